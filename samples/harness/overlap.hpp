// How deep polygons are in each other, worked out from where the bodies are and their shapes alone: an engine may keep no contact where it should, and the
// same measure holds for every engine.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine.hpp"
#include "scene.hpp"

namespace islet::samples {

using Corner = std::array<double, 2>;
using Outline = std::vector<Corner>;

/// A polygon's corners in the world, counter-clockwise.
Outline outline_of(const Polygon& polygon, const Transform& pose);
/// How far two convex outlines would have to move to come apart, m; negative where they are.
double overlap_of(const Outline& a, const Outline& b);

/// The polygons of a scene that are no sensors, each with its body.
struct ScenePolygon {
    std::size_t body = 0;
    Polygon shape;
};
std::vector<ScenePolygon> polygons_in(const Scene& scene);

/// Two polygons of different bodies.
struct Overlap {
    std::size_t body_a = 0, body_b = 0;
    double depth = 0;  // m
};

/// All that overlap by more than `least` m, at least one of the two being dynamic. Bodies that are gone are left out.
std::vector<Overlap> overlaps_of(const std::vector<ScenePolygon>& polygons, const Engine& engine, double least);
/// The deepest of them, m; 0 if there is none.
double deepest_overlap(const std::vector<ScenePolygon>& polygons, const Engine& engine);

}  // namespace islet::samples
