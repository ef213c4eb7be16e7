// Hit events: read off the rows of contacts once they are solved, which know the approach of what bounces or tells of hits. Weakly referenced: only
// World::hit_events, which reads them, links it.
#pragma once

#include "../constraint/contact_rows.hpp"
#include "../data/core.hpp"

namespace islet::detail {

/// Of solved rows: writes to `speeds`, by contact, of each that is to tell of hits (contact_hits) how fast its shapes came together where they needed an
/// impulse, m/s, below 0 if at the second point; 0 if nowhere.
ISLET_OPTIONAL void note_hits(const ContactManifold* manifolds, const ContactRows<1>* rows, std::uint32_t count, float* speeds);
ISLET_OPTIONAL void note_hits(const ContactManifold* manifolds, const ContactRows<4>* rows, std::uint32_t count, float* speeds);
ISLET_OPTIONAL void note_hits(const ContactManifold* manifolds, const ContactRows<8>* rows, std::uint32_t count, float* speeds);

/// Reports the contacts whose shapes came together faster than the threshold, in slot order.
ISLET_OPTIONAL void report_hits(Core& core, const float* speeds);

/// Does nothing, but whoever refers to it links the function above.
void link_hits();
inline bool hits_are_linked() { return ISLET_IS_LINKED(report_hits); }

}  // namespace islet::detail
