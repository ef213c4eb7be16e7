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

void assemble(const CarDef& def, Assembler& into) {
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
    into.body(body);
    into.shape(hull, steel);
    into.shape(cabin, light);

    ShapeDef rubber = steel;
    rubber.density = 0.5f * def.density;
    rubber.friction = def.friction;
    BodyDef wheel;
    wheel.type = BodyType::dynamic;
    const Vec2 axles[] = {def.position + Vec2{-half_base, axle}, def.position + Vec2{half_base, axle}};
    for (const Vec2 place : axles) {
        wheel.position = place;
        into.body(wheel);
        into.shape(Circle{{}, def.wheel_radius}, rubber);
    }
    WheelJointDef strut;
    strut.spring = {.enable = true, .hertz = def.hertz, .damping_ratio = def.damping_ratio};
    strut.limit = {.enable = true, .lower = -def.travel, .upper = def.travel};
    strut.motor = {.enable = false, .speed = 0, .max_force = def.torque};
    for (std::size_t i = 0; i < 2; ++i) {
        // The strut's axis points up: the spring rests where the wheel was made.
        strut.base.frame_a = {axles[i] - middle, 0.5f * pi};
        into.joint(0, 1 + i, strut);
    }
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

void coast(World& world, const Spawned& car) {
    for (const std::size_t joint : {rear, front}) {
        JointMotor motor = world.motor(car.joints[joint]);
        motor.enable = false;
        world.set_motor(car.joints[joint], motor);
    }
}

}  // namespace islet::samples
