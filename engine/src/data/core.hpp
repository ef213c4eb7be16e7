// Core: the host's view of a world's block. Pointers to the arrays, the error hook, and the report of the last step; none of it persists.
#pragma once

#include <cstdint>

#include "../data/records.hpp"
#include "../memory/arena.hpp"
#include "../memory/bit_set.hpp"
#include "../memory/pair_set.hpp"
#include "islet/world.hpp"

namespace islet::detail {

/// What sensors told, in the room that touches leave in an array of events (graph/sensors.cpp).
struct SensorEvents {
    SensorEvent* events = nullptr;
    std::uint32_t count = 0;
};

struct RecordingHead;  // calls/calls.hpp
struct Plan;           // island/batches.hpp

/// Why nothing may change the world now: the world is calling a function of the user's.
enum Inside : std::uint8_t {
    outside,
    inside_call,   // a hook, the task system, the clock, a drawing function
    inside_error,  // the error hook, which is told no errors of its own
};

/// What the clock told. A build without a profile has no memory for it.
template <bool is_there = has_profile>
struct TimesOfCore {
    StepProfile profile;
    std::uint64_t last_tick = 0;
};
template <>
struct TimesOfCore<false> {
    static inline StepProfile profile;  // zeros
    static inline std::uint64_t last_tick = 0;
};

/// What the next step may take over from the last one. A build without lanes, whose memory may be small, keeps nothing.
template <bool is_there = keeps_plan>
struct KeptOfCore {
    Plan* plan = nullptr;         // at the end of scratch, if the next step would make the same one
    bool keeps_in_lanes = false;  // lanes pay for contacts that touch, and for those without points (step/lane_update.hpp)
    bool parts_in_lanes = false;

    void keep(Plan* made) { plan = made; }
    void forget() { plan = nullptr; }
    void note_lanes(bool keeps, bool parts) { keeps_in_lanes = keeps, parts_in_lanes = parts; }
};
template <>
struct KeptOfCore<false> {
    static constexpr Plan* plan = nullptr;
    static constexpr bool keeps_in_lanes = false, parts_in_lanes = false;

    void keep(Plan*) {}
    void forget() {}
    void note_lanes(bool, bool) {}
};

struct Core {
    Capacity capacity;
    std::uint32_t lanes = 1;  // constraints that are solved at once, at most
    // Not part of the world's value: functions that only read record errors too, and close the world while they call the user's functions.
    mutable Error last_error = Error::none;
    Error kept_error = Error::none;  // the last error before a call of another language (begin_call)
    mutable Inside inside = outside;
    std::uint8_t workers = 1;  // that run parts of this step, or ran those of the last one (data/parallel.hpp)
    ErrorHook error_hook = nullptr;
    void* error_context = nullptr;
    TaskSystem tasks;
    RecordingHead* recording = nullptr;  // what calls are written down in, or null
    Hooks hooks;
    Clock clock = nullptr;
    void* clock_context = nullptr;

    State* state = nullptr;
    Pose* poses = nullptr;
    Motion* motions = nullptr;
    Body* bodies = nullptr;
    Shape* shapes = nullptr;
    Aabb* boxes = nullptr;  // fat boxes, by shape
    Geometry* geometries = nullptr;
    std::uint32_t* geometry_buckets = nullptr;
    TreeNode* tree = nullptr;
    Contact* contacts = nullptr;
    ContactManifold* manifolds = nullptr;
    PairSet pairs;
    float* clearances = nullptr;  // m, by contact: step/clearance.hpp
    Joint* joints = nullptr;
    BitSet awake_bodies;    // dynamic and kinematic bodies that move or may move
    BitSet awake_contacts;  // contacts of an awake body
    BitSet awake_joints;    // joints of an awake body
    BitSet moved_shapes;    // shapes whose fat box changed since pairs were last found
    BitSet begins;          // within a step: contacts whose touch its end will tell; those that are contact_untold only if they have met by then

    TouchEvent* end_events = nullptr;
    TouchEvent* begin_events = nullptr;
    SensorEvents sensor_begins, sensor_ends;
    HitEvent* hit_events = nullptr;
    BodyId* moved_events = nullptr;
    BodyId* slept_events = nullptr;
    JointBreakEvent* break_events = nullptr;
    float* residuals = nullptr;  // m/s, by body: of its island in the last step, if has_residuals
    std::uint32_t begin_count = 0, end_count = 0, end_reported = 0, moved_count = 0, slept_count = 0, break_count = 0;
    std::uint32_t sensor_ends_reported = 0, hit_count = 0;
    bool exact = true;           // false: no step is taken (Error::inexact_build)
    bool has_residuals = false;  // the last step measured them; otherwise their memory may hold anything
    std::uint32_t begun = 0;     // contacts in `begins` that do begin, or whose shapes begin to overlap

    std::byte* scratch = nullptr;
    std::byte* scratch_end = nullptr;
    StepReport report;
    KeptOfCore<> kept;
    TimesOfCore<> times;

    Arena arena() const { return {scratch, kept.plan == nullptr ? scratch_end : reinterpret_cast<std::byte*>(kept.plan)}; }
    /// Constraints in a block of rows.
    std::uint32_t block_lanes() const { return max_block_lanes == 1 ? 1 : lanes < max_block_lanes ? lanes : max_block_lanes; }
    /// Whether scratch follows the world's arrays. A fleet lends its worlds scratch that lies elsewhere.
    bool owns_scratch() const { return scratch == reinterpret_cast<std::byte*>(residuals) + align_up(capacity.bodies * sizeof(float)); }
    /// Scratch with the arrays before it that a step writes at its end.
    Arena arena_until_told() const { return {owns_scratch() ? reinterpret_cast<std::byte*>(begin_events) : scratch, arena().end}; }
    /// Call this when something changes that a plan is made from: which bodies, joints and touching contacts are awake, their colours, or which kernel or tree
    /// solves a joint. (State::trees_stale tells of the last.)
    void forget_plan() { kept.forget(); }

    ISLET_SHARED void fail(Error error) const {
        last_error = error;
        if (error_hook == nullptr || inside == inside_error) return;
        const Inside before = inside;
        inside = inside_error;
        error_hook(error, error_context);
        inside = before;
    }

    BodyId body_id(std::uint32_t i) const { return {i + 1, bodies[i].generation}; }
    ShapeId shape_id(std::uint32_t i) const { return {i + 1, shapes[i].generation}; }
    JointId joint_id(std::uint32_t i) const { return {i + 1, joints[i].generation}; }
    bool is_awake(std::uint32_t body) const { return awake_bodies.test(body); }
    bool is_dynamic(std::uint32_t body) const { return bodies[body].type() == BodyType::dynamic; }

    static Core& of(World& world);
    static const Core& of(const World& world);
};

/// While it lives, nothing may change the world. Within a step, which has closed the world already, it writes nothing: so workers may make one.
struct Closed {
    const Core* core;
    explicit Closed(const Core& open) : core(open.inside == outside ? &open : nullptr) {
        if (core != nullptr) core->inside = inside_call;
    }
    ~Closed() {
        if (core != nullptr) core->inside = outside;
    }
    Closed(const Closed&) = delete;
    Closed& operator=(const Closed&) = delete;
};

static_assert(sizeof(Core) <= core_bytes);
static_assert(constraint_color_count == color_count);

/// False if continuous collision is switched off, or left out of this build: both come to the same.
inline bool is_continuous(const Core& core) { return has_continuous && core.state->continuous != 0; }
/// The same of seamless floors.
inline bool has_seamless(const Core& core) { return has_seamless_floors && core.state->catching_floors == 0; }

/// None is known from now on.
inline void forget_residuals(Core& core) {
    core.report.residual = 0;
    core.has_residuals = false;
}

/// Against gravity, unit; zero if there is none.
inline Vec2 up_of(const State& state) {
    const Vec2 g = state.gravity;
    const float strength = length(g);
    return strength > 0 && strength < 1.0e18f ? (-1 / strength) * g : Vec2{0, 0};
}

}  // namespace islet::detail

namespace islet {

ISLET_ALWAYS_INLINE inline detail::Core& World::core() { return *reinterpret_cast<detail::Core*>(core_); }
ISLET_ALWAYS_INLINE inline const detail::Core& World::core() const { return *reinterpret_cast<const detail::Core*>(core_); }

namespace detail {
inline Core& Core::of(World& world) { return world.core(); }
inline const Core& Core::of(const World& world) { return world.core(); }
}  // namespace detail

}  // namespace islet
