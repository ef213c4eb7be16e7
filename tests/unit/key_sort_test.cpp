// Every way of sorting by keys against the standard library's stable sort.
#include "math/key_sort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/random.hpp"

namespace {

using namespace islet::detail;
using islet::test::Random;

using Items = std::vector<KeyedItem>;

Items in_order_of_numbers(const std::vector<std::uint32_t>& keys) {
    Items items;
    for (std::uint32_t key : keys) items.push_back(keyed(key, static_cast<std::uint32_t>(items.size())));
    return items;
}

Items sorted_stably(Items items) {
    std::stable_sort(items.begin(), items.end(), [](KeyedItem a, KeyedItem b) { return a >> 32 < b >> 32; });
    return items;
}

Items by_gaps(Items items) {
    sort_by_gaps(items.data(), static_cast<std::uint32_t>(items.size()), [](KeyedItem a, KeyedItem b) { return a < b; });
    return items;
}

template <std::uint32_t digit_bits>
Items by_digits(Items items) {
    Items spare(items.size());
    std::vector<std::uint32_t> counts(std::size_t{1} << digit_bits, 7u);
    const KeyedItem* sorted = sort_by_digits<digit_bits>(items.data(), spare.data(), static_cast<std::uint32_t>(items.size()), counts.data());
    return {sorted, sorted + items.size()};
}

Items by_key(Items items) {
    Items spare(items.size());
    std::vector<std::uint32_t> counts(sort_digits, 7u);
    const KeyedItem* sorted = sort_by_key(items.data(), spare.data(), static_cast<std::uint32_t>(items.size()), counts.data());
    return {sorted, sorted + items.size()};
}

void expect_all_sort(const std::vector<std::uint32_t>& keys) {
    const Items items = in_order_of_numbers(keys);
    const Items wanted = sorted_stably(items);
    EXPECT_EQ(by_gaps(items), wanted) << keys.size();
    EXPECT_EQ(by_digits<8>(items), wanted) << keys.size();
    EXPECT_EQ(by_digits<11>(items), wanted) << keys.size();
    EXPECT_EQ(by_key(items), wanted) << keys.size();
}

void expect_all_sort(std::uint32_t count, Random& random) {
    std::vector<std::uint32_t> keys(count);
    const auto fill = [&](auto&& key_of) {
        for (std::uint32_t i = 0; i < count; ++i) keys[i] = key_of(i);
        expect_all_sort(keys);
    };
    fill([&](std::uint32_t) { return static_cast<std::uint32_t>(random.bits()); });
    fill([&](std::uint32_t) { return random.below(4); });                // many equal keys
    fill([&](std::uint32_t) { return random.below(4) << 30; });          // that differ in the highest digit alone
    fill([&](std::uint32_t) { return 0x80000000u + random.below(9); });  // whose highest digits are alike
    fill([](std::uint32_t) { return 0xffffffffu; });
    fill([](std::uint32_t i) { return i; });
    fill([&](std::uint32_t i) { return count - i; });
}

TEST(KeySort, SortsUpToSeventyItemsAsAStableSortDoes) {
    Random random(1);
    for (std::uint32_t count = 0; count <= 70; ++count) expect_all_sort(count, random);
}

TEST(KeySort, SortsAsManyItemsAsChangeTheWayOfSorting) {
    Random random(2);
    for (std::uint32_t most : {few_items, many_items, 3 * many_items})
        for (std::uint32_t count : {most - 1, most, most + 1}) expect_all_sort(count, random);
}

}  // namespace
