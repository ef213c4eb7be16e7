// What spares a fast body a look at its surroundings says what the look would have said, as far out as worlds reach: a lean build does without, and must give
// the same bits.
#include <gtest/gtest.h>

#include "support/random.hpp"
#include "support/test_world.hpp"
#include "world/continuous.hpp"

namespace islet::test {
namespace {

constexpr float far_out[] = {0, 1e3f, 3e4f, 1e5f, 1e6f, 9e6f};  // m from the origin

// A slow rod falls, point first, on a wall about as far away as a body is taken to be alone, so fast that it has not looked so far ahead; with or without a
// thing around it that it passes through.
TEST(Shortcuts, WhoIsAloneMovesAsIfItWereNot) {
    Random random(2);
    std::uint32_t stopped = 0;
    for (int i = 0; i < 12'000; ++i) {
        const float out = far_out[i % 6], radius = random.between(0.05f, 2);
        const Rot q = make_rot(random.one_in(2) ? 0 : random.between(-pi, pi));
        const Vec2 center{out, random.between(-out, out)}, ahead = rotate(q, {1, 0});
        const float way = radius * random.between(3.7f, 4.05f) - 1e-7f * random.between(-2, 2) * out;
        const float gap = radius * random.between(4.6f, 5.1f) + 1e-7f * random.between(-4, 4) * out;
        const auto thrown = [&](bool alone) {
            WorldDef def;
            def.gravity = 60 * 60 / 0.625f * way * ahead;  // which it falls in four substeps
            def.max_speed = 1e4f;
            TestWorld w({.bodies = 3, .shapes = 3, .contacts = 2}, def);
            BodyDef rod;
            rod.type = BodyType::dynamic;
            rod.position = center;
            rod.linear_velocity = 0.01f * ahead;
            const BodyId body = w.add(Segment{radius * ahead, -radius * ahead}, rod);
            w.add(make_offset_box(0.01f, 3 * radius, {{}, q}), center + gap * ahead, {}, BodyType::static_body);
            ShapeDef unseen;
            unseen.filter = {.category = 0, .mask = 0};
            if (!alone) w.add_circle(center, 10 * radius, unseen, BodyType::static_body);
            w.step();
            return w->center_of_mass(body);
        };
        const Vec2 end = thrown(true);
        ASSERT_EQ(end, thrown(false)) << "trial " << i << ", " << out << " m out";
        if (distance(end, center) < 0.99f * way) ++stopped;
    }
    EXPECT_GT(stopped, 1000u);
}

}  // namespace
}  // namespace islet::test
