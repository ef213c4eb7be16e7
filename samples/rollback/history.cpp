#include "history.hpp"

#include <algorithm>
#include <utility>

namespace islet::rollback {

History::History(const Capacity& capacity, int frames, Keep keep) : keep_(keep), ring_(static_cast<std::size_t>(frames)) {
    const std::size_t most = max_snapshot_bytes(capacity);
    if (keep_ == Keep::images) {
        for (Block& image : ring_) image.memory.resize(most);
    } else {
        image_.memory.resize(most);
        spare_.memory.resize(most);
        packed_.resize(max_delta_bytes(most));
    }
}

void History::save(const World& world, int frame) {
    if (frame == newest_) return;
    if (keep_ == Keep::images) {
        Block& image = ring_[slot(frame)];
        image.bytes = world.save(image.memory);
    } else {
        std::swap(image_, spare_);
        image_.bytes = world.save(image_.memory);
        if (kept_ > 0) {
            Block& way_back = ring_[slot(frame)];
            way_back.bytes = delta(image_.used(), spare_.used(), packed_);
            way_back.memory.assign(packed_.data(), packed_.data() + way_back.bytes);
        }
    }
    newest_ = frame;
    kept_ = std::min(kept_ + 1, static_cast<int>(ring_.size()));
}

bool History::restore(World& world, int frame) {
    if (frame > newest_ || frame <= newest_ - kept_) return false;
    for (; newest_ > frame; --newest_, --kept_) {
        if (keep_ == Keep::images) continue;
        spare_.bytes = apply(image_.used(), ring_[slot(newest_)].used(), spare_.memory);
        std::swap(image_, spare_);
    }
    return world.restore(keep_ == Keep::images ? ring_[slot(frame)].used() : image_.used());
}

std::size_t History::bytes() const {
    std::size_t sum = image_.bytes;
    for (int frame = newest_ - kept_ + 1; frame <= newest_; ++frame) sum += ring_[slot(frame)].bytes;
    return sum;
}

}  // namespace islet::rollback
