// Turning: inertia of compounds, spin without torque, and the periods of things that rock.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "measure.hpp"

namespace islet::test {
namespace {

constexpr double exact_pi = 3.14159265358979323846;

TEST(Inertia, OfACompoundFollowsFromTheParallelAxes) {
    // m = sum m_i, c = sum m_i c_i / m, I = sum (I_i + m_i |c_i - c|^2), with I = m (a^2 + b^2) / 12 of a box a by b and m r^2 / 2 of a
    // disc. A few dozen roundings, 1e-5 relative.
    TestWorld world;
    const BodyId id = world->create_body(dynamic_at({5, -3}, 0.4f));
    ShapeDef light, heavy;
    light.density = 2;
    heavy.density = 7;
    world->create_shape(id, make_offset_box(1, 0.25f, {{-1, 0.5f}, make_rot(0.7f)}), light);
    world->create_shape(id, make_offset_box(0.5f, 0.5f, {{1, 2}, {}}), heavy);
    world->create_shape(id, Circle{{2, -1}, 0.75f}, light);

    struct Part {
        double m, x, y, own;
    };
    const double disc = 2 * exact_pi * 0.75 * 0.75;
    const Part parts[] = {{2.0, -1, 0.5, 2.0 * (4 + 0.25) / 12}, {7.0, 1, 2, 7.0 * 2 / 12}, {disc, 2, -1, disc * 0.75 * 0.75 / 2}};
    double m = 0, x = 0, y = 0, inertia = 0;
    for (const Part& p : parts) m += p.m, x += p.m * p.x, y += p.m * p.y;
    x /= m, y /= m;
    for (const Part& p : parts) inertia += p.own + p.m * ((p.x - x) * (p.x - x) + (p.y - y) * (p.y - y));

    EXPECT_NEAR(double(world->mass(id)), m, 1e-5 * m);
    EXPECT_NEAR(double(world->local_center_of_mass(id).x), x, 1e-5);
    EXPECT_NEAR(double(world->local_center_of_mass(id).y), y, 1e-5);
    EXPECT_NEAR(double(world->rotational_inertia(id)), inertia, 1e-5 * inertia);
}

TEST(Inertia, OfACapsuleIsThatOfARectangleAndTwoHalfDiscs) {
    // Rectangle 2 L x 2 r, two half discs that make a disc of m2 = rho pi r^2: their inertia about the capsule's centre is
    // m2 r^2 / 2 + m2 (L^2 + 8 r L / (3 pi)).
    TestWorld world;
    const double half = 1.5, r = 0.5;
    const BodyId id = world.add_capsule({0, 0}, 1.5f, 0.5f);
    const double m1 = 4 * half * r, m2 = exact_pi * r * r;
    const double inertia = m1 * (4 * half * half + 4 * r * r) / 12 + m2 * (r * r / 2 + half * half + 8 * r * half / (3 * exact_pi));
    EXPECT_NEAR(double(world->mass(id)), m1 + m2, 1e-5);
    EXPECT_NEAR(double(world->rotational_inertia(id)), inertia, 1e-5 * inertia);
}

TEST(Spin, WithoutTorqueKeepsItsSpeedToTheLastBit) {
    // w is constant; angle = w t. integrate() is short by d^5 / 45 per step of d = w / 60, and rounds by a few eps.
    for (const float w : {0.5f, 3.0f, -7.0f}) {
        TestWorld world({.bodies = 1, .shapes = 2, .contacts = 1}, weightless());
        BodyDef def = dynamic_at({1, 2});
        def.angular_velocity = w;
        const BodyId id = world.add(make_offset_box(0.5f, 0.1f, {{0.3f, 0.2f}, {}}), def);
        const Vec2 center = world->center_of_mass(id);
        // A body given a spin about its origin gets its centre of mass moving when shapes move that centre; the test wants it still.
        world->set_linear_velocity(id, {0, 0});
        world.step(600);
        EXPECT_EQ(world->angular_velocity(id), w);
        const double d = std::abs(double(w)) / 60, tolerance = 600 * (std::pow(d, 5) / 45 + 4 * eps);
        EXPECT_NEAR(std::remainder(double(world->angle(id)) - 10 * double(w), 2 * exact_pi), 0, tolerance) << "w " << w;
        EXPECT_EQ(world->center_of_mass(id), center);
    }
}

// Times at which f(t) crosses zero, interpolated between the steps.
struct Crossings {
    std::vector<double> at;
    double last = 0, last_t = 0;
    bool any = false;
    void see(double t, double value) {
        if (any && (value > 0) != (last > 0)) at.push_back(last_t + (t - last_t) * last / (last - value));
        any = true;
        last = value;
        last_t = t;
    }
};

TEST(Rocking, ADiscWithItsWeightOffCentreSwingsWithItsSmallOscillationPeriod) {
    // A disc of radius R rolls on a plane, its centre of mass d below the middle at rest. Small swings turn about the touching point:
    //     T = 2 pi sqrt((I + m (R - d)^2) / (m g d)).
    // Swings of 0.1 rad are longer by about theta^2 / 16, 0.06 %; the substeps' soft contact and the lever arms kept between manifolds
    // leave less than 1 %.
    for (const double d : {0.1, 0.2, 0.3}) {
        TestWorld world(roomy, sleepless());
        world.add_ground(0, 100, rough(1));
        constexpr double radius = 0.5, inertia = 0.15, mass = 2, swing = 0.1;
        // Turned by theta about the touching point, the middle has rolled by -R theta.
        const BodyId id =
            world.add(Circle{{0, 0}, 0.5f}, dynamic_at({static_cast<float>(-radius * swing), 0.5f}, static_cast<float>(swing)), rough(1));
        world->set_mass(id, {static_cast<float>(mass), {0, static_cast<float>(-d)}, static_cast<float>(inertia)});
        Crossings angle;
        for (int i = 1; i <= 3600; ++i) {
            world.step(1, 1.0f / 240);
            angle.see(i / 240.0, double(world->angle(id)));
        }
        const double period = 2 * exact_pi * std::sqrt((inertia + mass * (radius - d) * (radius - d)) / (mass * g * d));
        ASSERT_GE(angle.at.size(), 9u) << "d " << d;
        const double measured = (angle.at[8] - angle.at[0]) / 4;
        EXPECT_NEAR(measured, period, 0.01 * period) << "d " << d;
    }
}

TEST(Rocking, ABoxTippedOntoItsEdgeFallsBackInHousnersTime) {
    // A block of half diagonal r and slenderness alpha = atan(width / height), tipped by theta0 about one corner, turns about it by
    // I w' = -m g r sin(alpha - theta). For small alpha it is flat again after acosh(1 / (1 - theta0 / alpha)) / p, p = sqrt(m g r / I),
    // I = 4 m r^2 / 3 (Housner 1963). sin alpha < alpha makes it longer by alpha^2 / 12, 0.4 % here; the contact ahead of the touch and
    // the step in which it is seen make up the rest of 3 %.
    for (const double share : {0.2, 0.4, 0.6}) {
        TestWorld world(roomy, sleepless());
        world.add_ground(0, 100, rough(2));
        constexpr double hx = 0.2, hy = 1;
        const double alpha = std::atan(hx / hy), r = std::hypot(hx, hy), theta = share * alpha, p = std::sqrt(3 * g / (4 * r));
        // Turned by -theta about its right lower corner, which stays at the origin.
        const Rot q = make_rot(static_cast<float>(-theta));
        const BodyId id = world.add(make_box(0.2f, 1), dynamic_at(rotate(q, {-0.2f, 1}), static_cast<float>(-theta)), rough(2));
        Crossings angle;
        double t = 0;
        while (angle.at.empty() && t < 5) {
            world.step(1, 1.0f / 240);
            t += 1.0 / 240;
            // Flat is when it stands on both corners; the solver stops it there within the slop, 0.005 m over its width.
            angle.see(t, double(world->angle(id)) + 0.002);
        }
        ASSERT_FALSE(angle.at.empty()) << "theta / alpha " << share;
        const double due = std::acosh(1 / (1 - share)) / p;
        EXPECT_NEAR(angle.at[0], due, 0.03 * due) << "theta / alpha " << share;
    }
}

}  // namespace
}  // namespace islet::test
