// The smallest use of Islet: a crate falls on the ground. The world's memory is part of the program; nothing is allocated.
#include <cstdio>

#include <islet/islet.hpp>

using namespace islet;

static StaticWorld<Capacity{.bodies = 64, .shapes = 64, .contacts = 256, .joints = 16}> storage;

static void print_error(Error error, void*) {  // the world calls this function for every error
    std::fprintf(stderr, "islet: %s\n", describe(error));
}

int main() {
    World& world = storage.create({.gravity = {0, -10}, .error_hook = print_error});
    BodyId ground = world.create_body({});
    world.create_shape(ground, make_box(20, 1), {.friction = 0.6f});
    BodyId crate = world.create_body({.type = BodyType::dynamic, .position = {0, 8}});
    world.create_shape(crate, make_box(0.5f, 0.5f), {.density = 1});
    for (int i = 0; i < 120; ++i) world.step(1.0f / 60);
    Transform pose = world.transform(crate);
    std::printf("the crate rests at (%.3f, %.3f)\n", double(pose.p.x), double(pose.p.y));
}
