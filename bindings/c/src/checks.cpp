// Functions of islet.h: checks.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

uint64_t islet_world_hash(const IsletWorld* world) {
    uint64_t found = {};
    if (world != nullptr) found = of(world).hash();
    return found;
}

const char* islet_world_validate(const IsletWorld* world) {
    const char* found = {};
    if (world != nullptr) found = of(world).validate();
    return found;
}

}  // extern "C"
