#include "world_recording.hpp"

#include <cstdint>
#include <utility>

namespace islet::samples {

AlignedBytes::AlignedBytes(std::size_t size) : memory_(size + world_alignment), size_(size) {
    const auto address = reinterpret_cast<std::uintptr_t>(memory_.data());
    data_ = memory_.data() + (world_alignment - address % world_alignment) % world_alignment;
}

namespace {

std::size_t room_for(const World& world) { return 2 * max_snapshot_bytes(world.capacity()) + (std::size_t{1} << 20); }

}  // namespace

WorldRecording::WorldRecording(World& world) : world_(&world), memory_(room_for(world)) { world.start_recording(memory_.span()); }

void WorldRecording::after_step() {
    if (!world_->is_recording() || memory_.span().size() - world_->recorded_bytes() >= room_for(*world_)) return;
    AlignedBytes larger(2 * memory_.span().size());
    world_->move_recording(larger.span());
    memory_ = std::move(larger);
}

std::span<const std::byte> WorldRecording::finish() {
    return world_->is_recording() ? memory_.span().first(world_->stop_recording()) : std::span<std::byte>{};
}

}  // namespace islet::samples
