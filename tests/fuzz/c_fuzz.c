// The C interface, called by a fuzzer. Each input is a list of calls of any of its functions, on one small world or on none: good and bad values, ids of
// the living, the dead and the never born, null pointers, structs of wrong sizes, buffers of any length. make_c_calls.py writes the calls.
//
// A call that returns an error must change nothing, and at the end of each input the world must be sound; sanitizers find the rest. What is right in C++ is
// not asked again: islet_fuzz_api does that.
#include <islet/islet.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Input {
    const uint8_t* at;
    const uint8_t* end;
} Input;

static uint8_t take_byte(Input* in) { return in->at < in->end ? *in->at++ : 1; }
static bool take_flag(Input* in) { return (take_byte(in) & 1) != 0; }

/// Mostly few.
static uint32_t take_count(Input* in) {
    const uint8_t kind = take_byte(in);
    if (kind < 200) return kind % 20;
    uint32_t n = 0;
    for (int i = 0; i < 4; ++i) n = n << 8 | take_byte(in);
    return kind < 250 ? n % 70000 : n;
}

/// Mostly of a game; now and then anything.
static float take_float(Input* in) {
    const uint8_t kind = take_byte(in);
    if (kind < 240) return (float)((int)kind - 120) * 0.1f;
    uint32_t bits = 0;
    for (int i = 0; i < 4; ++i) bits = bits << 8 | take_byte(in);
    float f;
    memcpy(&f, &bits, 4);
    return f;
}

#define KNOWN 32  // ids that are remembered
static IsletBodyId body_ids[KNOWN];
static IsletShapeId shape_ids[KNOWN];
static IsletJointId joint_ids[KNOWN];
static unsigned body_count, shape_count, joint_count;

#define IDS(Type, kind)                                                             \
    static Type take_##kind(Input* in) {                                            \
        Type id = {0, 0};                                                           \
        const uint8_t which = take_byte(in);                                        \
        if (which < 240) return kind##_count != 0 ? kind##_ids[which % KNOWN] : id; \
        if (which < 250)                                                            \
            id.index1 = take_byte(in) % 20, id.generation = take_byte(in) % 4;      \
        else                                                                        \
            id.index1 = take_count(in), id.generation = take_count(in);             \
        return id;                                                                  \
    }                                                                               \
    static void keep_##kind(Type id) {                                              \
        if (id.index1 != 0) kind##_ids[kind##_count++ % KNOWN] = id;                \
    }
IDS(IsletBodyId, body)
IDS(IsletShapeId, shape)
IDS(IsletJointId, joint)

/// Buffers for images and the like, and two for recordings, which belong to the world while it records.
static _Alignas(16) uint8_t areas[4][1 << 15], tapes[2][1 << 15];
static unsigned tape_count;
static uint8_t* tape(Input* in) { return tapes[take_byte(in) == 255 ? tape_count % 2 : ++tape_count % 2]; }

/// Reads every byte that a call has given back.
static void look(const void* data, size_t bytes) {
    for (size_t i = 0; i < bytes; ++i) (void)((const volatile uint8_t*)data)[i];
}

static void run_tasks(void* context, uint32_t count, void (*task)(void* data, uint32_t index), void* data) {
    (void)context;
    for (uint32_t i = count; i-- > 0;) task(data, i);
}

#include "c_calls.inc.h"

static void broken(const char* what) {
    fprintf(stderr, "islet_fuzz_c: %s\n", what);
    abort();
}

static IsletWorld* make_world(void) {
    static _Alignas(ISLET_WORLD_ALIGNMENT) uint8_t block[1 << 18];
    IsletCapacity capacity = islet_default_capacity();
    capacity.bodies = capacity.shapes = capacity.joints = 16;
    capacity.contacts = 32;
    IsletError error = ISLET_ERROR_NONE;
    IsletWorld* world = islet_create_world(block, sizeof block, &capacity, NULL, &error);
    if (world == NULL) broken(islet_describe(error));
    body_count = shape_count = joint_count = 0;
    memset(body_ids, 0, sizeof body_ids);
    memset(shape_ids, 0, sizeof shape_ids);
    memset(joint_ids, 0, sizeof joint_ids);
    // Something to begin with, so that short inputs reach contacts and joints too.
    for (int i = 0; i < 4; ++i) {
        IsletBodyDef def = islet_default_body_def();
        def.type = i == 0 ? ISLET_BODY_TYPE_STATIC_BODY : ISLET_BODY_TYPE_DYNAMIC;
        def.position.y = (float)i - 0.5f;
        const IsletPolygon box = islet_make_box(i == 0 ? 9.0f : 0.5f, 0.5f);
        keep_body(islet_create_body(world, &def));
        keep_shape(islet_create_polygon(world, body_ids[i], &box, NULL));
    }
    IsletRevoluteJointDef hinge = islet_default_revolute_joint_def();
    hinge.base.body_a = body_ids[2];
    hinge.base.body_b = body_ids[3];
    hinge.base.frame_b.position.y = -1;
    keep_joint(islet_create_revolute_joint(world, &hinge));
    return world;
}

/// Whether a call that returns this code may have had an effect: a step that is short of room still steps, and what a full recording or a full list of events
/// cannot hold was done all the same.
static bool may_change(IsletError error) {
    return error == ISLET_ERROR_NONE || error == ISLET_ERROR_CONTACTS_FULL || error == ISLET_ERROR_EVENTS_FULL || error == ISLET_ERROR_HITS_FULL ||
           error == ISLET_ERROR_RECORDING_FULL;
}

static uint64_t hash_of_fleet(IsletFleet* fleet) {
    uint64_t sum = 0;
    for (uint32_t k = 0; k < islet_fleet_size(fleet); ++k) sum = sum * 31 + islet_world_hash(islet_fleet_world(fleet, k));
    return sum;
}

/// Mostly the right number.
static size_t size_near(Input* in, size_t right) { return take_byte(in) > 20 ? right : take_count(in) % 33; }

/// A fleet of copies of the world, and some calls on it.
static void use_fleet(Input* in, const IsletWorld* world) {
    static _Alignas(ISLET_WORLD_ALIGNMENT) uint8_t block[1 << 19];
    static float actions[32], observations[32];
    static uint8_t mask[33];
    static uint32_t parents[33];
    IsletDrive drives[3];
    IsletSense senses[3];
    IsletVariation variation;
    const uint32_t worlds = 1 + take_byte(in) % 4;
    IsletError error = ISLET_ERROR_NONE;
    IsletFleet* fleet = islet_create_fleet(block, sizeof block, world, worlds, NULL, &error);
    if (fleet == NULL) {
        if (error == ISLET_ERROR_NONE) broken("no fleet, and no error");
        return;
    }
    for (int made = 0; made < 6 && in->at < in->end; ++made) {
        const uint32_t k = take_byte(in) % (worlds + 1);
        for (int i = 0; i < 3; ++i) fill_drive(in, &drives[i]);
        for (int i = 0; i < 3; ++i) fill_sense(in, &senses[i]);
        fill_variation(in, &variation);
        for (int i = 0; i < 12; ++i) actions[i] = take_float(in);
        for (uint32_t i = 0; i < worlds; ++i) mask[i] = take_byte(in) & 1, parents[i] = take_byte(in) % (worlds + 1);
        const uint64_t before = hash_of_fleet(fleet);
        const size_t seen = size_near(in, worlds * (size_t)islet_sense_columns(senses, 3));
        IsletFleetStep what = islet_default_fleet_step();
        switch (take_byte(in) % 5) {
        case 0:
            what.repeat = take_byte(in) % 4;
            what.drives = drives;
            what.drives_count = 3;
            what.actions = actions;
            what.actions_count = size_near(in, 3 * worlds);
            what.senses = senses;
            what.senses_count = 3;
            what.observations = observations;
            what.observations_count = seen < 32 ? seen : 32;
            what.mask = mask;
            what.mask_count = take_flag(in) ? size_near(in, worlds) : 0;
            error = islet_fleet_step(fleet, &what);
            break;
        case 1: error = islet_fleet_observe(fleet, senses, 3, take_byte(in) == 0 ? NULL : observations, seen < 32 ? seen : 32, NULL, 0); break;
        case 2: error = islet_fleet_reset(fleet, k, areas[0], take_flag(in) ? islet_world_save(world, areas[0], sizeof areas[0]) : take_count(in) % sizeof areas[0], k, &variation, 1); break;
        case 3: error = islet_fleet_copy(fleet, k, take_byte(in) % (worlds + 1)); break;
        default: error = islet_fleet_fork(fleet, parents, size_near(in, worlds)); break;
        }
        if (error != ISLET_ERROR_NONE && hash_of_fleet(fleet) != before) broken("a call that was refused has changed the fleet");
    }
    for (uint32_t k = 0; k < worlds; ++k) {
        const char* fault = islet_world_validate(islet_fleet_world(fleet, k));
        if (fault != NULL) broken(fault);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    Input in = {data, data + size};
    IsletWorld* world = make_world();
    const unsigned count = sizeof calls / sizeof *calls;
    for (int made = 0; made < 100 && in.at < in.end; ++made) {
        const unsigned which = (unsigned)take_byte(&in) << 8 | take_byte(&in);
        const bool none = take_byte(&in) == 255;
        if (which >= 60000) {
            islet_world_step(world, 1.0f / 60);
            continue;
        }
        const uint64_t before = islet_world_hash(world);
        if (which >= 59000) {
            use_fleet(&in, world);
            if (islet_world_hash(world) != before) broken("a fleet has changed its prototype");
            continue;
        }
        const IsletError error = calls[which % count](&in, none ? NULL : world);
        if (none && error != ISLET_ERROR_NONE && error != ISLET_ERROR_NULL_POINTER) broken("a call without a world was not told so");
        if (!may_change(error) && islet_world_hash(world) != before) broken("a call that was refused has changed the world");
    }
    const char* fault = islet_world_validate(world);
    if (fault != NULL) broken(fault);
    return 0;
}
