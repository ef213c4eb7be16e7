// Hits: contacts whose shapes came together fast (solver/hits.hpp).
#include "../exact.hpp"

#include "../solver/hits.hpp"

#include "../calls/recorder.hpp"
#include "../constraint/contact_bounce.hpp"
#include "../graph/contacts.hpp"

namespace islet {

using namespace detail;

namespace detail {

namespace {

template <std::uint32_t W>
void note(const ContactManifold* manifolds, const ContactRows<W>* rows, std::uint32_t count, Hit* hits) {
    if (!has_hits) return;
    for (std::uint32_t block = 0; block < count; ++block) {
        const ContactRows<W>& r = rows[block];
        for (std::uint32_t i = 0; i < W; ++i) {
            const std::uint32_t contact = contact_of(r, i, manifolds);
            if (contact == null_index) continue;
            const ContactManifold& m = manifolds[contact];
            if ((m.flags & contact_hits) == 0) continue;
            hits[contact] = Hit::of_points(hit_speed(r, 0, i), m.count() == 2 ? hit_speed(r, 1, i) : 0.0f);
        }
    }
}

}  // namespace

void note_hits(const ContactManifold* manifolds, const ContactRows<1>* rows, std::uint32_t count, Hit* hits) { note(manifolds, rows, count, hits); }
#if ISLET_MAX_LANES >= 4
void note_hits(const ContactManifold* manifolds, const ContactRows<4>* rows, std::uint32_t count, Hit* hits) { note(manifolds, rows, count, hits); }
#endif
#if ISLET_MAX_LANES >= 8
void note_hits(const ContactManifold* manifolds, const ContactRows<8>* rows, std::uint32_t count, Hit* hits) { note(manifolds, rows, count, hits); }
#endif
#if ISLET_MAX_LANES >= 16
void note_hits(const ContactManifold* manifolds, const ContactRows<16>* rows, std::uint32_t count, Hit* hits) { note(manifolds, rows, count, hits); }
#endif

void report_hits(Core& core, const Hit* hits) {
    const float threshold = core.state->hit_threshold;
    const std::uint32_t room = hit_capacity(core.capacity);
    const BitSet awake = core.awake_contacts;
    awake.for_each([&](std::uint32_t i) {
        constexpr std::uint32_t wanted = contact_touching | contact_hits;
        if ((core.manifolds[i].flags & wanted) != wanted || !(hits[i].speed() > threshold)) return;
        if (core.hit_count == room) {
            ++core.report.dropped_hits;
            return;
        }
        ContactInfo contact;
        read_contact(core, i, contact);
        core.hit_events[core.hit_count++] = {contact.shape_a, contact.shape_b, contact.points[hits[i].point()].point, contact.normal, hits[i].speed()};
    });
    if (core.report.dropped_hits != 0) core.fail(Error::hits_full);
}

}  // namespace detail

span<const HitEvent> World::hit_events() const { return {core().hit_events, core().hit_count}; }

float World::hit_threshold() const { return core().state->hit_threshold; }

void World::set_hit_threshold(float speed) {
    note_call<Call::set_hit_threshold>(core(), speed);
    if (check_open(core()) && check_range(core(), speed, 0, no_limit)) core().state->hit_threshold = speed;
}

}  // namespace islet
