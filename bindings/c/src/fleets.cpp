// Functions of islet.h: fleets.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

uint32_t islet_sense_columns(const IsletSense* senses, size_t senses_count) {
    uint32_t found = {};
    if (is_there(nullptr, senses, senses_count)) found = islet::columns(span_of<const Sense>(senses, senses_count));
    return found;
}

}  // extern "C"
