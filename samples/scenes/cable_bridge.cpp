// A suspension bridge: a deck of planks on hangers from a cable between two towers, and a car that crosses it.
#include <algorithm>
#include <cmath>
#include <memory>

#include "build.hpp"
#include "harness/checks.hpp"
#include "prefabs/bridge.hpp"
#include "prefabs/car.hpp"
#include "prefabs/rope.hpp"
#include "prefab_scene.hpp"
#include "scenes.hpp"

namespace islet::samples {

Scene make_cable_bridge() {
    constexpr std::size_t planks = 20;             // and links of the cable
    constexpr float half_span = 10, tower = 4.5f;  // m; the tower's height above the deck
    constexpr int start_step = 300;                // by then the bridge has come to rest
    Scene scene;
    scene.name = "cable_bridge";
    scene.steps = 1000;
    scene.view = {{-16, -2.5f}, {16, 6}};
    make_stiff(scene);
    for (const float side : {-1.0f, 1.0f}) {
        add_static(scene, {side * (half_span + 4), -1.6f}, make_box(4, 1.6f));
        add_static(scene, {side * half_span, 0.5f * tower}, make_box(0.15f, 0.5f * tower), {.filter = {.mask = 0}});
    }

    // The deck is straight, so that it carries next to nothing by itself: the cable carries all of it.
    const BridgeDef deck_def = {
        .from = {-half_span, -0.1f}, .to = {half_span, -0.1f}, .slack = 1, .planks = planks, .density = 100, .hertz = 4};
    RopeDef cable_def = {.from = {-half_span, tower}, .to = {half_span, tower}, .slack = 1.06f, .links = planks, .radius = 0.06f};
    cable_def.density = 60;
    cable_def.damping = 0.5f;
    cable_def.group = 1;
    cable_def.hold_from = cable_def.hold_to = true;
    const Placed deck = add_prefab(scene, prefab_of(deck_def)), cable = add_prefab(scene, prefab_of(cable_def));
    // A hanger from each hinge of the cable to the hinge of the deck under it, as long as is right for a parabola of the cable's length, which is
    // span (1 + 8/3 (depth / span)^2). Hangers are ropes: they pull only.
    const float end = rope_end(cable_def).position.x, depth = 2 * half_span * std::sqrt((cable_def.slack - 1) * 3 / 8);
    for (std::size_t i = 0; i + 1 < planks; ++i) {
        const std::size_t link = cable.first_body + i, plank = deck.first_body + i;
        const BodyDef &above = scene.bodies[link].def, &below = scene.bodies[plank].def;
        const Vec2 hook = above.position + rotate(make_rot(above.angle), {end, 0});
        const Vec2 hold = below.position + rotate(make_rot(below.angle), {half_span / planks, 0});
        DistanceJointDef hanger = rope_between(scene, link, plank, hook, hold);
        const float x = hold.x / half_span;
        hanger.length = hanger.limit.upper = tower - depth * (1 - x * x) - hold.y;
        add_joint(scene, link, plank, hanger);
    }
    // Of the cable's group: it drives past the cable, not into it.
    const CarDef car_def = {.position = {-13.5f, 0}, .wheel_radius = 0.35f, .density = 30, .group = 1};
    const Placed car = add_prefab(scene, prefab_of(car_def));
    scene.traced = {car.first_body};

    // At rest: weight per metre, sag of the cable and pull in its middle.
    struct Rest {
        double sag = 0, pull = 0, weight = 0, deck_low = 0, speed = 0;
    };
    const auto rest = std::make_shared<Rest>();
    const std::size_t middle = planks / 2;
    scene.before_step = [=](Engine& engine, int step) {
        if (step == 0) *rest = {};
        const bool arrived = engine.body(car.first_body).position.x > half_span + 2;
        if (step > start_step && arrived) drive(engine, car, car_def, 0);
        if (step != start_step) return;
        rest->sag = double(tower - engine.body(cable.first_body + middle).position.y);
        rest->pull = std::abs(double(engine.joint_force(cable.first_joint + middle - 1).x));
        for (std::size_t i = 0; i < planks; ++i)
            rest->weight += 10 * double(engine.body(cable.first_body + i).mass + engine.body(deck.first_body + i).mass);
        rest->speed = max_speed(engine);
        drive(engine, car, car_def, 3);
    };
    scene.after_step = [=](const Engine& engine, int step) {
        const double low = double(engine.body(deck.first_body + middle).position.y);
        if (step == start_step) rest->deck_low = low;
        if (step > start_step) rest->deck_low = std::min(rest->deck_low, low);
    };
    scene.check = [=](const Engine& engine) -> std::vector<CheckLine> {
        // A cable that carries w per metre over the span L sags into a parabola of depth f and pulls with H = w L^2 / (8 f).
        const double span = 2 * double(half_span), due = rest->weight * span / (8 * rest->sag);
        const BodyState arrived = engine.body(car.first_body);
        return {
            at_most("fastest body before the car starts (m/s)", rest->speed, 0.05),
            {"sag of the cable (m)", rest->sag, 2, double(tower)},
            near_line("pull in its middle over w L^2 / 8 f", rest->pull / due, 1, 0.1),
            {"the car got to x (m)", double(arrived.position.x), double(half_span) + 1, double(half_span) + 8},
            at_most("the car leans (rad)", std::abs(double(arrived.angle)), 0.1),
            {"lowest the deck's middle was (m)", rest->deck_low, -1.5, 0},
            at_most("a joint came apart (m)", double(engine.max_joint_error().linear), 0.03),
        };
    };
    return scene;
}

}  // namespace islet::samples
