// What the scenes' checks measure, for any engine.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine.hpp"
#include "scene.hpp"

namespace islet::samples {

/// How far bodies are from where the scene put them.
struct Drift {
    double distance = 0;  // m, the largest of all
    double sideways = 0;  // m, the largest along x
    double sink = 0;      // m, the largest fall
    double turn = 0;      // rad, the largest
};

/// Where the scene puts bodies first <= index < end; only position and angle are set.
std::vector<BodyState> places_of(const Scene& scene, std::size_t first, std::size_t end);
/// The states of bodies first <= index < end now.
std::vector<BodyState> states_of(const Engine& engine, std::size_t first, std::size_t end);
/// How far bodies first, first + 1, ... are from `before`. A body that is gone or not finite gives infinite drift.
Drift drift_from(const std::vector<BodyState>& before, const Engine& engine, std::size_t first);

/// a - b brought to (-pi, pi].
double angle_difference(double a, double b);

/// Bodies with a position or velocity that is NaN or infinite.
std::size_t count_not_finite(const Engine& engine);
/// Dynamic bodies whose origin is outside the box.
std::size_t count_outside(const Engine& engine, const Aabb& box);
/// Largest speed of a dynamic body's centre of mass, m/s.
double max_speed(const Engine& engine);
/// Sum over the dynamic bodies, J.
double kinetic_energy(const Engine& engine);
/// Sum of -m g . x over the dynamic bodies, J.
double potential_energy(const Engine& engine, Vec2 gravity);
/// The sum of both, J.
double mechanical_energy(const Engine& engine, Vec2 gravity);
/// Sum of m v over the dynamic bodies, kg m/s.
void momentum(const Engine& engine, double& x, double& y);

/// Sum of m (c x v) + I w over the dynamic bodies, about the world's origin, kg m^2/s.
double angular_momentum(const Engine& engine);

/// A line that passes within `tolerance` of `expected`.
CheckLine near_line(std::string what, double value, double expected, double tolerance);
/// A line that passes from 0 to `high`.
CheckLine at_most(std::string what, double value, double high);
/// A row of `islet steady`: at most `most` is wanted. Where the engine falls short of that, the check passes up to `known`.
CheckLine wanted_line(std::string what, double value, double most, double known = 0);
/// A row that counts the starts that failed: none is wanted. Where some are known to fail, this one may.
CheckLine wanted_none(std::string what, bool failed, bool may_fail = false);
/// Bodies, shapes and joints exactly, contacts (which depend on box margins) within 15 %, and no number that is not finite.
std::vector<CheckLine> count_lines(const Engine& engine, std::size_t bodies, std::size_t shapes, std::size_t contacts,
                                   std::size_t joints = 0);

}  // namespace islet::samples
