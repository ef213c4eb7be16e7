// The public functions on joints, making apart (joint_make.cpp).
#include "../exact.hpp"

#include "../bodies/jam.hpp"
#include "../bodies/joint_changes.hpp"
#include "../bodies/sleep.hpp"
#include "../broadphase/pairs.hpp"
#include "../calls/checks.hpp"
#include "../calls/recorder.hpp"
#include "../collide/manifold.hpp"
#include "../constraint/joint_kinds.hpp"
#include "../graph/joint_graph.hpp"
#include "../math/float_mode.hpp"

namespace islet {

using namespace detail;

namespace {

JointType type_of(const Joint& j) { return j.joint_type(); }

/// Slot of a live joint of one of the types, or null_index with the error recorded.
std::uint32_t find_slot(const Core& core, JointId id, std::uint32_t types) {
    const std::uint32_t i = find_slot(core, id);
    if (i == null_index) return i;
    return check(core, (types & joint_bit(type_of(core.joints[i]))) != 0, Error::wrong_joint_type) ? i : null_index;
}

std::uint32_t find_slot(Core& core, JointId id, std::uint32_t types) {
    return check_open(core) ? find_slot(static_cast<const Core&>(core), id, types) : null_index;
}

/// begin_call for joints of some types.
template <Call call, class... Args>
ISLET_ALWAYS_INLINE inline Found begin_call_on(std::uint32_t types, Core& core, const JointId& id, const Args&... args) {
    note_call<call>(core, id, args...);
    return {core, find_slot(core, id, types)};
}

void wake_bodies(Core& core, const Joint& j) {
    if (j.body_a != null_index) wake_island(core, j.body_a, core.arena());
    wake_island(core, j.body_b, core.arena());
}

// What is enabled on a hinge decides whether its tree is swept.
template <class Set>
void change_parts(Core& core, Joint& j, Set&& set) {
    const std::uint32_t before = j.flags;
    set(j);
    if (j.flags != before) core.state->trees_stale = 1;
    wake_bodies(core, j);
}

Vec2 world_point(const Core& core, std::uint32_t body, Vec2 local) {
    return core.poses[body].center + rotate(core.poses[body].q, local - core.bodies[body].local_center);
}

Vec2 point_velocity(const Core& core, std::uint32_t body, Vec2 arm) { return core.motions[body].v + cross(core.motions[body].w, arm); }

float force_of(const Core& core, float impulse) { return core.state->last_substep > 0 ? impulse / core.state->last_substep : 0; }

}  // namespace

void World::destroy_joint(JointId id) {
    const auto [c, i] = begin_call<Call::destroy_joint>(core(), id);
    if (i == null_index) return;
    forget_jam_of_joint(c, i);
    remove_joint(c, i);
}

bool World::is_valid(JointId id) const { return pool_holds(core().state->joint_pool, core().joints, id); }
std::uint32_t World::joint_count() const { return core().state->joint_pool.count; }

JointId World::joint_at(std::uint32_t slot) const {
    const Core& c = core();
    return pool_live(c.state->joint_pool, c.joints, slot) ? c.joint_id(slot) : JointId{};
}

std::uint32_t World::joints(BodyId id, span<JointId> out) const {
    const Core& c = core();
    const std::uint32_t i = find_slot(c, id);
    if (i == null_index) return 0;
    std::uint32_t n = 0;
    for_each_joint(c, i, [&](std::uint32_t joint, std::uint32_t) {
        if (n < out.size()) out[n] = c.joint_id(joint);
        ++n;
    });
    return n;
}

JointId World::next_joint(BodyId id, JointId joint) const {
    const Core& c = core();
    const std::uint32_t i = find_slot(c, id);
    if (i == null_index || !has_joints) return {};
    std::uint32_t key = c.bodies[i].joint_head;
    if (joint) {
        const std::uint32_t j = find_slot(c, joint);
        if (j == null_index || !check(c, c.joints[j].body_a == i || c.joints[j].body_b == i, Error::out_of_range)) return {};
        key = c.joints[j].next[c.joints[j].body_a == i ? 0 : 1];
    }
    return key != 0 ? c.joint_id(constraint_of_key(key)) : JointId{};
}

// Reading: value if the id is good and the joint of one of the types, else the value's zero.
#define ISLET_READ_JOINT(types, value)               \
    const Core& c = core();                          \
    const std::uint32_t i = find_slot(c, id, types); \
    if (i == null_index) return {};                  \
    const Joint& j = c.joints[i];                    \
    return value

JointType World::joint_type(JointId id) const { ISLET_READ_JOINT(~0u, type_of(j)); }
BodyId World::body_a(JointId id) const { ISLET_READ_JOINT(~0u, j.body_a != null_index ? c.body_id(j.body_a) : BodyId{}); }
BodyId World::body_b(JointId id) const { ISLET_READ_JOINT(~0u, c.body_id(j.body_b)); }
JointFrame World::frame_a(JointId id) const { ISLET_READ_JOINT(~0u, (JointFrame{j.local_a, islet::angle_of(j.frame_a)})); }
JointFrame World::frame_b(JointId id) const { ISLET_READ_JOINT(~0u, (JointFrame{j.local_b, islet::angle_of(j.frame_b)})); }
Vec2 World::anchor_a(JointId id) const { ISLET_READ_JOINT(~0u, j.body_a != null_index ? world_point(c, j.body_a, j.local_a) : j.local_a); }
Vec2 World::anchor_b(JointId id) const { ISLET_READ_JOINT(~0u, world_point(c, j.body_b, j.local_b)); }
bool World::collide_connected(JointId id) const { ISLET_READ_JOINT(~0u, (j.flags & joint_collide) != 0); }
std::uint64_t World::user_data(JointId id) const { ISLET_READ_JOINT(~0u, j.user_data); }
float World::break_force(JointId id) const { ISLET_READ_JOINT(~0u, j.break_force); }
float World::break_torque(JointId id) const { ISLET_READ_JOINT(~0u, j.break_torque); }
JointSpring World::spring(JointId id) const {
    ISLET_READ_JOINT(with_coordinate, (JointSpring{(j.flags & joint_spring) != 0, j.spring_hertz, j.spring_damping_ratio, j.target}));
}
JointLimit World::limit(JointId id) const { ISLET_READ_JOINT(with_coordinate, (JointLimit{(j.flags & joint_limit) != 0, j.lower, j.upper})); }
JointMotor World::motor(JointId id) const { ISLET_READ_JOINT(with_coordinate, (JointMotor{(j.flags & joint_motor) != 0, j.motor_speed, j.motor_max})); }
float World::joint_friction(JointId id) const { ISLET_READ_JOINT(with_friction, j.friction); }
float World::motor_force(JointId id) const { ISLET_READ_JOINT(with_coordinate, force_of(c, j.motor_impulse)); }
float World::joint_length(JointId id) const { ISLET_READ_JOINT(joint_bit(JointType::distance), j.length); }
JointRatchet World::ratchet(JointId id) const { ISLET_READ_JOINT(joint_bit(JointType::angle), (JointRatchet{j.length, j.velocity.x})); }
JointSoftness World::softness(JointId id) const {
    ISLET_READ_JOINT(with_softness, (JointSoftness{j.linear_hertz, j.linear_damping_ratio, j.angular_hertz, j.angular_damping_ratio}));
}
Vec2 World::joint_linear_velocity(JointId id) const { ISLET_READ_JOINT(joint_bit(JointType::motor), j.velocity); }
float World::joint_angular_velocity(JointId id) const { ISLET_READ_JOINT(joint_bit(JointType::motor), j.motor_speed); }
float World::joint_max_force(JointId id) const { ISLET_READ_JOINT(with_strength, j.motor_max); }
float World::joint_max_torque(JointId id) const { ISLET_READ_JOINT(with_strength, j.max_torque); }
Vec2 World::target(JointId id) const { ISLET_READ_JOINT(joint_bit(JointType::mouse), j.local_a); }
Vec2 World::ground_a(JointId id) const { ISLET_READ_JOINT(joint_bit(JointType::pulley), j.ground_a); }
Vec2 World::ground_b(JointId id) const { ISLET_READ_JOINT(joint_bit(JointType::pulley), j.ground_b); }
float World::joint_ratio(JointId id) const { ISLET_READ_JOINT(with_ratio, j.ratio); }
JointId World::joint1(JointId id) const { ISLET_READ_JOINT(joint_bit(JointType::gear), c.joint_id(j.joint1)); }
JointId World::joint2(JointId id) const { ISLET_READ_JOINT(joint_bit(JointType::gear), c.joint_id(j.joint2)); }
float World::joint_position(JointId id) const { ISLET_READ_JOINT(with_coordinate, joint_coordinate(c, j)); }
Vec2 World::joint_force(JointId id) const { ISLET_READ_JOINT(~0u, (Vec2{force_of(c, j.force_impulse.x), force_of(c, j.force_impulse.y)})); }
float World::joint_torque(JointId id) const { ISLET_READ_JOINT(~0u, force_of(c, j.torque_impulse)); }

#undef ISLET_READ_JOINT

float World::joint_speed(JointId id) const {
    const Core& c = core();
    const std::uint32_t i = find_slot(c, id, with_coordinate);
    if (i == null_index) return 0;
    const Joint& j = c.joints[i];
    const JointPose p = pose_of(j, c.poses, c.bodies);
    const JointMotion m = {point_velocity(c, j.body_b, p.rb) - point_velocity(c, j.body_a, p.ra), c.motions[j.body_a].w, c.motions[j.body_b].w};
    return with_kind(type_of(j), [&](auto kind) {
        if constexpr (kind.has_coordinate) return kind.speed(p, m);
        return 0.0f;
    });
}

JointError World::joint_error(JointId id) const {
    const Core& c = core();
    const std::uint32_t i = find_slot(c, id);
    if (i == null_index) return {};
    const Joint& j = c.joints[i];
    const JointPose p = pose_of(j, c.poses, c.bodies);
    return with_kind(type_of(j), [&](auto kind) { return kind.error(c, j, p); });
}

void World::set_frames(JointId id, const JointFrame& frame_a, const JointFrame& frame_b) {
    const DefaultFloatMode mode;
    const auto [c, i] = begin_call_on<Call::set_frames>(with_frames, core(), id, frame_a, frame_b);
    if (i == null_index || !check_frame(c, frame_a) || !check_frame(c, frame_b)) return;
    Joint& j = c.joints[i];
    j.local_a = frame_a.position;
    j.local_b = frame_b.position;
    j.frame_a = make_rot(frame_a.angle);
    j.frame_b = make_rot(frame_b.angle);
    wake_bodies(c, j);
}

void World::set_collide_connected(JointId id, bool collide) {
    const auto [c, i] = begin_call_on<Call::set_collide_connected>(with_base, core(), id, collide);
    if (i == null_index) return;
    Joint& j = c.joints[i];
    if (((j.flags & joint_collide) != 0) == collide) return;
    j.flags = collide ? j.flags | joint_collide : j.flags & ~static_cast<std::uint32_t>(joint_collide);
    wake_bodies(c, j);
    if (!collide) return end_forbidden_contacts(c, j);
    for (std::uint32_t s = c.bodies[j.body_b].shape_head; s != null_index; s = c.shapes[s].next) mark_moved(c, s);
}

void World::set_break(JointId id, float force, float torque) {
    const auto [c, i] = begin_call<Call::set_break>(core(), id, force, torque);
    if (i == null_index || !check_not_negative(c, force) || !check_not_negative(c, torque)) return;
    c.joints[i].break_force = force;
    c.joints[i].break_torque = torque;
    if (c.joints[i].can_break()) c.state->asked |= asked_breaks;
    c.state->trees_stale = 1;  // what can break decides how a bridge is solved
    wake_bodies(c, c.joints[i]);
}

void World::set_user_data(JointId id, std::uint64_t data) {
    const auto [c, i] = begin_call<Call::set_joint_user_data>(core(), id, data);
    if (i != null_index) c.joints[i].user_data = data;
}

void World::set_spring(JointId id, const JointSpring& spring) {
    const auto [c, i] = begin_call_on<Call::set_spring>(with_coordinate, core(), id, spring);
    if (i == null_index || !check_spring(c, spring)) return;
    change_parts(c, c.joints[i], [&](Joint& j) { set_spring_of(j, spring); });
}

void World::set_limit(JointId id, const JointLimit& limit) {
    const auto [c, i] = begin_call_on<Call::set_limit>(with_coordinate, core(), id, limit);
    if (i == null_index || !check_limit(c, limit)) return;
    if (!check(c, (with_length & joint_bit(type_of(c.joints[i]))) == 0 || !limit.enable || limit.lower >= 0, Error::out_of_range)) return;
    change_parts(c, c.joints[i], [&](Joint& j) { set_limit_of(j, limit); });
}

void World::set_motor(JointId id, const JointMotor& motor) {
    const auto [c, i] = begin_call_on<Call::set_motor>(with_coordinate, core(), id, motor);
    if (i == null_index || !check_motor(c, motor)) return;
    change_parts(c, c.joints[i], [&](Joint& j) { set_motor_of(j, motor); });
}

void World::set_joint_friction(JointId id, float friction) {
    const auto [c, i] = begin_call_on<Call::set_joint_friction>(with_friction, core(), id, friction);
    if (i == null_index || !check_not_negative(c, friction)) return;
    c.state->trees_stale = 1;  // friction too has a hinge swept
    c.joints[i].friction = friction;
    if (friction == 0) c.joints[i].friction_impulse = 0;
    wake_bodies(c, c.joints[i]);
}

void World::set_joint_length(JointId id, float length) {
    const auto [c, i] = begin_call_on<Call::set_joint_length>(joint_bit(JointType::distance), core(), id, length);
    if (i == null_index || !check_range(c, length, linear_slop, max_position)) return;
    c.joints[i].length = length;
    wake_bodies(c, c.joints[i]);
}

void World::set_ratchet(JointId id, const JointRatchet& ratchet) {
    const auto [c, i] = begin_call_on<Call::set_ratchet>(joint_bit(JointType::angle), core(), id, ratchet);
    if (i == null_index || !check_ratchet(c, ratchet)) return;
    set_ratchet_of(c.joints[i], ratchet);
    wake_bodies(c, c.joints[i]);
}

void World::set_joint_velocity(JointId id, Vec2 linear, float angular) {
    const auto [c, i] = begin_call_on<Call::set_joint_velocity>(joint_bit(JointType::motor), core(), id, linear, angular);
    if (i == null_index || !check_finite(c, linear) || !check_finite(c, angular)) return;
    c.joints[i].velocity = linear;
    c.joints[i].motor_speed = angular;
    wake_bodies(c, c.joints[i]);
}

void World::set_joint_strength(JointId id, float max_force, float max_torque) {
    const auto [c, i] = begin_call_on<Call::set_joint_strength>(with_strength, core(), id, max_force, max_torque);
    if (i == null_index || !check_not_negative(c, max_force) || !check_not_negative(c, max_torque)) return;
    c.joints[i].motor_max = max_force;
    if (type_of(c.joints[i]) == JointType::motor) c.joints[i].max_torque = max_torque;
    wake_bodies(c, c.joints[i]);
}

void World::set_softness(JointId id, const JointSoftness& softness) {
    const auto [c, i] = begin_call_on<Call::set_softness>(with_softness, core(), id, softness);
    if (i == null_index) return;
    for (const float a : {softness.linear_hertz, softness.linear_damping_ratio, softness.angular_hertz, softness.angular_damping_ratio})
        if (!check_not_negative(c, a)) return;
    Joint& j = c.joints[i];
    const bool mouse = type_of(j) == JointType::mouse;
    if (!check(c, !mouse || (softness.linear_hertz > 0 && softness.angular_hertz == 0), Error::out_of_range)) return;
    fill_softness(j, softness);
    if (mouse) j.angular_damping_ratio = 0;
    wake_bodies(c, j);
}

void World::set_grounds(JointId id, Vec2 ground_a, Vec2 ground_b) {
    const DefaultFloatMode mode;
    const auto [c, i] = begin_call_on<Call::set_grounds>(joint_bit(JointType::pulley), core(), id, ground_a, ground_b);
    if (i == null_index || !check_position(c, ground_a) || !check_position(c, ground_b)) return;
    Joint changed = c.joints[i];
    changed.ground_a = ground_a;
    changed.ground_b = ground_b;
    if (!measure_rope(c, changed)) return;
    c.joints[i] = changed;
    wake_bodies(c, changed);
}

void World::set_joint_ratio(JointId id, float ratio) {
    const DefaultFloatMode mode;
    const auto [c, i] = begin_call_on<Call::set_joint_ratio>(with_ratio, core(), id, ratio);
    if (i == null_index || !check_range(c, ratio, -max_ratio, max_ratio)) return;
    Joint changed = c.joints[i];
    const bool gear = type_of(changed) == JointType::gear;
    if (!check(c, gear ? ratio != 0 : ratio > 0, Error::out_of_range)) return;
    changed.ratio = ratio;
    if (gear) {
        changed.length = joint_coordinate(c, c.joints[changed.joint1]) + ratio * joint_coordinate(c, c.joints[changed.joint2]);
    } else if (!measure_rope(c, changed)) {
        return;
    }
    c.joints[i] = changed;
    wake_bodies(c, changed);
}

void World::set_target(JointId id, Vec2 target) {
    const auto [c, i] = begin_call_on<Call::set_joint_target>(joint_bit(JointType::mouse), core(), id, target);
    if (i == null_index || !check_position(c, target)) return;
    c.joints[i].local_a = target;
    wake_bodies(c, c.joints[i]);
}

}  // namespace islet
