// What slides over a floor of boxes laid side by side sinks into it by a little, and so meets the side of the next box, or comes near its corner, from
// where it is. Each pair alone is right to push back; but no body can come to that side, because the box before covers it.
//
//        D: sunk in by s                normal n of D with S: the side's, or the corner's on the way to it
//     +------+                          q: a point in front of that side, a little below the corner
//     |   T  |  S                       q is inside T: the side is covered. A normal that leans towards it is right only as far as T's own
//     +------|q-------+ ...             surface leans there: not at all if T is flush, more where T falls away (a ridge).
//
// (Bullet, Jolt and bepuphysics2 mend the inner edges of triangle meshes in like ways; here there is no mesh, the neighbours are whatever the body touches.)
#include "world/seams.hpp"

#include "broadphase/contacts.hpp"
#include "collide/outline.hpp"
#include "math/scalar.hpp"
#include "world/bounds.hpp"

namespace islet::detail {

namespace {

inline constexpr float least_lean = 1.0e-4f;           // a normal that leans less does not lean
inline constexpr float never = 2.0f;                   // no cosine is as large
inline constexpr float gap_width = 0.2f * linear_slop; // m in front of a side that a neighbour must cover

// Signed distance of a point from the plane of a face of the core, body frame.
float height_over(const Polygon& p, std::uint32_t face, Vec2 point) { return dot(p.normals[face], point - p.vertices[face]); }

// A point in front of the face of p, near `point` but not at the face's ends.
Vec2 before_face(const Polygon& p, std::uint32_t face, Vec2 point) {
    const Vec2 start = p.vertices[face], edge = p.vertices[next(face, p.count)] - start;
    const float length = sqrt(length_squared(edge));
    const float inset = min(linear_slop, 0.5f * length);
    const float along = clamp(dot(point - start, edge) / length, inset, length - inset);
    return start + along / length * edge + (p.radius + gap_width) * p.normals[face];
}

// How far the neighbour's own surface near `point` leans towards `side`, as a cosine; 0 if it has none there, never if it does not hold `before`.
float lean_of(const Polygon& neighbor, Vec2 before, Vec2 point, Vec2 side) {
    float lean = 0;
    for (std::uint32_t i = 0; i < neighbor.count; ++i) {
        if (height_over(neighbor, i, before) > neighbor.radius) return never;
        if (abs(height_over(neighbor, i, point) - neighbor.radius) <= linear_slop) lean = max(lean, dot(neighbor.normals[i], side));
    }
    return lean;
}

const Polygon* polygon_of(const Core& core, std::uint32_t shape) {
    const Geometry& g = core.geometries[core.shapes[shape].geometry];
    return g.shape_type() == ShapeType::polygon ? &g.polygon : nullptr;
}

/// A piece of floor and what stands on it.
struct Floor {
    const Core& core;
    std::uint32_t shape;  // the piece
    const Polygon& piece;
    std::uint32_t other;  // the other shape's body

    // True if a neighbour covers the face at `point`, and is not itself turned as far as `normal`. Everything is in the piece's body frame.
    bool is_covered(std::uint32_t face, Vec2 point, Vec2 normal) const {
        const Vec2 side = piece.normals[face];
        const Vec2 before = before_face(piece, face, point);
        const std::uint32_t body = core.shapes[shape].body;
        const Transform at = body_transform(core, body);
        bool covered = false;
        for_each_contact(core, other, [&](std::uint32_t contact, std::uint32_t end) {
            const Contact& link = core.contacts[contact];
            const std::uint32_t neighbor = end == 0 ? link.shape_b : link.shape_a;
            const std::uint32_t its_body = core.shapes[neighbor].body;
            const bool fixed = its_body == body || (core.bodies[its_body].type() == BodyType::static_body && core.bodies[body].type() == BodyType::static_body);
            if (covered || neighbor == shape || !fixed) return;
            const Polygon* its = polygon_of(core, neighbor);
            const bool senses = ((core.shapes[link.shape_a].flags | core.shapes[link.shape_b].flags) & shape_sensor) != 0;
            if (its == nullptr || senses) return;
            const Transform to_neighbor = inv_mul(body_transform(core, its_body), at);
            const float lean = lean_of(*its, transform_point(to_neighbor, before), transform_point(to_neighbor, point), rotate(to_neighbor.q, side));
            covered = dot(normal, side) > lean + least_lean;
        });
        return covered;
    }

    // True if a point of contact is on a face that is covered.
    bool is_inner(Vec2 point, Vec2 normal) const {
        for (std::uint32_t i = 0; i < piece.count; ++i) {
            const bool leans = dot(piece.normals[i], normal) > least_lean;
            if (leans && height_over(piece, i, point) - piece.radius > -linear_slop && is_covered(i, point, normal)) return true;
        }
        return false;
    }
};

}  // namespace

void drop_inner_edges(const Core& core, const Contact& contact, const Transform& b_in_a, Manifold& manifold) {
    for (const bool piece_is_a : {true, false}) {
        const std::uint32_t shape = piece_is_a ? contact.shape_a : contact.shape_b;
        const std::uint32_t body = core.shapes[shape].body;
        const std::uint32_t other = core.shapes[piece_is_a ? contact.shape_b : contact.shape_a].body;
        const Polygon* piece = polygon_of(core, shape);
        if (core.is_dynamic(body) || piece == nullptr || core.bodies[other].contact_count < 2) continue;
        const Floor floor{core, shape, *piece, other};
        const Vec2 normal = piece_is_a ? manifold.normal : -inv_rotate(b_in_a.q, manifold.normal);
        bool inner = true;
        for (std::uint32_t i = 0; i < manifold.count && inner; ++i) {
            const Vec2 middle = piece_is_a ? manifold.points[i].point : inv_transform_point(b_in_a, manifold.points[i].point);
            inner = floor.is_inner(middle - 0.5f * manifold.points[i].separation * normal, normal);
        }
        if (inner) manifold.count = 0;
    }
}

}  // namespace islet::detail
