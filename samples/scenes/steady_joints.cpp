// Joints that neither come apart nor gain or lose energy: pendulums, rods in space, bridges, a net, a doll that is whirled around.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "benchmark_doll.hpp"
#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"
#include "steady.hpp"

namespace islet::samples {
namespace {

/// The widest gap of joints first <= index < end in all of the run so far, m.
std::shared_ptr<double> watch_gap(Scene& scene, std::size_t first, std::size_t end) {
    auto widest = std::make_shared<double>();
    scene.after_step = [widest, first, end, before = scene.after_step](const Engine& engine, int step) {
        if (before) before(engine, step);
        if (step == 0) *widest = 0;
        for (std::size_t i = first; i < end; ++i) *widest = std::max(*widest, double(engine.joint_error(i).linear));
    };
    return widest;
}

std::shared_ptr<double> watch_gap(Scene& scene) { return watch_gap(scene, 0, scene.joints.size()); }

/// A rod of 1 m from `from` at an angle, and where it ends.
Vec2 add_rod(Scene& scene, Vec2 from, float angle) {
    const Rot q = make_rot(angle);
    const Vec2 along = {q.c, q.s};
    add_dynamic(scene, from + 0.5f * along, make_box(0.5f, 0.04f), ghost(), angle);
    return from + along;
}

}  // namespace

// -- energy ----------------------------------------------------------------------------------------------------------------------

Scene make_wild_pendulum(int start) {
    constexpr int after_a_minute = 3600;
    constexpr float right = 0.5f * pi, degree = pi / 180;
    Scene scene = sleepless_scene("wild_pendulum", 36000, {{-3.6f, -2.4f}, {3.6f, 2.4f}});
    std::size_t previous = add_body(scene, {}, {});
    Vec2 at = {0, 0};
    const float n = static_cast<float>(start - 5);
    for (const float degrees : {90 + 0.7f * n, 172 + 1.1f * n}) {  // from hanging down
        const Vec2 from = at;
        at = add_rod(scene, from, degrees * degree - right);
        const std::size_t rod = scene.bodies.size() - 1;
        add_joint(scene, previous, rod, hinge_at(scene, previous, rod, from));
        previous = rod;
    }
    const std::shared_ptr<double> gap = watch_gap(scene);
    // What it may swing with is its energy above hanging down. Positions and velocities are half a substep apart: up to 0.7 % of it.
    struct Seen {
        double before = 0, scale = 0, minute = 0, most = 0, least = 0;
    };
    const auto seen = std::make_shared<Seen>();
    const Vec2 gravity = scene.world.gravity;
    scene.before_step = [seen, gravity](Engine& engine, int step) {
        if (step > 0) return;
        *seen = {};
        seen->before = mechanical_energy(engine, gravity);
        const double hanging = -10 * (0.5 * double(engine.body(1).mass) + 1.5 * double(engine.body(2).mass));
        seen->scale = seen->before - hanging;
    };
    scene.after_step = [seen, gravity, before = scene.after_step](const Engine& engine, int step) {
        before(engine, step);
        const double gained = (mechanical_energy(engine, gravity) - seen->before) / seen->scale;
        seen->most = std::max(seen->most, gained);
        seen->least = std::min(seen->least, gained);
        if (step + 1 == after_a_minute) seen->minute = gained;
    };
    scene.check = [seen, gap](const Engine&) -> std::vector<CheckLine> {
        return {
            wanted_line("double pendulum: energy gained or lost in 60 s (of it)", std::abs(seen->minute), 0.05),
            wanted_line("double pendulum: most energy gained in 10 min (of it)", seen->most, 0.01),
            at_most("most energy lost (of it)", -seen->least, 0.05),
            at_most("widest gap of a hinge (m)", *gap, 1e-4),
        };
    };
    return scene;
}

Scene make_rods_in_space(int start) {
    constexpr float turn = 10;  // rad/s
    const float bend = 0.1f + 0.25f * static_cast<float>(start);
    Scene scene = sleepless_scene("rods_in_space", 586 * 60, {{-2.5f, -1.7f}, {5, 3.3f}});
    scene.world.gravity = {0, 0};
    Vec2 at = {0, 0}, middle = {0, 0};
    for (const float angle : {0.0f, bend, -0.7f * bend}) {
        const Vec2 from = at;
        at = add_rod(scene, from, angle);
        const std::size_t rod = scene.bodies.size() - 1;
        if (rod > 0) add_joint(scene, rod - 1, rod, hinge_at(scene, rod - 1, rod, from));
        middle += (1.0f / 3) * scene.bodies[rod].def.position;
    }
    for (SceneBody& rod : scene.bodies) {
        rod.def.linear_velocity = cross(turn, rod.def.position - middle);
        rod.def.angular_velocity = turn;
    }
    struct Before {
        double energy = 0, spin = 0;
    };
    const auto before = std::make_shared<Before>();
    scene.before_step = [before](Engine& engine, int step) {
        if (step == 0) *before = {kinetic_energy(engine), angular_momentum(engine)};
    };
    scene.check = [before](const Engine& engine) -> std::vector<CheckLine> {
        return {
            wanted_line("three rods in space: energy gained or lost in 586 s (of it)", std::abs(kinetic_energy(engine) / before->energy - 1), 0.05),
            wanted_line("three rods in space: angular momentum changed (of it)", std::abs(angular_momentum(engine) / before->spin - 1), 0.001),
            at_most("widest gap of a hinge in the end (m)", double(engine.max_joint_error().linear), 1e-4),
        };
    };
    return scene;
}

Scene make_spun_rod(int start) {
    constexpr float spin = 60;  // rad/s
    const float half = 0.5f + 0.05f * static_cast<float>(start), angle = 0.3f * static_cast<float>(start);
    Scene scene = sleepless_scene("spun_rod", 1200, {{-3, -2}, {3, 2}});
    const std::size_t ground = add_body(scene, {}, {});
    const Vec2 middle = half * Vec2{make_rot(angle).c, make_rot(angle).s};
    const std::size_t rod = add_dynamic(scene, middle, make_box(half, 0.05f), ghost(), angle);
    scene.bodies[rod].def.angular_velocity = spin;
    scene.bodies[rod].def.linear_velocity = cross(spin, middle);
    add_joint(scene, ground, rod, hinge_at(scene, ground, rod, {0, 0}));
    const std::shared_ptr<double> gap = watch_gap(scene);
    const auto before = std::make_shared<double>();
    const Vec2 gravity = scene.world.gravity;
    scene.before_step = [before, gravity](Engine& engine, int step) {
        if (step == 0) *before = mechanical_energy(engine, gravity);
    };
    scene.check = [before, gap, gravity](const Engine& engine) -> std::vector<CheckLine> {
        return {
            wanted_line("rod at 60 rad/s: energy gained or lost in 20 s (of it)", std::abs(mechanical_energy(engine, gravity) / *before - 1), 0.01),
            wanted_line("rod at 60 rad/s: gap of its hinge (m)", *gap, 0.001),
        };
    };
    return scene;
}

// -- gaps ------------------------------------------------------------------------------------------------------------------------

Scene make_long_bridges(int start) {
    constexpr int planks = 60;
    static constexpr float loads[] = {100, 1000};  // kg
    static constexpr double wanted[] = {0.002, 0.01};
    Scene scene = sleepless_scene("long_bridges", 1200, {{-32, -8}, {32, 16}});
    ShapeDef wood, crate;
    wood.density = 20;
    std::array<std::shared_ptr<double>, 2> gaps;
    for (std::size_t bridge = 0; bridge < 2; ++bridge) {
        const float y = 10 * static_cast<float>(bridge);
        const std::size_t banks = add_body(scene, {}, {}), first = scene.joints.size();
        std::size_t previous = banks;
        for (int i = 0; i < planks; ++i) {
            const Vec2 middle = {static_cast<float>(i) - 29.5f, y};
            const std::size_t plank = add_dynamic(scene, middle, make_box(0.5f, 0.125f), wood);
            add_joint(scene, previous, plank, hinge_at(scene, previous, plank, middle - Vec2{0.5f, 0}));
            previous = plank;
        }
        add_joint(scene, previous, banks, hinge_at(scene, previous, banks, {30, y}));
        crate.density = 0.25f * loads[bridge];
        add_dynamic(scene, {-9 + 2.13f * static_cast<float>(start), y + 1.2f}, make_box(1, 1), crate);
        gaps[bridge] = watch_gap(scene, first, scene.joints.size());
    }
    scene.check = [gaps](const Engine&) {
        std::vector<CheckLine> lines;
        for (std::size_t i = 0; i < 2; ++i)
            lines.push_back(wanted_line("bridge of 60 planks under " + std::to_string(int(loads[i])) + " kg: widest gap (m)", *gaps[i], wanted[i]));
        return lines;
    };
    return scene;
}

Scene make_hung_net(int start) {
    constexpr std::size_t side = 40;
    Scene scene = sleepless_scene("hung_net", 300, {{-12, -62}, {51, 3}});
    const Rot tilt = make_rot(0.02f * static_cast<float>(start));
    scene.world.gravity = rotate(tilt, {0, -10});
    for (std::size_t column = 0; column < side; ++column) {
        for (std::size_t row = 0; row < side; ++row) {
            const bool is_held = row == 0 && (column == 0 || column + 1 == side);
            const Vec2 place = {static_cast<float>(column), -static_cast<float>(row)};
            const std::size_t body = is_held ? add_static(scene, place, Circle{{}, 0.4f}, ghost()) : add_dynamic(scene, place, Circle{{}, 0.4f}, ghost());
            if (row > 0) add_joint(scene, body - 1, body, hinge_at(scene, body - 1, body, place + Vec2{0, 0.5f}));
            if (column > 0) add_joint(scene, body - side, body, hinge_at(scene, body - side, body, place - Vec2{0.5f, 0}));
        }
    }
    const std::shared_ptr<double> gap = watch_gap(scene);
    scene.check = [gap](const Engine&) -> std::vector<CheckLine> {
        return {wanted_line("net of 40 x 40 held at two corners: widest gap (m)", *gap, 0.02, 0.4)};
    };
    return scene;
}

Scene make_whirled_doll(int start) {
    constexpr Bone held[] = {Bone::torso, Bone::hip, Bone::head, Bone::lower_left_arm, Bone::lower_right_leg};
    constexpr float pull = 50 * 10;                                                               // m/s^2, of the doll as a whole
    const float rate = 15 + static_cast<float>(start), phase = 0.6f * static_cast<float>(start);  // rad/s, rad
    Scene scene = sleepless_scene("whirled_doll", 600, {{-4, -4}, {4, 4}});
    const Placed doll = add_prefab(scene, make_benchmark_doll({.position = {0, -1}, .friction_torque = 0.5f, .hertz = 0}));
    const std::size_t bone = doll.first_body + static_cast<std::size_t>(held[start % 5]);
    scene.traced = {bone};
    // A force that turns: what it pulls goes around in circles of a / w^2, about 1 to 2 m, if it sets out at a / w.
    const Rot first = make_rot(phase);
    for (std::size_t i = 0; i < bone_count; ++i) scene.bodies[doll.first_body + i].def.linear_velocity = pull / rate * Vec2{first.s, -first.c};
    scene.before_step = [=, dt = scene.dt](Engine& engine, int step) {
        double mass = 0;
        for (std::size_t i = 0; i < bone_count; ++i) mass += double(engine.body(doll.first_body + i).mass);
        const Rot q = make_rot(std::remainder(phase + rate * dt * static_cast<float>(step), 2 * pi));
        engine.apply_force(bone, static_cast<float>(mass) * (pull * Vec2{q.c, q.s} + Vec2{0, 10}));
    };
    const std::shared_ptr<double> gap = watch_gap(scene);
    scene.check = [gap](const Engine& engine) -> std::vector<CheckLine> {
        return {
            wanted_line("ragdoll whirled around by 50 x its weight: widest gap (m)", *gap, 0.002),
            at_most("bodies not finite", double(count_not_finite(engine)), 0),
        };
    };
    return scene;
}

Scene make_chain_ball_from(int start) {
    Scene scene = make_chain_ball();
    scene.world.gravity = rotate(make_rot(0.05f * static_cast<float>(start)), {0, -10});
    const std::shared_ptr<double> gap = watch_gap(scene);
    scene.check = [gap](const Engine&) -> std::vector<CheckLine> { return {wanted_line("chain under 1000 x a link: widest gap (m)", *gap, 4e-5)}; };
    return scene;
}

Scene make_joint_grid_from(int start) {
    Scene scene = make_joint_grid();
    scene.steps = 300;
    scene.world.gravity = rotate(make_rot(0.02f * static_cast<float>(start)), {0, -10});
    const std::shared_ptr<double> gap = watch_gap(scene);
    scene.check = [gap](const Engine&) -> std::vector<CheckLine> { return {wanted_line("joint_grid: widest gap in 5 s (m)", *gap, 0.05, 1)}; };
    return scene;
}

}  // namespace islet::samples
