// Making joints: what each definition must keep, and how it fills the record.
#include "broadphase/contacts.hpp"
#include "broadphase/pairs.hpp"
#include "constraint/gear.hpp"
#include "constraint/mouse.hpp"
#include "math/float_mode.hpp"
#include "memory/colors.hpp"
#include "memory/joint_graph.hpp"
#include "collide/manifold.hpp"
#include "world/checks.hpp"
#include "world/joints.hpp"
#include "world/sleep.hpp"
#include "solver/joint_solve.hpp"

namespace islet {

using namespace detail;

namespace detail {

bool check_not_negative(const Core& core, float a) { return check_range(core, a, 0, no_limit); }

bool check_spring(const Core& core, const JointSpring& s) {
    return check_not_negative(core, s.hertz) && check_not_negative(core, s.damping_ratio) && check_finite(core, s.target);
}

bool check_limit(const Core& core, const JointLimit& l) {
    return check_finite(core, l.lower) && check_finite(core, l.upper) && check(core, l.lower <= l.upper, Error::out_of_range);
}

bool check_motor(const Core& core, const JointMotor& m) { return check_finite(core, m.speed) && check_not_negative(core, m.max_force); }

bool check_frame(const Core& core, const JointFrame& f) { return check_position(core, f.position) && check_finite(core, f.angle); }

void set_spring_of(Joint& j, const JointSpring& s) {
    j.flags = s.enable ? j.flags | joint_spring : j.flags & ~static_cast<std::uint32_t>(joint_spring);
    j.spring_hertz = s.hertz;
    j.spring_damping_ratio = s.damping_ratio;
    j.target = s.target;
    if (!s.enable) j.spring_impulse = 0;
}

void set_limit_of(Joint& j, const JointLimit& l) {
    j.flags = l.enable ? j.flags | joint_limit : j.flags & ~static_cast<std::uint32_t>(joint_limit);
    j.lower = l.lower;
    j.upper = l.upper;
    if (!l.enable) j.lower_impulse = j.upper_impulse = 0;
}

void set_motor_of(Joint& j, const JointMotor& m) {
    j.flags = m.enable ? j.flags | joint_motor : j.flags & ~static_cast<std::uint32_t>(joint_motor);
    j.motor_speed = m.speed;
    j.motor_max = m.max_force;
    if (!m.enable) j.motor_impulse = 0;
}

void end_forbidden_contacts(Core& core, const Joint& j) {
    if (j.body_a == null_index) return;
    for_each_contact(core, j.body_b, [&](std::uint32_t contact, std::uint32_t side) {
        const Contact& c = core.contacts[contact];
        if (other_body(core, contact, side) == j.body_a && !may_collide(core, c.shape_a, c.shape_b)) destroy_contact(core, contact);
    });
}

}  // namespace detail

namespace {

/// The bodies of a joint to be made, as slots, if they will do.
struct Bodies {
    std::uint32_t a = null_index, b = null_index;
    bool good = false;
};

Bodies check_base(const Core& core, const JointBase& base) {
    Bodies bodies;
    bodies.a = find_body(core, base.body_a);
    if (bodies.a == null_index) return bodies;
    bodies.b = find_body(core, base.body_b);
    if (bodies.b == null_index) return bodies;
    bodies.good = check(core, bodies.a != bodies.b, Error::same_body) &&
                  check(core, core.is_dynamic(bodies.a) || core.is_dynamic(bodies.b), Error::no_dynamic_body) && check_frame(core, base.frame_a) &&
                  check_frame(core, base.frame_b) && check_not_negative(core, base.break_force) && check_not_negative(core, base.break_torque);
    return bodies;
}

/// Takes a slot for a joint. Call when all else is checked. Every joint is made through here, so here is where the program links what joints need.
std::uint32_t take_joint(Core& core, JointType type) {
    link_joint_solve();
    link_joint_changes();
    const std::uint32_t i = pool_take(core.state->joint_pool, core.joints, core.capacity.joints);
    if (i == null_index) {
        core.fail(Error::joints_full);
        return i;
    }
    const std::uint32_t generation = core.joints[i].generation;
    core.joints[i] = Joint{};
    core.joints[i].generation = generation;
    core.joints[i].type = static_cast<std::uint32_t>(type);
    core.joints[i].set_color(no_color);
    return i;
}

/// Ties the finished joint to its bodies, wakes them, and ends what it forbids.
JointId tie(Core& core, std::uint32_t i) {
    Joint& j = core.joints[i];
    if (j.joint_type() != JointType::gear) j.set_color(take_color(core, j.body_a, j.body_b));
    link_joint(core, i, 0, j.body_a);
    link_joint(core, i, 1, j.body_b);
    if (j.body_a != null_index) wake_island(core, j.body_a, core.arena());
    wake_island(core, j.body_b, core.arena());
    core.awake_joints.assign(i, (j.body_a != null_index && core.is_awake(j.body_a)) || core.is_awake(j.body_b));
    end_forbidden_contacts(core, j);
    return core.joint_id(i);
}

void fill_base(Joint& j, const Bodies& bodies, const JointBase& base) {
    j.body_a = bodies.a;
    j.body_b = bodies.b;
    j.local_a = base.frame_a.position;
    j.local_b = base.frame_b.position;
    j.frame_a = make_rot(base.frame_a.angle);
    j.frame_b = make_rot(base.frame_b.angle);
    j.break_force = base.break_force;
    j.break_torque = base.break_torque;
    j.user_data = base.user_data;
    if (base.collide_connected) j.flags |= joint_collide;
}

/// A joint between two bodies: checked, filled by `fill(joint)`, tied. `good` says whether the rest of the definition will do.
template <class Good, class Fill>
JointId make(Core& core, JointType type, const JointBase& base, Good&& good, Fill&& fill) {
    const DefaultFloatMode mode;
    const Bodies bodies = check_base(core, base);
    if (!bodies.good || !good()) return {};
    const std::uint32_t i = take_joint(core, type);
    if (i == null_index) return {};
    fill_base(core.joints[i], bodies, base);
    fill(core.joints[i]);
    return tie(core, i);
}

template <class Def>
void fill_coordinate(Joint& j, const Def& def) {
    set_spring_of(j, def.spring);
    set_limit_of(j, def.limit);
    set_motor_of(j, def.motor);
}

template <class Def>
bool check_coordinate(const Core& core, const Def& def) {
    return check_spring(core, def.spring) && check_limit(core, def.limit) && check_motor(core, def.motor);
}

template <class Def>
void fill_softness(Joint& j, const Def& def) {
    j.linear_hertz = def.linear_hertz;
    j.linear_damping_ratio = def.linear_damping_ratio;
    j.angular_hertz = def.angular_hertz;
    j.angular_damping_ratio = def.angular_damping_ratio;
}

template <class Def>
bool check_softness(const Core& core, const Def& def) {
    return check_not_negative(core, def.linear_hertz) && check_not_negative(core, def.linear_damping_ratio) &&
           check_not_negative(core, def.angular_hertz) && check_not_negative(core, def.angular_damping_ratio);
}

}  // namespace

JointId World::create_joint(const RevoluteJointDef& def) {
    Core& c = core();
    if (!check(c, has_joint(JointType::revolute), Error::feature_cut)) return {};
    return make(
        c, JointType::revolute, def.base, [&] { return check_coordinate(c, def) && check_not_negative(c, def.friction); },
        [&](Joint& j) {
            fill_coordinate(j, def);
            j.friction = def.friction;
            j.coordinate = angle_of(pose_of(j, c.poses, c.bodies));
        });
}

JointId World::create_joint(const PrismaticJointDef& def) {
    Core& c = core();
    if (!check(c, has_joint(JointType::prismatic), Error::feature_cut)) return {};
    return make(
        c, JointType::prismatic, def.base, [&] { return check_coordinate(c, def) && check_not_negative(c, def.friction); },
        [&](Joint& j) {
            fill_coordinate(j, def);
            j.friction = def.friction;
        });
}

JointId World::create_joint(const DistanceJointDef& def) {
    Core& c = core();
    if (!check(c, has_joint(JointType::distance), Error::feature_cut)) return {};
    return make(
        c, JointType::distance, def.base,
        [&] {
            return check_range(c, def.length, linear_slop, max_position) && check_coordinate(c, def) &&
                   check(c, !def.limit.enable || def.limit.lower >= 0, Error::out_of_range);
        },
        [&](Joint& j) {
            fill_coordinate(j, def);
            j.length = def.length;
        });
}

JointId World::create_joint(const WeldJointDef& def) {
    Core& c = core();
    if (!check(c, has_joint(JointType::weld), Error::feature_cut)) return {};
    return make(
        c, JointType::weld, def.base, [&] { return check_softness(c, def); }, [&](Joint& j) { fill_softness(j, def); });
}

JointId World::create_joint(const WheelJointDef& def) {
    Core& c = core();
    if (!check(c, has_joint(JointType::wheel), Error::feature_cut)) return {};
    return make(
        c, JointType::wheel, def.base, [&] { return check_coordinate(c, def) && check_not_negative(c, def.friction); },
        [&](Joint& j) {
            fill_coordinate(j, def);
            j.friction = def.friction;
        });
}

JointId World::create_joint(const MotorJointDef& def) {
    Core& c = core();
    if (!check(c, has_joint(JointType::motor), Error::feature_cut)) return {};
    return make(
        c, JointType::motor, def.base,
        [&] {
            return check_softness(c, def) && check_finite(c, def.linear_velocity) && check_finite(c, def.angular_velocity) &&
                   check_not_negative(c, def.max_force) && check_not_negative(c, def.max_torque);
        },
        [&](Joint& j) {
            fill_softness(j, def);
            j.velocity = def.linear_velocity;
            j.motor_speed = def.angular_velocity;
            j.motor_max = def.max_force;
            j.max_torque = def.max_torque;
        });
}

JointId World::create_joint(const MouseJointDef& def) {
    Core& c = core();
    if (!check(c, has_joint(JointType::mouse), Error::feature_cut)) return {};
    const DefaultFloatMode mode;
    const std::uint32_t body = find_body(c, def.body);
    if (body == null_index || !check(c, c.is_dynamic(body), Error::no_dynamic_body) || !check_position(c, def.target)) return {};
    if (!check_not_negative(c, def.hertz) || !check(c, def.hertz > 0, Error::out_of_range)) return {};
    if (!check_not_negative(c, def.damping_ratio) || !check_not_negative(c, def.max_force)) return {};
    const std::uint32_t i = take_joint(c, JointType::mouse);
    if (i == null_index) return {};
    Joint& j = c.joints[i];
    j.body_b = body;
    set_mouse(j, c.poses[body], c.bodies[body].local_center, def.target, def.hertz, def.damping_ratio, def.max_force);
    j.user_data = def.user_data;
    return tie(c, i);
}

JointId World::create_joint(const PulleyJointDef& def) {
    Core& c = core();
    if (!check(c, has_joint(JointType::pulley), Error::feature_cut)) return {};
    const auto rope = [&](BodyId body, const JointFrame& frame, Vec2 ground) {
        return distance(transform_point(transform(body), frame.position), ground);
    };
    return make(
        c, JointType::pulley, def.base,
        [&] {
            return check_position(c, def.ground_a) && check_position(c, def.ground_b) && check_range(c, def.ratio, 0, max_ratio) &&
                   check(c, def.ratio > 0, Error::out_of_range) &&
                   check(c, rope(def.base.body_a, def.base.frame_a, def.ground_a) >= linear_slop, Error::out_of_range) &&
                   check(c, rope(def.base.body_b, def.base.frame_b, def.ground_b) >= linear_slop, Error::out_of_range);
        },
        [&](Joint& j) {
            j.ground_a = def.ground_a;
            j.ground_b = def.ground_b;
            j.ratio = def.ratio;
            j.length = rope(def.base.body_a, def.base.frame_a, def.ground_a) + def.ratio * rope(def.base.body_b, def.base.frame_b, def.ground_b);
        });
}

JointId World::create_joint(const GearJointDef& def) {
    Core& c = core();
    if (!check(c, has_joint(JointType::gear), Error::feature_cut)) return {};
    const DefaultFloatMode mode;
    const std::uint32_t joint1 = find_joint(c, def.joint1);
    if (joint1 == null_index) return {};
    const std::uint32_t joint2 = find_joint(c, def.joint2);
    if (joint2 == null_index) return {};
    const auto may_gear = [&](std::uint32_t joint) {
        const auto type = c.joints[joint].joint_type();
        return type == JointType::revolute || type == JointType::prismatic;
    };
    if (!check(c, may_gear(joint1) && may_gear(joint2), Error::wrong_joint_type)) return {};
    const std::uint32_t a = moving_body(c, c.joints[joint1]), b = moving_body(c, c.joints[joint2]);
    if (!check(c, a != b, Error::same_body) || !check(c, c.is_dynamic(a) && c.is_dynamic(b), Error::no_dynamic_body)) return {};
    if (!check_range(c, def.ratio, -max_ratio, max_ratio) || !check(c, def.ratio != 0, Error::out_of_range) || !check_not_negative(c, def.break_torque)) return {};
    const std::uint32_t i = take_joint(c, JointType::gear);
    if (i == null_index) return {};
    Joint& j = c.joints[i];
    j.body_a = a;
    j.body_b = b;
    j.joint1 = joint1;
    j.joint2 = joint2;
    j.ratio = def.ratio;
    j.break_torque = def.break_torque;
    j.user_data = def.user_data;
    j.flags |= joint_collide;
    j.length = joint_coordinate(c, c.joints[joint1]) + def.ratio * joint_coordinate(c, c.joints[joint2]);
    ++c.joints[joint1].gear_count;
    ++c.joints[joint2].gear_count;
    return tie(c, i);
}

}  // namespace islet
