// A pinball table, seen along its slope. It plays by itself: a script looks where the ball is and works plunger, bumpers and flippers, by what any engine
// tells.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {
namespace pinball {
namespace {

constexpr float gravity = 5;         // m/s^2 along the table
constexpr float wide = 7, side = 8;  // m: how wide it is, and where the sides end and the arch begins
constexpr float lane = 6.3f;         // m: what is right of it is the plunger's lane
constexpr float middle = 0.5f * lane;
constexpr float ball_radius = 0.2f;
constexpr std::array<Vec2, 5> bumpers = {{{0.75f, 9.3f}, {2.1f, 7.9f}, {4.4f, 7.9f}, {3.25f, 6.4f}, {3.3f, 9.4f}}};
constexpr float bumper_radius = 0.5f, kick = 3;      // m; m/s that a bumper adds
constexpr float plunger_top = 0.35f, stroke = 0.8f;  // m: at rest; by which it is pulled back
constexpr float striking_speed = 13;                 // m/s
constexpr float flipper_length = 1.2f, droop = 0.5f, flip_speed = 14;  // m; rad, below level at rest and above it when up; rad/s

/// Flippers are 0 on the left and 1 on the right, where all is the other way round.
constexpr float way_of(std::size_t flipper) { return flipper == 0 ? 1.0f : -1.0f; }
constexpr Vec2 pivot_of(std::size_t flipper) { return {middle - 1.4f * way_of(flipper), 2.2f}; }
constexpr Vec2 mirrored(Vec2 p) { return {2 * middle - p.x, p.y}; }

/// What the bodies and joints are that the script works.
struct Table {
    std::size_t ball = 0, plunger = 0;         // a body, a joint
    std::array<std::size_t, 2> flippers = {};  // joints
};

/// What the script remembers of the game, and the check wants to know.
struct Game {
    int plunging = 0;            // steps since the ball lay on the plunger, or since a person began to pull it
    std::array<int, 2> up = {};  // steps for which each flipper is still to stay up
    bool is_low = false;         // the ball came down to the flippers, which have not sent it back yet
    bool is_driven = false;      // something may push the ball in this step
    Vec2 velocity;               // m/s, of the ball before the last step, kicked already; and its energy
    double energy = 0;           // J/kg
    int shots = 0, touches = 0, returns = 0, drains = 0;
    double fastest = 0, farthest = 0, gained = 0;  // m/s; m, out of the table; J/kg, in a step in which nothing drove the ball
};

double energy_of(const BodyState& b) {
    const double spin = double(b.inertia / b.mass) * double(b.angular_velocity) * double(b.angular_velocity);
    return 0.5 * (double(length_squared(b.linear_velocity)) + spin) + double(gravity) * double(b.position.y);
}

/// How far the ball's centre is beyond where it could be.
double outside(Vec2 p) {
    const double walls = std::max({double(ball_radius - p.x), double(p.x + ball_radius - wide), double(plunger_top - stroke - p.y)});
    const double arch = p.y > side ? double(distance(p, {0.5f * wide, side}) + ball_radius - 0.5f * wide) : 0;
    return std::max({walls, arch, 0.0});
}

/// The plunger waits for the ball to lie on it, goes back for a second, strikes, and rests.
void work_plunger(Engine& engine, const Table& table, Game& game) {
    const BodyState ball = engine.body(table.ball);
    const bool ready = ball.position.x > lane && ball.position.y < plunger_top + 1.5f * ball_radius && length(ball.linear_velocity) < 1;
    if (game.plunging > 0 || ready) ++game.plunging;
    if (game.plunging == 10) engine.set_motor(table.plunger, {.enable = true, .speed = -1, .max_force = 100});
    if (game.plunging == 70) engine.set_motor(table.plunger, {.enable = true, .speed = striking_speed, .max_force = 1500});
    if (game.plunging != 90) return;
    engine.set_motor(table.plunger, {.enable = true, .speed = 1, .max_force = 100});
    game.plunging = 0;
    ++game.shots;
}

enum Button : std::size_t { left_flipper, right_flipper, pull_plunger };

/// A person pulls the plunger back, and lets it strike.
void play_plunger(Engine& engine, const Table& table, Game& game, const Controls& controls) {
    constexpr int strike_steps = 20;
    if (controls.holds(pull_plunger))
        game.plunging = strike_steps + 1;
    else if (game.plunging > 0)
        --game.plunging;
    const bool pulls = game.plunging > strike_steps, strikes = game.plunging > 0;
    engine.set_motor(table.plunger, {.enable = true, .speed = pulls ? -1 : strikes ? striking_speed : 1, .max_force = pulls || !strikes ? 100.0f : 1500.0f});
}

/// A bumper kicks what has just rebounded from it.
void work_bumpers(Engine& engine, const Table& table, Game& game) {
    const BodyState ball = engine.body(table.ball);
    for (const Vec2 bumper : bumpers) {
        const Vec2 away = normalize(ball.position - bumper);
        const float gap = distance(ball.position, bumper) - ball_radius - bumper_radius;
        if (gap > 0.3f || dot(game.velocity, away) >= 0 || dot(ball.linear_velocity, away) <= 0) continue;
        engine.apply_impulse(table.ball, kick * ball.mass * away);
        ++game.touches;
    }
}

/// A flipper goes up when the ball is about to touch its outer half, and stays up for a moment; or while a person wants it to.
void work_flippers(Engine& engine, const Table& table, Game& game, const Controls& controls) {
    const BodyState ball = engine.body(table.ball);
    for (const std::size_t i : {0u, 1u}) {
        const float way = way_of(i);
        const Rot rest = make_rot(-droop);
        const auto in_frame = [&](Vec2 v) { return inv_rotate(rest, {way * v.x, v.y}); };
        const Vec2 place = in_frame(ball.position - pivot_of(i)), velocity = in_frame(ball.linear_velocity);
        // Where on it the ball lies when it goes up decides where the ball goes to: not always the same way.
        const float aim = 0.6f + 0.1f * static_cast<float>(game.returns % 4);
        const bool near = place.x > aim && place.x < 1.4f && place.y > 0 && place.y < ball_radius + 0.15f - 2 * velocity.y / 60;
        if (controls.taken)
            game.up[i] = controls.holds(i) ? 1 : 0;
        else if (game.up[i] > 0)
            --game.up[i];
        else if (near && velocity.y < 0.5f)
            game.up[i] = 20;
        engine.set_motor(table.flippers[i], {.enable = true, .speed = (game.up[i] > 0 ? way : -0.5f * way) * flip_speed, .max_force = 250});
    }
}

void watch(const Engine& engine, const Table& table, Game& game) {
    const BodyState ball = engine.body(table.ball);
    const Vec2 p = ball.position;
    game.fastest = std::max(game.fastest, double(length(ball.linear_velocity)));
    game.farthest = std::max(game.farthest, outside(p));
    if (!game.is_driven) game.gained = std::max(game.gained, energy_of(ball) - game.energy);
    if (p.x > lane) return;
    if (p.y > 4.5f && game.is_low) ++game.returns;
    if (p.y < 1.5f && game.is_low) ++game.drains;
    if (p.y < 1.5f || p.y > 4.5f) game.is_low = false;
    if (p.y > 1.5f && p.y < 2.8f) game.is_low = true;
}

Scene make() {
    Scene scene;
    scene.name = "pinball";
    scene.steps = 3000;
    scene.view = {{-4.5f, -0.8f}, {11.5f, 11.8f}};
    scene.world.gravity = {0, -gravity};
    scene.world.enable_sleep = false;
    ShapeDef wood, rubber, steel, light;
    wood.restitution = 0.3f;
    rubber.restitution = 0.8f;
    steel.density = 5;
    light.density = 0.5f;
    for (ShapeDef* def : {&wood, &rubber, &steel, &light}) def->friction = 0.2f;

    // The outline: from the left over the arch, down the right side, and back over a floor that leads what is drained to the plunger.
    Chain outline;
    outline.loop = true;
    constexpr int arch = 32;
    for (int i = 0; i <= arch; ++i) {
        const Vec2 spoke = rotate(make_rot(-pi * static_cast<float>(i) / arch), {-0.5f * wide, 0});
        outline.points.push_back(Vec2{0.5f * wide, side} + spoke);
    }
    for (const Vec2 p : {Vec2{wide, -0.7f}, {lane, -0.7f}, {lane, plunger_top}, {0, 0.9f}}) outline.points.push_back(p);
    // On it the wall of the lane, slopes that lead to the flippers, triangles of rubber above them, and the bumpers.
    std::vector<SceneShape> parts = {{outline, wood}, {make_offset_box(0.05f, 3.1f, {{lane, 4.5f}, {}}), wood}};
    const float foot = pivot_of(0).x - 0.02f;
    for (const auto flip : {+[](Vec2 p) { return p; }, +[](Vec2 p) { return mirrored(p); }}) {
        parts.push_back({polygon_of({flip({0, 3.3f}), flip({0, 2.6f}), flip({foot, 2.15f}), flip({foot, 2.36f})}), wood});
        parts.push_back({polygon_of({flip({0.75f, 4.6f}), flip({0.75f, 3.75f}), flip({1.45f, 3.3f})}), rubber});
    }
    for (const Vec2 bumper : bumpers) parts.push_back({Circle{bumper, bumper_radius}, rubber});
    const std::size_t board = add_body(scene, {}, std::move(parts));

    Table table;
    for (const std::size_t i : {0u, 1u}) {
        const float way = way_of(i), length = way * flipper_length;
        const Polygon blade = polygon_of({{0, -0.14f}, {length, -0.06f}, {1.04f * length, 0}, {length, 0.06f}, {0, 0.14f}});
        const std::size_t flipper = add_dynamic(scene, pivot_of(i), blade, steel);
        RevoluteJointDef hinge = hinge_at(scene, board, flipper, pivot_of(i));
        hinge.limit = {.enable = true, .lower = -droop, .upper = droop};
        hinge.motor.enable = true;
        table.flippers[i] = add_joint(scene, board, flipper, hinge);
        scene.bodies[flipper].def.angle = -way * droop;
    }
    const std::size_t plunger = add_dynamic(scene, {0.5f * (lane + wide), plunger_top - 0.1f}, make_box(0.27f, 0.1f), steel);
    PrismaticJointDef slider = slider_at(scene, board, plunger, scene.bodies[plunger].def.position, {0, 1});
    slider.limit = {.enable = true, .lower = -stroke, .upper = 0};
    slider.motor = {.enable = true, .speed = 1, .max_force = 100};
    table.plunger = add_joint(scene, board, plunger, slider);
    // A flap on top of the lane opens upwards only. It slopes, so that nothing comes to rest on it.
    constexpr float slope = 0.45f;  // rad
    const Vec2 top = {lane, 7.75f};
    const std::size_t flap = add_dynamic(scene, top, make_offset_box(0.34f, 0.03f, {{0.34f, 0}, {}}), light);
    RevoluteJointDef flap_hinge = hinge_at(scene, board, flap, top);
    flap_hinge.limit = {.enable = true, .lower = slope, .upper = 1.4f};
    add_joint(scene, board, flap, flap_hinge);
    scene.bodies[flap].def.angle = slope;

    BodyDef ball;
    ball.type = BodyType::dynamic;
    ball.position = {0.5f * (lane + wide), plunger_top + ball_radius};
    ball.bullet = true;
    table.ball = add_body(scene, ball, {{Circle{{}, ball_radius}, steel}});
    scene.traced = {table.ball};

    const auto game = std::make_shared<Game>();
    scene.controls = std::make_shared<Controls>();
    scene.controls->buttons = {{"left flipper", '<'}, {"right flipper", '>'}, {"plunger", 'v'}};
    scene.before_step = [game, table, controls = scene.controls](Engine& engine, int step) {
        if (step == 0) *game = {};
        if (controls->taken)
            play_plunger(engine, table, *game, *controls);
        else
            work_plunger(engine, table, *game);
        work_bumpers(engine, table, *game);
        work_flippers(engine, table, *game, *controls);
        const BodyState now = engine.body(table.ball);
        game->velocity = now.linear_velocity;
        game->energy = energy_of(now);
        const bool is_flipping = game->up[0] > 0 || game->up[1] > 0 || now.position.y < 3.5f;
        game->is_driven = is_flipping || (now.position.x > lane - 1 && now.position.y < 9.5f);
    };
    scene.after_step = [game, table](const Engine& engine, int) { watch(engine, table, *game); };
    scene.check = [game](const Engine& engine) -> std::vector<CheckLine> {
        return {
            {"shots of the plunger", double(game->shots), 1, 30},
            {"touches of the bumpers", double(game->touches), 5, 1000},
            {"times the flippers sent the ball back up", double(game->returns), 1, 1000},
            {"times it was drained", double(game->drains), 0, 30},
            at_most("the ball got out of the table (m)", game->farthest, 0.1),
            at_most("its greatest speed (m/s)", game->fastest, 25),
            at_most("energy it gained in a step without being pushed (J/kg)", game->gained, 0.1),
            at_most("a joint came apart (m)", double(engine.max_joint_error().linear), 0.05),
            near_line("bodies that are not finite", static_cast<double>(count_not_finite(engine)), 0, 0),
        };
    };
    return scene;
}

}  // namespace
}  // namespace pinball

Scene make_pinball() { return pinball::make(); }

}  // namespace islet::samples
