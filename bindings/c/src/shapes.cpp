// Functions of islet.h: shapes.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

IsletShapeId islet_create_circle(IsletWorld* world, IsletBodyId body, const IsletCircle* circle, const IsletShapeDef* def) {
    if (world == nullptr) return out(ShapeId{});
    if (circle == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), out(ShapeId{});
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = def == nullptr ? take_default<ShapeDef>() : take<ShapeDef>(world, def, def_room);
    if (def_taken == nullptr) return out(ShapeId{});
    return out(of(world).create_shape(in<BodyId>(body), *cast<const Circle>(circle), *def_taken));
}

IsletShapeId islet_create_capsule(IsletWorld* world, IsletBodyId body, const IsletCapsule* capsule, const IsletShapeDef* def) {
    if (world == nullptr) return out(ShapeId{});
    if (capsule == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), out(ShapeId{});
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = def == nullptr ? take_default<ShapeDef>() : take<ShapeDef>(world, def, def_room);
    if (def_taken == nullptr) return out(ShapeId{});
    return out(of(world).create_shape(in<BodyId>(body), *cast<const Capsule>(capsule), *def_taken));
}

IsletShapeId islet_create_segment(IsletWorld* world, IsletBodyId body, const IsletSegment* segment, const IsletShapeDef* def) {
    if (world == nullptr) return out(ShapeId{});
    if (segment == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), out(ShapeId{});
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = def == nullptr ? take_default<ShapeDef>() : take<ShapeDef>(world, def, def_room);
    if (def_taken == nullptr) return out(ShapeId{});
    return out(of(world).create_shape(in<BodyId>(body), *cast<const Segment>(segment), *def_taken));
}

IsletShapeId islet_create_polygon(IsletWorld* world, IsletBodyId body, const IsletPolygon* polygon, const IsletShapeDef* def) {
    if (world == nullptr) return out(ShapeId{});
    if (polygon == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), out(ShapeId{});
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = def == nullptr ? take_default<ShapeDef>() : take<ShapeDef>(world, def, def_room);
    if (def_taken == nullptr) return out(ShapeId{});
    return out(of(world).create_shape(in<BodyId>(body), *cast<const Polygon>(polygon), *def_taken));
}

IsletShapeId islet_create_half_space(IsletWorld* world, IsletBodyId body, const IsletHalfSpace* half_space, const IsletShapeDef* def) {
    if (world == nullptr) return out(ShapeId{});
    if (half_space == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), out(ShapeId{});
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = def == nullptr ? take_default<ShapeDef>() : take<ShapeDef>(world, def, def_room);
    if (def_taken == nullptr) return out(ShapeId{});
    return out(of(world).create_shape(in<BodyId>(body), *cast<const HalfSpace>(half_space), *def_taken));
}

IsletError islet_destroy_shape(IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).destroy_shape(in<ShapeId>(shape));
    return end(world, before);
}

bool islet_shape_is_valid(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return false;
    return of(world).is_valid(in<ShapeId>(shape));
}

uint32_t islet_shape_contacts(const IsletWorld* world, IsletShapeId shape, IsletContactInfo* out, size_t out_count) {
    if (world == nullptr) return 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).contacts(in<ShapeId>(shape), span_of<ContactInfo>(out, out_count));
}

IsletBodyId islet_shape_body(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return out(BodyId{});
    return out(of(world).body(in<ShapeId>(shape)));
}

IsletShapeType islet_shape_type(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return out(ShapeType{});
    return out(of(world).shape_type(in<ShapeId>(shape)));
}

const IsletCircle* islet_shape_circle(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return nullptr;
    return cast<const IsletCircle>(of(world).circle(in<ShapeId>(shape)));
}

const IsletCapsule* islet_shape_capsule(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return nullptr;
    return cast<const IsletCapsule>(of(world).capsule(in<ShapeId>(shape)));
}

const IsletSegment* islet_shape_segment(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return nullptr;
    return cast<const IsletSegment>(of(world).segment(in<ShapeId>(shape)));
}

const IsletPolygon* islet_shape_polygon(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return nullptr;
    return cast<const IsletPolygon>(of(world).polygon(in<ShapeId>(shape)));
}

const IsletHalfSpace* islet_shape_half_space(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return nullptr;
    return cast<const IsletHalfSpace>(of(world).half_space(in<ShapeId>(shape)));
}

IsletError islet_shape_set_circle(IsletWorld* world, IsletShapeId shape, const IsletCircle* circle) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (circle == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_circle(in<ShapeId>(shape), *cast<const Circle>(circle));
    return end(world, before);
}

IsletError islet_shape_set_capsule(IsletWorld* world, IsletShapeId shape, const IsletCapsule* capsule) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (capsule == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_capsule(in<ShapeId>(shape), *cast<const Capsule>(capsule));
    return end(world, before);
}

IsletError islet_shape_set_segment(IsletWorld* world, IsletShapeId shape, const IsletSegment* segment) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (segment == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_segment(in<ShapeId>(shape), *cast<const Segment>(segment));
    return end(world, before);
}

IsletError islet_shape_set_polygon(IsletWorld* world, IsletShapeId shape, const IsletPolygon* polygon) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (polygon == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_polygon(in<ShapeId>(shape), *cast<const Polygon>(polygon));
    return end(world, before);
}

IsletError islet_shape_set_half_space(IsletWorld* world, IsletShapeId shape, const IsletHalfSpace* half_space) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (half_space == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_half_space(in<ShapeId>(shape), *cast<const HalfSpace>(half_space));
    return end(world, before);
}

float islet_shape_density(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return 0;
    return of(world).density(in<ShapeId>(shape));
}

IsletError islet_shape_set_density(IsletWorld* world, IsletShapeId shape, float density) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_density(in<ShapeId>(shape), density);
    return end(world, before);
}

IsletAabb islet_shape_aabb(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return out(Aabb{});
    return out(of(world).aabb(in<ShapeId>(shape)));
}

float islet_shape_friction(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return 0;
    return of(world).friction(in<ShapeId>(shape));
}

IsletError islet_shape_set_friction(IsletWorld* world, IsletShapeId shape, float friction) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_friction(in<ShapeId>(shape), friction);
    return end(world, before);
}

float islet_shape_restitution(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return 0;
    return of(world).restitution(in<ShapeId>(shape));
}

IsletError islet_shape_set_restitution(IsletWorld* world, IsletShapeId shape, float restitution) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_restitution(in<ShapeId>(shape), restitution);
    return end(world, before);
}

float islet_shape_rolling_resistance(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return 0;
    return of(world).rolling_resistance(in<ShapeId>(shape));
}

IsletError islet_shape_set_rolling_resistance(IsletWorld* world, IsletShapeId shape, float resistance) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_rolling_resistance(in<ShapeId>(shape), resistance);
    return end(world, before);
}

float islet_shape_tangent_speed(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return 0;
    return of(world).tangent_speed(in<ShapeId>(shape));
}

IsletError islet_shape_set_tangent_speed(IsletWorld* world, IsletShapeId shape, float speed) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_tangent_speed(in<ShapeId>(shape), speed);
    return end(world, before);
}

IsletSurfaceMaterial islet_shape_material(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return out(SurfaceMaterial{});
    return out(of(world).material(in<ShapeId>(shape)));
}

IsletError islet_shape_set_material(IsletWorld* world, IsletShapeId shape, const IsletSurfaceMaterial* material) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (material == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_material(in<ShapeId>(shape), *cast<const SurfaceMaterial>(material));
    return end(world, before);
}

bool islet_shape_is_sensor(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return false;
    return of(world).is_sensor(in<ShapeId>(shape));
}

IsletError islet_shape_set_sensor(IsletWorld* world, IsletShapeId shape, bool sensor) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_sensor(in<ShapeId>(shape), sensor);
    return end(world, before);
}

uint32_t islet_shape_sensor_overlaps(const IsletWorld* world, IsletShapeId sensor, IsletShapeId* out, size_t out_count) {
    if (world == nullptr) return 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).sensor_overlaps(in<ShapeId>(sensor), span_of<ShapeId>(out, out_count));
}

bool islet_shape_sensor_events_enabled(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return false;
    return of(world).sensor_events_enabled(in<ShapeId>(shape));
}

IsletError islet_shape_enable_sensor_events(IsletWorld* world, IsletShapeId shape, bool enable) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).enable_sensor_events(in<ShapeId>(shape), enable);
    return end(world, before);
}

bool islet_shape_hit_events_enabled(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return false;
    return of(world).hit_events_enabled(in<ShapeId>(shape));
}

IsletError islet_shape_enable_hit_events(IsletWorld* world, IsletShapeId shape, bool enable) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).enable_hit_events(in<ShapeId>(shape), enable);
    return end(world, before);
}

bool islet_shape_pre_solve_enabled(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return false;
    return of(world).pre_solve_enabled(in<ShapeId>(shape));
}

IsletError islet_shape_enable_pre_solve(IsletWorld* world, IsletShapeId shape, bool enable) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).enable_pre_solve(in<ShapeId>(shape), enable);
    return end(world, before);
}

IsletVec2 islet_shape_one_way(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).one_way(in<ShapeId>(shape)));
}

IsletError islet_shape_set_one_way(IsletWorld* world, IsletShapeId shape, IsletVec2 direction) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_one_way(in<ShapeId>(shape), in<Vec2>(direction));
    return end(world, before);
}

IsletError islet_shape_apply_wind(IsletWorld* world, IsletShapeId shape, const IsletWindDef* wind) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    Room<WindDef> wind_room;
    const WindDef* wind_taken = take<WindDef>(world, wind, wind_room);
    if (wind_taken == nullptr) return why(wind);
    const Error before = begin(world);
    of(world).apply_wind(in<ShapeId>(shape), *wind_taken);
    return end(world, before);
}

IsletFilter islet_shape_filter(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return out(Filter{});
    return out(of(world).filter(in<ShapeId>(shape)));
}

IsletError islet_shape_set_filter(IsletWorld* world, IsletShapeId shape, const IsletFilter* filter) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (filter == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_filter(in<ShapeId>(shape), *cast<const Filter>(filter));
    return end(world, before);
}

uint64_t islet_shape_user_data(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return 0;
    return of(world).user_data(in<ShapeId>(shape));
}

IsletError islet_shape_set_user_data(IsletWorld* world, IsletShapeId shape, uint64_t data) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_user_data(in<ShapeId>(shape), data);
    return end(world, before);
}

}  // extern "C"
