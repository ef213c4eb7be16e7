#include "first_contacts.hpp"

#include <memory>

namespace islet::tools {

FirstContacts::FirstContacts(const World& world) : block_(world_bytes(world.capacity()) + world_alignment), image_(world.snapshot_bytes()), world_(&world) {
    constexpr float shortest_step = 1e-6f;  // s
    void* start = block_.data();
    std::size_t room = block_.size();
    if (std::align(world_alignment, world_bytes(world.capacity()), start, room) == nullptr) return;
    World* copy = copy_world(world, {static_cast<std::byte*>(start), room}, world.capacity(), image_);
    if (copy == nullptr) return;
    copy->set_hooks({});
    copy->step(shortest_step);
    world_ = copy;
}

}  // namespace islet::tools
