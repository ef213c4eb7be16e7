// Bad arguments to every public function of a world.
#include <cstring>
#include <functional>
#include <set>
#include <string>

#include "refusal.hpp"

namespace {

using namespace islet;
using namespace islet::test;

class BadInput : public RefusalTest {};

// -- ids -------------------------------------------------------------------------------------------------------------------------------

struct BodyCall {
    const char* name;
    std::function<bool(World&, BodyId)> returns_nothing;  // calls it; true if what came back is null or zero
};

const BodyCall body_calls[] = {
    {"destroy_body", [](World& w, BodyId b) { return w.destroy_body(b), true; }},
    {"transform", [](World& w, BodyId b) { return w.transform(b) == Transform{}; }},
    {"position", [](World& w, BodyId b) { return w.position(b) == Vec2{}; }},
    {"angle", [](World& w, BodyId b) { return w.angle(b) == 0; }},
    {"center_of_mass", [](World& w, BodyId b) { return w.center_of_mass(b) == Vec2{}; }},
    {"local_center_of_mass", [](World& w, BodyId b) { return w.local_center_of_mass(b) == Vec2{}; }},
    {"linear_velocity", [](World& w, BodyId b) { return w.linear_velocity(b) == Vec2{}; }},
    {"angular_velocity", [](World& w, BodyId b) { return w.angular_velocity(b) == 0; }},
    {"velocity_at",
     [](World& w, BodyId b) {
         return w.velocity_at(b, {1, 2}) == Vec2{};
     }},
    {"set_transform",
     [](World& w, BodyId b) {
         return w.set_transform(b, {1, 2}, 3), true;
     }},
    {"set_linear_velocity",
     [](World& w, BodyId b) {
         return w.set_linear_velocity(b, {1, 2}), true;
     }},
    {"set_angular_velocity", [](World& w, BodyId b) { return w.set_angular_velocity(b, 1), true; }},
    {"apply_force",
     [](World& w, BodyId b) {
         return w.apply_force(b, {1, 2}, {3, 4}), true;
     }},
    {"apply_force_to_center",
     [](World& w, BodyId b) {
         return w.apply_force_to_center(b, {1, 2}), true;
     }},
    {"apply_torque", [](World& w, BodyId b) { return w.apply_torque(b, 1), true; }},
    {"apply_linear_impulse",
     [](World& w, BodyId b) {
         return w.apply_linear_impulse(b, {1, 2}, {3, 4}), true;
     }},
    {"apply_linear_impulse_to_center",
     [](World& w, BodyId b) {
         return w.apply_linear_impulse_to_center(b, {1, 2}), true;
     }},
    {"apply_angular_impulse", [](World& w, BodyId b) { return w.apply_angular_impulse(b, 1), true; }},
    {"type", [](World& w, BodyId b) { return w.type(b) == BodyType::static_body; }},
    {"set_type", [](World& w, BodyId b) { return w.set_type(b, BodyType::kinematic), true; }},
    {"mass", [](World& w, BodyId b) { return w.mass(b) == 0; }},
    {"rotational_inertia", [](World& w, BodyId b) { return w.rotational_inertia(b) == 0; }},
    {"set_mass",
     [](World& w, BodyId b) {
         return w.set_mass(b, {1, {}, 1}), true;
     }},
    {"reset_mass", [](World& w, BodyId b) { return w.reset_mass(b), true; }},
    {"linear_damping", [](World& w, BodyId b) { return w.linear_damping(b) == 0; }},
    {"set_linear_damping", [](World& w, BodyId b) { return w.set_linear_damping(b, 1), true; }},
    {"angular_damping", [](World& w, BodyId b) { return w.angular_damping(b) == 0; }},
    {"set_angular_damping", [](World& w, BodyId b) { return w.set_angular_damping(b, 1), true; }},
    {"gravity_scale", [](World& w, BodyId b) { return w.gravity_scale(b) == 0; }},
    {"set_gravity_scale", [](World& w, BodyId b) { return w.set_gravity_scale(b, 2), true; }},
    {"set_fixed_rotation", [](World& w, BodyId b) { return w.set_fixed_rotation(b, true), true; }},
    {"enable_sleep", [](World& w, BodyId b) { return w.enable_sleep(b, false), true; }},
    {"is_awake", [](World& w, BodyId b) { return !w.is_awake(b); }},
    {"wake", [](World& w, BodyId b) { return w.wake(b), true; }},
    {"user_data", [](World& w, BodyId b) { return w.user_data(b) == 0; }},
    {"set_user_data", [](World& w, BodyId b) { return w.set_user_data(b, 1), true; }},
    {"shapes", [](World& w, BodyId b) { return w.shapes(b, {}) == 0; }},
    {"create_shape(Circle)", [](World& w, BodyId b) { return !w.create_shape(b, Circle{}); }},
    {"create_shape(Capsule)",
     [](World& w, BodyId b) {
         return !w.create_shape(b, Capsule{{0, 0}, {1, 0}, 1});
     }},
    {"create_shape(Segment)",
     [](World& w, BodyId b) {
         return !w.create_shape(b, Segment{{0, 0}, {1, 0}});
     }},
    {"create_shape(Polygon)", [](World& w, BodyId b) { return !w.create_shape(b, make_box(1, 1)); }},
    {"create_shape(ChainSegment)",
     [](World& w, BodyId b) {
         return !w.create_shape(b, ChainSegment{{-1, 0}, {{0, 0}, {1, 0}}, {2, 0}});
     }},
    {"create_chain",
     [](World& w, BodyId b) {
         const Vec2 points[] = {{0, 0}, {1, 0}};
         return w.create_chain(b, points, false) == 0;
     }},
};

struct ShapeCall {
    const char* name;
    std::function<bool(World&, ShapeId)> returns_nothing;
};

const ShapeCall shape_calls[] = {
    {"destroy_shape", [](World& w, ShapeId s) { return w.destroy_shape(s), true; }},
    {"body", [](World& w, ShapeId s) { return !w.body(s); }},
    {"shape_type", [](World& w, ShapeId s) { return w.shape_type(s) == ShapeType{}; }},
    {"circle", [](World& w, ShapeId s) { return w.circle(s) == nullptr; }},
    {"capsule", [](World& w, ShapeId s) { return w.capsule(s) == nullptr; }},
    {"segment", [](World& w, ShapeId s) { return w.segment(s) == nullptr; }},
    {"polygon", [](World& w, ShapeId s) { return w.polygon(s) == nullptr; }},
    {"chain_segment", [](World& w, ShapeId s) { return w.chain_segment(s) == nullptr; }},
    {"aabb", [](World& w, ShapeId s) { return w.aabb(s) == Aabb{}; }},
    {"friction", [](World& w, ShapeId s) { return w.friction(s) == 0; }},
    {"set_friction", [](World& w, ShapeId s) { return w.set_friction(s, 1), true; }},
    {"restitution", [](World& w, ShapeId s) { return w.restitution(s) == 0; }},
    {"set_restitution", [](World& w, ShapeId s) { return w.set_restitution(s, 1), true; }},
    {"rolling_resistance", [](World& w, ShapeId s) { return w.rolling_resistance(s) == 0; }},
    {"set_rolling_resistance", [](World& w, ShapeId s) { return w.set_rolling_resistance(s, 1), true; }},
    {"tangent_speed", [](World& w, ShapeId s) { return w.tangent_speed(s) == 0; }},
    {"set_tangent_speed", [](World& w, ShapeId s) { return w.set_tangent_speed(s, 1), true; }},
    {"filter", [](World& w, ShapeId s) { return w.filter(s).category == Filter{}.category && w.filter(s).group == 0; }},
    {"set_filter", [](World& w, ShapeId s) { return w.set_filter(s, {.mask = 0}), true; }},
    {"user_data", [](World& w, ShapeId s) { return w.user_data(s) == 0; }},
    {"set_user_data", [](World& w, ShapeId s) { return w.set_user_data(s, 1), true; }},
};

TEST_F(BadInput, EveryFunctionRefusesANullBody) {
    for (const BodyCall& call : body_calls) {
        SCOPED_TRACE(call.name);
        expect_refused(Error::null_id, [&] { EXPECT_TRUE(call.returns_nothing(*w, BodyId{})); });
    }
}

TEST_F(BadInput, EveryFunctionRefusesAStaleBody) {
    // Destroyed; never handed out; from a slot beyond the pool; from the future.
    const BodyId ids[] = {stale_body, {box.index1, box.generation + 2}, {400, 1}, {0xffffffffu, 1}, {1u << 31, 1}, {box.index1, 0}};
    for (const BodyId id : ids) {
        for (const BodyCall& call : body_calls) {
            SCOPED_TRACE(call.name);
            expect_refused(Error::stale_id, [&] { EXPECT_TRUE(call.returns_nothing(*w, id)); });
        }
        EXPECT_FALSE(w->is_valid(id));
    }
}

TEST_F(BadInput, EveryFunctionRefusesANullOrStaleShape) {
    const ShapeId ids[] = {{}, stale_shape, {shape.index1, shape.generation + 2}, {900, 1}, {0xffffffffu, 1}};
    for (const ShapeId id : ids) {
        for (const ShapeCall& call : shape_calls) {
            if (std::strcmp(call.name, "filter") == 0) continue;  // calls twice; below
            SCOPED_TRACE(call.name);
            expect_refused(id ? Error::stale_id : Error::null_id, [&] { EXPECT_TRUE(call.returns_nothing(*w, id)); });
        }
        expect_refused(id ? Error::stale_id : Error::null_id, [&] {
            const Filter filter = w->filter(id);
            EXPECT_EQ(filter.category, Filter{}.category);
        });
        EXPECT_FALSE(w->is_valid(id));
    }
}

TEST_F(BadInput, AskingWhetherAnIdIsValidIsNoError) {
    w.errors.clear();
    EXPECT_FALSE(w->is_valid(BodyId{}));
    EXPECT_FALSE(w->is_valid(stale_body));
    EXPECT_FALSE(w->is_valid(ShapeId{}));
    EXPECT_FALSE(w->is_valid(stale_shape));
    EXPECT_FALSE(w->body_at(100000));
    ContactInfo info;
    EXPECT_FALSE(w->contact_at(100000, info));
    EXPECT_TRUE(w.errors.empty());
}

TEST_F(BadInput, AnIdFromBeforeItsSlotWasUsedAgainStaysStale) {
    const BodyId reborn = w.add_box({5, 5});
    EXPECT_EQ(reborn.index1, stale_body.index1);
    EXPECT_TRUE(w->is_valid(reborn));
    expect_refused(Error::stale_id, [&] { w->destroy_body(stale_body); });
    EXPECT_TRUE(w->is_valid(reborn));
}

TEST_F(BadInput, ReadingAGeometryOfAnotherTypeIsNoError) {
    w.errors.clear();
    EXPECT_NE(w->polygon(shape), nullptr);
    EXPECT_EQ(w->circle(shape), nullptr);
    EXPECT_EQ(w->capsule(shape), nullptr);
    EXPECT_EQ(w->segment(shape), nullptr);
    EXPECT_EQ(w->chain_segment(shape), nullptr);
    EXPECT_TRUE(w.errors.empty());
}

// -- time ------------------------------------------------------------------------------------------------------------------------------

TEST_F(BadInput, ATimeStepMustBeFromAMicrosecondToASecond) {
    for (const float dt : {0.0f, -0.0f, -1.0f / 60, nan, inf, -inf, 10.0f, 1.0001f, 9.99e-7f, 1.0e-36f}) {
        SCOPED_TRACE(dt);
        const StepReport report = w->report();
        const auto moved = w->moved_bodies().size();
        expect_refused(Error::bad_time_step, [&] { w->step(dt); });
        EXPECT_EQ(w->moved_bodies().size(), moved) << "events of the last good step are gone";
        EXPECT_EQ(std::memcmp(&report, &w->report(), sizeof(report)), 0);
    }
    w->step(1.0f);
    EXPECT_EQ(w->validate(), nullptr);
}

// -- the definition of a world -----------------------------------------------------------------------------------------------------------

void expect_no_world(WorldDef def, Error expected) {
    alignas(world_alignment) static std::byte block[world_bytes({.bodies = 1, .shapes = 1, .contacts = 1})];
    static std::vector<Error> heard;
    heard.clear();
    std::memset(block, 0x5a, sizeof(block));
    def.error_hook = [](Error error, void*) { heard.push_back(error); };
    Error error = Error::none;
    EXPECT_EQ(World::create(block, {.bodies = 1, .shapes = 1, .contacts = 1}, def, &error), nullptr);
    EXPECT_EQ(error, expected) << describe(error);
    EXPECT_EQ(heard, std::vector<Error>{expected});
    for (const std::byte b : block) ASSERT_EQ(b, std::byte{0x5a}) << "the block was written to";
    EXPECT_EQ(World::create(block, {.bodies = 1, .shapes = 1, .contacts = 1}, def), nullptr) << "the error pointer may be null";
}

struct SolverFault {
    const char* name;
    std::function<void(SolverDef&)> apply;
    Error error;
};

std::vector<SolverFault> solver_faults() {
    std::vector<SolverFault> faults = {
        {"no substeps", [](SolverDef& d) { d.substeps = 0; }, Error::out_of_range},
        {"too many substeps", [](SolverDef& d) { d.substeps = 65; }, Error::out_of_range},
        {"no iterations", [](SolverDef& d) { d.iterations = 0; }, Error::out_of_range},
        {"too many iterations", [](SolverDef& d) { d.iterations = 257; }, Error::out_of_range},
        {"too many relax iterations", [](SolverDef& d) { d.relax_iterations = 257; }, Error::out_of_range},
        {"zero hertz", [](SolverDef& d) { d.contact_hertz = 0; }, Error::out_of_range},
        {"negative hertz", [](SolverDef& d) { d.contact_hertz = -1; }, Error::out_of_range},
        {"negative damping ratio", [](SolverDef& d) { d.contact_damping_ratio = -1; }, Error::out_of_range},
        {"negative push speed", [](SolverDef& d) { d.contact_push_speed = -1; }, Error::out_of_range},
        {"negative baumgarte", [](SolverDef& d) { d.baumgarte = -0.1f; }, Error::out_of_range},
        {"baumgarte above 1", [](SolverDef& d) { d.baumgarte = 1.1f; }, Error::out_of_range},
        {"omega 0", [](SolverDef& d) { d.omega = 0; }, Error::out_of_range},
        {"omega 2", [](SolverDef& d) { d.omega = 2; }, Error::out_of_range},
        {"negative shock", [](SolverDef& d) { d.shock = -0.1f; }, Error::out_of_range},
        {"shock above the most", [](SolverDef& d) { d.shock = 1.01f * max_shock; }, Error::out_of_range},
        {"negative tolerance", [](SolverDef& d) { d.tolerance = -1e-6f; }, Error::out_of_range},
        {"no such order of sweeps", [](SolverDef& d) { d.sweep_order = static_cast<SweepOrder>(4); }, Error::out_of_range},
        {"no such schedule", [](SolverDef& d) { d.schedule = static_cast<Schedule>(7); }, Error::out_of_range},
    };
    for (float SolverDef::*member : {&SolverDef::contact_hertz, &SolverDef::contact_damping_ratio, &SolverDef::contact_push_speed,
                                     &SolverDef::baumgarte, &SolverDef::omega, &SolverDef::shock, &SolverDef::tolerance})
        for (const float bad : not_finite) faults.push_back({"not finite", [=](SolverDef& d) { d.*member = bad; }, Error::not_finite});
    return faults;
}

TEST_F(BadInput, TheSolverTakesOnlyNumbersInRange) {
    for (const SolverFault& fault : solver_faults()) {
        SCOPED_TRACE(fault.name);
        SolverDef def;
        fault.apply(def);
        expect_refused(fault.error, [&] { w->set_solver(def); });
        WorldDef world;
        world.solver = def;
        expect_no_world(world, fault.error);
    }
}

TEST_F(BadInput, AWorldTakesOnlyNumbersInRange) {
    for (const Vec2 bad : not_finite_vectors) {
        expect_refused(Error::not_finite, [&] { w->set_gravity(bad); });
        WorldDef def;
        def.gravity = bad;
        expect_no_world(def, Error::not_finite);
    }
    for (float WorldDef::*member : {&WorldDef::restitution_threshold, &WorldDef::max_speed}) {
        for (const float bad : {nan, inf, -inf, -1.0f}) {
            WorldDef def;
            def.*member = bad;
            expect_no_world(def, bad == -1.0f ? Error::out_of_range : Error::not_finite);
        }
    }
    WorldDef still;
    still.max_speed = 0;
    expect_no_world(still, Error::out_of_range);
    for (const std::uint32_t lanes : {2u, 3u, 5u, 15u, 32u, 0xffffffffu}) {
        WorldDef def;
        def.lanes = lanes;
        expect_no_world(def, Error::out_of_range);
    }
}

// -- sentences ---------------------------------------------------------------------------------------------------------------------------

TEST(Describe, SaysSomethingDifferentAboutEveryError) {
    std::set<std::string> sentences;
    for (int e = 0; e <= static_cast<int>(Error::endless_shape); ++e) {
        const char* sentence = describe(static_cast<Error>(e));
        ASSERT_NE(sentence, nullptr);
        EXPECT_GT(std::strlen(sentence), 5u);
        EXPECT_TRUE(sentences.insert(sentence).second) << sentence;
    }
    EXPECT_NE(describe(static_cast<Error>(255)), nullptr);
}

}  // namespace
