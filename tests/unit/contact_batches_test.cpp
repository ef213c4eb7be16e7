// Many contacts that begin, end and are told of in one step are the work of several workers at once. All of it comes to what one worker makes.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../../engine/src/graph/contact_batches.hpp"
#include "support/random.hpp"
#include "support/task_orders.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

/// What flies about in a crowd.
struct Crowd {
    std::string name;
    Capacity capacity{.bodies = 1200, .shapes = 3600, .contacts = 20000, .joints = 4};
    std::uint32_t pieces = 1;  // shapes of a body
    int every = 1;  // of so many bodies, one has this surface
    ShapeDef surface = {.restitution = 0.9f};
    WorldDef world = {};
};

void fill(TestWorld& w, const Crowd& crowd) {
    Random random(5);
    for (const float side : {-1.0f, 1.0f}) {
        w.add(make_box(1, 25), {24 * side, 0}, {}, BodyType::static_body);
        w.add(make_box(25, 1), {0, 24 * side}, {}, BodyType::static_body);
    }
    for (int i = 0; i < 1156; ++i) {
        BodyDef def{.type = BodyType::dynamic, .position = {1.3f * static_cast<float>(i % 34) - 21.5f, 1.3f * static_cast<float>(i / 34) - 21.5f}};
        def.linear_velocity = {random.between(-25, 25), random.between(-25, 25)};
        def.angular_velocity = random.between(-9, 9);
        const BodyId body = w->create_body(def);
        for (std::uint32_t k = 0; k < crowd.pieces; ++k) {
            const ShapeDef surface = i % crowd.every == 0 ? crowd.surface : Crowd{}.surface;
            const Vec2 at = {0.4f * static_cast<float>(k), 0};
            if (i % 2 == 0) {
                w->create_shape(body, Circle{at, 0.4f}, surface);
            } else {
                w->create_shape(body, make_offset_box(0.4f, 0.3f, {at}), surface);
            }
        }
    }
}

// The contacts of a world, by slot and generation.
std::vector<std::pair<std::uint32_t, std::uint32_t>> contacts_of(const World& world) {
    const detail::Core& core = detail::Core::of(world);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
    for_each_live(core.state->contact_pool, core.contacts, [&](std::uint32_t i) { found.emplace_back(i, core.contacts[i].generation); });
    return found;
}

// The slots of the shapes of all events.
template <class Events>
std::vector<std::pair<std::uint32_t, std::uint32_t>> shapes_of(const Events& events) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> shapes;
    for (const TouchEvent& e : events) shapes.emplace_back(e.shape_a.index1, e.shape_b.index1);
    return shapes;
}

/// In how many steps so many contacts began, ended, and were told of that it was the work of several workers; and in how many there were enough of them.
struct Seen {
    int begins = 0, ends = 0, told = 0, many = 0;
};

// Worlds of one worker, and of several in two orders of their tasks, step for step.
Seen compare(const Crowd& crowd, std::uint32_t workers, int steps) {
    const auto make = [&](TaskSystem tasks) {
        WorldDef def = crowd.world;
        def.tasks = tasks;
        auto w = std::make_unique<TestWorld>(crowd.capacity, def);
        fill(*w, crowd);
        return w;
    };
    const auto one = make({}), forth = make(in_order(workers)), back = make(backwards(workers));
    Seen seen;
    auto before = contacts_of(**one);
    for (int i = 0; i < steps && !testing::Test::HasFailure(); ++i) {
        for (const auto& w : {one.get(), forth.get(), back.get()}) w->step();
        for (const auto& w : {forth.get(), back.get()}) {
            const std::string what = crowd.name + ", step " + std::to_string(i) + (w == back.get() ? ", tasks backwards" : "");
            EXPECT_EQ((*one)->hash(), (*w)->hash()) << what;
            EXPECT_EQ(shapes_of((*one)->begin_touch_events()), shapes_of((*w)->begin_touch_events())) << what;
            EXPECT_EQ(shapes_of((*one)->end_touch_events()), shapes_of((*w)->end_touch_events())) << what;
            EXPECT_EQ((*one)->report().dropped_contacts, (*w)->report().dropped_contacts) << what;
            EXPECT_EQ((*one)->report().dropped_events, (*w)->report().dropped_events) << what;
            EXPECT_EQ(one->errors, w->errors) << what;
        }
        const auto now = contacts_of(**one);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> made, ended;
        std::set_difference(now.begin(), now.end(), before.begin(), before.end(), std::back_inserter(made));
        std::set_difference(before.begin(), before.end(), now.begin(), now.end(), std::back_inserter(ended));
        const detail::Core& core = detail::Core::of(**forth);
        seen.begins += detail::in_batches(core, static_cast<std::uint32_t>(made.size())) ? 1 : 0;
        seen.ends += detail::in_batches(core, static_cast<std::uint32_t>(ended.size())) ? 1 : 0;
        seen.many += made.size() >= detail::least_contact_batch && ended.size() >= detail::least_contact_batch ? 1 : 0;
        seen.told += (*one)->begin_touch_events().size() >= 128 ? 1 : 0;
        before = now;
    }
    return seen;
}

TEST(ContactBatches, ComeToWhatOneWorkerMakes) {
    if (!detail::has_threads) GTEST_SKIP() << "a build without threads has no workers";
    std::vector<Crowd> crowds;
    crowds.push_back({.name = "single shapes"});
    crowds.push_back({.name = "bodies of three shapes, which share contacts", .pieces = 3});
    crowds.push_back({.name = "with a mixing hook"});
    crowds.back().world.hooks.mix_friction = [](float a, std::uint32_t, float b, std::uint32_t, void*) { return a > b ? a : b; };
    crowds.push_back({.name = "with room for few contacts", .capacity = {.bodies = 1200, .shapes = 3600, .contacts = 500, .joints = 4}});
    crowds.push_back({.name = "with room for few events", .capacity = {.bodies = 1200, .shapes = 3600, .contacts = 20000, .joints = 4, .events = 40}});
    for (const Crowd& crowd : crowds) {
        for (const std::uint32_t workers : {4u, 7u}) {
            const Seen seen = compare(crowd, workers, 60);
            EXPECT_GT(seen.begins, 10) << crowd.name << ": this test shows nothing";
            EXPECT_GT(seen.ends, 10) << crowd.name << ": this test shows nothing";
            if (crowd.capacity.contacts == 20000 && crowd.capacity.events == 0) { EXPECT_GT(seen.told, 3) << crowd.name << ": this test shows nothing"; }
        }
    }
}

TEST(ContactBatches, AreNotMadeWhereHooksOrSensorsSeeOneAfterAnother) {
    if (!detail::has_threads) GTEST_SKIP() << "a build without threads has no workers";
    Crowd sensors{.name = "sensors", .every = 10, .surface = {.sensor = true, .sensor_events = true}};
    Crowd filter{.name = "filter"}, asks{.name = "pre-solve hook", .surface = {.pre_solve = true}};
    filter.world.hooks.filter = [](ShapeId a, ShapeId b, void*) { return (a.index1 + b.index1) % 3 != 0; };
    asks.world.hooks.pre_solve = [](PreSolve& contact, void*) { contact.enabled = contact.contact.shape_a.index1 % 5 != 0; };
    for (const Crowd& crowd : {sensors, filter, asks}) {
        const Seen seen = compare(crowd, 4, 40);
        EXPECT_EQ(seen.begins + seen.ends, 0) << crowd.name;
        EXPECT_GT(seen.many, 5) << crowd.name << ": this test shows nothing";
    }
}

}  // namespace
}  // namespace islet::test
