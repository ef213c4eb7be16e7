// Functions of islet.h: bodies.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

float islet_body_residual(const IsletWorld* world, IsletBodyId body) {
    float found = {};
    if (world != nullptr) found = of(world).residual(in<BodyId>(body));
    return found;
}

IsletBodyId islet_create_body(IsletWorld* world, const IsletBodyDef* def) {
    Room<BodyDef> def_room;
    const BodyDef* def_taken = nullptr;
    IsletBodyId found = {};
    if ((def_taken = take<BodyDef>(world, def, def_room)) != nullptr) new (&found) BodyId(of(world).create_body(*def_taken));
    return found;
}

IsletError islet_destroy_body(IsletWorld* world, IsletBodyId body) {
    if (begin(world)) of(world).destroy_body(in<BodyId>(body));
    return end(world);
}

bool islet_body_is_valid(const IsletWorld* world, IsletBodyId body) {
    bool found = {};
    if (world != nullptr) found = of(world).is_valid(in<BodyId>(body));
    return found;
}

IsletTransform islet_body_transform(const IsletWorld* world, IsletBodyId body) {
    Transform found = {};
    if (world != nullptr) found = of(world).transform(in<BodyId>(body));
    return out(found);
}

IsletVec2 islet_body_position(const IsletWorld* world, IsletBodyId body) {
    Vec2 found = {};
    if (world != nullptr) found = of(world).position(in<BodyId>(body));
    return out(found);
}

float islet_body_angle(const IsletWorld* world, IsletBodyId body) {
    float found = {};
    if (world != nullptr) found = of(world).angle(in<BodyId>(body));
    return found;
}

IsletVec2 islet_body_center_of_mass(const IsletWorld* world, IsletBodyId body) {
    Vec2 found = {};
    if (world != nullptr) found = of(world).center_of_mass(in<BodyId>(body));
    return out(found);
}

IsletVec2 islet_body_local_center_of_mass(const IsletWorld* world, IsletBodyId body) {
    Vec2 found = {};
    if (world != nullptr) found = of(world).local_center_of_mass(in<BodyId>(body));
    return out(found);
}

IsletVec2 islet_body_linear_velocity(const IsletWorld* world, IsletBodyId body) {
    Vec2 found = {};
    if (world != nullptr) found = of(world).linear_velocity(in<BodyId>(body));
    return out(found);
}

float islet_body_angular_velocity(const IsletWorld* world, IsletBodyId body) {
    float found = {};
    if (world != nullptr) found = of(world).angular_velocity(in<BodyId>(body));
    return found;
}

IsletVec2 islet_body_velocity_at(const IsletWorld* world, IsletBodyId body, IsletVec2 point) {
    Vec2 found = {};
    if (world != nullptr) found = of(world).velocity_at(in<BodyId>(body), in<Vec2>(point));
    return out(found);
}

IsletError islet_body_set_transform(IsletWorld* world, IsletBodyId body, IsletVec2 position, float angle) {
    if (begin(world)) of(world).set_transform(in<BodyId>(body), in<Vec2>(position), angle);
    return end(world);
}

IsletError islet_body_set_pose(IsletWorld* world, IsletBodyId body, IsletTransform pose) {
    if (begin(world)) of(world).set_transform(in<BodyId>(body), in<Transform>(pose));
    return end(world);
}

IsletError islet_body_set_linear_velocity(IsletWorld* world, IsletBodyId body, IsletVec2 velocity) {
    if (begin(world)) of(world).set_linear_velocity(in<BodyId>(body), in<Vec2>(velocity));
    return end(world);
}

IsletError islet_body_set_angular_velocity(IsletWorld* world, IsletBodyId body, float velocity) {
    if (begin(world)) of(world).set_angular_velocity(in<BodyId>(body), velocity);
    return end(world);
}

IsletError islet_body_set_target(IsletWorld* world, IsletBodyId body, IsletTransform target, float dt) {
    if (begin(world)) of(world).set_target(in<BodyId>(body), in<Transform>(target), dt);
    return end(world);
}

IsletError islet_body_apply_force(IsletWorld* world, IsletBodyId body, IsletVec2 force, IsletVec2 point, bool wake) {
    if (begin(world)) of(world).apply_force(in<BodyId>(body), in<Vec2>(force), in<Vec2>(point), wake);
    return end(world);
}

IsletError islet_body_apply_force_to_center(IsletWorld* world, IsletBodyId body, IsletVec2 force, bool wake) {
    if (begin(world)) of(world).apply_force_to_center(in<BodyId>(body), in<Vec2>(force), wake);
    return end(world);
}

IsletError islet_body_apply_torque(IsletWorld* world, IsletBodyId body, float torque, bool wake) {
    if (begin(world)) of(world).apply_torque(in<BodyId>(body), torque, wake);
    return end(world);
}

IsletError islet_body_apply_linear_impulse(IsletWorld* world, IsletBodyId body, IsletVec2 impulse, IsletVec2 point, bool wake) {
    if (begin(world)) of(world).apply_linear_impulse(in<BodyId>(body), in<Vec2>(impulse), in<Vec2>(point), wake);
    return end(world);
}

IsletError islet_body_apply_linear_impulse_to_center(IsletWorld* world, IsletBodyId body, IsletVec2 impulse, bool wake) {
    if (begin(world)) of(world).apply_linear_impulse_to_center(in<BodyId>(body), in<Vec2>(impulse), wake);
    return end(world);
}

IsletError islet_body_apply_angular_impulse(IsletWorld* world, IsletBodyId body, float impulse, bool wake) {
    if (begin(world)) of(world).apply_angular_impulse(in<BodyId>(body), impulse, wake);
    return end(world);
}

IsletBodyType islet_body_type(const IsletWorld* world, IsletBodyId body) {
    BodyType found = {};
    if (world != nullptr) found = of(world).type(in<BodyId>(body));
    return out(found);
}

IsletError islet_body_set_type(IsletWorld* world, IsletBodyId body, IsletBodyType type) {
    if (begin(world)) of(world).set_type(in<BodyId>(body), in<BodyType>(type));
    return end(world);
}

float islet_body_mass(const IsletWorld* world, IsletBodyId body) {
    float found = {};
    if (world != nullptr) found = of(world).mass(in<BodyId>(body));
    return found;
}

float islet_body_rotational_inertia(const IsletWorld* world, IsletBodyId body) {
    float found = {};
    if (world != nullptr) found = of(world).rotational_inertia(in<BodyId>(body));
    return found;
}

IsletError islet_body_set_mass(IsletWorld* world, IsletBodyId body, const IsletMassData* mass) {
    if (begin(world) && is_there(world, mass)) of(world).set_mass(in<BodyId>(body), *cast<const MassData>(mass));
    return end(world);
}

IsletError islet_body_reset_mass(IsletWorld* world, IsletBodyId body) {
    if (begin(world)) of(world).reset_mass(in<BodyId>(body));
    return end(world);
}

float islet_body_linear_damping(const IsletWorld* world, IsletBodyId body) {
    float found = {};
    if (world != nullptr) found = of(world).linear_damping(in<BodyId>(body));
    return found;
}

IsletError islet_body_set_linear_damping(IsletWorld* world, IsletBodyId body, float damping) {
    if (begin(world)) of(world).set_linear_damping(in<BodyId>(body), damping);
    return end(world);
}

float islet_body_angular_damping(const IsletWorld* world, IsletBodyId body) {
    float found = {};
    if (world != nullptr) found = of(world).angular_damping(in<BodyId>(body));
    return found;
}

IsletError islet_body_set_angular_damping(IsletWorld* world, IsletBodyId body, float damping) {
    if (begin(world)) of(world).set_angular_damping(in<BodyId>(body), damping);
    return end(world);
}

float islet_body_gravity_scale(const IsletWorld* world, IsletBodyId body) {
    float found = {};
    if (world != nullptr) found = of(world).gravity_scale(in<BodyId>(body));
    return found;
}

IsletError islet_body_set_gravity_scale(IsletWorld* world, IsletBodyId body, float scale) {
    if (begin(world)) of(world).set_gravity_scale(in<BodyId>(body), scale);
    return end(world);
}

bool islet_body_is_rotation_fixed(const IsletWorld* world, IsletBodyId body) {
    bool found = {};
    if (world != nullptr) found = of(world).is_rotation_fixed(in<BodyId>(body));
    return found;
}

IsletError islet_body_set_fixed_rotation(IsletWorld* world, IsletBodyId body, bool fixed) {
    if (begin(world)) of(world).set_fixed_rotation(in<BodyId>(body), fixed);
    return end(world);
}

bool islet_body_is_x_locked(const IsletWorld* world, IsletBodyId body) {
    bool found = {};
    if (world != nullptr) found = of(world).is_x_locked(in<BodyId>(body));
    return found;
}

bool islet_body_is_y_locked(const IsletWorld* world, IsletBodyId body) {
    bool found = {};
    if (world != nullptr) found = of(world).is_y_locked(in<BodyId>(body));
    return found;
}

IsletError islet_body_lock_x(IsletWorld* world, IsletBodyId body, bool lock) {
    if (begin(world)) of(world).lock_x(in<BodyId>(body), lock);
    return end(world);
}

IsletError islet_body_lock_y(IsletWorld* world, IsletBodyId body, bool lock) {
    if (begin(world)) of(world).lock_y(in<BodyId>(body), lock);
    return end(world);
}

bool islet_body_is_enabled(const IsletWorld* world, IsletBodyId body) {
    bool found = {};
    if (world != nullptr) found = of(world).is_enabled(in<BodyId>(body));
    return found;
}

IsletError islet_body_set_enabled(IsletWorld* world, IsletBodyId body, bool enabled) {
    if (begin(world)) of(world).set_enabled(in<BodyId>(body), enabled);
    return end(world);
}

bool islet_body_is_bullet(const IsletWorld* world, IsletBodyId body) {
    bool found = {};
    if (world != nullptr) found = of(world).is_bullet(in<BodyId>(body));
    return found;
}

IsletError islet_body_set_bullet(IsletWorld* world, IsletBodyId body, bool bullet) {
    if (begin(world)) of(world).set_bullet(in<BodyId>(body), bullet);
    return end(world);
}

bool islet_body_sleep_enabled(const IsletWorld* world, IsletBodyId body) {
    bool found = {};
    if (world != nullptr) found = of(world).sleep_enabled(in<BodyId>(body));
    return found;
}

IsletError islet_body_enable_sleep(IsletWorld* world, IsletBodyId body, bool enable) {
    if (begin(world)) of(world).enable_sleep(in<BodyId>(body), enable);
    return end(world);
}

float islet_body_sleep_threshold(const IsletWorld* world, IsletBodyId body) {
    float found = {};
    if (world != nullptr) found = of(world).sleep_threshold(in<BodyId>(body));
    return found;
}

IsletError islet_body_set_sleep_threshold(IsletWorld* world, IsletBodyId body, float threshold) {
    if (begin(world)) of(world).set_sleep_threshold(in<BodyId>(body), threshold);
    return end(world);
}

bool islet_body_is_awake(const IsletWorld* world, IsletBodyId body) {
    bool found = {};
    if (world != nullptr) found = of(world).is_awake(in<BodyId>(body));
    return found;
}

IsletError islet_body_wake(IsletWorld* world, IsletBodyId body) {
    if (begin(world)) of(world).wake(in<BodyId>(body));
    return end(world);
}

IsletError islet_body_sleep(IsletWorld* world, IsletBodyId body) {
    if (begin(world)) of(world).sleep(in<BodyId>(body));
    return end(world);
}

uint64_t islet_body_user_data(const IsletWorld* world, IsletBodyId body) {
    uint64_t found = {};
    if (world != nullptr) found = of(world).user_data(in<BodyId>(body));
    return found;
}

IsletError islet_body_set_user_data(IsletWorld* world, IsletBodyId body, uint64_t data) {
    if (begin(world)) of(world).set_user_data(in<BodyId>(body), data);
    return end(world);
}

uint32_t islet_body_contacts(const IsletWorld* world, IsletBodyId body, IsletContactInfo* out, size_t out_count) {
    uint32_t found = {};
    if (world != nullptr && is_there(world, out, out_count)) found = of(world).contacts(in<BodyId>(body), span_of<ContactInfo>(out, out_count));
    return found;
}

uint32_t islet_body_shapes(const IsletWorld* world, IsletBodyId body, IsletShapeId* out, size_t out_count) {
    uint32_t found = {};
    if (world != nullptr && is_there(world, out, out_count)) found = of(world).shapes(in<BodyId>(body), span_of<ShapeId>(out, out_count));
    return found;
}

IsletShapeId islet_body_next_shape(const IsletWorld* world, IsletBodyId body, IsletShapeId shape) {
    IsletShapeId found = {};
    if (world != nullptr) new (&found) ShapeId(of(world).next_shape(in<BodyId>(body), in<ShapeId>(shape)));
    return found;
}

uint32_t islet_body_next_contact(const IsletWorld* world, IsletBodyId body, uint32_t contact, IsletContactInfo* out) {
    uint32_t found = {};
    if (world != nullptr && is_there(world, out)) found = of(world).next_contact(in<BodyId>(body), contact, *cast<ContactInfo>(out));
    return found;
}

}  // extern "C"
