#include "checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace islet::samples {
namespace {

bool finite(const BodyState& s) {
    return std::isfinite(s.position.x) && std::isfinite(s.position.y) && std::isfinite(s.angle) && std::isfinite(s.linear_velocity.x) &&
           std::isfinite(s.linear_velocity.y) && std::isfinite(s.angular_velocity);
}

void widen(Drift& drift, const BodyState& before, const BodyState& after) {
    constexpr double lost = std::numeric_limits<double>::infinity();
    if (!finite(after)) {
        drift = {lost, lost, lost, lost};
        return;
    }
    const double dx = double(after.position.x) - double(before.position.x);
    const double dy = double(after.position.y) - double(before.position.y);
    drift.distance = std::max(drift.distance, std::hypot(dx, dy));
    drift.sideways = std::max(drift.sideways, std::abs(dx));
    drift.sink = std::max(drift.sink, -dy);
    drift.turn = std::max(drift.turn, std::abs(angle_difference(double(after.angle), double(before.angle))));
}

/// Calls f with the state of every dynamic body.
template <class F>
void each_dynamic(const Engine& engine, F f) {
    for (std::size_t i = 0; i < engine.body_slots(); ++i) {
        if (!engine.exists(i)) continue;
        const BodyState s = engine.body(i);
        if (s.mass > 0) f(s);
    }
}

}  // namespace

double angle_difference(double a, double b) { return std::remainder(a - b, 2 * std::numbers::pi); }

std::vector<BodyState> places_of(const Scene& scene, std::size_t first, std::size_t end) {
    std::vector<BodyState> states(end - first);
    for (std::size_t i = first; i < end; ++i) {
        states[i - first].position = scene.bodies[i].def.position;
        states[i - first].angle = scene.bodies[i].def.angle;
    }
    return states;
}

std::vector<BodyState> states_of(const Engine& engine, std::size_t first, std::size_t end) {
    std::vector<BodyState> states;
    states.reserve(end - first);
    for (std::size_t i = first; i < end; ++i) states.push_back(engine.body(i));
    return states;
}

Drift drift_from(const std::vector<BodyState>& before, const Engine& engine, std::size_t first) {
    Drift drift;
    for (std::size_t i = 0; i < before.size(); ++i) {
        BodyState now;
        now.position.x = std::numeric_limits<float>::infinity();
        if (engine.exists(first + i)) now = engine.body(first + i);
        widen(drift, before[i], now);
    }
    return drift;
}

std::size_t count_not_finite(const Engine& engine) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < engine.body_slots(); ++i) {
        if (engine.exists(i) && !finite(engine.body(i))) ++count;
    }
    return count;
}

std::size_t count_outside(const Engine& engine, const Aabb& box) {
    std::size_t count = 0;
    each_dynamic(engine, [&](const BodyState& s) {
        const bool inside =
            s.position.x >= box.lower.x && s.position.x <= box.upper.x && s.position.y >= box.lower.y && s.position.y <= box.upper.y;
        if (!inside) ++count;
    });
    return count;
}

double max_speed(const Engine& engine) {
    double fastest = 0;
    each_dynamic(engine, [&](const BodyState& s) {
        fastest = std::max(fastest, std::hypot(double(s.linear_velocity.x), double(s.linear_velocity.y)));
    });
    return fastest;
}

double kinetic_energy(const Engine& engine) {
    double sum = 0;
    each_dynamic(engine, [&](const BodyState& s) {
        const double vx = double(s.linear_velocity.x), vy = double(s.linear_velocity.y), w = double(s.angular_velocity);
        sum += 0.5 * double(s.mass) * (vx * vx + vy * vy) + 0.5 * double(s.inertia) * w * w;
    });
    return sum;
}

double potential_energy(const Engine& engine, Vec2 gravity) {
    double sum = 0;
    each_dynamic(engine, [&](const BodyState& s) {
        sum -= double(s.mass) * (double(gravity.x) * double(s.center.x) + double(gravity.y) * double(s.center.y));
    });
    return sum;
}

double mechanical_energy(const Engine& engine, Vec2 gravity) { return kinetic_energy(engine) + potential_energy(engine, gravity); }

void momentum(const Engine& engine, double& x, double& y) {
    x = y = 0;
    each_dynamic(engine, [&](const BodyState& s) {
        x += double(s.mass) * double(s.linear_velocity.x);
        y += double(s.mass) * double(s.linear_velocity.y);
    });
}

double angular_momentum(const Engine& engine) {
    double sum = 0;
    each_dynamic(engine, [&](const BodyState& s) {
        const double moment = double(s.center.x) * double(s.linear_velocity.y) - double(s.center.y) * double(s.linear_velocity.x);
        sum += double(s.mass) * moment + double(s.inertia) * double(s.angular_velocity);
    });
    return sum;
}

CheckLine near_line(std::string what, double value, double expected, double tolerance) {
    return {std::move(what), value, expected - tolerance, expected + tolerance};
}

CheckLine at_most(std::string what, double value, double high) { return {std::move(what), value, 0, high}; }

CheckLine wanted_line(std::string what, double value, double most, double known) {
    return {std::move(what), value, 0, std::max(most, known), Wanted{.most = most}};
}

CheckLine wanted_none(std::string what, bool failed, bool may_fail) {
    return {std::move(what), failed ? 1.0 : 0.0, 0, may_fail ? 1.0 : 0.0, Wanted{.counts = true}};
}

std::vector<CheckLine> count_lines(const Engine& engine, std::size_t bodies, std::size_t shapes, std::size_t contacts, std::size_t joints) {
    const EngineCounts counts = engine.counts();
    return {
        near_line("bodies", double(counts.bodies), double(bodies), 0),
        near_line("shapes", double(counts.shapes), double(shapes), 0),
        near_line("joints", double(counts.joints), double(joints), 0),
        near_line("contacts", double(counts.contacts), double(contacts), 0.3 * double(contacts)),  // as much work as for Box2D, more or less
        at_most("bodies not finite", double(count_not_finite(engine)), 0),
    };
}

}  // namespace islet::samples
