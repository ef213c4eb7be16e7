// The graph of joints: each body heads a doubly linked list of its joints, linked by joint keys (joint * 2 + side + 1), like that of its contacts.
#pragma once

#include "memory/core.hpp"

namespace islet::detail {

inline std::uint32_t joint_of_key(std::uint32_t key) { return (key - 1) >> 1; }
inline std::uint32_t joint_side_of_key(std::uint32_t key) { return (key - 1) & 1u; }

/// Calls visit(joint, side) for each joint of a body, newest first; `visit` may destroy that joint.
template <class Visit>
void for_each_joint(const Core& core, std::uint32_t body, Visit&& visit) {
    for (std::uint32_t key = core.bodies[body].joint_head; key != 0;) {
        const std::uint32_t joint = joint_of_key(key);
        const std::uint32_t side = joint_side_of_key(key);
        key = core.joints[joint].next[side];
        visit(joint, side);
    }
}

/// The body at the other end of a joint, or null_index if that is the world.
inline std::uint32_t other_joined(const Core& core, std::uint32_t joint, std::uint32_t side) {
    return side == 0 ? core.joints[joint].body_b : core.joints[joint].body_a;
}

/// True if a joint between the two bodies forbids their shapes to collide.
inline bool joint_forbids(const Core& core, std::uint32_t body_1, std::uint32_t body_2) {
    const bool first = core.bodies[body_1].joint_count < core.bodies[body_2].joint_count;
    const std::uint32_t body = first ? body_1 : body_2;
    const std::uint32_t other = first ? body_2 : body_1;
    for (std::uint32_t key = core.bodies[body].joint_head; key != 0; key = core.joints[joint_of_key(key)].next[joint_side_of_key(key)]) {
        const Joint& j = core.joints[joint_of_key(key)];
        if ((j.flags & joint_collide) == 0 && other_joined(core, joint_of_key(key), joint_side_of_key(key)) == other) return true;
    }
    return false;
}

inline void link_joint(Core& core, std::uint32_t joint, std::uint32_t side, std::uint32_t body) {
    if (body == null_index) return;
    Joint& j = core.joints[joint];
    Body& b = core.bodies[body];
    const std::uint32_t key = joint * 2 + side + 1;
    j.prev[side] = 0;
    j.next[side] = b.joint_head;
    if (b.joint_head != 0) core.joints[joint_of_key(b.joint_head)].prev[joint_side_of_key(b.joint_head)] = key;
    b.joint_head = key;
    ++b.joint_count;
}

inline void unlink_joint(Core& core, std::uint32_t joint, std::uint32_t side, std::uint32_t body) {
    if (body == null_index) return;
    const Joint& j = core.joints[joint];
    Body& b = core.bodies[body];
    const std::uint32_t prev = j.prev[side];
    const std::uint32_t next = j.next[side];
    if (prev != 0) {
        core.joints[joint_of_key(prev)].next[joint_side_of_key(prev)] = next;
    } else {
        b.joint_head = next;
    }
    if (next != 0) core.joints[joint_of_key(next)].prev[joint_side_of_key(next)] = prev;
    --b.joint_count;
}

}  // namespace islet::detail
