// A plan is kept from step to step until something changes that it was made from. (The tests of random calls and of all scenes compare plans that are kept
// with new ones.)
#include "support/kept_plan.hpp"

#include "islet/snapshot.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

// Three boxes, one on the other, that rest awake beside a door on a motor.
struct RestingWorld {
    TestWorld w{roomy, {.enable_sleep = false}};
    BodyId boxes[3], wall, door;
    JointId hinge;

    RestingWorld() {
        w.add_ground();
        for (int i = 0; i < 3; ++i) boxes[i] = w.add_box({0, 0.5f + static_cast<float>(i)});
        wall = w->create_body({.position = {10, 5}});
        door = w.add_box({11, 5}, 1, 0.1f);
        RevoluteJointDef def;
        def.base.body_a = wall;
        def.base.body_b = door;
        def.base.frame_b.position = {-1, 0};
        def.motor = {true, 1, 100};
        hinge = w->create_joint(def);
        w.step(60);
    }
    bool keeps() const { return keeps_plan(*w); }
};

class KeptPlan : public testing::Test {
protected:
    void SetUp() override {
        if (!detail::keeps_plan) GTEST_SKIP() << "where memory is small, no plan is kept";
    }
};

// Takes a step, and says whether it took over the plan that was kept: one that is marked by a number of islands which no plan here has.
bool takes_over(TestWorld& w) {
    detail::Plan* const kept = detail::Core::of(*w).kept.plan;
    const std::uint32_t islands = 777, before = kept->island_count;
    kept->island_count = islands;
    w.step();
    const bool took_over = w->report().islands == islands;
    if (took_over) kept->island_count = before;
    return took_over;
}

TEST_F(KeptPlan, IsKeptWhileBodiesRestOrAreDrivenAsBefore) {
    RestingWorld r;
    ASSERT_TRUE(r.keeps());
    for (int i = 0; i < 60; ++i) {
        r.w->apply_force_to_center(r.boxes[1], {0.1f, 0});
        r.w->apply_torque(r.door, 0.1f);
        r.w->set_motor(r.hinge, {true, 1 + 0.01f * static_cast<float>(i), 100});
        r.w->set_gravity({0, -10 - 0.01f * static_cast<float>(i)});
        ASSERT_TRUE(takes_over(r.w)) << "step " << i;
        expect_kept_plan_is_right(*r.w);
    }
}

TEST_F(KeptPlan, IsForgottenWhereItWouldBeAnotherOne) {
    const auto forgets = [](auto&& change) {
        RestingWorld r;
        EXPECT_TRUE(r.keeps());
        change(r);
        return !r.keeps() || detail::Core::of(*r.w).state->trees_stale != 0;
    };
    EXPECT_TRUE(forgets([](RestingWorld& r) { r.w.add_box({5, 5}); }));
    EXPECT_TRUE(forgets([](RestingWorld& r) { r.w->destroy_body(r.boxes[2]); }));
    EXPECT_TRUE(forgets([](RestingWorld& r) { r.w->set_type(r.boxes[0], BodyType::static_body); }));
    EXPECT_TRUE(forgets([](RestingWorld& r) { r.w->destroy_joint(r.hinge); }));
    EXPECT_TRUE(forgets([](RestingWorld& r) { r.w->set_motor(r.hinge, {}); }));
    EXPECT_TRUE(forgets([](RestingWorld& r) { r.w->set_enabled(r.boxes[1], false); }));
    EXPECT_TRUE(forgets([](RestingWorld& r) { r.w->set_solver({.sweep_order = SweepOrder::upward}); }));
    EXPECT_TRUE(forgets([](RestingWorld& r) {
        std::vector<std::byte> image(r.w->snapshot_bytes());
        r.w->save(image);
        EXPECT_TRUE(r.w->restore(image));
    }));
}

TEST_F(KeptPlan, IsMadeAnewInTheStepInWhichATouchBeginsOrEnds) {
    RestingWorld r;
    const BodyId ball = r.w->create_body({.type = BodyType::dynamic, .position = {-3, 2}});
    r.w->create_shape(ball, Circle{{0, 0}, 0.5f});
    r.w.step();
    ASSERT_TRUE(r.keeps());
    std::uint32_t changes = 0;
    for (int i = 0; i < 120; ++i) {
        if (i == 80) r.w->set_linear_velocity(ball, {0, 5});
        const std::uint32_t before = r.w->report().touching_contacts;
        r.w.step();
        ASSERT_TRUE(r.keeps()) << "step " << i;
        expect_kept_plan_is_right(*r.w);
        changes += before != r.w->report().touching_contacts ? 1 : 0;
    }
    EXPECT_EQ(changes, 2u) << "the ball lands, and is thrown up";
}

TEST_F(KeptPlan, IsKeptAfterChangesOfAWorldWithoutJoints) {
    TestWorld w{roomy, {.enable_sleep = false}};
    w.add_ground();
    const BodyId box = w.add_box({0, 0.5f});
    w.step(60);
    w->lock_x(box, true);  // joint trees would have to be chosen anew
    w.step(2);
    EXPECT_TRUE(takes_over(w));
}

TEST_F(KeptPlan, IsForgottenWhenTheLastJointBreaks) {
    TestWorld w{roomy, {.gravity = {0, 0}, .enable_sleep = false}};
    const BodyId a = w.add_box({0, 0}), b = w.add_box({5, 0});
    DistanceJointDef def;
    def.base.body_a = a;
    def.base.body_b = b;
    def.base.break_force = 100;
    const JointId rod = w->create_joint(def);
    w.step(2);
    ASSERT_TRUE(takes_over(w));
    w->apply_force_to_center(b, {1000, 0});
    w.step();
    ASSERT_FALSE(w->is_valid(rod));
    EXPECT_FALSE(keeps_plan(*w));
    w.step();
    EXPECT_EQ(w->report().islands, 2u);
}

// Contacts with rolling resistance are looked at one by one. If the update took them for settled, it would try lanes in every second step, and in vain.
TEST_F(KeptPlan, WorldsOfSpecialContactsTryNoLanes) {
    TestWorld w{roomy, {.enable_sleep = false}};
    w.add_ground();
    for (int i = 0; i < 30; ++i) w.add_box({2.0f * static_cast<float>(i % 3), 0.5f + static_cast<float>(i / 3)}, 0.5f, 0.5f, {.rolling_resistance = 0.1f});
    for (int i = 0; i < 90; ++i) {
        w.step();
        ASSERT_FALSE(detail::Core::of(*w).kept.keeps_in_lanes || detail::Core::of(*w).kept.parts_in_lanes) << "step " << i;
    }
    EXPECT_GT(w->report().recycled_contacts, 20u);
}

}  // namespace
}  // namespace islet::test
