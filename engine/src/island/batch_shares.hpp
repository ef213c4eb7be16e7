// How workers share batches that one of them solves alone.
#pragma once

#include <cstdint>

#include "islet/tasks.hpp"

namespace islet::detail {

inline constexpr std::uint32_t max_shares = 2 * max_workers;

/// Gives items to 1 to max_shares shares, so that these weigh about the same, and calls visit(item, share) for each. weight_of(item) says how much an item
/// weighs; those that weigh 0 are left out. Heavy ones, of half a fair share and more, go one after another to the share that is lightest so far. The others
/// fill up the shares in their order, each where its middle comes to lie; so neighbours stay together. A share gets at most its heavy items or a fair share,
/// whichever is more, and the weight of one light item.
template <class WeightOf, class Visit>
inline void share_out(std::uint32_t items, std::uint32_t shares, WeightOf&& weight_of, Visit&& visit) {
    std::uint64_t total = 0, loads[max_shares] = {};
    for (std::uint32_t i = 0; i < items; ++i) total += weight_of(i);
    const std::uint64_t fair = (total + shares - 1) / shares;
    const auto is_heavy = [&](std::uint64_t weight) { return 2 * weight >= fair; };
    for (std::uint32_t i = 0; i < items; ++i) {
        const std::uint64_t weight = weight_of(i);
        if (weight == 0 || !is_heavy(weight)) continue;
        std::uint32_t lightest = 0;
        for (std::uint32_t k = 1; k < shares; ++k) lightest = loads[k] < loads[lightest] ? k : lightest;
        loads[lightest] += weight;
        visit(i, lightest);
    }
    std::uint32_t share = 0;
    std::uint64_t filled = loads[0];  // this share, and those before it
    for (std::uint32_t i = 0; i < items; ++i) {
        const std::uint64_t weight = weight_of(i);
        if (weight == 0 || is_heavy(weight)) continue;
        while (share + 1 < shares && filled + weight / 2 >= (share + 1) * fair) filled += loads[++share];
        filled += weight;
        visit(i, share);
    }
}

}  // namespace islet::detail
