#include "ragdoll.hpp"

namespace islet::samples {
namespace {

/// A part when the person stands upright: heights and radii as shares of the person's height, the mass as a share of the person's, angles in degrees.
struct Part {
    BodyPart parent;
    float mass;
    float bottom, top, radius;  // the ends of its capsule's axis
    float pivot;                // the joint's height; of the pelvis there is none
    float lower, upper;         // counter-clockwise from upright
    float torque;               // share of the joint torque
    bool has_foot = false;
};

constexpr Part thigh = {BodyPart::pelvis, 0.100f, 0.285f, 0.530f, 0.042f, 0.530f, -20, 120, 1};
constexpr Part left_shank = {BodyPart::left_thigh, 0.061f, 0.060f, 0.285f, 0.030f, 0.285f, -135, 0, 0.5f, true};
constexpr Part right_shank = {BodyPart::right_thigh, 0.061f, 0.060f, 0.285f, 0.030f, 0.285f, -135, 0, 0.5f, true};
constexpr Part upper_arm = {BodyPart::torso, 0.028f, 0.630f, 0.805f, 0.025f, 0.805f, -60, 180, 0.3f};
constexpr Part left_forearm = {BodyPart::left_upper_arm, 0.022f, 0.397f, 0.630f, 0.020f, 0.630f, 0, 150, 0.1f};
constexpr Part right_forearm = {BodyPart::right_upper_arm, 0.022f, 0.397f, 0.630f, 0.020f, 0.630f, 0, 150, 0.1f};
constexpr Part parts[body_part_count] = {
    {BodyPart::pelvis, 0.142f, 0.550f, 0.590f, 0.055f, 0, 0, 0, 0},
    {BodyPart::pelvis, 0.355f, 0.650f, 0.780f, 0.055f, 0.610f, -80, 25, 1},
    {BodyPart::torso, 0.081f, 0.885f, 0.955f, 0.045f, 0.840f, -45, 45, 0.3f},
    thigh,
    left_shank,
    thigh,
    right_shank,
    upper_arm,
    left_forearm,
    upper_arm,
    right_forearm,
};

// The foot lies along the ground, from the heel behind the ankle to the toes.
constexpr float foot_heel = -0.03f, foot_toes = 0.082f, foot_radius = 0.02f;

constexpr float radians(float degrees) { return degrees * pi / 180; }

float capsule_area(const Capsule& c) { return 2 * c.radius * length(c.point2 - c.point1) + pi * c.radius * c.radius; }

/// A body's origin is at the middle of its capsule.
float middle_of(const Part& part) { return 0.5f * (part.bottom + part.top); }

BodyId create_part(World& world, const Part& part, const RagdollDef& def) {
    const float h = def.height, half = 0.5f * (part.top - part.bottom) * h;
    const BodyId body = world.create_body({.type = BodyType::dynamic, .position = def.position + Vec2{0, middle_of(part) * h}});
    if (!body) return body;  // the error stays the one that says why
    const Capsule bone = {.point1 = {0, -half}, .point2 = {0, half}, .radius = part.radius * h};
    const float sole = (foot_radius - middle_of(part)) * h;
    const Capsule foot = {.point1 = {foot_heel * h, sole}, .point2 = {foot_toes * h, sole}, .radius = foot_radius * h};
    const float area = capsule_area(bone) + (part.has_foot ? capsule_area(foot) : 0);
    const ShapeDef skin = {.friction = def.friction, .density = part.mass * def.mass / area, .filter = def.filter};
    const ShapeId shape = world.create_shape(body, bone, skin);
    const bool is_whole = shape && (!part.has_foot || world.create_shape(body, foot, skin));
    if (!is_whole) world.destroy_body(body);
    return is_whole ? body : BodyId{};
}

JointId create_hinge(World& world, const Part& part, BodyId parent, BodyId body, const RagdollDef& def) {
    const float h = def.height;
    return world.create_joint(
        RevoluteJointDef{.base = {.body_a = parent,
                                  .body_b = body,
                                  .frame_a = {{0, (part.pivot - middle_of(parts[static_cast<std::size_t>(part.parent)])) * h}},
                                  .frame_b = {{0, (part.pivot - middle_of(part)) * h}}},
                         .spring = {.enable = def.hertz > 0, .hertz = def.hertz, .damping_ratio = def.damping_ratio},
                         .limit = {.enable = true, .lower = radians(part.lower), .upper = radians(part.upper)},
                         .motor = {.enable = true, .speed = 0, .max_force = part.torque * def.joint_torque * def.mass}});
}

}  // namespace

Ragdoll create_ragdoll(World& world, const RagdollDef& def) {
    Ragdoll made;
    for (std::size_t i = 0; i < body_part_count; ++i) {
        made.bodies[i] = create_part(world, parts[i], def);
        bool is_whole = static_cast<bool>(made.bodies[i]);
        if (is_whole && i > 0) {
            made.joints[i - 1] = create_hinge(world, parts[i], made[parts[i].parent], made.bodies[i], def);
            is_whole = static_cast<bool>(made.joints[i - 1]);
        }
        if (is_whole) continue;
        destroy(world, made);
        return {};
    }
    return made;
}

void destroy(World& world, const Ragdoll& ragdoll) {
    for (const BodyId body : ragdoll.bodies)
        if (world.is_valid(body)) world.destroy_body(body);
}

}  // namespace islet::samples
