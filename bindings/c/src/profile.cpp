// Functions of islet.h: profile.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

IsletError islet_world_profile(const IsletWorld* world, IsletStepProfile* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<StepProfile>(world, out)) return why(out);
    give<StepProfile>(out, of(world).profile());
    return ISLET_ERROR_NONE;
}

IsletError islet_world_set_clock(IsletWorld* world, IsletClock clock, void* context) {
    if (begin(world)) of(world).set_clock(function<Clock>(clock), context);
    return end(world);
}

}  // extern "C"
