#include "box2d_nearest.hpp"

#include <array>
#include <utility>

namespace islet::engines {

using samples::Scene;
using samples::SceneBody;
using samples::SceneGeometry;
using samples::SceneJoint;

namespace {

constexpr float diagonal = 0.70710678f;

/// The two round ends as three directions each, and the ends of the sides between them.
Polygon octagon_of(const Capsule& c) {
    const Vec2 u = normalize(c.point2 - c.point1);
    const Vec2 n = left_perp(u);
    const float r = c.radius;
    const std::array<Vec2, 8> points = {
        c.point2 + r * n,           c.point2 + r * diagonal * (u + n), c.point2 + r * diagonal * (u - n), c.point2 - r * n,
        c.point1 - r * n,           c.point1 - r * diagonal * (u + n), c.point1 + r * diagonal * (n - u), c.point1 + r * n,
    };
    return make_polygon(compute_hull(points));
}

/// Every corner moved out along the bisector of its two sides by the radius.
Polygon grown(const Polygon& p) {
    std::array<Vec2, max_polygon_vertices> points;
    for (std::uint32_t i = 0; i < p.count; ++i)
        points[i] = p.vertices[i] + p.radius * normalize(p.normals[i] + p.normals[(i + p.count - 1) % p.count]);
    return make_polygon(compute_hull(std::span<const Vec2>(points.data(), p.count)));
}

struct NearestJoint {
    void operator()(RevoluteJointDef& def) const { simplify(def); }
    void operator()(PrismaticJointDef& def) const { simplify(def); }
    template <class Def>
    void operator()(Def&) const {}

    template <class Def>
    static void simplify(Def& def) {
        def.spring.enable = false;
        if (def.motor.enable) def.friction = 0;
    }
};

}  // namespace

SceneBody box2d_nearest(SceneBody body) {
    for (samples::SceneShape& shape : body.shapes) {
        if (const auto* capsule = std::get_if<Capsule>(&shape.geometry)) {
            shape.geometry = octagon_of(*capsule);
        } else if (const auto* polygon = std::get_if<Polygon>(&shape.geometry); polygon != nullptr && polygon->radius > 0) {
            shape.geometry = grown(*polygon);
        }
    }
    return body;
}

SceneJoint box2d_nearest(SceneJoint joint) {
    std::visit(NearestJoint{}, joint.def);
    return joint;
}

Scene box2d_nearest(Scene scene) {
    for (SceneBody& body : scene.bodies) body = box2d_nearest(std::move(body));
    for (SceneJoint& joint : scene.joints) joint = box2d_nearest(std::move(joint));
    return scene;
}

}  // namespace islet::engines
