#include "svg_path.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace islet::samples {
namespace {

/// A circle is two half arcs.
void circle_outline(PathWriter& path, const Camera& camera, Vec2 center, float radius) {
    const int x = camera.x(double(center.x)), y = camera.y(double(center.y)), r = std::max(1, camera.length(double(radius)));
    path.move(x - r, y);
    path.arc(r, x + r, y, false);
    path.arc(r, x - r, y, false);
    path.close();
}

/// Corners in order, counter-clockwise in the world, rounded by the radius.
void rounded_outline(PathWriter& path, const Camera& camera, const std::vector<Vec2>& points, float radius) {
    const int r = camera.length(double(radius));
    const auto x = [&](Vec2 p) { return camera.x(double(p.x)); };
    const auto y = [&](Vec2 p) { return camera.y(double(p.y)); };
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 here = points[i], next = points[(i + 1) % count], before = points[(i + count - 1) % count];
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

struct Outline {
    PathWriter& path;
    const Camera& camera;
    const Transform& pose;

    int x(Vec2 local) const { return camera.x(double(transform_point(pose, local).x)); }
    int y(Vec2 local) const { return camera.y(double(transform_point(pose, local).y)); }

    void operator()(const Circle& c) const { circle_outline(path, camera, transform_point(pose, c.center), c.radius); }
    void operator()(const Capsule& c) const {
        rounded_outline(path, camera, {transform_point(pose, c.point1), transform_point(pose, c.point2)}, c.radius);
    }
    void operator()(const Segment& s) const {
        path.move(x(s.point1), y(s.point1));
        path.line(x(s.point2), y(s.point2));
    }
    void operator()(const Polygon& p) const {
        std::vector<Vec2> points;
        for (std::uint32_t i = 0; i < p.count; ++i) points.push_back(transform_point(pose, p.vertices[i]));
        rounded_outline(path, camera, points, p.radius);
    }
    void operator()(const Chain& c) const {
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            if (i == 0)
                path.move(x(c.points[i]), y(c.points[i]));
            else
                path.line(x(c.points[i]), y(c.points[i]));
        }
        if (c.loop) path.close();
    }
};

struct LocalBox {
    Aabb operator()(const Circle& c) const { return compute_aabb(c, {}); }
    Aabb operator()(const Capsule& c) const { return compute_aabb(c, {}); }
    Aabb operator()(const Segment& s) const { return compute_aabb(s, {}); }
    Aabb operator()(const Polygon& p) const { return compute_aabb(p, {}); }
    Aabb operator()(const Chain& c) const {
        if (c.points.empty()) return {};
        Aabb box = {c.points[0], c.points[0]};
        for (const Vec2 p : c.points) box = merge(box, {p, p});
        return box;
    }
};

}  // namespace

Camera::Camera(const Aabb& shown, double width_pixels) : view(shown) {
    width = static_cast<int>(width_pixels) * units_per_pixel;
    scale = width / std::max(1e-6, double(view.upper.x) - double(view.lower.x));
    const int exact = static_cast<int>(std::lround((double(view.upper.y) - double(view.lower.y)) * scale));
    height = exact / units_per_pixel * units_per_pixel;
}

int Camera::x(double metres) const { return static_cast<int>(std::lround(std::clamp((metres - double(view.lower.x)) * scale, -1e6, 1e6))); }

int Camera::y(double metres) const { return static_cast<int>(std::lround(std::clamp((double(view.upper.y) - metres) * scale, -1e6, 1e6))); }

int Camera::length(double metres) const { return static_cast<int>(std::lround(metres * scale)); }

bool Camera::sees(const SceneGeometry& geometry, const Transform& pose) const {
    // The box around the turned local box: generous, which is fine for leaving shapes out.
    const Aabb local = std::visit(LocalBox{}, geometry);
    const Vec2 center = transform_point(pose, lerp(local.lower, local.upper, 0.5f));
    return is_finite(center) && overlaps(view, expand({center, center}, 0.5f * distance(local.lower, local.upper)));
}

void PathWriter::move(int x, int y) {
    go('m', x, y);
    start_x_ = x;
    start_y_ = y;
    last_ = 'l';  // further pairs after a move are lines
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

bool is_line(const SceneGeometry& geometry) { return std::holds_alternative<Segment>(geometry) || std::holds_alternative<Chain>(geometry); }

double size_of(const SceneGeometry& geometry) {
    const Aabb box = std::visit(LocalBox{}, geometry);
    return 0.5 * (double(box.upper.x - box.lower.x) + double(box.upper.y - box.lower.y));
}

void draw_outline(PathWriter& path, const Camera& camera, const SceneGeometry& geometry, const Transform& pose) {
    std::visit(Outline{path, camera, pose}, geometry);
}

void draw_turn_hint(PathWriter& path, const Camera& camera, const SceneGeometry& geometry, const Transform& pose) {
    Vec2 from, to;
    if (const auto* circle = std::get_if<Circle>(&geometry)) {
        from = circle->center;
        to = from + Vec2{0.85f * circle->radius, 0};
    } else if (const auto* capsule = std::get_if<Capsule>(&geometry)) {
        from = lerp(capsule->point1, capsule->point2, 0.5f);
        to = capsule->point2;
    } else if (const auto* polygon = std::get_if<Polygon>(&geometry)) {
        from = polygon->centroid;
        to = lerp(from, lerp(polygon->vertices[0], polygon->vertices[1], 0.5f), 0.6f);
    } else {
        return;
    }
    from = transform_point(pose, from);
    to = transform_point(pose, to);
    path.move(camera.x(double(from.x)), camera.y(double(from.y)));
    path.line(camera.x(double(to.x)), camera.y(double(to.y)));
}

}  // namespace islet::samples
