// Free systems: what collisions between bodies keep, and what they may only lose.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "measure.hpp"

namespace islet::test {
namespace {

// Boxes, discs and capsules of several densities on a ring, all sent inwards and spinning: they meet, and scatter.
void add_cluster(TestWorld& world, float e, float mu, unsigned seed) {
    std::mt19937 random(seed);
    const auto uniform = [&](float low, float high) { return low + (high - low) * static_cast<float>(random() >> 8) / 16777216.0f; };
    for (int i = 0; i < 36; ++i) {
        const Rot q = make_rot(2 * pi * static_cast<float>(i % 12) / 12);
        const float r = 5 + 2 * static_cast<float>(i / 12);
        BodyDef def = dynamic_at(rotate(q, {r, 0}), uniform(-3, 3));
        def.linear_velocity = rotate(q, {-uniform(2, 4), uniform(-0.5f, 0.5f)});
        def.angular_velocity = uniform(-3, 3);
        ShapeDef shape = rough(mu);
        shape.restitution = e;
        shape.density = uniform(0.5f, 4);
        if (i % 3 == 0) {
            world.add(make_box(uniform(0.2f, 0.5f), uniform(0.2f, 0.5f)), def, shape);
        } else if (i % 3 == 1) {
            world.add(Circle{{}, uniform(0.2f, 0.5f)}, def, shape);
        } else {
            world.add(Capsule{{-0.3f, 0}, {0.3f, 0}, uniform(0.15f, 0.3f)}, def, shape);
        }
    }
}

double total_mass(const TestWorld& world) {
    double m = 0;
    for (const BodyId id : world.bodies()) m += double(world->mass(id));
    return m;
}

class Cluster : public testing::TestWithParam<float> {};

TEST_P(Cluster, KeepsItsLinearMomentum) {
    // Contacts act on both bodies alike: sum m v changes by rounding only. Each of 4 x 2 sweeps a step rounds a velocity of up to 10 m/s
    // per contact: 300 steps x 8 x ~40 contacts x 10 eps x m as a random walk of 1e5 steps stays below 1e-4 M v.
    TestWorld world(roomy, weightless());
    add_cluster(world, GetParam(), 0.5f, 11);
    const Invariants before = invariants_of(world);
    const double tolerance = 1e-4 * total_mass(world);
    for (int i = 0; i < 300; ++i) {
        world.step();
        const Invariants now = invariants_of(world);
        ASSERT_NEAR(now.px, before.px, tolerance) << "step " << i;
        ASSERT_NEAR(now.py, before.py, tolerance) << "step " << i;
    }
    EXPECT_LT(invariants_of(world).energy, before.energy) << "nothing collided";
}

TEST_P(Cluster, KeepsItsAngularMomentumWhileContactsHold) {
    // Each impulse P acts on both bodies along one line, but that line is the one of the moment the manifold was made: while the bodies
    // slip on by up to d (0.01 m until it is made anew, or one step's way in a fast collision), the couple d x P stays behind. Summed with random
    // signs over impulses of about M v in all, that is well under 1 % of the sum of |m r v|.
    TestWorld world(roomy, weightless());
    add_cluster(world, GetParam(), 0.5f, 12);
    const Invariants before = invariants_of(world);
    double scale = 0;
    for (const BodyId id : world.bodies())
        scale += double(world->mass(id)) * double(length(world->center_of_mass(id))) * double(length(world->linear_velocity(id)));
    world.step(300);
    EXPECT_NEAR(invariants_of(world).spin, before.spin, 0.01 * scale);
}

TEST_P(Cluster, NeverHasMoreEnergyThanItBeganWith) {
    // Friction and impacts take energy. Overlap that is pushed apart may give a little back within a step (0.5 % of the whole is seen), but never
    // more than was taken before; 1e-3 covers the rounding of elastic clusters, which lose nothing.
    TestWorld world(roomy, weightless());
    add_cluster(world, GetParam(), 0.5f, 13);
    const double first = invariants_of(world).energy;
    double last = first;
    for (int i = 0; i < 300; ++i) {
        world.step();
        const double now = invariants_of(world).energy;
        ASSERT_LE(now, 1.001 * first) << "step " << i;
        ASSERT_LE(now, last + 0.01 * first) << "step " << i;
        last = now;
    }
}

INSTANTIATE_TEST_SUITE_P(Momentum, Cluster, testing::Values(0.0f, 0.25f, 0.5f, 0.75f, 1.0f));

TEST(Momentum, ASmoothCollisionOfTwoBodiesNeverGainsEnergy) {
    // Two boxes at any angles meet at up to two points: with restitution e the energy after is at most the energy before. A spinning
    // box's corner is met with the speed it had at the start of the step, off by up to w dt = 0.03 rad in direction: 2 % of the energy.
    for (const float e : {0.0f, 0.5f, 1.0f}) {
        std::mt19937 random(5);
        double worst = 0;  // energy after over energy before
        for (int i = 0; i < 50; ++i) {
            TestWorld world(roomy, weightless());
            ShapeDef shape = rough(0);
            shape.restitution = e;
            const auto uniform = [&](float low, float high) {
                return low + (high - low) * static_cast<float>(random() >> 8) / 16777216.0f;
            };
            // Every other pair meets face to face, where two points share the impact.
            const bool flat = i % 2 == 0;
            BodyDef def = dynamic_at({-2, uniform(-0.6f, 0.6f)}, flat ? 0 : uniform(0, 1.5f));
            def.linear_velocity = {uniform(2, 8), 0};
            world.add(make_box(0.5f, 0.3f), def, shape);
            def = dynamic_at({0, 0}, flat ? 0 : uniform(0, 1.5f));
            def.angular_velocity = flat ? 0 : uniform(-2, 2);
            world.add(make_box(0.4f, 0.7f), def, shape);
            const double before = invariants_of(world).energy;
            world.step(120);
            worst = std::fmax(worst, invariants_of(world).energy / before);
        }
        EXPECT_LE(worst, 1.02) << "e " << e;
    }
}

TEST(Momentum, ElasticDiscsKeepTheirEnergy) {
    // Smooth discs with e = 1 that meet in pairs: each collision leaves |relative speed| as it was, so the energy is kept, within rounding
    // of a few dozen operations: 1e-5.
    for (const float offset : {0.0f, 0.3f, 0.6f}) {
        TestWorld world(roomy, weightless());
        ShapeDef shape = rough(0);
        shape.restitution = 1;
        BodyDef def = dynamic_at({-3, offset});
        def.linear_velocity = {5, 0};
        const BodyId a = world.add(Circle{{}, 0.5f}, def, shape);
        const BodyId b = world.add_circle({0, 0}, 0.5f, shape);
        const Invariants before = invariants_of(world);
        world.step(120);
        const Invariants after = invariants_of(world);
        EXPECT_NEAR(after.energy, before.energy, 1e-5 * before.energy) << "offset " << offset;
        EXPECT_NEAR(after.px, before.px, 1e-5 * before.px);
        // Equal masses part at a right angle (or the first one stops): va . vb = 0.
        EXPECT_NEAR(double(dot(world->linear_velocity(a), world->linear_velocity(b))), 0, 1e-3) << "offset " << offset;
    }
}

TEST(Momentum, ElasticDiscsPartAlongTheLineOfTheirCentres) {
    // Without friction the struck disc leaves along n, the line of centres at the touch: with an offset b of the path, sin = b / (2 r).
    // The normal is that of the step's start, up to v dt = 0.083 m before the touch: 0.1 rad at this offset.
    TestWorld world(roomy, weightless());
    ShapeDef shape = rough(0);
    shape.restitution = 1;
    BodyDef def = dynamic_at({-3, 0.5f});
    def.linear_velocity = {5, 0};
    world.add(Circle{{}, 0.5f}, def, shape);
    const BodyId b = world.add_circle({0, 0}, 0.5f, shape);
    world.step(120);
    const Vec2 v = world->linear_velocity(b);
    EXPECT_NEAR(std::atan2(double(v.y), double(v.x)), -std::asin(0.5), 0.1);
}

TEST(Momentum, APerfectlyInelasticImpactLosesTheEnergyOfTheFormula) {
    // e = 0: both go on at the common speed; m1 m2 / (2 (m1 + m2)) u^2 is lost. 1e-5: rounding.
    TestWorld world(roomy, weightless());
    BodyDef def = dynamic_at({-3, 0});
    def.linear_velocity = {6, 0};
    const BodyId a = world.add(Circle{}, def, dense(2));
    const BodyId b = world.add_circle({0, 0}, 0.5f, dense(1));
    const double ma = double(world->mass(a)), mb = double(world->mass(b));
    const double before = invariants_of(world).energy;
    world.step(120);
    EXPECT_NEAR(before - invariants_of(world).energy, ma * mb / (2 * (ma + mb)) * 36, 1e-5 * before);
    EXPECT_NEAR(double(world->linear_velocity(a).x), double(world->linear_velocity(b).x), 1e-5 * 6);
}

}  // namespace
}  // namespace islet::test
