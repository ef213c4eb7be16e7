// Boxes and discs tumble into a pit for five seconds; prints the hash of the world every second. What is computed here is exact (small
// binary fractions), so that only the engine could tell one set of compiler flags from another.
#include <cinttypes>
#include <cstdio>

#include <islet/islet.hpp>

using namespace islet;

static StaticWorld<Capacity{.bodies = 64, .shapes = 64, .contacts = 512}> storage;

int main() {
    World& world = storage.create();
    const BodyId pit = world.create_body({});
    world.create_shape(pit, make_offset_box(6, 1, {{0, -1}, {}}));
    world.create_shape(pit, make_offset_box(1, 4, {{-5, 3}, make_rot(0.25f)}));
    world.create_shape(pit, make_offset_box(1, 4, {{5, 3}, make_rot(-0.25f)}));

    for (int i = 0; i < 48; ++i) {
        const float x = static_cast<float>(i % 6) - 2.5f, y = 3.0f + 1.25f * static_cast<float>(i / 6);
        const BodyId body = world.create_body({.type = BodyType::dynamic, .position = {x, y}, .angle = 0.125f * static_cast<float>(i)});
        if (i % 3 == 0) {
            world.create_shape(body, Circle{{}, 0.4f});
        } else {
            world.create_shape(body, make_box(0.45f, 0.3f));
        }
    }

    for (int second = 1; second <= 5; ++second) {
        for (int i = 0; i < 60; ++i) world.step(1.0f / 60);
        std::printf("%d s: %016" PRIx64 "\n", second, world.hash());
    }
    return world.last_error() == Error::none ? 0 : 1;
}
