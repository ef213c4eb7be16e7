// A step, as a table of contents.
#include "../exact.hpp"

#include "../calls/recorder.hpp"
#include "../math/float_mode.hpp"
#include "../solver/solver.hpp"
#include "../step/step_halves.hpp"

namespace islet {

using namespace detail;

void World::step(float dt) {
    Core& c = core();
    if (!c.exact) return c.fail(Error::inexact_build);
    note_call<Call::step>(c, dt);
    if (!check_open(c) || !check(c, is_time_step(dt), Error::bad_time_step)) return;
    const DefaultFloatMode mode;
    begin_step(c, dt);
    if (has_joints && c.state->trees_stale != 0 && c.state->joint_pool.count != 0) c.forget_plan();  // and then its place is free
    Arena arena = c.arena_until_told();
    const Plan plan = plan_step(c, arena);
    SolverBody* bodies = detail::solve(c, plan, arena, dt);
    arena.at = c.scratch;
    end_step(c, plan, bodies, arena, dt);
    if (has_recorder && c.recording != nullptr) write_stepped(*this);
}

}  // namespace islet
