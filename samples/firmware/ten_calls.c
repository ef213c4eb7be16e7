// Ten functions of the C interface, for what it adds in flash to what ten_calls.cpp takes, which does the same in C++. tools/footprint.sh --c compares them.
#include <islet/islet.h>

static _Alignas(ISLET_WORLD_ALIGNMENT) char memory[40000];

/// Drops a crate, pushes it for a second, and says where it is then and how fast. The error that the world recorded.
int ten_calls(float found[4]);
int ten_calls(float found[4]) {
    IsletCapacity capacity = islet_default_capacity();
    capacity.bodies = capacity.shapes = 16;
    capacity.contacts = 48;
    capacity.joints = 0;
    capacity.geometries = 4;
    IsletError error = ISLET_ERROR_NONE;
    IsletWorld* world = islet_create_world(memory, sizeof memory, &capacity, NULL, &error);
    IsletBodyDef def = islet_default_body_def();
    const IsletBodyId ground = islet_create_body(world, &def);
    def.type = ISLET_BODY_TYPE_DYNAMIC;
    def.position.y = 2;
    const IsletBodyId crate = islet_create_body(world, &def);
    const IsletPolygon floor = islet_make_box(20, 1), box = islet_make_box(0.5f, 0.5f);
    islet_create_polygon(world, ground, &floor, NULL);
    islet_create_polygon(world, crate, &box, NULL);
    const IsletCircle ball = {{0, 0.5f}, 0.25f};
    islet_create_circle(world, crate, &ball, NULL);
    for (int i = 0; i < 60; ++i) {
        const IsletVec2 force = {2, 0};
        islet_body_apply_force_to_center(world, crate, force, true);
        islet_world_step(world, 1.0f / 60);
    }
    const IsletVec2 p = islet_body_position(world, crate), v = islet_body_linear_velocity(world, crate);
    found[0] = p.x;
    found[1] = p.y;
    found[2] = v.x;
    found[3] = v.y;
    return islet_world_last_error(world);
}
