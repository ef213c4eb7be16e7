// The halves of a step, before the solve and after it: of World::step, and of worlds that are solved together.
#pragma once

#include "../bodies/joint_changes.hpp"
#include "../broadphase/pairs.hpp"
#include "../calls/recorder.hpp"
#include "../data/parallel.hpp"
#include "../graph/contacts.hpp"
#include "../island/batches.hpp"
#include "../math/inlining.hpp"
#include "../step/contact_update.hpp"
#include "../step/move_and_sleep.hpp"
#include "../step/profile.hpp"

namespace islet::detail {

/// Drops the events of the last step. Events of calls made since (a touching shape was destroyed) stay, and are reported with this step's.
ISLET_PART void clear_events(Core& core) {
    drop_told_ends(core);
    if (has_sensors) core.sensor_begins.count = 0;
    core.begin_count = core.moved_count = core.slept_count = core.break_count = core.hit_count = 0;
    core.report.dropped_events = core.report.dropped_hits = 0;
}

ISLET_PART void fill_report(Core& core, const Plan& plan) {
    StepReport& r = core.report;
    r.bodies = core.state->body_pool.count;
    r.awake_bodies = core.awake_bodies.count();
    r.shapes = core.state->shape_pool.count;
    r.contacts = core.state->contact_pool.count;
    r.touching_contacts = plan.touching_count;
    r.islands = plan.island_count;
    r.colors = 0;
    for (std::uint32_t colors = plan.colors; colors != 0; colors &= colors - 1) ++r.colors;
    r.overflow_contacts = plan.overflow_count;
    r.batches = plan.batch_count;
    r.sweeps = 0;
    for (std::uint32_t i = 0; i < plan.batch_count; ++i) r.sweeps = r.sweeps > plan.batches[i].sweeps ? r.sweeps : plan.batches[i].sweeps;
    r.awake_joints = plan.awake_joints;
    r.overflow_joints = plan.overflow_joints;
    r.joints = core.state->joint_pool.count;
    core.end_reported = core.end_count;
    core.sensor_ends_reported = core.sensor_ends.count;
    ++core.state->steps;
}

/// Brings the contacts up to date. Until the step ends, nothing may change the world.
ISLET_PART void begin_step(Core& c, float dt) {
    c.inside = inside_call;
    count_workers(c);
    note(c, Stage::begin);
    clear_events(c);
    find_pairs(c, dt);
    note(c, Stage::pairs);
    update_contacts(c, dt);
    note(c, Stage::collide);
}

/// Plans the solve. The arrays of a new plan are taken from the end of `arena`; a plan that was kept lies behind it.
ISLET_PART Plan plan_step(Core& c, Arena& arena) {
    if (has_joints && c.state->joint_pool.count != 0) choose_trees(c, arena);
    const Plan plan = kept_or_new_plan(c, arena);
    note(c, Stage::islands);
    return plan;
}

/// Ends the step of a world whose solve came to `bodies`, by slot.
ISLET_PART void end_step(Core& c, const Plan& plan, SolverBody* bodies, Arena& arena, float dt) {
    tell_touches(c);
    note(c, Stage::solve);
    finish_bodies(c, plan, bodies, arena, dt);
    if (has_joints && c.state->joint_pool.count != 0) finish_joints(c, arena);
    fill_report(c, plan);
    note(c, Stage::finish);
    c.inside = outside;
}

}  // namespace islet::detail
