// A body that slides over a floor of boxes side by side sinks into it a little. So it meets the side of the next box, or comes near its corner. Each pair of
// shapes by itself is right to push back, but no body can really come to that side, because the box before covers it.
//
//        D: sunk in by s                normal n of D with S: the side's, or the corner's on the way to it
//     +------+                          The line just in front of that side, as far as D reaches along it, is inside T: the side is covered. A normal
//     |   T  |  S                       that leans towards it is right only as far as T's own surface leans there: not at all if T is flush, more
//     +------|+-------+ ...             where T falls away (a ridge). If S rises above T, part of the side is bare: it is a wall, and stops D.
//
// Where pieces have gaps, round edges, or meet in corners alone, no neighbour covers the side. But while D stands on T, it is above the line of T's face, and a
// piece that does not rise above that line is below it: no motion along the line brings the two together.
//
//        D: stands on face f of T
//     +------+
//     |   T  |   gap    S: below the line of f. A normal that would push D back along f is wrong.
//     +------|- - - - -+-------+ ...
//
// A contact along a covered side, or back along the floor, is made anew: along that other face of S in which D is least deep. If D is clear of that face there
// is no contact, since the neighbour alone holds D.
//
// A line (a segment, a capsule, a segment of a chain) has no sides, but its ends are met like corners. It counts as a box behind the face that looks at D. So
// lines laid end to end, or flush beside a box, are a floor like any other.
//
// The faster a body is, the farther a contact looks ahead. So the bevelled edge of a crate over a seam has two points: the near one at the corner of S, the far
// one ahead, over the top of S. The near one decides.
//
// The pieces belong to one body, which may be dynamic and much heavier than what stands on it, or to static bodies.
//
// (Bullet, Jolt and bepuphysics2 correct the inner edges of triangle meshes in similar ways. Here there is no mesh: the neighbours are the shapes that the body
// touches.)
#include "../exact.hpp"

#include "../step/inner_edges.hpp"

#include "../bodies/bounds.hpp"
#include "../collide/outline.hpp"
#include "../graph/contacts.hpp"
#include "../math/scalar.hpp"
#include "../shapes/shape_types.hpp"

namespace islet::detail {

namespace {

inline constexpr float least_lean = 1.0e-4f;               // the least lean of a normal, as a cosine, that counts
inline constexpr float least_slope = 1.0e-6f;              // sine of the angle below which a line is parallel to a face
inline constexpr float most_rise = 0.1f;                   // the greatest lean of a face that still goes on as the ground before it
inline constexpr float ridge_room = 0.05f;                 // share of a ridge's angle: what tips over it sinks in, and so leans a little too far
inline constexpr std::uint32_t most_pieces = 4;            // the most pieces in a row that cover one side; a side behind more is not part of a floor
inline constexpr float gap_width = 0.2f * linear_slop;     // m: a neighbour that covers a side holds what is this far in front of it
inline constexpr float end_reach = 0.8f * linear_slop;     // m: a line holds what is this far beyond its ends; less than where a surface counts as near
inline constexpr float piece_depth = 2.0f * linear_slop;   // m: of a line as a piece
inline constexpr float nested_depth = 4.0f * linear_slop;  // m: what is this deep in a dynamic body does not slide over it
inline constexpr std::uint32_t front_face = 2;             // of the box of a line
inline constexpr float behind_line = 10.0f * linear_slop;  // m: what a line covers of others, behind it; what reaches farther there is past its end
inline constexpr float most_round = 2.0f * linear_slop;    // m: of the corners of a piece that covers a side; there is a groove above rounder ones
inline constexpr bool has_lines = ShapeRow<Capsule>::is_there || ShapeRow<Segment>::is_there || ShapeRow<ChainSegment>::is_there;

// Signed distance of a point from the plane of a face of the core.
ISLET_SHARED float height_over(const Outline& p, std::uint32_t face, Vec2 point) { return dot(p.normals[face], point - p.vertices[face]); }

// True of what has no faces and is no circle: of a capsule, a segment, a segment of a chain.
bool is_line(const Geometry& g) { return has_lines && faces_of(g) == nullptr && corners_of(g).count == 2; }

// The faces of a piece that stands at `pose`: a polygon's own, or those of the box of some depth behind that face of a line which looks at `viewer`, longer by
// `reach` at either end. None (count 0) if the shape is no piece, or is met from its front alone and looks away.
ISLET_SHARED Outline piece_of(const Geometry& g, const Transform& pose, Vec2 viewer, float depth, float reach) {
    if (const Polygon* faces = faces_of(g)) return outline_of(*faces, pose, {0, 0});
    const Corners line = corners_of(g);
    if (!has_lines || line.count != 2) return {};
    const Vec2 start = transform_point(pose, line.points[0]), edge = transform_point(pose, line.points[1]) - start;
    const float whole = length(edge);
    Rot q = {edge.x / whole, edge.y / whole};
    if (cross(edge, viewer - start) < 0) {
        q = {-q.c, -q.s};
    } else if (kind_of(g) == ShapeKind::front) {
        return {};
    }
    const Vec2 center = start + 0.5f * edge + (line.radius - 0.5f * depth) * Vec2{-q.s, q.c};
    return outline_of(make_box(0.5f * whole + reach, 0.5f * depth), {center, q}, {0, 0});
}

/// Part of a line, m from its start.
struct Span {
    float low, high;
};

// The part of the line that the polygon holds; empty (low above high) if none.
Span held_by(const Outline& p, Vec2 start, Vec2 direction, Span part) {
    for (std::uint32_t i = 0; i < p.count; ++i) {
        const float height = height_over(p, i, start) - min(p.radius, most_round);
        const float slope = dot(p.normals[i], direction);
        if (abs(slope) < least_slope) {
            if (height > 0) return {1, 0};
        } else if (slope > 0) {
            part.high = min(part.high, -height / slope);
        } else {
            part.low = max(part.low, -height / slope);
        }
    }
    return part;
}

// True if the polygon, in its own frame, holds the point.
bool holds(const Polygon& p, Vec2 point) {
    for (std::uint32_t i = 0; i < p.count; ++i)
        if (dot(p.normals[i], point - p.vertices[i]) > min(p.radius, most_round)) return false;
    return true;
}

// How far a piece rises above the line of another's face.
float rise_over(const Outline& other, std::uint32_t face, const Outline& piece) {
    float highest = -3.0e38f;
    for (std::uint32_t i = 0; i < piece.count; ++i) highest = max(highest, height_over(other, face, piece.vertices[i]));
    return highest + piece.radius - other.radius;
}

// m: how far a body will have gone in this step when it stands there, in a frame that stands at `frame` in the world.
ISLET_SHARED Vec2 way_to(const Core& core, std::uint32_t body, const Transform& stands, const Transform& frame) {
    return transform_point(stands, core.bodies[body].local_center) - inv_transform_point(frame, core.poses[body].center);
}

const Geometry& geometry_at(const Core& core, std::uint32_t shape) { return core.geometries[core.shapes[shape].geometry]; }

/// The shape that stands on a piece of floor, in the frame of the manifold.
struct Standing {
    std::uint32_t body;
    Vec2 corners[max_polygon_vertices];
    std::uint32_t count;
    float radius;
    Vec2 way;  // m, that its body will have gone in this step when it stands there
    Vec2 middle = {0, 0};

    Standing(std::uint32_t of, const Corners& shape, const Transform& pose, Vec2 gone) : body(of), count(shape.count), radius(shape.radius), way(gone) {
        for (std::uint32_t i = 0; i < count; ++i) {
            corners[i] = transform_point(pose, shape.points[i]);
            middle += 1.0f / static_cast<float>(count) * corners[i];
        }
    }

    // The least height of a corner above a face of the core.
    float lowest_over(const Outline& p, std::uint32_t face) const {
        float lowest = 3.0e38f;
        for (std::uint32_t i = 0; i < count; ++i) lowest = min(lowest, height_over(p, face, corners[i]));
        return lowest;
    }

    // Where its corners are along a line, those at most `height` to the right of it.
    Span corners_along(Vec2 start, Vec2 along, float height) const {
        Span reach = {3.0e38f, -3.0e38f};
        for (std::uint32_t i = 0; i < count; ++i) {
            const Vec2 to = corners[i] - start;
            if (cross(to, along) > height) continue;
            reach = {min(reach.low, dot(to, along)), max(reach.high, dot(to, along))};
        }
        return reach;
    }
};

/// The face of a neighbour on which a shape stands.
struct Ground {
    Vec2 normal, back;  // unit: out of the face; along it, from the piece to its neighbour
    bool is_there = false;

    // True if a face of the piece goes on as the ground does: it may rise by as little as the piece may, but not fall away.
    bool goes_on(Vec2 face) const {
        const float rise = dot(face, back);
        return dot(face, normal) > 0 && rise > -10.0f * least_lean && rise < most_rise;
    }
};

/// The corner of a shape that is deepest under the line of a piece's face, and its height above the face's core.
struct Depth {
    std::uint32_t face = null_index, corner = 0;
    float gap = -3.0e38f;  // m
};

/// A piece of floor and the shape that stands on it. Everything is in the frame of the manifold.
struct Floor {
    const Core& core;
    std::uint32_t shape;     // the piece
    const Transform& frame;  // of the manifold, in the world
    const Standing& other;
    Outline piece;
    float rounding;  // m, of the piece's ends

    // The next piece near the other body that cannot move against this one (or is this one), and where it stands; null_index at the end. `key` is where the
    // list of contacts goes on.
    ISLET_SHARED std::uint32_t next_piece(std::uint32_t& key, Transform& pose) const {
        const std::uint32_t body = core.shapes[shape].body;
        const bool moves = core.is_dynamic(body);
        while (key != 0) {
            const Contact& record = core.contacts[constraint_of_key(key)];
            key = record.next[side_of_key(key)];
            const bool a_is_other = core.shapes[record.shape_a].body == other.body;
            if (!a_is_other && core.shapes[record.shape_b].body != other.body) continue;
            const std::uint32_t index = a_is_other ? record.shape_b : record.shape_a;
            const Shape& its = core.shapes[index];
            const bool fixed = its.body == body || (core.bodies[its.body].type() == BodyType::static_body && core.bodies[body].type() == BodyType::static_body);
            const std::uint32_t flags = core.shapes[record.shape_a].flags | core.shapes[record.shape_b].flags;
            if (!fixed || (flags & (shape_sensor | shape_pre_solve | shape_one_way_bits)) != 0) continue;  // it holds nothing, or may not
            if (moves && is_line(core.geometries[its.geometry])) continue;
            pose = inv_mul(frame, body_transform(core, its.body));
            return index;
        }
        return null_index;
    }

    // Where that list begins: the other body's. A body that moves has no neighbours but its own, so its list will do if it is shorter.
    std::uint32_t first_key() const {
        const Body &own = core.bodies[core.shapes[shape].body], &standing = core.bodies[other.body];
        return (own.type() == BodyType::dynamic && own.contact_count < standing.contact_count ? own : standing).contact_head;
    }

    // Calls visit(neighbour, true for a line) for each of these pieces but this one.
    template <class Visit>
    void for_each_neighbor(Visit&& visit) const {
        Transform pose;
        std::uint32_t key = first_key();
        for (std::uint32_t index = next_piece(key, pose); index != null_index; index = next_piece(key, pose)) {
            if (index == shape) continue;
            const Geometry& g = geometry_at(core, index);
            const Outline its = piece_of(g, pose, other.middle, behind_line, end_reach);
            if (its.count != 0) visit(its, is_line(g));
        }
    }

    // True if no polygon is just in front of the face of a piece near `point`.
    ISLET_SHARED bool is_bare(const Outline& its, std::uint32_t face, Vec2 point) const {
        const Vec2 normal = its.normals[face], along = left_perp(normal), corner = its.vertices[face];
        const float length = dot(its.vertices[next(face, its.count)] - corner, along);
        const float inset = min(2.0f * linear_slop, 0.5f * length);
        const Vec2 spot = corner + clamp(dot(point - corner, along), inset, length - inset) * along + (its.radius + gap_width) * normal;
        Transform pose;
        std::uint32_t key = first_key();
        for (std::uint32_t index = next_piece(key, pose); index != null_index; index = next_piece(key, pose)) {
            const Polygon* faces = faces_of(geometry_at(core, index));
            if (faces != nullptr && holds(*faces, inv_transform_point(pose, spot))) return false;
        }
        return true;
    }

    // The normal of the bare face of a piece near `point` that leans most towards `side`; zero if none leans that way.
    ISLET_SHARED Vec2 lean_of(const Outline& its, Vec2 point, Vec2 side) const {
        Vec2 lean = {0, 0};
        for (std::uint32_t i = 0; i < its.count; ++i) {
            const bool near = abs(height_over(its, i, point) - its.radius) <= linear_slop;
            if (near && dot(its.normals[i], side) > dot(lean, side) && is_bare(its, i, point)) lean = its.normals[i];
        }
        return lean;
    }

    // True if neighbours cover the face as far as the other shape reaches along it, and `normal` leans over their own surface at `point`.
    ISLET_SHARED bool is_covered(std::uint32_t face, Vec2 point, Vec2 normal) const {
        const Vec2 side = piece.normals[face], along = left_perp(side);
        const Vec2 start = piece.vertices[face] + (piece.radius + gap_width) * side;
        const float length = dot(piece.vertices[next(face, piece.count)] - piece.vertices[face], along);
        const float inset = min(linear_slop, 0.5f * length);
        const Span reach = other.corners_along(start, along, 3.0e38f);
        const float end = clamp(reach.high + other.radius, inset, length - inset);
        float covered = clamp(reach.low - other.radius, inset, length - inset);
        Vec2 lean = {0, 0};
        // Each pass goes on where the last one ended.
        bool found = true;
        for (std::uint32_t pass = 0; pass < most_pieces && found; ++pass) {
            found = false;
            for_each_neighbor([&](const Outline& its, bool) {
                const Span held = held_by(its, start, along, {covered, end});
                if (held.low > covered + gap_width || held.high < held.low || (pass != 0 && held.high <= covered)) return;
                covered = max(covered, held.high);
                const Vec2 its_lean = lean_of(its, point, side);
                if (dot(its_lean, side) > dot(lean, side)) lean = its_lean;
                found = true;
            });
            if (found && covered >= end - gap_width) {
                const Vec2 own = lean_of(piece, point, lean);  // the piece's surface that goes on from the neighbours', at an angle if the two form a ridge
                return dot(normal, side - dot(lean, side) * lean) > least_lean + ridge_room * max(dot(lean - own, side), 0.0f);
            }
        }
        return false;
    }

    // The face of a neighbour on which the other shape stands, if the piece does not rise above its line and `normal` would push the shape back along it.
    ISLET_SHARED Ground ground_under(Vec2 point, Vec2 normal) const {
        Ground ground;
        for_each_neighbor([&](const Outline& its, bool line) {
            const std::uint32_t first = line ? front_face : 0, end = line ? front_face + 1 : its.count;  // the other faces of a line's box are none
            for (std::uint32_t i = first; i < end && !ground.is_there; ++i) {
                const Vec2 along = left_perp(its.normals[i]), start = its.vertices[i];
                const float length = dot(its.vertices[next(i, its.count)] - start, along);
                const Vec2 back = dot(point - start, along) > 0.5f * length ? -along : along;
                if (!(dot(normal, back) > least_lean) || rise_over(its, i, piece) > gap_width) continue;
                const float height = other.lowest_over(its, i), reach = other.radius + its.radius;
                if (height > reach + speculative_distance) continue;
                // Where a fast body will meet the piece it is past the line, if it flies on. It stands where it crosses it.
                const float sunk = reach - height, sinks = -dot(its.normals[i], other.way);
                const bool lands = sunk > 2.0f * linear_slop;
                if (lands && sinks < sunk - 2.0f * linear_slop) continue;
                const Span foot = other.corners_along(start, along, height + linear_slop);
                const float since = lands ? min(sunk / sinks, 1.0f) * dot(along, other.way) : 0, inside = lands ? 2.0f * linear_slop : 0;
                if (foot.high - since >= inside && foot.low - since <= length - inside) ground = {its.normals[i], back, true};
            }
        });
        return ground;
    }

    // True if a point of contact is on a face that is covered.
    bool is_inner(Vec2 point, Vec2 normal) const {
        for (std::uint32_t i = 0; i < piece.count; ++i) {
            const bool leans = dot(piece.normals[i], normal) > least_lean;
            if (leans && height_over(piece, i, point) - piece.radius > -linear_slop && is_covered(i, point, normal)) return true;
        }
        return false;
    }

    // That face in which the other shape is least deep: of those that are parallel to the ground if there is one, else of those not covered.
    ISLET_SHARED Depth bare_face(const Ground& ground) const {
        Depth best;
        for (std::uint32_t i = 0; i < piece.count; ++i) {
            Depth depth = {i, 0, 3.0e38f};
            float sum = 0;
            for (std::uint32_t k = 0; k < other.count; ++k) {
                const float over = height_over(piece, i, other.corners[k]);
                sum += over;
                if (!(over < depth.gap)) continue;
                depth.gap = over;
                depth.corner = k;
            }
            if (sum < 0 || depth.gap <= best.gap) continue;
            const Vec2 normal = piece.normals[i], foot = other.corners[depth.corner] - (depth.gap - piece.radius) * normal;
            if (ground.is_there ? ground.goes_on(normal) : !is_covered(i, foot, normal)) best = depth;
        }
        return best;
    }

    // Makes the manifold anew along a face.
    ISLET_SHARED void go_along(const Depth& depth, float margin, bool piece_is_a, const Ground& ground, Manifold& m) const {
        const auto [best, deepest, gap] = depth;
        m = {};
        if (best == null_index || gap > margin + piece.radius + other.radius) return;
        const Vec2(&corners)[max_polygon_vertices] = other.corners;
        const std::uint32_t count = other.count;
        Face bare = {piece.vertices[best], piece.vertices[next(best, piece.count)], piece.normals[best], piece.radius, best, next(best, piece.count)};
        // The incident face: of the two faces at the deepest corner the one that rises less from the piece's face and runs the other way.
        const std::uint32_t after = next(deepest, count), before = (deepest == 0 ? count : deepest) - 1;
        const auto rise = [&](std::uint32_t i) { return height_over(piece, depth.face, corners[i]) - depth.gap; };
        const Vec2 along = left_perp(bare.normal);
        // What is over a gap that is covered is over both its sides. What stands on the ground is over the round end of the next piece.
        const float more = max(ground.is_there ? rounding : 0.0f, count == 1 ? 0.5f * linear_slop : 0.0f);
        bare.v1 -= more * along;
        bare.v2 += more * along;
        const float run_after = dot(corners[deepest] - corners[after], along), run_before = dot(corners[before] - corners[deepest], along);
        const bool forward = run_after > 0 && !(rise(before) * run_after < rise(after) * run_before);
        const std::uint32_t i1 = forward ? deepest : before, i2 = forward ? after : deepest;
        m = clip_faces(bare, {corners[i1], corners[i2], {}, other.radius, i1, i2}, !piece_is_a, {0, 0}, margin);
        if (count == 1 && m.count == 2) m.count = 1;
    }
};

}  // namespace

void mend_inner_edges(const Core& core, const Contact& contact, const Transform& b_in_a, float margin, Manifold& manifold) {
    const Transform a_in_a;
    for (const bool piece_is_a : {true, false}) {
        const std::uint32_t shape = piece_is_a ? contact.shape_a : contact.shape_b;
        const std::uint32_t other_shape = piece_is_a ? contact.shape_b : contact.shape_a;
        const std::uint32_t body = core.shapes[shape].body;
        const std::uint32_t other = core.shapes[other_shape].body;
        const bool moves = core.is_dynamic(body);
        if (manifold.count == 0 || core.bodies[other].contact_count < 2) continue;
        if (moves) {
            const Body& own = core.bodies[body];
            // What is static or kinematic stands on nothing: a part of a body that falls into a valley is no floor for the valley's walls.
            if (!may_bear(own, core.poses[body], core.poses[other]) || own.contact_count < 2 || least_separation(manifold) < -nested_depth) continue;
        }
        const Geometry &g = geometry_at(core, shape), &other_g = geometry_at(core, other_shape);
        const bool line = is_line(g);
        if (line && (kind_of(g) == ShapeKind::front || moves)) continue;      // a chain knows its neighbours
        if (has_endless && kind_of(other_g) == ShapeKind::endless) continue;  // which has no corners
        const Transform &pose = piece_is_a ? a_in_a : b_in_a, at = body_transform(core, body);
        const Rot q = at.q * inverse(pose.q);
        const Transform frame = {at.p - rotate(q, pose.p), q};
        const Transform& stands = piece_is_a ? b_in_a : a_in_a;
        const Standing standing(other, corners_of(other_g), stands, way_to(core, other, stands, frame));
        const float rounding = corners_of(g).radius;
        const Floor floor{core, shape, frame, standing, piece_of(g, pose, standing.middle, piece_depth, 0), rounding};
        if (floor.piece.count == 0) continue;  // a circle
        const Vec2 normal = piece_is_a ? manifold.normal : -manifold.normal;
        const Vec2 lift = line ? rounding * (floor.piece.normals[front_face] - normal) : Vec2{};  // from the round end of a capsule to where it begins
        Ground ground;
        bool inner = true;
        for (std::uint32_t i = 0; i < manifold.count && inner; ++i) {
            const ManifoldPoint& p = manifold.points[i];
            // The far end of a bevel, or of a line that is met by an end, holds nothing yet: where the nearest point is, the normal must be right.
            if (p.separation > least_separation(manifold) + separation_tie) continue;
            const Vec2 point = p.point - 0.5f * p.separation * normal + lift;
            ground = floor.ground_under(point, normal);
            inner = ground.is_there || floor.is_inner(point, normal);
        }
        if (inner) floor.go_along(floor.bare_face(ground), margin, piece_is_a, ground, manifold);
    }
}

}  // namespace islet::detail
