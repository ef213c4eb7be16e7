// What overlaps a box, a shape or a point, and what is closest to a point.
#include "../exact.hpp"

#include "../bodies/bounds.hpp"
#include "../calls/checks.hpp"
#include "../collide/difference.hpp"
#include "../math/boxes.hpp"
#include "../math/float_mode.hpp"
#include "../query/queries.hpp"

namespace islet {

using namespace detail;

namespace detail {
namespace {

enum class Question : std::uint8_t { box, shape, point };

/// What overlap is asked for: with a box, or with a proxy that is a shape or a single point.
struct Overlap {
    const Core& core;
    const ShapeProxy& proxy;
    Aabb box;  // of the question
    QueryFilter filter;
    Question question;

    bool holds(std::uint32_t shape) const {
        if (!is_queried(core, shape, filter)) return false;
        if (question == Question::box) return meet(shape_aabb(core, shape), box);
        const ShapeProxy seen = seen_from(body_transform(core, core.shapes[shape].body), proxy);
        const ShapeProxy other = proxy_of(core.geometries[core.shapes[shape].geometry], seen);
        if (question == Question::point && other.count == 2 && other.radius == 0) return false;
        return nearest(difference_of(seen, other)).distance <= 0;
    }
};

std::uint32_t count_overlaps(const Overlap& overlap, span<ShapeId> out) {
    if (queries_are_cut(overlap.core)) return 0;
    const DefaultFloatMode mode;
    const Aabb reach = expand(overlap.box, rounding_of(overlap.box));
    FirstFew<ShapeId> found{out.data(), out.size()};
    std::uint32_t count = 0;
    search_shapes(
        overlap.core, [&](const Aabb& box) { return meet_at_once(box, reach); },
        [&](std::uint32_t shape) {
            if (!overlap.holds(shape)) return;
            ++count;
            found.add(overlap.core.shape_id(shape));
        });
    return count;
}

void visit_overlaps(const Overlap& overlap, OverlapVisitor visit_hook, void* context) {
    if (queries_are_cut(overlap.core) || visit_hook == nullptr) return;
    const DefaultFloatMode mode;
    const Aabb reach = expand(overlap.box, rounding_of(overlap.box));
    ShapeId shapes[visits_a_search];
    ShapeId last;
    for (bool again = true; again;) {
        FirstFew<ShapeId> found{shapes, visits_a_search};
        search_shapes(
            overlap.core, [&](const Aabb& box) { return meet_at_once(box, reach); },
            [&](std::uint32_t shape) {
                const ShapeId id = overlap.core.shape_id(shape);
                if (comes_before(last, id) && (!found.full() || comes_before(id, shapes[visits_a_search - 1])) && overlap.holds(shape)) found.add(id);
            });
        for (std::size_t i = 0; i < found.count; ++i) {
            last = shapes[i];
            if (!visit_hook(last, context)) return;
        }
        again = found.full();
    }
}

bool check_box(const Core& core, const Aabb& box) {
    return check_position(core, box.lower) && check_position(core, box.upper) &&
           check(core, box.lower.x <= box.upper.x && box.lower.y <= box.upper.y, Error::bad_geometry);
}

}  // namespace
}  // namespace detail

std::uint32_t World::overlap_box(const Aabb& box, span<ShapeId> out, const QueryFilter& filter) const {
    return check_box(core(), box) ? count_overlaps({core(), {}, box, filter, Question::box}, out) : 0;
}

std::uint32_t World::overlap_shape(const ShapeProxy& shape, span<ShapeId> out, const QueryFilter& filter) const {
    return check_proxy(core(), shape) ? count_overlaps({core(), shape, box_of(shape), filter, Question::shape}, out) : 0;
}

std::uint32_t World::overlap_point(Vec2 point, span<ShapeId> out, const QueryFilter& filter) const {
    return check_position(core(), point) ? count_overlaps({core(), point_proxy(point), {point, point}, filter, Question::point}, out) : 0;
}

void World::overlap_box_each(const Aabb& box, const QueryFilter& filter, OverlapVisitor visit, void* context) const {
    if (check_box(core(), box)) visit_overlaps({core(), {}, box, filter, Question::box}, visit, context);
}

void World::overlap_shape_each(const ShapeProxy& shape, const QueryFilter& filter, OverlapVisitor visit, void* context) const {
    if (check_proxy(core(), shape)) visit_overlaps({core(), shape, box_of(shape), filter, Question::shape}, visit, context);
}

void World::overlap_point_each(Vec2 point, const QueryFilter& filter, OverlapVisitor visit, void* context) const {
    if (check_position(core(), point)) visit_overlaps({core(), point_proxy(point), {point, point}, filter, Question::point}, visit, context);
}

ClosestHit World::closest(Vec2 point, float max_distance, const QueryFilter& filter) const {
    const Core& c = core();
    if (queries_are_cut(c)) return {};
    const DefaultFloatMode mode;
    ClosestHit best;
    if (!check_position(c, point) || !check_range(c, max_distance, 0, max_translation)) return best;
    const ShapeProxy proxy = point_proxy(point);
    const Aabb at{point, point};
    float within = max_distance;
    // The distance from a box, less what rounding may have added to it. Every operation is monotone, so a larger box is never farther.
    const auto gap = [&](const Aabb& box) {
        const Vec2 outside = max(max(box.lower - point, point - box.upper), Vec2{0, 0});
        return max(0.0f, length(outside) - rounding_of(at));
    };
    search_shapes(
        c, [&](const Aabb& box) { return gap(box) <= within; },
        [&](std::uint32_t shape) {
            if (!is_queried(c, shape, filter)) return;
            const Transform t = body_transform(c, c.shapes[shape].body);
            const ShapeProxy seen = seen_from(t, proxy);
            const ShapeProxy other = proxy_of(c.geometries[c.shapes[shape].geometry], seen);
            const Difference w = difference_of(seen, other);
            const Nearest n = nearest(w);
            const float distance = max(n.distance, gap(c.boxes[shape]));  // not less than its box: so it never matters when a search comes to the box
            const bool closer = distance < within || (distance == within && (!best || shape + 1 < best.shape.index1));
            if (!closer) return;
            const Vec2 surface = transform_point(t, point_of(w, w.index_b, other.points, n.place) + other.radius * n.normal);
            best = {c.shape_id(shape), n.distance > 0 ? surface : point, rotate(t.q, n.normal), distance};
            within = distance;
        });
    return best;
}

}  // namespace islet
