// The sample: a few scenes, stepped in one block of static memory. A line for each says what came out and what it cost:
//
//   pyramid steps 60 hash 0123456789abcdef instructions 812345 most 912345
//
// with the mean and the largest number of instructions of a step. The hashes are the same on every machine.
#include "board.hpp"
#include "console.hpp"
#include "floats.hpp"
#include "scenes.hpp"

namespace firmware {
namespace {

constexpr int steps = 60;  // at 1/60 s

islet::StaticWorld<scene_capacity> storage;

/// (The builder is a template's argument, not a pointer, so that the calls, and with them the stack, can be followed.)
template <void build(islet::World&)>
bool play(const char* name) {
    islet::World& world = storage.create();
    build(world);
    std::uint64_t sum = 0, most = 0;
    for (int i = 0; i < steps; ++i) {
        disturb_floats(true);
        const std::uint64_t before = instructions();
        world.step(1.0f / 60);
        const std::uint64_t taken = instructions() - before;
        disturb_floats(false);
        sum += taken;
        most = taken > most ? taken : most;
    }
    print(name);
    print(" steps ");
    print_decimal(steps);
    print(" hash ");
    print_hash(world.hash());
    print(" instructions ");
    print_decimal(static_cast<std::uint32_t>(sum) / steps);
    print(" most ");
    print_decimal(static_cast<std::uint32_t>(most));
    print("\n");
    if (world.last_error() == islet::Error::none) return true;
    print("error ");  // the number: islet::describe would bring all its sentences into the image
    print_decimal(static_cast<std::uint32_t>(world.last_error()));
    print("\n");
    return false;
}

struct Size {
    islet::Capacity capacity;
    std::size_t bytes = islet::world_bytes(capacity);
};

/// What worlds of some capacities need, all included: "world <bodies> <shapes> <contacts> <joints> <geometries> <bytes>".
void print_sizes() {
    static constexpr Size sizes[] = {
        {{16, 16, 48, 0, 4}}, {{32, 32, 96, 8, 8}}, {{64, 64, 192, 0, 8}}, {{64, 64, 192, 16, 8}}, {{64, 64, 192, 16, 64}}, {{256, 256, 1024, 16, 16}}};
    for (const Size& s : sizes) {
        const islet::Capacity& c = s.capacity;
        print("world");
        for (const std::uint32_t n : {c.bodies, c.shapes, c.contacts, c.joints, c.geometries, static_cast<std::uint32_t>(s.bytes)}) {
            print(" ");
            print_decimal(n);
        }
        print("\n");
    }
}

}  // namespace

int run() {
    print_sizes();
    // All of them, whatever the first ones come to.
    bool good = play<build_pyramid>("pyramid");
    good = play<build_ragdoll>("ragdoll") && good;
    good = play<build_circles>("circles") && good;
    good = play<build_machine>("machine") && good;
    good = play<build_ordered_machine>("ordered") && good;
    print("floats steps 20000 hash ");
    print_hash(hash_floats(20000));
    print("\n");
    print("stack ");
    print_decimal(static_cast<std::uint32_t>(stack_used()));
    print("\n");
    return good ? 0 : 1;
}

}  // namespace firmware
