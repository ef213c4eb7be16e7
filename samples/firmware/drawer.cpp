// What a board from the drawer does: ten boxes and a ball, with 64 kB of flash and 16 kB of memory, in the small profile. Prints a line as firmware.cpp
// does, and the bytes of the world. The host prints the same hash from the whole engine: sleep, continuous collision and seamless floors, which the small
// profile leaves out, are off.
#include <islet/islet.hpp>

#include "board.hpp"
#include "console.hpp"

namespace firmware {

using namespace islet;

namespace {

constexpr int steps = 120;  // at 1/60 s

using Storage = StaticWorld<Capacity{.bodies = 12, .shapes = 12, .contacts = 30, .joints = 0, .geometries = 3, .hits = 5, .events = 16}>;
Storage storage;

BodyId add(World& world, Vec2 position) { return world.create_body({.type = BodyType::dynamic, .position = position}); }

}  // namespace

int run() {
    World& world = storage.create({.gravity = {0, -10}, .enable_sleep = false, .continuous = false, .seamless_floors = false});
    world.create_shape(world.create_body({}), make_box(10, 1));
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4 - row; ++column) {
            const float x = 0.6f * static_cast<float>(row) + 1.2f * static_cast<float>(column);
            world.create_shape(add(world, {x, 1.5f + static_cast<float>(row)}), make_box(0.5f, 0.5f));
        }
    }
    const BodyId ball = add(world, {-4, 2.5f});
    world.create_shape(ball, Circle{{}, 0.5f}, {.restitution = 0.4f, .density = 4});
    world.set_linear_velocity(ball, {8, 1});

    std::uint64_t sum = 0, most = 0;
    for (int i = 0; i < steps; ++i) {
        const std::uint64_t before = instructions();
        world.step(1.0f / 60);
        const std::uint64_t taken = instructions() - before;
        sum += taken;
        most = taken > most ? taken : most;
    }
    print("drawer steps ");
    print_decimal(steps);
    print(" hash ");
    print_hash(world.hash());
    print(" instructions ");
    print_decimal(static_cast<std::uint32_t>(sum) / steps);
    print(" most ");
    print_decimal(static_cast<std::uint32_t>(most));
    print("\nmemory ");
    print_decimal(static_cast<std::uint32_t>(Storage::bytes));
    print("\nstack ");
    print_decimal(static_cast<std::uint32_t>(stack_used()));
    print("\n");
    if (world.last_error() == Error::none) return 0;
    print("error ");
    print_decimal(static_cast<std::uint32_t>(world.last_error()));
    print("\n");
    return 1;
}

}  // namespace firmware
