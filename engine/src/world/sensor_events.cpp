// The overlaps of sensors. A program that calls one of these functions links the sensors (graph/sensors.hpp).
#include "../exact.hpp"

#include "../graph/sensors.hpp"

#include "../calls/checks.hpp"
#include "../graph/contacts.hpp"

namespace islet {

using namespace detail;

span<const SensorEvent> World::sensor_begin_events() const { return {core().sensor_begins.events, core().sensor_begins.count}; }

span<const SensorEvent> World::sensor_end_events() const { return {core().sensor_ends.events, core().sensor_ends.count}; }

std::uint32_t World::sensor_overlaps(ShapeId id, span<ShapeId> out) const {
    const Core& c = core();
    const std::uint32_t i = find_slot(c, id);
    if (i == null_index || !check(c, detail::is_sensor(c, i), Error::not_a_sensor)) return 0;
    std::uint32_t n = 0;
    for_each_contact(c, c.shapes[i].body, [&](std::uint32_t contact, std::uint32_t) {
        const Contact& of = c.contacts[contact];
        if ((of.shape_a != i && of.shape_b != i) || (c.manifolds[contact].flags & contact_overlap) == 0) return;
        if (n < out.size()) out[n] = c.shape_id(of.shape_a == i ? of.shape_b : of.shape_a);
        ++n;
    });
    return n;
}

}  // namespace islet
