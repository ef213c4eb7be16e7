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

TEST_F(KeptPlan, IsKeptWhileBodiesRestOrAreDrivenAsBefore) {
    RestingWorld r;
    const detail::Plan* const first = detail::Core::of(*r.w).kept.plan;
    ASSERT_NE(first, nullptr);
    for (int i = 0; i < 60; ++i) {
        r.w->apply_force_to_center(r.boxes[1], {0.1f, 0});
        r.w->apply_torque(r.door, 0.1f);
        r.w->set_motor(r.hinge, {true, 1 + 0.01f * static_cast<float>(i), 100});
        r.w->set_gravity({0, -10 - 0.01f * static_cast<float>(i)});
        r.w.step();
        ASSERT_EQ(detail::Core::of(*r.w).kept.plan, first) << "step " << i;
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

}  // namespace
}  // namespace islet::test
