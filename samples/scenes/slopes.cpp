// Slopes: boxes that slide or hold, and what rolls down them.
#include <cmath>
#include <memory>
#include <string>

#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {
namespace {

constexpr float plank = 0.1f;  // half thickness of a slope, m

/// A plank through `middle`, turned by -slope so that it falls to the right.
void add_slope(Scene& scene, Vec2 middle, float half_length, float slope, float friction) {
    ShapeDef material;
    material.friction = friction;
    add_static(scene, middle, make_box(half_length, plank), material, -slope);
}

/// The point `along` metres down the slope from the plank's middle and `above` metres off its surface.
Vec2 on_slope(Vec2 middle, float slope, float along, float above) { return middle + rotate(make_rot(-slope), {along, plank + above}); }

constexpr int settled_step = 30;  // from here on a body's contact with its slope is established, and is measured

using States = std::vector<BodyState>;

/// Remembers the traced bodies as they are after the settled step.
std::shared_ptr<const States> remember_settled(Scene& scene) {
    auto settled = std::make_shared<States>();
    scene.after_step = [settled, traced = scene.traced](const Engine& engine, int step) {
        if (step + 1 != settled_step) return;
        settled->clear();
        for (const std::size_t body : traced) settled->push_back(engine.body(body));
    };
    return settled;
}

double measured_time(const Scene& scene) { return double(scene.dt) * (scene.steps - settled_step); }

double distance_between(const BodyState& a, const BodyState& b) {
    return std::hypot(double(b.position.x) - double(a.position.x), double(b.position.y) - double(a.position.y));
}

/// Speed down the slope, m/s.
double speed_of(const BodyState& state, float slope) { return double(dot(rotate(make_rot(-slope), {1, 0}), state.linear_velocity)); }

}  // namespace

Scene make_friction_ramp() {
    constexpr float slope = 20 * pi / 180, half_length = 6.5f, half = 0.25f;
    constexpr float friction[] = {0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.7f};  // tan(20 degrees) = 0.364
    Scene scene;
    scene.name = "friction_ramp";
    scene.steps = 180;
    scene.view = {{-7.5f, -3}, {7.5f, 10.5f}};

    struct Slider {
        std::size_t body;
        float friction;
    };
    std::vector<Slider> sliders;
    float y = 7.5f;
    for (const float mu : friction) {
        const Vec2 middle = {0, y};
        add_slope(scene, middle, half_length, slope, mu);
        ShapeDef material;
        material.friction = mu;
        sliders.push_back(
            {add_dynamic(scene, on_slope(middle, slope, -half_length + 0.7f, half), make_box(half, half), material, -slope), mu});
        scene.traced.push_back(sliders.back().body);
        y -= 1.5f;
    }

    scene.check = [sliders, settled = remember_settled(scene), t = measured_time(scene)](const Engine& engine) {
        std::vector<CheckLine> lines;
        for (std::size_t i = 0; i < sliders.size(); ++i) {
            const BodyState before = settled->at(i), now = engine.body(sliders[i].body);
            const double mu = double(sliders[i].friction), due = 10 * (std::sin(double(slope)) - mu * std::cos(double(slope)));
            const double gained = (speed_of(now, slope) - speed_of(before, slope)) / t;
            const std::string name = "mu = 0." + std::to_string(std::lround(10 * mu));
            if (due > 0)
                lines.push_back(near_line(name + " slides: acceleration, due g (sin - mu cos) (m/s^2)", gained, due, 0.01 * due + 0.005));
            else
                lines.push_back(at_most(name + " holds: moved after the first half second (m)", distance_between(before, now), 0.001));
        }
        return lines;
    };
    return scene;
}

Scene make_rolling() {
    constexpr float slope = 15 * pi / 180, half_length = 4, radius = 0.4f, bead = 0.04f;
    Scene scene;
    scene.name = "rolling";
    scene.steps = 120;
    scene.view = {{-5, -4.2f}, {5, 4.2f}};

    // A disc that slides, a disc that rolls, and a ring that rolls. The ring is a massless outline with eight beads on it that touch
    // nothing; at this distance from the middle d^2 + bead^2 / 2 = radius^2, so that its inertia is m radius^2.
    ShapeDef rough;
    rough.friction = 0.9f;
    ShapeDef smooth;
    smooth.friction = 0;
    ShapeDef outline = rough;
    outline.density = 0;
    ShapeDef beads;
    beads.density = 20;
    beads.filter.mask = 0;
    std::vector<SceneShape> ring = {{Circle{{}, radius}, outline}};
    const float distance = std::sqrt(radius * radius - 0.5f * bead * bead);
    for (int i = 0; i < 8; ++i) {
        const Rot q = make_rot(static_cast<float>(i) * pi / 4);
        ring.push_back({Circle{{distance * q.c, distance * q.s}, bead}, beads});
    }

    struct Racer {
        const char* name;
        std::size_t body;
        double share;  // of g sin(slope)
        bool rolls;
    };
    std::vector<Racer> racers;
    const auto add_racer = [&](const char* name, float y, std::vector<SceneShape> shapes, const ShapeDef& ground, double share,
                               bool rolls) {
        const Vec2 middle = {0, y};
        add_slope(scene, middle, half_length, slope, ground.friction);
        BodyDef body;
        body.type = BodyType::dynamic;
        body.position = on_slope(middle, slope, -half_length + 0.6f, radius);
        racers.push_back({name, add_body(scene, body, std::move(shapes)), share, rolls});
        scene.traced.push_back(racers.back().body);
    };
    add_racer("sliding disc", 2.3f, {{Circle{{}, radius}, smooth}}, smooth, 1, false);
    add_racer("rolling disc", 0, {{Circle{{}, radius}, rough}}, rough, 2.0 / 3, true);
    add_racer("rolling ring", -2.3f, std::move(ring), rough, 1.0 / 2, true);

    scene.check = [racers, settled = remember_settled(scene), t = measured_time(scene)](const Engine& engine) {
        std::vector<CheckLine> lines;
        for (std::size_t i = 0; i < racers.size(); ++i) {
            const Racer& racer = racers[i];
            const BodyState now = engine.body(racer.body);
            const double share = (speed_of(now, slope) - speed_of(settled->at(i), slope)) / (t * 10 * std::sin(double(slope)));
            lines.push_back(near_line(std::string(racer.name) + ": acceleration over g sin", share, racer.share, 0.01 * racer.share));
            const double rim = -double(now.angular_velocity) * double(radius);
            if (racer.rolls)
                lines.push_back(at_most(std::string(racer.name) + ": slip of its rim (m/s)", std::abs(speed_of(now, slope) - rim), 0.02));
            else
                lines.push_back(at_most(std::string(racer.name) + ": speed of its rim (m/s)", std::abs(rim), 0.02));
        }
        return lines;
    };
    return scene;
}

}  // namespace islet::samples
