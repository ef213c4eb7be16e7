// A fleet: its block, and worlds as copies of each other.
#include "../exact.hpp"

#include "islet/fleet.hpp"

#include "../calls/checks.hpp"
#include "../fleet/fleet_columns.hpp"
#include "../fleet/group_step.hpp"
#include "../math/float_mode.hpp"
#include "../memory/place.hpp"
#include "../state/world_copy.hpp"

namespace islet {

using namespace detail;

namespace {

/// 64 random bits. The numbers are those of SplitMix64 (Steele, Lea, Flood 2014).
std::uint64_t next_random(std::uint64_t& state) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

/// Evenly distributed from -width to width.
float random_within(std::uint64_t& state, float width) { return (static_cast<float>(next_random(state) >> 40) * 0x1p-23f - 1) * width; }

Error check_variation(const Variation& v) {
    if (!all_finite(v.position.x, v.position.y, v.angle, v.velocity.x, v.velocity.y, v.angular_velocity)) return Error::not_finite;
    const float least = min(min(min(v.position.x, v.position.y), min(v.velocity.x, v.velocity.y)), min(v.angle, v.angular_velocity));
    return least >= 0 ? Error::none : Error::out_of_range;
}

void vary(World& world, const Variation& v, std::uint64_t& random) {
    const Vec2 by = {random_within(random, v.position.x), random_within(random, v.position.y)};
    const float turn = random_within(random, v.angle);
    const Vec2 faster = {random_within(random, v.velocity.x), random_within(random, v.velocity.y)};
    const float spin = random_within(random, v.angular_velocity);
    if (!world.is_valid(v.body)) return;
    const Transform at = world.transform(v.body);
    if (v.position != Vec2{0, 0} || v.angle != 0) world.set_transform(v.body, {at.p + by, at.q * make_rot(turn)});
    if (v.velocity != Vec2{0, 0}) world.set_linear_velocity(v.body, world.linear_velocity(v.body) + faster);
    if (v.angular_velocity != 0) world.set_angular_velocity(v.body, world.angular_velocity(v.body) + spin);
}

/// The first error that check(item) gives, or none.
template <class Items, class Check>
Error first_error(const Items& items, Check&& check) {
    for (const auto& item : items)
        if (const Error error = check(item); error != Error::none) return error;
    return Error::none;
}

Error check_senses(const Fleet& fleet, span<const Sense> senses, span<float> observations, span<const std::uint8_t> mask) {
    if (!mask.empty() && mask.size() != fleet.size()) return Error::out_of_range;
    if (observations.size() != std::size_t{fleet.size()} * columns(senses)) return Error::out_of_range;
    return first_error(senses, check_sense);
}

Error check_step(const Fleet& fleet, const FleetStep& what) {
    if (!is_time_step(what.dt)) return Error::bad_time_step;
    if (what.repeat == 0 || what.repeat > 1000 || what.actions.size() != std::size_t{fleet.size()} * what.drives.size()) return Error::out_of_range;
    Error error = check_senses(fleet, what.senses, what.observations, what.mask);
    if (error == Error::none) error = first_error(what.drives, check_drive);
    if (error == Error::none) error = first_error(what.actions, [](float action) { return is_finite(action) ? Error::none : Error::not_finite; });
    return error;
}

// Worlds of odd capacities are aligned, too.
constexpr Capacity odd_capacity{.bodies = 5, .shapes = 7, .contacts = 11};
constexpr std::size_t odd_stride = fleet_stride(layout_of(odd_capacity));
static_assert(odd_stride % alignof(World) == 0 && (Fleet::bytes(1, odd_capacity) - odd_stride) % alignof(World) == 0);

/// Worlds that a worker takes at a time.
constexpr std::uint32_t worlds_at_a_time = max_block_lanes > 4 ? max_block_lanes : 4;

/// Calls work(first, end, worker) for ranges that together are the worlds k < count. Each worker takes the next worlds until none are left, so none waits for
/// another.
template <class Work>
void for_worlds(const TaskSystem& tasks, std::uint32_t count, Work&& work) {
    struct Queue {
        Work& work;
        std::uint32_t count, next;
        static void run(void* data, std::uint32_t worker) {
            const DefaultFloatMode mode;  // each thread has its own
            Queue& queue = *static_cast<Queue*>(data);
            for (;;) {
                const std::uint32_t first = __atomic_fetch_add(&queue.next, worlds_at_a_time, __ATOMIC_RELAXED);
                if (first >= queue.count) return;
                queue.work(first, queue.count - first < worlds_at_a_time ? queue.count : first + worlds_at_a_time, worker);
            }
        }
    } queue{work, count, 0};
#if ISLET_THREADS
    if (tasks.parallel_for != nullptr && tasks.workers > 1 && count > worlds_at_a_time)
        return tasks.parallel_for(tasks.context, tasks.workers, Queue::run, &queue);
#else
    static_cast<void>(tasks);
#endif
    Queue::run(&queue, 0);
}

bool is_chosen(span<const std::uint8_t> mask, std::uint32_t k) { return mask.empty() || mask[k] != 0; }

}  // namespace

Fleet* Fleet::create(span<std::byte> block, const World& prototype, std::uint32_t worlds, const TaskSystem& tasks, Error* error) {
    const Core& from = Core::of(prototype);
    const std::size_t wanted = bytes(worlds, from.capacity, tasks.workers);
    Error problem = Error::none;
    if (reinterpret_cast<std::uintptr_t>(block.data()) % world_alignment != 0) problem = Error::block_misaligned;
    if (block.data() == nullptr || block.size() < wanted) problem = Error::block_too_small;
    if (wanted == 0) problem = Error::out_of_range;
    if (from.inside != outside) problem = Error::in_step;
    if (error != nullptr) *error = problem;
    if (problem != Error::none) return nullptr;

    const Layout layout = layout_of(from.capacity);
    Fleet& fleet = *new (block.data(), IsletPlace{}) Fleet;
    fleet.self_ = &fleet;
    fleet.size_ = worlds;
    fleet.tasks_ = tasks;
    fleet.scratch_ = block.data() + head_bytes;
    fleet.scratch_bytes_ = worker_bytes(worlds, from.capacity);
    fleet.worlds_ = fleet.scratch_ + tasks.workers * fleet.scratch_bytes_;
    fleet.stride_ = fleet_stride(layout);
    WorldDef def = host_settings(from);
    def.tasks = {};
    def.clock = nullptr;
    for (std::uint32_t k = 0; k < worlds; ++k) {
        Core& core = Core::of(create_static(fleet.worlds_ + k * fleet.stride_, from.capacity, layout, def));
        fleet.lend_scratch(k, 0);
        copy_state(from, core);
    }
    return &fleet;
}

bool detail::is_fleet(const Fleet& fleet) { return fleet.self_ == &fleet; }

World& Fleet::operator[](std::uint32_t k) { return *reinterpret_cast<World*>(worlds_ + k * stride_); }
const World& Fleet::operator[](std::uint32_t k) const { return *reinterpret_cast<const World*>(worlds_ + k * stride_); }

void Fleet::lend_scratch(std::uint32_t k, std::uint32_t worker) {
    Core& core = Core::of((*this)[k]);
    core.scratch = scratch_ + worker * scratch_bytes_;
    core.scratch_end = core.scratch + scratch_bytes_;
}

// Steps and observes worlds first <= k < end.
void Fleet::step_worlds(const FleetStep& what, std::uint32_t first, std::uint32_t end, std::uint32_t worker) {
    const auto act_on = [&](std::uint32_t k) ISLET_INLINED_LAMBDA { act((*this)[k], what.drives, what.actions.data() + k * what.drives.size()); };
    bool grouped = false;
    if constexpr (max_lanes > 1) {
        World* chosen[worlds_at_a_time];
        std::uint32_t place[worlds_at_a_time], count = 0;
        for (std::uint32_t k = first; k < end; ++k) {
            if (!is_chosen(what.mask, k)) continue;
            chosen[count] = &(*this)[k];
            place[count++] = k;
        }
        grouped = count > 1 && worlds_together(chosen[0]->capacity(), size_) > 1;
        const Arena arena{scratch_ + worker * scratch_bytes_, scratch_ + (worker + 1) * scratch_bytes_};
        for (std::uint32_t step = 0; grouped && step < what.repeat; ++step) {
            for (std::uint32_t i = 0; i < count; ++i) {
                lend_scratch(place[i], worker);
                act_on(place[i]);
            }
            step_group(chosen, count, arena, what.dt);
        }
    }
    const std::size_t wide = columns(what.senses);
    for (std::uint32_t k = first; k < end; ++k) {
        if (!is_chosen(what.mask, k)) continue;
        World& world = (*this)[k];
        lend_scratch(k, worker);
        for (std::uint32_t step = 0; !grouped && step < what.repeat; ++step) {
            act_on(k);
            world.step(what.dt);
        }
        detail::observe(world, what.senses, what.observations.data() + k * wide);
    }
}

Error Fleet::step(const FleetStep& what) {
    const Error error = check_step(*this, what);
    if (error != Error::none) return error;
    for_worlds(tasks_, size_,
               [&](std::uint32_t first, std::uint32_t end, std::uint32_t worker) ISLET_INLINED_LAMBDA { step_worlds(what, first, end, worker); });
    return Error::none;
}

Error Fleet::observe(span<const Sense> senses, span<float> observations, span<const std::uint8_t> mask) {
    const Error error = check_senses(*this, senses, observations, mask);
    if (error != Error::none) return error;
    const std::size_t wide = columns(senses);
    for_worlds(tasks_, size_, [&](std::uint32_t first, std::uint32_t end, std::uint32_t) ISLET_INLINED_LAMBDA {
        for (std::uint32_t k = first; k < end; ++k)
            if (is_chosen(mask, k)) detail::observe((*this)[k], senses, observations.data() + k * wide);
    });
    return Error::none;
}

Error Fleet::reset(std::uint32_t k, span<const std::byte> image, std::uint64_t seed, span<const Variation> variations) {
    if (k >= size_) return Error::out_of_range;
    const Error error = first_error(variations, check_variation);
    if (error != Error::none) return error;
    World& world = (*this)[k];
    if (!world.restore(image)) return world.last_error();
    for (const Variation& v : variations) vary(world, v, seed);
    return Error::none;
}

Error Fleet::copy(std::uint32_t from, std::uint32_t to) {
    if (from >= size_ || to >= size_) return Error::out_of_range;
    if (from != to) copy_state(Core::of((*this)[from]), Core::of((*this)[to]));
    return Error::none;
}

Error Fleet::fork(span<const std::uint32_t> parents) {
    if (parents.size() != size_) return Error::out_of_range;
    for (const std::uint32_t parent : parents)
        if (parent >= size_ || parents[parent] != parent) return Error::out_of_range;
    for_worlds(tasks_, size_, [&](std::uint32_t first, std::uint32_t end, std::uint32_t) ISLET_INLINED_LAMBDA {
        for (std::uint32_t k = first; k < end; ++k) copy(parents[k], k);
    });
    return Error::none;
}

}  // namespace islet
