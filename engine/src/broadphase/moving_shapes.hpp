// The shapes in motion, as columns that are sorted and scanned for pairs (pairs.cpp), and how far bodies may go within a step.
#pragma once

#include "../broadphase/columns.hpp"
#include "../broadphase/pairs.hpp"
#include "../math/boxes.hpp"
#include "../math/key_sort.hpp"
#include "../math/lanes.hpp"
#include "../memory/arena.hpp"

namespace islet::detail {

/// How far a body goes within dt if nothing touches it.
ISLET_SHARED Way way_of(const Core& core, std::uint32_t body, float dt) {
    const Motion& motion = core.motions[body];
    return {dt * motion.v + pull_share * dt * dt * pull_on(core, body), min(dt * abs(motion.w), 2.0f) * core.poses[body].max_extent};
}

/// m: at least the way of any point of a body within dt.
inline float way_length(const Core& core, std::uint32_t body, float dt) {
    const Motion& motion = core.motions[body];
    const Vec2 pull = pull_on(core, body);
    return dt * (length_inline(motion.v) + abs(motion.w) * core.poses[body].max_extent + pull_share * dt * (abs(pull.x) + abs(pull.y)));
}

/// A box grown by a way, of which at most `most` m count along each axis.
ISLET_LANE_SHARED Aabb grow(const Aabb& box, const Way& way, float most) {
    const Vec2 bound = {most, most};
    return swept(box, max(min(way.move, bound), -bound), way.turn);
}

/// A shape in motion.
struct MovingShape {
    Aabb box;  // its fat box
    Way way;   // its body's, if that leaves the box
    std::uint32_t body;
    std::uint32_t shape;
    bool leaves;        // the way may lead out of the box
    std::uint16_t kin;  // of its filter's group if that is negative, else 0
};

/// The low bits of a negative group: shapes with the same group have the same. (One lane has no use for it.)
inline std::uint16_t kin_of([[maybe_unused]] const Filter& filter) {
    if constexpr (max_lanes > 1)
        if (filter.group < 0) return static_cast<std::uint16_t>(filter.group);
    return 0;
}

/// The box of a shape's way, but no farther than its surroundings: a body that is faster for its size must be a bullet to stop at moving bodies.
ISLET_SHARED Aabb box_along_way(const Core& core, const MovingShape& m) {
    return has_continuous && m.leaves ? grow(m.box, m.way, surroundings(core.poses[m.body])) : m.box;
}

/// Whether two shapes with the boxes `a` and `b` may come together; `fall` (m) is the way that gravity adds to one while the other is held.
ISLET_SHARED bool may_meet_on(const Aabb& a, const Way& way_a, const Aabb& b, const Way& way_b, float fall) {
    return meet_at_once(a, swept(b, way_b.move - way_a.move, way_a.turn + way_b.turn + fall));
}

/// The shapes in motion, and those among them whose boxes changed.
struct Moving {
    const Core& core;
    Columns all;
    Columns moved;
    const MovingShape* shapes;  // where processors have caches, in the order of places; otherwise `order` tells which one is at a place
    const KeyedItem* order;
    bool along_x;
    float dt, fall;

    const MovingShape& in_place(std::uint32_t place) const { return shapes[max_lanes > 1 ? place : number_of(order[place])]; }

    // For bodies that move together, an overlap of the boxes of their ways means little.
    bool may_meet(std::uint32_t place_1, std::uint32_t place_2) const {
        const MovingShape& a = in_place(place_1);
        const MovingShape& b = in_place(place_2);
        if (a.body == b.body) return false;
        // Limbs overlap in every step, so it pays to know early that they do not collide.
        if (max_lanes > 1 && a.kin != 0 && a.kin == b.kin && core.shapes[a.shape].filter.group == core.shapes[b.shape].filter.group) return false;
        if (!has_continuous || (!a.leaves && !b.leaves) || meet_at_once(a.box, b.box)) return true;
        const Way way_a = way(a), way_b = way(b);
        if (!may_meet_on(a.box, way_a, b.box, way_b, fall)) return false;
        return way_a.turn + way_b.turn < fast_way || detail::may_meet(core, a.body, a.box, b.body, b.box, dt);
    }
    Way way(const MovingShape& m) const { return m.leaves ? m.way : way_of(core, m.body, dt); }
};

inline Aabb surroundings_of(const Pose& pose) {
    const float reach = pose.max_extent + surroundings(pose);
    return expand({pose.center, pose.center}, reach);
}

/// True if it is known that nothing at rest overlaps a box near the body.
inline bool is_clear(const Pose& pose, const Aabb& box) { return has_shortcuts && (pose.flags & pose_alone) != 0 && contains(surroundings_of(pose), box); }

/// The shapes in motion that may be part of a new pair, sorted, in memory from `arena`.
Moving sorted_columns(Core& core, Arena& arena, float dt);

}  // namespace islet::detail
