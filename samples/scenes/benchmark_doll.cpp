#include "benchmark_doll.hpp"

namespace islet::samples {
namespace {

/// A bone when the ragdoll stands upright at the origin: lengths in metres, angles as shares of pi.
struct BonePlan {
    Bone parent;
    float height;               // of its middle
    float bottom, top, radius;  // its capsule, from the middle
    float pivot;                // height of the hinge that hangs it on its parent
    float lower, upper;         // limits of the hinge
    float friction;             // share of the ragdoll's friction torque
    float bend = 0;             // where the hinge's angle counts from
    float damping = 0;          // 1/s
    bool foot = false;
};

/// By Bone; an arm or a leg is the same on both sides.
constexpr BonePlan hip = {Bone::hip, 0.95f, -0.02f, 0.02f, 0.095f, 0, 0, 0, 0};
constexpr BonePlan torso = {Bone::hip, 1.2f, -0.135f, 0.135f, 0.09f, 1.0f, -0.25f, 0, 0.5f};
constexpr BonePlan head = {Bone::torso, 1.475f, -0.038f, 0.039f, 0.075f, 1.4f, -0.3f, 0.1f, 0.25f, 0, 0.1f};
constexpr BonePlan upper_leg = {Bone::hip, 0.775f, -0.125f, 0.125f, 0.06f, 0.9f, -0.05f, 0.4f, 1};
constexpr BonePlan left_shin = {Bone::upper_left_leg, 0.475f, -0.155f, 0.125f, 0.045f, 0.625f, -0.5f, -0.02f, 0.5f, 0, 0, true};
constexpr BonePlan right_shin = {Bone::upper_right_leg, 0.475f, -0.155f, 0.125f, 0.045f, 0.625f, -0.5f, -0.02f, 0.5f, 0, 0, true};
constexpr BonePlan upper_arm = {Bone::torso, 1.225f, -0.125f, 0.125f, 0.035f, 1.35f, -0.1f, 0.8f, 0.5f};
constexpr BonePlan left_forearm = {Bone::upper_left_arm, 0.975f, -0.125f, 0.125f, 0.03f, 1.1f, -0.2f, 0.3f, 0.1f, 0.25f, 0.1f};
constexpr BonePlan right_forearm = {Bone::upper_right_arm, 0.975f, -0.125f, 0.125f, 0.03f, 1.1f, -0.2f, 0.3f, 0.1f, 0.25f, 0.1f};
constexpr BonePlan bones[bone_count] = {hip,        torso,     head,         upper_leg, left_shin,    upper_leg,
                                        right_shin, upper_arm, left_forearm, upper_arm, right_forearm};

Polygon make_foot(float scale) {
    const Vec2 corners[] = {{-0.03f, -0.185f}, {0.11f, -0.185f}, {0.11f, -0.16f}, {-0.03f, -0.14f}};
    Vec2 points[4];
    for (std::size_t i = 0; i < 4; ++i) points[i] = scale * corners[i];
    return make_polygon(compute_hull(points), 0.015f * scale);
}

SceneBody make_bone(const BonePlan& plan, const BenchmarkDollDef& def) {
    const float s = def.scale;
    SceneBody body;
    body.def.type = BodyType::dynamic;
    body.def.position = def.position + Vec2{0, plan.height * s};
    body.def.linear_damping = plan.damping;
    body.def.sleep_threshold = 0.1f;

    ShapeDef skin;
    skin.friction = 0.2f;
    skin.filter = {.category = 2, .mask = 1 | 2, .group = -def.group};
    body.shapes.push_back({Capsule{{0, plan.bottom * s}, {0, plan.top * s}, plan.radius * s}, skin});
    if (plan.foot) {
        ShapeDef sole = skin;
        sole.friction = 0.05f;
        sole.filter.mask = 1;
        body.shapes.push_back({make_foot(s), sole});
    }
    return body;
}

RevoluteJointDef make_hinge(const BonePlan& plan, const BenchmarkDollDef& def) {
    const float s = def.scale, parent_height = bones[static_cast<std::size_t>(plan.parent)].height;
    RevoluteJointDef hinge;
    hinge.base.frame_a = {{0, (plan.pivot - parent_height) * s}, plan.bend * pi};
    hinge.base.frame_b = {{0, (plan.pivot - plan.height) * s}, 0};
    hinge.limit = {.enable = true, .lower = plan.lower * pi, .upper = plan.upper * pi};
    hinge.motor = {.enable = true, .speed = 0, .max_force = plan.friction * def.friction_torque * s};
    hinge.spring = {.enable = def.hertz > 0, .hertz = def.hertz, .damping_ratio = def.damping_ratio};
    return hinge;
}

}  // namespace

Prefab make_benchmark_doll(const BenchmarkDollDef& def) {
    Prefab ragdoll;
    for (std::size_t i = 0; i < bone_count; ++i) {
        const BonePlan& plan = bones[i];
        ragdoll.bodies.push_back(make_bone(plan, def));
        if (i > 0) ragdoll.joints.push_back({static_cast<std::size_t>(plan.parent), i, make_hinge(plan, def)});
    }
    return ragdoll;
}

}  // namespace islet::samples
