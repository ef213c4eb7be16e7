// Functions of islet.h: mover.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

bool islet_step_mover(IsletWorld* world, const IsletMoverDef* def, IsletMoverState* state, const IsletMoverInput* input, float dt) {
    if (world == nullptr) return false;
    Room<MoverDef> def_room;
    const MoverDef* def_taken = take<MoverDef>(world, def, def_room);
    if (def_taken == nullptr) return false;
    if (state == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), false;
    Room<MoverInput> input_room;
    const MoverInput* input_taken = take<MoverInput>(world, input, input_room);
    if (input_taken == nullptr) return false;
    return islet::step_mover(of(world), *def_taken, *cast<MoverState>(state), *input_taken, dt);
}

}  // extern "C"
