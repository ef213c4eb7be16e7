#include "svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "joint_measure.hpp"
#include "svg_path.hpp"

namespace islet::samples {
namespace {

constexpr double picture_width = 1200;      // px
constexpr double caption_height = 56;       // px
constexpr std::size_t most_normals = 6000;  // with more contacts than this the normals would only be a smear, and megabytes
constexpr std::size_t most_contacts = 40000;
constexpr int tint_count = 3;
constexpr float touching = 0.005f;  // m; points farther apart than this are only watched by the solver

struct Style {
    const char* name;
    std::array<const char*, tint_count> fills;
    const char* stroke;
};

/// By Look.
constexpr std::array<Style, 4> styles = {{
    {"static", {"#d8dce3", "#d8dce3", "#d8dce3"}, "#8f99a8"},
    {"kinematic", {"#cdbfe9", "#cdbfe9", "#cdbfe9"}, "#7c66b0"},
    {"awake", {"#f7bd6d", "#f9cb8b", "#f4ae56"}, "#b0702c"},
    {"asleep", {"#b4d2eb", "#c4ddf1", "#a5c7e5"}, "#5d89ae"},
}};
constexpr const char* paper = "#fdfcf9";
constexpr const char* grid_color = "#efece5";
constexpr const char* contact_color = "#c4314b";
constexpr const char* joint_color = "#2f7d6b";
constexpr const char* trail_color = "#d98a3d";
constexpr const char* ink = "#2c3440";
constexpr const char* pale_ink = "#77808d";

/// A round number of metres, 1, 2 or 5 times a power of ten, that is at least `pixels` wide.
double round_length(const Camera& camera, double pixels) {
    const double least = pixels * units_per_pixel / camera.scale;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit * power >= least) return digit * power;
    }
    return 10 * power;
}

/// The middling size of the moving bodies, each by its largest shape, in pixels: lines and dots are drawn in proportion to it.
double typical_size(const Picture& picture, const Camera& camera) {
    std::map<std::size_t, double> largest;
    for (const DrawnShape& shape : picture.shapes) {
        if (shape.look != Look::fixed) largest[shape.body] = std::max(largest[shape.body], size_of(shape.geometry));
    }
    if (largest.empty()) return 30;
    std::vector<double> sizes;
    for (const auto& [body, size] : largest) sizes.push_back(size * camera.scale / units_per_pixel);
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return *middle;
}

/// One of a few tints, scattered so that neighbours differ without a pattern.
int tint_of(std::size_t body) {
    auto bits = static_cast<std::uint32_t>(body) * 2654435761u;
    bits = (bits ^ bits >> 15) * 2246822519u;
    return static_cast<int>((bits ^ bits >> 13) % tint_count);
}

int units(double pixels) { return static_cast<int>(std::lround(pixels * units_per_pixel)); }

std::string grid(const Picture& picture, const Camera& camera) {
    const double step = round_length(camera, 50);
    PathWriter path;
    for (double x = std::ceil(double(picture.view.lower.x) / step) * step; x <= double(picture.view.upper.x); x += step) {
        path.move(camera.x(x), 0);
        path.line(camera.x(x), camera.height);
    }
    for (double y = std::ceil(double(picture.view.lower.y) / step) * step; y <= double(picture.view.upper.y); y += step) {
        path.move(0, camera.y(y));
        path.line(camera.width, camera.y(y));
    }
    return fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", path.text(), grid_color, units(1));
}

/// All shapes of one look and tint are one path: thousands of boxes then cost 30 bytes each.
std::string shapes(const Picture& picture, const Camera& camera, double size) {
    struct Layer {
        PathWriter solids, lines, hints;
    };
    std::map<std::pair<int, int>, Layer> layers;
    for (const DrawnShape& shape : picture.shapes) {
        if (!camera.sees(shape.geometry, shape.pose)) continue;
        Layer& layer = layers[{static_cast<int>(shape.look), tint_of(shape.body)}];
        draw_outline(is_line(shape.geometry) ? layer.lines : layer.solids, camera, shape.geometry, shape.pose);
        const double pixels = size_of(shape.geometry) * camera.scale / units_per_pixel;
        if (shape.look != Look::fixed && pixels >= 9) draw_turn_hint(layer.hints, camera, shape.geometry, shape.pose);
    }
    const double stroke = std::clamp(0.045 * size, 0.35, 1.6);
    std::string text;
    for (const auto& [key, layer] : layers) {
        const Style& style = styles[static_cast<std::size_t>(key.first)];
        text += fmt::format("<g stroke=\"{}\" stroke-width=\"{}\">\n", style.stroke, units(stroke));
        if (!layer.solids.empty())
            text += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", style.fills[static_cast<std::size_t>(key.second)], layer.solids.text());
        if (!layer.lines.empty())
            text += fmt::format("<path stroke-width=\"{}\" d=\"{}\"/>\n", units(std::max(1.5, stroke)), layer.lines.text());
        if (!layer.hints.empty()) text += fmt::format("<path stroke-opacity=\".55\" d=\"{}\"/>\n", layer.hints.text());
        text += "</g>\n";
    }
    return text;
}

void add_line(PathWriter& path, const Camera& camera, const std::vector<Vec2>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const int x = camera.x(double(points[i].x)), y = camera.y(double(points[i].y));
        if (i == 0)
            path.move(x, y);
        else
            path.line(x, y);
    }
}

std::string trails(const Picture& picture, const Camera& camera) {
    PathWriter path;
    for (const Trail& trail : picture.trails) add_line(path, camera, trail);
    if (path.empty()) return {};
    return fmt::format("<path stroke=\"{}\" stroke-width=\"{}\" stroke-opacity=\".75\" d=\"{}\"/>\n", trail_color, units(1.6), path.text());
}

/// Thin lines, and a dot at each anchor: two dots beside each other are a joint that has come apart.
std::string joints(const Picture& picture, const Camera& camera, double size) {
    PathWriter lines, dots;
    for (const DrawnJoint& joint : picture.joints) {
        add_line(lines, camera, joint.line);
        for (const Vec2 dot : joint.dots) {
            dots.move(camera.x(double(dot.x)), camera.y(double(dot.y)));
            dots.dot();
        }
    }
    if (lines.empty()) return {};
    return fmt::format(
        "<path stroke=\"{0}\" stroke-opacity=\".7\" stroke-width=\"{1}\" d=\"{2}\"/>\n<path stroke=\"{0}\" stroke-width=\"{3}\" "
        "d=\"{4}\"/>\n",
        joint_color, units(std::clamp(0.03 * size, 0.35, 1.4)), lines.text(), units(std::clamp(0.12 * size, 1.0, 5.0)), dots.text());
}

std::string contacts(const Picture& picture, const Camera& camera, double size) {
    if (size < 5 || picture.contacts.size() > most_contacts) return {};
    PathWriter dots, normals;
    const double length = std::clamp(0.2 * size, 2.0, 14.0) * units_per_pixel;
    for (const DrawnContact& contact : picture.contacts) {
        if (!contains(picture.view, {contact.point, contact.point})) continue;
        const int x = camera.x(double(contact.point.x)), y = camera.y(double(contact.point.y));
        dots.move(x, y);
        dots.dot();
        if (picture.contacts.size() > most_normals) continue;
        normals.move(x, y);
        normals.line(x + static_cast<int>(std::lround(length * double(contact.normal.x))),
                     y - static_cast<int>(std::lround(length * double(contact.normal.y))));
    }
    std::string text;
    if (!normals.empty()) {
        text += fmt::format("<path stroke=\"{}\" stroke-opacity=\".6\" stroke-width=\"{}\" d=\"{}\"/>\n", contact_color,
                            units(std::clamp(0.025 * size, 0.35, 1.2)), normals.text());
    }
    if (!dots.empty()) {
        text += fmt::format("<path stroke=\"{}\" stroke-width=\"{}\" d=\"{}\"/>\n", contact_color, units(std::clamp(0.1 * size, 1.0, 5.0)),
                            dots.text());
    }
    return text;
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return out;
}

/// The strip below: title, numbers, what the colours mean, and a bar of a round number of metres.
std::string caption(const Picture& picture, const Camera& camera, bool contacts_drawn) {
    const int top = camera.height, middle = top + units(0.5 * caption_height), base = middle + units(6);
    std::string text =
        fmt::format("<path fill=\"#fff\" d=\"M0 {}h{}v{}H0z\"/>\n<path stroke=\"#e3dfd6\" stroke-width=\"{}\" d=\"M0 {}h{}\"/>\n", top,
                    camera.width, units(caption_height), units(1), top, camera.width);
    text += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\"><tspan font-weight=\"600\">{}</tspan>", units(20), base,
                        units(17), ink, escaped(picture.title));
    text += fmt::format("<tspan dx=\"{}\" font-size=\"{}\" fill=\"{}\">{}</tspan></text>\n", units(14), units(14.5), pale_ink,
                        escaped(picture.details));

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
    if (!picture.joints.empty()) legend("joint", fmt::format("stroke=\"{}\" stroke-width=\"{}\" d=\"M0 0h0\"", joint_color, units(6)));
    if (contacts_drawn) legend("contact", fmt::format("stroke=\"{}\" stroke-width=\"{}\" d=\"M0 0h0\"", contact_color, units(6)));
    for (int look = static_cast<int>(styles.size()) - 1; look >= 0; --look) {
        const bool used = std::any_of(picture.shapes.begin(), picture.shapes.end(),
                                      [look](const DrawnShape& s) { return static_cast<int>(s.look) == look; });
        const Style& style = styles[static_cast<std::size_t>(look)];
        if (used)
            legend(style.name, fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\" d=\"M-55-55h110v110h-110z\"", style.fills[0],
                                           style.stroke, units(1.2)));
    }
    return text;
}

Look look_of(const World& world, BodyId body) {
    if (world.type(body) == BodyType::static_body) return Look::fixed;
    if (world.type(body) == BodyType::kinematic) return Look::kinematic;
    return world.is_awake(body) ? Look::awake : Look::asleep;
}

std::optional<SceneGeometry> geometry_of(const World& world, ShapeId shape) {
    switch (world.shape_type(shape)) {
    case ShapeType::circle: return *world.circle(shape);
    case ShapeType::capsule: return *world.capsule(shape);
    case ShapeType::segment: return *world.segment(shape);
    case ShapeType::polygon: return *world.polygon(shape);
    case ShapeType::chain_segment: return world.chain_segment(shape)->segment;
    }
    return std::nullopt;
}

}  // namespace

Picture picture_of(const Run& run) {
    const World& world = run.engine.world();
    Picture picture;
    picture.view = run.scene.view;
    picture.trails = run.trails;
    std::vector<ShapeId> ids(world.capacity().shapes);
    for (std::uint32_t slot = 0; slot < world.capacity().bodies; ++slot) {
        const BodyId body = world.body_at(slot);
        if (!body) continue;
        const std::uint32_t count = world.shapes(body, ids);
        for (std::uint32_t i = 0; i < count; ++i) {
            if (const auto geometry = geometry_of(world, ids[i]))
                picture.shapes.push_back({*geometry, world.transform(body), look_of(world, body), slot});
        }
    }
    ContactInfo contact;
    for (std::uint32_t slot = 0; slot < world.capacity().contacts; ++slot) {
        if (!world.contact_at(slot, contact)) continue;
        for (std::uint32_t i = 0; i < contact.point_count; ++i) {
            if (contact.points[i].separation < touching) picture.contacts.push_back({contact.points[i].point, contact.normal});
        }
    }
    for (std::size_t i = 0; i < run.engine.joint_slots(); ++i) {
        if (!run.engine.joint_exists(i)) continue;
        JointDrawing drawing = draw_joint(run.engine, i);
        if (!drawing.line.empty()) picture.joints.push_back({std::move(drawing.line), std::move(drawing.dots)});
    }
    const EngineCounts counts = run.engine.counts();
    picture.title = run.scene.name;
    picture.details = fmt::format("step {}  ·  {:.4g} s  ·  {} bodies  ·  {} contacts", world.step_count(),
                                  double(world.step_count()) * double(run.scene.dt), counts.bodies, counts.contacts);
    if (counts.joints > 0) picture.details += fmt::format("  ·  {} joints", counts.joints);
    return picture;
}

std::string draw_svg(const Picture& picture) {
    const Camera camera(picture.view, picture_width);
    const double size = typical_size(picture, camera);
    const int height = camera.height + units(caption_height);
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\" "
        "font-family=\"Inter, 'Segoe UI', 'Helvetica Neue', Arial, sans-serif\">\n",
        picture_width, height / units_per_pixel, camera.width, height);
    text +=
        fmt::format("<title>{}</title>\n<path fill=\"{}\" d=\"M0 0h{}v{}H0z\"/>\n", escaped(picture.title), paper, camera.width, height);
    text += "<g fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
    text += grid(picture, camera);
    text += trails(picture, camera);
    text += shapes(picture, camera, size);
    text += joints(picture, camera, size);
    const std::string dots = contacts(picture, camera, size);
    text += dots;
    text += "</g>\n<g stroke-linecap=\"round\">\n";
    text += caption(picture, camera, !dots.empty());
    text += "</g>\n</svg>\n";
    return text;
}

}  // namespace islet::samples
