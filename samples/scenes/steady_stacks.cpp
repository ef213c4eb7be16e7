// Columns, houses of cards and piles that stand, do not sink and come to rest.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "build.hpp"
#include "harness/checks.hpp"
#include "harness/overlap.hpp"
#include "random.hpp"
#include "scenes.hpp"
#include "steady.hpp"

namespace islet::samples {
namespace {

/// Boxes of 1 m and 1 kg, one on another. The last may weigh more.
struct Column {
    std::size_t first = 0, count = 0;
    std::vector<BodyState> places;
};

/// Each up to `offset` m off x, and `gap` m above the one below it.
Column add_column(Scene& scene, float x, int count, float offset, float gap, Random& random, float load = 0) {
    Column column;
    column.first = scene.bodies.size();
    for (int i = 0; i < count; ++i) {
        const float aside = offset > 0 ? random.uniform(-offset, offset) : 0;
        add_dynamic(scene, {x + aside, 0.5f + (1 + gap) * static_cast<float>(i)}, make_box(0.5f, 0.5f));
    }
    if (load > 0) scene.bodies.back().shapes[0].def.density = load;
    column.count = scene.bodies.size() - column.first;
    column.places = places_of(scene, column.first, scene.bodies.size());
    return column;
}

/// Every box lies on the one below it: neither beside it nor half in it.
bool stands(const Engine& engine, const Column& column) {
    for (std::size_t i = column.first + 1; i < column.first + column.count; ++i) {
        const Vec2 step = engine.body(i).position - engine.body(i - 1).position;
        if (std::fabs(step.x) > 0.5f || step.y < 0.5f) return false;
    }
    return true;
}

/// How far the top is below where it would be if nothing gave way, m.
double sunk(const Engine& engine, const Column& column) { return double(column.count) - 0.5 - double(engine.body(column.first + column.count - 1).position.y); }

}  // namespace

// -- columns ---------------------------------------------------------------------------------------------------------------------

Scene make_tall_columns(int start) {
    static constexpr int counts[] = {30, 60, 100};
    Scene scene = sleepless_scene("tall_columns", 3600, {{-65, -3}, {65, 103}});
    add_floor(scene, 80);
    Random random(static_cast<std::uint64_t>(start));
    std::array<Column, 3> columns;
    for (std::size_t i = 0; i < 3; ++i) {
        const float x = 40 * (static_cast<float>(i) - 1) + 0.37f * static_cast<float>(start);
        columns[i] = add_column(scene, x, counts[i], 0, 1e-4f * static_cast<float>(start), random);
    }
    const auto sway = std::make_shared<std::array<double, 3>>();
    scene.after_step = [sway, columns](const Engine& engine, int step) {
        if (step == 0) *sway = {};
        for (std::size_t i = 0; i < 3; ++i) (*sway)[i] = std::max((*sway)[i], drift_from(columns[i].places, engine, columns[i].first).sideways);
    };
    scene.check = [sway, columns](const Engine& engine) -> std::vector<CheckLine> {
        return {
            wanted_line("column of 60: sway in 60 s (m)", (*sway)[1], 0.01),
            wanted_none("columns of 100 that fell", !stands(engine, columns[2])),
            wanted_line("column of 30: sunk after 60 s (m)", sunk(engine, columns[0]), 0.08),
            wanted_line("column of 60: sunk after 60 s (m)", sunk(engine, columns[1]), 0.3),
        };
    };
    return scene;
}

Scene make_crooked_columns(int start) {
    static constexpr float offsets[] = {0.005f, 0.02f, 0.05f};
    static constexpr const char* names[] = {"0.5", "2", "5"};
    Scene scene = sleepless_scene("crooked_columns", 1200, {{-42, -2}, {42, 62}});
    add_floor(scene, 90);
    Random random(static_cast<std::uint64_t>(start));
    std::array<Column, 3> columns;
    for (std::size_t i = 0; i < 3; ++i) columns[i] = add_column(scene, 25 * (static_cast<float>(i) - 1), 60, offsets[i], 0, random);
    scene.check = [columns](const Engine& engine) {
        std::vector<CheckLine> lines;
        for (std::size_t i = 0; i < 3; ++i)
            lines.push_back(wanted_none(std::string("columns of 60, each box up to ") + names[i] + " cm off: fell in 20 s", !stands(engine, columns[i])));
        return lines;
    };
    return scene;
}

Scene make_loaded_columns(int start) {
    struct Case {
        int count;
        float load, offset;
        const char* name;
    };
    static constexpr Case cases[] = {
        {10, 100, 0.02f, "100 kg on 10 x 1 kg"}, {5, 300, 0.01f, "300 kg on 5 x 1 kg"}, {5, 300, 0.2f, "300 kg on 5 x 1 kg, each up to 2 cm off"}};
    Scene scene = sleepless_scene("loaded_columns", 3600, {{-9, -1.5f}, {21, 12}});
    add_floor(scene, 40);
    Random random(static_cast<std::uint64_t>(start));
    std::array<Column, 3> columns;
    for (std::size_t i = 0; i < 3; ++i) {
        const Case& c = cases[i];
        columns[i] = add_column(scene, 9 * static_cast<float>(i) - 3, c.count + 1, 0.1f * c.offset * static_cast<float>(start), 0, random, c.load);
    }
    scene.check = [columns](const Engine& engine) {
        std::vector<CheckLine> lines;
        for (std::size_t i = 0; i < 3; ++i) lines.push_back(wanted_none(std::string(cases[i].name) + ": fell in 60 s", !stands(engine, columns[i])));
        return lines;
    };
    return scene;
}

Scene make_resting_stacks(int start) {
    constexpr int rows = 20, bricks = 5;
    Scene scene;
    scene.name = "resting_stacks";
    scene.steps = 3600;
    scene.view = {{-70, -3}, {85, 63}};
    add_floor(scene, 150);
    Random random(static_cast<std::uint64_t>(start));
    const std::array<Column, 3> columns = {add_column(scene, -65, 10, 0.01f, 0, random), add_column(scene, -32, 30, 0.01f, 0, random),
                                           add_column(scene, 80, 60, 0.01f, 0, random)};
    // A wall of bricks of 2 m by 1 m, half a brick at both ends of every other row. No column that falls reaches another.
    const std::size_t wall = scene.bodies.size();
    for (int row = 0; row < rows; ++row) {
        const bool shifted = row % 2 != 0;
        for (int i = 0; i < bricks + (shifted ? 1 : 0); ++i) {
            const bool half = shifted && (i == 0 || i == bricks);
            const float middle = 2 * static_cast<float>(i) + (shifted ? (half ? (i == 0 ? 0.5f : -0.5f) : 0.0f) : 1.0f);
            const Vec2 place = {5 + middle + random.uniform(-0.001f, 0.001f), 0.5f + static_cast<float>(row)};
            add_dynamic(scene, place, make_box(half ? 0.498f : 0.998f, 0.5f));
        }
    }
    const std::vector<BodyState> places = places_of(scene, wall, scene.bodies.size());
    scene.check = [columns, wall, places](const Engine& engine) -> std::vector<CheckLine> {
        double wall_sunk = 0;
        for (std::size_t i = 0; i < places.size(); ++i)
            wall_sunk = std::max(wall_sunk, double(places[i].position.y) - double(engine.body(wall + i).position.y));
        return {
            wanted_line("column of 10 that sleeps: sunk after 60 s (m)", sunk(engine, columns[0]), 0.02),
            wanted_line("column of 30 that sleeps: sunk after 60 s (m)", sunk(engine, columns[1]), 0.08),
            wanted_line("column of 60 that sleeps: sunk after 60 s (m)", sunk(engine, columns[2]), 0.3),
            wanted_line("wall of 20 rows that sleeps: sunk after 60 s (m)", wall_sunk, 0.04),
            wanted_none("columns or walls awake after 60 s", engine.counts().awake_bodies > 0),
        };
    };
    return scene;
}

Scene make_weighed_stack(int start) {
    const float shock = start < 10 ? 0.0f : 0.1f;
    const int count = 5 + start % 10;
    Scene scene = sleepless_scene("weighed_stack", 600, {{-11, -1.5f}, {11, 15}});
    scene.world.solver.shock = shock;
    const std::size_t ground = add_floor(scene, 12);
    Random random(static_cast<std::uint64_t>(start));
    const Column column = add_column(scene, 0, count, 0, 0, random);
    scene.check = [ground, column, shock](const Engine& engine) -> std::vector<CheckLine> {
        const double weight = 10 * double(column.count) * double(engine.body(column.first).mass);
        const double told = engine.contact_force(ground) ? -double(engine.contact_force(ground)->y) : 0;
        return {wanted_line(shock > 0 ? "weight of a stack that the ground misses, shock 0.1 (of it)" : "weight of a stack that the ground misses (of it)",
                            std::abs(told / weight - 1), 0.01)};
    };
    return scene;
}

Scene make_tall_card_house(int start) {
    Scene scene = make_card_house_of(7, (18.5f + 0.5f * static_cast<float>(start)) * pi / 180);
    scene.name = "tall_card_house";
    scene.view = {{-5, -0.7f}, {5, 7.6f}};
    scene.check = [places = places_of(scene, 1, scene.bodies.size())](const Engine& engine) -> std::vector<CheckLine> {
        const double fallen = drift_from(places, engine, 1).distance;
        return {wanted_none("houses of cards of 7 storeys that fell in 60 s", !(fallen < 0.25))};
    };
    return scene;
}

// -- piles -----------------------------------------------------------------------------------------------------------------------

namespace {

/// A bin of thick walls, its floor at y = 0.
void add_bin(Scene& scene, float half_width, float height) {
    std::vector<SceneShape> walls = {{make_offset_box(half_width + 2, 1, {{0, -1}, {}}), {}}};
    for (const float side : {-1.0f, 1.0f}) walls.push_back({make_offset_box(1, 0.5f * height, {{side * (half_width + 1), 0.5f * height}, {}}), {}});
    add_body(scene, {}, std::move(walls));
}

}  // namespace

Scene make_mixed_pile(int start) {
    constexpr int columns = 8, rows = 25;
    Scene scene = sleepless_scene("mixed_pile", 900, {{-22, -2}, {22, 32}});
    add_bin(scene, 5, 32);
    Random random(static_cast<std::uint64_t>(start) + 3);
    for (int i = 0; i < columns * rows; ++i) {
        const int corners = 3 + i % 6;
        const float radius = random.uniform(0.3f, 0.55f);
        std::array<Vec2, 8> points;
        for (int k = 0; k < corners; ++k) {
            const Rot q = make_rot(2 * pi * (static_cast<float>(k) + random.uniform(-0.3f, 0.3f)) / static_cast<float>(corners));
            points[static_cast<std::size_t>(k)] = {radius * q.c, radius * q.s};
        }
        const float x = 1.2f * (static_cast<float>(i % columns) - 3.5f) + random.uniform(-0.05f, 0.05f);
        add_dynamic(scene, {x, 0.7f + 1.2f * static_cast<float>(i / columns)}, make_polygon(compute_hull({points.data(), static_cast<std::size_t>(corners)})));
    }
    scene.check = [polygons = polygons_in(scene)](const Engine& engine) -> std::vector<CheckLine> {
        double sum = 0, deepest = 0;
        const std::vector<Overlap> overlaps = overlaps_of(polygons, engine, 0);
        for (const Overlap& overlap : overlaps) sum += overlap.depth, deepest = std::max(deepest, overlap.depth);
        return {
            wanted_line("settled pile of polygons: mean overlap of pairs (m)", sum / double(std::max(overlaps.size(), std::size_t{1})), 0.02, 0.1),
            wanted_line("settled pile of polygons: deepest overlap of a pair (m)", deepest, 0.02, 0.1),
        };
    };
    return scene;
}

Scene make_settling_pile(int start) {
    constexpr int columns = 20, rows = 25, count = columns * rows;
    Scene scene;
    scene.name = "settling_pile";
    scene.steps = 1500;
    scene.view = {{-22, -2}, {22, 31}};
    add_bin(scene, 10, 20);
    Random random(static_cast<std::uint64_t>(start) + 5);
    for (int i = 0; i < count; ++i) {
        const Vec2 place = {static_cast<float>(i % columns) - 9.5f + random.uniform(-0.05f, 0.05f), 0.6f + 1.05f * static_cast<float>(i / columns)};
        const float half = random.uniform(0.25f, 0.45f);
        add_dynamic(scene, place, i % 2 == 0 ? make_box(half, half) : make_box(0.4f, 0.2f), {}, random.uniform(-0.3f, 0.3f));
    }
    const auto last = std::make_shared<int>();
    scene.after_step = [last](const Engine& engine, int step) {
        if (step == 0 || engine.counts().awake_bodies > 0) *last = step + 1;
    };
    scene.check = [last, dt = double(scene.dt)](const Engine& engine) -> std::vector<CheckLine> {
        return {
            wanted_line("a pile of 500 boxes sleeps after (s)", dt * *last, 11, 20),
            at_most("bodies outside the bin", double(count_outside(engine, {{-10, 0}, {10, 30}})), 0),
        };
    };
    return scene;
}

namespace {

/// Moves each body by up to 2 mm: a pile then comes to lie otherwise. Start 0 moves none.
void nudge(Scene& scene, int start) {
    Random random(static_cast<std::uint64_t>(start));
    for (SceneBody& body : scene.bodies)
        if (start > 0 && body.def.type == BodyType::dynamic) body.def.position.x += random.uniform(-0.002f, 0.002f);
}

/// Ends after 300 steps, and counts pairs that are deep in each other there and hardly move apart: what lies, not what has just been hit.
Scene with_deep_contacts_counted(Scene scene, int start, double known) {
    constexpr double deep = 0.05;  // m
    constexpr float slow = 1;      // m/s
    nudge(scene, start);
    scene.steps = 300;
    scene.check = [polygons = polygons_in(scene), name = scene.name, known](const Engine& engine) -> std::vector<CheckLine> {
        int count = 0;
        for (const Overlap& overlap : overlaps_of(polygons, engine, deep)) {
            const BodyState a = engine.body(overlap.body_a), b = engine.body(overlap.body_b);
            const Vec2 middle = 0.5f * (a.center + b.center);
            const auto velocity = [middle](const BodyState& s) { return s.linear_velocity + cross(s.angular_velocity, middle - s.center); };
            if (length(velocity(a) - velocity(b)) < slow) ++count;
        }
        return {wanted_line(name + ": slow contacts deeper than 5 cm after 300 steps", count, 100, known)};
    };
    return scene;
}

}  // namespace

Scene make_compounds_from(int start) { return with_deep_contacts_counted(make_compounds(), start, 700); }

Scene make_junkyard_from(int start) { return with_deep_contacts_counted(make_junkyard(), start, 100); }

Scene make_washer_from(int start) { return with_deep_contacts_counted(make_washer(), start, 100); }

}  // namespace islet::samples
