// Functions of islet.h: chains.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

bool islet_chain_segment_is_valid(const IsletChainSegment* s) {
    bool found = {};
    if (is_there(nullptr, s)) found = islet::is_valid(*cast<const ChainSegment>(s));
    return found;
}

IsletShapeProxy islet_make_chain_segment_proxy(const IsletChainSegment* segment) {
    IsletShapeProxy found = {};
    if (is_there(nullptr, segment)) new (&found) ShapeProxy(islet::make_proxy(*cast<const ChainSegment>(segment)));
    return found;
}

IsletShapeId islet_create_chain_segment(IsletWorld* world, IsletBodyId body, const IsletChainSegment* segment, const IsletShapeDef* def) {
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = nullptr;
    IsletShapeId found = {};
    if ((def_taken = take_with<ShapeDef>(world, segment, def, def_room)) != nullptr)
        new (&found) ShapeId(of(world).create_shape(in<BodyId>(body), *cast<const ChainSegment>(segment), *def_taken));
    return found;
}

uint32_t islet_create_chain(IsletWorld* world, IsletBodyId body, const IsletVec2* points, size_t points_count, bool loop, const IsletShapeDef* def,
    IsletShapeId* out, size_t out_count) {
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = nullptr;
    uint32_t found = {};
    if (world != nullptr &&
        is_there(world, points, points_count) &&
        (def_taken = take_or_default<ShapeDef>(world, def, def_room)) != nullptr &&
        is_there(world, out, out_count))
        found = of(world).create_chain(in<BodyId>(body), span_of<const Vec2>(points, points_count), loop, *def_taken, span_of<ShapeId>(out, out_count));
    return found;
}

const IsletChainSegment* islet_shape_chain_segment(const IsletWorld* world, IsletShapeId shape) {
    const ChainSegment* found = nullptr;
    if (world != nullptr) found = of(world).chain_segment(in<ShapeId>(shape));
    return cast<const IsletChainSegment>(found);
}

IsletError islet_shape_set_chain_segment(IsletWorld* world, IsletShapeId shape, const IsletChainSegment* segment) {
    if (begin(world) && is_there(world, segment)) of(world).set_chain_segment(in<ShapeId>(shape), *cast<const ChainSegment>(segment));
    return end(world);
}

}  // extern "C"
