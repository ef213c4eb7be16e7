// Sensors: shapes that report what overlaps them and collide with nothing.
//
// A sensor and a shape whose fat boxes overlap have a contact like any other two, marked contact_sensor. It has no points and is never solved:
// contact_touching, by which islands, sleep and the solver go, is never set. contact_overlap says instead whether the two shapes overlap.
//
// A lean program (ISLET_LEAN) that uses no sensors does not link them. The functions below are referenced weakly, and only those functions of World that read
// overlaps call link_sensors, which takes all of them. A program without them has no sensors, so it never calls them.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// True if one of two shapes is a sensor that may see the other one, whatever their filters say. (Sensors see every kind of geometry, and joints do not
/// matter.)
ISLET_OPTIONAL bool may_sense(const Core& core, const Shape& s1, const Shape& s2);
/// True if the two shapes of a sensor's contact overlap now.
ISLET_OPTIONAL bool overlaps_sensor(const Core& core, std::uint32_t contact);
/// Note that the two shapes began, or ceased, to overlap, and record the event.
ISLET_OPTIONAL void begin_overlap(Core& core, std::uint32_t contact);
ISLET_OPTIONAL void end_overlap(Core& core, std::uint32_t contact);

/// Moves the events of sensors out of the way of one more touch in the same array.
ISLET_OPTIONAL void make_room(const Core& core, TouchEvent* array, std::uint32_t touches, SensorEvents& list);

/// Does nothing. A program that refers to it links the functions above.
void link_sensors();
/// True if the program has linked them.
inline bool sensors_are_linked() { return ISLET_IS_LINKED(begin_overlap); }

/// True of a sensor.
inline bool is_sensor(const Core& core, std::uint32_t shape) { return has_sensors && (core.shapes[shape].flags & shape_sensor) != 0; }

/// Adds a touch to the first of the two lists that share an array. There must be room.
inline void push_touch(const Core& core, TouchEvent* array, std::uint32_t& touches, SensorEvents& list, const TouchEvent& event) {
    if (has_sensors && list.count != 0) make_room(core, array, touches, list);
    array[touches++] = event;
}

}  // namespace islet::detail
