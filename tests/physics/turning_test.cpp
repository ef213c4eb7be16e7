// Bodies that turn together: what lies on a board or in a swing answers to where its support points now, not to where it pointed a while ago.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "measure.hpp"

namespace islet::test {
namespace {

// A box slides off a board that is slowly turned: along it, s'' = -g sin(w t) + w^2 s against friction of mu (g cos(w t) + 2 w s').
TEST(Turning, ABoxSlidesOffABoardWhenItsTiltSaysSo) {
    const Vec2 triangle[] = {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0, 0.5f}};
    for (const float friction : {0.0f, 0.05f, 0.3f}) {
        for (const double rate : {0.02, 0.1, 0.5}) {
            double at = 0, speed = 0, tilt = 0;
            constexpr double h = 1e-4;
            for (double t = 0; at > -0.02; t += h) {
                tilt = rate * t;
                const double pull = -g * std::sin(tilt) + rate * rate * at, held = double(friction) * (g * std::cos(tilt) + 2 * rate * speed);
                speed = std::fmin(speed + h * (pull + held), 0.0);  // it begins downwards, and does not turn back
                at += h * speed;
            }
            for (const bool is_box : {true, false}) {
                TestWorld world(roomy, sleepless());
                BodyDef board;
                board.type = BodyType::kinematic;
                board.angular_velocity = static_cast<float>(rate);
                world.add(make_box(20, 0.5f), board, rough(friction));
                BodyDef def = dynamic_at({0, 1});
                def.linear_velocity = {-static_cast<float>(rate), 0};
                def.angular_velocity = static_cast<float>(rate);
                const BodyId box = world.add(is_box ? make_box(0.5f, 0.5f) : make_polygon(compute_hull(triangle)), def, rough(friction));
                double turned = 0;
                for (double along = 0; along > -0.02 && turned < 1;) {
                    world.step();
                    turned += rate * double(step_time);
                    along = double(world->position(box).x) * std::cos(turned) + double(world->position(box).y) * std::sin(turned);
                }
                EXPECT_NEAR(turned, tilt, 0.002 + 1.5 * rate * double(step_time)) << "friction " << friction << ", " << rate << " rad/s, box " << is_box;
            }
        }
    }
}

// A tray that hangs from a hinge 3 m above, with three boxes in it. They hold still, so it swings as a rigid body does, with the period
// 2 pi sqrt(I / (m g l)) but for amplitude^2 / 16 (Landau and Lifshitz, "Mechanics", section 11), and hardly loses height. (Where it turns more slowly than
// 0.05 rad/s, cargo still holds it a little: of the smallest swing that is much of the way.)
TEST(Turning, CargoDoesNotBrakeASwing) {
    for (const float amplitude : {0.04f, 0.08f, 0.3f}) {
        TestWorld world(roomy, sleepless());
        const Rot q = make_rot(amplitude);
        const BodyId ground = world->create_body({}), tray = world->create_body(dynamic_at({}, amplitude));
        world->create_shape(tray, make_offset_box(1.5f, 0.1f, {{0, -3}, {}}), rough(0.6f));
        RevoluteJointDef hinge;
        hinge.base.body_a = ground;
        hinge.base.body_b = tray;
        world->create_joint(hinge);
        std::vector<BodyId> all = {tray};
        for (const float x : {-0.9f, 0.0f, 0.9f}) all.push_back(world.add(make_box(0.4f, 0.4f), dynamic_at(rotate(q, {x, -2.5f}), amplitude), rough(0.6f)));
        double inertia = 0;
        Vec2 center = {};
        for (const BodyId id : all) {
            const Vec2 at = world->center_of_mass(id);
            inertia += double(world->rotational_inertia(id)) + double(world->mass(id)) * double(length_squared(at));
            center += world->mass(id) * at;
        }
        const double moment = double(length(center)) * g;
        const double period = 2 * double(pi) * std::sqrt(inertia / moment) * (1 + double(amplitude) * double(amplitude) / 16);
        double first = 0, last = 0, before = double(amplitude), late = 0;
        int crossings = 0;
        for (int i = 1; i <= 1800; ++i) {
            world.step();
            const double angle = double(world->angle(tray));
            if (before * angle < 0) {
                last = (i - 1 + before / (before - angle)) * double(step_time);
                if (crossings++ == 0) first = last;
            }
            before = angle;
            if (i > 1500) late = std::fmax(late, std::fabs(angle));
        }
        ASSERT_GT(crossings, 10);
        EXPECT_NEAR(2 * (last - first) / (crossings - 1), period, (amplitude < 0.05f ? 0.02 : 0.005) * period) << "s, amplitude " << amplitude;
        EXPECT_GT(late, 0.9 * double(amplitude)) << "after 25 s";
        EXPECT_LT(late, 1.02 * double(amplitude)) << "after 25 s";
    }
}

}  // namespace
}  // namespace islet::test
