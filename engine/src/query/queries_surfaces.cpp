// The planes that bound a shape's way: what a mover slides along.
#include "../exact.hpp"

#include "../bodies/bounds.hpp"
#include "../calls/checks.hpp"
#include "../collide/difference.hpp"
#include "../math/float_mode.hpp"
#include "../query/queries.hpp"

namespace islet {

using namespace detail;

namespace {

// False if the proxy is behind the segment, by the mean of its corners or by what of it is closest to an end. If its core reaches through, the segment's own
// plane is the only way out.
bool face_of_segment(const ShapeProxy& p, const ShapeProxy& segment, Nearest& n) {
    const Vec2 origin = segment.points[0];
    const Vec2 normal = normalize(right_perp(segment.points[1] - origin));
    float lowest = 3.0e38f;
    float sum = 0;
    for (std::uint32_t i = 0; i < p.count; ++i) {
        const float height = dot(normal, p.points[i] - origin);
        sum += height;
        lowest = min(lowest, height);
    }
    if (sum < 0) return false;
    const bool through = n.distance <= -p.radius;
    if (through) n = {lowest - p.radius, normal, n.place};
    return through || dot(n.normal, normal) > 0;
}

}  // namespace

std::uint32_t World::surfaces_near(const ShapeProxy& shape, float within, span<Surface> out, const QueryFilter& filter) const {
    const Core& c = core();
    if (queries_are_cut(c)) return 0;
    const DefaultFloatMode mode;
    if (!check_proxy(c, shape) || !check_range(c, within, 0, max_translation)) return 0;
    const Aabb around = expand(box_of(shape), within);
    const Aabb reach = expand(around, rounding_of(around));
    FirstFew<Surface> found{out.data(), out.size()};
    std::uint32_t count = 0;
    search_shapes(
        c, [&](const Aabb& box) { return meet_at_once(box, reach); },
        [&](std::uint32_t s) {
            if (!is_queried(c, s, filter)) return;
            const Transform t = body_transform(c, c.shapes[s].body);
            const ShapeProxy seen = seen_from(t, shape);
            const ShapeProxy other = proxy_of(c.geometries[c.shapes[s].geometry], seen);
            const Difference w = difference_of(seen, other);
            Nearest n = nearest(w);
            if (!(n.distance <= within) || (other.one_sided && !face_of_segment(seen, other, n))) return;
            ++count;
            const Vec2 point = point_of(w, w.index_b, other.points, n.place) + other.radius * n.normal;
            found.add({c.shape_id(s), transform_point(t, point), rotate(t.q, n.normal), n.distance});
        });
    return count;
}

}  // namespace islet
