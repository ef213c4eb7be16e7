#include "gripper.hpp"

namespace islet::samples {
namespace {

constexpr float finger_speed = 0.5f;      // m/s, until they meet something
constexpr float finger_half = 0.06f;      // m, half their width
constexpr float palm_half_height = 0.1f;  // m
constexpr float lift_start = 0.5f;        // m, from the rail down to the palm

SceneBody moving_part(Vec2 place, std::vector<SceneShape> shapes) {
    SceneBody body;
    body.def.type = BodyType::dynamic;
    body.def.position = place;
    body.def.enable_sleep = false;  // it waits for commands
    body.shapes = std::move(shapes);
    return body;
}

PrismaticJointDef slider(Vec2 on_a, Vec2 on_b, float angle, float lower, float upper) {
    PrismaticJointDef def;
    def.base.frame_a = {on_a, angle};
    def.base.frame_b = {on_b, angle};
    def.limit = {.enable = true, .lower = lower, .upper = upper};
    return def;
}

/// How far a finger's middle is from the palm's axis when it is open.
float open_offset(const GripperDef& def) { return 0.5f * def.opening + finger_half; }

}  // namespace

Prefab make_gripper(const GripperDef& def) {
    ShapeDef steel;
    steel.density = 40;
    // Parts of the gantry touch nothing; the palm and the fingers do, but not each other.
    ShapeDef gantry = steel;
    gantry.filter.mask = 0;
    ShapeDef hand = steel;
    hand.filter.group = -1000;
    ShapeDef pad = hand;
    pad.friction = def.friction;

    const float half_rail = 0.5f * def.rail_length, finger = 0.5f * def.finger_length, side = open_offset(def);
    const float palm_half = side + finger_half;
    const Vec2 palm = def.rail - Vec2{0, lift_start};
    SceneBody rail;
    rail.def.position = def.rail;
    rail.shapes = {{make_box(half_rail, 0.05f), gantry}};

    Prefab gripper;
    gripper.bodies = {
        rail,
        moving_part(def.rail, {{make_box(0.25f, 0.15f), gantry}}),
        moving_part(palm, {{make_box(palm_half, palm_half_height), hand}}),
        moving_part(palm - Vec2{side, palm_half_height + finger}, {{make_rounded_box(finger_half - 0.02f, finger - 0.02f, 0.02f), pad}}),
        moving_part(palm - Vec2{-side, palm_half_height + finger}, {{make_rounded_box(finger_half - 0.02f, finger - 0.02f, 0.02f), pad}}),
    };
    const Vec2 root = {0, finger}, hinge = {side, -palm_half_height};
    // The right finger closes to the left: both frames of its slider are turned by half a turn.
    gripper.joints = {
        {0, 1, slider({}, {}, 0, -half_rail, half_rail)},
        {1, 2, slider({0, -lift_start}, {}, 0.5f * pi, -def.reach, 0)},
        {2, 3, slider({-hinge.x, hinge.y}, root, 0, 0, side - finger_half)},
        {2, 4, slider(hinge, root, pi, 0, side - finger_half)},
    };
    // A rack and pinion between the fingers: they close by the same way, so that the palm stays over what they hold.
    GearJointDef pinion;
    pinion.ratio = -1;
    gripper.joints.push_back({2, 3, pinion});
    const std::array<JointMotor, 4> still = gripper_motors(def, {});
    for (std::size_t i = 0; i < still.size(); ++i) std::get<PrismaticJointDef>(gripper.joints[i].def).motor = still[i];
    return gripper;
}

std::array<JointMotor, 4> gripper_motors(const GripperDef& def, const GripperCommand& command) {
    const JointMotor finger = {.enable = true, .speed = command.close ? finger_speed : -finger_speed, .max_force = def.grip};
    return {{
        {.enable = true, .speed = command.travel, .max_force = def.drive_force},
        {.enable = true, .speed = command.lift, .max_force = def.drive_force},
        finger,
        finger,
    }};
}

void command(World& world, const Spawned& gripper, const GripperDef& def, const GripperCommand& command) {
    const std::array<JointMotor, 4> motors = gripper_motors(def, command);
    for (std::size_t i = 0; i < motors.size(); ++i) world.set_motor(gripper.joints[i], motors[i]);
}

void command(Engine& engine, const Placed& gripper, const GripperDef& def, const GripperCommand& command) {
    const std::array<JointMotor, 4> motors = gripper_motors(def, command);
    for (std::size_t i = 0; i < motors.size(); ++i) engine.set_motor(gripper.first_joint + i, motors[i]);
}

}  // namespace islet::samples
