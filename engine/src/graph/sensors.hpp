// Sensors: shapes that report what overlaps them and collide with nothing.
//
// A sensor and a shape whose fat boxes overlap have a contact like any other two, marked contact_sensor. It has no points and is never solved:
// contact_touching, by which islands, sleep and the solver go, is never set. contact_overlap says instead whether the two shapes overlap.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// True if one of two shapes is a sensor that may see the other one, whatever their filters say. (Sensors see every kind of geometry, and joints do not
/// matter.)
bool may_sense(const Core& core, const Shape& s1, const Shape& s2);
/// True if the two shapes of a sensor's contact overlap now.
bool overlaps_sensor(const Core& core, std::uint32_t contact);
/// Note that the two shapes began, or ceased, to overlap, and record the event: of a beginning, at the end of the step (tell_overlap).
void begin_overlap(Core& core, std::uint32_t contact);
void end_overlap(Core& core, std::uint32_t contact);
void tell_overlap(Core& core, std::uint32_t contact);

/// Moves the events of sensors out of the way of one more touch in the same array.
void make_room(const Core& core, TouchEvent* array, std::uint32_t touches, SensorEvents& list);

/// True of a sensor.
inline bool is_sensor(const Core& core, std::uint32_t shape) { return has_sensors && (core.shapes[shape].flags & shape_sensor) != 0; }

/// Adds a touch to the first of the two lists that share an array. There must be room.
inline void push_touch(const Core& core, TouchEvent* array, std::uint32_t& touches, SensorEvents& list, const TouchEvent& event) {
    if (has_sensors && list.count != 0) make_room(core, array, touches, list);
    array[touches++] = event;
}

}  // namespace islet::detail
