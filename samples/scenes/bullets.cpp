// Fast things and thin walls.
#include <cmath>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {
namespace gallery {
namespace {

constexpr int shots = 48;
constexpr float right = 4, left = -right, high = 4, wall = 1.5f;  // m: a room, and where in it the wall stands
constexpr float half = 0.01f;                                    // m, of the thickness of whatever is to keep shots out
constexpr float muzzle = -3.8f;                                  // m

/// Shot number i: a ball, a rod or a die of 4 to 8 cm, at 100 to 900 m/s, turning. They come from all heights, so that each hits another spot.
SceneBody shot(int i) {
    SceneBody body;
    body.def.type = BodyType::dynamic;
    body.def.position = {muzzle, 0.25f + 0.076f * static_cast<float>(i * 19 % shots)};
    body.def.linear_velocity = {100 + 17 * static_cast<float>(i), 0};
    body.def.angular_velocity = static_cast<float>(i % 7) * 15 - 45;
    body.def.bullet = true;
    ShapeDef lead;
    lead.friction = 0.4f;
    lead.restitution = 0.3f;
    lead.rolling_resistance = 0.1f;
    lead.density = 10;
    const float size = 0.02f + 0.005f * static_cast<float>(i % 5);
    switch (i % 3) {
    case 0: body.shapes = {{Circle{{}, size}, lead}}; break;
    case 1: body.shapes = {{Capsule{{-size, 0}, {size, 0}, 0.5f * size}, lead}}; break;
    default: body.shapes = {{make_box(size, size), lead}}; break;
    }
    return body;
}

/// Four walls around an empty inside of that middle and half size.
std::vector<SceneShape> shell(Vec2 middle, float half_width, float half_height) {
    ShapeDef steel;
    steel.density = 500;
    std::vector<SceneShape> walls;
    for (const float side : {-1.0f, 1.0f}) {
        walls.push_back({make_offset_box(half_width + 2 * half, half, {middle + Vec2{0, side * (half_height + half)}, {}}), steel});
        walls.push_back({make_offset_box(half, half_height, {middle + Vec2{side * (half_width + half), 0}, {}}), steel});
    }
    return walls;
}

// Shots at a wall of 2 cm, behind which a pyramid stands, and at a box of such walls, which is free to move and in which a ball lies. The fastest cross the
// room twice over in one step.
Scene make() {
    constexpr float chest_wide = 0.5f, chest_high = 0.4f, chest_at = -0.6f;  // m, halves of its inside; where it stands, on a table
    constexpr float table_high = 1.2f, table_wide = 0.7f;                    // m, half its width
    constexpr int rows = 6;
    Scene scene;
    scene.name = "bullets";
    scene.steps = 360;
    scene.view = {{-4.2f, -0.25f}, {4.2f, 4.2f}};
    scene.world.max_speed = 1000;
    std::vector<SceneShape> room = shell({0, 0.5f * high}, right, 0.5f * high);
    room.push_back({make_offset_box(half, 0.5f * high, {{wall + half, 0.5f * high}, {}}), {}});
    room.push_back({make_offset_box(table_wide, 0.5f * table_high, {{chest_at, 0.5f * table_high}, {}}), {}});
    add_body(scene, {}, std::move(room));
    BodyDef def;
    def.type = BodyType::dynamic;
    def.position = {chest_at, table_high + 2 * half + chest_high};
    const std::size_t chest = add_body(scene, def, shell({}, chest_wide, chest_high));
    const std::size_t kept = add_dynamic(scene, {chest_at, table_high + 2 * half + 0.15f}, Circle{{}, 0.15f});
    const std::size_t pyramid = add_pyramid(scene, rows, 0.17f, wall + 0.2f, 0);
    const std::size_t first = scene.bodies.size();
    scene.extra_bodies = scene.extra_shapes = shots;
    scene.extra_contacts = 400;
    // A few fly when the scene begins, and leave their paths in the picture; then comes one every four steps.
    constexpr int tracers = 3, pause = 24, between = 4;
    for (int i = 0; i < tracers; ++i) {
        scene.traced.push_back(scene.bodies.size());
        scene.bodies.push_back(shot(i));
    }
    scene.before_step = [](Engine& engine, int step) {
        const int i = tracers + (step - pause) / between;
        if (step >= pause && step % between == 0 && i < shots) engine.create_body(shot(i));
    };

    const auto struck = std::make_shared<std::set<std::size_t>>();  // those seen at the wall or at the chest, or on their way back after a step
    const auto in_chest = [chest](const Engine& engine, std::size_t body) {
        const BodyState box = engine.body(chest);
        const Vec2 p = inv_transform_point({box.position, make_rot(box.angle)}, engine.body(body).position);
        return std::abs(p.x) < chest_wide && std::abs(p.y) < chest_high;
    };
    scene.after_step = [=](const Engine& engine, int step) {
        if (step == 0) struck->clear();
        for (std::size_t i = first; i < engine.body_slots(); ++i) {
            const BodyState seen = engine.body(i);
            if (seen.position.x > chest_at - table_wide - 0.15f || seen.linear_velocity.x < 0) struck->insert(i);
        }
    };
    scene.check = [=, before = places_of(scene, pyramid, first)](const Engine& engine) -> std::vector<CheckLine> {
        double through = 0, outside = 0, inside = 0;
        for (std::size_t i = first; i < engine.body_slots(); ++i) {
            const Vec2 p = engine.body(i).position;
            if (p.x > wall) ++through;
            if (!(p.x > left && p.x < right && p.y > 0 && p.y < high)) ++outside;
            if (in_chest(engine, i)) ++inside;
        }
        return {
            near_line("shots fired", static_cast<double>(engine.body_slots() - first), shots, 0),
            near_line("shots that came to the wall, the chest or its table, or were thrown back", static_cast<double>(struck->size()), shots, 0),
            at_most("shots through the wall", through, 0),
            at_most("shots out of the room", outside, 0),
            at_most("shots in the chest", inside, 0),
            near_line("balls kept in it", in_chest(engine, kept) ? 1 : 0, 1, 0),
            at_most("the pyramid behind the wall moved (m)", drift_from(before, engine, pyramid).distance, 0.005),
        };
    };
    return scene;
}

}  // namespace
}  // namespace gallery

Scene make_bullets() { return gallery::make(); }

}  // namespace islet::samples
