#include "svg_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace islet::tools {

namespace {

constexpr double farthest = 1e6;  // units; beyond lies nothing that shows

int whole_units(double exact) { return static_cast<int>(std::lround(std::clamp(exact, -farthest, farthest))); }

}  // namespace

Camera::Camera(const Aabb& shown, double width_pixels) : view(shown) {
    width = static_cast<int>(width_pixels) * units_per_pixel;
    const double view_width = std::max(1e-6, double(view.upper.x) - double(view.lower.x));
    const double view_height = double(view.upper.y) - double(view.lower.y);
    const double tallest = most_height_by_width * width;
    scale = std::min(width / view_width, tallest / view_height);
    height = whole_units(view_height * scale) / units_per_pixel * units_per_pixel;
    if (width / view_width <= scale) return;
    // A view that is too tall for that shows more to both sides.
    const double middle = 0.5 * (double(view.lower.x) + double(view.upper.x)), half = 0.5 * width / scale;
    constexpr double most = double(std::numeric_limits<float>::max());
    view.lower.x = static_cast<float>(std::max(middle - half, -most));
    view.upper.x = static_cast<float>(std::min(middle + half, most));
}

int Camera::x(double metres) const { return whole_units((metres - double(view.lower.x)) * scale); }

int Camera::y(double metres) const { return whole_units((double(view.upper.y) - metres) * scale); }

int Camera::length(double metres) const { return whole_units(metres * scale); }

void PathWriter::move(int x, int y) {
    go('m', x, y);
    start_x_ = x;
    start_y_ = y;
    last_ = 'l';  // further pairs after a move are lines
}

void PathWriter::go_on_from(int x, int y) {
    if (last_ != 'l' || x != x_ || y != y_) move(x, y);
}

void PathWriter::line(int x, int y) { go('l', x, y); }

void PathWriter::arc(int radius, int x, int y, bool clockwise) {
    text_ += fmt::format("a{} {} 0 0 {}", radius, radius, clockwise ? 1 : 0);
    number(x - x_);
    number(y - y_);
    x_ = x;
    y_ = y;
    last_ = 0;
}

void PathWriter::dot() {
    text_ += "h0";
    last_ = 0;
}

void PathWriter::close() {
    text_ += 'z';
    last_ = 0;
    x_ = start_x_;
    y_ = start_y_;
}

void PathWriter::go(char command, int x, int y) {
    if (command != last_) text_ += command;
    number(x - x_);
    number(y - y_);
    x_ = x;
    y_ = y;
    last_ = command;
}

/// A number parts itself from a letter or, by its minus sign, from a number before it; else a space is needed.
void PathWriter::number(int n) {
    const bool after_digit = !text_.empty() && text_.back() >= '0' && text_.back() <= '9';
    if (after_digit && n >= 0) text_ += ' ';
    text_ += fmt::format_int(n).c_str();
}

// A circle is two half arcs.
void draw_circle(PathWriter& path, const Camera& camera, Vec2 center, float radius) {
    const int x = camera.x(double(center.x)), y = camera.y(double(center.y)), r = std::max(1, camera.length(double(radius)));
    path.move(x - r, y);
    path.arc(r, x + r, y, false);
    path.arc(r, x - r, y, false);
    path.close();
}

void draw_rounded(PathWriter& path, const Camera& camera, std::span<const Vec2> corners, float radius) {
    const int r = camera.length(double(radius));
    const auto x = [&](Vec2 p) { return camera.x(double(p.x)); };
    const auto y = [&](Vec2 p) { return camera.y(double(p.y)); };
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 here = corners[i], next = corners[(i + 1) % count], before = corners[(i + count - 1) % count];
        const Vec2 offset_in = radius * normalize(right_perp(here - before));
        const Vec2 offset_out = radius * normalize(right_perp(next - here));
        if (i == 0)
            path.move(x(here + offset_in), y(here + offset_in));
        else
            path.line(x(here + offset_in), y(here + offset_in));
        if (r > 0) path.arc(r, x(here + offset_out), y(here + offset_out), false);
    }
    path.close();
}

void draw_line(PathWriter& path, const Camera& camera, Vec2 from, Vec2 to) {
    path.go_on_from(camera.x(double(from.x)), camera.y(double(from.y)));
    path.line(camera.x(double(to.x)), camera.y(double(to.y)));
}

void draw_dot(PathWriter& path, const Camera& camera, Vec2 at) {
    path.move(camera.x(double(at.x)), camera.y(double(at.y)));
    path.dot();
}

}  // namespace islet::tools
