// Ten functions of the engine, called as ten_calls.c calls them through the C interface.
#include <cstddef>

#include <islet/islet.hpp>

using namespace islet;

alignas(world_alignment) static std::byte memory[40000];

extern "C" int ten_calls(float found[4]) {
    Capacity capacity;
    capacity.bodies = capacity.shapes = 16;
    capacity.contacts = 48;
    capacity.joints = 0;
    capacity.geometries = 4;
    Error error = Error::none;
    World* const made = World::create(memory, capacity, {}, &error);
    if (made == nullptr) return static_cast<int>(error);
    World& world = *made;
    BodyDef def;
    const BodyId ground = world.create_body(def);
    def.type = BodyType::dynamic;
    def.position.y = 2;
    const BodyId crate = world.create_body(def);
    const Polygon floor = make_box(20, 1), box = make_box(0.5f, 0.5f);
    world.create_shape(ground, floor);
    world.create_shape(crate, box);
    world.create_shape(crate, Circle{{0, 0.5f}, 0.25f});
    for (int i = 0; i < 60; ++i) {
        world.apply_force_to_center(crate, {2, 0});
        world.step(1.0f / 60);
    }
    const Vec2 p = world.position(crate), v = world.linear_velocity(crate);
    found[0] = p.x;
    found[1] = p.y;
    found[2] = v.x;
    found[3] = v.y;
    return static_cast<int>(world.last_error());
}
