// What swings: pendulums, a heavy ball on a light chain, balls caught by ropes.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {
namespace {

/// The arithmetic-geometric mean of a and b.
double common_mean(double a, double b) {
    for (int i = 0; i < 20; ++i) {
        const double mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
    }
    return a;
}

}  // namespace

Scene make_pendulum() {
    constexpr int count = 5;
    constexpr float length = 2, radius = 0.25f;
    static constexpr int amplitudes[count] = {20, 50, 80, 110, 140};  // degrees
    Scene scene = sleepless_scene("pendulum", 900, {{-13, -3.5f}, {13, 3}});
    const std::size_t ground = add_body(scene, {}, {});
    BodyDef def;
    def.type = BodyType::dynamic;
    for (int i = 0; i < count; ++i) {
        def.position = {5 * static_cast<float>(i - 2), 0};
        def.angle = static_cast<float>(amplitudes[i]) * pi / 180;
        const std::size_t bob = add_body(scene, def, {{Circle{{0, -length}, radius}, ghost()}});
        RevoluteJointDef hinge;  // its angle is the pendulum's, 0 hanging down
        hinge.base.frame_a.position = def.position;
        add_joint(scene, ground, bob, hinge);
    }

    // Times at which each one comes through the bottom from the right.
    struct Swing {
        double before = 0, first = 0, last = 0;
        int passes = 0;
    };
    const auto swings = std::make_shared<std::array<Swing, count>>();
    scene.after_step = [swings, dt = double(scene.dt)](const Engine& engine, int step) {
        if (step == 0) *swings = {};
        for (std::size_t i = 0; i < count; ++i) {
            Swing& swing = (*swings)[i];
            const double angle = double(engine.joint_position(i)), before = swing.before;
            if (before > 0 && angle <= 0) {
                swing.last = dt * (step + before / (before - angle));
                if (swing.passes++ == 0) swing.first = swing.last;
            }
            swing.before = angle;
        }
    };

    // T = 2 pi sqrt(I / (m g d)) / M(1, cos(a / 2)), M the arithmetic-geometric mean, I about the hinge: the complete elliptic integral.
    scene.check = [swings, gravity = scene.world.gravity, start = scene.bodies](const Engine& engine) {
        std::vector<CheckLine> lines;
        double least = 0, now = mechanical_energy(engine, gravity), at_start = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const BodyState bob = engine.body(i + 1);
            const double d = double(length), g = -double(gravity.y), inertia = double(bob.inertia) + double(bob.mass) * d * d;
            const double amplitude = amplitudes[i] * std::numbers::pi / 180;
            const double period =
                2 * std::numbers::pi * std::sqrt(inertia / (double(bob.mass) * g * d)) / common_mean(1, std::cos(0.5 * amplitude));
            const Swing& swing = (*swings)[i];
            const double seen = swing.passes > 1 ? (swing.last - swing.first) / (swing.passes - 1) : 0;
            lines.push_back(near_line("period at " + std::to_string(amplitudes[i]) + " degrees (s)", seen, period, 0.005 * period));
            at_start -= double(bob.mass) * g * d * std::cos(amplitude);
            least -= double(bob.mass) * g * d;
        }
        lines.push_back(near_line("energy lost in 15 s, of what swings", (at_start - now) / (at_start - least), 0, 0.01));
        lines.push_back(at_most("farthest a hinge came apart (m)", double(engine.max_joint_error().linear), 0.001));
        return lines;
    };
    return scene;
}

Scene make_double_pendulum() {
    constexpr float length = 1, half_width = 0.04f;
    Scene scene = sleepless_scene("double_pendulum", 600, {{-3.6f, -2.4f}, {3.6f, 1.6f}});
    const std::size_t ground = add_body(scene, {}, {});
    BodyDef def;
    def.type = BodyType::dynamic;
    def.position = {0.5f * length, 0};
    const std::size_t upper = add_body(scene, def, {{make_box(0.5f * length, half_width), ghost()}});
    def.position = {2 * length, 0};  // its tip, which draws the path
    const std::size_t lower = add_body(scene, def, {{make_offset_box(0.5f * length, half_width, {{-0.5f * length, 0}, {}}), ghost()}});
    add_joint(scene, ground, upper, hinge_at(scene, ground, upper, {0, 0}));
    add_joint(scene, upper, lower, hinge_at(scene, upper, lower, {length, 0}));
    scene.traced = {lower};

    // From level the rods could fall by half a length and by one and a half.
    struct Seen {
        double most = 0, least = 0, gap = 0;
    };
    const auto seen = std::make_shared<Seen>();
    scene.after_step = [seen, gravity = scene.world.gravity](const Engine& engine, int step) {
        if (step == 0) *seen = {};
        const double now = mechanical_energy(engine, gravity);
        seen->most = std::max(seen->most, now);
        seen->least = std::min(seen->least, now);
        seen->gap = std::max(seen->gap, double(engine.max_joint_error().linear));
    };
    scene.check = [seen, upper](const Engine& engine) -> std::vector<CheckLine> {
        const double scale = 2 * double(length) * double(engine.body(upper).mass) * 10;
        return {
            at_most("most energy gained in 10 s, of what may swing", seen->most / scale, 0.02),
            at_most("most energy lost", -seen->least / scale, 0.05),
            at_most("farthest a hinge came apart (m)", seen->gap, 0.005),
        };
    };
    return scene;
}

Scene make_chain_ball() {
    constexpr int links = 30;
    constexpr float half_length = 0.5f, half_width = 0.1f, radius = 1.5f, ratio = 1000;
    Scene scene = sleepless_scene("chain_ball", 600, {{-42, -44}, {42, 4}});
    std::size_t previous = add_body(scene, {}, {});
    const Polygon link = make_box(half_length, half_width);
    for (int i = 0; i < links; ++i) {
        const float x = 2 * half_length * static_cast<float>(i);
        const std::size_t next = add_dynamic(scene, {x + half_length, 0}, link, ghost());
        add_joint(scene, previous, next, hinge_at(scene, previous, next, {x, 0}));
        previous = next;
    }
    constexpr float end = 2 * half_length * links;
    ShapeDef heavy = ghost();
    heavy.density = ratio * 4 * half_length * half_width / (pi * radius * radius);
    const std::size_t ball = add_dynamic(scene, {end + radius, 0}, Circle{{}, radius}, heavy);
    add_joint(scene, previous, ball, hinge_at(scene, previous, ball, {end, 0}));
    scene.traced = {ball};

    struct Seen {
        double gap = 0, most = 0, reach = 0;
    };
    const auto seen = std::make_shared<Seen>();
    scene.after_step = [seen, ball, gravity = scene.world.gravity](const Engine& engine, int step) {
        if (step == 0) *seen = {};
        seen->gap = std::max(seen->gap, double(engine.max_joint_error().linear));
        seen->most = std::max(seen->most, mechanical_energy(engine, gravity));
        seen->reach = std::max(seen->reach, double(length(engine.body(ball).center)));
    };
    // At the bottom the chain bears three times the ball's weight, m g and m v^2 / r = 2 m g. For a solver that knows two bodies at a time the worst case:
    // a joint of two links gives way by load / stiffness, and its stiffness goes with a link's mass, by half a metre here. Solved exactly it does not.
    scene.check = [seen, ball](const Engine& engine) -> std::vector<CheckLine> {
        const double heavy_mass = double(engine.body(ball).mass), light = double(engine.body(1).mass), reach = double(end) + double(radius);
        constexpr double give = 0.0025;
        return {
            near_line("the ball is so many times heavier than a link", heavy_mass / light, double(ratio), 1),
            at_most("farthest a joint came apart (m)", seen->gap, give),
            at_most("farthest the ball got (m), of 31.5", seen->reach, reach + (links + 1) * give),
            at_most("energy gained, of what the ball may swing with", std::max(0.0, seen->most) / (heavy_mass * 10 * reach), 0.02),
            at_most("bodies not finite", double(count_not_finite(engine)), 0),
        };
    };
    return scene;
}

Scene make_rope() {
    constexpr std::size_t count = 4;
    constexpr float length = 4, radius = 0.25f;
    static constexpr float aside[count] = {0.2f, 0.45f, 0.7f, 0.95f};  // of the length: where the ball starts
    Scene scene = sleepless_scene("rope", 180, {{-18, -5.5f}, {18, 1.5f}});
    const std::size_t ground = add_body(scene, {}, {});
    std::array<float, count> pivots{};
    for (std::size_t i = 0; i < count; ++i) {
        pivots[i] = 8.8f * (static_cast<float>(i) - 1.5f);
        const Vec2 pivot = {pivots[i], 0}, place = {pivots[i] + aside[i] * length, 0};
        const std::size_t ball = add_dynamic(scene, place, Circle{{}, radius}, ghost());
        DistanceJointDef rope = rope_between(scene, ground, ball, pivot, place);
        rope.length = rope.limit.upper = length;
        add_joint(scene, ground, ball, rope);
        scene.traced.push_back(ball);
    }

    // Speed at the bottom of the first swing, and how long the ropes ever were.
    struct Seen {
        std::array<double, count> speed{};
        double longest = 0, slack = 0;
    };
    const auto seen = std::make_shared<Seen>();
    scene.after_step = [seen, pivots, dt = double(scene.dt), h = double(scene.dt) / scene.world.solver.substeps](const Engine& engine,
                                                                                                                 int step) {
        if (step == 0) *seen = {};
        for (std::size_t i = 0; i < count; ++i) {
            const BodyState ball = engine.body(i + 1);
            seen->longest = std::max(seen->longest, double(engine.joint_position(i)));
            const double v = std::hypot(double(ball.linear_velocity.x), double(ball.linear_velocity.y));
            if (ball.position.x >= pivots[i] && ball.linear_velocity.x < 0) seen->speed[i] = v;
            // While the rope is slack by more than a step's way the ball falls freely: the substeps' sum g t (t + h) / 2.
            const double t = dt * (step + 1), fall = 5 * t * (t + h);
            if (std::hypot(fall, double(aside[i] * length)) < double(length) - v * dt)
                seen->slack = std::max(seen->slack, std::abs(double(ball.position.y) + fall));
        }
    };
    // The ball falls by f = sqrt(l^2 - a^2); the rope takes the part of its speed along the rope, a / l of it is left; then it swings down by l - f more.
    scene.check = [seen](const Engine&) {
        std::vector<CheckLine> lines;
        for (std::size_t i = 0; i < count; ++i) {
            const double l = double(length), a = double(aside[i]) * l, f = std::sqrt(l * l - a * a), g = 10;
            const double caught = std::sqrt(2 * g * f) * a / l, bottom = std::sqrt(caught * caught + 2 * g * (l - f));
            lines.push_back(near_line("speed at the bottom, let fall " + std::to_string(a).substr(0, 3) + " m aside (m/s)", seen->speed[i],
                                      bottom, 0.03 * bottom));
        }
        lines.push_back({"longest a rope ever was (m)", seen->longest, double(length) - 0.001, double(length) + 0.01});
        lines.push_back(at_most("off free fall while the rope was slack (m)", seen->slack, 0.001));
        return lines;
    };
    return scene;
}

}  // namespace islet::samples
