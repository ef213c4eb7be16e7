#include "match.hpp"

#include <utility>

#include "link.hpp"

namespace islet::rollback {

namespace {

constexpr std::uint64_t crate_mark = 1ull << 32;  // in a crate's user data, above the frame it was thrown in

samples::Scene with_room(samples::Scene scene, std::uint32_t lanes) {
    scene.world.lanes = lanes;
    scene.extra_bodies += player_count + Match::most_crates;
    scene.extra_shapes += player_count + Match::most_crates;
    scene.extra_contacts += 40 * (player_count + Match::most_crates);
    return scene;
}

}  // namespace

Match::Match(samples::Scene scene, std::uint32_t lanes) : dt_(scene.dt) {
    const float middle = 0.5f * (scene.view.lower.x + scene.view.upper.x);
    engine_.load(with_room(std::move(scene), lanes));
    for (int i = 0; i < player_count; ++i) {
        const float side = i == 0 ? -1.0f : 1.0f;
        balls_[i] = world().create_body({.type = BodyType::dynamic, .position = {middle + 3 * side, 9}, .linear_damping = 0.5f, .enable_sleep = false});
        world().create_shape(balls_[i], Circle{{}, 0.4f}, {.restitution = 0.3f, .density = 4});
    }
}

void Match::advance(const Input (&inputs)[player_count]) {
    constexpr float strength = 60;  // N
    for (int i = 0; i < player_count; ++i) {
        const Input& input = inputs[i];
        world().apply_force_to_center(balls_[i], {strength * input.push_x, 1.5f * strength * input.push_y});
        // Who falls off the world comes back in on top.
        const Vec2 at = world().position(balls_[i]);
        if (at.y < -20 || abs(at.x) > 60) {
            world().set_transform(balls_[i], {i == 0 ? -3.0f : 3.0f, 12}, 0);
            world().set_linear_velocity(balls_[i], {});
        }
        if (input.throws) throw_crate(i);
    }
    world().step(dt_);
}

// Makes a crate, and room for it by destroying the oldest. Slots and ids come and go, so that a peer which handed out another id would show.
void Match::throw_crate(int player) {
    World& w = world();
    BodyId oldest;
    int crates = 0;
    for (std::uint32_t slot = 0; slot < w.capacity().bodies; ++slot) {
        const BodyId body = w.body_at(slot);
        if (!body || w.user_data(body) < crate_mark) continue;
        ++crates;
        if (!oldest || w.user_data(body) < w.user_data(oldest)) oldest = body;
    }
    if (crates == most_crates) w.destroy_body(oldest);
    const float side = player == 0 ? 1.0f : -1.0f;
    const BodyId crate = w.create_body({.type = BodyType::dynamic,
                                        .position = w.position(balls_[player]) + Vec2{0.8f * side, 0.6f},
                                        .linear_velocity = w.linear_velocity(balls_[player]) + Vec2{6 * side, 3},
                                        .user_data = crate_mark + w.step_count()});
    w.create_shape(crate, make_box(0.2f, 0.2f));
}

Input pretend(int player, int frame) {
    // A direction for 24 frames at a time, drawn from player and time alone.
    Random mood(static_cast<std::uint64_t>(frame / 24 * player_count + player));
    Input input;
    input.push_x = static_cast<std::int8_t>(mood.below(3) - 1);
    input.push_y = static_cast<std::int8_t>(mood.below(4) == 0);
    input.throws = frame % 24 == 7 && mood.below(3) == 0;
    return input;
}

}  // namespace islet::rollback
