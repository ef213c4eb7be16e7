#include "measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace islet::compare {

using samples::BodyState;
using samples::Engine;
using samples::Scene;

namespace {

constexpr double two_pi = 6.283185307179586;

double square(double a) { return a * a; }

double length_of(Vec2 a) { return std::hypot(double(a.x), double(a.y)); }

/// Dynamic bodies alive in the engine; `visit(index, state)`.
template <class Visit>
void each_dynamic(const Engine& engine, Visit visit) {
    for (std::size_t i = 0; i < engine.body_slots(); ++i) {
        if (!engine.exists(i)) continue;
        const BodyState body = engine.body(i);
        if (body.mass > 0) visit(i, body);
    }
}

double gravity_scale(const Scene& scene, std::size_t index) {
    return index < scene.bodies.size() ? double(scene.bodies[index].def.gravity_scale) : 1.0;
}

bool rests(const BodyState& body) {
    return !body.awake || (length_of(body.linear_velocity) < double(rest_speed) && std::abs(body.angular_velocity) < rest_spin);
}

/// The kinetic energy at the start and the weight times the height the reference ever spans, at least 1 m:
/// the energy the scene plays with.
double energy_scale(const Run& run) {
    double top = -std::numeric_limits<double>::infinity(), low = std::numeric_limits<double>::infinity(), kinetic = 0;
    for (const Sample& s : run.samples) {
        top = std::max(top, s.reference.top_height);
        low = std::min(low, s.reference.low_height);
        kinetic = std::max(kinetic, s.reference.kinetic);
    }
    const State& start = run.first().reference;
    const double potential = start.weight * std::max(top - low, 1.0);
    return start.kinetic + potential > 0 ? start.kinetic + potential : std::max(kinetic, 1.0);
}

}  // namespace

State measure(const Engine& engine, const Scene& scene) {
    State state;
    const Vec2 g = scene.world.gravity;
    const double strength = length_of(g);
    const double up_x = strength > 0 ? -double(g.x) / strength : 0, up_y = strength > 0 ? -double(g.y) / strength : 1;
    double px = 0, py = 0;
    std::size_t count = 0, resting = 0;
    state.top_height = -std::numeric_limits<double>::infinity();
    state.low_height = std::numeric_limits<double>::infinity();

    each_dynamic(engine, [&](std::size_t index, const BodyState& body) {
        const double mass = double(body.mass);
        const double height = double(body.center.x) * up_x + double(body.center.y) * up_y;
        const double weight = mass * strength * gravity_scale(scene, index);
        const double vx = double(body.linear_velocity.x), vy = double(body.linear_velocity.y);
        const double kinetic = 0.5 * (mass * (vx * vx + vy * vy) + double(body.inertia) * square(double(body.angular_velocity)));
        state.kinetic += kinetic;
        state.energy += kinetic + weight * height;
        state.weight += weight;
        px += mass * vx;
        py += mass * vy;
        state.mean_height += height;
        state.top_height = std::max(state.top_height, height);
        state.low_height = std::min(state.low_height, height);
        ++count;
        if (rests(body)) ++resting;
    });

    state.momentum = {static_cast<float>(px), static_cast<float>(py)};
    if (count > 0) {
        state.mean_height /= double(count);
        state.at_rest = double(resting) / double(count);
    } else {
        state.top_height = state.low_height = 0;
    }
    state.penetration = engine.max_penetration();
    return state;
}

Apart measure_apart(const Engine& a, const Engine& b) {
    Apart apart;
    double position2 = 0, angle2 = 0, most2 = 0;
    each_dynamic(a, [&](std::size_t index, const BodyState& here) {
        if (!b.exists(index)) return;
        const BodyState there = b.body(index);
        const double d2 = square(double(here.center.x) - double(there.center.x)) + square(double(here.center.y) - double(there.center.y));
        const double turn = std::remainder(double(here.angle) - double(there.angle), two_pi);
        position2 += d2;
        angle2 += turn * turn;
        most2 = std::max(most2, std::isfinite(d2) ? d2 : std::numeric_limits<double>::infinity());
        ++apart.bodies;
    });
    if (apart.bodies > 0) {
        apart.rms_position = std::sqrt(position2 / double(apart.bodies));
        apart.rms_angle = std::sqrt(angle2 / double(apart.bodies));
        apart.max_position = std::sqrt(most2);
    }
    return apart;
}

Run run_both(Engine& islet, Engine& reference, const std::function<Scene()>& make, int steps, int horizon) {
    // A scene's script may remember things, so each engine has its own copy.
    const Scene scene_a = make(), scene_b = make();
    islet.load(scene_a);
    reference.load(scene_b);

    Run run;
    run.samples.reserve(static_cast<std::size_t>(steps) + 1);
    run.samples.push_back({0, measure(islet, scene_a), measure(reference, scene_b), measure_apart(islet, reference)});
    double position2 = 0, angle2 = 0, count = 0;
    for (int i = 0; i < steps; ++i) {
        islet.advance(scene_a, i, scene_a.dt);
        reference.advance(scene_b, i, scene_b.dt);
        const Sample& s =
            run.samples.emplace_back(Sample{i + 1, measure(islet, scene_a), measure(reference, scene_b), measure_apart(islet, reference)});
        if (!run.first_divergence_step && !(s.apart.max_position <= divergence_distance)) run.first_divergence_step = s.step;
        if (s.step > horizon) continue;
        const double bodies = double(s.apart.bodies);
        position2 += bodies * square(s.apart.rms_position);
        angle2 += bodies * square(s.apart.rms_angle);
        count += bodies;
        run.max_position = std::max(run.max_position, s.apart.max_position);
    }
    if (count > 0) {
        run.rms_position = std::sqrt(position2 / count);
        run.rms_angle = std::sqrt(angle2 / count);
    }
    run.energy_scale = energy_scale(run);
    return run;
}

double deepest_penetration(const Run& run, Side side) {
    double deepest = 0;
    for (const Sample& s : run.samples) deepest = std::max(deepest, (s.*side).penetration);
    return deepest;
}

double energy_drift(const Run& run, Side side) { return ((run.last().*side).energy - (run.first().*side).energy) / run.energy_scale; }

double energy_gain(const Run& run, Side side) {
    double gain = 0;
    for (const Sample& s : run.samples) gain = std::max(gain, (s.*side).energy - (run.first().*side).energy);
    return gain / run.energy_scale;
}

double momentum_drift(const Run& run, Side side) {
    double most = 0;
    for (const Sample& s : run.samples) most = std::max(most, length_of((s.*side).momentum));
    return most > 0 ? length_of((run.last().*side).momentum - (run.first().*side).momentum) / most : 0;
}

}  // namespace islet::compare
