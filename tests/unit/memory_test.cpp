// The block of memory and what lives in it: layout, pools, bit sets, the set of pairs. Compared with the standard library's containers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "islet/islet.hpp"
#include "memory/arena.hpp"
#include "memory/bit_set.hpp"
#include "memory/pair_set.hpp"
#include "memory/pool.hpp"
#include "support/random.hpp"

namespace {

using namespace islet;
using namespace islet::detail;
using islet::test::Random;

struct Slot {
    std::uint32_t generation = 0;
    std::uint32_t next_free = null_index;
};

// -- pools ---------------------------------------------------------------------------------------------------------------------------

TEST(Pool, HandsOutFreshSlotsInOrderUntilItIsFull) {
    PoolState pool;
    Slot slots[3];
    for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(pool_take(pool, slots, 3), i);
    EXPECT_EQ(pool.count, 3u);
    EXPECT_EQ(pool_take(pool, slots, 3), null_index);
    EXPECT_EQ(pool.count, 3u);
    EXPECT_EQ(pool.high_water, 3u);
}

TEST(Pool, HandsOutTheLastFreedSlotFirst) {
    PoolState pool;
    Slot slots[4];
    for (int i = 0; i < 4; ++i) pool_take(pool, slots, 4);
    pool_give(pool, slots, 1);
    pool_give(pool, slots, 3);
    pool_give(pool, slots, 0);
    EXPECT_EQ(pool_take(pool, slots, 4), 0u);
    EXPECT_EQ(pool_take(pool, slots, 4), 3u);
    EXPECT_EQ(pool_take(pool, slots, 4), 1u);
    EXPECT_EQ(pool_take(pool, slots, 4), null_index);
}

TEST(Pool, AGenerationIsOddWhileItsSlotIsLiveAndNeverComesBack) {
    PoolState pool;
    Slot slots[1];
    std::set<std::uint32_t> seen;
    for (int i = 0; i < 1000; ++i) {
        ASSERT_EQ(pool_take(pool, slots, 1), 0u);
        EXPECT_TRUE(pool_live(pool, slots, 0));
        EXPECT_EQ(slots[0].generation % 2, 1u);
        EXPECT_TRUE(seen.insert(slots[0].generation).second);
        pool_give(pool, slots, 0);
        EXPECT_FALSE(pool_live(pool, slots, 0));
        EXPECT_EQ(slots[0].generation % 2, 0u);
    }
}

TEST(Pool, SlotsNeverUsedAreNotLiveWhateverTheirMemoryHolds) {
    PoolState pool;
    Slot slots[2];
    slots[1].generation = 77;
    pool_take(pool, slots, 2);
    EXPECT_TRUE(pool_live(pool, slots, 0));
    EXPECT_FALSE(pool_live(pool, slots, 1));
    EXPECT_FALSE(pool_live(pool, slots, null_index));
}

TEST(Pool, GivesTheSameIdsAfterTheSameCalls) {
    constexpr std::uint32_t capacity = 200;
    const auto run = [] {
        PoolState pool;
        std::vector<Slot> slots(capacity);
        std::vector<std::uint32_t> live, history;
        Random random(7);
        for (int i = 0; i < 20000; ++i) {
            if (random.one_in(2) || live.empty()) {
                const std::uint32_t index = pool_take(pool, slots.data(), capacity);
                EXPECT_EQ(index == null_index, live.size() == capacity);
                if (index == null_index) continue;
                EXPECT_EQ(std::count(live.begin(), live.end(), index), 0) << "a live slot was handed out again";
                live.push_back(index);
                history.push_back(index);
                history.push_back(slots[index].generation);
            } else {
                const std::size_t at = random.below(static_cast<std::uint32_t>(live.size()));
                pool_give(pool, slots.data(), live[at]);
                live.erase(live.begin() + static_cast<std::ptrdiff_t>(at));
            }
            EXPECT_EQ(pool.count, live.size());
        }
        return history;
    };
    EXPECT_EQ(run(), run());
}

// -- bit sets ------------------------------------------------------------------------------------------------------------------------

TEST(BitSet, HoldsWhatAStandardSetHolds) {
    constexpr std::uint32_t bits = 1000;
    std::vector<std::uint64_t> words(words_for(bits));
    const BitSet set{words.data(), static_cast<std::uint32_t>(words.size())};
    std::set<std::uint32_t> expected;
    Random random(1);
    for (int round = 0; round < 200; ++round) {
        for (int i = 0; i < 100; ++i) {
            const std::uint32_t bit = random.below(bits);
            const bool on = !random.one_in(3);
            if (random.one_in(2)) {
                set.assign(bit, on);
            } else {
                on ? set.set(bit) : set.clear(bit);
            }
            on ? void(expected.insert(bit)) : void(expected.erase(bit));
            ASSERT_EQ(set.test(bit), on);
        }
        std::vector<std::uint32_t> walked;
        set.for_each([&](std::uint32_t i) { walked.push_back(i); });
        ASSERT_EQ(walked, std::vector<std::uint32_t>(expected.begin(), expected.end())) << "not in ascending order, or not the same bits";
        ASSERT_EQ(set.count(), expected.size());
    }
    set.clear_all();
    EXPECT_EQ(set.count(), 0u);
}

TEST(BitSet, BitsMayBeClearedWhileItIsWalked) {
    std::uint64_t words[3];
    const BitSet set{words, 3};
    set.clear_all();
    for (std::uint32_t i = 0; i < 192; i += 5) set.set(i);
    const std::uint32_t before = set.count();
    std::uint32_t visited = 0;
    set.for_each([&](std::uint32_t i) {
        set.clear(i);
        ++visited;
    });
    EXPECT_EQ(visited, before);
    EXPECT_EQ(set.count(), 0u);
}

// -- pairs ---------------------------------------------------------------------------------------------------------------------------

TEST(PairSet, AKeyIsTheSameBothWaysAndNeverZero) {
    EXPECT_EQ(PairSet::key(3, 9), PairSet::key(9, 3));
    EXPECT_NE(PairSet::key(0, 0), 0u);
    std::set<std::uint64_t> keys;
    for (std::uint32_t a = 0; a < 60; ++a)
        for (std::uint32_t b = a; b < 60; ++b) EXPECT_TRUE(keys.insert(PairSet::key(a, b)).second) << a << ' ' << b;
    EXPECT_NE(PairSet::key(max_capacity - 1, max_capacity - 2), PairSet::key(max_capacity - 2, max_capacity - 3));
}

// The same random insertions and erasures as a standard set, in a table of `size` places filled up to `most` of them.
void compare_with_standard_set(std::uint32_t size, std::uint32_t most, std::uint32_t shapes) {
    std::vector<std::uint64_t> keys(size);
    PairSet set{keys.data(), size - 1};
    std::set<std::uint64_t> expected;
    std::vector<std::uint64_t> live;
    Random random(size + most);
    for (int i = 0; i < 100000; ++i) {
        const std::uint32_t a = random.below(shapes);
        const std::uint64_t key = PairSet::key(a, (a + 1 + random.below(shapes - 1)) % shapes);
        ASSERT_EQ(set.contains(key), expected.count(key) != 0);
        // Mostly full: erase only when there is no room, or one time in four.
        if (live.size() == most || (!live.empty() && random.one_in(4))) {
            const std::size_t at = random.below(static_cast<std::uint32_t>(live.size()));
            set.erase(live[at]);
            expected.erase(live[at]);
            ASSERT_FALSE(set.contains(live[at]));
            live[at] = live.back();
            live.pop_back();
        } else if (expected.insert(key).second) {
            set.insert(key);
            live.push_back(key);
            ASSERT_TRUE(set.contains(key));
        }
        if (i % 1000 != 0) continue;
        for (const std::uint64_t k : expected) ASSERT_TRUE(set.contains(k)) << "a key was lost at operation " << i;
    }
    std::size_t places = 0;
    for (const std::uint64_t k : keys) places += k != 0 ? 1u : 0u;
    EXPECT_EQ(places, expected.size());
    for (const std::uint64_t k : live) set.erase(k);
    EXPECT_EQ(std::count(keys.begin(), keys.end(), 0u), static_cast<std::ptrdiff_t>(size)) << "an emptied table still holds keys";
}

TEST(PairSet, HoldsWhatAStandardSetHoldsAtTheFillOfAWorld) { compare_with_standard_set(512, 256, 64); }
TEST(PairSet, HoldsWhatAStandardSetHoldsWhenAllPlacesButOneAreTaken) { compare_with_standard_set(64, 63, 40); }

// -- scratch -------------------------------------------------------------------------------------------------------------------------

TEST(Arena, GivesAlignedPiecesThatDoNotOverlap) {
    alignas(64) std::byte block[1024];
    Arena arena{block, block + sizeof(block)};
    const auto* a = reinterpret_cast<std::byte*>(arena.take<std::uint32_t>(3));
    const auto* b = reinterpret_cast<std::byte*>(arena.take<std::uint64_t>(9));
    const auto* c = reinterpret_cast<std::byte*>(arena.take<std::byte>(1));
    EXPECT_EQ(a, block);
    EXPECT_EQ(b, block + 64);
    EXPECT_EQ(c, block + 64 + 128);
}

// -- layout --------------------------------------------------------------------------------------------------------------------------

constexpr Capacity small{.bodies = 4, .shapes = 4, .contacts = 8};
constexpr std::size_t small_bytes = world_bytes(small);  // must be known at compile time
static_assert(small_bytes > 0 && small_bytes % world_alignment == 0);
static_assert(StaticWorld<small>::bytes == world_bytes(small));
static_assert(sizeof(StaticWorld<small>) == world_bytes(small) && alignof(StaticWorld<small>) == world_alignment);

TEST(Layout, AWorldNeverGetsSmallerWhenACapacityGrows) {
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const auto up_to = [&](std::uint32_t n) { return 1 + static_cast<std::uint32_t>(random.below(n)); };
        const Capacity c{up_to(5000), up_to(5000), up_to(20000), up_to(100), up_to(5000)};
        for (std::uint32_t Capacity::*member :
             {&Capacity::bodies, &Capacity::shapes, &Capacity::contacts, &Capacity::joints, &Capacity::geometries}) {
            Capacity more = c;
            more.*member += up_to(1000);
            ASSERT_GE(world_bytes(more), world_bytes(c));
        }
    }
}

TEST(Layout, NoGeometriesMeansAsManyAsShapes) {
    EXPECT_EQ(world_bytes({.bodies = 10, .shapes = 33, .contacts = 10}),
              world_bytes({.bodies = 10, .shapes = 33, .contacts = 10, .geometries = 33}));
    EXPECT_LT(world_bytes({.bodies = 10, .shapes = 33, .contacts = 10, .geometries = 1}),
              world_bytes({.bodies = 10, .shapes = 33, .contacts = 10}));
}

TEST(Layout, OfACapacityThatIsNotValidThereAreNoBytes) {
    for (const std::uint32_t n : {0u, max_capacity + 1, 0x80000001u, 0xffffffffu}) {
        EXPECT_EQ(world_bytes({.bodies = n, .shapes = 1, .contacts = 1}), 0u) << n;
        EXPECT_EQ(world_bytes({.bodies = 1, .shapes = n, .contacts = 1}), 0u) << n;
        EXPECT_EQ(world_bytes({.bodies = 1, .shapes = 1, .contacts = n}), 0u) << n;
    }
    EXPECT_EQ(world_bytes({.bodies = 1, .shapes = 1, .contacts = 1, .joints = 0xffffffffu}), 0u);
}

TEST(Layout, TheRegionsFollowOneAnotherAlignedToCacheLines) {
    const Layout l = layout_of({.bodies = 7, .shapes = 13, .contacts = 101, .geometries = 3});
    std::vector<std::size_t> offsets(std::begin(l.arrays), std::end(l.arrays));
    EXPECT_EQ(offsets.front(), host_bytes);
    offsets.insert(offsets.end(), {l.scratch, l.end});
    EXPECT_TRUE(std::is_sorted(offsets.begin(), offsets.end()));
    for (const std::size_t offset : offsets) EXPECT_EQ(offset % 64, 0u);
    EXPECT_EQ(l.persistent_end, l[Array::end_events]);
}

TEST(Layout, ALargePyramidNeedsAtMostFifteenHundredBytesABody) {
    constexpr Capacity large_pyramid{.bodies = 5051, .shapes = 5051, .contacts = 14950, .geometries = 2};
    constexpr std::size_t per_body = world_bytes(large_pyramid) / large_pyramid.bodies;
    RecordProperty("bytes_per_body", static_cast<int>(per_body));
    EXPECT_LE(per_body, 1500u);
}

TEST(Layout, AStaticWorldHoldsAWorldInside) {
    static StaticWorld<small> storage;
    World& world = storage.create();
    EXPECT_EQ(world.capacity(), small);
    const auto* first = reinterpret_cast<std::byte*>(&storage);
    EXPECT_EQ(reinterpret_cast<std::byte*>(&world), first);
    EXPECT_EQ(world.validate(), nullptr);
    // Creating again drops what it held.
    world.create_body({});
    EXPECT_EQ(storage.create().body_count(), 0u);
}

TEST(Layout, AStaticWorldFallsBackToTheDefaultDefinitionAndSaysWhy) {
    static StaticWorld<small> storage;
    WorldDef bad;
    bad.max_speed = -1;
    World& world = storage.create(bad);
    EXPECT_EQ(world.last_error(), Error::out_of_range);
    EXPECT_EQ(world.gravity(), WorldDef{}.gravity);
    world.step(1.0f / 60);
    EXPECT_EQ(world.step_count(), 1u);
}

TEST(Layout, AWorldDoesNotDependOnWhatItsBlockHeldBefore) {
    alignas(world_alignment) static std::byte block[small_bytes];
    std::uint64_t hashes[2];
    for (const std::byte filling : {std::byte{0}, std::byte{0xa5}}) {
        std::fill(std::begin(block), std::end(block), filling);
        World* world = World::create(block, small, {});
        ASSERT_NE(world, nullptr);
        const BodyId ground = world->create_body({});
        world->create_shape(ground, make_box(10, 1));
        BodyDef def;
        def.type = BodyType::dynamic;
        def.position = {0, 1.4f};
        world->create_shape(world->create_body(def), make_box(0.5f, 0.5f));
        for (int i = 0; i < 30; ++i) world->step(1.0f / 60);
        ASSERT_EQ(world->validate(), nullptr);
        hashes[filling == std::byte{0} ? 0 : 1] = world->hash();
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace
