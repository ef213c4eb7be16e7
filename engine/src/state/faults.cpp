// Finds what is wrong with pools, bits, indices and lists, through which one record leads to another. The order of the checks is pools, numbers and indices of
// each record, lists, the tree: each check relies on the ones before it.
#include "../exact.hpp"

#include "../state/faults.hpp"

#include "../bodies/bounds.hpp"
#include "../bodies/joint_changes.hpp"
#include "../broadphase/tree.hpp"
#include "../calls/checks.hpp"
#include "../data/arrays.hpp"
#include "../graph/contacts.hpp"
#include "../graph/joint_graph.hpp"
#include "../island/joint_trees.hpp"
#include "../state/image.hpp"
#include "../state/image_records.hpp"

namespace islet::detail {

namespace {

/// Calls fault(i) for each live slot until one returns a sentence.
template <class T, class Fault>
const char* first_fault(const PoolState& pool, const T* slots, Fault&& fault) {
    const char* bad = nullptr;
    for (std::uint32_t i = 0; bad == nullptr && i < pool.high_water; ++i)
        if (pool_live(pool, slots, i)) bad = fault(i);
    return bad;
}

// -- pools ---------------------------------------------------------------------------------------------------------------------------

/// is_live(i) and next(i) read slots that were used.
template <class IsLive, class Next>
const char* fault_in_free_list(const PoolState& pool, std::uint32_t live, IsLive&& is_live, Next&& next) {
    if (live != pool.count) return "a pool miscounts its live slots";
    std::uint32_t free = 0;
    for (std::uint32_t i = pool.free_head; i != null_index; i = next(i)) {
        if (i >= pool.high_water || is_live(i)) return "a free list holds a live slot";
        if (++free > pool.high_water) return "a free list has a cycle";
    }
    return live + free == pool.high_water ? nullptr : "a pool lost a slot";
}

template <class T>
const char* fault_in_pool(const PoolState& pool, const T* slots, std::uint32_t capacity) {
    if (pool.high_water > capacity || pool.count > pool.high_water) return "a pool holds more than its capacity";
    std::uint32_t live = 0;
    for (std::uint32_t i = 0; i < pool.high_water; ++i) live += slots[i].generation & 1u;
    return fault_in_free_list(
        pool, live, [&](std::uint32_t i) { return (slots[i].generation & 1u) != 0; }, [&](std::uint32_t i) { return slots[i].next_free; });
}

// Geometries have no generation: one that shapes refer to is live.
const char* fault_in_geometry_pool(const Core& c, Arena scratch) {
    const State& s = *c.state;
    const PoolState& pool = s.geometry_pool;
    // A shape adds at most one geometry, so there are never more geometries than shapes.
    if (pool.high_water > geometry_capacity(c.capacity) || pool.high_water > s.shape_pool.high_water) return "a pool holds more than its capacity";
    std::uint32_t* references = scratch.take<std::uint32_t>(pool.high_water);
    for (std::uint32_t i = 0; i < pool.high_water; ++i) references[i] = 0;
    const char* bad = first_fault(s.shape_pool, c.shapes, [&](std::uint32_t i) -> const char* {
        if (c.shapes[i].geometry >= pool.high_water) return "a shape has no geometry";
        ++references[c.shapes[i].geometry];
        return nullptr;
    });
    if (bad != nullptr) return bad;
    std::uint32_t live = 0;
    for (std::uint32_t i = 0; i < pool.high_water; ++i) {
        if (references[i] != c.geometries[i].references) return "a geometry miscounts its shapes";
        live += references[i] != 0 ? 1 : 0;
    }
    return fault_in_free_list(
        pool, live, [&](std::uint32_t i) { return references[i] != 0; }, [&](std::uint32_t i) { return c.geometries[i].next; });
}

/// Bits may be set for live slots only.
template <class T>
const char* fault_in_bits(const BitSet& bits, const PoolState& pool, const T* slots) {
    for (std::uint32_t i = 0; i < bits.word_count * 64; ++i)
        if (bits.test(i) && !pool_live(pool, slots, i)) return "a bit is set for what does not exist";
    return nullptr;
}

/// The pool of slots that an array has an element for.
template <Per per>
const PoolState& pool_of(const State& s) {
    if constexpr (per == Per::body) return s.body_pool;
    if constexpr (per == Per::shape) return s.shape_pool;
    if constexpr (per == Per::contact) return s.contact_pool;
    if constexpr (per == Per::joint) return s.joint_pool;
}
template <Per per, class AnyCore>
auto* slots_of(const AnyCore& c) {
    if constexpr (per == Per::body) return c.bodies;
    if constexpr (per == Per::shape) return c.shapes;
    if constexpr (per == Per::contact) return c.contacts;
    if constexpr (per == Per::joint) return c.joints;
}

/// Whether a member of Core points to records that come from a pool.
template <class Array, class = void>
constexpr bool has_generation = false;
template <class Array>
constexpr bool has_generation<Array, decltype(void(Array {} -> generation))> = true;

template <class AnyCore>
const char* fault_in_pools(const AnyCore& c, Arena scratch) {
    const State& s = *c.state;
    const char* bad = nullptr;
    for_each_array(c, [&](auto& array, auto row) {
        if constexpr (row.array == Array::geometries) {
            if (bad == nullptr) bad = fault_in_geometry_pool(c, scratch);
        } else if constexpr (row.size == one_bit) {
            if (bad == nullptr) bad = fault_in_bits(array, pool_of<row.per>(s), slots_of<row.per>(c));
        } else if constexpr (row.kept == Kept::saved && has_generation<std::decay_t<decltype(array)>>) {
            if (bad == nullptr) bad = fault_in_pool(pool_of<row.per>(s), array, static_cast<std::uint32_t>(room_for(row.per, c.capacity)));
        }
    });
    if (bad == nullptr && c.moved_shapes.count() != s.moved_count) bad = "the shapes that moved are miscounted";
    return bad;
}

// -- one record at a time: numbers, and indices of what must exist ---------------------------------------------------------------------

bool live_body(const Core& c, std::uint32_t i) { return pool_live(c.state->body_pool, c.bodies, i); }
bool live_shape(const Core& c, std::uint32_t i) { return pool_live(c.state->shape_pool, c.shapes, i); }
bool live_joint(const Core& c, std::uint32_t i) { return pool_live(c.state->joint_pool, c.joints, i); }

const char* fault_in_ends(const Core& c, const Joint& j) {
    const auto type = j.joint_type();
    if (!live_body(c, j.body_b) || (type == JointType::mouse ? j.body_a != null_index : !live_body(c, j.body_a) || j.body_a == j.body_b))
        return "a joint's body is gone";
    if (type == JointType::gear && (!live_joint(c, j.joint1) || !live_joint(c, j.joint2))) return "a gear's joint is gone";
    return nullptr;
}

template <class AnyCore>
const char* fault_in_records(const AnyCore& c) {
    const State& s = *c.state;
    const char* bad = fault_in_numbers(s);
    if (bad == nullptr) bad = first_fault(s.body_pool, c.bodies, [&](std::uint32_t i) { return fault_in_numbers(c.bodies[i], c.poses[i], c.motions[i]); });
    for (std::uint32_t i = 0; bad == nullptr && i < s.geometry_pool.high_water; ++i)
        if (c.geometries[i].references != 0) bad = fault_in_numbers(c.geometries[i]);
    if (bad != nullptr) return bad;
    bad = first_fault(s.shape_pool, c.shapes,
                      [&](std::uint32_t i) { return live_body(c, c.shapes[i].body) ? fault_in_numbers(c.shapes[i], c.boxes[i]) : "a shape's body is gone"; });
    if (bad != nullptr) return bad;
    bad = first_fault(s.contact_pool, c.contacts, [&](std::uint32_t i) -> const char* {
        const auto& contact = c.contacts[i];
        const auto& m = c.manifolds[i];
        if (!live_shape(c, contact.shape_a) || !live_shape(c, contact.shape_b)) return "a contact's shape is gone";
        if (c.shapes[contact.shape_a].body != m.body_a || c.shapes[contact.shape_b].body != m.body_b) return "a contact's bodies are not its shapes'";
        return fault_in_numbers(image_of(m));
    });
    if (bad != nullptr) return bad;
    return first_fault(s.joint_pool, c.joints, [&](std::uint32_t i) {
        const char* ends = fault_in_ends(c, c.joints[i]);
        return ends != nullptr ? ends : fault_in_numbers(c.joints[i]);
    });
}

// -- lists ---------------------------------------------------------------------------------------------------------------------------

/// Walks a body's list of constraints. `body_of(constraint, side)` and `color_of(constraint)` read them. Collects the colours in use.
template <class Constraint, class BodyOf, class ColorOf>
const char* fault_in_list(const PoolState& pool, const Constraint* constraints, std::uint32_t body, std::uint32_t head, std::uint32_t count, BodyOf&& body_of,
                          ColorOf&& color_of, std::uint32_t& colors) {
    std::uint32_t walked = 0;
    std::uint32_t prev = 0;
    for (std::uint32_t key = head; key != 0; ++walked) {
        const std::uint32_t constraint = constraint_of_key(key);
        const std::uint32_t side = side_of_key(key);
        if (walked == count || !pool_live(pool, constraints, constraint)) return "a body's list of constraints is broken";
        if (body_of(constraint, side) != body || constraints[constraint].prev[side] != prev) return "a constraint is in the wrong list";
        const std::uint32_t color = color_of(constraint);
        if (color != no_color) {
            if ((colors >> color & 1u) != 0) return "two constraints of a body share a colour";
            colors |= 1u << color;
        }
        prev = key;
        key = constraints[constraint].next[side];
    }
    return walked == count ? nullptr : "a body miscounts its constraints";
}

const char* fault_in_shapes_of(const Core& c, std::uint32_t i) {
    const Body& b = c.bodies[i];
    const bool rests = !c.is_awake(i) && (b.flags & body_disabled) == 0;
    std::uint32_t shapes = 0;
    std::uint32_t prev = null_index;
    for (std::uint32_t s = b.shape_head; s != null_index; s = c.shapes[s].next, ++shapes) {
        if (shapes == b.shape_count || !live_shape(c, s) || c.shapes[s].body != i || c.shapes[s].prev != prev) return "a body's list of shapes is broken";
        const std::uint32_t leaf = c.shapes[s].tree_node;
        if ((leaf != null_index) != rests) return "a shape is in the wrong half of the broad phase";
        if (rests && (leaf >= c.state->tree.high_water || c.tree[leaf].child1 != null_index || c.tree[leaf].child2 != s))
            return "a tree leaf does not know its shape";
        if (rests && c.tree[leaf].box != c.boxes[s]) return "a tree leaf has another box than its shape";
        prev = s;
    }
    return shapes == b.shape_count ? nullptr : "a body miscounts its shapes";
}

template <class AnyCore>
ISLET_APART const char* fault_in_body(const AnyCore& c, std::uint32_t i) {
    const Body& b = c.bodies[i];
    const bool dynamic = b.type() == BodyType::dynamic;
    if (c.is_awake(i) && b.type() == BodyType::static_body) return "a static body is awake";
    if (c.is_awake(i) && (b.flags & body_disabled) != 0) return "a disabled body is awake";
    const char* bad = fault_in_shapes_of(c, i);
    if (bad != nullptr) return bad;
    std::uint32_t colors = 0;
    bad = fault_in_list(
        c.state->contact_pool, c.contacts, i, b.contact_head, b.contact_count,
        [&](std::uint32_t contact, std::uint32_t side) { return side == 0 ? c.manifolds[contact].body_a : c.manifolds[contact].body_b; },
        [&](std::uint32_t contact) { return dynamic ? c.manifolds[contact].color() : no_color; }, colors);
    if (bad != nullptr) return bad;
    bad = fault_in_list(
        c.state->joint_pool, c.joints, i, b.joint_head, b.joint_count,
        [&](std::uint32_t joint, std::uint32_t side) { return side == 0 ? c.joints[joint].body_a : c.joints[joint].body_b; },
        [&](std::uint32_t joint) { return dynamic ? c.joints[joint].color() : no_color; }, colors);
    if (bad != nullptr) return bad;
    return colors == b.colors ? nullptr : "a body's colours are not those of its constraints";
}

// If every list holds only constraints of its body, and there are as many entries as constraints have ends, each constraint is in the list at each of its ends.
template <class AnyCore>
const char* fault_in_lists(const AnyCore& c) {
    const State& s = *c.state;
    std::uint32_t shapes = 0, resting = 0, contacts = 0, joints = 0, ends = 0;
    const char* bad = first_fault(s.body_pool, c.bodies, [&](std::uint32_t i) {
        shapes += c.bodies[i].shape_count;
        resting += c.is_awake(i) || (c.bodies[i].flags & body_disabled) != 0 ? 0 : c.bodies[i].shape_count;
        contacts += c.bodies[i].contact_count;
        joints += c.bodies[i].joint_count;
        return fault_in_body(c, i);
    });
    if (bad != nullptr) return bad;
    for_each_live(s.joint_pool, c.joints, [&](std::uint32_t i) { ends += c.joints[i].body_a != null_index ? 2 : 1; });
    if (shapes != s.shape_pool.count) return "a shape is in no list";
    if (resting != s.tree.leaf_count) return "the tree holds more than the shapes at rest";
    return contacts == 2 * s.contact_pool.count && joints == ends ? nullptr : "a constraint is in no list";
}

// -- numbers that follow from others: where bodies and boxes are, how far they reach ----------------------------------------------------

// How much rounding can change these numbers. A number is rounded by at most `epsilon` of itself. No number between a body's centre and the side of its fat box
// is larger than this sum: the centre, the arm to the origin and back, the farthest point of a shape, and 1 m for margins and other small numbers.
constexpr float epsilon = 0x1p-24f;

float span_of(const Core& c, std::uint32_t i) {
    const Vec2 center = c.poses[i].center, arm = c.bodies[i].local_center;
    return 1.0f + abs(center.x) + abs(center.y) + 2.0f * (abs(arm.x) + abs(arm.y)) + c.poses[i].max_extent;
}

// Rounding of a tight box, made twice: 5 roundings of an origin, 4 of a corner's position, 3 on the way to the side of a box, 4 of a turn's length.
float box_rounding(const Core& c, std::uint32_t i) { return 32.0f * epsilon * span_of(c, i); }

// How much farther a body may have gone than its slack counted, because each step rounds: a turn 4 times, the centre's way 3 times. Beyond 2^24 steps the bound
// no longer grows.
float drift_of(const Core& c, std::uint32_t i) {
    if (c.bodies[i].type() == BodyType::static_body) return 0;
    constexpr std::uint32_t many = 1u << 24;
    const auto steps = static_cast<float>(c.state->steps < many ? static_cast<std::uint32_t>(c.state->steps) : many);
    return 8.0f * epsilon * steps * span_of(c, i);
}

// The most room that a shape can have in its fat box, m: half the box's smaller side.
float most_room(const Aabb& fat) { return 0.5f * min(fat.upper.x - fat.lower.x, fat.upper.y - fat.lower.y); }

// How far the body may move before the shape leaves its fat box, m, seen from the body's centre: however far away the body is, only lengths of the size of the
// body and the box are rounded. So no step can change this by more than twice the way that it takes from the slack, and what is sound once remains so.
float room_of(const Core& c, std::uint32_t s) {
    const Geometry& g = c.geometries[c.shapes[s].geometry];
    const std::uint32_t body = c.shapes[s].body;
    const Rot q = c.poses[body].q;
    const Vec2 center = c.poses[body].center;
    const Vec2 here = is_endless(g) ? Vec2{0, 0} : center;  // what has no end reaches equally far wherever it is
    const Vec2 origin = center - here - rotate(q, c.bodies[body].local_center);
    return room_in_box({c.boxes[s].lower - here, c.boxes[s].upper - here}, g, {origin, q});
}

const char* fault_in_place(const Core& c, std::uint32_t i) {
    const Body& b = c.bodies[i];
    const Pose& pose = c.poses[i];
    const Vec2 gap = transform_point(body_transform(c, i), b.local_center) - pose.center;
    const float rounding = box_rounding(c, i);
    if (!(abs(gap.x) <= rounding && abs(gap.y) <= rounding)) return "a body's centre is not where its origin says";
    const Extent extent = body_extent(c, i);
    if (pose.max_extent != extent.max || b.min_extent != extent.min) return "a body's extent is not its shapes'";
    // A step that is shorter than the distance between two floats is rounded to nothing, or to at most twice its length. So is the way since the boxes were
    // made, by which their room has shrunk.
    float room = 3.0e38f, slack = room;
    for (std::uint32_t s = b.shape_head; s != null_index; s = c.shapes[s].next) {
        room = min(room, most_room(c.boxes[s]));
        slack = min(slack, room_of(c, s));
    }
    const float most = is_beyond(pose.center) ? -1.0f : min(slack + drift_of(c, i), 0.5f * (room + slack)) + rounding;
    return c.motions[i].slack <= most ? nullptr : "a body thinks that its boxes have more room";
}

const char* fault_in_box(const Core& c, std::uint32_t s) {
    const std::uint32_t body = c.shapes[s].body;
    if (is_endless(c.geometries[c.shapes[s].geometry]) && c.bodies[body].type() == BodyType::dynamic) return "a dynamic body has a shape without end";
    // No more than what a body may have lost unseen whose slack is 0.
    const float inexact = 2.0f * box_rounding(c, body) + min(drift_of(c, body), max(0.0f, most_room(c.boxes[s])));
    return room_of(c, s) >= -inexact ? nullptr : "a shape has left its fat box";
}

// -- constraints ---------------------------------------------------------------------------------------------------------------------

// A contact's flags for events and hooks follow from its shapes.
template <class Index>
const char* fault_in_told(const Core& c, const ContactWith<Index>& contact, const ManifoldWith<Index>& m) {
    const Shape& a = c.shapes[contact.shape_a];
    const Shape& b = c.shapes[contact.shape_b];
    const std::uint32_t flags = a.flags | b.flags;
    const bool sensor = (flags & shape_sensor) != 0;
    if (((m.flags & contact_sensor) != 0) != sensor) return "a sensor's contact is not marked as one, or the reverse";
    if (sensor && ((m.flags & (contact_touching | contact_special | contact_bouncy | contact_hits | contact_asks)) != 0 || m.count() != 0))
        return "a sensor's contact is solved";
    if (!sensor && (m.flags & contact_overlap) != 0) return "a contact that is no sensor's has an overlap";
    if (!sensor && (m.flags & contact_hits) != 0 && (flags & shape_hit_events) == 0) return "a contact tells of hits unasked";
    if (!sensor && (m.flags & contact_asks) != 0 && (flags & shape_pre_solve) == 0) return "a contact asks the hook unasked";
    if (((m.flags & contact_one_way) != 0) != (!sensor && has_one_way && (flags & shape_one_way_bits) != 0))
        return "a contact of a one-way shape is not marked as one, or the reverse";
    if ((m.flags & contact_one_way) == 0 && (m.flags & (contact_passes | contact_dropped)) != 0) return "a contact passes unasked";
    if (!contact.has_own_speed()) return nullptr;
    const float speed = contact.own_speed();
    return (m.flags & contact_asks) != 0 && abs(speed) <= max_speed_limit ? nullptr : "a contact's surface speed is out of range";
}

template <class AnyCore>
const char* fault_in_contact(const AnyCore& c, std::uint32_t i) {
    const auto& contact = c.contacts[i];
    const auto& m = c.manifolds[i];
    if (!may_collide(c, contact.shape_a, contact.shape_b)) return "two shapes that may not collide have a contact";
    if (!in_contact_order(c, contact.shape_a, contact.shape_b)) return "a contact's shapes are the wrong way round";
    const bool awake_a = c.is_awake(m.body_a), awake_b = c.is_awake(m.body_b);
    if (c.awake_contacts.test(i) != (awake_a || awake_b)) return "a contact is awake though its bodies sleep, or the reverse";
    const bool touching = (m.flags & contact_touching) != 0;
    if (const char* bad = fault_in_told(c, contact, m)) return bad;
    if (touching != (m.count() > 0)) return "a contact touches without points, or the reverse";
    if (!touching && m.color() != no_color) return "a contact that does not touch has a colour";
    const std::uint32_t asleep = awake_a ? m.body_b : m.body_a;
    if (touching && awake_a != awake_b && c.is_dynamic(asleep)) return "what sleeps touches what is awake";
    return nullptr;
}

const char* fault_in_gear(const Core& c, const Joint& gear) {
    const Joint& j1 = c.joints[gear.joint1];
    const Joint& j2 = c.joints[gear.joint2];
    for (const Joint* j : {&j1, &j2}) {
        const auto type = j->joint_type();
        if (type != JointType::revolute && type != JointType::prismatic) return "a gear couples the wrong joints";
    }
    const std::uint32_t b = moving_body(c, j2);
    const bool hangs_right = gear.body_a == moving_body(c, j1) && gear.body_b == (b != gear.body_a ? b : b == j2.body_b ? j2.body_a : j2.body_b);
    return hangs_right ? nullptr : "a gear hangs on the wrong bodies";
}

const char* fault_in_joint(const Core& c, std::uint32_t i) {
    const Joint& j = c.joints[i];
    const bool has_a = j.body_a != null_index;
    const bool awake_a = has_a && c.is_awake(j.body_a), awake_b = c.is_awake(j.body_b);
    if (c.awake_joints.test(i) != is_joint_awake(c, j)) return "a joint is awake though its bodies sleep, or the reverse";
    if (!is_joint_idle(c, j) && has_a && awake_a != awake_b && c.is_dynamic(awake_a ? j.body_b : j.body_a)) return "an island is half asleep";
    return j.joint_type() == JointType::gear ? fault_in_gear(c, j) : nullptr;
}

const char* fault_in_gear_counts(const Core& c, Arena scratch) {
    const PoolState& pool = c.state->joint_pool;
    std::uint32_t* gears = scratch.take<std::uint32_t>(pool.high_water);
    for (std::uint32_t i = 0; i < pool.high_water; ++i) gears[i] = 0;
    for_each_live(pool, c.joints, [&](std::uint32_t i) {
        if (c.joints[i].joint_type() != JointType::gear) return;
        ++gears[c.joints[i].joint1];
        ++gears[c.joints[i].joint2];
    });
    return first_fault(pool, c.joints, [&](std::uint32_t i) { return c.joints[i].gear_count == gears[i] ? nullptr : "a joint miscounts its gears"; });
}

// Hinges marked as joint trees must be trees, unless they are to be marked anew anyway.
const char* fault_in_trees(const Core& c, Arena scratch) {
    constexpr const char* miscounted = "the hinges of trees are miscounted";
    if (c.state->trees_stale != 0) return nullptr;
    if (!has_joint(JointType::revolute)) return c.state->exact_joints == 0 ? nullptr : miscounted;
    const Forest forest(c.state->body_pool.high_water, scratch);
    std::uint32_t marked = 0;
    for (std::uint32_t i = 0; i < c.state->joint_pool.high_water; ++i) {
        if (!live_joint(c, i) || (c.joints[i].flags & joint_exact) == 0) continue;
        ++marked;
        if (!forest.add(c, c.joints[i])) return "hinges that are no tree are solved as one";
    }
    for (std::uint32_t i = 0; i < c.state->joint_pool.high_water; ++i) {
        const Joint& j = c.joints[i];
        if (live_joint(c, i) && ((j.flags & joint_anchor) != 0) != ((j.flags & joint_exact) != 0 && forest.is_anchor(c, j)))
            return "a tree of hinges mistakes what holds it";
    }
    return marked == c.state->exact_joints ? nullptr : miscounted;
}

const char* fault_in_counts(const Core& c) {
    const State& s = *c.state;
    std::uint32_t bullets = 0, locked = 0;
    for_each_live(s.body_pool, c.bodies, [&](std::uint32_t i) {
        bullets += (c.bodies[i].flags & body_bullet) != 0 ? 1 : 0;
        locked += c.bodies[i].has_locks() ? 1 : 0;
    });
    for (std::uint32_t i = 0; i < s.shape_pool.high_water; ++i)
        if (live_shape(c, i) && (asked_of(c.shapes[i].flags) & ~s.asked) != 0) return "a shape has a flag that the world does not know of";
    return bullets != s.bullet_count ? "the bullets are miscounted" : locked != s.locked_count ? "the bodies with locks are miscounted" : nullptr;
}

template <class AnyCore>
const char* fault_in_pairs(const AnyCore& c, Arena scratch) {
    const std::uint32_t size = next_power_of_two(2 * c.state->contact_pool.high_water + 1);
    PairSet seen{scratch.take<std::uint64_t>(size), size - 1};
    std::memset(seen.keys, 0, std::size_t{size} * 8);
    return first_fault(c.state->contact_pool, c.contacts, [&](std::uint32_t i) -> const char* {
        const std::uint64_t key = PairSet::key(c.contacts[i].shape_a, c.contacts[i].shape_b);
        if (seen.contains(key)) return "two shapes have two contacts";
        seen.insert(key);
        return nullptr;
    });
}

// Checks the arrays that images do not hold, because they follow from the others.
const char* fault_in_pair_set(const Core& c) {
    if (!has_pair_set) return nullptr;
    const PoolState& pool = c.state->contact_pool;
    std::uint32_t keys = 0;
    for (std::uint32_t i = 0; i <= c.pairs.mask; ++i) keys += c.pairs.keys[i] != 0 ? 1 : 0;
    if (keys != pool.count) return "the pair set does not hold one key per contact";
    return first_fault(pool, c.contacts, [&](std::uint32_t i) {
        return c.pairs.contains(PairSet::key(c.contacts[i].shape_a, c.contacts[i].shape_b)) ? nullptr : "a contact is missing from the pair set";
    });
}

}  // namespace

template <class AnyCore>
const char* find_fault(const AnyCore& c, Arena scratch) {
    const State& s = *c.state;
    const char* bad = fault_in_pools(c, scratch);
    if (bad == nullptr) bad = fault_in_records(c);
    if (bad == nullptr) bad = fault_in_lists(c);
    if (bad == nullptr) bad = first_fault(s.body_pool, c.bodies, [&](std::uint32_t i) { return fault_in_place(c, i); });
    if (bad == nullptr) bad = first_fault(s.shape_pool, c.shapes, [&](std::uint32_t i) { return fault_in_box(c, i); });
    if (bad == nullptr) bad = first_fault(s.contact_pool, c.contacts, [&](std::uint32_t i) { return fault_in_contact(c, i); });
    if (bad == nullptr) bad = first_fault(s.joint_pool, c.joints, [&](std::uint32_t i) { return fault_in_joint(c, i); });
    if (bad == nullptr) bad = fault_in_gear_counts(c, scratch);
    if (bad == nullptr) bad = fault_in_trees(c, scratch);
    if (bad == nullptr) bad = fault_in_counts(c);
    if (bad == nullptr) bad = fault_in_pairs(c, scratch);
    if (bad == nullptr) bad = tree_validate({&c.state->tree, c.tree});
    return bad;
}

template const char* find_fault(const ImageView& image, Arena scratch);

}  // namespace islet::detail

namespace islet {

using namespace detail;

const char* World::validate() const {
    const Core& c = core();
    if (!check_open(c)) return "the world is in the middle of a call";
    const char* bad = find_fault(c, c.arena());
    return bad != nullptr ? bad : fault_in_pair_set(c);
}

}  // namespace islet
