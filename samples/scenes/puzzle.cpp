// Two pieces of a puzzle, alike but for half a turn, seen from above. Each has a hook, and the faces by which the hooks hold each other lean: the harder the
// pieces are pulled apart, the deeper they sit. Along the other axis nothing holds them.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {
namespace puzzle {
namespace {

constexpr float play = 0.04f;                // m, between the hooks when all is in the middle
constexpr float lean = 0.18f;                // of the hooks' faces: tan 10 degrees
constexpr float from_lock = 1.55f;           // m, from the middle of a piece to the middle between the hooks
constexpr float strength = 200;              // N
constexpr float settled = 1.5f;              // s after which pieces that are pulled are to be at rest
constexpr Vec2 closed = {-0.06f, 0}, above = {-0.06f, 1.8f}, away = {1.4f, 1.8f};  // m: where the right piece is to be, as seen from where it locks

/// What is done to the pieces for a while: the right one is led along a straight line, or pulled; the left one the other way, so that together they stay.
struct PuzzleLeg {
    float time;      // s
    Vec2 from, to;   // m, of the right piece as seen from the left one, less where they lock
    float pull = 0;  // N along x; if not 0 nothing else is done
};
constexpr std::array<PuzzleLeg, 8> puzzle_legs = {{
    {1.2f, away, above}, {1.2f, above, closed}, {2.5f, {}, {}, strength},  // together, and pull
    {1.2f, closed, above}, {1.2f, above, away},                            // out the open way
    {1.5f, away, above}, {1.2f, above, closed}, {2.5f, {}, {}, strength},  // and once more
}};

/// A leg, and where in it a step is.
struct Moment {
    const PuzzleLeg* leg;
    float time;  // s, since it began
};
Moment moment_of(float t) {
    for (const PuzzleLeg& leg : puzzle_legs) {
        if (t < leg.time) return {&leg, t};
        t -= leg.time;
    }
    return {&puzzle_legs.back(), puzzle_legs.back().time};
}

/// Where the right piece is to be in a leg that leads it: it sets out and arrives gently.
Vec2 place_at(const PuzzleLeg& leg, float time) {
    const float t = clamp(time / leg.time, 0, 1);
    return lerp(leg.from, leg.to, t * t * (3 - 2 * t));
}

/// A piece about the middle of its square, its hook to the right and open upwards.
std::vector<SceneShape> piece() {
    ShapeDef wood;
    wood.friction = 0.2f;
    constexpr float x = from_lock, tip = 0.34f, root = -0.35f;
    return {
        {make_box(0.75f, 0.75f), wood},
        {polygon_of({{0.75f, -0.75f}, {x + 0.45f, -0.75f}, {x + 0.6f, -0.6f}, {x + 0.6f, root}, {0.75f, root}}), wood},
        {polygon_of({{x - lean * root + play, root}, {x + 0.6f, root}, {x + 0.6f, tip - 0.15f}, {x + 0.45f, tip}, {x - lean * tip + play, tip}}), wood},
    };
}

Scene make() {
    Scene scene;
    scene.name = "merge";
    scene.steps = 750;
    scene.world.gravity = {0, 0};
    scene.world.enable_sleep = false;
    scene.view = {{-3.6f, -1.9f}, {3.6f, 1.9f}};
    const Vec2 lock = {from_lock, 0};
    std::array<std::size_t, 2> pieces = {};
    for (const std::size_t i : {0u, 1u}) {
        const float way = i == 0 ? -1.0f : 1.0f;
        BodyDef def;
        def.type = BodyType::dynamic;
        def.position = way * (lock + 0.5f * away);
        def.angle = i == 0 ? 0 : pi;
        def.linear_damping = def.angular_damping = 8;  // they slide on a table
        pieces[i] = add_body(scene, def, piece());
    }
    scene.traced = {pieces[0], pieces[1]};

    struct Seen {
        double least = 1, parted = -1, turned = 0, speed = 0;  // m, rad, m/s: while they were pulled, once they had settled
        double apart = 0, effort = 0;               // m, N: the farthest apart, and the most that led them out
    };
    const auto seen = std::make_shared<Seen>();
    scene.before_step = [=, dt = scene.dt](Engine& engine, int step) {
        if (step == 0) *seen = {};
        const auto [leg, time] = moment_of(dt * static_cast<float>(step));
        for (const std::size_t i : {0u, 1u}) {
            const float way = i == 0 ? -1.0f : 1.0f;
            const BodyState s = engine.body(pieces[i]);
            if (leg->pull > 0) {
                // At the middle of the far side, the more the longer, up to the whole after half a second.
                engine.apply_force_at(pieces[i], {way * leg->pull * std::min(1.0f, 2 * time), 0}, s.position + Vec2{way * 0.75f, 0});
                continue;
            }
            // A spring without overshoot, to a place that moves.
            constexpr float w = 12;  // rad/s
            const Vec2 place = place_at(*leg, time), next = place_at(*leg, time + dt);
            const Vec2 behind = way * (lock + 0.5f * place) - s.position, slow = 0.5f * way / dt * (next - place) - s.linear_velocity;
            const Vec2 force = s.mass * (w * w * behind + 2 * w * slow);
            const float turn = way * make_rot(s.angle).s;  // the sine of what is missing: the left piece is to be at 0, the right one half a turn round
            engine.apply_force(pieces[i], force);
            engine.apply_torque(pieces[i], s.inertia * (w * w * turn - 2 * w * s.angular_velocity));
            if (leg == &puzzle_legs[3]) seen->effort = std::max(seen->effort, double(length(force)));
        }
    };
    scene.after_step = [=, dt = scene.dt](const Engine& engine, int step) {
        const auto [leg, time] = moment_of(dt * static_cast<float>(step));
        const BodyState left = engine.body(pieces[0]), right = engine.body(pieces[1]);
        const Vec2 offset = right.position - left.position - 2 * lock;
        seen->apart = std::max(seen->apart, double(offset.x));
        if (leg->pull == 0 || time < settled) return;
        seen->least = std::min(seen->least, double(offset.x));
        seen->parted = std::max(seen->parted, double(offset.x));
        seen->speed = std::max(seen->speed, double(length(right.linear_velocity - left.linear_velocity)));
        seen->turned = std::max({seen->turned, std::abs(angle_difference(double(left.angle), 0)), std::abs(angle_difference(double(right.angle), double(pi)))});
    };
    scene.check = [=](const Engine& engine) -> std::vector<CheckLine> {
        // Leaning faces give as they are pulled home: by the play, and by the depth to which they sink times their slope.
        return {
            near_line("pulled with 200 N they gave by at least (m)", seen->least, 2 * double(play), 0.02),
            near_line("and at most (m)", seen->parted, 2 * double(play), 0.02),
            at_most("and turned (rad)", seen->turned, 0.02),
            at_most("and moved (m/s)", seen->speed, 0.05),
            at_most("leading them out took (N)", seen->effort, 0.2 * double(strength)),
            {"they came apart by (m)", seen->apart, 1.3, 1.5},
            at_most("overlap in the end (m)", engine.max_penetration(), 0.005),
        };
    };
    return scene;
}

}  // namespace
}  // namespace puzzle

Scene make_merge() { return puzzle::make(); }

}  // namespace islet::samples
