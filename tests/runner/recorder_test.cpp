// What a recording of a run holds: every body and contact within the stated distance, whatever scripts do, within the budget.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "html.hpp"
#include "recorder.hpp"

namespace {

using namespace islet;
using namespace islet::samples;
using SceneRun = islet::samples::Run;  // a test has a Run of its own

SceneRun run_of(const char* scene, int steps) {
    RunOptions options;
    options.steps = steps;
    return SceneRun(find_scene(scene)->make(), options);
}

/// Runs to the end under a recorder, calling `after` at the start and after every step.
template <class After>
RunResult record(SceneRun& run, Recorder& recorder, const After& after) {
    after();
    return run.run([&](const StepRecord& step) {
        recorder.observe(step);
        after();
    });
}

double apart(double wanted, std::int32_t quanta, double quantum, double origin) { return std::abs(origin + quanta * quantum - wanted); }

TEST(Recorder, BodiesAreWithinHalfAQuantumOfWhereTheyWere) {
    for (const char* scene : {"card_house", "rolling", "far_from_origin"}) {
        SceneRun run = run_of(scene, 90);
        Recorder recorder(run);
        std::vector<std::vector<BodyState>> states;
        const auto remember = [&] {
            states.emplace_back();
            for (std::size_t i = 0; i < run.engine.body_slots(); ++i) states.back().push_back(run.engine.body(i));
        };
        record(run, recorder, remember);
        ASSERT_EQ(recorder.numbers().size(), 91u);
        const Scale& scale = recorder.scale();
        const Aabb& view = run.scene.view;
        EXPECT_LE(scale.quantum * 65536, double(std::max(view.upper.x - view.lower.x, view.upper.y - view.lower.y)));

        RecordingReader reader(recorder.bytes());
        for (const auto& frame : states) {
            ASSERT_TRUE(reader.next());
            for (std::size_t id = 0; id < frame.size(); ++id) {
                const Place place = reader.frame().bodies.entries[id];
                const double bound = 0.5 * scale.quantum * (1 + 1e-9);
                ASSERT_LE(apart(double(frame[id].position.x), place.x, scale.quantum, scale.origin_x), bound);
                ASSERT_LE(apart(double(frame[id].position.y), place.y, scale.quantum, scale.origin_y), bound);
                const double turns = place.angle / double(body_turn) - double(frame[id].angle) / (2 * double(pi));
                ASSERT_LE(std::abs(turns - std::round(turns)), 0.5 / body_turn * (1 + 1e-6));
                ASSERT_EQ(reader.frame().awake[id] != 0, frame[id].awake || frame[id].mass == 0);
            }
        }
        EXPECT_FALSE(reader.next());
    }
}

TEST(Recorder, ContactsAreWithinHalfOfTheirCoarserQuantum) {
    SceneRun run = run_of("pyramid", 30);
    Recorder recorder(run);
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
    record(run, recorder, remember);
    const Scale& scale = recorder.scale();
    const double quantum = scale.quantum * contact_quanta;
    RecordingReader reader(recorder.bytes());
    for (const std::vector<Vec2>& points : wanted) {
        ASSERT_TRUE(reader.next());
        const Table<Place>& contacts = reader.frame().contacts;
        std::size_t next = 0;  // both lists are in the order of slots
        for (std::size_t id = 0; id < contacts.size(); ++id) {
            if (!contacts.has(id)) continue;
            ASSERT_LT(next, points.size());
            ASSERT_LE(apart(double(points[next].x), contacts.entries[id].x, quantum, scale.origin_x), 0.5 * quantum * (1 + 1e-9));
            ASSERT_LE(apart(double(points[next].y), contacts.entries[id].y, quantum, scale.origin_y), 0.5 * quantum * (1 + 1e-9));
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

TEST(Recorder, ABodyThatTakesAnothersSlotIsAnotherBody) {
    SceneRun run(scene_with_a_swap(), {});
    Recorder recorder(run);
    record(run, recorder, [] {});
    RecordingReader reader(recorder.bytes());
    for (std::size_t i = 0; i < 6; ++i) reader.next();
    EXPECT_TRUE(reader.frame().bodies.has(1));
    EXPECT_FALSE(reader.frame().bodies.has(2));
    reader.next();
    EXPECT_FALSE(reader.frame().bodies.has(1));
    ASSERT_TRUE(reader.frame().bodies.has(2));
    const Model& model = recorder.models().at(reader.frame().kinds[2].model);
    ASSERT_EQ(model.size(), 1u);
    EXPECT_EQ(model[0].points.size(), 1u);
    EXPECT_FLOAT_EQ(model[0].radius, 0.25f);
    EXPECT_EQ(recorder.numbers().back().bodies, 2u);
}

TEST(Recorder, JointsStayWithTheirBodies) {
    SceneRun run = run_of("rain", 40);
    Recorder recorder(run);
    std::vector<std::vector<RecordedJoint>> wanted;
    record(run, recorder, [&] { wanted.push_back(collect_joints(run.engine.world())); });
    const Scale& scale = recorder.scale();
    RecordingReader reader(recorder.bytes());
    for (const std::vector<RecordedJoint>& joints : wanted) {
        ASSERT_TRUE(reader.next());
        const Frame& frame = reader.frame();
        EXPECT_EQ(std::count(frame.joints.live.begin(), frame.joints.live.end(), 1), std::ptrdiff_t(joints.size()));
        for (const RecordedJoint& joint : joints) {
            ASSERT_TRUE(frame.joints.has(joint.slot));
            const JointLine& line = frame.joints.entries[joint.slot];
            ASSERT_EQ(line.size(), joint.line.size());
            for (std::size_t i = 0; i < line.size(); ++i) {
                const Place body = frame.bodies.entries[line[i].frame - 1];
                const double angle = body.angle * 2 * double(pi) / body_turn;
                const double x = body.x + std::cos(angle) * line[i].x - std::sin(angle) * line[i].y;
                const double y = body.y + std::sin(angle) * line[i].x + std::cos(angle) * line[i].y;
                // Half a quantum each for body and point, two for the point's freedom to shake, and what a small turn moves.
                ASSERT_NEAR(x, (double(joint.line[i].place.x) - scale.origin_x) / scale.quantum, 4);
                ASSERT_NEAR(y, (double(joint.line[i].place.y) - scale.origin_y) / scale.quantum, 4);
            }
        }
    }
    EXPECT_GT(wanted.back().size(), 100u);
}

TEST(Recorder, BodiesOfTheSameShapesShareAModel) {
    SceneRun run = run_of("pyramid", 0);
    const Recorder recorder(run);
    EXPECT_EQ(recorder.models().size(), 2u);  // the ground and a box
    EXPECT_EQ(recorder.numbers().size(), 1u);
}

TEST(Recorder, ThinsToItsBudgetAndKeepsTheEnds) {
    SceneRun whole_run = run_of("confined", 101);
    Recorder whole(whole_run);
    record(whole_run, whole, [] {});
    std::vector<Frame> frames;
    for (RecordingReader reader(whole.bytes()); reader.next();) frames.push_back(reader.frame());
    ASSERT_EQ(frames.size(), 102u);

    for (const double share : {0.8, 0.4, 0.1}) {
        const auto budget = static_cast<std::size_t>(share * double(whole.bytes().size()));
        SceneRun run = run_of("confined", 101);
        Recorder recorder(run, budget);
        record(run, recorder, [] {});
        EXPECT_LE(recorder.bytes().size(), budget);
        EXPECT_GT(recorder.stride(), 1);
        EXPECT_EQ(recorder.has_contacts(), share == 0.8);
        EXPECT_EQ(recorder.numbers().front().step, 0);
        EXPECT_EQ(recorder.numbers().back().step, 101);
        RecordingReader reader(recorder.bytes());
        for (const FrameNumbers& numbers : recorder.numbers()) {
            ASSERT_TRUE(reader.next());
            ASSERT_TRUE(numbers.step % recorder.stride() == 0 || numbers.step == 101);
            ASSERT_TRUE(reader.frame().bodies.entries == frames[static_cast<std::size_t>(numbers.step)].bodies.entries);
        }
        EXPECT_FALSE(reader.next());
    }
}

TEST(Page, HoldsARunOfFourHundredBodiesInTwoMegabytes) {
    SceneRun run = run_of("confined", 600);
    Recorder recorder(run);
    const RunResult result = record(run, recorder, [] {});
    EXPECT_EQ(recorder.stride(), 1);
    EXPECT_LT(player_page(run, result, recorder).size(), 2'000'000u);
}

TEST(Page, NeedsNothingElse) {
    SceneRun run = run_of("hello", 20);
    Recorder recorder(run);
    const RunResult result = record(run, recorder, [] {});
    const std::string page = player_page(run, result, recorder);
    for (const char* never : {"{{", "http:", "https:", "src=", "@import", "import(", "fetch("})
        EXPECT_EQ(page.find(never), std::string::npos) << never;
    EXPECT_NE(page.find(base64(recorder.bytes())), std::string::npos);
    EXPECT_NE(page.find("<title>hello"), std::string::npos);
    EXPECT_EQ(page.substr(page.size() - 8), "</html>\n");
}

TEST(Page, ASceneCannotSmuggleInATag) {
    SceneRun run(scene_with_a_swap(), {});
    Recorder recorder(run);
    RunResult result = record(run, recorder, [] {});
    result.scene = "</script><script>alert(1)</script>";
    EXPECT_EQ(player_page(run, result, recorder).find("alert(1)</script>"), std::string::npos);
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
