// Angle joint: ties the angle of two bodies, and leaves their points free.
//
// The coordinate is that of a hinge, the angle of frame B in frame A, continuous past a full turn:
//     x = qb - qa,  J = (-1, 1) on (wa, wb),  K = ia + ib
// Spring, limits, motor and friction act on it (coordinate.hpp). A ratchet is a limit that follows: its teeth are at phase + i step, and the last one that
// x is past holds it as a lower limit does, or where the step is below 0 as an upper one. (Angle, phase and step are those of Chipmunk's ratchet joint.)
//
// Of the record `length` is the step, `velocity` the phase and the tooth that holds. The impulses are the coordinate's.
#pragma once

#include "../calls/checks.hpp"
#include "../constraint/revolute_joint.hpp"

namespace islet::detail {

template <std::uint32_t W>
struct alignas(W * 4) AngleRows : HingeRows<W> {};

inline constexpr float least_ratchet_step = 0.001f, most_ratchet_step = 100, most_ratchet_phase = 1.0e4f;  // rad

inline bool is_ratchet_step(float step) { return step == 0 || (abs(step) >= least_ratchet_step && abs(step) <= most_ratchet_step); }

inline bool check_ratchet(const Core& core, const JointRatchet& r) {
    return check_finite(core, r.step) && check_range(core, r.phase, -most_ratchet_phase, most_ratchet_phase) &&
           check(core, is_ratchet_step(r.step), Error::out_of_range);
}

/// No tooth holds yet.
inline void set_ratchet_of(Joint& j, const JointRatchet& r) {
    j.length = r.step;
    j.velocity = {r.phase, r.step < 0 ? no_bound : -no_bound};
    if ((j.flags & joint_limit) == 0) j.lower_impulse = j.upper_impulse = j.limit_load = 0;
}

/// The tooth that holds when the angle is x.
inline float tooth_at(const Joint& j, float x) {
    const float step = j.length, phase = j.velocity.x, tooth = j.velocity.y;
    const float steps = (x - phase) / step;
    if (!(abs(steps) < 1.0e9f)) return tooth;
    auto whole = static_cast<std::int32_t>(steps);
    if (static_cast<float>(whole) > steps) --whole;
    const float passed = phase + static_cast<float>(whole) * step;
    return step > 0 ? max(tooth, passed) : min(tooth, passed);
}

/// What the limits and the ratchet leave free.
struct AngleRange {
    float lower, upper;
};

inline AngleRange range_at(const Joint& j, float x) {
    const bool limited = (j.flags & joint_limit) != 0;
    AngleRange range = {limited ? j.lower : -no_bound, limited ? j.upper : no_bound};
    if (j.length > 0) range.lower = max(range.lower, tooth_at(j, x));
    if (j.length < 0) range.upper = min(range.upper, tooth_at(j, x));
    return range;
}

template <std::uint32_t W>
WarmStart prepare(AngleRows<W>& r, std::uint32_t lane, const Joint& j, const JointPose& p, const JointInput& in) {
    r.angle[lane] = unwrap(angle_of(p), j.coordinate);
    float turning = set_coordinate(r.free, lane, j, in);
    if (j.length != 0) {
        const AngleRange range = range_at(j, r.angle[lane]);
        hold_between(r.free, lane, j, in.numbers, range.lower, range.upper);
        r.free.parts |= part_limit;
        turning = r.free.spring[lane] + r.free.motor[lane] + r.free.friction[lane] + r.free.low[lane] - r.free.high[lane];
    }
    return {{0, 0}, turning};
}

template <class L>
ISLET_LANE void solve(JointBodies<L>& s, const JointArms<L>&, AngleRows<L::width>& r, const JointSweep& n) {
    using F = typename L::F;
    const F k = s.ia + s.ib;
    const F x = L::load(r.angle) + s.dqb - s.dqa;
    s.push_angular(solve_motor_and_friction<L>(r.free, k, s.wb - s.wa, n));
    s.push_angular(solve_spring_and_limits<L>(r.free, x, k, s.wb - s.wa, L::splat(0.0f), n));
}

template <std::uint32_t W>
void store(const AngleRows<W>& r, std::uint32_t lane, Joint& j, const JointOutput& out) {
    get_coordinate(r.free, lane, j, out);
    j.torque_impulse = coordinate_impulse(j);
    j.coordinate = r.angle[lane] + turned_by(r.ends, lane, out);
    if (j.length == 0) return;
    if ((j.flags & joint_limit) == 0) keep_load(r.free.low[lane] - r.free.high[lane], j, out);
    for (const float x : {r.angle[lane], j.coordinate}) j.velocity.y = tooth_at(j, x);  // a new ratchet has passed the teeth up to where the step began
}

template <>
struct JointKind<JointType::angle> : AnyJoint {
    static constexpr bool has_coordinate = true, has_friction = true, counts_turns = true;

    static bool take(const Core& core, Joint& j, const AngleJointDef& def) {
        fill_coordinate(j, def.spring, def.limit, def.motor);
        j.friction = def.friction;
        set_ratchet_of(j, def.ratchet);
        return check_ratchet(core, def.ratchet);
    }
    static const char* fault(const Joint& j) { return is_ratchet_step(j.length) ? nullptr : "a ratchet's step is out of range"; }
    static JointKernel kernel(const Joint&) { return JointKernel::angle; }
    static float coordinate(const Joint& j, const JointPose& p) { return unwrap(angle_of(p), j.coordinate); }
    static float speed(const JointPose&, const JointMotion& m) { return m.wb - m.wa; }
    static JointError error(const Core&, const Joint& j, const JointPose& p) {
        const float x = coordinate(j, p);
        const AngleRange range = range_at(j, x);
        return {0, max(0.0f, max(range.lower - x, x - range.upper))};
    }

    template <class Rows>
    static void add_rows(Rows& rows) {
        const float x = coordinate(rows.j, rows.p);
        Joint held = rows.j;
        if (held.length != 0) {
            const AngleRange range = range_at(held, x);
            held.flags |= joint_limit;
            held.lower = range.lower;
            held.upper = range.upper;
        }
        Rows of_held{rows.to, held, rows.slot, rows.p};
        const auto free = of_held.turning();
        of_held.motor_and_friction(free);
        of_held.spring_and_limits(free, x, held.target);
    }
    /// A ring around A's point, toothed if there is a ratchet, with a hand that turns with B and the limits' directions in A; dashes to B's point.
    template <class Pen>
    static void draw(const Pen& pen, const Joint& j) {
        if (j.length != 0) {
            pen.toothed_ring(pen.at.a, pen.at.qa);
        } else {
            pen.circle(pen.at.a, pen.size, pen.direction(pen.at.qa));
        }
        pen.segment(pen.at.a, pen.at.a + pen.size * pen.direction(pen.at.qb));
        pen.limits_around(j);
        pen.dashes(pen.at.a, pen.at.b);
    }
};

}  // namespace islet::detail
