#include "../exact.hpp"

#include "../fleet/group_step.hpp"

#include "../solver/solver.hpp"
#include "../step/step_halves.hpp"

namespace islet::detail {

#if ISLET_MAX_LANES > 1

namespace {

/// Worlds between the halves of their steps, whose plans lie one behind the other in scratch.
struct Group {
    GroupWorld worlds[group_worlds];
    std::uint32_t count = 0;
    std::uint32_t rows = 0;
    Arena rest;  // what the plans leave

    void add(Core& core, const Plan& plan, Arena left) {
        worlds[count++] = {&core, plan};
        rows += plan.block_count * core.block_lanes() + plan.overflow_count;
        rest = left;
    }
};

// Solves the group's worlds and ends their steps.
void finish(Group& group, float dt) {
    Arena arena = group.rest;
    if (group.count == 1) {
        const Plan& plan = group.worlds[0].plan;
        group.worlds[0].bodies = solve(*group.worlds[0].core, plan, arena, dt);
    } else if (group.count > 1) {
        solve_group(group.worlds, group.count, arena, dt);
    }
    for (std::uint32_t i = 0; i < group.count; ++i) {
        const GroupWorld& world = group.worlds[i];
        Arena rest = arena;
        world.core->scratch = rest.at;  // what it takes there is none of the other worlds' plans
        world.core->scratch_end = rest.end;
        end_step(*world.core, world.plan, world.bodies, rest, dt);
    }
    group.count = group.rows = 0;
}

/// Nothing wants to see the steps of this world one by one.
bool may_join(const Core& core) {
    const bool watched = core.recording != nullptr || core.clock != nullptr;
    return core.exact && core.inside == outside && !watched && core.lanes > 1 && core.tasks.parallel_for == nullptr;
}

}  // namespace

void step_group(World* const* worlds, std::uint32_t count, Arena arena, float dt) {
    Group group, alone;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (group.count == 0) group.rest = arena;
        Core& core = Core::of(*worlds[i]);
        core.scratch = group.rest.at;
        core.scratch_end = group.rest.end;
        if (!may_join(core)) {
            worlds[i]->step(dt);
            continue;
        }
        begin_step(core, dt);
        Arena left = group.rest;
        const Plan plan = plan_step(core, left);
        const Core& first = group.count != 0 ? *group.worlds[0].core : core;
        const bool joins = first.lanes == core.lanes && solve_alike(first, core);
        (joins ? group : alone).add(core, plan, left);
        if (!joins) finish(alone, dt);
        if (group.rows >= group_rows) finish(group, dt);
    }
    finish(group, dt);
}

#endif

}  // namespace islet::detail
