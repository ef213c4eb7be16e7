// The C interface and that of C++ make the same worlds: machines.c's scene once more, and equal hashes after each step.
#include "machines.h"

#include <gtest/gtest.h>
#include <islet/islet.hpp>

namespace {

using namespace islet;

StaticWorld<Capacity{.bodies = 100, .shapes = 100, .contacts = 500, .joints = 20}> machines_storage;

BodyId body_at(World& world, BodyType type, float x, float y) { return world.create_body({.type = type, .position = {x, y}, .angle = 0.125f}); }

unsigned same_machines(std::uint64_t* hashes, unsigned count) {
    const Hooks hooks = {
        .filter = [](ShapeId a, ShapeId b, void*) { return !(a.index1 % 2 == 1 && b.index1 % 2 == 1 && a.index1 > 10 && b.index1 > 10); },
        .pre_solve = [](PreSolve& contact, void*) { contact.friction *= 0.5f; },
        .mix_friction = [](float a, std::uint32_t material_a, float b, std::uint32_t material_b,
                           void*) { return material_a == 3 || material_b == 3 ? 0.05f : min(a, b); },
    };
    World& world =
        machines_storage.create({.gravity = {0.5f, -10}, .solver = {.substeps = 3, .contact_hertz = 25}, .restitution_threshold = 0.5f, .hooks = hooks});
    const BodyId ground = body_at(world, BodyType::static_body, 0, 0);
    const Vec2 points[] = {{40, 3}, {20, 0}, {-20, 0}, {-40, 3}};
    world.create_chain(ground, points, false);
    world.create_shape(ground, HalfSpace{{0, 1}, -5});
    BodyId body[18];
    for (unsigned i = 0; i < 18; ++i) {
        body[i] = body_at(world, BodyType::dynamic, -12.0f + 1.5f * float(i), 4.0f + float(i % 3));
        const ShapeDef def = {
            .restitution = i % 5 == 0 ? 0.5f : 0, .density = 1 + 0.25f * float(i % 4), .hit_events = true, .pre_solve = i % 2 == 0, .material = i % 4};
        if (i % 3 == 0)
            world.create_shape(body[i], make_rounded_box(0.4f, 0.3f, 0.05f), def);
        else if (i % 3 == 1)
            world.create_shape(body[i], Circle{{0.1f, 0}, 0.4f}, def);
        else
            world.create_shape(body[i], Capsule{{-0.3f, 0}, {0.3f, 0.1f}, 0.25f}, def);
    }
    const auto base = [&](int a) { return JointBase{.body_a = body[a], .body_b = body[a + 1]}; };
    JointBase arm = base(0);
    arm.frame_a.position.x = 0.75f;
    arm.frame_b.position.x = -0.75f;
    const JointId hinge = world.create_joint(RevoluteJointDef{.base = arm, .limit = {.enable = true, .upper = 1}});
    const JointId slider = world.create_joint(PrismaticJointDef{.base = base(1), .motor = {.enable = true, .speed = 1, .max_force = 20}});
    JointBase weak = base(3);
    weak.break_force = 40;
    world.create_joint(DistanceJointDef{.base = weak, .length = 1.5f});
    world.create_joint(WeldJointDef{.base = base(5), .angular_hertz = 5});
    world.create_joint(WheelJointDef{.base = base(7)});
    world.create_joint(MotorJointDef{.base = base(9), .max_force = 5});
    world.create_joint(MouseJointDef{.body = body[11], .target = {0, 9}, .max_force = 50});
    world.create_joint(PulleyJointDef{.base = base(12), .ground_a = {0, 12}, .ground_b = {0, 12}, .ratio = 0.5f});
    world.create_joint(AngleJointDef{.base = base(14), .ratchet = {.step = 0.2f}});
    world.create_joint(GearJointDef{.joint1 = hinge, .joint2 = slider, .ratio = 2});
    unsigned events = 0;
    for (unsigned i = 0; i < count; ++i) {
        if (i % 20 == 10) world.apply_force_to_center(body[16], {0, 30});
        world.step(1.0f / 60);
        hashes[i] = world.hash();
        events += unsigned(world.begin_touch_events().size() + world.hit_events().size() + world.broken_joints().size());
    }
    return world.last_error() == Error::none ? events : 0;
}

TEST(Machines, HaveTheSameHashesFromCAndFromCpp) {
    std::uint64_t of_c[200], of_cpp[200];
    const unsigned events = machines(of_c, 200);
    EXPECT_GT(events, 40u);
    EXPECT_EQ(same_machines(of_cpp, 200), events);
    for (int i = 0; i < 200; ++i) ASSERT_EQ(of_c[i], of_cpp[i]) << "step " << i;
}

}  // namespace
