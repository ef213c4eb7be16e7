// What the tests of physics measure, in doubles, so that the sums add no rounding of their own.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "support/effort.hpp"
#include "support/test_world.hpp"

namespace islet::test {

inline constexpr float step_time = 1.0f / 60;   // s
inline constexpr double g = 10;                 // m/s^2, the default gravity
inline constexpr double eps = 1.0 / (1 << 24);  // largest relative error of one rounding of a float

/// What does not change in a free system (the momenta) or only falls (the energy).
struct Invariants {
    double px = 0, py = 0;  // kg m/s
    double spin = 0;        // kg m^2/s about the origin
    double energy = 0;      // J, kinetic
};

inline double kinetic_energy(const World& w, BodyId id) {
    const double vx = double(w.linear_velocity(id).x), vy = double(w.linear_velocity(id).y), turn = double(w.angular_velocity(id));
    return 0.5 * (double(w.mass(id)) * (vx * vx + vy * vy) + double(w.rotational_inertia(id)) * turn * turn);
}

/// J: kinetic, and potential above y = 0 at the default gravity.
inline double energy_of(const World& w, std::span<const BodyId> bodies) {
    double sum = 0;
    for (const BodyId id : bodies) sum += kinetic_energy(w, id) + double(w.mass(id)) * g * double(w.center_of_mass(id).y);
    return sum;
}

/// m, by which joints come apart: the largest.
inline double widest_gap(const World& w, std::span<const JointId> joints) {
    double most = 0;
    for (const JointId id : joints) most = std::fmax(most, double(w.joint_error(id).linear));
    return most;
}

inline Invariants invariants_of(const TestWorld& world) {
    Invariants sum;
    for (const BodyId id : world.bodies()) {
        const double m = double(world->mass(id));
        const Vec2 c = world->center_of_mass(id), v = world->linear_velocity(id);
        sum.px += m * double(v.x);
        sum.py += m * double(v.y);
        sum.spin += m * (double(c.x) * double(v.y) - double(c.y) * double(v.x)) + double(world->rotational_inertia(id)) * double(world->angular_velocity(id));
        sum.energy += kinetic_energy(*world, id);
    }
    return sum;
}

/// Deepest overlap of two touching shapes, m.
inline double deepest_overlap(const TestWorld& world) {
    double deepest = 0;
    for (const ContactInfo& c : world.contacts())
        for (std::uint32_t i = 0; i < c.point_count; ++i) deepest = std::fmax(deepest, -double(c.points[i].separation));
    return deepest;
}

/// The corners of a regular polygon about the origin, on a circle of that radius (m).
inline std::vector<Vec2> regular(int corners, float radius) {
    std::vector<Vec2> points;
    for (int i = 0; i < corners; ++i) points.push_back(rotate(make_rot(2 * pi * static_cast<float>(i) / static_cast<float>(corners)), {radius, 0}));
    return points;
}

/// A definition of a dynamic body; the rest is for the test to fill in.
inline BodyDef dynamic_at(Vec2 position, float angle = 0) {
    BodyDef def;
    def.type = BodyType::dynamic;
    def.position = position;
    def.angle = angle;
    return def;
}

/// A material with all but one number at its default.
inline ShapeDef dense(float density) {
    ShapeDef def;
    def.density = density;
    return def;
}
inline ShapeDef rough(float friction) {
    ShapeDef def;
    def.friction = friction;
    return def;
}

/// No gravity, nothing falls asleep.
inline WorldDef weightless() {
    WorldDef def;
    def.gravity = {0, 0};
    def.enable_sleep = false;
    return def;
}

/// Gravity as usual, nothing falls asleep.
inline WorldDef sleepless() {
    WorldDef def;
    def.enable_sleep = false;
    return def;
}

}  // namespace islet::test
