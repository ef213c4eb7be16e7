// Finds numbers that no sound world holds, record by record. NaN fails every comparison.
#include "../exact.hpp"

#include "../bodies/bounds.hpp"
#include "../bodies/geometry_pool.hpp"
#include "../broadphase/pairs.hpp"
#include "../calls/checks.hpp"
#include "../collide/manifold.hpp"
#include "../constraint/joint_kinds.hpp"
#include "../shapes/shape_types.hpp"
#include "../solver/solver_def.hpp"
#include "../state/faults.hpp"

namespace islet::detail {

namespace {

// After a step, centres of mass are within max_position; before it, at most a shape's reach farther out.
constexpr float far_away = 8.0f * max_position;

bool is_near(Vec2 p) { return abs(p.x) <= far_away && abs(p.y) <= far_away; }
bool within(float a, float lo, float hi) { return a >= lo && a <= hi; }
bool not_negative(float a) { return within(a, 0, no_limit); }
bool is_unit(Rot q) { return abs(q.c * q.c + q.s * q.s - 1.0f) <= 1.0e-5f; }

/// True if the 4-byte floats from byte `first` to byte `end` of a record are finite.
template <class Record>
bool floats_are_finite(const Record& record, std::size_t first, std::size_t end) {
    const auto* bytes = reinterpret_cast<const std::byte*>(&record);
    for (std::size_t at = first; at < end; at += 4) {
        float a = 0;
        std::memcpy(&a, bytes + at, 4);
        if (!is_finite(a)) return false;
    }
    return true;
}

}  // namespace

const char* fault_in_numbers(const State& s) {
    if (s.solver.schedule > 1 || s.solver.warm_start > 1 || s.solver.joint_trees > 2 || s.solver.sweep_order > 3 || s.solver.block_contacts > 1 ||
        s.solver.measure_residual > 1 || s.trees_stale > 1 || s.enable_sleep > 1 || s.continuous > 1 || s.catching_floors > 1 ||
        s.asked > (shape_single_bits | asked_one_way | asked_breaks | asked_sharing))
        return "a setting of the world is none";
    Error error = Error::none;
    const bool sane = check_solver(unpack(s.solver), error) && is_finite(s.gravity) && not_negative(s.restitution_threshold) && s.max_speed > 0 &&
                      s.max_speed <= max_speed_limit && within(s.last_substep, 0, 1) && not_negative(s.hit_threshold);
    return sane ? nullptr : "a setting of the world is out of range";
}

const char* fault_in_numbers(const Body& b, const Pose& pose, const Motion& motion) {
    if ((b.flags & body_type_mask) > static_cast<std::uint32_t>(BodyType::dynamic) || b.flags > body_all_flags) return "a body's flags are none";
    if ((pose.flags & ~std::uint32_t{pose_fast | pose_moved | pose_learns}) != 0) return "a body's flags are none";
    if (!is_near(pose.center) || !is_near(b.origin) || !is_near(b.local_center) || !is_finite(motion.v) || !is_finite(motion.w))
        return "a body's state is not finite";
    if (!is_unit(pose.q)) return "a rotation is not of unit length";
    if (!not_negative(motion.sleep_time) || !is_finite(motion.slack)) return "a body's rest is not finite";
    if (!not_negative(b.linear_damping) || !not_negative(b.angular_damping) || !is_finite(b.gravity_scale) || !not_negative(b.sleep_threshold))
        return "a body's damping, gravity or sleep threshold is out of range";
    if (!not_negative(b.mass) || !not_negative(b.inertia)) return "a body's mass or inertia is out of range";
    if (!is_finite(motion.force) || !all_finite(motion.torque, b.stretch)) return "what pulls at a body is not finite";
    constexpr float rounding = 1.001f;
    const bool dynamic = b.type() == BodyType::dynamic;
    if (dynamic && !within(pose.inv_mass, 1.0f / (rounding * max_mass), rounding / min_mass)) return "a dynamic body has no mass";
    if (dynamic && !within(pose.inv_inertia, 0, rounding / min_inertia)) return "a body's inertia is out of range";
    if (!dynamic && (pose.inv_mass != 0 || pose.inv_inertia != 0)) return "a body that cannot be pushed has a mass";
    return nullptr;
}

const char* fault_in_numbers(const Shape& s, const Aabb& box) {
    const bool sane = within(s.friction, 0, max_coefficient) && within(s.restitution, 0, 1) && within(s.rolling_resistance, 0, max_coefficient) &&
                      within(s.tangent_speed, -max_speed_limit, max_speed_limit) && not_negative(s.density) && within(s.margin, 0, max_box_margin);
    if (!sane) return "a shape's material is out of range";
    if ((s.flags & ~static_cast<std::uint32_t>(shape_single_bits | shape_one_way_bits)) != 0) return "a shape's flags are none";
    const bool ordered = box.lower.x <= box.upper.x && box.lower.y <= box.upper.y;
    return ordered && is_near(box.lower) && is_near(box.upper) ? nullptr : "a box is inside out or far away";
}

const char* fault_in_numbers(const Geometry& g) {
    if (g.type >= shape_type_count || !with_shape(g, [](const auto& shape) { return is_valid(shape); })) return "a geometry is not valid";
    return g.hash == geometry_hash(g) ? nullptr : "a geometry has the wrong hash";
}

const char* fault_in_numbers(const ImageManifold& m) {
    constexpr std::uint32_t known = contact_touching | contact_posed | contact_special | contact_bouncy | 3u << contact_count_shift | contact_sensor |
                                    contact_overlap | contact_hits | contact_asks | contact_one_way | contact_passes | contact_dropped | contact_ahead |
                                    contact_untold | 3u << contact_sharers_shift | contact_rolls | 0xffu << contact_color_shift;
    if ((m.flags & ~known) != 0 || m.count() > 2) return "a contact's flags are none";
    if (m.color() != no_color && m.color() >= color_count) return "a contact has a colour that is none";
    if (!floats_are_finite(m, offsetof(ImageManifold, normal), sizeof m)) return "a contact's numbers are not finite";
    if (!is_unit(m.rotation_a) || !is_unit(m.rotation_b)) return "a rotation is not of unit length";
    const float length = length_squared(m.normal);
    if (length > 1.001f || (m.count() > 0 && length < 0.999f)) return "a contact's normal is not of unit length";
    return within(m.friction, 0, 1.001f * max_coefficient) ? nullptr : "a contact's friction is out of range";
}

const char* fault_in_numbers(const Joint& j) {
    constexpr std::uint32_t known = joint_spring | joint_limit | joint_motor | joint_collide | joint_exact | joint_anchor | joint_loaded |
                                    0xffu << joint_color_shift | joint_calm_bits | joint_moved;
    if (j.type >= joint_type_count || (j.flags & ~known) != 0 || ((j.flags & joint_exact) != 0 && j.joint_type() != JointType::revolute))
        return "a joint's type or flags are none";
    if (j.color() != no_color && j.color() >= color_count) return "a joint has a colour that is none";
    const auto type = j.joint_type();
    if (type == JointType::gear && j.color() != no_color) return "a gear has a colour";
    if (!floats_are_finite(j, offsetof(Joint, local_a), offsetof(Joint, gear_count)) ||
        !floats_are_finite(j, offsetof(Joint, impulse), offsetof(Joint, user_data)))
        return "a joint's numbers are not finite";
    if (!is_near(j.local_a) || !is_near(j.local_b) || !is_near(j.ground_a) || !is_near(j.ground_b)) return "a joint's point is out of range";
    if (!is_unit(j.frame_a) || !is_unit(j.frame_b)) return "a rotation is not of unit length";
    for (const float a : {j.break_force, j.break_torque, j.spring_hertz, j.spring_damping_ratio, j.motor_max, j.friction, j.linear_hertz,
                          j.linear_damping_ratio, j.angular_hertz, j.angular_damping_ratio, j.max_torque})
        if (a < 0) return "a joint's strength is negative";
    if (j.lower > j.upper) return "a joint's limits are crossed";
    return with_kind(type, [&](auto kind) { return kind.fault(j); });
}

}  // namespace islet::detail
