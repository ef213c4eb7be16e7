// What can be given at creation can be read and changed later, with the effect that it would have had from the start.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/joint_world.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

// -- worlds ------------------------------------------------------------------------------------------------------------------------------

TEST(WorldSettings, AreReadAsTheyWereGiven) {
    TestWorld w(roomy, {.enable_sleep = false, .restitution_threshold = 0.25f, .max_speed = 77, .lanes = 1});
    EXPECT_FALSE(w->sleep_enabled());
    EXPECT_EQ(w->restitution_threshold(), 0.25f);
    EXPECT_EQ(w->max_speed(), 77);
    EXPECT_EQ(w->lanes(), 1u);
    w->enable_sleep(true);
    EXPECT_TRUE(w->sleep_enabled());
    const BodyId body = w.add_box({0, 0});
    EXPECT_TRUE(w->sleep_enabled(body));
    w->enable_sleep(body, false);
    EXPECT_FALSE(w->sleep_enabled(body));
}

TEST(WorldSettings, TheThresholdOfBouncesDecidesAboutSlowImpacts) {
    const auto rebound = [](float threshold) {
        TestWorld w;
        w.add_ground();
        w->set_restitution_threshold(threshold);
        const BodyId ball = w.add_circle({0, 1.5f}, 0.5f, {.restitution = 1});
        float highest = 0;
        for (int i = 0; i < 90; ++i) {
            w.step();
            if (w->linear_velocity(ball).y > 0) highest = std::fmax(highest, w->linear_velocity(ball).y);
        }
        return highest;
    };
    const float impact = std::sqrt(2 * 10.0f * 1);  // m/s, from 1 m
    EXPECT_GT(rebound(impact - 0.5f), impact - 0.5f);
    EXPECT_LT(rebound(impact + 0.5f), 0.5f);
}

TEST(WorldSettings, TheSpeedLimitHoldsFromTheNextStep) {
    TestWorld w;
    w->set_gravity({});
    const BodyId body = w.add_box({0, 0});
    w->set_linear_velocity(body, {300, 400});
    w.step();
    EXPECT_NEAR(length(w->linear_velocity(body)), 400, 0.01f) << "the default";
    w->set_max_speed(10);
    w.step();
    EXPECT_NEAR(w->linear_velocity(body).x, 6, 1e-4f);
    EXPECT_NEAR(w->linear_velocity(body).y, 8, 1e-4f);
}

TEST(WorldSettings, TheErrorHookCanBeReplacedAndRemoved) {
    TestWorld w;
    const ErrorHook first = w->error_hook();
    EXPECT_EQ(w->error_context(), &w) << "as it was given at creation";
    const std::uint64_t before = w->hash();
    const std::size_t bytes = w->snapshot_bytes();
    std::vector<Error> heard;
    w->set_error_hook([](Error error, void* list) { static_cast<std::vector<Error>*>(list)->push_back(error); }, &heard);
    EXPECT_EQ(w->error_context(), &heard);
    EXPECT_NE(w->error_hook(), first);
    w->step(-1);
    EXPECT_EQ(heard, std::vector<Error>{Error::bad_time_step});
    EXPECT_TRUE(w.errors.empty()) << "the hook before is told no more";
    w->set_error_hook(nullptr);
    EXPECT_EQ(w->error_hook(), nullptr);
    EXPECT_EQ(w->error_context(), nullptr);
    w->set_max_speed(-1);
    EXPECT_EQ(heard.size(), 1u) << "no hook is told, but";
    EXPECT_EQ(w->last_error(), Error::out_of_range);
    EXPECT_EQ(w->hash(), before);
    EXPECT_EQ(w->snapshot_bytes(), bytes);
    w->set_error_hook(first, &w);
    w->step(-1);
    EXPECT_EQ(w.errors, std::vector<Error>{Error::bad_time_step});
}

TEST(WorldSettings, TheErrorHookSetLastIsThatOfACopy) {
    TestWorld w;
    int heard = 0;
    w->set_error_hook([](Error, void* count) { ++*static_cast<int*>(count); }, &heard);
    Block block(world_bytes(roomy));
    std::vector<std::byte> image(w->snapshot_bytes());
    World* copy = copy_world(*w, block.span(), roomy, image);
    ASSERT_NE(copy, nullptr);
    EXPECT_EQ(copy->error_hook(), w->error_hook());
    copy->step(-1);
    EXPECT_EQ(heard, 1);
}

// What the hook itself calls is refused without another call of it, so it can not remove itself either.
TEST(WorldSettings, TheErrorHookDoesNotReplaceItself) {
    struct Self {
        World* world;
        int heard;
    } self{nullptr, 0};
    TestWorld w;
    self.world = w.get();
    w->set_error_hook(
        [](Error, void* context) {
            ++static_cast<Self*>(context)->heard;
            static_cast<Self*>(context)->world->set_error_hook(nullptr);
        },
        &self);
    w->step(-1);
    EXPECT_EQ(w->last_error(), Error::in_step);
    EXPECT_EQ(w->error_context(), &self);
    w->step(-1);
    EXPECT_EQ(self.heard, 2);
}

TEST(WorldSettings, OutOfRangeAreRefused) {
    TestWorld w;
    const std::uint64_t before = w->hash();
    for (const float bad : {-1.0f, INFINITY, NAN}) {
        w->set_restitution_threshold(bad);
        w->set_max_speed(bad);
    }
    w->set_max_speed(0);
    w->set_max_speed(2 * max_speed_limit);
    EXPECT_EQ(w.errors.size(), 8u);
    EXPECT_EQ(w->hash(), before);
}

// -- bodies ------------------------------------------------------------------------------------------------------------------------------

TEST(Pose, IsSetByARotationAsByAnAngle) {
    TestWorld by_angle, by_rotation;
    for (TestWorld* w : {&by_angle, &by_rotation}) {
        w->add_ground();
        w->add_box({0, 0.5f});
        w->step(30);
    }
    by_angle->set_transform(by_angle->body_at(1), {2, 3}, 0.7f);
    by_rotation->set_transform(by_rotation->body_at(1), {{2, 3}, make_rot(0.7f)});
    for (int i = 0; i < 120; ++i) {
        by_angle.step();
        by_rotation.step();
        ASSERT_LT(distance(by_angle->position(by_angle->body_at(1)), by_rotation->position(by_rotation->body_at(1))), 1e-4f);
    }
}

TEST(Pose, ThatIsNoneIsRefused) {
    TestWorld w;
    const BodyId body = w.add_box({0, 0.5f});
    const std::uint64_t before = w->hash();
    w->set_transform(body, Transform{{0, 0}, {2, 0}});
    w->set_transform(body, Transform{{0, 0}, {0, 0}});
    w->set_transform(body, Transform{{0, 0}, {NAN, 0}});
    w->set_transform(body, Transform{{2 * max_position, 0}, {}});
    EXPECT_EQ(w.errors, (std::vector{Error::out_of_range, Error::out_of_range, Error::not_finite, Error::out_of_range}));
    EXPECT_EQ(w->hash(), before);
}

TEST(SleepByHand, TakesTheWholeIslandAndNoMore) {
    TestWorld w;
    w.add_ground();
    std::vector<BodyId> stack, other;
    for (int i = 0; i < 5; ++i) {
        stack.push_back(w.add_box({0, 0.5f + static_cast<float>(i)}));
        other.push_back(w.add_box({5, 0.5f + static_cast<float>(i)}));
    }
    w.step(3);
    ASSERT_TRUE(w->is_awake(stack[0]));
    w->apply_force_to_center(stack[4], {1000, 0});
    w->sleep(stack[2]);
    for (const BodyId body : stack) {
        EXPECT_FALSE(w->is_awake(body));
        EXPECT_EQ(w->linear_velocity(body), Vec2{});
    }
    for (const BodyId body : other) EXPECT_TRUE(w->is_awake(body));
    EXPECT_EQ(w->validate(), nullptr);
    const Vec2 place = w->position(stack[4]);
    w.step(60);
    EXPECT_EQ(w->position(stack[4]), place);
    w->wake(stack[0]);
    w.step(2);
    EXPECT_TRUE(w->is_awake(stack[4]));
    EXPECT_LT(std::fabs(w->linear_velocity(stack[4]).x), 0.1f) << "the force before is forgotten";
}

TEST(SleepByHand, GoesAlongJoints) {
    TestWorld w;
    const BodyId a = w.add_box({0, 5}), b = w.add_box({4, 5});
    w->create_joint(DistanceJointDef{.base = {.body_a = a, .body_b = b}, .length = 4});
    w.step();
    w->sleep(a);
    EXPECT_FALSE(w->is_awake(b));
    EXPECT_EQ(w->validate(), nullptr);
    w.step(10);
    EXPECT_EQ(w->position(b).y, 5 - 10.0f / 3600 * 0.625f) << "it hangs where the first step left it: 4 substeps fall g h^2 (1 + 2 + 3 + 4)";
}

TEST(SleepByHand, LeavesOthersAlone) {
    TestWorld w;
    const BodyId ground = w.add_ground();
    const BodyId lift = w.add_box({0, 1}, 1, 0.5f, {}, BodyType::kinematic);
    const BodyId on_lift = w.add_box({0, 2});
    const BodyId falling = w.add_box({9, 9});
    w->set_linear_velocity(lift, {0.2f, 0});
    w.step(5);
    w->sleep(ground);
    w->sleep(lift);
    w->sleep(on_lift);
    EXPECT_TRUE(w->is_awake(lift));
    EXPECT_TRUE(w->is_awake(on_lift)) << "what it stands on moves";
    w->enable_sleep(false);
    w->sleep(falling);
    EXPECT_TRUE(w->is_awake(falling));
    w->enable_sleep(true);
    w->sleep(falling);
    EXPECT_FALSE(w->is_awake(falling));
    EXPECT_TRUE(w.errors.empty());
    EXPECT_EQ(w->validate(), nullptr);
}

// -- shapes ------------------------------------------------------------------------------------------------------------------------------

TEST(ShapeSettings, AShapeBecomesASensorAndBack) {
    TestWorld w;
    w.add_ground();
    const ShapeId shelf = w.shape_of(w.add_box({0, 3}, 1, 0.1f, {}, BodyType::static_body));
    const BodyId box = w.add_box({0, 3.6f});
    w.step(30);
    ASSERT_EQ(w.contacts().size(), 1u);
    w->set_sensor(shelf, true);
    EXPECT_TRUE(w->is_sensor(shelf));
    EXPECT_EQ(w->end_touch_events().size(), 1u);
    w.step(2);
    ShapeId seen;
    EXPECT_EQ(w->sensor_overlaps(shelf, {&seen, 1}), 1u);
    EXPECT_EQ(seen, w.shape_of(box));
    w.step(120);
    EXPECT_NEAR(w->position(box).y, 0.5f, 0.01f) << "it fell through";
    w->set_transform(box, {0, 5}, 0);
    w->set_sensor(shelf, false);
    w.step(120);
    EXPECT_NEAR(w->position(box).y, 3.6f, 0.01f) << "the shelf holds it again";
    EXPECT_EQ(w->validate(), nullptr);
    EXPECT_TRUE(w.errors.empty());
}

TEST(ShapeSettings, ASensorThatSleepsUnderABodyWakesIt) {
    TestWorld w;
    w.add_ground();
    const ShapeId shelf = w.shape_of(w.add_box({0, 3}, 1, 0.1f, {}, BodyType::static_body));
    const BodyId box = w.add_box({0, 3.6f});
    w.step(120);
    ASSERT_FALSE(w->is_awake(box));
    w->set_sensor(shelf, true);
    EXPECT_TRUE(w->is_awake(box));
    w.step(120);
    EXPECT_NEAR(w->position(box).y, 0.5f, 0.01f);
}

TEST(ShapeSettings, ASensorOfAMovingBodyHasMassAndHoldsNothing) {
    TestWorld w;
    w.add_ground();
    const BodyId box = w.add_box({0, 2});
    w->set_mass(box, {5, {0, 0}, 1});
    for (const bool sensor : {true, false}) {
        w->set_transform(box, {0, 2}, 0);
        w->set_linear_velocity(box, {0, -3});
        w->set_sensor(w.shape_of(box), sensor);
        EXPECT_EQ(w->validate(), nullptr);
        EXPECT_EQ(w->mass(box), 5) << "what was set stays";
        w.step(60);
        EXPECT_EQ(w->validate(), nullptr);
        EXPECT_EQ(w->position(box).y < 0, sensor);
    }
}

TEST(ShapeSettings, ASegmentOfAChainMoves) {
    TestWorld w;
    const BodyId ground = w->create_body({});
    const Vec2 points[] = {{9, 0}, {3, 0}, {-3, 0}, {-9, 0}};
    ShapeId segments[3];
    ASSERT_EQ(w->create_chain(ground, points, false, {}, segments), 3u);
    const BodyId ball = w.add_circle({0, 0.5f});
    w.step(90);
    w->set_chain_segment(segments[1], {{9, 0}, {{3, -2}, {-3, -2}}, {-9, 0}});
    EXPECT_TRUE(w->is_awake(ball));
    EXPECT_EQ(w->chain_segment(segments[1])->segment.point1, (Vec2{3, -2}));
    w.step(120);
    EXPECT_NEAR(w->position(ball).y, -1.5f, 0.01f);
    w->set_chain_segment(segments[1], {{9, 0}, {{3, -2}, {3, -2}}, {-9, 0}});
    EXPECT_EQ(w.errors, std::vector{Error::bad_geometry});
    EXPECT_EQ(w->validate(), nullptr);
}

TEST(ShapeSettings, ContactsOfAShapeAreThoseOfItsBodyThatConcernIt) {
    TestWorld w;
    w.add_ground();
    const BodyId table = w->create_body({.type = BodyType::dynamic, .position = {0, 1}});
    const ShapeId left = w->create_shape(table, make_offset_box(0.1f, 1, {{-1, 0}, {}}));
    const ShapeId right = w->create_shape(table, make_offset_box(0.1f, 1, {{1, 0}, {}}));
    const ShapeId top = w->create_shape(table, make_offset_box(1.1f, 0.1f, {{0, 1.1f}, {}}));
    w.add_box({0, 2.45f}, 0.25f, 0.25f);
    w.step(10);
    ContactInfo contacts[8];
    EXPECT_EQ(w->contacts(table, contacts), 3u);
    for (const ShapeId shape : {left, right, top}) {
        ASSERT_EQ(w->contacts(shape, contacts), 1u);
        EXPECT_TRUE(contacts[0].shape_a == shape || contacts[0].shape_b == shape);
    }
    EXPECT_EQ(w->contacts(ShapeId{}, contacts), 0u);
    EXPECT_EQ(w->last_error(), Error::null_id);
}

// -- joints ------------------------------------------------------------------------------------------------------------------------------

TEST(JointSettings, OfAWeldMakeItSoftAndRigidAgain) {
    TestWorld w;
    const BodyId wall = w->create_body({});
    const BodyId plank = w.add_box({1, 0}, 1, 0.1f);
    const JointId weld = w->create_joint(WeldJointDef{.base = {.body_a = wall, .body_b = plank, .frame_b = {{-1, 0}, 0}}});
    w.step(60);
    const float rigid = std::fabs(w->angle(plank));
    w->set_softness(weld, {.angular_hertz = 4});
    EXPECT_EQ(w->softness(weld).angular_hertz, 4);
    w.step(240);
    // A spring of f Hz bends by torque / (I (2 pi f)^2).
    const float bend = w->mass(plank) * 10 / (w->rotational_inertia(plank) * 64 * pi * pi);
    EXPECT_NEAR(w->angle(plank), -bend, 0.03f * bend);
    w->set_softness(weld, {});
    w.step(120);
    EXPECT_NEAR(std::fabs(w->angle(plank)), rigid, 1e-3f);
    EXPECT_TRUE(w.errors.empty());
}

// Changing a joint, or what a body takes part in, wakes the bodies: what no longer holds must fall.
TEST(JointSettings, AWeakerJointBreaksThoughItsBodySleeps) {
    TestWorld w;
    const BodyId beam = w->create_body({});
    const BodyId lamp = w.add_circle({0, -1}, 0.5f);
    RevoluteJointDef def;
    def.base.body_a = beam;
    def.base.body_b = lamp;
    def.base.frame_b.position = {0, 1};
    const JointId hinge = w->create_joint(def);
    for (int i = 0; i < 300 && w->is_awake(lamp); ++i) w.step();
    ASSERT_FALSE(w->is_awake(lamp));
    w->set_break(hinge, 1, 0);  // N; the lamp weighs 8
    w.step(2);
    EXPECT_FALSE(w->is_valid(hinge));
}

TEST(BodySettings, ABodyThatMayTurnAgainWakes) {
    TestWorld w;
    w.add_ground();
    BodyDef def;
    def.type = BodyType::dynamic;
    def.position = {0, 0.8f};
    def.angle = 0.7f;
    def.fixed_rotation = true;
    const BodyId box = w.add(make_box(0.5f, 0.5f), def);
    for (int i = 0; i < 300 && w->is_awake(box); ++i) w.step();
    ASSERT_FALSE(w->is_awake(box));
    w->set_fixed_rotation(box, true);
    EXPECT_FALSE(w->is_awake(box)) << "nothing changed";
    w->set_fixed_rotation(box, false);
    EXPECT_TRUE(w->is_awake(box));
    w.step(300);
    EXPECT_NEAR(w->position(box).y, 0.5f, 0.02f) << "it has come down from its corner";
}

TEST(JointSettings, OfAMouseJointAreRead) {
    TestWorld w;
    const BodyId box = w.add_box({0, 0});
    const JointId mouse = w->create_joint(MouseJointDef{.body = box, .target = {0, 0}, .hertz = 3, .damping_ratio = 0.4f, .max_force = 50});
    EXPECT_EQ(w->softness(mouse).linear_hertz, 3);
    EXPECT_EQ(w->softness(mouse).linear_damping_ratio, 0.4f);
    EXPECT_EQ(w->joint_max_force(mouse), 50);
    w->set_softness(mouse, {.linear_hertz = 8, .linear_damping_ratio = 1});
    w->set_joint_strength(mouse, 5, 0);  // less than its weight
    w.step(60);
    EXPECT_LT(w->position(box).y, -1);
    w->set_joint_strength(mouse, 500, 0);
    w.step(240);
    // The spring gives way by m g / k = g / (2 pi f)^2.
    EXPECT_NEAR(w->position(box).y, -10 / (16 * pi * 16 * pi), 1e-3f);
    w->set_softness(mouse, {});
    EXPECT_EQ(w->last_error(), Error::out_of_range) << "without a frequency it would not pull";
}

TEST(JointSettings, OfAMotorJointAreRead) {
    TestWorld w;
    const BodyId floor = w->create_body({}), box = w.add_box({0, 0});
    MotorJointDef def{.base = {.body_a = floor, .body_b = box, .break_force = 9000, .break_torque = 8000}, .linear_velocity = {1, 2}, .angular_velocity = 3};
    def.max_force = 400;
    def.max_torque = 500;
    const JointId motor = w->create_joint(def);
    EXPECT_EQ(w->joint_linear_velocity(motor), (Vec2{1, 2}));
    EXPECT_EQ(w->joint_angular_velocity(motor), 3);
    EXPECT_EQ(w->joint_max_force(motor), 400);
    EXPECT_EQ(w->joint_max_torque(motor), 500);
    EXPECT_EQ(w->break_force(motor), 9000);
    EXPECT_EQ(w->break_torque(motor), 8000);
    w->set_softness(motor, {.linear_hertz = 4, .angular_hertz = 4});
    w->set_joint_velocity(motor, {0, 0}, 0);
    w.step(240);
    EXPECT_NEAR(w->angle(box), 0, 1e-3f) << "it holds the pose now";
}

TEST(JointSettings, APulleyIsMeasuredAnew) {
    TestWorld w;
    const BodyId a = w.add_box({-2, 0}), b = w.add_box({2, 0});
    const JointId pulley = w->create_joint(PulleyJointDef{.base = {.body_a = a, .body_b = b}, .ground_a = {-2, 5}, .ground_b = {2, 5}});
    w.step(30);
    EXPECT_EQ(w->joint_ratio(pulley), 1);
    w->set_grounds(pulley, {-2, 8}, {2, 8});
    EXPECT_EQ(w->ground_b(pulley), (Vec2{2, 8}));
    EXPECT_LT(w->joint_error(pulley).linear, 1e-5f);
    w.step(30);
    EXPECT_NEAR(w->position(a).y, 0, 0.01f) << "equal weights stay where they are";
    w->set_joint_ratio(pulley, 2);
    EXPECT_LT(w->joint_error(pulley).linear, 1e-5f);
    w.step(30);
    EXPECT_LT(w->joint_error(pulley).linear, 0.01f);
    // T - m g = m a_a and 2 T - m g = m a_b with a_a + 2 a_b = 0 give a_b = g / 5 upward.
    EXPECT_NEAR(w->linear_velocity(b).y, 0.5f * 10 / 5, 0.02f);
    EXPECT_NEAR(w->linear_velocity(a).y, -0.5f * 20 / 5, 0.04f);
    w->set_grounds(pulley, w->position(a), {2, 8});
    EXPECT_EQ(w->last_error(), Error::out_of_range) << "a rope of no length has no direction";
    w->set_joint_ratio(pulley, -1);
    EXPECT_EQ(w->last_error(), Error::out_of_range);
    EXPECT_EQ(w->joint_ratio(pulley), 2);
}

TEST(JointSettings, AGearTakesANewRatioFromWhereItIs) {
    TestWorld w;
    w->set_gravity({});
    const BodyId floor = w->create_body({});
    const BodyId a = w.add_circle({0, 0}), b = w.add_circle({2, 0});
    const JointId hinge_a = w->create_joint(RevoluteJointDef{.base = {.body_a = floor, .body_b = a}});
    const JointId hinge_b = w->create_joint(RevoluteJointDef{.base = {.body_a = floor, .body_b = b, .frame_a = {{2, 0}, 0}}});
    const JointId gear = w->create_joint(GearJointDef{.joint1 = hinge_a, .joint2 = hinge_b, .ratio = 1});
    EXPECT_EQ(w->joint1(gear), hinge_a);
    EXPECT_EQ(w->joint2(gear), hinge_b);
    w->set_angular_velocity(a, 1);
    w.step(60);
    const float turned_a = w->joint_position(hinge_a), turned_b = w->joint_position(hinge_b);
    w->set_joint_ratio(gear, -3);
    w.step(60);
    EXPECT_NEAR((w->joint_position(hinge_a) - turned_a) - 3 * (w->joint_position(hinge_b) - turned_b), 0, 1e-3f);
    EXPECT_GT(std::fabs(w->joint_position(hinge_b) - turned_b), 0.05f) << "and it does turn";
    EXPECT_EQ(w->joint_ratio(gear), -3);
    w->set_joint_ratio(gear, 0);
    EXPECT_EQ(w->last_error(), Error::out_of_range);
}

}  // namespace
}  // namespace islet::test
