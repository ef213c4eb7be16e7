// Pairs of shapes in motion are found by sorting their fat boxes along an axis and scanning the sorted columns (sort and sweep, Baraff 1992). Pairs with shapes
// at rest are found by queries of the tree. Measurements decided (tools/bench/pair_finder.cpp): with 8 100 boxes that all move, updating and querying a tree
// takes 9 times as long, with 64 boxes 3 times.
#include "../exact.hpp"

#include "../broadphase/pairs.hpp"

#include "../broadphase/columns.hpp"
#include "../broadphase/moving_shapes.hpp"
#include "../broadphase/tree.hpp"
#include "../collide/manifold.hpp"
#include "../data/parallel.hpp"
#include "../graph/contact_batches.hpp"
#include "../graph/contacts.hpp"
#include "../math/key_sort.hpp"
#include "../math/scalar.hpp"
#include "../shapes/shape_types.hpp"

namespace islet::detail {

namespace {

// True once as many pairs were dropped as the capacity has contacts; the search then ends. No contact is freed during the search, so any later pair would be
// dropped as well. Without this end, bodies that crowd together would cost the square of their number in every step.
bool is_over(const Core& core) { return core.report.dropped_contacts == core.capacity.contacts; }

// Whether two shapes may have a contact, before the filter hook is asked. Reads only, so workers may ask.
bool may_pair(const Core& core, std::uint32_t shape_1, std::uint32_t shape_2, [[maybe_unused]] float dt) {
    if (!may_collide(core, shape_1, shape_2)) return false;
    const auto is_endless_shape = [&](std::uint32_t shape) { return is_endless(core.geometries[core.shapes[shape].geometry]); };
    if (is_endless_shape(shape_1) && keeps_from_endless(core, shape_1, shape_2, dt)) return false;
    return !is_endless_shape(shape_2) || !keeps_from_endless(core, shape_2, shape_1, dt);
}

// Makes the contact of two shapes that may have one. A search may find a pair twice.
void make_contact(Core& core, std::uint32_t shape_1, std::uint32_t shape_2) {
    if (is_over(core) || have_contact(core, shape_1, shape_2) || !is_allowed(core, shape_1, shape_2)) return;
    if (!create_contact(core, shape_1, shape_2)) ++core.report.dropped_contacts;
}

void add_pair(Core& core, std::uint32_t shape_1, std::uint32_t shape_2, float dt) {
    if (may_pair(core, shape_1, shape_2, dt)) make_contact(core, shape_1, shape_2);
}

/// Makes the contacts of pairs that have none.
struct ContactMaker {
    [[maybe_unused]] static constexpr bool looks_up = true;  // whether there is a contact already
    Core& core;
    float dt;
    void add(std::uint32_t shape_1, std::uint32_t shape_2) { add_pair(core, shape_1, shape_2, dt); }
    bool is_over() const { return detail::is_over(core); }
};

// Most pairs found already have a contact. Looking them up some at a time hides the time in which the set of pairs comes from memory. On processors without
// vectors, which have hardly a cache either, pairs are looked up one by one. The others go to `sink`.
template <class Sink>
struct PairBuffer {
    static constexpr std::uint32_t size = max_lanes > 1 ? 64 : 1;
    Sink sink;
    std::uint32_t count = 0;
    std::uint64_t keys[size];
    std::uint32_t pairs[size][2];

    explicit PairBuffer(const Sink& to) : sink(to) {}  // clears no room

    void push(std::uint32_t shape_1, std::uint32_t shape_2) {
        if constexpr (size == 1) {
            if (Sink::looks_up || !have_contact(sink.core, shape_1, shape_2)) sink.add(shape_1, shape_2);
            return;
        }
        keys[count] = PairSet::key(shape_1, shape_2);
        sink.core.pairs.prefetch(keys[count]);
        pairs[count][0] = shape_1;
        pairs[count][1] = shape_2;
        if (++count == size) flush();
    }
    void flush() {
        for (std::uint32_t i = 0; i < count; ++i)
            if (!sink.core.pairs.contains(keys[i])) sink.add(pairs[i][0], pairs[i][1]);
        count = 0;
    }
    bool is_over() const { return sink.is_over(); }
};

struct Scan {
    std::uint32_t lanes = 1;         // of the world
    std::uint32_t* found = nullptr;  // room for as many indices as there are boxes, and a block more; a build for one lane needs none
};

// Calls visit(index) for the boxes from `first` on that overlap box i of `from`, in order.
template <class Visit>
ISLET_ALWAYS_INLINE inline void scan([[maybe_unused]] const Scan& how, const Columns& c, std::uint32_t first, const Columns& from, std::uint32_t i,
                                     Visit&& visit) {
#if ISLET_MAX_LANES >= 4
    const std::uint32_t count =
        ISLET_MAX_LANES >= 8 && how.lanes >= 8 ? scan_columns_8(c, first, from, i, how.found) : scan_columns<Lane4>(c, first, from, i, how.found);
    for (std::uint32_t k = 0; k < count; ++k) visit(how.found[k]);
#else
    for (std::uint32_t j = first; c.lower[j] <= from.upper[i]; ++j)
        if (c.lower2[j] <= from.upper2[i] && c.upper2[j] >= from.lower2[i]) visit(j);
#endif
}

// The pairs in which a box changed: a box that changed is compared with all boxes that begin after it, any other box with the changed boxes that do. The first
// function takes changed boxes [begin, end), the second one boxes [begin, end).
template <class Out>
void scan_changed(Out& out, const Scan& how, const Moving& m, std::uint32_t begin, std::uint32_t end) {
    const Columns& all = m.all;
    const Columns& moved = m.moved;
    for (std::uint32_t i = begin; i < end && !out.is_over(); ++i)
        scan(how, all, moved.place[i] + 1, moved, i, [&](std::uint32_t j) {
            if (m.may_meet(moved.place[i], j)) out.push(moved.shape[i], all.shape[j]);
        });
}

template <class Out>
void scan_others(Out& out, const Scan& how, const Moving& m, std::uint32_t begin, std::uint32_t end) {
    const Columns& all = m.all;
    const Columns& moved = m.moved;
    if (max_lanes > 1 && moved.count == all.count) return;
    std::uint32_t first = 0;  // of the changed boxes behind box i
    for (std::uint32_t above = begin == 0 ? 0 : moved.count; first < above;) {
        const std::uint32_t middle = first + (above - first) / 2;
        if (moved.place[middle] < begin) {
            first = middle + 1;
        } else {
            above = middle;
        }
    }
    for (std::uint32_t i = begin; i < end && !out.is_over(); ++i) {
        while (first < moved.count && moved.place[first] < i) ++first;
        if (first == moved.count) break;
        if (moved.place[first] == i) continue;
        scan(how, moved, first, all, i, [&](std::uint32_t j) {
            if (m.may_meet(i, moved.place[j])) out.push(all.shape[i], moved.shape[j]);
        });
    }
}

[[maybe_unused]] inline constexpr std::uint32_t note_grain = 8;  // words of 64 bodies that are worth a task
// m: a body whose way exceeds its boxes' slack by this may leave them; the slack ends half the speculative distance ahead of the shapes.
inline constexpr float leave_way = 0.5f * speculative_distance + 0.4f * linear_slop;
inline constexpr float alone_fraction = 0.5f;  // of its smallest half-thickness: if a body moves farther in a step, it pays to know whether it is alone

// Notes whether the body is fast, and whether it is alone, which saves up to three queries of the tree. Returns whether it may leave its boxes. (Without
// continuous collision that says nothing: contacts are made where bodies stand.)
bool note_fast(Core& core, std::uint32_t body, float dt) {
    Pose& pose = core.poses[body];
    pose.flags &= ~static_cast<std::uint32_t>(pose_fast | pose_leaves | pose_far | pose_deep);
    const float way = way_length(core, body, dt);
    if (!(way > fast_way)) return false;
    pose.flags |= pose_fast;
    if (!is_continuous(core)) return false;
    if (way > core.motions[body].slack + leave_way) pose.flags |= pose_leaves;
    if (way > surroundings(pose)) pose.flags |= pose_far;
    if (has_shortcuts && way > alone_fraction * core.bodies[body].min_extent &&
        TreeWalk(Tree{&core.state->tree, core.tree}, surroundings_of(pose)).next() == null_index)
        pose.flags |= pose_alone;
    return may_leave(pose);
}

// Notes the fast among all awake bodies, and marks the shapes of those that may leave their boxes as moved. Returns whether one of them may go beyond its
// surroundings, where the boxes of ways end.
bool note_all_fast(Core& core, float dt) {
    const BitSet awake = core.awake_bodies;
#if ISLET_SHARES_WORDS
    if (has_workers(core)) {
        std::uint32_t far_bodies = 0;
        for_ranges(core, awake.word_count, fine_grain(core, note_grain), [&](std::uint32_t first, std::uint32_t end) {
            std::uint32_t marked = 0, far_here = 0;
            awake.for_each_in(first, end, [&](std::uint32_t body) {
                if (!note_fast(core, body, dt)) return;
                if ((core.poses[body].flags & pose_far) != 0) ++far_here;
                for (std::uint32_t s = core.bodies[body].shape_head; s != null_index; s = core.shapes[s].next) mark_moved(core, s, &marked);
            });
            add_marked(core, marked);
            if (far_here != 0) __atomic_fetch_add(&far_bodies, far_here, __ATOMIC_RELAXED);
        });
        return far_bodies != 0;
    }
#endif
    bool any_far = false;
    awake.for_each([&](std::uint32_t body) {
        if (!note_fast(core, body, dt)) return;
        any_far |= (core.poses[body].flags & pose_far) != 0;
        for (std::uint32_t s = core.bodies[body].shape_head; s != null_index; s = core.shapes[s].next) mark_moved(core, s);
    });
    return any_far;
}

// True if it is known that nothing at rest overlaps any box ahead of the body. (A fat box is at most two extents, two margins and the speculative distance
// wide, and begins within one extent of the centre, as its shape does. The last term allows for rounding far from the origin.)
bool stays_alone(const Core& core, std::uint32_t body, float dt) {
    const Pose& pose = core.poses[body];
    const float way = way_length(core, body, dt);
    const float inexact = 1e-6f * (abs(pose.center.x) + abs(pose.center.y));
    const float reach = way + 3.0f * pose.max_extent + 2.0f * (max_box_margin + speculative_distance) + inexact;
    return (pose.flags & pose_alone) != 0 && reach <= pose.max_extent + surroundings(pose);
}

// The pairs of changed boxes [begin, end) with shapes at rest.
template <class Out>
void query_tree(Out& out, const Moving& m, std::uint32_t begin, std::uint32_t end) {
    const Core& core = out.sink.core;
    for (std::uint32_t i = begin; i < end && !out.is_over(); ++i) {
        const MovingShape& shape = m.in_place(m.moved.place[i]);
        const Aabb box = box_along_way(core, shape);
        if (is_clear(core.poses[shape.body], box)) continue;
        tree_query({&core.state->tree, core.tree}, box, [&](std::uint32_t other) {
            if (!has_continuous || !shape.leaves || meet(shape.box, core.boxes[other]) || may_meet_on(core.boxes[other], {}, shape.box, shape.way, m.fall))
                out.push(shape.shape, other);
        });
    }
}

/// The search for pairs with shapes in motion has three parts; each is a loop over items.
inline constexpr std::uint32_t search_parts = 3;

std::uint32_t items_of(const Moving& m, std::uint32_t part) { return part == 1 ? m.all.count : m.moved.count; }

template <class Out>
void search(Out& out, const Scan& how, const Moving& m, std::uint32_t part, std::uint32_t begin, std::uint32_t end) {
    if (part == 0) scan_changed(out, how, m, begin, end);
    if (part == 1) scan_others(out, how, m, begin, end);
    if (part == 2) query_tree(out, m, begin, end);
}

/// A range of a part of the search, which a worker makes: the pairs that may have a contact and have none yet, in order.
struct SearchRange {
    static constexpr std::uint32_t room = 512;  // pairs; a range with more is searched again when contacts are made, as it may be in the first steps of a world
    std::uint32_t part = 0, begin = 0, end = 0;
    std::uint32_t count = 0;
    std::uint32_t (*pairs)[2] = nullptr;
    std::uint32_t* found = nullptr;  // room for a scan

    bool is_over() const { return count > room; }
};

/// Lists the pairs of a range.
struct PairLister {
    [[maybe_unused]] static constexpr bool looks_up = false;
    const Core& core;
    SearchRange& range;
    float dt;

    void add(std::uint32_t shape_1, std::uint32_t shape_2) {
        if (!may_pair(core, shape_1, shape_2, dt)) return;
        if (range.count < SearchRange::room) {
            range.pairs[range.count][0] = shape_1;
            range.pairs[range.count][1] = shape_2;
        }
        ++range.count;
    }
    bool is_over() const { return range.is_over(); }
};

inline constexpr std::uint32_t least_searched = 512;   // boxes that make few workers pay; of those that make many pay, a quarter
inline constexpr std::uint32_t ranges_per_worker = 4;  // of each part
inline constexpr std::uint32_t least_ranges = 16;      // of each part, so that few overflow

#if ISLET_THREADS
// Makes the contacts of all listed pairs, by several workers. False if they have to be made one by one.
bool make_listed(Core& core, const SearchRange* ranges, std::uint32_t count, Arena arena) {
    std::uint32_t listed = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
        if (ranges[k].is_over()) return false;
        listed += ranges[k].count;
    }
    if (!in_batches(core, listed) || arena.room() < sizeof(std::uint32_t) * listed + line_bytes) return false;
    std::uint32_t* const made = arena.take<std::uint32_t>(listed);
    std::uint32_t next = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
        for (std::uint32_t i = 0; i < ranges[k].count && !is_over(core); ++i) {
            const auto [shape_1, shape_2] = ranges[k].pairs[i];
            if (have_contact(core, shape_1, shape_2)) continue;
            if (name_contact(core, shape_1, shape_2, made[next])) {
                ++next;
            } else {
                ++core.report.dropped_contacts;
            }
        }
    }
    make_contacts(core, {made, next});
    return true;
}
#endif

// Workers search the ranges; then the contacts are made in order. False if there is no room in scratch memory for that.
bool search_by_workers(Core& core, const Moving& m, ContactMaker maker, Arena arena) {
    const std::size_t bytes_of_range =
        sizeof(SearchRange) + align_up(sizeof(std::uint32_t[2]) * SearchRange::room) + align_up((m.all.count + max_block_lanes) * std::size_t{4});
    const std::size_t fitting = arena.room() <= line_bytes ? 0 : (arena.room() - line_bytes) / (search_parts * bytes_of_range);
    const std::uint32_t shared = ranges_per_worker * worker_count(core), wanted = shared < least_ranges ? least_ranges : shared;
    const std::uint32_t ranges_of_part = fitting < wanted ? static_cast<std::uint32_t>(fitting) : wanted;
    if (ranges_of_part < 2) return false;
    const std::uint32_t count = search_parts * ranges_of_part;
    SearchRange* ranges = arena.take<SearchRange>(count);
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t part = k / ranges_of_part, i = k % ranges_of_part;
        const std::uint64_t items = items_of(m, part);
        SearchRange& range = ranges[k] = {};
        range.part = part;
        range.begin = static_cast<std::uint32_t>(items * i / ranges_of_part);
        range.end = static_cast<std::uint32_t>(items * (i + 1) / ranges_of_part);
        range.pairs = arena.take<std::uint32_t[2]>(SearchRange::room);
        range.found = arena.take<std::uint32_t>(m.all.count + max_block_lanes);
    }
    for_ranges(core, count, 1, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t k = first; k < end; ++k) {
            SearchRange& range = ranges[count - 1 - k];  // the queries of the tree first: they take longest
            PairBuffer<PairLister> out({core, range, maker.dt});
            search(out, {core.lanes, range.found}, m, range.part, range.begin, range.end);
            out.flush();
        }
    });
#if ISLET_THREADS
    if (make_listed(core, ranges, count, arena)) return true;
#endif
    for (std::uint32_t k = 0; k < count; ++k) {
        SearchRange& range = ranges[k];
        if (range.is_over()) {
            PairBuffer<ContactMaker> out(maker);
            search(out, {core.lanes, range.found}, m, range.part, range.begin, range.end);
            out.flush();
        } else {
            for (std::uint32_t i = 0; i < range.count; ++i) make_contact(core, range.pairs[i][0], range.pairs[i][1]);
        }
    }
    return true;
}

// Finds the pairs of the shapes in motion, and of those at rest whose boxes changed.
ISLET_APART void find_pairs_of(Core& core, const Moving& moving, Arena& arena, float dt) {
    const Tree tree{&core.state->tree, core.tree};
    PairBuffer<ContactMaker> out({core, dt});
    if (!has_workers(core) || moving.all.count < fine_grain(core, least_searched) || !search_by_workers(core, moving, out.sink, arena)) {
        const Scan how{core.lanes, max_lanes > 1 ? arena.take<std::uint32_t>(moving.all.count + max_block_lanes) : nullptr};
        for (std::uint32_t part = 0; part < search_parts; ++part) search(out, how, moving, part, 0, items_of(moving, part));
    }

    // Shapes at rest whose boxes changed were just created or teleported, or fell asleep as they moved. Each pair is tried once, so a dropped one counts once.
    core.moved_shapes.for_each([&](std::uint32_t shape) {
        if (core.is_awake(core.shapes[shape].body) || is_over(core)) return;
        // Shapes in motion whose boxes changed have found it in the tree.
        for (std::uint32_t i = 0; moving.moved.count != moving.all.count && i < moving.all.count; ++i) {
            const std::uint32_t other = moving.all.shape[i];
            if (meet(core.boxes[other], core.boxes[shape]) && !core.moved_shapes.test(other)) out.push(shape, other);
        }
        tree_query(tree, core.boxes[shape], [&](std::uint32_t other) {
            if (other > shape || !core.moved_shapes.test(other)) out.push(shape, other);
        });
    });
    out.flush();
}

// Finds every pair in which a fat box changed.
void find_moved_pairs(Core& core, float dt) {
    Arena arena = core.arena();
    const Moving moving = sorted_columns(core, arena, dt);
    find_pairs_of(core, moving, arena, dt);
}

// Makes contacts of a fast body with the static shapes that it may reach in this step, so that it does not pass through them.
void look_ahead(Core& core, std::uint32_t body, float dt) {
    const Tree tree{&core.state->tree, core.tree};
    const Way way = way_of(core, body, dt);
    const float fall = fall_in(core, dt);
    for (std::uint32_t s = core.bodies[body].shape_head; s != null_index; s = core.shapes[s].next) {
        const Aabb ahead = grow(core.boxes[s], way, 3.0e38f);
        if (is_clear(core.poses[body], ahead)) continue;
        tree_query(tree, ahead, [&](std::uint32_t other) {
            // If the fat boxes overlap, the contact is there already, or was dropped and counted.
            const bool is_static = core.bodies[core.shapes[other].body].type() == BodyType::static_body;
            if (is_static && !meet(core.boxes[s], core.boxes[other]) && may_meet_on(core.boxes[other], {}, core.boxes[s], way, fall))
                add_pair(core, s, other, dt);
        });
    }
}

}  // namespace

void mark_moved(Core& core, std::uint32_t shape, [[maybe_unused]] std::uint32_t* marked) {
    core.poses[core.shapes[shape].body].flags |= pose_moved;
#if ISLET_SHARES_WORDS
    if (marked != nullptr) {
        if (!set_at_once(core.moved_shapes, shape)) ++*marked;
        return;
    }
#endif
    if (core.moved_shapes.test(shape)) return;
    core.moved_shapes.set(shape);
    ++core.state->moved_count;
}

void add_marked(Core& core, std::uint32_t marked) {
    if (marked == 0) return;
#if ISLET_SHARES_WORDS
    __atomic_fetch_add(&core.state->moved_count, marked, __ATOMIC_RELAXED);
#else
    core.state->moved_count += marked;
#endif
}

bool may_meet(const Core& core, std::uint32_t body_a, const Aabb& box_a, std::uint32_t body_b, const Aabb& box_b, float dt) {
    if (!may_leave(core.poses[body_a]) && !may_leave(core.poses[body_b])) return false;
    const Approach approach = approach_of(core.poses[body_a], core.poses[body_b], core.motions[body_a], core.motions[body_b], dt, fall_in(core, dt));
    return meet(box_a, grow(box_b, {approach.way, approach.turn}, 3.0e38f));
}

bool keeps_from_endless(const Core& core, std::uint32_t shape_a, std::uint32_t shape_b, float dt) {
    const Shape& a = core.shapes[shape_a];
    if (!is_endless(core.geometries[a.geometry])) return false;
    const std::uint32_t body_b = core.shapes[shape_b].body;
    Aabb box = core.boxes[shape_b];
    if (may_leave(core.poses[a.body]) || may_leave(core.poses[body_b])) {
        const Approach approach = approach_of(core.poses[a.body], core.poses[body_b], core.motions[a.body], core.motions[body_b], dt, fall_in(core, dt));
        box = grow(box, {approach.way, approach.turn}, 3.0e38f);
    }
    return !reaches_endless(core.geometries[a.geometry], {core.bodies[a.body].origin, core.poses[a.body].q}, box);
}

void find_pairs(Core& core, float dt) {
    core.report.dropped_contacts = 0;
    const bool any_far = note_all_fast(core, dt);
    if (core.state->moved_count != 0) find_moved_pairs(core, dt);
    if (has_continuous && any_far) {
        core.awake_bodies.for_each([&](std::uint32_t body) {
            constexpr std::uint32_t both_flags = pose_leaves | pose_far;
            if ((core.poses[body].flags & both_flags) == both_flags && (!has_shortcuts || !stays_alone(core, body, dt))) look_ahead(core, body, dt);
        });
    }
    if (core.report.dropped_contacts != 0) {
        core.fail(Error::contacts_full);  // shapes that moved stay marked, so the next step tries the same pairs again
        return;
    }
    core.moved_shapes.clear_all();
    core.state->moved_count = 0;
}

}  // namespace islet::detail
