// Outlines from shapes, and clipping: see the drawing in outline.hpp.
#include "../exact.hpp"

#include "../collide/outline.hpp"

#include "../math/lanes.hpp"

namespace islet::detail {

Outline outline_of(const Polygon& p, const Transform& t, Vec2 origin) {
    Outline o;
    o.count = p.count;
    o.radius = p.radius;
    // One corner takes the rounding of a large offset, the others follow it: the shape itself is not distorted.
    const Vec2 base = p.vertices[0];
    const Vec2 moved = rotate(t.q, base) + (t.p - origin);
#if ISLET_MAX_LANES > 1
    // Two corners at once; what stands behind the last one counts for nothing.
    const f4 to = {moved.x, moved.y, moved.x, moved.y}, from = {base.x, base.y, base.x, base.y};
    for (std::uint32_t i = 0; i < p.count; i += 2) {
        store4(&o.vertices[i].x, to + rotate_two(t.q, load4(&p.vertices[i].x) - from));
        store4(&o.normals[i].x, rotate_two(t.q, load4(&p.normals[i].x)));
    }
#else
    for (std::uint32_t i = 0; i < p.count; ++i) {
        o.vertices[i] = moved + rotate(t.q, p.vertices[i] - base);
        o.normals[i] = rotate(t.q, p.normals[i]);
    }
#endif
    return o;
}

Manifold point_manifold(Vec2 a, float radius_a, Vec2 b, float radius_b, Vec2 normal, float gap, std::uint16_t id) {
    const Vec2 on_a = a + radius_a * normal;
    const Vec2 on_b = b - radius_b * normal;
    Manifold m;
    m.normal = normal;
    m.points[0] = {0.5f * (on_a + on_b), gap - radius_a - radius_b, id};
    m.count = 1;
    return m;
}

Manifold clip_faces(const Face& reference, const Face& incident, bool reference_is_b, Vec2 origin, float margin) {
    const Vec2 n = reference.normal;
    const Vec2 tangent = left_perp(n);

    // Along the tangent the reference face runs from 0 to length, the incident face the other way, from its v2 to its v1.
    const float length = dot(reference.v2 - reference.v1, tangent);
    const Vec2 from1 = incident.v1 - reference.v1;
    const Vec2 from2 = incident.v2 - reference.v1;
    const float high = dot(from1, tangent);
    const float low = dot(from2, tangent);
    Manifold m;
    if (high < 0.0f || low > length) { return m; }
    Vec2 lower = from2;
    Vec2 upper = from1;
    if (high - low > 1e-7f) {  // m; a face seen end on keeps both its corners
        const float scale = 1.0f / (high - low);
        lower = low < 0.0f ? lerp(from2, from1, -low * scale) : from2;
        upper = high > length ? lerp(from2, from1, (length - low) * scale) : from1;
    }

    const float radii = reference.radius + incident.radius;
    const float lift = 0.5f * (reference.radius - incident.radius);
    const Vec2 base = origin + reference.v1;
    const float gap_lower = dot(lower, n);
    const float gap_upper = dot(upper, n);
    const ManifoldPoint at_lower = {base + lower + (lift - 0.5f * gap_lower) * n, gap_lower - radii,
                                    reference_is_b ? feature_id(incident.index2, reference.index1) : feature_id(reference.index1, incident.index2)};
    const ManifoldPoint at_upper = {base + upper + (lift - 0.5f * gap_upper) * n, gap_upper - radii,
                                    reference_is_b ? feature_id(incident.index1, reference.index2) : feature_id(reference.index2, incident.index1)};

    // In the order of A's corners whichever shape is the reference.
    m.normal = reference_is_b ? -n : n;
    m.points[0] = reference_is_b ? at_upper : at_lower;
    m.count = m.points[0].separation <= margin ? 1 : 0;
    m.points[m.count] = reference_is_b ? at_lower : at_upper;
    m.count += m.points[m.count].separation <= margin ? 1 : 0;
    return m;
}

}  // namespace islet::detail
