// What several scenes build from: bodies with one shape, floors, pyramids, and joints at points of the world.
#pragma once

#include <vector>

#include "harness/scene.hpp"

namespace islet::samples {

/// A scene without bodies in which nothing may sleep: what rests, rests by the solver's work.
Scene sleepless_scene(const char* name, int steps, const Aabb& view);

/// Adds a body and returns its index.
std::size_t add_body(Scene& scene, const BodyDef& def, std::vector<SceneShape> shapes);
/// A dynamic or static body with one shape.
std::size_t add_dynamic(Scene& scene, Vec2 position, const SceneGeometry& geometry, const ShapeDef& def = {}, float angle = 0);
std::size_t add_static(Scene& scene, Vec2 position, const SceneGeometry& geometry, const ShapeDef& def = {}, float angle = 0);

/// For bodies that are to meet nothing.
ShapeDef ghost(float density = 1);

/// A static box 2 m thick, 2 * half_width wide, its top at y = 0.
std::size_t add_floor(Scene& scene, float half_width, const ShapeDef& def = {});

/// Boxes of half width `half` in rows of `rows`, rows - 1, ... 1, without gaps, row by row from the ground up. The lowest left box has its
/// left side at x = left, and its bottom at y = bottom. Returns the index of the first one; the top box is the last one made.
std::size_t add_pyramid(Scene& scene, int rows, float half, float left, float bottom, const ShapeDef& def = {});

/// Adds a joint and returns its index.
std::size_t add_joint(Scene& scene, std::size_t body_a, std::size_t body_b, JointDef def);
/// A gear between two joints, by their indices.
std::size_t add_gear(Scene& scene, std::size_t joint1, std::size_t joint2, float ratio);

/// Definitions whose frames are where the bodies are now, so that a joint made of them starts without error and at coordinate 0: a hinge and a weld
/// at a point of the world; a slider and a wheel's strut through a point along a direction (of any length), positive that way.
RevoluteJointDef hinge_at(const Scene& scene, std::size_t body_a, std::size_t body_b, Vec2 point);
WeldJointDef weld_at(const Scene& scene, std::size_t body_a, std::size_t body_b, Vec2 point);
PrismaticJointDef slider_at(const Scene& scene, std::size_t body_a, std::size_t body_b, Vec2 point, Vec2 direction);
WheelJointDef wheel_at(const Scene& scene, std::size_t body_a, std::size_t body_b, Vec2 point, Vec2 direction);
/// A rod between two points of the world, as long as they are apart.
DistanceJointDef rod_between(const Scene& scene, std::size_t body_a, std::size_t body_b, Vec2 point_a, Vec2 point_b);
/// As a rod, but it may hang slack.
DistanceJointDef rope_between(const Scene& scene, std::size_t body_a, std::size_t body_b, Vec2 point_a, Vec2 point_b);
/// A rope from point_a over ground_a and ground_b to point_b, all in the world.
PulleyJointDef pulley_over(const Scene& scene, std::size_t body_a, std::size_t body_b, Vec2 point_a, Vec2 ground_a, Vec2 ground_b,
                           Vec2 point_b);

/// Stiffer joints than usual, at twice the time: 8 substeps and a joint_hertz of 120, a quarter of the substep rate. Under a force F a joint gives by
/// F / (m w^2), m being the effective mass of its bodies and w = 2 pi joint_hertz. For many light bodies under one load.
void make_stiff(Scene& scene);

/// Convex polygon through the points, which must be a hull already (checked: an empty polygon is refused by the engine).
Polygon polygon_of(std::initializer_list<Vec2> points);

}  // namespace islet::samples
