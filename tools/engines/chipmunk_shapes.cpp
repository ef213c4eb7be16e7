#include "chipmunk_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "chipmunk_joints.hpp"

namespace islet::engines {

using samples::Chain;
using samples::Scene;
using samples::SceneBody;
using samples::SceneShape;

namespace {

/// Half of make_chipmunk_shapes for each geometry; std::visit picks one.
struct Maker {
    cpBody* body;

    using Shapes = std::vector<cpShape*>;

    Shapes operator()(const Circle& c) const { return {cpCircleShapeNew(body, double(c.radius), to_cp(c.center))}; }
    Shapes operator()(const Capsule& c) const { return {cpSegmentShapeNew(body, to_cp(c.point1), to_cp(c.point2), double(c.radius))}; }
    Shapes operator()(const Segment& s) const { return {cpSegmentShapeNew(body, to_cp(s.point1), to_cp(s.point2), 0)}; }

    Shapes operator()(const HalfSpace& h) const { return (*this)(samples::long_segment(h)); }

    Shapes operator()(const Polygon& p) const {
        std::array<cpVect, max_polygon_vertices> corners;
        for (std::uint32_t i = 0; i < p.count; ++i) corners[i] = to_cp(p.vertices[i]);
        return {cpPolyShapeNewRaw(body, static_cast<int>(p.count), corners.data(), double(p.radius))};
    }

    /// A segment for each link. Told of its neighbours, a segment lets nothing catch on the corner between them.
    Shapes operator()(const Chain& chain) const {
        const std::vector<Vec2>& p = chain.points;
        const std::size_t links = chain.loop ? p.size() : p.size() - 1;
        Shapes shapes;
        for (std::size_t i = 0; i < links; ++i) {
            const Vec2 from = p[i], to = p[(i + 1) % p.size()];
            // Straight on beyond the ends.
            const bool first = !chain.loop && i == 0, last = !chain.loop && i + 1 == links;
            const Vec2 before = first ? 2.0f * from - to : p[(i + p.size() - 1) % p.size()];
            const Vec2 after = last ? 2.0f * to - from : p[(i + 2) % p.size()];
            shapes.push_back(cpSegmentShapeNew(body, to_cp(from), to_cp(to), 0));
            cpSegmentShapeSetNeighbors(shapes.back(), to_cp(before), to_cp(after));
        }
        return shapes;
    }
};

/// Mass properties of one shape at its density; lines have none.
struct MassOf {
    float density;

    MassData operator()(const Segment&) const { return {}; }
    MassData operator()(const Chain&) const { return {}; }
    MassData operator()(const HalfSpace&) const { return {}; }
    template <class Solid>
    MassData operator()(const Solid& solid) const {
        return compute_mass(solid, density);
    }
};

cpShapeFilter filter_of(const Filter& filter) {
    // Shapes of one group never meet, as those of one negative group of Islet's.
    return cpShapeFilterNew(static_cast<cpGroup>(-static_cast<std::int64_t>(filter.group)), filter.category, filter.mask);
}

std::string shape_lacks(const SceneShape& shape) {
    if (shape.def.rolling_resistance > 0) return "rolling resistance";
    if (shape.def.tangent_speed != 0) return "surface speed that follows an outline";
    if (shape.def.sensor) return "sensors that tell what overlaps them";
    if (shape.def.pre_solve) return "hooks";
    if (shape.def.filter.group > 0) return "groups of shapes that always collide";
    return {};
}

std::string body_lacks(const SceneBody& body) {
    if (body.def.lock_x || body.def.lock_y) return "locks of an axis";
    if (!body.def.enabled) return "disabled bodies";
    if (body.def.bullet) return "continuous collision, without which bullets pass through things";
    for (const SceneShape& shape : body.shapes) {
        if (std::string what = shape_lacks(shape); !what.empty()) return what;
    }
    return {};
}

/// Bodies that fall asleep are compared; what never does has no threshold.
bool may_sleep(const SceneBody& body) { return body.def.type == BodyType::dynamic && body.def.enable_sleep; }

std::string sleep_lacks(const Scene& scene) {
    const double common = chipmunk_idle_speed(scene);
    const auto differs = [common](const SceneBody& body) { return may_sleep(body) && double(body.def.sleep_threshold) != common; };
    if (std::any_of(scene.bodies.begin(), scene.bodies.end(), differs)) return "sleep thresholds of single bodies";
    return common > 0 ? "" : "sleep threshold of 0";
}

}  // namespace

double chipmunk_idle_speed(const Scene& scene) {
    const auto first = std::find_if(scene.bodies.begin(), scene.bodies.end(), may_sleep);
    return double(first != scene.bodies.end() ? first->def.sleep_threshold : BodyDef{}.sleep_threshold);
}

std::string chipmunk_lacks(const Scene& scene) {
    const auto sentence = [](const std::string& what) { return "Chipmunk 7 has no " + what; };
    for (const SceneBody& body : scene.bodies) {
        if (const std::string what = body_lacks(body); !what.empty()) return sentence(what);
    }
    if (scene.world.enable_sleep) {
        if (const std::string what = sleep_lacks(scene); !what.empty()) return sentence(what);
    }
    for (const samples::SceneJoint& joint : scene.joints) {
        if (const std::string what = chipmunk_joint_lacks(scene, joint); !what.empty()) return sentence(what);
    }
    return {};
}

std::vector<cpShape*> make_chipmunk_shapes(cpBody* body, const SceneShape& shape) {
    std::vector<cpShape*> made = std::visit(Maker{body}, shape.geometry);
    for (cpShape* part : made) {
        // Chipmunk multiplies the frictions of two shapes: of their roots, that is the geometric mean Islet takes.
        cpShapeSetFriction(part, std::sqrt(double(shape.def.friction)));
        cpShapeSetElasticity(part, double(shape.def.restitution));
        cpShapeSetFilter(part, filter_of(shape.def.filter));
    }
    return made;
}

MassData chipmunk_mass(const SceneBody& body) {
    MassData total;
    for (const SceneShape& shape : body.shapes) {
        const MassData part = std::visit(MassOf{shape.def.density}, shape.geometry);
        if (!(part.mass > 0)) continue;
        const float mass = total.mass + part.mass;
        // Two parts about their common centre: each part's own, and m1 m2 / (m1 + m2) times the square of their distance.
        total.inertia += part.inertia + total.mass * part.mass / mass * distance_squared(total.center, part.center);
        total.center += (part.mass / mass) * (part.center - total.center);
        total.mass = mass;
    }
    return total;
}

}  // namespace islet::engines
