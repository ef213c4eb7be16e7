#include "car.hpp"

namespace islet::samples {
namespace {

constexpr std::size_t rear = 0, front = 1;  // joints

Polygon hull_of(std::initializer_list<Vec2> points, float rounding) {
    return make_polygon(compute_hull({points.begin(), points.size()}), rounding);
}

/// The radius of a wheel, from its shape.
float radius_of(const World& world, BodyId wheel) {
    ShapeId shape;
    world.shapes(wheel, {&shape, 1});
    const Circle* tyre = world.circle(shape);
    return tyre != nullptr ? tyre->radius : 1;
}

}  // namespace

Prefab make_car(const CarDef& def) {
    const float half_base = 0.5f * def.wheel_base, axle = def.wheel_radius, unit = def.wheel_base / 2.2f;
    const Vec2 middle = def.position + Vec2{0, axle + 0.35f * unit};

    ShapeDef steel;
    steel.density = def.density;
    steel.friction = 0.4f;
    steel.filter.group = -def.group;
    BodyDef body;
    body.type = BodyType::dynamic;
    body.position = middle;
    const auto at = [unit](float x, float y) { return Vec2{unit * x, unit * y}; };
    // The lower half weighs; the cabin hardly does, so that the car does not tip.
    const Polygon hull = hull_of({at(-1.6f, -0.2f), at(1.6f, -0.2f), at(1.7f, 0.1f), at(1.2f, 0.25f), at(-1.6f, 0.25f)}, 0.05f * unit);
    const Polygon cabin = hull_of({at(-1.3f, 0.25f), at(0.9f, 0.25f), at(0.3f, 0.7f), at(-0.9f, 0.7f)}, 0.05f * unit);
    ShapeDef light = steel;
    light.density = 0.1f * def.density;
    Prefab car;
    car.bodies.push_back({body, {{hull, steel}, {cabin, light}}});

    ShapeDef rubber = steel;
    rubber.density = 0.5f * def.density;
    rubber.friction = def.friction;
    WheelJointDef strut;
    strut.spring = {.enable = true, .hertz = def.hertz, .damping_ratio = def.damping_ratio};
    strut.limit = {.enable = true, .lower = -def.travel, .upper = def.travel};
    strut.motor = {.enable = false, .speed = 0, .max_force = def.torque};
    for (const float side : {-1.0f, 1.0f}) {
        BodyDef wheel;
        wheel.type = BodyType::dynamic;
        wheel.position = def.position + Vec2{side * half_base, axle};
        car.bodies.push_back({wheel, {{Circle{{}, def.wheel_radius}, rubber}}});
        // The strut's axis points up: the spring rests where the wheel was made.
        strut.base.frame_a = {wheel.position - middle, 0.5f * pi};
        car.joints.push_back({0, car.bodies.size() - 1, strut});
    }
    return car;
}

JointMotor wheel_motor(const CarDef& def, float speed) {
    return {.enable = true, .speed = -speed / def.wheel_radius, .max_force = def.torque};
}

void drive(World& world, const Spawned& car, float speed) {
    for (const std::size_t joint : {rear, front}) {
        JointMotor motor = world.motor(car.joints[joint]);
        motor.enable = true;
        motor.speed = -speed / radius_of(world, car.bodies[1 + joint]);
        world.set_motor(car.joints[joint], motor);
    }
}

void drive(Engine& engine, const Placed& car, const CarDef& def, float speed) {
    for (const std::size_t joint : {rear, front}) engine.set_motor(car.first_joint + joint, wheel_motor(def, speed));
}

void coast(World& world, const Spawned& car) {
    for (const std::size_t joint : {rear, front}) {
        JointMotor motor = world.motor(car.joints[joint]);
        motor.enable = false;
        world.set_motor(car.joints[joint], motor);
    }
}

}  // namespace islet::samples
