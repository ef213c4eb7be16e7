// The engine's debug drawing as a list of numbers, which the page draws over the bodies.
#include <span>

#include "sandbox.hpp"

namespace islet::sandbox {
namespace {

/// What a record begins with: what is drawn, its colour, part and slot (DrawStyle). Polygons: the radius, how many corners, and those. Circles: centre, radius.
/// Capsules: both ends, radius. Segments: both ends. Points: the place.
enum Record { polygon, circle, capsule, segment, point };

using List = std::vector<float>;

void begin(List& list, Record what, const DrawStyle& style) {
    list.insert(list.end(), {static_cast<float>(what), static_cast<float>(style.color), static_cast<float>(style.part), static_cast<float>(style.slot)});
}

DebugDraw into(List& list) {
    DebugDraw draw;
    draw.context = &list;
    draw.polygon = [](std::span<const Vec2> corners, float radius, const DrawStyle& style, void* context) {
        List& to = *static_cast<List*>(context);
        begin(to, polygon, style);
        to.insert(to.end(), {radius, static_cast<float>(corners.size())});
        for (const Vec2 p : corners) to.insert(to.end(), {p.x, p.y});
    };
    draw.circle = [](Vec2 center, float radius, Vec2, const DrawStyle& style, void* context) {
        List& to = *static_cast<List*>(context);
        begin(to, circle, style);
        to.insert(to.end(), {center.x, center.y, radius});
    };
    draw.capsule = [](Vec2 a, Vec2 b, float radius, const DrawStyle& style, void* context) {
        List& to = *static_cast<List*>(context);
        begin(to, capsule, style);
        to.insert(to.end(), {a.x, a.y, b.x, b.y, radius});
    };
    draw.segment = [](Vec2 a, Vec2 b, const DrawStyle& style, void* context) {
        List& to = *static_cast<List*>(context);
        begin(to, segment, style);
        to.insert(to.end(), {a.x, a.y, b.x, b.y});
    };
    draw.point = [](Vec2 p, const DrawStyle& style, void* context) {
        List& to = *static_cast<List*>(context);
        begin(to, point, style);
        to.insert(to.end(), {p.x, p.y});
    };
    return draw;
}

}  // namespace
}  // namespace islet::sandbox

using namespace islet;
using islet::sandbox::Running;
using islet::sandbox::running_at;

extern "C" {

/// What to draw, bit by bit: 1 shapes, 2 shapes in the colours of their islands, 4 contact points, 8 their impulses, 16 constraint colours, 32 boxes. In a view
/// (m), with impulses so long (m for each N s). Returns how many numbers it left at sandbox_drawn.
std::uint32_t sandbox_draw(std::uint32_t place, std::uint32_t what, float left, float bottom, float right, float top, float impulse_scale) {
    Running& running = running_at(place);
    running.drawn.clear();
    DebugDraw draw = sandbox::into(running.drawn);
    draw.view = {{left, bottom}, {right, top}};
    draw.impulse_scale = impulse_scale;
    draw.shapes = (what & 3) != 0;
    draw.body_colors = (what & 2) != 0 ? BodyColors::island : BodyColors::state;
    draw.contacts = (what & 4) != 0;
    draw.impulses = (what & 8) != 0;
    draw.constraint_colors = (what & 16) != 0;
    draw.joints = draw.constraint_colors;
    draw.size = 0.1f;
    draw.boxes = (what & 32) != 0;
    running.engine.world().draw(draw);
    return static_cast<std::uint32_t>(running.drawn.size());
}
const float* sandbox_drawn(std::uint32_t place) { return running_at(place).drawn.data(); }

/// Kinetic and potential energy of all that moves (J).
double sandbox_energy(std::uint32_t place) {
    const World& w = running_at(place).engine.world();
    const Vec2 gravity = w.gravity();
    double sum = 0;
    for (std::uint32_t slot = 0, found = 0; found < w.body_count(); ++slot) {
        const BodyId body = w.body_at(slot);
        if (!body) continue;
        ++found;
        if (w.type(body) != BodyType::dynamic) continue;
        const double m = double(w.mass(body)), spin = double(w.angular_velocity(body));
        const Vec2 v = w.linear_velocity(body);
        sum += 0.5 * m * double(dot(v, v)) + 0.5 * double(w.rotational_inertia(body)) * spin * spin - m * double(dot(gravity, w.center_of_mass(body)));
    }
    return sum;
}

/// Where continuous collision held bodies back: how many stops there are, and three numbers of each (x, y, the step).
std::uint32_t sandbox_stops(std::uint32_t place) {
    Running& running = running_at(place);
    running.drawn.clear();
    for (const sandbox::Stop& stop : running.stops) running.drawn.insert(running.drawn.end(), {stop.place.x, stop.place.y, static_cast<float>(stop.step)});
    return static_cast<std::uint32_t>(running.stops.size());
}

}  // extern "C"
