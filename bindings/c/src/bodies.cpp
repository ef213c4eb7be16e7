// Functions of islet.h: bodies.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

float islet_body_residual(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).residual(in<BodyId>(body));
}

IsletBodyId islet_create_body(IsletWorld* world, const IsletBodyDef* def) {
    if (world == nullptr) return out(BodyId{});
    Room<BodyDef> def_room;
    const BodyDef* def_taken = take<BodyDef>(world, def, def_room);
    if (def_taken == nullptr) return out(BodyId{});
    return out(of(world).create_body(*def_taken));
}

IsletError islet_destroy_body(IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).destroy_body(in<BodyId>(body));
    return end(world, before);
}

bool islet_body_is_valid(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return false;
    return of(world).is_valid(in<BodyId>(body));
}

IsletTransform islet_body_transform(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return out(Transform{});
    return out(of(world).transform(in<BodyId>(body)));
}

IsletVec2 islet_body_position(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).position(in<BodyId>(body)));
}

float islet_body_angle(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).angle(in<BodyId>(body));
}

IsletVec2 islet_body_center_of_mass(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).center_of_mass(in<BodyId>(body)));
}

IsletVec2 islet_body_local_center_of_mass(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).local_center_of_mass(in<BodyId>(body)));
}

IsletVec2 islet_body_linear_velocity(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).linear_velocity(in<BodyId>(body)));
}

float islet_body_angular_velocity(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).angular_velocity(in<BodyId>(body));
}

IsletVec2 islet_body_velocity_at(const IsletWorld* world, IsletBodyId body, IsletVec2 point) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).velocity_at(in<BodyId>(body), in<Vec2>(point)));
}

IsletError islet_body_set_transform(IsletWorld* world, IsletBodyId body, IsletVec2 position, float angle) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_transform(in<BodyId>(body), in<Vec2>(position), angle);
    return end(world, before);
}

IsletError islet_body_set_pose(IsletWorld* world, IsletBodyId body, IsletTransform pose) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_transform(in<BodyId>(body), in<Transform>(pose));
    return end(world, before);
}

IsletError islet_body_set_linear_velocity(IsletWorld* world, IsletBodyId body, IsletVec2 velocity) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_linear_velocity(in<BodyId>(body), in<Vec2>(velocity));
    return end(world, before);
}

IsletError islet_body_set_angular_velocity(IsletWorld* world, IsletBodyId body, float velocity) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_angular_velocity(in<BodyId>(body), velocity);
    return end(world, before);
}

IsletError islet_body_set_target(IsletWorld* world, IsletBodyId body, IsletTransform target, float dt) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_target(in<BodyId>(body), in<Transform>(target), dt);
    return end(world, before);
}

IsletError islet_body_apply_force(IsletWorld* world, IsletBodyId body, IsletVec2 force, IsletVec2 point) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).apply_force(in<BodyId>(body), in<Vec2>(force), in<Vec2>(point));
    return end(world, before);
}

IsletError islet_body_apply_force_to_center(IsletWorld* world, IsletBodyId body, IsletVec2 force) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).apply_force_to_center(in<BodyId>(body), in<Vec2>(force));
    return end(world, before);
}

IsletError islet_body_apply_torque(IsletWorld* world, IsletBodyId body, float torque) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).apply_torque(in<BodyId>(body), torque);
    return end(world, before);
}

IsletError islet_body_apply_linear_impulse(IsletWorld* world, IsletBodyId body, IsletVec2 impulse, IsletVec2 point) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).apply_linear_impulse(in<BodyId>(body), in<Vec2>(impulse), in<Vec2>(point));
    return end(world, before);
}

IsletError islet_body_apply_linear_impulse_to_center(IsletWorld* world, IsletBodyId body, IsletVec2 impulse) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).apply_linear_impulse_to_center(in<BodyId>(body), in<Vec2>(impulse));
    return end(world, before);
}

IsletError islet_body_apply_angular_impulse(IsletWorld* world, IsletBodyId body, float impulse) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).apply_angular_impulse(in<BodyId>(body), impulse);
    return end(world, before);
}

IsletBodyType islet_body_type(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return out(BodyType{});
    return out(of(world).type(in<BodyId>(body)));
}

IsletError islet_body_set_type(IsletWorld* world, IsletBodyId body, IsletBodyType type) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_type(in<BodyId>(body), in<BodyType>(type));
    return end(world, before);
}

float islet_body_mass(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).mass(in<BodyId>(body));
}

float islet_body_rotational_inertia(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).rotational_inertia(in<BodyId>(body));
}

IsletError islet_body_set_mass(IsletWorld* world, IsletBodyId body, const IsletMassData* mass) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (mass == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_mass(in<BodyId>(body), *cast<const MassData>(mass));
    return end(world, before);
}

IsletError islet_body_reset_mass(IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).reset_mass(in<BodyId>(body));
    return end(world, before);
}

float islet_body_linear_damping(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).linear_damping(in<BodyId>(body));
}

IsletError islet_body_set_linear_damping(IsletWorld* world, IsletBodyId body, float damping) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_linear_damping(in<BodyId>(body), damping);
    return end(world, before);
}

float islet_body_angular_damping(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).angular_damping(in<BodyId>(body));
}

IsletError islet_body_set_angular_damping(IsletWorld* world, IsletBodyId body, float damping) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_angular_damping(in<BodyId>(body), damping);
    return end(world, before);
}

float islet_body_gravity_scale(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).gravity_scale(in<BodyId>(body));
}

IsletError islet_body_set_gravity_scale(IsletWorld* world, IsletBodyId body, float scale) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_gravity_scale(in<BodyId>(body), scale);
    return end(world, before);
}

bool islet_body_is_rotation_fixed(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return false;
    return of(world).is_rotation_fixed(in<BodyId>(body));
}

IsletError islet_body_set_fixed_rotation(IsletWorld* world, IsletBodyId body, bool fixed) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_fixed_rotation(in<BodyId>(body), fixed);
    return end(world, before);
}

bool islet_body_is_x_locked(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return false;
    return of(world).is_x_locked(in<BodyId>(body));
}

bool islet_body_is_y_locked(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return false;
    return of(world).is_y_locked(in<BodyId>(body));
}

IsletError islet_body_lock_x(IsletWorld* world, IsletBodyId body, bool lock) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).lock_x(in<BodyId>(body), lock);
    return end(world, before);
}

IsletError islet_body_lock_y(IsletWorld* world, IsletBodyId body, bool lock) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).lock_y(in<BodyId>(body), lock);
    return end(world, before);
}

bool islet_body_is_enabled(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return false;
    return of(world).is_enabled(in<BodyId>(body));
}

IsletError islet_body_set_enabled(IsletWorld* world, IsletBodyId body, bool enabled) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_enabled(in<BodyId>(body), enabled);
    return end(world, before);
}

bool islet_body_is_bullet(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return false;
    return of(world).is_bullet(in<BodyId>(body));
}

IsletError islet_body_set_bullet(IsletWorld* world, IsletBodyId body, bool bullet) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_bullet(in<BodyId>(body), bullet);
    return end(world, before);
}

bool islet_body_sleep_enabled(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return false;
    return of(world).sleep_enabled(in<BodyId>(body));
}

IsletError islet_body_enable_sleep(IsletWorld* world, IsletBodyId body, bool enable) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).enable_sleep(in<BodyId>(body), enable);
    return end(world, before);
}

float islet_body_sleep_threshold(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).sleep_threshold(in<BodyId>(body));
}

IsletError islet_body_set_sleep_threshold(IsletWorld* world, IsletBodyId body, float threshold) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_sleep_threshold(in<BodyId>(body), threshold);
    return end(world, before);
}

bool islet_body_is_awake(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return false;
    return of(world).is_awake(in<BodyId>(body));
}

IsletError islet_body_wake(IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).wake(in<BodyId>(body));
    return end(world, before);
}

IsletError islet_body_sleep(IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).sleep(in<BodyId>(body));
    return end(world, before);
}

uint64_t islet_body_user_data(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).user_data(in<BodyId>(body));
}

IsletError islet_body_set_user_data(IsletWorld* world, IsletBodyId body, uint64_t data) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_user_data(in<BodyId>(body), data);
    return end(world, before);
}

uint32_t islet_body_contacts(const IsletWorld* world, IsletBodyId body, IsletContactInfo* out, size_t out_count) {
    if (world == nullptr) return 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).contacts(in<BodyId>(body), span_of<ContactInfo>(out, out_count));
}

uint32_t islet_body_shapes(const IsletWorld* world, IsletBodyId body, IsletShapeId* out, size_t out_count) {
    if (world == nullptr) return 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).shapes(in<BodyId>(body), span_of<ShapeId>(out, out_count));
}

}  // extern "C"
