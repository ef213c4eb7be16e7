// A scene with all shapes, joints and settings, by the C interface. machines_test.cpp makes the same scene by that of C++.
#include "machines.h"

#include <islet/islet.h>
#include <stddef.h>

static _Alignas(ISLET_WORLD_ALIGNMENT) char block[1 << 20];

static float mix(float a, uint32_t material_a, float b, uint32_t material_b, void* context) {
    (void)context;
    return material_a == 3 || material_b == 3 ? 0.05f : a < b ? a : b;
}
static bool odd_ones_pass(IsletShapeId a, IsletShapeId b, void* context) {
    (void)context;
    return !(a.index1 % 2 == 1 && b.index1 % 2 == 1 && a.index1 > 10 && b.index1 > 10);
}
static void halve_friction(IsletPreSolve* contact, void* context) {
    (void)context;
    contact->friction *= 0.5f;
}

static IsletBodyId body_at(IsletWorld* world, IsletBodyType type, float x, float y) {
    IsletBodyDef def = islet_default_body_def();
    def.type = type;
    def.position.x = x;
    def.position.y = y;
    def.angle = 0.125f;
    return islet_create_body(world, &def);
}

unsigned machines(uint64_t* hashes, unsigned count) {
    IsletCapacity capacity = islet_default_capacity();
    capacity.bodies = capacity.shapes = 100;
    capacity.contacts = 500;
    capacity.joints = 20;
    IsletSolverDef solver = islet_default_solver_def();
    solver.substeps = 3;
    solver.contact_hertz = 25;
    IsletHooks hooks = islet_default_hooks();
    hooks.filter = odd_ones_pass;
    hooks.pre_solve = halve_friction;
    hooks.mix_friction = mix;
    IsletWorldDef def = islet_default_world_def();
    def.gravity.x = 0.5f;
    def.solver = &solver;
    def.hooks = &hooks;
    def.restitution_threshold = 0.5f;
    IsletWorld* world = islet_create_world(block, sizeof block, &capacity, &def, NULL);

    const IsletBodyId ground = body_at(world, ISLET_BODY_TYPE_STATIC_BODY, 0, 0);
    const IsletVec2 points[] = {{40, 3}, {20, 0}, {-20, 0}, {-40, 3}};
    const IsletHalfSpace bottom = {{0, 1}, -5};
    islet_create_chain(world, ground, points, 4, false, NULL, NULL, 0);
    islet_create_half_space(world, ground, &bottom, NULL);

    IsletBodyId body[18];
    IsletShapeDef shape = islet_default_shape_def();
    for (int i = 0; i < 18; ++i) {
        body[i] = body_at(world, ISLET_BODY_TYPE_DYNAMIC, -12.0f + 1.5f * (float)i, 4.0f + (float)(i % 3));
        shape.density = 1 + 0.25f * (float)(i % 4);
        shape.restitution = i % 5 == 0 ? 0.5f : 0;
        shape.material = (uint32_t)i % 4;
        shape.pre_solve = i % 2 == 0;
        shape.hit_events = true;
        if (i % 3 == 0) {
            const IsletPolygon box = islet_make_rounded_box(0.4f, 0.3f, 0.05f);
            islet_create_polygon(world, body[i], &box, &shape);
        } else if (i % 3 == 1) {
            const IsletCircle circle = {{0.1f, 0}, 0.4f};
            islet_create_circle(world, body[i], &circle, &shape);
        } else {
            const IsletCapsule capsule = {{-0.3f, 0}, {0.3f, 0.1f}, 0.25f};
            islet_create_capsule(world, body[i], &capsule, &shape);
        }
    }
    IsletRevoluteJointDef revolute = islet_default_revolute_joint_def();
    revolute.base.body_a = body[0];
    revolute.base.body_b = body[1];
    revolute.base.frame_a.position.x = 0.75f;
    revolute.base.frame_b.position.x = -0.75f;
    revolute.limit.enable = true;
    revolute.limit.upper = 1;
    const IsletJointId hinge = islet_create_revolute_joint(world, &revolute);
    IsletPrismaticJointDef prismatic = islet_default_prismatic_joint_def();
    prismatic.base.body_a = body[1];
    prismatic.base.body_b = body[2];
    prismatic.motor.enable = true;
    prismatic.motor.speed = 1;
    prismatic.motor.max_force = 20;
    const IsletJointId slider = islet_create_prismatic_joint(world, &prismatic);
    IsletDistanceJointDef distance = islet_default_distance_joint_def();
    distance.base.body_a = body[3];
    distance.base.body_b = body[4];
    distance.length = 1.5f;
    distance.base.break_force = 40;
    islet_create_distance_joint(world, &distance);
    IsletWeldJointDef weld = islet_default_weld_joint_def();
    weld.base.body_a = body[5];
    weld.base.body_b = body[6];
    weld.angular_hertz = 5;
    islet_create_weld_joint(world, &weld);
    IsletWheelJointDef wheel = islet_default_wheel_joint_def();
    wheel.base.body_a = body[7];
    wheel.base.body_b = body[8];
    islet_create_wheel_joint(world, &wheel);
    IsletMotorJointDef motor = islet_default_motor_joint_def();
    motor.base.body_a = body[9];
    motor.base.body_b = body[10];
    motor.max_force = 5;
    islet_create_motor_joint(world, &motor);
    IsletMouseJointDef mouse = islet_default_mouse_joint_def();
    mouse.body = body[11];
    mouse.target.y = 9;
    mouse.max_force = 50;
    islet_create_mouse_joint(world, &mouse);
    IsletPulleyJointDef pulley = islet_default_pulley_joint_def();
    pulley.base.body_a = body[12];
    pulley.base.body_b = body[13];
    pulley.ground_a.y = pulley.ground_b.y = 12;
    pulley.ratio = 0.5f;
    islet_create_pulley_joint(world, &pulley);
    IsletAngleJointDef angle = islet_default_angle_joint_def();
    angle.base.body_a = body[14];
    angle.base.body_b = body[15];
    angle.ratchet.step = 0.2f;
    islet_create_angle_joint(world, &angle);
    IsletGearJointDef gear = islet_default_gear_joint_def();
    gear.joint1 = hinge;
    gear.joint2 = slider;
    gear.ratio = 2;
    islet_create_gear_joint(world, &gear);

    unsigned events = 0;
    for (unsigned i = 0; i < count; ++i) {
        const IsletVec2 up = {0, 30};
        if (i % 20 == 10) islet_body_apply_force_to_center(world, body[16], up, true);
        islet_world_step(world, 1.0f / 60);
        hashes[i] = islet_world_hash(world);
        events += (unsigned)(islet_world_begin_touch_events(world).count + islet_world_hit_events(world).count + islet_world_broken_joints(world).count);
    }
    return islet_world_last_error(world) == ISLET_ERROR_NONE ? events : 0;
}
