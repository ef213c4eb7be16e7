// Convex hull of a handful of points: Andrew's monotone chain (1979), then the corners that are too fine are dropped.
#include "../exact.hpp"

#include "../geometry/convex.hpp"

namespace islet {
namespace {

// m: a corner that stands out less than this is on a straight line. A tenth of the distance by which shapes may overlap anyway.
constexpr float collinear_tolerance = 0.1f * detail::min_length;

/// Points in lexicographic order, each once: the hull depends on the set, not on the order in which it was given.
struct SortedPoints {
    Vec2 points[max_polygon_vertices];
    std::uint32_t count = 0;
};

bool before(Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

void insert(SortedPoints& set, Vec2 p) {
    std::uint32_t at = set.count;
    while (at > 0 && before(p, set.points[at - 1])) --at;
    if (at > 0 && set.points[at - 1] == p) return;
    for (std::uint32_t i = set.count; i > at; --i) set.points[i] = set.points[i - 1];
    set.points[at] = p;
    ++set.count;
}

/// The outline while it is being built. Rounding may leave a point of a nearly straight outline on both chains, hence the room for two.
struct Loop {
    Vec2 points[2 * max_polygon_vertices];
    std::uint32_t count = 0;
};

/// Appends p to the chain that starts at index `first`, after taking back all points that are not strictly right of the line to p.
void extend_chain(Loop& loop, std::uint32_t first, Vec2 p) {
    while (loop.count >= first + 2) {
        const Vec2 a = loop.points[loop.count - 2];
        const Vec2 b = loop.points[loop.count - 1];
        if (cross(b - a, p - b) > 0) break;
        --loop.count;
    }
    loop.points[loop.count++] = p;
}

/// The lower chain from the first point to the last, then the upper chain back to the first.
Loop monotone_chain(const SortedPoints& set) {
    Loop loop;
    for (std::uint32_t i = 0; i < set.count; ++i) extend_chain(loop, 0, set.points[i]);
    const std::uint32_t turn = loop.count - 1;
    for (std::uint32_t i = set.count - 1; i > 0; --i) extend_chain(loop, turn, set.points[i - 1]);
    --loop.count;  // the first point closed the loop, it is there already
    return loop;
}

/// Index of the corner that may go and would change the hull least, or loop.count if all of them matter.
std::uint32_t find_idle_corner(const Loop& loop) {
    std::uint32_t idle = loop.count;
    float least_height = 0;
    for (std::uint32_t i = 0; i < loop.count; ++i) {
        const Vec2 p = loop.points[i];
        const Vec2 previous = loop.points[i > 0 ? i - 1 : loop.count - 1];
        const Vec2 following = loop.points[detail::next(i, loop.count)];
        const float height = cross(p - following, normalize(following - previous));  // above the line through the neighbours
        const float shorter_squared = min(distance_squared(previous, p), distance_squared(p, following));
        const bool matters = height > collinear_tolerance && shorter_squared >= detail::min_length * detail::min_length;
        if (!matters && (idle == loop.count || height < least_height)) {
            idle = i;
            least_height = height;
        }
    }
    return idle;
}

void remove(Loop& loop, std::uint32_t corner) {
    --loop.count;
    for (std::uint32_t i = corner; i < loop.count; ++i) loop.points[i] = loop.points[i + 1];
}

}  // namespace

namespace detail {

bool is_strictly_convex(span<const Vec2> points) {
    const auto count = static_cast<std::uint32_t>(points.size());
    if (count < 3) return false;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t j = next(i, count);
        const Vec2 edge = points[j] - points[i];
        for (std::uint32_t k = 0; k < count; ++k) {
            if (k != i && k != j && !(cross(edge, points[k] - points[i]) > 0)) return false;
        }
    }
    return true;
}

}  // namespace detail

Hull compute_hull(span<const Vec2> points) {
    if (points.size() < 3 || points.size() > max_polygon_vertices) return {};
    SortedPoints set;
    for (const Vec2 p : points) {
        if (!detail::in_range(p)) return {};
        insert(set, p + Vec2{});  // adding zero turns -0 into +0: equal points have equal bits
    }
    if (set.count < 3) return {};

    Loop loop = monotone_chain(set);
    while (loop.count >= 3) {
        const std::uint32_t corner = find_idle_corner(loop);
        if (corner == loop.count) break;
        remove(loop, corner);
    }
    if (loop.count > max_polygon_vertices || !detail::is_strictly_convex({loop.points, loop.count})) return {};
    Hull hull;
    for (std::uint32_t i = 0; i < loop.count; ++i) hull.points[i] = loop.points[i];
    hull.count = loop.count;
    return hull;
}

}  // namespace islet
