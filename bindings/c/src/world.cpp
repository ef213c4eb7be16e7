// Functions of islet.h: world.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

size_t islet_world_bytes(const IsletCapacity* capacity) {
    Room<Capacity> capacity_room;
    const Capacity* capacity_taken = nullptr;
    size_t found = {};
    if ((capacity_taken = take<Capacity>(nullptr, capacity, capacity_room)) != nullptr) found = islet::world_bytes(*capacity_taken);
    return found;
}

IsletError islet_world_step(IsletWorld* world, float dt) {
    if (begin(world)) of(world).step(dt);
    return end(world);
}

IsletVec2 islet_world_gravity(const IsletWorld* world) {
    Vec2 found = {};
    if (world != nullptr) found = of(world).gravity();
    return out(found);
}

IsletError islet_world_set_gravity(IsletWorld* world, IsletVec2 gravity) {
    if (begin(world)) of(world).set_gravity(in<Vec2>(gravity));
    return end(world);
}

IsletError islet_world_solver(const IsletWorld* world, IsletSolverDef* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<SolverDef>(world, out)) return why(out);
    give<SolverDef>(out, of(world).solver());
    return ISLET_ERROR_NONE;
}

IsletError islet_world_set_solver(IsletWorld* world, const IsletSolverDef* solver) {
    Room<SolverDef> solver_room;
    const SolverDef* solver_taken = nullptr;
    if (begin(world) && (solver_taken = take<SolverDef>(world, solver, solver_room)) != nullptr) of(world).set_solver(*solver_taken);
    return end(world);
}

IsletError islet_world_tasks(const IsletWorld* world, IsletTaskSystem* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<TaskSystem>(world, out)) return why(out);
    give<TaskSystem>(out, of(world).tasks());
    return ISLET_ERROR_NONE;
}

IsletError islet_world_set_tasks(IsletWorld* world, const IsletTaskSystem* tasks) {
    Room<TaskSystem> tasks_room;
    const TaskSystem* tasks_taken = nullptr;
    if (begin(world) && (tasks_taken = take<TaskSystem>(world, tasks, tasks_room)) != nullptr) of(world).set_tasks(*tasks_taken);
    return end(world);
}

bool islet_world_sleep_enabled(const IsletWorld* world) {
    bool found = {};
    if (world != nullptr) found = of(world).sleep_enabled();
    return found;
}

IsletError islet_world_enable_sleep(IsletWorld* world, bool enable) {
    if (begin(world)) of(world).enable_sleep(enable);
    return end(world);
}

float islet_world_restitution_threshold(const IsletWorld* world) {
    float found = {};
    if (world != nullptr) found = of(world).restitution_threshold();
    return found;
}

IsletError islet_world_set_restitution_threshold(IsletWorld* world, float speed) {
    if (begin(world)) of(world).set_restitution_threshold(speed);
    return end(world);
}

float islet_world_max_speed(const IsletWorld* world) {
    float found = {};
    if (world != nullptr) found = of(world).max_speed();
    return found;
}

IsletError islet_world_set_max_speed(IsletWorld* world, float speed) {
    if (begin(world)) of(world).set_max_speed(speed);
    return end(world);
}

uint32_t islet_world_lanes(const IsletWorld* world) {
    uint32_t found = {};
    if (world != nullptr) found = of(world).lanes();
    return found;
}

bool islet_world_continuous(const IsletWorld* world) {
    bool found = {};
    if (world != nullptr) found = of(world).continuous();
    return found;
}

IsletError islet_world_enable_continuous(IsletWorld* world, bool enable) {
    if (begin(world)) of(world).enable_continuous(enable);
    return end(world);
}

bool islet_world_seamless_floors(const IsletWorld* world) {
    bool found = {};
    if (world != nullptr) found = of(world).seamless_floors();
    return found;
}

IsletError islet_world_enable_seamless_floors(IsletWorld* world, bool enable) {
    if (begin(world)) of(world).enable_seamless_floors(enable);
    return end(world);
}

IsletError islet_world_hooks(const IsletWorld* world, IsletHooks* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<Hooks>(world, out)) return why(out);
    give<Hooks>(out, of(world).hooks());
    return ISLET_ERROR_NONE;
}

IsletError islet_world_set_hooks(IsletWorld* world, const IsletHooks* hooks) {
    Room<Hooks> hooks_room;
    const Hooks* hooks_taken = nullptr;
    if (begin(world) && (hooks_taken = take<Hooks>(world, hooks, hooks_room)) != nullptr) of(world).set_hooks(*hooks_taken);
    return end(world);
}

float islet_world_hit_threshold(const IsletWorld* world) {
    float found = {};
    if (world != nullptr) found = of(world).hit_threshold();
    return found;
}

IsletError islet_world_set_hit_threshold(IsletWorld* world, float speed) {
    if (begin(world)) of(world).set_hit_threshold(speed);
    return end(world);
}

IsletError islet_world_explode(IsletWorld* world, const IsletExplosionDef* explosion) {
    Room<ExplosionDef> explosion_room;
    const ExplosionDef* explosion_taken = nullptr;
    if (begin(world) && (explosion_taken = take<ExplosionDef>(world, explosion, explosion_room)) != nullptr)
        of(world).explode(*explosion_taken);
    return end(world);
}

IsletError islet_world_capacity(const IsletWorld* world, IsletCapacity* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<Capacity>(world, out)) return why(out);
    give<Capacity>(out, of(world).capacity());
    return ISLET_ERROR_NONE;
}

IsletError islet_world_report(const IsletWorld* world, IsletStepReport* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<StepReport>(world, out)) return why(out);
    give<StepReport>(out, of(world).report());
    return ISLET_ERROR_NONE;
}

IsletErrorHook islet_world_error_hook(const IsletWorld* world) {
    IsletErrorHook found = {};
    if (world != nullptr) new (&found) ErrorHook(of(world).error_hook());
    return found;
}

void* islet_world_error_context(const IsletWorld* world) {
    void* found = {};
    if (world != nullptr) found = of(world).error_context();
    return found;
}

IsletError islet_world_set_error_hook(IsletWorld* world, IsletErrorHook hook, void* context) {
    if (begin(world)) of(world).set_error_hook(function<ErrorHook>(hook), context);
    return end(world);
}

uint64_t islet_world_step_count(const IsletWorld* world) {
    uint64_t found = {};
    if (world != nullptr) found = of(world).step_count();
    return found;
}

IsletTouchEventSpan islet_world_begin_touch_events(const IsletWorld* world) {
    span<const TouchEvent> found;
    if (world != nullptr) found = of(world).begin_touch_events();
    return {cast<const IsletTouchEvent>(found.data()), found.size()};
}

IsletTouchEventSpan islet_world_end_touch_events(const IsletWorld* world) {
    span<const TouchEvent> found;
    if (world != nullptr) found = of(world).end_touch_events();
    return {cast<const IsletTouchEvent>(found.data()), found.size()};
}

IsletSensorEventSpan islet_world_sensor_begin_events(const IsletWorld* world) {
    span<const SensorEvent> found;
    if (world != nullptr) found = of(world).sensor_begin_events();
    return {cast<const IsletSensorEvent>(found.data()), found.size()};
}

IsletSensorEventSpan islet_world_sensor_end_events(const IsletWorld* world) {
    span<const SensorEvent> found;
    if (world != nullptr) found = of(world).sensor_end_events();
    return {cast<const IsletSensorEvent>(found.data()), found.size()};
}

IsletHitEventSpan islet_world_hit_events(const IsletWorld* world) {
    span<const HitEvent> found;
    if (world != nullptr) found = of(world).hit_events();
    return {cast<const IsletHitEvent>(found.data()), found.size()};
}

IsletBodyIdSpan islet_world_moved_bodies(const IsletWorld* world) {
    span<const BodyId> found;
    if (world != nullptr) found = of(world).moved_bodies();
    return {cast<const IsletBodyId>(found.data()), found.size()};
}

IsletBodyIdSpan islet_world_slept_bodies(const IsletWorld* world) {
    span<const BodyId> found;
    if (world != nullptr) found = of(world).slept_bodies();
    return {cast<const IsletBodyId>(found.data()), found.size()};
}

uint32_t islet_world_body_count(const IsletWorld* world) {
    uint32_t found = {};
    if (world != nullptr) found = of(world).body_count();
    return found;
}

IsletBodyId islet_world_body_at(const IsletWorld* world, uint32_t slot) {
    IsletBodyId found = {};
    if (world != nullptr) new (&found) BodyId(of(world).body_at(slot));
    return found;
}

uint32_t islet_world_shape_count(const IsletWorld* world) {
    uint32_t found = {};
    if (world != nullptr) found = of(world).shape_count();
    return found;
}

IsletShapeId islet_world_shape_at(const IsletWorld* world, uint32_t slot) {
    IsletShapeId found = {};
    if (world != nullptr) new (&found) ShapeId(of(world).shape_at(slot));
    return found;
}

uint32_t islet_world_contact_count(const IsletWorld* world) {
    uint32_t found = {};
    if (world != nullptr) found = of(world).contact_count();
    return found;
}

bool islet_world_contact_at(const IsletWorld* world, uint32_t slot, IsletContactInfo* out) {
    bool found = {};
    if (world != nullptr && is_there(world, out)) found = of(world).contact_at(slot, *cast<ContactInfo>(out));
    return found;
}

}  // extern "C"
