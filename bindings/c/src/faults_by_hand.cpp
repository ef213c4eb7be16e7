// Functions written by hand: which field of a world's definition breaks its rules.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

IsletFieldFault islet_find_world_def_fault(const IsletWorldDef* given) {
    WorldDef def;
    if (given == nullptr || !take_world_def(given, def)) return {why(given), nullptr};
    return out(islet::find_fault(def));
}

}  // extern "C"
