// The sample: three scenes, stepped in one block of static memory. A line for each says what came out and what it cost:
//
//   pyramid steps 60 hash 0123456789abcdef instructions 812345 most 912345
//
// with the mean and the largest number of instructions of a step. The hashes are the same on every machine.
#include "board.hpp"
#include "console.hpp"
#include "scenes.hpp"

namespace firmware {
namespace {

constexpr int steps = 60;  // at 1/60 s

islet::StaticWorld<scene_capacity> storage;

bool play(const char* name, void (*build)(islet::World&)) {
    islet::World& world = storage.create();
    build(world);
    std::uint64_t sum = 0, most = 0;
    for (int i = 0; i < steps; ++i) {
        const std::uint64_t before = instructions();
        world.step(1.0f / 60);
        const std::uint64_t taken = instructions() - before;
        sum += taken;
        most = taken > most ? taken : most;
    }
    print(name);
    print(" steps ");
    print_decimal(steps);
    print(" hash ");
    print_hash(world.hash());
    print(" instructions ");
    print_decimal(sum / steps);
    print(" most ");
    print_decimal(most);
    print("\n");
    if (world.last_error() == islet::Error::none) return true;
    print(islet::describe(world.last_error()));
    print("\n");
    return false;
}

}  // namespace

int run() {
    const bool good = play("pyramid", build_pyramid) & play("ragdoll", build_ragdoll) & play("circles", build_circles);
    print("stack ");
    print_decimal(stack_used());
    print("\n");
    return good ? 0 : 1;
}

}  // namespace firmware
