// Draws a world as an SVG picture, through DebugDraw.
#pragma once

#include <string>

#include "runner.hpp"

namespace islet::tools {

/// What a picture shows besides shapes, unless it is told otherwise: joints, contacts and their normals.
DebugDraw usual_drawing();

/// The present state of a run as an SVG document, 1200 pixels wide, with the paths its scene wants shown. Of `what` the options count; the view and the
/// sizes of marks are the picture's own. Contacts are left out where bodies are so small or so many that the dots would hide them.
std::string draw_svg(const Run& run, const DebugDraw& what = usual_drawing());

}  // namespace islet::tools
