// A step, as a table of contents.
#include "../exact.hpp"

#include "../bodies/joint_changes.hpp"
#include "../broadphase/pairs.hpp"
#include "../calls/recorder.hpp"
#include "../graph/contacts.hpp"
#include "../island/batches.hpp"
#include "../math/float_mode.hpp"
#include "../solver/solver.hpp"
#include "../step/contact_update.hpp"
#include "../step/move_and_sleep.hpp"
#include "../step/profile.hpp"

namespace islet {

using namespace detail;

namespace {

// Drops the events of the last step. Events of calls made since (a touching shape was destroyed) stay, and are reported with this step's.
void clear_events(Core& core) {
    drop_told_ends(core);
    if (has_sensors) core.sensor_begins.count = 0;
    core.begin_count = core.moved_count = core.slept_count = core.break_count = core.hit_count = 0;
    core.report.dropped_events = core.report.dropped_hits = 0;
}

void fill_report(Core& core, const Plan& plan) {
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

}  // namespace

void World::step(float dt) {
    Core& c = core();
    if (!c.exact) return c.fail(Error::inexact_build);
    note_call<Call::step>(c, dt);
    if (!check_open(c) || !check(c, is_time_step(dt), Error::bad_time_step)) return;
    const DefaultFloatMode mode;
    c.inside = inside_call;
    note(c, Stage::begin);
    clear_events(c);

    find_pairs(c, dt);
    note(c, Stage::pairs);
    update_contacts(c, dt);
    note(c, Stage::collide);

    Arena arena = c.arena();
    SolverMotion* motions = take_motions(c, arena);
    if (c.state->joint_pool.count != 0) choose_trees(c, arena);
    const Plan plan = make_plan(c, arena);
    note(c, Stage::islands);
    SolverBody* bodies = detail::solve(c, plan, motions, arena, dt);
    tell_touches(c);
    note(c, Stage::solve);
    finish_bodies(c, plan, bodies, arena, dt);
    if (c.state->joint_pool.count != 0) finish_joints(c);
    fill_report(c, plan);
    note(c, Stage::finish);
    c.inside = 0;
    if (has_recorder && c.recording != nullptr) write_stepped(*this);
}

}  // namespace islet
