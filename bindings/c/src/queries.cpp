// Functions of islet.h: queries.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

IsletQueryHit islet_world_cast_ray(const IsletWorld* world, IsletVec2 origin, IsletVec2 translation, const IsletQueryFilter* filter) {
    IsletQueryHit found = {};
    if (world != nullptr)
        new (&found) QueryHit(of(world).cast_ray(in<Vec2>(origin), in<Vec2>(translation), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter)));
    return found;
}

bool islet_world_cast_ray_any(const IsletWorld* world, IsletVec2 origin, IsletVec2 translation, const IsletQueryFilter* filter) {
    bool found = {};
    if (world != nullptr)
        found = of(world).cast_ray_any(in<Vec2>(origin), in<Vec2>(translation), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter));
    return found;
}

uint32_t islet_world_cast_ray_all(const IsletWorld* world, IsletVec2 origin, IsletVec2 translation, IsletQueryHit* out, size_t out_count,
    const IsletQueryFilter* filter) {
    uint32_t found = {};
    if (world != nullptr && is_there(world, out, out_count))
        found = of(world).cast_ray_all(in<Vec2>(origin), in<Vec2>(translation), span_of<QueryHit>(out, out_count), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter));
    return found;
}

void islet_world_cast_ray_each(const IsletWorld* world, IsletVec2 origin, IsletVec2 translation, const IsletQueryFilter* filter, IsletCastVisitor visit,
    void* context) {
    if (world != nullptr)
        of(world).cast_ray_each(in<Vec2>(origin), in<Vec2>(translation), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter), function<CastVisitor>(visit), context);
}

IsletQueryHit islet_world_cast_shape(const IsletWorld* world, const IsletShapeProxy* shape, IsletVec2 translation, const IsletQueryFilter* filter) {
    IsletQueryHit found = {};
    if (world != nullptr && is_there(world, shape))
        new (&found) QueryHit(of(world).cast_shape(*cast<const ShapeProxy>(shape), in<Vec2>(translation), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter)));
    return found;
}

bool islet_world_cast_shape_any(const IsletWorld* world, const IsletShapeProxy* shape, IsletVec2 translation, const IsletQueryFilter* filter) {
    bool found = {};
    if (world != nullptr && is_there(world, shape))
        found = of(world).cast_shape_any(*cast<const ShapeProxy>(shape), in<Vec2>(translation), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter));
    return found;
}

uint32_t islet_world_cast_shape_all(const IsletWorld* world, const IsletShapeProxy* shape, IsletVec2 translation, IsletQueryHit* out, size_t out_count,
    const IsletQueryFilter* filter) {
    uint32_t found = {};
    if (world != nullptr && is_there(world, shape) && is_there(world, out, out_count))
        found = of(world).cast_shape_all(*cast<const ShapeProxy>(shape), in<Vec2>(translation), span_of<QueryHit>(out, out_count), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter));
    return found;
}

void islet_world_cast_shape_each(const IsletWorld* world, const IsletShapeProxy* shape, IsletVec2 translation, const IsletQueryFilter* filter,
    IsletCastVisitor visit, void* context) {
    if (world != nullptr && is_there(world, shape))
        of(world).cast_shape_each(*cast<const ShapeProxy>(shape), in<Vec2>(translation), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter), function<CastVisitor>(visit), context);
}

uint32_t islet_world_overlap_box(const IsletWorld* world, IsletAabb box, IsletShapeId* out, size_t out_count, const IsletQueryFilter* filter) {
    uint32_t found = {};
    if (world != nullptr && is_there(world, out, out_count))
        found = of(world).overlap_box(in<Aabb>(box), span_of<ShapeId>(out, out_count), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter));
    return found;
}

uint32_t islet_world_overlap_shape(const IsletWorld* world, const IsletShapeProxy* shape, IsletShapeId* out, size_t out_count,
    const IsletQueryFilter* filter) {
    uint32_t found = {};
    if (world != nullptr && is_there(world, shape) && is_there(world, out, out_count))
        found = of(world).overlap_shape(*cast<const ShapeProxy>(shape), span_of<ShapeId>(out, out_count), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter));
    return found;
}

uint32_t islet_world_overlap_point(const IsletWorld* world, IsletVec2 point, IsletShapeId* out, size_t out_count, const IsletQueryFilter* filter) {
    uint32_t found = {};
    if (world != nullptr && is_there(world, out, out_count))
        found = of(world).overlap_point(in<Vec2>(point), span_of<ShapeId>(out, out_count), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter));
    return found;
}

void islet_world_overlap_box_each(const IsletWorld* world, IsletAabb box, const IsletQueryFilter* filter, IsletOverlapVisitor visit, void* context) {
    if (world != nullptr)
        of(world).overlap_box_each(in<Aabb>(box), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter), function<OverlapVisitor>(visit), context);
}

void islet_world_overlap_shape_each(const IsletWorld* world, const IsletShapeProxy* shape, const IsletQueryFilter* filter, IsletOverlapVisitor visit,
    void* context) {
    if (world != nullptr && is_there(world, shape))
        of(world).overlap_shape_each(*cast<const ShapeProxy>(shape), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter), function<OverlapVisitor>(visit), context);
}

void islet_world_overlap_point_each(const IsletWorld* world, IsletVec2 point, const IsletQueryFilter* filter, IsletOverlapVisitor visit, void* context) {
    if (world != nullptr)
        of(world).overlap_point_each(in<Vec2>(point), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter), function<OverlapVisitor>(visit), context);
}

IsletClosestHit islet_world_closest(const IsletWorld* world, IsletVec2 point, float max_distance, const IsletQueryFilter* filter) {
    IsletClosestHit found = {};
    if (world != nullptr)
        new (&found) ClosestHit(of(world).closest(in<Vec2>(point), max_distance, filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter)));
    return found;
}

uint32_t islet_world_surfaces_near(const IsletWorld* world, const IsletShapeProxy* shape, float within, IsletSurface* out, size_t out_count,
    const IsletQueryFilter* filter) {
    uint32_t found = {};
    if (world != nullptr && is_there(world, shape) && is_there(world, out, out_count))
        found = of(world).surfaces_near(*cast<const ShapeProxy>(shape), within, span_of<Surface>(out, out_count), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter));
    return found;
}

}  // extern "C"
