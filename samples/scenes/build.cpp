#include "build.hpp"

#include <utility>

namespace islet::samples {

Scene sleepless_scene(const char* name, int steps, const Aabb& view) {
    Scene scene;
    scene.name = name;
    scene.world.enable_sleep = false;
    scene.steps = steps;
    scene.view = view;
    return scene;
}

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

ShapeDef ghost(float density) {
    ShapeDef material;
    material.density = density;
    material.filter.mask = 0;
    return material;
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

namespace {

/// The frame of a body that lies at a point of the world with its x axis at an angle there.
JointFrame frame_at(const Scene& scene, std::size_t body, Vec2 point, float angle) {
    const BodyDef& def = scene.bodies[body].def;
    return {inv_transform_point({def.position, make_rot(def.angle)}, point), angle - def.angle};
}

JointBase base_at(const Scene& scene, std::size_t body_a, std::size_t body_b, Vec2 point_a, Vec2 point_b, float angle) {
    JointBase base;
    base.frame_a = frame_at(scene, body_a, point_a, angle);
    base.frame_b = frame_at(scene, body_b, point_b, angle);
    return base;
}

}  // namespace

std::size_t add_joint(Scene& scene, std::size_t body_a, std::size_t body_b, JointDef def) {
    scene.joints.push_back({body_a, body_b, std::move(def)});
    return scene.joints.size() - 1;
}

std::size_t add_gear(Scene& scene, std::size_t joint1, std::size_t joint2, float ratio) {
    GearJointDef def;
    def.ratio = ratio;
    return add_joint(scene, joint1, joint2, def);
}

RevoluteJointDef hinge_at(const Scene& scene, std::size_t body_a, std::size_t body_b, Vec2 point) {
    RevoluteJointDef def;
    def.base = base_at(scene, body_a, body_b, point, point, 0);
    return def;
}

WeldJointDef weld_at(const Scene& scene, std::size_t body_a, std::size_t body_b, Vec2 point) {
    WeldJointDef def;
    def.base = base_at(scene, body_a, body_b, point, point, 0);
    return def;
}

PrismaticJointDef slider_at(const Scene& scene, std::size_t body_a, std::size_t body_b, Vec2 point, Vec2 direction) {
    PrismaticJointDef def;
    def.base = base_at(scene, body_a, body_b, point, point, atan2(direction.y, direction.x));
    return def;
}

WheelJointDef wheel_at(const Scene& scene, std::size_t body_a, std::size_t body_b, Vec2 point, Vec2 direction) {
    WheelJointDef def;
    def.base = base_at(scene, body_a, body_b, point, point, atan2(direction.y, direction.x));
    return def;
}

DistanceJointDef rod_between(const Scene& scene, std::size_t body_a, std::size_t body_b, Vec2 point_a, Vec2 point_b) {
    DistanceJointDef def;
    def.base = base_at(scene, body_a, body_b, point_a, point_b, 0);
    def.length = distance(point_a, point_b);
    return def;
}

DistanceJointDef rope_between(const Scene& scene, std::size_t body_a, std::size_t body_b, Vec2 point_a, Vec2 point_b) {
    DistanceJointDef def = rod_between(scene, body_a, body_b, point_a, point_b);
    def.limit = {.enable = true, .lower = 0, .upper = def.length};
    return def;
}

PulleyJointDef pulley_over(const Scene& scene, std::size_t body_a, std::size_t body_b, Vec2 point_a, Vec2 ground_a, Vec2 ground_b,
                           Vec2 point_b) {
    PulleyJointDef def;
    def.base = base_at(scene, body_a, body_b, point_a, point_b, 0);
    def.ground_a = ground_a;
    def.ground_b = ground_b;
    return def;
}

void make_stiff(Scene& scene) {
    scene.world.solver.substeps = 8;
    scene.world.solver.joint_hertz = 120;
}

Polygon polygon_of(std::initializer_list<Vec2> points) { return make_polygon(compute_hull({points.begin(), points.size()})); }

}  // namespace islet::samples
