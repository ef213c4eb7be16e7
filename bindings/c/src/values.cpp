// Functions of islet.h: values.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

IsletVec2 islet_vec2_add(IsletVec2 a, IsletVec2 b) {
    return out(in<Vec2>(a) + in<Vec2>(b));
}

IsletVec2 islet_vec2_subtract(IsletVec2 a, IsletVec2 b) {
    return out(in<Vec2>(a) - in<Vec2>(b));
}

IsletVec2 islet_vec2_negate(IsletVec2 a) {
    return out(-in<Vec2>(a));
}

IsletVec2 islet_vec2_scale(float s, IsletVec2 a) {
    return out(s * in<Vec2>(a));
}

float islet_vec2_dot(IsletVec2 a, IsletVec2 b) {
    return islet::dot(in<Vec2>(a), in<Vec2>(b));
}

float islet_vec2_cross(IsletVec2 a, IsletVec2 b) {
    return islet::cross(in<Vec2>(a), in<Vec2>(b));
}

IsletVec2 islet_vec2_cross_rate(float w, IsletVec2 r) {
    return out(islet::cross(w, in<Vec2>(r)));
}

IsletVec2 islet_vec2_left_perp(IsletVec2 a) {
    return out(islet::left_perp(in<Vec2>(a)));
}

IsletVec2 islet_vec2_right_perp(IsletVec2 a) {
    return out(islet::right_perp(in<Vec2>(a)));
}

float islet_vec2_length_squared(IsletVec2 a) {
    return islet::length_squared(in<Vec2>(a));
}

float islet_vec2_distance_squared(IsletVec2 a, IsletVec2 b) {
    return islet::distance_squared(in<Vec2>(a), in<Vec2>(b));
}

IsletVec2 islet_vec2_lerp(IsletVec2 a, IsletVec2 b, float t) {
    return out(islet::lerp(in<Vec2>(a), in<Vec2>(b), t));
}

IsletVec2 islet_vec2_min(IsletVec2 a, IsletVec2 b) {
    return out(islet::min(in<Vec2>(a), in<Vec2>(b)));
}

IsletVec2 islet_vec2_max(IsletVec2 a, IsletVec2 b) {
    return out(islet::max(in<Vec2>(a), in<Vec2>(b)));
}

IsletVec2 islet_rot_rotate(IsletRot q, IsletVec2 v) {
    return out(islet::rotate(in<Rot>(q), in<Vec2>(v)));
}

IsletVec2 islet_rot_inv_rotate(IsletRot q, IsletVec2 v) {
    return out(islet::inv_rotate(in<Rot>(q), in<Vec2>(v)));
}

IsletRot islet_rot_multiply(IsletRot q, IsletRot r) {
    return out(in<Rot>(q) * in<Rot>(r));
}

IsletRot islet_rot_inverse(IsletRot q) {
    return out(islet::inverse(in<Rot>(q)));
}

IsletRot islet_rot_inv_mul(IsletRot q, IsletRot r) {
    return out(islet::inv_mul(in<Rot>(q), in<Rot>(r)));
}

IsletVec2 islet_transform_point(IsletTransform t, IsletVec2 v) {
    return out(islet::transform_point(in<Transform>(t), in<Vec2>(v)));
}

IsletVec2 islet_inv_transform_point(IsletTransform t, IsletVec2 v) {
    return out(islet::inv_transform_point(in<Transform>(t), in<Vec2>(v)));
}

IsletTransform islet_transform_inv_mul(IsletTransform a, IsletTransform b) {
    return out(islet::inv_mul(in<Transform>(a), in<Transform>(b)));
}

bool islet_aabb_overlaps(IsletAabb a, IsletAabb b) {
    return islet::overlaps(in<Aabb>(a), in<Aabb>(b));
}

bool islet_aabb_contains(IsletAabb outer, IsletAabb inner) {
    return islet::contains(in<Aabb>(outer), in<Aabb>(inner));
}

IsletAabb islet_aabb_merge(IsletAabb a, IsletAabb b) {
    return out(islet::merge(in<Aabb>(a), in<Aabb>(b)));
}

IsletAabb islet_aabb_expand(IsletAabb a, float margin) {
    return out(islet::expand(in<Aabb>(a), margin));
}

float islet_aabb_perimeter(IsletAabb a) {
    return islet::perimeter(in<Aabb>(a));
}

bool islet_vec2_is_finite(IsletVec2 a) {
    return islet::is_finite(in<Vec2>(a));
}

float islet_vec2_length(IsletVec2 a) {
    return islet::length(in<Vec2>(a));
}

float islet_vec2_distance(IsletVec2 a, IsletVec2 b) {
    return islet::distance(in<Vec2>(a), in<Vec2>(b));
}

IsletVec2 islet_vec2_normalize(IsletVec2 a) {
    return out(islet::normalize(in<Vec2>(a)));
}

IsletRot islet_make_rot(float radians) {
    return out(islet::make_rot(radians));
}

float islet_rot_angle(IsletRot q) {
    return islet::angle_of(in<Rot>(q));
}

float islet_atan2(float y, float x) {
    return islet::atan2(y, x);
}

IsletRot islet_rot_normalize(IsletRot q) {
    return out(islet::normalize(in<Rot>(q)));
}

IsletRot islet_rot_lerp(IsletRot q, IsletRot r, float t) {
    return out(islet::lerp(in<Rot>(q), in<Rot>(r), t));
}

IsletTransform islet_transform_lerp(IsletTransform a, IsletTransform b, float t) {
    return out(islet::lerp(in<Transform>(a), in<Transform>(b), t));
}

IsletRot islet_rot_integrate(IsletRot q, float delta_radians) {
    return out(islet::integrate(in<Rot>(q), delta_radians));
}

IsletHull islet_compute_hull(const IsletVec2* points, size_t points_count) {
    IsletHull found = {};
    if (is_there(nullptr, points, points_count)) new (&found) Hull(islet::compute_hull(span_of<const Vec2>(points, points_count)));
    return found;
}

IsletPolygon islet_make_polygon(const IsletHull* hull, float radius) {
    IsletPolygon found = {};
    if (is_there(nullptr, hull)) new (&found) Polygon(islet::make_polygon(*cast<const Hull>(hull), radius));
    return found;
}

IsletPolygon islet_make_box(float hx, float hy) {
    IsletPolygon found;
    new (&found) Polygon(islet::make_box(hx, hy));
    return found;
}

IsletPolygon islet_make_rounded_box(float hx, float hy, float radius) {
    IsletPolygon found;
    new (&found) Polygon(islet::make_rounded_box(hx, hy, radius));
    return found;
}

IsletPolygon islet_make_offset_box(float hx, float hy, IsletTransform pose, float radius) {
    IsletPolygon found;
    new (&found) Polygon(islet::make_offset_box(hx, hy, in<Transform>(pose), radius));
    return found;
}

IsletPolygon islet_transform_polygon(IsletTransform t, const IsletPolygon* p) {
    IsletPolygon found = {};
    if (is_there(nullptr, p)) new (&found) Polygon(islet::transform_polygon(in<Transform>(t), *cast<const Polygon>(p)));
    return found;
}

bool islet_circle_is_valid(const IsletCircle* c) {
    bool found = {};
    if (is_there(nullptr, c)) found = islet::is_valid(*cast<const Circle>(c));
    return found;
}

bool islet_capsule_is_valid(const IsletCapsule* c) {
    bool found = {};
    if (is_there(nullptr, c)) found = islet::is_valid(*cast<const Capsule>(c));
    return found;
}

bool islet_segment_is_valid(const IsletSegment* s) {
    bool found = {};
    if (is_there(nullptr, s)) found = islet::is_valid(*cast<const Segment>(s));
    return found;
}

bool islet_half_space_is_valid(const IsletHalfSpace* h) {
    bool found = {};
    if (is_there(nullptr, h)) found = islet::is_valid(*cast<const HalfSpace>(h));
    return found;
}

bool islet_polygon_is_valid(const IsletPolygon* p) {
    bool found = {};
    if (is_there(nullptr, p)) found = islet::is_valid(*cast<const Polygon>(p));
    return found;
}

IsletMassData islet_circle_compute_mass(const IsletCircle* c, float density) {
    IsletMassData found = {};
    if (is_there(nullptr, c)) new (&found) MassData(islet::compute_mass(*cast<const Circle>(c), density));
    return found;
}

IsletMassData islet_capsule_compute_mass(const IsletCapsule* c, float density) {
    IsletMassData found = {};
    if (is_there(nullptr, c)) new (&found) MassData(islet::compute_mass(*cast<const Capsule>(c), density));
    return found;
}

IsletMassData islet_polygon_compute_mass(const IsletPolygon* p, float density) {
    IsletMassData found = {};
    if (is_there(nullptr, p)) new (&found) MassData(islet::compute_mass(*cast<const Polygon>(p), density));
    return found;
}

IsletAabb islet_circle_compute_aabb(const IsletCircle* c, IsletTransform t) {
    Aabb found = {};
    if (is_there(nullptr, c)) found = islet::compute_aabb(*cast<const Circle>(c), in<Transform>(t));
    return out(found);
}

IsletAabb islet_capsule_compute_aabb(const IsletCapsule* c, IsletTransform t) {
    Aabb found = {};
    if (is_there(nullptr, c)) found = islet::compute_aabb(*cast<const Capsule>(c), in<Transform>(t));
    return out(found);
}

IsletAabb islet_segment_compute_aabb(const IsletSegment* s, IsletTransform t) {
    Aabb found = {};
    if (is_there(nullptr, s)) found = islet::compute_aabb(*cast<const Segment>(s), in<Transform>(t));
    return out(found);
}

IsletAabb islet_polygon_compute_aabb(const IsletPolygon* p, IsletTransform t) {
    Aabb found = {};
    if (is_there(nullptr, p)) found = islet::compute_aabb(*cast<const Polygon>(p), in<Transform>(t));
    return out(found);
}

bool islet_capacity_is_valid(const IsletCapacity* c) {
    Room<Capacity> c_room;
    const Capacity* c_taken = nullptr;
    bool found = {};
    if ((c_taken = take<Capacity>(nullptr, c, c_room)) != nullptr) found = islet::is_valid(*c_taken);
    return found;
}

IsletShapeProxy islet_make_circle_proxy(const IsletCircle* circle) {
    IsletShapeProxy found = {};
    if (is_there(nullptr, circle)) new (&found) ShapeProxy(islet::make_proxy(*cast<const Circle>(circle)));
    return found;
}

IsletShapeProxy islet_make_capsule_proxy(const IsletCapsule* capsule) {
    IsletShapeProxy found = {};
    if (is_there(nullptr, capsule)) new (&found) ShapeProxy(islet::make_proxy(*cast<const Capsule>(capsule)));
    return found;
}

IsletShapeProxy islet_make_segment_proxy(const IsletSegment* segment) {
    IsletShapeProxy found = {};
    if (is_there(nullptr, segment)) new (&found) ShapeProxy(islet::make_proxy(*cast<const Segment>(segment)));
    return found;
}

IsletShapeProxy islet_make_polygon_proxy(const IsletPolygon* polygon) {
    IsletShapeProxy found = {};
    if (is_there(nullptr, polygon)) new (&found) ShapeProxy(islet::make_proxy(*cast<const Polygon>(polygon)));
    return found;
}

IsletShapeProxy islet_make_proxy(const IsletVec2* points, size_t points_count, float radius) {
    IsletShapeProxy found = {};
    if (is_there(nullptr, points, points_count))
        new (&found) ShapeProxy(islet::make_proxy(span_of<const Vec2>(points, points_count), radius));
    return found;
}

IsletShapeProxy islet_make_box_proxy(IsletAabb box) {
    IsletShapeProxy found;
    new (&found) ShapeProxy(islet::make_proxy(in<Aabb>(box)));
    return found;
}

IsletShapeProxy islet_transform_proxy(IsletTransform t, const IsletShapeProxy* p) {
    IsletShapeProxy found = {};
    if (is_there(nullptr, p)) new (&found) ShapeProxy(islet::transform_proxy(in<Transform>(t), *cast<const ShapeProxy>(p)));
    return found;
}

bool islet_proxy_is_valid(const IsletShapeProxy* p) {
    bool found = {};
    if (is_there(nullptr, p)) found = islet::is_valid(*cast<const ShapeProxy>(p));
    return found;
}

IsletCastHit islet_cast_ray(const IsletShapeProxy* target, IsletVec2 origin, IsletVec2 translation) {
    IsletCastHit found = {};
    if (is_there(nullptr, target))
        new (&found) CastHit(islet::cast_ray(*cast<const ShapeProxy>(target), in<Vec2>(origin), in<Vec2>(translation)));
    return found;
}

IsletCastHit islet_cast_shape(const IsletShapeProxy* moving, IsletVec2 translation, const IsletShapeProxy* target) {
    IsletCastHit found = {};
    if (is_there(nullptr, moving) && is_there(nullptr, target))
        new (&found) CastHit(islet::cast_shape(*cast<const ShapeProxy>(moving), in<Vec2>(translation), *cast<const ShapeProxy>(target)));
    return found;
}

bool islet_proxy_overlaps(const IsletShapeProxy* a, const IsletShapeProxy* b) {
    bool found = {};
    if (is_there(nullptr, a) && is_there(nullptr, b)) found = islet::overlaps(*cast<const ShapeProxy>(a), *cast<const ShapeProxy>(b));
    return found;
}

bool islet_proxy_contains(const IsletShapeProxy* shape, IsletVec2 point) {
    bool found = {};
    if (is_there(nullptr, shape)) found = islet::contains(*cast<const ShapeProxy>(shape), in<Vec2>(point));
    return found;
}

}  // extern "C"
