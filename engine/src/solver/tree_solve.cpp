#include "../exact.hpp"

#include "../solver/tree_solve.hpp"

#include "../constraint/angle_law.hpp"
#include "../constraint/revolute_joint.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

namespace {

// A tree is eliminated towards one of its holds. At any other it hangs on a body so many times as heavy as the lightest of all: passes make up for the
// difference, and a chain that is taut between two holds, whose hinges then need more of each other than there is, gives way a little. (A bridge of 60 planks,
// flat, with 200 times a plank's weight on it: 7 mm a hinge at 100, 1.5 mm at 1000, 0.3 mm at 10 000. At 50 000, floats have no digits left for the lightest:
// a row of four links, one of them 54 times as heavy, that hung on 1000 times the heavy one came to 30 times its energy in a sweep.)
constexpr float ground_ratio = 1000;

// Where something acts on angles, a substep mends this share of the gaps that sweeps have left when they hand a tree over; and so does solve_safely, at most.
constexpr float mend_share = 0.2f;
// A call that puts a body elsewhere opens its hinges. In the next step solve_safely mends gaps at this rate, 1/s, but at most half of one in a substep, with
// what moves bodies as light as the lightest at this speed, m/s: at the usual four substeps all but 6 % of a gap is closed then. (If gaps are mended in one
// substep, a row of 15 bars that was moved by 3 m comes to 360 m/s.) A tree that is held in several places may not come so far, and gets less.
constexpr float moved_rate = 120, moved_speed = 10, moved_taut_speed = 1;

// m: a hinge that would be so far open at the end of the substep is taken to first order. Contacts may push light bodies against their tree so hard that
// without it they would turn far: Newton's passes from there diverge. (A bridge whose planks touch both banks reached 400 m/s.)
constexpr float far_open = linear_slop;

// Hinges do no work. If after a sweep the bodies of a tree have more kinetic energy than they would have without their hinges, by this share of it
// and by that of these speeds (m/s), the sweep is made anew in a way that adds none (solve_safely). Rods that whip round gain 1.7 % in a sound substep.
// Where friction acts on angles, they lose some.
constexpr float energy_gain = 0.02f, acting_energy_gain = 0.002f;
constexpr float mending_speed = 1, noise_speed = 0.01f;  // in sweeps with bias, which mend gaps, and in others
// In others of trees that are held in several places. (Made anew more often, at 0.1 m/s, a bridge of 60 planks comes apart by 5 mm under a crate that lands on
// it, at 0.3 m/s by 11 mm under one of a ton, and of 510 crates that fell on rows 7 bounced off with at least half as much energy again; with 0.3 m/s, none.
// With 0.6 m/s, rows whose holders are a hair too far apart gain speed.)
constexpr float taut_speed = 0.4f;
constexpr float spare_speed = 0.3f;  // m/s; see solve_safely

// 1 / x, or 0 where x is not above 0, as extreme masses may make it.
ISLET_SHARED float inverse(float x) { return inverse_or_zero<Lane1>(x); }

Sym2 inverse(const Sym2& a) {
    const float i = inverse(a.xx * a.yy - a.xy * a.xy);
    return {i * a.yy, -(i * a.xy), i * a.xx};
}

// The inverse of the mass matrix of a body and all that hangs on it. A body that does not turn has no angular part.
Sym3 inverse(const Sym3& a, bool turns) {
    // The linear part, which has the larger numbers, is eliminated first. What then remains of the angular part is a single number.
    const Sym2 i = inverse(Sym2{a.xx, a.xy, a.yy});
    if (!turns) return {i.xx, i.xy, 0, i.yy, 0, 0};
    const Vec2 e = {i.xx * a.xz + i.xy * a.yz, i.xy * a.xz + i.yy * a.yz};
    const float z = inverse(a.zz - a.xz * e.x - a.yz * e.y);
    return {i.xx + z * e.x * e.x, i.xy + z * e.x * e.y, -(z * e.x), i.yy + z * e.y * e.y, -(z * e.y), z};
}

ISLET_SHARED Motion3 operator*(const Sym3& m, const Motion3& f) {
    return {m.xx * f.x + m.xy * f.y + m.xz * f.turning, m.xy * f.x + m.yy * f.y + m.yz * f.turning, m.xz * f.x + m.yz * f.y + m.zz * f.turning};
}
Vec2 operator*(const Sym2& m, Vec2 v) { return {m.xx * v.x + m.xy * v.y, m.xy * v.x + m.yy * v.y}; }

// Velocity of the point at `arm`.
Vec2 at_point(const Motion3& m, Vec2 arm) { return m.linear() + cross(m.turning, arm); }

// S = J m J^T for a point at `arm` of a body with the inverse mass matrix m.
Sym2 point_of(const Sym3& m, Vec2 arm) {
    const Motion3 x = m * Motion3{1, 0, -arm.y};
    const Motion3 y = m * Motion3{0, 1, arm.x};
    const Vec2 vx = at_point(x, arm), vy = at_point(y, arm);
    return {vx.x, vx.y, vy.y};
}

// Adds J^T s J to the parent's mass matrix: the effective mass s of a hinge and all below it, as the parent feels it.
ISLET_SHARED void hang(Sym3& m, const Sym2& s, Vec2 arm) {
    const Vec2 u = s * Vec2{-arm.y, arm.x};
    m.xx += s.xx;
    m.xy += s.xy;
    m.yy += s.yy;
    m.xz += u.x;
    m.yz += u.y;
    m.zz += dot(u, Vec2{-arm.y, arm.x});
}

// The same for a hinge whose angle is held: s has an angular part.
ISLET_SHARED void hang(Sym3& m, const Sym3& s, Vec2 arm) {
    hang(m, Sym2{s.xx, s.xy, s.yy}, arm);
    m.xz += s.xz;
    m.yz += s.yz;
    m.zz += s.zz + 2 * (s.yz * arm.x - s.xz * arm.y);
}

ISLET_SHARED Vec2 turned_arm(const SolverBody& b, Vec2 arm) { return turned(b.dq, arm.x, arm.y); }

// Adds to the velocity of a link's body, and notes it, to be taken back.
ISLET_SHARED void add(SolverBody& b, TreeLink& l, Vec2 dv, float dw) {
    if (!is_positive(b.inv_mass)) return;  // no thread may write to it
    l.dv += dv;
    l.dw += dw;
    b.v += dv;
    b.w += dw;
}

// Takes back what the tree did to the velocities in the last substep, so that the tree is solved from the velocities that bodies would have without it. The
// angles' impulses stay: they change little from substep to substep, and tell which angles are held.
void take_back(SolverBody* bodies, TreeLink* links, std::uint32_t count) {
    for (std::uint32_t k = 0; k < count; ++k) {
        TreeLink& l = links[k];
        l.lambda.x = l.lambda.y = 0;
        if (!is_positive(bodies[l.child].inv_mass)) continue;
        bodies[l.child].v -= l.dv;
        bodies[l.child].w -= l.dw;
        l.dv = {0, 0};
        l.dw = 0;
    }
    for (std::uint32_t k = 0; k < count; ++k) {
        TreeLink& l = links[k];
        if (!has_exact_angles || !l.acts) continue;
        add(bodies[l.child], l, {0, 0}, bodies[l.child].inv_inertia * l.lambda.turning);
        if (l.up != null_index) add(bodies[l.parent], links[l.up], {0, 0}, -(bodies[l.parent].inv_inertia * l.lambda.turning));
    }
}

// Where the hinge's point on a body will be, from the body's centre when the step began.
Vec2 point_at_end(const SolverBody& b, Vec2 arm, float h) {
    const float turn = within_bounds(b.dq + h * b.w, 0.5f * pi);
    return b.dp + h * b.v + turned(turn, arm.x, arm.y);
}

// The velocity that the hinge lacks: -Cdot, in sweeps with bias what keeps it from (1 - rate h) C at the end of the substep, to first order or exactly.
Vec2 missing(const TreeLink& l, const SolverBody& c, const SolverBody& p, const JointSweep& n, bool linear) {
    if (!n.biased) return p.v + cross(p.w, l.arm_p) - c.v - cross(c.w, l.arm_c);
    const Vec2 gap = l.d + c.dp - p.dp + l.arm_c - l.arm_p;
    if (linear) return p.v + cross(p.w, l.arm_p) - c.v - cross(c.w, l.arm_c) - n.tree_rate * gap;
    const Vec2 end = l.d + point_at_end(c, l.rc, n.h) - point_at_end(p, l.rp, n.h);
    return n.inv_h * ((1 - n.h * n.tree_rate) * gap - end);
}

// True if static or kinematic bodies hold the tree in several places. The hinges that do so come first.
bool is_taut(const SolverBody* bodies, const TreeLink* links) { return links[0].joint != null_index && !is_positive(bodies[links[0].child].inv_mass); }

// True if a call has put a body of the tree elsewhere.
ISLET_APART bool is_moved(const TreeLink* links, std::uint32_t count) {
    bool moved = false;
    for (std::uint32_t k = 0; k < count; ++k) moved = moved || links[k].moved;
    return moved;
}

// The mass of the lightest body of the tree.
ISLET_APART float lightest_of(const SolverBody* bodies, const TreeLink* links, std::uint32_t count) {
    float lightest = 3.0e38f;
    for (std::uint32_t k = 0; k < count; ++k)
        if (is_positive(bodies[links[k].child].inv_mass)) lightest = min(lightest, inverse(bodies[links[k].child].inv_mass));
    return lightest;
}

// Lets the next sweep fill in the factors anew.
ISLET_SHARED void forget_factors(TreeLink* links) { links[0].arm_c.x = __builtin_nanf(""); }

// Fills in the factors, from the leaves to the roots, if any arm has turned since they were filled in, or if they are `stale`.
void factor(const SolverBody* bodies, TreeLink* links, std::uint32_t count, bool stale) {
    for (std::uint32_t k = 0; k < count; ++k) {
        TreeLink& l = links[k];
        const Vec2 arm_c = turned_arm(bodies[l.child], l.rc), arm_p = turned_arm(bodies[l.parent], l.rp);
        stale = stale || !(arm_c == l.arm_c && arm_p == l.arm_p);
        l.arm_c = arm_c;
        l.arm_p = arm_p;
    }
    if (!stale) return;
    const float heavy = is_taut(bodies, links) ? ground_ratio * lightest_of(bodies, links, count) : 0.0f;
    for (std::uint32_t k = 0; k < count; ++k) links[k].mass = {};
    for (std::uint32_t k = 0; k < count; ++k) {
        TreeLink& l = links[k];
        const SolverBody& c = bodies[l.child];
        l.s = {};
        if (!is_positive(c.inv_mass)) {
            l.inv_mass = {};
            l.s.xx = l.s.yy = heavy;
            if (l.is_held()) l.s.zz = heavy * bodies[l.parent].inv_mass * inverse(bodies[l.parent].inv_inertia);
        } else {
            const float mass = inverse(c.inv_mass);
            l.mass.xx += mass;
            l.mass.yy += mass;
            l.mass.zz += inverse(c.inv_inertia);
            if (l.is_held()) hang(l.s, l.mass, -l.arm_c);  // the hinge bears the body and all that hangs on it as if they were one
            l.inv_mass = inverse(l.mass, is_positive(c.inv_inertia) && !l.capped);
            if (l.joint == null_index) continue;
            if (!l.is_held()) {
                const Sym2 s = inverse(point_of(l.inv_mass, l.arm_c));
                l.s.xx = s.xx;
                l.s.xy = s.xy;
                l.s.yy = s.yy;
            }
        }
        if (l.up == null_index) continue;
        if (l.is_held()) {
            hang(links[l.up].mass, l.s, l.arm_p);
        } else {
            hang(links[l.up].mass, Sym2{l.s.xx, l.s.xy, l.s.yy}, l.arm_p);
        }
    }
}

// Builds for speed have a copy of the passes for trees on whose angles nothing acts (`bridge` takes 1.15 times the instructions without). On the web, what is
// loaded counts more.
#if defined(__OPTIMIZE_SIZE__) || defined(__wasm__)
constexpr bool has_plain_copy = false;
#else
constexpr bool has_plain_copy = has_exact_angles;
#endif

// Fills in what velocity each hinge lacks, and returns the largest part of it.
template <bool angles>
float look(const SolverBody* bodies, TreeLink* links, std::uint32_t count, const JointSweep& n, bool linear) {
    float most = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
        TreeLink& l = links[k];
        l.pull = {0, 0, 0};
        if (l.joint == null_index) continue;
        const SolverBody &c = bodies[l.child], &p = bodies[l.parent];
        const Vec2 b = missing(l, c, p, n, linear);
        most = max(most, max(abs(b.x), abs(b.y)));
        l.b = {b.x, b.y, 0};
        if (!angles || !l.is_held()) continue;
        l.b.turning = l.sign * l.angle_held.speed - (c.w - p.w);
        most = max(most, abs(l.b.turning));
    }
    return most;
}

// The impulse with which a hinge gains b.
template <bool angles = true>
ISLET_SHARED Motion3 impulse_of(const TreeLink& l) {
    if (angles && l.is_held()) return l.s * l.b;
    const Vec2 p = Sym2{l.s.xx, l.s.xy, l.s.yy} * l.b.linear();
    return {p.x, p.y, 0};
}

// Finds the impulses that give the hinges what they lack, and what these do to the bodies. Where nothing acts on angles, it applies them.
template <bool angles>
void push(SolverBody* bodies, TreeLink* links, std::uint32_t count, bool acts) {
    if constexpr (!angles) acts = false;
    // From the leaves to the roots.
    for (std::uint32_t k = 0; k < count; ++k) {
        TreeLink& l = links[k];
        if (l.joint == null_index) continue;
        const Motion3 change = l.inv_mass * l.pull;
        const Vec2 at = at_point(change, l.arm_c);
        l.b = {l.b.x - at.x, l.b.y - at.y, angles ? l.b.turning - change.turning : 0};
        if (l.up == null_index) continue;
        const Motion3 lambda = impulse_of<angles>(l);
        Motion3& pull = links[l.up].pull;
        pull.x -= lambda.x;
        pull.y -= lambda.y;
        pull.turning -= cross(l.arm_p, lambda.linear()) + (angles ? lambda.turning : 0);
    }
    // From the roots back to the leaves.
    for (std::uint32_t k = count; k-- > 0;) {
        TreeLink& l = links[k];
        Motion3 force = l.pull;
        if (l.joint != null_index) {
            if (l.up != null_index) {
                const Motion3& change = links[l.up].change;
                const Vec2 at = at_point(change, l.arm_p);
                l.b = {l.b.x + at.x, l.b.y + at.y, angles ? l.b.turning + change.turning : 0};
            }
            const Motion3 lambda = impulse_of<angles>(l);
            force.x += lambda.x;
            force.y += lambda.y;
            force.turning += cross(l.arm_c, lambda.linear()) + (angles ? lambda.turning : 0);
            if (!acts) {
                l.lambda.x += lambda.x;
                l.lambda.y += lambda.y;
            }
        }
        l.change = l.inv_mass * force;
        if (!acts) add(bodies[l.child], l, l.change.linear(), l.change.turning);
    }
}

// Finds how much of what `push` found its tree can have before a held angle's impulse comes to an end of its range, at most all of it.
ISLET_APART void share_room(TreeLink* links, std::uint32_t count) {
    for (std::uint32_t k = 0; k < count; ++k) {
        TreeLink& l = links[k];
        l.room = l.share = 1;
        if (!l.is_held()) continue;
        const float gain = l.sign * impulse_of(l).turning, so_far = l.sign * l.lambda.turning;
        if (gain != 0) l.room = l.share = min(((gain > 0 ? l.angle_held.most : l.angle_held.least) - so_far) / gain, 1.0f);
    }
    for (std::uint32_t k = 0; k < count; ++k)
        if (links[k].up != null_index) links[links[k].up].share = min(links[links[k].up].share, links[k].share);
    for (std::uint32_t k = count; k-- > 0;)
        if (links[k].up != null_index) links[k].share = links[links[k].up].share;
}

// Applies that much. What has come to an end of its range is held no longer.
void apply(SolverBody* bodies, TreeLink* links, std::uint32_t count) {
    for (std::uint32_t k = 0; k < count; ++k) {
        TreeLink& l = links[k];
        if (l.joint != null_index) {
            const Motion3 lambda = impulse_of(l);
            l.lambda.x += l.share * lambda.x;
            l.lambda.y += l.share * lambda.y;
            if (l.share < 1 && l.is_held() && l.room <= l.share) {
                l.held = false;
                l.lambda.turning = l.sign * (l.sign * lambda.turning > 0 ? l.angle_held.most : l.angle_held.least);
            } else if (l.is_held()) {
                l.lambda.turning += l.share * lambda.turning;
            }
        }
        add(bodies[l.child], l, l.share * l.change.linear(), l.share * l.change.turning);
    }
}

ISLET_SHARED float angle_now(const TreeLink& l, const SolverBody& c, const SolverBody& p) { return l.angle + l.sign * (c.dq - p.dq); }

// Decides which angles are held, where that is open: before the first pass, and in trees whose last pass came to no end of a range. In a last pass none is
// held where that is still open, so that at least the points hold. Returns true if any began or ended to be held.
ISLET_APART bool hold_angles(const SolverBody* bodies, TreeLink* links, std::uint32_t count, const Joint* joints, const JointSweep& n, bool first, bool last) {
    bool changed = false;
    for (std::uint32_t k = 0; k < count; ++k) {
        TreeLink& l = links[k];
        if (!l.acts) continue;
        const bool whole = l.share == 1, before = l.held;
        const SolverBody &c = bodies[l.child], &p = bodies[l.parent];
        if ((last && !whole) || l.capped || (l.up != null_index && links[l.up].capped)) {
            l.held = false;
        } else if (first || whole) {
            const Joint& j = joints[l.joint];
            const AngleLaw law = angle_law(j, angle_now(l, c, p), n);
            l.held = find_held(l.angle_held, law, (j.flags & joint_limit) != 0, l.sign * l.lambda.turning, l.sign * (c.w - p.w), whole);
        }
        changed = changed || l.held != before;
    }
    return changed;
}

// True if something acts on angles; then all is made ready to decide which are held.
bool begin_angles(TreeLink* links, std::uint32_t count, const JointSweep& n) {
    bool acts = false;
    for (std::uint32_t k = 0; has_exact_angles && k < count; ++k) acts = acts || links[k].acts;
    for (std::uint32_t k = 0; acts && k < count; ++k) {
        links[k].share = n.biased ? 0.0f : 1.0f;
        links[k].capped = false;
    }
    return acts;
}

// Stops bodies at the most that they may turn, as the end of the substep does, so that their hinges hold nevertheless. Returns true if it did, or if a tree
// came to an end of a range.
ISLET_APART bool cap_turning(SolverBody* bodies, TreeLink* links, std::uint32_t count, const JointSweep& n) {
    bool changed = false;
    for (std::uint32_t k = 0; k < count; ++k) {
        TreeLink& l = links[k];
        SolverBody& c = bodies[l.child];
        changed = changed || l.share < 1;
        if (l.share < 1 || !(abs(c.w) > n.max_turn)) continue;
        add(c, l, {0, 0}, within_bounds(c.w, n.max_turn) - c.w);
        l.capped = changed = true;
    }
    return changed;
}

// Starts from an impulse p and an angular impulse of the last substep, and notes what they do, to be taken back.
ISLET_SHARED void start_from(SolverBody& b, TreeLink& l, Vec2 arm, Vec2 p, float turning) {
    if (!is_positive(b.inv_mass)) return;
    turning += cross(arm, p);
    add_warm_start(b, p, turning);
    l.dv += b.inv_mass * p;
    l.dw += b.inv_inertia * turning;
}

// Twice the energy that hinges gave the bodies beyond a share of what these had, and that of a speed.
ISLET_APART float gained_energy(const SolverBody* bodies, const TreeLink* links, std::uint32_t count, float share, float speed) {
    float gain = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
        const TreeLink& l = links[k];
        const SolverBody& c = bodies[l.child];
        const float free_w = c.w - l.dw;
        gain += inverse(c.inv_mass) * (length_squared(c.v) - (1 + share) * length_squared(c.v - l.dv) - speed * speed) +
                inverse(c.inv_inertia) * (c.w * c.w - (1 + share) * free_w * free_w);
    }
    return gain;
}

// Makes passes until the hinges hold; in a sweep with bias, where the substep ends, or there to first order. Returns whether something acts on angles.
ISLET_APART bool make_passes(SolverBody* bodies, TreeLink* links, std::uint32_t count, const Joint* joints, JointSweep n, std::uint32_t most_passes,
                             bool first_order) {
    constexpr float close = 1.0e-6f;  // m
    const bool acts = begin_angles(links, count, n);
    if (acts) most_passes = 24;
    if (acts) n.tree_rate *= mend_share;
    // Angles are sought with the error to first order: a poor guess of what is held may turn bodies too fast for more.
    bool linear = acts, stale = false;
    float before = 0;  // what was lacking before the last pass
    for (std::uint32_t pass = 0; pass < most_passes; ++pass) {
        if (has_exact_angles && acts) stale = hold_angles(bodies, links, count, joints, n, pass == 0, pass + 1 == most_passes) || stale;
        linear = first_order || (linear && (pass == 0 || stale));
        if (pass == 0 || stale) factor(bodies, links, count, stale);
        const bool plain = has_plain_copy && !acts;
        const float lacking = plain ? look<!has_plain_copy>(bodies, links, count, n, linear) : look<true>(bodies, links, count, n, linear);
        if (pass > 0 && !stale && !(lacking * n.h > close)) break;
        // The first guess, and one that a pass has made worse.
        if (!acts && n.biased && lacking * n.h > far_open && (pass == 0 || lacking > before)) look<true>(bodies, links, count, n, true);
        before = lacking;
        plain ? push<!has_plain_copy>(bodies, links, count, false) : push<true>(bodies, links, count, acts);
        if (!has_exact_angles || !acts) continue;
        share_room(links, count);
        apply(bodies, links, count);
        stale = cap_turning(bodies, links, count, n);
    }
    return acts;
}

// Mends a share of the gaps as far as twice the energy `most` goes. The hinges' velocities are right, and stay so: what mends gaps is at right angles to them,
// in the metric of the masses, so the energies add up.
ISLET_APART void mend_gaps(SolverBody* bodies, TreeLink* links, std::uint32_t count, JointSweep n, bool acts, float gap_share, float most) {
    n.tree_rate *= gap_share;
    look<true>(bodies, links, count, n, true);
    push<true>(bodies, links, count, true);
    float needed = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
        const SolverBody& c = bodies[links[k].child];
        const Motion3& change = links[k].change;
        needed += inverse(c.inv_mass) * length_squared(change.linear()) + inverse(c.inv_inertia) * change.turning * change.turning;
    }
    const float share = needed > most ? sqrt(max(most, 0.0f) / needed) : 1.0f;
    if (acts) share_room(links, count);
    for (std::uint32_t k = 0; k < count; ++k) links[k].share = acts ? min(links[k].share, share) : share;
    apply(bodies, links, count);
}

// Solves the tree anew, to first order and without more energy: making the hinges' velocities right takes some from the bodies, and gaps are mended with no
// more than that. They may take besides what moves bodies as light as the lightest of these at spare_speed, so that gaps close where nothing moves. (Without
// that bound, gaps in a rope of ten hinges with friction under 300 times its links' mass throw the mass up, and open again.) A tree that is held in several
// places takes several passes in a relaxing sweep: one from nothing does not bear its load. Factors may be those of bodies that were stopped as they turned
// (cap_turning). Impulses found with these were too large for bodies that turn, and threw them in the next step.
ISLET_APART void solve_safely(SolverBody* bodies, TreeLink* links, std::uint32_t count, const Joint* joints, const JointSweep& n) {
    for (std::uint32_t k = 0; k < count; ++k) links[k].lambda.turning = 0;
    take_back(bodies, links, count);
    forget_factors(links);
    JointSweep still = n;
    still.tree_rate = 0;
    const bool acts = make_passes(bodies, links, count, joints, still, is_taut(bodies, links) && !n.biased ? 5 : 1, true);
    if (!n.biased) return;
    const bool moved = is_moved(links, count);
    const float fastest = !moved ? spare_speed : is_taut(bodies, links) ? moved_taut_speed : moved_speed;
    const float spare = static_cast<float>(count) * lightest_of(bodies, links, count) * fastest * fastest;
    mend_gaps(bodies, links, count, n, acts, moved ? min(moved_rate * n.h, 0.5f) : mend_share, spare - gained_energy(bodies, links, count, 0, 0));
}

// Calls visit(its first link, how many it has) tree by tree. The root is the last link of its tree, and the only one with none above it.
template <class Visit>
ISLET_ALWAYS_INLINE inline void for_each_tree(TreeLink* links, std::uint32_t count, Visit&& visit) {
    for (std::uint32_t first = 0, end; first < count; first = end) {
        for (end = first + 1; links[end - 1].up != null_index; ++end) {}
        visit(links + first, end - first);
    }
}

}  // namespace

void prepare_trees(const Plan& plan, const Batch& batch, TreeLink* links, const JointInput& in, SolverMotion* motions) {
    for (std::uint32_t i = batch.first_link; i < batch.first_link + batch.link_count; ++i) {
        TreeLink& l = links[i] = TreeLink{};
        const PlannedLink link = plan.links[i];
        l.child = in.slot_of[link.body];
        l.up = plan.parent_links[i];
        l.joint = link.joint;
        const float inv_inertia = in.poses[link.body].inv_inertia;
        const float light = plan.lightness != nullptr ? plan.lightness[link.body] : 1.0f;
        if (is_positive(inv_inertia)) motions[l.child].angular_factor *= in.bodies[l.child].inv_inertia / (light * inv_inertia);
        if (l.joint == null_index) continue;
        const Joint& j = in.joints[l.joint];
        const JointPose p = pose_of(j, in.poses, in.bodies_in);
        const bool is_b = j.body_b == link.body;
        l.parent = in.slot_of[is_b ? j.body_a : j.body_b];
        l.moved = (j.flags & joint_moved) != 0;
        l.sign = is_b ? 1.0f : -1.0f;
        l.rc = is_b ? p.rb : p.ra;
        l.rp = is_b ? p.ra : p.rb;
        l.d = l.sign * p.d;
        l.acts = has_exact_angles && coordinate_parts(j) != 0;
        l.angle = l.acts ? unwrap(angle_of(p), j.coordinate) : rough_coordinate(j, p);
        if (!l.acts) continue;
        l.lambda.turning = (in.numbers.warm * l.sign) * coordinate_impulse(j);
        if ((j.flags & joint_limit) == 0) {  // a weaker motor or less friction has no room for all of it
            JointSweep n;
            n.h = in.numbers.h;
            l.lambda.turning = within_bounds(l.lambda.turning, angle_law(j, l.angle, n).drive(-no_bound, 1));
        }
    }
    // Contacts are solved before the trees. They must not find bodies in free fall which the trees hold.
    for_each_tree(links + batch.first_link, batch.link_count, [&](TreeLink* tree, std::uint32_t count) {
        for (std::uint32_t k = 0; k < count; ++k) {
            TreeLink& l = tree[k];
            if (l.joint == null_index) continue;
            const Vec2 p = (in.numbers.warm * l.sign) * in.joints[l.joint].impulse;
            start_from(in.bodies[l.child], l, l.rc, p, l.lambda.turning);
            if (l.up != null_index) start_from(in.bodies[l.parent], tree[l.up], l.rp, -p, -l.lambda.turning);
        }
    });
}

void solve_trees(SolverBody* bodies, TreeLink* links, std::uint32_t link_count, const Joint* joints, const JointSweep& n) {
    for_each_tree(links, link_count, [&](TreeLink* tree, std::uint32_t count) {
        if (n.biased) take_back(bodies, tree, count);
        const bool acts = make_passes(bodies, tree, count, joints, n, n.biased ? 5 : 1, false);
        const float speed = n.biased ? mending_speed : is_taut(bodies, tree) ? taut_speed : noise_speed;
        const float gain = gained_energy(bodies, tree, count, acts ? acting_energy_gain : energy_gain, speed);
        if (gain > 0) solve_safely(bodies, tree, count, joints, n);
    });
}

namespace {

// A hinge that a call has opened counts as opened while it closes. (If something is in the way, it gets no more energy to close with.)
void note_closing(Joint& j, const TreeLink& l, const SolverBody& c, const SolverBody& p, float dt) {
    const float before = length(l.d + l.rc - l.rp), now = length(l.d + point_at_end(c, l.rc, 0) - point_at_end(p, l.rp, 0));
    if (!(now > closed_gap && before - now > spare_speed * dt)) j.flags &= ~std::uint32_t{joint_moved};
}

}  // namespace

void store_trees(const TreeLink* links, std::uint32_t count, const JointOutput& out) {
    for (std::uint32_t k = 0; k < count; ++k) {
        const TreeLink& l = links[k];
        if (l.joint == null_index) continue;
        Joint& j = out.joints[l.joint];
        if ((j.flags & joint_torn) != 0) continue;
        if (!out.ends) {
            if (!j.can_break()) continue;
            Joint borne = j;
            borne.force_impulse = l.sign * l.lambda.linear();
            borne.torque_impulse = l.sign * l.lambda.turning;
            note_torn(j, borne, out);
            continue;
        }
        const SolverBody &c = out.solved[l.child], &p = out.solved[l.parent];
        j.impulse = j.force_impulse = l.sign * l.lambda.linear();
        j.torque_impulse = l.sign * l.lambda.turning + 0.0f;
        j.coordinate = angle_now(l, c, p);
        if (l.moved) note_closing(j, l, c, p, out.dt);
        if (has_exact_angles && l.acts) {
            JointSweep n;
            n.h = out.h;
            store_angle(j, angle_law(j, j.coordinate, n), l.is_held() ? l.angle_held.speed : l.sign * (c.w - p.w), out);
        }
        forget_unsound(j);
        const bool is_b = l.sign > 0;
        add_stretch(out, l.child, is_b ? j.body_b : j.body_a, l.rc, is_b ? j.impulse : -j.impulse);
        add_stretch(out, l.parent, is_b ? j.body_a : j.body_b, l.rp, is_b ? -j.impulse : j.impulse);
    }
}

void link_tree_solve() {}

}  // namespace islet::detail
