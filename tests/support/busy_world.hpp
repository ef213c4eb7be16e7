// A small world in which everything there is occurs: all shapes, all joints, bodies at rest, asleep and in flight, destroyed slots, touches that
// ended and were not reported yet. Nothing here allocates.
#pragma once

#include "joint_world.hpp"

namespace islet::test {

inline constexpr Capacity busy_capacity{.bodies = 40, .shapes = 64, .contacts = 160, .joints = 16};

inline void fill_busy(World& w) {
    add_machine(w, {0, 0});
    const auto add = [&](Vec2 at, const auto& geometry, const ShapeDef& shape = {}) {
        const BodyId body = w.create_body({.type = BodyType::dynamic, .position = at, .angle = 0.1f * at.x});
        w.create_shape(body, geometry, shape);
        return body;
    };
    const BodyId ground = w.create_body({.position = {30, 0}});
    const Vec2 hills[] = {{12, 1}, {6, 0}, {0, 0.5f}, {-6, 0}, {-12, 2}};
    w.create_chain(ground, hills, false, {.restitution = 0.3f});
    w.create_shape(ground, Segment{{-12, 4}, {-11, 8}});
    const BodyId sleeper = add({52, 0.6f}, make_box(0.5f, 0.5f));
    const BodyId floor = w.create_body({.position = {52, -1}});
    w.create_shape(floor, make_box(5, 1));
    for (int i = 0; i < 60; ++i) w.step(1.0f / 60);  // until the box sleeps

    BodyId pile[10];
    for (int i = 0; i < 10; ++i) {
        const Vec2 at = {28 + 0.9f * static_cast<float>(i % 4), 1.5f + 0.8f * static_cast<float>(i / 4)};
        switch (i % 4) {
        case 0: pile[i] = add(at, Circle{{0.05f, 0}, 0.35f}, {.rolling_resistance = 0.02f}); break;
        case 1: pile[i] = add(at, make_box(0.4f, 0.3f), {.friction = 0.3f, .tangent_speed = 0.5f}); break;
        case 2: pile[i] = add(at, Capsule{{-0.2f, 0}, {0.2f, 0}, 0.25f}, {.restitution = 0.6f}); break;
        default: pile[i] = add(at, make_rounded_box(0.25f, 0.2f, 0.1f)); break;
        }
    }
    const BodyId paddle = w.create_body({.type = BodyType::kinematic, .position = {30, 1}, .angular_velocity = 1});
    w.create_shape(paddle, make_box(1, 0.1f));
    for (int i = 0; i < 40; ++i) w.step(1.0f / 60);
    w.destroy_body(pile[3]);
    w.destroy_body(pile[1]);
    w.set_linear_velocity(pile[8], {30, 10});
    w.apply_force_to_center(pile[9], {3, 4});
    w.set_user_data(sleeper, 0x0123456789abcdefull);
}

}  // namespace islet::test
