// A person of a size that you give, from two files to take along: it stands, is pushed, and falls.
#include <cstdio>

#include <islet/islet.hpp>

#include "prefabs/ragdoll.hpp"

using namespace islet;
using namespace islet::samples;

static StaticWorld<Capacity{.bodies = 16, .shapes = 16, .contacts = 128, .joints = 16}> storage;

int main() {
    World& world = storage.create();
    const BodyId ground = world.create_body({});
    world.create_shape(ground, make_offset_box(20, 1, {{0, -1}}), {.friction = 0.6f});
    const Ragdoll person = create_ragdoll(world, {.height = 1.75f, .mass = 70});
    if (!person) return std::printf("no room: %s\n", describe(world.last_error())), 1;

    world.apply_linear_impulse_to_center(person[BodyPart::torso], {70, 0});
    for (int step = 0; step <= 180; ++step) {
        if (step % 45 == 0) std::printf("%4.2f s: the head is at a height of %.2f m\n", step / 60.0, double(world.position(person[BodyPart::head]).y));
        world.step(1.0f / 60);
    }
}
