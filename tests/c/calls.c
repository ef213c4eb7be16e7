// Every function of the C interface called as it should be, and what it returns. (That all of them are here or in machines.c is checked by c_test.sh.)
#include <islet/islet.h>
#include <math.h>
#include <string.h>

#include "check.h"

static _Alignas(ISLET_WORLD_ALIGNMENT) char block[1 << 20];
static _Alignas(ISLET_WORLD_ALIGNMENT) char other_block[1 << 20];
static uint64_t image[1 << 15], image2[1 << 15], packed[1 << 15], tape[1 << 16];

static bool near(float a, float b) { return fabsf(a - b) < 1e-4f; }
static bool same(IsletVec2 a, float x, float y) { return near(a.x, x) && near(a.y, y); }
static bool ok(IsletError error) { return error == ISLET_ERROR_NONE; }
static IsletVec2 vec(float x, float y) {
    const IsletVec2 v = {x, y};
    return v;
}
static IsletTransform at(float x, float y) {
    IsletTransform t = islet_default_transform();
    t.p = vec(x, y);
    return t;
}
static IsletAabb box(float x0, float y0, float x1, float y1) {
    const IsletAabb b = {{x0, y0}, {x1, y1}};
    return b;
}
static bool equal_bodies(IsletBodyId a, IsletBodyId b) { return a.index1 == b.index1 && a.generation == b.generation; }
static bool equal_shapes(IsletShapeId a, IsletShapeId b) { return a.index1 == b.index1 && a.generation == b.generation; }
static bool equal_joints(IsletJointId a, IsletJointId b) { return a.index1 == b.index1 && a.generation == b.generation; }

static const IsletCapacity* capacity(void) {
    static IsletCapacity c;
    c = islet_default_capacity();
    c.bodies = c.shapes = 64;
    c.contacts = 128;
    c.joints = 16;
    return &c;
}

static IsletWorld* new_world(char* memory) { return islet_create_world(memory, sizeof block, capacity(), NULL, NULL); }

static IsletBodyId new_body(IsletWorld* world, IsletBodyType type, float x, float y) {
    IsletBodyDef def = islet_default_body_def();
    def.type = type;
    def.position = vec(x, y);
    return islet_create_body(world, &def);
}
static IsletShapeId new_box(IsletWorld* world, IsletBodyId body, float half_width, float half_height) {
    const IsletPolygon polygon = islet_make_box(half_width, half_height);
    return islet_create_polygon(world, body, &polygon, NULL);
}

// -- definitions ------------------------------------------------------------------------------------------------------------------------

static bool faulty(IsletFieldFault fault, IsletError error, const char* field) {
    return fault.error == error && (field == NULL ? fault.field == NULL : fault.field != NULL && strcmp(fault.field, field) == 0);
}

#define FAULT(Type, made, found, change, error, name)          \
    do {                                                       \
        Type def = made;                                       \
        CHECK(faulty(found, ISLET_ERROR_NONE, NULL));          \
        change;                                                \
        CHECK(faulty(found, error, name));                     \
        --def.struct_size;                                     \
        CHECK(faulty(found, ISLET_ERROR_STRUCT_SIZE, NULL));   \
    } while (0)

static void faults(void) {
    FAULT(IsletWorldDef, islet_default_world_def(), islet_find_world_def_fault(&def), def.lanes = 3, ISLET_ERROR_OUT_OF_RANGE, "lanes");
    FAULT(IsletSolverDef, islet_default_solver_def(), islet_find_solver_def_fault(&def), def.substeps = 0, ISLET_ERROR_OUT_OF_RANGE, "substeps");
    FAULT(IsletBodyDef, islet_default_body_def(), islet_find_body_def_fault(&def), def.position.y = NAN, ISLET_ERROR_NOT_FINITE, "position");
    FAULT(IsletShapeDef, islet_default_shape_def(), islet_find_shape_def_fault(&def), def.density = -1, ISLET_ERROR_OUT_OF_RANGE, "density");
    FAULT(IsletExplosionDef, islet_default_explosion_def(), islet_find_explosion_def_fault(&def), def.radius = -1, ISLET_ERROR_OUT_OF_RANGE, "radius");
    FAULT(IsletWindDef, islet_default_wind_def(), islet_find_wind_def_fault(&def), def.drag = -1, ISLET_ERROR_OUT_OF_RANGE, "drag");
    FAULT(IsletRevoluteJointDef, islet_default_revolute_joint_def(), islet_find_revolute_joint_def_fault(&def), def.limit.lower = 1, ISLET_ERROR_OUT_OF_RANGE, "limit.upper");
    FAULT(IsletPrismaticJointDef, islet_default_prismatic_joint_def(), islet_find_prismatic_joint_def_fault(&def), def.friction = -1, ISLET_ERROR_OUT_OF_RANGE, "friction");
    FAULT(IsletDistanceJointDef, islet_default_distance_joint_def(), islet_find_distance_joint_def_fault(&def), def.length = 0, ISLET_ERROR_OUT_OF_RANGE, "length");
    FAULT(IsletWeldJointDef, islet_default_weld_joint_def(), islet_find_weld_joint_def_fault(&def), def.linear_hertz = INFINITY, ISLET_ERROR_NOT_FINITE, "linear_hertz");
    FAULT(IsletWheelJointDef, islet_default_wheel_joint_def(), islet_find_wheel_joint_def_fault(&def), def.spring.hertz = -1, ISLET_ERROR_OUT_OF_RANGE, "spring.hertz");
    FAULT(IsletMotorJointDef, islet_default_motor_joint_def(), islet_find_motor_joint_def_fault(&def), def.max_force = -1, ISLET_ERROR_OUT_OF_RANGE, "max_force");
    FAULT(IsletMouseJointDef, islet_default_mouse_joint_def(), islet_find_mouse_joint_def_fault(&def), def.hertz = 0, ISLET_ERROR_OUT_OF_RANGE, "hertz");
    FAULT(IsletPulleyJointDef, islet_default_pulley_joint_def(), islet_find_pulley_joint_def_fault(&def), def.base.frame_b.angle = NAN, ISLET_ERROR_NOT_FINITE, "base.frame_b.angle");
    FAULT(IsletGearJointDef, islet_default_gear_joint_def(), islet_find_gear_joint_def_fault(&def), def.ratio = 0, ISLET_ERROR_OUT_OF_RANGE, "ratio");
    FAULT(IsletAngleJointDef, islet_default_angle_joint_def(), islet_find_angle_joint_def_fault(&def), def.ratchet.step = 1000, ISLET_ERROR_OUT_OF_RANGE, "ratchet.step");
    FAULT(IsletCapacity, *capacity(), islet_find_capacity_fault(&def), def.shapes = 0, ISLET_ERROR_BAD_CAPACITY, "shapes");
    FAULT(IsletMoverDef, islet_default_mover_def(), islet_find_mover_def_fault(&def), def.max_slope = 2, ISLET_ERROR_OUT_OF_RANGE, "max_slope");
    IsletMassData mass = {1, {0, 0}, 1};
    IsletSurfaceMaterial material = islet_default_surface_material();
    IsletJointFrame frame = {{0, 0}, 0};
    IsletJointSpring spring = {true, 1, 1, 0};
    IsletJointSoftness softness = islet_default_joint_softness();
    IsletJointLimit limit = {true, 0, 1};
    IsletJointMotor motor = {true, 1, 1};
    IsletJointRatchet ratchet = {0.1f, 0};
    CHECK(faulty(islet_find_mass_data_fault(&mass), ISLET_ERROR_NONE, NULL) && faulty(islet_find_surface_material_fault(&material), ISLET_ERROR_NONE, NULL));
    CHECK(faulty(islet_find_joint_frame_fault(&frame), ISLET_ERROR_NONE, NULL) && faulty(islet_find_joint_spring_fault(&spring), ISLET_ERROR_NONE, NULL));
    CHECK(faulty(islet_find_joint_softness_fault(&softness), ISLET_ERROR_NONE, NULL) && faulty(islet_find_joint_limit_fault(&limit), ISLET_ERROR_NONE, NULL));
    CHECK(faulty(islet_find_joint_motor_fault(&motor), ISLET_ERROR_NONE, NULL) && faulty(islet_find_joint_ratchet_fault(&ratchet), ISLET_ERROR_NONE, NULL));
    mass.inertia = -1;
    material.restitution = 2;
    frame.angle = NAN;
    spring.damping_ratio = -1;
    softness.angular_hertz = INFINITY;
    limit.upper = -1;
    motor.max_force = -1;
    ratchet.phase = 20000;
    CHECK(faulty(islet_find_mass_data_fault(&mass), ISLET_ERROR_OUT_OF_RANGE, "inertia"));
    CHECK(faulty(islet_find_surface_material_fault(&material), ISLET_ERROR_OUT_OF_RANGE, "restitution"));
    CHECK(faulty(islet_find_joint_frame_fault(&frame), ISLET_ERROR_NOT_FINITE, "angle"));
    CHECK(faulty(islet_find_joint_spring_fault(&spring), ISLET_ERROR_OUT_OF_RANGE, "damping_ratio"));
    CHECK(faulty(islet_find_joint_softness_fault(&softness), ISLET_ERROR_NOT_FINITE, "angular_hertz"));
    CHECK(faulty(islet_find_joint_limit_fault(&limit), ISLET_ERROR_OUT_OF_RANGE, "upper"));
    CHECK(faulty(islet_find_joint_motor_fault(&motor), ISLET_ERROR_OUT_OF_RANGE, "max_force"));
    CHECK(faulty(islet_find_joint_ratchet_fault(&ratchet), ISLET_ERROR_OUT_OF_RANGE, "phase"));
    CHECK(faulty(islet_find_joint_spring_fault(NULL), ISLET_ERROR_NULL_POINTER, NULL));
    IsletWorldDef world = islet_default_world_def();
    IsletSolverDef solver = islet_default_solver_def();
    world.solver = &solver;
    solver.omega = 2;
    CHECK(faulty(islet_find_world_def_fault(&world), ISLET_ERROR_OUT_OF_RANGE, "solver.omega"));
    CHECK(faulty(islet_find_world_def_fault(NULL), ISLET_ERROR_NULL_POINTER, NULL));
    CHECK(faulty(islet_find_body_def_fault(NULL), ISLET_ERROR_NULL_POINTER, NULL));
}

// -- plain values -----------------------------------------------------------------------------------------------------------------------

static void vectors(void) {
    CHECK(same(islet_vec2_add(vec(1, 2), vec(3, 5)), 4, 7));
    CHECK(same(islet_vec2_subtract(vec(1, 2), vec(3, 5)), -2, -3));
    CHECK(same(islet_vec2_negate(vec(1, -2)), -1, 2));
    CHECK(same(islet_vec2_scale(3, vec(1, 2)), 3, 6));
    CHECK(near(islet_vec2_dot(vec(1, 2), vec(3, 5)), 13));
    CHECK(near(islet_vec2_cross(vec(1, 2), vec(3, 5)), -1));
    CHECK(same(islet_vec2_cross_rate(2, vec(1, 0)), 0, 2));
    CHECK(same(islet_vec2_left_perp(vec(1, 0)), 0, 1));
    CHECK(same(islet_vec2_right_perp(vec(1, 0)), 0, -1));
    CHECK(near(islet_vec2_length_squared(vec(3, 4)), 25) && near(islet_vec2_length(vec(3, 4)), 5));
    CHECK(near(islet_vec2_distance_squared(vec(1, 1), vec(4, 5)), 25) && near(islet_vec2_distance(vec(1, 1), vec(4, 5)), 5));
    CHECK(same(islet_vec2_lerp(vec(0, 0), vec(4, 8), 0.25f), 1, 2));
    CHECK(same(islet_vec2_min(vec(1, 5), vec(3, 2)), 1, 2) && same(islet_vec2_max(vec(1, 5), vec(3, 2)), 3, 5));
    CHECK(same(islet_vec2_normalize(vec(0, 5)), 0, 1));
    CHECK(islet_vec2_is_finite(vec(1, 2)) && !islet_vec2_is_finite(vec(1, INFINITY)));

    const IsletRot quarter = islet_make_rot(ISLET_PI / 2);
    CHECK(near(quarter.c, 0) && near(quarter.s, 1) && near(islet_rot_angle(quarter), ISLET_PI / 2));
    CHECK(same(islet_rot_rotate(quarter, vec(1, 0)), 0, 1) && same(islet_rot_inv_rotate(quarter, vec(0, 1)), 1, 0));
    CHECK(near(islet_rot_angle(islet_rot_multiply(quarter, islet_rot_inverse(quarter))), 0));
    CHECK(near(islet_rot_angle(islet_rot_inv_mul(quarter, islet_default_rot())), -ISLET_PI / 2));
    CHECK(near(islet_rot_angle(islet_rot_integrate(islet_default_rot(), 0.25f)), 0.25f));
    const IsletRot twice = {0, 2};
    CHECK(near(islet_rot_normalize(twice).s, 1));
    CHECK(near(islet_atan2(1, 0), ISLET_PI / 2));

    CHECK(near(islet_rot_angle(islet_rot_lerp(islet_default_rot(), quarter, 0.5f)), ISLET_PI / 4));
    CHECK(same(islet_transform_lerp(at(0, 2), at(4, 0), 0.5f).p, 2, 1));

    IsletTransform pose = at(3, 4);
    pose.q = quarter;
    CHECK(same(islet_transform_point(pose, vec(1, 0)), 3, 5) && same(islet_inv_transform_point(pose, vec(3, 5)), 1, 0));
    CHECK(same(islet_transform_inv_mul(pose, pose).p, 0, 0));

    CHECK(islet_aabb_overlaps(box(0, 0, 2, 2), box(1, 1, 3, 3)) && !islet_aabb_contains(box(0, 0, 2, 2), box(1, 1, 3, 3)));
    CHECK(same(islet_aabb_merge(box(0, 0, 2, 2), box(1, 1, 3, 3)).upper, 3, 3) && same(islet_aabb_expand(box(0, 0, 2, 2), 1).lower, -1, -1));
    CHECK(near(islet_aabb_perimeter(box(0, 0, 2, 3)), 10));
}

static void geometry(void) {
    const IsletVec2 corners[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
    const IsletHull hull = islet_compute_hull(corners, 5);
    CHECK(hull.count == 4);
    const IsletPolygon polygon = islet_make_polygon(&hull, 0.1f), plain = islet_make_box(1, 2), round = islet_make_rounded_box(1, 1, 0.5f);
    const IsletPolygon offset = islet_make_offset_box(1, 1, at(5, 0), 0);
    const IsletPolygon moved = islet_transform_polygon(at(0, 7), &plain);
    CHECK(islet_polygon_is_valid(&polygon) && near(round.radius, 0.5f) && same(offset.centroid, 5, 0) && same(moved.centroid, 0, 7));
    CHECK(near(islet_polygon_compute_mass(&plain, 2).mass, 16) && same(islet_polygon_compute_aabb(&plain, at(1, 0)).upper, 2, 2));
    const IsletCircle circle = islet_default_circle();
    CHECK(islet_circle_is_valid(&circle) && near(islet_circle_compute_mass(&circle, 1).mass, ISLET_PI / 4));
    CHECK(same(islet_circle_compute_aabb(&circle, at(1, 1)).lower, 0.5f, 0.5f));
    const IsletCapsule capsule = {{-1, 0}, {1, 0}, 0.5f};
    CHECK(islet_capsule_is_valid(&capsule) && near(islet_capsule_compute_mass(&capsule, 1).mass, 2 + ISLET_PI / 4));
    CHECK(same(islet_capsule_compute_aabb(&capsule, at(0, 0)).upper, 1.5f, 0.5f));
    const IsletSegment segment = {{-1, 0}, {1, 0}};
    CHECK(islet_segment_is_valid(&segment) && same(islet_segment_compute_aabb(&segment, at(0, 1)).lower, -1, 1));
    const IsletChainSegment link = {{2, 0}, {{1, 0}, {-1, 0}}, {-2, 0}};
    CHECK(islet_chain_segment_is_valid(&link));
    const IsletHalfSpace ground = islet_default_half_space();
    CHECK(islet_half_space_is_valid(&ground) && same(ground.normal, 0, 1));

    const IsletShapeProxy of_circle = islet_make_circle_proxy(&circle), of_capsule = islet_make_capsule_proxy(&capsule);
    const IsletShapeProxy of_segment = islet_make_segment_proxy(&segment), of_polygon = islet_make_polygon_proxy(&plain);
    const IsletShapeProxy of_link = islet_make_chain_segment_proxy(&link), of_points = islet_make_proxy(corners, 4, 0.5f);
    const IsletShapeProxy of_box = islet_make_box_proxy(box(0, 0, 1, 1)), far = islet_transform_proxy(at(10, 0), &of_circle);
    CHECK(of_circle.count == 1 && of_capsule.count == 2 && of_segment.count == 2 && of_polygon.count == 4 && of_link.one_sided && of_points.count == 4);
    CHECK(islet_proxy_is_valid(&of_box) && islet_proxy_overlaps(&of_circle, &of_capsule) && islet_proxy_contains(&of_box, vec(0.5f, 0.5f)));
    CHECK(near(islet_separation(&of_circle, &far).distance, 9) && islet_separation(NULL, &far).distance > 1e38f);
    CHECK(near(islet_cast_ray(&far, vec(0, 0), vec(20, 0)).fraction, 9.5f / 20));
    CHECK(near(islet_cast_shape(&of_circle, vec(20, 0), &far).fraction, 9.0f / 20));
    CHECK(!islet_cast_ray(NULL, vec(0, 0), vec(20, 0)).hit);
    CHECK(islet_distinct_color(0) != islet_distinct_color(1));
}

// -- worlds -----------------------------------------------------------------------------------------------------------------------------

static IsletError told;
static unsigned told_count;
static void tell(IsletError error, void* context) {
    told = error;
    ++*(unsigned*)context;
}

static void creation(void) {
    const IsletCapacity* room = capacity();
    IsletWorldDef def = islet_default_world_def();
    IsletError error = 77;
    CHECK(islet_capacity_is_valid(room) && islet_world_bytes(room) <= sizeof block);
    CHECK(islet_create_world(NULL, sizeof block, room, &def, &error) == NULL && error == ISLET_ERROR_NULL_POINTER);
    CHECK(islet_create_world(block, sizeof block, NULL, &def, &error) == NULL && error == ISLET_ERROR_NULL_POINTER);
    CHECK(islet_create_world(block, islet_world_bytes(room) - 1, room, &def, &error) == NULL && error == ISLET_ERROR_BLOCK_TOO_SMALL);
    CHECK(islet_create_world(block + 1, sizeof block - 1, room, &def, &error) == NULL && error == ISLET_ERROR_BLOCK_MISALIGNED);
    IsletCapacity none = *room;
    none.bodies = 0;
    CHECK(islet_create_world(block, sizeof block, &none, &def, &error) == NULL && error == ISLET_ERROR_BAD_CAPACITY);
    none.struct_size = 3;
    CHECK(islet_create_world(block, sizeof block, &none, &def, &error) == NULL && error == ISLET_ERROR_STRUCT_SIZE);
    CHECK(!islet_capacity_is_valid(&none) && islet_world_bytes(&none) == 0 && islet_world_bytes(NULL) == 0);
    def.struct_size -= 8;
    CHECK(islet_create_world(block, sizeof block, room, &def, &error) == NULL && error == ISLET_ERROR_STRUCT_SIZE);
    def = islet_default_world_def();
    def.max_speed = -1;
    def.error_hook = tell;
    def.error_context = &told_count;
    CHECK(islet_create_world(block, sizeof block, room, &def, &error) == NULL && error == ISLET_ERROR_OUT_OF_RANGE && told == error && told_count == 1);
    def.max_speed = 100;
    IsletSolverDef solver = islet_default_solver_def();
    IsletTaskSystem tasks = islet_default_task_system();
    IsletHooks hooks = islet_default_hooks();
    solver.substeps = 7;
    def.solver = &solver;
    def.tasks = &tasks;
    def.hooks = &hooks;
    hooks.struct_size = 1;
    CHECK(islet_create_world(block, sizeof block, room, &def, &error) == NULL && error == ISLET_ERROR_STRUCT_SIZE);
    hooks = islet_default_hooks();
    IsletWorld* world = islet_create_world(block, sizeof block, room, &def, &error);
    CHECK(world != NULL && error == ISLET_ERROR_NONE && (void*)world == (void*)block);
    solver.substeps = 0;
    CHECK(ok(islet_world_solver(world, &solver)) && solver.substeps == 7);

    // Codes are of the call alone; the world keeps the last error.
    CHECK(islet_world_step(world, -1) == ISLET_ERROR_BAD_TIME_STEP && islet_world_last_error(world) == ISLET_ERROR_BAD_TIME_STEP);
    CHECK(told == ISLET_ERROR_BAD_TIME_STEP);
    CHECK(ok(islet_world_step(world, 0.01f)) && islet_world_last_error(world) == ISLET_ERROR_BAD_TIME_STEP);
    CHECK(ok(islet_world_clear_error(world)) && islet_world_last_error(world) == ISLET_ERROR_NONE);
    CHECK(islet_world_last_error(NULL) == ISLET_ERROR_NULL_POINTER);
    CHECK(islet_world_error_hook(world) == tell && islet_world_error_context(world) == &told_count);
    CHECK(ok(islet_world_set_error_hook(world, NULL, NULL)) && islet_world_error_hook(world) == NULL && islet_world_error_context(world) == NULL);
    told = ISLET_ERROR_NONE;
    CHECK(islet_world_step(world, -1) == ISLET_ERROR_BAD_TIME_STEP && told == ISLET_ERROR_NONE);
    unsigned told_again = 0;
    CHECK(ok(islet_world_set_error_hook(world, tell, &told_again)) && islet_world_error_context(world) == &told_again);
    CHECK(islet_world_step(world, -1) == ISLET_ERROR_BAD_TIME_STEP && told == ISLET_ERROR_BAD_TIME_STEP && told_again == 1);
    CHECK(ok(islet_world_set_error_hook(world, tell, &told_count)) && ok(islet_world_clear_error(world)));
    CHECK(islet_create_body(world, NULL).index1 == 0 && islet_world_last_error(world) == ISLET_ERROR_NULL_POINTER && told == ISLET_ERROR_NULL_POINTER);
    for (int e = 0; e < 256; ++e) CHECK(islet_describe((IsletError)e) != NULL && strlen(islet_describe((IsletError)e)) > 5);

    // Ids of no body, of one that is gone, and of another world.
    IsletWorld* other = new_world(other_block);
    const IsletBodyId null = {0, 0}, foreign = new_body(other, ISLET_BODY_TYPE_DYNAMIC, 0, 0), here = new_body(world, ISLET_BODY_TYPE_DYNAMIC, 0, 0);
    const IsletBodyId far = {60, 1};
    CHECK(ok(islet_destroy_body(world, here)));
    const uint64_t hash = islet_world_hash(world);
    CHECK(islet_body_wake(world, null) == ISLET_ERROR_NULL_ID && islet_body_wake(world, here) == ISLET_ERROR_STALE_ID);
    CHECK(islet_body_set_linear_velocity(world, foreign, vec(1, 1)) == ISLET_ERROR_STALE_ID && islet_body_wake(world, far) == ISLET_ERROR_STALE_ID);
    CHECK(same(islet_body_position(world, here), 0, 0) && islet_world_last_error(world) == ISLET_ERROR_STALE_ID);
    IsletBodyDef wrong = islet_default_body_def();
    wrong.type = 9;
    CHECK(islet_create_body(world, &wrong).index1 == 0 && islet_world_last_error(world) == ISLET_ERROR_OUT_OF_RANGE);
    CHECK(islet_world_hash(world) == hash);
}

static bool hook_saw_step;
static IsletWorld* hooked;
static bool filter_none(IsletShapeId a, IsletShapeId b, void* context) {
    ++*(unsigned*)context;
    hook_saw_step = islet_world_step(hooked, 0.01f) == ISLET_ERROR_IN_STEP;
    return islet_shape_is_valid(hooked, a) && islet_shape_is_valid(hooked, b);
}
static void slide(IsletPreSolve* contact, void* context) {
    (void)context;
    contact->friction = 0;
    contact->tangent_speed = 0;
}
static float mix(float a, uint32_t material_a, float b, uint32_t material_b, void* context) {
    (void)context;
    return a * b + (float)(material_a + material_b);
}
static uint64_t ticks;
static uint64_t count_ticks(void* context) {
    (void)context;
    return ++ticks;
}
static unsigned runs;
static void run_tasks(void* context, uint32_t count, void (*task)(void* data, uint32_t index), void* data) {
    (void)context;
    ++runs;
    for (uint32_t i = 0; i < count; ++i) task(data, i);
}

static void settings(void) {
    IsletWorld* world = new_world(block);
    CHECK(ok(islet_world_set_gravity(world, vec(0, -5))) && same(islet_world_gravity(world), 0, -5));
    IsletSolverDef solver = islet_default_solver_def();
    solver.substeps = 5;
    solver.measure_residual = true;
    CHECK(ok(islet_world_set_solver(world, &solver)));
    solver.substeps = 1000;
    CHECK(islet_world_set_solver(world, &solver) == ISLET_ERROR_OUT_OF_RANGE && ok(islet_world_solver(world, &solver)) && solver.substeps == 5);
    CHECK(ok(islet_world_enable_sleep(world, false)) && ok(islet_world_enable_continuous(world, false)) && !islet_world_continuous(world));
    CHECK(islet_world_seamless_floors(world) && ok(islet_world_enable_seamless_floors(world, false)) && !islet_world_seamless_floors(world));
    CHECK(!islet_world_sleep_enabled(world) && islet_world_lanes(world) >= 1);
    CHECK(ok(islet_world_set_restitution_threshold(world, 2)) && near(islet_world_restitution_threshold(world), 2));
    CHECK(ok(islet_world_set_max_speed(world, 90)) && near(islet_world_max_speed(world), 90));
    CHECK(islet_world_set_max_speed(world, 0) == ISLET_ERROR_OUT_OF_RANGE && near(islet_world_max_speed(world), 90));
    CHECK(ok(islet_world_set_hit_threshold(world, 2)) && near(islet_world_hit_threshold(world), 2));
    IsletTaskSystem tasks = islet_default_task_system();
    tasks.parallel_for = run_tasks;
    tasks.workers = 2;
    CHECK(ok(islet_world_set_tasks(world, &tasks)));
    tasks.workers = 0;
    CHECK(islet_world_set_tasks(world, &tasks) == ISLET_ERROR_OUT_OF_RANGE && ok(islet_world_tasks(world, &tasks)) && tasks.workers == 2);
    CHECK(ok(islet_world_set_clock(world, count_ticks, NULL)));
    unsigned asked = 0;
    IsletHooks hooks = islet_default_hooks();
    hooks.filter = filter_none;
    hooks.pre_solve = slide;
    hooks.mix_friction = mix;
    hooks.mix_restitution = mix;
    hooks.context = &asked;
    CHECK(ok(islet_world_set_hooks(world, &hooks)));
    hooks = islet_default_hooks();
    CHECK(ok(islet_world_hooks(world, &hooks)) && hooks.filter == filter_none && hooks.context == &asked);
    hooked = world;
    const IsletBodyId ground = new_body(world, ISLET_BODY_TYPE_STATIC_BODY, 0, 0), crate = new_body(world, ISLET_BODY_TYPE_DYNAMIC, 0, 1.5f);
    new_box(world, ground, 20, 1);
    const IsletShapeId shape = new_box(world, crate, 0.5f, 0.5f);
    CHECK(ok(islet_shape_enable_pre_solve(world, shape, true)) && islet_shape_pre_solve_enabled(world, shape));
    for (int i = 0; i < 20; ++i) islet_world_step(world, 1.0f / 60);
    CHECK(asked == 1 && hook_saw_step && ticks > 0);
    IsletStepProfile profile = islet_default_step_profile();
    CHECK(ok(islet_world_profile(world, &profile)) && profile.total > 0);
    IsletStepReport report = islet_default_step_report();
    CHECK(ok(islet_world_report(world, &report)) && report.bodies == 2 && report.touching_contacts == 1);
    IsletWorldCounters counters = islet_default_world_counters();
    CHECK(ok(islet_world_counters(world, &counters)) && counters.bytes == islet_world_bytes(capacity()) && counters.geometries == 2);
    IsletCapacity room = islet_default_capacity();
    CHECK(ok(islet_world_capacity(world, &room)) && room.bodies == 64 && room.joints == 16);
    CHECK(islet_body_residual(world, crate) >= 0 && islet_world_step_count(world) == 20 && islet_world_validate(world) == NULL);
    IsletExplosionDef blast = islet_default_explosion_def();
    blast.radius = 5;
    blast.impulse_per_length = 10;
    CHECK(ok(islet_world_explode(world, &blast)) && islet_body_linear_velocity(world, crate).y > 1);
}

/// A world with work for two workers.
static void workers(void) {
    static _Alignas(ISLET_WORLD_ALIGNMENT) char room_for_many[1 << 23];
    IsletCapacity many = islet_default_capacity();
    many.bodies = many.shapes = 4000;
    many.contacts = 4000;
    IsletWorld* world = islet_create_world(room_for_many, sizeof room_for_many, &many, NULL, NULL);
    CHECK(world != NULL);
    const IsletCircle circle = islet_default_circle();
    for (int i = 0; i < 4000; ++i) islet_create_circle(world, new_body(world, ISLET_BODY_TYPE_DYNAMIC, (float)i, (float)(i % 7)), &circle, NULL);
    IsletTaskSystem tasks = islet_default_task_system();
    tasks.parallel_for = run_tasks;
    tasks.workers = 2;
    runs = 0;
    CHECK(ok(islet_world_set_tasks(world, &tasks)) && ok(islet_world_step(world, 1.0f / 60)) && runs > 0);
}

static void bodies(void) {
    IsletWorld* world = new_world(block);
    const IsletBodyId ground = new_body(world, ISLET_BODY_TYPE_STATIC_BODY, 0, 0), body = new_body(world, ISLET_BODY_TYPE_DYNAMIC, 3, 4);
    const IsletBodyId lift = new_body(world, ISLET_BODY_TYPE_KINEMATIC, 30, 0);
    const IsletShapeId shape = new_box(world, body, 1, 1);
    CHECK(islet_world_body_count(world) == 3 && islet_body_is_valid(world, body) && equal_bodies(islet_world_body_at(world, 1), body));
    CHECK(same(islet_body_position(world, body), 3, 4) && same(islet_body_transform(world, body).p, 3, 4) && near(islet_body_angle(world, body), 0));
    CHECK(same(islet_body_center_of_mass(world, body), 3, 4) && same(islet_body_local_center_of_mass(world, body), 0, 0));
    CHECK(ok(islet_body_set_linear_velocity(world, body, vec(1, 2))) && same(islet_body_linear_velocity(world, body), 1, 2));
    CHECK(ok(islet_body_set_angular_velocity(world, body, 3)) && near(islet_body_angular_velocity(world, body), 3));
    CHECK(same(islet_body_velocity_at(world, body, vec(4, 4)), 1, 5));
    CHECK(ok(islet_body_set_transform(world, body, vec(5, 6), 0.5f)) && near(islet_body_angle(world, body), 0.5f));
    IsletTransform pose = at(5, 6);
    pose.q = islet_make_rot(0.5f);
    CHECK(ok(islet_body_set_pose(world, body, pose)) && near(islet_body_angle(world, body), 0.5f));
    pose.q.c = 2;
    CHECK(islet_body_set_pose(world, body, pose) == ISLET_ERROR_OUT_OF_RANGE);
    CHECK(ok(islet_body_set_target(world, lift, at(30, 1), 0.5f)) && same(islet_body_linear_velocity(world, lift), 0, 2));
    CHECK(near(islet_body_mass(world, body), 4) && near(islet_body_rotational_inertia(world, body), 4 * 4.0f / 6));
    const IsletMassData mass = {10, {0, 0}, 5};
    CHECK(ok(islet_body_set_mass(world, body, &mass)) && near(islet_body_mass(world, body), 10));
    CHECK(ok(islet_body_reset_mass(world, body)) && near(islet_body_mass(world, body), 4));
    CHECK(ok(islet_body_set_linear_velocity(world, body, vec(0, 0))) && ok(islet_body_set_angular_velocity(world, body, 0)));
    CHECK(ok(islet_body_apply_linear_impulse_to_center(world, body, vec(4, 0), true)) && same(islet_body_linear_velocity(world, body), 1, 0));
    CHECK(ok(islet_body_apply_linear_impulse(world, body, vec(-4, 0), vec(5, 6), true)) && same(islet_body_linear_velocity(world, body), 0, 0));
    CHECK(ok(islet_body_apply_angular_impulse(world, body, 8.0f / 3, true)) && near(islet_body_angular_velocity(world, body), 1));
    CHECK(ok(islet_body_apply_force(world, body, vec(1, 0), vec(5, 6), true)) && ok(islet_body_apply_force_to_center(world, body, vec(1, 0), true)));
    CHECK(ok(islet_body_apply_torque(world, body, 1, true)));
    const IsletBodyId sleeper = new_body(world, ISLET_BODY_TYPE_DYNAMIC, 50, 0);
    CHECK(ok(islet_body_sleep(world, sleeper)) && !islet_body_is_awake(world, sleeper));
    CHECK(ok(islet_body_apply_force(world, sleeper, vec(1, 0), vec(5, 6), false)) && ok(islet_body_apply_force_to_center(world, sleeper, vec(1, 0), false)));
    CHECK(ok(islet_body_apply_linear_impulse(world, sleeper, vec(1, 0), vec(0, 0), false)) && ok(islet_body_apply_torque(world, sleeper, 1, false)));
    CHECK(ok(islet_body_apply_linear_impulse_to_center(world, sleeper, vec(1, 0), false)) && ok(islet_body_apply_angular_impulse(world, sleeper, 1, false)));
    CHECK(!islet_body_is_awake(world, sleeper) && ok(islet_body_apply_torque(world, sleeper, 1, true)) && islet_body_is_awake(world, sleeper));
    CHECK(ok(islet_destroy_body(world, sleeper)));
    CHECK(ok(islet_body_set_linear_damping(world, body, 0.5f)) && near(islet_body_linear_damping(world, body), 0.5f));
    CHECK(ok(islet_body_set_angular_damping(world, body, 0.25f)) && near(islet_body_angular_damping(world, body), 0.25f));
    CHECK(ok(islet_body_set_gravity_scale(world, body, 2)) && near(islet_body_gravity_scale(world, body), 2));
    CHECK(ok(islet_body_set_fixed_rotation(world, body, true)) && islet_body_is_rotation_fixed(world, body));
    CHECK(ok(islet_body_lock_x(world, body, true)) && islet_body_is_x_locked(world, body) && !islet_body_is_y_locked(world, body));
    CHECK(ok(islet_body_lock_y(world, body, true)) && islet_body_is_y_locked(world, body));
    CHECK(ok(islet_body_set_enabled(world, body, false)) && !islet_body_is_enabled(world, body) && ok(islet_body_set_enabled(world, body, true)));
    CHECK(ok(islet_body_set_bullet(world, body, true)) && islet_body_is_bullet(world, body));
    CHECK(ok(islet_body_enable_sleep(world, body, false)) && ok(islet_body_set_sleep_threshold(world, body, 1)) &&
          near(islet_body_sleep_threshold(world, body), 1));
    CHECK(!islet_body_sleep_enabled(world, body) && ok(islet_body_sleep(world, body)) && !islet_body_is_awake(world, body));
    CHECK(ok(islet_body_wake(world, body)) && islet_body_is_awake(world, body));
    CHECK(ok(islet_body_set_user_data(world, body, 99)) && islet_body_user_data(world, body) == 99);
    CHECK(ok(islet_body_set_type(world, body, ISLET_BODY_TYPE_KINEMATIC)) && islet_body_type(world, body) == ISLET_BODY_TYPE_KINEMATIC);
    IsletShapeId shapes[2];
    CHECK(islet_body_shapes(world, body, shapes, 2) == 1 && equal_shapes(shapes[0], shape) && islet_body_shapes(world, body, NULL, 0) == 1);
    const IsletShapeId no_shape = {0, 0};
    CHECK(equal_shapes(islet_body_next_shape(world, body, no_shape), shape) && islet_body_next_shape(world, body, shape).index1 == 0);
    IsletJointId joints[1];
    IsletContactInfo contacts[1];
    CHECK(islet_body_joints(world, body, joints, 1) == 0 && islet_body_contacts(world, body, contacts, 1) == 0);
    CHECK(ok(islet_destroy_body(world, body)) && !islet_body_is_valid(world, body) && !islet_shape_is_valid(world, shape) &&
          islet_body_is_valid(world, ground));
}

static void shapes(void) {
    IsletWorld* world = new_world(block);
    const IsletBodyId ground = new_body(world, ISLET_BODY_TYPE_STATIC_BODY, 0, 0), body = new_body(world, ISLET_BODY_TYPE_DYNAMIC, 0, 20);
    IsletShapeDef def = islet_default_shape_def();
    def.density = 2;
    def.friction = 0.3f;
    def.filter.category = 4;
    const IsletCircle circle = islet_default_circle();
    const IsletCapsule capsule = {{-1, 0}, {1, 0}, 0.5f};
    const IsletSegment segment = {{-1, 0}, {1, 0}};
    const IsletPolygon polygon = islet_make_box(1, 1);
    const IsletChainSegment link = {{2, 0}, {{1, 0}, {-1, 0}}, {-2, 0}};
    const IsletHalfSpace half_space = islet_default_half_space();
    const IsletVec2 points[] = {{30, 0}, {10, 0}, {-10, 0}, {-30, 0}};
    IsletShapeId links[5];
    const IsletShapeId a = islet_create_circle(world, body, &circle, &def), b = islet_create_capsule(world, body, &capsule, NULL);
    const IsletShapeId c = islet_create_segment(world, ground, &segment, NULL), d = islet_create_polygon(world, body, &polygon, NULL);
    const IsletShapeId e = islet_create_chain_segment(world, ground, &link, NULL), f = islet_create_half_space(world, ground, &half_space, NULL);
    CHECK(islet_create_half_space(world, body, &half_space, NULL).index1 == 0 && islet_world_last_error(world) == ISLET_ERROR_ENDLESS_SHAPE);
    CHECK(islet_create_chain(world, ground, points, 4, false, NULL, links, 5) == 3 && islet_shape_is_valid(world, links[2]));
    CHECK(islet_create_chain(world, ground, points, 1, false, NULL, NULL, 0) == 0 && islet_world_last_error(world) == ISLET_ERROR_BAD_CHAIN);
    CHECK(islet_world_shape_count(world) == 9 && equal_bodies(islet_shape_body(world, a), body) && islet_shape_type(world, f) == ISLET_SHAPE_TYPE_HALF_SPACE);
    CHECK(near(islet_shape_circle(world, a)->radius, 0.5f) && near(islet_shape_capsule(world, b)->point2.x, 1) && islet_shape_circle(world, b) == NULL);
    CHECK(near(islet_shape_segment(world, c)->point2.x, 1) && islet_shape_polygon(world, d)->count == 4 &&
          near(islet_shape_chain_segment(world, e)->ghost1.x, 2));
    CHECK(near(islet_shape_half_space(world, f)->normal.y, 1));
    CHECK(near(islet_shape_density(world, a), 2) && ok(islet_shape_set_density(world, a, 3)) && near(islet_shape_density(world, a), 3));
    CHECK(near(islet_shape_friction(world, a), 0.3f) && ok(islet_shape_set_friction(world, a, 0.4f)) && near(islet_shape_friction(world, a), 0.4f));
    CHECK(ok(islet_shape_set_restitution(world, a, 0.5f)) && near(islet_shape_restitution(world, a), 0.5f));
    CHECK(ok(islet_shape_set_rolling_resistance(world, a, 0.1f)) && near(islet_shape_rolling_resistance(world, a), 0.1f));
    CHECK(ok(islet_shape_set_tangent_speed(world, a, 2)) && near(islet_shape_tangent_speed(world, a), 2));
    IsletSurfaceMaterial material = islet_default_surface_material();
    material.id = 8;
    CHECK(ok(islet_shape_set_material(world, a, &material)) && islet_shape_material(world, a).id == 8 && near(islet_shape_material(world, a).friction, 0.6f));
    CHECK(!islet_shape_is_sensor(world, a) && islet_shape_sensor_overlaps(world, a, NULL, 0) == 0 && islet_world_last_error(world) == ISLET_ERROR_NOT_A_SENSOR);
    CHECK(ok(islet_shape_enable_sensor_events(world, a, false)) && !islet_shape_sensor_events_enabled(world, a));
    CHECK(ok(islet_shape_enable_hit_events(world, a, true)) && islet_shape_hit_events_enabled(world, a));
    CHECK(ok(islet_shape_set_one_way(world, f, vec(0, 1))) && same(islet_shape_one_way(world, f), 0, 1));
    const IsletWindDef wind = islet_default_wind_def();
    CHECK(ok(islet_shape_apply_wind(world, a, &wind)) && same(islet_shape_aabb(world, a).upper, 0.5f, 20.5f));
    CHECK(islet_shape_filter(world, a).category == 4);
    const IsletFilter filter = {2, 3, -1};
    CHECK(ok(islet_shape_set_filter(world, a, &filter)) && islet_shape_filter(world, a).group == -1);
    CHECK(ok(islet_shape_set_user_data(world, a, 5)) && islet_shape_user_data(world, a) == 5);
    CHECK(ok(islet_shape_set_polygon(world, a, &polygon)) && islet_shape_type(world, a) == ISLET_SHAPE_TYPE_POLYGON);
    CHECK(ok(islet_shape_set_circle(world, a, &circle)) && ok(islet_shape_set_capsule(world, a, &capsule)) && ok(islet_shape_set_segment(world, a, &segment)));
    CHECK(islet_shape_set_half_space(world, a, &half_space) == ISLET_ERROR_ENDLESS_SHAPE && ok(islet_shape_set_half_space(world, c, &half_space)));
    CHECK(ok(islet_shape_set_chain_segment(world, e, &link)) && ok(islet_shape_set_sensor(world, d, true)) && islet_shape_is_sensor(world, d));
    CHECK(equal_shapes(islet_world_shape_at(world, 0), a) && islet_shape_contacts(world, a, NULL, 0) == 0);
    CHECK(ok(islet_destroy_shape(world, d)) && islet_destroy_shape(world, d) == ISLET_ERROR_STALE_ID);
}

static void joints(void) {
    IsletWorld* world = new_world(block);
    IsletBodyId body[12];
    for (int i = 0; i < 12; ++i) {
        body[i] = new_body(world, ISLET_BODY_TYPE_DYNAMIC, 3.0f * (float)i, 0);
        new_box(world, body[i], 1, 1);
    }
#define JOINT(name, a, b)                                         \
    IsletJointId name##_joint;                                    \
    Islet_##name name##_def = islet_default_##name##_joint_def(); \
    name##_def.base.body_a = body[a];                             \
    name##_def.base.body_b = body[b];                             \
    name##_def.base.frame_b.position = vec(-3.0f * (b - a), 0)
    typedef IsletRevoluteJointDef Islet_revolute;
    typedef IsletPrismaticJointDef Islet_prismatic;
    typedef IsletDistanceJointDef Islet_distance;
    typedef IsletWeldJointDef Islet_weld;
    typedef IsletWheelJointDef Islet_wheel;
    typedef IsletMotorJointDef Islet_motor;
    typedef IsletPulleyJointDef Islet_pulley;
    typedef IsletAngleJointDef Islet_angle;
    JOINT(revolute, 0, 1);
    revolute_joint = islet_create_revolute_joint(world, &revolute_def);
    JOINT(prismatic, 1, 2);
    prismatic_joint = islet_create_prismatic_joint(world, &prismatic_def);
    JOINT(distance, 2, 3);
    distance_def.base.frame_b.position = vec(0, 0);
    distance_def.length = 3;
    distance_joint = islet_create_distance_joint(world, &distance_def);
    JOINT(weld, 3, 4);
    weld_joint = islet_create_weld_joint(world, &weld_def);
    JOINT(wheel, 4, 5);
    CHECK(wheel_def.spring.enable && near(wheel_def.spring.hertz, 4));
    wheel_joint = islet_create_wheel_joint(world, &wheel_def);
    JOINT(motor, 5, 6);
    motor_joint = islet_create_motor_joint(world, &motor_def);
    IsletMouseJointDef mouse_def = islet_default_mouse_joint_def();
    mouse_def.body = body[7];
    mouse_def.target = vec(21, 0);
    mouse_def.max_force = 100;
    const IsletJointId mouse_joint = islet_create_mouse_joint(world, &mouse_def);
    JOINT(pulley, 8, 9);
    pulley_def.base.frame_b.position = vec(0, 0);
    pulley_def.ground_a = vec(24, 5);
    pulley_def.ground_b = vec(27, 5);
    pulley_joint = islet_create_pulley_joint(world, &pulley_def);
    JOINT(angle, 10, 11);
    angle_joint = islet_create_angle_joint(world, &angle_def);
    IsletGearJointDef gear_def = islet_default_gear_joint_def();
    gear_def.joint1 = revolute_joint;
    gear_def.joint2 = prismatic_joint;
    const IsletJointId gear_joint = islet_create_gear_joint(world, &gear_def);
    CHECK(islet_world_joint_count(world) == 10 && islet_world_last_error(world) == ISLET_ERROR_NONE);
    const IsletJointId all[] = {revolute_joint, prismatic_joint, distance_joint, weld_joint, wheel_joint,
                                motor_joint,    mouse_joint,     pulley_joint,   gear_joint, angle_joint};
    for (int i = 0; i < 10; ++i) CHECK(islet_joint_is_valid(world, all[i]) && islet_joint_type(world, all[i]) == i);
    CHECK(equal_joints(islet_world_joint_at(world, 0), revolute_joint));
    IsletJointId found[3];
    CHECK(islet_body_joints(world, body[1], found, 3) >= 2);
    const IsletJointId no_joint = {0, 0}, second = islet_body_next_joint(world, body[1], found[0]);
    const IsletJointId newest = islet_body_next_joint(world, body[1], no_joint);
    CHECK(newest.index1 == found[0].index1 && newest.generation == found[0].generation && second.index1 == found[1].index1);
    CHECK(equal_bodies(islet_joint_body_a(world, revolute_joint), body[0]) && equal_bodies(islet_joint_body_b(world, revolute_joint), body[1]));
    CHECK(near(islet_joint_frame_b(world, revolute_joint).position.x, -3) && near(islet_joint_frame_a(world, revolute_joint).position.x, 0));
    const IsletJointFrame frame_a = {{1.5f, 0}, 0}, frame_b = {{-1.5f, 0}, 0};
    CHECK(ok(islet_joint_set_frames(world, revolute_joint, &frame_a, &frame_b)));
    CHECK(same(islet_joint_anchor_a(world, revolute_joint), 1.5f, 0) && same(islet_joint_anchor_b(world, revolute_joint), 1.5f, 0));
    CHECK(ok(islet_joint_set_collide_connected(world, revolute_joint, true)) && islet_joint_collide_connected(world, revolute_joint));
    CHECK(ok(islet_joint_set_break(world, revolute_joint, 1e6f, 1e5f)));
    CHECK(ok(islet_joint_set_user_data(world, revolute_joint, 6)) && islet_joint_user_data(world, revolute_joint) == 6);
    CHECK(near(islet_joint_position(world, revolute_joint), 0) && near(islet_joint_speed(world, revolute_joint), 0));
    const IsletJointSpring spring = {true, 2, 1, 0.5f};
    const IsletJointLimit limit = {true, -1, 1};
    const IsletJointMotor motor = {true, 1, 10};
    const IsletJointRatchet ratchet = {0.1f, 0};
    CHECK(ok(islet_joint_set_spring(world, revolute_joint, &spring)) && near(islet_joint_spring(world, revolute_joint).target, 0.5f));
    CHECK(ok(islet_joint_set_limit(world, revolute_joint, &limit)) && near(islet_joint_limit(world, revolute_joint).lower, -1));
    CHECK(ok(islet_joint_set_motor(world, revolute_joint, &motor)) && near(islet_joint_motor(world, revolute_joint).max_force, 10));
    CHECK(ok(islet_joint_set_friction(world, revolute_joint, 2)) && near(islet_joint_friction(world, revolute_joint), 2));
    CHECK(ok(islet_joint_set_ratchet(world, angle_joint, &ratchet)) && near(islet_joint_ratchet(world, angle_joint).step, 0.1f));
    CHECK(ok(islet_joint_set_length(world, distance_joint, 2)) && near(islet_joint_length(world, distance_joint), 2));
    CHECK(ok(islet_joint_set_velocity(world, motor_joint, vec(1, 0), 1)) && ok(islet_joint_set_strength(world, motor_joint, 5, 5)));
    CHECK(ok(islet_joint_set_target(world, mouse_joint, vec(21, 1))) && same(islet_joint_target(world, mouse_joint), 21, 1));
    CHECK(same(islet_joint_ground_a(world, pulley_joint), 24, 5) && same(islet_joint_ground_b(world, pulley_joint), 27, 5));
    CHECK(islet_joint_break_force(world, revolute_joint) == 1e6f && islet_joint_break_torque(world, revolute_joint) == 1e5f);
    const IsletJointSoftness soft = {4, 1, 5, 1};
    CHECK(ok(islet_joint_set_softness(world, weld_joint, &soft)) && near(islet_joint_softness(world, weld_joint).angular_hertz, 5));
    CHECK(same(islet_joint_linear_velocity(world, motor_joint), 1, 0) && near(islet_joint_angular_velocity(world, motor_joint), 1));
    CHECK(near(islet_joint_max_force(world, motor_joint), 5) && near(islet_joint_max_torque(world, motor_joint), 5));
    CHECK(ok(islet_joint_set_grounds(world, pulley_joint, vec(24, 6), vec(27, 6))) && same(islet_joint_ground_a(world, pulley_joint), 24, 6));
    CHECK(ok(islet_joint_set_ratio(world, gear_joint, -2)) && near(islet_joint_ratio(world, gear_joint), -2));
    CHECK(equal_joints(islet_gear_joint1(world, gear_joint), revolute_joint) && equal_joints(islet_gear_joint2(world, gear_joint), prismatic_joint));
    CHECK(islet_joint_set_length(world, revolute_joint, 2) == ISLET_ERROR_WRONG_JOINT_TYPE);
    CHECK(ok(islet_world_step(world, 1.0f / 60)));
    CHECK(islet_vec2_length(islet_joint_force(world, revolute_joint)) > 0 && islet_joint_torque(world, revolute_joint) != 0);
    CHECK(islet_joint_motor_force(world, revolute_joint) != 0 && islet_joint_error(world, distance_joint).linear > 0.01f);
    CHECK(ok(islet_destroy_joint(world, revolute_joint)) && !islet_joint_is_valid(world, gear_joint));
}

// -- queries ----------------------------------------------------------------------------------------------------------------------------

static float visit_ray(const IsletQueryHit* hit, void* context) {
    *(float*)context += hit->fraction;
    return 1;
}
static bool visit_shape(IsletShapeId shape, void* context) {
    (void)shape;
    ++*(unsigned*)context;
    return true;
}
static bool all_surfaces(const IsletSurface* surface, void* context) {
    ++*(unsigned*)context;
    return surface->shape.index1 != 0;
}

static void queries(void) {
    IsletWorld* world = new_world(block);
    const IsletBodyId ground = new_body(world, ISLET_BODY_TYPE_STATIC_BODY, 0, 0);
    const IsletShapeId floor = new_box(world, ground, 20, 1), wall = new_box(world, new_body(world, ISLET_BODY_TYPE_STATIC_BODY, 10, 3), 1, 2);
    const IsletQueryFilter filter = islet_default_query_filter();
    const IsletCircle circle = islet_default_circle();
    const IsletShapeProxy proxy = islet_make_circle_proxy(&circle), here = islet_transform_proxy(at(0, 1), &proxy),
                          above = islet_transform_proxy(at(0, 3), &proxy);
    const IsletQueryHit hit = islet_world_cast_ray(world, vec(0, 5), vec(0, -10), NULL);
    CHECK(equal_shapes(hit.shape, floor) && near(hit.fraction, 0.4f) && same(hit.normal, 0, 1) && same(hit.point, 0, 1));
    CHECK(islet_world_cast_ray_any(world, vec(0, 5), vec(0, -10), &filter) && !islet_world_cast_ray_any(world, vec(0, 5), vec(0, 10), &filter));
    IsletQueryHit hits[4];
    CHECK(islet_world_cast_ray_all(world, vec(10, 9), vec(0, -10), hits, 4, NULL) == 2 && equal_shapes(hits[0].shape, wall));
    float sum = 0;
    islet_world_cast_ray_each(world, vec(10, 9), vec(0, -10), NULL, visit_ray, &sum);
    CHECK(near(sum, hits[0].fraction + hits[1].fraction));
    CHECK(near(islet_world_cast_shape(world, &above, vec(0, -10), NULL).fraction, 0.15f) && islet_world_cast_shape_any(world, &above, vec(0, -10), NULL));
    CHECK(islet_world_cast_shape_all(world, &above, vec(0, -10), hits, 4, NULL) == 1);
    sum = 0;
    islet_world_cast_shape_each(world, &above, vec(0, -10), &filter, visit_ray, &sum);
    CHECK(near(sum, 0.15f));
    IsletShapeId shapes_found[4];
    unsigned count = 0;
    CHECK(islet_world_overlap_box(world, box(-50, -50, 50, 50), shapes_found, 4, NULL) == 2 &&
          islet_world_overlap_shape(world, &here, shapes_found, 4, &filter) == 1);
    CHECK(islet_world_overlap_point(world, vec(0, 0), shapes_found, 4, NULL) == 1 && equal_shapes(shapes_found[0], floor));
    islet_world_overlap_box_each(world, box(-50, -50, 50, 50), NULL, visit_shape, &count);
    islet_world_overlap_shape_each(world, &here, NULL, visit_shape, &count);
    islet_world_overlap_point_each(world, vec(0, 0), NULL, visit_shape, &count);
    CHECK(count == 4);
    CHECK(near(islet_world_closest(world, vec(0, 4), 10, NULL).distance, 3) && islet_world_closest(world, vec(0, 4), 1, NULL).shape.index1 == 0);
    IsletSurface surfaces[2];
    CHECK(islet_world_surfaces_near(world, &here, 1, surfaces, 2, NULL) == 1 && near(surfaces[0].separation, -0.5f));

    IsletMoverDef mover = islet_default_mover_def();
    IsletMoverState hero = {0};
    IsletMoverInput input = islet_default_mover_input();
    CHECK(near(mover.capsule.point2.y, 1.5f) && near(mover.mass, 70));
    hero.position = vec(0, 1.2f);
    count = 0;
    mover.collides = all_surfaces;
    mover.context = &count;
    for (int i = 0; i < 60; ++i) {
        input.walk = 2;
        CHECK(ok(islet_world_step(world, 1.0f / 60)) && islet_step_mover(world, &mover, &hero, &input, 1.0f / 60));
    }
    CHECK(equal_bodies(hero.ground, ground) && hero.position.x > 1 && count > 0);
    mover.up = vec(3, 3);
    CHECK(!islet_step_mover(world, &mover, &hero, &input, 1.0f / 60) && islet_world_last_error(world) == ISLET_ERROR_OUT_OF_RANGE);
}

// -- events -----------------------------------------------------------------------------------------------------------------------------

static void events(void) {
    IsletWorld* world = new_world(block);
    const IsletBodyId ground = new_body(world, ISLET_BODY_TYPE_STATIC_BODY, 0, 0), crate = new_body(world, ISLET_BODY_TYPE_DYNAMIC, 0, 6);
    new_box(world, ground, 20, 1);
    const IsletShapeId shape = new_box(world, crate, 0.5f, 0.5f);
    islet_shape_enable_hit_events(world, shape, true);
    IsletShapeDef def = islet_default_shape_def();
    def.sensor = true;
    const IsletPolygon zone = islet_make_offset_box(1, 0.5f, at(0, 4), 0);
    const IsletShapeId sensor = islet_create_polygon(world, ground, &zone, &def);
    CHECK(islet_shape_is_sensor(world, sensor));
    IsletDistanceJointDef rope = islet_default_distance_joint_def();
    rope.base.body_a = ground;
    rope.base.body_b = crate;
    rope.length = 6;
    rope.base.break_force = 1;
    rope.base.user_data = 7;
    const IsletJointId joint = islet_create_distance_joint(world, &rope);
    size_t begun = 0, entered = 0, left = 0, hit = 0, moved = 0, slept = 0, broken = 0, overlapping = 0;
    for (int i = 0; i < 200; ++i) {
        islet_world_step(world, 1.0f / 60);
        begun += islet_world_begin_touch_events(world).count;
        entered += islet_world_sensor_begin_events(world).count;
        left += islet_world_sensor_end_events(world).count;
        IsletShapeId visitor;
        if (islet_shape_sensor_overlaps(world, sensor, &visitor, 1) == 1 && equal_shapes(visitor, shape)) ++overlapping;
        const IsletHitEventSpan hits = islet_world_hit_events(world);
        for (size_t k = 0; k < hits.count; ++k) CHECK(hits.data[k].speed > 3);
        hit += hits.count;
        moved += islet_world_moved_bodies(world).count;
        slept += islet_world_slept_bodies(world).count;
        const IsletJointBreakEventSpan breaks = islet_world_broken_joints(world);
        for (size_t k = 0; k < breaks.count; ++k) CHECK(breaks.data[k].user_data == 7 && equal_joints(breaks.data[k].joint, joint));
        broken += breaks.count;
    }
    CHECK(begun == 1 && entered == 1 && left == 1 && hit == 1 && moved > 50 && slept == 1 && broken == 1 && overlapping > 0);
    IsletContactInfo contact;
    bool touching = false;
    for (uint32_t i = 0; i < 128; ++i) touching = touching || islet_world_contact_at(world, i, &contact);
    CHECK(islet_world_contact_count(world) == 1 && touching && contact.point_count == 2);
    CHECK(islet_body_contacts(world, crate, &contact, 1) == 1);
    IsletContactInfo next;
    const uint32_t number = islet_body_next_contact(world, crate, 0, &next);
    CHECK(number != 0 && equal_shapes(next.shape_a, contact.shape_a) && equal_shapes(next.shape_b, contact.shape_b));
    CHECK(islet_body_next_contact(world, crate, number, &next) == 0 && islet_body_next_contact(world, crate, 4000, &next) == 0);
    CHECK(islet_shape_next_contact(world, contact.shape_b, 0, &next) == number && islet_shape_next_contact(world, contact.shape_b, number, &next) == 0);
    CHECK(ok(islet_destroy_shape(world, shape)));
    const IsletTouchEventSpan ended = islet_world_end_touch_events(world);
    CHECK(ended.count == 1 && (equal_shapes(ended.data[0].shape_a, shape) || equal_shapes(ended.data[0].shape_b, shape)));
}

// -- the world as a value ---------------------------------------------------------------------------------------------------------------

static IsletWorld* falling(char* memory) {
    IsletWorld* world = new_world(memory);
    new_box(world, new_body(world, ISLET_BODY_TYPE_STATIC_BODY, 0, 0), 20, 1);
    for (int i = 0; i < 6; ++i) new_box(world, new_body(world, ISLET_BODY_TYPE_DYNAMIC, 0.1f * (float)i, 2 + 1.2f * (float)i), 0.5f, 0.5f);
    return world;
}

static void values(void) {
    IsletWorld* world = falling(block);
    CHECK(islet_world_start_recording(world, tape, sizeof tape, true) && islet_world_is_recording(world));
    for (int i = 0; i < 30; ++i) islet_world_step(world, 1.0f / 60);
    const size_t bytes = islet_world_save(world, image, sizeof image);
    CHECK(bytes == islet_world_snapshot_bytes(world) && bytes <= islet_max_snapshot_bytes(capacity()));
    CHECK(islet_world_save(world, image2, bytes - 1) == 0 && islet_world_last_error(world) == ISLET_ERROR_IMAGE_TOO_SMALL);
    for (int i = 0; i < 30; ++i) islet_world_step(world, 1.0f / 60);
    const uint64_t hash = islet_world_hash(world);
    IsletError copy_error = 77;
    IsletWorld* copy = islet_copy_world(world, other_block, sizeof other_block, capacity(), image2, sizeof image2, &copy_error);
    CHECK(copy != NULL && ok(copy_error) && islet_world_hash(copy) == hash);
    CHECK(islet_copy_world(NULL, other_block, sizeof other_block, capacity(), image2, sizeof image2, &copy_error) == NULL &&
          copy_error == ISLET_ERROR_NULL_POINTER);
    CHECK(islet_copy_world(world, other_block, sizeof other_block, NULL, image2, sizeof image2, &copy_error) == NULL &&
          copy_error == ISLET_ERROR_NULL_POINTER);
    CHECK(islet_copy_world(world, other_block, sizeof other_block, capacity(), NULL, sizeof image2, NULL) == NULL);
    CHECK(islet_copy_world(world, other_block, sizeof other_block, capacity(), image2, 8, &copy_error) == NULL &&
          copy_error == ISLET_ERROR_IMAGE_TOO_SMALL);
    const size_t bytes2 = islet_world_save(world, image2, sizeof image2);

    static uint64_t tape2[1 << 16];
    CHECK(islet_world_recorded_bytes(world) > bytes);
    memcpy(tape2, tape, sizeof tape);
    CHECK(islet_world_move_recording(world, tape2, sizeof tape2));
    const size_t recorded = islet_world_stop_recording(world);
    CHECK(recorded > bytes && !islet_world_is_recording(world));
    IsletRecordingInfo recording = islet_default_recording_info();
    IsletCapacity claimed = islet_default_capacity(), needed = islet_default_capacity();
    recording.capacity = &claimed;
    recording.needed = &needed;
    CHECK(ok(islet_read_recording(tape2, recorded, &recording)) && recording.bytes == recorded && recording.bodies && claimed.bodies == 64 &&
          needed.bodies >= 7);
    CHECK(islet_read_recording(image, bytes, &recording) == ISLET_ERROR_NOT_A_RECORDING);
    IsletWorld* other = new_world(other_block);
    IsletReplayResult replayed = islet_default_replay_result();
    CHECK(ok(islet_replay(other, tape2, recorded, UINT64_MAX, &replayed)) && replayed.end == ISLET_REPLAY_END_COMPLETE && replayed.steps == 60);
    CHECK(islet_world_hash(other) == hash);

    CHECK(islet_world_restore(world, image, bytes) && islet_world_step_count(world) == 30);
    for (int i = 0; i < 30; ++i) islet_world_step(world, 1.0f / 60);
    CHECK(islet_world_hash(world) == hash);
    CHECK(islet_world_load(world, image, bytes));
    IsletSnapshotInfo info = islet_default_snapshot_info();
    CHECK(ok(islet_read_snapshot(image, bytes, &info)) && info.bytes == bytes);
    info.used = &needed;
    CHECK(ok(islet_read_snapshot(image, bytes, &info)) && needed.bodies == 7 && needed.struct_size == sizeof needed);
    CHECK(islet_read_snapshot(tape2, recorded, &info) == ISLET_ERROR_NOT_AN_IMAGE);
    CHECK(islet_read_snapshot(image, bytes - 1, &info) == ISLET_ERROR_TRUNCATED_IMAGE);

    IsletError error = 9;
    const size_t difference = islet_delta(image, bytes, image2, bytes2, packed, sizeof packed, &error);
    CHECK(difference > 0 && difference <= islet_max_delta_bytes(bytes2));
    static uint64_t again[1 << 15];
    CHECK(islet_apply(image, bytes, packed, difference, again, sizeof again, NULL) == bytes2 && memcmp(again, image2, bytes2) == 0);
    CHECK(islet_apply(image2, bytes2, packed, difference, again, sizeof again, &error) == 0 && error == ISLET_ERROR_WRONG_DELTA);

    IsletFormatInfo format = islet_default_format_info();
    char sentence[128];
    CHECK(ok(islet_read_format(image, bytes, &format)) && format.kind == ISLET_FORMAT_KIND_SNAPSHOT && format.format == ISLET_SNAPSHOT_FORMAT);
    CHECK(islet_format_is_readable(&format) && !islet_format_is_readable(NULL));
    CHECK(islet_describe_format(&format, sentence, sizeof sentence) == strlen(sentence));
    CHECK(strstr(sentence, ISLET_VERSION_STRING) != NULL);
    ((char*)image)[200] ^= 1;
    CHECK(!islet_world_load(world, image, bytes) && islet_world_last_error(world) == ISLET_ERROR_CORRUPT_IMAGE);
}

static void islands(void) {
    IsletWorld* world = falling(block);
    for (int i = 0; i < 60; ++i) islet_world_step(world, 1.0f / 60);
    const IsletBodyId body = islet_world_body_at(world, 1), null = {0, 0};
    static char memory[1 << 16];
    IsletIslandProblem problem = islet_default_island_problem();
    const size_t bytes = islet_body_export_island(world, body, 1.0f / 240, NULL, 0, &problem);
    CHECK(bytes > 0 && bytes <= sizeof memory && problem.row_count == 0);
    CHECK(islet_body_export_island(world, body, 1.0f / 240, memory, sizeof memory, &problem) == bytes && problem.row_count > 2 && problem.body_count > 0);
    CHECK(problem.row_starts[problem.row_count] == problem.entry_count && problem.rows[0].kind <= ISLET_ROW_KIND_JOINT_FRICTION &&
          problem.bodies[0].inv_mass > 0);
    float pushed = 0;
    for (uint32_t i = 0; i < problem.row_count; ++i) pushed += problem.impulses[i] * 0 + problem.values[problem.row_starts[i]] * 0 + problem.q[i] * 0;
    CHECK(pushed == 0 && problem.lo != NULL && problem.hi != NULL && problem.friction != NULL && problem.columns[0] < problem.row_count);
    CHECK(islet_body_export_island(world, null, 1.0f / 240, memory, sizeof memory, &problem) == 0 && islet_world_last_error(world) == ISLET_ERROR_NULL_ID);
    CHECK(islet_body_export_island(NULL, body, 1.0f / 240, memory, sizeof memory, &problem) == 0);
    CHECK(islet_body_export_island(world, body, 1.0f / 240, NULL, 8, &problem) == 0 && islet_world_last_error(world) == ISLET_ERROR_NULL_POINTER);
    CHECK(islet_body_export_island(world, body, 1.0f / 240, memory, sizeof memory, NULL) == 0 && islet_world_last_error(world) == ISLET_ERROR_NULL_POINTER);
    problem.struct_size = 4;
    CHECK(islet_body_export_island(world, body, 1.0f / 240, memory, sizeof memory, &problem) == 0 && islet_world_last_error(world) == ISLET_ERROR_STRUCT_SIZE);
}

// -- drawing ----------------------------------------------------------------------------------------------------------------------------

struct Drawn {
    unsigned polygons, circles, capsules, segments, points, texts;
    size_t corners;
};

static void draw_polygon(const IsletVec2* corners, size_t count, float radius, const IsletDrawStyle* style, void* context) {
    struct Drawn* drawn = context;
    ++drawn->polygons;
    drawn->corners += count;
    CHECK(corners != NULL && radius >= 0 && style->part <= ISLET_DRAW_PART_NAME && style->color <= 0xffffff);
}
static void draw_circle(IsletVec2 center, float radius, IsletVec2 axis, const IsletDrawStyle* style, void* context) {
    ++((struct Drawn*)context)->circles;
    CHECK(radius > 0 && near(islet_vec2_length(axis), 1) && islet_vec2_is_finite(center) && style->color != 0);
}
static void draw_capsule(IsletVec2 point1, IsletVec2 point2, float radius, const IsletDrawStyle* style, void* context) {
    ++((struct Drawn*)context)->capsules;
    CHECK(radius > 0 && islet_vec2_is_finite(point1) && islet_vec2_is_finite(point2) && style != NULL);
}
static void draw_segment(IsletVec2 point1, IsletVec2 point2, const IsletDrawStyle* style, void* context) {
    ++((struct Drawn*)context)->segments;
    CHECK(islet_vec2_is_finite(point1) && islet_vec2_is_finite(point2) && style != NULL);
}
static void draw_point(IsletVec2 point, const IsletDrawStyle* style, void* context) {
    ++((struct Drawn*)context)->points;
    CHECK(islet_vec2_is_finite(point) && style != NULL);
}
static void draw_text(IsletVec2 point, const char* text, const IsletDrawStyle* style, void* context) {
    ++((struct Drawn*)context)->texts;
    CHECK(islet_vec2_is_finite(point) && strlen(text) > 0 && style != NULL);
}

static void drawing(void) {
    IsletWorld* world = falling(block);
    const IsletCircle circle = islet_default_circle();
    const IsletCapsule capsule = {{-1, 0}, {1, 0}, 0.5f};
    const IsletSegment segment = {{-1, 0}, {1, 0}};
    const IsletPolygon polygon = islet_make_box(1, 1);
    IsletDrawStyle style = islet_default_draw_style();
    style.color = ISLET_DRAW_COLOR_AWAKE;
    const IsletShapeId shape = islet_create_circle(world, islet_world_body_at(world, 0), &circle, NULL);
    for (int i = 0; i < 60; ++i) islet_world_step(world, 1.0f / 60);
    struct Drawn drawn = {0};
    IsletDebugDraw draw = islet_default_debug_draw();
    islet_world_draw(world, &draw);  // nothing to draw with
    draw.polygon = draw_polygon;
    draw.circle = draw_circle;
    draw.capsule = draw_capsule;
    draw.segment = draw_segment;
    draw.point = draw_point;
    draw.text = draw_text;
    draw.context = &drawn;
    draw.contacts = draw.names = draw.normals = true;
    CHECK(draw.shapes && near(draw.size, 0.25f) && draw.view.upper.x > 1e29f);
    islet_world_draw(world, &draw);
    CHECK(drawn.polygons == 7 && drawn.corners == 28 && drawn.circles == 1 && drawn.points > 3 && drawn.texts == 6 && drawn.segments > 3);
    islet_world_draw_shape(world, &draw, shape, at(0, 0), &style);
    islet_draw_circle(&draw, &circle, at(0, 0), &style);
    islet_draw_capsule(&draw, &capsule, at(0, 0), &style);
    islet_draw_segment(&draw, &segment, at(0, 0), &style);
    islet_draw_polygon(&draw, &polygon, at(0, 0), &style);
    CHECK(drawn.circles == 3 && drawn.capsules == 1 && drawn.polygons == 8);
    draw.size = -1;
    islet_world_draw(world, &draw);
    CHECK(islet_world_last_error(world) == ISLET_ERROR_OUT_OF_RANGE && drawn.circles == 3);
}

int main(void) {
    faults();
    vectors();
    geometry();
    creation();
    settings();
    workers();
    bodies();
    shapes();
    joints();
    queries();
    events();
    values();
    islands();
    drawing();
    return result();
}
