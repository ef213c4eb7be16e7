// A course for the character mover: a slope, stairs, a platform that moves, a crate to push into a hole, platforms to jump through, a beam that rocks.
//
// The character itself is no body. What the picture shows is a kinematic body that is told to be where the mover is; it collides with nothing. In an engine
// that is not Islet it stays where it is.
#include <islet/mover.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {
namespace {

constexpr float start = -14, finish = 28;  // m
constexpr float speed = 4;                 // m/s
constexpr std::uint32_t one_way = 2;       // category of the platforms that let pass from below

/// A step of the script: walk until a place is reached.
struct Leg {
    float until;      // m, x to reach
    float walk;       // m/s
    float jump;       // m/s, when it starts; 0: none
    int wait_for;     // the ferry: 0 nothing, -1 its being at the left, 1 at the right
};

constexpr Leg legs[] = {
    {-2.4f, speed, 0, 0},     // over the hill, to the edge of the pit
    {-1.2f, speed, 0, -1},    // on to the ferry
    {6.6f, speed, 0, 1},      // and off it
    {13.4f, 1.5f, 0, 0},      // push the crate into the hole and go over it
    {14.6f, 2, 7, 0},         // up through the first platform
    {17.4f, 2, 7, 0},         // and on to the second
    {finish, speed, 0, 0},    // down, and over the beam
};

struct Player {
    MoverState mover{.position = {start, mover_gap}};
    std::size_t leg = 0;
    bool off = false;  // the leg has begun
    // What the check looks at.
    double highest = 0, ferried = 0, overlap = 0, squeezed = 0;
    float boarded = 0;
};

bool passes_one_way(const Surface& s, void* context) {
    const World& world = *static_cast<const World*>(context);
    return world.filter(s.shape).category != one_way || (s.normal.y > 0.7f && s.separation > -0.05f);
}

MoverInput next_input(Player& player, float ferry) {
    if (player.leg == std::size(legs)) return {};
    const Leg& leg = legs[player.leg];
    if (!player.off && leg.wait_for != 0 && (leg.wait_for < 0 ? ferry > -0.75f : ferry < 4.75f)) return {};
    if (!player.off && leg.jump > 0 && !player.mover.ground) return {.walk = leg.walk};
    MoverInput input{.walk = leg.walk, .jump = player.off ? 0 : leg.jump};
    player.off = true;
    if (player.mover.position.x >= leg.until - leg.walk / 60) {
        player.off = false;
        ++player.leg;
        input.walk = player.leg < std::size(legs) && legs[player.leg].wait_for == 0 ? input.walk : 0;
    }
    return input;
}

enum Button : std::size_t { left, right, jump };

/// What a person who plays wants. A jump of 3.2 m reaches each platform from the one below, and leads out of the pit.
MoverInput input_of(const Controls& controls) {
    const float way = (controls.holds(right) ? 1.0f : 0.0f) - (controls.holds(left) ? 1.0f : 0.0f);
    return {.walk = speed * way, .jump = controls.holds(jump) ? 8.0f : 0.0f};
}

/// Whoever falls out of the world begins anew.
void play(Controls& controls, MoverState& mover) {
    constexpr float bottom = -8;  // m
    if (mover.position.y < bottom) mover = {.position = {start, mover_gap}};
    if (distance(mover.position, *controls.goal) < 1) controls.has_won = true;
}

}  // namespace

Scene make_platformer() {
    Scene scene;
    scene.name = "platformer";
    scene.steps = 1500;
    scene.view = {{-16, -3.5f}, {30, 8}};
    const auto block = [&](float left, float right, float bottom, float top, const ShapeDef& def = {}) {
        return add_static(scene, {0.5f * (left + right), 0.5f * (bottom + top)}, make_box(0.5f * (right - left), 0.5f * (top - bottom)), def);
    };
    // Ground with a pit for the ferry and a hole for the crate.
    block(-16, -2, -3, 0);
    block(-2, 6, -3, -2.5f);
    block(6, 10, -3, 0);
    block(10, 11.5f, -3, -1);
    block(11.5f, 20, -3, 0);
    block(24, 30, -3, 0);
    // The hill: 30 degrees up, stairs down.
    const float crest = -12 + 2 * std::sqrt(3.0f);
    add_static(scene, {0, 0}, polygon_of({{-12, 0}, {crest, 0}, {crest, 2}}));
    block(crest, -7, 0, 2);
    for (int i = 1; i < 8; ++i) block(-7 + 0.35f * static_cast<float>(i - 1), -7 + 0.35f * static_cast<float>(i), 0, 2 - 0.25f * static_cast<float>(i));
    const std::size_t crate = add_dynamic(scene, {8, 0.5f}, make_box(0.5f, 0.5f), {.friction = 0.4f, .density = 25});
    const ShapeDef thin = {.filter = {.category = one_way}};
    block(13.5f, 16, 1.5f, 1.6f, thin);
    block(16.5f, 19, 3, 3.1f, thin);
    const auto moving = [&](Vec2 position, const Polygon& shape) {
        return add_body(scene, {.type = BodyType::kinematic, .position = position}, {{shape, {}}});
    };
    const std::size_t ferry = moving({2, -0.15f}, make_box(1, 0.15f));
    const std::size_t beam = moving({22, -0.15f}, make_box(1.95f, 0.15f));
    const MoverDef def = {};
    const std::size_t hero = add_body(scene, {.type = BodyType::kinematic, .position = {start, mover_gap}},
                                      {{def.capsule, {.filter = {.mask = 0}}}});
    scene.traced = {hero, crate};

    scene.controls = std::make_shared<Controls>();
    scene.controls->buttons = {{"left", '<'}, {"right", '>'}, {"jump", '^'}};
    scene.controls->goal = Vec2{finish, 0};
    const auto player = std::make_shared<Player>();
    scene.before_step = [=, controls = scene.controls](Engine& engine, int step) {
        // Both swing: x = 2 - 3 sin(w t) and angle = 0.2 sin(w t), by the speeds that lead there.
        const float w = 2 * pi / 8, t = static_cast<float>(step) / 60;
        const float now = make_rot(w * t).s, next = make_rot(w * (t + 1.0f / 60)).s;
        engine.set_velocity(ferry, {-3 * 60 * (next - now), 0}, 0);
        engine.set_velocity(beam, {0, 0}, 0.2f * 60 * (next - now));
        auto* islet = dynamic_cast<IsletEngine*>(&engine);
        if (islet == nullptr) return;
        if (step == 0) *player = {};
        MoverDef mover = def;
        mover.collides = passes_one_way;
        mover.context = &islet->world();
        const float ferry_x = engine.body(ferry).position.x;
        const MoverInput input = controls->taken ? input_of(*controls) : next_input(*player, ferry_x);
        step_mover(islet->world(), mover, player->mover, input, 1.0f / 60);
        if (controls->taken) play(*controls, player->mover);
        engine.set_velocity(hero, 60 * (player->mover.position - engine.body(hero).position), 0);

        Player& p = *player;
        p.highest = std::max(p.highest, double(p.mover.position.y));
        p.squeezed += p.mover.squeezed;
        if (p.leg == 2 && !p.off && p.boarded == 0) p.boarded = p.mover.position.x;
        if (p.leg == 2 && p.off && p.ferried == 0) p.ferried = double(p.mover.position.x - p.boarded);
        const Capsule c{p.mover.position + def.capsule.point1, p.mover.position + def.capsule.point2, def.capsule.radius};
        Surface deepest[4];
        const std::uint32_t near = islet->world().surfaces_near(make_proxy(c), 0, deepest);
        for (std::uint32_t i = 0; i < std::min(near, 4u); ++i) {
            if (passes_one_way(deepest[i], mover.context)) p.overlap = std::max(p.overlap, -double(deepest[i].separation));
        }
    };
    scene.check = [=](const Engine& engine) -> std::vector<CheckLine> {
        const Vec2 at = engine.body(hero).position;
        return {
            near_line("the character reached x (m)", double(at.x), double(finish), 0.15),
            near_line("where it stands at y (m)", double(at.y), double(mover_gap), 0.002),
            {"and it was as high as (m)", player->highest, 3.1, 5},
            {"the ferry carried it (m)", player->ferried, 5, 6},
            near_line("the crate lies in the hole at x (m)", double(engine.body(crate).position.x), 10.75, 0.26),
            near_line("and its middle at y (m)", double(engine.body(crate).position.y), -0.5, 0.01),
            at_most("deepest overlap on its way (m)", player->overlap, 0.005),
            at_most("steps in which it had no room", player->squeezed, 0),
        };
    };
    return scene;
}

}  // namespace islet::samples
