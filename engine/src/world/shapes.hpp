#pragma once

#include "../calls/recorder.hpp"
#include "../data/core.hpp"
#include "../shapes/shape_types.hpp"

namespace islet::detail {

/// Destroys a shape and its contacts. The caller updates the body's mass.
void remove_shape(Core& core, std::uint32_t shape);

/// Destroys the shape's contacts, or with `unwanted` only those that filters or joints now forbid, and wakes the bodies that it touched.
void end_contacts_of_shape(Core& core, std::uint32_t shape, bool unwanted = false);
/// Takes the flags `forget` (ContactFlags) from the shape's contacts and mixes their materials again, after the shape's material or one-way direction changed.
/// Wakes the body and the bodies that touch the shape.
void remix(Core& core, std::uint32_t shape, std::uint32_t forget = 0);

// The parts of making a shape:

/// True if the definition breaks no rule; else records the error.
bool check_shape_def(const Core& core, const ShapeDef& def);
/// Takes a slot for a shape with its body and geometry. Returns null_index, with the error recorded, if there is no room.
std::uint32_t add_shape(Core& core, std::uint32_t body, const Geometry& geometry, const ShapeDef& def);
/// Updates mass, boxes and the tree after shapes were added to a body or taken from it. Of a static body only the newest shapes are looked at, so many as are
/// given: a level of thousands of shapes may be one body.
void shapes_changed(Core& core, std::uint32_t body, std::uint32_t newest);
/// Makes a shape: checks the body and the definition, and does all of the above. `valid` says whether the geometry is valid.
ShapeId attach_shape(Core& core, BodyId body, const Geometry& geometry, bool valid, const ShapeDef& def);

/// True if this build has such shapes.
template <class Shape>
bool is_in_build(const Shape&) {
    return has_shape(RowOf<Shape>::type);
}
inline bool is_in_build(const Polygon& shape) { return has_polygons && (has_hulls || is_box(shape) || !islet::is_valid(shape)); }

/// World::create_shape for a type of shape.
#define ISLET_DEFINE_CREATE_SHAPE(name, Type)                                                                                                     \
    ShapeId World::create_shape(BodyId body, const Type& shape, const ShapeDef& def) {                                                            \
        note_call<Call::create_##name>(core(), body, shape, def);                                                                                 \
        return check_there(core(), is_in_build(shape)) ? attach_shape(core(), body, geometry_of(shape), islet::is_valid(shape), def) : ShapeId{}; \
    }

/// Gives a shape another geometry. `valid` says whether it is valid, `there` whether this build has its type. Contacts are destroyed, because the types of two
/// shapes decide which of them is A; the next step finds those of the new geometry.
void replace_geometry(Core& core, ShapeId shape, const Geometry& geometry, bool valid, bool there);

/// World::set_circle and so on, for a type of shape.
#define ISLET_DEFINE_SET_SHAPE(name, Type)                                                            \
    void World::set_##name(ShapeId id, const Type& shape) {                                           \
        note_call<Call::set_##name>(core(), id, shape);                                               \
        replace_geometry(core(), id, geometry_of(shape), islet::is_valid(shape), is_in_build(shape)); \
    }

}  // namespace islet::detail
