// Functions written by hand: on plain values.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

const char* islet_describe(IsletError error) {
    if (error == ISLET_ERROR_NULL_POINTER) return "A pointer that must not be null is: check what the call was given, the world among it.";
    if (error == ISLET_ERROR_STRUCT_SIZE)
        return "A struct has no size that this version of Islet knows: start from its islet_default_..., which sets struct_size.";
    if (error == ISLET_ERROR_NOT_A_FLEET) return "The pointer points to no fleet: take the one that islet_create_fleet returned, and do not move its memory.";
    return islet::describe(in<Error>(error));
}

IsletSeparation islet_separation(const IsletShapeProxy* a, const IsletShapeProxy* b) {
    static constexpr ShapeProxy none = {};
    return out(islet::separation(a == nullptr ? none : *cast<const ShapeProxy>(a), b == nullptr ? none : *cast<const ShapeProxy>(b)));
}

bool islet_format_is_readable(const IsletFormatInfo* info) {
    Room<FormatInfo> room;
    const FormatInfo* taken = take<FormatInfo>(nullptr, info, room);
    return taken != nullptr && taken->is_readable();
}

}  // extern "C"
