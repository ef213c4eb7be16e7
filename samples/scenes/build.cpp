#include "build.hpp"

#include <utility>

namespace islet::samples {

std::size_t add_body(Scene& scene, const BodyDef& def, std::vector<SceneShape> shapes) {
    scene.bodies.push_back({def, std::move(shapes)});
    return scene.bodies.size() - 1;
}

std::size_t add_dynamic(Scene& scene, Vec2 position, const SceneGeometry& geometry, const ShapeDef& def, float angle) {
    BodyDef body;
    body.type = BodyType::dynamic;
    body.position = position;
    body.angle = angle;
    return add_body(scene, body, {{geometry, def}});
}

std::size_t add_static(Scene& scene, Vec2 position, const SceneGeometry& geometry, const ShapeDef& def, float angle) {
    BodyDef body;
    body.position = position;
    body.angle = angle;
    return add_body(scene, body, {{geometry, def}});
}

std::size_t add_floor(Scene& scene, float half_width, const ShapeDef& def) {
    return add_static(scene, {0, -1}, make_box(half_width, 1), def);
}

std::size_t add_pyramid(Scene& scene, int rows, float half, float left, float bottom, const ShapeDef& def) {
    const std::size_t first = scene.bodies.size();
    const Polygon box = make_box(half, half);
    for (int row = 0; row < rows; ++row) {
        const float y = (2 * static_cast<float>(row) + 1) * half + bottom;
        for (int column = row; column < rows; ++column) {
            const float x = (static_cast<float>(row) + 1) * half + 2 * static_cast<float>(column - row) * half + left;
            add_dynamic(scene, {x, y}, box, def);
        }
    }
    return first;
}

Polygon polygon_of(std::initializer_list<Vec2> points) { return make_polygon(compute_hull({points.begin(), points.size()})); }

}  // namespace islet::samples
