#pragma once

#include "../calls/checks.hpp"
#include "../calls/recorder.hpp"
#include "../data/core.hpp"
#include "../shapes/shape_types.hpp"

namespace islet::detail {

/// Takes a shape off its body and frees it, contacts first. The body's mass is left to the caller.
void remove_shape(Core& core, std::uint32_t shape);

/// Destroys the shape's contacts, or only those that may no longer be (`unwanted`), and wakes who was touched.
void end_contacts_of_shape(Core& core, std::uint32_t shape, bool unwanted = false);
/// After its material or its one-way direction changed: mixes materials again for the shape's contacts, after taking the flags `forget` (ContactFlags) from
/// them. Wakes the body and what touches the shape.
void remix(Core& core, std::uint32_t shape, std::uint32_t forget = 0);

// The parts of making a shape:

/// True if the definition keeps its rules; else records the error.
bool check_shape_def(const Core& core, const ShapeDef& def);
/// Takes a slot, and links it to its body and its geometry; null_index if there is no room, with the error recorded.
std::uint32_t add_shape(Core& core, std::uint32_t body, const Geometry& geometry, const ShapeDef& def);
/// After shapes were added to a body or taken from it: mass, boxes, the tree.
void shapes_changed(Core& core, std::uint32_t body);
/// All of these in turn, with the body and the definition checked; `valid` says whether the geometry is.
ShapeId attach_shape(Core& core, BodyId body, const Geometry& geometry, bool valid, const ShapeDef& def);

/// World::create_shape for a type of shape.
#define ISLET_DEFINE_CREATE_SHAPE(name, Type)                                                                                                             \
    ShapeId World::create_shape(BodyId body, const Type& shape, const ShapeDef& def) {                                                                    \
        note_call<Call::create_##name>(core(), body, shape, def);                                                                                         \
        return check_there(core(), has_shape(ShapeType::name)) ? attach_shape(core(), body, geometry_of(shape), islet::is_valid(shape), def) : ShapeId{}; \
    }

}  // namespace islet::detail
