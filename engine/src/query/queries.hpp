// What all queries of a world share: which shapes they look at, and lists that come out in an order of their own, whatever order shapes are found in.
#pragma once

#include "../broadphase/tree.hpp"
#include "../calls/checks.hpp"
#include "islet/query.hpp"

namespace islet::detail {

/// In a build without queries: records that, and says so.
ISLET_ALWAYS_INLINE inline bool queries_are_cut(const Core& core) {
    if constexpr (!has_queries) core.fail(Error::feature_cut);
    return !has_queries;
}

/// Whether queries with this filter find the shape at all.
inline bool is_queried(const Core& core, std::uint32_t shape, const QueryFilter& filter) {
    const Shape& s = core.shapes[shape];
    const Filter& f = s.filter;
    const bool hidden = ((s.flags & shape_sensor) != 0 && !filter.sensors) || (core.bodies[s.body].flags & body_disabled) != 0;
    return !hidden && (filter.mask & f.category) != 0 && (f.mask & filter.category) != 0;
}

/// A shape in its body's frame, for a question about `seen`, which is in that frame too, and its way. (Only what has no end depends on the question.)
ShapeProxy proxy_of(const Geometry& g, const ShapeProxy& seen, Vec2 way = {});
/// A point as a shape: a ray is its cast.
inline ShapeProxy point_proxy(Vec2 p) {
    ShapeProxy proxy;
    proxy.points[0] = p;
    proxy.count = 1;
    return proxy;
}
/// A proxy in the world, seen from the frame that t leads from.
ShapeProxy seen_from(const Transform& t, const ShapeProxy& p);

/// True if a query may start from the proxy, or from the point: else the error is recorded.
bool check_proxy(const Core& core, const ShapeProxy& p);
bool check_translation(const Core& core, Vec2 translation);

/// The box around a proxy. Exact: a larger one is never cut off by rounding.
Aabb box_of(const ShapeProxy& p);

/// Rounding in boxes and in what is inside them, m, for numbers up to those in `box`: what is within it of a box may touch what is in the box.
inline float rounding_of(const Aabb& box) { return 1e-6f * max(max(abs(box.lower.x), abs(box.lower.y)), max(abs(box.upper.x), abs(box.upper.y))); }

/// Calls visit(shape) for each shape whose fat box `reaches` accepts, in no particular order. Resting shapes are in the tree. Awake ones are found by going
/// through their bodies or, where many are awake, through all boxes, which stand in a row in memory (of 8000 awake shapes in a third of the time).
template <class Reaches, class Visit>
void search_shapes(const Core& core, Reaches&& reaches, Visit&& visit) {
    tree_search({&core.state->tree, core.tree}, reaches, visit);
    const std::uint32_t shapes = core.state->shape_pool.high_water;
    if (4 * core.awake_bodies.count() > shapes) {
        for (std::uint32_t s = 0; s < shapes; ++s) {
            if (reaches(core.boxes[s]) && core.shapes[s].tree_node == null_index && pool_live(core.state->shape_pool, core.shapes, s)) visit(s);
        }
        return;
    }
    core.awake_bodies.for_each([&](std::uint32_t body) {
        for (std::uint32_t s = core.bodies[body].shape_head; s != null_index; s = core.shapes[s].next) {
            if (reaches(core.boxes[s])) visit(s);
        }
    });
}

/// The order in which things found are handed out.
inline bool comes_before(const QueryHit& a, const QueryHit& b) {
    return a.fraction < b.fraction || (a.fraction == b.fraction && a.shape.index1 < b.shape.index1);
}
inline bool comes_before(const ShapeId& a, const ShapeId& b) { return a.index1 < b.index1; }
inline bool comes_before(const Surface& a, const Surface& b) {
    return a.separation < b.separation || (a.separation == b.separation && a.shape.index1 < b.shape.index1);
}

/// The first few of what is added, in ascending order.
template <class Item>
struct FirstFew {
    Item* items;
    std::size_t room;
    std::size_t count = 0;

    bool full() const { return count == room; }
    /// Inserts the item in its place, and drops the last one if there is no room for it.
    void add(const Item& item) {
        if (room == 0 || (full() && !comes_before(item, items[count - 1]))) return;
        std::size_t i = full() ? count - 1 : count++;
        for (; i > 0 && comes_before(item, items[i - 1]); --i) items[i] = items[i - 1];
        items[i] = item;
    }
};

/// How many are found in one search, when each is to be visited in order: those behind them take another search.
inline constexpr std::uint32_t visits_a_search = 8;

}  // namespace islet::detail
