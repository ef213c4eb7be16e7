#include "film.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>

namespace islet::pictures {
namespace {

// Between two key frames bodies move in a straight line. So far may they be from where they were:
constexpr float tolerance = 0.5f;  // px
constexpr float reach = 14;        // px, at which a turn counts as a way

[[gnu::format(printf, 1, 2)]] std::string print(const char* format, ...) {
    char text[256];
    va_list values;
    va_start(values, format);
    std::vsnprintf(text, sizeof text, format, values);
    va_end(values);
    return text;
}

/// A number with as few characters as show it.
std::string number(float n, int digits) {
    std::string text = print("%.*f", digits, double(n));
    while (text.find('.') != std::string::npos && (text.back() == '0' || text.back() == '.')) {
        const bool point = text.back() == '.';
        text.pop_back();
        if (point) break;
    }
    return text == "-0" ? "0" : text;
}

/// Outlines of a body in its own frame, in px.
struct Outliner {
    std::string text;
    float scale;

    std::string at(Vec2 p) const { return number(scale * p.x, 1) + " " + number(-scale * p.y, 1); }
};

void outline_polygon(span<const Vec2> corners, float radius, const DrawStyle&, void* context) {
    Outliner& o = *static_cast<Outliner*>(context);
    o.text += "<path d=\"";
    for (std::size_t i = 0; i < corners.size(); ++i) o.text += (i == 0 ? "M" : "L") + o.at(corners[i]);
    o.text += radius > 0 ? print("Z\" stroke=\"%%\" stroke-width=\"%.1f\"/>", double(2 * radius * o.scale)) : "Z\"/>";
}

void outline_circle(Vec2 center, float radius, Vec2 axis, const DrawStyle&, void* context) {
    Outliner& o = *static_cast<Outliner*>(context);
    const std::string r = number(o.scale * radius, 1);
    o.text += "<path d=\"M" + o.at(center - radius * axis) + "a" + r + " " + r + " 0 1 1 0 .01Z\"/><path d=\"M" + o.at(center) + "L" +
              o.at(center + radius * axis) + "\"/>";
}

void outline_capsule(Vec2 point1, Vec2 point2, float radius, const DrawStyle& style, void* context) {
    const Vec2 ends[] = {point1, point2};
    outline_polygon(ends, radius, style, context);
}

}  // namespace

Film::Film(const World& world, const Camera& camera, int width, int height, float seconds)
    : camera_(camera), width_(width), height_(height), seconds_(seconds), bodies_(world.capacity().bodies) {
    for (std::uint32_t slot = 0; slot < bodies_.size(); ++slot) {
        const BodyId body = world.body_at(slot);
        if (!body) continue;
        bodies_[slot].moves = world.type(body) != BodyType::static_body;
        Outliner outliner = {{}, camera.scale};  // at the origin, as the body sees its shapes
        ShapeId shapes[8];
        for (const ShapeId shape : span<ShapeId>(shapes, std::min<std::size_t>(world.shapes(body, shapes), std::size(shapes)))) {
            DebugDraw draw;
            draw.context = &outliner;
            draw.polygon = outline_polygon;
            draw.circle = outline_circle;
            draw.capsule = outline_capsule;
            if (const Polygon* polygon = world.polygon(shape)) draw_shape(draw, *polygon, {}, {});
            if (const Circle* circle = world.circle(shape)) draw_shape(draw, *circle, {}, {});
            if (const Capsule* capsule = world.capsule(shape)) draw_shape(draw, *capsule, {}, {});
        }
        bodies_[slot].outline = outliner.text;
    }
}

void Film::shoot(const World& world) {
    constexpr float turn = 6.2831853f;
    for (std::uint32_t slot = 0; slot < bodies_.size(); ++slot) {
        const BodyId body = world.body_at(slot);
        if (!body) continue;
        std::vector<Pose>& poses = bodies_[slot].poses;
        const Vec2 p = camera_(world.position(body));
        float angle = -world.angle(body);
        if (!poses.empty()) angle += turn * std::round((poses.back().angle - angle) / turn);
        poses.push_back({p.x, p.y, angle});
    }
}

/// The frames that lines between them are near enough to: each line goes as far as it can.
std::vector<std::size_t> Film::kept(const Body& body) const {
    const std::vector<Pose>& poses = body.poses;
    const auto fits = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from + 1; i < to; ++i) {
            const float share = static_cast<float>(i - from) / static_cast<float>(to - from);
            const auto off = [&](float Pose::*value) { return std::abs(poses[from].*value + share * (poses[to].*value - poses[from].*value) - poses[i].*value); };
            if (off(&Pose::x) + off(&Pose::y) + reach * off(&Pose::angle) > tolerance) return false;
        }
        return true;
    };
    std::vector<std::size_t> frames = {0};
    while (frames.back() + 1 < poses.size()) {
        std::size_t to = frames.back() + 1;
        while (to + 1 < poses.size() && fits(frames.back(), to + 1)) ++to;
        frames.push_back(to);
    }
    return frames;
}

std::string Film::key_frames(const Body& body) const {
    std::string text;
    for (const std::size_t frame : kept(body)) {
        const Pose& pose = body.poses[frame];
        text += number(100 * static_cast<float>(frame) / static_cast<float>(body.poses.size() - 1), 2) + "%{transform:translate(" + number(pose.x, 1) + "px," +
                number(pose.y, 1) + "px)rotate(" + number(pose.angle, 3) + "rad)}";
    }
    return text;
}

std::string Film::svg() const {
    constexpr const char* colors[] = {"#f7bd6d", "#f2a08a", "#f5d98a", "#b9d48e", "#8fcdb6", "#e8b4c8"};
    std::string style, shapes;
    for (std::size_t slot = 0; slot < bodies_.size(); ++slot) {
        const Body& body = bodies_[slot];
        if (body.poses.empty()) continue;
        const std::string name = "b" + std::to_string(slot);
        const Pose& pose = body.poses[0];
        const std::string start = "translate(" + number(pose.x, 1) + " " + number(pose.y, 1) + ")rotate(" + number(pose.angle * 57.29578f, 1) + ")";
        const char* fill = body.moves ? colors[slot % std::size(colors)] : "#d8dce3";
        const char* stroke = body.moves ? "#8a5a2b" : "#8f99a8";
        std::string outline = body.outline;
        for (std::size_t at = outline.find('%'); at != std::string::npos; at = outline.find('%')) outline.replace(at, 1, fill);  // rounded by a wide stroke
        shapes += "<g class=\"" + name + "\" transform=\"" + start + "\" fill=\"" + fill + "\" stroke=\"" + stroke + "\">" + outline + "</g>\n";
        if (kept(body).size() > 2) style += "." + name + "{animation-name:" + name + "}@keyframes " + name + "{" + key_frames(body) + "}\n";
    }
    return print("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\">\n<style>\ng{animation:%.2fs linear infinite}\n", width_, height_, double(seconds_)) +
           "@keyframes all{0%{opacity:0}3%,95%{opacity:1}100%{opacity:0}}#all{animation-name:all}\n@media (prefers-reduced-motion:reduce){g{animation:none!important}}\n" +
           style +
           print("</style>\n<clipPath id=\"c\"><rect width=\"%d\" height=\"%d\" rx=\"12\"/></clipPath><g clip-path=\"url(#c)\">"
                 "<rect width=\"%d\" height=\"%d\" fill=\"#fdfcf9\"/>\n<g id=\"all\" stroke-linejoin=\"round\">\n",
                 width_, height_, width_, height_) +
           shapes + "</g></g></svg>\n";
}

}  // namespace islet::pictures
