// Trees of hinges: which hinges are solved exactly, all of a tree at once, and in what order.
//
// A sweep that knows two bodies at a time needs as many passes as a chain has links to carry a load along it, and each loses the more the heavier the
// load is beside a link. Where hinges form trees they need not be swept: eliminating bodies from the leaves to the root solves them exactly in one
// pass up and one down (solver/tree_solve.hpp).
//
//   static --- link --- link --- ball        leaves first: ball, link, link
//
// Static and kinematic bodies hold a tree but are no part of it, so one that is held twice is a loop. A hinge that closes a loop is swept as ever, and so
// are springs, limits, motors and friction on the angles of a tree's hinges: they know two bodies only and not what hangs on these, so a motor in a tree
// drives worse than where all is swept (an arm of two bars turns 10 % off its speed). Left to choose, the engine takes no such trees.
//
// Which hinges are marked follows from the joints, the masses and the setting alone, and is worked out anew when one of these has changed.
#pragma once

#include "memory/core.hpp"

namespace islet::detail {

/// A body and the hinge that ties it to its parent.
struct TreeBody {
    std::uint32_t body;
    std::uint32_t joint;  // null_index: the root of a tree that nothing holds
};

/// Marks the hinges of trees that the setting wants solved exactly, if anything has changed since they were marked.
ISLET_OPTIONAL void choose_trees(Core& core, Arena temporary);

/// The bodies of all awake trees, leaves first. `out` has room for every body, or for two a joint. Returns how many.
ISLET_OPTIONAL std::uint32_t order_trees(const Core& core, TreeBody* out, Arena temporary);

/// Does nothing, but whoever refers to it links the functions above.
void link_joint_trees();

}  // namespace islet::detail
