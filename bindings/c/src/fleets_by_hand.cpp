// Functions written by hand: fleets of worlds. They have no world that would record an error, so each returns it.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

namespace {

bool is_missing(const void* array, std::size_t count) { return array == nullptr && count != 0; }

/// Why a pointer to a fleet is refused; none if it is good.
IsletError why_no_fleet(const IsletFleet* fleet) {
    if (fleet == nullptr) return ISLET_ERROR_NULL_POINTER;
    return detail::is_fleet(*cast<const Fleet>(fleet)) ? ISLET_ERROR_NONE : ISLET_ERROR_NOT_A_FLEET;
}
/// The same, and whether an array is there.
IsletError why_not(const IsletFleet* fleet, bool is_array_missing) {
    const IsletError error = why_no_fleet(fleet);
    return error != ISLET_ERROR_NONE || !is_array_missing ? error : static_cast<IsletError>(ISLET_ERROR_NULL_POINTER);
}

Fleet& of(IsletFleet* fleet) { return *cast<Fleet>(fleet); }

}  // namespace

extern "C" {

size_t islet_fleet_bytes(uint32_t worlds, const IsletCapacity* capacity, uint32_t workers) {
    Room<Capacity> room;
    const Capacity* const taken = take<Capacity>(nullptr, capacity, room);
    return taken == nullptr ? 0 : Fleet::bytes(worlds, *taken, workers);
}

IsletFleet* islet_create_fleet(void* block, size_t block_bytes, const IsletWorld* prototype, uint32_t worlds, const IsletTaskSystem* tasks, IsletError* error) {
    Room<TaskSystem> room;
    const TaskSystem* const taken = take_or_default<TaskSystem>(nullptr, tasks, room);
    IsletError refused = ISLET_ERROR_NONE;
    if (taken == nullptr) refused = ISLET_ERROR_STRUCT_SIZE;
    if (block == nullptr || prototype == nullptr) refused = ISLET_ERROR_NULL_POINTER;
    if (refused == ISLET_ERROR_NONE)
        return cast<IsletFleet>(Fleet::create(span_of<std::byte>(block, block_bytes), c::of(prototype), worlds, *taken, cast<Error>(error)));
    if (error != nullptr) *error = refused;
    return nullptr;
}

uint32_t islet_fleet_size(const IsletFleet* fleet) { return why_no_fleet(fleet) == ISLET_ERROR_NONE ? cast<const Fleet>(fleet)->size() : 0; }

IsletWorld* islet_fleet_world(IsletFleet* fleet, uint32_t k) { return k < islet_fleet_size(fleet) ? cast<IsletWorld>(&of(fleet)[k]) : nullptr; }

IsletError islet_fleet_step(IsletFleet* fleet, const IsletFleetStep* what) {
    if (const IsletError error = why_not(fleet, what == nullptr); error != ISLET_ERROR_NONE) return error;
    if (what->struct_size != sizeof *what) return ISLET_ERROR_STRUCT_SIZE;
    if (is_missing(what->mask, what->mask_count) || is_missing(what->drives, what->drives_count) || is_missing(what->actions, what->actions_count) ||
        is_missing(what->senses, what->senses_count) || is_missing(what->observations, what->observations_count))
        return ISLET_ERROR_NULL_POINTER;
    FleetStep taken;
    taken.dt = what->dt;
    taken.repeat = what->repeat;
    taken.mask = {what->mask, what->mask_count};
    taken.drives = span_of<const Drive>(what->drives, what->drives_count);
    taken.actions = {what->actions, what->actions_count};
    taken.senses = span_of<const Sense>(what->senses, what->senses_count);
    taken.observations = {what->observations, what->observations_count};
    return out(of(fleet).step(taken));
}

IsletError islet_fleet_observe(IsletFleet* fleet, const IsletSense* senses, size_t senses_count, float* observations, size_t observations_count,
                               const uint8_t* mask, size_t mask_count) {
    const bool is_array_missing = is_missing(senses, senses_count) || is_missing(observations, observations_count) || is_missing(mask, mask_count);
    if (const IsletError error = why_not(fleet, is_array_missing); error != ISLET_ERROR_NONE) return error;
    return out(of(fleet).observe(span_of<const Sense>(senses, senses_count), {observations, observations_count}, {mask, mask_count}));
}

IsletError islet_fleet_reset(IsletFleet* fleet, uint32_t k, const void* image, size_t image_bytes, uint64_t seed, const IsletVariation* variations,
                             size_t variations_count) {
    const bool is_array_missing = is_missing(image, image_bytes) || is_missing(variations, variations_count);
    if (const IsletError error = why_not(fleet, is_array_missing); error != ISLET_ERROR_NONE) return error;
    return out(of(fleet).reset(k, span_of<const std::byte>(image, image_bytes), seed, span_of<const Variation>(variations, variations_count)));
}

IsletError islet_fleet_copy(IsletFleet* fleet, uint32_t from, uint32_t to) {
    const IsletError error = why_no_fleet(fleet);
    return error != ISLET_ERROR_NONE ? error : out(of(fleet).copy(from, to));
}

IsletError islet_fleet_fork(IsletFleet* fleet, const uint32_t* parents, size_t parents_count) {
    const IsletError error = why_not(fleet, is_missing(parents, parents_count));
    return error != ISLET_ERROR_NONE ? error : out(of(fleet).fork({parents, parents_count}));
}

}  // extern "C"
