// From metres to SVG path data: a camera, a writer of short relative paths, and the outlines of shapes.
#pragma once

#include <span>
#include <string>

#include <islet/islet.hpp>

namespace islet::tools {

/// Path data is written in whole tenths of a pixel: digits are what a picture of thousands of shapes is made of.
inline constexpr int units_per_pixel = 10;

/// A picture is at most so many times as high as it is wide.
inline constexpr double most_height_by_width = 4;

/// Maps the view, y up, to a picture, y down. Of a view that is too tall for a picture's width the sides show more.
struct Camera {
    Camera(const Aabb& view, double width_pixels);

    int x(double metres) const;
    int y(double metres) const;
    int length(double metres) const;

    Aabb view;
    double scale = 1;           // units per metre
    int width = 0, height = 0;  // units
};

/// Builds the `d` of a path from relative commands.
class PathWriter {
public:
    void move(int x, int y);
    /// As move, but nothing where a line has just ended there: of lines in a row, as those of a chain, only the first begins with a move.
    void go_on_from(int x, int y);
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

/// Points are in the world, m.
void draw_circle(PathWriter& path, const Camera& camera, Vec2 center, float radius);
/// Corners counter-clockwise, rounded by the radius; two are a capsule.
void draw_rounded(PathWriter& path, const Camera& camera, std::span<const Vec2> corners, float radius);
void draw_line(PathWriter& path, const Camera& camera, Vec2 from, Vec2 to);
void draw_dot(PathWriter& path, const Camera& camera, Vec2 at);

}  // namespace islet::tools
