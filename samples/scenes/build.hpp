// What several scenes build from: bodies with one shape, floors and pyramids.
#pragma once

#include <vector>

#include "../scene.hpp"

namespace islet::samples {

/// Adds a body and returns its index.
std::size_t add_body(Scene& scene, const BodyDef& def, std::vector<SceneShape> shapes);
/// A dynamic or static body with one shape.
std::size_t add_dynamic(Scene& scene, Vec2 position, const SceneGeometry& geometry, const ShapeDef& def = {}, float angle = 0);
std::size_t add_static(Scene& scene, Vec2 position, const SceneGeometry& geometry, const ShapeDef& def = {}, float angle = 0);

/// A static box 2 m thick, 2 * half_width wide, its top at y = 0.
std::size_t add_floor(Scene& scene, float half_width, const ShapeDef& def = {});

/// Boxes of half width `half` in rows of `rows`, rows - 1, ... 1, without gaps, row by row from the ground up. The lowest left box has its
/// left side at x = left, and its bottom at y = bottom. Returns the index of the first one; the top box is the last one made.
std::size_t add_pyramid(Scene& scene, int rows, float half, float left, float bottom, const ShapeDef& def = {});

/// Convex polygon through the points, which must be a hull already (checked: an empty polygon is refused by the engine).
Polygon polygon_of(std::initializer_list<Vec2> points);

}  // namespace islet::samples
