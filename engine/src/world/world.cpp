// Making a world, and functions on the world as a whole.
#include "../exact.hpp"

#include "islet/world.hpp"

#include "../bodies/geometry_pool.hpp"
#include "../bodies/sleep.hpp"
#include "../calls/recorder.hpp"
#include "../data/arrays.hpp"
#include "../data/parallel.hpp"
#include "../graph/hooks.hpp"
#include "../graph/joint_graph.hpp"
#include "../graph/sensors.hpp"
#include "../math/cpu.hpp"
#include "../math/float_mode.hpp"
#include "../math/scalar.hpp"
#include "../memory/place.hpp"
#include "../solver/hits.hpp"
#include "../solver/ordered_sweep.hpp"
#include "../solver/solver_def.hpp"
#include "../step/continuous.hpp"
#include "../step/one_way.hpp"
#include "../step/profile.hpp"

namespace islet {

using namespace detail;

namespace {

Error check_block(span<std::byte> block, std::size_t wanted) {
    if (reinterpret_cast<std::uintptr_t>(block.data()) % world_alignment != 0) return Error::block_misaligned;
    return block.data() == nullptr || block.size() < wanted ? Error::block_too_small : Error::none;
}

// True if products are rounded before something is subtracted from them, and if subnormal numbers are kept. The source cannot force every compiler to do so
// (exact.hpp), nor a run-time library that stands in for a floating-point unit.
bool is_exact() {
    const DefaultFloatMode mode;
    constexpr float unit = ISLET_SUBNORMALS ? 0x1p-62f : 1.0f;
    volatile float known = 0x1.001p0f * unit;  // volatile, so that the compiler does not compute the result itself
    const float x = known;
    // x^2 is (1 + 2^-11 + 2^-24) unit^2, and the last term is lost to rounding. 2^-11 unit^2 may be subnormal.
    known = x * x - unit * unit;
    return bits_of(known) == bits_of(0x1p-11f * (unit * unit));
}

bool is_usable(const TaskSystem& tasks) { return tasks.workers >= 1 && tasks.workers <= max_workers; }

Error check_def(const WorldDef& def) {
    if (!is_exact()) return Error::inexact_build;
    if (!all_finite(def.gravity.x, def.gravity.y, def.restitution_threshold, def.max_speed, def.hit_threshold)) return Error::not_finite;
    if (!are_there(def.hooks)) return Error::feature_cut;
    if (def.restitution_threshold < 0 || def.hit_threshold < 0 || def.max_speed <= 0 || def.max_speed > max_speed_limit) return Error::out_of_range;
    if (def.lanes != 0 && def.lanes != 1 && def.lanes != 4 && def.lanes != 8 && def.lanes != 16) return Error::out_of_range;
    if (!is_usable(def.tasks)) return Error::out_of_range;
    if (!has_profile && def.clock != nullptr) return Error::feature_cut;
    Error error = Error::none;
    check_solver(def.solver, error);
    return error;
}

std::uint32_t choose_lanes(std::uint32_t wanted) {
    std::uint32_t widest = max_lanes;
    if (widest == 16 && !cpu_has_avx512()) widest = 8;
    if (widest == 8 && !cpu_has_avx2()) widest = 4;
    return wanted == 0 || wanted > widest || wanted < min_lanes ? widest : wanted;
}

template <class T>
void point(T*& array, std::byte* at, std::size_t) {
    array = reinterpret_cast<T*>(at);
}
void point(BitSet& set, std::byte* at, std::size_t bits) {
    set = {reinterpret_cast<std::uint64_t*>(at), static_cast<std::uint32_t>(words_for(static_cast<std::uint32_t>(bits)))};
}
[[maybe_unused]] void point(PairSet& set, std::byte* at, std::size_t keys) {
    set = {reinterpret_cast<std::uint64_t*>(at), static_cast<std::uint32_t>(keys) - 1};
}

void point_into(Core& core, std::byte* block, const Layout& l) {
    for_each_array(core, [&](auto& array, auto row) {
        if constexpr (row.is_there) point(array, block + l[row.array], room_for(row.per, core.capacity));
    });
    core.scratch = block + l.scratch;
    core.scratch_end = block + l.end;
}

}  // namespace

World* World::create(span<std::byte> block, const Capacity& capacity, const WorldDef& def, Error* error) {
    Layout l{};
    Error problem = islet::is_valid(capacity) ? Error::none : Error::bad_capacity;
    if (problem == Error::none) {
        l = layout_of(capacity);
        problem = check_block(block, l.end);
    }
    if (problem == Error::none) problem = check_def(def);
    if (problem != Error::none) return detail::refuse_creation(problem, def, error);
    if (error != nullptr) *error = problem;
    return &create_static(block.data(), capacity, l, def);
}

namespace detail {

World* refuse_creation(Error problem, const WorldDef& def, Error* error) {
    if (error != nullptr) *error = problem;
    if (def.error_hook != nullptr) def.error_hook(problem, def.error_context);
    return nullptr;
}

static_assert(sizeof(World) <= host_bytes);

World& create_static(std::byte* block, const Capacity& capacity, const Layout& layout, const WorldDef& wanted, LaidOut) {
    static constexpr WorldDef fallback;
    const Error problem = check_def(wanted);
    if (problem != Error::none && wanted.error_hook != nullptr) wanted.error_hook(problem, wanted.error_context);
    const WorldDef& def = problem == Error::none ? wanted : fallback;

    World& world = *new (block, IsletPlace{}) World;
    Core& core = *new (world.core_, IsletPlace{}) Core{};
    core.capacity = capacity;
    core.lanes = choose_lanes(def.lanes);
    core.error_hook = def.error_hook;
    core.error_context = def.error_context;
    core.last_error = problem;
    core.exact = problem != Error::inexact_build;
    core.tasks = def.tasks;
    core.hooks = def.hooks;
    if (has_profile && ISLET_IS_LINKED(note_stage)) core.clock = def.clock;
    core.clock_context = def.clock_context;
    point_into(core, block, layout);

    // Persistent memory starts as zeros, so that no byte of a world depends on what the block held before.
    std::memset(block + layout[Array::state], 0, layout.persistent_end - layout[Array::state]);
    State& state = *new (core.state, IsletPlace{}) State{};
    rebuild_buckets(core);
    state.gravity = def.gravity;
    state.restitution_threshold = def.restitution_threshold;
    state.max_speed = def.max_speed;
    state.hit_threshold = def.hit_threshold;
    state.solver = pack(def.solver);
    forget_residuals(core);
    state.enable_sleep = has_sleep && def.enable_sleep ? 1 : 0;
    state.continuous = has_continuous && def.continuous ? 1 : 0;
    state.catching_floors = has_seamless_floors && def.seamless_floors ? 0 : 1;
    return world;
}

Error refuse_call(const World* world, Error error) {
    if (world != nullptr) Core::of(*world).fail(error);
    return error;
}

bool begin_call(World* world) {
    if (world == nullptr) return false;
    Core& core = Core::of(*world);
    core.kept_error = core.last_error;
    core.last_error = Error::none;
    return true;
}

Error end_call(World* world, Error without) {
    if (world == nullptr) return without;
    Core& core = Core::of(*world);
    const Error error = core.last_error;
    if (error == Error::none) core.last_error = core.kept_error;
    return error;
}

}  // namespace detail

Vec2 World::gravity() const { return core().state->gravity; }

void World::set_gravity(Vec2 gravity) {
    note_call<Call::set_gravity>(core(), gravity);
    if (check_open(core()) && check_finite(core(), gravity)) core().state->gravity = gravity;
}

SolverDef World::solver() const { return unpack(core().state->solver); }

float World::residual(BodyId id) const { ISLET_READ(has_tuning && c.has_residuals ? c.residuals[i] : 0.0f); }

TaskSystem World::tasks() const { return core().tasks; }

void World::set_tasks(const TaskSystem& tasks) {
    Core& c = core();
    if (!check_open(c) || !check(c, is_usable(tasks), Error::out_of_range)) return;
    const std::uint32_t most = workers_of(tasks);
    c.tasks = tasks;
    set_workers(c, c.workers < most ? c.workers : most);
}

bool World::sleep_enabled() const { return core().state->enable_sleep != 0; }

void World::enable_sleep(bool enable) {
    Core& c = core();
    note_call<Call::enable_sleep>(c, enable);
    if (!check_open(c) || !check_there(c, has_sleep || !enable)) return;
    c.state->enable_sleep = enable ? 1 : 0;
    if (enable) return;
    for_each_live(c.state->body_pool, c.bodies, [&](std::uint32_t i) { wake_island(c, i, c.arena()); });
}

bool World::continuous() const { return core().state->continuous != 0; }

void World::enable_continuous(bool enable) {
    note_call<Call::enable_continuous>(core(), enable);
    if (check_open(core()) && check_there(core(), has_continuous || !enable)) core().state->continuous = enable ? 1 : 0;
}

bool World::seamless_floors() const { return core().state->catching_floors == 0; }

void World::enable_seamless_floors(bool enable) {
    note_call<Call::enable_seamless_floors>(core(), enable);
    if (check_open(core()) && check_there(core(), has_seamless_floors || !enable)) core().state->catching_floors = enable ? 0 : 1;
}

float World::restitution_threshold() const { return core().state->restitution_threshold; }

void World::set_restitution_threshold(float speed) {
    note_call<Call::set_restitution_threshold>(core(), speed);
    if (check_open(core()) && check_range(core(), speed, 0, no_limit)) core().state->restitution_threshold = speed;
}

float World::max_speed() const { return core().state->max_speed; }

void World::set_max_speed(float speed) {
    note_call<Call::set_max_speed>(core(), speed);
    if (check_open(core()) && check_range(core(), speed, 0, max_speed_limit) && check(core(), speed > 0, Error::out_of_range)) core().state->max_speed = speed;
}

std::uint32_t World::lanes() const { return core().lanes; }

const Capacity& World::capacity() const { return core().capacity; }
const StepReport& World::report() const { return core().report; }
Error World::last_error() const { return core().last_error; }
void World::clear_error() { core().last_error = Error::none; }

ErrorHook World::error_hook() const { return core().error_hook; }
void* World::error_context() const { return core().error_context; }

void World::set_error_hook(ErrorHook hook, void* context) {
    if (!check_open(core())) return;
    core().error_hook = hook;
    core().error_context = context;
}

std::uint64_t World::step_count() const { return core().state->steps; }

span<const TouchEvent> World::begin_touch_events() const { return {core().begin_events, core().begin_count}; }
span<const TouchEvent> World::end_touch_events() const { return {core().end_events, core().end_count}; }
span<const BodyId> World::moved_bodies() const { return {core().moved_events, core().moved_count}; }
span<const BodyId> World::slept_bodies() const { return {core().slept_events, core().slept_count}; }
span<const JointBreakEvent> World::broken_joints() const { return {core().break_events, core().break_count}; }

std::uint32_t World::contact_count() const { return core().state->contact_pool.count; }

}  // namespace islet
