#include "../exact.hpp"

#include "../bodies/geometry_pool.hpp"

namespace islet::detail {

namespace {

constexpr std::uint32_t word_count = sizeof(Geometry::words) / 4;

std::uint32_t bucket_mask(const Core& core) { return next_power_of_two(geometry_capacity(core.capacity)) - 1; }

void put_into_bucket(Core& core, std::uint32_t index) {
    Geometry& g = core.geometries[index];
    std::uint32_t& bucket = core.geometry_buckets[g.hash & bucket_mask(core)];
    g.next = bucket;
    bucket = index;
}

}  // namespace

std::uint32_t geometry_hash(const Geometry& g) {
    std::uint32_t h = 2166136261u ^ g.type;  // FNV-1a over words
    for (std::uint32_t i = 0; i < word_count; ++i) h = (h ^ g.words[i]) * 16777619u;
    return h ^ h >> 15;
}

void rebuild_buckets(Core& core) {
    std::memset(core.geometry_buckets, 0xff, (std::size_t{bucket_mask(core)} + 1) * 4);
    for (std::uint32_t i = 0; i < core.state->geometry_pool.high_water; ++i)
        if (core.geometries[i].references != 0) put_into_bucket(core, i);
}

std::uint32_t find_geometry(const Core& core, const Geometry& g) {
    const std::uint32_t hash = geometry_hash(g);
    std::uint32_t i = core.geometry_buckets[hash & bucket_mask(core)];
    for (; i != null_index; i = core.geometries[i].next) {
        const Geometry& other = core.geometries[i];
        if (other.hash == hash && other.type == g.type && std::memcmp(other.words, g.words, sizeof(g.words)) == 0) break;
    }
    return i;
}

std::uint32_t share_geometry(Core& core, const Geometry& g) {
    const std::uint32_t shared = find_geometry(core, g);
    if (shared != null_index) {
        ++core.geometries[shared].references;
        return shared;
    }
    PoolState& pool = core.state->geometry_pool;
    std::uint32_t index = pool.free_head;
    if (index != null_index) {
        pool.free_head = core.geometries[index].next;
    } else {
        if (pool.high_water == geometry_capacity(core.capacity)) return null_index;
        index = pool.high_water++;
    }
    ++pool.count;
    core.geometries[index] = g;
    core.geometries[index].references = 1;
    core.geometries[index].hash = geometry_hash(g);
    put_into_bucket(core, index);
    return index;
}

void release_geometry(Core& core, std::uint32_t index) {
    Geometry& g = core.geometries[index];
    if (--g.references != 0) return;
    std::uint32_t* place = &core.geometry_buckets[g.hash & bucket_mask(core)];
    while (*place != index) place = &core.geometries[*place].next;
    *place = g.next;
    g = Geometry{};
    PoolState& pool = core.state->geometry_pool;
    g.next = pool.free_head;
    pool.free_head = index;
    --pool.count;
}

}  // namespace islet::detail
