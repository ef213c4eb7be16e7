// World::draw, layer by layer.
#include "../exact.hpp"

#include "islet/debug_draw.hpp"

#include "../bodies/bounds.hpp"
#include "../calls/checks.hpp"
#include "../collide/manifold.hpp"
#include "../draw/draw_pen.hpp"
#include "../math/boxes.hpp"
#include "../math/float_mode.hpp"
#include "../shapes/shape_types.hpp"

namespace islet {

using namespace detail;

namespace {

bool check_draw(const Core& core, const DebugDraw& d) {
    const bool finite = all_finite(d.view.lower.x, d.view.lower.y, d.view.upper.x, d.view.upper.y, d.size, d.impulse_scale);
    if (!check(core, finite, Error::not_finite)) return false;
    const bool view = d.view.lower.x <= d.view.upper.x && d.view.lower.y <= d.view.upper.y;
    return check(core, view && d.size > 0 && d.impulse_scale >= 0, Error::out_of_range);
}

DrawColor state_color(const Core& core, std::uint32_t body) {
    const std::uint32_t flags = core.bodies[body].flags;
    if ((flags & body_disabled) != 0) return draw_color::disabled;
    switch (core.bodies[body].type()) {
        case BodyType::static_body: return draw_color::static_body;
        case BodyType::kinematic: return draw_color::kinematic;
        case BodyType::dynamic: break;
    }
    if (!core.is_awake(body)) return draw_color::asleep;
    return (flags & body_bullet) != 0 ? draw_color::bullet : draw_color::awake;
}

void draw_geometry(const DebugDraw& draw, const Geometry& g, const Transform& pose, const DrawStyle& style) {
    with_shape(g, [&](const auto& shape) { draw_shape(draw, shape, pose, style); });
}

// A fat box holds the shape, so most of what is out of view is left out without a look at its points.
bool sees_shape(const Core& core, const DebugDraw& draw, std::uint32_t shape) {
    return meet(core.boxes[shape], draw.view) && meet(shape_aabb(core, shape), draw.view);
}
bool sees_shape_at(const Core& core, const DebugDraw& draw, std::uint32_t shape, const Transform& pose) {
    return meet(aabb_of(core.geometries[core.shapes[shape].geometry], pose), draw.view);
}

bool sees_point(const DebugDraw& draw, Vec2 p) { return meet(draw.view, {p, p}); }

void draw_shapes(const Core& core, const DebugDraw& draw) {
    const std::uint32_t* islands = draw.body_colors == BodyColors::island ? find_all_islands(core) : nullptr;
    for_each_live(core.state->shape_pool, core.shapes, [&](std::uint32_t i) {
        const Shape& shape = core.shapes[i];
        const Transform pose = draw.poses != nullptr ? draw.poses[shape.body] : body_transform(core, shape.body);
        if (draw.poses != nullptr ? !sees_shape_at(core, draw, i, pose) : !sees_shape(core, draw, i)) return;
        const bool sensor = (shape.flags & shape_sensor) != 0;
        const bool in_island = islands != nullptr && islands[shape.body] != null_index;
        const DrawColor color = sensor ? draw_color::sensor : in_island ? distinct_color(islands[shape.body]) : state_color(core, shape.body);
        draw_geometry(draw, core.geometries[shape.geometry], pose, {color, DrawPart::shape, !sensor, shape.body});
    });
}

void draw_boxes(const Core& core, const DebugDraw& draw) {
    for_each_live(core.state->shape_pool, core.shapes, [&](std::uint32_t i) {
        if (draw.boxes && sees_shape(core, draw, i)) Pen{draw, {draw_color::box, DrawPart::box, false, i}}.box(shape_aabb(core, i));
        if (draw.fat_boxes && meet(core.boxes[i], draw.view)) Pen{draw, {draw_color::fat_box, DrawPart::fat_box, false, i}}.box(core.boxes[i]);
    });
}

void draw_tree(const Core& core, const DebugDraw& draw) {
    // A node in use has two children or, as a leaf, a shape; one that is free has neither.
    for (std::uint32_t i = 0; i < core.state->tree.high_water; ++i) {
        const TreeNode& node = core.tree[i];
        if (node.child1 != null_index && meet(node.box, draw.view)) Pen{draw, {draw_color::tree_box, DrawPart::tree_box, false, i}}.box(node.box);
    }
}

void draw_contact(const DebugDraw& draw, std::uint32_t slot, const ContactInfo& contact, std::uint32_t color) {
    for (std::uint32_t i = 0; i < contact.point_count; ++i) {
        const ContactPoint& p = contact.points[i];
        if (!sees_point(draw, p.point)) continue;
        if (draw.contacts) {
            const DrawColor state = p.separation > linear_slop ? draw_color::speculative : p.normal_impulse > 0 ? draw_color::pressing : draw_color::touching;
            Pen{draw, {constraint_color(draw, color, state), DrawPart::contact, true, slot}}.point(p.point);
        }
        if (draw.normals && p.separation <= linear_slop) {
            const DrawStyle style = {constraint_color(draw, color, draw_color::normal), DrawPart::normal, true, slot};
            Pen{draw, style}.segment(p.point, p.point + draw.size * contact.normal);
        }
        if (draw.impulses) {
            const Pen pen{draw, {draw_color::normal_impulse, DrawPart::impulse, true, slot}};
            const Vec2 push = draw.impulse_scale * p.normal_impulse * contact.normal;
            const Vec2 drag = draw.impulse_scale * p.tangent_impulse * right_perp(contact.normal);
            if (p.normal_impulse != 0) pen.segment(p.point, p.point + push);
            if (p.tangent_impulse != 0) pen.with(draw_color::friction_impulse).segment(p.point, p.point + drag);
        }
    }
}

void draw_centers(const Core& core, const DebugDraw& draw, bool centers, bool names) {
    for_each_live(core.state->body_pool, core.bodies, [&](std::uint32_t i) {
        const Pose& pose = core.poses[i];
        if (core.bodies[i].type() == BodyType::static_body || !sees_point(draw, pose.center)) return;
        if (centers) {
            const Pen pen{draw, {draw_color::center, DrawPart::center, true, i}};
            pen.with(draw_color::x_axis).segment(pose.center, pose.center + draw.size * Vec2{pose.q.c, pose.q.s});
            pen.with(draw_color::y_axis).segment(pose.center, pose.center + draw.size * Vec2{-pose.q.s, pose.q.c});
            pen.point(pose.center);
        }
        if (names) {
            char digits[11];
            char* at = digits + 10;
            *at = 0;
            std::uint32_t n = i;
            do *--at = static_cast<char>('0' + n % 10);
            while ((n /= 10) != 0);
            Pen{draw, {draw_color::name, DrawPart::name, true, i}}.text(pose.center, at);
        }
    });
}

template <class Draw>
void for_each_joint_in_use(const Core& core, const Draw& draw) {
    if constexpr (has_joints) for_each_live(core.state->joint_pool, core.joints, draw);
}

}  // namespace

void World::draw_shape(const DebugDraw& d, ShapeId shape, const Transform& pose, const DrawStyle& style) const {
    const Core& c = core();
    const DefaultFloatMode mode;
    const std::uint32_t i = find_slot(c, shape);
    if (i == null_index || !check_finite(c, pose.p) || !check_finite(c, Vec2{pose.q.c, pose.q.s})) return;
    const Closed closed(c);
    draw_geometry(d, c.geometries[c.shapes[i].geometry], pose, style);
}

void World::draw(const DebugDraw& d) const {
    const Core& c = core();
    const DefaultFloatMode mode;
    if (!check_open(c) || !check_draw(c, d)) return;
    const Closed closed(c);
    if (d.shapes) draw_shapes(c, d);
    if (d.boxes || d.fat_boxes) draw_boxes(c, d);
    if (d.tree) draw_tree(c, d);
    if (d.joints) for_each_joint_in_use(c, [&](std::uint32_t i) { draw_joint(c, d, i); });
    if (d.contacts || d.normals || d.impulses) {
        ContactInfo contact;
        for (std::uint32_t i = 0; i < c.state->contact_pool.high_water; ++i)
            if (contact_at(i, contact)) draw_contact(d, i, contact, c.manifolds[i].color());
    }
    if (d.centers) draw_centers(c, d, true, false);
    if (d.names) {
        draw_centers(c, d, false, true);
        for_each_joint_in_use(c, [&](std::uint32_t i) { draw_joint_name(c, d, i); });
    }
}

}  // namespace islet
