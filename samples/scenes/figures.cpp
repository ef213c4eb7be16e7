// Ragdolls on a stair, ragdolls in a heap, and a hand that pulls at a pile.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "benchmark_doll.hpp"
#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {
namespace {

/// How far any hinge from `first_joint` on is beyond its limits, rad.
double farthest_beyond(const Engine& engine, std::size_t first_joint) {
    double beyond = 0;
    for (std::size_t i = first_joint; i < engine.joint_slots(); ++i) beyond = std::max(beyond, double(engine.joint_error(i).angular));
    return beyond;
}

}  // namespace

Scene make_ragdoll() {
    constexpr int steps = 8, dolls = 3;
    constexpr float rise = 0.3f, run = 0.5f;
    Scene scene;
    scene.name = "ragdoll";
    scene.steps = 900;
    scene.view = {{-3.4f, -0.4f}, {8.6f, 5.6f}};
    ShapeDef stone;
    stone.friction = 0.8f;
    add_floor(scene, 12, stone);
    std::vector<SceneShape> stairs;
    for (int i = 0; i < steps; ++i) {
        const float top = rise * static_cast<float>(steps - i), left = -2.5f, right = run * static_cast<float>(i);
        stairs.push_back({make_offset_box(0.5f * (right - left), 0.5f * rise, {{0.5f * (left + right), top - 0.5f * rise}, {}}), stone});
    }
    stairs.push_back({make_offset_box(0.1f, 0.6f, {{8, 0.6f}, {}}), stone});
    add_body(scene, {}, std::move(stairs));

    const std::size_t first_joint = scene.joints.size();
    for (int i = 0; i < dolls; ++i) {
        const Vec2 place = {-1.4f + 0.6f * static_cast<float>(i), rise * steps + 0.05f};
        const Placed doll = add_prefab(scene, make_benchmark_doll({.position = place, .friction_torque = 1, .hertz = 0.5f, .group = i + 1}));
        for (std::size_t bone = 0; bone < bone_count; ++bone) scene.bodies[doll.first_body + bone].def.linear_velocity = {3, 0};
        scene.traced.push_back(doll.first_body + static_cast<std::size_t>(Bone::torso));
    }

    scene.check = [first_joint, torsos = scene.traced](const Engine& engine) -> std::vector<CheckLine> {
        double highest = 0;
        for (const std::size_t torso : torsos) highest = std::max(highest, double(engine.body(torso).position.y));
        return {
            near_line("joints", double(engine.counts().joints), dolls * (double(bone_count) - 1), 0),
            at_most("fastest bone in the end (m/s)", max_speed(engine), 0.05),
            at_most("farthest a hinge is beyond its limits (rad)", farthest_beyond(engine, first_joint), 0.05),
            at_most("farthest a hinge came apart (m)", double(engine.max_joint_error().linear), 0.005),
            at_most("highest torso (m), of 3.6 at the start", highest, 2.4),
            at_most("bones outside", double(count_outside(engine, {{-3, 0}, {8, 4}})), 0),
        };
    };
    return scene;
}

Scene make_ragdoll_pile() {
    constexpr int layers = 4, columns = 3, dolls = layers * columns;
    constexpr float half_width = 1.2f, wall = 8, pitch = 0.75f, tall = 1.75f;  // m
    Scene scene;
    scene.name = "ragdoll_pile";
    scene.steps = 900;
    scene.view = {{-4.5f, -0.5f}, {4.5f, 8.5f}};
    scene.world.solver.relax_iterations = 2;  // with one, a limb jammed at its limit goes on trembling in one heap out of ten
    ShapeDef stone;
    stone.friction = 0.8f;
    add_floor(scene, 5, stone);
    for (const float side : {-1.0f, 1.0f}) add_static(scene, {side * (half_width + 0.2f), 0.5f * wall}, make_box(0.2f, 0.5f * wall), stone);

    const std::size_t first_joint = scene.joints.size();
    for (int i = 0; i < dolls; ++i) {
        const int layer = i / columns, column = i % columns;
        const Vec2 place = {pitch * static_cast<float>(column - 1), 0.3f + tall * static_cast<float>(layer)};
        const Placed doll = add_prefab(scene, make_benchmark_doll({.position = place, .friction_torque = 0.5f, .hertz = 0, .group = i + 1}));
        // Layer by layer to the left and to the right, or they would stand on each other's heads.
        const float aside = layer % 2 == 0 ? 1.5f : -1.5f;
        for (std::size_t bone = 0; bone < bone_count; ++bone) scene.bodies[doll.first_body + bone].def.linear_velocity = {aside, 0};
        scene.traced.push_back(doll.first_body + static_cast<std::size_t>(Bone::torso));
    }

    // Hinges are springs, and the lowest bear the weight of the heap.
    scene.check = [first_joint](const Engine& engine) -> std::vector<CheckLine> {
        return {
            near_line("joints", double(engine.counts().joints), dolls * (double(bone_count) - 1), 0),
            at_most("fastest bone in the end (m/s)", max_speed(engine), 0.05),
            at_most("farthest a hinge is beyond its limits (rad)", farthest_beyond(engine, first_joint), 0.15),
            at_most("farthest a hinge came apart (m)", double(engine.max_joint_error().linear), 0.01),
            at_most("bones above the heap or outside the pen", double(count_outside(engine, {{-half_width, 0}, {half_width, 2.5f}})), 0),
            at_most("deepest overlap (m)", engine.max_penetration(), 0.03),
        };
    };
    return scene;
}

Scene make_mouse_drag() {
    constexpr int rows = 5, lift_step = 60;
    constexpr float half = 0.4f, hertz = 4, grip = 4000;  // m, Hz, N
    Scene scene = sleepless_scene("mouse_drag", 720, {{-5, -0.8f}, {8, 6.2f}});
    add_floor(scene, 12);
    ShapeDef material;
    const std::size_t first = add_pyramid(scene, rows, half, -0.5f * rows * 2 * half, 0, material);
    // The second box of the second row is pulled out of the pile by its upper right corner, carried up and held.
    const std::size_t pulled = first + rows + 1;
    scene.bodies[pulled].def.angular_damping = 2;
    const Vec2 held = scene.bodies[pulled].def.position + Vec2{0.8f * half, 0.8f * half};
    MouseJointDef hand;
    hand.target = held;
    hand.hertz = hertz;
    hand.max_force = grip;
    const std::size_t joint = add_joint(scene, 0, pulled, hand);
    // A second hand is too weak for its box.
    ShapeDef heavy;
    heavy.density = 10;
    const std::size_t block = add_dynamic(scene, {6.5f, half}, make_box(half, half), heavy);
    MouseJointDef weak;
    weak.target = scene.bodies[block].def.position;
    weak.max_force = 0.5f * 10 * 10 * 4 * half * half;
    const std::size_t weak_joint = add_joint(scene, 0, block, weak);
    scene.traced = {pulled};

    const Vec2 aside = {4, held.y + 0.4f}, above = {4, 4.5f};
    scene.before_step = [=](Engine& engine, int step) {
        // Smoothly from place to place: 3 t^2 - 2 t^3.
        const auto ease = [step](int from, int steps) {
            const float t = clamp(static_cast<float>(step - from) / static_cast<float>(steps), 0, 1);
            return t * t * (3 - 2 * t);
        };
        engine.set_target(joint, lerp(lerp(held, aside, ease(lift_step, 120)), above, ease(lift_step + 120, 120)));
        engine.set_target(weak_joint, Vec2{6.5f, half + 3 * ease(lift_step, 120)});
    };

    // The hand is a spring of 4 Hz: what hangs on it still hangs m g / (m w^2) below, as long as its line goes through the middle.
    scene.check = [=](const Engine& engine) -> std::vector<CheckLine> {
        const BodyState box = engine.body(pulled);
        const double omega = 2 * std::numbers::pi * double(hertz), weight = 10 * double(box.mass);
        const Vec2 grip_at = box.position + rotate(make_rot(box.angle), {0.8f * half, 0.8f * half});
        const double push = 10 * double(engine.body(block).mass);
        return {
            near_line("the corner hangs below the hand (m)", double(above.y - grip_at.y), 10 / (omega * omega), 0.003),
            near_line("beside it (m)", double(above.x - grip_at.x), 0, 0.01),
            near_line("the hand bears the box (N)", double(engine.joint_force(joint).y), weight, 0.05 * weight),
            near_line("the weak hand's pull (N)", double(engine.joint_force(weak_joint).y), 0.5 * push, 0.01 * push),
            near_line("height of the heavy box, on the ground (m)", double(engine.body(block).position.y), double(half), 0.005),
            at_most("boxes below the ground", double(count_outside(engine, {{-12, 0}, {12, 6}})), 0),
        };
    };
    return scene;
}

}  // namespace islet::samples
