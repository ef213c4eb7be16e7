// What the rows of all joints share, and how one is prepared, solved and stored.
//
// A joint is solved by one of a few kernels; joints of one kernel and one colour lie side by side in lanes. Preparing and storing go joint by
// joint, solving goes by lanes:
//
//   prepare   Joint -> rows, warm start added to the bodies
//   solve     rows <-> bodies, every sweep
//   store     rows -> Joint
//
// Within a step the lever arms turn with the bodies, so every sweep works them out anew from how far the bodies have turned. The impulses of the
// substep before then act along other directions than when they were applied: a sweep with bias first re-aims them, adding the difference
// M^-1 (J_now^T - J_then^T) lambda, and then solves. `applied` in the rows is J_then^T lambda. A relaxing sweep, which comes after the bodies have
// moved, does not re-aim: force is taken where the substep began, as in symplectic Euler. (Measured on a pendulum let go from level: after 10 s
// 0.04 % of the energy is lost; re-aiming in the relaxing sweep too loses 41 %, never re-aiming gains 94 %.)
//
// Sweeps with bias aim at the error at the end of the substep. Points on turning bodies move on arcs, so the prediction includes the second order:
// C(h) = C + h Cdot + h^2/2 q, where q is the part of C's second derivative that the velocities alone decide. Without it a swinging pendulum would
// stretch by h v^2 / (2 L rate). The correction is bounded to a slop per substep, so that wildly turning bodies do not feed on it.
#pragma once

#include <cstdint>

#include "../collide/manifold.hpp"
#include "../constraint/lane_vectors.hpp"
#include "../constraint/softness.hpp"
#include "../constraint/solver_body.hpp"
#include "../data/core.hpp"

namespace islet::detail {

/// Which kernel solves a joint (ISLET_JOINT_KERNELS in islet/config.hpp).
enum class JointKernel : std::uint32_t {
#define ISLET_NAME(name, ...) name,
    ISLET_JOINT_KERNELS(ISLET_NAME)
#undef ISLET_NAME
};

constexpr bool has_kernel(JointKernel kernel) {
#define ISLET_HAS(name, rows, there) \
    if (kernel == JointKernel::name) return there;
    ISLET_JOINT_KERNELS(ISLET_HAS)
#undef ISLET_HAS
    return false;
}

/// How one sweep treats joints.
struct JointSweep {
    float h = 0, inv_h = 0;
    float omega = 1;      // relaxation factor
    bool biased = false;  // false: velocities only
    Softness soft;        // of what is rigid; in a relax sweep (0, 1, 0)
    Softness soft_alone;  // the same of joints without a colour: those of crowded bodies, and those beside joint trees (solve_numbers.hpp)
    float max_turn = 0;   // rad/s, of bodies in joint trees
    float tree_rate = 0;  // 1/s, at which hinges solved exactly mend their error
};

/// Where joints find their inputs.
struct JointInput {
    const Joint* joints;
    const Pose* poses;
    const Body* bodies_in;
    const PlanIndex* slot_of;  // solver slot of a body
    SolverBody* bodies;
    StepNumbers numbers;
};

/// Which bodies, and how they stand to each other: the head of every joint's rows.
template <std::uint32_t W>
struct JointEnds {
    std::uint32_t body_a[W], body_b[W];  // solver slots; 0 in the padding
    std::uint32_t joint[W];              // null_index in the padding
    float rax[W], ray[W];                // m, anchor from A's centre when the step began
    float rbx[W], rby[W];
    float dx[W], dy[W];  // m, from A's centre to B's when the step began
};

/// J^T lambda as last applied: px, py and tb on B, their opposite and -ta on A.
template <std::uint32_t W>
struct Applied {
    float px[W], py[W];  // N s
    float ta[W], tb[W];  // N m s
};

/// Where a joint's two frames are in the world, seen from the bodies' centres.
struct JointPose {
    Vec2 ra, rb;  // m
    Vec2 d;       // m, from A's centre to B's
    Rot qa, qb;   // of the frames, world
};

inline JointPose pose_of(const Joint& j, const Pose* poses, const Body* bodies) {
    JointPose p;
    const Pose& b = poses[j.body_b];
    p.rb = rotate(b.q, j.local_b - bodies[j.body_b].local_center);
    p.qb = b.q * j.frame_b;
    if (j.body_a == null_index) {  // a mouse joint: A is the world, its point the target
        p.ra = {0, 0};
        p.d = b.center - j.local_a;
        p.qa = {};
        return p;
    }
    const Pose& a = poses[j.body_a];
    p.ra = rotate(a.q, j.local_a - bodies[j.body_a].local_center);
    p.qa = a.q * j.frame_a;
    p.d = b.center - a.center;
    return p;
}

/// A hinge whose bodies a call has put apart counts as closed if its gap is shorter, m; one that is made counts as put apart if its gap is wider. (Ropes that
/// are made with gaps of 3 cm under 300 times their links' mass would throw it.)
inline constexpr float closed_gap = 2 * linear_slop, wide_gap = 20 * linear_slop;

/// How its bodies move: for the speed of its coordinate.
struct JointMotion {
    Vec2 d_dot;    // m/s, of B's anchor as A's sees it
    float wa, wb;  // rad/s
};

/// Where a joint is drawn, in the world.
struct JointPlace {
    Vec2 a, b;                // m, its points
    Rot qa, qb;               // its frames
    Vec2 center_a, center_b;  // m, of mass
    bool moves_a, moves_b;
};

/// All that there is to know of a type of joints but its kernel: a specialisation in the type's own file says what differs from AnyJoint. Other files
/// reach it through joint_kinds.hpp.
template <JointType type>
struct JointKind;

struct AnyJoint {
    static constexpr bool has_coordinate = false;  // a spring, a limit and a motor act on it
    static constexpr bool has_friction = false;
    static constexpr bool has_length = false;    // the coordinate is a distance, never below 0
    static constexpr bool has_frames = true;     // they may be set anew
    static constexpr bool has_base = true;       // its definition has a JointBase
    static constexpr bool counts_turns = false;  // Joint::coordinate is its angle
    static constexpr bool has_softness = false;  // a frequency for its point, and perhaps one for its angle
    static constexpr bool has_strength = false;  // a greatest force, and perhaps a greatest torque
    static constexpr bool has_ratio = false;

    /// The joint's own part of what an image must keep: null, or what is wrong.
    static const char* fault(const Joint&) { return nullptr; }
    /// How far it is from what it locks; `p` is its pose.
    static JointError error(const Core&, const Joint&, const JointPose&) { return {}; }
    /// Calls add(point) for what is drawn beyond its points and its bodies' centres.
    template <class Add>
    static void reach(Add&&, const Joint&, const JointPlace&) {}
    // static bool take(const Core&, Joint&, const Def&)    fills the record from the definition; what all joints have, and its numbers' ranges, are the
    //                                                      caller's. False with the error recorded if the definition is no good. Not where has_base is false
    // static JointKernel kernel(const Joint&)
    // static float coordinate(const Joint&, const JointPose&), speed(const JointPose&, const JointMotion&)     where has_coordinate
    // static void add_rows(rows)                           its rows as they stand, in the kernel's order: export/island_joints.cpp says what `rows` can
    // static void draw(pen, const Joint&)                  its mark: draw/draw_joints.cpp says what `pen` can
};

/// From A's anchor to B's.
inline Vec2 gap_of(const JointPose& p) { return p.d + p.rb - p.ra; }

/// Angle of B in A, (-pi, pi].
inline float angle_of(const JointPose& p) { return islet::angle_of(inv_mul(p.qa, p.qb)); }

/// The angle that differs from `angle` by whole turns and is nearest to `near`.
ISLET_SHARED float unwrap(float angle, float near) {
    const float turns = (near - angle) * (0.5f / pi);
    if (!(abs(turns) < 1.0e6f)) return angle;
    const auto whole = static_cast<std::int32_t>(turns + (turns < 0 ? -0.5f : 0.5f));
    return angle + static_cast<float>(whole) * (2.0f * pi);
}

template <std::uint32_t W>
void set_ends(JointEnds<W>& r, std::uint32_t lane, const Joint& j, const JointInput& in, const JointPose& p) {
    r.body_a[lane] = j.body_a == null_index ? 0 : in.slot_of[j.body_a];
    r.body_b[lane] = in.slot_of[j.body_b];
    r.rax[lane] = p.ra.x;
    r.ray[lane] = p.ra.y;
    r.rbx[lane] = p.rb.x;
    r.rby[lane] = p.rb.y;
    r.dx[lane] = p.d.x;
    r.dy[lane] = p.d.y;
}

/// What an impulse adds to a body's velocity waits in its warm_v and warm_w for the first substep. Bodies that cannot be pushed are only read (see
/// scatter_pushed).
inline void add_warm_start(SolverBody& b, Vec2 impulse, float angular) {
    if (!is_positive(b.inv_mass)) return;
    b.warm_v += b.inv_mass * impulse;
    b.warm_w += b.inv_inertia * angular;
}

/// What a joint starts from: an impulse at B's anchor, and an angular impulse besides. Pulleys and gears see to theirs and return none.
struct WarmStart {
    Vec2 impulse;   // N s
    float turning;  // N m s
};

/// Starts from impulse p and the two angular impulses: remembered as applied, and added to the bodies' warm_v and warm_w for the first substep.
template <std::uint32_t W>
void warm_start(Applied<W>& applied, const JointEnds<W>& r, std::uint32_t lane, const JointInput& in, Vec2 p, float ta, float tb) {
    applied.px[lane] = p.x;
    applied.py[lane] = p.y;
    applied.ta[lane] = ta;
    applied.tb[lane] = tb;
    add_warm_start(in.bodies[r.body_a[lane]], -p, -ta);
    add_warm_start(in.bodies[r.body_b[lane]], p, tb);
}

/// Where a solved joint leaves its results.
struct JointOutput {
    Joint* joints;
    const Pose* poses;
    Body* bodies;
    const SolverBody* solved;
    float dt, h;  // s, step and substep
    float warm;   // StepNumbers::warm
    bool ends;    // the last substep; after the others, only what tears is noted
};

template <class L>
ISLET_LANE LaneVec<typename L::F> load(const float* x, const float* y) {
    return {L::load(x), L::load(y)};
}
template <class L>
ISLET_LANE void store(float* x, float* y, LaneVec<typename L::F> v) {
    L::store(x, v.x);
    L::store(y, v.y);
}

/// The arms of a block of joints as they are now, and the gap between the two anchors.
template <class L>
struct JointArms {
    using F = typename L::F;
    LaneVec<F> ra, rb, d;  // m
    ISLET_LANE JointArms(const JointEnds<L::width>& r, const JointBodies<L>& s)
        : ra(turn<L>(s.dqa, load<L>(r.rax, r.ray))), rb(turn<L>(s.dqb, load<L>(r.rbx, r.rby))), d(load<L>(r.dx, r.dy) + (s.dpb - s.dpa) + rb - ra) {}
};

/// A direction e along which B's point moves against a point of A, given by its arm: the Jacobian.
template <class L>
struct DirectionRow {
    using F = typename L::F;
    LaneVec<F> e;
    F sa, sb;  // angular entries
    F k;       // 1/kg

    ISLET_LANE DirectionRow(const JointBodies<L>& s, LaneVec<F> direction, LaneVec<F> arm_a, LaneVec<F> rb)
        : e(direction), sa(cross(arm_a, direction)), sb(cross(rb, direction)), k(s.ma + s.mb + s.ia * sa * sa + s.ib * sb * sb) {}

    ISLET_LANE F speed(const JointBodies<L>& s) const { return dot(e, s.vb - s.va) + sb * s.wb - sa * s.wa; }
    /// The second derivative, if e is fixed in A.
    ISLET_LANE F bend(const JointBodies<L>& s, const JointArms<L>& arms) const {
        const LaneVec<F> d_dot = s.point_velocity(arms.ra, arms.rb);
        return dot(e, s.point_curvature(arms.ra, arms.rb)) + (s.wa + s.wa) * dot(left_perp(e), d_dot) - s.wa * s.wa * dot(e, arms.d);
    }
    ISLET_LANE void push(JointBodies<L>& s, F impulse) const { s.push(impulse * e, sa * impulse, sb * impulse); }
};

template <class L>
ISLET_LANE JointBodies<L> gather(const SolverBody* bodies, const JointEnds<L::width>& r, const Applied<L::width>& applied) {
    JointBodies<L> s;
    s.gather(bodies, r.body_a, r.body_b);
    s.p = load<L>(applied.px, applied.py);
    s.ta = L::load(applied.ta);
    s.tb = L::load(applied.tb);
    return s;
}

template <class L>
ISLET_LANE void scatter(SolverBody* bodies, const JointEnds<L::width>& r, Applied<L::width>& applied, const JointBodies<L>& s) {
    store<L>(applied.px, applied.py, s.p);
    L::store(applied.ta, s.ta);
    L::store(applied.tb, s.tb);
    s.scatter(bodies, r.body_a, r.body_b);
}

/// In sweeps with bias: makes what was applied p and the angular impulses, as they would be applied now.
template <class L>
ISLET_LANE void aim(JointBodies<L>& s, const JointSweep& n, LaneVec<typename L::F> p, typename L::F ta, typename L::F tb) {
    if (n.biased) s.push(p - s.p, ta - s.ta, tb - s.tb);
}
/// The same for an impulse that keeps its direction in the world.
template <class L>
ISLET_LANE void aim_arms(JointBodies<L>& s, const JointSweep& n, typename L::F ta, typename L::F tb) {
    if (n.biased) s.push_angular(ta - s.ta, tb - s.tb);
}

/// What half a substep of second derivative q adds to a speed, in sweeps with bias; at most a slop per substep.
template <class L>
ISLET_LANE typename L::F curve(typename L::F q, const JointSweep& n) {
    const typename L::F bound = L::splat(n.biased ? linear_slop * n.inv_h : 0.0f);
    return clamp_lanes<L>(L::splat(0.5f * n.h) * q, -bound, bound);
}

/// What a rigid row of effective mass 1 / k adds to its impulse so far.
template <class L>
ISLET_LANE_SHARED typename L::F rigid_delta(const JointSweep& n, typename L::F k, typename L::F residual, typename L::F impulse) {
    return -(L::splat(n.omega * n.soft.mass_scale) * inverse_or_zero<L>(k) * residual) - L::splat(n.omega * n.soft.impulse_scale) * impulse;
}

/// The effective mass of a point of two bodies: the inverse of
///     K = (ma + mb) I + ia [ay^2, -ax ay; -ax ay, ax^2] + ib [by^2, -bx by; -bx by, bx^2].
template <class F>
struct PointMass {
    F k11, k12, k22;
};

template <class L>
ISLET_LANE PointMass<typename L::F> point_mass(const JointBodies<L>& s, LaneVec<typename L::F> ra, LaneVec<typename L::F> rb) {
    const auto m = s.ma + s.mb;
    return {m + s.ia * ra.y * ra.y + s.ib * rb.y * rb.y, -(s.ia * ra.x * ra.y) - s.ib * rb.x * rb.y, m + s.ia * ra.x * ra.x + s.ib * rb.x * rb.x};
}

/// K^-1 v, or 0 where K cannot be inverted.
template <class L>
ISLET_LANE LaneVec<typename L::F> solve_2x2(typename L::F k11, typename L::F k12, typename L::F k22, LaneVec<typename L::F> v) {
    const auto inv = inverse_or_zero<L>(k11 * k22 - k12 * k12);
    return {inv * (k22 * v.x - k12 * v.y), inv * (k11 * v.y - k12 * v.x)};
}

/// Solves both rows of a point as a block: B's point moves onto A's. The impulse so far is s.p.
///     C = (xb + rb) - (xa + ra),  Cdot = vb + wb x rb - va - wa x ra
template <class L>
ISLET_LANE void solve_point(JointBodies<L>& s, LaneVec<typename L::F> ra, LaneVec<typename L::F> rb, LaneVec<typename L::F> c, const JointSweep& n) {
    using F = typename L::F;
    const PointMass<F> k = point_mass<L>(s, ra, rb);
    const LaneVec<F> q = s.point_curvature(ra, rb);
    const LaneVec<F> speed = s.point_velocity(ra, rb) + LaneVec<F>{curve<L>(q.x, n), curve<L>(q.y, n)};
    const LaneVec<F> wanted = solve_2x2<L>(k.k11, k.k12, k.k22, speed + L::splat(n.soft.rate) * c);
    const F mass_scale = L::splat(n.omega * n.soft.mass_scale);
    const F impulse_scale = L::splat(n.omega * n.soft.impulse_scale);
    const LaneVec<F> delta = {-(mass_scale * wanted.x) - impulse_scale * s.p.x, -(mass_scale * wanted.y) - impulse_scale * s.p.y};
    s.push(delta, cross(ra, delta), cross(rb, delta));
}

ISLET_ALWAYS_INLINE inline Vec2 turned(float angle, float x, float y) {
    const LaneVec<float> v = turn<Lane1>(angle, LaneVec<float>{x, y});
    return {v.x, v.y};
}

/// Forgets all impulses of a joint if what it applies is beyond unsound_impulse, or if any single impulse is not finite. (Single impulses may cancel out in
/// what it applies; the sum of all is not finite if one of them is not.)
ISLET_SHARED void forget_unsound(Joint& j) {
    // Field by field: wide loads would wait for the narrow stores just made, and so would a long chain of sums for each other.
    const float applied = abs(j.force_impulse.x) + abs(j.force_impulse.y) + abs(j.torque_impulse);
    const float others =
        (j.impulse.x + j.impulse.y) + (j.angular_impulse + j.spring_impulse) + ((j.motor_impulse + j.friction_impulse) + (j.lower_impulse + j.upper_impulse));
    if (applied < unsound_impulse && is_finite(others)) return;
    j.forget_impulses();
}

/// True if a joint bore more in a substep than it can. What overflows breaks nothing.
inline bool bears_too_much(const Joint& j, float inv_h) {
    const float force = inv_h * length(j.force_impulse), torque = inv_h * abs(j.torque_impulse);
    if (!(force < unsound_impulse * inv_h && torque < unsound_impulse * inv_h)) return false;
    return (j.break_force > 0 && force > j.break_force) || (j.break_torque > 0 && torque > j.break_torque);
}

/// Marks a joint that bore too much in a substep, of which `borne` has the impulses. It keeps these, for readers, and is broken at the end of the step.
inline void note_torn(Joint& j, const Joint& borne, const JointOutput& out) {
    if (!bears_too_much(borne, 1.0f / out.h)) return;
    j.force_impulse = borne.force_impulse;
    j.torque_impulse = borne.torque_impulse;
    j.flags |= joint_torn;
}

/// Notes how an impulse p at `arm` (when the step began) pulled a body outwards, for the next step's stability (stiffened() in free_motion.hpp), up to
/// `most` times its inertia. What cannot be pushed is not stretched.
inline void add_stretch(const JointOutput& out, std::uint32_t slot, std::uint32_t body, Vec2 arm, Vec2 p, float most = 1.0e37f) {
    const SolverBody& b = out.solved[slot];
    if (!is_positive(b.inv_mass)) return;
    const float inv_inertia = out.poses[body].inv_inertia;
    const float bound = is_positive(inv_inertia) ? min(most / inv_inertia, 1.0e37f) : 1.0e37f;  // many joints may pull at one body: no sum may overflow
    float& stretch = out.bodies[body].stretch;
    stretch = within_bounds(stretch + out.h * dot(turned(b.dq, arm.x, arm.y), p), bound);
}

/// Writes back the impulse, for readers, and how the joint stretched its bodies.
template <std::uint32_t W>
void store_applied(const Applied<W>& applied, const JointEnds<W>& r, std::uint32_t lane, Joint& j, const JointOutput& out, float most_stretch) {
    const Vec2 p = {applied.px[lane], applied.py[lane]};
    j.force_impulse = p;
    if (!out.ends) return;
    if (!(abs(p.x) + abs(p.y) < unsound_impulse)) return;
    add_stretch(out, r.body_b[lane], j.body_b, {r.rbx[lane], r.rby[lane]}, p, most_stretch);
    add_stretch(out, r.body_a[lane], j.body_a, {r.rax[lane], r.ray[lane]}, -p, most_stretch);
}

}  // namespace islet::detail
