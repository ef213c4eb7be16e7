// Boxes on boxes: a tall stack, a heavy load, a row of dominoes.
#include <algorithm>
#include <array>
#include <memory>

#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {

Scene make_vertical_stack() {
    constexpr int count = 30;
    Scene scene = sleepless_scene("vertical_stack", 3600, {{-12, -1.5f}, {12, 31.5f}});
    add_floor(scene, 14);
    const std::size_t first = scene.bodies.size();
    for (int i = 0; i < count; ++i) add_dynamic(scene, {0, 0.5f + static_cast<float>(i)}, make_box(0.5f, 0.5f));

    // A soft contact gives way under its load: with k = m (2 pi f)^2, where m is the pair's reduced mass of 0.5 kg and f its 30 Hz, the
    // stack sinks by the sum of the loads over k, 0.25 m, and its lowest joints by 16 mm. Half as much again is allowed.
    const double f = double(scene.world.solver.contact_hertz), k = 0.5 * (2 * double(pi) * f) * (2 * double(pi) * f);
    const double give = 10.0 * (count - 1) / k, sink = give * count / 2;
    scene.check = [places = places_of(scene, first, scene.bodies.size()), first, give,
                   sink](const Engine& engine) -> std::vector<CheckLine> {
        const Drift all = drift_from(places, engine, first);
        return {
            at_most("farthest any box moved sideways in 60 s (m)", all.sideways, 0.05),
            at_most("farthest any box turned (rad)", all.turn, 0.01),
            at_most("top box sank (m)", all.sink, 1.5 * sink),
            at_most("deepest overlap (m)", engine.max_penetration(), 1.5 * give),
            at_most("fastest box (m/s)", max_speed(engine), 0.02),
        };
    };
    return scene;
}

Scene make_mass_ratio() {
    Scene scene = sleepless_scene("mass_ratio", 1200, {{-9, -1.5f}, {9, 6.5f}});
    add_floor(scene, 12);
    const std::size_t first = scene.bodies.size();

    // Left: a slab of 300 kg on three columns of two boxes of 1 kg.
    const Polygon box = make_box(0.5f, 0.5f);
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 3; ++column)
            add_dynamic(scene, {-5.5f + 1.5f * static_cast<float>(column), 0.5f + static_cast<float>(row)}, box);
    }
    ShapeDef slab;
    slab.density = 300.0f / 8;
    add_dynamic(scene, {-4, 3}, make_box(2, 1), slab);
    // Right: a pyramid whose top box weighs 300 kg.
    add_pyramid(scene, 5, 0.5f, 1.5f, 0);
    scene.bodies.back().shapes[0].def.density = 300;

    scene.check = [places = places_of(scene, first, scene.bodies.size()), first](const Engine& engine) -> std::vector<CheckLine> {
        const Drift all = drift_from(places, engine, first);
        return {
            at_most("farthest any box moved sideways in 20 s (m)", all.sideways, 0.05),
            at_most("farthest any box turned (rad)", all.turn, 0.05),
            at_most("farthest any box sank (m)", all.sink, 0.2),
            at_most("deepest overlap (m)", engine.max_penetration(), 0.1),
            at_most("fastest box (m/s)", max_speed(engine), 0.02),
        };
    };
    return scene;
}

Scene make_dominoes() {
    constexpr std::size_t count = 30;
    constexpr float half_height = 0.5f, half_width = 0.05f, spacing = 0.4f;  // m
    Scene scene;
    scene.name = "dominoes";
    scene.steps = 600;
    scene.view = {{-8.5f, -1}, {8, 3}};
    add_floor(scene, 14);
    BodyDef ball;
    ball.type = BodyType::dynamic;
    ball.position = {-7.5f, 0.3f};
    ball.linear_velocity = {2, 0};
    const std::size_t first = add_body(scene, ball, {{Circle{{}, 0.3f}, {}}}) + 1;
    scene.traced = {first - 1};
    BodyDef domino;
    domino.type = BodyType::dynamic;
    for (std::size_t i = 0; i < count; ++i) {
        domino.position = {spacing * (static_cast<float>(i) - 15), half_height};
        add_body(scene, domino, {{make_box(half_width, half_height), {}}});
    }

    // The step in which each has turned by half a radian, past all hope of standing up again.
    using Falls = std::array<int, count>;
    const auto falls = std::make_shared<Falls>();
    scene.after_step = [falls, first](const Engine& engine, int step) {
        if (step == 0) falls->fill(-1);
        for (std::size_t i = 0; i < count; ++i) {
            if ((*falls)[i] < 0 && engine.body(first + i).angle < -0.5f) (*falls)[i] = step;
        }
    };
    // In the end each leans on the next at asin(thickness / spacing) from flat, or a little more where the tops slid.
    scene.check = [falls, first](const Engine& engine) -> std::vector<CheckLine> {
        std::size_t fallen = 0, out_of_order = 0;
        double least = double(pi), fastest = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if ((*falls)[i] >= 0) ++fallen;
            if (i > 0 && (*falls)[i] < (*falls)[i - 1]) ++out_of_order;
            const BodyState state = engine.body(first + i);
            least = std::min(least, -double(state.angle));
            fastest = std::max(fastest, double(length(state.linear_velocity)));
        }
        return {
            near_line("dominoes fallen", double(fallen), double(count), 0),
            at_most("fell before the one behind", double(out_of_order), 0),
            {"least any turned (rad)", least, 1.1, 1.6},
            near_line("the last one turned (rad)", -double(engine.body(first + count - 1).angle), double(pi) / 2, 0.02),
            at_most("fastest domino (m/s)", fastest, 0.05),
        };
    };
    return scene;
}

}  // namespace islet::samples
