// What acts on the one coordinate a joint leaves free: a spring, a motor, dry friction, and two limits, each a row of its own.
//
// All share one Jacobian J and K = J M^-1 J^T; with x the coordinate and Cdot = dx/dt:
//     spring    a SplitSpring (softness.hpp) to `target`, with K for k
//     motor     Cdot = speed,  |lambda| <= h max_force
//     friction  Cdot = 0,      |lambda| <= h friction
//     lower     C = x - lower >= 0,  lambda >= 0
//     upper     C = upper - x >= 0,  lambda >= 0, pulls the other way
// A rigid row is soft (softness.hpp): in each sweep it loses a part of its impulse, and under a steady load it gives way until its error makes up for
// that. A limit loses a part only of the impulse that exceeds its load, so that it holds where it is set. The load is what the joint's own motor puts on the
// limit, and a running mean of what else the limit bore (load_rate). (Without any loss the impulse follows the error like an integrating controller, which
// swings up where the load is much heavier than the bodies of the joint. A mean over a shorter time does the same. What the heavy end of a row of limits does
// decays the more slowly the heavier it is, in proportion, so the time of the mean grows with the load too: light_load.)
// Units: rad, N m s and so on for an angle; m, N s for a length. Limits are speculative: they may be reached within the substep, not passed
// (Catto, "Solver2D", 2024).
#pragma once

#include "../constraint/joint_parts.hpp"
#include "../constraint/joint_rows.hpp"
#include "../constraint/softness.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

/// How far x is outside the joint's limits, if they are enabled.
inline float beyond_limit(const Joint& j, float x) { return (j.flags & joint_limit) != 0 ? max(0.0f, max(j.lower - x, x - j.upper)) : 0.0f; }

/// Limits along an axis through A's point, for JointKind::reach.
template <class Add>
void reach_limits(Add&& add, const Joint& j, const JointPlace& at, Vec2 axis) {
    if ((j.flags & joint_limit) == 0) return;
    add(at.a + clamp(j.lower, -max_position, max_position) * axis);
    add(at.a + clamp(j.upper, -max_position, max_position) * axis);
}

/// Which rows a block has in any of its lanes.
enum CoordinateParts : std::uint32_t { part_spring = 1u, part_motor = 2u, part_friction = 4u, part_limit = 8u };

template <std::uint32_t W>
struct CoordinateRows {
    SpringRows<W> soft;
    float target[W], held[W];      // held: N s, N m s, what the spring's relaxing sweep does not soften: (1 - late) `held`
    float speed[W], max_motor[W];  // max_motor, max_friction: N s, N m s over a substep
    float max_friction[W];
    float lower[W], upper[W];
    float load[W];                                            // on the limits, N s or N m s over a substep: positive on the lower, negative on the upper one
    float spring[W], motor[W], friction[W], low[W], high[W];  // accumulated impulses
    std::uint32_t parts;
    std::uint8_t pad[W * 4 - 4];
};

inline constexpr float load_rate = 60.0f / 128;  // 1/s, at which the load follows the impulse: slower than joints swing
inline constexpr float light_load = 100;         // m/s^2: a load that would give the lighter body more is followed more slowly, in inverse proportion

inline constexpr float no_bound = 1.0e12f;  // m or rad: what is farther is out of reach, and its products could leave the range of float
inline float within_bound(float a) { return within_bounds(a, no_bound); }

inline std::uint32_t coordinate_parts(const Joint& j) {
    return ((j.flags & joint_spring) != 0 ? std::uint32_t{part_spring} : 0u) | ((j.flags & joint_motor) != 0 ? std::uint32_t{part_motor} : 0u) |
           (is_positive(j.friction) ? std::uint32_t{part_friction} : 0u) | ((j.flags & joint_limit) != 0 ? std::uint32_t{part_limit} : 0u);
}

/// What the joint's own motor put on its limits in the last substep. (A wheel's motor turns it, and its limits are the strut's.)
inline float own_drive(const Joint& j) { return j.joint_type() == JointType::wheel ? 0 : j.motor_impulse; }

/// Fills the limits' part of rows that have none yet.
template <std::uint32_t W>
ISLET_PART void hold_between(CoordinateRows<W>& r, std::uint32_t lane, const Joint& j, const StepNumbers& n, float lower, float upper) {
    r.lower[lane] = within_bound(lower);
    r.upper[lane] = within_bound(upper);
    r.low[lane] = n.swept_warm * j.lower_impulse;
    r.high[lane] = n.swept_warm * j.upper_impulse;
    r.load[lane] = n.warm * (j.limit_load - own_drive(j));
}

/// The speed that an impulse on the limits would give to the lighter of the joint's bodies; where it turns, at its radius of gyration. m/s.
ISLET_SHARED float given_speed(const Joint& j, const Pose* poses, float impulse) {
    const bool turns = j.joint_type() == JointType::revolute || j.joint_type() == JointType::angle;
    const auto given_to = [&](std::uint32_t body) {
        if (body == null_index) return 0.0f;
        const Pose& p = poses[body];
        return turns ? sqrt(p.inv_mass * p.inv_inertia) : p.inv_mass;
    };
    return abs(impulse) * max(given_to(j.body_a), given_to(j.body_b));
}

/// The load that the limits bore, after a step, from their impulse. An image may hold any load; one beyond all sense is forgotten, as impulses are.
ISLET_PART void keep_load(float impulse, Joint& j, const JointOutput& out) {
    const float before = out.warm * j.limit_load;  // in this step's substeps
    const float borne = impulse + own_drive(j);
    const float bound = light_load * out.h;
    const float rate = load_rate * bound / max(bound, given_speed(j, out.poses, max(abs(borne), abs(before))));
    const float load = before + rate * out.dt * (borne - before);
    j.limit_load = abs(load) < unsound_impulse ? load : 0;
}

/// Fills rows that hold zeros. Returns the sum of the impulses, which warm starting applies.
template <std::uint32_t W>
float set_coordinate(CoordinateRows<W>& r, std::uint32_t lane, const Joint& j, const JointInput& in) {
    const StepNumbers& n = in.numbers;
    const std::uint32_t parts = coordinate_parts(j);
    r.parts |= parts;
    // A lane without a part that its neighbours have must come out as if there were none.
    r.soft.kick[lane] = -1;
    r.lower[lane] = -__builtin_huge_valf();
    r.upper[lane] = __builtin_huge_valf();
    if ((parts & part_spring) != 0) {
        const float crowd = crowd_of(j, in.poses, in.bodies_in);
        set_spring(r.soft, lane, split_spring(j.spring_hertz, j.spring_damping_ratio, crowd, n.h, n.relaxes));
        r.target[lane] = within_bound(j.target);
        r.spring[lane] = n.swept_warm * j.spring_impulse;
    }
    if ((parts & part_motor) != 0) {
        r.speed[lane] = within_bound(j.motor_speed);
        r.max_motor[lane] = n.h * j.motor_max;
        r.motor[lane] = n.swept_warm * j.motor_impulse;
    }
    if ((parts & part_friction) != 0) {
        r.max_friction[lane] = n.h * j.friction;
        r.friction[lane] = n.swept_warm * j.friction_impulse;
    }
    if ((parts & part_limit) != 0) hold_between(r, lane, j, n, j.lower, j.upper);
    return r.spring[lane] + r.motor[lane] + r.friction[lane] + r.low[lane] - r.high[lane];
}

/// `torn`: the joint's other rows gave way so far that what its limits bore is no load.
template <std::uint32_t W>
ISLET_SHARED void get_coordinate(const CoordinateRows<W>& r, std::uint32_t lane, Joint& j, const JointOutput& out, bool torn = false) {
    j.spring_impulse = r.spring[lane];
    j.motor_impulse = r.motor[lane];
    j.friction_impulse = r.friction[lane];
    j.lower_impulse = r.low[lane];
    j.upper_impulse = r.high[lane];
    if ((j.flags & joint_limit) != 0) keep_load(torn ? 0 : r.low[lane] - r.high[lane], j, out);
}

/// The sum of the impulses so far.
inline float coordinate_impulse(const Joint& j) { return j.spring_impulse + j.motor_impulse + j.friction_impulse + j.lower_impulse - j.upper_impulse; }
template <class L>
ISLET_LANE_SHARED typename L::F coordinate_impulse(const CoordinateRows<L::width>& r) {
    return L::load(r.spring) + L::load(r.motor) + L::load(r.friction) + L::load(r.low) - L::load(r.high);
}

/// Solves the spring and the limits. x is the coordinate, k its K, speed its rate, bend its q; returns the impulse to apply.
template <class L>
ISLET_LANE typename L::F solve_spring_and_limits(CoordinateRows<L::width>& r, typename L::F x, typename L::F k, typename L::F speed, typename L::F bend,
                                                 const JointSweep& n) {
    using F = typename L::F;
    const F zero = L::splat(0.0f);
    const F m = L::splat(n.omega) * inverse_or_zero<L>(k);
    F sum = zero;
    if ((r.parts & part_spring) != 0) {
        const F one = L::splat(1.0f), old = L::load(r.spring), kick = L::load(r.soft.kick), scale = L::load(r.soft.scale), late = L::load(r.soft.late);
        const F soft_part = n.biased ? old : old - L::load(r.held);
        const F wanted = -(m * (scale * speed + (n.biased ? kick : late * kick) * (x - L::load(r.target)))) - L::splat(n.omega) * (one - scale) * soft_part;
        const F delta = select(kick < zero, zero, wanted);
        L::store(r.spring, old + delta);
        if (n.biased) L::store(r.held, (one - late) * (old + delta));
        sum = sum + delta;
        speed = speed + k * delta;
    }
    if ((r.parts & part_limit) != 0) {
        const F inv_h = L::splat(n.inv_h);
        const F rate = L::splat(n.soft.rate), mass_scale = L::splat(n.soft.mass_scale), impulse_scale = L::splat(n.omega * n.soft.impulse_scale);
        const F ahead = curve<L>(bend, n);
        const F load = L::load(r.load);
        const auto side = [&](float* impulse, F borne, F c, F rate_of_c) {
            const F old = L::load(impulse);
            const auto apart = c > zero;
            const F bias = select(apart, c * inv_h, rate * c);
            const F scale = select(apart, L::splat(1.0f), mass_scale);
            const F delta = -(m * scale * (rate_of_c + bias)) - select(apart, zero, impulse_scale) * (old - max(borne, zero));
            const F lambda = max(old + delta, zero);
            L::store(impulse, lambda);
            return lambda - old;
        };
        const F low = side(r.low, load, x - L::load(r.lower), speed + ahead);
        sum = sum + low;
        speed = speed + k * low;
        const F high = side(r.high, -load, L::load(r.upper) - x, -(speed + ahead));
        sum = sum - high;
    }
    return sum;
}

/// Solves the motor and the friction.
template <class L>
ISLET_LANE typename L::F solve_motor_and_friction(CoordinateRows<L::width>& r, typename L::F k, typename L::F speed, const JointSweep& n) {
    using F = typename L::F;
    const F m = L::splat(n.omega) * inverse_or_zero<L>(k);
    F sum = L::splat(0.0f);
    const auto row = [&](float* impulse, F target, F bound) {
        const F old = L::load(impulse);
        // A lane that has no such row, beside one that has, is clamped to between -0 and 0: adding 0 leaves +0 there, as where it stands alone.
        const F lambda = clamp_lanes<L>(old - m * (speed - target), -bound, bound) + L::splat(0.0f);
        L::store(impulse, lambda);
        sum = sum + (lambda - old);
        speed = speed + k * (lambda - old);
    };
    if ((r.parts & part_friction) != 0) row(r.friction, L::splat(0.0f), L::load(r.max_friction));
    if ((r.parts & part_motor) != 0) row(r.motor, L::load(r.speed), L::load(r.max_motor));
    return sum;
}

}  // namespace islet::detail
