// What joints do to contacts, how they break, and bodies with more joints than there are colours.
#include "physics/measure.hpp"
#include "refusal.hpp"
#include "support/joint_world.hpp"

namespace {

using namespace islet;
using namespace islet::test;

// -- contacts --------------------------------------------------------------------------------------------------------------------------

// Two boxes that overlap, at rest: nothing pushes them apart.
struct Overlap : TestWorld {
    explicit Overlap(BodyType type_a = BodyType::dynamic) : TestWorld(roomy, still()) {
        a = add_box({0, 0}, 0.5f, 0.5f, {}, type_a);
        b = add_box({0.9f, 0});
        step(2);
        EXPECT_EQ(touching(), 1u);
    }
    std::size_t touching() const { return contacts().size(); }
    static WorldDef still() {
        WorldDef def;
        def.gravity = {0, 0};
        def.solver.contact_push_speed = 0;
        return def;
    }
    BodyId a, b;
};

TEST(JointContacts, AJointEndsTheContactOfItsBodiesAndItsEndLetsThemMeetAgain) {
    for (const BodyType type : {BodyType::dynamic, BodyType::kinematic, BodyType::static_body}) {
        for (const JointType joint : joint_types) {
            if (joint == JointType::mouse || joint == JointType::gear) continue;
            for (const bool swapped : {false, true}) {
                SCOPED_TRACE(name_of(joint));
                Overlap w(type);
                const JointId id = swapped ? join(*w, joint, w.b, w.a) : join(*w, joint, w.a, w.b);
                EXPECT_EQ(w.touching(), 0u);
                EXPECT_EQ(w->contact_count(), 0u);
                EXPECT_EQ(w->end_touch_events().size(), 1u);
                w.step(5);
                EXPECT_EQ(w.touching(), 0u);
                w->destroy_joint(id);
                w.step();
                EXPECT_EQ(w.touching(), 1u) << "they overlap, so they touch";
                EXPECT_EQ(w->begin_touch_events().size(), 1u);
                EXPECT_EQ(w->validate(), nullptr);
            }
        }
    }
}

TEST(JointContacts, MeetingAgainWorksForBodiesAsleepToo) {
    Overlap w;
    const JointId id = join(*w, JointType::weld, w.a, w.b);
    w.step(120);
    ASSERT_FALSE(w->is_awake(w.a));
    w->destroy_joint(id);
    w.step();
    EXPECT_EQ(w.touching(), 1u);
    EXPECT_EQ(w->validate(), nullptr);
}

TEST(JointContacts, CollidingIsSwitchedOnAndOffWhileTheyTouch) {
    Overlap w;
    const JointId id = join(*w, JointType::motor, w.a, w.b, true);
    w.step();
    EXPECT_EQ(w.touching(), 1u);
    for (int i = 0; i < 5; ++i) {
        w->set_collide_connected(id, false);
        EXPECT_FALSE(w->collide_connected(id));
        EXPECT_EQ(w.touching(), 0u) << "at once";
        w.step();
        EXPECT_EQ(w->end_touch_events().size(), 1u);
        EXPECT_EQ(w.touching(), 0u);
        w->set_collide_connected(id, true);
        w.step();
        EXPECT_EQ(w.touching(), 1u) << "from the next step on";
        EXPECT_EQ(w->begin_touch_events().size(), 1u);
        EXPECT_EQ(w->validate(), nullptr);
    }
    w.errors.clear();
    w->set_collide_connected(id, true);
    EXPECT_EQ(w.touching(), 1u) << "set to what it was";
    EXPECT_TRUE(w.errors.empty());
}

TEST(JointContacts, OneJointOfManyThatForbidsIsEnough) {
    Overlap w;
    const JointId lets = join(*w, JointType::motor, w.a, w.b, true);
    const JointId first = join(*w, JointType::motor, w.a, w.b), second = join(*w, JointType::motor, w.b, w.a);
    w.step();
    EXPECT_EQ(w.touching(), 0u);
    w->destroy_joint(first);
    w.step();
    EXPECT_EQ(w.touching(), 0u);
    w->set_collide_connected(lets, false);
    w->destroy_joint(second);
    w.step();
    EXPECT_EQ(w.touching(), 0u);
    w->set_collide_connected(lets, true);
    w.step();
    EXPECT_EQ(w.touching(), 1u);
}

TEST(JointContacts, ShapesAddedTeleportedOrRetypedLaterRespectTheJoint) {
    Overlap w;
    const JointId id = join(*w, JointType::motor, w.a, w.b);
    w->create_shape(w.b, Circle{{-0.5f, 0}, 0.5f});
    w->set_transform(w.b, {0.5f, 0.1f}, 0.3f);
    w->set_type(w.a, BodyType::static_body);
    w.step(3);
    EXPECT_EQ(w.touching(), 0u);
    EXPECT_EQ(w->validate(), nullptr);
    w->destroy_joint(id);
    w.step();
    EXPECT_EQ(w.touching(), 2u) << "both shapes of b";
}

// -- breaking --------------------------------------------------------------------------------------------------------------------------

TEST(JointBreak, AJointBreaksOnceAndOnlyBeyondWhatItBears) {
    // A weld holds a box of 1 kg at arm's length: 10 N and 20 N m.
    for (const auto& [force, torque, breaks] : {std::tuple{10.5f, 0.0f, false},
                                                {9.5f, 0.0f, true},
                                                {0.0f, 21.0f, false},
                                                {0.0f, 19.0f, true},
                                                {10.5f, 21.0f, false},
                                                {9.5f, 1e30f, true},
                                                {1e30f, 19.0f, true},
                                                {0.0f, 0.0f, false},
                                                {1e-45f, 0.0f, true},
                                                {3.4e38f, 3.4e38f, false}}) {
        SCOPED_TRACE(testing::Message() << force << " N, " << torque << " N m");
        TestWorld w;
        const BodyId wall = w.add_box({0, 5}, 0.5f, 0.5f, {}, BodyType::static_body), load = w.add_box({2, 5});
        WeldJointDef def{.base = base_at_b(*w, wall, load)};
        def.base.frame_a.position = {0, 0};
        def.base.frame_b.position = {-2, 0};
        def.base.user_data = 77;
        const JointId weld = w->create_joint(def);
        w.step(60);  // settled
        ASSERT_TRUE(w->is_valid(weld));
        w->set_break(weld, force, torque);
        int events = 0;
        for (int i = 0; i < 10; ++i) {
            w->wake(load);
            w.step();
            for (const JointBreakEvent& e : w->broken_joints()) {
                ++events;
                EXPECT_EQ(e.joint, weld);
                EXPECT_EQ(e.body_a, wall);
                EXPECT_EQ(e.body_b, load);
                EXPECT_EQ(e.user_data, 77u);
                EXPECT_NEAR(e.force.y, 10, 0.3f);
                EXPECT_NEAR(std::fabs(e.torque), 20, 0.6f);
            }
        }
        EXPECT_EQ(events, breaks ? 1 : 0);
        EXPECT_EQ(w->is_valid(weld), !breaks);
        EXPECT_EQ(w->validate(), nullptr);
        EXPECT_TRUE(w.errors.empty());
    }
}

TEST(JointBreak, EveryTypeBreaksUnderForce) {
    for (const JointType type : joint_types) {
        if (type == JointType::gear) continue;
        SCOPED_TRACE(name_of(type));
        TestWorld w(roomy, weightless());
        const BodyId a = w.add_box({0, 5}), b = w.add_box({2, 5.5f});
        const JointId id = join(*w, type, a, b);
        if (type == JointType::motor) w->set_joint_strength(id, 1e9f, 1e9f);
        w->set_break(id, 100, 100);
        w.step(5);
        ASSERT_TRUE(w->is_valid(id)) << "nothing pulls yet";
        for (int i = 0; i < 60 && w->is_valid(id); ++i) {
            w->apply_force_to_center(b, {500, -400});
            w->apply_torque(b, 200);
            w.step();
        }
        EXPECT_FALSE(w->is_valid(id));
        EXPECT_EQ(w->validate(), nullptr);
    }
}

TEST(JointBreak, ABrokenJointTakesItsGearsAndAGearBreaksByItself) {
    for (const bool gear_first : {false, true}) {
        TestWorld w(roomy, weightless());
        const BodyId hub = w.add_box({0, 0}, 0.2f, 0.2f, {}, BodyType::static_body), a = w.add_box({2, 0}), b = w.add_box({4, 0});
        const JointId ha = join(*w, JointType::revolute, hub, a), hb = join(*w, JointType::revolute, hub, b);
        const JointId gear = w->create_joint(GearJointDef{.joint1 = ha, .joint2 = hb, .break_torque = gear_first ? 1.0f : 0.0f});
        if (!gear_first) w->set_break(ha, 1, 0);
        w.step();
        w->apply_torque(a, 50);
        w->apply_force_to_center(a, {50, 0});
        w.step();
        const auto broken = w->broken_joints();
        ASSERT_EQ(broken.size(), 1u) << "a gear that goes with its joint is not an event";
        EXPECT_EQ(broken[0].joint, gear_first ? gear : ha);
        EXPECT_FALSE(w->is_valid(gear));
        EXPECT_EQ(w->is_valid(ha), gear_first);
        EXPECT_TRUE(w->is_valid(hb));
        EXPECT_EQ(w->validate(), nullptr);
        w.step(10);
        w->destroy_joint(hb);
        EXPECT_EQ(w->validate(), nullptr) << "the gear's place is free and no longer counted";
    }
}

TEST(JointBreak, WhatABrokenJointKeptApartMeetsAgain) {
    Overlap w;
    const JointId id = join(*w, JointType::weld, w.a, w.b);
    w->set_break(id, 1, 0);
    w->apply_force_to_center(w.b, {0, 20});
    w.step();
    ASSERT_EQ(w->broken_joints().size(), 1u);
    w.step();
    EXPECT_EQ(w.touching(), 1u);
}

// -- many joints -----------------------------------------------------------------------------------------------------------------------

TEST(ManyJoints, ABodyWithAHundredJointsStaysTheSameBits) {
    const auto run = [](std::uint32_t lanes) {
        WorldDef def;
        def.lanes = lanes;
        def.solver.joint_trees = JointTrees::off;  // an exact tree needs no colours
        TestWorld w(roomy, def);
        w.add_ground();
        const BodyId hub = w.add_circle({0, 12}, 1);
        for (int i = 0; i < 100; ++i) {
            const Rot q = make_rot(2 * pi * static_cast<float>(i) / 100);
            const BodyId b = w.add_box(Vec2{0, 12} + 3.0f * Vec2{q.c, q.s}, 0.08f, 0.08f);
            EXPECT_TRUE(join(*w, joint_types[static_cast<std::size_t>(i) % 6], hub, b));
        }
        EXPECT_EQ(w->joints(hub, {}), 100u);
        std::vector<std::uint64_t> hashes;
        for (int i = 0; i < 120; ++i) {
            w.step();
            EXPECT_GE(w->report().overflow_joints, 100u - 24u) << "only so many find a colour";
            if (i % 20 == 19) hashes.push_back(w->hash());
        }
        EXPECT_EQ(w->validate(), nullptr);
        EXPECT_TRUE(w.is_finite());
        const std::vector<JointId> joints = w.joints_of(hub);
        for (std::size_t i = 0; i < joints.size(); i += 2) w->destroy_joint(joints[i]);
        EXPECT_EQ(w->validate(), nullptr);
        w.step(30);
        hashes.push_back(w->hash());
        w->destroy_body(hub);
        EXPECT_EQ(w->joint_count(), 0u);
        w.step(30);
        hashes.push_back(w->hash());
        return hashes;
    };
    const auto one = run(1);
    EXPECT_EQ(one, run(4));
    EXPECT_EQ(one, run(8));
}

TEST(ManyJoints, HangingOnTheWorldLeavesNothingBehindInIt) {
    // Static bodies feel no joint: after any number of steps, a static anchor made dynamic behaves like a new one.
    Transform ends[2];
    for (const bool old : {false, true}) {
        TestWorld w;
        const BodyId anchor = w.add_box({0, 10}, 0.5f, 0.5f, {}, BodyType::static_body);
        const auto hang = [&] {
            const BodyId load = w.add_box({0, 8}, 0.5f, 0.5f, dense(50));
            RevoluteJointDef def{.base = {.body_a = anchor, .body_b = load}};
            def.base.frame_a.position = {0, -0.5f};
            def.base.frame_b.position = {0, 1.5f};
            w->create_joint(def);
            return load;
        };
        if (old) {
            const BodyId load = hang();
            w->enable_sleep(load, false);
            w.step(600);
            w->destroy_body(load);
        }
        w->set_type(anchor, BodyType::dynamic);
        w->set_gravity({0, 0});
        w->set_angular_velocity(anchor, 2);
        const BodyId other = w.add_box({3, 10});
        join(*w, JointType::weld, anchor, other);
        w.step(30);
        ends[old ? 1 : 0] = w->transform(anchor);
    }
    EXPECT_EQ(ends[0], ends[1]);
}

// -- turns -----------------------------------------------------------------------------------------------------------------------------

TEST(Turns, EveryHingeCountsThemGearedOrNot) {
    for (const bool rubs : {false, true}) {
        SCOPED_TRACE(rubs);
        TestWorld w(roomy, weightless());
        const BodyId hub = w.add_box({0, 0}, 0.2f, 0.2f, {}, BodyType::static_body), a = w.add_circle({2, 0}), b = w.add_circle({6, 0});
        const JointId ha = join(*w, JointType::revolute, hub, a), hb = join(*w, JointType::revolute, hub, b);
        w->create_joint(GearJointDef{.joint1 = ha, .joint2 = hb, .ratio = 2});
        if (rubs) w->set_joint_friction(ha, 1e-6f), w->set_joint_friction(hb, 1e-6f);
        w->set_angular_velocity(a, 4);
        w->set_angular_velocity(b, -2);
        w.step(600);
        EXPECT_NEAR(w->joint_position(ha), 40, 0.1f);
        EXPECT_NEAR(w->joint_position(hb), -20, 0.1f);
        EXPECT_NEAR(w->angular_velocity(a), 4, 0.01f) << "whole turns are no error of the gear's";
        // Reading does not depend on what acts on the hinge: a limit set now holds it here.
        w->set_limit(hb, {.enable = true, .lower = w->joint_position(hb), .upper = 0});
        w.step(60);
        EXPECT_NEAR(w->joint_position(hb), -20, 2);
    }
}

}  // namespace
