// What the columns of actions and observations mean.
#include "../exact.hpp"

#include "../fleet/fleet_columns.hpp"

#include "../calls/checks.hpp"
#include "../constraint/joint_kinds.hpp"
#include "../graph/contacts.hpp"

namespace islet {

using namespace detail;

namespace {

bool drives_joint(DriveKind kind) { return kind >= DriveKind::joint_torque; }

Error check_ids(bool of_joint, BodyId body, JointId joint) { return (of_joint ? joint.index1 : body.index1) != 0 ? Error::none : Error::null_id; }

void drive_body(World& world, const Drive& drive, float value) {
    if (!world.is_valid(drive.body)) return;
    if (drive.kind == DriveKind::force_x) world.apply_force_to_center(drive.body, {value, 0});
    if (drive.kind == DriveKind::force_y) world.apply_force_to_center(drive.body, {0, value});
    if (drive.kind == DriveKind::torque) world.apply_torque(drive.body, value);
}

void drive_motor(World& world, const Drive& drive, float value) {
    JointMotor motor = world.motor(drive.joint);
    float& driven = drive.kind == DriveKind::motor_speed ? motor.speed : motor.max_force;
    const float wanted = drive.kind == DriveKind::motor_speed ? value : abs(value);
    if (driven == wanted) return;  // and nothing wakes
    driven = wanted;
    world.set_motor(drive.joint, motor);
}

void drive_target(World& world, const Drive& drive, float value) {
    Vec2 target = world.target(drive.joint);
    (drive.kind == DriveKind::target_x ? target.x : target.y) = value;
    world.set_target(drive.joint, target);
}

void drive_joint(World& world, const Drive& drive, float value) {
    if (!world.is_valid(drive.joint)) return;
    const std::uint32_t type = joint_bit(world.joint_type(drive.joint));
    const bool is_mouse = type == joint_bit(JointType::mouse);
    switch (drive.kind) {
        case DriveKind::joint_torque:
            if (is_mouse) return;
            world.apply_torque(world.body_a(drive.joint), -value);
            return world.apply_torque(world.body_b(drive.joint), value);
        case DriveKind::motor_speed:
        case DriveKind::motor_force: return (type & with_coordinate) != 0 ? drive_motor(world, drive, value) : void();
        default: return is_mouse ? drive_target(world, drive, value) : void();
    }
}

bool touches(const Core& core, BodyId id) {
    bool found = false;
    for_each_contact(core, id.index1 - 1, [&](std::uint32_t contact, std::uint32_t) { found |= is_told(core.manifolds[contact]); });
    return found;
}

/// The ray's body, and how far it has come.
struct Ray {
    const World* world;
    BodyId body;
    float fraction;
};

float meet(const QueryHit& hit, void* context) {
    Ray& ray = *static_cast<Ray*>(context);
    if (ray.world->body(hit.shape) == ray.body) return -1;  // on past the body that carries it
    ray.fraction = hit.fraction;
    return 0;
}

float cast(const World& world, const Sense& sense) {
    const Transform pose = world.transform(sense.body);
    Ray ray = {&world, sense.body, 1};
    world.cast_ray_each(transform_point(pose, sense.origin), rotate(pose.q, sense.translation), sense.filter, meet, &ray);
    return ray.fraction;
}

float* write(float* row, Vec2 value) {
    row[0] = value.x;
    row[1] = value.y;
    return row + 2;
}

float* sense_body(const World& world, const Sense& sense, float* row) {
    const Transform pose = world.transform(sense.body);
    switch (sense.kind) {
        case SenseKind::position: return write(row, pose.p);
        case SenseKind::rotation: return write(row, {pose.q.c, pose.q.s});
        case SenseKind::velocity: return write(row, world.linear_velocity(sense.body));
        case SenseKind::angular_velocity: *row = world.angular_velocity(sense.body); break;
        case SenseKind::touching: *row = touches(Core::of(world), sense.body) ? 1.0f : 0.0f; break;
        default: *row = cast(world, sense); break;
    }
    return row + 1;
}

bool is_there(const World& world, const Sense& sense) {
    if (sense.kind != SenseKind::joint) return world.is_valid(sense.body);
    return world.is_valid(sense.joint) && (joint_bit(world.joint_type(sense.joint)) & with_coordinate) != 0;
}

}  // namespace

namespace detail {

std::uint32_t columns_of(SenseKind kind) {
    if (kind > SenseKind::ray) return 0;
    return kind == SenseKind::position || kind == SenseKind::rotation || kind == SenseKind::velocity || kind == SenseKind::joint ? 2 : 1;
}

Error check_drive(const Drive& drive) {
    if (drive.kind > DriveKind::target_y) return Error::out_of_range;
    return is_finite(drive.scale) ? check_ids(drives_joint(drive.kind), drive.body, drive.joint) : Error::not_finite;
}

Error check_sense(const Sense& sense) {
    if (columns_of(sense.kind) == 0) return Error::out_of_range;
    if (!is_finite(sense.origin) || !is_finite(sense.translation)) return Error::not_finite;
    return check_ids(sense.kind == SenseKind::joint, sense.body, sense.joint);
}

void act(World& world, span<const Drive> drives, const float* actions) {
    for (const Drive& drive : drives) {
        const float value = drive.scale * *actions++;
        drives_joint(drive.kind) ? drive_joint(world, drive, value) : drive_body(world, drive, value);
    }
}

void observe(const World& world, span<const Sense> senses, float* row) {
    for (const Sense& sense : senses) {
        if (is_there(world, sense)) {
            const bool of_joint = sense.kind == SenseKind::joint;
            row = of_joint ? write(row, {world.joint_position(sense.joint), world.joint_speed(sense.joint)}) : sense_body(world, sense, row);
            continue;
        }
        for (std::uint32_t i = columns_of(sense.kind); i > 0; --i) *row++ = 0;
    }
}

}  // namespace detail

std::uint32_t columns(span<const Sense> senses) {
    std::uint32_t n = 0;
    for (const Sense& sense : senses) n += columns_of(sense.kind);
    return n;
}

}  // namespace islet
