// Marks of joints. Each type has its own, so that a picture says which is which: JointKind::draw in the type's file says what it is.
//
// All but gears have a dot at each point, so that two dots beside each other are a joint that has come apart, and a line from there to the centre of mass
// of each body that can move.
#include "../exact.hpp"

#include "../constraint/joint_kinds.hpp"
#include "../draw/draw_pen.hpp"
#include "../graph/joint_graph.hpp"
#include "../math/boxes.hpp"

namespace islet::detail {

namespace {

JointPlace place_of_ends(const Core& core, const Joint& j) {
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

// A gear is between B's points of its two joints.
JointPlace place_of(const Core& core, const Joint& j) {
    if (j.joint_type() != JointType::gear) return place_of_ends(core, j);
    const JointPlace first = place_of_ends(core, core.joints[j.joint1]), second = place_of_ends(core, core.joints[j.joint2]);
    return {first.b, second.b, first.qb, second.qb, {}, {}, false, false};
}

/// What JointKind::draw of every type draws its mark with.
struct JointPen {
    const Pen& pen;
    const JointPlace& at;
    float size;  // DebugDraw::size

    static Vec2 direction(Rot q) { return {q.c, q.s}; }

    void segment(Vec2 a, Vec2 b) const { pen.segment(a, b); }
    void circle(Vec2 center, float radius, Vec2 axis) const { pen.circle(center, radius, axis); }
    void bar(Vec2 middle, Vec2 across) const { pen.segment(middle - across, middle + across); }
    void zigzag(Vec2 from, Vec2 to) const;
    [[maybe_unused]] void dashes(Vec2 from, Vec2 to) const;
    [[maybe_unused]] void toothed_ring(Vec2 center, Rot q) const;
    void limits_along(const Joint& j, Vec2 axis) const;
    void limits_around(const Joint& j) const;

    /// `half`: from the middle to an edge.
    void square(Vec2 center, Rot q, float half) const {
        const Vec2 x = half * direction(q), y = left_perp(x);
        const Vec2 corners[] = {center - x - y, center + x - y, center + x + y, center - x + y};
        pen.polygon(corners, 0);
    }
    void frame(Vec2 origin, Rot q) const {
        pen.segment(origin, origin + size * direction(q));
        pen.segment(origin, origin + size * left_perp(direction(q)));
    }
};

// With eight teeth; straight for a quarter at each end.
void JointPen::zigzag(Vec2 from, Vec2 to) const {
    constexpr int teeth = 8;
    const Vec2 across = 0.25f * size * left_perp(normalize(to - from));
    Vec2 last = from;
    for (int i = 0; i <= teeth; ++i) {
        const float side = i == 0 || i == teeth ? 0.0f : (i % 2 == 0 ? -1.0f : 1.0f);
        const Vec2 next = lerp(from, to, 0.25f + 0.5f * static_cast<float>(i) / teeth) + side * across;
        pen.segment(last, next);
        last = next;
    }
    pen.segment(last, to);
}

// Dashes and gaps of about half the size, 31 at most.
void JointPen::dashes(Vec2 from, Vec2 to) const {
    const float wanted = distance(from, to) / (0.5f * size);
    const int parts = wanted < 31 ? 2 * static_cast<int>(0.5f * wanted) + 1 : 31;
    for (int i = 0; i < parts; i += 2) {
        const float n = static_cast<float>(parts);
        pen.segment(lerp(from, to, static_cast<float>(i) / n), lerp(from, to, static_cast<float>(i + 1) / n));
    }
}

void JointPen::toothed_ring(Vec2 center, Rot q) const {
    constexpr float eighth = 0.70710678f;
    pen.circle(center, size, direction(q));
    Vec2 way = direction(q);
    for (int i = 0; i < 8; ++i) {
        pen.segment(center + size * way, center + 1.25f * size * way);
        way = eighth * (way + left_perp(way));
    }
}

// Bars across the axis where the limits are.
void JointPen::limits_along(const Joint& j, Vec2 axis) const {
    if ((j.flags & joint_limit) == 0) return;
    const Vec2 across = 0.5f * size * left_perp(axis);
    const Pen mark = pen.with(draw_color::limit);
    for (const float x : {j.lower, j.upper}) {
        const Vec2 middle = at.a + clamp(x, -max_position, max_position) * axis;
        mark.segment(middle - across, middle + across);
    }
}

// The limits' directions in A.
void JointPen::limits_around(const Joint& j) const {
    if ((j.flags & joint_limit) == 0) return;
    for (const float x : {j.lower, j.upper}) {
        const Vec2 way = direction(at.qa * make_rot(x));
        pen.with(draw_color::limit).segment(at.a + 0.5f * size * way, at.a + size * way);
    }
}

// A box around the marks.
Aabb bounds_of(const Joint& j, const JointPlace& at, float size) {
    Aabb box = {min(at.a, at.b), max(at.a, at.b)};
    const auto add = [&](Vec2 p) { box = merge(box, {p, p}); };
    if (at.moves_a) add(at.center_a);
    if (at.moves_b) add(at.center_b);
    with_kind(j.joint_type(), [&](auto kind) { kind.reach(add, j, at); });
    return expand(box, 2 * size);
}

}  // namespace

void draw_joint(const Core& core, const DebugDraw& draw, std::uint32_t i) {
    const Joint& j = core.joints[i];
    const JointPlace at = place_of(core, j);
    if (!meet(bounds_of(j, at, draw.size), draw.view)) return;
    const DrawColor color = is_joint_idle(core, j) ? draw_color::idle_joint : constraint_color(draw, j.color(), draw_color::joint);
    const Pen pen{draw, {color, DrawPart::joint, false, i}};
    if (at.moves_a) pen.segment(at.center_a, at.a);
    if (at.moves_b) pen.segment(at.b, at.center_b);
    with_kind(j.joint_type(), [&](auto kind) { kind.draw(JointPen{pen, at, draw.size}, j); });
    if (j.joint_type() == JointType::gear) return;
    pen.point(at.a);
    pen.point(at.b);
}

void draw_joint_name(const Core& core, const DebugDraw& draw, std::uint32_t i) {
#define ISLET_NAME(name, definition) #name,
    static constexpr const char* names[joint_type_count] = {ISLET_JOINT_TYPES(ISLET_NAME)};
#undef ISLET_NAME
    const Joint& j = core.joints[i];
    const JointPlace at = place_of(core, j);
    const Vec2 middle = lerp(at.a, at.b, 0.5f);
    if (!meet(draw.view, {middle, middle})) return;
    Pen{draw, {draw_color::name, DrawPart::name, true, i}}.text(middle, names[static_cast<std::uint32_t>(j.joint_type())]);
}

}  // namespace islet::detail
