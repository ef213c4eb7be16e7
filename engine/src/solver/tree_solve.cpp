#include "../exact.hpp"

#include "../solver/tree_solve.hpp"

#include "../constraint/revolute_joint.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

namespace {

// A tree is eliminated towards one of its holds. At any other it hangs on a body so many times as heavy as the one that it is tied to: passes make up for the
// difference, and a chain that is taut between two holds, whose hinges then need more of each other than there is, gives way a little. (A bridge of 60 planks,
// flat, with 200 times a plank's weight on it: 7 mm a hinge at 100, 1.5 mm at 1000, 0.3 mm at 10 000.)
constexpr float ground_ratio = 1000;

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

Motion3 operator*(const Sym3& m, const Motion3& f) {
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
void hang(Sym3& m, const Sym2& s, Vec2 arm) {
    const Vec2 u = s * Vec2{-arm.y, arm.x};
    m.xx += s.xx;
    m.xy += s.xy;
    m.yy += s.yy;
    m.xz += u.x;
    m.yz += u.y;
    m.zz += dot(u, Vec2{-arm.y, arm.x});
}

ISLET_SHARED Vec2 turned_arm(const SolverBody& b, Vec2 arm) { return turned(b.dq, arm.x, arm.y); }

// Takes back what the tree did to the velocities in the last substep, so that the tree is solved from the velocities that bodies would have without it.
void take_back(SolverBody* bodies, TreeLink* links, std::uint32_t count) {
    for (std::uint32_t k = 0; k < count; ++k) {
        TreeLink& l = links[k];
        l.lambda = {0, 0};
        if (!(bodies[l.child].inv_mass > 0)) continue;  // no thread may write to it
        bodies[l.child].v -= l.dv;
        bodies[l.child].w -= l.dw;
        l.dv = {0, 0};
        l.dw = 0;
    }
}

// Where the hinge's point on a body will be, from the body's centre when the step began.
Vec2 point_at_end(const SolverBody& b, Vec2 arm, float h) {
    const float turn = within_bounds(b.dq + h * b.w, 0.5f * pi);
    return b.dp + h * b.v + turned(turn, arm.x, arm.y);
}

// The velocity that the hinge lacks: -Cdot, in sweeps with bias what keeps it from (1 - rate h) C at the end of the substep.
Vec2 missing(const TreeLink& l, const SolverBody& c, const SolverBody& p, const JointSweep& n) {
    if (!n.biased) return p.v + cross(p.w, l.arm_p) - c.v - cross(c.w, l.arm_c);
    const Vec2 gap = l.d + c.dp - p.dp + l.arm_c - l.arm_p;
    const Vec2 end = l.d + point_at_end(c, l.rc, n.h) - point_at_end(p, l.rp, n.h);
    return n.inv_h * ((1 - n.h * n.tree_rate) * gap - end);
}

// Fills in the factors, from the leaves to the roots, if any arm has turned since they were filled in.
void factor(const SolverBody* bodies, TreeLink* links, std::uint32_t count) {
    bool turned = false;
    for (std::uint32_t k = 0; k < count; ++k) {
        TreeLink& l = links[k];
        const Vec2 arm_c = turned_arm(bodies[l.child], l.rc), arm_p = turned_arm(bodies[l.parent], l.rp);
        turned = turned || !(arm_c == l.arm_c && arm_p == l.arm_p);
        l.arm_c = arm_c;
        l.arm_p = arm_p;
    }
    if (!turned) return;
    for (std::uint32_t k = 0; k < count; ++k) links[k].mass = {};
    for (std::uint32_t k = 0; k < count; ++k) {
        TreeLink& l = links[k];
        const SolverBody& c = bodies[l.child];
        if (!(c.inv_mass > 0)) {
            const float heavy = ground_ratio * inverse(bodies[l.parent].inv_mass);
            l.inv_mass = {};
            l.s = {heavy, 0, heavy};
            hang(links[l.up].mass, l.s, l.arm_p);
            continue;
        }
        const float mass = inverse(c.inv_mass);
        l.mass.xx += mass;
        l.mass.yy += mass;
        l.mass.zz += inverse(c.inv_inertia);
        l.inv_mass = inverse(l.mass, c.inv_inertia > 0);
        if (l.joint == null_index) continue;
        l.s = inverse(point_of(l.inv_mass, l.arm_c));
        if (l.up != null_index) hang(links[l.up].mass, l.s, l.arm_p);
    }
}

// Fills in what velocity each hinge lacks, and returns the largest part of it along x or y.
float look(const SolverBody* bodies, TreeLink* links, std::uint32_t count, const JointSweep& n) {
    float most = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
        TreeLink& l = links[k];
        l.pull = {0, 0, 0};
        if (l.joint == null_index) continue;
        l.b = missing(l, bodies[l.child], bodies[l.parent], n);
        most = max(most, max(abs(l.b.x), abs(l.b.y)));
    }
    return most;
}

// Applies the impulses that give the hinges what they lack.
void push(SolverBody* bodies, TreeLink* links, std::uint32_t count) {
    // From the leaves to the roots.
    for (std::uint32_t k = 0; k < count; ++k) {
        TreeLink& l = links[k];
        if (l.joint == null_index) continue;
        l.b -= at_point(l.inv_mass * l.pull, l.arm_c);
        if (l.up == null_index) continue;
        const Vec2 lambda = l.s * l.b;
        Motion3& pull = links[l.up].pull;
        pull.x -= lambda.x;
        pull.y -= lambda.y;
        pull.turning -= cross(l.arm_p, lambda);
    }
    // From the roots back to the leaves.
    for (std::uint32_t k = count; k-- > 0;) {
        TreeLink& l = links[k];
        Motion3 force = l.pull;
        if (l.joint != null_index) {
            if (l.up != null_index) l.b += at_point(links[l.up].change, l.arm_p);
            const Vec2 lambda = l.s * l.b;
            l.lambda += lambda;
            force.x += lambda.x;
            force.y += lambda.y;
            force.turning += cross(l.arm_c, lambda);
        }
        if (!(bodies[l.child].inv_mass > 0)) continue;
        l.change = l.inv_mass * force;
        l.dv += l.change.linear();
        l.dw += l.change.turning;
        bodies[l.child].v += l.change.linear();
        bodies[l.child].w += l.change.turning;
    }
}

// Starts from an impulse p of the last substep, and notes what it does, to be taken back.
void start_from(SolverBody& b, TreeLink& l, Vec2 arm, Vec2 p) {
    if (!(b.inv_mass > 0)) return;
    add_warm_start(b, p, cross(arm, p));
    l.dv += b.inv_mass * p;
    l.dw += b.inv_inertia * cross(arm, p);
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
        if (inv_inertia > 0) motions[l.child].angular_factor *= in.bodies[l.child].inv_inertia / (light * inv_inertia);
        if (l.joint == null_index) continue;
        const Joint& j = in.joints[l.joint];
        const JointPose p = pose_of(j, in.poses, in.bodies_in);
        const bool is_b = j.body_b == link.body;
        l.parent = in.slot_of[is_b ? j.body_a : j.body_b];
        l.sign = is_b ? 1.0f : -1.0f;
        l.rc = is_b ? p.rb : p.ra;
        l.rp = is_b ? p.ra : p.rb;
        l.d = l.sign * p.d;
        l.angle = rough_coordinate(j, p);
    }
    // Contacts are solved before the trees. They must not find bodies in free fall which the trees hold.
    for (std::uint32_t i = batch.first_link; i < batch.first_link + batch.link_count; ++i) {
        TreeLink& l = links[i];
        if (l.joint == null_index) continue;
        const Vec2 p = (in.numbers.warm * l.sign) * in.joints[l.joint].impulse;
        start_from(in.bodies[l.child], l, l.rc, p);
        if (l.up != null_index) start_from(in.bodies[l.parent], links[batch.first_link + l.up], l.rp, -p);
    }
}

void solve_trees(SolverBody* bodies, TreeLink* links, std::uint32_t count, const JointSweep& n) {
    constexpr std::uint32_t most_passes = 5;
    constexpr float close = 1.0e-6f;  // m
    if (n.biased) take_back(bodies, links, count);
    factor(bodies, links, count);
    for (std::uint32_t pass = 0; pass < most_passes; ++pass) {
        const float lacking = look(bodies, links, count, n);
        if (pass > 0 && !(lacking * n.h > close)) break;
        push(bodies, links, count);
        if (!n.biased) break;
    }
}

void store_trees(const TreeLink* links, std::uint32_t count, const JointOutput& out) {
    for (std::uint32_t k = 0; k < count; ++k) {
        const TreeLink& l = links[k];
        if (l.joint == null_index) continue;
        Joint& j = out.joints[l.joint];
        j.impulse = j.force_impulse = l.sign * l.lambda;
        j.torque_impulse = 0;
        j.coordinate = l.angle + l.sign * (out.solved[l.child].dq - out.solved[l.parent].dq);
        forget_unsound(j);
        const bool is_b = l.sign > 0;
        add_stretch(out, l.child, is_b ? j.body_b : j.body_a, l.rc, is_b ? j.impulse : -j.impulse);
        add_stretch(out, l.parent, is_b ? j.body_a : j.body_b, l.rp, is_b ? -j.impulse : j.impulse);
    }
}

void link_tree_solve() {}

}  // namespace islet::detail
