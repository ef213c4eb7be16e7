// What a world costs: the size of its block is known to the compiler, so it can be checked before the program is ever run.
#include <cstdio>

#include <islet/islet.hpp>

using namespace islet;

namespace {

constexpr Capacity tiny = {.bodies = 8, .shapes = 8, .contacts = 16, .geometries = 4};
static_assert(world_bytes(tiny) < 32 * 1024, "must fit the microcontroller's memory");

void print(const char* what, const Capacity& c) {
    const std::size_t bytes = world_bytes(c);
    std::printf("%-22s %7u bodies %7u shapes %7u contacts %12zu bytes, %6.0f a body\n", what, c.bodies, c.shapes, c.contacts, bytes,
                double(bytes) / double(c.bodies));
}

}  // namespace

int main() {
    print("a few crates", tiny);
    print("a small puzzle", {.bodies = 64, .shapes = 64, .contacts = 256, .geometries = 16});
    print("a platform game", {.bodies = 500, .shapes = 800, .contacts = 2000, .geometries = 200});
    print("a large pile", {.bodies = 5000, .shapes = 5000, .contacts = 20000, .geometries = 100});
    print("a benchmark", {.bodies = 22001, .shapes = 22020, .contacts = 80000, .geometries = 64});
}
