// The bounding-box tree against a list of boxes searched from end to end.
#include "broadphase/tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/random.hpp"

namespace {

using namespace islet;
using namespace islet::detail;
using islet::test::Random;

struct Forest {
    explicit Forest(std::uint32_t leaves) : nodes(2 * leaves) {}
    Tree tree() { return {&state, nodes.data()}; }
    std::uint32_t height() const { return state.root == null_index ? 0 : nodes[state.root].height; }

    TreeState state;
    std::vector<TreeNode> nodes;
};

Aabb random_box(Random& random, float world, float size) {
    const Vec2 c{random.between(-world, world), random.between(-world, world)};
    const Vec2 h{random.between(0, size), random.between(0, size)};
    return {c - h, c + h};
}

std::vector<std::uint32_t> query(Tree tree, const Aabb& box) {
    std::vector<std::uint32_t> found;
    tree_query(tree, box, [&](std::uint32_t shape) { found.push_back(shape); });
    std::sort(found.begin(), found.end());
    return found;
}

TEST(Tree, AnEmptyTreeHoldsNothing) {
    Forest f(4);
    EXPECT_EQ(tree_validate(f.tree()), nullptr);
    EXPECT_TRUE(query(f.tree(), {{-1e9f, -1e9f}, {1e9f, 1e9f}}).empty());
}

TEST(Tree, ASingleLeafComesAndGoes) {
    Forest f(1);
    const std::uint32_t leaf = tree_insert(f.tree(), {{0, 0}, {1, 1}}, 42);
    EXPECT_EQ(query(f.tree(), {{1, 1}, {2, 2}}), std::vector<std::uint32_t>{42}) << "boxes that share a corner overlap";
    EXPECT_TRUE(query(f.tree(), {{1.01f, 0}, {2, 1}}).empty());
    tree_remove(f.tree(), leaf);
    EXPECT_EQ(tree_validate(f.tree()), nullptr);
    EXPECT_EQ(f.state.leaf_count, 0u);
    EXPECT_TRUE(query(f.tree(), {{-9, -9}, {9, 9}}).empty());
}

TEST(Tree, FindsWhatASearchThroughAllBoxesFinds) {
    constexpr std::uint32_t capacity = 300;
    Forest f(capacity);
    std::vector<Aabb> boxes(capacity);
    std::vector<std::uint32_t> leaves(capacity, null_index);
    Random random(11);
    for (int i = 0; i < 100000; ++i) {
        const std::uint32_t shape = random.below(capacity);
        // Slow tides of filling and emptying, so that the tree is often nearly full and sometimes empty.
        const bool filling = (i / 3000) % 2 == 0;
        if (leaves[shape] == null_index && (filling || random.one_in(4))) {
            boxes[shape] = random_box(random, 20, random.one_in(10) ? 15.0f : 1.0f);
            leaves[shape] = tree_insert(f.tree(), boxes[shape], shape);
        } else if (leaves[shape] != null_index && (!filling || random.one_in(4))) {
            tree_remove(f.tree(), leaves[shape]);
            leaves[shape] = null_index;
        }
        if (i % 10 == 0) {
            const char* broken = tree_validate(f.tree());
            ASSERT_EQ(broken, nullptr) << broken << " after operation " << i;
            const Aabb box = random_box(random, 22, 3);
            std::vector<std::uint32_t> expected;
            for (std::uint32_t s = 0; s < capacity; ++s)
                if (leaves[s] != null_index && overlaps(boxes[s], box)) expected.push_back(s);
            ASSERT_EQ(query(f.tree(), box), expected) << "after operation " << i;
        }
    }
}

TEST(Tree, StaysInBalanceWhateverTheOrderOfInsertion) {
    // An AVL tree of n leaves is at most about 1.4405 log2(n + 1) high.
    constexpr std::uint32_t n = 4096;
    const float limit = 1.4405f * std::log2(static_cast<float>(n) + 1.0f) + 1.0f;
    for (int order = 0; order < 4; ++order) {
        Forest f(n);
        Random random(5);
        std::vector<std::uint32_t> leaves;
        for (std::uint32_t i = 0; i < n; ++i) {
            const auto x = static_cast<float>(order == 0 ? i : n - i);
            const Aabb box = order < 2    ? Aabb{{x, 0}, {x + 0.5f, 1}}  // a row, from the left or from the right
                             : order == 2 ? Aabb{{0, 0}, {1, 1}}         // all the same
                                          : random_box(random, 100, 1);
            leaves.push_back(tree_insert(f.tree(), box, i));
        }
        ASSERT_EQ(tree_validate(f.tree()), nullptr) << "order " << order;
        EXPECT_LE(static_cast<float>(f.height()), limit) << "order " << order;
        // Every other leaf goes, in the order of their coming.
        for (std::uint32_t i = 0; i < n; i += 2) tree_remove(f.tree(), leaves[i]);
        ASSERT_EQ(tree_validate(f.tree()), nullptr) << "order " << order;
        EXPECT_LE(static_cast<float>(f.height()), limit) << "order " << order;
        EXPECT_EQ(f.state.leaf_count, n / 2);
    }
}

TEST(Tree, UsesNoMoreNodesThanTwiceItsLeaves) {
    constexpr std::uint32_t n = 64;
    Forest f(n);
    Random random(6);
    std::vector<std::uint32_t> leaves;
    for (int round = 0; round < 200; ++round) {
        while (leaves.size() < n)
            leaves.push_back(tree_insert(f.tree(), random_box(random, 10, 1), static_cast<std::uint32_t>(leaves.size())));
        ASSERT_LE(f.state.high_water, 2 * n);
        for (std::size_t keep = random.below(n); leaves.size() > keep; leaves.pop_back()) {
            std::swap(leaves[random.below(static_cast<std::uint32_t>(leaves.size()))], leaves.back());
            tree_remove(f.tree(), leaves.back());
        }
        ASSERT_EQ(tree_validate(f.tree()), nullptr);
    }
}

TEST(Tree, TheSameCallsMakeTheSameTree) {
    const auto run = [] {
        Forest f(128);
        Random random(9);
        std::vector<std::uint32_t> leaves;
        for (std::uint32_t i = 0; i < 128; ++i) leaves.push_back(tree_insert(f.tree(), random_box(random, 10, 2), i));
        for (std::uint32_t i = 0; i < 128; i += 3) tree_remove(f.tree(), leaves[i]);
        std::vector<std::uint32_t> order;
        tree_query(f.tree(), {{-99, -99}, {99, 99}}, [&](std::uint32_t shape) { order.push_back(shape); });
        return order;
    };
    EXPECT_EQ(run(), run());
}

TEST(Tree, ValidationNoticesDamage) {
    Forest f(8);
    for (std::uint32_t i = 0; i < 8; ++i) tree_insert(f.tree(), {{static_cast<float>(i), 0}, {static_cast<float>(i) + 1, 1}}, i);
    ASSERT_EQ(tree_validate(f.tree()), nullptr);
    TreeNode& root = f.nodes[f.state.root];
    const TreeNode whole = root;
    root.box.upper.x -= 1;
    EXPECT_NE(tree_validate(f.tree()), nullptr);
    root = whole;
    root.height += 1;
    EXPECT_NE(tree_validate(f.tree()), nullptr);
    root = whole;
    f.nodes[root.child1].parent = null_index;
    EXPECT_NE(tree_validate(f.tree()), nullptr);
}

}  // namespace
