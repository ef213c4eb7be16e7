// Functions of islet.h: mover.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

bool islet_step_mover(IsletWorld* world, const IsletMoverDef* def, IsletMoverState* state, const IsletMoverInput* input, float dt) {
    Room<MoverDef> def_room;
    const MoverDef* def_taken = nullptr;
    Room<MoverInput> input_room;
    const MoverInput* input_taken = nullptr;
    bool found = {};
    if ((def_taken = take<MoverDef>(world, def, def_room)) != nullptr &&
        is_there(world, state) &&
        (input_taken = take<MoverInput>(world, input, input_room)) != nullptr)
        found = islet::step_mover(of(world), *def_taken, *cast<MoverState>(state), *input_taken, dt);
    return found;
}

}  // extern "C"
