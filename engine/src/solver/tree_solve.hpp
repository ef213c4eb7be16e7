// Joint trees, solved exactly.
//
// Let a body with velocity v (linear and angular) have the mass matrix M, and a hinge from a parent p to a child c the rows
//     Cdot = (vc + wc x rc) - (vp + wp x rp) = Jc vc - Jp vp
// The solve finds impulses lambda such that every hinge of the tree has Cdot = -rate C after
//     M dv = Jc^T lambda - (sum over its children) Jp^T lambda.
// Eliminating a leaf leaves a smaller problem of the same kind. Let Mc and fc be the mass matrix and the force of a child with all that hangs on it:
//     S = Jc Mc^-1 Jc^T,  lambda = S^-1 (b + Jp dvp),  b = -(Cdot + rate C) - Jc Mc^-1 fc
//     Mp += Jp^T S^-1 Jp,  fp -= Jp^T S^-1 b
// At last the root finds its own velocity, and on the way back every child finds its hinge's lambda and its own velocity. The cost is linear in the number of
// bodies, there is no iteration, and no mass ratio harms it. (Baraff, "Linear-Time Dynamics using Lagrange Multipliers", 1996; Featherstone's articulated
// bodies.)
//
// Exact impulses, held over a substep, pull a light link under tension back and forth like a string. They are stable only while h^2 times the geometric
// stiffness, the sum of r . f, is small beside the link's inertia. Where it is not, the body already has more inertia (stiffened() in free_motion.hpp), and
// its spin is scaled as implicit Euler does, (I + h^2 k) w+ = I w + ... (Tournier and others, "Stable Constrained Dynamics", 2015). Measured on a chain of 30
// links with a ball of 1000 link masses that swings for 20 s from level: the hinges stay within 0.03 mm, and the first swing loses 1.4 % of its energy;
// without the scaling the chain explodes.
//
// A sweep with bias starts from the velocities as they would be without the tree, and solves the tree anew, with the arms of the substep's beginning, for
// hinges that hold at the substep's end: passes with the same factors come ever closer (within 1e-6 m, mostly after the second). The relaxing sweep gives the
// hinges' points equal velocities with the arms as they are then. So a tree moves by RATTLE, which keeps momentum, and energy up to a bounded error. (Three
// hinged rods that turn at 10 rad/s: after 586 s momentum is off by 0.01 %. With one pass of first order, and the arcs' curve bounded, energy was seven times
// what it had been.) (Andersen, "Rattle", 1983.)
//
// Passes may come to a wrong solution, or to none: where rods under a heavy load are snapped taut, or where a tree is held in two places that are too far
// apart. And what a hinge pulls with the arms of the substep's beginning, the relaxing sweep takes back with other arms, the less exactly the harder it pulls.
// Both made energy: a load of 200 rods' mass, let go above their hinge, came to 350 times its own. So each sweep is judged by the bodies' kinetic energy. To
// solve hinges to first order is to project the velocities that bodies have without them, which never adds energy: a sweep that has added more than a little
// is made anew so, with a share of the bias. A relaxing sweep must be judged even where a tree is held in several places: what mends such a tree's gaps turns
// taut links fast, which no hinge takes back.
//
// A hinge on whose angle a limit, a motor or friction acts has a third row while its angle is held (constraint/angle_law.hpp): wc - wp = a speed that is
// known. Which angles are held is found by an active-set method. From impulses that the laws allow, each pass solves all rows, but goes only so far as the
// first held impulse comes to an end of its range; that angle is then free. A pass that went all the way looks at all angles anew. Every pass lowers the same
// energy, so no set comes twice. (Deciding on all angles after each solve, as a primal-dual method does, alternates for ever between the limits of a chain.)
// Bodies of such a tree are stopped at the fastest that any body may turn while the tree is solved; stopped after that, they came off their hinges by 18 mm.
//
// The impulses of the last substep are only a start for the contacts, which are solved before the trees.
#pragma once

#include "../constraint/angle_law.hpp"
#include "../constraint/joint_rows.hpp"
#include "../island/batches.hpp"

namespace islet::detail {

/// A symmetric matrix.
struct Sym2 {
    float xx = 0, xy = 0, yy = 0;
};
struct Sym3 {
    float xx, xy, xz, yy, yz, zz;
};

/// A force over the substep (N s, N m s) or a velocity (m/s, rad/s) of a body.
struct Motion3 {
    float x, y, turning;
    Vec2 linear() const { return {x, y}; }
};

/// A link (island/joint_trees.hpp) during a solve. All is seen from the child, whichever end of the joint it is.
struct TreeLink {
    std::uint32_t child = 0, parent = 0;  // solver slots
    std::uint32_t up = null_index;        // the parent's link, among the tree's; null_index: the root, whose parent cannot be pushed, or is not there
    std::uint32_t joint = null_index;     // null_index: the root of a tree that nothing holds
    float sign = 1;                       // 1: the child is the joint's B; -1: its A
    Vec2 rc, rp;                          // m, from the centres to the hinge when the step began
    Vec2 d;                               // m, from the parent's centre to the child's when the step began
    float angle = 0;                      // rad, roughly: the joint's angle when the step began
    Motion3 lambda = {0, 0, 0};           // N s, N m s on the child in this substep
    Vec2 dv;                              // m/s, what the tree's hinges have added to the child's velocity in this substep
    float dw = 0;                         // rad/s
    HeldAngle angle_held;                 // where `held`: the child's speed in the parent, as the joint counts it, and the impulses in which it is held
    float room = 1, share = 1;            // of what a pass found: what the link's angle has room for, and what its tree takes
    bool acts = false;                    // a motor, friction or a limit acts on the angle
    bool held = false;                    // the angle's speed is held
    bool capped = false;                  // the child may turn no faster
    bool moved = false;                   // a call has opened the hinge
    bool is_held() const { return has_exact_angles && held; }
    // Factors of this sweep.
    Vec2 arm_c = {__builtin_nanf(""), 0}, arm_p;  // m, rc and rp as they were when these were filled in
    union {
        Sym3 mass = {};  // of the body and of all that hangs on it, until the way from the leaves has come to the body
        Sym3 inv_mass;   // from then on
    };
    Sym3 s = {};            // S^-1; its angular part is used where the angle is held
    Motion3 b = {0, 0, 0};  // m/s, rad/s
    union {
        Motion3 pull = {0, 0, 0};  // of the children on the body, until the way back from the root has come to the body
        Motion3 change;            // from then on: what this sweep added to the body's velocity
    };
};

static_assert(sizeof(TreeLink) == tree_link_bytes);

/// Fills the links of a batch's joint trees, which are solved one by one: what one tree needs changes nothing for another.
ISLET_OPTIONAL void prepare_trees(const Plan& plan, const Batch& batch, TreeLink* links, const JointInput& in, SolverMotion* motions);
/// One sweep.
ISLET_OPTIONAL void solve_trees(SolverBody* bodies, TreeLink* links, std::uint32_t count, const Joint* joints, const JointSweep& sweep);
/// Writes back the impulses, for readers, and the stretch of the bodies, for the next step's stability.
ISLET_OPTIONAL void store_trees(const TreeLink* links, std::uint32_t count, const JointOutput& out);

/// Does nothing. A program that refers to it links the functions above.
void link_tree_solve();

}  // namespace islet::detail
