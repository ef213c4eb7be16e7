// Machines of joints whose motion has a closed formula: Atwood's machine, gears, motors against loads, sliders on slopes, breaking strength.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "measure.hpp"
#include "support/joint_world.hpp"

namespace islet::test {
namespace {

JointBase between(BodyId a, BodyId b) {
    JointBase base;
    base.body_a = a;
    base.body_b = b;
    return base;
}

TEST(Pulley, IsAtwoodsMachine) {
    // Masses m1 and m2 on a rope with ratio r: a1 = g (m1 - m2 / r) / (m1 + m2 / r^2) down on side 1, and side 2 goes up 1 / r as fast.
    for (const float ratio : {1.0f, 2.0f, 0.5f}) {
        SCOPED_TRACE(ratio);
        TestWorld world(room_for_joints, sleepless());
        const BodyId beam = world->create_body({});
        const BodyId one = world.add_circle({-2, 0}, 0.5f, dense(3)), two = world.add_circle({2, 0}, 0.5f, dense(1));
        const JointId j = world->create_joint(PulleyJointDef{.base = between(one, two), .ground_a = {-2, 20}, .ground_b = {2, 20}, .ratio = ratio});
        ASSERT_TRUE(j);
        (void)beam;
        const double m1 = double(world->mass(one)), m2 = double(world->mass(two)), r = double(ratio);
        const double a = g * (m1 - m2 / r) / (m1 + m2 / (r * r));
        world.step(60);
        EXPECT_NEAR(double(world->linear_velocity(one).y), -a, 2e-3 * g);
        EXPECT_NEAR(double(world->linear_velocity(two).y), a / r, 2e-3 * g);
        // Position lags by half a substep's speed: a t h / 2.
        EXPECT_NEAR(double(world->position(one).y), -a / 2, 0.005 * g);
        // The rope's tension is m1 (g - a); B feels ratio times as much.
        EXPECT_NEAR(double(world->joint_force(j).y) / (r * m1 * (g - a)), 1, 0.002);
        EXPECT_LT(double(world->joint_error(j).linear), 1e-3);
    }
}

TEST(Gear, TurnsItsWheelsInTheRatioOfTheirRadii) {
    // Wheels of 1 m and 0.5 m that turn against each other: angle 1 * 1 + angle 2 * 0.5 = 0.
    TestWorld world(room_for_joints, weightless());
    const BodyId frame = world->create_body({});
    const BodyId big = world.add_circle({0, 0}, 1), small = world.add_circle({1.5f, 0}, 0.5f);
    const JointId hinge1 = world->create_joint(RevoluteJointDef{.base = between(frame, big), .motor = {.enable = true, .speed = 2, .max_force = 1000}});
    JointBase second = between(frame, small);
    second.frame_a.position = {1.5f, 0};
    const JointId hinge2 = world->create_joint(RevoluteJointDef{.base = second});
    const JointId gear = world->create_joint(GearJointDef{.joint1 = hinge1, .joint2 = hinge2, .ratio = 0.5f});
    ASSERT_TRUE(gear);
    world.step(600);  // 20 rad: past three full turns
    EXPECT_NEAR(double(world->joint_position(hinge1)), 20, 0.01);
    EXPECT_NEAR(double(world->joint_position(hinge2)), -40, 0.02);
    EXPECT_NEAR(double(world->joint_speed(hinge2)), -4, 0.01);
    EXPECT_LT(double(world->joint_error(gear).angular), 2e-3);
}

TEST(Gear, SharesTorqueAsALever) {
    // A torque on wheel 1 accelerates both: with w2 = -w1 / ratio, w1' = torque / (i1 + i2 / ratio^2).
    TestWorld world(room_for_joints, weightless());
    const BodyId frame = world->create_body({});
    const BodyId one = world.add_circle({0, 0}, 1), two = world.add_circle({5, 0}, 0.7f);
    const JointId hinge1 = world->create_joint(RevoluteJointDef{.base = between(frame, one)});
    JointBase base = between(frame, two);
    base.frame_a.position = {5, 0};
    const JointId hinge2 = world->create_joint(RevoluteJointDef{.base = base});
    const float ratio = -3;
    world->create_joint(GearJointDef{.joint1 = hinge1, .joint2 = hinge2, .ratio = ratio});
    const double i1 = double(world->rotational_inertia(one)), i2 = double(world->rotational_inertia(two)), r = double(ratio);
    for (int i = 0; i < 60; ++i) {
        world->apply_torque(one, 5);
        world.step();
    }
    const double expected = 5 / (i1 + i2 / (r * r));
    EXPECT_NEAR(double(world->angular_velocity(one)) / expected, 1, 1e-3);
    EXPECT_NEAR(double(world->angular_velocity(two)) / (-expected / r), 1, 1e-3);
}

TEST(Gear, RackAndPinionTurnsWayIntoAngle) {
    // A rack that slides by s turns a pinion of radius 0.25 m by s / 0.25: s - 0.25 angle = 0.
    TestWorld world(room_for_joints, weightless());
    const BodyId frame = world->create_body({});
    const BodyId rack = world.add_box({0, 0}, 2, 0.1f), pinion = world.add_circle({0, 5}, 0.25f);
    const JointId slide = world->create_joint(PrismaticJointDef{.base = between(frame, rack), .motor = {.enable = true, .speed = 0.5f, .max_force = 1e4f}});
    JointBase base = between(frame, pinion);
    base.frame_a.position = {0, 5};
    const JointId hinge = world->create_joint(RevoluteJointDef{.base = base});
    world->create_joint(GearJointDef{.joint1 = slide, .joint2 = hinge, .ratio = -0.25f});
    world.step(240);
    EXPECT_NEAR(double(world->joint_position(slide)), 2, 0.01);
    EXPECT_NEAR(double(world->joint_position(hinge)), 8, 0.04);
}

TEST(Motor, HoldsALoadWithTheTorqueOfItsWeightAndNoMore) {
    // A rod of mass m held level by the motor at its end: the torque is m g l. With less than that allowed it falls.
    for (const double share : {1.05, 0.95}) {
        SCOPED_TRACE(share);
        TestWorld world(room_for_joints, sleepless());
        const BodyId wall = world->create_body({});
        const BodyId rod = world.add(make_box(1, 0.1f), dynamic_at({1, 0}));
        const double needed = double(world->mass(rod)) * g * 1.0;
        JointBase base = between(wall, rod);
        base.frame_b.position = {-1, 0};
        const JointId j =
            world->create_joint(RevoluteJointDef{.base = base, .motor = {.enable = true, .speed = 0, .max_force = static_cast<float>(share * needed)}});
        world.step(120);
        if (share > 1) {
            EXPECT_NEAR(double(world->joint_position(j)), 0, 2e-3);  // it falls for a substep before the motor first pushes
            EXPECT_NEAR(double(world->motor_force(j)) / needed, 1, 1e-3);
            EXPECT_NEAR(double(world->joint_force(j).y) / (double(world->mass(rod)) * g), 1, 1e-3);
        } else {
            EXPECT_LT(double(world->joint_position(j)), -0.05);
        }
    }
}

TEST(Motor, ReachesItsSpeedInTheTimeItsTorqueNeeds) {
    TestWorld world(room_for_joints, weightless());
    const BodyId wall = world->create_body({});
    const BodyId wheel = world.add_circle({0, 0}, 1);
    const double inertia = double(world->rotational_inertia(wheel));
    const JointId j = world->create_joint(
        RevoluteJointDef{.base = between(wall, wheel), .motor = {.enable = true, .speed = 10, .max_force = static_cast<float>(5 * inertia)}});
    world.step(60);  // 5 rad/s^2 for a second
    EXPECT_NEAR(double(world->joint_speed(j)), 5, 0.01);
    EXPECT_NEAR(double(world->motor_force(j)) / (5 * inertia), 1, 1e-4);
    world.step(120);
    EXPECT_NEAR(double(world->joint_speed(j)), 10, 1e-4);
    EXPECT_NEAR(double(world->motor_force(j)), 0, 1e-3);
}

TEST(JointFriction, HoldsBelowItsBoundAndSlowsAboveIt) {
    TestWorld world(room_for_joints, weightless());
    const BodyId wall = world->create_body({});
    const BodyId wheel = world.add_circle({0, 0}, 1);
    const double inertia = double(world->rotational_inertia(wheel));
    const JointId j = world->create_joint(RevoluteJointDef{.base = between(wall, wheel), .friction = static_cast<float>(2 * inertia)});
    for (int i = 0; i < 60; ++i) {
        world->apply_torque(wheel, static_cast<float>(1.9 * inertia));
        world.step();
    }
    EXPECT_NEAR(double(world->joint_speed(j)), 0, 1e-5);
    for (int i = 0; i < 60; ++i) {
        world->apply_torque(wheel, static_cast<float>(5 * inertia));
        world.step();
    }
    EXPECT_NEAR(double(world->joint_speed(j)), 3, 0.01);  // 5 - 2 rad/s^2
}

TEST(Slider, OnASlopeSlidesWithTheSlopesShareOfGravity) {
    // Free: g sin a. With friction force f: g sin a - f / m. At a limit it stops.
    for (const bool rough : {false, true}) {
        SCOPED_TRACE(rough);
        TestWorld world(room_for_joints, sleepless());
        const BodyId wall = world->create_body({});
        const float slope = -0.5f;
        const BodyId box = world.add(make_box(0.5f, 0.5f), dynamic_at({0, 0}, slope));
        const double m = double(world->mass(box)), along = g * std::sin(0.5), friction = rough ? 0.3 * m * g : 0;
        JointBase base = between(wall, box);
        base.frame_a.angle = slope;
        const JointId j =
            world->create_joint(PrismaticJointDef{.base = base, .limit = {.enable = true, .lower = -1, .upper = 3}, .friction = static_cast<float>(friction)});
        world.step(48);  // 0.8 s
        const double a = along - friction / m;
        EXPECT_NEAR(double(world->joint_speed(j)) / (0.8 * a), 1, 2e-3);
        EXPECT_NEAR(double(world->joint_position(j)) / (0.5 * 0.64 * a), 1, 0.01);
        EXPECT_LT(double(world->joint_error(j).linear), 1e-4);
        EXPECT_LT(double(world->joint_error(j).angular), 1e-4);
        world.step(300);
        EXPECT_NEAR(double(world->joint_position(j)), 3, 2e-3);
        EXPECT_NEAR(double(world->joint_speed(j)), 0, 1e-3);
    }
}

TEST(Angle, CountsOnPastFullTurns) {
    TestWorld world(room_for_joints, weightless());
    const BodyId wall = world->create_body({});
    const BodyId wheel = world.add_circle({0, 0}, 1);
    const JointId j = world->create_joint(RevoluteJointDef{.base = between(wall, wheel), .motor = {.enable = true, .speed = 30, .max_force = 1e6f}});
    world.step(60);
    EXPECT_NEAR(double(world->joint_position(j)), 30, 0.2);
    world.step(540);
    EXPECT_NEAR(double(world->joint_position(j)), 300, 0.2);  // 48 turns
    world->set_motor(j, {.enable = true, .speed = -30, .max_force = 1e6f});
    world.step(600);
    EXPECT_NEAR(double(world->joint_position(j)), 0, 0.5);
}

TEST(Angle, LimitsHoldBeyondAFullTurn) {
    TestWorld world(room_for_joints, weightless());
    const BodyId wall = world->create_body({});
    const BodyId wheel = world.add_circle({0, 0}, 1);
    const JointId j = world->create_joint(RevoluteJointDef{
        .base = between(wall, wheel), .limit = {.enable = true, .lower = -1, .upper = 15}, .motor = {.enable = true, .speed = 10, .max_force = 10}});
    world.step(300);
    EXPECT_NEAR(double(world->joint_position(j)), 15, 0.01);
}

TEST(MotorJoint, IsTheFrictionOfABodySeenFromAbove) {
    // Without gravity a body joined to the ground with velocity 0 and force f slows down by f / m.
    TestWorld world(room_for_joints, weightless());
    const BodyId ground = world->create_body({});
    BodyDef def = dynamic_at({0, 0});
    def.linear_velocity = {6, 8};
    const BodyId puck = world.add(Circle{{}, 0.5f}, def);
    const double m = double(world->mass(puck));
    world->create_joint(MotorJointDef{.base = between(ground, puck), .max_force = static_cast<float>(4 * m)});
    world.step(60);
    EXPECT_NEAR(double(length(world->linear_velocity(puck))), 6, 0.01);
    EXPECT_NEAR(double(world->linear_velocity(puck).x) / double(world->linear_velocity(puck).y), 0.75, 1e-3);
    world.step(120);
    EXPECT_NEAR(double(length(world->linear_velocity(puck))), 0, 1e-4);
}

TEST(Weld, CarriesABeamsWeightAndItsTorque) {
    // A cantilever: force m g, torque m g l about the weld.
    TestWorld world(room_for_joints, sleepless());
    const BodyId wall = world->create_body({});
    const BodyId beam = world.add(make_box(2, 0.1f), dynamic_at({2, 0}));
    JointBase base = between(wall, beam);
    base.frame_b.position = {-2, 0};
    const JointId j = world->create_joint(WeldJointDef{.base = base});
    world.step(120);
    const double weight = double(world->mass(beam)) * g;
    EXPECT_NEAR(double(world->joint_force(j).y) / weight, 1, 1e-3);
    EXPECT_NEAR(double(world->joint_torque(j)) / (2 * weight), 1, 1e-3);
    EXPECT_LT(double(world->joint_error(j).linear), 5e-4);
    EXPECT_LT(double(world->joint_error(j).angular), 1e-3);
}

TEST(Breaking, HappensAtTheStatedForceAndIsReportedOnce) {
    // A hanging box pulls with its weight: it holds at 1.1 times that, and breaks at 0.9 times.
    for (const double share : {1.1, 0.9}) {
        SCOPED_TRACE(share);
        TestWorld world(room_for_joints, sleepless());
        const BodyId wall = world->create_body({});
        const BodyId box = world.add_box({0, -1});
        const double weight = double(world->mass(box)) * g;
        JointBase base = between(wall, box);
        base.frame_b.position = {0, 1};
        base.break_force = static_cast<float>(share * weight);
        base.user_data = 77;
        const JointId j = world->create_joint(RevoluteJointDef{.base = base});
        int reports = 0;
        for (int i = 0; i < 60; ++i) {
            world.step();
            for (const JointBreakEvent& e : world->broken_joints()) {
                ++reports;
                EXPECT_EQ(e.joint, j);
                EXPECT_EQ(e.body_b, box);
                EXPECT_EQ(e.user_data, 77u);
                EXPECT_GT(double(length(e.force)), share * weight);
            }
        }
        EXPECT_EQ(reports, share < 1 ? 1 : 0);
        EXPECT_EQ(world->is_valid(j), share > 1);
        EXPECT_EQ(world->validate(), nullptr);
    }
}

// A body of 1 kg at rest gets a blow J where a joint holds it. The joint must give J back before the body moves on, within a substep h, so it bears J / h
// and the weight then. A step later nothing of that is left.
TEST(Breaking, HappensInABlow) {
    const double blow = 5, h = 1.0 / 240, weight = g, most = blow / h + weight;
    for (const int kind : {0, 1, 2, 3})
        for (const bool exact : {false, true})
            for (const double share : {0.1, 0.5, 0.9, 1.1}) {
                WorldDef def = sleepless();
                def.solver.joint_trees = exact ? JointTrees::all : JointTrees::off;
                TestWorld world(room_for_joints, def);
                const BodyId wall = world->create_body({}), ball = world.add_circle({0, 0}, 0.2f, dense(1 / (0.04f * pi)));
                JointBase base = between(wall, ball);
                base.break_force = static_cast<float>(share * most);
                if (kind == 0) world->create_joint(RevoluteJointDef{.base = base});
                if (kind == 1) world->create_joint(WeldJointDef{.base = base});
                if (kind == 2) world->create_joint(PrismaticJointDef{.base = base});  // along x
                if (kind == 3) {
                    base.frame_a.position = {0, 2};
                    world->create_joint(DistanceJointDef{.base = base, .length = 2});
                }
                world.step(30);
                world->apply_linear_impulse_to_center(ball, {0, static_cast<float>(-blow)});
                world.step();
                const std::string what = "kind " + std::to_string(kind) + (exact ? ", exact" : ", swept") + ", share " + std::to_string(share);
                const auto broken = world->broken_joints();
                ASSERT_EQ(broken.size(), share < 1 ? 1u : 0u) << what;
                if (share < 1) { EXPECT_NEAR(double(length(broken[0].force)) / most, 1, 0.01) << what; }
                EXPECT_EQ(world->validate(), nullptr);
            }
}

// F / (m (2 pi f)^2), in each direction that the joint locks: what a spring of that frequency would give. SolverDef::joint_hertz says so.
TEST(RigidJoints, GiveWayUnderASteadyForceAsTheFormulaSays) {
    for (const float hertz : {10.0f, 30.0f, 60.0f}) {
        for (const float force : {0.0f, 500.0f}) {  // N, beside the weight
            for (const int kind : {0, 1, 2}) {
                WorldDef def = sleepless();
                def.solver.joint_hertz = hertz;
                def.solver.joint_trees = JointTrees::off;  // which give way by nothing
                TestWorld world(room_for_joints, def);
                const BodyId ground = world->create_body({}), body = world.add_circle({0, 0}, 0.5f, dense(3));
                const JointBase base = between(ground, body);
                const JointId j = kind == 0   ? world->create_joint(RevoluteJointDef{.base = base})
                                  : kind == 1 ? world->create_joint(WeldJointDef{.base = base})
                                              : world->create_joint(PrismaticJointDef{.base = base});
                for (int i = 0; i < 600; ++i) {
                    world->apply_force_to_center(body, {0, -force});
                    world.step();
                }
                const double m = double(world->mass(body)), rate = 2 * std::numbers::pi * double(hertz);
                const double way = (m * g + double(force)) / (m * rate * rate);
                EXPECT_NEAR(double(world->joint_error(j).linear) / way, 1, 0.01) << hertz << " Hz, " << force << " N, kind " << kind;
            }
        }
    }
}

TEST(FreeJoints, KeepMomentum) {
    // Whatever joints do between bodies, the sum of momenta and of spins stays: every impulse has its opposite, and point joints act at one point.
    TestWorld world(room_for_joints, weightless());
    ShapeDef ghost;
    ghost.filter.mask = 0;
    std::vector<BodyId> b;
    for (int i = 0; i < 6; ++i) {
        BodyDef def = dynamic_at({static_cast<float>(i), 0.1f * static_cast<float>(i * i)});
        def.linear_velocity = {static_cast<float>(i % 3), static_cast<float>(1 - i % 2)};
        def.angular_velocity = static_cast<float>(i - 2);
        b.push_back(world.add(make_box(0.4f, 0.2f), def, ghost));
    }
    JointBase base = between(b[0], b[1]);
    base.frame_a.position = {0.5f, 0};
    base.frame_b.position = {-0.5f, -0.1f};
    world->create_joint(RevoluteJointDef{.base = base, .motor = {.enable = true, .speed = 3, .max_force = 2}});
    world->create_joint(DistanceJointDef{.base = between(b[1], b[2]), .length = 1});
    base = between(b[2], b[3]);
    base.frame_a.position = {0.5f, 0.25f};
    base.frame_b.position = {-0.5f, -0.25f};
    world->create_joint(WeldJointDef{.base = base});
    base = between(b[3], b[4]);
    base.frame_a.position = {0, 0.7f};
    world->create_joint(PrismaticJointDef{.base = base, .spring = {.enable = true, .hertz = 2, .damping_ratio = 0.1f, .target = 1}});
    base = between(b[4], b[5]);
    base.frame_a.position = {0, 0.9f};
    world->create_joint(WheelJointDef{.base = base, .motor = {.enable = true, .speed = -4, .max_force = 1}});
    const Invariants before = invariants_of(world);
    world.step(300);
    const Invariants after = invariants_of(world);
    EXPECT_NEAR(after.px, before.px, 1e-4);
    EXPECT_NEAR(after.py, before.py, 1e-4);
    EXPECT_NEAR(after.spin, before.spin, 0.01);  // a joint's gap times its impulse
    EXPECT_EQ(world->validate(), nullptr);
}

}  // namespace
}  // namespace islet::test
