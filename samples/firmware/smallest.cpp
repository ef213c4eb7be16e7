// The smallest use: boxes and balls that meet. What is not called here (joints, other shapes, texts) is not in the image; tools/footprint.sh measures it.
#include <islet/islet.hpp>

#include "board.hpp"
#include "console.hpp"

namespace firmware {

using namespace islet;

static StaticWorld<Capacity{.bodies = 16, .shapes = 16, .contacts = 48, .joints = 0, .geometries = 4}> storage;

int run() {
    World& world = storage.create({.gravity = {0, -10}});
    const BodyId ground = world.create_body({});
    world.create_shape(ground, make_box(20, 1));
    const BodyId crate = world.create_body({.type = BodyType::dynamic, .position = {0, 2}});
    world.create_shape(crate, make_box(0.5f, 0.5f));
    const BodyId ball = world.create_body({.type = BodyType::dynamic, .position = {0.2f, 4}});
    world.create_shape(ball, Circle{{}, 0.5f});
    for (int i = 0; i < 60; ++i) world.step(1.0f / 60);
    // Where they are, in millimetres.
    for (const BodyId body : {crate, ball}) {
        print_decimal(static_cast<std::uint32_t>(1000 * world.transform(body).p.y));
        print("\n");
    }
    return 0;
}

}  // namespace firmware
