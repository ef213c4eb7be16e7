// What WebAssembly has beyond the C interface: functions of JavaScript that the engine calls, and the poses of all bodies in one array.
#include <islet/islet.h>

#define ISLET_JS_IMPORT(name) [[clang::import_module("islet"), clang::import_name(#name)]]

extern "C" {

ISLET_JS_IMPORT(filter) bool islet_js_filter(IsletShapeId a, IsletShapeId b, void* context);
ISLET_JS_IMPORT(preSolve) void islet_js_pre_solve(IsletPreSolve* contact, void* context);
ISLET_JS_IMPORT(mixFriction) float islet_js_mix_friction(float a, uint32_t material_a, float b, uint32_t material_b, void* context);
ISLET_JS_IMPORT(mixRestitution) float islet_js_mix_restitution(float a, uint32_t material_a, float b, uint32_t material_b, void* context);
ISLET_JS_IMPORT(error) void islet_js_error(IsletError error, void* context);
ISLET_JS_IMPORT(cast) float islet_js_cast(const IsletQueryHit* hit, void* context);
ISLET_JS_IMPORT(overlap) bool islet_js_overlap(IsletShapeId shape, void* context);
ISLET_JS_IMPORT(collides) bool islet_js_collides(const IsletSurface* surface, void* context);
ISLET_JS_IMPORT(clock) uint64_t islet_js_clock(void* context);

/// The address of one of the above, in the order that generate.py and islet.js know.
void* islet_js_callback(uint32_t which) {
    static const struct Address {
        void* at;
    } addresses[] = {{(void*)islet_js_filter},          {(void*)islet_js_pre_solve}, {(void*)islet_js_mix_friction},
                     {(void*)islet_js_mix_restitution}, {(void*)islet_js_error},     {(void*)islet_js_cast},
                     {(void*)islet_js_overlap},         {(void*)islet_js_collides},  {(void*)islet_js_clock}};
    return which < sizeof addresses / sizeof *addresses ? addresses[which].at : nullptr;
}

/// For each slot of a body: x, y, cosine and sine to `poses`, and to `states` 0 if the slot is free, else 1 + the body's type, 8 more if it is awake, 16 more if
/// it is a bullet. Returns the slots up to the last that is taken.
uint32_t islet_js_poses(const IsletWorld* world, float* poses, uint8_t* states, uint32_t slots) {
    uint32_t used = 0;
    const uint32_t bodies = islet_world_body_count(world);
    uint32_t found = 0;
    for (uint32_t slot = 0; slot < slots; ++slot) {
        states[slot] = 0;
        if (found == bodies) continue;
        const IsletBodyId body = islet_world_body_at(world, slot);
        if (body.index1 == 0) continue;
        ++found;
        used = slot + 1;
        const IsletTransform pose = islet_body_transform(world, body);
        float* const to = poses + 4 * slot;
        to[0] = pose.p.x;
        to[1] = pose.p.y;
        to[2] = pose.q.c;
        to[3] = pose.q.s;
        states[slot] = uint8_t(1 + islet_body_type(world, body) + (islet_body_is_awake(world, body) ? 8 : 0) + (islet_body_is_bullet(world, body) ? 16 : 0));
    }
    return used;
}

}  // extern "C"
