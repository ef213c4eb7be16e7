// Joint trees: which hinges are solved exactly, all of a tree together, and in what order.
//
// A sweep looks at two bodies at a time. It needs as many passes as a chain has links to carry a load along the chain, and each pass loses the more the
// heavier the load is beside a link. Where hinges form a tree, eliminating its bodies from the leaves to the root solves them exactly, in one pass up and
// one pass down (solver/tree_solve.hpp).
//
//   static --- link --- link --- ball        leaves first: ball, link, link
//
// Static and kinematic bodies can hold a tree in several places but are no part of it, so a bridge between two banks is a tree. Hinges that close a loop of
// bodies that move are swept, and so are hinges with a spring.
//
// A tree with a limit, a motor or friction (a ragdoll) takes several passes to solve, and sweeps do well as long as it bears little. It is solved exactly
// while one of these hinges bears a heavy load (heavy_load): as it did in the last step, or as a force that was just applied to one of its bodies will make it.
//
// (But not if a swept joint, such as a weld, fixes a load of many times its mass to one of its bodies. The tree would hand the body to that joint as light as
// it is alone, and gain energy: one plank that bore 70 times its mass so whirled round at 46 m/s. Swept, it bears that with a gap of 2 cm.)
//
// The joints, the masses, the setting and these loads decide which hinges are marked. The marks are made anew when one of these has changed.
#pragma once

#include "../data/core.hpp"
#include "../graph/joint_graph.hpp"
#include "../island/union_find.hpp"
#include "../math/inlining.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

/// True for a hinge if a limit, a motor or friction acts on its angle, and no spring does.
inline bool has_acting_angle(const Joint& j) {
    const bool acts = (j.flags & (joint_limit | joint_motor)) != 0 || j.friction > 0;
    return acts && (j.flags & joint_spring) == 0 && j.joint_type() == JointType::revolute;
}

/// m/s^2: what a hinge bears is heavy from so many times the mass of its lighter body on, until it is a quarter of that. (At 60 Hz, a swept hinge then gives
/// way by 2 cm. Ragdolls that lie jammed in a heap bear a fifth of it. With 1000, blows made the heap of the scene ragdoll_pile exact, for 1.27 times the
/// instructions.)
inline constexpr float heavy_load = 2500;

/// What a hinge bears, as the acceleration that it would give to its lighter body; of the turning of its limits, a quarter, at the body's radius of gyration.
/// (With all of it, blows made a ragdoll that lands exact, which pressed a limb halfway into the floor. Without it, two planks that jut out on limits and
/// carry 100 times their mass are swept, and sag by a quarter of their length.)
ISLET_SHARED float load_of(const Core& core, const Joint& j, Vec2 force, float turning) {
    const auto given_to = [&](const Pose& p) { return (abs(force.x) + abs(force.y)) * p.inv_mass + 0.25f * abs(turning) * sqrt(p.inv_mass * p.inv_inertia); };
    return max(given_to(core.poses[j.body_a]), given_to(core.poses[j.body_b]));
}

/// Whether a hinge with an acting angle counts as loaded after a step, and for how long it has borne little, as flags. Loaded, it remains so for 15 steps in
/// which it bears little: where sweeps hand a tree over with its hinges open, closing them takes impulses of any size and sign. (Without that, ropes of hinges
/// with friction under 1000 times their links' mass changed hands every few steps, and shook for ever.)
inline constexpr std::uint32_t load_bits = joint_loaded | joint_calm_bits;
ISLET_PART std::uint32_t load_flags(const Core& core, const Joint& j) {
    if (!has_exact_angles || !has_acting_angle(j)) return j.flags & load_bits;
    const bool was = (j.flags & joint_loaded) != 0;
    const float heavy = heavy_load * core.state->last_substep;
    if (load_of(core, j, j.force_impulse, j.lower_impulse - j.upper_impulse) > (was ? 0.25f * heavy : heavy)) return joint_loaded;
    const std::uint32_t calm = (j.flags & joint_calm_bits) + joint_calm;
    return was && calm <= joint_calm_bits ? joint_loaded | calm : 0;
}

/// The flags of a joint that a step may change, as it leaves them. (Where calls have put the bodies is of no interest to what is swept; trees forget it.)
ISLET_SHARED std::uint32_t stepped_flags(const Core& core, const Joint& j) {
    return load_flags(core, j) | ((j.flags & joint_exact) != 0 ? j.flags & joint_moved : 0);
}
inline bool load_has_changed(const Core& core, const Joint& j) { return stepped_flags(core, j) != (j.flags & (load_bits | joint_moved)); }

/// Notes them.
ISLET_PART void note_load(Core& core, Joint& j) {
    const std::uint32_t now = stepped_flags(core, j);
    if (((now ^ j.flags) & joint_loaded) != 0) core.state->trees_stale = 1;
    j.flags = (j.flags & ~(load_bits | joint_moved)) | now;
}

/// A load of so many times the mass of the body that it is fixed to is many times as heavy. (Arms of ten planks on limits gained energy from 16 times on.)
inline constexpr float burden = 10;

/// Joint trees as they grow.
struct Forest {
    struct Tree {
        bool held;      // by a static or kinematic body: filled in by is_anchor, and so is
        bool taut;      // held in several places
        bool breaks;    // one of its hinges can break
        bool swept;     // sweeps do better: one of its hinges closes a loop, or has a spring
        bool loaded;    // a hinge has a load so heavy that sweeps would not carry it
        bool acted;     // a limit, a motor or friction acts on one of its hinges
        bool asked;     // one of these is heavily loaded: filled in by choose_trees, and so is
        bool burdened;  // a swept joint fixes a load of many times its mass to one of its bodies
    };
    UnionFind sets;  // of bodies
    Tree* trees;     // by root

    Forest(std::uint32_t bodies, Arena& arena) : sets{arena.take<std::uint32_t>(bodies)}, trees(arena.take<Tree>(bodies)) {
        for (std::uint32_t i = 0; i < bodies; ++i) {
            sets.parent[i] = i;
            trees[i] = {};
        }
    }

    ISLET_SHARED static bool moves(const Core& core, std::uint32_t body) { return is_positive(core.poses[body].inv_mass); }

    /// True if a tree can take the hinge: it has no spring, its bodies have no locks, and they turn if something acts on its angle.
    static bool can_take(const Core& core, const Joint& j) {
        const auto locked = [&](std::uint32_t body) { return (core.bodies[body].flags & (body_lock_x | body_lock_y)) != 0; };
        const auto turns = [&](std::uint32_t body) { return is_positive(core.poses[body].inv_inertia) || !moves(core, body); };
        return (j.flags & joint_spring) == 0 && !locked(j.body_a) && !locked(j.body_b) &&
               (!has_acting_angle(j) || (has_exact_angles && turns(j.body_a) && turns(j.body_b)));
    }

    /// The tree of a hinge, of which at least one body moves.
    ISLET_SHARED Tree& tree_of(const Core& core, const Joint& j) const { return trees[sets.root_of(moves(core, j.body_a) ? j.body_a : j.body_b)]; }

    /// Adds a hinge; returns false if a tree cannot take it, if it would close a loop, or if neither of its bodies moves.
    bool add(const Core& core, const Joint& j) const {
        const bool moves_a = moves(core, j.body_a), moves_b = moves(core, j.body_b);
        if ((!moves_a && !moves_b) || is_joint_idle(core, j)) return false;
        const std::uint32_t a = sets.root_of(moves_a ? j.body_a : j.body_b), b = sets.root_of(moves_b ? j.body_b : j.body_a);
        const bool loops = moves_a && moves_b && a == b;
        if (loops || !can_take(core, j)) {
            trees[a].swept = trees[b].swept = true;
            return false;
        }
        const bool breaks = trees[a].breaks || trees[b].breaks || j.can_break();
        const bool acted = trees[a].acted || trees[b].acted || has_acting_angle(j);
        trees[sets.join(a, b)] = {false, false, breaks, trees[a].swept || trees[b].swept, false, acted, false, false};
        return true;
    }

    /// Notes what a swept joint fixes to a body. To be called after all hinges have been added.
    void note_burden(const Core& core, const Joint& j) const {
        if (j.body_a == null_index || j.joint_type() == JointType::gear || !moves(core, j.body_a) || !moves(core, j.body_b)) return;
        const float a = core.bodies[j.body_a].mass, b = core.bodies[j.body_b].mass;
        if (max(a, b) > burden * min(a, b)) trees[sets.root_of(a < b ? j.body_a : j.body_b)].burdened = true;
    }

    /// True if a hinge of a tree holds it at a static or kinematic body, and a hinge that was asked about before does so too (joint_anchor). To be called after
    /// all hinges have been added.
    bool is_anchor(const Core& core, const Joint& j) const {
        if (moves(core, j.body_a) && moves(core, j.body_b)) return false;
        Tree& tree = tree_of(core, j);
        tree.taut = tree.held;
        tree.held = true;
        return tree.taut;
    }
};

/// A body of a joint tree and the hinge that ties it to its parent.
struct PlannedLink {
    std::uint32_t body;   // of an anchor the one that cannot be pushed
    std::uint32_t joint;  // null_index: the root of a tree that nothing holds
};

/// Marks the hinges that are to be solved exactly (joint_exact), if anything they follow from has changed since they were marked.
ISLET_OPTIONAL void choose_trees(Core& core, Arena temporary);

/// Writes the links of all joint trees, or of awake ones alone, leaves first, and returns how many there are. `out` has room for all bodies, or for two a
/// joint.
ISLET_OPTIONAL std::uint32_t order_links(const Core& core, bool awake, PlannedLink* out, Arena temporary);

/// Does nothing. A program that refers to it links the functions above, and plan_links (batches.hpp).
void link_joint_trees();

}  // namespace islet::detail
