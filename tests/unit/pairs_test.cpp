// Which pairs of shapes have a contact, against a look at every two shapes.
//
// The rule: two shapes that may collide and whose tight boxes are closer than the speculative distance must have a contact. More pairs may have one
// (fat boxes are larger), but only if they may collide, and no pair has two.
#include "broadphase/pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

#include "broadphase/columns.hpp"
#include "graph/contacts.hpp"
#include "collide/manifold.hpp"
#include "support/effort.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"
#include "math/cpu.hpp"

namespace {

using namespace islet;
using namespace islet::detail;
using islet::test::Random;
using islet::test::slow_build;
using islet::test::TestWorld;

using Pairs = std::set<std::uint64_t>;

Pairs contacts_of(const World& world) {
    const detail::Core& c = detail::Core::of(world);
    Pairs pairs;
    for (std::uint32_t i = 0; i < c.state->contact_pool.high_water; ++i) {
        if (!pool_live(c.state->contact_pool, c.contacts, i)) continue;
        EXPECT_TRUE(pairs.insert(PairSet::key(c.contacts[i].shape_a, c.contacts[i].shape_b)).second) << "a pair has two contacts";
    }
    return pairs;
}

// The documented rule of filters, body types and shape types, written independently.
bool allowed(const World& w, ShapeId a, ShapeId b) {
    const BodyId body_a = w.body(a), body_b = w.body(b);
    if (body_a == body_b) return false;
    if (w.type(body_a) != BodyType::dynamic && w.type(body_b) != BodyType::dynamic) return false;
    const auto thin = [&](ShapeId s) { return w.shape_type(s) == ShapeType::segment || w.shape_type(s) == ShapeType::chain_segment; };
    if (thin(a) && thin(b)) return false;
    const Filter fa = w.filter(a), fb = w.filter(b);
    if (fa.group != 0 && fa.group == fb.group) return fa.group > 0;
    return (fa.mask & fb.category) != 0 && (fb.mask & fa.category) != 0;
}

struct Near {
    Pairs must, may;
};

Near near_pairs(const TestWorld& w) {
    std::vector<ShapeId> shapes;
    for (const BodyId body : w.bodies()) {
        ShapeId ids[16];
        const std::uint32_t n = w->shapes(body, ids);
        shapes.insert(shapes.end(), ids, ids + n);
    }
    Near near;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        for (std::size_t j = i + 1; j < shapes.size(); ++j) {
            if (!allowed(*w, shapes[i], shapes[j])) continue;
            const std::uint64_t key = PairSet::key(shapes[i].index1 - 1, shapes[j].index1 - 1);
            near.may.insert(key);
            if (overlaps(expand(w->aabb(shapes[i]), 0.999f * speculative_distance), w->aabb(shapes[j]))) near.must.insert(key);
        }
    }
    return near;
}

// One step, with the rule checked for the poses it starts from.
void step_and_check(const TestWorld& w, float dt = 1.0f / 60) {
    const Near near = near_pairs(w);
    w->step(dt);
    ASSERT_EQ(w->report().dropped_contacts, 0u);
    const Pairs found = contacts_of(*w);
    for (const std::uint64_t pair : near.must)
        ASSERT_TRUE(found.count(pair) != 0) << "shapes " << (pair & 0xffffffffu) << " and " << (pair >> 32) - 1 << " have no contact";
    for (const std::uint64_t pair : found) ASSERT_TRUE(near.may.count(pair) != 0) << "shapes that must not collide have a contact";
    const char* broken = w->validate();
    ASSERT_EQ(broken, nullptr) << broken;
}

// -- random motion -----------------------------------------------------------------------------------------------------------------------

/// Which filters random shapes get.
enum class Filters { any, layers };

// Layers, as games have them: ground; crates, which meet ground and crates; debris, which meets the ground alone.
Filter random_filter(Random& random, Filters filters) {
    if (filters == Filters::any) return {1u << random.below(3), random.below(8), static_cast<std::int32_t>(random.below(5)) - 2};
    constexpr Filter layers[] = {{1, 7, 0}, {2, 3, 0}, {4, 1, 0}, {4, 1, 0}, {4, 1, 3}};
    return layers[random.below(5)];
}

BodyId add_random(TestWorld& w, Random& random, Filters filters = Filters::any) {
    BodyDef def;
    def.type = random.one_in(4) ? BodyType::static_body : random.one_in(6) ? BodyType::kinematic : BodyType::dynamic;
    def.position = {random.between(-6, 6), random.between(-6, 6)};
    def.angle = random.between(-3, 3);
    def.linear_velocity = {random.between(-5, 5), random.between(-5, 5)};
    def.awake = !random.one_in(4);
    def.sleep_threshold = random.one_in(2) ? 10.0f : 0.05f;  // half of them doze off in mid-air
    const BodyId body = w->create_body(def);
    for (std::uint32_t n = 1 + random.below(2); n > 0; --n) {
        ShapeDef shape;
        if (filters == Filters::layers || random.one_in(3)) shape.filter = random_filter(random, filters);
        // Ground that moves would meet all.
        if (filters == Filters::layers && shape.filter.category == 1 && def.type != BodyType::static_body && !random.one_in(8)) shape.filter = {4, 1, 0};
        const Vec2 at{random.between(-0.3f, 0.3f), random.between(-0.3f, 0.3f)};
        switch (random.below(4)) {
        case 0: w->create_shape(body, Circle{at, random.between(0.1f, 0.5f)}, shape); break;
        case 1: w->create_shape(body, make_box(random.between(0.1f, 0.8f), 0.3f), shape); break;
        case 2: w->create_shape(body, Segment{at, {1, random.between(-1, 1)}}, shape); break;
        default: w->create_shape(body, Capsule{at, {0.7f, 0.7f}, 0.1f}, shape);
        }
    }
    return body;
}

void random_life(std::uint64_t seed, std::uint32_t lanes, Filters filters = Filters::any) {
    WorldDef def;
    def.gravity = {0, 0};
    def.lanes = lanes;
    TestWorld w(islet::test::roomy, def);
    Random random(seed);
    std::vector<BodyId> bodies;
    for (int i = 0; i < 60; ++i) bodies.push_back(add_random(w, random, filters));
    for (int step = 0; step < 300; ++step) {
        for (int change = 0; change < 3; ++change) {
            BodyId& body = bodies[random.below(static_cast<std::uint32_t>(bodies.size()))];
            switch (random.below(8)) {
            case 0: w->set_transform(body, {random.between(-6, 6), random.between(-6, 6)}, random.between(-3, 3)); break;
            case 1: w->destroy_body(body), body = add_random(w, random, filters); break;
            case 2: w->set_type(body, static_cast<BodyType>(random.below(3))); break;
            case 3:
                w->set_filter(w.shape_of(body), random_filter(random, filters));
                break;
            case 4: w->wake(body); break;
            default: w->set_linear_velocity(body, {random.between(-20, 20), random.between(-20, 20)});
            }
            // Nobody leaves the arena.
            if (length(w->position(body)) > 10) w->set_transform(body, {0, 0}, 0);
        }
        ASSERT_NO_FATAL_FAILURE(step_and_check(w)) << "in step " << step << ", seed " << seed;
    }
}

TEST(Pairs, EveryPairThatIsNearHasAContactThroughoutARandomLife) {
    for (std::uint64_t seed = 1; seed <= (slow_build ? 1 : 6); ++seed) ASSERT_NO_FATAL_FAILURE(random_life(seed, 0));
}

// Shapes whose filters agree with none in motion are not compared with these, only with those at rest.
TEST(Pairs, EveryPairThatIsNearHasAContactWhereLayersMeetOnlySomeOthers) {
    for (std::uint64_t seed = 20; seed < (slow_build ? 22 : 32); ++seed) ASSERT_NO_FATAL_FAILURE(random_life(seed, 0, Filters::layers));
}

TEST(Pairs, GroundThatIsCreatedBesideDebrisAtRestHasAContactWithIt) {
    WorldDef def;
    def.gravity = {0, 0};
    def.enable_sleep = false;
    TestWorld w(islet::test::roomy, def);
    ShapeDef debris;
    debris.filter = {4, 1, 0};  // it meets nothing in motion
    for (int i = 0; i < 5; ++i) w.add_circle({2.0f * static_cast<float>(i), 0}, 0.5f, debris);
    for (int i = 0; i < 3; ++i) ASSERT_NO_FATAL_FAILURE(step_and_check(w));
    ASSERT_EQ(w->contact_count(), 0u);
    const BodyId ground = w.add(make_box(20, 0.5f), {0, -1.01f}, {}, BodyType::static_body);
    ASSERT_NO_FATAL_FAILURE(step_and_check(w));
    EXPECT_EQ(w->contact_count(), 5u);
    w->set_transform(ground, {0, -9}, 0);
    ASSERT_NO_FATAL_FAILURE(step_and_check(w));
    w->set_transform(ground, {0, 1.01f}, 0);
    ASSERT_NO_FATAL_FAILURE(step_and_check(w));
    EXPECT_EQ(w->contact_count(), 5u);
}

TEST(Pairs, EveryPairThatIsNearHasAContactInAFallingHeap) {
    TestWorld w;
    w.add_ground();
    Random random(5);
    for (int i = 0; i < 150; ++i) {
        const Vec2 at{random.between(-3, 3), 1 + 0.15f * static_cast<float>(i)};
        i % 2 == 0 ? w.add_box(at, 0.3f, 0.2f) : w.add_circle(at, 0.25f);
    }
    for (int i = 0; i < (slow_build ? 40 : 200); ++i) ASSERT_NO_FATAL_FAILURE(step_and_check(w)) << "in step " << i;
}

// Of more than a hundred shapes, of which few have a changed box, only those near a change are sorted.
TEST(Pairs, EveryPairThatIsNearHasAContactInACrowdOfWhichFewMove) {
    for (const Vec2 middle : {Vec2{0, 0}, Vec2{-4000, 900}}) {
        WorldDef def;
        def.gravity = {0, 0};
        def.enable_sleep = false;
        TestWorld w(islet::test::roomy, def);
        Random random(11);
        std::vector<BodyId> bodies;
        const auto somewhere = [&] { return middle + Vec2{random.between(-60, 60), random.between(-30, 30)}; };
        for (int i = 0; i < 240; ++i) {
            const BodyId body = bodies.emplace_back(add_random(w, random));
            w->set_transform(body, somewhere(), random.between(-3, 3));
            w->set_linear_velocity(body, {0, 0});
        }
        for (int step = 0; step < (slow_build ? 20 : 120); ++step) {
            const BodyId body = bodies[random.below(240)];
            switch (step % 4) {
                case 0: w->set_transform(body, w->position(bodies[random.below(240)]) + Vec2{random.between(-1, 1), 0.5f}, 0); break;
                case 1: w->set_linear_velocity(body, {random.between(-60, 60), random.between(-60, 60)}); break;
                case 2: w->set_type(body, static_cast<BodyType>(random.below(3))); break;
                default: w->wake(body);
            }
            ASSERT_NO_FATAL_FAILURE(step_and_check(w)) << "in step " << step << " around (" << middle.x << ", " << middle.y << ")";
        }
    }
}

TEST(Pairs, TouchingBodiesFarFromTheOriginHaveContactsToo) {
    for (const Vec2 at : {Vec2{1e4f, 0}, Vec2{-1e5f, -1e5f}}) {
        TestWorld w;
        w.add(make_box(20, 1), at - Vec2{0, 1}, {}, BodyType::static_body);
        for (int i = 0; i < 10; ++i) w.add_box(at + Vec2{1.5f * static_cast<float>(i) - 7, 0.5f});
        for (int i = 0; i < 30; ++i) ASSERT_NO_FATAL_FAILURE(step_and_check(w));
        EXPECT_EQ(w->contact_count(), 10u);
    }
}

// -- what it costs -----------------------------------------------------------------------------------------------------------------------

TEST(Pairs, NothingIsLookedForWhenNothingMoved) {
    TestWorld w;
    w.add_ground();
    for (int i = 0; i < 10; ++i) w.add_box({2.0f * static_cast<float>(i), 0.5f});
    w.step(120);
    detail::Core& core = detail::Core::of(*w);
    EXPECT_EQ(core.state->moved_count, 0u);
    EXPECT_EQ(core.moved_shapes.count(), 0u);
    const std::uint64_t before = w->hash();
    find_pairs(core, 1.0f / 60);
    EXPECT_EQ(w->hash(), before);
}

TEST(Pairs, AShapeIsMarkedOnlyWhenItLeavesItsFatBox) {
    WorldDef def;
    def.gravity = {0, 0};
    TestWorld w(islet::test::roomy, def);
    const BodyId body = w.add_box({0, 0});
    w->set_linear_velocity(body, {0.6f, 0});  // a centimetre a step; the fat box leaves room for five
    int marked = 0;
    for (int i = 0; i < 60; ++i) {
        w.step();
        marked += static_cast<int>(detail::Core::of(*w).state->moved_count);
    }
    EXPECT_GE(marked, 5);
    EXPECT_LE(marked, 20);
}

// -- filters -----------------------------------------------------------------------------------------------------------------------------

bool collide_with(Filter a, Filter b, BodyType type_a = BodyType::dynamic, BodyType type_b = BodyType::dynamic) {
    TestWorld w({.bodies = 2, .shapes = 2, .contacts = 2});
    ShapeDef sa, sb;
    sa.filter = a;
    sb.filter = b;
    w.add_circle({0, 0}, 0.5f, sa, type_a);
    w.add_circle({0.5f, 0}, 0.5f, sb, type_b);
    w.step();
    return w->contact_count() == 1;
}

TEST(Filters, BothMasksMustHoldTheOthersCategory) {
    EXPECT_TRUE(collide_with({}, {}));
    EXPECT_TRUE(collide_with({.category = 2, .mask = 4}, {.category = 4, .mask = 2}));
    EXPECT_FALSE(collide_with({.category = 2, .mask = 4}, {.category = 4, .mask = 1}));
    EXPECT_FALSE(collide_with({.category = 2, .mask = 1}, {.category = 4, .mask = 2}));
    EXPECT_TRUE(collide_with({.category = 6, .mask = 8}, {.category = 12, .mask = 2})) << "one common bit is enough";
    EXPECT_FALSE(collide_with({.category = 0}, {}));
    EXPECT_TRUE(collide_with({.category = 1u << 31, .mask = 1u << 31}, {.category = 1u << 31, .mask = 1u << 31}));
}

TEST(Filters, EqualGroupsGoBeforeMasks) {
    EXPECT_TRUE(collide_with({.mask = 0, .group = 3}, {.mask = 0, .group = 3}));
    EXPECT_FALSE(collide_with({.group = -3}, {.group = -3}));
    EXPECT_TRUE(collide_with({.group = -3}, {.group = -4}));
    EXPECT_TRUE(collide_with({.group = -3}, {.group = -3 - 65536})) << "the low bits alone are the same";
    EXPECT_FALSE(collide_with({.group = -65536}, {.group = -65536})) << "the low bits are 0, as of no group";
    EXPECT_FALSE(collide_with({.group = std::numeric_limits<std::int32_t>::min()}, {.group = std::numeric_limits<std::int32_t>::min()}));
    EXPECT_TRUE(collide_with({.group = 3}, {.group = -3}));
    EXPECT_FALSE(collide_with({.mask = 0, .group = 3}, {.mask = 0, .group = 4}));
    EXPECT_FALSE(collide_with({.mask = 0, .group = 0}, {.mask = 0, .group = 0}));
}

TEST(Filters, OneOfTheTwoBodiesMustBeDynamic) {
    const BodyType types[] = {BodyType::static_body, BodyType::kinematic, BodyType::dynamic};
    for (const BodyType a : types)
        for (const BodyType b : types) EXPECT_EQ(collide_with({}, {}, a, b), a == BodyType::dynamic || b == BodyType::dynamic);
}

TEST(Filters, ShapesOfOneBodyNeverCollide) {
    TestWorld w;
    const BodyId body = w.add_box({0, 0});
    w->create_shape(body, Circle{{0.2f, 0}, 0.5f});
    w.step();
    EXPECT_EQ(w->contact_count(), 0u);
}

TEST(Columns, EveryWidthOfScanFindsTheSameBoxesInTheSameOrder) {
    Random random(7);
    std::size_t found = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const std::uint32_t count = 1 + random.below(70);
        std::vector<Aabb> boxes(count);
        // On a coarse grid, so that sides often touch.
        const auto place = [&](std::uint32_t n) { return static_cast<float>(random.below(n)); };
        for (Aabb& box : boxes) {
            box.lower = {place(40), place(8)};
            box.upper = box.lower + Vec2{place(6), place(3)};
        }
        std::sort(boxes.begin(), boxes.end(), [](const Aabb& a, const Aabb& b) { return a.lower.x < b.lower.x; });
        std::vector<float> column[4];
        for (const Aabb& box : boxes) {
            column[0].push_back(box.lower.x);
            column[1].push_back(box.upper.x);
            column[2].push_back(box.lower.y);
            column[3].push_back(box.upper.y);
        }
        for (int i = 0; i < 8; ++i)
            for (int k = 0; k < 4; ++k) column[k].push_back(k % 2 == 0 ? 3.4e38f : -3.4e38f);
        const Columns c{column[0].data(), column[1].data(), column[2].data(), column[3].data(), nullptr, nullptr, count};

        const std::uint32_t i = random.below(count), first = i + 1;
        std::vector<std::uint32_t> expected;
        for (std::uint32_t j = first; j < count; ++j)
            if (overlaps(boxes[i], boxes[j])) expected.push_back(j);
        found += expected.size();
        std::vector<std::uint32_t> room(count);
        const auto scanned = [&](std::uint32_t n) { return std::vector<std::uint32_t>(room.begin(), room.begin() + n); };
        EXPECT_EQ(scanned(scan_columns<Lane4>(c, first, c, i, room.data())), expected);
#if ISLET_MAX_LANES == 8
        if (cpu_has_avx2()) { EXPECT_EQ(scanned(scan_columns_8(c, first, c, i, room.data())), expected); }
#endif
    }
    EXPECT_GT(found, 1000u);
}

}  // namespace
