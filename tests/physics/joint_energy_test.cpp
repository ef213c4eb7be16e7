// Hinged bodies at the default settings: pendulums of several rods and hinged rods in space keep their energy and momenta; bridges keep together; nets rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "measure.hpp"
#include "support/random.hpp"
#include "support/starts.hpp"

namespace islet::test {
namespace {

constexpr int starts = 10;

// Bodies that meet nothing, and their hinges.
struct Linkage {
    TestWorld world;
    std::vector<BodyId> rods;  // or discs
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

TEST(JointEnergy, ADoublePendulumSwingsForTenMinutes) { holds_from_every_start("wild_pendulum"); }

TEST(JointEnergy, ATriplePendulumSwingsForTwoMinutes) { swings_for(3, 120, 0.02, 0.05); }

TEST(JointEnergy, ThreeHingedRodsInSpaceTurnOn) { holds_from_every_start("rods_in_space"); }

TEST(JointEnergy, ARodTurnsTenTimesASecondOnItsHinge) { holds_from_every_start("spun_rod"); }

TEST(JointTrees, ABridgeOf60PlanksBearsACrateOfATon) { holds_from_every_start("long_bridges"); }  // and another one 100 kg

TEST(JointTrees, ARagdollWhirledByFiftyTimesItsWeightHoldsTogether) { holds_from_every_start("whirled_doll"); }

// Loops of hinges, which are swept, whatever they bear. No force drives the net, so it gains no energy, and what hangs in it comes to rest.
TEST(Nets, OfHingedDiscsRestUnderAHeavyOne) {
    constexpr float apart = 0.3f;  // m
    for (const int side : {3, 6}) {
        for (const float load : {50.0f, 120.0f, 200.0f}) {
            for (std::uint32_t start = 0; start < (slow_build ? 1 : starts); ++start) {
                SCOPED_TRACE(std::to_string(side) + " discs a side, load " + std::to_string(int(load)) + ", start " + std::to_string(start));
                Linkage net(sleepless());
                Random random(start);
                for (int i = 0; i < side * side; ++i) {
                    const int x = i % side, y = i / side;
                    BodyDef at = dynamic_at({apart * float(x), -apart * float(y)});
                    const bool holds = y == 0 && (x == 0 || x == side - 1);
                    if (holds) at.type = BodyType::static_body;
                    if (!holds) at.linear_velocity = {random.between(-0.1f, 0.1f), 0};
                    const bool heavy = y == side - 1 && x == side / 2;
                    net.rods.push_back(net.world.add(Circle{{}, 0.05f}, at, {.density = heavy ? load : 1, .filter = {.mask = 0}}));
                    const Vec2 middle = at.position;
                    if (x > 0) net.hinge(net.rods[std::size_t(i - 1)], net.rods.back(), middle - Vec2{0.5f * apart, 0});
                    if (y > 0) net.hinge(net.rods[std::size_t(i - side)], net.rods.back(), middle + Vec2{0, 0.5f * apart});
                }
                double weight = 0;
                for (const BodyId disc : net.rods) weight += double(net.world->mass(disc)) * g;
                const double first = net.energy();
                double most = first, late = 0;
                for (int i = 0; i < 1200; ++i) {
                    net.world.step();
                    most = std::max(most, net.energy());
                }
                for (const BodyId disc : net.rods) late = std::max(late, double(length(net.world->linear_velocity(disc))));
                EXPECT_LT(most - first, 0.01 * weight * double(apart) * side);
                EXPECT_LT(late, 1);  // m/s
            }
        }
    }
}

}  // namespace
}  // namespace islet::test
