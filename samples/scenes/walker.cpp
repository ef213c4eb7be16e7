// A walking linkage: Theo Jansen's leg, six times, driven by one crank.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {
namespace {

// Jansen's eleven "holy numbers" (strandbeest.com), here in units of 2 cm: lengths of the bars, and the fixed hinge's place from the crank's axle.
constexpr float unit = 0.02f;
constexpr float axle_x = 38 * unit, axle_y = 7.8f * unit, crank = 15 * unit;
constexpr float bar_j = 50 * unit, bar_b = 41.5f * unit, bar_k = 61.9f * unit, bar_c = 39.3f * unit;
constexpr float bar_d = 40.1f * unit, bar_e = 55.8f * unit, bar_f = 39.4f * unit, bar_g = 36.7f * unit, bar_h = 65.7f * unit,
                bar_i = 49 * unit;

/// The point at `from_a` of a and `from_b` of b, to the left of the way from a to b.
Vec2 meet(Vec2 a, float from_a, Vec2 b, float from_b) {
    const Vec2 way = b - a;
    const float apart = length(way), along = (from_a * from_a - from_b * from_b + apart * apart) / (2 * apart);
    const float aside = std::sqrt(max(0, from_a * from_a - along * along));
    return a + (along / apart) * way + (aside / apart) * left_perp(way);
}

/// A left leg's hinges, seen from the axle, with the crank at an angle. A right leg is its mirror image.
//
//            top
//           / | \      j
//     side    |    pin---+         pin: on the crank; hip: fixed to the frame
//        \ \  |  / k
//       f  hip   |
//         \ | c  |
//         knee--ankle              top, side, hip: upper plate; ankle, knee, foot: lower plate
//            \  /
//            foot
struct WalkerLeg {
    Vec2 pin, hip, top, side, ankle, knee, foot;

    explicit WalkerLeg(float angle) {
        const Rot q = make_rot(angle);
        pin = {crank * q.c, crank * q.s};
        hip = {-axle_x, -axle_y};
        top = meet(hip, bar_b, pin, bar_j);
        side = meet(hip, bar_d, top, bar_e);
        ankle = meet(pin, bar_k, hip, bar_c);
        knee = meet(ankle, bar_g, side, bar_f);
        foot = meet(ankle, bar_i, knee, bar_h);
    }
};

/// Mirrored in the vertical through the axle, or not.
Vec2 to_side(Vec2 p, bool right) { return {right ? -p.x : p.x, p.y}; }

/// The leg that a pin at `angle` drives on one side.
WalkerLeg leg_on(bool right, float angle) {
    WalkerLeg leg(right ? pi - angle : angle);
    for (Vec2* p : {&leg.pin, &leg.hip, &leg.top, &leg.side, &leg.ankle, &leg.knee, &leg.foot}) *p = to_side(*p, right);
    return leg;
}

constexpr std::size_t pins = 3;
constexpr float sole = 0.06f;  // m, radius of a foot

float pin_angle(float crank_angle, std::size_t pin) { return crank_angle + 2 * pi * static_cast<float>(pin) / pins; }

/// How deep below the axle the lowest foot is, and how far it goes to the right when the crank turns on by `turn`.
struct Stance {
    double depth = 0, way = 0;  // m
};

Stance stance_at(float crank_angle, float turn) {
    Stance lowest;
    for (std::size_t pin = 0; pin < pins; ++pin) {
        for (const bool right : {false, true}) {
            const Vec2 foot = leg_on(right, pin_angle(crank_angle, pin)).foot;
            if (-double(foot.y) <= lowest.depth) continue;
            lowest = {-double(foot.y), double(leg_on(right, pin_angle(crank_angle, pin) + turn).foot.x - foot.x)};
        }
    }
    return lowest;
}

/// How far one turn of the crank walks if the lowest foot always stands still, m.
double stride_of(bool clockwise) {
    constexpr int parts = 360;
    const float turn = (clockwise ? -2 : 2) * pi / parts;
    double way = 0;
    for (int i = 0; i < parts; ++i) way -= stance_at(static_cast<float>(i) * turn, turn).way;
    return way;
}

/// A plate with corners at three points of the world, which its body's origin is the middle of.
std::size_t add_plate(Scene& scene, Vec2 a, Vec2 b, Vec2 c, const ShapeDef& material, std::vector<SceneShape> more = {}) {
    const Vec2 middle = (1.0f / 3) * (a + b + c);
    BodyDef body;
    body.type = BodyType::dynamic;
    body.position = middle;
    const Vec2 corners[] = {a - middle, b - middle, c - middle};
    for (SceneShape& shape : more) std::get<Circle>(shape.geometry).center -= middle;
    more.push_back({make_polygon(compute_hull(corners), 0.02f), material});
    return add_body(scene, body, std::move(more));
}

}  // namespace

Scene make_walker() {
    constexpr float rate = -2;  // rad/s: clockwise, as a wheel turns that rolls to the right
    Scene scene = sleepless_scene("walker", 540, {{-2.5f, -0.6f}, {10.8f, 3.6f}});
    make_stiff(scene);
    add_floor(scene, 14, {.friction = 0.9f});

    // Nothing of the walker touches the rest of it. Most of its weight is in the frame: light rods between heavy plates would not be solved well.
    ShapeDef steel;
    steel.filter.group = -1;
    steel.friction = 0.9f;
    ShapeDef rubber = steel;
    steel.density = 4;
    ShapeDef heavy = steel;
    heavy.density = 40;
    const Vec2 axle = {0, static_cast<float>(stance_at(0, 0).depth) + sole};
    BodyDef def;
    def.type = BodyType::dynamic;
    def.position = axle;
    const std::size_t frame = add_body(
        scene, def,
        {{make_offset_box(axle_x, 0.06f, {{0, -axle_y}, {}}), heavy}, {make_offset_box(0.3f, 0.25f, {{0, -axle_y + 0.3f}, {}}), heavy}});
    const std::size_t wheel = add_body(scene, def, {{Circle{{}, crank + 0.05f}, heavy}});
    RevoluteJointDef drive = hinge_at(scene, frame, wheel, axle);
    drive.motor = {.enable = true, .speed = rate, .max_force = 500};
    const std::size_t motor = add_joint(scene, frame, wheel, drive);
    scene.traced = {frame};
    for (std::size_t pin = 0; pin < pins; ++pin) {
        for (const bool right : {false, true}) {
            const WalkerLeg leg = leg_on(right, pin_angle(0, pin));
            const std::size_t upper = add_plate(scene, axle + leg.hip, axle + leg.top, axle + leg.side, steel);
            const std::size_t lower =
                add_plate(scene, axle + leg.ankle, axle + leg.knee, axle + leg.foot, steel, {{Circle{axle + leg.foot, sole}, rubber}});
            add_joint(scene, frame, upper, hinge_at(scene, frame, upper, axle + leg.hip));
            add_joint(scene, wheel, upper, rod_between(scene, wheel, upper, axle + leg.pin, axle + leg.top));
            add_joint(scene, wheel, lower, rod_between(scene, wheel, lower, axle + leg.pin, axle + leg.ankle));
            add_joint(scene, frame, lower, rod_between(scene, frame, lower, axle + leg.hip, axle + leg.ankle));
            add_joint(scene, upper, lower, rod_between(scene, upper, lower, axle + leg.side, axle + leg.knee));
        }
    }

    struct Seen {
        double tilt = 0, low = 0, high = 0;
    };
    const auto seen = std::make_shared<Seen>();
    scene.after_step = [=](const Engine& engine, int step) {
        const BodyState state = engine.body(frame);
        const double y = double(state.position.y);
        if (step == 0) *seen = {0, y, y};
        *seen = {std::max(seen->tilt, std::abs(double(state.angle))), std::min(seen->low, y), std::max(seen->high, y)};
    };
    const double time = double(scene.dt) * scene.steps;
    scene.check = [=](const Engine& engine) -> std::vector<CheckLine> {
        const double walked = double(engine.body(frame).position.x), turns = double(engine.joint_position(motor)) / (2 * double(pi));
        double least = double(axle.y), most = 0;
        for (int i = 0; i < 360; ++i) {
            const double depth = stance_at(static_cast<float>(i) * 2 * pi / 360, 0).depth + double(sole);
            least = std::min(least, depth);
            most = std::max(most, depth);
        }
        return {
            {"it walked (m)", walked, 5, 12},
            // What the linkage does if the lowest foot always stands still; it tilts a little, so that now and then another one does.
            {"share of what its feet went through, standing still", walked / (std::abs(turns) * stride_of(rate < 0)), 0.9, 1.1},
            near_line("turns of the crank", turns, double(rate) * time / (2 * double(pi)), 0.1),
            at_most("its frame leaned by up to (rad)", seen->tilt, 0.2),
            {"lowest its axle was, over what the linkage allows (m)", seen->low - least, -0.15, 0.05},
            {"highest (m)", seen->high - most, -0.1, 0.1},
            at_most("a bar or hinge was off by (m)", double(engine.max_joint_error().linear), 0.02),
        };
    };
    return scene;
}

}  // namespace islet::samples
