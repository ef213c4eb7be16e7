// What World::draw hands out, kept in lists: what pictures and movies of a world are made of.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <islet/islet.hpp>

namespace islet::tools {

/// One thing that was drawn. Its points are kept by the Drawing it is in: a circle's are its middle and a point on it that turns with it.
struct Stroke {
    enum class Figure : std::uint8_t { polygon, circle, capsule, segment, point };

    Figure figure = Figure::point;
    DrawStyle style;
    float radius = 0;  // m: of a circle or capsule, or that rounds a polygon
    std::uint32_t first_point = 0, point_count = 0;
};

struct Word {
    Vec2 at;
    std::string text;
    DrawColor color = 0;
};

class Drawing {
public:
    /// Adds what the options ask for; their functions and context are the drawing's own.
    void add(const World& world, DebugDraw options);
    /// Adds a shape alone, in its body's frame.
    void add_shape(const World& world, ShapeId shape);
    void clear();

    /// In the order in which they were drawn.
    const std::vector<Stroke>& strokes() const { return strokes_; }
    std::span<const Vec2> points(const Stroke& stroke) const { return {points_.data() + stroke.first_point, stroke.point_count}; }
    const std::vector<Word>& words() const { return words_; }

private:
    void take_all(DebugDraw& options);
    void put(Stroke::Figure figure, std::span<const Vec2> points, float radius, const DrawStyle& style);

    std::vector<Stroke> strokes_;
    std::vector<Vec2> points_;
    std::vector<Word> words_;
};

/// About the diameter of a shape, m: the middle of height and width, seen along the first edge.
double size_of(const Drawing& drawing, const Stroke& shape);
/// The middling size of the bodies that are not static, each by its largest shape, m: marks are drawn in proportion to it. 0 if there are none.
double typical_size(const Drawing& drawing);
/// DebugDraw::size for joints, m, in a picture of so many pixels a metre.
float joint_mark_size(double typical_size, double pixels_per_metre);

}  // namespace islet::tools
