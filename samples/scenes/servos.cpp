// Robots whose joints are servos: motors told every step to turn to where they should be.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {
namespace {

/// Two bars, end to end, from the origin: the angles, against the x axis, at which the second one ends at `reach`. `bend` = 1 puts the joint between
/// them to the left of the straight way, -1 to the right.
struct Bend {
    float first, second;
};
Bend bend_to(Vec2 reach, float length1, float length2, float bend) {
    const float far = length(reach), c = clamp((length1 * length1 + far * far - length2 * length2) / (2 * length1 * far), -1, 1);
    const float first = atan2(reach.y, reach.x) + bend * atan2(std::sqrt(1 - c * c), c);
    const Rot q = make_rot(first);
    const Vec2 rest = reach - Vec2{length1 * q.c, length1 * q.s};
    return {first, atan2(rest.y, rest.x)};
}

/// An angle less whole turns, in (-pi, pi].
float wrapped(float angle) { return atan2(make_rot(angle).s, make_rot(angle).c); }

/// A servo: turns at `rate` and mends what is missing within a few steps, with at most `torque`.
JointMotor servo(float angle, float now, float rate, float gain, float torque) {
    return {.enable = true, .speed = rate + gain * wrapped(angle - now), .max_force = torque};
}

/// 0 before a, 1 after b, smooth between.
float ease(float a, float b, float x) {
    const float t = clamp((x - a) / (b - a), 0, 1);
    return t * t * (3 - 2 * t);
}

/// A bar from the origin of its body along its x axis, or, if `shift` is -1, up to its origin.
SceneShape bar_of(float length, float radius, const ShapeDef& material, float shift = 0) {
    return {Capsule{{shift * length, 0}, {(1 + shift) * length, 0}, radius}, material};
}

SceneBody moving(Vec2 place, float angle, std::vector<SceneShape> shapes) {
    SceneBody body;
    body.def.type = BodyType::dynamic;
    body.def.position = place;
    body.def.angle = angle;
    body.def.enable_sleep = false;
    body.shapes = std::move(shapes);
    return body;
}

/// The circle that the arm's tip draws, and the angles of its three joints on the way.
struct ArmPlan {
    static constexpr std::array<float, 3> bars = {1.2f, 1, 0.5f};  // m
    static constexpr Vec2 shoulder = {0, 1}, middle = {1.6f, 1.6f};
    static constexpr float radius = 0.5f, period = 3;  // m, s

    /// Angle on the circle after t seconds; it sets out gently.
    static float phase(float t) { return 2 * pi / period * (t < 1 ? 0.5f * t * t : t - 0.5f); }
    static Vec2 tip(float t) {
        const Rot q = make_rot(phase(t));
        return middle + radius * Vec2{q.c, q.s};
    }
    /// Angles of the bars against the x axis. The last one, the hand, points down by an eighth of a turn.
    static std::array<float, 3> bar_angles(float t) {
        constexpr float hand = -pi / 4;
        const Rot q = make_rot(hand);
        const Bend bend = bend_to(tip(t) - bars[2] * Vec2{q.c, q.s} - shoulder, bars[0], bars[1], 1);
        return {bend.first, bend.second, hand};
    }
    /// Of the joints: each bar against the one before.
    static std::array<float, 3> joint_angles(float t) {
        const std::array<float, 3> bar = bar_angles(t);
        return {bar[0], wrapped(bar[1] - bar[0]), wrapped(bar[2] - bar[1])};
    }
};

}  // namespace

Scene make_arm() {
    constexpr float torque = 400;  // N m
    Scene scene;
    scene.name = "arm";
    scene.steps = 600;
    scene.view = {{-1.5f, -0.5f}, {3, 2.9f}};
    add_floor(scene, 3);
    ShapeDef steel;
    steel.density = 30;
    steel.filter.mask = 0;  // it is to draw, not to touch
    const std::size_t pedestal = add_static(scene, {0, 0.5f}, make_box(0.2f, 0.5f));

    // The hand's origin is its tip, so that it is the tip's path that the picture shows.
    const std::array<float, 3> angles = ArmPlan::bar_angles(0);
    Vec2 joint = ArmPlan::shoulder;
    std::size_t before = pedestal, joints[3] = {};
    for (std::size_t i = 0; i < 3; ++i) {
        const float shift = i == 2 ? -1.0f : 0.0f;
        const Vec2 far = joint + rotate(make_rot(angles[i]), {ArmPlan::bars[i], 0});
        scene.bodies.push_back(
            moving(i == 2 ? far : joint, angles[i], {bar_of(ArmPlan::bars[i], 0.09f - 0.02f * static_cast<float>(i), steel, shift)}));
        const std::size_t bar = scene.bodies.size() - 1;
        RevoluteJointDef hinge;
        hinge.base.frame_a.position = i == 0 ? Vec2{0, 0.5f} : Vec2{ArmPlan::bars[i - 1], 0};
        hinge.base.frame_b.position = {shift * ArmPlan::bars[i], 0};
        joints[i] = add_joint(scene, before, bar, hinge);
        before = bar;
        joint = far;
    }
    const std::size_t hand = before;
    scene.traced = {hand};

    struct Seen {
        double worst = 0, sum = 0, torque = 0;
        int count = 0;
    };
    const auto seen = std::make_shared<Seen>();
    const std::array<std::size_t, 3> servos = {joints[0], joints[1], joints[2]};
    scene.before_step = [servos, dt = scene.dt](Engine& engine, int step) {
        const float t = dt * static_cast<float>(step);
        const std::array<float, 3> now = ArmPlan::joint_angles(t), next = ArmPlan::joint_angles(t + dt);
        for (std::size_t i = 0; i < 3; ++i) {
            const float rate = wrapped(next[i] - now[i]) / dt;
            engine.set_motor(servos[i], servo(now[i], engine.joint_position(servos[i]), rate, 20, torque));
        }
    };
    scene.after_step = [servos, seen, hand, dt = scene.dt](const Engine& engine, int step) {
        if (step == 0) *seen = {};
        const double off = double(distance(engine.body(hand).position, ArmPlan::tip(dt * static_cast<float>(step + 1))));
        for (const std::size_t servo : servos) seen->torque = std::max(seen->torque, std::abs(double(engine.motor_force(servo))));
        if (step < 15) return;  // the motors have yet to find the bars' weight
        seen->worst = std::max(seen->worst, off);
        seen->sum += off;
        ++seen->count;
    };
    const double circles = double(ArmPlan::phase(scene.dt * static_cast<float>(scene.steps))) / (2 * double(pi));
    scene.check = [seen, circles](const Engine& engine) -> std::vector<CheckLine> {
        return {
            {"circles drawn", circles, 3, 3.5},
            // A motor holds its speed over a step, while the plan's rates change: that alone is off by acceleration * dt^2 / 2 in every step, 0.3 mm,
            // which the servo mends within three steps or so. The rest is the bars' weight, which the hinges give to.
            at_most("tip off the circle's moving point at most (m)", seen->worst, 0.003),
            at_most("on average (m)", seen->sum / seen->count, 0.0015),
            at_most("torque used (N m)", seen->torque, double(torque)),
            at_most("a hinge came apart (m)", double(engine.max_joint_error().linear), 0.003),
        };
    };
    return scene;
}

namespace {

/// How a quadruped folds and stretches its legs: bars' angles against the x axis. Lying, a thigh points along the trunk and its shin back again.
struct StandPlan {
    static constexpr float bar = 0.5f, radius = 0.06f;  // m, of thigh and shin
    static constexpr float high = 0.85f;                // m, from hip down to ankle, standing
    static constexpr float limp = 1, up = 3.5f;         // s: when it begins to stand up, and when it stands

    /// The foot ends `aside` of the hip; `bend` = 1 is a leg whose thigh points to the right, lying, and -1 to the left.
    static Bend leg(float aside, float bend, float t) {
        const Bend stand = bend_to({aside, -high}, bar, bar, bend), lie = bend > 0 ? Bend{0, -pi} : Bend{-pi, 0};
        const float share = ease(limp, up, t);
        return {lie.first + share * (stand.first - lie.first), lie.second + share * (stand.second - lie.second)};
    }
};

}  // namespace

Scene make_quadruped() {
    constexpr float torque = 250, half_length = 0.8f, half_height = 0.16f, hip_x = 0.62f, hip_y = -0.08f;
    Scene scene;
    scene.name = "quadruped";
    make_stiff(scene);
    scene.steps = 360;
    scene.view = {{-2, -0.5f}, {2, 1.8f}};
    add_floor(scene, 3, {.friction = 0.8f});
    ShapeDef trunk;
    trunk.density = 40;
    trunk.filter.group = -1;
    ShapeDef bone = trunk;
    bone.density = 20;
    bone.friction = 0.8f;

    const Vec2 place = {0, half_height + 0.01f};
    const std::size_t body = scene.bodies.size();
    scene.bodies.push_back(moving(place, 0,
                                  {{make_rounded_box(half_length - 0.05f, half_height - 0.05f, 0.05f), trunk},
                                   {make_offset_box(0.16f, 0.1f, {{half_length + 0.1f, 0.14f}, {}}, 0.05f), trunk}}));
    struct Servo {
        std::size_t hip, knee;
        float aside, bend;
    };
    std::vector<Servo> legs;
    for (const float end : {-1.0f, 1.0f}) {
        for (const float aside : {-0.12f, 0.12f}) {
            // Hind knees bend forwards and elbows backwards.
            const Bend pose = StandPlan::leg(aside, -end, 0);
            const Vec2 hip = place + Vec2{end * hip_x, hip_y}, knee = hip + rotate(make_rot(pose.first), {StandPlan::bar, 0});
            const SceneShape shape = bar_of(StandPlan::bar, StandPlan::radius, bone);
            scene.bodies.push_back(moving(hip, pose.first, {shape}));
            scene.bodies.push_back(moving(knee, pose.second, {shape}));
            const std::size_t shin = scene.bodies.size() - 1, thigh = shin - 1;
            RevoluteJointDef hinge;
            hinge.base.frame_a.position = {end * hip_x, hip_y};
            const std::size_t hip_joint = add_joint(scene, body, thigh, hinge);
            hinge.base.frame_a.position = {StandPlan::bar, 0};
            legs.push_back({hip_joint, add_joint(scene, thigh, shin, hinge), aside, -end});
        }
    }

    struct Seen {
        double lying = 0, torque = 0;
    };
    const auto seen = std::make_shared<Seen>();
    scene.before_step = [=, dt = scene.dt](Engine& engine, int step) {
        const float t = dt * static_cast<float>(step);
        for (const Servo& leg : legs) {
            const Bend pose = StandPlan::leg(leg.aside, leg.bend, t);
            const float strength = t < StandPlan::limp ? 1 : torque;
            engine.set_motor(leg.hip, servo(pose.first, engine.joint_position(leg.hip), 0, 8, strength));
            engine.set_motor(leg.knee, servo(pose.second - pose.first, engine.joint_position(leg.knee), 0, 8, strength));
        }
    };
    scene.after_step = [=, lying_step = static_cast<int>(StandPlan::limp / scene.dt)](const Engine& engine, int step) {
        if (step == 0) *seen = {};
        if (step == lying_step - 1) seen->lying = double(engine.body(body).position.y);
        for (const Servo& leg : legs)
            seen->torque =
                std::max({seen->torque, std::abs(double(engine.motor_force(leg.hip))), std::abs(double(engine.motor_force(leg.knee)))});
    };
    scene.check = [=](const Engine& engine) -> std::vector<CheckLine> {
        const BodyState now = engine.body(body);
        // Standing, the trunk's middle is above the floor by a foot, the legs, and what its hips are below it.
        const double due = double(StandPlan::radius) + double(StandPlan::high) - double(hip_y);
        return {
            near_line("lying on its belly: height (m)", seen->lying, double(half_height), 0.02),
            near_line("standing: height (m)", double(now.position.y), due, 0.02),
            at_most("tilt (rad)", std::abs(double(now.angle)), 0.02),
            at_most("moved sideways (m)", std::abs(double(now.position.x)), 0.1),
            at_most("torque used (N m)", seen->torque, double(torque)),
            at_most("fastest part (m/s)", max_speed(engine), 0.02),
        };
    };
    return scene;
}

}  // namespace islet::samples
