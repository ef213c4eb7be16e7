// A fleet: many worlds of one capacity in one block of memory, which start as copies of one world and step together, for learning, planning and search.
//
//     Fleet* fleet = Fleet::create(block, prototype, 1024);
//     const Drive drives[] = {{.kind = DriveKind::force_x, .body = cart, .scale = 10}};
//     const Sense senses[] = {{.kind = SenseKind::joint, .joint = hinge}, {.kind = SenseKind::position, .body = cart}};
//     fleet->step({.dt = 1.0f / 60, .drives = drives, .actions = actions, .senses = senses, .observations = observations});
//
// Actions and observations are flat arrays of floats, world after world. Because all worlds are copies, an id of the prototype names the same object in each.
// The worlds do not affect each other: each gives the same bits as a single world, for any number of worlds and workers.
#pragma once

#include <cstddef>
#include <cstdint>

#include "islet/layout.hpp"
#include "islet/span.hpp"
#include "islet/tasks.hpp"
#include "islet/types.hpp"
#include "islet/world.hpp"

ISLET_API_BEGIN
namespace islet {

/// What an action does to a world before a step.
enum class DriveKind : std::uint8_t {
    force_x,       ///< N on the body's centre of mass, along the world's x, during the next step
    force_y,       ///< the same along y
    torque,        ///< N m on the body, during the next step
    joint_torque,  ///< N m on body_b of the joint, and its opposite on body_a, during the next step
    motor_speed,   ///< the speed of the joint's motor, rad/s or m/s, until it is changed again
    motor_force,   ///< the greatest force of the joint's motor, N m or N: of the action's absolute value
    target_x,      ///< the target of a mouse joint, m in the world
    target_y,      ///< the same for y
};

/// One column of the actions.
struct Drive {
    DriveKind kind = DriveKind::force_x;
    BodyId body = {};
    JointId joint = {};
    float scale = 1;  ///< Dimensionless factor of the action. Finite.
};

/// What an observation tells of a world after a step.
enum class SenseKind : std::uint8_t {
    position,          ///< 2 columns: of the body's origin in the world, m
    rotation,          ///< 2 columns: cosine and sine of the body's angle
    velocity,          ///< 2 columns: of the body's centre of mass, m/s
    angular_velocity,  ///< 1 column, rad/s
    joint,             ///< 2 columns: the joint's position (rad or m) and speed
    touching,          ///< 1 column: 1 if a shape of the body touches another, else 0
    ray,               ///< 1 column: the fraction of a ray, fixed to the body, at which it meets a shape of another body; 1 if it meets none
};

/// One to two columns of the observations (SenseKind).
struct Sense {
    SenseKind kind = SenseKind::position;
    BodyId body = {};
    JointId joint = {};
    Vec2 origin = {};         ///< m, where a ray starts, in the body's frame
    Vec2 translation = {};    ///< m, from there to its end, in the body's frame
    QueryFilter filter = {};  ///< what a ray can meet
};

/// Columns that these senses fill; 0 for a sense of an unknown kind.
std::uint32_t columns(span<const Sense> senses);

/// What Fleet::step does. Empty spans stand for nothing to do; all arrays are read and written during the call only.
struct FleetStep {
    float dt = 1.0f / 60;                ///< s, min_time_step to 1
    std::uint32_t repeat = 1;            ///< Steps of each world, 1 to 1000; each repeats the actions.
    span<const std::uint8_t> mask = {};  ///< size() numbers: where one is 0, that world stays as it is. Empty: all step.
    span<const Drive> drives = {};
    span<const float> actions = {};  ///< Fleet::size() rows of drives.size() numbers. Finite.
    span<const Sense> senses = {};
    span<float> observations = {};  ///< Fleet::size() rows of columns(senses) numbers. Rows of worlds that did not step stay as they are.
};

/// A random change of one body, so that starts differ. Each number is half the width of a range around 0, >= 0.
struct Variation {
    BodyId body = {};
    Vec2 position = {};          ///< m
    float angle = 0;             ///< rad
    Vec2 velocity = {};          ///< m/s
    float angular_velocity = 0;  ///< rad/s
};

class Fleet;

namespace detail {
/// For the C interface: whether Fleet::create made this fleet at this address.
bool is_fleet(const Fleet& fleet);
}  // namespace detail

/// A fleet lives at the start of the block of memory it was created in, and its worlds behind it; it never moves, allocates or frees. Not copyable.
///
/// Its functions check their arguments as a world's do: on bad input they change nothing and return the error. The worlds share the memory that a step needs,
/// so they take far less memory than as many single worlds. Therefore no two of them may step, save, validate or draw at the same time on threads of yours:
/// step() uses the threads for you.
class Fleet {
public:
    /// Bytes of memory that a fleet needs; 0 if the capacity is not valid, or there is no world or no worker, or more than max_worlds or max_workers.
    static constexpr std::size_t bytes(std::uint32_t worlds, const Capacity& capacity, std::uint32_t workers = 1) {
        if (!is_valid(capacity) || worlds == 0 || worlds > max_worlds || workers == 0 || workers > max_workers) return 0;
        return head_bytes + std::size_t{workers} * worker_bytes(worlds, capacity) + std::size_t{worlds} * detail::fleet_stride(detail::layout_of(capacity));
    }
    static constexpr std::uint32_t max_worlds = 1u << 20;

    /// Makes a fleet of `worlds` copies of `prototype` in `block`, which must be aligned to world_alignment and hold at least bytes(worlds, the prototype's
    /// capacity, tasks.workers) bytes. The worlds have the prototype's state, settings and hooks, but no recording and no clock; each steps on one thread, and
    /// `tasks` steps many at a time. Hooks are then called on several threads at once. Returns null with *error set, if given: block_too_small;
    /// block_misaligned; out_of_range (of worlds or workers); in_step (of the prototype).
    static Fleet* create(span<std::byte> block, const World& prototype, std::uint32_t worlds, const TaskSystem& tasks = {}, Error* error = nullptr);

    Fleet(const Fleet&) = delete;
    Fleet& operator=(const Fleet&) = delete;

    /// How many worlds there are.
    std::uint32_t size() const { return size_; }
    /// World k, 0 <= k < size(). It can be read and changed like any other.
    World& operator[](std::uint32_t k);
    const World& operator[](std::uint32_t k) const;

    /// In each world that the mask names: applies the actions and steps, `repeat` times, then observes. An action or a sense whose body or joint is gone from a
    /// world, or is of the wrong type, does nothing there, or reads 0. Errors: bad_time_step; out_of_range (repeat, an unknown kind, spans of other sizes);
    /// not_finite (an action, a scale or a ray); null_id (of the body or joint that a kind needs).
    Error step(const FleetStep& what);

    /// Observes without a step. Errors as in step.
    Error observe(span<const Sense> senses, span<float> observations, span<const std::uint8_t> mask = {});

    /// Takes world k back to an image made by this program (World::save of a world of no greater capacity), and changes bodies at random: the same seed gives
    /// the same changes. Errors: out_of_range (k, or a negative width); not_finite; those of World::restore. A body that the image does not hold
    /// is left out.
    Error reset(std::uint32_t k, span<const std::byte> image, std::uint64_t seed = 0, span<const Variation> variations = {});

    /// Makes world `to` a copy of world `from`; a recording of `to` ends. Errors: out_of_range.
    Error copy(std::uint32_t from, std::uint32_t to);

    /// Makes each world k a copy of world parents[k], at once, to go on with the best futures of a search. A parent must be its own parent,
    /// parents[parents[k]] == parents[k], so it stays as it is, and so does a recording of it. Errors: out_of_range (a parent that breaks this rule, or another
    /// number of parents than size()).
    Error fork(span<const std::uint32_t> parents);

private:
    Fleet() = default;
    friend bool detail::is_fleet(const Fleet& fleet);
    static constexpr std::size_t head_bytes = 128;
    static constexpr std::size_t worker_bytes(std::uint32_t worlds, const Capacity& capacity) {
        const std::size_t bytes = detail::worlds_together(capacity, worlds) * detail::align_up(detail::scratch_bytes(capacity, true));
        return (bytes + alignof(World) - 1) / alignof(World) * alignof(World);  // the worlds come behind it
    }
    void lend_scratch(std::uint32_t k, std::uint32_t worker);
    void step_worlds(const FleetStep& what, std::uint32_t first, std::uint32_t end, std::uint32_t worker);

    const Fleet* self_ = nullptr;  // where the fleet is, by which a fleet is known
    std::uint32_t size_ = 0;
    std::byte* worlds_ = nullptr;   // the first world's block
    std::size_t stride_ = 0;        // bytes from a world's block to the next
    std::byte* scratch_ = nullptr;  // the first worker's
    std::size_t scratch_bytes_ = 0;
    TaskSystem tasks_;
};

}  // namespace islet
ISLET_API_END
