// Shapes in motion are found by sorting their fat boxes along an axis and sweeping over the sorted columns (Baraff 1992; the sort is a radix
// sort, so its cost is fixed), shapes at rest by a query of the tree. Measured on 8 100 boxes that all moved: the sort and sweep take a
// fraction of the time of one tree query per box, and need no tree to be kept up while things move (tools/bench/pair_finder.cpp).
#include "broadphase/pairs.hpp"

#include "broadphase/contacts.hpp"
#include "broadphase/tree.hpp"

namespace islet::detail {

namespace {

// The fat boxes of the shapes in motion as columns, sorted by `lower` along the sweep axis.
struct Columns {
    float* lower = nullptr;   // along the sweep axis
    float* upper = nullptr;
    float* lower2 = nullptr;  // across it
    float* upper2 = nullptr;
    std::uint32_t* shape = nullptr;  // bit 31: its box changed
    std::uint32_t count = 0;
};

inline constexpr std::uint32_t moved_bit = 1u << 31;

void add_pair(Core& core, std::uint32_t shape_1, std::uint32_t shape_2) {
    if (core.pairs.contains(PairSet::key(shape_1, shape_2)) || !may_collide(core, shape_1, shape_2)) return;
    if (create_contact(core, shape_1, shape_2)) return;
    ++core.report.dropped_contacts;
}

// An unsigned integer that sorts as the float does.
std::uint32_t sort_key(float x) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &x, 4);
    return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

// Least significant digit radix sort, three digits of 11 bits; stable, so equal keys stay in slot order.
std::uint32_t* sort_by_key(std::uint32_t* keys, std::uint32_t* order, std::uint32_t* keys2, std::uint32_t* order2, std::uint32_t n,
                           std::uint32_t* counts) {
    for (std::uint32_t i = 0; i < n; ++i) order[i] = i;
    for (std::uint32_t shift = 0; shift < 33; shift += 11) {
        std::memset(counts, 0, 2048 * 4);
        for (std::uint32_t i = 0; i < n; ++i) ++counts[keys[i] >> shift & 2047u];
        std::uint32_t sum = 0;
        for (std::uint32_t d = 0; d < 2048; ++d) {
            const std::uint32_t c = counts[d];
            counts[d] = sum;
            sum += c;
        }
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t to = counts[keys[i] >> shift & 2047u]++;
            keys2[to] = keys[i];
            order2[to] = order[i];
        }
        std::uint32_t* k = keys;
        keys = keys2;
        keys2 = k;
        std::uint32_t* o = order;
        order = order2;
        order2 = o;
    }
    return order;
}

Columns sorted_columns(Core& core, Arena& arena) {
    const std::uint32_t room = core.state->shape_pool.count;
    std::uint32_t* list = arena.take<std::uint32_t>(room);
    std::uint32_t n = 0;
    Aabb bounds{{3.0e38f, 3.0e38f}, {-3.0e38f, -3.0e38f}};
    core.awake_bodies.for_each([&](std::uint32_t body) {
        for (std::uint32_t s = core.bodies[body].shape_head; s != null_index; s = core.shapes[s].next) {
            list[n++] = s;
            bounds = merge(bounds, core.boxes[s]);
        }
    });

    // Sweep along the longer side of the whole.
    const bool along_x = bounds.upper.x - bounds.lower.x >= bounds.upper.y - bounds.lower.y;
    std::uint32_t* keys = arena.take<std::uint32_t>(n);
    std::uint32_t* keys2 = arena.take<std::uint32_t>(n);
    std::uint32_t* order = arena.take<std::uint32_t>(n);
    std::uint32_t* order2 = arena.take<std::uint32_t>(n);
    std::uint32_t* counts = arena.take<std::uint32_t>(2048);
    for (std::uint32_t i = 0; i < n; ++i) keys[i] = sort_key(along_x ? core.boxes[list[i]].lower.x : core.boxes[list[i]].lower.y);
    const std::uint32_t* sorted = sort_by_key(keys, order, keys2, order2, n, counts);

    Columns c;
    c.count = n;
    c.lower = arena.take<float>(n);
    c.upper = arena.take<float>(n);
    c.lower2 = arena.take<float>(n);
    c.upper2 = arena.take<float>(n);
    c.shape = arena.take<std::uint32_t>(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t s = list[sorted[i]];
        const Aabb& box = core.boxes[s];
        c.lower[i] = along_x ? box.lower.x : box.lower.y;
        c.upper[i] = along_x ? box.upper.x : box.upper.y;
        c.lower2[i] = along_x ? box.lower.y : box.lower.x;
        c.upper2[i] = along_x ? box.upper.y : box.upper.x;
        c.shape[i] = s | (core.moved_shapes.test(s) ? moved_bit : 0u);
    }
    return c;
}

void sweep(Core& core, const Columns& c) {
    for (std::uint32_t i = 0; i < c.count; ++i) {
        const float upper = c.upper[i];
        const float lower2 = c.lower2[i];
        const float upper2 = c.upper2[i];
        const std::uint32_t shape = c.shape[i];
        for (std::uint32_t j = i + 1; j < c.count && c.lower[j] <= upper; ++j) {
            if (c.lower2[j] > upper2 || c.upper2[j] < lower2) continue;
            if (((shape | c.shape[j]) & moved_bit) == 0) continue;
            add_pair(core, shape & ~moved_bit, c.shape[j] & ~moved_bit);
        }
    }
}

// A shape at rest whose box changed (just created, teleported, or fallen asleep as it moved) against all shapes in motion.
void scan(Core& core, const Columns& c, std::uint32_t shape) {
    const Aabb box = core.boxes[shape];
    for (std::uint32_t j = 0; j < c.count; ++j) {
        const std::uint32_t other = c.shape[j] & ~moved_bit;
        if (overlaps(core.boxes[other], box)) add_pair(core, shape, other);
    }
}

// Every pair in which a fat box changed.
void find_moved_pairs(Core& core) {
    Arena arena = core.arena();
    const Columns columns = sorted_columns(core, arena);
    sweep(core, columns);

    const Tree tree{&core.state->tree, core.tree};
    const auto against_rest = [&](std::uint32_t shape) {
        tree_query(tree, core.boxes[shape], [&](std::uint32_t other) { add_pair(core, shape, other); });
    };
    for (std::uint32_t i = 0; i < columns.count; ++i)
        if ((columns.shape[i] & moved_bit) != 0) against_rest(columns.shape[i] & ~moved_bit);

    core.moved_shapes.for_each([&](std::uint32_t shape) {
        if (core.is_awake(core.shapes[shape].body)) return;
        scan(core, columns, shape);
        against_rest(shape);
    });
}

// Fast bodies must not pass through what never moves: they look as far ahead as they may come in this step.
void find_pairs_ahead(Core& core, float dt) {
    const Tree tree{&core.state->tree, core.tree};
    if (core.state->tree.leaf_count == 0) return;
    core.awake_bodies.for_each([&](std::uint32_t body) {
        if ((core.poses[body].flags & pose_fast) == 0) return;
        for (std::uint32_t s = core.bodies[body].shape_head; s != null_index; s = core.shapes[s].next) {
            tree_query(tree, box_ahead(core, s, dt), [&](std::uint32_t other) {
                if (core.bodies[core.shapes[other].body].type() == BodyType::static_body) add_pair(core, s, other);
            });
        }
    });
}

}  // namespace

void mark_moved(Core& core, std::uint32_t shape) {
    if (core.moved_shapes.test(shape)) return;
    core.moved_shapes.set(shape);
    ++core.state->moved_count;
    core.poses[core.shapes[shape].body].flags |= pose_moved;
}

Aabb box_ahead(const Core& core, std::uint32_t shape, float dt) {
    const std::uint32_t body = core.shapes[shape].body;
    const Vec2 way = dt * core.motions[body].v;
    const float turn = dt * abs(core.motions[body].w) * core.poses[body].max_extent;
    const Aabb box = core.boxes[shape];
    return expand({min(box.lower, box.lower + way), max(box.upper, box.upper + way)}, turn);
}

void find_pairs(Core& core, float dt) {
    core.report.dropped_contacts = 0;
    if (core.state->moved_count != 0) find_moved_pairs(core);
    find_pairs_ahead(core, dt);
    if (core.report.dropped_contacts != 0) {
        core.fail(Error::contacts_full);  // what moved stays marked, so the same pairs are tried again in the next step
        return;
    }
    core.moved_shapes.clear_all();
    core.state->moved_count = 0;
}

}  // namespace islet::detail
