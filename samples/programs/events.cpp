// Reading events: a bouncing ball's contacts with the floor, and the step in which it falls asleep.
#include <cstdio>

#include <islet/islet.hpp>

using namespace islet;

namespace {

StaticWorld<Capacity{.bodies = 8, .shapes = 8, .contacts = 16}> storage;

/// Events name shapes; the user data of a shape says what it is to the program.
const char* name_of(const World& world, ShapeId shape) {
    static const char* const names[] = {"floor", "ball"};
    return world.is_valid(shape) ? names[world.user_data(shape)] : "something gone";
}

}  // namespace

int main() {
    World& world = storage.create();
    const BodyId ground = world.create_body({});
    world.create_shape(ground, make_box(10, 1), {.user_data = 0});
    const BodyId ball = world.create_body({.type = BodyType::dynamic, .position = {0, 4}});
    world.create_shape(ball, Circle{.radius = 0.5f}, {.restitution = 0.6f, .user_data = 1});

    for (int step = 1; step <= 600; ++step) {
        world.step(1.0f / 60);
        const double time = step / 60.0;
        for (const TouchEvent& e : world.begin_touch_events()) {
            std::printf("%5.2f s  %s and %s begin to touch\n", time, name_of(world, e.shape_a), name_of(world, e.shape_b));
        }
        for (const TouchEvent& e : world.end_touch_events()) {
            std::printf("%5.2f s  %s and %s part\n", time, name_of(world, e.shape_a), name_of(world, e.shape_b));
        }
        for (const BodyId body : world.slept_bodies()) {
            if (body == ball) std::printf("%5.2f s  the ball falls asleep at height %.2f m\n", time, double(world.position(ball).y));
        }
    }
}
