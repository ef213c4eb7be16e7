// Where bodies meet others that stand: walls, corners, grooves, floors of many pieces. How deep they go is worked out from their shapes.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "build.hpp"
#include "harness/checks.hpp"
#include "harness/overlap.hpp"
#include "random.hpp"
#include "steady.hpp"

namespace islet::samples {
namespace {

constexpr double unseen = 0.01;  // m, of overlap that nobody sees: twice the slop that contacts keep
constexpr double slop = 0.005;   // m

ShapeDef rough(float friction) {
    ShapeDef def;
    def.friction = friction;
    return def;
}

/// Where the lowest point of a body's shapes is, m.
double lowest_point(const SceneBody& body, const BodyState& state) {
    const Transform pose = {state.position, make_rot(state.angle)};
    double low = 1e9;
    const auto see = [&](Vec2 p, float radius) { low = std::min(low, double(transform_point(pose, p).y) - double(radius)); };
    for (const SceneShape& shape : body.shapes) {
        if (const auto* circle = std::get_if<Circle>(&shape.geometry)) see(circle->center, circle->radius);
        if (const auto* polygon = std::get_if<Polygon>(&shape.geometry))
            for (std::uint32_t i = 0; i < polygon->count; ++i) see(polygon->vertices[i], polygon->radius);
    }
    return low;
}

}  // namespace

// -- corners ---------------------------------------------------------------------------------------------------------------------

Scene make_wedge_at_wall(int start) {
    static constexpr float heights[] = {1, 2, 3.46f}, intos[] = {0, 0.01f, 0.5f, 2};  // m: of the wedge; of the wall into the floor
    constexpr int looked_from = 240;
    const float height = heights[start % 3], into = intos[start % 4], pull = start >= 12 ? 10.0f : 0.0f;
    Scene scene = sleepless_scene("wedge_at_wall", 480, {{-4, -2}, {9, 6}});
    scene.world.gravity = {pull, -10};
    const ShapeDef material = rough(0.3f);
    add_static(scene, {0, -1}, make_box(20, 1), material);
    const float half = 0.5f * (4 + into);
    add_static(scene, {6, 4 - half}, make_box(1, half), material);
    const std::size_t wedge = add_dynamic(scene, {2 - 0.04f * static_cast<float>(start), 0}, polygon_of({{-1, 0}, {1, 0}, {-1, height}}), material);
    scene.bodies[wedge].def.linear_velocity = {5, 0};

    // With the pull it hits the wall faster than at 5 m/s: then what counts is how deep it stays.
    const auto deepest = std::make_shared<double>();
    scene.after_step = [deepest, pull, polygons = polygons_in(scene)](const Engine& engine, int step) {
        if (step == 0) *deepest = 0;
        if (pull == 0 || step >= looked_from) *deepest = std::max(*deepest, deepest_overlap(polygons, engine));
    };
    scene.check = [deepest](const Engine& engine) -> std::vector<CheckLine> {
        return {
            wanted_line("deepest overlap of wedge, floor and wall (m)", *deepest, unseen),
            at_most("speed in the end (m/s)", max_speed(engine), 0.5),
        };
    };
    return scene;
}

Scene make_v_grooves(int start) {
    struct Groove {
        float degrees, friction;
    };
    static constexpr Groove grooves[] = {{30, 0}, {30, 0.05f}, {30, 0.1f}, {40, 0}, {40, 0.1f}, {40, 0.3f}};
    constexpr int looked_from = 1200;
    Scene scene = sleepless_scene("v_grooves", 1500, {{-22, -3}, {22, 12}});
    std::vector<std::size_t> squares;
    for (std::size_t i = 0; i < std::size(grooves); ++i) {
        const Vec2 bottom = {14 * (static_cast<float>(i % 3) - 1), 7 * static_cast<float>(i / 3)};
        const ShapeDef material = rough(grooves[i].friction);
        const float angle = grooves[i].degrees * pi / 180;
        const Rot q = make_rot(angle);
        // Both planks go a metre past the bottom.
        for (const float side : {1.0f, -1.0f})
            add_static(scene, bottom + Vec2{side * (3 * q.c + 0.5f * q.s), 3 * q.s - 0.5f * q.c}, make_box(4, 0.5f), material, side * angle);
        squares.push_back(
            add_dynamic(scene, bottom + Vec2{0.05f * static_cast<float>(start - 4), 2.2f}, make_box(0.5f, 0.5f), material, 0.15f * static_cast<float>(start)));
    }

    const auto deepest = std::make_shared<double>();
    scene.after_step = [deepest, polygons = polygons_in(scene)](const Engine& engine, int step) {
        if (step == 0) *deepest = 0;
        if (step >= looked_from) *deepest = std::max(*deepest, deepest_overlap(polygons, engine));
    };
    scene.check = [deepest, squares](const Engine& engine) -> std::vector<CheckLine> {
        double rough_speed = 0, smooth_speed = 0;
        for (std::size_t i = 0; i < squares.size(); ++i) {
            double& speed = grooves[i].friction > 0 ? rough_speed : smooth_speed;
            speed = std::max(speed, double(length(engine.body(squares[i]).linear_velocity)));
        }
        return {
            wanted_line("deepest overlap of square and groove, 20 to 25 s (m)", *deepest, unseen),
            wanted_line("speed after 25 s, friction 0.05 to 0.3 (m/s)", rough_speed, 0.01),
            wanted_line("speed after 25 s without friction (m/s)", smooth_speed, 0.01, 0.5),  // nothing stops its rocking but impacts
        };
    };
    return scene;
}

namespace {

/// A convex polygon of so many corners, at most 0.8 m across.
Polygon random_polygon(Random& random, int corners) {
    for (;;) {
        const float radius = random.uniform(0.15f, 0.4f);
        std::array<Vec2, 8> points;
        for (int i = 0; i < corners; ++i) {
            const Rot q = make_rot(2 * pi * (static_cast<float>(i) + random.uniform(-0.4f, 0.4f)) / static_cast<float>(corners));
            points[static_cast<std::size_t>(i)] = radius * random.uniform(0.7f, 1) * Vec2{q.c, q.s};
        }
        const Polygon polygon = make_polygon(compute_hull({points.data(), static_cast<std::size_t>(corners)}));
        if (polygon.count == static_cast<std::uint32_t>(corners)) return polygon;
    }
}

}  // namespace

Scene make_crossing_walls(int start) {
    constexpr int triangles = 8, looked_from = 300;
    Scene scene = sleepless_scene("crossing_walls", 420, {{-2.8f, -2.1f}, {2.8f, 2.1f}});
    Random random(static_cast<std::uint64_t>(start));
    const ShapeDef material = rough(random.uniform(0, 0.6f));
    for (const float side : {-1.0f, 1.0f}) {
        add_static(scene, {side * 2, 0}, make_box(0.01f, 1.5f + random.uniform(0.01f, 0.2f)), material);
        add_static(scene, {0, side * 1.5f}, make_box(2 + random.uniform(0.01f, 0.2f), 0.01f), material);
    }
    const std::size_t first = scene.bodies.size();
    for (int i = 0; i < triangles; ++i) {
        const Polygon triangle = random_polygon(random, 3);
        BodyDef def;
        def.type = BodyType::dynamic;
        def.position.x = random.uniform(-1.4f, 1.4f);
        def.position.y = random.uniform(-0.9f, 0.9f);
        def.angle = random.uniform(-pi, pi);
        def.linear_velocity.x = random.uniform(-5, 5);
        def.linear_velocity.y = random.uniform(-5, 5);
        def.angular_velocity = random.uniform(-5, 5);
        add_body(scene, def, {{triangle, material}});
    }

    // Walls and triangles: how deep triangles are in each other is another matter.
    const auto deepest = std::make_shared<double>();
    scene.after_step = [deepest, first, polygons = polygons_in(scene)](const Engine& engine, int step) {
        if (step == 0) *deepest = 0;
        if (step < looked_from) return;
        for (const Overlap& overlap : overlaps_of(polygons, engine, *deepest))
            if (std::min(overlap.body_a, overlap.body_b) < first) *deepest = std::max(*deepest, overlap.depth);
    };
    scene.check = [deepest, first](const Engine& engine) -> std::vector<CheckLine> {
        bool is_outside = false;
        for (std::size_t i = first; i < engine.body_slots(); ++i) {
            const Vec2 at = engine.body(i).center;
            is_outside = is_outside || !(std::abs(at.x) < 2 && std::abs(at.y) < 1.5f);
        }
        return {
            wanted_none("rooms that a triangle left", is_outside),
            wanted_none("rooms with a triangle 5 cm deep in a wall after 5 s", *deepest > 0.05),
        };
    };
    return scene;
}

// -- landing ---------------------------------------------------------------------------------------------------------------------

namespace {

Polygon regular(int corners, float radius) {
    std::array<Vec2, 8> points;
    for (int i = 0; i < corners; ++i) {
        const Rot q = make_rot(2 * pi * static_cast<float>(i) / static_cast<float>(corners));
        points[static_cast<std::size_t>(i)] = {radius * q.c, radius * q.s};
    }
    return make_polygon(compute_hull({points.data(), static_cast<std::size_t>(corners)}));
}

}  // namespace

Scene make_landings(int start) {
    constexpr float pitch = 6, lift_speed = 2;  // m, m/s
    Scene scene = sleepless_scene("landings", 240, {{-24, -2}, {24, 22}});
    BodyDef lift_def;
    lift_def.type = BodyType::kinematic;
    lift_def.linear_velocity = {0, lift_speed};
    // The last one falls on a lift that rises beside the ground. The first falls flat, the last every second time, the others as they come.
    const SceneGeometry things[] = {make_box(0.5f, 0.5f), make_box(0.5f, 0.5f), make_box(1, 0.05f),  regular(3, 0.5f),
                                    regular(8, 0.5f),     Circle{{}, 0.5f},     make_box(0.5f, 0.5f)};
    constexpr std::size_t count = std::size(things);
    add_static(scene, {-14, -1}, make_box(28, 1));
    struct Fall {
        std::size_t body, floor;
    };
    std::vector<Fall> falls;
    for (std::size_t i = 0; i < count; ++i) {
        const auto n = static_cast<float>(7 * start + static_cast<int>(i));
        const float height = 1 + 19 * std::fmod(n * 0.618034f, 1.0f), x = pitch * (static_cast<float>(i) - 3);
        const bool flat = i == 0 || (i == count - 1 && start % 2 == 0);
        const float angle = flat ? 0 : 0.5f * pi * std::fmod(n * 0.7548777f, 1.0f);
        std::size_t floor = 0;
        if (i + 1 == count) {
            lift_def.position = {x, -5};
            floor = add_body(scene, lift_def, {{make_box(2, 0.5f), {}}});
        }
        const std::size_t body = add_dynamic(scene, {x, 0}, things[i], {}, angle);
        BodyState pose;
        pose.position = {x, 0};
        pose.angle = angle;
        scene.bodies[body].def.position.y = height - static_cast<float>(lowest_point(scene.bodies[body], pose));
        if (i % 3 == 2) scene.bodies[body].def.angular_velocity = 10 * (std::fmod(n * 0.5698403f, 1.0f) - 0.5f);
        falls.push_back({body, floor});
        scene.traced.push_back(body);
    }

    const auto sunk = std::make_shared<std::array<double, 2>>();
    scene.after_step = [sunk, falls, bodies = scene.bodies](const Engine& engine, int step) {
        if (step == 0) *sunk = {};
        for (const Fall& fall : falls) {
            const BodyState state = engine.body(fall.body), floor = engine.body(fall.floor);
            const double top = fall.floor == 0 ? 0 : double(floor.position.y) + 0.5;
            if (fall.floor != 0 && std::abs(state.position.x - floor.position.x) > 1.2f) continue;
            double& deepest = (*sunk)[fall.floor == 0 ? 0 : 1];
            deepest = std::max(deepest, top - lowest_point(bodies[fall.body], state));
        }
    };
    scene.check = [sunk](const Engine&) -> std::vector<CheckLine> {
        return {
            wanted_line("deepest sink into the ground, fallen 1 to 20 m (m)", (*sunk)[0], slop),
            wanted_line("deepest sink into a floor that rises at 2 m/s (m)", (*sunk)[1], slop, 0.01),
        };
    };
    return scene;
}

Scene make_plates_at_walls(int start) {
    constexpr float half_thickness = 0.05f;
    static constexpr float speeds[] = {120, 300};  // m/s
    Scene scene = sleepless_scene("plates_at_walls", 40, {{-8, -3}, {3, 6}});
    scene.world.gravity = {0, 0};
    std::array<std::size_t, 2> plates{};
    for (std::size_t i = 0; i < 2; ++i) {
        const float y = 3 * static_cast<float>(i);
        add_static(scene, {1, y}, make_box(1, 1.4f));
        plates[i] = add_dynamic(scene, {-7 - speeds[i] / 60 * static_cast<float>(start) / 16, y}, make_box(half_thickness, 1));
        scene.bodies[plates[i]].def.linear_velocity = {speeds[i], 0};
    }
    struct Seen {
        std::array<double, 2> nearest{}, first{};
        std::array<bool, 2> stopped{};
    };
    const auto seen = std::make_shared<Seen>();
    scene.after_step = [seen, plates](const Engine& engine, int step) {
        if (step == 0) *seen = {{-10, -10}, {}, {}};
        for (std::size_t i = 0; i < 2; ++i) {
            const BodyState plate = engine.body(plates[i]);
            const double face = double(plate.position.x) + double(half_thickness);  // the wall's is at 0
            seen->nearest[i] = std::max(seen->nearest[i], face);
            if (!seen->stopped[i] && plate.linear_velocity.x < 5) {
                seen->stopped[i] = true;
                seen->first[i] = face;
            }
        }
    };
    scene.check = [seen](const Engine&) {
        std::vector<CheckLine> lines;
        for (std::size_t i = 0; i < 2; ++i) {
            const std::string speed = "at " + std::to_string(int(speeds[i])) + " m/s ";
            lines.push_back(wanted_line(speed + "the plate stops so far from the face (m)", std::abs(seen->first[i]), slop));
            lines.push_back(wanted_line(speed + "it is so far from it at the nearest (m)", std::abs(seen->nearest[i]), slop));
        }
        return lines;
    };
    return scene;
}

// -- floors of pieces ------------------------------------------------------------------------------------------------------------

namespace {

/// What slides along y = 0 after a second in which it settles, and what is asked of it: nothing slows it down or lifts it.
void ask_for_smooth_ride(Scene& scene, std::size_t slider, float speed, double lost, double lifted) {
    constexpr int settled = 60;
    struct Seen {
        double height = 0, lifted = 0;
    };
    const auto seen = std::make_shared<Seen>();
    scene.traced = {slider};
    scene.before_step = [slider, speed](Engine& engine, int step) {
        if (step == settled) engine.set_velocity(slider, {speed, 0}, 0);
    };
    scene.after_step = [seen, slider](const Engine& engine, int step) {
        const double y = double(engine.body(slider).position.y);
        if (step + 1 == settled) *seen = {y, 0};
        if (step >= settled) seen->lifted = std::max(seen->lifted, std::abs(y - seen->height));
    };
    const std::string at = " at " + std::to_string(int(speed)) + " m/s";
    scene.check = [=](const Engine& engine) -> std::vector<CheckLine> {
        const double now = double(engine.body(slider).linear_velocity.x);
        return {
            wanted_line("speed lost over the seams" + at + " (of it)", std::abs(1 - now / double(speed)), lost),
            wanted_line("farthest up or down" + at + " (m)", seen->lifted, lifted),
        };
    };
}

}  // namespace

Scene make_laid_segments(int start) {
    constexpr float speed = 20, length = 95, radius = 0.25f;
    Scene scene = sleepless_scene("laid_segments", 60 + 240, {{-5, -20}, {95, 30}});
    const ShapeDef smooth = rough(0);
    for (float x = -4; x < length; x += 1) {
        const bool turned = static_cast<int>(x) % 2 == 0;  // from which end a segment is drawn is nothing
        add_body(scene, {}, {{turned ? Segment{{x, 0}, {x + 1, 0}} : Segment{{x + 1, 0}, {x, 0}}, smooth}});
    }
    const std::size_t ball = add_dynamic(scene, {0.097f * static_cast<float>(start), radius}, Circle{{}, radius}, smooth);
    ask_for_smooth_ride(scene, ball, speed, 0.001, 0.002);
    return scene;
}

Scene make_tiled_floor(int start) {
    constexpr float speed = 50, half = 0.25f;
    constexpr int length = 210;
    Scene scene = sleepless_scene("tiled_floor", 60 + 240, {{-5, -45}, {215, 65}});
    const ShapeDef smooth = rough(0);
    for (int i = -4; i < length; ++i) add_static(scene, {static_cast<float>(i) + 0.5f, -0.5f}, make_box(0.5f, 0.5f), smooth);
    const std::size_t box = add_dynamic(scene, {0.097f * static_cast<float>(start), half}, make_box(half, half), smooth);
    ask_for_smooth_ride(scene, box, speed, 0.001, 0.001);
    return scene;
}

// -- collisions ------------------------------------------------------------------------------------------------------------------

Scene make_flat_bounce(int start) {
    static constexpr float restitutions[] = {0.25f, 0.5f, 0.75f, 1};
    const float speed = 6 + 0.7f * static_cast<float>(start);
    Scene scene = sleepless_scene("flat_bounce", 60, {{-9, -1.5f}, {9, 9}});
    scene.world.gravity = {0, 0};
    add_floor(scene, 12);
    const std::size_t first = scene.bodies.size();
    for (std::size_t i = 0; i < std::size(restitutions); ++i) {
        ShapeDef material = rough(0.5f);
        material.restitution = restitutions[i];
        const std::size_t box = add_dynamic(scene, {4 * static_cast<float>(i) - 6, 3.0f + 0.02f * static_cast<float>(start)}, make_box(0.5f, 0.5f), material);
        scene.bodies[box].def.linear_velocity = {0, -speed};
    }
    scene.check = [first, speed](const Engine& engine) -> std::vector<CheckLine> {
        double turn = 0, off = 0;
        for (std::size_t i = 0; i < std::size(restitutions); ++i) {
            const BodyState box = engine.body(first + i);
            turn = std::max(turn, std::abs(double(box.angular_velocity)));
            off = std::max(off, std::abs(double(box.linear_velocity.y) - double(restitutions[i] * speed)));
        }
        return {
            wanted_line("boxes that land flat rebound turning (rad/s)", turn, 0.01),
            wanted_line("their rebound is off e v (m/s)", off, 0.01),
        };
    };
    return scene;
}

Scene make_free_cluster(int start) {
    constexpr int count = 36;
    Scene scene = sleepless_scene("free_cluster", 300, {{-20, -15}, {20, 15}});
    scene.world.gravity = {0, 0};
    Random random(static_cast<std::uint64_t>(start) + 11);
    for (int i = 0; i < count; ++i) {
        const Rot q = make_rot(2 * pi * static_cast<float>(i % 12) / 12);
        const float r = 5 + 2 * static_cast<float>(i / 12);
        BodyDef def;
        def.type = BodyType::dynamic;
        def.position = rotate(q, {r, 0});
        def.angle = random.uniform(-3, 3);
        const float inwards = random.uniform(2, 4), aside = random.uniform(-0.5f, 0.5f);
        def.linear_velocity = rotate(q, {-inwards, aside});
        def.angular_velocity = random.uniform(-3, 3);
        ShapeDef material = rough(0.5f);
        material.restitution = 0.25f * static_cast<float>(start % 5);
        material.density = random.uniform(0.5f, 4);
        const float w = random.uniform(0.2f, 0.5f), h = random.uniform(0.2f, 0.5f);
        add_body(scene, def, {{i % 2 == 0 ? SceneGeometry(make_box(w, h)) : SceneGeometry(Circle{{}, w}), material}});
    }
    struct Seen {
        double x = 0, y = 0, spin = 0, energy = 0, drift = 0, most = 0;
    };
    const auto seen = std::make_shared<Seen>();
    scene.before_step = [seen](Engine& engine, int step) {
        if (step > 0) return;
        *seen = {};
        momentum(engine, seen->x, seen->y);
        seen->spin = angular_momentum(engine);
        seen->energy = kinetic_energy(engine);
    };
    scene.after_step = [seen](const Engine& engine, int) {
        double x = 0, y = 0;
        momentum(engine, x, y);
        seen->drift = std::max(seen->drift, std::hypot(x - seen->x, y - seen->y));
        seen->most = std::max(seen->most, kinetic_energy(engine));
    };
    scene.check = [seen](const Engine& engine) -> std::vector<CheckLine> {
        // Each of the bodies brings m v, and m v r of angular momentum: about 3 m/s, from 7 m.
        double mass = 0;
        for (std::size_t i = 0; i < engine.body_slots(); ++i) mass += double(engine.body(i).mass);
        return {
            wanted_line("momentum changed (of all that came in)", seen->drift / (3 * mass), 1e-4),
            wanted_line("angular momentum changed (of the same, at 7 m)", std::abs(angular_momentum(engine) - seen->spin) / (3 * 7 * mass), 0.01),
            wanted_line("energy gained (of it)", std::max(0.0, seen->most / seen->energy - 1), 0.001),
        };
    };
    return scene;
}

}  // namespace islet::samples
