// Grains that flow: through an hourglass, out of a silo, off a ledge, around a stirrer.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "build.hpp"
#include "harness/checks.hpp"
#include "random.hpp"
#include "scenes.hpp"

namespace islet::samples {
namespace {

constexpr float grain = 0.08f;  // m, mean radius

/// A disc of a radius that differs by up to 15 %, so that the grains do not line up as in a crystal.
SceneGeometry some_disc(Random& random) { return Circle{{}, grain * random.uniform(0.85f, 1.15f)}; }

/// A pentagon with its corners on a circle of 1.25 times the radius, at uneven angles.
SceneGeometry some_pebble(Random& random) {
    Vec2 corners[5];
    for (int i = 0; i < 5; ++i) {
        const Rot q = make_rot(2 * pi / 5 * (static_cast<float>(i) + random.uniform(-0.25f, 0.25f)));
        corners[i] = 1.25f * grain * Vec2{q.c, q.s};
    }
    return make_polygon(compute_hull(corners));
}

using Grain = std::function<SceneGeometry(Random&)>;

/// Pours grains in loose rows into `box` wherever `free` says so, until there are `count`. Returns the first one's index.
std::size_t pour(Scene& scene, std::size_t count, const Aabb& box, const std::function<bool(Vec2)>& is_free, const Grain& shape,
                 const ShapeDef& def, std::uint64_t seed) {
    const std::size_t first = scene.bodies.size();
    const float pitch = 2.4f * grain;
    Random random(seed);
    for (int row = 0; box.lower.y + pitch * static_cast<float>(row) <= box.upper.y; ++row) {
        for (int column = 0; box.lower.x + pitch * static_cast<float>(column) <= box.upper.x; ++column) {
            const Vec2 place = box.lower + pitch * Vec2{static_cast<float>(column), static_cast<float>(row)};
            const Vec2 off = {random.uniform(-0.01f, 0.01f), random.uniform(-0.01f, 0.01f)};
            const float angle = random.uniform(-pi, pi);
            if (!is_free(place) || scene.bodies.size() - first == count) continue;
            add_dynamic(scene, place + off, shape(random), def, angle);
        }
    }
    return first;
}

std::size_t count_below(const Engine& engine, std::size_t first, std::size_t count, float height) {
    std::size_t below = 0;
    for (std::size_t i = first; i < first + count; ++i) below += engine.body(i).position.y < height ? 1 : 0;
    return below;
}

/// Bodies faster than 0.05 m/s.
std::size_t count_moving(const Engine& engine) {
    std::size_t moving = 0;
    for (std::size_t i = 0; i < engine.body_slots(); ++i)
        moving += engine.exists(i) && length(engine.body(i).linear_velocity) > 0.05f ? 1 : 0;
    return moving;
}

}  // namespace

Scene make_hourglass() {
    constexpr std::size_t count = 230;
    constexpr float width = 2, tall = 3.4f, shoulder = 2, neck = 0.48f, throat = 0.15f;  // m; the neck is 6 grains wide
    Scene scene;
    scene.name = "hourglass";
    scene.steps = 600;
    scene.view = {{-3.6f, -3.8f}, {3.6f, 3.8f}};
    // Clockwise: the inside is on the right.
    Chain glass;
    glass.loop = true;
    glass.points = {{-width, tall}, {width, tall},   {width, shoulder},   {neck, throat},   {neck, -throat}, {width, -shoulder},
                    {width, -tall}, {-width, -tall}, {-width, -shoulder}, {-neck, -throat}, {-neck, throat}, {-width, shoulder}};
    const ShapeDef smooth = {.friction = 0.3f};
    add_static(scene, {}, glass, smooth);
    const auto inside = [](Vec2 p) {
        return abs(p.x) < min(width, neck + (width - neck) * (p.y - throat) / (shoulder - throat)) - 2 * grain;
    };
    const std::size_t first = pour(scene, count, {{-width, 0.4f}, {width, tall - 0.1f}}, inside, some_disc, smooth, 31);

    // A jam would last: how long nothing has gone through.
    const auto half_step = std::make_shared<int>(0);
    scene.after_step = [=](const Engine& engine, int step) {
        if (step == 0) *half_step = 0;
        if (*half_step == 0 && count_below(engine, first, count, 0) >= count / 2) *half_step = step;
    };
    scene.check = [=, placed = scene.bodies.size() - first, dt = double(scene.dt)](const Engine& engine) -> std::vector<CheckLine> {
        // Beverloo's law in two dimensions: grains of diameter d leave a slot of width D at about sqrt(g) (D - k d)^1.5 times a factor near 1 of the
        // area they fill, k = 1.4. Steep walls and their little friction speed it up, and the first ones fall freely.
        const double opening = 2 * double(neck) - 1.4 * 2 * double(grain);
        const double rate = std::sqrt(10.0) * std::pow(opening, 1.5) * 0.82 / (double(pi) * double(grain) * double(grain));
        return {
            near_line("grains", double(placed), double(count), 0),
            near_line("grains that went through", double(count_below(engine, first, count, -throat)), double(count), 0),
            {"rate at which the first half did, over Beverloo's", 0.5 * double(count) / (*half_step * dt) / rate, 0.5, 2},
            at_most("grains outside the glass", double(count_outside(engine, {{-width, -tall}, {width, tall}})), 0),
            at_most("grains that still move, one in a hundred at most", double(count_moving(engine)), 0.01 * double(count)),
            at_most("deepest overlap, half a grain's radius at most (m)", engine.max_penetration(), 0.5 * double(grain)),
        };
    };
    return scene;
}

Scene make_silo() {
    constexpr std::size_t count = 540;
    constexpr float width = 1.5f, tall = 6.4f, opening = 0.5f;  // m, halves of the width
    constexpr int open_step = 90;
    Scene scene;
    scene.name = "silo";
    scene.steps = 780;
    scene.view = {{-5.5f, -4}, {5.5f, 6.5f}};
    add_static(scene, {0, -3.7f}, make_box(4, 0.2f));
    for (const float side : {-1.0f, 1.0f}) {
        add_static(scene, {side * 3.9f, -2.9f}, make_box(0.1f, 0.6f));
        add_static(scene, {side * (width + 0.1f), 0.5f * tall - 0.1f}, make_box(0.1f, 0.5f * tall + 0.1f));
        add_static(scene, {side * 0.5f * (width + opening), -0.1f}, make_box(0.5f * (width - opening), 0.1f));
    }
    const std::size_t gate = add_static(scene, {0, -0.1f}, make_box(opening, 0.1f));
    const ShapeDef grit = {.friction = 0.5f};
    const auto anywhere = [](Vec2) { return true; };
    const std::size_t first =
        pour(scene, count, {{-width + 1.3f * grain, 0.1f}, {width - 1.3f * grain, 20}}, anywhere, some_disc, grit, 32);

    // The steps in which so many grains have come out, and how high the silo was filled.
    struct Flow {
        std::array<int, 5> steps = {};
        double high = 0, low = 0;
    };
    constexpr std::array<std::size_t, 5> marks = {50, 150, 250, 350, 450};
    const auto flow = std::make_shared<Flow>();
    scene.before_step = [gate](Engine& engine, int step) {
        if (step == open_step) engine.destroy_body(gate);
    };
    scene.after_step = [=](const Engine& engine, int step) {
        if (step == 0) *flow = {};
        const std::size_t out = count_below(engine, first, count, -0.3f);
        for (std::size_t i = 0; i < marks.size(); ++i) {
            if (flow->steps[i] == 0 && out >= marks[i]) flow->steps[i] = step;
        }
    };
    scene.check = [=, placed = scene.bodies.size() - first, dt = double(scene.dt)](const Engine& engine) -> std::vector<CheckLine> {
        // Grains flow at a rate that does not depend on how full the silo is, since its walls carry what is above; water would slow down with the square
        // root of its depth, here to a half. Beverloo's law: see the hourglass.
        const auto rate = [&](std::size_t from, std::size_t to) {
            return double(marks[to] - marks[from]) / ((flow->steps[to] - flow->steps[from]) * dt);
        };
        const double gap = 2 * double(opening) - 1.4 * 2 * double(grain);
        const double due = std::sqrt(10.0) * std::pow(gap, 1.5) * 0.82 / (double(pi) * double(grain) * double(grain));
        return {
            near_line("grains", double(placed), double(count), 0),
            {"rate over Beverloo's", rate(0, 4) / due, 0.6, 1.4},
            {"rate when nearly empty over that when full", rate(2, 4) / rate(0, 2), 0.8, 1.2},
            at_most("grains that got out of the tray", double(count_outside(engine, {{-4, -3.5f}, {4, 8}})), 0),
            {"grains that stay in the silo's corners", double(count - count_below(engine, first, count, -0.1f)), 1, 180},
            at_most("deepest overlap, half a grain's radius at most (m)", engine.max_penetration(), 0.5 * double(grain)),
        };
    };
    return scene;
}

namespace {

/// The slope of a heap's surface by least squares: highest grain of each column of 0.2 m from x = `from` on towards `to`.
double surface_slope(const Engine& engine, std::size_t first, std::size_t count, double from, double to) {
    constexpr double column = 0.2;
    const auto columns = static_cast<std::size_t>(std::lround(std::abs(to - from) / column));
    const double way = to > from ? 1 : -1;
    std::vector<double> tops(columns, 0);
    for (std::size_t i = first; i < first + count; ++i) {
        const Vec2 p = engine.body(i).position;
        const double along = (double(p.x) - from) * way / column;
        if (p.y < 0 || along < 0 || along >= double(columns)) continue;
        double& top = tops[static_cast<std::size_t>(along)];
        top = std::max(top, double(p.y));
    }
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    const double n = double(columns);
    for (std::size_t i = 0; i < columns; ++i) {
        const double x = (double(i) + 0.5) * column;
        sx += x;
        sy += tops[i];
        sxx += x * x;
        sxy += x * tops[i];
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace

Scene make_avalanche() {
    constexpr std::size_t count = 280;                        // on each side
    constexpr float ledge = 3.6f, drop = -2.5f, wall = 0.1f;  // m
    constexpr float frictions[] = {0.05f, 0.6f};              // left and right of the wall
    constexpr int open_step = 90;
    Scene scene;
    scene.name = "avalanche";
    scene.steps = 1200;
    scene.view = {{-6.5f, -2.9f}, {6.5f, 2.9f}};
    add_static(scene, {0, drop - 0.2f}, make_box(7, 0.2f));
    for (const float side : {-1.0f, 1.0f}) add_static(scene, {side * 6.9f, drop + 1}, make_box(0.1f, 1));
    add_static(scene, {0, -0.1f}, make_box(ledge, 0.1f));
    add_static(scene, {0, 1.4f}, make_box(wall, 1.4f));
    std::size_t gates[2], first[2];
    const auto anywhere = [](Vec2) { return true; };
    for (std::size_t side = 0; side < 2; ++side) {
        const float sign = side == 0 ? -1.0f : 1.0f;
        gates[side] = add_static(scene, {sign * (ledge + 0.05f), 1.2f}, make_box(0.05f, 1.2f));
        const float near = sign * (wall + 1.4f * grain), far = sign * (ledge - 1.4f * grain);
        const ShapeDef stone = {.friction = frictions[side]};
        first[side] = pour(scene, count, {{min(near, far), 0.1f}, {max(near, far), 20}}, anywhere, some_pebble, stone, 33 + side);
    }
    // What lies on what has the stones' friction: the shelf is as rough as they are, and two frictions mix to their geometric mean.
    scene.before_step = [gates = std::array{gates[0], gates[1]}](Engine& engine, int step) {
        if (step != open_step) return;
        for (const std::size_t gate : gates) engine.destroy_body(gate);
    };
    scene.check = [=, firsts = std::array{first[0], first[1]}, frictions = std::array{frictions[0], frictions[1]}](const Engine& engine) {
        // What flows over the ledge leaves a slope at the angle of repose. For bodies that slide on each other it would be atan(mu). Pebbles also lock
        // into each other, which makes it steeper, by up to some 20 degrees, and they can roll where friction is high, which makes it less.
        std::vector<CheckLine> lines;
        double angles[2];
        for (std::size_t side = 0; side < 2; ++side) {
            const double sign = side == 0 ? -1 : 1, degree = double(pi) / 180;
            const double slope = surface_slope(engine, firsts[side], count, sign * double(ledge), sign * double(wall));
            angles[side] = std::atan(slope) / degree;
            const double sliding = std::atan(double(frictions[side])) / degree;
            const std::string name = side == 0 ? "mu = 0.05: " : "mu = 0.6: ";
            lines.push_back({name + "angle of repose, atan(mu) being " + std::to_string(std::lround(sliding)) + " (degrees)", angles[side],
                             0.6 * sliding, sliding + 20});
        }
        lines.push_back({"the rough heap is steeper by (degrees)", angles[1] - angles[0], 4, 30});
        lines.push_back(
            at_most("pebbles that still move, one in a hundred at most", double(count_moving(engine)), 0.01 * double(2 * count)));
        lines.push_back(at_most("deepest overlap, half a grain's radius at most (m)", engine.max_penetration(), 0.5 * double(grain)));
        lines.push_back(at_most("pebbles that got away", double(count_outside(engine, {{-7, drop - 0.1f}, {7, 20}})), 0));
        return lines;
    };
    return scene;
}

namespace {

/// Lacey's index: 0 if two kinds lie apart, 1 if they are as mixed as by chance. Judged by the variance, over cells of 0.5 m, of the share of the first
/// kind among a cell's grains: apart it is p (1 - p), mixed by chance p (1 - p) / grains in a cell.
double mixing(const Engine& engine, std::size_t first, const std::vector<bool>& kinds) {
    constexpr int side = 12;
    struct Cell {
        double all = 0, of_first = 0;
    };
    std::array<Cell, side * side> cells;
    double p = 0;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const Vec2 place = engine.body(first + i).position;
        const int x = std::clamp(static_cast<int>(2 * (place.x + 3)), 0, side - 1),
                  y = std::clamp(static_cast<int>(2 * place.y), 0, side - 1);
        Cell& cell = cells[static_cast<std::size_t>(y * side + x)];
        cell.all += 1;
        cell.of_first += kinds[i] ? 1 : 0;
        p += (kinds[i] ? 1 : 0) / double(kinds.size());
    }
    double variance = 0, used = 0, grains = 0;
    for (const Cell& cell : cells) {
        if (cell.all < 4) continue;
        const double off = cell.of_first / cell.all - p;
        variance += off * off;
        grains += cell.all;
        used += 1;
    }
    variance /= used;
    const double apart = p * (1 - p), chance = apart / (grains / used);
    return (apart - variance) / (apart - chance);
}

}  // namespace

Scene make_mixer() {
    constexpr int points = 64;
    constexpr float radius = 2.2f, arm = 1.75f, rate = 1.5f;  // m, rad/s
    constexpr Vec2 middle = {0, radius};
    Scene scene;
    scene.name = "mixer";
    scene.steps = 900;
    scene.view = {{-3.4f, -0.3f}, {3.4f, 4.8f}};
    Chain tub;
    tub.loop = true;
    for (int i = 0; i < points; ++i) {
        const Rot q = make_rot(-2 * pi * static_cast<float>(i) / points);
        tub.points.push_back(middle + radius * Vec2{q.c, q.s});
    }
    const std::size_t ground = add_static(scene, {}, tub);
    BodyDef stirrer;
    stirrer.type = BodyType::dynamic;
    stirrer.position = middle;
    stirrer.enable_sleep = false;
    const Polygon blade = make_offset_box(arm, 0.05f, {{}, make_rot(pi / 4)}), other = make_offset_box(arm, 0.05f, {{}, make_rot(-pi / 4)});
    const std::size_t paddle = add_body(scene, stirrer, {{blade, {.density = 20}}, {other, {.density = 20}}});
    RevoluteJointDef axle = hinge_at(scene, ground, paddle, middle);
    axle.motor = {.enable = true, .speed = rate, .max_force = 5000};
    const std::size_t motor = add_joint(scene, ground, paddle, axle);

    // Discs on the left, hexagons on the right.
    const auto is_free = [middle](Vec2 p) {
        const Vec2 r = p - middle;
        return length(r) < radius - 1.5f * grain && abs(abs(r.x) - abs(r.y)) > 0.3f;
    };
    Vec2 corners[6];
    for (int i = 0; i < 6; ++i) {
        const Rot q = make_rot(pi / 3 * static_cast<float>(i));
        corners[i] = 1.1f * grain * Vec2{q.c, q.s};
    }
    const Polygon hexagon = make_polygon(compute_hull(corners));
    const ShapeDef grit = {.friction = 0.4f};
    constexpr std::size_t half = 125;
    const std::size_t first = pour(scene, half, {{-radius, 0}, {-0.12f, 2 * radius}}, is_free, some_disc, grit, 35);
    const std::size_t discs = scene.bodies.size() - first;
    pour(
        scene, half, {{0.12f, 0}, {radius, 2 * radius}}, is_free, [&](Random&) { return SceneGeometry(hexagon); }, grit, 36);
    std::vector<bool> kinds(scene.bodies.size() - first, false);
    std::fill_n(kinds.begin(), discs, true);

    const auto before = std::make_shared<double>(0);
    scene.after_step = [=](const Engine& engine, int step) {
        if (step == 0) *before = mixing(engine, first, kinds);
    };
    const double due = double(rate) * double(scene.dt) * scene.steps;
    scene.check = [=](const Engine& engine) -> std::vector<CheckLine> {
        return {
            near_line("grains", double(kinds.size()), double(2 * half), 0),
            {"mixing at first (0: apart)", *before, -0.1, 0.2},
            {"mixing at the end (1: as by chance)", mixing(engine, first, kinds), 0.75, 1.1},
            near_line("the stirrer turned by (rad)", double(engine.joint_position(motor)), due, 0.05),
            at_most("grains outside the tub", double(count_outside(engine, {{-radius, 0}, {radius, 2 * radius}})), 0),
            at_most("deepest overlap, half a grain's radius at most (m)", engine.max_penetration(), 0.5 * double(grain)),
        };
    };
    return scene;
}

}  // namespace islet::samples
