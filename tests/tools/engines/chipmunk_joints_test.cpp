// Joints in Chipmunk mean what Islet's definitions say, against closed formulas. (What differs on purpose is in tools/engines/README.md.)
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "chipmunk_fixture.hpp"

namespace islet::test {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// Of small-swing rate omega, let go at `amplitude`: by Gauss's arithmetic-geometric mean, the elliptic integral in disguise.
double exact_period(double omega, double amplitude) {
    double a = 1, b = std::cos(amplitude / 2);
    for (int i = 0; i < 30; ++i) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    return two_pi / (omega * a);
}

// Swings in Chipmunk lose energy, and with it time: at 90 degrees 1.5 % of the period with 60 steps a second, less with shorter ones, as here.
TEST_F(ChipmunkJoints, APendulumSwingsAsTheEllipticIntegralSays) {
    scene.dt = 1.0f / 480;
    for (const bool rod : {false, true}) {
        for (const double amplitude : {0.1, 1.0, std::numbers::pi / 2}) {
            SCOPED_TRACE(testing::Message() << (rod ? "rod, " : "hinge, ") << amplitude);
            scene.bodies.resize(1);
            scene.joints.clear();
            const auto angle = static_cast<float>(amplitude);
            const std::size_t bob = add(dynamic({2 * std::sin(angle), -2 * std::cos(angle)}, make_box(0.1f, 0.1f)));
            scene.bodies[bob].def.angle = angle;
            if (rod)
                join(0, bob, DistanceJointDef{.length = 2});
            else
                join(0, bob, RevoluteJointDef{.base = {.frame_b = {{0, 2}}}});
            load();
            const double own = rod ? 0 : double(engine->body(bob).inertia / engine->body(bob).mass);
            const auto swing = [&] { return std::atan2(double(engine->body(bob).position.x), -double(engine->body(bob).position.y)); };
            double first = 0, last = 0, before = swing();
            for (int i = 1, crossings = 0; crossings <= 6 && i < 10000; ++i) {
                step(1);
                const double now = swing();
                if ((before > 0) != (now > 0)) {
                    last = (i - now / (now - before)) * double(scene.dt);
                    if (crossings++ == 0) first = last;
                }
                before = now;
            }
            EXPECT_NEAR((last - first) / 3 / exact_period(std::sqrt(g * 2 / (4 + own)), amplitude), 1, 3e-3);
            EXPECT_LT(engine->joint_error(0).linear, 0.01f);
        }
    }
}

// It holds the weight, and whatever way it hangs.
TEST_F(ChipmunkJoints, AHangingWeightPullsByItsWeight) {
    const JointBase hooks = {.frame_a = {{1, 0}}};
    const JointDef kinds[] = {
        DistanceJointDef{.base = hooks, .length = 2}, DistanceJointDef{.base = hooks, .limit = {.enable = true, .lower = 0, .upper = 2}},
        DistanceJointDef{.base = hooks, .length = 2, .spring = {.enable = true, .hertz = 4, .damping_ratio = 1}},
        RevoluteJointDef{.base = {.frame_a = {{1, 0}}, .frame_b = {{0, 2}}}}, WeldJointDef{.base = {.frame_a = {{1, -2}}}}};
    for (const JointDef& kind : kinds) {
        SCOPED_TRACE(kind.index());
        scene.bodies.resize(1);
        scene.joints.clear();
        add(dynamic({1, -2}, make_box(0.5f, 1)));  // 2 kg
        join(0, 1, kind);
        load();
        EXPECT_EQ(engine->joint_force(0).y, 0) << "before the first step";
        step(300);
        EXPECT_NEAR(engine->joint_force(0).x, 0, 0.05f);
        EXPECT_NEAR(engine->joint_force(0).y, 20, 0.05f);
        EXPECT_NEAR(engine->joint_torque(0), 0, 0.05f);
    }
}

// A wall carries a 2 kg shelf by its end, 1 m from its middle: 20 N and 20 N m.
TEST_F(ChipmunkJoints, AWeldTellsTheTorqueItHoldsBy) {
    add(dynamic({1, 0}, make_box(1, 0.5f)));
    join(0, 1, WeldJointDef{.base = {.frame_b = {{-1, 0}}}});
    load();
    step(300);
    EXPECT_NEAR(engine->joint_force(0).y, 20, 0.1f);
    EXPECT_NEAR(engine->joint_torque(0), 20, 0.1f);
    EXPECT_LT(engine->joint_error(0).linear, 0.01f);
    EXPECT_LT(engine->joint_error(0).angular, 0.01f);
}

TEST_F(ChipmunkJoints, AMotorReachesItsSpeedWithTheTorqueItHas) {
    add_wheel({}, {.motor = {.enable = true, .speed = 3, .max_force = 2}});
    load();
    const double inertia = double(engine->body(1).inertia);
    step(12);
    EXPECT_NEAR(double(speed()), 2 * 12 * h / inertia, 1e-3);
    EXPECT_NEAR(engine->motor_force(0), 2, 1e-4f);
    EXPECT_NEAR(engine->joint_torque(0), 2, 1e-4f);
    step(200);
    EXPECT_NEAR(speed(), 3, 1e-3f);
    EXPECT_NEAR(engine->motor_force(0), 0, 1e-3f);
    const float before = position();
    step(120);  // 6 rad: nearly a turn, and it counts on past it
    EXPECT_NEAR(position(), before + 6, 1e-3f);
    engine->set_motor(0, {.enable = true, .speed = -1, .max_force = 200});
    step(30);
    EXPECT_NEAR(speed(), -1, 1e-3f);
    engine->set_motor(0, {});
    step(30);
    EXPECT_NEAR(speed(), -1, 1e-3f);
}

// Dry friction takes friction / inertia * t of the speed, then holds; beside a motor both act.
TEST_F(ChipmunkJoints, FrictionStopsAWheelAndHoldsAgainstAMotor) {
    add_wheel({}, {.friction = 1});
    scene.bodies[1].def.angular_velocity = 2;
    load();
    const double inertia = double(engine->body(1).inertia);
    step(30);
    EXPECT_NEAR(double(speed()), 2 - 30 * h / inertia, 1e-3);
    step(200);
    EXPECT_NEAR(speed(), 0, 1e-4f);
    engine->set_motor(0, {.enable = true, .speed = 5, .max_force = 0.9f});
    step(60);
    EXPECT_NEAR(speed(), 0, 1e-2f);
    engine->set_motor(0, {.enable = true, .speed = 5, .max_force = 1.5f});
    step(60);
    EXPECT_NEAR(double(speed()), 0.5 * 60 * h / inertia, 0.02);
}

// A hinge counts from within half a turn of 0, whatever full turns its bodies were made with.
TEST_F(ChipmunkJoints, AnAngleBeginsWithinHalfATurn) {
    add_wheel({}, {.base = {.frame_a = {{}, 0.5f}, .frame_b = {{}, -0.25f}}});
    scene.bodies[1].def.angle = 1 + 4 * pi;
    load();
    EXPECT_NEAR(position(), 1 - 0.75f, 1e-5f);
}

// Gravity turns a rod about its end onto its limits, and a limit that is set later holds too.
TEST_F(ChipmunkJoints, LimitsOfAHingeHold) {
    add(dynamic({1, 0}, make_box(1, 0.1f)));
    join(0, 1, RevoluteJointDef{.base = {.frame_b = {{-1, 0}}}, .limit = {.enable = true, .lower = -0.5f, .upper = 0.25f}});
    load();
    step(300);
    EXPECT_NEAR(position(), -0.5f, 0.02f);
    engine->set_limit(0, {.enable = true, .lower = -1, .upper = 0});
    step(300);
    EXPECT_NEAR(position(), -1, 0.02f);
    engine->set_limit(0, {});
    step(30);
    EXPECT_LT(position(), -1.2f);
}

// Down a slope of 30 degrees as fast as without a slope under it, then held at the end.
TEST_F(ChipmunkJoints, ASliderFollowsItsAxisToItsEnd) {
    const float angle = -pi / 6;
    for (const bool fixed_rotation : {false, true}) {
        scene.bodies.resize(1);
        scene.joints.clear();
        const std::size_t box = add(dynamic({0, 1}, make_box(0.5f, 0.5f)));
        scene.bodies[box].def.angle = 0.2f;
        scene.bodies[box].def.fixed_rotation = fixed_rotation;
        join(0, box,
             PrismaticJointDef{.base = {.frame_a = {{0, 1}, angle}, .frame_b = {{}, angle - 0.2f}},
                               .limit = {.enable = true, .lower = -1, .upper = 3}});
        load();
        step(30);
        EXPECT_NEAR(double(speed()), 0.5 * g * 30 * h, 0.02);
        EXPECT_NEAR(double(position()), 0.5 * 0.5 * g * 0.25, 0.06);
        step(300);
        EXPECT_NEAR(position(), 3, 0.01f);
        EXPECT_LT(engine->joint_error(0).linear, 0.01f);
        EXPECT_LT(engine->joint_error(0).angular, 0.01f);
        engine->set_limit(0, {.enable = true, .lower = 5, .upper = 5});
        step(300);
        EXPECT_NEAR(position(), 5, 0.01f);
    }
}

// Two hinges: angle 1 + ratio * angle 2 stays. Of 2 N m on wheel 1 the gear leaves what I1 + I2 / ratio^2 takes.
TEST_F(ChipmunkJoints, AGearKeepsItsRatio) {
    const std::size_t first = add_wheel({-2, 0}), second = add_wheel({2, 0});
    const std::size_t gear = join(first, second, GearJointDef{.ratio = 2});
    scene.bodies[1].def.angle = 0.3f;
    scene.before_step = [](Engine& e, int) { e.apply_torque(1, 2); };
    EXPECT_EQ(lacks(), "");
    load();
    step(60);
    const double inertia = double(engine->body(1).inertia);
    EXPECT_NEAR(double(engine->joint_speed(first)), 2 * 60 * h / (inertia * 1.25), 0.01);
    EXPECT_NEAR(engine->joint_speed(second), -engine->joint_speed(first) / 2, 1e-3f);
    EXPECT_NEAR(engine->joint_position(first) - 0.3f, -2 * engine->joint_position(second), 1e-2f);
    EXPECT_NEAR(engine->joint_torque(gear), -2 * 0.2f, 0.01f);  // on wheel 1, which keeps 0.8 of the torque
    engine->destroy_joint(second);
    EXPECT_FALSE(engine->joint_exists(gear));
    EXPECT_TRUE(engine->joint_exists(first));
    EXPECT_EQ(engine->counts().joints, 1u);
}

/// Mean time from one crossing of 0 upwards to the next.
template <class Coordinate, class Step>
double measured_period(Coordinate coordinate, Step step) {
    double first = 0, last = 0, before = coordinate();
    int crossings = -1;
    for (int i = 1; i <= 240; ++i) {
        step();
        const double now = coordinate();
        if (before < 0 && now >= 0) {
            last = (i - now / (now - before)) * h;
            if (++crossings == 0) first = last;
        }
        before = now;
    }
    return (last - first) / crossings;
}

// At the frequency asked for, with whatever masses: symplectic Euler's is higher by (omega h)^2 / 24, 0.2 % at 2 Hz.
TEST_F(ChipmunkJoints, SpringsSwingAtTheirFrequency) {
    scene.world.gravity = {0, 0};
    constexpr JointSpring two_hertz = {.enable = true, .hertz = 2, .damping_ratio = 0};
    add(dynamic({}, make_box(1, 0.5f), {.density = 3}));  // 6 kg, and 1 kg
    add(dynamic({2, 0.3f}, make_box(0.5f, 0.5f)));
    const JointSpring about_a_tenth = {.enable = true, .hertz = 2, .damping_ratio = 0, .target = 0.1f};
    const JointBase level = {.frame_a = {{0, 0.3f}}, .frame_b = {{-2, 0}}};
    const struct {
        JointDef def;
        double rest;
    } kinds[] = {{DistanceJointDef{.length = 1.9f, .spring = two_hertz}, 1.9},
                 {RevoluteJointDef{.base = level, .spring = about_a_tenth}, 0.1},
                 {WheelJointDef{.base = level, .spring = about_a_tenth}, 0.1}};
    for (const auto& kind : kinds) {
        SCOPED_TRACE(kind.def.index());
        scene.joints.clear();
        join(1, 2, kind.def);
        // The two ends of a spring move on their line; a hinge off its bodies' middles would change what swings.
        if (std::holds_alternative<RevoluteJointDef>(kind.def)) std::get<RevoluteJointDef>(scene.joints[0].def).base = {};
        scene.bodies[2].def.position = std::holds_alternative<RevoluteJointDef>(kind.def) ? Vec2{} : Vec2{2, 0.3f};
        if (std::holds_alternative<DistanceJointDef>(kind.def)) scene.bodies[2].def.position = {2, 0};
        load();
        const double period = measured_period([&] { return double(position()) - kind.rest; }, [&] { step(1); });
        EXPECT_NEAR(period, 0.5, 0.02 * 0.5);
    }
}

TEST_F(ChipmunkJoints, AWheelRollsOnAStrutThatGivesWay) {
    scene.bodies[0] = ground();
    add(dynamic({0, 2}, make_box(0.5f, 0.5f)));
    add(dynamic({0, 0.5f}, Circle{}, {.friction = 1}));
    scene.bodies[1].def.fixed_rotation = true;
    join(1, 2,
         WheelJointDef{.base = {.frame_a = {{0, -1.5f}, pi / 2}},
                       .spring = {.enable = true, .hertz = 3, .damping_ratio = 0.7f},
                       .motor = {.enable = true, .speed = -4, .max_force = 20}});
    load();
    const double chassis = double(engine->body(1).mass), wheel = double(engine->body(2).mass);
    step(240);
    EXPECT_NEAR(double(engine->body(1).linear_velocity.x), 4 * 0.5, 0.02);
    EXPECT_NEAR(engine->body(2).angular_velocity, -4, 0.02f);
    // The strut is pressed together by the weight on it over its stiffness.
    const double omega = two_pi * 3, stiffness = chassis * wheel / (chassis + wheel) * omega * omega;
    EXPECT_NEAR(double(position()), chassis * g / stiffness, 0.1 * chassis * g / stiffness);
    EXPECT_NEAR(double(engine->joint_force(0).y), -chassis * g, 0.02 * chassis * g);
}

TEST_F(ChipmunkJoints, AMouseLeadsABodyAsFarAsItsForceGoes) {
    add(dynamic({}, make_box(0.5f, 0.5f)));
    add(dynamic({5, 0}, make_box(0.5f, 0.5f)));
    scene.bodies[1].def.angular_damping = 3;  // or it swings for long
    join(0, 1, MouseJointDef{.target = {0, 0.5f}, .max_force = 100});
    join(0, 2, MouseJointDef{.target = {5, 0.5f}, .max_force = 5});
    load();
    for (std::size_t i : {0u, 1u}) engine->set_target(i, {5.0f * static_cast<float>(i) + 1, 2});
    step(600);
    EXPECT_NEAR(engine->body(1).center.x, 1, 0.01f);
    EXPECT_NEAR(engine->body(1).center.y, 1.5f, 0.01f);  // it hangs by the middle of its upper side
    EXPECT_NEAR(engine->joint_force(0).y, 10, 0.1f);
    EXPECT_LT(engine->body(2).center.y, -10);
}

}  // namespace
}  // namespace islet::test
