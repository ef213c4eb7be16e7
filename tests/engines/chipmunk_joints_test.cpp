// Joints in Chipmunk mean what Islet's definitions say, against closed formulas. (What differs on purpose is in tools/engines/README.md.)
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engines/chipmunk_fixture.hpp"

namespace islet::test {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// Body 0 of every scene here is a static one at the origin, without shapes.
class ChipmunkJoints : public Chipmunk {
protected:
    void SetUp() override {
        Chipmunk::SetUp();
        scene.world.enable_sleep = false;
        scene.bodies.emplace_back();
    }
    std::size_t join(std::size_t a, std::size_t b, JointDef def) {
        scene.joints.push_back({a, b, std::move(def)});
        return scene.joints.size() - 1;
    }
    /// A disc of 1 m at `place` on a hinge in its middle.
    std::size_t add_wheel(Vec2 place, RevoluteJointDef hinge = {}) {
        const std::size_t wheel = add(dynamic(place, Circle{{}, 1}));
        hinge.base.frame_a.position = place;
        return join(0, wheel, hinge);
    }
    float position() const { return engine->joint_position(0); }
    float speed() const { return engine->joint_speed(0); }
};

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

// A step of 1/60 s follows the motion with an error of (omega h)^2 / 24, here 1e-4. Correcting a joint by its speed adds a little.
TEST_F(ChipmunkJoints, APendulumSwingsAsTheEllipticIntegralSays) {
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
            for (int i = 1, crossings = 0; crossings <= 6 && i < 2000; ++i) {
                step(1);
                const double now = swing();
                if ((before > 0) != (now > 0)) {
                    last = (i - now / (now - before)) * h;
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
    const JointDef kinds[] = {DistanceJointDef{.base = hooks, .length = 2},
                              DistanceJointDef{.base = hooks, .limit = {.enable = true, .lower = 0, .upper = 2}},
                              DistanceJointDef{.base = hooks, .length = 2, .spring = {.enable = true, .hertz = 4, .damping_ratio = 1}},
                              RevoluteJointDef{.base = {.frame_a = {{1, 0}}, .frame_b = {{0, 2}}}},
                              WeldJointDef{.base = {.frame_a = {{1, -2}}}}};
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
    const double inertia = engine->body(1).inertia;
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
    const double inertia = engine->body(1).inertia;
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
    const double inertia = engine->body(1).inertia;
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
    const double chassis = engine->body(1).mass, wheel = engine->body(2).mass;
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
    join(0, 1, MouseJointDef{.target = {0, 0.5f}, .max_force = 100});
    join(0, 2, MouseJointDef{.target = {5, 0.5f}, .max_force = 5});
    load();
    for (std::size_t i : {0u, 1u}) engine->set_target(i, {5.0f * static_cast<float>(i) + 1, 2});
    step(300);
    EXPECT_NEAR(engine->body(1).center.x, 1, 0.01f);
    EXPECT_NEAR(engine->body(1).center.y, 1.5f, 0.01f);  // it hangs by the middle of its upper side
    EXPECT_NEAR(engine->joint_force(0).y, 10, 0.1f);
    EXPECT_LT(engine->body(2).center.y, -10);
}

TEST_F(ChipmunkJoints, OverloadedJointsBreak) {
    for (const float x : {0.0f, 2.0f, 4.0f, 6.0f}) add(dynamic({x, 0}, make_box(0.5f, 0.5f)));  // 1 kg each
    const auto weld = [this](std::size_t body, float force, float torque) {
        JointBase base = {.break_force = force, .break_torque = torque};
        base.frame_a.position = scene.bodies[body].def.position - Vec2{0.5f, 0};
        base.frame_b.position = {-0.5f, 0};
        join(0, body, WeldJointDef{.base = base});
    };
    weld(1, 11, 0);  // it needs 10 N and 5 N m
    weld(2, 9, 0);
    weld(3, 0, 6);
    weld(4, 0, 4);
    load();
    step(60);
    EXPECT_TRUE(engine->joint_exists(0));
    EXPECT_FALSE(engine->joint_exists(1));
    EXPECT_TRUE(engine->joint_exists(2));
    EXPECT_FALSE(engine->joint_exists(3));
    EXPECT_LT(engine->body(2).position.y, -1);
    EXPECT_EQ(engine->counts().joints, 2u);
}

TEST_F(ChipmunkJoints, BodiesOfAJointCollideOnlyIfTold) {
    scene.world.gravity = {0, 0};
    for (const bool collide : {false, true}) {
        scene.bodies.resize(1);
        scene.joints.clear();
        add(dynamic({0, 0}, make_box(0.5f, 0.5f)));
        add(dynamic({0.8f, 0}, make_box(0.5f, 0.5f)));
        join(1, 2, DistanceJointDef{.base = {.collide_connected = collide}, .limit = {.enable = true, .lower = 0, .upper = 5}});
        load();
        step(60);
        EXPECT_EQ(engine->counts().contacts, collide ? 1u : 0u);
        EXPECT_NEAR(position(), collide ? 1 : 0.8f, 0.02f);
    }
}

// A chain of three on the ground body; the middle one goes, then the ground itself.
TEST_F(ChipmunkJoints, ABodyTakesItsJointsAndTheirGearsWithIt) {
    const std::size_t left = add_wheel({-2, 0}), right = add_wheel({2, 0});
    const std::size_t gear = join(left, right, GearJointDef{});
    const std::size_t hung = join(1, add(dynamic({-2, -2}, Circle{})), DistanceJointDef{.base = {}, .length = 2});
    const std::size_t loose = join(2, add(dynamic({2, -2}, Circle{})), DistanceJointDef{.spring = {.enable = true}});
    const std::size_t held = join(0, 3, MouseJointDef{.target = {-2, -2}, .max_force = 1});
    load();
    EXPECT_EQ(engine->counts().joints, 6u);
    step(10);
    engine->destroy_body(1);
    EXPECT_FALSE(engine->joint_exists(left));
    EXPECT_FALSE(engine->joint_exists(gear));
    EXPECT_FALSE(engine->joint_exists(hung));
    for (const std::size_t joint : {right, loose, held}) EXPECT_TRUE(engine->joint_exists(joint));
    step(10);
    engine->destroy_body(0);
    EXPECT_FALSE(engine->joint_exists(right));
    engine->destroy_body(2);
    EXPECT_FALSE(engine->joint_exists(loose));
    EXPECT_EQ(engine->counts().joints, 1u);
    const std::size_t again = engine->create_joint({3, 4, DistanceJointDef{.length = 4}});
    step(10);
    EXPECT_EQ(again, 6u);
    EXPECT_TRUE(engine->joint_exists(again));
    EXPECT_FALSE(engine->joint_exists(again + 1));
}

// What sleeps together with its joints wakes, changes and goes without a trace.
TEST_F(ChipmunkJoints, SleepersKeepTheirJoints) {
    scene.world.enable_sleep = true;
    add(dynamic({0, -2}, make_box(0.5f, 0.5f)));
    add(dynamic({0, -4}, make_box(0.5f, 0.5f)));
    const std::size_t upper = join(0, 1, DistanceJointDef{.length = 2}), lower = join(1, 2, DistanceJointDef{.length = 2});
    load();
    step(180);
    EXPECT_FALSE(engine->body(1).awake);
    EXPECT_TRUE(engine->joint_exists(upper));
    EXPECT_NEAR(engine->joint_force(lower).y, 10, 0.05f);
    engine->destroy_joint(lower);
    step(30);
    EXPECT_LT(engine->body(2).position.y, -4.5f);
    EXPECT_NEAR(engine->body(1).position.y, -2, 0.01f);
    step(180);
    load();  // the engine lets go of the sleeper and its joint
    EXPECT_EQ(engine->counts().joints, 2u);
}

TEST_F(ChipmunkJoints, WhatIsMissingIsSaid) {
    add(dynamic({}, Circle{}));
    add(dynamic({2, 0}, Circle{}));
    const JointSpring soft = {.enable = true, .hertz = 2, .damping_ratio = 1}, stiff = {.enable = true, .hertz = 20, .damping_ratio = 1};
    const JointMotor drive = {.enable = true, .speed = 1, .max_force = 1};
    const struct {
        JointDef def;
        const char* what;
    } cases[] = {{PulleyJointDef{}, "pulleys"},
                 {MotorJointDef{}, "motor joints"},
                 {WeldJointDef{.angular_hertz = 2}, "welds that give way"},
                 {DistanceJointDef{.motor = drive}, "motors on rods"},
                 {PrismaticJointDef{.spring = soft}, "springs on sliders"},
                 {PrismaticJointDef{.motor = drive}, "motors on sliders"},
                 {PrismaticJointDef{.friction = 1}, "friction on sliders"},
                 {RevoluteJointDef{.spring = stiff}, "springs that swing so fast with steps so long"},
                 {RevoluteJointDef{.spring = soft, .motor = drive, .friction = 1}, nullptr},
                 {WheelJointDef{.spring = soft, .motor = drive, .friction = 1}, nullptr}};
    for (const auto& [def, what] : cases) {
        scene.joints.clear();
        join(1, 2, def);
        EXPECT_EQ(lacks(), what != nullptr ? std::string("Chipmunk 7 has no ") + what : "");
    }
    scene.joints.clear();
    join(join(0, 1, RevoluteJointDef{}), join(1, 2, RevoluteJointDef{}), GearJointDef{});
    EXPECT_EQ(lacks(), "Chipmunk 7 has no gears but between hinges on static bodies");
}

// Ragdolls fall by columns, and are destroyed and made anew. All 40 columns take 313 steps: here scripts run without most of them.
TEST_F(ChipmunkJoints, RainMakesAndDestroysRagdolls) {
    scene = find_scene("rain")->make();
    ASSERT_EQ(lacks(), "");
    load();
    IsletEngine islet;
    islet.load(scene);
    EXPECT_EQ(engine->counts().joints, islet.counts().joints);
    const std::size_t dolls = engine->counts().joints;
    step(50);
    EXPECT_EQ(engine->counts().joints, 7 * dolls);  // a column each 8 steps
    EXPECT_LT(engine->max_joint_error().linear, 0.1f);
    for (std::size_t i = 1; i < engine->body_slots(); i += 2) engine->destroy_body(i);
    EXPECT_LT(engine->counts().joints, 7 * dolls);
    for (int i = 0; i < 10; ++i) engine->advance({}, i, scene.dt);
    for (std::size_t i = 2; i < engine->body_slots(); i += 2) engine->destroy_body(i);
    EXPECT_EQ(engine->counts().joints, 0u);
    EXPECT_EQ(engine->counts().bodies, 1u);
}

}  // namespace
}  // namespace islet::test
