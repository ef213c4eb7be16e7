// islet-pictures: the pictures of docs/ that show more than a scene. docs/draw.sh makes them all.
//
//     islet-pictures NAME        writes the picture to standard output
//
// Exit status: 0 done, 2 there is no such picture.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <vector>

#include <islet/lcp.hpp>

#include "film.hpp"

namespace islet::pictures {
namespace {

constexpr float dt = 1.0f / 60;
constexpr const char* red = "#c4314b";
constexpr const char* blue = "#1565c0";
constexpr const char* green = "#2f7d6b";
constexpr const char* grey = "#77808d";
constexpr const char* white = "#ffffff";

constexpr Capacity capacity = {.bodies = 64, .shapes = 64, .contacts = 256, .joints = 8};
StaticWorld<capacity> storage, other_storage;

BodyId add(World& world, Vec2 position, float angle, const Polygon& box, BodyType type = BodyType::dynamic) {
    const BodyId body = world.create_body({.type = type, .position = position, .angle = angle});
    world.create_shape(body, box);
    return body;
}

// -- queries: a fan of rays, a cast, an overlap, and the closest point ----------------------------------------------------------------

void draw_rays(Sketch& sketch, const World& world, const Camera& camera) {
    const Vec2 eye = {1.2f, 2.6f};
    for (int i = -4; i <= 4; ++i) {
        const Vec2 way = 7 * rotate(make_rot(0.09f * static_cast<float>(i) - 0.02f), {1, 0});
        const QueryHit hit = world.cast_ray(eye, way);
        sketch.line(camera(eye), camera(hit ? hit.point : eye + way), {.stroke = blue, .width = 1.2f});
        if (!hit) continue;
        sketch.arrow(camera(hit.point), camera(hit.point + 0.5f * hit.normal), {.stroke = red, .width = 1.2f});
        sketch.circle(camera(hit.point), 3, {.stroke = red, .fill = red});
    }
    sketch.circle(camera(eye), 5, {.stroke = blue, .fill = blue});
    sketch.text(camera({0.4f, 3.0f}), "cast_ray", blue);
}

void draw_cast(Sketch& sketch, const World& world, const Camera& camera) {
    const Circle ball = {{9.4f, 5.4f}, 0.35f};
    const Vec2 way = {3.5f, -4.5f};
    const QueryHit hit = world.cast_shape(make_proxy(ball), way);
    const Vec2 end = ball.center + hit.fraction * way;
    const float radius = camera.scale * ball.radius;
    sketch.circle(camera(ball.center), radius, {.stroke = blue, .dashes = "4 3"});
    sketch.arrow(camera(ball.center), camera(end), {.stroke = blue});
    sketch.circle(camera(end), radius, {.stroke = blue});
    sketch.circle(camera(hit.point), 3, {.stroke = red, .fill = red});
    sketch.text(camera({9.9f, 5.4f}), "cast_shape", blue);
}

void draw_overlap(Sketch& sketch, const World& world, const Camera& camera) {
    const Circle blast = {{15.2f, 1.3f}, 1.5f};
    ShapeId found[8];
    const std::uint32_t count = world.overlap_shape(make_proxy(blast), found);
    sketch.circle(camera(blast.center), camera.scale * blast.radius, {.stroke = red, .dashes = "6 4"});
    for (std::uint32_t i = 0; i < count; ++i) {
        if (world.type(world.body(found[i])) == BodyType::dynamic) sketch.circle(camera(world.position(world.body(found[i]))), 5, {.stroke = red, .fill = red});
    }
    sketch.text(camera({13.9f, 3.0f}), "overlap_shape", red);
}

void draw_closest(Sketch& sketch, const World& world, const Camera& camera) {
    const Vec2 point = {5.2f, 5.2f};
    const ClosestHit closest = world.closest(point, 10);
    sketch.line(camera(point), camera(closest.point), {.stroke = green, .dashes = "3 3"});
    sketch.circle(camera(point), 4, {.stroke = green, .fill = white});
    sketch.circle(camera(closest.point), 4, {.stroke = green, .fill = green});
    sketch.text(camera({4.6f, 5.5f}), "closest", green);
}

Sketch draw_queries() {
    World& world = storage.create({.enable_sleep = false});
    add(world, {9, -0.5f}, 0, make_box(9, 0.5f), BodyType::static_body);
    add(world, {5, 0.6f}, 0, make_box(0.5f, 0.6f));
    add(world, {6.4f, 3.6f}, 0.5f, make_rounded_box(0.5f, 0.3f, 0.2f), BodyType::static_body);
    world.create_shape(world.create_body({.position = {6.6f, 1.9f}}), Circle{{}, 0.6f});
    world.create_shape(world.create_body({.position = {11.5f, 1.5f}, .angle = 0.4f}), Capsule{{-0.8f, 0}, {0.8f, 0}, 0.4f});
    for (const float x : {14.2f, 15.3f, 16.4f, 17.4f}) add(world, {x, 0.4f}, 0, make_box(0.4f, 0.4f));
    add(world, {14.8f, 1.2f}, 0, make_box(0.4f, 0.4f));
    Sketch sketch(760, 300);
    const Camera camera = {.lower = {0, -1}, .scale = 42, .bottom = 290};
    sketch.world(world, camera);
    draw_rays(sketch, world, camera);
    draw_cast(sketch, world, camera);
    draw_overlap(sketch, world, camera);
    draw_closest(sketch, world, camera);
    return sketch;
}

// -- snapshots: two futures from one saved state ----------------------------------------------------------------------------------------

/// Steps, and draws the way of a body.
void draw_future(Sketch& sketch, World& world, BodyId body, int steps, const Camera& camera, const char* color) {
    std::vector<Vec2> way = {camera(world.position(body))};
    for (int i = 0; i < steps; ++i) {
        world.step(dt);
        way.push_back(camera(world.position(body)));
    }
    sketch.polyline(way, {.stroke = color, .width = 2});
}

Sketch draw_snapshots() {
    World& world = storage.create({.enable_sleep = false});
    add(world, {9, -0.5f}, 0, make_box(9, 0.5f), BodyType::static_body);
    for (int i = 0; i < 6; ++i) add(world, {13, 0.4f + 0.8f * static_cast<float>(i)}, 0, make_box(0.4f, 0.4f));
    const BodyId ball = world.create_body({.type = BodyType::dynamic, .position = {1, 1}, .linear_velocity = {9, 9}});
    world.create_shape(ball, Circle{{}, 0.3f}, {.restitution = 0.3f, .density = 4});

    Sketch sketch(760, 300);
    const Camera camera = {.lower = {0, -0.8f}, .scale = 42, .bottom = 290};
    draw_future(sketch, world, ball, 30, camera, "#2c3440");
    const Vec2 saved = camera(world.position(ball));
    static std::byte image[max_snapshot_bytes(capacity)];
    const std::size_t bytes = world.save(image);
    draw_future(sketch, world, ball, 55, camera, grey);
    world.restore({image, bytes});
    world.apply_linear_impulse_to_center(ball, {-2, -2.5f});  // what was learned too late the first time
    draw_future(sketch, world, ball, 55, camera, red);
    sketch.world(world, camera);
    sketch.circle(saved, 7, {.stroke = blue, .fill = white, .width = 2.5f});
    sketch.text(saved + Vec2{-10, -14}, "save and restore", blue, 14, "end");
    sketch.text({200, 200}, "first future: without the late input", grey);
    sketch.text({200, 220}, "second future: with it", red);
    return sketch;
}

// -- recordings: one recording, replayed up to four steps ---------------------------------------------------------------------------------

Sketch draw_recording() {
    World& world = storage.create({.enable_sleep = false});
    add(world, {4, -0.5f}, 0, make_box(4, 0.5f), BodyType::static_body);
    for (int row = 0; row < 4; ++row) {
        for (int i = 0; i < 3; ++i) add(world, {3.2f + 0.82f * static_cast<float>(i), 0.4f + 0.8f * static_cast<float>(row)}, 0, make_box(0.4f, 0.4f));
    }
    alignas(recording_alignment) static std::byte buffer[200'000];
    world.start_recording(buffer);
    for (int i = 0; i < 60; ++i) {
        if (i == 10) world.explode({.position = {4, 0.1f}, .radius = 0.5f, .falloff = 3, .impulse_per_length = 5});
        world.step(dt);
    }
    const std::size_t bytes = world.stop_recording();

    Sketch sketch(820, 240);
    for (int frame = 0; frame < 4; ++frame) {
        const std::uint64_t steps = std::array{5u, 15u, 30u, 60u}[static_cast<std::size_t>(frame)];
        World& again = other_storage.create();
        const ReplayResult result = replay(again, {buffer, bytes}, steps);
        const float left = 10 + 203 * static_cast<float>(frame);
        sketch.world(again, {.lower = {0, -1}, .scale = 24, .left = left, .bottom = 205});
        sketch.text({left + 96, 228}, (result.end == ReplayEnd::complete || result.end == ReplayEnd::stopped ? "step " : "differs at step ") + std::to_string(steps),
                    "#2c3440", 14, "middle");
        if (frame > 0) sketch.line({left - 6, 10}, {left - 6, 230}, {.stroke = "#d8dce3"});
    }
    return sketch;
}

// -- memory: the block of a small world, to scale ------------------------------------------------------------------------------------------

Sketch draw_memory() {
    constexpr Capacity small = {.bodies = 64, .shapes = 64, .contacts = 192, .joints = 16, .geometries = 8};
    const struct {
        const char* name;
        const char* what;
        std::size_t bytes;
        const char* fill;
    } parts[] = {
        {"host", "pointers, hooks", sizeof(World), "#cdbfe9"},
        {"persistent", "what a snapshot holds", max_snapshot_bytes(small), "#f7bd6d"},
        {"events and scratch", "events of the last step; rows and lists that live for one call", 0, "#d8dce3"},
    };
    Sketch sketch(760, 150);
    const std::size_t all = world_bytes(small);
    float x = 20;
    std::size_t used = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t bytes = parts[i].bytes != 0 ? parts[i].bytes : all - used;
        used += bytes;
        const float width = 720 * static_cast<float>(bytes) / static_cast<float>(all);
        sketch.box({x, 40}, width, 50, {.stroke = "#77808d", .fill = parts[i].fill});
        if (width > 100) {
            sketch.text({x + width / 2, 62}, parts[i].name, "#2c3440", 14, "middle");
            sketch.text({x + width / 2, 80}, parts[i].what, "#2c3440", 10, "middle");
        } else {
            sketch.text({x, 30}, std::string(parts[i].name) + ": " + parts[i].what, "#2c3440", 12);
        }
        x += width;
    }
    sketch.text({20, 116}, "One block: 64 bodies, 64 shapes, 192 contacts, 16 joints, 8 geometries.");
    sketch.text({20, 136}, "No pointers in the persistent part: it is the same on 32-bit and 64-bit processors.", grey);
    return sketch;
}

// -- the matrix solvers: how fast each method gets to the solution -------------------------------------------------------------------------

Sketch draw_lcp() {
    // Twelve boxes of 1 kg on each other, which fall at 1 m/s for a moment: engine/include/islet/lcp.hpp.
    constexpr std::size_t n = 12;
    float m[n * n] = {}, q[n] = {-1};
    for (std::size_t i = 0; i < n; ++i) {
        m[n * i + i] = i == 0 ? 1 : 2;
        if (i > 0) m[n * i + i - 1] = m[n * (i - 1) + i] = -1;
    }
    Sketch sketch(760, 330);
    constexpr float left = 60, bottom = 290, width = 560, height = 250, decades = 5, most = 120;
    for (int i = 0; i <= 5; ++i) {
        const float y = bottom - height + height * static_cast<float>(i) / decades;
        sketch.line({left, y}, {left + width, y}, {.stroke = "#e4e1da", .width = 1});
        sketch.text({left - 8, y + 4}, i == 0 ? "1" : "1e-" + std::to_string(i), grey, 12, "end");
    }
    for (int i = 0; i <= 4; ++i) {
        const float x = left + width * static_cast<float>(i) / 4;
        sketch.text({x, bottom + 18}, std::to_string(30 * i), grey, 12, "middle");
    }
    sketch.text({left, 24}, "natural residual", grey, 12);
    sketch.text({left + width, bottom + 34}, "iterations", grey, 12, "end");
    const struct {
        lcp::Method method;
        float omega;
        const char* name;
        const char* color;
    } methods[] = {{lcp::Method::jacobi, 0.9f, "jacobi, omega 0.9", grey},
                   {lcp::Method::pgs, 1, "pgs", "#b0702c"},
                   {lcp::Method::psor, 1.6f, "psor, omega 1.6", blue},
                   {lcp::Method::block_pgs, 1, "block_pgs, 3 rows", green},
                   {lcp::Method::nncg, 1, "nncg", red}};
    const std::uint32_t blocks[] = {0, 3, 6, 9};
    float label = 60;
    for (const auto& method : methods) {
        float x[n] = {}, history[120] = {};
        static std::byte memory[lcp::workspace_bytes<float>(lcp::Method::nncg, n)];
        lcp::Options<float> options = {.method = method.method, .max_iterations = 120, .tolerance = 1e-5f, .omega = method.omega, .history = history};
        if (method.method == lcp::Method::block_pgs) options.blocks = blocks;
        const lcp::Result<float> result = lcp::solve<float>({.dense = {m}, .q = q}, options, x, memory);
        std::vector<Vec2> curve = {{left, bottom - height}};
        for (std::uint32_t i = 0; i < result.iterations && history[i] > 0; ++i) {
            const float down = min(-std::log10(history[i]), decades);
            curve.push_back({left + width * static_cast<float>(i + 1) / most, bottom - height + height * max(down, 0) / decades});
        }
        sketch.polyline(curve, {.stroke = method.color, .width = 2});
        sketch.text({left + width + 14, label}, method.name, method.color, 13);
        label += 24;
    }
    return sketch;
}

// -- a step: the stages, and a substep within one ------------------------------------------------------------------------------------------

Sketch draw_step() {
    const struct {
        const char* name;
        const char* lines[2];
    } stages[] = {{"pairs", {"which fat", "boxes overlap"}},
                  {"collide", {"where and how", "shapes touch"}},
                  {"islands", {"what belongs", "together"}},
                  {"solve", {"impulses and", "motion"}},
                  {"finish", {"poses, fast bodies,", "sleep, events"}}};
    Sketch sketch(760, 300);
    for (int i = 0; i < 5; ++i) {
        const float x = 20 + 148 * static_cast<float>(i);
        sketch.box({x, 30}, 124, 74, {.stroke = "#b0702c", .fill = i == 3 ? "#f7bd6d" : "#fbe3bf"});
        sketch.text({x + 62, 54}, stages[i].name, "#2c3440", 16, "middle");
        for (int j = 0; j < 2; ++j) sketch.text({x + 62, 76 + 16 * static_cast<float>(j)}, stages[i].lines[j], "#2c3440", 12, "middle");
        if (i < 4) sketch.arrow({x + 126, 67}, {x + 146, 67}, {});
    }
    sketch.line({464, 104}, {20, 160}, {.stroke = grey, .dashes = "3 3"});
    sketch.line({588, 104}, {740, 160}, {.stroke = grey, .dashes = "3 3"});
    const char* const substep[][2] = {{"gravity, forces,", "damping"}, {"warm start", ""}, {"sweep", "with bias"}, {"positions", "move"}, {"sweep", "without bias"}};
    for (int i = 0; i < 5; ++i) {
        const float x = 40 + 138 * static_cast<float>(i);
        sketch.box({x, 176}, 112, 56, {.stroke = blue, .fill = "#e3effa"});
        const bool one = *substep[i][1] == '\0';
        sketch.text({x + 56, one ? 209.0f : 200.0f}, substep[i][0], "#2c3440", 13, "middle");
        sketch.text({x + 56, 218}, substep[i][1], "#2c3440", 13, "middle");
        if (i < 4) sketch.arrow({x + 114, 204}, {x + 136, 204}, {});
    }
    const Vec2 back[] = {{648, 234}, {648, 256}, {96, 256}};
    sketch.polyline(back, {.stroke = blue});
    sketch.arrow({96, 256}, {96, 234}, {.stroke = blue});
    sketch.text({380, 276}, "once per substep: 4 times by default; then restitution", blue, 13, "middle");
    sketch.text({20, 20}, "World::step", grey);
    return sketch;
}

// -- the tree: who may use whom ----------------------------------------------------------------------------------------------------------

Sketch draw_folders() {
    Sketch sketch(760, 210);
    const struct {
        float x, y;
        const char *name, *what;
    } folders[] = {{270, 140, "engine", "the library, all that a game links"},
                   {20, 70, "samples", "scenes, prefabs, programs, firmware"},
                   {520, 70, "tools", "adapters, comparison, lab, scripts"},
                   {270, 10, "tests", "what each promise stands on"}};
    for (const auto& f : folders) {
        sketch.box({f.x, f.y}, 220, 54, {.stroke = "#b0702c", .fill = "#fbe3bf"});
        sketch.text({f.x + 110, f.y + 23}, f.name, "#2c3440", 16, "middle");
        sketch.text({f.x + 110, f.y + 42}, f.what, "#2c3440", 11, "middle");
    }
    sketch.arrow({320, 66}, {320, 138}, {});
    sketch.arrow({268, 40}, {150, 68}, {});
    sketch.arrow({492, 40}, {610, 68}, {});
    sketch.arrow({518, 97}, {242, 97}, {});
    sketch.arrow({130, 126}, {268, 160}, {});
    sketch.arrow({630, 126}, {492, 160}, {});
    sketch.text({20, 200}, "An arrow reads: uses.", grey, 12);
    return sketch;
}

// -- pgs: the plane of two impulses, and where the updates lead ------------------------------------------------------------------------

/// The tower of docs/pgs.md: a box of `upper` kg on one of 1 kg, which falls at 1 m/s.
void draw_plane(Sketch& sketch, float left, float upper, const char* title) {
    const float m[] = {1, -1, -1, 1 + 1 / upper}, q[] = {-1, 0}, side = 250, range = 1.45f * (1 + upper);
    const auto at = [&](float x, float y) { return Vec2{left + side * x / range, 290 - side * y / range}; };
    const auto line = [&](Vec2 a, Vec2 b, const Pen& pen) { sketch.line(at(a.x, a.y), at(b.x, b.y), pen); };
    line({0, 0}, {range, 0}, {.stroke = grey});
    line({0, 0}, {0, range}, {.stroke = grey});
    line({1, 0}, {range, range - 1}, {.stroke = blue});                 // w0 = 0: x = 1 + y
    line({0, 0}, {range, range / m[3]}, {.stroke = green});             // w1 = 0: y = x / m11
    sketch.text(at(range, range - 1) + Vec2{4, 4}, "w0 = 0", blue, 12);
    sketch.text(at(range, range / m[3]) + Vec2{4, 10}, "w1 = 0", green, 12);
    float x[] = {0, 0};
    for (int i = 0; i < 24; ++i) {
        const int row = i % 2;
        const Vec2 from = {x[0], x[1]};
        x[row] = std::max(0.0f, x[row] - (q[row] + m[2 * row] * x[0] + m[2 * row + 1] * x[1]) / m[3 * row]);
        line(from, {x[0], x[1]}, {.stroke = "#c26a12", .width = 2});
        sketch.circle(at(x[0], x[1]), 2.5f, {.stroke = "#c26a12", .fill = "#c26a12"});
    }
    sketch.circle(at(1 + upper, upper), 7, {.stroke = red, .width = 2});
    sketch.text({left + 8, 28}, title, "#2c3440", 14);
    sketch.text({left + side / 2, 312}, "impulse from the ground", grey, 12, "middle");
    sketch.text({left + 8, 52}, "impulse between the boxes", grey, 12);
}

Sketch draw_pgs() {
    Sketch sketch(760, 325);
    draw_plane(sketch, 40, 1, "two boxes of 1 kg: 12 sweeps");
    draw_plane(sketch, 420, 9, "a box of 9 kg on one of 1 kg: 12 sweeps");
    return sketch;
}

constexpr struct {
    const char* name;
    Sketch (*draw)();
} pictures[] = {{"queries", draw_queries}, {"snapshots", draw_snapshots}, {"recording", draw_recording}, {"memory", draw_memory},
                {"lcp", draw_lcp},         {"step", draw_step},           {"folders", draw_folders},     {"pgs", draw_pgs}};

}  // namespace
}  // namespace islet::pictures

int main(int argc, char** argv) {
    if (argc == 2 && std::string_view(argv[1]) == "film") {
        std::fputs(islet::pictures::opening_film().c_str(), stdout);
        return 0;
    }
    for (const auto& picture : islet::pictures::pictures) {
        if (argc != 2 || std::string_view(argv[1]) != picture.name) continue;
        std::fputs(picture.draw().svg().c_str(), stdout);
        return 0;
    }
    std::fputs("usage: islet-pictures NAME, one of film", stderr);
    for (const auto& picture : islet::pictures::pictures) std::fprintf(stderr, " %s", picture.name);
    std::fputs("\n", stderr);
    return 2;
}
