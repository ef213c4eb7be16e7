// Hit events. Weakly referenced: only World::hit_events, which reads them, links it.
#pragma once

#include "memory/core.hpp"

namespace islet::detail {

/// Reports the contacts whose shapes came together faster than the threshold, in slot order. `speeds` by contact, as ContactKernel::store wrote them.
ISLET_OPTIONAL void report_hits(Core& core, const float* speeds);

/// Does nothing, but whoever refers to it links the function above.
void link_hits();
inline bool hits_are_linked() {
#if defined(__ELF__)
    return report_hits != nullptr;
#else
    return true;
#endif
}

}  // namespace islet::detail
