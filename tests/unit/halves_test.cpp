// Two workers share a large batch by halves: what one sweeps, the other does not touch, and every body's constraints stay in the order of their colours.
#include <string>

#include "../../engine/src/data/parallel.hpp"
#include "../../engine/src/island/halves.hpp"
#include "support/kept_plan.hpp"
#include "support/random.hpp"
#include "support/task_orders.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

inline constexpr Capacity heap_room{.bodies = 2600, .shapes = 2600, .contacts = 20000, .joints = 160};

// Boxes, balls and capsules that fall into vats of a given width, some of them bouncy, some hinged to the one before; in the first vat a kinematic bar turns.
struct Heap {
    TestWorld w;
    BodyId last;

    Heap(float half_width, std::uint32_t lanes, TaskSystem tasks, int vats = 1) : w(heap_room, {.enable_sleep = false, .lanes = lanes, .tasks = tasks}) {
        w.add_ground();
        for (int vat = 0; vat < vats; ++vat) fill(static_cast<float>(vat) * (2 * half_width + 2), half_width, vats == 1 ? 1450 : 2500 / vats);
    }

    void fill(float middle, float half_width, int count) {
        for (const float side : {-1.0f, 1.0f}) w.add(make_box(0.5f, 200), {middle + side * (half_width + 0.5f), 200}, {}, BodyType::static_body);
        if (middle == 0) w->set_angular_velocity(w.add(make_box(2, 0.2f), {0.3f, 3}, {}, BodyType::kinematic), 1.5f);
        Random random(11);
        const int across = static_cast<int>(half_width / 0.3f);
        for (int i = 0; i < count; ++i) {
            const Vec2 at = {middle + (static_cast<float>(i % across) + 0.5f) * 0.6f - half_width, 5 + 0.6f * static_cast<float>(i / across)};
            ShapeDef surface;
            surface.restitution = random.one_in(5) ? 0.5f : 0.0f;
            const BodyId body = i % 3 == 0   ? w.add(make_box(0.25f, 0.2f), at, surface)
                                : i % 3 == 1 ? w.add(Circle{{0, 0}, 0.25f}, at, surface)
                                             : w.add(Capsule{{-0.1f, 0}, {0.1f, 0}, 0.15f}, at, surface);
            if (i % 16 == 1 && i % across != 0) {
                RevoluteJointDef hinge;
                hinge.base.body_a = last;
                hinge.base.body_b = body;
                hinge.base.frame_a.position = {0.3f, 0};
                hinge.base.frame_b.position = {-0.3f, 0};
                w->create_joint(hinge);
            }
            last = body;
        }
    }
};

class Halves : public testing::Test {
protected:
    void SetUp() override {
        if (!detail::has_halves || detail::max_lanes < 4) GTEST_SKIP() << "a build without threads or lanes makes no halves";
    }
};

// Two workers' steps against one worker's, in two orders of their tasks. Returns in how many steps there were halves.
int steps_with_halves(float half_width, std::uint32_t lanes, int steps, int vats = 1) {
    Heap one(half_width, lanes, {}, vats), forth(half_width, lanes, in_order(2), vats), back(half_width, lanes, backwards(2), vats);
    int halved = 0;
    for (int i = 0; i < steps; ++i) {
        for (Heap* h : {&one, &forth, &back}) h->w.step();
        if (keeps_plan(*forth.w) && detail::Core::of(*forth.w).kept.plan->half_count() == 2) ++halved;
        EXPECT_EQ(one.w->hash(), forth.w->hash()) << "step " << i;
        EXPECT_EQ(one.w->hash(), back.w->hash()) << "tasks backwards, step " << i;
        if (testing::Test::HasFailure()) break;
    }
    return halved;
}

TEST_F(Halves, OfAHeapThatIsWideOrTallGiveTheBitsOfOneWorker) {
    EXPECT_GT(steps_with_halves(12, 0, 240), 100) << "a wide heap was hardly ever cut: this test shows nothing";
    EXPECT_GT(steps_with_halves(3, 4, 300), 100) << "a tall heap was hardly ever cut: this test shows nothing";
}

TEST_F(Halves, OfOneOfThreeHeapsGiveTheBitsOfOneWorker) {
    EXPECT_GT(steps_with_halves(6, 0, 240, 3), 100) << "no heap was cut: this test shows nothing";
}

TEST_F(Halves, StayRightWhenTheNumberOfWorkersChanges) {
    Heap one(12, 0, {}), changing(12, 0, in_order(2));
    for (int i = 0; i < 200; ++i) {
        changing.w->set_tasks(in_order(i % 7 == 3 ? 1u : i % 5 == 2 ? 4u : 2u));
        one.w.step();
        changing.w.step();
        ASSERT_EQ(one.w->hash(), changing.w->hash()) << "step " << i;
    }
}

// A task system that runs tasks in order, and of whose workers so many are ready.
TaskSystem with_ready(std::uint32_t workers, std::uint32_t& ready) {
    TaskSystem tasks = in_order(workers);
    tasks.context = &ready;
    tasks.ready_workers = [](void* count) { return *static_cast<std::uint32_t*>(count); };
    return tasks;
}

TEST_F(Halves, GoWithTheSecondWorkerAndComeBackWithIt) {
    std::uint32_t ready = 2;
    constexpr int base = 60;
    TestWorld w(heap_room, {.enable_sleep = false, .tasks = with_ready(2, ready)});
    w.add_ground();
    for (int row = 0; row < base; ++row)
        for (int i = 0; i < base - row; ++i) {
            const float x = static_cast<float>(i) + 0.5f * static_cast<float>(row), y = 0.5f + static_cast<float>(row);
            w.add(make_box(0.5f, 0.5f), {x, y});
        }
    w.step(20);
    const detail::Core& core = detail::Core::of(*w);
    const auto halves_after_a_step = [&] {
        w.step();
        EXPECT_TRUE(keeps_plan(*w));
        return core.kept.plan->half_count();
    };
    EXPECT_EQ(halves_after_a_step(), 2u);
    ready = 1;
    EXPECT_EQ(halves_after_a_step(), 0u);
    ready = 2;
    EXPECT_EQ(halves_after_a_step(), 2u);
    w->set_tasks({});
    EXPECT_EQ(detail::worker_count(core), 1u) << "a call between two steps could give tasks to a task system that is gone";
    EXPECT_EQ(halves_after_a_step(), 0u);
}

TEST_F(Halves, AStepHasAsManyWorkersAsAreReady) {
    struct Case {
        std::uint32_t ready, count;
    };
    std::uint32_t ready = 0;
    TestWorld w(roomy, {.tasks = with_ready(4, ready)});
    for (const Case& c : {Case{0, 1}, {1, 1}, {3, 3}, {4, 4}, {5, 4}, {256, 4}, {0xffffffffu, 4}}) {
        ready = c.ready;
        w.step();
        EXPECT_EQ(detail::worker_count(detail::Core::of(*w)), c.count) << c.ready << " of 4 are ready";
    }
}

// A body's contacts, by what the plan does with them.
struct ContactsOfBody {
    std::uint32_t last_in_half = 0, first_waiting = detail::color_count;  // colours; the first is one more
    std::uint32_t halves = 0;                                             // bits of those that have a contact of it
};

TEST_F(Halves, HoldMostContactsAndOnlySuchAsComeBeforeAllThatWait) {
    Heap heap(12, 0, in_order(2));
    heap.w.step(200);
    ASSERT_TRUE(keeps_plan(*heap.w));
    const detail::Core& core = detail::Core::of(*heap.w);
    const detail::Plan& plan = *core.kept.plan;
    ASSERT_EQ(plan.half_count(), 2u);
    std::vector<ContactsOfBody> of(core.capacity.bodies);
    std::uint32_t in_halves = 0, waiting = 0, in_half[2] = {};
    const auto for_contacts = [&](const detail::Batch& batch, auto&& visit) {
        for (std::uint32_t c = 0; c < detail::color_count; ++c) {
            for (std::uint32_t row = batch.first_block[c] * core.block_lanes(); row < batch.first_block[c + 1] * core.block_lanes(); ++row) {
                if (plan.contacts[row] == detail::no_plan_index) continue;
                const detail::ContactManifold& m = core.manifolds[plan.contacts[row]];
                for (const std::uint32_t body : {m.body_a, m.body_b})
                    if (core.poses[body].inv_mass > 0) visit(of[body], body, c);
            }
        }
    };
    for (std::uint32_t half = 0; half < 2; ++half) {
        const detail::Batch& batch = plan.batches[plan.batch_count + half];
        for_contacts(batch, [&](ContactsOfBody& body, std::uint32_t index, std::uint32_t color) {
            body.last_in_half = std::max(body.last_in_half, color + 1);
            body.halves |= 1u << half;
            ++in_halves;
            ++in_half[half];
            const std::uint32_t slot = plan.slot_of[index];
            EXPECT_TRUE(slot >= batch.first_slot && slot < batch.end_slot()) << "body " << index << " is in the other half";
        });
    }
    for_contacts(plan.batches[plan.halved_batch], [&](ContactsOfBody& body, std::uint32_t, std::uint32_t color) {
        body.first_waiting = std::min(body.first_waiting, color);
        ++waiting;
    });
    for (std::size_t i = 0; i < of.size(); ++i) {
        EXPECT_LE(of[i].last_in_half, of[i].first_waiting) << "body " << i << ": a contact in a half comes after one that waits";
        EXPECT_NE(of[i].halves, 3u) << "body " << i << " is swept in both halves";
    }
    EXPECT_GT(in_halves, 3 * waiting);
    EXPECT_GT(waiting, 0u);
    EXPECT_GT(2 * std::min(in_half[0], in_half[1]), std::max(in_half[0], in_half[1])) << "the halves are no halves";
}

// A block in which one contact lands is solved again as a whole, so these stand together, also where several workers list the contacts part by part.
TEST_F(Halves, AndWholeBatchesHaveTheContactsThatLandFirstInEachColor) {
    for (const std::uint32_t workers : {1u, 2u, 4u}) {
        Heap heap(12, 0, in_order(workers));
        std::uint32_t landing = 0, after_others = 0;
        for (int step = 0; step < 150; ++step) {
            detail::Core& core = detail::Core::of(*heap.w);
            core.forget_plan();  // a kept one has first what landed when it was made
            heap.w.step();
            if (!keeps_plan(*heap.w)) continue;
            const detail::Plan& plan = *core.kept.plan;
            for (std::uint32_t b = 0; b < plan.batch_count + plan.half_count(); ++b) {  // the bar is in batch 0
                for (std::uint32_t c = 0; c < detail::color_count; ++c) {
                    bool others = false;
                    for (std::uint32_t row = plan.batches[b].first_block[c] * core.block_lanes(); row < plan.batches[b].first_block[c + 1] * core.block_lanes();
                         ++row) {
                        if (plan.contacts[row] == detail::no_plan_index) continue;
                        const bool lands = (core.manifolds[plan.contacts[row]].flags & detail::contact_ahead) != 0;
                        landing += lands ? 1 : 0;
                        after_others += lands && others ? 1 : 0;
                        others = others || !lands;
                    }
                }
            }
        }
        EXPECT_GT(landing, 300u) << "hardly anything lands: this test shows nothing";
        EXPECT_EQ(after_others, 0u) << workers << " workers";
    }
}

}  // namespace
}  // namespace islet::test
