// World::counters: figures that are counted only when they are read.
#include "../exact.hpp"

#include "../data/core.hpp"
#include "islet/layout.hpp"

namespace islet {

using namespace detail;

WorldCounters World::counters() const {
    const Core& c = core();
    const State& state = *c.state;
    WorldCounters counters;
    counters.bytes = world_bytes(c.capacity);
    counters.snapshot_bytes = snapshot_bytes();
    counters.geometries = state.geometry_pool.count;
    counters.tree_shapes = state.tree.leaf_count;
    if (state.tree.root != null_index) counters.tree_height = c.tree[state.tree.root].height + 1;
    const auto count = [&](std::uint32_t color) { ++(color == no_color ? counters.uncolored : counters.colors[color]); };
    for_each_live(state.contact_pool, c.contacts, [&](std::uint32_t i) {
        if ((c.manifolds[i].flags & contact_touching) != 0) count(c.manifolds[i].color());
    });
    for_each_live(state.joint_pool, c.joints, [&](std::uint32_t i) { count(c.joints[i].color()); });
    return counters;
}

}  // namespace islet
