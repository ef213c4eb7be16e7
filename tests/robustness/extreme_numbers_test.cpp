// Every number that a world takes without complaint, as large or as small as it takes it: a world must refuse a number or survive it.
#include <functional>
#include <ostream>
#include <string>

#include "refusal.hpp"
#include "support/image.hpp"
#include "support/island.hpp"

namespace {

using namespace islet;
using namespace islet::test;

struct ExtremeCall {
    const char* name;
    std::function<void(TestWorld&, BodyId, float)> with;
    friend void PrintTo(const ExtremeCall& call, std::ostream* out) { *out << call.name; }
};

template <class Set>
void each_shape(TestWorld& w, Set&& set) {
    for (const BodyId id : w.bodies()) set(w.shape_of(id));
}

template <class Set>
void change_solver(TestWorld& w, Set&& set) {
    SolverDef def = w->solver();
    set(def);
    w->set_solver(def);
}

const ExtremeCall calls[] = {
    {"set_gravity",
     [](TestWorld& w, BodyId, float x) {
         w->set_gravity({x, -x});
     }},
    {"set_linear_velocity",
     [](TestWorld& w, BodyId b, float x) {
         w->set_linear_velocity(b, {x, -x});
     }},
    {"set_angular_velocity", [](TestWorld& w, BodyId b, float x) { w->set_angular_velocity(b, x); }},
    {"set_transform",
     [](TestWorld& w, BodyId b, float x) {
         w->set_transform(b, {x, x}, x);
     }},
    {"apply_force",
     [](TestWorld& w, BodyId b, float x) {
         w->apply_force(b, {x, -x}, {1, x});
     }},
    {"apply_force_to_center_twice",
     [](TestWorld& w, BodyId b, float x) {
         for (int i = 0; i < 2; ++i) w->apply_force_to_center(b, {x, -x});
     }},
    {"apply_torque", [](TestWorld& w, BodyId b, float x) { w->apply_torque(b, x); }},
    {"apply_linear_impulse",
     [](TestWorld& w, BodyId b, float x) {
         w->apply_linear_impulse(b, {x, 0}, {0, x});
     }},
    {"apply_linear_impulse_to_center",
     [](TestWorld& w, BodyId b, float x) {
         w->apply_linear_impulse_to_center(b, {x, x});
     }},
    {"apply_angular_impulse", [](TestWorld& w, BodyId b, float x) { w->apply_angular_impulse(b, x); }},
    {"set_mass_mass",
     [](TestWorld& w, BodyId b, float x) {
         w->set_mass(b, {x, {}, 1});
     }},
    {"set_mass_center",
     [](TestWorld& w, BodyId b, float x) {
         w->set_mass(b, {1, {x, x}, 1});
     }},
    {"set_mass_center_of_what_turns",
     [](TestWorld& w, BodyId b, float x) {
         w->set_angular_velocity(b, x);
         w->set_mass(b, {1, {3, 2}, 1});
         w->set_mass(b, {1, {-3, 2}, 1});
     }},
    {"apply_impulses_twice",
     [](TestWorld& w, BodyId b, float x) {
         for (int i = 0; i < 2; ++i) {
             w->apply_linear_impulse(b, {x, -x}, {100, x});
             w->apply_angular_impulse(b, x);
             w->apply_torque(b, x);
         }
     }},
    {"set_mass_inertia",
     [](TestWorld& w, BodyId b, float x) {
         w->set_mass(b, {1, {}, x});
     }},
    {"set_linear_damping", [](TestWorld& w, BodyId b, float x) { w->set_linear_damping(b, x); }},
    {"set_angular_damping", [](TestWorld& w, BodyId b, float x) { w->set_angular_damping(b, x); }},
    {"set_gravity_scale", [](TestWorld& w, BodyId b, float x) { w->set_gravity_scale(b, x); }},
    {"set_friction", [](TestWorld& w, BodyId, float x) { each_shape(w, [&](ShapeId s) { w->set_friction(s, x); }); }},
    {"set_rolling_resistance", [](TestWorld& w, BodyId, float x) { each_shape(w, [&](ShapeId s) { w->set_rolling_resistance(s, x); }); }},
    {"set_tangent_speed", [](TestWorld& w, BodyId, float x) { each_shape(w, [&](ShapeId s) { w->set_tangent_speed(s, x); }); }},
    {"density",
     [](TestWorld& w, BodyId b, float x) {
         ShapeDef d;
         d.density = x;
         w->create_shape(b, make_offset_box(1, 1, {{0.5f, 0}, {}}), d);
     }},
    {"contact_hertz", [](TestWorld& w, BodyId, float x) { change_solver(w, [&](SolverDef& d) { d.contact_hertz = x; }); }},
    {"contact_damping_ratio", [](TestWorld& w, BodyId, float x) { change_solver(w, [&](SolverDef& d) { d.contact_damping_ratio = x; }); }},
    {"contact_push_speed", [](TestWorld& w, BodyId, float x) { change_solver(w, [&](SolverDef& d) { d.contact_push_speed = x; }); }},
    {"omega", [](TestWorld& w, BodyId, float x) { change_solver(w, [&](SolverDef& d) { d.omega = x; }); }},
};

class ExtremeNumber : public testing::TestWithParam<ExtremeCall> {};

TEST_P(ExtremeNumber, IsRefusedOrSurvived) {
    for (const float size : {1e-45f, 1e-40f, 1e-38f, 1e-20f, 1e10f, 1e19f, 1e20f, 1e30f, 1e38f, 3.4028234e38f}) {
        for (const float x : {size, -size}) {
            TestWorld w;
            w.add_ground();
            const BodyId box = w.add_box({0, 0.48f});
            w.add_circle({0.2f, 1.4f});
            w.step(5);
            GetParam().with(w, box, x);
            EXPECT_EQ(w->validate(), nullptr) << GetParam().name << '(' << x << "), before any step";
            w.step(5);
            GetParam().with(w, box, x);
            w.step(20);
            const char* broken = w->validate();
            EXPECT_TRUE(broken == nullptr && w.is_finite())
                << GetParam().name << '(' << x << "): " << (broken != nullptr ? broken : "not finite");
            const char* fault = fault_in(*ExportedIsland(*w, box, 1.0f / 240));
            EXPECT_EQ(fault, nullptr) << GetParam().name << '(' << x << "): the island's " << fault;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(ExtremeCall, ExtremeNumber, testing::ValuesIn(calls), [](const auto& test) { return std::string(test.param.name); });

TEST(ExtremeSpeedLimit, IsRefusedOrSurvived) {
    for (const float limit : {1e-38f, 1e6f, 1e19f, 1e20f, 3.4028234e38f}) {
        WorldDef def;
        def.max_speed = limit;
        TestWorld w(roomy, def);
        if (w.get() == nullptr) continue;
        w.add_ground();
        const BodyId box = w.add_box({0, 2});
        w->set_linear_velocity(box, {limit, -limit});
        w.step(5, 1);
        const char* broken = w->validate();
        EXPECT_TRUE(broken == nullptr && w.is_finite()) << limit << ": " << (broken != nullptr ? broken : "not finite");
    }
}

// How fast surfaces meet is worked out from what pulls at the bodies until then; no body is ever as fast as the strongest pull would make it.
TEST(ExtremeNumbers, WhatBouncesUnderAnyPullHasFiniteImpulses) {
    for (const float pull : {1e10f, 1e20f, 1e30f, 1e36f, 1e37f, 1e38f, 3.4e38f}) {
        for (const bool is_gravity : {false, true}) {
            for (const float dt : {1.0f / 240, 1.0f / 60, 1.0f}) {
                TestWorld w;
                w.add_ground(0, 100, {.restitution = 0.3f});
                const BodyId ball = w.add_circle({0, 3}, 0.5f, {.restitution = 1, .density = 6000});
                w->set_linear_velocity(ball, {0, -300});
                if (is_gravity) {
                    w->set_gravity({0, -pull});
                } else {
                    w->apply_force_to_center(ball, {0, -pull});
                }
                for (int i = 0; i < 6; ++i) {
                    w.step(1, dt);
                    const char* broken = w->validate();
                    ASSERT_TRUE(broken == nullptr && w.is_finite()) << "pull " << pull << ", dt " << dt << ": " << (broken != nullptr ? broken : "not finite");
                }
            }
        }
    }
}

// Ten thousand kilometres out a fat box has no margin that a float could hold, so a shape may lie outside its own by rounding. Where a body rests, its
// boxes are those of the tree all the same.
TEST(ExtremeNumbers, ABodyAtRestThatReachesToTheEndOfTheWorldMayGetMoreShapes) {
    for (int i = 0; i < 200; ++i) {
        TestWorld w;
        const float turn = 0.037f * static_cast<float>(i);
        const BodyId body = w->create_body({.type = BodyType::dynamic, .position = {1.3f + turn, 0.7f}, .angle = turn});
        w->create_shape(body, Circle{{-9.99e6f, 17 * turn}, 2.6f});
        w->create_shape(body, Circle{{0.3f, turn}, 1.3f});
        w->set_gravity({0, 0});
        w.step(60);  // until it sleeps
        ASSERT_FALSE(w->is_awake(body));
        w->create_shape(body, make_offset_box(7, 0.5f, {{1, -9}, {}}));
        ASSERT_EQ(w->validate(), nullptr) << "turned by " << turn;
        w.step();
        ASSERT_EQ(w->validate(), nullptr) << "turned by " << turn;
    }
}

// Each shape's mass is a number, but not their sum, or not its first moment: the body weighs a kilogram, as one whose only shape is too heavy to say.
TEST(ExtremeNumbers, ABodyOfShapesThatAreTooHeavyTogetherHasAPlace) {
    for (const float density : {3.0e29f, 3.0e35f, 3.0e37f, 3.0e38f}) {
        for (const float apart : {0.0f, 1.0f, 1.0e4f, 9.0e6f}) {
            TestWorld w;
            const BodyId body = w->create_body({.type = BodyType::dynamic});
            for (const float x : {apart, -apart, 0.5f * apart}) w->create_shape(body, Circle{{x, 1}, 0.5f}, {.density = density});
            const auto expect_sound = [&] {
                const char* broken = w->validate();
                EXPECT_EQ(broken, nullptr) << broken << ": density " << density << ", " << apart << " m apart";
                EXPECT_TRUE(w.is_finite() && is_finite(w->mass(body)) && is_finite(w->rotational_inertia(body)) && is_finite(w->center_of_mass(body)));
                const Image image = save(*w);
                TestWorld other;
                EXPECT_TRUE(other->load(image.bytes())) << "density " << density << ", " << apart << " m apart";
            };
            expect_sound();
            w.step(2);
            expect_sound();
        }
    }
}

}  // namespace
