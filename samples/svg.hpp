// Draws a state as an SVG picture.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "runner.hpp"

namespace islet::samples {

/// How a drawn shape is coloured.
enum class Look : std::uint8_t { fixed, kinematic, awake, asleep };

struct DrawnShape {
    SceneGeometry geometry;
    Transform pose;
    Look look = Look::fixed;
    std::size_t body = 0;  // which body it belongs to: neighbours get slightly different tints
};

struct DrawnContact {
    Vec2 point;
    Vec2 normal;
};

struct DrawnJoint {
    std::vector<Vec2> line, dots;
};

/// What a picture shows, whichever engine it came from.
struct Picture {
    std::string title, details;  // the caption: bold, and beside it
    Aabb view;                   // m
    std::vector<DrawnShape> shapes;
    std::vector<DrawnContact> contacts;
    std::vector<DrawnJoint> joints;
    std::vector<Trail> trails;
};

/// The present state of a run, with the paths its scene wants shown.
Picture picture_of(const Run& run);
/// An SVG document, 1200 pixels wide.
std::string draw_svg(const Picture& picture);

}  // namespace islet::samples
