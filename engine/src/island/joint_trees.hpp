// Trees of hinges: which hinges are solved exactly, all of a tree at once, and in what order.
//
// A sweep that knows two bodies at a time needs as many passes as a chain has links to carry a load along it, and each loses the more the heavier the
// load is beside a link. Where hinges form trees they need not be swept: eliminating bodies from the leaves to the root solves them exactly in one
// pass up and one down (solver/tree_solve.hpp).
//
//   static --- link --- link --- ball        leaves first: ball, link, link
//
// Static and kinematic bodies hold a tree but are no part of it, so one that is held twice is a loop. A hinge that closes a loop is swept as ever, and so
// is one on which a spring, a limit, a motor or friction acts.
//
// Which hinges are marked follows from the joints, the masses and the setting alone, and is worked out anew when one of these has changed.
#pragma once

#include "../data/core.hpp"
#include "../graph/joint_graph.hpp"
#include "../island/union_find.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

/// Trees of hinges as they grow.
struct Forest {
    /// Of a tree, at its root.
    struct Tree {
        bool held;    // by a static or kinematic body
        bool swept;   // sweeps do better: a hinge of it closes a loop, or something acts on one
        bool loaded;  // a hinge bears so much that sweeping would not do
    };
    UnionFind sets;  // of bodies
    Tree* trees;

    Forest(std::uint32_t bodies, Arena& arena) : sets{arena.take<std::uint32_t>(bodies)}, trees(arena.take<Tree>(bodies)) {
        for (std::uint32_t i = 0; i < bodies; ++i) {
            sets.parent[i] = i;
            trees[i] = {};
        }
    }

    ISLET_SHARED static bool moves(const Core& core, std::uint32_t body) { return core.poses[body].inv_mass > 0; }

    /// Nothing acts on the hinge's angle, and no lock on its bodies, so that a tree can take it.
    static bool is_plain(const Core& core, const Joint& j) {
        const auto locked = [&](std::uint32_t body) { return (core.bodies[body].flags & (body_lock_x | body_lock_y)) != 0; };
        return (j.flags & (joint_spring | joint_limit | joint_motor)) == 0 && j.friction == 0 && !locked(j.body_a) && !locked(j.body_b);
    }

    /// The tree of a hinge that has a body which moves.
    ISLET_SHARED Tree& tree_of(const Core& core, const Joint& j) const { return trees[sets.root_of(moves(core, j.body_a) ? j.body_a : j.body_b)]; }

    /// Grows by a hinge, or returns false: a tree cannot take it, or it would close a loop, or has no body that moves.
    bool add(const Core& core, const Joint& j) const {
        const bool moves_a = moves(core, j.body_a), moves_b = moves(core, j.body_b);
        if ((!moves_a && !moves_b) || is_joint_idle(core, j)) return false;
        const std::uint32_t a = sets.root_of(moves_a ? j.body_a : j.body_b), b = sets.root_of(moves_b ? j.body_b : j.body_a);
        const bool holds = !moves_a || !moves_b;
        const bool loops = holds ? trees[a].held : a == b || (trees[a].held && trees[b].held);
        if (loops || !is_plain(core, j)) {
            trees[a].swept = trees[b].swept = true;
            return false;
        }
        trees[sets.join(a, b)] = {trees[a].held || trees[b].held || holds, trees[a].swept || trees[b].swept, false};
        return true;
    }
};

/// A body and the hinge that ties it to its parent.
struct TreeBody {
    std::uint32_t body;
    std::uint32_t joint;  // null_index: the root of a tree that nothing holds
};

/// Marks the hinges of trees that the setting wants solved exactly, if anything has changed since they were marked.
ISLET_OPTIONAL void choose_trees(Core& core, Arena temporary);

/// The bodies of all trees, or of those awake, leaves first. `out` has room for every body, or for two a joint. Returns how many.
ISLET_OPTIONAL std::uint32_t order_trees(const Core& core, bool awake, TreeBody* out, Arena temporary);

/// Does nothing, but whoever refers to it links the functions above, and plan_trees (batches.hpp).
void link_joint_trees();

}  // namespace islet::detail
