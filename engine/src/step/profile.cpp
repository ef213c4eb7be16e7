#include "../exact.hpp"

#include "../step/profile.hpp"

#include "../calls/checks.hpp"

namespace islet {

using namespace detail;

namespace detail {

void note_stage(Core& core, Stage stage) {
    const std::uint64_t now = core.clock(core.clock_context);
    StepProfile& p = core.times.profile;
    const std::uint64_t passed = now - core.times.last_tick;
    core.times.last_tick = now;
    p.total += passed;
    switch (stage) {
        case Stage::begin: p = {}; break;
        case Stage::pairs: p.pairs = passed; break;
        case Stage::collide: p.collide = passed; break;
        case Stage::islands: p.islands = passed; break;
        case Stage::solve: p.solve = passed; break;
        case Stage::finish: p.finish = passed; break;
    }
}

}  // namespace detail

const StepProfile& World::profile() const { return core().times.profile; }

void World::set_clock(Clock clock, void* context) {
    Core& c = core();
    if (!check_open(c) || !check_there(c, has_profile || clock == nullptr)) return;
    c.clock = clock;
    c.clock_context = context;
    if (has_profile) c.times.profile = {};
}

}  // namespace islet
