// A world continued in another block.
#include "../exact.hpp"

#include "../state/world_copy.hpp"
#include "islet/snapshot.hpp"
#include "islet/world.hpp"

namespace islet {

using namespace detail;

WorldDef detail::host_settings(const Core& core) {
    WorldDef def;
    def.lanes = core.lanes;
    def.error_hook = core.error_hook;
    def.error_context = core.error_context;
    def.hooks = core.hooks;
    def.tasks = core.tasks;
    def.clock = core.clock;
    def.clock_context = core.clock_context;
    return def;
}

World* copy_world(const World& from, span<std::byte> block, const Capacity& capacity, span<std::byte> image, Error* error) {
    const Core& core = Core::of(from);
    Error problem = core.inside != outside ? Error::in_step : image.size() < from.snapshot_bytes() ? Error::image_too_small : Error::none;
    World* world = nullptr;
    if (problem == Error::none) world = World::create(block, capacity, host_settings(core), &problem);
    if (world != nullptr && !world->restore(image.first(from.save(image)))) {
        problem = world->last_error();
        world = nullptr;
    }
    if (error != nullptr) *error = problem;
    return world;
}

}  // namespace islet
