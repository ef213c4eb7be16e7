// DebugDraw: draws a world through functions of yours, as polygons, circles, capsules, lines, points and texts.
//
//     DebugDraw draw;
//     draw.polygon = [](span<const Vec2> corners, float radius, const DrawStyle& style, void* window) { ... };
//     draw.segment = ...;
//     draw.context = &window;
//     draw.contacts = true;
//     world.draw(draw);
//
// All positions are in the world and all lengths in metres; the camera is yours. The world's state alone decides what is drawn and in which order: shapes, then
// boxes, joints, contacts, centres of mass and names, each by ascending slot.
#pragma once

#include <cstdint>

#include "islet/geometry.hpp"
#include "islet/math.hpp"
#include "islet/span.hpp"

ISLET_API_BEGIN
namespace islet {

/// 0xrrggbb.
using DrawColor = std::uint32_t;

/// The colours that DebugDraw uses. A function of yours may replace any of them.
namespace draw_color {
// Shapes, by what their body is.
inline constexpr DrawColor static_body = 0xd8dce3;  // grey
inline constexpr DrawColor kinematic = 0xcdbfe9;    // violet
inline constexpr DrawColor awake = 0xf7bd6d;        // orange: dynamic
inline constexpr DrawColor asleep = 0xb4d2eb;       // blue: dynamic
inline constexpr DrawColor bullet = 0xf08a5d;       // coral: dynamic, awake and a bullet
inline constexpr DrawColor disabled = 0xeceae4;     // nearly white: of a body that takes part in nothing
inline constexpr DrawColor sensor = 0x7fc8a9;       // mint: the shape is a sensor
// Joints.
inline constexpr DrawColor joint = 0x2f7d6b;       // green
inline constexpr DrawColor idle_joint = 0xb9c2cc;  // grey: acts on no body, as one of its bodies is disabled
inline constexpr DrawColor limit = 0xb5651d;       // brown: the marks of limits
// Contact points.
inline constexpr DrawColor pressing = 0xc4314b;     // red: with a normal impulse
inline constexpr DrawColor touching = 0xe59aa8;     // pale red: without
inline constexpr DrawColor speculative = 0xb9c2cc;  // grey: the surfaces are more than 0.005 m apart; the solver only watches
inline constexpr DrawColor normal = 0xc4314b;
inline constexpr DrawColor normal_impulse = 0x7a1fa2;    // purple
inline constexpr DrawColor friction_impulse = 0x1565c0;  // blue
// The rest.
inline constexpr DrawColor box = 0x5b8c5a;
inline constexpr DrawColor fat_box = 0xa8b820;
inline constexpr DrawColor tree_box = 0x8d99a6;
inline constexpr DrawColor center = 0x2c3440;
inline constexpr DrawColor x_axis = 0xd1352b;
inline constexpr DrawColor y_axis = 0x2e8b3d;
inline constexpr DrawColor name = 0x2c3440;
inline constexpr DrawColor overflow = 0x111111;  // constraint_colors: constraints that found no colour and are solved one by one
}  // namespace draw_color

/// Colour number n of an endless series in which neighbours are easy to tell apart. Islands and constraint colours are drawn in these.
DrawColor distinct_color(std::uint32_t n);

/// The kind of a drawn thing, and whose slot DrawStyle::slot is.
enum class DrawPart : std::uint8_t {
    shape,     ///< DrawStyle::slot is that of the body (World::body_at)
    box,       ///< of the shape
    fat_box,   ///< of the shape
    tree_box,  ///< of the node of the tree
    joint,     ///< of the joint (World::joint_at)
    contact,   ///< of the contact (World::contact_at)
    normal,    ///< of the contact
    impulse,   ///< of the contact
    center,    ///< of the body
    name,      ///< of the body, or of the joint that the name is of
};

/// How to draw a thing, and what it belongs to. A plain picture needs only the colour.
struct DrawStyle {
    DrawColor color = 0;
    DrawPart part = DrawPart::shape;
    bool solid = true;       ///< Polygons, circles and capsules are filled. True for shapes but sensors; false for boxes and the marks of joints.
    std::uint32_t slot = 0;  ///< of what the thing belongs to
};

/// The colour of a dynamic body's shapes. Shapes of other bodies, sensors and disabled bodies keep their own colours.
enum class BodyColors : std::uint8_t {
    state,   ///< that of draw_color
    island,  ///< distinct_color of the lowest slot of a body in its island, awake or not. Islands are found while drawing, from contacts and joints.
};

/// The functions that draw, and the parts of the world to draw. Functions may be null, and may not change the world (in_step). The pointers that they get are
/// valid only during the call.
struct DebugDraw {
    /// A convex polygon, counter-clockwise, rounded by `radius` (>= 0) around its corners. The first edge is always the same edge of the shape, so a mark
    /// on it shows how the shape turns.
    void (*polygon)(span<const Vec2> corners, float radius, const DrawStyle& style, void* context) = nullptr;
    /// `axis` is a unit vector that turns with the circle.
    void (*circle)(Vec2 center, float radius, Vec2 axis, const DrawStyle& style, void* context) = nullptr;
    /// All points within `radius` of a line.
    void (*capsule)(Vec2 point1, Vec2 point2, float radius, const DrawStyle& style, void* context) = nullptr;
    void (*segment)(Vec2 point1, Vec2 point2, const DrawStyle& style, void* context) = nullptr;
    /// A dot, as large as you like.
    void (*point)(Vec2 point, const DrawStyle& style, void* context) = nullptr;
    /// Plain ASCII, ended by a zero.
    void (*text)(Vec2 point, const char* text, const DrawStyle& style, void* context) = nullptr;
    void* context = nullptr;  ///< passed on to all of them

    /// m. Things outside are left out. By default all are drawn.
    Aabb view = {{-1.0e30f, -1.0e30f}, {1.0e30f, 1.0e30f}};
    float size = 0.25f;          ///< m, > 0: of the marks of joints and of normals and axes
    float impulse_scale = 1.0f;  ///< m for each N s, >= 0

    bool shapes = true;
    bool joints = true;
    bool contacts = false;   ///< a point for each point of each contact
    bool normals = false;    ///< of contacts, from A to B
    bool impulses = false;   ///< of contacts over the last substep, on B: along the normal, and of friction along the surface
    bool boxes = false;      ///< the tight box of each shape
    bool fat_boxes = false;  ///< the fat box of each shape, with which pairs are found; the shape keeps it until it leaves it
    bool tree = false;       ///< the boxes of the tree of resting shapes; its leaves, which are fat boxes, are left out
    bool centers = false;    ///< the centre of mass and the axes of each body that is not static
    bool names = false;      ///< the slot of each body that is not static at its centre, the type of each joint at its place
    BodyColors body_colors = BodyColors::state;
    bool constraint_colors = false;  ///< joints, contact points and normals in distinct_color of the constraint colour (0 to 31) they are solved with
    /// Null, or where to draw the shapes instead of where they are: a pose for each slot of a body, capacity().bodies of them. For pictures between two steps:
    /// keep each body's transform before the step, and lerp to the one after it.
    const Transform* poses = nullptr;
};

/// Draws a geometry as World::draw draws a shape whose body is at `pose`. The options and the view have no effect.
void draw_shape(const DebugDraw& draw, const Circle& circle, const Transform& pose, const DrawStyle& style);
void draw_shape(const DebugDraw& draw, const Capsule& capsule, const Transform& pose, const DrawStyle& style);
void draw_shape(const DebugDraw& draw, const Segment& segment, const Transform& pose, const DrawStyle& style);
/// Nothing is drawn of a polygon with a count above max_polygon_vertices.
void draw_shape(const DebugDraw& draw, const Polygon& polygon, const Transform& pose, const DrawStyle& style);

}  // namespace islet
ISLET_API_END
