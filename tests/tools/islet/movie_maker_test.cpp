// What a movie of a run holds: every body and contact within the stated distance, whatever scripts do, within the budget.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "islet/html.hpp"
#include "islet/movie_maker.hpp"
#include "scenes/catalogue.hpp"

namespace {

using namespace islet;
using namespace islet::samples;
using namespace islet::tools;
using SceneRun = islet::tools::Run;  // a test has a Run of its own

SceneRun run_of(const char* scene, int steps) {
    RunOptions options;
    options.steps = steps;
    return SceneRun(find_scene(scene)->make(), options);
}

/// Runs to the end and makes a movie of it, calling `after` at the start and after every step.
template <class After>
RunResult record(SceneRun& run, MovieMaker& movie, const After& after) {
    after();
    return run.run([&](const StepRecord& step) {
        movie.observe(step);
        after();
    });
}

double apart(double wanted, std::int32_t quanta, double quantum, double origin) { return std::abs(origin + quanta * quantum - wanted); }

TEST(MovieMaker, BodiesAreWithinHalfAQuantumOfWhereTheyWere) {
    for (const char* scene : {"card_house", "rolling", "far_from_origin"}) {
        SceneRun run = run_of(scene, 90);
        MovieMaker movie(run);
        std::vector<std::vector<BodyState>> states;
        const auto remember = [&] {
            states.emplace_back();
            for (std::size_t i = 0; i < run.engine.body_slots(); ++i) states.back().push_back(run.engine.body(i));
        };
        record(run, movie, remember);
        ASSERT_EQ(movie.numbers().size(), 91u);
        const Scale& scale = movie.scale();
        const Aabb& view = run.scene.view;
        EXPECT_LE(scale.quantum * 65536, double(std::max(view.upper.x - view.lower.x, view.upper.y - view.lower.y)));

        MovieReader reader(movie.bytes());
        for (const auto& frame : states) {
            ASSERT_TRUE(reader.next());
            for (std::size_t id = 0; id < frame.size(); ++id) {
                const Place place = reader.frame().bodies.entries[id];
                const double bound = 0.5 * scale.quantum * (1 + 1e-9);
                ASSERT_LE(apart(double(frame[id].position.x), place.x, scale.quantum, scale.origin_x), bound);
                ASSERT_LE(apart(double(frame[id].position.y), place.y, scale.quantum, scale.origin_y), bound);
                const double turns = place.angle / double(body_turn) - double(frame[id].angle) / (2 * double(pi));
                ASSERT_LE(std::abs(turns - std::round(turns)), 0.5 / body_turn * (1 + 1e-6));
                const BodyLook look = frame[id].mass == 0 ? BodyLook::static_body : frame[id].awake ? BodyLook::awake : BodyLook::asleep;
                ASSERT_EQ(reader.frame().looks[id], look);
            }
        }
        EXPECT_FALSE(reader.next());
    }
}

TEST(MovieMaker, ContactsAreWithinHalfOfTheirCoarserQuantum) {
    SceneRun run = run_of("pyramid", 30);
    MovieMaker movie(run);
    std::vector<std::vector<Vec2>> wanted;
    const auto remember = [&] {
        const World& world = run.engine.world();
        std::vector<Vec2>& points = wanted.emplace_back();
        ContactInfo contact;
        for (std::uint32_t slot = 0; slot < world.capacity().contacts; ++slot) {
            if (!world.contact_at(slot, contact)) continue;
            for (std::uint32_t i = 0; i < contact.point_count; ++i) {
                if (contact.points[i].separation < 0.005f) points.push_back(contact.points[i].point);
            }
        }
    };
    record(run, movie, remember);
    const Scale& scale = movie.scale();
    const double quantum = scale.quantum * contact_quanta;
    // Before its first step the world knows no contacts, and the movie shows those that the bodies have all the same. They are at rest: the first step
    // moves no point by more than a slop.
    ASSERT_TRUE(wanted[0].empty());
    wanted[0] = wanted[1];
    constexpr double slop = 0.005;  // m
    MovieReader reader(movie.bytes());
    for (const std::vector<Vec2>& points : wanted) {
        const double bound = 0.5 * quantum * (1 + 1e-9) + (&points == wanted.data() ? slop : 0);
        ASSERT_TRUE(reader.next());
        const Table<Place>& contacts = reader.frame().contacts;
        std::size_t next = 0;  // both lists are in the order of slots
        for (std::size_t id = 0; id < contacts.size(); ++id) {
            if (!contacts.has(id)) continue;
            ASSERT_LT(next, points.size());
            ASSERT_LE(apart(double(points[next].x), contacts.entries[id].x, quantum, scale.origin_x), bound);
            ASSERT_LE(apart(double(points[next].y), contacts.entries[id].y, quantum, scale.origin_y), bound);
            ++next;
        }
        ASSERT_EQ(next, points.size());
    }
    EXPECT_GT(wanted.back().size(), 50u);
}

/// A floor and a box; at step 5 a disc takes the box's place, and its slot in the world.
Scene scene_with_a_swap() {
    Scene scene;
    scene.name = "swap";
    scene.steps = 10;
    const auto add = [&scene](BodyType type, Vec2 position, const SceneGeometry& geometry) {
        SceneBody body;
        body.def.type = type;
        body.def.position = position;
        body.shapes.push_back({geometry, {}});
        scene.bodies.push_back(body);
        return body;
    };
    add(BodyType::static_body, {0, -1}, make_box(10, 1));
    SceneBody disc = add(BodyType::dynamic, {0, 2}, make_box(0.5f, 0.5f));
    disc.shapes[0].geometry = Circle{{}, 0.25f};
    scene.before_step = [disc](Engine& engine, int step) {
        if (step != 5) return;
        engine.destroy_body(1);
        engine.create_body(disc);
    };
    return scene;
}

TEST(MovieMaker, ABodyThatTakesAnothersSlotIsAnotherBody) {
    SceneRun run(scene_with_a_swap(), {});
    MovieMaker movie(run);
    record(run, movie, [] {});
    MovieReader reader(movie.bytes());
    for (std::size_t i = 0; i < 6; ++i) reader.next();
    EXPECT_TRUE(reader.frame().bodies.has(1));
    EXPECT_FALSE(reader.frame().bodies.has(2));
    reader.next();
    EXPECT_FALSE(reader.frame().bodies.has(1));
    ASSERT_TRUE(reader.frame().bodies.has(2));
    const Model& model = movie.models().at(reader.frame().models[2]);
    ASSERT_EQ(model.size(), 1u);
    EXPECT_EQ(model[0].points.size(), 1u);
    EXPECT_FLOAT_EQ(model[0].radius, 0.25f);
    EXPECT_EQ(movie.numbers().back().bodies, 2u);
}

/// Where a point of a joint's figure is, in quanta, as the player works it out: from where bodies and dots are in the movie.
class PlayedJoint {
public:
    PlayedJoint(const Frame& frame, const JointEntry& entry, const JointFigure& figure) {
        a_ = entry.body_a != 0 ? pose_of(frame.bodies.entries[entry.body_a - 1]) : QuantaPose{{double(entry.x), double(entry.y)}, 1, 0};
        if (entry.body_b != 0) b_ = pose_of(frame.bodies.entries[entry.body_b - 1]);
        for (const JointMark::Kind kind : {JointMark::dot, JointMark::ring}) {
            for (const JointMark& mark : figure) {
                if (mark.kind == kind && ends_.size() < 2) ends_.push_back(at(mark.points[0]));
            }
        }
    }
    QuantaPoint at(const JointPoint& p) const {
        const auto from = [&](QuantaPoint o, double c, double s, double x) { return QuantaPoint{o.x + c * x - s * p.y, o.y + s * x + c * p.y}; };
        switch (p.frame) {
        case JointPoint::world: return {double(p.x), double(p.y)};
        case JointPoint::body_a: return from(a_.origin, a_.c, a_.s, p.x);
        case JointPoint::body_b: return from(b_.origin, b_.c, b_.s, p.x);
        case JointPoint::end_a_turn_b: return from(ends_.at(0), b_.c, b_.s, p.x);
        case JointPoint::end_b_turn_a: return from(ends_.at(1), a_.c, a_.s, p.x);
        default: break;
        }
        const double dx = ends_.at(1).x - ends_[0].x, dy = ends_[1].y - ends_[0].y, far = std::hypot(dx, dy);
        return from(ends_[p.frame == JointPoint::end_b_way ? 1 : 0], dx / far, dy / far, p.frame == JointPoint::between ? p.x * far / between_parts : p.x);
    }

private:
    static QuantaPose pose_of(const Place& place) {
        const double angle = place.angle * 2 * double(pi) / body_turn;
        return {{double(place.x), double(place.y)}, std::cos(angle), std::sin(angle)};
    }
    QuantaPose a_, b_;
    std::vector<QuantaPoint> ends_;
};

/// Points that World::draw draws of a joint, m: of lines both ends, of rings the middle and how large they are.
struct DrawnPoints {
    std::vector<Vec2> points;
    std::vector<float> radii;
};

std::map<std::uint32_t, DrawnPoints> drawn_joints(const World& world, float size) {
    Drawing drawing;
    DebugDraw what;
    what.shapes = false;
    what.size = size;
    drawing.add(world, what);
    std::map<std::uint32_t, DrawnPoints> joints;
    for (const Stroke& stroke : drawing.strokes()) {
        DrawnPoints& joint = joints[stroke.style.slot];
        const bool is_ring = stroke.figure == Stroke::Figure::circle;
        const auto points = drawing.points(stroke).first(is_ring ? 1 : stroke.point_count);
        joint.points.insert(joint.points.end(), points.begin(), points.end());
        if (is_ring) joint.radii.push_back(stroke.radius);
    }
    return joints;
}

// All nine types, joints that come and go, and bodies that turn, hang slack and give way.
TEST(MovieMaker, JointsAreShownAsDebugDrawDrawsThem) {
    for (const char* scene : {"rain", "door", "elevator", "pulley", "gears", "car", "rope", "mouse_drag", "ragdoll", "blob", "tumbler", "pinball"}) {
        SceneRun run = run_of(scene, 80);
        MovieMaker movie(run);
        const Scale& scale = movie.scale();
        std::vector<std::map<std::uint32_t, DrawnPoints>> wanted;
        record(run, movie, [&] { wanted.push_back(drawn_joints(run.engine.world(), movie.drawn().size)); });
        ASSERT_EQ(movie.stride(), 1) << scene;

        std::size_t compared = 0;
        MovieReader reader(movie.bytes());
        for (const auto& joints : wanted) {
            ASSERT_TRUE(reader.next());
            const Frame& frame = reader.frame();
            EXPECT_EQ(std::count(frame.joints.live.begin(), frame.joints.live.end(), 1), std::ptrdiff_t(joints.size()));
            for (const auto& [slot, drawn] : joints) {
                ASSERT_TRUE(frame.joints.has(slot)) << scene;
                const JointEntry& entry = frame.joints.entries[slot];
                const JointFigure& figure = reader.figures()[entry.figure];
                const PlayedJoint joint(frame, entry, figure);
                std::size_t next = 0, rings = 0;
                for (const JointMark& mark : figure) {
                    if (mark.kind == JointMark::ring) {
                        ASSERT_NEAR(mark.radius * scale.quantum, double(drawn.radii.at(rings++)), 0.5 * scale.quantum * (1 + 1e-6));
                    }
                    for (const JointPoint& p : mark.points) {
                        ASSERT_LT(next, drawn.points.size());
                        const QuantaPoint got = joint.at(p);
                        const Vec2 due = drawn.points[next++];
                        const double off = std::hypot(got.x - (double(due.x) - scale.origin_x) / scale.quantum, got.y - (double(due.y) - scale.origin_y) / scale.quantum);
                        // Beyond the tolerance: what bodies are rounded by, and half a part of a turn over some metres.
                        ASSERT_LE(off, JointFigures::tolerance + 6) << scene << ", joint " << slot << ", frame of reference " << int(p.frame);
                        ++compared;
                    }
                }
                ASSERT_EQ(next, drawn.points.size());
            }
        }
        EXPECT_GT(compared, 200u) << scene;
    }
}

// A joint that is swung about in a world costs as little as its bodies: what is drawn of it is told once or twice.
TEST(MovieMaker, JointsAlikeShareTheirFigures) {
    SceneRun run = run_of("joint_grid", 2);
    MovieMaker movie(run);
    record(run, movie, [] {});
    MovieReader reader(movie.bytes());
    while (reader.next()) {}
    EXPECT_GT(run.engine.counts().joints, 19000u);
    EXPECT_LT(reader.figures().size(), 500u);
}

TEST(MovieMaker, BodiesLookAsDebugDrawColoursThem) {
    SceneRun run = run_of("sensors", 5);
    MovieMaker movie(run);
    record(run, movie, [] {});
    std::size_t sensors = 0;
    for (const Model& model : movie.models()) sensors += static_cast<std::size_t>(std::count_if(model.begin(), model.end(), [](const Outline& o) { return !o.solid; }));
    EXPECT_EQ(sensors, 2u);  // gates, which are alike, and the tray

    Scene scene = scene_with_a_swap();
    scene.bodies[1].def.bullet = true;
    SceneRun shot(scene, {});
    MovieMaker of_shot(shot);
    record(shot, of_shot, [] {});
    const std::set<BodyLook> looks = {BodyLook::static_body, BodyLook::awake, BodyLook::bullet};  // the disc that takes the box's place is none
    EXPECT_EQ(of_shot.looks(), looks);
}

TEST(MovieMaker, BodiesOfTheSameShapesShareAModel) {
    SceneRun run = run_of("pyramid", 0);
    const MovieMaker movie(run);
    EXPECT_EQ(movie.models().size(), 2u);  // the ground and a box
    EXPECT_EQ(movie.numbers().size(), 1u);
}

TEST(MovieMaker, ThinsToItsBudgetAndKeepsTheEnds) {
    SceneRun whole_run = run_of("confined", 101);
    MovieMaker whole(whole_run);
    record(whole_run, whole, [] {});
    std::vector<Frame> frames;
    for (MovieReader reader(whole.bytes()); reader.next();) frames.push_back(reader.frame());
    ASSERT_EQ(frames.size(), 102u);

    for (const double share : {0.8, 0.4, 0.1}) {
        const auto budget = static_cast<std::size_t>(share * double(whole.bytes().size()));
        SceneRun run = run_of("confined", 101);
        MovieMaker movie(run, budget);
        record(run, movie, [] {});
        EXPECT_LE(movie.bytes().size(), budget);
        EXPECT_GT(movie.stride(), 1);
        EXPECT_EQ(movie.has_contacts(), share == 0.8);
        EXPECT_EQ(movie.numbers().front().step, 0);
        EXPECT_EQ(movie.numbers().back().step, 101);
        MovieReader reader(movie.bytes());
        for (const FrameNumbers& numbers : movie.numbers()) {
            ASSERT_TRUE(reader.next());
            ASSERT_TRUE(numbers.step % movie.stride() == 0 || numbers.step == 101);
            ASSERT_TRUE(reader.frame().bodies.entries == frames[static_cast<std::size_t>(numbers.step)].bodies.entries);
        }
        EXPECT_FALSE(reader.next());
    }
}

TEST(Page, HoldsARunOfFourHundredBodiesInTwoMegabytes) {
    SceneRun run = run_of("confined", 600);
    MovieMaker movie(run);
    const RunResult result = record(run, movie, [] {});
    EXPECT_EQ(movie.stride(), 1);
    EXPECT_LT(player_page(run, result, movie).size(), 2'000'000u);
}

TEST(Page, NeedsNothingElse) {
    SceneRun run = run_of("hello", 20);
    MovieMaker movie(run);
    const RunResult result = record(run, movie, [] {});
    const std::string page = player_page(run, result, movie);
    for (const char* never : {"{{", "http:", "https:", "src=", "@import", "import(", "fetch("})
        EXPECT_EQ(page.find(never), std::string::npos) << never;
    EXPECT_NE(page.find(base64(movie.bytes())), std::string::npos);
    EXPECT_NE(page.find("<title>hello"), std::string::npos);
    EXPECT_EQ(page.substr(page.size() - 8), "</html>\n");
}

TEST(Page, ASceneCannotSmuggleInATag) {
    SceneRun run(scene_with_a_swap(), {});
    MovieMaker movie(run);
    RunResult result = record(run, movie, [] {});
    result.scene = "</script><script>alert(1)</script>";
    EXPECT_EQ(player_page(run, result, movie).find("alert(1)</script>"), std::string::npos);
}

TEST(Page, Base64IsThatOfItsStandard) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

}  // namespace
