#include "film.hpp"
#include "prefabs/bridge.hpp"
#include "prefabs/car.hpp"
#include "prefabs/chain.hpp"

namespace islet::pictures {
namespace {

constexpr float dt = 1.0f / 60;
constexpr Capacity capacity = {.bodies = 128, .shapes = 192, .contacts = 1024, .joints = 64};
StaticWorld<capacity> storage;

void add_land(World& world) {
    const BodyId land = world.create_body({});
    const ShapeDef rough = {.friction = 0.8f};
    world.create_shape(land, make_offset_box(20, 1, {{10, -1}, {}}), rough);
    const Vec2 ramp[] = {{0.2f, 0}, {4.4f, 0}, {4.4f, 1.3f}, {3.4f, 1.2f}};
    world.create_shape(land, make_polygon(compute_hull(ramp)), rough);
    const Vec2 jump[] = {{8.6f, 0}, {11.2f, 0}, {11.2f, 1.85f}, {8.6f, 1.3f}};
    world.create_shape(land, make_polygon(compute_hull(jump)), rough);
}

void add_pyramid(World& world, Vec2 corner, int rows) {
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < rows - row; ++i) {
            const Vec2 place = {corner.x + 0.5f * (static_cast<float>(i) + 0.5f * static_cast<float>(row + 1)), corner.y + 0.25f + 0.5f * static_cast<float>(row)};
            world.create_shape(world.create_body({.type = BodyType::dynamic, .position = place}), make_box(0.245f, 0.25f), {.friction = 0.6f, .density = 4});
        }
    }
}

void add_hinge(World& world, BodyId a, BodyId b, Vec2 point) {
    world.create_joint(RevoluteJointDef{.base = {.body_a = a,
                                                 .body_b = b,
                                                 .frame_a = {inv_transform_point(world.transform(a), point)},
                                                 .frame_b = {inv_transform_point(world.transform(b), point)}}});
}

/// A ball on a chain of capsules, held at `from`; it starts at `to`.
void add_ball(World& world, Vec2 from, Vec2 to) {
    constexpr int links = 12;
    const Vec2 along = (1.0f / links) * (to - from);
    const float angle = atan2(along.y, along.x);
    BodyId before = world.create_body({.position = from});
    world.create_shape(before, Circle{{}, 0.12f}, {.filter = {.mask = 0}});
    for (int i = 0; i < links; ++i) {
        const BodyId link = world.create_body({.type = BodyType::dynamic, .position = from + (static_cast<float>(i) + 0.5f) * along, .angle = angle});
        const float half = 0.5f * length(along);
        world.create_shape(link, Capsule{{-half, 0}, {half, 0}, 0.05f}, {.density = 20, .filter = {.mask = 0}});
        add_hinge(world, before, link, from + static_cast<float>(i) * along);
        before = link;
    }
    const BodyId ball = world.create_body({.type = BodyType::dynamic, .position = to});
    world.create_shape(ball, Circle{{}, 0.55f}, {.density = 40});
    add_hinge(world, before, ball, to);
}

}  // namespace

std::string opening_film() {
    constexpr float seconds = 7;
    const Camera camera = {.lower = {0, -0.45f}, .scale = 52, .left = 0, .bottom = 380};
    World& world = storage.create({.gravity = {0, -10}});
    add_land(world);
    BodyId planks[18], parts[3];
    JointId hinges[17], struts[2];
    samples::spawn(world, samples::BridgeDef{.from = {4.4f, 1.22f}, .to = {8.6f, 1.22f}, .planks = 12, .density = 20, .friction = 0.9f}, planks, hinges);
    add_pyramid(world, {12.9f, 0}, 8);
    add_ball(world, {14.6f, 8.6f}, {8.6f, 7.4f});
    const samples::Spawned car = samples::spawn(world, samples::CarDef{.position = {-1.6f, 0.02f}}, parts, struts);
    samples::drive(world, car, 8);

    Film film(world, camera, 960, 380, seconds);
    film.shoot(world);
    for (int i = 0; i < static_cast<int>(seconds / dt); ++i) {
        if (i == 230) samples::drive(world, car, 0);
        world.step(dt);
        if (i % 2 == 1) film.shoot(world);
    }
    return film.svg();
}

}  // namespace islet::pictures
