// Calls from functions that the world itself calls. Whatever would change the world or show it half done is refused: from every place a user's function is
// called from, every call there is.
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <ostream>
#include <regex>
#include <set>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>

#include "islet/debug_draw.hpp"
#include "islet/island.hpp"
#include "islet/mover.hpp"
#include "islet/recording.hpp"
#include "support/image.hpp"
#include "support/test_world.hpp"
#include "calls/calls.hpp"

namespace islet::test {
namespace {

constexpr Capacity many{.bodies = 1024, .shapes = 1024, .contacts = 1024, .joints = 64};  // so many that workers are asked

// A world in which the next step calls every function of the user's: a box stands, another begins to touch, a hinge swings.
struct Stage {
    std::function<void()> once;      // what is done in the first call from `place`
    const char* place = "";          // of the functions that a world calls
    int calls = 0;                   // from that place
    Block block;
    World* world = nullptr;
    std::vector<Error> errors;
    BodyId ground, box;
    ShapeId shape;
    JointId hinge, other_hinge;
    Image image, recording{std::size_t{1} << 20}, other_recording{std::size_t{1} << 20};
    std::vector<std::byte> memory = std::vector<std::byte>(1 << 16);
    std::vector<Vec2> points = {{0, 0}, {1, 0}, {0, 1}};

    static void came(void* stage, const char* from) {
        Stage& s = *static_cast<Stage*>(stage);
        if (std::string(from) != s.place) return;
        ++s.calls;
        if (!s.once) return;
        const std::function<void()> act = std::move(s.once);
        s.once = nullptr;
        act();
    }

    Hooks hooks() {
        Hooks h;
        h.filter = [](ShapeId, ShapeId, void* stage) {
            came(stage, "filter");
            return true;
        };
        h.pre_solve = [](PreSolve&, void* stage) { came(stage, "pre_solve"); };
        h.mix_friction = [](float a, std::uint32_t, float, std::uint32_t, void* stage) {
            came(stage, "mix_friction");
            return a;
        };
        h.mix_restitution = [](float a, std::uint32_t, float, std::uint32_t, void* stage) {
            came(stage, "mix_restitution");
            return a;
        };
        h.context = this;
        return h;
    }

    explicit Stage(const Capacity& capacity = many) : block(world_bytes(capacity)) {
        WorldDef def;
        def.error_hook = [](Error error, void* stage) {
            static_cast<Stage*>(stage)->errors.push_back(error);
            came(stage, "error_hook");
        };
        def.error_context = this;
        def.hooks = hooks();
        def.clock = [](void* stage) {
            came(stage, "clock");
            return std::uint64_t{0};
        };
        def.clock_context = this;
        def.tasks.parallel_for = [](void* stage, std::uint32_t count, void (*task)(void*, std::uint32_t), void* data) {
            came(stage, "parallel_for");
            for (std::uint32_t i = 0; i < count; ++i) task(data, i);
        };
        def.tasks.ready_workers = [](void* stage) {
            came(stage, "ready_workers");
            return std::uint32_t{2};
        };
        def.tasks.context = this;
        def.tasks.workers = 2;
        world = World::create(block.span(), capacity, def);
        ground = world->create_body({});
        world->create_shape(ground, make_box(100, 1));
        box = add({0, 1.5f});
        shape = shape_of(box);
        const BodyId bob = add({20, 9}), other_bob = add({30, 9});
        hinge = world->create_joint(RevoluteJointDef{.base = {.body_a = ground, .body_b = bob, .frame_a = {{20, 10}}, .frame_b = {{0, 1}}}});
        other_hinge = world->create_joint(RevoluteJointDef{.base = {.body_a = ground, .body_b = other_bob, .frame_a = {{30, 10}}, .frame_b = {{0, 1}}}});
        for (int i = 0; i < 3; ++i) world->step(1.0f / 60);
        add({5, 1.45f});
        image = save(*world);
        world->start_recording(recording.bytes());
        errors.clear();
    }

    BodyId add(Vec2 at) {
        const BodyId body = world->create_body({.type = BodyType::dynamic, .position = at});
        world->create_shape(body, make_box(0.5f, 0.5f), {.restitution = 0.1f, .pre_solve = true});
        return body;
    }
    ShapeId shape_of(BodyId body) const {
        ShapeId id;
        world->shapes(body, {&id, 1});
        return id;
    }
};

// -- the calls ---------------------------------------------------------------------------------------------------------------------------

struct Refused {
    const char* name;
    std::function<bool(Stage&)> call;  // true if it came back with something
};

template <class T>
T argument(Stage& s) {
    if constexpr (std::is_same_v<T, BodyId>) return s.box;
    else if constexpr (std::is_same_v<T, ShapeId>) return s.shape;
    else if constexpr (std::is_same_v<T, JointId>) return s.hinge;
    else if constexpr (std::is_same_v<T, float>) return 0.25f;
    else if constexpr (std::is_same_v<T, Vec2>) return {0.5f, 2};
    else if constexpr (std::is_same_v<T, bool>) return true;
    else if constexpr (std::is_same_v<T, std::uint64_t>) return 7;
    else if constexpr (std::is_same_v<T, BodyType>) return BodyType::kinematic;
    else if constexpr (std::is_same_v<T, SolverDef>) return {.substeps = 2};
    else if constexpr (std::is_same_v<T, ExplosionDef>) return {.radius = 10, .impulse_per_length = 5};
    else if constexpr (std::is_same_v<T, MassData>) return {3, {0.1f, 0}, 2};
    else if constexpr (std::is_same_v<T, SurfaceMaterial>) return {.friction = 0.1f, .id = 4};
    else if constexpr (std::is_same_v<T, WindDef>) return {.velocity = {10, 0}};
    else if constexpr (std::is_same_v<T, Filter>) return {.category = 2, .mask = 2};
    else if constexpr (std::is_same_v<T, Circle>) return {{0, 0}, 0.3f};
    else if constexpr (std::is_same_v<T, Capsule>) return {{-1, 0}, {1, 0}, 0.2f};
    else if constexpr (std::is_same_v<T, Segment>) return {{-1, 0}, {1, 0}};
    else if constexpr (std::is_same_v<T, Polygon>) return make_box(1, 0.3f);
    else if constexpr (std::is_same_v<T, ChainSegment>) return {{-2, 0}, {{-1, 0}, {1, 0}}, {2, 0}};
    else if constexpr (std::is_same_v<T, std::span<const Vec2>>) return s.points;
    else if constexpr (std::is_same_v<T, JointSpring>) return {.enable = true, .hertz = 1};
    else if constexpr (std::is_same_v<T, JointLimit>) return {.enable = true, .lower = -1, .upper = 1};
    else if constexpr (std::is_same_v<T, JointMotor>) return {.enable = true, .speed = 1, .max_force = 1};
    else if constexpr (std::is_same_v<T, MouseJointDef>) return {.body = s.box, .max_force = 10};
    else if constexpr (std::is_same_v<T, GearJointDef>) return {.joint1 = s.hinge, .joint2 = s.other_hinge};
    else if constexpr (std::is_same_v<T, PulleyJointDef>) return {.base = {.body_a = s.ground, .body_b = s.box}, .ground_a = {0, 9}, .ground_b = {1, 9}};
    else if constexpr (requires(T def) { def.base; }) { T def; def.base = {.body_a = s.ground, .body_b = s.box}; return def; }
    else return T{};  // BodyDef, ShapeDef, Transform, JointFrame
}

template <class... Args, class Function>
bool made(Stage& s, const Function& function) {
    if constexpr (std::is_void_v<decltype(function(argument<Args>(s)...))>) {
        function(argument<Args>(s)...);
        return false;
    } else {
        return bool(function(argument<Args>(s)...));
    }
}

const Refused all_calls[] = {
#define ISLET_REFUSED(name, function, ...) \
    {#function, [](Stage& s) { return made<__VA_ARGS__>(s, [&](const auto&... args) { return s.world->function(args...); }); }},
    ISLET_CALLS(ISLET_REFUSED)
#undef ISLET_REFUSED
    {"set_tasks", [](Stage& s) { s.world->set_tasks({}); return false; }},
    {"set_clock", [](Stage& s) { s.world->set_clock(nullptr); return false; }},
    {"set_hooks", [](Stage& s) { s.world->set_hooks({}); return false; }},
    {"set_error_hook", [](Stage& s) { s.world->set_error_hook(nullptr); return false; }},
    {"restore", [](Stage& s) { return s.world->restore(s.image.bytes()); }},
    {"load", [](Stage& s) { return s.world->load(s.image.bytes()); }},
    {"start_recording", [](Stage& s) { return s.world->start_recording(s.other_recording.bytes()); }},
    {"move_recording", [](Stage& s) { return s.world->move_recording(s.other_recording.bytes()); }},
    {"stop_recording", [](Stage& s) { return s.world->stop_recording() != 0; }},
    {"save", [](Stage& s) { return s.world->save(s.other_recording.bytes()) != 0; }},
    {"hash", [](Stage& s) { return s.world->hash() != 0; }},
    {"validate", [](Stage& s) { return s.world->validate() == nullptr; }},
    {"export_island", [](Stage& s) { IslandProblem problem; return s.world->export_island(s.box, 0.01f, s.memory, problem) != 0; }},
    {"draw", [](Stage& s) { DebugDraw d; d.body_colors = BodyColors::island; s.world->draw(d); return false; }},
    {"step_mover", [](Stage& s) {  // onto the box, which it would weigh on
         MoverState hero{.position = {0, 2.6f}, .velocity = {0, -20}};
         const bool moved = step_mover(*s.world, {}, hero, {.walk = 3}, 1.0f / 60);
         return moved || hero.position != Vec2{0, 2.6f} || hero.velocity != Vec2{0, -20};
     }},
};

// No public function of World that is not const is missing above.
TEST(InStep, EveryFunctionThatChangesAWorldIsTried) {
    std::ifstream file(std::filesystem::path(__FILE__).parent_path() / ".." / ".." / "engine" / "include" / "islet" / "world.hpp");
    ASSERT_TRUE(file) << "run in the folder that the test was built in";
    std::set<std::string> tried = {"create", "clear_error"};  // makes another world; no part of the state
    for (const Refused& call : all_calls) tried.insert(call.name);
    const std::regex declaration(R"(^    [A-Za-z][\w:<> ]*[ &*](\w+)\(.*\)( const)?;$)");
    int found = 0;
    for (std::string line; std::getline(file, line) && line != "private:";) {
        std::smatch match;
        if (!std::regex_match(line, match, declaration) || match[2].matched) continue;
        ++found;
        EXPECT_TRUE(tried.contains(match[1].str())) << match[1].str();
    }
    EXPECT_GT(found, 80);
}

// -- the places --------------------------------------------------------------------------------------------------------------------------

struct Place {
    const char* name;
    const char* function;                // of the user's
    std::function<void(Stage&)> act;     // by which the world comes to call it
    friend void PrintTo(const Place& place, std::ostream* out) { *out << place.name; }
};

void step(Stage& s) { s.world->step(1.0f / 60); }

void draw(Stage& s, bool all) {
    DebugDraw d;
    d.polygon = [](std::span<const Vec2>, float, const DrawStyle&, void* stage) { Stage::came(stage, "polygon"); };
    d.segment = [](Vec2, Vec2, const DrawStyle&, void* stage) { Stage::came(stage, "segment"); };
    d.context = &s;
    d.contacts = d.normals = d.boxes = d.fat_boxes = d.tree = d.centers = true;
    if (all) return s.world->draw(d);
    s.world->draw_shape(d, s.shape, {}, {});
}

void walk(Stage& s) {
    MoverState hero{.position = {40, 1.01f}};
    const MoverFilter asks = [](const Surface&, void* stage) {
        Stage::came(stage, "collides");
        return true;
    };
    ASSERT_TRUE(step_mover(*s.world, {.collides = asks, .context = &s}, hero, {.walk = 3}, 1.0f / 60));
    EXPECT_EQ(hero.ground, s.ground);
}

const Place places[] = {
    {"FilterInAStep", "filter", step},
    {"PreSolveInAStep", "pre_solve", step},
    {"MixFrictionInAStep", "mix_friction", step},
    {"MixRestitutionInAStep", "mix_restitution", step},
    {"ClockInAStep", "clock", step},
    {"TaskSystemInAStep", "parallel_for", step},
    {"TaskSystemThatCountsItsWorkers", "ready_workers", step},
    {"MixFrictionAsAMaterialChanges", "mix_friction", [](Stage& s) { s.world->set_friction(s.shape, 0.3f); }},
    {"MixRestitutionAsAMaterialChanges", "mix_restitution", [](Stage& s) { s.world->set_material(s.shape, {.restitution = 0.5f}); }},
    {"MixFrictionAsAFlagChanges", "mix_friction", [](Stage& s) { s.world->enable_hit_events(s.shape, true); }},
    {"MixRestitutionAsContactsAreRead", "mix_restitution", [](Stage& s) {
         ContactInfo contacts[4];
         s.world->contacts(s.box, contacts);
     }},
    {"ErrorHookOfAnArgument", "error_hook", [](Stage& s) { s.world->set_friction(s.shape, -1); }},
    {"DrawingAll", "polygon", [](Stage& s) { draw(s, true); }},
    {"DrawingJoints", "segment", [](Stage& s) { draw(s, true); }},
    {"DrawingAShape", "polygon", [](Stage& s) { draw(s, false); }},
    {"FilterOfAMover", "collides", walk},
};

class InStep : public testing::TestWithParam<Place> {};

// Makes `call` from the place in one of two equal worlds: both must come out the same.
void expect_refused(const Place& place, const Capacity& capacity, const Refused& call) {
    SCOPED_TRACE(call.name);
    Stage left(capacity), right(capacity);
    left.place = right.place = place.function;
    bool came = false, gave = true;
    Error error = Error::none;
    std::size_t bytes_before = 1, bytes_after = 0;
    left.once = [&] {
        came = true;
        left.world->clear_error();
        bytes_before = left.world->recorded_bytes();
        gave = call.call(left);
        error = left.world->last_error();
        bytes_after = left.world->recorded_bytes();
    };
    place.act(left);
    place.act(right);
    ASSERT_TRUE(came) << "the world did not call " << place.function;
    EXPECT_FALSE(gave) << "it gave what it must not";
    EXPECT_EQ(error, Error::in_step) << describe(error);
    EXPECT_EQ(bytes_after, bytes_before) << "a refused call was recorded";
    EXPECT_EQ(left.calls, right.calls);
    EXPECT_EQ(left.world->hash(), right.world->hash());
    EXPECT_STREQ(left.world->validate(), nullptr);
    for (int i = 0; i < 3; ++i) {
        left.world->step(1.0f / 60);
        right.world->step(1.0f / 60);
    }
    EXPECT_EQ(left.world->hash(), right.world->hash());
    // Told of once; the error hook is told nothing of what it does itself.
    std::vector<Error> expected = right.errors;
    if (std::string(place.function) != "error_hook") expected.insert(expected.begin(), Error::in_step);
    EXPECT_EQ(left.errors, expected);
    // Still being recorded, and replayed it is the same world.
    const std::size_t bytes = left.world->stop_recording();
    EXPECT_EQ(bytes, right.world->stop_recording());
    ASSERT_NE(bytes, 0u);
    Stage third(capacity);
    third.world->stop_recording();
    const ReplayResult replayed = replay(*third.world, left.recording.bytes().first(bytes));
    EXPECT_EQ(replayed.end, ReplayEnd::complete);
}

TEST_P(InStep, NothingIsChanged) {
    for (const Refused& call : all_calls) ASSERT_NO_FATAL_FAILURE(expect_refused(GetParam(), many, call));
}

INSTANTIATE_TEST_SUITE_P(Places, InStep, testing::ValuesIn(places), [](const auto& test) { return std::string(test.param.name); });

// The error hook, from the middle of a step (a contact finds no room) and of a call (an end event finds none).
TEST(InStep, TheErrorHookChangesNothingInTheMiddleOfAStep) {
    const Place place{"ErrorHookInAStep", "error_hook", step};
    const Capacity tight{.bodies = 1024, .shapes = 1024, .contacts = 3, .joints = 64};  // box on ground, two bobs: none for the newcomer
    Capacity room = tight;
    room.contacts = Stage().world->contact_count();
    for (const Refused& call : all_calls) ASSERT_NO_FATAL_FAILURE(expect_refused(place, room, call));
}

// -- what is allowed ---------------------------------------------------------------------------------------------------------------------

TEST(InStep, HooksMayReadAndAsk) {
    Stage s;
    s.place = "pre_solve";
    int good = 0;
    s.once = [&] {
        good += s.world->transform(s.box).p.y > 1 ? 1 : 0;
        good += s.world->is_valid(s.shape) ? 1 : 0;
        good += s.world->aabb(s.shape).upper.y > 1 ? 1 : 0;
        good += s.world->joint_type(s.hinge) == JointType::revolute ? 1 : 0;
        good += s.world->cast_ray({0, 9}, {0, -9}) ? 1 : 0;
        good += s.world->closest({0, 9}, 10) ? 1 : 0;
    };
    s.world->step(1.0f / 60);
    EXPECT_EQ(good, 6);
    EXPECT_TRUE(s.errors.empty());
}

TEST(InStep, ErrorsInTheErrorHookDoNotCallItAgain) {
    Stage s;
    s.place = "error_hook";
    s.once = [&] {
        s.once = [&] { FAIL() << "called from within itself"; };
        s.world->friction(ShapeId{});
        s.world->step(1.0f / 60);
    };
    s.world->set_friction(s.shape, -1);
    s.once = nullptr;
    EXPECT_EQ(s.errors, std::vector<Error>{Error::out_of_range});
    EXPECT_EQ(s.world->last_error(), Error::in_step);
    s.world->step(1.0f / 60);
    EXPECT_EQ(s.world->step_count(), 4u);
}

// A query goes through nothing while it calls a visitor: what it found so far is all that it holds. (It cannot close the world as a step does, since any
// number of threads may ask at once.)
struct Visitors {
    const char* name;
    void (*act)(TestWorld& w, ShapeId found, int visit, const std::vector<std::byte>& image);
};

const Visitors visitors[] = {
    {"destroys what it found", [](TestWorld& w, ShapeId s, int, const auto&) { if (w->is_valid(s)) w->destroy_body(w->body(s)); }},
    {"destroys everything", [](TestWorld& w, ShapeId, int, const auto&) { for (const BodyId body : w.bodies()) w->destroy_body(body); }},
    {"makes more", [](TestWorld& w, ShapeId, int visit, const auto&) { if (visit < 50) w.add_box({60 - 0.7f * static_cast<float>(visit), 0}); }},
    {"moves it on", [](TestWorld& w, ShapeId s, int, const auto&) { w->set_transform(w->body(s), w->position(w->body(s)) + Vec2{2, 0}, 0.3f); }},
    {"steps", [](TestWorld& w, ShapeId, int, const auto&) { w.step(5); }},
    {"loads", [](TestWorld& w, ShapeId, int, const auto& image) { ASSERT_TRUE(w->load(image)); }},
    {"asks and changes", [](TestWorld& w, ShapeId, int visit, const auto&) {
         const auto wake = [](ShapeId s, void* world) { return static_cast<World*>(world)->wake(static_cast<World*>(world)->body(s)), true; };
         w->overlap_box_each({{-1, -1}, {100, 1}}, {}, wake, w.get());
         w->set_gravity({0, -static_cast<float>(visit)});
     }},
};

TEST(InStep, VisitorsOfQueriesMayChangeTheWorld) {
    for (const Visitors& v : visitors) {
        for (int query = 0; query < 5; ++query) {
            SCOPED_TRACE(std::string(v.name) + ", query " + std::to_string(query));
            TestWorld w({.bodies = 128, .shapes = 128, .contacts = 256});
            for (int i = 0; i < 40; ++i) w.add_box({1.5f * static_cast<float>(i), 0}, 0.5f, 0.5f, {}, i % 2 == 0 ? BodyType::static_body : BodyType::dynamic);
            std::vector<std::byte> image(w->snapshot_bytes());
            ASSERT_GT(w->save(image), 0u);
            w.step(3);
            struct Visit {
                TestWorld& w;
                const Visitors& v;
                const std::vector<std::byte>& image;
                int seen = 0;
                void come(ShapeId s) {
                    ASSERT_LT(seen, 2000) << "it goes on for ever";
                    v.act(w, s, seen++, image);
                }
            } visit{w, v, image};
            const CastVisitor cast = [](const QueryHit& hit, void* it) { static_cast<Visit*>(it)->come(hit.shape); return -1.0f; };
            const OverlapVisitor overlap = [](ShapeId shape, void* it) { static_cast<Visit*>(it)->come(shape); return true; };
            switch (query) {
            case 0: w->cast_ray_each({-1, 0}, {70, 0}, {}, cast, &visit); break;
            case 1: w->cast_shape_each(make_proxy(Circle{{-1, 0}, 0.2f}), {70, 0}, {}, cast, &visit); break;
            case 2: w->overlap_box_each({{-1, -1}, {100, 1}}, {}, overlap, &visit); break;
            case 3: w->overlap_shape_each(make_proxy(make_box(50, 0.2f)), {}, overlap, &visit); break;
            case 4: w->overlap_point_each({0, 0}, {}, overlap, &visit); break;
            }
            EXPECT_GT(visit.seen, 0);
            EXPECT_STREQ(w->validate(), nullptr);
            w.step(10);
            EXPECT_STREQ(w->validate(), nullptr);
            // What came late in a search may be stale; nothing else goes wrong.
            for (const Error e : w.errors) EXPECT_EQ(e, Error::stale_id) << describe(e);
        }
    }
}

}  // namespace
}  // namespace islet::test
