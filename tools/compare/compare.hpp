// One scene through both engines: run, judge, and draw.
#pragma once

#include <string>

#include "judge.hpp"
#include "scenes/catalogue.hpp"

namespace islet::compare {

/// The reference advances in substeps as long as Islet's, so that free motion is integrated alike and what differs is contact.
inline constexpr int reference_substeps = 4;

/// steps 0: as many as the tolerance says. If `svg` is given it receives the picture of the final states.
Comparison compare_scene(const samples::SceneInfo& info, const Tolerance& tolerance, int steps = 0, std::string* svg = nullptr);

}  // namespace islet::compare
