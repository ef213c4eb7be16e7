// Free flight and impacts: a box that lands, projectiles, bouncing balls, Newton's cradle.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {

Scene make_hello() {
    Scene scene;
    scene.name = "hello";
    scene.steps = 180;
    scene.view = {{-8, -1.5f}, {8, 9}};
    add_static(scene, {0, 0}, make_box(20, 1));
    const std::size_t crate = add_dynamic(scene, {0, 8}, make_box(0.5f, 0.5f));
    scene.traced = {crate};

    scene.check = [crate](const Engine& engine) -> std::vector<CheckLine> {
        const BodyState state = engine.body(crate);
        return {
            near_line("height of the crate's middle (m), on a floor at 1", double(state.position.y), 1.5, 0.005),
            at_most("moved sideways (m)", std::abs(double(state.position.x)), 0.05),
            at_most("awake bodies", double(engine.counts().awake_bodies), 0),
        };
    };
    return scene;
}

Scene make_projectile() {
    constexpr int count = 7;
    constexpr float speed = 14;  // m/s
    Scene scene;
    scene.name = "projectile";
    scene.steps = 90;
    scene.view = {{-1, -5}, {21, 10.5f}};
    ShapeDef through;  // the balls start in one place and meet nothing
    through.filter.mask = 0;
    BodyDef ball;
    ball.type = BodyType::dynamic;
    for (int i = 0; i < count; ++i) {
        const Rot aim = make_rot(static_cast<float>(20 + 10 * i) * pi / 180);
        ball.linear_velocity = {speed * aim.c, speed * aim.s};
        scene.traced.push_back(add_body(scene, ball, {{Circle{{}, 0.2f}, through}}));
    }

    // n substeps of h seconds, each v += g h and then x += v h, put the ball at v t + g h^2 n (n + 1) / 2: g t h / 2 off the parabola.
    const double h = double(scene.dt) / scene.world.solver.substeps, n = double(scene.steps) * scene.world.solver.substeps, t = n * h;
    const double g = double(scene.world.gravity.y);
    scene.check = [bodies = scene.bodies, h, n, t, g](const Engine& engine) -> std::vector<CheckLine> {
        double off_sum = 0, off_parabola = 0, off_range = 0;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const Vec2 p = engine.body(i).position, v = bodies[i].def.linear_velocity;
            const double rise = double(v.y) * t;
            off_sum = std::max(off_sum, std::abs(double(p.y) - (rise + g * h * h * n * (n + 1) / 2)));
            off_parabola = std::max(off_parabola, std::abs(double(p.y) - (rise + g * t * t / 2)));
            off_range = std::max(off_range, std::abs(double(p.x) - double(v.x) * t));
        }
        return {
            at_most("off v t along x (m)", off_range, 1e-3),
            at_most("off the sum that the substeps make (m)", off_sum, 1e-3),
            at_most("off the parabola (m), of which g t h / 2 is due", off_parabola, std::abs(g) * t * h / 2 + 1e-3),
        };
    };
    return scene;
}

Scene make_bounce() {
    constexpr int count = 11;
    constexpr float radius = 0.3f, height = 5;  // m
    Scene scene;
    scene.name = "bounce";
    scene.steps = 150;
    scene.view = {{-8, -1}, {8, 6.5f}};
    add_floor(scene, 10);
    for (int i = 0; i < count; ++i) {
        ShapeDef material;
        material.restitution = 0.1f * static_cast<float>(i);
        scene.traced.push_back(add_dynamic(scene, {1.3f * (static_cast<float>(i) - 5), height + radius}, Circle{{}, radius}, material));
    }

    // The height of each ball's first rebound: the highest it gets once it has turned upwards at the floor.
    struct Seen {
        std::array<bool, count> turned{};
        std::array<double, count> apex{};
    };
    const auto seen = std::make_shared<Seen>();
    scene.after_step = [seen](const Engine& engine, int step) {
        if (step == 0) *seen = {};
        for (std::size_t i = 0; i < count; ++i) {
            const BodyState ball = engine.body(i + 1);
            const double gap = double(ball.position.y) - double(radius);
            if (gap < 0.5 && ball.linear_velocity.y >= -0.01f) seen->turned[i] = true;
            if (seen->turned[i]) seen->apex[i] = std::max(seen->apex[i], gap);
        }
    };
    // A step knows the speed at its start only: at impact it is off by up to g dt. And the substeps' sum of a rise at speed v is v h / 2
    // below its parabola. Both are allowed for, and a centimetre.
    const double g = 10, speed = std::sqrt(2 * g * double(height)), off = g * double(scene.dt);
    const double h = double(scene.dt) / scene.world.solver.substeps;
    scene.check = [seen, g, speed, off, h](const Engine&) {
        std::vector<CheckLine> lines;
        for (std::size_t i = 0; i < count; ++i) {
            const double e = 0.1 * double(i), least = e * (speed - off), most = e * (speed + off);
            const std::string what = "rebound with e = " + std::to_string(i / 10) + "." + std::to_string(i % 10) + " from 5 m (m)";
            lines.push_back({what, seen->apex[i], least * least / (2 * g) - least * h / 2 - 0.01, most * most / (2 * g) + 0.01});
        }
        return lines;
    };
    return scene;
}

Scene make_newtons_cradle() {
    constexpr int row = 7;
    constexpr float radius = 0.5f, gap = 0.05f, speed = 2;  // m, m, m/s
    Scene scene;
    scene.name = "newtons_cradle";
    scene.steps = 130;
    scene.view = {{-8, -1.2f}, {8, 3}};
    ShapeDef smooth;
    smooth.friction = 0;
    add_floor(scene, 10, smooth);
    smooth.restitution = 1;
    BodyDef ball;
    ball.type = BodyType::dynamic;
    ball.position = {-6, radius};
    ball.linear_velocity = {speed, 0};
    const std::size_t striker = add_body(scene, ball, {{Circle{{}, radius}, smooth}});
    ball.linear_velocity = {};
    // The small gaps give each impact its own step: restitution is worked out pair by pair, not for a whole row at once.
    for (int i = 0; i < row; ++i) {
        ball.position.x = (2 * radius + gap) * (static_cast<float>(i) - 3);
        add_body(scene, ball, {{Circle{{}, radius}, smooth}});
    }
    scene.traced = {striker, scene.bodies.size() - 1};

    scene.check = [striker, last = scene.bodies.size() - 1](const Engine& engine) -> std::vector<CheckLine> {
        double others = 0, x = 0, y = 0;
        for (std::size_t i = striker; i < last; ++i) others = std::max(others, std::abs(double(engine.body(i).linear_velocity.x)));
        momentum(engine, x, y);
        const double mass = double(engine.body(striker).mass);
        return {
            near_line("speed of the last ball (m/s)", double(engine.body(last).linear_velocity.x), double(speed), 0.02 * double(speed)),
            at_most("fastest of the others (m/s)", others, 0.02 * double(speed)),
            near_line("momentum over its first value", x / (mass * double(speed)), 1, 1e-3),
            near_line("kinetic energy over its first value", kinetic_energy(engine) / (0.5 * mass * double(speed) * double(speed)), 1,
                      0.04),
        };
    };
    return scene;
}

}  // namespace islet::samples
