// Bounding-box tree of the shapes at rest: those of static and of sleeping bodies.
//
// A binary tree that rotations keep in balance (AVL) while leaves come and go. An insertion follows the branch whose perimeter grows least (the surface area
// heuristic; see Catto's GDC 2019 talk on dynamic bounding volume hierarchies). Shapes in motion are not in the tree: they are sorted (pairs.cpp). So the tree
// does not change while bodies move or sleep.
#pragma once

#include "../data/records.hpp"
#include "../math/boxes.hpp"
#include "../math/inlining.hpp"
#include "../math/lanes.hpp"

namespace islet::detail {

struct Tree {
    TreeState* state;
    TreeNode* nodes;
};

/// Adds a leaf for `shape`; returns the node. There is always room, because the pool holds twice as many nodes as there are shapes.
std::uint32_t tree_insert(Tree tree, const Aabb& box, std::uint32_t shape);
void tree_remove(Tree tree, std::uint32_t leaf);
/// Null, or a sentence that says what is broken.
const char* tree_validate(Tree tree);

/// Room for a traversal: an AVL tree of 2^22 leaves is at most 1.44 * 22 = 32 levels high, and a traversal holds one node a level.
inline constexpr std::uint32_t tree_stack = 64;

/// A walk over the leaves whose boxes overlap `box`, in an order that depends on the tree.
struct TreeWalk {
    const TreeNode* nodes;
    Aabb box;
    std::uint32_t top = 0;
    std::uint32_t stack[tree_stack];

    ISLET_SHARED TreeWalk(Tree tree, const Aabb& over) : nodes(tree.nodes), box(over) {
        const std::uint32_t root = tree.state->root;
        if (root != null_index && (!has_vectors || reaches(root))) stack[top++] = root;
    }

    /// The next leaf's shape, or null_index.
    ISLET_COPIED std::uint32_t next() { return has_vectors ? next_of_reached() : next_of_all(); }

private:
    static constexpr bool has_vectors = max_lanes > 1;

    bool reaches(std::uint32_t node) const { return meet_at_once(nodes[node].box, box); }

    // The stack holds nodes whose boxes are still to be tested.
    std::uint32_t next_of_all() {
        while (top > 0) {
            const TreeNode& node = nodes[stack[--top]];
            if (!meet(node.box, box)) continue;
            if (node.child1 == null_index) return node.child2;
            stack[top++] = node.child2;
            stack[top++] = node.child1;
        }
        return null_index;
    }

    // The stack holds nodes whose boxes overlap. Where a box is tested without a branch, testing both children at once is faster.
    std::uint32_t next_of_reached() {
        while (top > 0) {
            const TreeNode* node = &nodes[stack[--top]];
            for (;;) {
                if (node->child1 == null_index) return node->child2;
                const bool first = reaches(node->child1), second = reaches(node->child2);
                if (second) stack[top++] = node->child2;
                if (!first) break;
                node = &nodes[node->child1];
            }
        }
        return null_index;
    }
};

/// Calls visit(shape) for every leaf whose box `reaches` accepts, in an order that depends on the tree. If `reaches` accepts a box, it must accept all boxes
/// that contain it; it may accept fewer boxes as the walk goes on.
template <class Reaches, class Visit>
void tree_search(Tree tree, Reaches&& reaches, Visit&& visit) {
    std::uint32_t stack[tree_stack];
    std::uint32_t top = 0;
    if (tree.state->root != null_index) stack[top++] = tree.state->root;
    while (top > 0) {
        const TreeNode& node = tree.nodes[stack[--top]];
        if (!reaches(node.box)) continue;
        if (node.child1 == null_index) {
            visit(node.child2);
            continue;
        }
        stack[top++] = node.child2;
        stack[top++] = node.child1;
    }
}

/// Calls visit(shape) for every leaf whose box overlaps `box`.
template <class Visit>
void tree_query(Tree tree, const Aabb& box, Visit&& visit) {
    TreeWalk walk(tree, box);
    for (std::uint32_t shape = walk.next(); shape != null_index; shape = walk.next()) visit(shape);
}

}  // namespace islet::detail
