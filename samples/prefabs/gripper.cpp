#include "gripper.hpp"

namespace islet::samples {
namespace {

constexpr float finger_speed = 0.5f;      // m/s, until they meet something
constexpr float finger_half = 0.06f;      // m, half their width
constexpr float palm_half_height = 0.1f;  // m
constexpr float lift_start = 0.5f;        // m, from the rail down to the palm

void add_part(Assembler& into, BodyType type, Vec2 place, const Polygon& shape, const ShapeDef& material) {
    BodyDef def;
    def.type = type;
    def.position = place;
    def.enable_sleep = type == BodyType::static_body;  // what moves waits for commands
    into.body(def);
    into.shape(shape, material);
}

PrismaticJointDef slider(Vec2 on_a, Vec2 on_b, float angle, float lower, float upper, const JointMotor& motor) {
    PrismaticJointDef def;
    def.base.frame_a = {on_a, angle};
    def.base.frame_b = {on_b, angle};
    def.limit = {.enable = true, .lower = lower, .upper = upper};
    def.motor = motor;
    return def;
}

/// How far a finger's middle is from the palm's axis when it is open.
float open_offset(const GripperDef& def) { return 0.5f * def.opening + finger_half; }

}  // namespace

void assemble(const GripperDef& def, Assembler& into) {
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
    const Polygon box = make_rounded_box(finger_half - 0.02f, finger - 0.02f, 0.02f);
    add_part(into, BodyType::static_body, def.rail, make_box(half_rail, 0.05f), gantry);
    add_part(into, BodyType::dynamic, def.rail, make_box(0.25f, 0.15f), gantry);
    add_part(into, BodyType::dynamic, palm, make_box(palm_half, palm_half_height), hand);
    add_part(into, BodyType::dynamic, palm - Vec2{side, palm_half_height + finger}, box, pad);
    add_part(into, BodyType::dynamic, palm - Vec2{-side, palm_half_height + finger}, box, pad);

    const std::array<JointMotor, 4> still = gripper_motors(def, {});
    const Vec2 root = {0, finger}, hinge = {side, -palm_half_height};
    into.joint(0, 1, slider({}, {}, 0, -half_rail, half_rail, still[0]));
    into.joint(1, 2, slider({0, -lift_start}, {}, 0.5f * pi, -def.reach, 0, still[1]));
    into.joint(2, 3, slider({-hinge.x, hinge.y}, root, 0, 0, side - finger_half, still[2]));
    // The right finger closes to the left: both frames of its slider are turned by half a turn.
    into.joint(2, 4, slider(hinge, root, pi, 0, side - finger_half, still[3]));
    // A rack and pinion between the fingers: they close by the same way, so that the palm stays over what they hold.
    GearJointDef pinion;
    pinion.ratio = -1;
    into.joint(2, 3, pinion);
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

}  // namespace islet::samples
