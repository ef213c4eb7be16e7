// Limits one after another, which bear what hangs on all that follow, take energy or leave it: they give none.
#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "../support/random.hpp"
#include "measure.hpp"

namespace islet::test {
namespace {

constexpr float half = 0.25f;  // m, of a plank or link

/// J: the weight of a row times its length.
double weight_times_length(const World& world, std::span<const BodyId> row) {
    double mass = 0;
    for (const BodyId body : row) mass += double(world.mass(body));
    return mass * g * 2 * double(half) * double(row.size());
}

/// m/s
double fastest(const World& world, std::span<const BodyId> row) {
    double most = 0;
    for (const BodyId body : row) most = std::fmax(most, double(length(world.linear_velocity(body))));
    return most;
}

/// Planks in a row on a hinge at the origin and hinges between them, the last one `load` times as dense. Each start moves them a little. At first the two
/// points of each hinge are `gap` apart (m).
struct Planks {
    TestWorld world;
    std::vector<BodyId> bodies;

    std::vector<JointId> hinges;

    Planks(int count, float load, JointLimit limit, float friction, Vec2 along, std::uint32_t start, const WorldDef& def, float gap = 0) : world(roomy, def) {
        Random random(start);
        const float angle = along.x != 0 ? 0 : -pi / 2;
        BodyId before = world->create_body({});
        for (int i = 0; i < count; ++i) {
            BodyDef at = dynamic_at((gap + half + (gap + 2 * half) * float(i)) * along, angle);
            at.linear_velocity = {random.between(-0.1f, 0.1f), along.x != 0 ? random.between(-0.1f, 0.1f) : 0};
            bodies.push_back(world.add(make_box(0.8f * half, 0.07f), at, dense(i + 1 == count ? load : 1)));
            RevoluteJointDef hinge{
                .base = {.body_a = before, .body_b = bodies.back(), .frame_a = {{i == 0 ? 0 : half, 0}, i == 0 ? angle : 0.0f}, .frame_b = {{-half, 0}, {}}}};
            hinge.limit = limit;
            hinge.friction = friction;
            hinges.push_back(world->create_joint(hinge));
            before = bodies.back();
        }
    }
};

class LimitsInSeries : public testing::TestWithParam<std::tuple<int, float, bool, JointTrees>> {};

// A row that juts out falls onto its limits, which bear all of it. No force drives it, so it has never more energy than at its start; a hundredth of its weight
// times its length is left to limits that mend what the blow has bent.
TEST_P(LimitsInSeries, GiveNoEnergy) {
    const auto [count, load, symmetric, trees] = GetParam();
    const JointLimit limit = symmetric ? JointLimit{.enable = true, .lower = -0.3f, .upper = 0.3f} : JointLimit{.enable = true, .lower = 0, .upper = 0.5f};
    for (std::uint32_t start = 0; start < 10; ++start) {
        WorldDef def = sleepless();
        def.solver.joint_trees = trees;
        Planks row(count, load, limit, 0, {1, 0}, start, def);
        const double before = energy_of(*row.world, row.bodies);
        double most = before;
        for (int i = 0; i < 1200; ++i) {
            row.world.step();
            most = std::fmax(most, energy_of(*row.world, row.bodies));
        }
        EXPECT_LT(most - before, 0.01 * weight_times_length(*row.world, row.bodies)) << "start " << start;
        ASSERT_EQ(row.world.errors.size(), 0u);
    }
}

std::string name_of_row(const testing::TestParamInfo<LimitsInSeries::ParamType>& test) {
    return std::to_string(std::get<0>(test.param)) + "_planks_load_" + std::to_string(int(std::get<1>(test.param))) +
           (std::get<2>(test.param) ? "_both_ways" : "_one_way") + (std::get<3>(test.param) == JointTrees::off ? "_swept" : "");
}
INSTANTIATE_TEST_SUITE_P(Rows, LimitsInSeries,
                         testing::Combine(testing::Values(4, 6, 8, 12), testing::Values(1.0f, 3.0f, 10.0f, 30.0f), testing::Bool(),
                                          testing::Values(JointTrees::automatic, JointTrees::off)),
                         name_of_row);

TEST(LimitsUnderLoad, PlanksThatJutOutComeToRestUnderAHeavyTip) {
    for (const int count : {1, 2, 3}) {
        for (const float load : {10.0f, 30.0f, 100.0f, 300.0f}) {
            Planks row(count, load, {.enable = true, .lower = 0, .upper = 0.5f}, 0, {1, 0}, 1, {});
            row.world.step(1800);
            EXPECT_FALSE(row.world->is_awake(row.bodies[0])) << count << " planks, load " << load;
        }
    }
}

enum class Link { distance, slider, wheel };

/// Links that hang one from another, each at its limit.
JointId hang(World& world, Link link, BodyId above, BodyId below, bool first) {
    const float end = link == Link::distance ? 0.8f * half : half;
    JointBase base = {.body_a = above, .body_b = below, .frame_a = {{0, first ? 0 : -end}, {}}, .frame_b = {{0, end}, {}}};
    if (link == Link::distance) {
        const float reach = (first ? 0.2f : 0.4f) * half;
        return world.create_joint(DistanceJointDef{.base = base, .length = reach, .limit = {.enable = true, .lower = 0, .upper = reach}});
    }
    base.frame_a.angle = base.frame_b.angle = -pi / 2;
    const JointLimit limit = {.enable = true, .lower = -0.2f, .upper = 0.1f};
    if (link == Link::slider) return world.create_joint(PrismaticJointDef{.base = base, .limit = limit});
    return world.create_joint(WheelJointDef{.base = base, .spring = {.enable = false}, .limit = limit});
}

TEST(LimitsUnderLoad, WhatHangsFromLimitToLimitComesToRestUnderAHeavyEnd) {
    for (const Link link : {Link::distance, Link::slider, Link::wheel}) {
        for (const int count : {2, 3, 6}) {
            for (const float load : {10.0f, 30.0f, 100.0f}) {
                for (std::uint32_t start = 0; start < 10; ++start) {
                    const std::string which = "link " + std::to_string(int(link)) + ", " + std::to_string(count) + " of them, load " +
                                              std::to_string(int(load)) + ", start " + std::to_string(start);
                    TestWorld world(roomy, sleepless());
                    Random random(start);
                    std::vector<BodyId> bodies;
                    BodyId before = world->create_body({});
                    for (int i = 0; i < count; ++i) {
                        BodyDef at = dynamic_at({0, -half - 2 * half * float(i)});
                        const float nudge = random.between(-0.1f, 0.1f);
                        at.linear_velocity = link == Link::distance ? Vec2{nudge, 0} : Vec2{0, nudge};
                        bodies.push_back(world.add(make_box(0.07f, 0.8f * half), at, dense(i + 1 == count ? load : 1)));
                        hang(*world, link, before, bodies.back(), i == 0);
                        before = bodies.back();
                    }
                    const double at_start = energy_of(*world, bodies);
                    double most = at_start, late = 0;
                    for (int i = 0; i < 1800; ++i) {
                        world.step();
                        most = std::fmax(most, energy_of(*world, bodies));
                        if (i > 1200) late = std::fmax(late, fastest(*world, bodies));
                    }
                    EXPECT_LT(most - at_start, 0.01 * weight_times_length(*world, bodies)) << which;
                    EXPECT_LT(late, 1) << which;  // m/s; ropes swing on with what they began with
                    ASSERT_EQ(world.errors.size(), 0u);
                }
            }
        }
    }
}

// Loads that no rail bears: telescopes of sliders and struts of wheels that jut out come apart. What then falls and swings has no more energy than at first.
TEST(LimitsUnderLoad, TelescopesThatComeApartAreNotThrown) {
    for (const bool wheels : {false, true}) {
        for (const int count : {3, 6}) {
            for (const float load : {200.0f, 1000.0f}) {
                for (std::uint32_t start = 0; start < (slow_build ? 2 : 10); ++start) {
                    TestWorld world(roomy, sleepless());
                    Random random(start);
                    std::vector<BodyId> bodies;
                    BodyId before = world->create_body({});
                    for (int i = 0; i < count; ++i) {
                        BodyDef at = dynamic_at({half + 2 * half * float(i), 0});
                        at.linear_velocity = {0, random.between(-0.1f, 0.1f)};
                        bodies.push_back(world.add(make_box(half, random.between(0.04f, 0.1f)), at, dense(i + 1 == count ? load : 1)));
                        const JointBase base = {
                            .body_a = before, .body_b = bodies.back(), .frame_a = {{i == 0 ? 0 : half, 0}, {}}, .frame_b = {{-half, 0}, {}}};
                        const JointLimit limit = {.enable = true, .lower = 0, .upper = 0.2f};
                        if (wheels) {
                            world->create_joint(WheelJointDef{.base = base, .spring = {.enable = false}, .limit = limit});
                        } else {
                            world->create_joint(PrismaticJointDef{.base = base, .limit = limit});
                        }
                        before = bodies.back();
                    }
                    const double first = energy_of(*world, bodies);
                    double most = first;
                    for (int i = 0; i < 1200; ++i) {
                        world.step();
                        most = std::fmax(most, energy_of(*world, bodies));
                    }
                    EXPECT_LT(most - first, 0.01 * weight_times_length(*world, bodies))
                        << (wheels ? "wheels, " : "sliders, ") << count << ", load " << load << ", start " << start;
                }
            }
        }
    }
}

// Sweeps cannot carry so much, and hand the rope over, its hinges open, to be solved exactly.
TEST(FrictionUnderLoad, ARopeOfHingesWithFrictionComesToRestUnderAHeavyEnd) {
    for (const auto& [count, load] : {std::tuple{5, 200.0f}, {5, 1000.0f}, {10, 200.0f}, {10, 300.0f}, {10, 1000.0f}, {20, 300.0f}}) {
        for (const float friction : {0.001f, 0.1f}) {
            if (slow_build && count == 20) continue;
            const std::uint32_t starts = slow_build ? 2 : count == 20 ? 3 : 10;
            int restless = 0;
            for (std::uint32_t start = 0; start < starts; ++start) {
                Planks rope(count, load, {}, friction, {0, -1}, start, sleepless());
                rope.world.step(1200);
                double late = 0;
                for (int i = 0; i < 600; ++i) {
                    rope.world.step();
                    late = std::fmax(late, fastest(*rope.world, rope.bodies));
                }
                restless += late > 1;
            }
            EXPECT_EQ(restless, 0) << count << " links, load " << load << ", friction " << friction;
        }
    }
}

// Hinges do no work: however heavy the end is, nothing gets faster than what falls through all gaps together.
TEST(RopesMadeApart, CloseTheirGapsWithoutThrowingTheirLoad) {
    for (const int count : {3, 10}) {
        for (const float load : {1.0f, 30.0f, 300.0f}) {
            for (const float gap : {0.005f, 0.03f}) {
                for (std::uint32_t start = 0; start < (slow_build ? 2 : 10); ++start) {
                    const std::string which = std::to_string(count) + " links, load " + std::to_string(load) + ", gaps of " + std::to_string(gap) + " m";
                    Planks rope(count, load, {}, 0, {0, -1}, start, sleepless(), gap);
                    double most = 0;
                    for (int i = 0; i < 600; ++i) {
                        rope.world.step();
                        most = std::fmax(most, fastest(*rope.world, rope.bodies));
                    }
                    EXPECT_LT(most, std::sqrt(2 * g * double(gap) * count) + 0.1) << which;  // 0.1 m/s: with what they began
                    for (const JointId hinge : rope.hinges) EXPECT_LT(double(rope.world->joint_error(hinge).linear), 0.002) << which;
                }
            }
        }
    }
}

}  // namespace
}  // namespace islet::test
