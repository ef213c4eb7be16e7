// Pyramids of boxes: the small one that must stand for a minute, the one far out, and the two of the benchmark.
#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {

Scene make_pyramid() {
    Scene scene = sleepless_scene("pyramid", 3600, {{-8, -1.5f}, {8, 11.5f}});
    add_floor(scene, 12);
    const std::size_t first = add_pyramid(scene, 10, 0.5f, -5, 0);

    scene.check = [places = places_of(scene, first, scene.bodies.size()), first](const Engine& engine) -> std::vector<CheckLine> {
        const Drift all = drift_from(places, engine, first);
        return {
            at_most("farthest any box moved sideways in 60 s (m)", all.sideways, 0.01),
            at_most("farthest any box turned (rad)", all.turn, 0.01),
            at_most("farthest any box sank (m)", all.sink, 0.02),
            at_most("deepest overlap (m)", engine.max_penetration(), 0.005),
            at_most("fastest box (m/s)", max_speed(engine), 0.01),
        };
    };
    return scene;
}

Scene make_far_from_origin() {
    constexpr float far = 10000;  // m; a float there steps by 1 mm
    Scene scene = sleepless_scene("far_from_origin", 600, {{far - 8, -1.5f}, {far + 8, 11.5f}});
    add_static(scene, {far, -1}, make_box(12, 1));
    const std::size_t first = add_pyramid(scene, 10, 0.5f, far - 5, 0);

    scene.check = [places = places_of(scene, first, scene.bodies.size()), first](const Engine& engine) -> std::vector<CheckLine> {
        const Drift all = drift_from(places, engine, first);
        return {
            at_most("farthest any box moved sideways in 10 s (m)", all.sideways, 0.05),
            at_most("farthest any box turned (rad)", all.turn, 0.02),
            at_most("farthest any box sank (m)", all.sink, 0.03),
            at_most("deepest overlap (m)", engine.max_penetration(), 0.01),
        };
    };
    return scene;
}

Scene make_large_pyramid() {
    constexpr int base = 100;
    Scene scene = sleepless_scene("large_pyramid", 500, {{-58, -4}, {58, 103}});
    add_floor(scene, 100);
    const std::size_t first = add_pyramid(scene, base, 0.5f, -0.5f * base, 0);

    scene.check = [places = places_of(scene, first, scene.bodies.size()), first](const Engine& engine) {
        const Drift all = drift_from(places, engine, first);
        std::vector<CheckLine> lines = count_lines(engine, 5051, 5051, 14950);
        lines.push_back(at_most("farthest any box moved sideways (m)", all.sideways, 0.5));
        lines.push_back(at_most("farthest any box turned (rad)", all.turn, 0.1));
        lines.push_back(at_most("farthest any box sank (m)", all.sink, 1.0));
        lines.push_back(at_most("deepest overlap (m)", engine.max_penetration(), 0.05));
        lines.push_back(at_most("kinetic energy (J)", kinetic_energy(engine), 50));
        return lines;
    };
    return scene;
}

Scene make_many_pyramids() {
    constexpr int rows = 20, columns = 20, base = 10;
    constexpr float half = 0.5f;
    constexpr float pitch = 2 * half * (base + 1);  // one box wider, and one taller, than a pyramid
    constexpr float width = columns * pitch;
    Scene scene = sleepless_scene("many_pyramids", 200, {{-113, -2}, {113, 221}});

    std::vector<SceneShape> floors;
    for (int row = 0; row < rows; ++row) {
        const float y = static_cast<float>(row) * pitch;
        floors.push_back({Segment{{-0.5f * width, y}, {0.5f * width, y}}, {}});
    }
    const std::size_t first = add_body(scene, {}, std::move(floors)) + 1;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const float left = -0.5f * width + static_cast<float>(column) * pitch + half;
            add_pyramid(scene, base, half, left, static_cast<float>(row) * pitch);
        }
    }

    scene.check = [places = places_of(scene, first, scene.bodies.size()), first](const Engine& engine) {
        const Drift all = drift_from(places, engine, first);
        std::vector<CheckLine> lines = count_lines(engine, 22001, 22020, 58000);
        lines.push_back(at_most("farthest any box moved sideways (m)", all.sideways, 0.02));
        lines.push_back(at_most("farthest any box turned (rad)", all.turn, 0.02));
        lines.push_back(at_most("farthest any box sank (m)", all.sink, 0.03));
        lines.push_back(at_most("deepest overlap (m)", engine.max_penetration(), 0.01));
        lines.push_back(at_most("kinetic energy (J)", kinetic_energy(engine), 5));
        return lines;
    };
    return scene;
}

}  // namespace islet::samples
