// Marks of joints. Each type has its own, so that a picture says which is which; `s` is DebugDraw::size.
//
//   revolute   a ring of s/2 around A's point. With a limit, spring or motor a hand of length s that turns with B, and the limits' directions in A
//   prismatic  a rail along the axis and a square of s/2 that slides on it with B; limits are bars across the rail
//   wheel      a zigzag along the axis from A's to B's point, a ring of s with spokes that turns with B; limits are bars across the axis
//   distance   a line from point to point, or with a spring a zigzag; limits are bars across it
//   weld       a square of s with its diagonals, fixed to A
//   motor      the two frames as corners of s, and an arrow from A's to B's
//   mouse      a crosshair of s at the target, and dashes to the point it pulls
//   pulley     the rope over two rings of s/2
//   gear       a toothed ring of s around B's point of each of its two joints, and dashes between them
//
// All but gears have a dot at each point, so that two dots beside each other are a joint that has come apart, and a line from there to the centre of mass
// of each body that can move.
#include "../exact.hpp"

#include "../constraint/coordinate.hpp"
#include "../constraint/distance_joint.hpp"
#include "../constraint/joint_rows.hpp"
#include "../draw/draw_pen.hpp"
#include "../graph/joint_graph.hpp"
#include "../math/boxes.hpp"

namespace islet::detail {

namespace {

/// Where a joint is, in the world.
struct JointPlace {
    Vec2 a, b;                // m, its points
    Rot qa, qb;               // its frames
    Vec2 center_a, center_b;  // m, of mass
    bool moves_a, moves_b;
};

JointPlace place_of(const Core& core, const Joint& j) {
    const JointPose p = pose_of(j, core.poses, core.bodies);
    const Vec2 center_b = core.poses[j.body_b].center;
    JointPlace at{{}, center_b + p.rb, p.qa, p.qb, {}, center_b, false, core.poses[j.body_b].inv_mass > 0};
    at.a = j.local_a;  // of a mouse joint, in the world
    if (j.body_a != null_index) {
        at.center_a = core.poses[j.body_a].center;
        at.a = at.center_a + p.ra;
        at.moves_a = core.poses[j.body_a].inv_mass > 0;
    }
    return at;
}

Vec2 direction(Rot q) { return {q.c, q.s}; }

// From one end to the other, with eight teeth of half-width `half`; straight for a quarter at each end.
void draw_zigzag(const Pen& pen, Vec2 from, Vec2 to, float half) {
    constexpr int teeth = 8;
    const Vec2 across = half * left_perp(normalize(to - from));
    Vec2 last = from;
    for (int i = 0; i <= teeth; ++i) {
        const float side = i == 0 || i == teeth ? 0.0f : (i % 2 == 0 ? -1.0f : 1.0f);
        const Vec2 next = lerp(from, to, 0.25f + 0.5f * static_cast<float>(i) / teeth) + side * across;
        pen.segment(last, next);
        last = next;
    }
    pen.segment(last, to);
}

// Dashes and gaps of about `length`, 31 at most.
void draw_dashes(const Pen& pen, Vec2 from, Vec2 to, float length) {
    const float wanted = distance(from, to) / length;
    const int parts = wanted < 31 ? 2 * static_cast<int>(0.5f * wanted) + 1 : 31;
    for (int i = 0; i < parts; i += 2) {
        const float n = static_cast<float>(parts);
        pen.segment(lerp(from, to, static_cast<float>(i) / n), lerp(from, to, static_cast<float>(i + 1) / n));
    }
}

// A square with this distance from the middle to an edge.
void draw_square(const Pen& pen, Vec2 center, Rot q, float half) {
    const Vec2 x = half * direction(q), y = left_perp(x);
    const Vec2 corners[] = {center - x - y, center + x - y, center + x + y, center - x + y};
    pen.polygon(corners, 0);
}

void draw_bar(const Pen& pen, Vec2 at, Vec2 across) { pen.segment(at - across, at + across); }

// Bars across the axis where the limits are.
void draw_limits_along(const Pen& pen, const Joint& j, Vec2 from, Vec2 axis, float size) {
    if ((j.flags & joint_limit) == 0) return;
    const Vec2 across = 0.5f * size * left_perp(axis);
    for (const float x : {j.lower, j.upper}) draw_bar(pen.with(draw_color::limit), from + clamp(x, -max_position, max_position) * axis, across);
}

void draw_revolute(const Pen& pen, const Joint& j, const JointPlace& at, float size) {
    pen.circle(at.a, 0.5f * size, direction(at.qb));
    if (coordinate_parts(j) != 0) pen.segment(at.a, at.a + size * direction(at.qb));
    if ((j.flags & joint_limit) == 0) return;
    for (const float x : {j.lower, j.upper}) {
        const Vec2 way = direction(at.qa * make_rot(x));
        pen.with(draw_color::limit).segment(at.a + 0.5f * size * way, at.a + size * way);
    }
}

void draw_prismatic(const Pen& pen, const Joint& j, const JointPlace& at, float size) {
    const Vec2 axis = direction(at.qa);
    const float x = dot(at.b - at.a, axis);
    // The rail reaches from limit to limit, or a little past what slides on it.
    const bool limited = (j.flags & joint_limit) != 0;
    const float low = limited ? max(j.lower, -max_position) : min(0.0f, x) - 2 * size;
    const float high = limited ? min(j.upper, max_position) : max(0.0f, x) + 2 * size;
    pen.segment(at.a + low * axis, at.a + high * axis);
    draw_limits_along(pen, j, at.a, axis, size);
    draw_square(pen, at.b, at.qa, 0.25f * size);
}

void draw_wheel(const Pen& pen, const Joint& j, const JointPlace& at, float size) {
    draw_zigzag(pen, at.a, at.b, 0.25f * size);
    draw_limits_along(pen, j, at.a, direction(at.qa), size);
    const Vec2 spoke = size * direction(at.qb);
    pen.circle(at.b, size, direction(at.qb));
    draw_bar(pen, at.b, spoke);
    draw_bar(pen, at.b, left_perp(spoke));
}

void draw_distance(const Pen& pen, const Joint& j, const JointPlace& at, float size) {
    if ((j.flags & joint_spring) != 0) {
        draw_zigzag(pen, at.a, at.b, 0.25f * size);
    } else {
        pen.segment(at.a, at.b);
    }
    draw_limits_along(pen, j, at.a, normalize(at.b - at.a), size);
}

void draw_weld(const Pen& pen, const JointPlace& at, float size) {
    draw_square(pen, at.a, at.qa, 0.5f * size);
    const Vec2 x = 0.5f * size * direction(at.qa), y = left_perp(x);
    draw_bar(pen, at.a, x + y);
    draw_bar(pen, at.a, x - y);
}

void draw_frame(const Pen& pen, Vec2 at, Rot q, float size) {
    pen.segment(at, at + size * direction(q));
    pen.segment(at, at + size * left_perp(direction(q)));
}

void draw_motor(const Pen& pen, const JointPlace& at, float size) {
    draw_frame(pen, at.a, at.qa, size);
    draw_frame(pen, at.b, at.qb, size);
    pen.segment(at.a, at.b);
    const Vec2 back = -0.5f * size * normalize(at.b - at.a), across = 0.5f * left_perp(back);
    pen.segment(at.b, at.b + back + across);
    pen.segment(at.b, at.b + back - across);
}

void draw_mouse(const Pen& pen, const JointPlace& at, float size) {
    draw_bar(pen, at.a, {size, 0});
    draw_bar(pen, at.a, {0, size});
    pen.circle(at.a, 0.5f * size, {1, 0});
    draw_dashes(pen, at.a, at.b, 0.5f * size);
}

void draw_pulley(const Pen& pen, const Joint& j, const JointPlace& at, float size) {
    pen.segment(at.a, j.ground_a);
    pen.segment(j.ground_a, j.ground_b);
    pen.segment(j.ground_b, at.b);
    pen.circle(j.ground_a, 0.5f * size, {1, 0});
    pen.circle(j.ground_b, 0.5f * size, {1, 0});
}

void draw_toothed_ring(const Pen& pen, Vec2 center, Rot q, float radius) {
    constexpr float eighth = 0.70710678f;
    pen.circle(center, radius, direction(q));
    Vec2 way = direction(q);
    for (int i = 0; i < 8; ++i) {
        pen.segment(center + radius * way, center + 1.25f * radius * way);
        way = eighth * (way + left_perp(way));
    }
}

void draw_gear(const Core& core, const Pen& pen, const Joint& j, float size) {
    const JointPlace first = place_of(core, core.joints[j.joint1]), second = place_of(core, core.joints[j.joint2]);
    draw_toothed_ring(pen, first.b, first.qb, size);
    draw_toothed_ring(pen, second.b, second.qb, size);
    draw_dashes(pen, first.b, second.b, 0.5f * size);
}

// A box around the marks.
Aabb bounds_of(const Core& core, const Joint& j, float size) {
    if (j.joint_type() == JointType::gear) {
        const Vec2 a = place_of(core, core.joints[j.joint1]).b, b = place_of(core, core.joints[j.joint2]).b;
        return expand({min(a, b), max(a, b)}, 1.25f * size);
    }
    const JointPlace at = place_of(core, j);
    Aabb box = {min(at.a, at.b), max(at.a, at.b)};
    const auto add = [&](Vec2 p) { box = merge(box, {p, p}); };
    if (at.moves_a) add(at.center_a);
    if (at.moves_b) add(at.center_b);
    if (j.joint_type() == JointType::pulley) {
        add(j.ground_a);
        add(j.ground_b);
    }
    const bool along = j.joint_type() == JointType::prismatic || j.joint_type() == JointType::wheel || j.joint_type() == JointType::distance;
    if (along && (j.flags & joint_limit) != 0) {
        const Vec2 axis = j.joint_type() == JointType::distance ? normalize(at.b - at.a) : direction(at.qa);
        add(at.a + clamp(j.lower, -max_position, max_position) * axis);
        add(at.a + clamp(j.upper, -max_position, max_position) * axis);
    }
    return expand(box, 2 * size);
}

}  // namespace

void draw_joint(const Core& core, const DebugDraw& draw, std::uint32_t i) {
    const Joint& j = core.joints[i];
    if (!meet(bounds_of(core, j, draw.size), draw.view)) return;
    const DrawColor color = is_joint_idle(core, j) ? draw_color::idle_joint : constraint_color(draw, j.color(), draw_color::joint);
    const Pen pen{draw, {color, DrawPart::joint, false, i}};
    if (j.joint_type() == JointType::gear) return draw_gear(core, pen, j, draw.size);

    const JointPlace at = place_of(core, j);
    if (at.moves_a) pen.segment(at.center_a, at.a);
    if (at.moves_b) pen.segment(at.b, at.center_b);
    switch (j.joint_type()) {
        case JointType::revolute: draw_revolute(pen, j, at, draw.size); break;
        case JointType::prismatic: draw_prismatic(pen, j, at, draw.size); break;
        case JointType::distance: draw_distance(pen, j, at, draw.size); break;
        case JointType::weld: draw_weld(pen, at, draw.size); break;
        case JointType::wheel: draw_wheel(pen, j, at, draw.size); break;
        case JointType::motor: draw_motor(pen, at, draw.size); break;
        case JointType::mouse: draw_mouse(pen, at, draw.size); break;
        case JointType::pulley: draw_pulley(pen, j, at, draw.size); break;
        case JointType::gear: break;
    }
    pen.point(at.a);
    pen.point(at.b);
}

void draw_joint_name(const Core& core, const DebugDraw& draw, std::uint32_t i) {
    static constexpr const char* names[joint_type_count] = {"revolute", "prismatic", "distance", "weld", "wheel", "motor", "mouse", "pulley", "gear"};
    const Joint& j = core.joints[i];
    const bool is_gear = j.joint_type() == JointType::gear;
    const JointPlace at = place_of(core, is_gear ? core.joints[j.joint1] : j);
    const Vec2 end = is_gear ? place_of(core, core.joints[j.joint2]).b : at.b;
    const Vec2 middle = lerp(is_gear ? at.b : at.a, end, 0.5f);
    if (!meet(draw.view, {middle, middle})) return;
    Pen{draw, {draw_color::name, DrawPart::name, true, i}}.text(middle, names[static_cast<std::uint32_t>(j.joint_type())]);
}

}  // namespace islet::detail
