// A pyramid of 55 boxes in C, for what the C interface takes of the time; boxes.cpp is the same in C++. tools/c_cost.sh compares them.
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include <islet/islet.h>

static _Alignas(ISLET_WORLD_ALIGNMENT) char memory[600000];

/// boxes STEPS READS: steps, and reads every pose so many times after each. Prints the world's hash and the sum of what was read.
int main(int argc, char** argv) {
    const int steps = argc > 1 ? atoi(argv[1]) : 60, reads = argc > 2 ? atoi(argv[2]) : 1;
    IsletCapacity capacity = islet_default_capacity();
    capacity.bodies = capacity.shapes = 64;
    capacity.contacts = 512;
    IsletWorld* world = islet_create_world(memory, sizeof memory, &capacity, NULL, NULL);
    if (world == NULL) return 1;
    IsletBodyDef def = islet_default_body_def();
    const IsletPolygon floor = islet_make_box(20, 1), box = islet_make_box(0.5f, 0.5f);
    const IsletBodyId ground = islet_create_body(world, &def);
    islet_create_polygon(world, ground, &floor, NULL);
    IsletBodyId boxes[55];
    int count = 0;
    def.type = ISLET_BODY_TYPE_DYNAMIC;
    def.enable_sleep = false;
    for (int row = 0; row < 10; ++row) {
        for (int i = 0; i < 10 - row; ++i) {
            def.position.x = (float)i + 0.5f * (float)row;
            def.position.y = 1.5f + 1.01f * (float)row;
            boxes[count] = islet_create_body(world, &def);
            islet_create_polygon(world, boxes[count++], &box, NULL);
        }
    }
    float sum = 0;
    for (int step = 0; step < steps; ++step) {
        islet_world_step(world, 1.0f / 60);
        for (int read = 0; read < reads; ++read) {
            for (int i = 0; i < count; ++i) {
                const IsletTransform pose = islet_body_transform(world, boxes[i]);
                sum += pose.p.x + pose.p.y + pose.q.s;
            }
        }
    }
    printf("%016" PRIx64 " %.9g\n", islet_world_hash(world), (double)sum);
    return islet_world_last_error(world);
}
