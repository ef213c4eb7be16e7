#include "../exact.hpp"

#include "../broadphase/tree.hpp"

namespace islet::detail {

namespace {

bool is_leaf(const TreeNode& node) { return node.child1 == null_index; }

std::uint32_t take_node(Tree t) {
    std::uint32_t index = t.state->free_head;
    if (index != null_index) {
        t.state->free_head = t.nodes[index].parent;
    } else {
        index = t.state->high_water++;
    }
    t.nodes[index] = TreeNode{};
    return index;
}

void give_node(Tree t, std::uint32_t index) {
    t.nodes[index] = TreeNode{};
    t.nodes[index].parent = t.state->free_head;
    t.state->free_head = index;
}

void refit(Tree t, std::uint32_t index) {
    TreeNode& node = t.nodes[index];
    const TreeNode& a = t.nodes[node.child1];
    const TreeNode& b = t.nodes[node.child2];
    node.box = both(a.box, b.box);
    node.height = 1 + (a.height > b.height ? a.height : b.height);
}

void replace_child(Tree t, std::uint32_t parent, std::uint32_t old_child, std::uint32_t new_child) {
    if (parent == null_index) {
        t.state->root = new_child;
    } else if (t.nodes[parent].child1 == old_child) {
        t.nodes[parent].child1 = new_child;
    } else {
        t.nodes[parent].child2 = new_child;
    }
    t.nodes[new_child].parent = parent;
}

// Rotates the taller child of a node above it if the children's heights differ by more than one. Returns the root of the subtree.
//
//        a              b
//       / \            / \.
//      b   c    ->    x   a        x is the taller child of b
//     / \                / \.
//    x   y              y   c
std::uint32_t balance(Tree t, std::uint32_t ia) {
    TreeNode& a = t.nodes[ia];
    const std::uint32_t h1 = t.nodes[a.child1].height;
    const std::uint32_t h2 = t.nodes[a.child2].height;
    if (h1 <= h2 + 1 && h2 <= h1 + 1) return ia;
    const bool first = h1 > h2;
    const std::uint32_t ib = first ? a.child1 : a.child2;
    TreeNode& b = t.nodes[ib];
    const bool keep_first = t.nodes[b.child1].height > t.nodes[b.child2].height;
    const std::uint32_t keep = keep_first ? b.child1 : b.child2;
    const std::uint32_t move = keep_first ? b.child2 : b.child1;

    replace_child(t, a.parent, ia, ib);
    b.child1 = keep;
    b.child2 = ia;
    a.parent = ib;
    (first ? a.child1 : a.child2) = move;
    t.nodes[move].parent = ia;
    refit(t, ia);
    refit(t, ib);
    return ib;
}

void refit_upwards(Tree t, std::uint32_t index) {
    while (index != null_index) {
        index = balance(t, index);
        refit(t, index);
        index = t.nodes[index].parent;
    }
}

// The leaf beside which a new one adds little perimeter to the tree, found by descending where the box grows less. As the way always goes down to a leaf, the
// tree stays an AVL tree: no insertion unbalances a node by more than one rotation can correct.
std::uint32_t best_sibling(Tree t, const Aabb& box) {
    std::uint32_t index = t.state->root;
    while (!is_leaf(t.nodes[index])) {
        const auto growth = [&](std::uint32_t child) {
            const TreeNode& node = t.nodes[child];
            const float merged = perimeter(both(node.box, box));
            return is_leaf(node) ? merged : merged - perimeter(node.box);
        };
        const std::uint32_t child1 = t.nodes[index].child1;
        const std::uint32_t child2 = t.nodes[index].child2;
        index = growth(child1) <= growth(child2) ? child1 : child2;
    }
    return index;
}

}  // namespace

std::uint32_t tree_insert(Tree t, const Aabb& box, std::uint32_t shape) {
    const std::uint32_t leaf = take_node(t);
    t.nodes[leaf].box = box;
    t.nodes[leaf].child2 = shape;
    ++t.state->leaf_count;
    if (t.state->root == null_index) {
        t.state->root = leaf;
        return leaf;
    }
    const std::uint32_t sibling = best_sibling(t, box);
    const std::uint32_t parent = take_node(t);
    replace_child(t, t.nodes[sibling].parent, sibling, parent);
    t.nodes[parent].child1 = sibling;
    t.nodes[parent].child2 = leaf;
    t.nodes[sibling].parent = parent;
    t.nodes[leaf].parent = parent;
    refit_upwards(t, parent);
    return leaf;
}

void tree_remove(Tree t, std::uint32_t leaf) {
    --t.state->leaf_count;
    const std::uint32_t parent = t.nodes[leaf].parent;
    if (parent == null_index) {
        t.state->root = null_index;
    } else {
        const std::uint32_t sibling = t.nodes[parent].child1 == leaf ? t.nodes[parent].child2 : t.nodes[parent].child1;
        const std::uint32_t grandparent = t.nodes[parent].parent;
        replace_child(t, grandparent, parent, sibling);
        give_node(t, parent);
        refit_upwards(t, grandparent);
    }
    give_node(t, leaf);
}

const char* tree_validate(Tree t) {
    const std::uint32_t high_water = t.state->high_water;
    const std::uint32_t leaves_wanted = t.state->leaf_count;
    if (leaves_wanted > high_water) return "the tree counts more leaves than nodes";
    const std::uint32_t live = leaves_wanted == 0 ? 0 : 2 * leaves_wanted - 1;

    // A free node has no child of either kind, so the two walks never meet.
    std::uint32_t free = 0;
    for (std::uint32_t i = t.state->free_head; i != null_index; i = t.nodes[i].parent) {
        if (i >= high_water || t.nodes[i].child1 != null_index || t.nodes[i].child2 != null_index) return "the tree's free list holds a live node";
        if (++free > high_water) return "the tree's free list has a cycle";
    }
    if (live + free != high_water) return "the tree lost a node";
    if (t.state->root == null_index) return leaves_wanted == 0 ? nullptr : "an empty tree counts leaves";
    if (t.state->root >= high_water || t.nodes[t.state->root].parent != null_index) return "the root of the tree has a parent";

    // Heights fall from node to child and each child knows its one parent, so the walk ends and meets no node twice.
    std::uint32_t stack[2 * tree_stack];
    std::uint32_t top = 0;
    std::uint32_t leaves = 0;
    stack[top++] = t.state->root;
    while (top > 0) {
        const std::uint32_t index = stack[--top];
        const TreeNode& node = t.nodes[index];
        if (is_leaf(node)) {
            if (node.child2 == null_index || node.height != 0) return "a leaf of the tree has no shape";
            ++leaves;
            continue;
        }
        if (node.child1 >= high_water || node.child2 >= high_water || node.child1 == node.child2) return "a tree node has no two children";
        const TreeNode& a = t.nodes[node.child1];
        const TreeNode& b = t.nodes[node.child2];
        if (a.parent != index || b.parent != index) return "a tree node does not know its parent";
        if (a.height >= tree_stack || b.height >= tree_stack || node.height >= tree_stack) return "the tree is too deep";
        if (node.height != 1 + (a.height > b.height ? a.height : b.height)) return "a tree node has the wrong height";
        if (a.height > b.height + 1 || b.height > a.height + 1) return "a tree node is out of balance";
        if (node.box != merge(a.box, b.box)) return "a tree node is not as large as its children";
        stack[top++] = node.child1;
        stack[top++] = node.child2;
    }
    return leaves == leaves_wanted ? nullptr : "the tree lost or gained a leaf";
}

}  // namespace islet::detail
