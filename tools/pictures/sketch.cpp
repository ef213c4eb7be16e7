#include "sketch.hpp"

#include <cstdarg>

#include "scene_files/printable.hpp"

namespace islet::pictures {
namespace {

[[gnu::format(printf, 1, 2)]] std::string print(const char* format, ...) {
    char text[512];
    va_list values;
    va_start(values, format);
    std::vsnprintf(text, sizeof text, format, values);
    va_end(values);
    return text;
}

std::string look(const Pen& pen) {
    std::string text = print("stroke=\"%s\" fill=\"%s\" stroke-width=\"%.1f\"", pen.stroke, pen.fill, double(pen.width));
    if (*pen.dashes != '\0') text += print(" stroke-dasharray=\"%s\"", pen.dashes);
    return text;
}

std::string path(std::span<const Vec2> points) {
    std::string text;
    for (const Vec2 p : points) text += print("%.1f,%.1f ", double(p.x), double(p.y));
    return text;
}

/// The colour of a shape's outline: its own, darker.
DrawColor darker(DrawColor color) { return (color >> 1 & 0x7f7f7f) + (color >> 3 & 0x1f1f1f); }

}  // namespace

void Sketch::line(Vec2 a, Vec2 b, const Pen& pen) {
    const Vec2 ends[] = {a, b};
    polyline(ends, pen);
}

void Sketch::arrow(Vec2 a, Vec2 b, const Pen& pen) {
    line(a, b, pen);
    const Vec2 along = 8 * normalize(b - a);
    const Vec2 head[] = {b - along + 0.5f * left_perp(along), b, b - along + 0.5f * right_perp(along)};
    polyline(head, {pen.stroke, "none", pen.width, ""});
}

void Sketch::circle(Vec2 center, float radius, const Pen& pen) {
    body_ += print("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" ", double(center.x), double(center.y), double(radius)) + look(pen) + "/>\n";
}

void Sketch::polyline(std::span<const Vec2> points, const Pen& pen) {
    body_ += "<polyline points=\"" + path(points) + "\" stroke-linejoin=\"round\" stroke-linecap=\"round\" " + look(pen) + "/>\n";
}

void Sketch::box(Vec2 corner, float width, float height, const Pen& pen) {
    body_ += print("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" rx=\"5\" ", double(corner.x), double(corner.y), double(width), double(height)) +
             look(pen) + "/>\n";
}

void Sketch::text(Vec2 at, const std::string& words, const char* color, float size, const char* anchor) {
    body_ += print("<text x=\"%.1f\" y=\"%.1f\" fill=\"%s\" font-size=\"%.0f\" text-anchor=\"%s\">", double(at.x), double(at.y), color, double(size), anchor) +
             samples::markup(words) + "</text>\n";
}

/// Corners on the picture, rounded by a wide stroke of the shape's own colour.
void Sketch::shape(std::span<const Vec2> corners, float radius, const DrawStyle& style) {
    const std::string points = path(corners);
    const float round = 2 * camera_.scale * radius;
    const auto polygon = [&](DrawColor stroke, DrawColor fill, float width) {
        body_ += "<polygon points=\"" + points +
                 print("\" stroke=\"#%06x\" fill=\"#%06x\" stroke-width=\"%.1f\" stroke-linejoin=\"round\"/>\n", stroke, fill, double(width));
    };
    polygon(darker(style.color), style.color, round + 1.6f);
    if (round > 0) polygon(style.color, style.color, round - 1);
}

void Sketch::world(const World& world, const Camera& camera) {
    camera_ = camera;
    DebugDraw draw;
    draw.context = this;
    draw.joints = false;
    draw.polygon = [](std::span<const Vec2> corners, float radius, const DrawStyle& style, void* sketch) {
        Sketch& s = *static_cast<Sketch*>(sketch);
        Vec2 at[max_polygon_vertices];
        for (std::size_t i = 0; i < corners.size(); ++i) at[i] = s.camera_(corners[i]);
        s.shape({at, corners.size()}, radius, style);
    };
    draw.capsule = [](Vec2 point1, Vec2 point2, float radius, const DrawStyle& style, void* sketch) {
        Sketch& s = *static_cast<Sketch*>(sketch);
        const Vec2 at[] = {s.camera_(point1), s.camera_(point2)};
        s.shape(at, radius, style);
    };
    draw.circle = [](Vec2 center, float radius, Vec2, const DrawStyle& style, void* sketch) {
        Sketch& s = *static_cast<Sketch*>(sketch);
        const std::string stroke = print("#%06x", darker(style.color)), fill = print("#%06x", style.color);
        s.circle(s.camera_(center), s.camera_.scale * radius, {.stroke = stroke.c_str(), .fill = fill.c_str(), .width = 0.8f});
    };
    draw.segment = [](Vec2 point1, Vec2 point2, const DrawStyle&, void* sketch) {
        Sketch& s = *static_cast<Sketch*>(sketch);
        s.line(s.camera_(point1), s.camera_(point2), {.stroke = "#8f99a8", .width = 2});
    };
    world.draw(draw);
}

std::string Sketch::svg() const {
    return print("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" font-family=\"sans-serif\">\n", width_, height_) +
           print("<rect width=\"%d\" height=\"%d\" fill=\"#fdfcf9\"/>\n", width_, height_) + body_ + "</svg>\n";
}

}  // namespace islet::pictures
