// Functions of islet.h: drawing.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

IsletDrawColor islet_distinct_color(uint32_t n) {
    return islet::distinct_color(n);
}

void islet_draw_circle(const IsletDebugDraw* draw, const IsletCircle* circle, IsletTransform pose, const IsletDrawStyle* style) {
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = nullptr;
    if ((draw_taken = take<DebugDraw>(nullptr, draw, draw_room)) != nullptr && is_there(nullptr, circle) && is_there(nullptr, style))
        islet::draw_shape(Drawing(*draw_taken).functions, *cast<const Circle>(circle), in<Transform>(pose), *cast<const DrawStyle>(style));
}

void islet_draw_capsule(const IsletDebugDraw* draw, const IsletCapsule* capsule, IsletTransform pose, const IsletDrawStyle* style) {
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = nullptr;
    if ((draw_taken = take<DebugDraw>(nullptr, draw, draw_room)) != nullptr && is_there(nullptr, capsule) && is_there(nullptr, style))
        islet::draw_shape(Drawing(*draw_taken).functions, *cast<const Capsule>(capsule), in<Transform>(pose), *cast<const DrawStyle>(style));
}

void islet_draw_segment(const IsletDebugDraw* draw, const IsletSegment* segment, IsletTransform pose, const IsletDrawStyle* style) {
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = nullptr;
    if ((draw_taken = take<DebugDraw>(nullptr, draw, draw_room)) != nullptr && is_there(nullptr, segment) && is_there(nullptr, style))
        islet::draw_shape(Drawing(*draw_taken).functions, *cast<const Segment>(segment), in<Transform>(pose), *cast<const DrawStyle>(style));
}

void islet_draw_polygon(const IsletDebugDraw* draw, const IsletPolygon* polygon, IsletTransform pose, const IsletDrawStyle* style) {
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = nullptr;
    if ((draw_taken = take<DebugDraw>(nullptr, draw, draw_room)) != nullptr && is_there(nullptr, polygon) && is_there(nullptr, style))
        islet::draw_shape(Drawing(*draw_taken).functions, *cast<const Polygon>(polygon), in<Transform>(pose), *cast<const DrawStyle>(style));
}

void islet_world_draw(const IsletWorld* world, const IsletDebugDraw* draw) {
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = nullptr;
    if ((draw_taken = take<DebugDraw>(world, draw, draw_room)) != nullptr) of(world).draw(Drawing(*draw_taken).functions);
}

void islet_world_draw_shape(const IsletWorld* world, const IsletDebugDraw* draw, IsletShapeId shape, IsletTransform pose, const IsletDrawStyle* style) {
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = nullptr;
    if ((draw_taken = take<DebugDraw>(world, draw, draw_room)) != nullptr && is_there(world, style))
        of(world).draw_shape(Drawing(*draw_taken).functions, in<ShapeId>(shape), in<Transform>(pose), *cast<const DrawStyle>(style));
}

}  // extern "C"
