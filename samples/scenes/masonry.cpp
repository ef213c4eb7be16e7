// What stands by balance and friction alone: a house of cards, an arch, cairns.
#include <algorithm>
#include <cmath>
#include <memory>

#include "build.hpp"
#include "harness/checks.hpp"
#include "random.hpp"
#include "scenes.hpp"

namespace islet::samples {

Scene make_card_house() { return make_card_house_of(5, 20 * pi / 180); }

Scene make_card_house_of(int storeys, float lean) {
    constexpr float half_length = 0.5f, half_thickness = 0.02f, pitch = 2 * half_length + 0.01f;
    Scene scene = sleepless_scene("card_house", 3600, {{-4, -0.7f}, {4, 5.5f}});
    ShapeDef paper;
    paper.friction = 0.7f;
    add_floor(scene, 6, paper);
    const std::size_t first = scene.bodies.size();
    const Polygon card = make_box(half_thickness, half_length), flat = make_box(half_length, half_thickness);

    // Two cards lean against each other at their inner top corners. Their outer ones, 2 t cos(lean) to each side, carry the next floor.
    const Rot q = make_rot(lean);
    const float aside = half_thickness * q.c + half_length * q.s, up = half_length * q.c + half_thickness * q.s;
    float bottom = 0;
    for (int storey = 0; storey < storeys; ++storey) {
        const int tents = storeys - storey;
        const float left = -0.5f * pitch * static_cast<float>(tents - 1);
        for (int i = 0; i < tents; ++i) {
            const float x = left + pitch * static_cast<float>(i);
            add_dynamic(scene, {x - aside, bottom + up}, card, paper, -lean);
            add_dynamic(scene, {x + aside, bottom + up}, card, paper, lean);
        }
        bottom += 2 * up;
        for (int i = 0; i + 1 < tents; ++i)
            add_dynamic(scene, {left + pitch * (static_cast<float>(i) + 0.5f), bottom + half_thickness}, flat, paper);
        bottom += 2 * half_thickness;
    }

    scene.check = [places = places_of(scene, first, scene.bodies.size()), first](const Engine& engine) -> std::vector<CheckLine> {
        const Drift all = drift_from(places, engine, first);
        return {
            at_most("farthest any card moved in 60 s (m)", all.distance, 0.08),
            at_most("farthest any card turned (rad)", all.turn, 0.05),
            at_most("deepest overlap (m)", engine.max_penetration(), 0.01),
            at_most("fastest card (m/s)", max_speed(engine), 0.02),
        };
    };
    return scene;
}

Scene make_arch() {
    constexpr int stones = 17;
    constexpr float inner = 4, outer = 5, footing = 1;  // m
    Scene scene = sleepless_scene("arch", 3600, {{-8, -1.2f}, {8, 7}});
    add_floor(scene, 12);
    for (const float side : {-1.0f, 1.0f})
        add_static(scene, {side * 0.5f * (inner + outer), 0.5f * footing}, make_box(0.7f, 0.5f * footing));

    // Wedges between radial joints: a half ring whose thickness is 0.22 of its mean radius, twice what a half circle needs to stand.
    const std::size_t first = scene.bodies.size();
    for (int i = 0; i < stones; ++i) {
        const Rot from = make_rot(pi * static_cast<float>(i) / stones), to = make_rot(pi * static_cast<float>(i + 1) / stones);
        const Vec2 corners[] = {
            {inner * from.c, inner * from.s}, {outer * from.c, outer * from.s}, {outer * to.c, outer * to.s}, {inner * to.c, inner * to.s}};
        const Vec2 middle = 0.25f * (corners[0] + corners[1] + corners[2] + corners[3]);
        const Polygon stone = polygon_of({corners[0] - middle, corners[1] - middle, corners[2] - middle, corners[3] - middle});
        add_dynamic(scene, middle + Vec2{0, footing}, stone);
    }

    scene.check = [places = places_of(scene, first, scene.bodies.size()), first](const Engine& engine) -> std::vector<CheckLine> {
        const Drift all = drift_from(places, engine, first);
        return {
            at_most("farthest any stone moved in 60 s (m)", all.distance, 0.08),
            at_most("farthest any stone turned (rad)", all.turn, 0.02),
            at_most("deepest overlap (m)", engine.max_penetration(), 0.01),
            at_most("fastest stone (m/s)", max_speed(engine), 0.01),
        };
    };
    return scene;
}

namespace {

/// A stone about w by h with a flattish top and bottom: six corners, every one of them a little off.
Polygon make_stone(Random& random, float w, float h) {
    const auto x = [&](float low, float high) { return 0.5f * w * random.uniform(low, high); };
    const auto y = [&](float y0) { return h * (y0 + random.uniform(-0.04f, 0.04f)); };
    const Vec2 corners[] = {{-x(0.6f, 0.85f), y(-0.5f)}, {x(0.6f, 0.85f), y(-0.5f)}, {x(0.95f, 1.05f), y(0.05f)},
                            {x(0.55f, 0.8f), y(0.5f)},   {-x(0.55f, 0.8f), y(0.5f)}, {-x(0.95f, 1.05f), y(-0.05f)}};
    return make_polygon(compute_hull(corners));
}

}  // namespace

Scene make_cairn() {
    constexpr int cairns = 5, stones = 7;
    constexpr int settled_step = 180;
    Scene scene = sleepless_scene("cairn", 1200, {{-8, -0.8f}, {8, 5.2f}});
    ShapeDef rock;
    rock.friction = 0.8f;
    rock.density = 2;
    add_floor(scene, 10, rock);
    Random random(2024);
    const std::size_t first = scene.bodies.size();
    for (int cairn = 0; cairn < cairns; ++cairn) {
        float bottom = 0;
        for (int i = 0; i < stones; ++i) {
            const float w = 2.2f - 0.22f * static_cast<float>(i), h = 0.75f - 0.06f * static_cast<float>(i);
            const float x = 3 * (static_cast<float>(cairn) - 2) + random.uniform(-0.03f, 0.03f);
            // Laid down, not dropped: a finger's breadth above the one below.
            add_dynamic(scene, {x, bottom + 0.54f * h + 0.01f}, make_stone(random, w, h), rock);
            bottom += 1.05f * h;
        }
    }

    const auto settled = std::make_shared<std::vector<BodyState>>();
    scene.after_step = [settled, first, end = scene.bodies.size()](const Engine& engine, int step) {
        if (step == settled_step) *settled = states_of(engine, first, end);
    };
    scene.check = [settled, first](const Engine& engine) -> std::vector<CheckLine> {
        std::size_t fallen = 0;
        for (std::size_t i = 0; i < std::size_t{cairns} * stones; ++i) {
            const bool lowest = i % stones == 0;
            if (!lowest && engine.body(first + i).position.y < engine.body(first + i - 1).position.y + 0.2f) ++fallen;
        }
        const Drift drift = drift_from(*settled, engine, first);
        return {
            at_most("stones fallen", double(fallen), 0),
            at_most("farthest any stone moved after the first 3 s (m)", drift.distance, 0.02),
            at_most("farthest any stone turned after that (rad)", drift.turn, 0.02),
            at_most("deepest overlap (m)", engine.max_penetration(), 0.01),
            at_most("fastest stone (m/s)", max_speed(engine), 0.02),
        };
    };
    return scene;
}

}  // namespace islet::samples
