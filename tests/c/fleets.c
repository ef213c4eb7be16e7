// A fleet by the C interface, and what its functions refuse. fleets_test.cpp makes the same fleet by that of C++.
#include "fleets.h"

#include <islet/islet.h>
#include <math.h>
#include <string.h>

#include "check.h"

static _Alignas(ISLET_WORLD_ALIGNMENT) char prototype_block[200000];
static _Alignas(ISLET_WORLD_ALIGNMENT) char fleet_block[3000000];
static uint64_t image[1 << 13];

void fleet_actions(unsigned round, float* actions) {
    for (unsigned i = 0; i < fleet_worlds * fleet_drives; ++i) actions[i] = (float)((round * 31 + i * 17) % 64) / 32.0f - 1.0f;
}

static IsletCapacity fleet_capacity(void) {
    IsletCapacity capacity = islet_default_capacity();
    capacity.bodies = capacity.shapes = 16;
    capacity.contacts = 64;
    capacity.joints = 8;
    return capacity;
}

static IsletBodyId box_at(IsletWorld* world, float x, float y, float half_width, float half_height) {
    IsletBodyDef def = islet_default_body_def();
    def.type = ISLET_BODY_TYPE_DYNAMIC;
    def.position.x = x;
    def.position.y = y;
    const IsletBodyId body = islet_create_body(world, &def);
    const IsletPolygon box = islet_make_box(half_width, half_height);
    islet_create_polygon(world, body, &box, NULL);
    return body;
}

/// A cart with a pole on a floor, and a box on it.
struct Yard {
    IsletWorld* world;
    IsletBodyId cart, pole, box;
    IsletJointId hinge;
};

static struct Yard make_yard(void) {
    struct Yard yard;
    const IsletCapacity capacity = fleet_capacity();
    yard.world = islet_create_world(prototype_block, sizeof prototype_block, &capacity, NULL, NULL);
    IsletBodyDef def = islet_default_body_def();
    def.position.y = -1;
    const IsletBodyId ground = islet_create_body(yard.world, &def);
    const IsletPolygon floor = islet_make_box(50, 1);
    islet_create_polygon(yard.world, ground, &floor, NULL);
    yard.cart = box_at(yard.world, 0, 0.25f, 0.5f, 0.25f);
    yard.pole = box_at(yard.world, 0, 1, 0.05f, 0.5f);
    yard.box = box_at(yard.world, 2, 3, 0.5f, 0.5f);
    IsletRevoluteJointDef hinge = islet_default_revolute_joint_def();
    hinge.base.body_a = yard.cart;
    hinge.base.body_b = yard.pole;
    hinge.base.frame_a.position.y = 0.25f;
    hinge.base.frame_b.position.y = -0.5f;
    hinge.motor.enable = true;
    hinge.motor.max_force = 2;
    yard.hinge = islet_create_revolute_joint(yard.world, &hinge);
    return yard;
}

static void fill_drives(const struct Yard* yard, IsletDrive* drives) {
    for (int i = 0; i < fleet_drives; ++i) drives[i] = islet_default_drive();
    drives[0].body = yard->cart;
    drives[0].scale = 30;
    drives[1].kind = ISLET_DRIVE_KIND_MOTOR_SPEED;
    drives[1].joint = yard->hinge;
    drives[1].scale = 3;
    drives[2].kind = ISLET_DRIVE_KIND_TORQUE;
    drives[2].body = yard->box;
    drives[2].scale = 5;
}

enum { sense_count = 7 };

static void fill_senses(const struct Yard* yard, IsletSense* senses) {
    const IsletSenseKind kinds[sense_count] = {
        ISLET_SENSE_KIND_POSITION, ISLET_SENSE_KIND_ROTATION, ISLET_SENSE_KIND_VELOCITY, ISLET_SENSE_KIND_ANGULAR_VELOCITY,
        ISLET_SENSE_KIND_JOINT,    ISLET_SENSE_KIND_TOUCHING, ISLET_SENSE_KIND_RAY};
    for (int i = 0; i < sense_count; ++i) {
        senses[i] = islet_default_sense();
        senses[i].kind = kinds[i];
        senses[i].body = i % 2 == 0 ? yard->box : yard->pole;
    }
    senses[4].joint = yard->hinge;
    senses[6].translation.y = -4;
}

/// Runs the tasks last to first, on one thread: worlds must not care.
static void run_backwards(void* context, uint32_t count, void (*task)(void* data, uint32_t index), void* data) {
    ++*(unsigned*)context;
    for (uint32_t i = count; i-- > 0;) task(data, i);
}

bool tell_fleet_story(struct FleetStory* story) {
    const struct Yard yard = make_yard();
    const IsletCapacity capacity = fleet_capacity();
    unsigned jobs = 0;
    IsletTaskSystem tasks = islet_default_task_system();
    tasks.parallel_for = run_backwards;
    tasks.context = &jobs;
    tasks.workers = 3;
    story->bytes = islet_fleet_bytes(fleet_worlds, &capacity, tasks.workers);
    IsletFleet* fleet = islet_create_fleet(fleet_block, story->bytes, yard.world, fleet_worlds, &tasks, NULL);
    if (fleet == NULL || islet_fleet_size(fleet) != fleet_worlds || story->bytes > sizeof fleet_block) return false;

    IsletDrive drives[fleet_drives];
    IsletSense senses[sense_count];
    fill_drives(&yard, drives);
    fill_senses(&yard, senses);
    if (islet_sense_columns(senses, sense_count) != fleet_columns) return false;
    float actions[fleet_worlds * fleet_drives];
    const uint8_t mask[fleet_worlds] = {1, 1, 0, 1, 0, 1, 1, 0, 1, 1, 1, 0, 0, 1, 1, 1, 0, 1, 0};
    const uint32_t parents[fleet_worlds] = {0, 0, 2, 2, 2, 5, 5, 7, 8, 2, 0, 11, 11, 8, 14, 15, 14, 5, 18};
    IsletVariation variation = {0};
    variation.body = yard.box;
    variation.position.x = 0.5f;
    variation.velocity.y = 2;
    variation.angular_velocity = 1;
    const size_t image_bytes = islet_world_save(yard.world, image, sizeof image);
    bool good = true;
    for (unsigned round = 0; round < fleet_rounds; ++round) {
        fleet_actions(round, actions);
        float* observations = story->observations[round];
        IsletFleetStep what = islet_default_fleet_step();
        what.repeat = 1 + round % 3;
        what.drives = drives;
        what.drives_count = fleet_drives;
        what.actions = actions;
        what.actions_count = fleet_worlds * fleet_drives;
        if (round % 2 == 1) {
            what.mask = mask;
            what.mask_count = fleet_worlds;
        }
        good = good && islet_fleet_step(fleet, &what) == ISLET_ERROR_NONE;
        if (round % 10 == 4) good = good && islet_fleet_reset(fleet, round % fleet_worlds, image, image_bytes, round, &variation, 1) == ISLET_ERROR_NONE;
        if (round % 10 == 6) good = good && islet_fleet_copy(fleet, 3, 1) == ISLET_ERROR_NONE;
        if (round % 10 == 8) good = good && islet_fleet_fork(fleet, parents, fleet_worlds) == ISLET_ERROR_NONE;
        good = good && islet_fleet_observe(fleet, senses, sense_count, observations, fleet_worlds * fleet_columns, NULL, 0) == ISLET_ERROR_NONE;
        for (uint32_t k = 0; k < fleet_worlds; ++k) story->hashes[round][k] = islet_world_hash(islet_fleet_world(fleet, k));
    }
    return good && jobs > 0;
}

static IsletFleet* fleet;
static uint64_t hashes_before[fleet_worlds];

static void remember_fleet(void) {
    for (uint32_t k = 0; k < fleet_worlds; ++k) hashes_before[k] = islet_world_hash(islet_fleet_world(fleet, k));
}
static bool fleet_is_unchanged(void) {
    bool same = true;
    for (uint32_t k = 0; k < fleet_worlds; ++k) same = same && hashes_before[k] == islet_world_hash(islet_fleet_world(fleet, k));
    return same;
}

// A call that returns this error and changes no world.
#define REFUSED(call, error)         \
    do {                             \
        CHECK((call) == (error));    \
        CHECK(fleet_is_unchanged()); \
    } while (0)

static void refuse_creations(const struct Yard* yard) {
    IsletCapacity capacity = fleet_capacity();
    IsletTaskSystem tasks = islet_default_task_system();
    IsletError error = ISLET_ERROR_NONE;
    const size_t bytes = islet_fleet_bytes(fleet_worlds, &capacity, 1);
    CHECK(bytes > 0 && islet_fleet_bytes(0, &capacity, 1) == 0 && islet_fleet_bytes(1, &capacity, 0) == 0);
    CHECK(islet_fleet_bytes((1u << 20) + 1, &capacity, 1) == 0 && islet_fleet_bytes(1, &capacity, ISLET_MAX_WORKERS + 1) == 0);
    CHECK(islet_fleet_bytes(1, NULL, 1) == 0);
    --capacity.struct_size;
    CHECK(islet_fleet_bytes(1, &capacity, 1) == 0);
    CHECK(islet_create_fleet(NULL, bytes, yard->world, fleet_worlds, NULL, &error) == NULL && error == ISLET_ERROR_NULL_POINTER);
    CHECK(islet_create_fleet(fleet_block, bytes, NULL, fleet_worlds, NULL, &error) == NULL && error == ISLET_ERROR_NULL_POINTER);
    CHECK(islet_create_fleet(fleet_block, bytes, NULL, fleet_worlds, NULL, NULL) == NULL);
    CHECK(islet_create_fleet(fleet_block, bytes - 1, yard->world, fleet_worlds, NULL, &error) == NULL && error == ISLET_ERROR_BLOCK_TOO_SMALL);
    CHECK(islet_create_fleet(fleet_block + 8, bytes, yard->world, fleet_worlds, NULL, &error) == NULL && error == ISLET_ERROR_BLOCK_MISALIGNED);
    CHECK(islet_create_fleet(fleet_block, bytes, yard->world, 0, NULL, &error) == NULL && error == ISLET_ERROR_OUT_OF_RANGE);
    tasks.workers = 0;
    CHECK(islet_create_fleet(fleet_block, bytes, yard->world, fleet_worlds, &tasks, &error) == NULL && error == ISLET_ERROR_OUT_OF_RANGE);
    ++tasks.struct_size;
    CHECK(islet_create_fleet(fleet_block, bytes, yard->world, fleet_worlds, &tasks, &error) == NULL && error == ISLET_ERROR_STRUCT_SIZE);
    fleet = islet_create_fleet(fleet_block, bytes, yard->world, fleet_worlds, NULL, &error);
    CHECK(fleet != NULL && error == ISLET_ERROR_NONE);
}

/// What is no fleet: a null pointer, memory of zeros, a world, and a fleet that was moved.
static void refuse_what_is_no_fleet(const struct Yard* yard) {
    static _Alignas(ISLET_WORLD_ALIGNMENT) char zeros[256], moved[256];
    memcpy(moved, fleet_block, sizeof moved);
    void* const none[] = {NULL, zeros, yard->world, moved};
    const uint64_t world_before = islet_world_hash(yard->world);
    for (size_t i = 0; i < sizeof none / sizeof *none; ++i) {
        IsletFleet* const given = (IsletFleet*)none[i];
        const IsletError error = given == NULL ? ISLET_ERROR_NULL_POINTER : ISLET_ERROR_NOT_A_FLEET;
        const IsletFleetStep what = islet_default_fleet_step();
        const uint32_t parents[] = {0};
        CHECK(islet_fleet_size(given) == 0 && islet_fleet_world(given, 0) == NULL);
        REFUSED(islet_fleet_step(given, &what), error);
        REFUSED(islet_fleet_observe(given, NULL, 0, NULL, 0, NULL, 0), error);
        REFUSED(islet_fleet_reset(given, 0, image, sizeof image, 0, NULL, 0), error);
        REFUSED(islet_fleet_copy(given, 0, 0), error);
        REFUSED(islet_fleet_fork(given, parents, 1), error);
    }
    CHECK(islet_world_hash(yard->world) == world_before);
    CHECK(strstr(islet_describe(ISLET_ERROR_NOT_A_FLEET), "islet_create_fleet") != NULL);
}

static void refuse_steps(const struct Yard* yard) {
    IsletDrive drives[fleet_drives];
    float actions[fleet_worlds * fleet_drives] = {0};
    fill_drives(yard, drives);
    IsletFleetStep what = islet_default_fleet_step();
    REFUSED(islet_fleet_step(fleet, NULL), ISLET_ERROR_NULL_POINTER);
    --what.struct_size;
    REFUSED(islet_fleet_step(fleet, &what), ISLET_ERROR_STRUCT_SIZE);
    size_t* const counts[] = {&what.mask_count, &what.drives_count, &what.actions_count, &what.senses_count, &what.observations_count};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; ++i) {
        what = islet_default_fleet_step();
        *counts[i] = fleet_worlds;
        REFUSED(islet_fleet_step(fleet, &what), ISLET_ERROR_NULL_POINTER);
    }
    what = islet_default_fleet_step();
    what.dt = 0;
    REFUSED(islet_fleet_step(fleet, &what), ISLET_ERROR_BAD_TIME_STEP);
    what = islet_default_fleet_step();
    what.repeat = 0;
    REFUSED(islet_fleet_step(fleet, &what), ISLET_ERROR_OUT_OF_RANGE);
    what = islet_default_fleet_step();
    what.drives = drives;
    what.drives_count = fleet_drives;
    what.actions = actions;
    what.actions_count = fleet_worlds * fleet_drives - 1;
    REFUSED(islet_fleet_step(fleet, &what), ISLET_ERROR_OUT_OF_RANGE);
    ++what.actions_count;
    actions[5] = NAN;
    REFUSED(islet_fleet_step(fleet, &what), ISLET_ERROR_NOT_FINITE);
    actions[5] = 0;
    drives[1].kind = 200;
    REFUSED(islet_fleet_step(fleet, &what), ISLET_ERROR_OUT_OF_RANGE);
}

static void refuse_the_rest(const struct Yard* yard) {
    const uint8_t mask[] = {1};
    const uint32_t parents[fleet_worlds] = {0, 0, 1, 0, 0, 0, 0};  // 1 is no parent of itself
    float observations[2];
    IsletSense sense = islet_default_sense();
    IsletVariation variation = {0};
    const size_t bytes = islet_world_save(yard->world, image, sizeof image);
    CHECK(islet_fleet_world(fleet, fleet_worlds) == NULL);
    REFUSED(islet_fleet_observe(fleet, NULL, 1, observations, 2, NULL, 0), ISLET_ERROR_NULL_POINTER);
    REFUSED(islet_fleet_observe(fleet, &sense, 1, NULL, 2, NULL, 0), ISLET_ERROR_NULL_POINTER);
    REFUSED(islet_fleet_observe(fleet, NULL, 0, NULL, 0, NULL, 1), ISLET_ERROR_NULL_POINTER);
    REFUSED(islet_fleet_observe(fleet, &sense, 1, observations, 2, NULL, 0), ISLET_ERROR_OUT_OF_RANGE);
    REFUSED(islet_fleet_observe(fleet, NULL, 0, NULL, 0, mask, 1), ISLET_ERROR_OUT_OF_RANGE);
    REFUSED(islet_fleet_reset(fleet, 0, NULL, bytes, 0, NULL, 0), ISLET_ERROR_NULL_POINTER);
    REFUSED(islet_fleet_reset(fleet, 0, image, bytes, 0, NULL, 1), ISLET_ERROR_NULL_POINTER);
    REFUSED(islet_fleet_reset(fleet, fleet_worlds, image, bytes, 0, NULL, 0), ISLET_ERROR_OUT_OF_RANGE);
    REFUSED(islet_fleet_reset(fleet, 0, image, bytes - 8, 0, NULL, 0), ISLET_ERROR_TRUNCATED_IMAGE);
    variation.angle = -1;
    REFUSED(islet_fleet_reset(fleet, 0, image, bytes, 0, &variation, 1), ISLET_ERROR_OUT_OF_RANGE);
    REFUSED(islet_fleet_copy(fleet, 0, fleet_worlds), ISLET_ERROR_OUT_OF_RANGE);
    REFUSED(islet_fleet_fork(fleet, NULL, fleet_worlds), ISLET_ERROR_NULL_POINTER);
    REFUSED(islet_fleet_fork(fleet, parents, fleet_worlds - 1), ISLET_ERROR_OUT_OF_RANGE);
    REFUSED(islet_fleet_fork(fleet, parents, fleet_worlds), ISLET_ERROR_OUT_OF_RANGE);
}

int refuse_fleet_calls(void) {
    const struct Yard yard = make_yard();
    refuse_creations(&yard);
    if (fleet == NULL) return result();
    const IsletFleetStep what = islet_default_fleet_step();
    CHECK(islet_fleet_step(fleet, &what) == ISLET_ERROR_NONE);  // so that no world is like the prototype
    remember_fleet();
    refuse_what_is_no_fleet(&yard);
    refuse_steps(&yard);
    refuse_the_rest(&yard);
    return result();
}
