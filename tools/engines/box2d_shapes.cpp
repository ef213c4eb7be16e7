#include "box2d_shapes.hpp"

#include <array>
#include <vector>

#include "box2d_joints.hpp"
#include "box2d_nearest.hpp"

namespace islet::engines {

using samples::Chain;
using samples::Scene;
using samples::SceneBody;
using samples::SceneGeometry;
using samples::SceneShape;

namespace {

b2Vec2 to_b2(Vec2 v) { return {v.x, v.y}; }

/// Half of make_box2d_shape for each geometry; std::visit picks one.
struct Maker {
    Skin skin;

    std::unique_ptr<b2Shape> operator()(const Circle& circle) const {
        auto shape = std::make_unique<b2CircleShape>();
        shape->m_p = to_b2(circle.center);
        shape->m_radius = circle.radius;
        return shape;
    }

    std::unique_ptr<b2Shape> operator()(const Capsule&) const { return nullptr; }

    std::unique_ptr<b2Shape> operator()(const Segment& segment) const {
        auto shape = std::make_unique<b2EdgeShape>();
        shape->SetTwoSided(to_b2(segment.point1), to_b2(segment.point2));
        if (skin == Skin::inside) shape->m_radius = 0;  // a segment has no inside that could take the skin
        return shape;
    }

    std::unique_ptr<b2Shape> operator()(const HalfSpace& h) const { return (*this)(samples::long_segment(h)); }

    std::unique_ptr<b2Shape> operator()(const Polygon& polygon) const {
        if (polygon.radius > 0) return nullptr;
        std::array<b2Vec2, max_polygon_vertices> points;
        const float inset = skin == Skin::inside && can_inset(polygon, b2_polygonRadius) ? b2_polygonRadius : 0.0f;
        for (std::uint32_t i = 0; i < polygon.count; ++i) points[i] = to_b2(inset_vertex(polygon, i, inset));
        auto shape = std::make_unique<b2PolygonShape>();
        shape->Set(points.data(), static_cast<int32>(polygon.count));
        return shape;
    }

    /// Both engines' chains collide on the right of their direction.
    std::unique_ptr<b2Shape> operator()(const Chain& chain) const {
        std::vector<b2Vec2> points;
        for (Vec2 p : chain.points) points.push_back(to_b2(p));
        const auto count = points.size();
        auto shape = std::make_unique<b2ChainShape>();
        if (chain.loop) {
            shape->CreateLoop(points.data(), static_cast<int32>(count));
        } else {
            // Straight on beyond the ends.
            const b2Vec2 before = 2.0f * points[0] - points[1];
            const b2Vec2 after = 2.0f * points[count - 1] - points[count - 2];
            shape->CreateChain(points.data(), static_cast<int32>(count), before, after);
        }
        if (skin == Skin::inside) shape->m_radius = 0;
        return shape;
    }

    /// Corner i after both its edges have moved inwards by d: v - d (n1 + n2) / (1 + n1 . n2).
    static Vec2 inset_vertex(const Polygon& p, std::uint32_t i, float d) {
        const Vec2 n1 = p.normals[(i + p.count - 1) % p.count], n2 = p.normals[i];
        return p.vertices[i] - (d / (1 + dot(n1, n2))) * (n1 + n2);
    }

    /// False if an edge would all but vanish.
    static bool can_inset(const Polygon& p, float d) {
        for (std::uint32_t i = 0; i < p.count; ++i) {
            const Vec2 edge = p.vertices[(i + 1) % p.count] - p.vertices[i];
            const Vec2 left = inset_vertex(p, (i + 1) % p.count, d) - inset_vertex(p, i, d);
            if (dot(left, edge) < 0.25f * dot(edge, edge)) return false;
        }
        return true;
    }
};

std::string shape_lacks(const SceneShape& shape) {
    if (std::holds_alternative<Capsule>(shape.geometry)) return "capsules";
    if (const auto* polygon = std::get_if<Polygon>(&shape.geometry); polygon != nullptr && polygon->radius > 0) return "rounded polygons";
    if (shape.def.rolling_resistance > 0) return "rolling resistance";
    if (shape.def.tangent_speed != 0) return "surface speed";
    if (shape.def.filter.category > 0xffff) return "collision categories beyond the sixteenth";
    return {};
}

}  // namespace

std::string box2d_lacks(const Scene& scene) {
    for (const SceneBody& body : scene.bodies) {
        for (const SceneShape& shape : body.shapes) {
            if (std::string what = shape_lacks(shape); !what.empty()) return "Box2D 2.4 has no " + what;
        }
    }
    for (const samples::SceneJoint& joint : scene.joints) {
        if (std::string what = joint_lacks(joint); !what.empty()) return "Box2D 2.4 has no " + what;
    }
    return {};
}

std::string box2d_lacks_even_nearest(const Scene& scene) { return box2d_lacks(box2d_nearest(scene)); }

std::unique_ptr<b2Shape> make_box2d_shape(const SceneGeometry& geometry, Skin skin) { return std::visit(Maker{skin}, geometry); }

b2MassData box2d_mass(const SceneBody& body) {
    b2MassData total;
    total.mass = 0;
    total.center.SetZero();
    total.I = 0;
    for (const SceneShape& shape : body.shapes) {
        if (!(shape.def.density > 0)) continue;
        b2MassData part;
        make_box2d_shape(shape.geometry, Skin::outside)->ComputeMass(&part, shape.def.density);
        total.mass += part.mass;
        total.center += part.mass * part.center;
        total.I += part.I;
    }
    if (total.mass > 0) total.center *= 1 / total.mass;
    return total;
}

}  // namespace islet::engines
