// Islands, batches and colours against a search through the graph of touching contacts.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "island/batches.hpp"
#include "support/effort.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace {

using namespace islet;
using namespace islet::detail;
using islet::test::Random;
using islet::test::TestWorld;

struct Touch {
    std::uint32_t contact, body_a, body_b;
};

// The touching contacts of awake bodies; by the flag, since one that is made ahead is solved before the user hears of it.
std::vector<Touch> touches_of(const TestWorld& w) {
    const Core& core = Core::of(*w);
    std::vector<Touch> touches;
    for (std::uint32_t slot = 0; slot < w->capacity().contacts; ++slot) {
        if (!pool_live(core.state->contact_pool, core.contacts, slot)) continue;
        const ContactManifold& m = core.manifolds[slot];
        if ((m.flags & contact_touching) != 0 && (core.is_awake(m.body_a) || core.is_awake(m.body_b))) touches.push_back({slot, m.body_a, m.body_b});
    }
    return touches;
}

// The smallest body that each awake dynamic body is linked to, by spreading labels until nothing changes.
std::map<std::uint32_t, std::uint32_t> components(const TestWorld& w, const std::vector<Touch>& touches) {
    std::map<std::uint32_t, std::uint32_t> label;
    for (const BodyId id : w.bodies())
        if (w->type(id) == BodyType::dynamic && w->is_awake(id)) label[id.index1 - 1] = id.index1 - 1;
    for (bool changed = true; changed;) {
        changed = false;
        for (const Touch& t : touches) {
            if (label.count(t.body_a) == 0 || label.count(t.body_b) == 0) continue;
            const std::uint32_t low = std::min(label[t.body_a], label[t.body_b]);
            changed |= label[t.body_a] != low || label[t.body_b] != low;
            label[t.body_a] = label[t.body_b] = low;
        }
    }
    return label;
}

void check_islands(const Plan& plan, const std::map<std::uint32_t, std::uint32_t>& label) {
    std::map<std::uint32_t, std::uint32_t> island_of_label;
    std::set<std::uint32_t> islands;
    for (const auto& [body, component] : label) {
        const std::uint32_t slot = plan.slot_of[body];
        ASSERT_NE(slot, 0u);
        ASSERT_LT(slot, plan.slot_count);
        ASSERT_EQ(plan.body_of[slot], body);
        const std::uint32_t island = plan.island_of[slot];
        ASSERT_LT(island, plan.island_count);
        islands.insert(island);
        const auto [known, is_new] = island_of_label.emplace(component, island);
        ASSERT_EQ(known->second, island) << "linked bodies are in different islands";
    }
    ASSERT_EQ(islands.size(), island_of_label.size()) << "bodies that are not linked share an island";
    ASSERT_EQ(plan.island_count, islands.size());
}

void check_batches(const Core& core, const Plan& plan, const std::vector<Touch>& touches) {
    std::map<std::uint32_t, int> planned;
    std::vector<int> owner(plan.slot_count, -1);
    for (std::uint32_t b = 0; b < plan.batch_count; ++b) {
        for (std::uint32_t slot = plan.batches[b].first_slot; slot < plan.batches[b].end_slot(); ++slot) {
            ASSERT_EQ(owner[slot], -1) << "a body is in two batches";
            owner[slot] = static_cast<int>(b);
        }
    }
    for (std::uint32_t slot = 1; slot < plan.slot_count; ++slot) ASSERT_NE(owner[slot], -1) << "a body is in no batch";

    const std::uint32_t lanes = core.block_lanes();
    const auto place = [&](std::uint32_t contact, std::uint32_t batch, std::set<std::uint32_t>* used) {
        ++planned[contact];
        const ContactManifold& m = core.manifolds[contact];
        for (const std::uint32_t body : {m.body_a, m.body_b}) {
            const std::uint32_t slot = plan.slot_of[body];
            if (slot != 0) { ASSERT_EQ(owner[slot], static_cast<int>(batch)) << "a contact acts on a body of another batch"; }
            if (used != nullptr && core.is_dynamic(body)) {
                ASSERT_TRUE(used->insert(body).second) << "two contacts of a colour share a body";
            }
        }
    };
    for (std::uint32_t b = 0; b < plan.batch_count; ++b) {
        const Batch& batch = plan.batches[b];
        for (std::uint32_t color = 0; color < color_count; ++color) {
            std::set<std::uint32_t> used;
            bool others = false;
            for (std::uint32_t row = batch.first_block[color] * lanes; row < batch.first_block[color + 1] * lanes; ++row) {
                if (plan.contacts[row] == null_index) continue;
                ASSERT_NO_FATAL_FAILURE(place(plan.contacts[row], b, &used));
                const bool lands = (core.manifolds[plan.contacts[row]].flags & contact_ahead) != 0;
                ASSERT_FALSE(lands && others && max_lanes > 1) << "a contact that lands comes after one that does not";
                others |= !lands;
            }
        }
        for (std::uint32_t i = batch.first_overflow; i < batch.end_overflow; ++i)
            ASSERT_NO_FATAL_FAILURE(place(plan.contacts[std::size_t{plan.block_count} * lanes + i], b, nullptr));
    }
    ASSERT_EQ(planned.size(), touches.size());
    for (const Touch& t : touches) ASSERT_EQ(planned[t.contact], 1) << "contact " << t.contact;
    ASSERT_EQ(plan.touching_count, touches.size());
}

void check_plan(const TestWorld& w) {
    const Core& core = Core::of(*w);
    const std::vector<Touch> touches = touches_of(w);
    Arena arena = core.arena();
    const Plan plan = make_plan(core, arena);
    ASSERT_NO_FATAL_FAILURE(check_islands(plan, components(w, touches)));
    ASSERT_NO_FATAL_FAILURE(check_batches(core, plan, touches));
}

WorldDef with_lanes(std::uint32_t lanes, bool sleep = true) {
    WorldDef def;
    def.lanes = lanes;
    def.enable_sleep = sleep;
    return def;
}

TEST(Islands, StaticAndKinematicBodiesLinkNothing) {
    TestWorld w;
    w.add_ground();
    for (int i = 0; i < 4; ++i) w.add_box({3.0f * static_cast<float>(i), 0.5f});
    const BodyId shelf = w.add_box({0, 10}, 10, 0.5f, {}, BodyType::kinematic);
    w->set_linear_velocity(shelf, {0, 0.1f});
    for (int i = 0; i < 3; ++i) w.add_box({3.0f * static_cast<float>(i), 11});
    w.step(5);
    EXPECT_EQ(w->report().islands, 7u);
    ASSERT_NO_FATAL_FAILURE(check_plan(w));
}

TEST(Islands, LinkAsSoonAsTheyTouchAndSplitAsSoonAsTheyPart) {
    WorldDef def = with_lanes(0, false);
    def.gravity = {0, 0};
    TestWorld w(islet::test::roomy, def);
    const BodyId left = w.add_circle({-2, 0});
    const BodyId right = w.add_circle({2, 0});
    w->set_linear_velocity(left, {3, 0});
    w->set_linear_velocity(right, {-3, 0});
    w->set_restitution(w.shape_of(left), 1);
    bool linked = false, split = false;
    for (int i = 0; i < 120; ++i) {
        w.step();
        const bool touching = w->report().touching_contacts != 0;
        EXPECT_EQ(w->report().islands, touching ? 1u : 2u);
        linked |= touching;
        split |= linked && !touching;
        ASSERT_NO_FATAL_FAILURE(check_plan(w));
    }
    EXPECT_TRUE(linked);
    EXPECT_TRUE(split);
}

TEST(Islands, ATowerSplitsWhereABoxIsTakenOut) {
    TestWorld w(islet::test::roomy, with_lanes(0, false));
    w.add_ground();
    std::vector<BodyId> tower;
    for (int i = 0; i < 9; ++i) tower.push_back(w.add_box({0, 0.5f + static_cast<float>(i)}));
    w.step(10);
    EXPECT_EQ(w->report().islands, 1u);
    w->destroy_body(tower[4]);
    w.step();
    EXPECT_EQ(w->report().islands, 2u);
    ASSERT_NO_FATAL_FAILURE(check_plan(w));
    w.step(60);
    EXPECT_EQ(w->report().islands, 1u) << "the upper half has landed on the lower";
}

TEST(Islands, MatchASearchThroughTheGraphInARandomHeap) {
    for (const std::uint32_t lanes : {1u, 4u, 8u, 16u}) {
        TestWorld w(islet::test::roomy, with_lanes(lanes));
        Random random(lanes);
        w.add_ground(0, 30);
        const BodyId lift = w.add_box({0, 3}, 2, 0.2f, {}, BodyType::kinematic);
        for (int i = 0; i < 150; ++i) {
            const Vec2 at{random.between(-25, 25), random.between(0.5f, 12)};
            random.one_in(2) ? w.add_box(at, random.between(0.2f, 0.8f), 0.3f) : w.add_circle(at, random.between(0.1f, 0.5f));
        }
        for (int i = 0; i < (islet::test::slow_build ? 50 : 250); ++i) {
            w->set_linear_velocity(lift, {0, i % 60 < 30 ? 1.0f : -1.0f});
            w.step();
            ASSERT_NO_FATAL_FAILURE(check_plan(w)) << "in step " << i << ", " << lanes << " lanes";
            ASSERT_EQ(w->validate(), nullptr);
        }
    }
}

TEST(Islands, ManySmallOnesShareBatchesAndALargeOneIsSplitOverNone) {
    TestWorld w({.bodies = 1200, .shapes = 1200, .contacts = 12000}, with_lanes(0, false));
    w.add_ground(0, 3000);
    // A wall of 30 x 30 in one island, and 200 pairs.
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 30; ++x) w.add_box({static_cast<float>(x), 0.5f + static_cast<float>(y)});
    for (int i = 0; i < 100; ++i)
        w.add_box({100 + 3.0f * static_cast<float>(i), 0.5f}), w.add_box({100 + 3.0f * static_cast<float>(i), 1.5f});
    w.step(3);
    EXPECT_EQ(w->report().islands, 101u);
    EXPECT_GT(w->report().batches, 1u);
    EXPECT_LT(w->report().batches, 20u);
    ASSERT_NO_FATAL_FAILURE(check_plan(w));
}

TEST(Colors, ABodyWithMoreContactsThanColorsOverflowsAndStillEveryContactIsSolved) {
    WorldDef def = with_lanes(0, false);
    def.gravity = {0, 0};
    TestWorld w(islet::test::roomy, def);
    const float big = 5;
    w.add_circle({0, 0}, big);
    const int count = 60;
    for (int i = 0; i < count; ++i) {
        const Rot q = make_rot(2 * pi * static_cast<float>(i) / count);
        w.add_circle((big + 0.2f) * Vec2{q.c, q.s}, 0.2f);
    }
    w.step();
    EXPECT_EQ(w->report().touching_contacts, static_cast<std::uint32_t>(count));
    EXPECT_GE(w->report().overflow_contacts, static_cast<std::uint32_t>(count) - color_count);
    EXPECT_GT(w->report().overflow_contacts, 0u);
    ASSERT_NO_FATAL_FAILURE(check_plan(w));
    w.step(60);
    EXPECT_EQ(w->validate(), nullptr);
}

TEST(Colors, BeginWithTheContactsThatLand) {
    TestWorld w(islet::test::roomy, with_lanes(0, false));
    Random random(1);
    w.add_ground(0, 100);
    for (int i = 0; i < 60; ++i) w.add_box({-60 + 2.0f * static_cast<float>(i), random.between(0.5f, 6)});  // each lands by itself, in a step of its own
    int mixed = 0;                                                                                          // steps with contacts of both kinds
    for (int i = 0; i < 90; ++i) {
        w.step();
        const Core& core = Core::of(*w);
        std::size_t landing = 0;
        const std::vector<Touch> touches = touches_of(w);
        for (const Touch& t : touches) landing += (core.manifolds[t.contact].flags & contact_ahead) != 0;
        mixed += landing != 0 && landing < touches.size();
        ASSERT_NO_FATAL_FAILURE(check_plan(w)) << "in step " << i;
    }
    EXPECT_GT(mixed, 20);
}

TEST(Colors, OfTheGroundAreSolvedLast) {
    TestWorld w(islet::test::roomy, with_lanes(0, false));
    w.add_ground();
    for (int i = 0; i < 5; ++i) w.add_box({0, 0.5f + static_cast<float>(i)});
    w.step(5);
    const Core& core = Core::of(*w);
    std::uint32_t highest_between_boxes = 0, ground = 0;
    for (const Touch& t : touches_of(w)) {
        const std::uint32_t color = core.manifolds[t.contact].color();
        if (core.is_dynamic(t.body_a) && core.is_dynamic(t.body_b)) {
            highest_between_boxes = std::max(highest_between_boxes, color);
        } else {
            ground = color;
        }
    }
    EXPECT_GT(ground, highest_between_boxes);
}

}  // namespace
