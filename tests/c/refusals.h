// For refusals.c: a world with a body in it, and calls that must leave it as it is.
#ifndef ISLET_TESTS_C_REFUSALS_H
#define ISLET_TESTS_C_REFUSALS_H

#include <islet/islet.h>

#include "check.h"

static _Alignas(ISLET_WORLD_ALIGNMENT) char block[200000];
static uint64_t hash_before;
static unsigned told;

static void count_error(IsletError error, void* context) {
    (void)error;
    (void)context;
    ++told;
}

static IsletWorld* make_world(void) {
    IsletCapacity capacity = islet_default_capacity();
    capacity.bodies = capacity.shapes = capacity.contacts = capacity.joints = 8;
    IsletWorldDef def = islet_default_world_def();
    def.error_hook = count_error;
    IsletWorld* world = islet_create_world(block, sizeof block, &capacity, &def, NULL);
    IsletBodyDef body = islet_default_body_def();
    islet_create_body(world, &body);
    hash_before = islet_world_hash(world);
    return world;
}

// A function that returns its error.
#define CODE(call, error)                              \
    do {                                               \
        CHECK((call) == (error));                      \
        CHECK(islet_world_hash(world) == hash_before); \
    } while (0)

// A function that returns something else: the world knows the error, and the hook is told once.
#define LAST(call, error)                                \
    do {                                                 \
        islet_world_clear_error(world);                  \
        const unsigned before = told;                    \
        (void)(call);                                    \
        CHECK(islet_world_last_error(world) == (error)); \
        CHECK(told == before + 1);                       \
        CHECK(islet_world_hash(world) == hash_before);   \
    } while (0)

// A function that has no world: it does nothing.
#define CALL(call) (void)(call)

#endif
