// A car: wheels on sprung struts, driven by a motor.
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

/// The road: flat, then waves, then flat again.
struct Road {
    static constexpr float start = -10, waves = 6, calm = 26, end = 60;  // m
    static constexpr float pitch = 0.25f, wave_length = 4, wave_height = 0.3f;

    static float height_at(float x) {
        if (x <= waves || x >= calm) return 0;
        return 0.5f * wave_height * (1 - make_rot(2 * pi * (x - waves) / wave_length).c);
    }
    static Chain chain() {
        Chain chain;
        for (float x = end; x >= start; x -= pitch) chain.points.push_back({x, height_at(x)});  // a floor runs from right to left
        return chain;
    }
    /// Length of its surface between two places.
    static double way(double from, double to) {
        constexpr double step = 0.01;
        double sum = 0;
        for (double x = from; x < to; x += step) {
            const double rise = double(height_at(static_cast<float>(x + step))) - double(height_at(static_cast<float>(x)));
            sum += std::sqrt(step * step + rise * rise);
        }
        return sum;
    }
};

/// A person drives: both wheels, twice as strong as what the script has. Without a button they roll.
void play_car(Engine& engine, std::size_t chassis, const std::array<std::size_t, 2>& struts, Controls& controls) {
    const float way = (controls.holds(1) ? 1.0f : 0.0f) - (controls.holds(0) ? 1.0f : 0.0f);
    for (const std::size_t strut : struts) engine.set_motor(strut, {.enable = way != 0, .speed = -15 * way, .max_force = 16});
    if (engine.body(chassis).position.x > controls.goal->x) controls.has_won = true;
}

}  // namespace

Scene make_car() {
    constexpr int drive_step = 120;
    constexpr float radius = 0.4f, rate = 10, torque = 8, hertz = 4;  // m, rad/s, N m, Hz
    Scene scene = sleepless_scene("car", 660, {{-4, -3}, {40, 7}});
    ShapeDef tarmac;
    tarmac.friction = 0.9f;
    add_body(scene, {}, {{Road::chain(), tarmac}});

    BodyDef def;
    def.type = BodyType::dynamic;
    def.position = {0, 1};
    const std::size_t chassis =
        add_body(scene, def, {{polygon_of({{-1.5f, -0.4f}, {1.5f, -0.4f}, {1.5f, 0}, {0.2f, 0.8f}, {-1.1f, 0.8f}, {-1.5f, 0.2f}}), {}}});
    std::size_t wheels[2], struts[2];
    const Vec2 hubs[] = {{-1, radius}, {1, radius}};
    for (std::size_t i = 0; i < 2; ++i) {
        wheels[i] = add_dynamic(scene, hubs[i], Circle{{}, radius}, tarmac);
        WheelJointDef strut = wheel_at(scene, chassis, wheels[i], hubs[i], {0, 1});
        strut.spring = {.enable = true, .hertz = hertz, .damping_ratio = 0.7f};
        strut.limit = {.enable = true, .lower = -0.25f, .upper = 0.25f};
        struts[i] = add_joint(scene, chassis, wheels[i], strut);
    }
    scene.traced = {chassis};
    scene.controls = std::make_shared<Controls>();
    scene.controls->buttons = {{"back", '<'}, {"forward", '>'}};
    scene.controls->goal = Vec2{Road::end - 4, 0.5f};
    scene.before_step = [chassis, struts = std::to_array(struts), controls = scene.controls](Engine& engine, int step) {
        if (controls->taken) return play_car(engine, chassis, struts, *controls);
        if (step == drive_step) engine.set_motor(struts[0], {.enable = true, .speed = -rate, .max_force = torque});
    };

    struct Seen {
        double compressed = 0, start = 0, turned = 0;
    };
    const auto seen = std::make_shared<Seen>();
    scene.after_step = [=, front = struts[1], wheel = wheels[1], dt = double(scene.dt)](const Engine& engine, int step) {
        if (step == 0) *seen = {};
        if (step + 1 == drive_step) {
            seen->compressed = double(engine.joint_position(front));
            seen->start = double(engine.body(wheel).position.x);
        }
        if (step >= drive_step) seen->turned -= dt * double(engine.body(wheel).angular_velocity);
    };
    // At rest a strut bears the chassis's weight by lever arms and gives way by load / (m w^2), m what the wheel and the chassis are at the strut
    // together. The front wheel rolls: radius times its turn is the way along the road.
    const double drive_time = double(scene.dt) * (scene.steps - drive_step);
    scene.check = [=, wheel = wheels[1]](const Engine& engine) -> std::vector<CheckLine> {
        const BodyState body = engine.body(chassis), rolling = engine.body(wheel);
        const double middle = double(engine.body(chassis).center.x - body.position.x);  // level by now
        const double arm = 1 - middle, omega = 2 * std::numbers::pi * double(hertz);
        const double load = 10 * double(body.mass) * (1 + middle) / 2;
        const double mass = 1 / (1 / double(rolling.mass) + 1 / double(body.mass) + arm * arm / double(body.inertia));
        const double way = Road::way(seen->start, double(rolling.position.x));
        return {
            near_line("the front strut gives way at rest (m)", seen->compressed, load / (mass * omega * omega),
                      0.1 * load / (mass * omega * omega)),
            near_line("way along the road, as the wheel turned (m)", double(radius) * seen->turned, way, 0.02 * way),
            near_line("speed on the flat (m/s)", double(body.linear_velocity.x), double(radius * rate), 0.02 * double(radius * rate)),
            // Less for setting off and for the waves' own way; they push as well as brake.
            {"distance in 9 s (m), of 36 at that speed", double(body.position.x), 0.9 * drive_time * double(radius * rate),
             1.03 * drive_time * double(radius * rate)},
            at_most("the chassis leans (rad)", std::abs(double(body.angle)), 0.1),
            at_most("farthest a wheel is off its strut (m)", double(engine.max_joint_error().linear), 0.01),
        };
    };
    return scene;
}

}  // namespace islet::samples
