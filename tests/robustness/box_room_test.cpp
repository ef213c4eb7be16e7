// How much room a body thinks it has in its fat boxes, as an attacker would set it: as much as the checks let pass. What is sound must be sound after steps, too.
#include <gtest/gtest.h>

#include <cmath>

#include "data/core.hpp"
#include "support/forge.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

/// The largest finite room of the body, m, with which the world is sound; found by halving.
float most_room(TestWorld& w, std::uint32_t body) {
    float& room = detail::Core::of(*w).motions[body].slack;
    float sound = room, unsound = 1.0e9f;
    for (int i = 0; i < 200 && std::nextafter(sound, unsound) < unsound; ++i) {
        room = std::fmin(0.5f * (sound + unsound), std::fmax(2 * std::fabs(sound), 1.0e-6f) + sound);
        (w->validate() == nullptr ? sound : unsound) = room;
    }
    room = sound;
    return sound;
}

/// A body of two shapes, whose centre is beside its origin, falls onto a floor.
BodyId fill(TestWorld& w, Vec2 at, BodyType type) {
    w.add(make_box(20, 1), at, {}, BodyType::static_body);
    const BodyId body = w.add(make_box(0.4f, 0.7f), at + Vec2{0.5f, 3}, {}, type);
    w->create_shape(body, Circle{{0.9f, 0.3f}, 0.35f});
    w->set_linear_velocity(body, {0.3f, -0.5f});
    w->set_angular_velocity(body, 0.4f);
    return body;
}

constexpr Capacity small{.bodies = 4, .shapes = 8, .contacts = 16};

TEST(BoxRoom, TheMostThatIsTakenIsSoundAfterAnyStep) {
    int taken = 0, moved_away = 0;
    for (const BodyType type : {BodyType::dynamic, BodyType::kinematic})
        for (const Vec2 at : {Vec2{0, 0}, Vec2{-30, 700}, Vec2{4.0e4f, -5.0e3f}, Vec2{3.0e6f, -9.0e5f}, Vec2{-9.99e6f, 9.99e6f}})
            for (const int before : {0, 1, 7, 300}) {
                TestWorld source(small);
                const std::uint32_t body = fill(source, at, type).index1 - 1;
                source.step(before);
                ASSERT_EQ(source->validate(), nullptr);
                const Image image = save(*source);
                for (const float off : {0.0f, -0.4f, 0.4f, -0.9f, 0.9f})
                    for (const float speed : {0.0f, 0.01f, 3.0f, 70.0f})
                        for (const float dt : {1.0f / 1000, 1.0f / 60, 1.0f}) {
                            TestWorld forged(small);
                            ASSERT_TRUE(forged->load(image.bytes()));
                            detail::Core& core = detail::Core::of(*forged);
                            const float far = std::fabs(at.x) + std::fabs(at.y) + 4;
                            core.poses[body].center.y += off * 32 * 0x1p-24f * far;  // as far off its origin as rounding might explain
                            if (forged->validate() != nullptr) continue;
                            most_room(forged, body);
                            core.motions[body].v = {0.2f * speed, -speed};
                            core.motions[body].w = 0.3f * speed;
                            TestWorld w(small);
                            ASSERT_TRUE(w->load(save(*forged).bytes()));
                            ++taken;
                            moved_away += off != 0;
                            for (int i = 0; i < 20; ++i) {
                                w->step(dt);
                                ASSERT_STREQ(w->validate(), nullptr) << "step " << i << " of " << dt << " s at " << at.x << ", " << at.y << " after " << before
                                                                     << " steps, " << off << " off, at " << speed << " m/s, room " << core.motions[body].slack;
                                TestWorld other(small);
                                ASSERT_TRUE(other->load(save(*w).bytes()));
                            }
                        }
            }
    EXPECT_GT(taken, 1000);
    EXPECT_GT(moved_away, 200);
}

}  // namespace
}  // namespace islet::test
