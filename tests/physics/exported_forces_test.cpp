// Exported islands, solved exactly, give the forces that statics gives; and what the engine itself stored is close to that.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "measure.hpp"
#include "support/island.hpp"
#include "support/joint_world.hpp"

namespace {

using namespace islet;
using namespace islet::test;

constexpr float h = 1.0f / 240;  // s

double weight(const World& w, BodyId body) { return double(w.mass(body)) * g; }

// All are exact here; they get there in different ways.
constexpr lcp::Method exact_methods[] = {lcp::Method::newton, lcp::Method::lemke, lcp::Method::pgs};

/// Of a row of a joint.
double impulse_of(const ExportedIsland& island, const std::vector<double>& x, JointId joint, RowKind kind, std::uint32_t skip = 0) {
    for (std::size_t i = 0; i < x.size(); ++i) {
        const IslandRow& r = island->rows[i];
        const bool of_contact = r.kind == RowKind::normal || r.kind == RowKind::friction || r.kind == RowKind::rolling;
        if (!of_contact && r.slot == joint.index1 - 1 && r.kind == kind && skip-- == 0) return x[i];
    }
    ADD_FAILURE() << "no such row";
    return 0;
}

TEST(ExportedStatics, ABoxPressesOnTheFloorWithItsWeight) {
    TestWorld w(roomy, sleepless());
    w.add_ground();
    const BodyId box = w.add_box({0, 0.5f}, 0.5f, 0.5f, dense(3));
    w.step(120);
    for (const float step : {h, 0.25f * h, 4 * h}) {
        for (const lcp::Method method : exact_methods) {
            const ExportedIsland island(*w, box, step);
            const WideSolution s = solve(island, method);
            ASSERT_EQ(s.result.status, lcp::Status::converged) << lcp::describe(s.result.status);
            // The box may still move by a rounding of its speed, and be a rounding above the floor.
            EXPECT_NEAR(island.sum_of(RowKind::normal, s.x), weight(*w, box) * double(step), 1e-3 * weight(*w, box) * double(step));
        }
    }
}

// Gravity at an angle of which the tangent is `slope` is a floor at that angle.
struct Slope {
    TestWorld w;
    BodyId box;
    explicit Slope(float slope) : w(roomy, {.gravity = {10 * slope, -10}, .enable_sleep = false}) {
        w.add_ground(0, 1000, rough(0.5f));
        box = w.add_box({0, 0.5f}, 1, 0.5f, rough(0.5f));
        w.step(60);
    }
};

TEST(ExportedStatics, FrictionHoldsWhatItCanAndNoMore) {
    for (const float slope : {0.3f, 0.45f}) {
        const Slope s(slope);
        const ExportedIsland island(*s.w, s.box, h);
        const WideSolution x = solve(island, lcp::Method::newton);
        ASSERT_EQ(x.result.status, lcp::Status::converged);
        EXPECT_NEAR(std::fabs(island.sum_of(RowKind::friction, x.x)), double(slope) * weight(*s.w, s.box) * double(h),
                    1e-3 * weight(*s.w, s.box) * double(h))
            << "it holds the box against " << slope << " of its weight";
    }
    const Slope s(0.8f);
    const ExportedIsland island(*s.w, s.box, h);
    const WideSolution x = solve(island, lcp::Method::newton);
    ASSERT_EQ(x.result.status, lcp::Status::converged);
    EXPECT_NEAR(std::fabs(island.sum_of(RowKind::friction, x.x)), 0.5 * island.sum_of(RowKind::normal, x.x), 1e-6)
        << "sliding: mu times the normal impulse";
    EXPECT_NEAR(island.sum_of(RowKind::normal, x.x), weight(*s.w, s.box) * double(h), 1e-3 * weight(*s.w, s.box) * double(h));
}

// A chain of links that hangs straight down: each joint carries what hangs below it.
TEST(ExportedStatics, EachJointOfAHangingChainCarriesWhatHangsBelow) {
    constexpr int links = 12;
    TestWorld w(roomy, sleepless());
    BodyId above = w->create_body({.position = {0, 20}});
    std::vector<JointId> joints;
    double below = 0;
    for (int i = 0; i < links; ++i) {
        const BodyId link = w.add_box({0, 19.5f - static_cast<float>(i)}, 0.1f, 0.5f, dense(1 + static_cast<float>(i % 3)));
        joints.push_back(w->create_joint(
            RevoluteJointDef{.base = {.body_a = above, .body_b = link, .frame_a = {{0, i == 0 ? 0.0f : -0.5f}}, .frame_b = {{0, 0.5f}}}}));
        below += weight(*w, link);
        above = link;
    }
    for (const lcp::Method method : {lcp::Method::newton, lcp::Method::lemke}) {
        const ExportedIsland island(*w, above, h);
        ASSERT_EQ(island->bodies.size(), std::size_t{links});
        const WideSolution s = solve(island, method);
        ASSERT_EQ(s.result.status, lcp::Status::converged) << lcp::describe(s.result.status);
        double carried = below;
        for (int i = 0; i < links; ++i) {
            EXPECT_NEAR(impulse_of(island, s.x, joints[static_cast<std::size_t>(i)], RowKind::joint, 1), carried * double(h),
                        1e-4 * below * double(h))
                << "joint " << i;
            EXPECT_NEAR(impulse_of(island, s.x, joints[static_cast<std::size_t>(i)], RowKind::joint, 0), 0, 1e-6);
            carried -= weight(*w, island->bodies[static_cast<std::size_t>(i)].id);
        }
    }
}

// A bob on a rod at rest, at an angle to the vertical: the rod takes the part of the weight that is along it.
TEST(ExportedStatics, ARodTakesTheWeightAlongIt) {
    for (const float angle : {0.0f, 0.4f, 1.2f}) {
        TestWorld w(roomy, sleepless());
        const BodyId hook = w->create_body({.position = {0, 5}});
        const Rot q = make_rot(angle);
        const BodyId bob = w.add_circle({2 * q.s, 5 - 2 * q.c}, 0.2f);
        w->create_joint(DistanceJointDef{.base = {.body_a = hook, .body_b = bob}, .length = 2});
        const ExportedIsland island(*w, bob, h);
        const WideSolution s = solve(island, lcp::Method::lemke);
        ASSERT_EQ(s.result.status, lcp::Status::converged);
        ASSERT_EQ(s.x.size(), 1u);
        EXPECT_NEAR(s.x[0], -weight(*w, bob) * std::cos(double(angle)) * double(h), 1e-5 * weight(*w, bob) * double(h));
    }
}

// An arm held level by the motor of its hinge needs m g l; a weaker motor gives all it has, and the arm begins to fall.
TEST(ExportedStatics, AMotorGivesWhatIsNeededUpToWhatItHas) {
    for (const float strength : {0.5f, 0.9f, 1.1f, 5.0f}) {
        TestWorld w(roomy, sleepless());
        const BodyId wall = w->create_body({});
        const BodyId arm = w.add_box({1, 0}, 1, 0.1f);
        const double needed = weight(*w, arm) * 1.0;  // N m
        const JointId hinge =
            w->create_joint(RevoluteJointDef{.base = {.body_a = wall, .body_b = arm, .frame_b = {{-1, 0}}},
                                             .motor = {.enable = true, .speed = 0, .max_force = strength * static_cast<float>(needed)}});
        const ExportedIsland island(*w, arm, h);
        const WideSolution s = solve(island, lcp::Method::lemke);
        ASSERT_EQ(s.result.status, lcp::Status::converged);
        const double given = std::fmin(double(strength), 1.0) * needed;
        EXPECT_NEAR(impulse_of(island, s.x, hinge, RowKind::motor), given * double(h), 1e-5 * needed * double(h));
        // Of what is missing comes an angular acceleration about the hinge.
        const double inertia = double(w->rotational_inertia(arm)) + double(w->mass(arm));
        EXPECT_NEAR(velocities_after(*island, s.x)[0].w, -(needed - given) / inertia * double(h), 1e-5);
    }
}

TEST(ExportedStatics, ALimitHoldsAnArmAndDryFrictionCarriesItsShare) {
    for (const float friction : {0.0f, 0.25f, 2.0f}) {
        TestWorld w(roomy, sleepless());
        const BodyId wall = w->create_body({});
        const BodyId arm = w.add_box({1, 0}, 1, 0.1f);
        const double needed = weight(*w, arm) * 1.0;
        const JointId hinge = w->create_joint(RevoluteJointDef{.base = {.body_a = wall, .body_b = arm, .frame_b = {{-1, 0}}},
                                                               .limit = {.enable = true, .lower = 0, .upper = 1},
                                                               .friction = friction * static_cast<float>(needed)});
        const ExportedIsland island(*w, arm, h);
        // The two may share the load in any way as long as friction keeps its bound: only their sum is certain.
        const WideSolution s = solve(island, lcp::Method::lemke);
        ASSERT_EQ(s.result.status, lcp::Status::converged);
        const double rubbed = friction > 0 ? impulse_of(island, s.x, hinge, RowKind::joint_friction) : 0;
        EXPECT_NEAR(impulse_of(island, s.x, hinge, RowKind::limit, 0) + rubbed, needed * double(h), 1e-5 * needed * double(h));
        EXPECT_LE(std::fabs(rubbed), double(friction) * needed * double(h) * (1 + 1e-6));
        EXPECT_NEAR(impulse_of(island, s.x, hinge, RowKind::limit, 1), 0, 1e-9) << "the upper one is far";
    }
}

// Weights on both sides of a pulley, balanced by its ratio.
TEST(ExportedStatics, ABalancedPulleyCarriesBothWeights) {
    TestWorld w(roomy, sleepless());
    const BodyId left = w.add_box({-2, 0}, 0.5f, 0.5f, dense(2)), right = w.add_box({2, 0}, 0.5f, 0.5f, dense(3));
    w->create_joint(PulleyJointDef{.base = {.body_a = left, .body_b = right}, .ground_a = {-2, 4}, .ground_b = {2, 4}, .ratio = 1.5f});
    const ExportedIsland island(*w, left, h);
    const WideSolution s = solve(island, lcp::Method::lemke);
    ASSERT_EQ(s.result.status, lcp::Status::converged);
    EXPECT_NEAR(s.x.at(0), weight(*w, left) * double(h), 1e-5 * weight(*w, left) * double(h)) << "the tension";
    for (const WideVelocity& v : velocities_after(*island, s.x)) EXPECT_NEAR(v.vy, 0, 1e-6);
}

// -- piles ------------------------------------------------------------------------------------------------------------------------------------------------

BodyId add_pyramid(TestWorld& w, int rows) {
    w.add_ground();
    BodyId last;
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < rows - i; ++k)
            last = w.add_box({static_cast<float>(k) + 0.5f * static_cast<float>(i), 0.5f + static_cast<float>(i)}, 0.48f, 0.5f);
    return last;
}

/// Sum of the normal impulses that come from what cannot be pushed: upwards.
double from_the_ground(const ExportedIsland& island, const std::vector<double>& x) {
    double up = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const IslandRow& r = island->rows[i];
        if (r.kind != RowKind::normal || (r.ends[0].body != no_body && r.ends[1].body != no_body)) continue;
        const RowEnd& pushed = r.ends[r.ends[0].body == no_body ? 1 : 0];
        up += x[i] * double(pushed.linear.y);
    }
    return up;
}

TEST(ExportedPiles, TheGroundCarriesAPyramidsWeightByExactAndByStoredImpulses) {
    TestWorld w(roomy, sleepless());
    const BodyId top = add_pyramid(w, 6);
    w.step(400);
    const ExportedIsland island(*w, top, h);
    ASSERT_EQ(island->bodies.size(), 21u);
    double total = 0;
    for (const IslandBody& b : island->bodies) total += weight(*w, b.id) * double(h);

    const std::vector<double> stored(island->impulses.begin(), island->impulses.end());
    EXPECT_NEAR(from_the_ground(island, stored), total, 1e-3 * total);

    const WideSolution exact = solve(island, lcp::Method::newton, 1e-9);
    ASSERT_EQ(exact.result.status, lcp::Status::converged) << lcp::describe(exact.result.status) << " " << exact.result.residuals.natural;
    EXPECT_NEAR(from_the_ground(island, exact.x), total, 1e-3 * total);
}

// The natural residual adds impulses of boxes of 1 kg to speeds, so 1e-3 is a millimetre a second, or a tenth of a box's weight over a substep at most.
TEST(ExportedPiles, WhatASettledPyramidStoredIsNearlyASolution) {
    TestWorld w(roomy, sleepless());
    const BodyId top = add_pyramid(w, 6);
    w.step(400);
    const ExportedIsland island(*w, top, h);
    const double stored = double(lcp::residuals<float>(island->lcp, island->impulses).natural);
    const std::vector<float> zero(island->impulses.size());
    const double cold = double(lcp::residuals<float>(island->lcp, zero).natural);
    EXPECT_NEAR(cold, 10 * double(h), 0.05 * 10 * double(h)) << "without impulses everything falls for a substep";
    EXPECT_LT(stored, 0.02 * cold);
}

TEST(ExportedPiles, FloatSolversTakeTheProblemAsItIs) {
    TestWorld w(roomy, sleepless());
    const BodyId top = add_pyramid(w, 4);
    w.step(200);
    for (const lcp::Method method : {lcp::Method::pgs, lcp::Method::symmetric_pgs, lcp::Method::nncg, lcp::Method::newton}) {
        const ExportedIsland island(*w, top, h);
        std::vector<float> x(island->impulses.size());
        std::vector<std::byte> memory(lcp::workspace_bytes<float>(method, x.size()));
        const lcp::Result<float> result =
            lcp::solve<float>(island->lcp, {.method = method, .max_iterations = 20000, .tolerance = 1e-5f}, x, memory);
        EXPECT_EQ(result.status, lcp::Status::converged) << lcp::describe(result.status) << " " << result.residuals.natural;
        EXPECT_NEAR(from_the_ground(island, {x.begin(), x.end()}), 10 * 0.96 * 10 * double(h), 2e-3 * 10 * 0.96 * 10 * double(h));
    }
}

// -- the engine -------------------------------------------------------------------------------------------------------------------------------------------

// A step of one substep of sweeps without bias, many of them: the engine then solves the problem it exports.
void be_patient(World& w) {
    SolverDef patient;
    patient.schedule = Schedule::classic;
    patient.substeps = 1;
    patient.iterations = 256;
    patient.baumgarte = 0;
    w.set_solver(patient);
}

// The velocities that the exact impulses give the island's bodies, and those they leave the step with.
void expect_the_engine_gets_there(TestWorld& w, const std::vector<BodyId>& islands, double tolerance) {
    be_patient(*w);
    std::vector<std::vector<WideVelocity>> wanted;
    std::vector<std::vector<BodyId>> bodies;
    for (const BodyId id : islands) {
        const ExportedIsland island(*w, id, h);
        const WideSolution s = solve(island, lcp::Method::newton, 1e-9);
        ASSERT_EQ(s.result.status, lcp::Status::converged) << lcp::describe(s.result.status) << " " << s.result.residuals.natural;
        wanted.push_back(velocities_after(*island, s.x));
        bodies.emplace_back();
        for (const IslandBody& b : island->bodies) bodies.back().push_back(b.id);
    }
    w->step(h);
    for (std::size_t k = 0; k < islands.size(); ++k) {
        for (std::size_t i = 0; i < bodies[k].size(); ++i) {
            SCOPED_TRACE("island " + std::to_string(k) + ", body " + std::to_string(i));
            const WideVelocity& v = wanted[k][i];
            EXPECT_NEAR(double(w->linear_velocity(bodies[k][i]).x), v.vx, tolerance);
            EXPECT_NEAR(double(w->linear_velocity(bodies[k][i]).y), v.vy, tolerance);
            EXPECT_NEAR(double(w->angular_velocity(bodies[k][i])), v.w, tolerance);
        }
    }
}

TEST(ExportedEngine, GetsWhereTheExactSolutionIsInAPileThatSlidesAndTips) {
    TestWorld w(roomy, sleepless());
    add_pyramid(w, 3);
    w.step(60);
    w->set_linear_velocity(w->body_at(6), {0.5f, 0});
    w->set_linear_velocity(w->body_at(4), {-0.2f, 0});
    w->set_angular_velocity(w->body_at(1), 0.3f);
    expect_the_engine_gets_there(w, {w->body_at(6)}, 1e-4);
}

TEST(ExportedEngine, GetsWhereTheExactSolutionIsOnAConveyorAndARollingBall) {
    TestWorld w(roomy, sleepless());
    w.add_ground();
    w.add_box({20, 0.5f}, 10, 0.5f, {.tangent_speed = 1}, BodyType::static_body);
    const BodyId crate = w.add_box({20, 1.5f}), ball = w.add_circle({0, 0.5f}, 0.5f, {.rolling_resistance = 0.2f});
    w.step(3);
    w->set_linear_velocity(ball, {2, 0});
    w->set_angular_velocity(ball, -4);
    expect_the_engine_gets_there(w, {crate, ball}, 1e-4);
}

TEST(ExportedEngine, GetsWhereTheExactSolutionIsWithEveryJoint) {
    TestWorld w(roomy, sleepless());
    const Machine m = add_machine(*w, {0, 0});
    // The forces of the two drives, which the engine bounds by their length, within their bounds; the torque of the motor joint at its bound.
    w->set_joint_strength(m[JointType::motor], 1000, 0.1f);
    w->set_target(m[JointType::mouse], {3.42f, 4.01f});
    w->step(1e-4f);  // until the wheel touches the ground
    expect_the_engine_gets_there(w, {m.arm, m.slider, m.cart, m.drone, m.left}, 1e-4);
}

}  // namespace
