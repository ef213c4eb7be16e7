// Functions written by hand: which field of a world's definition breaks its rules.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

IsletFieldFault islet_find_world_def_fault(const IsletWorldDef* given) {
    int refused = ISLET_ERROR_NONE;
    const WorldDef def = world_def_of(given, refused);
    if (given == nullptr || refused != ISLET_ERROR_NONE) return {why(given), nullptr};
    return out(islet::find_fault(def));
}

}  // extern "C"
