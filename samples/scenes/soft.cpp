// Cloth and pennants: what hangs, and what the wind carries.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "build.hpp"
#include "harness/checks.hpp"
#include "prefabs/cloth.hpp"
#include "prefabs/rope.hpp"
#include "prefab_scene.hpp"
#include "scenes.hpp"

namespace islet::samples {
namespace {

/// How far the longest rod is beyond its length, as a share of it.
double worst_stretch(const Engine& engine, std::size_t first_joint, std::size_t rods, double length) {
    double worst = 0;
    for (std::size_t i = first_joint; i < first_joint + rods; ++i) worst = std::max(worst, double(engine.joint_error(i).linear) / length);
    return worst;
}

}  // namespace

Scene make_cloth_scene() {
    constexpr int release_step = 180;
    Scene scene;
    scene.name = "cloth";
    scene.steps = 900;
    scene.view = {{-4.3f, -0.8f}, {2.6f, 4.9f}};
    make_stiff(scene);
    const ClothDef def = {.corner = {-2, 4.6f}, .columns = 15, .rows = 11, .damping = 0.8f};
    const Placed cloth = add_prefab(scene, prefab_of(def));
    const std::size_t left = cloth.first_body + cloth_node(def, 0, 0), right = cloth.first_body + cloth_node(def, def.columns - 1, 0);
    const std::size_t opposite = cloth.first_body + cloth_node(def, def.columns - 1, def.rows - 1);
    const double across = double(def.spacing) * double(def.columns - 1), down = double(def.spacing) * double(def.rows - 1);
    const Vec2 left_place = scene.bodies[left].def.position, right_place = scene.bodies[right].def.position;
    const std::size_t nails = add_static(scene, {-0.25f, 4.6f}, make_box(2, 0.03f), {.filter = {.mask = 0}});
    add_joint(scene, nails, left, hinge_at(scene, nails, left, left_place));
    const std::size_t released = add_joint(scene, nails, right, hinge_at(scene, nails, right, right_place));
    scene.traced = {right};

    const auto most_stretch = std::make_shared<double>();
    scene.before_step = [released](Engine& engine, int step) {
        if (step == release_step) engine.destroy_joint(released);
    };
    const std::size_t rods = cloth_rods(def);
    scene.after_step = [=](const Engine& engine, int step) {
        *most_stretch = std::max(step == 0 ? 0 : *most_stretch, worst_stretch(engine, cloth.first_joint, rods, double(def.spacing)));
    };
    // Let go, the cloth swings until the middle of its weight is below the nail, and the opposite corner as far down as its longer side at least and
    // as both sides at most. The rods give by F / (m w^2) (see make_stiff), m being half a node's mass: at rest the nail's rods carry the cloth's
    // weight, and as it swings three times as much, as the rod of a pendulum does that falls from the horizontal.
    const double omega = 2 * double(pi) * double(scene.world.solver.joint_hertz);
    const double give = 10 * double(def.columns * def.rows) / (0.5 * omega * omega) / double(def.spacing);
    scene.check = [=](const Engine& engine) -> std::vector<CheckLine> {
        double weight_x = 0;
        const double nodes = double(def.columns * def.rows);
        for (std::size_t i = 0; i < def.columns * def.rows; ++i) weight_x += double(engine.body(cloth.first_body + i).position.x) / nodes;
        return {
            at_most("most that a thread was ever stretched (share of its length)", *most_stretch, 3 * give),
            at_most("stretched at the end (share)", worst_stretch(engine, cloth.first_joint, rods, double(def.spacing)), give),
            {"the opposite corner is below the nail by (m)", double(left_place.y - engine.body(opposite).position.y), across,
             across + down},
            near_line("middle of the cloth beside the nail (m)", weight_x - double(left_place.x), 0, 0.15),
            at_most("fastest node (m/s)", max_speed(engine), 0.5),
            at_most("bodies not finite", double(count_not_finite(engine)), 0),
        };
    };
    return scene;
}

namespace {

/// Air that moves to the right and presses on a line across it: with (c / 2) rho |v| v on each metre of the line, v being the part of the relative
/// wind that is across it. In a steady wind a pennant of weight w per metre streams out straight, at the angle below the horizontal at which on every
/// metre the wind lifts what weight presses: q sin^2 a = w cos a, q = (c / 2) rho u^2. That is the critical angle of a towed cable.
struct Wind {
    static constexpr float pressure = 0.6f;  // (c / 2) rho, N s^2 / m^4, times a pennant's width of 1 m

    static Vec2 force(const BodyState& link, float length, float speed) {
        const Vec2 normal = rotate(make_rot(link.angle), {0, 1});
        const float across = dot(Vec2{speed, 0} - link.linear_velocity, normal);
        return pressure * length * abs(across) * across * normal;
    }
    /// cos a from q (1 - cos^2 a) = w cos a, in radians.
    static double critical_angle(double speed, double weight) {
        const double b = weight / (double(pressure) * speed * speed);
        return std::acos(0.5 * (std::sqrt(b * b + 4) - b));
    }
};

}  // namespace

Scene make_flag() {
    constexpr int wind_step = 60;
    constexpr float speeds[] = {2, 3, 7, 12};  // m/s, more the higher up
    constexpr float length = 1.8f;             // m
    constexpr std::size_t links = 12;
    Scene scene = sleepless_scene("flag", 900, {{-1.5f, -0.5f}, {4.5f, 9}});
    add_floor(scene, 3);
    add_static(scene, {0, 4.2f}, make_box(0.05f, 4.2f), {.filter = {.mask = 0}});

    struct Pennant {
        std::size_t first;
        float speed;               // m/s, of its wind
        double weight;             // N/m
        double low = 0, high = 0;  // m, how far its end went down and up lately
    };
    const auto pennants = std::make_shared<std::array<Pennant, 4>>();
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 from = {0.05f, 2.2f + 2 * static_cast<float>(i)};
        const RopeDef def = {.from = from, .to = from - Vec2{0, length}, .links = links, .density = 5, .group = 1, .hold_from = true};
        const std::size_t first = add_prefab(scene, prefab_of(def)).first_body;
        const Capsule link = std::get<Capsule>(scene.bodies[first].shapes[0].geometry);
        (*pennants)[i] = {first, speeds[i], double(10 * compute_mass(link, def.density).mass * links / length)};
    }

    scene.before_step = [pennants](Engine& engine, int step) {
        if (step < wind_step) return;
        const float rise = min(1, static_cast<float>(step - wind_step) / 60);
        for (std::size_t p = 0; p < 4; ++p) {
            const std::size_t first = (*pennants)[p].first;
            for (std::size_t i = first; i < first + links; ++i)
                engine.apply_force(i, Wind::force(engine.body(i), length / links, rise * (*pennants)[p].speed));
        }
    };
    scene.after_step = [pennants, measured_from = scene.steps - 300](const Engine& engine, int step) {
        for (Pennant& pennant : *pennants) {
            const double end = double(engine.body(pennant.first + links - 1).position.y);
            pennant.low = step <= measured_from ? end : std::min(pennant.low, end);
            pennant.high = step <= measured_from ? end : std::max(pennant.high, end);
        }
    };
    scene.check = [pennants](const Engine& engine) {
        std::vector<CheckLine> lines;
        for (std::size_t p = 0; p < 4; ++p) {
            const Pennant& pennant = (*pennants)[p];
            const std::string name = "wind of " + std::to_string(std::lround(pennant.speed)) + " m/s: ";
            const double angle = Wind::critical_angle(double(pennant.speed), pennant.weight);
            // Waves run down it no faster than sqrt(tension / mass) = sqrt(g length sin a), reckoned where it is held. Wind that is faster blows them up.
            const bool calm = double(pennant.speed) * std::cos(angle) < std::sqrt(10 * double(length) * std::sin(angle));
            const double range = pennant.high - pennant.low;
            if (!calm) {
                lines.push_back({name + "it flutters: its end went up and down by (m)", range, 0.1, double(length)});
                continue;
            }
            const Vec2 from = engine.body(pennant.first).position, to = engine.body(pennant.first + links - 1).position;
            const double below = std::atan2(double(from.y) - double(to.y), double(to.x) - double(from.x));
            lines.push_back(near_line(name + "angle below the horizontal, due the critical one (rad)", below, angle, 0.01));
            lines.push_back(at_most(name + "it is calm: its end went up and down by (m)", range, 0.02));
        }
        lines.push_back(at_most("a pennant came apart (m)", double(engine.max_joint_error().linear), 0.005));
        return lines;
    };
    return scene;
}

}  // namespace islet::samples
