// From metres to SVG path data: a camera, a writer of short relative paths, and the outlines of shapes.
#pragma once

#include <string>

#include "scene.hpp"

namespace islet::samples {

/// Path data is written in whole tenths of a pixel: digits are what a picture of thousands of shapes is made of.
inline constexpr int units_per_pixel = 10;

/// Maps the view, y up, to a picture, y down.
struct Camera {
    Camera(const Aabb& view, double width_pixels);

    int x(double metres) const;
    int y(double metres) const;
    int length(double metres) const;
    /// False if the shape lies wholly outside the view.
    bool sees(const SceneGeometry& geometry, const Transform& pose) const;

    Aabb view;
    double scale = 1;           // units per metre
    int width = 0, height = 0;  // units
};

/// Builds the `d` of a path from relative commands.
class PathWriter {
public:
    void move(int x, int y);
    void line(int x, int y);
    /// Circular arc to (x, y), the short way, turning with or against the clock as seen in the picture.
    void arc(int radius, int x, int y, bool clockwise);
    /// A point that shows with round line ends.
    void dot();
    void close();
    const std::string& text() const { return text_; }
    bool empty() const { return text_.empty(); }

private:
    void go(char command, int x, int y);
    void number(int n);

    std::string text_;
    char last_ = 0;  // command that may be left out if it comes again
    int x_ = 0, y_ = 0, start_x_ = 0, start_y_ = 0;
};

/// Segments and chains have no inside.
bool is_line(const SceneGeometry& geometry);
/// About the diameter, m.
double size_of(const SceneGeometry& geometry);
void draw_outline(PathWriter& path, const Camera& camera, const SceneGeometry& geometry, const Transform& pose);
/// A line that turns with the shape.
void draw_turn_hint(PathWriter& path, const Camera& camera, const SceneGeometry& geometry, const Transform& pose);

}  // namespace islet::samples
