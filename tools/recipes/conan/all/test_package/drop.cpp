// A box falls onto the ground; 0 if it lies there after two seconds.
#include <cstdio>

#include <islet/islet.hpp>
#include <islet/version.hpp>

using namespace islet;

static StaticWorld<Capacity{.bodies = 2, .shapes = 2, .contacts = 4}> storage;

int main() {
    World& world = storage.create();
    world.create_shape(world.create_body({}), make_box(10, 1));
    const BodyId box = world.create_body({.type = BodyType::dynamic, .position = {0, 3}});
    world.create_shape(box, make_box(0.5f, 0.5f));
    for (int i = 0; i < 120; ++i) world.step(1.0f / 60);
    const float height = world.position(box).y;  // m; the ground's top is at 1, the box's middle half a metre above
    std::printf("Islet %s: the box lies at %.3f m\n", ISLET_VERSION_STRING, double(height));
    return height > 1.49f && height < 1.51f ? 0 : 1;
}
