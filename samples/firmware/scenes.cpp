#include "scenes.hpp"

namespace firmware {

using namespace islet;

namespace {

BodyId add_floor(World& world) {
    const BodyId floor = world.create_body({.position = {0, -1}});
    world.create_shape(floor, make_box(12, 1));
    return floor;
}

BodyId add_dynamic(World& world, Vec2 position) { return world.create_body({.type = BodyType::dynamic, .position = position}); }

/// A capsule and the hinge that hangs it on its parent. Standing upright, feet at 0; metres, radians.
struct Bone {
    int parent;           // -1: none
    float height;         // of its middle
    float half, radius;   // of its straight part, of its ends
    float pivot;          // height of the hinge
    float lower, upper;   // how far the hinge turns
};

constexpr Bone bones[] = {
    {-1, 0.95f, 0.02f, 0.095f, 0, 0, 0},               // hip
    {0, 1.20f, 0.13f, 0.09f, 1.02f, -0.6f, 0.6f},      // torso
    {1, 1.48f, 0.04f, 0.075f, 1.40f, -0.8f, 0.4f},     // head
    {0, 0.78f, 0.12f, 0.06f, 0.90f, -0.2f, 1.2f},      // upper legs and shins
    {3, 0.42f, 0.15f, 0.05f, 0.62f, -1.6f, 0},
    {0, 0.78f, 0.12f, 0.06f, 0.90f, -0.2f, 1.2f},
    {5, 0.42f, 0.15f, 0.05f, 0.62f, -1.6f, 0},
    {1, 1.22f, 0.12f, 0.035f, 1.35f, -0.3f, 2.4f},     // upper arms and forearms
    {7, 0.98f, 0.12f, 0.03f, 1.10f, 0, 1.6f},
    {1, 1.22f, 0.12f, 0.035f, 1.35f, -0.3f, 2.4f},
    {9, 0.98f, 0.12f, 0.03f, 1.10f, 0, 1.6f},
};

}  // namespace

void build_pyramid(World& world) {
    world.enable_sleep(false);
    add_floor(world);
    constexpr int rows = 10;
    for (int row = 0; row < rows; ++row) {
        for (int column = row; column < rows; ++column) {
            const float x = 0.5f * static_cast<float>(row + 1) + static_cast<float>(column - row) - 5.0f;
            const BodyId box = add_dynamic(world, {x, static_cast<float>(row) + 0.5f});
            world.create_shape(box, make_box(0.5f, 0.5f));
        }
    }
}

void build_ragdoll(World& world) {
    add_floor(world);
    BodyId made[std::size(bones)];
    int n = 0;
    for (const Bone& bone : bones) {
        const BodyId body = made[n++] = add_dynamic(world, {0, bone.height + 0.5f});
        // Bones of one figure do not meet each other.
        world.create_shape(body, Capsule{{0, -bone.half}, {0, bone.half}, bone.radius}, {.friction = 0.4f, .filter = {.group = -1}});
        if (bone.parent < 0) continue;
        const Bone& parent = bones[bone.parent];
        world.create_joint(RevoluteJointDef{.base = {.body_a = made[bone.parent],
                                                     .body_b = body,
                                                     .frame_a = {{0, bone.pivot - parent.height}},
                                                     .frame_b = {{0, bone.pivot - bone.height}}},
                                            .spring = {.enable = true, .hertz = 2, .damping_ratio = 0.5f},
                                            .limit = {.enable = true, .lower = bone.lower, .upper = bone.upper},
                                            .friction = 0.05f});
    }
    world.set_linear_velocity(made[1], {1.5f, 0});
}

void build_circles(World& world) {
    world.enable_sleep(false);
    const BodyId trough = add_floor(world);
    world.create_shape(trough, make_offset_box(0.25f, 4, {{-3.2f, 4}, {}}));
    world.create_shape(trough, make_offset_box(0.25f, 4, {{3.2f, 4}, {}}));
    for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 8; ++column) {
            const float shift = (row & 1) != 0 ? 0.1f : -0.1f;
            const BodyId ball = add_dynamic(world, {0.7f * static_cast<float>(column) - 2.45f + shift, 0.4f + 0.7f * static_cast<float>(row)});
            world.create_shape(ball, Circle{{}, 0.3f}, {.restitution = 0.2f});
        }
    }
}

void build_machine(World& world) {
    // A valley of chain, with a bump and a ramp in it that carries things along.
    const BodyId ground = world.create_body({});
    const Vec2 valley[] = {{8, 3}, {6, 0}, {2, -0.5f}, {-2, -0.5f}, {-6, 0}, {-8, 3}};
    world.create_chain(ground, valley, false);
    world.create_shape(ground, Segment{{-5, 1}, {-3, 0.2f}}, {.tangent_speed = 1});
    const BodyId lift = world.create_body({.type = BodyType::kinematic, .position = {5, 0}, .linear_velocity = {-0.5f, 0.2f}});
    world.create_shape(lift, make_rounded_box(0.6f, 0.1f, 0.05f));

    // Two rows of bodies of all kinds; each joint ties one of the upper row to one of the lower.
    BodyId upper[9], lower[9];
    const Vec2 corners[] = {{-0.2f, -0.2f}, {0.25f, -0.15f}, {0.1f, 0.25f}};
    for (int i = 0; i < 9; ++i) {
        const float x = static_cast<float>(i) - 4.0f;
        upper[i] = add_dynamic(world, {x, 3.5f});
        lower[i] = add_dynamic(world, {x, 2.5f});
        world.create_shape(upper[i], make_box(0.2f, 0.15f), {.restitution = 0.3f});
        switch (i % 3) {
            case 0: world.create_shape(lower[i], Circle{{}, 0.2f}, {.rolling_resistance = 0.05f}); break;
            case 1: world.create_shape(lower[i], Capsule{{-0.1f, 0}, {0.1f, 0}, 0.12f}); break;
            default: world.create_shape(lower[i], make_polygon(compute_hull(corners))); break;
        }
    }
    const auto tie = [&](int i) {
        return JointBase{.body_a = upper[i], .body_b = lower[i], .frame_a = {{0, -0.5f}, -0.5f * pi}, .frame_b = {{0, 0.5f}, -0.5f * pi}};
    };
    const JointId hinge = world.create_joint(RevoluteJointDef{.base = tie(0), .motor = {.enable = true, .speed = 3, .max_force = 1}});
    const JointId slider = world.create_joint(PrismaticJointDef{.base = tie(1), .limit = {.enable = true, .lower = -0.1f, .upper = 0.4f}});
    world.create_joint(DistanceJointDef{.base = tie(2), .length = 0.5f, .spring = {.enable = true, .hertz = 3, .damping_ratio = 0.2f}});
    world.create_joint(WeldJointDef{.base = tie(3), .angular_hertz = 4});
    world.create_joint(WheelJointDef{.base = tie(4), .motor = {.enable = true, .speed = 5, .max_force = 2}});
    world.create_joint(MotorJointDef{.base = tie(5), .angular_velocity = 1, .max_force = 20, .max_torque = 1});
    world.create_joint(MouseJointDef{.body = lower[6], .target = {2.5f, 4}, .max_force = 30});
    world.create_joint(PulleyJointDef{.base = tie(7), .ground_a = {2.8f, 5}, .ground_b = {3.2f, 5}});
    world.create_joint(RevoluteJointDef{.base = tie(8)});
    world.create_joint(GearJointDef{.joint1 = hinge, .joint2 = slider, .ratio = 0.5f});
}

void build_ordered_machine(World& world) {
    build_machine(world);
    world.set_solver({.iterations = 2, .sweep_order = SweepOrder::upward, .block_contacts = true, .shock = 0.2f, .tolerance = 0.001f});
}

}  // namespace firmware
