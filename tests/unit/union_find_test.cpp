// Union-find: sets that several threads join at once are those that one thread joins.
#include "island/union_find.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <random>
#include <thread>
#include <utility>
#include <vector>

namespace islet::detail {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// Pairs of neighbours and of any two items: long paths, and many threads at the same roots.
Pairs random_pairs(std::uint32_t items, std::size_t count, std::uint32_t seed) {
    std::mt19937 random(seed);
    Pairs pairs;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t a = static_cast<std::uint32_t>(random()) % items;
        const std::uint32_t b = i % 2 == 0 ? static_cast<std::uint32_t>(random()) % items : (a + 1) % items;
        pairs.emplace_back(a, b);
    }
    return pairs;
}

std::vector<std::uint32_t> singles(std::uint32_t items) {
    std::vector<std::uint32_t> parent(items);
    std::iota(parent.begin(), parent.end(), 0u);
    return parent;
}

std::vector<std::uint32_t> roots_of(std::vector<std::uint32_t> parent) {
    const UnionFind sets{parent.data()};
    std::vector<std::uint32_t> roots;
    for (std::uint32_t i = 0; i < parent.size(); ++i) roots.push_back(sets.root_of(i));
    return roots;
}

std::vector<std::uint32_t> joined_by_one(std::uint32_t items, const Pairs& pairs) {
    std::vector<std::uint32_t> parent = singles(items);
    const UnionFind sets{parent.data()};
    for (const auto& [a, b] : pairs) {
        const std::uint32_t root_a = sets.root_of(a), root_b = sets.root_of(b);
        if (root_a != root_b) sets.join(root_a, root_b);
    }
    return roots_of(parent);
}

TEST(UnionFind, TheSmallestItemOfASetIsItsRoot) {
    const std::vector<std::uint32_t> roots = joined_by_one(8, {{7, 5}, {5, 6}, {3, 1}, {6, 2}});
    EXPECT_EQ(roots, (std::vector<std::uint32_t>{0, 1, 2, 1, 4, 2, 2, 2}));
}

#if ISLET_SHARES_WORDS
TEST(UnionFind, ThreadsThatJoinAtOnceFindTheSetsOfOne) {
    constexpr std::uint32_t threads = 4;
    // From few sets of many items to many sets of few.
    for (const std::size_t count : {20000u, 6000u, 2000u}) {
        for (std::uint32_t seed = 1; seed <= 20; ++seed) {
            const std::uint32_t items = 5000;
            const Pairs pairs = random_pairs(items, count, seed);
            std::vector<std::uint32_t> parent = singles(items);
            std::vector<std::thread> workers;
            for (std::uint32_t t = 0; t < threads; ++t)
                workers.emplace_back([&, t] {
                    const SharedUnionFind sets{{parent.data()}};
                    for (std::size_t i = t; i < pairs.size(); i += threads) sets.join(pairs[i].first, pairs[i].second);
                });
            for (std::thread& worker : workers) worker.join();
            ASSERT_EQ(roots_of(parent), joined_by_one(items, pairs)) << count << " pairs, seed " << seed;
        }
    }
}
#endif

}  // namespace
}  // namespace islet::detail
