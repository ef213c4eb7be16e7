#include "svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "scene_files/printable.hpp"
#include "drawing.hpp"
#include "svg_path.hpp"

namespace islet::tools {
namespace {

constexpr double picture_width = 1200;      // px
constexpr double caption_height = 56;       // px
constexpr std::size_t most_normals = 6000;  // with more contacts than this the normals would only be a smear, and megabytes
constexpr std::size_t most_contacts = 40000;
constexpr double smallest_ringed = 8;       // px; on smaller bodies a hinge's ring is no more than its dot
constexpr int tint_count = 3;

struct Style {
    const char* name;
    DrawColor color;  // as DebugDraw gives it
    std::array<const char*, tint_count> fills;
    const char* stroke;
};

/// In the order they are painted.
constexpr std::array<Style, 7> styles = {{
    {"disabled", draw_color::disabled, {"#eceae4", "#eceae4", "#eceae4"}, "#c3c0b8"},
    {"static", draw_color::static_body, {"#d8dce3", "#d8dce3", "#d8dce3"}, "#8f99a8"},
    {"kinematic", draw_color::kinematic, {"#cdbfe9", "#cdbfe9", "#cdbfe9"}, "#7c66b0"},
    {"awake", draw_color::awake, {"#f7bd6d", "#f9cb8b", "#f4ae56"}, "#b0702c"},
    {"asleep", draw_color::asleep, {"#b4d2eb", "#c4ddf1", "#a5c7e5"}, "#5d89ae"},
    {"bullet", draw_color::bullet, {"#f08a5d", "#f3a07b", "#ec7744"}, "#9c4421"},
    {"sensor", draw_color::sensor, {"none", "none", "none"}, "#3b9a73"},
}};
constexpr const char* paper = "#fdfcf9";
constexpr const char* grid_color = "#efece5";
constexpr const char* trail_color = "#d98a3d";
constexpr const char* ink = "#2c3440";
constexpr const char* pale_ink = "#77808d";

using Figure = Stroke::Figure;

/// Lines and dots of a colour.
struct Marks {
    PathWriter lines, dots;
};
using MarkLayers = std::map<std::pair<DrawPart, DrawColor>, Marks>;

/// A round number of metres, 1, 2 or 5 times a power of ten, that is at least `pixels` wide.
double round_length(const Camera& camera, double pixels) {
    const double least = pixels * units_per_pixel / camera.scale;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit * power >= least) return digit * power;
    }
    return 10 * power;
}

/// One of a few tints, scattered so that neighbours differ without a pattern.
int tint_of(std::uint32_t body) {
    std::uint32_t bits = body * 2654435761u;
    bits = (bits ^ bits >> 15) * 2246822519u;
    return static_cast<int>((bits ^ bits >> 13) % tint_count);
}

int units(double pixels) { return static_cast<int>(std::lround(pixels * units_per_pixel)); }

std::string css(DrawColor color) { return fmt::format("#{:06x}", color); }

/// The colour mixed with black (share below 0) or white.
DrawColor shaded(DrawColor color, double share) {
    DrawColor mixed = 0;
    for (int shift = 0; shift < 24; shift += 8) {
        const double part = double(color >> shift & 255u), end = share < 0 ? 0 : 255;
        mixed |= static_cast<DrawColor>(std::lround(part + std::abs(share) * (end - part))) << shift;
    }
    return mixed;
}

std::string grid(const Camera& camera) {
    const double step = round_length(camera, 50);
    PathWriter path;
    const auto for_each_line = [step](float low, float high, int length, const auto& draw) {
        const double first = std::ceil(double(low) / step);
        const int most = length / units(50) + 1;  // far from the origin a step may be lost in rounding
        for (int i = 0; i < most && (first + i) * step <= double(high); ++i) draw((first + i) * step);
    };
    for_each_line(camera.view.lower.x, camera.view.upper.x, camera.width, [&](double x) {
        path.move(camera.x(x), 0);
        path.line(camera.x(x), camera.height);
    });
    for_each_line(camera.view.lower.y, camera.view.upper.y, camera.height, [&](double y) {
        path.move(0, camera.y(y));
        path.line(camera.width, camera.y(y));
    });
    return fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", path.text(), grid_color, units(1));
}

/// A line that turns with the shape.
void draw_turn_hint(PathWriter& path, const Camera& camera, const Drawing& drawing, const Stroke& shape) {
    const std::span<const Vec2> p = drawing.points(shape);
    if (shape.figure == Figure::circle) return draw_line(path, camera, p[0], lerp(p[0], p[1], 0.85f));
    Vec2 middle = {};
    for (const Vec2 corner : p) middle += (1 / static_cast<float>(p.size())) * corner;
    draw_line(path, camera, middle, p.size() == 2 ? p[1] : lerp(middle, lerp(p[0], p[1], 0.5f), 0.6f));
}

/// Where a shape's colour stands among the styles; those of islands come last.
std::size_t rank_of(DrawColor color) {
    const auto style = std::find_if(styles.begin(), styles.end(), [color](const Style& s) { return s.color == color; });
    return static_cast<std::size_t>(style - styles.begin());
}

/// Draws a stroke's outline, or a line if it is one.
void draw_outline(PathWriter& path, const Camera& camera, const Drawing& drawing, const Stroke& stroke) {
    const std::span<const Vec2> p = drawing.points(stroke);
    switch (stroke.figure) {
    case Figure::circle: return draw_circle(path, camera, p[0], stroke.radius);
    case Figure::segment: return draw_line(path, camera, p[0], p[1]);
    case Figure::point: return draw_dot(path, camera, p[0]);
    default: return draw_rounded(path, camera, p, stroke.radius);
    }
}

/// All shapes of one colour and tint are one path: thousands of boxes then cost 30 bytes each.
std::string shapes(const Drawing& drawing, const Camera& camera, double size) {
    struct Layer {
        PathWriter solids, lines, hints;
    };
    std::map<std::tuple<std::size_t, DrawColor, int>, Layer> layers;
    for (const Stroke& shape : drawing.strokes()) {
        const DrawStyle& style = shape.style;
        if (style.part != DrawPart::shape) continue;
        Layer& layer = layers[{rank_of(style.color), style.color, tint_of(style.slot)}];
        const bool is_line = shape.figure == Figure::segment;
        draw_outline(is_line ? layer.lines : layer.solids, camera, drawing, shape);
        if (!is_line && style.color != draw_color::static_body && size_of(drawing, shape) * camera.scale / units_per_pixel >= 9)
            draw_turn_hint(layer.hints, camera, drawing, shape);
    }
    const double stroke = std::clamp(0.045 * size, 0.35, 1.6);
    std::string text;
    for (const auto& [key, layer] : layers) {
        const auto& [rank, color, tint] = key;
        const bool known = rank < styles.size();
        const std::string line = known ? styles[rank].stroke : css(shaded(color, -0.4));
        const std::string fill = known ? styles[rank].fills[static_cast<std::size_t>(tint)] : css(shaded(color, 0.25 + 0.1 * tint));
        text += fmt::format("<g stroke=\"{}\" stroke-width=\"{}\">\n", line, units(stroke));
        if (!layer.solids.empty()) text += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", fill, layer.solids.text());
        if (!layer.lines.empty())
            text += fmt::format("<path stroke-width=\"{}\" d=\"{}\"/>\n", units(std::max(1.5, stroke)), layer.lines.text());
        if (!layer.hints.empty()) text += fmt::format("<path stroke-opacity=\".55\" d=\"{}\"/>\n", layer.hints.text());
        text += "</g>\n";
    }
    return text;
}

std::string trails(const std::vector<Trail>& list, const Camera& camera) {
    PathWriter path;
    for (const Trail& trail : list) {
        for (std::size_t i = 1; i < trail.size(); ++i) draw_line(path, camera, trail[i - 1], trail[i]);
    }
    if (path.empty()) return {};
    return fmt::format("<path stroke=\"{}\" stroke-width=\"{}\" stroke-opacity=\".75\" d=\"{}\"/>\n", trail_color, units(1.6), path.text());
}

/// Widths of the lines and dots of a part, px.
struct Widths {
    double line, dot, opacity;
};

Widths widths_of(DrawPart part, double size) {
    switch (part) {
    case DrawPart::joint: return {std::clamp(0.03 * size, 0.35, 1.4), std::clamp(0.12 * size, 1.0, 5.0), 0.75};
    case DrawPart::contact: return {0, std::clamp(0.1 * size, 1.0, 5.0), 1};
    case DrawPart::normal: return {std::clamp(0.025 * size, 0.35, 1.2), 0, 0.6};
    case DrawPart::center: return {1.2, 3, 1};
    default: return {0.8, 2, 0.8};
    }
}

/// What is not a shape is drawn over the shapes, part by part and colour by colour.
MarkLayers layers_of(const Drawing& drawing, const Camera& camera, bool with_rings) {
    MarkLayers layers;
    for (const Stroke& stroke : drawing.strokes()) {
        const DrawStyle& style = stroke.style;
        if (style.part == DrawPart::shape || style.part == DrawPart::impulse) continue;
        if (style.part == DrawPart::joint && stroke.figure == Figure::circle && !with_rings) continue;
        if (style.part == DrawPart::contact && style.color == draw_color::speculative) continue;
        Marks& marks = layers[{style.part, style.color}];
        draw_outline(stroke.figure == Figure::point ? marks.dots : marks.lines, camera, drawing, stroke);
    }
    return layers;
}

/// `dark`: they have the colours of a row that is made for areas, and lines need darker ones.
std::string marks(const MarkLayers& layers, double size, bool dark) {
    std::string text;
    for (const auto& [key, m] : layers) {
        const Widths widths = widths_of(key.first, size);
        const std::string color = css(dark ? shaded(key.second, -0.3) : key.second);
        if (!m.lines.empty()) {
            text += fmt::format("<path stroke=\"{}\" stroke-opacity=\"{:g}\" stroke-width=\"{}\" d=\"{}\"/>\n", color, widths.opacity,
                                units(widths.line), m.lines.text());
        }
        if (!m.dots.empty()) text += fmt::format("<path stroke=\"{}\" stroke-width=\"{}\" d=\"{}\"/>\n", color, units(widths.dot), m.dots.text());
    }
    return text;
}

/// The strongest impulse is as long as two bodies, and the others in proportion.
std::string impulses(const Drawing& drawing, const Camera& camera, double size) {
    const auto for_each = [&](const auto& visit) {
        for (const Stroke& stroke : drawing.strokes()) {
            const std::span<const Vec2> p = drawing.points(stroke);
            if (stroke.style.part == DrawPart::impulse) visit(p[0], p[1] - p[0], stroke.style.color);
        }
    };
    float strongest = 0;
    for_each([&](Vec2, Vec2 way, DrawColor) { strongest = std::max(strongest, length(way)); });
    if (!(strongest > 0)) return {};
    const auto scale = static_cast<float>(std::clamp(2 * size, 20.0, 160.0) * units_per_pixel / camera.scale / double(strongest));
    std::map<DrawColor, PathWriter> paths;
    for_each([&](Vec2 from, Vec2 way, DrawColor color) { draw_line(paths[color], camera, from, from + scale * way); });
    std::string text;
    for (const auto& [color, path] : paths) text += fmt::format("<path stroke=\"{}\" stroke-width=\"{}\" d=\"{}\"/>\n", css(color), units(1.4), path.text());
    return text;
}

/// (A scene's name may come from a file.)
std::string words(const std::vector<Word>& list, const Camera& camera) {
    std::string text;
    for (const Word& word : list) {
        text += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"middle\" fill=\"{}\">{}</text>\n",
                            camera.x(double(word.at.x)), camera.y(double(word.at.y)) - units(3), units(11), css(word.color), markup(word.text));
    }
    return text;
}

/// The strip below: title, numbers, what the colours mean, and a bar of a round number of metres.
std::string caption(const std::string& title, const std::string& details, const Drawing& drawing, const MarkLayers& layers, const Camera& camera) {
    const int top = camera.height, middle = top + units(0.5 * caption_height), base = middle + units(6);
    std::string text =
        fmt::format("<path fill=\"#fff\" d=\"M0 {}h{}v{}H0z\"/>\n<path stroke=\"#e3dfd6\" stroke-width=\"{}\" d=\"M0 {}h{}\"/>\n", top,
                    camera.width, units(caption_height), units(1), top, camera.width);
    text += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\"><tspan font-weight=\"600\">{}</tspan>", units(20), base,
                        units(17), ink, markup(title));
    text += fmt::format("<tspan dx=\"{}\" font-size=\"{}\" fill=\"{}\">{}</tspan></text>\n", units(14), units(14.5), pale_ink,
                        markup(details));

    const double metres = round_length(camera, 60);
    const int bar = static_cast<int>(std::lround(metres * camera.scale));
    int right = camera.width - units(20);
    text += fmt::format("<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" d=\"M{} {}v{}h{}v{}\"/>\n", ink, units(1.5), right - bar,
                        middle - units(1), units(6), bar, -units(6));
    text += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"middle\">{:g} m</text>\n", right - bar / 2,
                        middle - units(5), units(12.5), pale_ink, metres);
    right -= bar + units(22);

    const auto legend = [&](const std::string& label, const std::string& swatch) {
        right -= units(7.6 * double(label.size()));
        text += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\">{}</text>\n", right, base - units(1), units(13), pale_ink,
                            label);
        right -= units(14);
        text += fmt::format("<path transform=\"translate({} {})\" {}/>\n", right, middle, swatch);
        right -= units(22);
    };
    const auto dot = [](DrawColor color) { return fmt::format("stroke=\"{}\" stroke-width=\"{}\" d=\"M0 0h0\"", css(color), units(6)); };
    const auto has = [&](DrawPart part) {
        return std::any_of(layers.begin(), layers.end(), [part](const auto& entry) { return entry.first.first == part; });
    };
    if (has(DrawPart::joint)) legend("joint", dot(draw_color::joint));
    if (has(DrawPart::contact)) legend("contact", dot(draw_color::pressing));
    for (auto style = styles.rbegin(); style != styles.rend(); ++style) {
        const bool used =
            std::any_of(drawing.strokes().begin(), drawing.strokes().end(),
                        [style](const Stroke& s) { return s.style.part == DrawPart::shape && s.style.color == style->color; });
        if (used)
            legend(style->name, fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\" d=\"M-55-55h110v110h-110z\"", style->fills[0],
                                            style->stroke, units(1.2)));
    }
    return text;
}

/// Adds the marks of joints and contacts, in sizes that go with the bodies'.
void add_marks(Drawing& drawing, const World& world, const DebugDraw& what, const Camera& camera, double size) {
    const double pixels_per_metre = camera.scale / units_per_pixel;
    DebugDraw rest = what;
    rest.view = camera.view;
    rest.shapes = rest.contacts = rest.normals = rest.impulses = false;
    rest.size = joint_mark_size(size / pixels_per_metre, pixels_per_metre);
    drawing.add(world, rest);
    // Of specks of bodies the contacts would hide everything.
    const std::size_t contacts = world.contact_count();
    if (size < 5 || contacts > most_contacts) return;
    DebugDraw touches = what;
    touches.view = camera.view;
    touches.shapes = touches.joints = touches.boxes = touches.fat_boxes = touches.tree = touches.centers = touches.names = false;
    touches.normals = what.normals && contacts <= most_normals;
    touches.size = static_cast<float>(std::clamp(0.2 * size, 2.0, 14.0) / pixels_per_metre);
    drawing.add(world, touches);
}

}  // namespace

DebugDraw usual_drawing() {
    DebugDraw draw;
    draw.contacts = draw.normals = true;
    return draw;
}

std::string draw_svg(const World& world, const Picture& picture, const DebugDraw& what) {
    const Camera camera(picture.view, picture_width);
    Drawing drawing;
    DebugDraw only_shapes;
    only_shapes.view = camera.view;
    only_shapes.joints = false;
    only_shapes.body_colors = what.body_colors;
    drawing.add(world, only_shapes);
    const double typical = typical_size(drawing) * camera.scale / units_per_pixel, size = typical > 0 ? typical : 30;  // px
    add_marks(drawing, world, what, camera, size);
    const MarkLayers layers = layers_of(drawing, camera, size >= smallest_ringed);

    std::string details = fmt::format("step {}  ·  {:.4g} s", world.step_count(), double(world.step_count()) * double(picture.dt));
    const auto count = [&](auto number, const char* one, const char* many) { details += fmt::format("  ·  {} {}", number, number == 1 ? one : many); };
    count(world.body_count(), "body", "bodies");
    count(world.contact_count(), "contact", "contacts");
    if (world.joint_count() > 0) count(world.joint_count(), "joint", "joints");
    if (picture.most_dropped_contacts > 0) details += fmt::format("  ·  {} without room", picture.most_dropped_contacts);
    const int height = camera.height + units(caption_height);
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\" "
        "font-family=\"Inter, 'Segoe UI', 'Helvetica Neue', Arial, sans-serif\">\n",
        picture_width, height / units_per_pixel, camera.width, height);
    text += fmt::format("<title>{}</title>\n<path fill=\"{}\" d=\"M0 0h{}v{}H0z\"/>\n", markup(picture.title), paper, camera.width, height);
    text += "<g fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
    text += grid(camera);
    text += trails(picture.trails, camera);
    text += shapes(drawing, camera, size);
    text += marks(layers, size, what.constraint_colors);
    text += impulses(drawing, camera, size);
    text += "</g>\n";
    text += words(drawing.words(), camera);
    text += "<g stroke-linecap=\"round\">\n";
    text += caption(picture.title, details, drawing, layers, camera);
    text += "</g>\n</svg>\n";
    return text;
}

std::string draw_svg(const Run& run, const DebugDraw& what) {
    return draw_svg(run.engine.world(), {run.scene.view, run.scene.name, run.scene.dt, run.trails, run.most_dropped_contacts}, what);
}

}  // namespace islet::tools
