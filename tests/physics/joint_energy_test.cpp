// Hinged bodies at the default settings: pendulums of several rods and hinged rods in space keep their energy and momenta; bridges keep together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "measure.hpp"

namespace islet::test {
namespace {

constexpr int starts = 10;

// Bodies that meet nothing, and their hinges.
struct Linkage {
    TestWorld world;
    std::vector<BodyId> rods;
    std::vector<JointId> hinges;

    explicit Linkage(const WorldDef& def) : world({.bodies = 128, .shapes = 128, .contacts = 256, .joints = 128}, def) {}

    /// A rod of 1 m from `from`, and where it ends.
    Vec2 add_rod(Vec2 from, double angle) {
        const Vec2 along = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
        rods.push_back(world.add(make_box(0.5f, 0.04f), dynamic_at(from + 0.5f * along, static_cast<float>(angle)), {.filter = {.mask = 0}}));
        return from + along;
    }
    void hinge(BodyId a, BodyId b, Vec2 at) {
        RevoluteJointDef def;
        const Transform pose_a = world->transform(a), pose_b = world->transform(b);
        def.base = {.body_a = a, .body_b = b, .frame_a = {inv_rotate(pose_a.q, at - pose_a.p)}, .frame_b = {inv_rotate(pose_b.q, at - pose_b.p)}};
        hinges.push_back(world->create_joint(def));
    }
    double energy() const { return energy_of(*world, rods); }
    double gap() const { return widest_gap(*world, hinges); }
};

// The energy that a pendulum of rods may swing with is what it has above hanging down. Positions and velocities are half a substep apart: up to 0.7 % of it.
void swings_for(int rods, double seconds, double most_gained, double most_lost) {
    for (int start = 0; start < starts; ++start) {
        SCOPED_TRACE(start);
        Linkage pendulum(sleepless());
        BodyId previous = pendulum.world->create_body({});
        Vec2 at = {0, 0};
        double least = 0;
        for (int i = 0; i < rods; ++i) {
            const double degrees = i == 0 ? 90 + 0.7 * (start - 5) : 172 + 1.1 * (start - 5);  // from hanging down
            const Vec2 from = at;
            at = pendulum.add_rod(from, (degrees - 90) * double(pi) / 180);
            pendulum.hinge(previous, pendulum.rods.back(), from);
            previous = pendulum.rods.back();
            least -= double(pendulum.world->mass(previous)) * g * (i + 0.5);
        }
        const double before = pendulum.energy(), scale = before - least;
        double most = 0, lowest = 0, gap = 0;
        for (int i = 0; i < static_cast<int>(60 * seconds); ++i) {
            pendulum.world.step();
            const double gained = (pendulum.energy() - before) / scale;
            most = std::max(most, gained);
            lowest = std::min(lowest, gained);
            gap = std::max(gap, pendulum.gap());
        }
        EXPECT_LT(most, most_gained);
        EXPECT_GT(lowest, -most_lost);
        EXPECT_LT(gap, 1e-4);
    }
}

TEST(JointEnergy, ADoublePendulumSwingsForTenMinutes) { swings_for(2, 600, 0.01, 0.05); }

TEST(JointEnergy, ATriplePendulumSwingsForTwoMinutes) { swings_for(3, 120, 0.02, 0.05); }

TEST(JointEnergy, ThreeHingedRodsInSpaceTurnOn) {
    for (int start = 0; start < starts; ++start) {
        SCOPED_TRACE(start);
        Linkage free(weightless());
        const double bend = 0.1 + 0.25 * start, turn = 10;
        Vec2 at = {0, 0};
        for (const double angle : {0.0, bend, -0.7 * bend}) {
            const Vec2 from = at;
            at = free.add_rod(from, angle);
            if (free.rods.size() > 1) free.hinge(free.rods[free.rods.size() - 2], free.rods.back(), from);
        }
        Vec2 middle = {0, 0};
        for (const BodyId id : free.rods) middle += (1.0f / 3) * free.world->center_of_mass(id);
        for (const BodyId id : free.rods) {
            free.world->set_linear_velocity(id, cross(static_cast<float>(turn), free.world->center_of_mass(id) - middle));
            free.world->set_angular_velocity(id, static_cast<float>(turn));
        }
        const Invariants before = invariants_of(free.world);
        free.world.step(586 * 60);
        const Invariants after = invariants_of(free.world);
        EXPECT_NEAR(after.energy / before.energy, 1, 0.05);
        EXPECT_NEAR(after.spin / before.spin, 1, 0.001);
        EXPECT_LT(free.gap(), 1e-4);
    }
}

// 60 planks of 5 kg, hinged to each other and to both banks, and a crate on them.
double widest_gap(float load, float place) {
    Linkage bridge(sleepless());
    const BodyId banks = bridge.world->create_body({});
    BodyId previous = banks;
    for (int i = 0; i < 60; ++i) {
        const Vec2 middle = {static_cast<float>(i) - 29.5f, 0};
        const BodyId plank = bridge.world.add(make_box(0.5f, 0.125f), middle, dense(20));
        bridge.hinge(previous, plank, middle - Vec2{0.5f, 0});
        previous = plank;
    }
    bridge.hinge(previous, banks, {30, 0});
    bridge.world.add(make_box(1, 1), Vec2{place, 1.2f}, dense(0.25f * load));
    double gap = 0;
    for (int i = 0; i < 1200; ++i) {
        bridge.world.step();
        gap = std::max(gap, bridge.gap());
    }
    EXPECT_EQ(bridge.world->validate(), nullptr);
    return gap;
}

TEST(JointTrees, ABridgeOf60PlanksBearsACrateOf100Kilograms) {
    for (int start = 0; start < starts; ++start) EXPECT_LT(widest_gap(100, -9 + 2.13f * static_cast<float>(start)), 0.002) << "start " << start;
}

TEST(JointTrees, ABridgeOf60PlanksBearsACrateOfATon) {
    for (int start = 0; start < starts; ++start) EXPECT_LT(widest_gap(1000, -9 + 2.13f * static_cast<float>(start)), 0.01) << "start " << start;
}

}  // namespace
}  // namespace islet::test
