// Pendulums: their periods against the elliptic integral, their energy, and how well their joints hold.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "measure.hpp"
#include "support/joint_world.hpp"

namespace islet::test {
namespace {

/// Period of a pendulum of small-swing rate omega let go at `amplitude`: 2 pi / (omega M(1, cos(amplitude / 2))), with Gauss's
/// arithmetic-geometric mean M, which is the complete elliptic integral in disguise.
double exact_period(double omega, double amplitude) {
    double a = 1, b = std::cos(amplitude / 2);
    for (int i = 0; i < 30; ++i) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    return 2 * std::numbers::pi / (omega * a);
}

/// A bob at `length` from the origin, let go at rest at `amplitude` from straight down.
struct Pendulum {
    TestWorld world{room_for_joints, sleepless()};
    BodyId pivot, bob;
    double length = 0;

    explicit Pendulum(float l, double amplitude) : length(double(l)) {
        pivot = world->create_body({});
        const Rot q = make_rot(static_cast<float>(amplitude));
        bob = world.add(make_box(0.1f, 0.1f), dynamic_at({l * q.s, -l * q.c}, static_cast<float>(amplitude)));
    }
    void hang_by_hinge() {
        const auto l = static_cast<float>(length);
        EXPECT_TRUE(world->create_joint(RevoluteJointDef{.base = {.body_a = pivot, .body_b = bob, .frame_b = {{0, l}}}}));
    }
    void hang_by_rod() {
        EXPECT_TRUE(world->create_joint(DistanceJointDef{.base = {.body_a = pivot, .body_b = bob}, .length = static_cast<float>(length)}));
    }
    /// rad from straight down
    double angle() const {
        const Vec2 p = world->center_of_mass(bob);
        return std::atan2(double(p.x), -double(p.y));
    }
    double energy() const { return kinetic_energy(*world, bob) + g * double(world->mass(bob)) * double(world->center_of_mass(bob).y); }
    double joint_error() const { return double(world->joint_error(world->joint_at(0)).linear); }
    /// Mean over `periods` periods, s, from the moments the bob crosses the lowest point, which are interpolated between steps.
    double measured_period(int periods) {
        double first = 0, last = 0, before = angle();
        for (int crossings = 0, i = 1; crossings <= 2 * periods; ++i) {
            if (i > 100000) return 0;
            world.step();
            const double now = angle();
            if ((before > 0) != (now > 0)) {
                last = (i - now / (now - before)) * double(step_time);
                if (crossings++ == 0) first = last;
            }
            before = now;
        }
        return (last - first) / periods;
    }
    /// Rate of small swings. By a hinge the bob turns with the rod, by a rod it does not.
    double rate(bool turns) const {
        const double own = turns ? double(world->rotational_inertia(bob)) / double(world->mass(bob)) : 0;
        return std::sqrt(g * length / (length * length + own));
    }
};

TEST(PendulumPeriod, OfAHingeFollowsTheEllipticIntegralFromSmallToLargeSwings) {
    // A substep follows 1/240 s of motion with an error of second order, (omega h)^2 / 24 = 7e-6; joints that give way a little and friction-free
    // solves leave the rest. 0.1 % is a sixtieth of what separates 90 degrees from small swings.
    for (const double amplitude : {0.05, 0.5, std::numbers::pi / 2, 2.0, 2.5}) {
        SCOPED_TRACE(amplitude);
        Pendulum p(1, amplitude);
        p.hang_by_hinge();
        const double expected = exact_period(p.rate(true), amplitude);
        // At 2.5 rad the period is 1.75 times that of small swings, and a change of the energy by 1 % changes it by 1 % too.
        EXPECT_NEAR(p.measured_period(5) / expected, 1, amplitude < 2.2 ? 1e-3 : 2e-3);
    }
}

TEST(PendulumPeriod, OfARodFollowsTheEllipticIntegralToo) {
    for (const double amplitude : {0.05, 1.0, 2.0}) {
        SCOPED_TRACE(amplitude);
        Pendulum p(2, amplitude);
        p.hang_by_rod();
        EXPECT_NEAR(p.measured_period(5) / exact_period(p.rate(false), amplitude), 1, 1e-3);
    }
}

TEST(PendulumEnergy, StaysOverTenSeconds) {
    // Let go from level. The fall of one length is the scale; symplectic Euler swings about the true energy by h omega of it, and keeps its mean.
    for (const bool rod : {false, true}) {
        SCOPED_TRACE(rod ? "rod" : "hinge");
        Pendulum p(1, std::numbers::pi / 2);
        rod ? p.hang_by_rod() : p.hang_by_hinge();
        const double scale = g * double(p.world->mass(p.bob)) * p.length, start = p.energy();
        double low = 0, high = 0, error = 0;
        for (int i = 0; i < 600; ++i) {
            p.world.step();
            low = std::fmin(low, (p.energy() - start) / scale);
            high = std::fmax(high, (p.energy() - start) / scale);
            error = std::fmax(error, p.joint_error());
        }
        EXPECT_GT(low, -0.02);
        EXPECT_LT(high, 0.02);
        EXPECT_LT(error, 5e-4) << "m";
    }
}

TEST(DoublePendulum, KeepsItsEnergyForTenSeconds) {
    // Two rods of one metre let go from level: chaotic, so only what is conserved can be compared. 2 % of the fall of the upper rod's end.
    TestWorld world(room_for_joints, sleepless());
    const BodyId pivot = world->create_body({});
    ShapeDef ghost;
    ghost.filter.mask = 0;
    const BodyId upper = world.add(make_box(0.5f, 0.05f), dynamic_at({0.5f, 0}), ghost);
    const BodyId lower = world.add(make_box(0.5f, 0.05f), dynamic_at({1.5f, 0}), ghost);
    world->create_joint(RevoluteJointDef{.base = {.body_a = pivot, .body_b = upper, .frame_b = {{-0.5f, 0}}}});
    world->create_joint(RevoluteJointDef{.base = {.body_a = upper, .body_b = lower, .frame_a = {{0.5f, 0}}, .frame_b = {{-0.5f, 0}}}});
    const auto energy = [&] {
        double sum = 0;
        for (const BodyId id : {upper, lower}) sum += kinetic_energy(*world, id) + g * double(world->mass(id)) * double(world->center_of_mass(id).y);
        return sum;
    };
    const double start = energy(), scale = g * double(world->mass(upper) + world->mass(lower)) * 1.0;
    double error = 0;
    for (int i = 0; i < 600; ++i) {
        world.step();
        EXPECT_NEAR((energy() - start) / scale, 0, 0.02) << "step " << i;
        for (std::uint32_t slot = 0; slot < 2; ++slot) error = std::fmax(error, double(world->joint_error(world->joint_at(slot)).linear));
        if (HasFailure()) return;
    }
    EXPECT_LT(error, 2e-3) << "m";
}

TEST(Pendulum, PullsAtItsHingeWithWeightAndCentripetalForce) {
    // At the lowest point after a fall from level the hinge carries m g + m v^2 / l with v^2 = 2 g l / (1 + i / l^2): nearly three times the weight.
    Pendulum p(1, std::numbers::pi / 2);
    p.hang_by_hinge();
    while (p.angle() > 0) p.world.step();
    const double m = double(p.world->mass(p.bob)), own = double(p.world->rotational_inertia(p.bob)) / m;
    const double expected = m * g * (1 + 2 / (1 + own));
    const Vec2 force = p.world->joint_force(p.world->joint_at(0));
    EXPECT_NEAR(double(length(force)) / expected, 1, 0.01);  // a step later the angle is up to 0.07 rad past the lowest point
    EXPECT_NEAR(double(p.world->joint_torque(p.world->joint_at(0))), 0, 1e-6);
}

}  // namespace
}  // namespace islet::test
