#include "../exact.hpp"

#include "../constraint/joint_parts.hpp"

#include "../calls/checks.hpp"

namespace islet::detail {

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

}  // namespace islet::detail
