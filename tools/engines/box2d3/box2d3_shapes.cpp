#include <stdexcept>
#include <vector>

#include "box2d3_parts.hpp"

namespace islet::engines {

using samples::Chain;
using samples::SceneShape;

namespace {

/// Without points if Box2D refuses the polygon.
b2Hull hull_of(const Polygon& p) {
    b2Vec2 corners[max_polygon_vertices];
    for (std::uint32_t i = 0; i < p.count; ++i) corners[i] = to_b2(p.vertices[i]);
    return b2ComputeHull(corners, static_cast<int>(p.count));
}

/// Makes each kind of shape; std::visit picks one.
struct Maker {
    b2BodyId body;
    const b2ShapeDef& def;

    void operator()(const Circle& c) const {
        const b2Circle circle{to_b2(c.center), c.radius};
        b2CreateCircleShape(body, &def, &circle);
    }
    void operator()(const Capsule& c) const {
        const b2Capsule capsule{to_b2(c.point1), to_b2(c.point2), c.radius};
        b2CreateCapsuleShape(body, &def, &capsule);
    }
    void operator()(const Segment& s) const {
        const b2Segment segment{to_b2(s.point1), to_b2(s.point2)};
        b2CreateSegmentShape(body, &def, &segment);
    }
    void operator()(const HalfSpace& h) const { (*this)(samples::long_segment(h)); }
    void operator()(const Polygon& p) const {
        const b2Hull hull = hull_of(p);
        if (hull.count == 0) throw std::runtime_error("Box2D 3 refuses a polygon");
        const b2Polygon polygon = b2MakePolygon(&hull, p.radius);
        b2CreatePolygonShape(body, &def, &polygon);
    }
    /// Both engines' chains collide on the right of their direction.
    void operator()(const Chain& chain) const {
        std::vector<b2Vec2> points;
        for (const Vec2 p : chain.points) points.push_back(to_b2(p));
        if (!chain.loop) {  // Box2D takes the first and the last edge for neighbours only: straight on beyond the ends
            const std::vector<Vec2>& p = chain.points;
            points.insert(points.begin(), to_b2(2.0f * p[0] - p[1]));
            points.push_back(to_b2(2.0f * p[p.size() - 1] - p[p.size() - 2]));
        }
        b2ChainDef made = b2DefaultChainDef();
        made.points = points.data();
        made.count = static_cast<int>(points.size());
        made.materials = &def.material;
        made.materialCount = 1;
        made.filter = def.filter;
        made.isLoop = chain.loop;
        b2CreateChain(body, &made);
    }
};

}  // namespace

std::string box2d3_shape_lacks(const SceneShape& shape) {
    if (shape.def.sensor) return "sensors that tell what overlaps them";
    if (shape.def.pre_solve) return "hooks";
    if (const auto* polygon = std::get_if<Polygon>(&shape.geometry); polygon != nullptr && hull_of(*polygon).count == 0)
        return "polygons as small or thin as one here";
    if (const auto* chain = std::get_if<Chain>(&shape.geometry); chain != nullptr && chain->loop && chain->points.size() < 4) return "loops of three points";
    return {};
}

void add_box2d3_shape(b2BodyId body, const SceneShape& shape) {
    b2ShapeDef def = b2DefaultShapeDef();
    def.density = shape.def.density;
    def.material.friction = shape.def.friction;
    def.material.restitution = shape.def.restitution;
    def.material.rollingResistance = shape.def.rolling_resistance;
    def.material.tangentSpeed = shape.def.tangent_speed;
    def.filter.categoryBits = shape.def.filter.category;
    def.filter.maskBits = shape.def.filter.mask;
    def.filter.groupIndex = shape.def.filter.group;
    std::visit(Maker{body, def}, shape.geometry);
}

}  // namespace islet::engines
