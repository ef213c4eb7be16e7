// Circles of many sizes, squeezed into a closed box.
#include "build.hpp"
#include "harness/checks.hpp"
#include "random.hpp"
#include "scenes.hpp"

namespace islet::samples {

Scene make_confined() {
    constexpr int columns = 20, rows = 20;
    constexpr float half = 10, wall = 0.5f;  // m
    Scene scene;
    scene.name = "confined";
    scene.steps = 900;
    scene.view = {{-16, -1.5f}, {16, 21.5f}};
    const Vec2 walls[] = {{0, -wall}, {0, 2 * half + wall}, {-half - wall, half}, {half + wall, half}};
    std::vector<SceneShape> box;
    for (const Vec2 p : walls) box.push_back({make_offset_box(p.x == 0 ? half + 2 * wall : wall, p.x == 0 ? wall : half, {p, {}}), {}});
    const std::size_t first = add_body(scene, {}, std::move(box)) + 1;

    // Four fifths of the area is filled. The biggest overlap their neighbours to begin with, and have to make themselves room.
    Random random(7);
    double area = 0;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const float radius = random.uniform(0.36f, 0.62f);
            const Vec2 p = {static_cast<float>(column) - half + 0.5f, static_cast<float>(row) + 0.5f};
            add_dynamic(scene, {clamp(p.x, -half + radius, half - radius), clamp(p.y, radius, 2 * half - radius)}, Circle{{}, radius});
            area += double(pi * radius * radius);
        }
    }

    // Chains of circles carry the load: two light ones (m = 0.2 kg reduced) under 200 N give way by 200 / (m (2 pi 30)^2) = 28 mm.
    scene.check = [first, filled = area / double(4 * half * half)](const Engine& engine) -> std::vector<CheckLine> {
        return {
            near_line("share of the box that the circles fill", filled, 0.78, 0.03),
            at_most("circles outside the box", double(count_outside(engine, {{-half, 0}, {half, 2 * half}})), 0),
            near_line("circles in the box", double(engine.counts().bodies - first), double(columns * rows), 0),
            at_most("deepest overlap (m)", engine.max_penetration(), 0.06),
            at_most("fastest circle (m/s)", max_speed(engine), 0.05),
        };
    };
    return scene;
}

}  // namespace islet::samples
