// The plan that a world keeps from its last step, beside a plan made anew.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "../../engine/src/data/core.hpp"
#include "../../engine/src/island/batches.hpp"

namespace islet::test {

inline bool keeps_plan(const World& world) { return detail::Core::of(world).kept.plan != nullptr; }

/// Everything in a plan but for what the solve itself notes there.
inline std::vector<std::uint64_t> words_of(const detail::Plan& plan, std::uint32_t bodies, std::uint32_t lanes) {
    using namespace detail;
    std::vector<std::uint64_t> words;
    const auto add = [&](auto... values) { (words.push_back(static_cast<std::uint64_t>(values)), ...); };
    const auto add_all = [&](const auto* values, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) add(values[i]);
    };
    add(plan.slot_count, plan.island_count, plan.batch_count, plan.block_count, plan.overflow_count, plan.run_count, plan.joint_count, plan.awake_joints,
        plan.has_trees, plan.overflow_joints, plan.link_count, plan.lightness != nullptr, plan.colors, plan.touching_count);
    add_all(plan.slot_of, bodies);
    add_all(plan.body_of, plan.slot_count);
    if (keeps_islands) add_all(plan.island_of + 1, plan.slot_count - 1);
    add_all(plan.contacts + std::size_t{plan.block_count} * lanes, plan.overflow_count);
    for (std::uint32_t i = 0; i < plan.run_count; ++i) {
        const JointRun& r = plan.runs[i];
        const std::uint32_t width = r.color == no_color ? 1 : lanes;
        add(r.kernel, r.color, r.first, r.blocks);
        add_all(plan.joints + r.first, std::size_t{r.blocks} * width);
    }
    for (std::uint32_t i = 0; i < plan.link_count; ++i) add(plan.links[i].body, plan.links[i].joint, plan.parent_links[i]);
    for (std::uint32_t b = plan.batches[kinematic_batch].body_count != 0 ? 0 : 1; b < plan.batch_count; ++b) {
        const Batch& batch = plan.batches[b];
        add(batch.first_slot, batch.body_count, batch.first_overflow, batch.end_overflow, batch.first_run, batch.end_run, batch.first_link, batch.link_count);
        add_all(batch.first_block, color_count + 1);
        for (std::uint32_t c = 0; c < color_count; ++c) {  // in any order within a colour: first come those that landed when the plan was made
            std::vector<PlanIndex> contacts(plan.contacts + std::size_t{batch.first_block[c]} * lanes,
                                            plan.contacts + std::size_t{batch.first_block[c + 1]} * lanes);
            std::sort(contacts.begin(), contacts.end());
            add_all(contacts.data(), contacts.size());
        }
    }
    return words;
}

/// If the world keeps a plan, a step that began now and changed no contact would make the same one.
inline void expect_kept_plan_is_right(const World& world) {
    const detail::Core& core = detail::Core::of(world);
    if (core.kept.plan == nullptr || (core.state->trees_stale != 0 && core.state->joint_pool.count != 0)) return;
    const std::uint32_t bodies = core.state->body_pool.high_water, lanes = core.block_lanes();
    detail::Arena arena = core.arena();
    EXPECT_EQ(words_of(*core.kept.plan, bodies, lanes), words_of(detail::make_plan(core, arena), bodies, lanes));
}

}  // namespace islet::test
