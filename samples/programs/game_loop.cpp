// A game's loop: steps of equal length, as many as real time asks for, and what is drawn lies between the last two. Shots pass through players.
#include <cstdio>

#include <islet/islet.hpp>

using namespace islet;

namespace {

constexpr float dt = 1.0f / 60;       // s
constexpr float most_behind = 0.25f;  // s: after a hiccup the game is late rather than busy for ever

enum Category : std::uint32_t { wall = 1, player = 2, shot = 4 };

StaticWorld<Capacity{.bodies = 64, .shapes = 64, .contacts = 256}> storage;

/// What is drawn of a body: where it was before the last step, and where it is.
struct Seen {
    BodyId body;
    Transform before, now;
};

Transform between(const Transform& a, const Transform& b, float share) {
    return {lerp(a.p, b.p, share), normalize(Rot{a.q.c + share * (b.q.c - a.q.c), a.q.s + share * (b.q.s - a.q.s)})};
}

}  // namespace

int main() {
    World& world = storage.create();
    const BodyId ground = world.create_body({});
    world.create_shape(ground, make_box(50, 1), {.filter = {.category = wall}});
    Seen hero{world.create_body({.type = BodyType::dynamic, .position = {2, 1.5f}}), {}, {}};
    world.create_shape(hero.body, make_box(0.4f, 0.5f), {.filter = {.category = player, .mask = wall}});
    Seen ball{world.create_body({.type = BodyType::dynamic, .position = {0, 1.5f}, .linear_velocity = {10, 1}, .bullet = true}), {}, {}};
    world.create_shape(ball.body, Circle{{}, 0.1f}, {.restitution = 0.5f, .filter = {.category = shot, .mask = wall | shot}});
    for (Seen* seen : {&hero, &ball}) seen->before = seen->now = world.transform(seen->body);

    float owed = 0;  // s of real time that no step has covered yet
    for (int frame = 1; frame <= 8; ++frame) {
        const float elapsed = frame == 5 ? 0.4f : 1.0f / 90;  // s, of the display's last frame
        owed = min(owed + elapsed, most_behind);
        int steps = 0;
        for (; owed >= dt; owed -= dt, ++steps) {
            world.step(dt);
            for (Seen* seen : {&hero, &ball}) {
                seen->before = seen->now;
                seen->now = world.transform(seen->body);
            }
        }
        const Transform drawn = between(ball.before, ball.now, owed / dt);
        std::printf("frame %d: %2d steps, the ball is drawn at (%.3f, %.3f)\n", frame, steps, double(drawn.p.x), double(drawn.p.y));
    }
    const float speed = world.linear_velocity(ball.body).x;  // m/s; nothing was in the way of its 10
    const bool has_passed = abs(speed - 10) < 0.001f;
    std::printf("the ball %s the hero, and flies on at %.3f m/s\n", has_passed ? "passed" : "hit", double(speed));
    return has_passed ? 0 : 1;
}
