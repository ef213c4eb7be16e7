// The graph of joints: each body is a node, and each joint ties two of them.
#pragma once

#include "../data/core.hpp"
#include "../graph/constraint_list.hpp"

namespace islet::detail {

/// Calls visit(joint, side) for each joint of a body, newest first; `visit` may destroy that joint.
template <class Visit>
void for_each_joint(const Core& core, std::uint32_t body, Visit&& visit) {
    if constexpr (has_joints) for_each_constraint(core.joints, core.bodies[body].joint_head, visit);
}

/// The body at the other end of a joint, or null_index if that is the world.
inline std::uint32_t other_joined(const Core& core, std::uint32_t joint, std::uint32_t side) {
    return side == 0 ? core.joints[joint].body_b : core.joints[joint].body_a;
}

/// The bodies whose velocities a joint's rows read: two, or of a gear the four of its two joints. null_index: the world, or none.
struct BodiesOfJoint {
    std::uint32_t body[4];
};
inline BodiesOfJoint bodies_of(const Core& core, const Joint& j) {
    if (j.joint_type() != JointType::gear) return {{j.body_a, j.body_b, null_index, null_index}};
    const Joint &j1 = core.joints[j.joint1], &j2 = core.joints[j.joint2];
    return {{j1.body_a, j1.body_b, j2.body_a, j2.body_b}};
}

/// True if a joint between the two bodies forbids their shapes to collide.
inline bool joint_forbids(const Core& core, std::uint32_t body_1, std::uint32_t body_2) {
    if (!has_joints) return false;
    const bool first = core.bodies[body_1].joint_count < core.bodies[body_2].joint_count;
    const std::uint32_t body = first ? body_1 : body_2;
    const std::uint32_t other = first ? body_2 : body_1;
    for (std::uint32_t key = core.bodies[body].joint_head; key != 0; key = core.joints[constraint_of_key(key)].next[side_of_key(key)]) {
        const Joint& j = core.joints[constraint_of_key(key)];
        if ((j.flags & joint_collide) == 0 && other_joined(core, constraint_of_key(key), side_of_key(key)) == other) return true;
    }
    return false;
}

/// True if a body that the joint acts on is disabled; the joint then acts on no body.
bool has_disabled_body(const Core& core, const Joint& j);
inline bool is_joint_idle(const Core& core, const Joint& j) { return has_disabling && has_disabled_body(core, j); }

/// Whether the joint belongs to the awake ones.
inline bool is_joint_awake(const Core& core, const Joint& j) {
    return ((j.body_a != null_index && core.is_awake(j.body_a)) || core.is_awake(j.body_b)) && !is_joint_idle(core, j);
}

/// Decides for each joint whether it is awake, after a body was enabled or disabled. (All joints are checked, because a gear may use joints of bodies on which
/// it does not hang.) Links has_disabled_body.
void refresh_awake_joints(Core& core);

/// A mouse joint's side A is in no list.
inline void attach_joint(Core& core, std::uint32_t joint, std::uint32_t side, std::uint32_t body) {
    core.state->trees_stale = 1;
    if (body != null_index) add_to_list(core.joints, joint, side, core.bodies[body].joint_head, core.bodies[body].joint_count);
}

inline void detach_joint(Core& core, std::uint32_t joint, std::uint32_t side, std::uint32_t body) {
    core.state->trees_stale = 1;
    if (body != null_index) remove_from_list(core.joints, joint, side, core.bodies[body].joint_head, core.bodies[body].joint_count);
}

}  // namespace islet::detail
