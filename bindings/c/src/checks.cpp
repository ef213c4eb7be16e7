// Functions of islet.h: checks.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

uint64_t islet_world_hash(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).hash();
}

const char* islet_world_validate(const IsletWorld* world) {
    if (world == nullptr) return nullptr;
    return of(world).validate();
}

}  // extern "C"
