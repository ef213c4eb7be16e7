// Lists the shapes in motion that may be part of a new pair, and sorts their boxes: by all workers where there are some.
#include "../exact.hpp"

#include "../broadphase/moving_shapes.hpp"

#include <cstring>

#include "../broadphase/culling.hpp"
#include "../broadphase/sort_by_parts.hpp"
#include "../broadphase/tree.hpp"
#include "../data/parallel.hpp"

namespace islet::detail {

namespace {

Columns take_columns(Arena& arena, std::uint32_t n) {
    Columns c;
    for (float** column : {&c.lower, &c.upper, &c.lower2, &c.upper2}) *column = arena.take<float>(n + max_block_lanes);
    c.shape = arena.take<std::uint32_t>(n + max_block_lanes);
    c.place = arena.take<std::uint32_t>(n + max_block_lanes);
    return c;
}

void set_box(Columns& c, std::uint32_t i, float lower, float upper, float lower2, float upper2, std::uint32_t shape, std::uint32_t place) {
    c.lower[i] = lower;
    c.upper[i] = upper;
    c.lower2[i] = lower2;
    c.upper2[i] = upper2;
    c.shape[i] = shape;
    c.place[i] = place;
}

void push_box(Columns& c, float lower, float upper, float lower2, float upper2, std::uint32_t shape, std::uint32_t place) {
    set_box(c, c.count++, lower, upper, lower2, upper2, shape, place);
}

void close_columns(Columns& c) {
    const std::uint32_t count = c.count;
    for (std::uint32_t i = 0; i < max_block_lanes; ++i) push_box(c, 3.4e38f, -3.4e38f, 3.4e38f, -3.4e38f, null_index, null_index);
    c.count = count;
}

// The box in which a shape may meet others: its fat box, and the way of a body that may leave that.
ISLET_SHARED Aabb box_to_meet_in(const Core& core, std::uint32_t shape, float dt) {
    const std::uint32_t body = core.shapes[shape].body;
    if (!core.is_awake(body) || !may_leave(core.poses[body])) return core.boxes[shape];
    return both(core.boxes[shape], box_along_way(core, {core.boxes[shape], way_of(core, body, dt), body, shape, true, 0}));
}

// If few boxes changed: the awake bodies with a shape near one, in `bodies`. No other body is part of a new pair.
[[maybe_unused]] ISLET_APART bool find_near_changed(const Core& core, float dt, BitSet bodies) {
    const std::uint32_t shape_count = core.state->shape_pool.count;
    if (shape_count < ChangedCells::least_shapes || core.state->moved_count > shape_count / ChangedCells::share) return false;
    Aabb area{{3.0e38f, 3.0e38f}, {-3.0e38f, -3.0e38f}};
    core.moved_shapes.for_each([&](std::uint32_t shape) { area = both(area, box_to_meet_in(core, shape, dt)); });
    ChangedCells changed(area);
    core.moved_shapes.for_each([&](std::uint32_t shape) { changed.add(box_to_meet_in(core, shape, dt)); });
    bodies.clear_all();
    for (std::uint32_t shape = 0; shape < core.state->shape_pool.high_water; ++shape) {
        if (!meet_at_once(core.boxes[shape], area) || !changed.reach(core.boxes[shape]) || !pool_live(core.state->shape_pool, core.shapes, shape)) continue;
        if (core.is_awake(core.shapes[shape].body)) bodies.set(core.shapes[shape].body);
    }
    return true;
}

// True if something at rest is near a shape in motion, so that the two may be a new pair.
bool is_near_rest(const Core& core, const MovingShape& shape) {
    const Aabb box = box_along_way(core, shape);
    return !is_clear(core.poses[shape.body], box) && TreeWalk(Tree{&core.state->tree, core.tree}, box).next() != null_index;
}

inline constexpr std::uint32_t box_grain = 512;  // boxes that are worth a task

/// A part of the awake bodies, whose shapes a worker lists.
struct ListPart {
    std::uint32_t first = 0;  // place of its first shape
    std::uint32_t count = 0;  // shapes
    std::uint32_t moved = 0;  // of them, those whose boxes changed
    FilterSum filters;
    Aabb changed{{3.0e38f, 3.0e38f}, {-3.0e38f, -3.0e38f}};  // box around those of its boxes that changed
};

inline constexpr std::uint32_t list_grain = 8;  // words of 64 bodies that are worth a task
using ListCut = RangeCut<64>;

/// What list_moving found.
struct ListedShapes {
    std::uint32_t count = 0;
    std::uint32_t moved = 0;                                 // of them, those whose boxes changed
    Aabb changed{{3.0e38f, 3.0e38f}, {-3.0e38f, -3.0e38f}};  // around all boxes that changed
};

// Lists the shapes of awake bodies that may be part of a new pair, in the order of the bodies.
ISLET_APART ListedShapes list_moving(const Core& core, const BitSet& bodies, MovingShape* shapes, float dt) {
    const std::uint32_t words = bodies.word_count;
    const ListCut cut(core, words, list_grain);
    ListPart parts[ListCut::room];
    for_ranges(core, words, cut.grain, [&](std::uint32_t first, std::uint32_t end) {
        ListPart& part = parts[cut.of(first)];
        bodies.for_each_in(first, end, [&](std::uint32_t body) {
            part.count += core.bodies[body].shape_count;
            for (std::uint32_t s = core.bodies[body].shape_head; s != null_index; s = core.shapes[s].next) part.filters.add(core.shapes[s].filter);
        });
    });
    FilterSum filters;
    for (std::uint32_t p = 0, n = 0; p < cut.count; ++p) {
        parts[p].first = n;
        n += parts[p].count;
        filters.add(parts[p].filters);
    }
    for_ranges(core, words, cut.grain, [&](std::uint32_t first, std::uint32_t end) {
        ListPart& part = parts[cut.of(first)];
        part.count = 0;
        bodies.for_each_in(first, end, [&](std::uint32_t body) {
            const bool leaves = may_leave(core.poses[body]);
            const Way way = leaves ? way_of(core, body, dt) : Way{};
            for (std::uint32_t s = core.bodies[body].shape_head; s != null_index; s = core.shapes[s].next) {
                const bool moved = core.moved_shapes.test(s);
                if (moved) part.changed = both(part.changed, core.boxes[s]);
                const MovingShape shape = {core.boxes[s], way, body, s, leaves, kin_of(core.shapes[s].filter)};
                if (!filters.may_agree(core.shapes[s].filter) && !is_near_rest(core, shape)) continue;
                shapes[part.first + part.count++] = shape;
                if (max_lanes > 1 && moved) ++part.moved;
            }
        });
    });
    ListedShapes listed;
    for (std::uint32_t p = 0; p < cut.count; ++p) {
        if (listed.count != parts[p].first) std::memmove(shapes + listed.count, shapes + parts[p].first, parts[p].count * sizeof *shapes);
        listed.count += parts[p].count;
        listed.moved += parts[p].moved;
        listed.changed = both(listed.changed, parts[p].changed);
    }
    return listed;
}

}  // namespace

Moving sorted_columns(Core& core, Arena& arena, float dt) {
    const std::uint32_t room = core.state->shape_pool.count;
    MovingShape* shapes = arena.take<MovingShape>(room);
    BitSet bodies = core.awake_bodies;
    if constexpr (has_shortcuts) {
        const BitSet near_changed{arena.take<std::uint64_t>(bodies.word_count), bodies.word_count};
        if (find_near_changed(core, dt, near_changed)) bodies = near_changed;
    }
    const ListedShapes listed = list_moving(core, bodies, shapes, dt);
    const std::uint32_t n = listed.count;
    const bool all_moved = max_lanes > 1 && listed.moved == n;

    // The boxes are sorted along the longer side of the box around those that changed, whichever others are sorted with them.
    const Vec2 size = listed.changed.upper - listed.changed.lower;
    const bool along_x = size.x >= size.y;
    KeyedItem* keys = arena.take<KeyedItem>(n);
    KeyedItem* spare = sorts_by_digits ? arena.take<KeyedItem>(n) : nullptr;
    std::uint32_t* counts = sorts_by_digits ? arena.take<std::uint32_t>(sort_digits) : nullptr;
    const BoxCut cut(core, n, box_grain);
    for_ranges(core, n, cut.grain, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t i = first; i < end; ++i) {
            const Aabb box = box_along_way(core, shapes[i]);
            keys[i] = keyed(sort_key(along_x ? box.lower.x : box.lower.y), i);
        }
    });
    const KeyedItem* sorted =
        sorts_by_digits && cut.count > 1 && has_many_workers(core) ? sort_by_parts(core, cut, keys, spare, n, counts) : sort_by_key(keys, spare, n, counts);

    MovingShape* const in_order = max_lanes > 1 ? arena.take<MovingShape>(n) : shapes;
    Moving c{core, take_columns(arena, n), take_columns(arena, n), in_order, sorted, along_x, dt, fall_in(core, dt)};
    std::uint32_t moved[BoxCut::room] = {};  // boxes of each part that changed; then the place of the first
    for_ranges(core, n, cut.grain, [&](std::uint32_t first, std::uint32_t end) {
        std::uint32_t count = 0;
        for (std::uint32_t i = first; i < end; ++i) {
            const MovingShape& moving_shape = shapes[number_of(sorted[i])];
            if constexpr (max_lanes > 1) in_order[i] = moving_shape;
            const Aabb box = box_along_way(core, moving_shape);
            const Vec2 x = along_x ? Vec2{box.lower.x, box.upper.x} : Vec2{box.lower.y, box.upper.y};
            const Vec2 y = along_x ? Vec2{box.lower.y, box.upper.y} : Vec2{box.lower.x, box.upper.x};
            set_box(c.all, i, x.x, x.y, y.x, y.y, moving_shape.shape, i);
            if (all_moved || !core.moved_shapes.test(moving_shape.shape)) continue;
            if (cut.count == 1) {
                push_box(c.moved, x.x, x.y, y.x, y.y, moving_shape.shape, i);
            } else {
                ++count;
            }
        }
        moved[cut.of(first)] = count;
    });
    c.all.count = n;
    if (cut.count > 1 && !all_moved) {
        for (std::uint32_t p = 0; p < cut.count; ++p) {
            const std::uint32_t count = moved[p];
            moved[p] = c.moved.count;
            c.moved.count += count;
        }
        for_ranges(core, n, cut.grain, [&](std::uint32_t first, std::uint32_t end) {
            std::uint32_t at = moved[cut.of(first)];
            for (std::uint32_t i = first; i < end; ++i)
                if (core.moved_shapes.test(c.all.shape[i]))
                    set_box(c.moved, at++, c.all.lower[i], c.all.upper[i], c.all.lower2[i], c.all.upper2[i], c.all.shape[i], i);
        });
    }
    close_columns(c.all);
    if (all_moved) {
        c.moved = c.all;
    } else {
        close_columns(c.moved);
    }
    return c;
}

}  // namespace islet::detail
