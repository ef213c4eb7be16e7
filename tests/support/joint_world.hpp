// Joints for tests: one of any type in a word, and a machine that holds all ten. Nothing here allocates.
#pragma once

#include <array>

#include "islet/islet.hpp"

namespace islet::test {

inline constexpr Capacity room_for_joints{.bodies = 32, .shapes = 32, .contacts = 64, .joints = 32};
inline constexpr JointType joint_types[joint_type_count] = {JointType::revolute, JointType::prismatic, JointType::distance,
                                                            JointType::weld,     JointType::wheel,     JointType::motor,
                                                            JointType::mouse,    JointType::pulley,    JointType::gear,
                                                            JointType::angle};
inline const char* name_of(JointType type) {
    constexpr const char* names[] = {"revolute", "prismatic", "distance", "weld", "wheel", "motor", "mouse", "pulley", "gear", "angle"};
    return names[static_cast<std::size_t>(type)];
}

/// Frames that lie on each other at the origin of B.
inline JointBase base_at_b(const World& w, BodyId a, BodyId b) {
    const Transform pose_a = w.transform(a);
    JointBase base;
    base.body_a = a;
    base.body_b = b;
    base.frame_a = {inv_transform_point(pose_a, w.position(b)), w.angle(b) - w.angle(a)};
    return base;
}

/// Joins two bodies as they stand, by a joint of any type but a gear. A mouse joint pulls B and needs it dynamic.
inline JointId join(World& w, JointType type, BodyId a, BodyId b, bool collide = false) {
    JointBase base = base_at_b(w, a, b);
    base.collide_connected = collide;
    switch (type) {
    case JointType::revolute: return w.create_joint(RevoluteJointDef{.base = base});
    case JointType::prismatic: return w.create_joint(PrismaticJointDef{.base = base});
    case JointType::distance: {
        base.frame_a.position = {};
        return w.create_joint(DistanceJointDef{.base = base, .length = max(0.005f, distance(w.position(a), w.position(b)))});
    }
    case JointType::weld: return w.create_joint(WeldJointDef{.base = base});
    case JointType::wheel: return w.create_joint(WheelJointDef{.base = base});
    case JointType::motor: return w.create_joint(MotorJointDef{.base = base, .max_force = 100, .max_torque = 10});
    case JointType::mouse: return w.create_joint(MouseJointDef{.body = b, .target = w.position(b), .max_force = 1000});
    case JointType::pulley: {
        base.frame_a.position = {};
        const Vec2 above = {0, 3};
        return w.create_joint(PulleyJointDef{.base = base, .ground_a = w.position(a) + above, .ground_b = w.position(b) + above});
    }
    case JointType::angle: return w.create_joint(AngleJointDef{.base = base, .limit = {.enable = true}});
    case JointType::gear: break;
    }
    return {};
}

/// A machine of one frame, nine moving bodies and a joint of each type, all of them under load.
struct Machine {
    BodyId frame, arm, bob, slider, tip, cart, wheel, drone, left, right;
    std::array<JointId, joint_type_count> joints;  // by type
    JointId operator[](JointType type) const { return joints[static_cast<std::size_t>(type)]; }
};
inline constexpr std::uint32_t machine_bodies = 10, machine_shapes = 11;

inline Machine add_machine(World& w, Vec2 at) {
    const auto add = [&](BodyType type, Vec2 place, Vec2 half) {
        BodyDef def;
        def.type = type;
        def.position = at + place;
        const BodyId id = w.create_body(def);
        w.create_shape(id, make_box(half.x, half.y));
        return id;
    };
    Machine m;
    m.frame = add(BodyType::static_body, {0, -1}, {12, 1});
    m.arm = add(BodyType::dynamic, {-8, 4}, {1, 0.2f});
    m.bob = add(BodyType::dynamic, {-7, 2}, {0.3f, 0.3f});
    m.slider = add(BodyType::dynamic, {-4, 4}, {0.5f, 0.5f});
    m.tip = add(BodyType::dynamic, {-3, 4}, {0.4f, 0.2f});
    m.cart = add(BodyType::dynamic, {0, 1}, {1, 0.2f});
    m.wheel = add(BodyType::dynamic, {0.5f, 0.4f}, {0.25f, 0.25f});
    w.create_shape(m.wheel, Circle{{0, 0}, 0.4f});
    m.drone = add(BodyType::dynamic, {3, 4}, {0.5f, 0.2f});
    m.left = add(BodyType::dynamic, {6, 3}, {0.4f, 0.4f});
    m.right = add(BodyType::dynamic, {8, 3}, {0.3f, 0.3f});

    const auto set = [&](JointType type, JointId id) { m.joints[static_cast<std::size_t>(type)] = id; };
    RevoluteJointDef hinge{.base = base_at_b(w, m.frame, m.arm)};
    hinge.base.frame_a.position.x -= 1;
    hinge.base.frame_b.position.x -= 1;
    hinge.spring = {.enable = true, .hertz = 2, .damping_ratio = 0.5f, .target = 0.1f};
    hinge.limit = {.enable = true, .lower = -0.2f, .upper = 0.5f};
    hinge.motor = {.enable = true, .speed = 1, .max_force = 5};
    hinge.friction = 1;
    set(JointType::revolute, w.create_joint(hinge));
    PrismaticJointDef rail{.base = base_at_b(w, m.frame, m.slider)};
    rail.base.frame_a.angle = 0.25f;
    rail.base.frame_b.angle = 0.25f;
    rail.spring = {.enable = true, .hertz = 1, .damping_ratio = 0.2f, .target = 0};
    rail.limit = {.enable = true, .lower = -0.25f, .upper = 0.5f};
    rail.motor = {.enable = true, .speed = -0.5f, .max_force = 3};
    rail.friction = 0.5f;
    set(JointType::prismatic, w.create_joint(rail));
    DistanceJointDef rope{.base = {.body_a = m.arm, .body_b = m.bob}, .length = 2};
    rope.base.frame_a.position = {1, 0};
    rope.spring = {.enable = true, .hertz = 3, .damping_ratio = 0.1f};
    rope.limit = {.enable = true, .lower = 0.5f, .upper = 2.1f};
    rope.motor = {.enable = true, .speed = 0.1f, .max_force = 1};
    set(JointType::distance, w.create_joint(rope));
    WeldJointDef glue{.base = base_at_b(w, m.slider, m.tip)};
    glue.angular_hertz = 5;
    glue.linear_hertz = 8;
    set(JointType::weld, w.create_joint(glue));
    WheelJointDef strut{.base = base_at_b(w, m.cart, m.wheel)};
    strut.base.frame_a.angle = 0.5f * pi;
    strut.limit = {.enable = true, .lower = -0.1f, .upper = 0.1f};
    strut.motor = {.enable = true, .speed = 3, .max_force = 2};
    strut.friction = 0.1f;
    set(JointType::wheel, w.create_joint(strut));
    MotorJointDef drive{.base = base_at_b(w, m.frame, m.drone)};
    drive.linear_hertz = 2;
    drive.angular_velocity = 0.5f;
    drive.max_force = 8;
    drive.max_torque = 1;
    set(JointType::motor, w.create_joint(drive));
    set(JointType::mouse, w.create_joint(MouseJointDef{.body = m.drone, .target = at + Vec2{3.4f, 4}, .max_force = 30}));
    w.set_target(m[JointType::mouse], at + Vec2{4, 5});
    PulleyJointDef pulley{.base = {.body_a = m.left, .body_b = m.right}};
    pulley.ground_a = at + Vec2{6, 6};
    pulley.ground_b = at + Vec2{8, 6};
    pulley.ratio = 1.5f;
    set(JointType::pulley, w.create_joint(pulley));
    set(JointType::gear, w.create_joint(GearJointDef{.joint1 = m[JointType::revolute], .joint2 = m[JointType::prismatic], .ratio = 0.5f}));
    AngleJointDef twist{.base = base_at_b(w, m.frame, m.bob)};
    twist.base.collide_connected = true;
    twist.spring = {.enable = true, .hertz = 1, .damping_ratio = 0.1f, .target = 0.2f};
    twist.limit = {.enable = true, .lower = -0.5f, .upper = 1};
    twist.motor = {.enable = true, .speed = 0.5f, .max_force = 0.5f};
    twist.friction = 0.01f;
    twist.ratchet = {.step = 0.05f};
    set(JointType::angle, w.create_joint(twist));
    return m;
}

}  // namespace islet::test
