// The ways a comparison is written down: a table, JSON, CSV and a picture of both final states.
#pragma once

#include <string>
#include <vector>

#include "judge.hpp"

namespace islet::compare {

/// One line per scene, and below it what failed.
std::string to_table(const std::vector<Comparison>& comparisons);
/// The list that README.md describes.
std::string to_json(const std::vector<Comparison>& comparisons);
/// One line per scene and step.
std::string to_csv(const std::vector<Comparison>& comparisons);

/// Outlines of all bodies of both engines, as they are now: Islet's filled, the reference's drawn over them.
std::string to_svg(const samples::Scene& scene, const samples::Engine& islet, const samples::Engine& reference, int step);

}  // namespace islet::compare
