// Functions of islet.h: world.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

size_t islet_world_bytes(const IsletCapacity* capacity) {
    Room<Capacity> capacity_room;
    const Capacity* capacity_taken = take<Capacity>(nullptr, capacity, capacity_room);
    if (capacity_taken == nullptr) return 0;
    return islet::world_bytes(*capacity_taken);
}

IsletError islet_world_step(IsletWorld* world, float dt) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).step(dt);
    return end(world, before);
}

IsletVec2 islet_world_gravity(const IsletWorld* world) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).gravity());
}

IsletError islet_world_set_gravity(IsletWorld* world, IsletVec2 gravity) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_gravity(in<Vec2>(gravity));
    return end(world, before);
}

IsletError islet_world_solver(const IsletWorld* world, IsletSolverDef* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<SolverDef>(world, out)) return why(out);
    give<SolverDef>(out, of(world).solver());
    return ISLET_ERROR_NONE;
}

IsletError islet_world_set_solver(IsletWorld* world, const IsletSolverDef* solver) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    Room<SolverDef> solver_room;
    const SolverDef* solver_taken = take<SolverDef>(world, solver, solver_room);
    if (solver_taken == nullptr) return why(solver);
    const Error before = begin(world);
    of(world).set_solver(*solver_taken);
    return end(world, before);
}

IsletError islet_world_tasks(const IsletWorld* world, IsletTaskSystem* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<TaskSystem>(world, out)) return why(out);
    give<TaskSystem>(out, of(world).tasks());
    return ISLET_ERROR_NONE;
}

IsletError islet_world_set_tasks(IsletWorld* world, const IsletTaskSystem* tasks) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    Room<TaskSystem> tasks_room;
    const TaskSystem* tasks_taken = take<TaskSystem>(world, tasks, tasks_room);
    if (tasks_taken == nullptr) return why(tasks);
    const Error before = begin(world);
    of(world).set_tasks(*tasks_taken);
    return end(world, before);
}

bool islet_world_sleep_enabled(const IsletWorld* world) {
    if (world == nullptr) return false;
    return of(world).sleep_enabled();
}

IsletError islet_world_enable_sleep(IsletWorld* world, bool enable) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).enable_sleep(enable);
    return end(world, before);
}

float islet_world_restitution_threshold(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).restitution_threshold();
}

IsletError islet_world_set_restitution_threshold(IsletWorld* world, float speed) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_restitution_threshold(speed);
    return end(world, before);
}

float islet_world_max_speed(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).max_speed();
}

IsletError islet_world_set_max_speed(IsletWorld* world, float speed) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_max_speed(speed);
    return end(world, before);
}

uint32_t islet_world_lanes(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).lanes();
}

bool islet_world_continuous(const IsletWorld* world) {
    if (world == nullptr) return false;
    return of(world).continuous();
}

IsletError islet_world_enable_continuous(IsletWorld* world, bool enable) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).enable_continuous(enable);
    return end(world, before);
}

IsletError islet_world_hooks(const IsletWorld* world, IsletHooks* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<Hooks>(world, out)) return why(out);
    give<Hooks>(out, of(world).hooks());
    return ISLET_ERROR_NONE;
}

IsletError islet_world_set_hooks(IsletWorld* world, const IsletHooks* hooks) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    Room<Hooks> hooks_room;
    const Hooks* hooks_taken = take<Hooks>(world, hooks, hooks_room);
    if (hooks_taken == nullptr) return why(hooks);
    const Error before = begin(world);
    of(world).set_hooks(*hooks_taken);
    return end(world, before);
}

float islet_world_hit_threshold(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).hit_threshold();
}

IsletError islet_world_set_hit_threshold(IsletWorld* world, float speed) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_hit_threshold(speed);
    return end(world, before);
}

IsletError islet_world_explode(IsletWorld* world, const IsletExplosionDef* explosion) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    Room<ExplosionDef> explosion_room;
    const ExplosionDef* explosion_taken = take<ExplosionDef>(world, explosion, explosion_room);
    if (explosion_taken == nullptr) return why(explosion);
    const Error before = begin(world);
    of(world).explode(*explosion_taken);
    return end(world, before);
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

uint64_t islet_world_step_count(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).step_count();
}

IsletTouchEventSpan islet_world_begin_touch_events(const IsletWorld* world) {
    if (world == nullptr) return {};
    const auto found = of(world).begin_touch_events();
    return {cast<const IsletTouchEvent>(found.data()), found.size()};
}

IsletTouchEventSpan islet_world_end_touch_events(const IsletWorld* world) {
    if (world == nullptr) return {};
    const auto found = of(world).end_touch_events();
    return {cast<const IsletTouchEvent>(found.data()), found.size()};
}

IsletSensorEventSpan islet_world_sensor_begin_events(const IsletWorld* world) {
    if (world == nullptr) return {};
    const auto found = of(world).sensor_begin_events();
    return {cast<const IsletSensorEvent>(found.data()), found.size()};
}

IsletSensorEventSpan islet_world_sensor_end_events(const IsletWorld* world) {
    if (world == nullptr) return {};
    const auto found = of(world).sensor_end_events();
    return {cast<const IsletSensorEvent>(found.data()), found.size()};
}

IsletHitEventSpan islet_world_hit_events(const IsletWorld* world) {
    if (world == nullptr) return {};
    const auto found = of(world).hit_events();
    return {cast<const IsletHitEvent>(found.data()), found.size()};
}

IsletBodyIdSpan islet_world_moved_bodies(const IsletWorld* world) {
    if (world == nullptr) return {};
    const auto found = of(world).moved_bodies();
    return {cast<const IsletBodyId>(found.data()), found.size()};
}

IsletBodyIdSpan islet_world_slept_bodies(const IsletWorld* world) {
    if (world == nullptr) return {};
    const auto found = of(world).slept_bodies();
    return {cast<const IsletBodyId>(found.data()), found.size()};
}

uint32_t islet_world_body_count(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).body_count();
}

IsletBodyId islet_world_body_at(const IsletWorld* world, uint32_t slot) {
    if (world == nullptr) return out(BodyId{});
    return out(of(world).body_at(slot));
}

uint32_t islet_world_shape_count(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).shape_count();
}

IsletShapeId islet_world_shape_at(const IsletWorld* world, uint32_t slot) {
    if (world == nullptr) return out(ShapeId{});
    return out(of(world).shape_at(slot));
}

uint32_t islet_world_contact_count(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).contact_count();
}

bool islet_world_contact_at(const IsletWorld* world, uint32_t slot, IsletContactInfo* out) {
    if (world == nullptr) return false;
    if (out == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), false;
    return of(world).contact_at(slot, *cast<ContactInfo>(out));
}

}  // extern "C"
