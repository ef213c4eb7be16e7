// Functions of islet.h: chains.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

bool islet_chain_segment_is_valid(const IsletChainSegment* s) {
    if (s == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), false;
    return islet::is_valid(*cast<const ChainSegment>(s));
}

IsletShapeProxy islet_make_chain_segment_proxy(const IsletChainSegment* segment) {
    if (segment == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(ShapeProxy{});
    return out(islet::make_proxy(*cast<const ChainSegment>(segment)));
}

IsletShapeId islet_create_chain_segment(IsletWorld* world, IsletBodyId body, const IsletChainSegment* segment, const IsletShapeDef* def) {
    if (world == nullptr) return out(ShapeId{});
    if (segment == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), out(ShapeId{});
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = def == nullptr ? take_default<ShapeDef>() : take<ShapeDef>(world, def, def_room);
    if (def_taken == nullptr) return out(ShapeId{});
    return out(of(world).create_shape(in<BodyId>(body), *cast<const ChainSegment>(segment), *def_taken));
}

uint32_t islet_create_chain(IsletWorld* world, IsletBodyId body, const IsletVec2* points, size_t points_count, bool loop, const IsletShapeDef* def,
    IsletShapeId* out, size_t out_count) {
    if (world == nullptr) return 0;
    if (points == nullptr && points_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = def == nullptr ? take_default<ShapeDef>() : take<ShapeDef>(world, def, def_room);
    if (def_taken == nullptr) return 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).create_chain(in<BodyId>(body), span_of<const Vec2>(points, points_count), loop, *def_taken, span_of<ShapeId>(out, out_count));
}

const IsletChainSegment* islet_shape_chain_segment(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return nullptr;
    return cast<const IsletChainSegment>(of(world).chain_segment(in<ShapeId>(shape)));
}

IsletError islet_shape_set_chain_segment(IsletWorld* world, IsletShapeId shape, const IsletChainSegment* segment) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (segment == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_chain_segment(in<ShapeId>(shape), *cast<const ChainSegment>(segment));
    return end(world, before);
}

}  // extern "C"
