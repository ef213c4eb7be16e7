// A car seen from the side: a body on two sprung wheels, each with a motor.
//
//   BodyId parts[3];
//   JointId struts[2];
//   Spawned car = spawn(world, CarDef{.position = {0, 0}}, parts, struts);
//   drive(world, car, 8);   // at 8 m/s to the right, until told otherwise; 0 brakes
//   coast(world, car);      // lets the wheels turn freely
#pragma once

#include "prefab.hpp"

namespace islet::samples {

/// The order of a car's bodies, and of its joints from the rear wheel's on.
enum class CarPart : std::size_t { body, rear_wheel, front_wheel };

struct CarDef {
    Vec2 position = {};         ///< m, of the ground midway between its wheels
    float wheel_radius = 0.4f;  ///< m
    float wheel_base = 2.2f;    ///< m, from axle to axle
    float density = 60;         ///< kg/m^2, of the body; the wheels are half as dense. The car weighs about 145 kg.
    float friction = 1.2f;      ///< of the tyres
    float hertz = 2.5f;         ///< Hz, of the springs
    float damping_ratio = 0.7f;
    float torque = 300;    ///< N m, the most that each wheel's motor gives
    float travel = 0.25f;  ///< m, of the springs, up and down
    int group = 0;         ///< > 0: cars of the same group do not collide with each other
};

void assemble(const CarDef& def, Assembler& into);
/// What a motor is set to for the car to go at `speed`, m/s to the right.
JointMotor wheel_motor(const CarDef& def, float speed);
/// Turns both wheels so that the car goes at `speed`; the wheels' radius and torque are those it was made with.
void drive(World& world, const Spawned& car, float speed);
void coast(World& world, const Spawned& car);

}  // namespace islet::samples
