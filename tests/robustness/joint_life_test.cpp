// The life of joints: what becomes of them, of the gears on them and of their bodies' sleep when bodies and joints come, go and change.
#include <algorithm>

#include "physics/measure.hpp"
#include "refusal.hpp"
#include "support/joint_world.hpp"

namespace {

using namespace islet;
using namespace islet::test;

class JointLife : public testing::Test {
protected:
    ~JointLife() override { expect_sound("in the end"); }

    void expect_sound(const char* when) {
        const char* broken = w->validate();
        EXPECT_EQ(broken, nullptr) << broken << ", " << when;
        EXPECT_TRUE(w.is_finite()) << when;
    }
    BodyId box(float x, float y, BodyType type = BodyType::dynamic) { return w.add_box({x, y}, 0.4f, 0.4f, {}, type); }

    TestWorld w{roomy, weightless_but_sleepy()};

private:
    static WorldDef weightless_but_sleepy() {
        WorldDef def;
        def.gravity = {0, 0};
        return def;
    }
};

// -- destroying ------------------------------------------------------------------------------------------------------------------------

TEST_F(JointLife, ABodyTakesItsJointsAndTheirGearsWithIt) {
    const BodyId hub = box(0, 0, BodyType::static_body), a = box(2, 0), b = box(4, 0), c = box(6, 0);
    const JointId ha = join(*w, JointType::revolute, hub, a), hb = join(*w, JointType::revolute, hub, b),
                  bc = join(*w, JointType::weld, b, c);
    const JointId gear = w->create_joint(GearJointDef{ha, hb});
    ASSERT_TRUE(gear);
    w.step();
    EXPECT_EQ(w.joints_of(a), (std::vector<JointId>{gear, ha}));
    EXPECT_EQ(w.joints_of(b), (std::vector<JointId>{gear, bc, hb}));
    w->destroy_body(a);
    EXPECT_FALSE(w->is_valid(ha));
    EXPECT_FALSE(w->is_valid(gear)) << "of joint 1, which is gone";
    EXPECT_TRUE(w->is_valid(hb));
    EXPECT_EQ(w->joint_count(), 2u);
    EXPECT_EQ(w.joints_of(b), (std::vector<JointId>{bc, hb}));
    expect_sound("after destroying a");
    w->destroy_body(hub);
    EXPECT_EQ(w->joint_count(), 1u);
    w->destroy_body(c);
    EXPECT_EQ(w->joint_count(), 0u);
    w.step();
    EXPECT_TRUE(w->broken_joints().empty()) << "destroyed is not broken";
    EXPECT_TRUE(w.errors.empty());
}

TEST_F(JointLife, ADestroyedJointTakesEveryGearOnIt) {
    const BodyId hub = box(0, 0, BodyType::kinematic);
    std::vector<JointId> hinges, gears;
    for (int i = 0; i < 5; ++i) hinges.push_back(join(*w, JointType::revolute, hub, box(2.0f * static_cast<float>(i + 1), 0)));
    for (std::size_t i = 0; i < 5; ++i) gears.push_back(w->create_joint(GearJointDef{hinges[i], hinges[(i + 1) % 5]}));
    for (std::size_t i = 0; i < 5; ++i) gears.push_back(w->create_joint(GearJointDef{hinges[(i + 2) % 5], hinges[i], -1}));
    w.step(5);
    w->destroy_joint(hinges[2]);
    for (std::size_t i = 0; i < 10; ++i) {
        const bool on_it = i == 1 || i == 2 || i == 5 || i == 7;
        EXPECT_EQ(w->is_valid(gears[i]), !on_it) << "gear " << i;
    }
    EXPECT_EQ(w->joint_count(), 4u + 6u);
    expect_sound("after the joint");
    w->destroy_joint(gears[0]);
    w->destroy_body(hub);
    EXPECT_EQ(w->joint_count(), 0u);
}

TEST_F(JointLife, AnyOrderOfDestroyingEndsInAnEmptyWorld) {
    // All orders of two bodies, two hinges and the gear on them: what is gone already is stale and nothing else happens.
    std::array<int, 5> order = {0, 1, 2, 3, 4};
    do {
        const BodyId hub = box(0, 0), a = box(2, 0), b = box(4, 0);
        const JointId ha = join(*w, JointType::revolute, hub, a), hb = join(*w, JointType::prismatic, hub, b);
        const JointId gear = w->create_joint(GearJointDef{ha, hb});
        w.step();
        for (const int i : order) {
            if (i < 2 && w->is_valid(i == 0 ? a : b)) w->destroy_body(i == 0 ? a : b);
            const JointId joint = i == 2 ? ha : i == 3 ? hb : gear;
            if (i >= 2 && w->is_valid(joint)) w->destroy_joint(joint);
            const bool gone_a = !w->is_valid(ha), gone_b = !w->is_valid(hb);
            EXPECT_FALSE(w->is_valid(gear) && (gone_a || gone_b));
            ASSERT_EQ(w->validate(), nullptr);
            w.step();
        }
        EXPECT_EQ(w->joint_count(), 0u);
        EXPECT_EQ(w->body_count(), 1u);
        w->destroy_body(hub);
        w.errors.clear();
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST_F(JointLife, ManyJointsBetweenTheSameTwoBodies) {
    const BodyId a = box(0, 0), b = box(2, 0);
    std::vector<JointId> ids;
    for (const JointType type : joint_types)
        if (type != JointType::gear) ids.push_back(join(*w, type, a, b));
    w.step(10);
    expect_sound("with eight joints on two bodies");
    while (!ids.empty()) {
        w->destroy_joint(ids[ids.size() / 2]);
        ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(ids.size() / 2));
        w.step(2);
        expect_sound("with fewer");
    }
    EXPECT_EQ(w->joints(a, {}), 0u);
    EXPECT_EQ(w->joints(b, {}), 0u);
}

// -- what a joint says of itself --------------------------------------------------------------------------------------------------------

TEST_F(JointLife, AJointReadsBackAsItWasMade) {
    const BodyId a = box(0, 0), b = box(2, 1);
    JointBase base{.body_a = a, .body_b = b, .frame_a = {{0.25f, 0.5f}, 0.75f}, .frame_b = {{-0.5f, 0}, -2}};
    base.collide_connected = true;
    base.user_data = 0x123456789abcdef0ull;
    const JointId ids[] = {w->create_joint(RevoluteJointDef{.base = base}),
                           w->create_joint(PrismaticJointDef{.base = base}),
                           w->create_joint(DistanceJointDef{.base = base}),
                           w->create_joint(WeldJointDef{.base = base}),
                           w->create_joint(WheelJointDef{.base = base}),
                           w->create_joint(MotorJointDef{.base = base}),
                           w->create_joint(PulleyJointDef{.base = base, .ground_a = {0, 9}, .ground_b = {3, 9}}),
                           w->create_joint(AngleJointDef{.base = base})};
    const JointType types[] = {JointType::revolute, JointType::prismatic, JointType::distance, JointType::weld,
                               JointType::wheel,    JointType::motor,     JointType::pulley,   JointType::angle};
    for (std::size_t i = 0; i < std::size(ids); ++i) {
        SCOPED_TRACE(name_of(types[i]));
        EXPECT_EQ(w->joint_type(ids[i]), types[i]);
        EXPECT_EQ(w->body_a(ids[i]), a);
        EXPECT_EQ(w->body_b(ids[i]), b);
        EXPECT_EQ(w->frame_a(ids[i]).position, base.frame_a.position);
        EXPECT_EQ(w->frame_b(ids[i]).position, base.frame_b.position);
        EXPECT_NEAR(w->frame_a(ids[i]).angle, 0.75f, 1e-6f);
        EXPECT_NEAR(w->frame_b(ids[i]).angle, -2.0f, 1e-6f);
        EXPECT_LT(distance(w->anchor_a(ids[i]), {0.25f, 0.5f}), 1e-6f);
        EXPECT_LT(distance(w->anchor_b(ids[i]), {1.5f, 1}), 1e-6f);
        EXPECT_TRUE(w->collide_connected(ids[i]));
        EXPECT_EQ(w->user_data(ids[i]), base.user_data);
        w->set_user_data(ids[i], i);
        EXPECT_EQ(w->user_data(ids[i]), i);
    }
    const JointId mouse = w->create_joint(MouseJointDef{.body = b, .target = {2.25f, 1}, .user_data = 7});
    EXPECT_FALSE(w->body_a(mouse));
    EXPECT_EQ(w->body_b(mouse), b);
    EXPECT_EQ(w->anchor_a(mouse), (Vec2{2.25f, 1}));
    EXPECT_EQ(w->anchor_b(mouse), (Vec2{2.25f, 1}));
    EXPECT_EQ(w->target(mouse), (Vec2{2.25f, 1}));
    EXPECT_EQ(w->user_data(mouse), 7u);
    EXPECT_TRUE(w.errors.empty());
    for (const JointId id : w.joints_of(b)) w->destroy_joint(id);
}

// -- types of bodies -------------------------------------------------------------------------------------------------------------------

TEST_F(JointLife, BodiesMayChangeTheirTypeUnderEveryJoint) {
    const Machine m = add_machine(*w, {0, 0});
    const BodyType types[] = {BodyType::static_body, BodyType::dynamic,   BodyType::kinematic,
                              BodyType::static_body, BodyType::kinematic, BodyType::dynamic};
    for (const BodyId body : w.bodies()) {
        for (const BodyType type : types) {
            w->set_type(body, type);
            expect_sound("after the change");
            w.step(3);
            expect_sound("after stepping");
        }
        if (body == m.frame) w->set_type(body, BodyType::static_body);
    }
    // All at once, and back.
    for (const BodyType type : types) {
        for (const BodyId body : w.bodies()) {
            w->set_type(body, type);
            expect_sound("on the way");
        }
        w.step(3);
        expect_sound("with all of one type");
    }
    EXPECT_EQ(w->joint_count(), joint_type_count) << "no change of type destroys a joint";
    EXPECT_TRUE(w.errors.empty());
}

TEST_F(JointLife, AGearHoldsWhicheverBodiesOfItsJointsMove) {
    // Hinge 1 is made with both bodies dynamic, then its B is pinned: the gear turns A instead. Pinned and let go in every way, it holds.
    const BodyId a = box(0, 0), b = box(0, 2), hub = box(4, 0, BodyType::static_body), c = box(6, 0);
    const JointId first = join(*w, JointType::revolute, a, b), second = join(*w, JointType::revolute, hub, c);
    const JointId gear = w->create_joint(GearJointDef{first, second, 1});
    for (const auto& [type_a, type_b] : {std::pair{BodyType::dynamic, BodyType::static_body},
                                         {BodyType::dynamic, BodyType::kinematic},
                                         {BodyType::static_body, BodyType::dynamic},
                                         {BodyType::kinematic, BodyType::static_body},
                                         {BodyType::dynamic, BodyType::dynamic}}) {
        w->set_type(a, type_a);
        w->set_type(b, type_b);
        for (int i = 0; i < 60; ++i) {
            w->apply_torque(c, 0.2f);
            w.step();
            ASSERT_EQ(w->validate(), nullptr);
        }
        EXPECT_LT(w->joint_error(gear).angular, 0.02f);
        w.step(120);
        w->wake(type_a == BodyType::dynamic ? a : b);
        EXPECT_TRUE(w->is_awake(c) || (type_a != BodyType::dynamic && type_b != BodyType::dynamic)) << "the gear's bodies wake together";
        w->destroy_joint(w->create_joint(GearJointDef{second, first, 1}));
        expect_sound("with a gear more for a moment");
    }
    w->destroy_joint(first);
    EXPECT_FALSE(w->is_valid(gear));
}

TEST_F(JointLife, TheBodiesOfAGearMayComeToShareOne) {
    // Both joints hang on one hub. With their other bodies pinned, the hub is what moves for both.
    const BodyId hub = box(0, 0), a = box(2, 0), b = box(-2, 0);
    const JointId ha = join(*w, JointType::revolute, hub, a), hb = join(*w, JointType::prismatic, hub, b);
    const JointId gears[] = {w->create_joint(GearJointDef{ha, hb, 1}), w->create_joint(GearJointDef{hb, ha, 2}),
                             w->create_joint(GearJointDef{ha, hb, -1})};
    for (const BodyType type : {BodyType::static_body, BodyType::kinematic, BodyType::dynamic, BodyType::static_body}) {
        w->set_type(a, type);
        expect_sound("with one pinned");
        w->set_type(b, type);
        w->apply_linear_impulse_to_center(hub, {0.5f, 1});
        expect_sound("with both pinned");
        w.step(20);
        for (const JointId gear : gears) EXPECT_TRUE(w->is_valid(gear));
    }
    w->destroy_joint(gears[1]);
    expect_sound("with one gear fewer");
    w->destroy_joint(ha);
    for (const JointId gear : gears) EXPECT_FALSE(w->is_valid(gear));
    EXPECT_EQ(w->joint_count(), 1u);
}

TEST_F(JointLife, AJointBetweenBodiesThatCannotMoveWaitsUntilOneCan) {
    const BodyId a = box(0, 0), b = box(2, 0);
    const JointId weld = join(*w, JointType::weld, a, b);
    w->set_type(a, BodyType::static_body);
    w->set_type(b, BodyType::kinematic);
    w->set_linear_velocity(b, {1, 0});
    w.step(60);
    EXPECT_NEAR(w->position(b).x, 3, 1e-3f) << "nothing holds a kinematic body";
    EXPECT_EQ(w->report().awake_joints, 0u);
    w->set_type(b, BodyType::dynamic);
    w->set_linear_velocity(b, {0, 0});
    w.step(300);
    EXPECT_NEAR(w->position(b).x, 2, 0.01f) << "the joint pulls it back";
    EXPECT_LT(w->joint_error(weld).linear, 0.01f);
}

// -- sleep -----------------------------------------------------------------------------------------------------------------------------

TEST_F(JointLife, SleepAndWakingGoThroughJointsOfEveryType) {
    for (const JointType type : joint_types) {
        if (type == JointType::mouse || type == JointType::gear) continue;
        SCOPED_TRACE(name_of(type));
        const BodyId a = box(0, 0), b = box(2, 0), c = box(4, 0);
        const JointId ab = join(*w, type, a, b), bc = join(*w, type, b, c);
        w.step(120);
        ASSERT_FALSE(w->is_awake(a) || w->is_awake(b) || w->is_awake(c)) << "they rest";
        EXPECT_EQ(w->report().awake_joints, 0u);
        w->wake(c);
        EXPECT_TRUE(w->is_awake(a));
        w.step(120);
        ASSERT_FALSE(w->is_awake(a));
        expect_sound("asleep again");
        w->enable_sleep(c, false);
        w.step(120);
        EXPECT_TRUE(w->is_awake(a)) << "one keeps them all awake";
        w->enable_sleep(c, true);
        w.step(120);
        ASSERT_FALSE(w->is_awake(a));
        w->destroy_joint(bc);
        EXPECT_TRUE(w->is_awake(a) && w->is_awake(b) && w->is_awake(c)) << "what was joined wakes when it is not any more";
        w.step(120);
        w->destroy_body(b);
        EXPECT_TRUE(w->is_awake(a));
        EXPECT_FALSE(w->is_valid(ab));
        w->destroy_body(a);
        w->destroy_body(c);
    }
}

TEST_F(JointLife, AGearSharesSleepBetweenItsBodies) {
    const BodyId hub = box(0, 0, BodyType::static_body), a = box(2, 0), b = box(4, 0);
    const JointId ha = join(*w, JointType::revolute, hub, a), hb = join(*w, JointType::revolute, hub, b);
    w->create_joint(GearJointDef{ha, hb});
    w.step(120);
    ASSERT_FALSE(w->is_awake(a) || w->is_awake(b));
    w->apply_angular_impulse(a, 0.5f);
    EXPECT_TRUE(w->is_awake(b));
    w.step(10);
    EXPECT_NEAR(w->angular_velocity(b), -w->angular_velocity(a), 1e-3f);
    EXPECT_GT(std::fabs(w->angular_velocity(b)), 0.1f);
}

TEST_F(JointLife, EveryChangeOfAJointWakesItsBodies) {
    const Machine m = add_machine(*w, {0, 0});
    const JointId hinge = m[JointType::revolute], rail = m[JointType::prismatic], rod = m[JointType::distance], drive = m[JointType::motor],
                  mouse = m[JointType::mouse];
    for (const BodyId body : w.bodies()) w->set_linear_damping(body, 1);  // lest the bob orbits for ever
    const auto change = [&](int i) -> BodyId {
        switch (i) {
        case 0: return w->set_spring(hinge, {}), m.arm;
        case 1: return w->set_limit(rail, {}), m.slider;
        case 2: return w->set_motor(hinge, {}), m.arm;
        case 3: return w->set_joint_friction(rail, 2), m.slider;
        case 4: return w->set_joint_length(rod, 1), m.bob;
        case 5: return w->set_joint_velocity(drive, {}, 0), m.drone;
        case 6: return w->set_joint_strength(drive, 5, 5), m.drone;
        case 7: return w->set_target(mouse, {3, 4}), m.drone;
        case 8: return w->set_frames(rod, {{1, 0}, 0}, {}), m.bob;
        case 9: return w->set_collide_connected(rod, true), m.arm;
        default: return w->destroy_joint(mouse), m.drone;
        }
    };
    for (int i = 0; i <= 10; ++i) {
        for (const BodyId body : w.bodies()) {
            w->set_linear_velocity(body, {});
            w->set_angular_velocity(body, 0);
        }
        w->set_motor(hinge, {});
        w->set_motor(rail, {});
        w->set_motor(rod, {});
        w->set_motor(m[JointType::wheel], {});
        w->set_joint_velocity(drive, {}, 0);
        w.step(1200);
        ASSERT_EQ(w->report().awake_bodies, 0u) << "before change " << i;
        const BodyId woken = change(i);
        EXPECT_TRUE(w->is_awake(woken)) << "change " << i;
        expect_sound("after a change");
        w.step();
    }
}

TEST_F(JointLife, AStaticAnchorThatIsMovedOrLetGoWakesWhatHangsOnIt) {
    for (const int kind : {0, 1, 2}) {
        SCOPED_TRACE(kind);
        const BodyId anchor = box(0, 0, BodyType::static_body), hanging = box(2, 0);
        join(*w, JointType::weld, anchor, hanging);
        w.step(120);
        ASSERT_FALSE(w->is_awake(hanging));
        if (kind == 0) w->set_transform(anchor, {0, 1}, 0);
        if (kind == 1) w->set_type(anchor, BodyType::dynamic);
        if (kind == 2) w->set_type(anchor, BodyType::kinematic), w->set_linear_velocity(anchor, {0, 0.5f});
        expect_sound("after the call");
        EXPECT_TRUE(w->is_awake(hanging));
        w.step(120);
        expect_sound("later");
        EXPECT_NEAR(w->position(hanging).y, kind == 1 ? 0 : 1, 0.05f);
        w->destroy_body(anchor);
        w->destroy_body(hanging);
    }
}

TEST_F(JointLife, AKinematicBodyCarriesWhatIsJoinedToIt) {
    const BodyId lift = box(0, 0, BodyType::kinematic), load = box(2, 0);
    join(*w, JointType::weld, lift, load);
    w.step(120);
    EXPECT_FALSE(w->is_awake(load));
    w->set_linear_velocity(lift, {0, 1});
    EXPECT_TRUE(w->is_awake(load));
    w.step(180);
    EXPECT_TRUE(w->is_awake(load)) << "joined to a body that moves";
    EXPECT_NEAR(w->position(load).y, 3, 0.05f);
    // A sleeping body is woken when it is tied to one that is awake, and the reverse.
    BodyDef def = dynamic_at({9, 0});
    def.awake = false;
    const BodyId sleeper = w.add(make_box(0.4f, 0.4f), def);
    join(*w, JointType::distance, lift, sleeper);
    EXPECT_TRUE(w->is_awake(sleeper));
    expect_sound("after tying");
}

}  // namespace
