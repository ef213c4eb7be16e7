// The rest of the benchmark: worlds with the dimensions that Box2D 3 measures itself with, so that times can be put side by side.
#include <cmath>
#include <memory>

#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {
namespace {

/// A floor from -half to half with its boxes at y = 0 and two walls of `height` boxes, all of unit boxes that overlap their neighbours.
void add_trough(Scene& scene, int half, int height, std::vector<SceneShape> more) {
    std::vector<SceneShape> shapes;
    for (int i = -half; i <= half; ++i) { shapes.push_back({make_offset_box(0.55f, 0.5f, {{static_cast<float>(i), 0}, {}}), {}}); }
    for (const int side : {-half, half}) {
        for (int i = 1; i <= height; ++i) {
            shapes.push_back({make_offset_box(0.5f, 0.55f, {{static_cast<float>(side), static_cast<float>(i)}, {}}), {}});
        }
    }
    shapes.insert(shapes.end(), more.begin(), more.end());
    add_body(scene, {}, std::move(shapes));
}

/// The drum of the washer: a ring of 36 wall pieces, each a little wider than its share, and a paddle at every ninth.
std::vector<SceneShape> make_drum() {
    constexpr int pieces = 36;
    constexpr float paddle_tip = 14, inner = 16, outer = 18;  // m
    const float share = pi / 18;
    const Rot step = make_rot(share), overlap = make_rot(0.1f * share);
    const auto piece = [](float r1, float r2, Vec2 from, Vec2 to) { return polygon_of({r1 * from, r2 * from, r1 * to, r2 * to}); };

    std::vector<SceneShape> shapes;
    Vec2 from = {1, 0};
    for (int i = 0; i < pieces; ++i) {
        const Vec2 to = i == pieces - 1 ? Vec2{1, 0} : rotate(step, from);
        shapes.push_back({piece(inner, outer, inv_rotate(overlap, from), rotate(overlap, to)), {}});
        if (i % 9 == 0) shapes.push_back({piece(paddle_tip, inner, from, to), {}});
        from = to;
    }
    return shapes;
}

}  // namespace

Scene make_washer() {
    constexpr int count = 90;
    constexpr float half = 0.1f;
    Scene scene;
    scene.name = "washer";
    scene.steps = 500;
    scene.view = {{-20, -10}, {20, 30}};
    add_body(scene, {}, {});

    BodyDef drum;
    drum.type = BodyType::kinematic;
    drum.position = {0, 10};
    drum.angular_velocity = 25 * pi / 180;
    drum.linear_velocity = {0.001f, -0.002f};
    const std::size_t drum_index = add_body(scene, drum, make_drum());

    const Polygon box = make_box(half, half);
    for (int row = 0; row < count; ++row) {
        for (int column = 0; column < count; ++column) {
            const float x = -1.1f * half * count + 2.1f * half * static_cast<float>(column);
            const float y = -1.1f * half * count + 10 + 2.1f * half * static_cast<float>(row);
            add_dynamic(scene, {x, y}, box);
        }
    }

    scene.check = [drum_index, drum, time = double(scene.steps) * double(scene.dt)](const Engine& engine) {
        const BodyState state = engine.body(drum_index);
        double farthest = 0;
        for (std::size_t i = drum_index + 1; i < engine.body_slots(); ++i) {
            const Vec2 p = engine.body(i).position;
            farthest = std::max(farthest, std::hypot(double(p.x - state.position.x), double(p.y - state.position.y)));
        }
        std::vector<CheckLine> lines = count_lines(engine, 8102, 8140, 29669);
        lines.push_back(at_most("farthest box from the drum's middle (m)", farthest, 16));
        lines.push_back(at_most("drum is off its angle (rad)",
                                std::abs(angle_difference(double(state.angle), double(drum.angular_velocity) * time)), 1e-3));
        lines.push_back(at_most("deepest overlap (m)", engine.max_penetration(), 2 * double(half)));
        lines.push_back(at_most("fastest box (m/s)", max_speed(engine), 25));
        return lines;
    };
    return scene;
}

Scene make_smash() {
    constexpr int columns = 120, rows = 80;
    constexpr float size = 0.4f;
    Scene scene;
    scene.name = "smash";
    scene.world.gravity = {0, 0};
    scene.steps = 300;
    scene.view = {{-10, -65}, {190, 65}};

    BodyDef hammer;
    hammer.type = BodyType::dynamic;
    hammer.position = {-20, 0};
    hammer.linear_velocity = {40, 0};
    ShapeDef heavy;
    heavy.density = 8;
    add_body(scene, hammer, {{make_box(4, 4), heavy}});

    BodyDef brick;
    brick.type = BodyType::dynamic;
    brick.awake = false;
    const Polygon box = make_box(0.5f * size, 0.5f * size);
    for (int column = 0; column < columns; ++column) {
        for (int row = 0; row < rows; ++row) {
            brick.position = {static_cast<float>(column) * size + 30, (static_cast<float>(row) - 0.5f * rows) * size};
            add_body(scene, brick, {{box, {}}});
        }
    }

    scene.check = [](const Engine& engine) {
        constexpr double mass = 8 * 8 * 8, speed = 40;
        double x = 0, y = 0;
        momentum(engine, x, y);
        std::vector<CheckLine> lines = count_lines(engine, 9601, 9601, 6296);
        lines.push_back(near_line("momentum along x (kg m/s)", x, mass * speed, 1e-3 * mass * speed));
        lines.push_back(near_line("momentum along y (kg m/s)", y, 0, 1e-3 * mass * speed));
        lines.push_back(at_most("kinetic energy left (J), of 409600", kinetic_energy(engine), 0.5 * mass * speed * speed));
        lines.push_back(at_most("deepest overlap (m)", engine.max_penetration(), 0.2));
        return lines;
    };
    return scene;
}

Scene make_compounds() {
    constexpr int columns = 20, rows = 150;
    constexpr float pitch = 2, gap = 0.25f;
    Scene scene;
    scene.name = "compounds";
    scene.steps = 500;
    scene.view = {{-46, -4}, {46, 106}};
    add_trough(scene, 40, 100, {{Segment{{-800, -80}, {800, -80}}, {}}});

    ShapeDef material;
    material.friction = 0.5f;
    const std::vector<SceneShape> triangles = {
        {polygon_of({{-1, 0}, {0.5f, 1}, {0, 2}}), material},
        {polygon_of({{1, 0}, {-0.5f, 1}, {0, 2}}), material},
    };
    BodyDef body;
    body.type = BodyType::dynamic;
    float side = 0.25f;
    for (int column = 0; column < columns; ++column) {
        const float x = static_cast<float>(column) * pitch - (0.5f * pitch * columns - 1);
        for (int row = 0; row < rows; ++row) {
            body.position = {x + side, static_cast<float>(row) * (pitch + gap) + 0.575f + 5};
            side = -side;
            add_body(scene, body, triangles);
        }
    }

    scene.check = [](const Engine& engine) {
        std::vector<CheckLine> lines = count_lines(engine, 3001, 6282, 26221);
        lines.push_back(at_most("bodies outside the trough", double(count_outside(engine, {{-40, 0}, {40, 400}})), 0));
        // The triangles are 2 m long; where the pile is hit at 50 m/s they overlap by up to half of that for a while.
        lines.push_back(at_most("deepest overlap (m)", engine.max_penetration(), 1.5));
        lines.push_back(at_most("fastest body (m/s)", max_speed(engine), 60));
        return lines;
    };
    return scene;
}

Scene make_junkyard() {
    constexpr int columns = 200, rows = 40, corners = 5;
    constexpr float radius = 0.25f, reach = 60, rate = 0.2f;  // m, m, rad/s of the pusher's swing
    Scene scene;
    scene.name = "junkyard";
    scene.steps = 800;
    scene.view = {{-84, -3}, {84, 32}};
    add_trough(scene, 80, 50, {});

    // Five points on a circle, each the golden angle further than the last: an irregular pentagon.
    const float golden = pi * (std::sqrt(5.0f) - 1);
    Vec2 points[corners];
    for (int i = 0; i < corners; ++i) {
        const Rot q = make_rot(golden * static_cast<float>(i));
        points[i] = {radius * q.c, radius * q.s};
    }
    const Polygon pentagon = make_polygon(compute_hull(points));

    float side = -0.1f;
    for (int column = 0; column < columns; ++column) {
        const float x = 1.5f * static_cast<float>(2 * column - columns) * radius;
        for (int row = 0; row < rows; ++row) {
            add_dynamic(scene, {x + side, 4 * static_cast<float>(row) * radius + 15}, pentagon);
            side = -side;
        }
    }

    BodyDef def;
    def.type = BodyType::kinematic;
    const std::size_t pusher = add_body(scene, def, {{make_offset_box(2, 4, {{0, 4}, {}}), {}}});
    // Aim each step at where the pusher ought to be at its end.
    scene.before_step = [pusher, dt = scene.dt](Engine& engine, int step) {
        const float target = reach * make_rot(rate * dt * static_cast<float>(step)).s;
        engine.set_velocity(pusher, {(target - engine.body(pusher).position.x) / dt, 0}, 0);
    };

    scene.check = [pusher, last = rate * scene.dt * static_cast<float>(scene.steps - 1)](const Engine& engine) {
        const double target = double(reach) * std::sin(double(last));
        std::vector<CheckLine> lines = count_lines(engine, 8002, 8262, 24341);
        lines.push_back(near_line("pusher's place (m)", double(engine.body(pusher).position.x), target, 0.01));
        lines.push_back(at_most("bodies outside the yard", double(count_outside(engine, {{-80, 0}, {80, 80}})), 0));
        lines.push_back(at_most("deepest overlap (m)", engine.max_penetration(), 2 * double(radius)));
        lines.push_back(at_most("fastest body (m/s)", max_speed(engine), 40));
        return lines;
    };
    return scene;
}

}  // namespace islet::samples
