// Making joints: what each definition must keep, and how it fills the record.
#include "../exact.hpp"

#include "../bodies/joint_changes.hpp"
#include "../bodies/sleep.hpp"
#include "../broadphase/pairs.hpp"
#include "../calls/checks.hpp"
#include "../calls/recorder.hpp"
#include "../collide/manifold.hpp"
#include "../constraint/joint_kinds.hpp"
#include "../graph/colors.hpp"
#include "../graph/contacts.hpp"
#include "../graph/joint_graph.hpp"
#include "../math/float_mode.hpp"
#include "../math/inlining.hpp"
#include "../solver/joint_solve.hpp"

namespace islet {

using namespace detail;

namespace {

/// A joint on which nothing acts, filled by the definition's parts below; its bodies and its place come last.
ISLET_SHARED Joint new_joint(JointType type, std::uint64_t user_data) {
    Joint j;
    j.type = static_cast<std::uint32_t>(type);
    j.user_data = user_data;
    j.set_color(no_color);
    return j;
}

[[maybe_unused]] Joint new_joint(JointType type, const JointBase& base) {
    Joint j = new_joint(type, base.user_data);
    j.local_a = base.frame_a.position;
    j.local_b = base.frame_b.position;
    j.break_force = base.break_force;
    j.break_torque = base.break_torque;
    if (base.collide_connected) j.flags |= joint_collide;
    return j;
}

/// What every joint's numbers must keep; those that its type does not have are 0 and keep it.
bool check_numbers(const Core& core, const Joint& j) {
    for (const float a : {j.break_force, j.break_torque, j.spring_hertz, j.spring_damping_ratio, j.motor_max, j.friction, j.linear_hertz,
                          j.linear_damping_ratio, j.angular_hertz, j.angular_damping_ratio, j.max_torque})
        if (!check_not_negative(core, a)) return false;
    for (const float a : {j.target, j.lower, j.upper, j.motor_speed, j.velocity.x, j.velocity.y})
        if (!check_finite(core, a)) return false;
    const bool too_short = (with_length & joint_bit(j.joint_type())) != 0 && (j.flags & joint_limit) != 0 && j.lower < 0;
    return check(core, j.lower <= j.upper && !too_short, Error::out_of_range);
}

/// Puts the joint into a slot, ties it to its bodies, wakes them, and ends what it forbids. Call when all else is checked; null if there is no room.
/// Every joint is made through here, so here is where the program links what joints need.
JointId tie(Core& core, const Joint& made) {
    link_joint_solve();
    link_joint_changes();
    const std::uint32_t i = pool_take(core.state->joint_pool, core.joints, core.capacity.joints);
    if (i == null_index) {
        core.fail(Error::joints_full);
        return {};
    }
    Joint& j = core.joints[i];
    const std::uint32_t generation = j.generation;
    j = made;
    j.generation = generation;
    if (j.joint_type() != JointType::gear) j.set_color(take_color(core, j.body_a, j.body_b));
    if (j.can_break()) core.state->asked |= asked_breaks;
    if (j.joint_type() == JointType::revolute && length(gap_of(pose_of(j, core.poses, core.bodies))) > wide_gap) j.flags |= joint_moved;
    attach_joint(core, i, 0, j.body_a);
    attach_joint(core, i, 1, j.body_b);
    if (j.body_a != null_index) wake_island(core, j.body_a, core.arena());
    wake_island(core, j.body_b, core.arena());
    core.awake_joints.assign(i, is_joint_awake(core, j));
    end_forbidden_contacts(core, j);
    return core.joint_id(i);
}

/// A joint between two bodies, checked as far as all types have it in common.
[[maybe_unused]] JointId make(Core& core, Joint& j, const JointBase& base) {
    const DefaultFloatMode mode;
    j.body_a = find_slot(core, base.body_a);
    if (j.body_a == null_index) return {};
    j.body_b = find_slot(core, base.body_b);
    if (j.body_b == null_index) return {};
    if (!check(core, j.body_a != j.body_b, Error::same_body) || !check(core, core.is_dynamic(j.body_a) || core.is_dynamic(j.body_b), Error::no_dynamic_body) ||
        !check_frame(core, base.frame_a) || !check_frame(core, base.frame_b) || !check_numbers(core, j))
        return {};
    j.frame_a = make_rot(base.frame_a.angle);
    j.frame_b = make_rot(base.frame_b.angle);
    if ((with_turns & joint_bit(j.joint_type())) != 0) j.coordinate = angle_of(pose_of(j, core.poses, core.bodies));
    if (j.joint_type() == JointType::pulley && !measure_rope(core, j)) return {};
    return tie(core, j);
}

/// A body's point and the world.
[[maybe_unused]] JointId make(Core& c, const MouseJointDef& def) {
    const DefaultFloatMode mode;
    const std::uint32_t body = find_slot(c, def.body);
    if (body == null_index || !check(c, c.is_dynamic(body), Error::no_dynamic_body) || !check_position(c, def.target)) return {};
    Joint j = new_joint(JointType::mouse, def.user_data);
    j.body_b = body;
    set_mouse(j, c.poses[body], c.bodies[body].local_center, def.target, def.hertz, def.damping_ratio, def.max_force);
    if (!check_numbers(c, j) || !check(c, def.hertz > 0, Error::out_of_range)) return {};
    return tie(c, j);
}

/// Two joints.
[[maybe_unused]] JointId make(Core& c, const GearJointDef& def) {
    const DefaultFloatMode mode;
    const std::uint32_t joint1 = find_slot(c, def.joint1);
    if (joint1 == null_index) return {};
    const std::uint32_t joint2 = find_slot(c, def.joint2);
    if (joint2 == null_index) return {};
    const auto may_gear = [&](std::uint32_t joint) {
        const auto type = c.joints[joint].joint_type();
        return type == JointType::revolute || type == JointType::prismatic;
    };
    if (!check(c, may_gear(joint1) && may_gear(joint2), Error::wrong_joint_type)) return {};
    const std::uint32_t a = moving_body(c, c.joints[joint1]), b = moving_body(c, c.joints[joint2]);
    if (!check(c, a != b, Error::same_body) || !check(c, c.is_dynamic(a) && c.is_dynamic(b), Error::no_dynamic_body)) return {};
    if (!check_range(c, def.ratio, -max_ratio, max_ratio) || !check(c, def.ratio != 0, Error::out_of_range)) return {};
    Joint j = new_joint(JointType::gear, def.user_data);
    j.body_a = a;
    j.body_b = b;
    j.joint1 = joint1;
    j.joint2 = joint2;
    j.ratio = def.ratio;
    j.break_torque = def.break_torque;
    j.flags |= joint_collide;
    j.length = joint_coordinate(c, c.joints[joint1]) + def.ratio * joint_coordinate(c, c.joints[joint2]);
    if (!check_numbers(c, j)) return {};
    const JointId gear = tie(c, j);
    if (!gear) return {};
    ++c.joints[joint1].gear_count;
    ++c.joints[joint2].gear_count;
    return gear;
}

template <JointType type, Call call, class Def>
JointId create_of_type(Core& core, const Def& def) {
    note_call<call>(core, def);
    if (!check_there(core, has_joint(type))) return {};
    if constexpr (!has_joint(type)) {
        return {};
    } else if constexpr (JointKind<type>::has_base) {
        Joint j = new_joint(type, def.base);
        return JointKind<type>::take(core, j, def) ? make(core, j, def.base) : JointId{};
    } else {
        return make(core, def);
    }
}

}  // namespace

#define ISLET_CREATE(type, definition) \
    JointId World::create_joint(const definition##JointDef& def) { return create_of_type<JointType::type, Call::create_##type##_joint>(core(), def); }
ISLET_JOINT_TYPES(ISLET_CREATE)
#undef ISLET_CREATE

}  // namespace islet
