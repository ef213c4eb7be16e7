// Batches are shared out among workers: each goes to one share, and the shares weigh about the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "../../engine/src/island/batch_shares.hpp"
#include "support/random.hpp"

namespace islet::test {
namespace {

using Weights = std::vector<std::uint32_t>;

// Which share each item goes to; -1 for those that were left out. Fails if one is visited twice.
std::vector<int> shares_of(const Weights& weights, std::uint32_t shares) {
    std::vector<int> of(weights.size(), -1);
    const auto weight_of = [&](std::uint32_t i) { return weights[i]; };
    detail::share_out(static_cast<std::uint32_t>(weights.size()), shares, weight_of, [&](std::uint32_t item, std::uint32_t share) {
        EXPECT_EQ(of[item], -1) << "item " << item << " was given away twice";
        EXPECT_LT(share, shares);
        of[item] = static_cast<int>(share);
    });
    return of;
}

std::vector<std::uint64_t> loads_of(const Weights& weights, const std::vector<int>& of, std::uint32_t shares) {
    std::vector<std::uint64_t> loads(shares, 0);
    for (std::size_t i = 0; i < weights.size(); ++i)
        if (of[i] >= 0) loads[static_cast<std::size_t>(of[i])] += weights[i];
    return loads;
}

TEST(BatchShares, EachItemThatWeighsSomethingGoesToOneShare) {
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        Weights weights(random.below(40));
        for (std::uint32_t& w : weights) w = random.one_in(4) ? 0 : 1 + random.below(random.one_in(5) ? 5000 : 300);
        const std::vector<int> of = shares_of(weights, 1 + random.below(detail::max_shares));
        for (std::size_t k = 0; k < weights.size(); ++k) EXPECT_EQ(of[k] >= 0, weights[k] != 0);
    }
}

TEST(BatchShares, OfLightItemsEachShareIsFairToWithinOneItemAndNeighboursStayTogether) {
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        const std::uint32_t shares = 1 + random.below(16);
        Weights weights(8 * shares + random.below(100));
        for (std::uint32_t& w : weights) w = 100 + random.below(200);  // none is half a fair share
        const std::vector<int> of = shares_of(weights, shares);
        EXPECT_TRUE(std::is_sorted(of.begin(), of.end()));
        const std::uint64_t total = std::accumulate(weights.begin(), weights.end(), std::uint64_t{0}), fair = total / shares;
        for (const std::uint64_t load : loads_of(weights, of, shares)) {
            EXPECT_LE(load, fair + 300) << shares << " shares of " << weights.size() << " items";
            EXPECT_GE(load + 300, fair) << shares << " shares of " << weights.size() << " items";
        }
    }
}

// (Nine batches of one size used to be cut after each third one for four workers, so that the last worker had none.)
TEST(BatchShares, TheLastOfAShareIsWhatComesNearest) {
    const auto loads = [](std::uint32_t items, std::uint32_t shares) {
        const Weights weights(items, 100);
        return loads_of(weights, shares_of(weights, shares), shares);
    };
    EXPECT_EQ(loads(10, 2), (std::vector<std::uint64_t>{500, 500}));
    EXPECT_EQ(loads(9, 4), (std::vector<std::uint64_t>{200, 200, 300, 200}));
    EXPECT_EQ(loads(10, 4), (std::vector<std::uint64_t>{200, 300, 200, 300}));
}

TEST(BatchShares, HeavyItemsGoToTheLightestShareAndTheOthersFillUp) {
    const Weights weights = {10, 600, 10, 500, 10, 100, 100, 100, 10};
    EXPECT_EQ(shares_of(weights, 2), (std::vector<int>{0, 0, 0, 1, 0, 0, 1, 1, 1}));
    Random random(7);
    for (int i = 0; i < 2000; ++i) {
        const std::uint32_t shares = 2 + random.below(7);
        Weights some(20 + random.below(30));
        for (std::uint32_t& w : some) w = random.one_in(8) ? 3000 + random.below(9000) : 100 + random.below(100);
        const std::uint64_t total = std::accumulate(some.begin(), some.end(), std::uint64_t{0}), fair = (total + shares - 1) / shares;
        const std::vector<int> of = shares_of(some, shares);
        std::vector<std::uint64_t> heavy(shares, 0);
        std::uint64_t most_light = 0;
        for (std::size_t k = 0; k < some.size(); ++k) {
            if (2 * some[k] >= fair) heavy[static_cast<std::size_t>(of[k])] += some[k];
            else most_light = std::max<std::uint64_t>(most_light, some[k]);
        }
        const std::vector<std::uint64_t> loads = loads_of(some, of, shares);
        for (std::size_t k = 0; k < shares; ++k) EXPECT_LE(loads[k], std::max(heavy[k], fair) + most_light);
    }
}

}  // namespace
}  // namespace islet::test
