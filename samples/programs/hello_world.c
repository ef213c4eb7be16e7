// The smallest use of Islet from C: a crate falls on the ground. The world's memory is part of the program; nothing is allocated.
#include <stdio.h>

#include <islet/islet.h>

static _Alignas(ISLET_WORLD_ALIGNMENT) char memory[250000];

int main(void) {
    IsletCapacity capacity = islet_default_capacity();
    capacity.bodies = capacity.shapes = 64;
    capacity.contacts = 256;
    IsletError error;
    IsletWorld* world = islet_create_world(memory, sizeof memory, &capacity, NULL, &error);
    if (world == NULL) return puts(islet_describe(error)), 1;
    IsletBodyDef def = islet_default_body_def();
    IsletBodyId ground = islet_create_body(world, &def);
    def.type = ISLET_BODY_TYPE_DYNAMIC;
    def.position.y = 8;
    IsletBodyId crate = islet_create_body(world, &def);
    IsletPolygon floor = islet_make_box(20, 1), box = islet_make_box(0.5f, 0.5f);
    islet_create_polygon(world, ground, &floor, NULL);
    islet_create_polygon(world, crate, &box, NULL);
    for (int i = 0; i < 120; ++i) islet_world_step(world, 1.0f / 60);
    IsletVec2 p = islet_body_position(world, crate);
    printf("the crate rests at (%.3f, %.3f)\n", (double)p.x, (double)p.y);
    return islet_world_last_error(world);
}
