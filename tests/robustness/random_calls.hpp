// What the tests of random calls have in common: the world stays sound under them, and some of them are refused.
#pragma once

#include <gtest/gtest.h>

#include "support/kept_plan.hpp"
#include "support/test_world.hpp"

namespace islet::test {

/// Calls act() `operations` times, and after every seventh looks whether all invariants hold and all numbers are finite; and after each,
/// whether a plan that is kept is right. Returns one hash over the states
/// on the way and the number of errors; 0 as soon as the world is broken.
template <class Act>
std::uint64_t random_calls(TestWorld& w, int operations, Act act) {
    std::uint64_t seen = 0;
    int kept = 0;
    for (int i = 0; i < operations; ++i) {
        act();
        kept += keeps_plan(*w) ? 1 : 0;
        expect_kept_plan_is_right(*w);
        if (i % 7 == 0) {
            const char* broken = w->validate();
            EXPECT_EQ(broken, nullptr) << broken << ", after operation " << i;
            EXPECT_TRUE(w.is_finite()) << "after operation " << i;
            if (broken != nullptr || !w.is_finite()) return 0;
        }
        if (i % 97 == 0) seen = (seen ^ w->hash()) * 0x9e3779b97f4a7c15ull + w.errors.size();
    }
    EXPECT_TRUE(kept > operations / 400 || !detail::keeps_plan) << "hardly any plan was kept";
    EXPECT_GT(w.errors.size(), static_cast<std::size_t>(operations / 100)) << "hardly anything bad was tried";
    return seen ^ w->hash();
}

}  // namespace islet::test
