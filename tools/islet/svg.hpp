// Draws a world as an SVG picture, through DebugDraw.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runner.hpp"

namespace islet::tools {

/// What a picture shows besides shapes, unless it is told otherwise: joints, contacts and their normals.
DebugDraw usual_drawing();

/// What a picture shows of a world, and what its caption says.
struct Picture {
    Aabb view = {{-10, -1}, {10, 11}};          // m
    std::string title = {};
    float dt = 1.0f / 60;                       // s, of a step
    std::vector<Trail> trails = {};
    std::uint32_t most_dropped_contacts = 0;    // as in Run
};

/// The present state of a world as an SVG document, 1200 pixels wide. Of `what` the options count; the view and the sizes of marks are the picture's own.
/// Contacts are left out where bodies are so small or so many that the dots would hide them.
std::string draw_svg(const World& world, const Picture& picture, const DebugDraw& what = usual_drawing());
/// That of a run, with the paths its scene wants shown.
std::string draw_svg(const Run& run, const DebugDraw& what = usual_drawing());

}  // namespace islet::tools
