// Functions of islet.h: shapes.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

IsletShapeId islet_create_circle(IsletWorld* world, IsletBodyId body, const IsletCircle* circle, const IsletShapeDef* def) {
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = nullptr;
    IsletShapeId found = {};
    if ((def_taken = take_with<ShapeDef>(world, circle, def, def_room)) != nullptr)
        new (&found) ShapeId(of(world).create_shape(in<BodyId>(body), *cast<const Circle>(circle), *def_taken));
    return found;
}

IsletShapeId islet_create_capsule(IsletWorld* world, IsletBodyId body, const IsletCapsule* capsule, const IsletShapeDef* def) {
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = nullptr;
    IsletShapeId found = {};
    if ((def_taken = take_with<ShapeDef>(world, capsule, def, def_room)) != nullptr)
        new (&found) ShapeId(of(world).create_shape(in<BodyId>(body), *cast<const Capsule>(capsule), *def_taken));
    return found;
}

IsletShapeId islet_create_segment(IsletWorld* world, IsletBodyId body, const IsletSegment* segment, const IsletShapeDef* def) {
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = nullptr;
    IsletShapeId found = {};
    if ((def_taken = take_with<ShapeDef>(world, segment, def, def_room)) != nullptr)
        new (&found) ShapeId(of(world).create_shape(in<BodyId>(body), *cast<const Segment>(segment), *def_taken));
    return found;
}

IsletShapeId islet_create_polygon(IsletWorld* world, IsletBodyId body, const IsletPolygon* polygon, const IsletShapeDef* def) {
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = nullptr;
    IsletShapeId found = {};
    if ((def_taken = take_with<ShapeDef>(world, polygon, def, def_room)) != nullptr)
        new (&found) ShapeId(of(world).create_shape(in<BodyId>(body), *cast<const Polygon>(polygon), *def_taken));
    return found;
}

IsletShapeId islet_create_half_space(IsletWorld* world, IsletBodyId body, const IsletHalfSpace* half_space, const IsletShapeDef* def) {
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = nullptr;
    IsletShapeId found = {};
    if ((def_taken = take_with<ShapeDef>(world, half_space, def, def_room)) != nullptr)
        new (&found) ShapeId(of(world).create_shape(in<BodyId>(body), *cast<const HalfSpace>(half_space), *def_taken));
    return found;
}

IsletError islet_destroy_shape(IsletWorld* world, IsletShapeId shape) {
    if (begin(world)) of(world).destroy_shape(in<ShapeId>(shape));
    return end(world);
}

bool islet_shape_is_valid(const IsletWorld* world, IsletShapeId shape) {
    bool found = {};
    if (world != nullptr) found = of(world).is_valid(in<ShapeId>(shape));
    return found;
}

uint32_t islet_shape_contacts(const IsletWorld* world, IsletShapeId shape, IsletContactInfo* out, size_t out_count) {
    uint32_t found = {};
    if (world != nullptr && is_there(world, out, out_count)) found = of(world).contacts(in<ShapeId>(shape), span_of<ContactInfo>(out, out_count));
    return found;
}

uint32_t islet_shape_next_contact(const IsletWorld* world, IsletShapeId shape, uint32_t contact, IsletContactInfo* out) {
    uint32_t found = {};
    if (world != nullptr && is_there(world, out)) found = of(world).next_contact(in<ShapeId>(shape), contact, *cast<ContactInfo>(out));
    return found;
}

IsletBodyId islet_shape_body(const IsletWorld* world, IsletShapeId shape) {
    IsletBodyId found = {};
    if (world != nullptr) new (&found) BodyId(of(world).body(in<ShapeId>(shape)));
    return found;
}

IsletShapeType islet_shape_type(const IsletWorld* world, IsletShapeId shape) {
    ShapeType found = {};
    if (world != nullptr) found = of(world).shape_type(in<ShapeId>(shape));
    return out(found);
}

const IsletCircle* islet_shape_circle(const IsletWorld* world, IsletShapeId shape) {
    const Circle* found = nullptr;
    if (world != nullptr) found = of(world).circle(in<ShapeId>(shape));
    return cast<const IsletCircle>(found);
}

const IsletCapsule* islet_shape_capsule(const IsletWorld* world, IsletShapeId shape) {
    const Capsule* found = nullptr;
    if (world != nullptr) found = of(world).capsule(in<ShapeId>(shape));
    return cast<const IsletCapsule>(found);
}

const IsletSegment* islet_shape_segment(const IsletWorld* world, IsletShapeId shape) {
    const Segment* found = nullptr;
    if (world != nullptr) found = of(world).segment(in<ShapeId>(shape));
    return cast<const IsletSegment>(found);
}

const IsletPolygon* islet_shape_polygon(const IsletWorld* world, IsletShapeId shape) {
    const Polygon* found = nullptr;
    if (world != nullptr) found = of(world).polygon(in<ShapeId>(shape));
    return cast<const IsletPolygon>(found);
}

const IsletHalfSpace* islet_shape_half_space(const IsletWorld* world, IsletShapeId shape) {
    const HalfSpace* found = nullptr;
    if (world != nullptr) found = of(world).half_space(in<ShapeId>(shape));
    return cast<const IsletHalfSpace>(found);
}

IsletError islet_shape_set_circle(IsletWorld* world, IsletShapeId shape, const IsletCircle* circle) {
    if (begin(world) && is_there(world, circle)) of(world).set_circle(in<ShapeId>(shape), *cast<const Circle>(circle));
    return end(world);
}

IsletError islet_shape_set_capsule(IsletWorld* world, IsletShapeId shape, const IsletCapsule* capsule) {
    if (begin(world) && is_there(world, capsule)) of(world).set_capsule(in<ShapeId>(shape), *cast<const Capsule>(capsule));
    return end(world);
}

IsletError islet_shape_set_segment(IsletWorld* world, IsletShapeId shape, const IsletSegment* segment) {
    if (begin(world) && is_there(world, segment)) of(world).set_segment(in<ShapeId>(shape), *cast<const Segment>(segment));
    return end(world);
}

IsletError islet_shape_set_polygon(IsletWorld* world, IsletShapeId shape, const IsletPolygon* polygon) {
    if (begin(world) && is_there(world, polygon)) of(world).set_polygon(in<ShapeId>(shape), *cast<const Polygon>(polygon));
    return end(world);
}

IsletError islet_shape_set_half_space(IsletWorld* world, IsletShapeId shape, const IsletHalfSpace* half_space) {
    if (begin(world) && is_there(world, half_space)) of(world).set_half_space(in<ShapeId>(shape), *cast<const HalfSpace>(half_space));
    return end(world);
}

float islet_shape_density(const IsletWorld* world, IsletShapeId shape) {
    float found = {};
    if (world != nullptr) found = of(world).density(in<ShapeId>(shape));
    return found;
}

IsletError islet_shape_set_density(IsletWorld* world, IsletShapeId shape, float density) {
    if (begin(world)) of(world).set_density(in<ShapeId>(shape), density);
    return end(world);
}

IsletAabb islet_shape_aabb(const IsletWorld* world, IsletShapeId shape) {
    Aabb found = {};
    if (world != nullptr) found = of(world).aabb(in<ShapeId>(shape));
    return out(found);
}

float islet_shape_friction(const IsletWorld* world, IsletShapeId shape) {
    float found = {};
    if (world != nullptr) found = of(world).friction(in<ShapeId>(shape));
    return found;
}

IsletError islet_shape_set_friction(IsletWorld* world, IsletShapeId shape, float friction) {
    if (begin(world)) of(world).set_friction(in<ShapeId>(shape), friction);
    return end(world);
}

float islet_shape_restitution(const IsletWorld* world, IsletShapeId shape) {
    float found = {};
    if (world != nullptr) found = of(world).restitution(in<ShapeId>(shape));
    return found;
}

IsletError islet_shape_set_restitution(IsletWorld* world, IsletShapeId shape, float restitution) {
    if (begin(world)) of(world).set_restitution(in<ShapeId>(shape), restitution);
    return end(world);
}

float islet_shape_rolling_resistance(const IsletWorld* world, IsletShapeId shape) {
    float found = {};
    if (world != nullptr) found = of(world).rolling_resistance(in<ShapeId>(shape));
    return found;
}

IsletError islet_shape_set_rolling_resistance(IsletWorld* world, IsletShapeId shape, float resistance) {
    if (begin(world)) of(world).set_rolling_resistance(in<ShapeId>(shape), resistance);
    return end(world);
}

float islet_shape_tangent_speed(const IsletWorld* world, IsletShapeId shape) {
    float found = {};
    if (world != nullptr) found = of(world).tangent_speed(in<ShapeId>(shape));
    return found;
}

IsletError islet_shape_set_tangent_speed(IsletWorld* world, IsletShapeId shape, float speed) {
    if (begin(world)) of(world).set_tangent_speed(in<ShapeId>(shape), speed);
    return end(world);
}

IsletSurfaceMaterial islet_shape_material(const IsletWorld* world, IsletShapeId shape) {
    SurfaceMaterial found = {};
    if (world != nullptr) found = of(world).material(in<ShapeId>(shape));
    return out(found);
}

IsletError islet_shape_set_material(IsletWorld* world, IsletShapeId shape, const IsletSurfaceMaterial* material) {
    if (begin(world) && is_there(world, material)) of(world).set_material(in<ShapeId>(shape), *cast<const SurfaceMaterial>(material));
    return end(world);
}

bool islet_shape_is_sensor(const IsletWorld* world, IsletShapeId shape) {
    bool found = {};
    if (world != nullptr) found = of(world).is_sensor(in<ShapeId>(shape));
    return found;
}

IsletError islet_shape_set_sensor(IsletWorld* world, IsletShapeId shape, bool sensor) {
    if (begin(world)) of(world).set_sensor(in<ShapeId>(shape), sensor);
    return end(world);
}

uint32_t islet_shape_sensor_overlaps(const IsletWorld* world, IsletShapeId sensor, IsletShapeId* out, size_t out_count) {
    uint32_t found = {};
    if (world != nullptr && is_there(world, out, out_count))
        found = of(world).sensor_overlaps(in<ShapeId>(sensor), span_of<ShapeId>(out, out_count));
    return found;
}

bool islet_shape_sensor_events_enabled(const IsletWorld* world, IsletShapeId shape) {
    bool found = {};
    if (world != nullptr) found = of(world).sensor_events_enabled(in<ShapeId>(shape));
    return found;
}

IsletError islet_shape_enable_sensor_events(IsletWorld* world, IsletShapeId shape, bool enable) {
    if (begin(world)) of(world).enable_sensor_events(in<ShapeId>(shape), enable);
    return end(world);
}

bool islet_shape_hit_events_enabled(const IsletWorld* world, IsletShapeId shape) {
    bool found = {};
    if (world != nullptr) found = of(world).hit_events_enabled(in<ShapeId>(shape));
    return found;
}

IsletError islet_shape_enable_hit_events(IsletWorld* world, IsletShapeId shape, bool enable) {
    if (begin(world)) of(world).enable_hit_events(in<ShapeId>(shape), enable);
    return end(world);
}

bool islet_shape_pre_solve_enabled(const IsletWorld* world, IsletShapeId shape) {
    bool found = {};
    if (world != nullptr) found = of(world).pre_solve_enabled(in<ShapeId>(shape));
    return found;
}

IsletError islet_shape_enable_pre_solve(IsletWorld* world, IsletShapeId shape, bool enable) {
    if (begin(world)) of(world).enable_pre_solve(in<ShapeId>(shape), enable);
    return end(world);
}

IsletVec2 islet_shape_one_way(const IsletWorld* world, IsletShapeId shape) {
    Vec2 found = {};
    if (world != nullptr) found = of(world).one_way(in<ShapeId>(shape));
    return out(found);
}

IsletError islet_shape_set_one_way(IsletWorld* world, IsletShapeId shape, IsletVec2 direction) {
    if (begin(world)) of(world).set_one_way(in<ShapeId>(shape), in<Vec2>(direction));
    return end(world);
}

IsletError islet_shape_apply_wind(IsletWorld* world, IsletShapeId shape, const IsletWindDef* wind) {
    Room<WindDef> wind_room;
    const WindDef* wind_taken = nullptr;
    if (begin(world) && (wind_taken = take<WindDef>(world, wind, wind_room)) != nullptr)
        of(world).apply_wind(in<ShapeId>(shape), *wind_taken);
    return end(world);
}

IsletFilter islet_shape_filter(const IsletWorld* world, IsletShapeId shape) {
    Filter found = {};
    if (world != nullptr) found = of(world).filter(in<ShapeId>(shape));
    return out(found);
}

IsletError islet_shape_set_filter(IsletWorld* world, IsletShapeId shape, const IsletFilter* filter) {
    if (begin(world) && is_there(world, filter)) of(world).set_filter(in<ShapeId>(shape), *cast<const Filter>(filter));
    return end(world);
}

uint64_t islet_shape_user_data(const IsletWorld* world, IsletShapeId shape) {
    uint64_t found = {};
    if (world != nullptr) found = of(world).user_data(in<ShapeId>(shape));
    return found;
}

IsletError islet_shape_set_user_data(IsletWorld* world, IsletShapeId shape, uint64_t data) {
    if (begin(world)) of(world).set_user_data(in<ShapeId>(shape), data);
    return end(world);
}

}  // extern "C"
