// Many joints that make one motion: a scissor lift, pulleys, gears.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>

#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {

Scene make_scissor_lift() {
    constexpr int stages = 4, measured_step = 300;
    constexpr float length = 2, wide = 1.7f, narrow = 0.8f, speed = 0.15f, strength = 5000;  // m, m, m, m/s, N
    constexpr float platform_half = 1.2f, half = 0.35f;
    Scene scene;
    scene.name = "scissor_lift";
    scene.world.enable_sleep = false;
    // Light bars that bear ten times their weight at a flat angle: shorter substeps let the joints be stiffer.
    scene.world.solver.substeps = 8;
    scene.world.solver.joint_hertz = 120;
    scene.steps = 540;
    scene.view = {{-5.5f, -0.6f}, {7.5f, 9}};
    add_floor(scene, 8);

    // Bars cross in each stage: one rises to the right, its partner to the left. Their feet stand `wide` apart, the right one on a carriage.
    const float rise = std::sqrt(length * length - wide * wide);
    const auto corner = [&](bool right, int level) { return Vec2{right ? wide : 0, rise * static_cast<float>(level) + 0.15f}; };
    const ShapeDef iron = ghost(5);
    const Polygon bar = make_box(0.5f * length + 0.04f, 0.06f);
    std::array<std::size_t, stages> rising{}, falling{};
    for (int i = 0; i < stages; ++i) {
        const auto stage = static_cast<std::size_t>(i);
        const Vec2 middle = 0.5f * (corner(false, i) + corner(true, i + 1));
        rising[stage] = add_dynamic(scene, middle, bar, iron, atan2(rise, wide));
        falling[stage] = add_dynamic(scene, middle, bar, iron, atan2(-rise, wide));
        add_joint(scene, rising[stage], falling[stage], hinge_at(scene, rising[stage], falling[stage], middle));
        if (i == 0) continue;
        add_joint(scene, rising[stage - 1], falling[stage], hinge_at(scene, rising[stage - 1], falling[stage], corner(true, i)));
        add_joint(scene, falling[stage - 1], rising[stage], hinge_at(scene, falling[stage - 1], rising[stage], corner(false, i)));
    }
    const std::size_t carriage = add_dynamic(scene, corner(true, 0), make_box(0.15f, 0.1f), ghost(20));
    PrismaticJointDef rail = slider_at(scene, 0, carriage, corner(true, 0), {1, 0});
    rail.limit = {.enable = true, .lower = narrow - wide, .upper = 0};
    rail.motor = {.enable = true, .speed = -speed, .max_force = strength};
    const std::size_t motor = add_joint(scene, 0, carriage, rail);
    add_joint(scene, 0, rising[0], hinge_at(scene, 0, rising[0], corner(false, 0)));
    add_joint(scene, carriage, falling[0], hinge_at(scene, carriage, falling[0], corner(true, 0)));

    ShapeDef wood;
    wood.density = 5;
    const std::size_t platform = add_dynamic(scene, corner(false, stages) + Vec2{0.5f * wide, 0}, make_box(platform_half, 0.08f), wood);
    add_joint(scene, platform, falling[stages - 1], hinge_at(scene, platform, falling[stages - 1], corner(false, stages)));
    WheelJointDef roller = wheel_at(scene, platform, rising[stages - 1], corner(true, stages), {1, 0});
    roller.spring.enable = false;
    add_joint(scene, platform, rising[stages - 1], roller);
    const std::size_t first_load = scene.bodies.size();
    const Vec2 top = scene.bodies[platform].def.position + Vec2{0, 0.08f + half};
    add_dynamic(scene, top + Vec2{-0.4f, 0}, make_box(half, half), wood);
    add_dynamic(scene, top + Vec2{0.4f, 0}, make_box(half, half), wood);

    // The platform stands stages * sqrt(l^2 - w^2) above the feet.
    const auto height = [](double width) { return stages * std::sqrt(double(length * length) - width * width); };
    struct Seen {
        double height = 0, expected = 0, force = 0, needed = 0;
    };
    const auto seen = std::make_shared<Seen>();
    scene.after_step = [=](const Engine& engine, int step) {
        if (step + 1 != measured_step) return;
        const double width = double(wide) + double(engine.joint_position(motor)), h1 = height(width) / stages;
        *seen = {double(engine.body(platform).position.y) - 0.15, height(width), double(engine.motor_force(motor)), 0};
        // Virtual work: F dw = the weights times what each rises. Bars of stage i rise by (i + 1/2) dh, dh / dw = -w / h of a stage.
        double moment = stages * double(engine.body(platform).mass);
        for (std::size_t load = first_load; load < engine.body_slots(); ++load) moment += stages * double(engine.body(load).mass);
        for (std::size_t i = 0; i < stages; ++i) moment += 2 * (double(i) + 0.5) * double(engine.body(rising[i]).mass);
        seen->needed = -10 * moment * width / h1;
    };
    scene.check = [=](const Engine& engine) -> std::vector<CheckLine> {
        double away = 0;
        for (std::size_t load = first_load; load < engine.body_slots(); ++load)
            away = std::max(away, std::abs(double(engine.body(load).position.y - engine.body(platform).position.y) - double(0.08f + half)));
        return {
            near_line("height half way up, by Pythagoras (m)", seen->height, seen->expected, 0.05),
            near_line("force of its motor, by virtual work (N)", seen->force, seen->needed, -0.05 * seen->needed),
            near_line("height in the end (m)", double(engine.body(platform).position.y) - 0.15, height(double(narrow)), 0.05),
            at_most("the platform is off level (rad)", std::abs(double(engine.body(platform).angle)), 0.02),
            at_most("the load is off the platform (m)", away, 0.03),
            at_most("farthest a joint came apart (m)", double(engine.max_joint_error().linear), 0.01),
        };
    };
    return scene;
}

Scene make_pulley() {
    struct Pair {
        float x, left, right, ratio;  // m, kg, kg
    };
    static constexpr Pair pairs[] = {{-6, 2, 2, 1}, {-2, 2, 1, 1}, {2, 1, 3, 1}, {6, 2, 3, 2}};
    constexpr std::size_t count = 4;
    constexpr float beam = 6, start = 3, half_apart = 0.9f;
    Scene scene = sleepless_scene("pulley", 45, {{-8.6f, -0.6f}, {8.6f, 7}});
    add_floor(scene, 10);
    scene.bodies[0].shapes.push_back({make_offset_box(8, 0.1f, {{0, 1 + beam + 0.1f}, {}}), {}});
    for (const Pair& pair : pairs) {
        std::size_t ends[2];
        const float masses[] = {pair.left, pair.right};
        for (std::size_t side = 0; side < 2; ++side) {
            const float half = 0.25f * std::sqrt(masses[side]);
            const float x = pair.x + (side == 0 ? -half_apart : half_apart);
            ends[side] = add_dynamic(scene, {x, start}, make_box(half, half), ShapeDef{.density = 4});
        }
        const Vec2 a = scene.bodies[ends[0]].def.position, b = scene.bodies[ends[1]].def.position;
        PulleyJointDef pulley = pulley_over(scene, ends[0], ends[1], a, {a.x, beam}, {b.x, beam}, b);
        pulley.ratio = pair.ratio;
        add_joint(scene, ends[0], ends[1], pulley);
    }

    // l1 + r l2 = constant: with tension T on the left and r T on the right the right weight goes down at a = g (m2 - r m1) / (m2 + r^2 m1), the left one
    // up at r a. The substeps of h seconds sum it to a t (t + h) / 2.
    const double t = double(scene.dt) * scene.steps, h = double(scene.dt) / scene.world.solver.substeps;
    scene.check = [t, h](const Engine& engine) {
        std::vector<CheckLine> lines;
        for (std::size_t i = 0; i < count; ++i) {
            const BodyState left = engine.body(2 * i + 1), right = engine.body(2 * i + 2);
            const double m1 = double(left.mass), m2 = double(right.mass), r = double(pairs[i].ratio), g = 10;
            const double a = g * (m2 - r * m1) / (m2 + r * r * m1), fallen = 0.5 * a * t * (t + h), tension = m1 * (g + r * a);
            char name[64];
            std::snprintf(name, sizeof name, "%g kg : %g kg, ratio %g: ", double(pairs[i].left), double(pairs[i].right),
                          double(pairs[i].ratio));
            lines.push_back(
                near_line(std::string(name) + "the right one fell (m)", double(start) - double(right.position.y), fallen, 0.005));
            lines.push_back(near_line("  the left one rose (m)", double(left.position.y) - double(start), r * fallen, 0.005));
            lines.push_back(near_line("  the rope bears on the right (N)", double(engine.joint_force(i).y), r * tension, 0.01 * r * tension));
        }
        lines.push_back(at_most("farthest a rope was from its length (m)", double(engine.max_joint_error().linear), 0.002));
        return lines;
    };
    return scene;
}

Scene make_gears() {
    constexpr int measured_step = 170;
    constexpr float small = 0.6f, large = 1.2f, rate = 2, strength = 1000;  // m, m, rad/s, N m
    Scene scene = sleepless_scene("gears", 180, {{-2.6f, -3.9f}, {6.4f, 3.9f}});
    const std::size_t ground = add_body(scene, {}, {});

    // Three wheels in a row, and a toothed bar that hangs on the last one.
    const auto add_wheel = [&](float x, float radius) {
        std::vector<SceneShape> shapes = {{Circle{{}, radius - 0.08f}, ghost(2)}};
        const int teeth = static_cast<int>(radius * 20);
        for (int i = 0; i < teeth; ++i) {
            const Rot q = make_rot(2 * pi * (static_cast<float>(i) + 0.5f) / static_cast<float>(teeth));
            shapes.push_back({make_offset_box(0.1f, 0.06f, {rotate(q, {radius - 0.06f, 0}), q}), ghost(2)});
        }
        BodyDef def;
        def.type = BodyType::dynamic;
        def.position = {x, 0};
        return add_body(scene, def, std::move(shapes));
    };
    const float xs[] = {0, small + large, 2 * (small + large)};
    const float radii[] = {small, large, small};
    std::array<std::size_t, 3> wheels{}, hinges{};
    for (std::size_t i = 0; i < 3; ++i) {
        wheels[i] = add_wheel(xs[i], radii[i]);
        RevoluteJointDef hinge = hinge_at(scene, ground, wheels[i], {xs[i], 0});
        if (i == 0) hinge.motor = {.enable = true, .speed = rate, .max_force = strength};
        hinges[i] = add_joint(scene, ground, wheels[i], hinge);
    }
    const float rack_x = xs[2] + small + 0.15f;
    const std::size_t rack = add_dynamic(scene, {rack_x, -1.8f}, make_box(0.1f, 1.9f), ghost(20));
    const std::size_t slider = add_joint(scene, ground, rack, slider_at(scene, ground, rack, {rack_x, 0}, {0, 1}));
    std::array<std::size_t, 3> gears{};
    gears[0] = add_gear(scene, hinges[0], hinges[1], large / small);
    gears[1] = add_gear(scene, hinges[1], hinges[2], small / large);
    // The rim of the last wheel goes up on its right as it turns: s = radius * angle.
    gears[2] = add_gear(scene, hinges[2], slider, -1 / small);

    struct Seen {
        double torque = 0;
    };
    const auto seen = std::make_shared<Seen>();
    scene.after_step = [seen, motor = hinges[0]](const Engine& engine, int step) {
        if (step + 1 == measured_step) seen->torque = double(engine.motor_force(motor));
    };
    scene.check = [=](const Engine& engine) -> std::vector<CheckLine> {
        const double first = double(engine.joint_position(hinges[0])), r1 = double(small), r2 = double(large);
        const double torque = 10 * double(engine.body(rack).mass) * r1;  // what lifts the bar by r1 a radian
        return {
            near_line("the first wheel's turn (rad)", first, double(rate) * 3, 0.05),
            near_line("the second's (rad)", double(engine.joint_position(hinges[1])), -first * r1 / r2, 0.02),
            near_line("the third's (rad)", double(engine.joint_position(hinges[2])), first, 0.02),
            near_line("the bar's rise (m)", double(engine.joint_position(slider)), first * r1, 0.02),
            near_line("the motor bears the bar's weight (N m)", seen->torque, torque, 0.02 * torque),
            at_most("farthest a joint came apart (m)", double(engine.max_joint_error().linear), 0.005),
            at_most("farthest a gear is off its teeth (rad)", double(engine.max_joint_error().angular), 0.01),
        };
    };
    return scene;
}

}  // namespace islet::samples
