// Hits: contacts whose shapes came together fast. Whoever asks for them links them (solver/hits.hpp).
#include "solver/hits.hpp"

#include "world/checks.hpp"
#include "world/contact_info.hpp"

namespace islet {

using namespace detail;

namespace detail {

void link_hits() {}

void report_hits(Core& core, const float* speeds) {
    const float threshold = core.state->hit_threshold;
    const std::uint32_t room = hit_capacity(core.capacity);
    const BitSet awake = core.awake_contacts;
    awake.for_each([&](std::uint32_t i) {
        constexpr std::uint32_t wanted = contact_touching | contact_hits;
        if ((core.manifolds[i].flags & wanted) != wanted || !(abs(speeds[i]) > threshold)) return;
        if (core.hit_count == room) {
            ++core.report.dropped_hits;
            return;
        }
        ContactInfo contact;
        read_contact(core, i, contact);
        core.hit_events[core.hit_count++] = {contact.shape_a, contact.shape_b, contact.points[speeds[i] < 0 ? 1 : 0].point, contact.normal, abs(speeds[i])};
    });
    if (core.report.dropped_hits != 0) core.fail(Error::hits_full);
}

}  // namespace detail

std::span<const HitEvent> World::hit_events() const {
    link_hits();
    return {core().hit_events, core().hit_count};
}

float World::hit_threshold() const { return core().state->hit_threshold; }

void World::set_hit_threshold(float speed) {
    if (check_range(core(), speed, 0, no_limit)) core().state->hit_threshold = speed;
}

}  // namespace islet
