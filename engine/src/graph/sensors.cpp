#include "../exact.hpp"

#include "../graph/sensors.hpp"

#include "../collide/distance.hpp"
#include "../graph/contacts.hpp"
#include "../shapes/shape_types.hpp"

namespace islet::detail {

namespace {

// Touches and overlaps share an array of events. Touches grow from its start; the overlaps lie in one piece in the remaining room. Whenever the piece comes up
// against an end of that room, it moves to the middle of the free part, so an array is filled with few moves.
SensorEvent* room_of(TouchEvent* array, std::uint32_t touches) { return reinterpret_cast<SensorEvent*>(array + touches); }

std::uint32_t free_room(const Core& core, std::uint32_t touches, const SensorEvents& list) { return event_capacity(core.capacity) - touches - list.count; }

void move(SensorEvents& list, SensorEvent* to) {
    std::memmove(to, list.events, std::size_t{list.count} * sizeof(SensorEvent));
    list.events = to;
}

void push(const Core& core, TouchEvent* array, std::uint32_t touches, SensorEvents& list, std::uint32_t contact) {
    SensorEvent* const room = room_of(array, touches);
    const std::uint32_t free = free_room(core, touches, list);
    if (list.count == 0) list.events = room + free / 2;
    if (list.events == room + free) move(list, room + free / 2);
    const Contact& c = core.contacts[contact];
    const bool a_senses = is_sensor(core, c.shape_a);
    list.events[list.count++] = {core.shape_id(a_senses ? c.shape_a : c.shape_b), core.shape_id(a_senses ? c.shape_b : c.shape_a)};
}

}  // namespace

bool may_sense(const Core& core, const Shape& s1, const Shape& s2) {
    const bool both = (s1.flags & s2.flags & shape_sensor) != 0;
    const bool unseen = (((s1.flags & shape_sensor) != 0 ? s2 : s1).flags & shape_unseen) != 0;
    const bool moves = core.bodies[s1.body].type() != BodyType::static_body || core.bodies[s2.body].type() != BodyType::static_body;
    return !both && !unseen && moves;
}

void make_room(const Core& core, TouchEvent* array, std::uint32_t touches, SensorEvents& list) {
    SensorEvent* const room = room_of(array, touches);
    if (list.events == room) move(list, room + (free_room(core, touches, list) + 1) / 2);
}

bool overlaps_sensor(const Core& core, std::uint32_t contact) {
    const Contact& c = core.contacts[contact];
    const ContactManifold& m = core.manifolds[contact];
    const Corners b = corners_of(core.geometries[core.shapes[c.shape_b].geometry]);
    const Transform b_in_a = pose_between(core, m.body_a, m.body_b, stand_now(core, m.body_a, m.body_b));
    Vec2 room[4];
    const Corners a = corners_near(core.geometries[core.shapes[c.shape_a].geometry], has_endless ? around(b, b_in_a) : Around{}, room);
    Vec2 moved[max_polygon_vertices];
    for (std::uint32_t i = 0; i < b.count; ++i) moved[i] = transform_point(b_in_a, b.points[i]);
    return core_distance(a.points, a.count, moved, b.count).distance <= a.radius + b.radius;
}

void begin_overlap(Core& core, std::uint32_t contact) {
    core.manifolds[contact].flags |= contact_overlap;
    note_begin(core, contact);
}

void tell_overlap(Core& core, std::uint32_t contact) { push(core, core.begin_events, core.begin_count, core.sensor_begins, contact); }

void end_overlap(Core& core, std::uint32_t contact) {
    core.manifolds[contact].flags &= ~static_cast<std::uint32_t>(contact_overlap);
    if (has_room_for_end(core)) push(core, core.end_events, core.end_count, core.sensor_ends, contact);
}

}  // namespace islet::detail
