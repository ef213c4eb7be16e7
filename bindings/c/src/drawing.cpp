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
    const DebugDraw* draw_taken = take<DebugDraw>(nullptr, draw, draw_room);
    if (draw_taken == nullptr) return;
    const Drawing drawing(*draw_taken);
    if (circle == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), void();
    if (style == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), void();
    islet::draw_shape(drawing.functions, *cast<const Circle>(circle), in<Transform>(pose), *cast<const DrawStyle>(style));
}

void islet_draw_capsule(const IsletDebugDraw* draw, const IsletCapsule* capsule, IsletTransform pose, const IsletDrawStyle* style) {
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = take<DebugDraw>(nullptr, draw, draw_room);
    if (draw_taken == nullptr) return;
    const Drawing drawing(*draw_taken);
    if (capsule == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), void();
    if (style == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), void();
    islet::draw_shape(drawing.functions, *cast<const Capsule>(capsule), in<Transform>(pose), *cast<const DrawStyle>(style));
}

void islet_draw_segment(const IsletDebugDraw* draw, const IsletSegment* segment, IsletTransform pose, const IsletDrawStyle* style) {
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = take<DebugDraw>(nullptr, draw, draw_room);
    if (draw_taken == nullptr) return;
    const Drawing drawing(*draw_taken);
    if (segment == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), void();
    if (style == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), void();
    islet::draw_shape(drawing.functions, *cast<const Segment>(segment), in<Transform>(pose), *cast<const DrawStyle>(style));
}

void islet_draw_polygon(const IsletDebugDraw* draw, const IsletPolygon* polygon, IsletTransform pose, const IsletDrawStyle* style) {
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = take<DebugDraw>(nullptr, draw, draw_room);
    if (draw_taken == nullptr) return;
    const Drawing drawing(*draw_taken);
    if (polygon == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), void();
    if (style == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), void();
    islet::draw_shape(drawing.functions, *cast<const Polygon>(polygon), in<Transform>(pose), *cast<const DrawStyle>(style));
}

void islet_world_draw(const IsletWorld* world, const IsletDebugDraw* draw) {
    if (world == nullptr) return;
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = take<DebugDraw>(world, draw, draw_room);
    if (draw_taken == nullptr) return;
    const Drawing drawing(*draw_taken);
    of(world).draw(drawing.functions);
}

void islet_world_draw_shape(const IsletWorld* world, const IsletDebugDraw* draw, IsletShapeId shape, IsletTransform pose, const IsletDrawStyle* style) {
    if (world == nullptr) return;
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = take<DebugDraw>(world, draw, draw_room);
    if (draw_taken == nullptr) return;
    const Drawing drawing(*draw_taken);
    if (style == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), void();
    of(world).draw_shape(drawing.functions, in<ShapeId>(shape), in<Transform>(pose), *cast<const DrawStyle>(style));
}

}  // extern "C"
