// The defaults of structs of joints in C are those of C++.
//
// Made by bindings/c/generate.py; do not edit.
#include <gtest/gtest.h>
#include <islet/islet.h>

#include <islet/islet.hpp>

namespace {

void expect_same(const IsletBodyId& c, const islet::BodyId& cpp) {
    EXPECT_EQ(c.index1, cpp.index1);
    EXPECT_EQ(c.generation, cpp.generation);
}

void expect_same(const IsletVec2& c, const islet::Vec2& cpp) {
    EXPECT_EQ(c.x, cpp.x);
    EXPECT_EQ(c.y, cpp.y);
}

void expect_same(const IsletJointFrame& c, const islet::JointFrame& cpp) {
    expect_same(c.position, cpp.position);
    EXPECT_EQ(c.angle, cpp.angle);
}

void expect_same(const IsletJointBase& c, const islet::JointBase& cpp) {
    expect_same(c.body_a, cpp.body_a);
    expect_same(c.body_b, cpp.body_b);
    expect_same(c.frame_a, cpp.frame_a);
    expect_same(c.frame_b, cpp.frame_b);
    EXPECT_EQ(c.collide_connected, cpp.collide_connected);
    EXPECT_EQ(c.break_force, cpp.break_force);
    EXPECT_EQ(c.break_torque, cpp.break_torque);
    EXPECT_EQ(c.user_data, cpp.user_data);
}

void expect_same(const IsletJointSpring& c, const islet::JointSpring& cpp) {
    EXPECT_EQ(c.enable, cpp.enable);
    EXPECT_EQ(c.hertz, cpp.hertz);
    EXPECT_EQ(c.damping_ratio, cpp.damping_ratio);
    EXPECT_EQ(c.target, cpp.target);
}

void expect_same(const IsletJointLimit& c, const islet::JointLimit& cpp) {
    EXPECT_EQ(c.enable, cpp.enable);
    EXPECT_EQ(c.lower, cpp.lower);
    EXPECT_EQ(c.upper, cpp.upper);
}

void expect_same(const IsletJointMotor& c, const islet::JointMotor& cpp) {
    EXPECT_EQ(c.enable, cpp.enable);
    EXPECT_EQ(c.speed, cpp.speed);
    EXPECT_EQ(c.max_force, cpp.max_force);
}

void expect_same(const IsletJointId& c, const islet::JointId& cpp) {
    EXPECT_EQ(c.index1, cpp.index1);
    EXPECT_EQ(c.generation, cpp.generation);
}

void expect_same(const IsletJointRatchet& c, const islet::JointRatchet& cpp) {
    EXPECT_EQ(c.step, cpp.step);
    EXPECT_EQ(c.phase, cpp.phase);
}

extern "C" IsletJointSoftness default_joint_softness_of_c(void);
TEST(Defaults, OfJointSoftness) {
    const islet::JointSoftness cpp = {};
    for (const IsletJointSoftness& c : {islet_default_joint_softness(), default_joint_softness_of_c()}) {
        EXPECT_EQ(c.linear_hertz, cpp.linear_hertz);
        EXPECT_EQ(c.linear_damping_ratio, cpp.linear_damping_ratio);
        EXPECT_EQ(c.angular_hertz, cpp.angular_hertz);
        EXPECT_EQ(c.angular_damping_ratio, cpp.angular_damping_ratio);
    }
}

extern "C" IsletRevoluteJointDef default_revolute_joint_def_of_c(void);
TEST(Defaults, OfRevoluteJointDef) {
    const islet::RevoluteJointDef cpp = {};
    for (const IsletRevoluteJointDef& c : {islet_default_revolute_joint_def(), default_revolute_joint_def_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        expect_same(c.base, cpp.base);
        expect_same(c.spring, cpp.spring);
        expect_same(c.limit, cpp.limit);
        expect_same(c.motor, cpp.motor);
        EXPECT_EQ(c.friction, cpp.friction);
    }
}

extern "C" IsletPrismaticJointDef default_prismatic_joint_def_of_c(void);
TEST(Defaults, OfPrismaticJointDef) {
    const islet::PrismaticJointDef cpp = {};
    for (const IsletPrismaticJointDef& c : {islet_default_prismatic_joint_def(), default_prismatic_joint_def_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        expect_same(c.base, cpp.base);
        expect_same(c.spring, cpp.spring);
        expect_same(c.limit, cpp.limit);
        expect_same(c.motor, cpp.motor);
        EXPECT_EQ(c.friction, cpp.friction);
    }
}

extern "C" IsletDistanceJointDef default_distance_joint_def_of_c(void);
TEST(Defaults, OfDistanceJointDef) {
    const islet::DistanceJointDef cpp = {};
    for (const IsletDistanceJointDef& c : {islet_default_distance_joint_def(), default_distance_joint_def_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        expect_same(c.base, cpp.base);
        EXPECT_EQ(c.length, cpp.length);
        expect_same(c.spring, cpp.spring);
        expect_same(c.limit, cpp.limit);
        expect_same(c.motor, cpp.motor);
    }
}

extern "C" IsletWeldJointDef default_weld_joint_def_of_c(void);
TEST(Defaults, OfWeldJointDef) {
    const islet::WeldJointDef cpp = {};
    for (const IsletWeldJointDef& c : {islet_default_weld_joint_def(), default_weld_joint_def_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        expect_same(c.base, cpp.base);
        EXPECT_EQ(c.linear_hertz, cpp.linear_hertz);
        EXPECT_EQ(c.linear_damping_ratio, cpp.linear_damping_ratio);
        EXPECT_EQ(c.angular_hertz, cpp.angular_hertz);
        EXPECT_EQ(c.angular_damping_ratio, cpp.angular_damping_ratio);
    }
}

extern "C" IsletWheelJointDef default_wheel_joint_def_of_c(void);
TEST(Defaults, OfWheelJointDef) {
    const islet::WheelJointDef cpp = {};
    for (const IsletWheelJointDef& c : {islet_default_wheel_joint_def(), default_wheel_joint_def_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        expect_same(c.base, cpp.base);
        expect_same(c.spring, cpp.spring);
        expect_same(c.limit, cpp.limit);
        expect_same(c.motor, cpp.motor);
        EXPECT_EQ(c.friction, cpp.friction);
    }
}

extern "C" IsletMotorJointDef default_motor_joint_def_of_c(void);
TEST(Defaults, OfMotorJointDef) {
    const islet::MotorJointDef cpp = {};
    for (const IsletMotorJointDef& c : {islet_default_motor_joint_def(), default_motor_joint_def_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        expect_same(c.base, cpp.base);
        expect_same(c.linear_velocity, cpp.linear_velocity);
        EXPECT_EQ(c.angular_velocity, cpp.angular_velocity);
        EXPECT_EQ(c.max_force, cpp.max_force);
        EXPECT_EQ(c.max_torque, cpp.max_torque);
        EXPECT_EQ(c.linear_hertz, cpp.linear_hertz);
        EXPECT_EQ(c.linear_damping_ratio, cpp.linear_damping_ratio);
        EXPECT_EQ(c.angular_hertz, cpp.angular_hertz);
        EXPECT_EQ(c.angular_damping_ratio, cpp.angular_damping_ratio);
    }
}

extern "C" IsletMouseJointDef default_mouse_joint_def_of_c(void);
TEST(Defaults, OfMouseJointDef) {
    const islet::MouseJointDef cpp = {};
    for (const IsletMouseJointDef& c : {islet_default_mouse_joint_def(), default_mouse_joint_def_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        expect_same(c.body, cpp.body);
        expect_same(c.target, cpp.target);
        EXPECT_EQ(c.hertz, cpp.hertz);
        EXPECT_EQ(c.damping_ratio, cpp.damping_ratio);
        EXPECT_EQ(c.max_force, cpp.max_force);
        EXPECT_EQ(c.user_data, cpp.user_data);
    }
}

extern "C" IsletPulleyJointDef default_pulley_joint_def_of_c(void);
TEST(Defaults, OfPulleyJointDef) {
    const islet::PulleyJointDef cpp = {};
    for (const IsletPulleyJointDef& c : {islet_default_pulley_joint_def(), default_pulley_joint_def_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        expect_same(c.base, cpp.base);
        expect_same(c.ground_a, cpp.ground_a);
        expect_same(c.ground_b, cpp.ground_b);
        EXPECT_EQ(c.ratio, cpp.ratio);
    }
}

extern "C" IsletGearJointDef default_gear_joint_def_of_c(void);
TEST(Defaults, OfGearJointDef) {
    const islet::GearJointDef cpp = {};
    for (const IsletGearJointDef& c : {islet_default_gear_joint_def(), default_gear_joint_def_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        expect_same(c.joint1, cpp.joint1);
        expect_same(c.joint2, cpp.joint2);
        EXPECT_EQ(c.ratio, cpp.ratio);
        EXPECT_EQ(c.break_torque, cpp.break_torque);
        EXPECT_EQ(c.user_data, cpp.user_data);
    }
}

extern "C" IsletAngleJointDef default_angle_joint_def_of_c(void);
TEST(Defaults, OfAngleJointDef) {
    const islet::AngleJointDef cpp = {};
    for (const IsletAngleJointDef& c : {islet_default_angle_joint_def(), default_angle_joint_def_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        expect_same(c.base, cpp.base);
        expect_same(c.spring, cpp.spring);
        expect_same(c.limit, cpp.limit);
        expect_same(c.motor, cpp.motor);
        EXPECT_EQ(c.friction, cpp.friction);
        expect_same(c.ratchet, cpp.ratchet);
    }
}

}  // namespace
