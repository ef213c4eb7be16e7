// Small programs, one for each kind of thing that a game does. Joints, chains and hooks are in machines.c, fleets in fleets.c.
#include "kinds.h"

#include <islet/islet.h>
#include <islet/islet_lcp.h>
#include <string.h>

static _Alignas(ISLET_WORLD_ALIGNMENT) char block[1 << 23];
static uint64_t sum;

static void note(uint64_t word) { sum = with_word(sum, word); }
static void note_float(float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    note(bits);
}
static void note_vec(IsletVec2 v) {
    note_float(v.x);
    note_float(v.y);
}
static void note_bytes(const void* bytes, size_t count) {
    for (size_t i = 0; i < count; ++i) note(((const unsigned char*)bytes)[i]);
}

/// A pyramid of boxes on the ground, and a ball that flies into it.
static IsletWorld* pyramid(int rows) {
    sum = 14695981039346656037u;
    IsletCapacity capacity = islet_default_capacity();
    capacity.bodies = capacity.shapes = 1000;
    capacity.contacts = 6000;
    IsletWorld* world = islet_create_world(block, sizeof block, &capacity, NULL, NULL);
    IsletBodyDef def = islet_default_body_def();
    const IsletPolygon floor = islet_make_box(60, 1), box = islet_make_box(0.5f, 0.5f);
    islet_create_polygon(world, islet_create_body(world, &def), &floor, NULL);
    def.type = ISLET_BODY_TYPE_DYNAMIC;
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < rows - row; ++i) {
            def.position.x = (float)i + 0.5f * (float)row;
            def.position.y = 1.5f + (float)row;
            islet_create_polygon(world, islet_create_body(world, &def), &box, NULL);
        }
    }
    def.position.x = -8;
    def.position.y = 3;
    def.linear_velocity.x = 12;
    IsletShapeDef material = islet_default_shape_def();
    material.hit_events = true;
    const IsletCircle ball = islet_default_circle();
    islet_create_circle(world, islet_create_body(world, &def), &ball, &material);
    return world;
}

uint64_t stack_of_c(void) {
    IsletWorld* world = pyramid(5);
    for (int i = 0; i < 90; ++i) {
        islet_world_step(world, 1.0f / 60);
        note(islet_world_hash(world));
    }
    return sum;
}

uint64_t events_of_c(void) {
    IsletWorld* world = pyramid(5);
    for (int i = 0; i < 120; ++i) {
        islet_world_step(world, 1.0f / 60);
        const IsletTouchEventSpan begun = islet_world_begin_touch_events(world), ended = islet_world_end_touch_events(world);
        for (size_t k = 0; k < begun.count; ++k) note(begun.data[k].shape_a.index1 * 1000u + begun.data[k].shape_b.index1);
        for (size_t k = 0; k < ended.count; ++k) note(ended.data[k].shape_a.index1 * 1000u + ended.data[k].shape_b.index1);
        const IsletHitEventSpan hits = islet_world_hit_events(world);
        for (size_t k = 0; k < hits.count; ++k) {
            note_vec(hits.data[k].point);
            note_float(hits.data[k].speed);
        }
    }
    return sum;
}

uint64_t queries_of_c(void) {
    IsletWorld* world = pyramid(5);
    for (int i = 0; i < 60; ++i) {
        islet_world_step(world, 1.0f / 60);
        const IsletVec2 from = {-10, 0.1f * (float)i}, along = {20, 0}, near = {0.1f * (float)i, 4};
        const IsletQueryHit hit = islet_world_cast_ray(world, from, along, NULL);
        note(hit.shape.index1);
        note_vec(hit.point);
        note_vec(hit.normal);
        note_float(hit.fraction);
        const IsletClosestHit closest = islet_world_closest(world, near, 3, NULL);
        note(closest.shape.index1);
        note_float(closest.distance);
        const IsletCircle circle = {near, 1};
        const IsletShapeProxy proxy = islet_make_circle_proxy(&circle);
        IsletShapeId found[8];
        const uint32_t count = islet_world_overlap_shape(world, &proxy, found, 8, NULL);
        note(count);
        for (uint32_t k = 0; k < count && k < 8; ++k) note(found[k].index1);
    }
    return sum;
}

uint64_t mover_of_c(void) {
    IsletWorld* world = pyramid(5);
    const IsletMoverDef def = islet_default_mover_def();
    IsletMoverInput input = islet_default_mover_input();
    IsletMoverState hero = {{-3, 2}, {0, 0}, {0, 0}, {0, 0}, {0, 0}, 0};
    for (int i = 0; i < 120; ++i) {
        input.walk = 4;
        input.jump = i % 40 == 39 ? 5.0f : 0.0f;
        islet_world_step(world, 1.0f / 60);
        note(islet_step_mover(world, &def, &hero, &input, 1.0f / 60));
        note_vec(hero.position);
        note_vec(hero.velocity);
        note(hero.ground.index1);
    }
    return sum;
}

uint64_t snapshots_of_c(void) {
    static uint64_t before[1 << 13], after[1 << 13], packed[1 << 13], back[1 << 13];
    IsletWorld* world = pyramid(5);
    for (int i = 0; i < 30; ++i) islet_world_step(world, 1.0f / 60);
    const size_t first = islet_world_save(world, before, sizeof before);
    for (int i = 0; i < 30; ++i) islet_world_step(world, 1.0f / 60);
    const size_t second = islet_world_save(world, after, sizeof after);
    const uint64_t reached = islet_world_hash(world);
    const size_t bytes = islet_delta(before, first, after, second, packed, sizeof packed, NULL);
    note(first);
    note(second);
    note(bytes);
    note_bytes(packed, bytes);
    note(islet_world_restore(world, before, first));
    note(islet_world_hash(world));
    note(islet_apply(before, first, packed, bytes, back, sizeof back, NULL));
    note(islet_world_restore(world, back, second));
    note(islet_world_hash(world) == reached);
    return sum;
}

uint64_t recording_of_c(void) {
    static uint64_t tape[1 << 14];
    IsletWorld* world = pyramid(5);
    note(islet_world_start_recording(world, tape, sizeof tape, true));
    for (int i = 0; i < 60; ++i) {
        const IsletVec2 gravity = {0.1f * (float)(i % 5), -10};
        islet_world_set_gravity(world, gravity);
        islet_world_step(world, 1.0f / 60);
    }
    const size_t bytes = islet_world_stop_recording(world);
    note(bytes);
    note_bytes(tape, bytes);
    IsletReplayResult result = islet_default_replay_result();
    islet_replay(world, tape, bytes, UINT64_MAX, &result);
    note(result.end);
    note(result.steps);
    note(islet_world_hash(world));
    return sum;
}

/// Takes the last task first, as threads may.
static void backwards(void* context, uint32_t count, void (*task)(void* data, uint32_t index), void* data) {
    (void)context;
    note(count);
    while (count > 0) task(data, --count);
}

uint64_t tasks_of_c(void) {
    IsletWorld* world = pyramid(40);
    IsletTaskSystem tasks = islet_default_task_system();
    tasks.parallel_for = backwards;
    tasks.workers = 3;
    note(islet_world_set_tasks(world, &tasks));
    for (int i = 0; i < 10; ++i) islet_world_step(world, 1.0f / 60);
    note(islet_world_hash(world));
    return sum;
}

static void draw_polygon(const IsletVec2* corners, size_t count, float radius, const IsletDrawStyle* style, void* context) {
    (void)context;
    for (size_t i = 0; i < count; ++i) note_vec(corners[i]);
    note_float(radius);
    note(style->color);
}
static void draw_circle(IsletVec2 center, float radius, IsletVec2 axis, const IsletDrawStyle* style, void* context) {
    (void)context;
    note_vec(center);
    note_float(radius);
    note_vec(axis);
    note(style->color);
}
static void draw_point(IsletVec2 point, const IsletDrawStyle* style, void* context) {
    (void)context;
    note_vec(point);
    note(style->part);
}

uint64_t drawing_of_c(void) {
    IsletWorld* world = pyramid(5);
    IsletDebugDraw draw = islet_default_debug_draw();
    draw.polygon = draw_polygon;
    draw.circle = draw_circle;
    draw.point = draw_point;
    draw.contacts = true;
    for (int i = 0; i < 60; ++i) islet_world_step(world, 1.0f / 60);
    islet_world_draw(world, &draw);
    return sum;
}

uint64_t matrix_of_c(void) {
    const float m[] = {2, -1, 0, -1, 2, -1, 0, -1, 2}, q[] = {-1, 0.5f, -1};
    float x[3] = {0};
    char workspace[512];
    sum = 14695981039346656037u;
    IsletLcpProblem problem = islet_lcp_default_problem();
    problem.row_count = 3;
    problem.dense = m;
    problem.q = q;
    note(islet_lcp_solve(&problem, NULL, x, workspace, sizeof workspace, NULL));
    for (int i = 0; i < 3; ++i) note_float(x[i]);
    return sum;
}
