// Velocities that underflow: what a factor makes of a small negative speed is -0, and a lane that adds nothing to it, beside one that has something to
// add, must not show.
#include <gtest/gtest.h>

#include "support/test_world.hpp"

namespace islet::test {
namespace {

std::uint64_t hash_of_slow_world(std::uint32_t lanes, Schedule schedule, float max_speed, float damping) {
    WorldDef def;
    def.max_speed = max_speed;
    def.solver.schedule = schedule;
    def.lanes = lanes;
    TestWorld w(roomy, def);
    // Two contacts in the air, which are solved beside each other: a surface that moves, and one that bounces.
    const auto add = [&](const auto& geometry, Vec2 at, const ShapeDef& shape) {
        w.add(geometry, BodyDef{.type = BodyType::dynamic, .position = at, .linear_velocity = {-1e-9f, 0}, .linear_damping = damping}, shape);
    };
    add(make_box(1, 0.5f), {4, 12.5f}, {});
    add(make_box(0.5f, 1), {4, 14}, {.restitution = 1});
    add(make_box(0.5f, 0.5f), {-2, 6}, {.tangent_speed = -6});
    add(Circle{}, {-2.375f, 6}, {});
    w.step(10, 1.0f / 120);
    return w->hash();
}

TEST(Underflow, LanesAgreeOnWorldsWithHardlyAnySpeed) {
    for (const Schedule schedule : {Schedule::soft, Schedule::classic}) {
        for (const float max_speed : {1.4e-45f, 2.8e-45f, 1e-40f, 1e-30f, 400.0f}) {
            for (const float damping : {0.0f, 1e30f, 3e38f}) {
                const std::uint64_t one = hash_of_slow_world(1, schedule, max_speed, damping);
                EXPECT_EQ(hash_of_slow_world(4, schedule, max_speed, damping), one) << "four lanes, at most " << max_speed << " m/s, damping " << damping;
                EXPECT_EQ(hash_of_slow_world(8, schedule, max_speed, damping), one) << "eight lanes, at most " << max_speed << " m/s, damping " << damping;
            }
        }
    }
}

}  // namespace
}  // namespace islet::test
