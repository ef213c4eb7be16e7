// Functions written by hand: an island as a complementarity problem.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

size_t islet_body_export_island(const IsletWorld* world, IsletBodyId body, float h, void* memory, size_t memory_bytes, IsletIslandProblem* to) {
    if (world == nullptr) return 0;
    if (memory == nullptr && memory_bytes != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    if (take_exact(world, to, sizeof *to, 0) == nullptr) return 0;
    IslandProblem found;
    const size_t bytes = of(world).export_island(in<BodyId>(body), h, span_of<std::byte>(memory, memory_bytes), found);
    if (bytes == 0 || bytes > memory_bytes) return bytes;
    to->row_count = static_cast<uint32_t>(found.rows.size());
    to->body_count = static_cast<uint32_t>(found.bodies.size());
    to->entry_count = static_cast<uint32_t>(found.lcp.sparse.values.size());
    to->row_starts = found.lcp.sparse.row_starts.data();
    to->columns = found.lcp.sparse.columns.data();
    to->values = found.lcp.sparse.values.data();
    to->q = found.lcp.q.data();
    to->lo = found.lcp.lo.data();
    to->hi = found.lcp.hi.data();
    to->friction = found.lcp.friction.data();
    to->impulses = found.impulses.data();
    to->rows = cast<const IsletIslandRow>(found.rows.data());
    to->bodies = cast<const IsletIslandBody>(found.bodies.data());
    return bytes;
}

}  // extern "C"
