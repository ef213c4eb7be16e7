/// Makes a world in `block`, which must be aligned to ISLET_WORLD_ALIGNMENT and hold at least islet_world_bytes(capacity) bytes. The world then owns all of it.
/// Returns null, and sets *error if given, if the block, the capacity or the definition breaks a rule, or if the engine was compiled in a way that changes the
/// bits (inexact_build). def may be null. There is nothing to destroy: the block is yours again when you no longer use the world.
ISLET_C_API IsletWorld* islet_create_world(void* block, size_t block_bytes, const IsletCapacity* capacity, const IsletWorldDef* def, IsletError* error);

/// The error of the last call that failed, since creation or islet_world_clear_error; null_pointer if `world` is null.
ISLET_C_API IsletError islet_world_last_error(const IsletWorld* world);
ISLET_C_API IsletError islet_world_clear_error(IsletWorld* world);
/// A sentence: what was wrong and how to mend it. Never null.
ISLET_C_API const char* islet_describe(IsletError error);

/// Distance and closest points of two shapes in one frame. Of shapes that are not valid, or null: distance 3.4e38, no normal.
ISLET_C_API IsletSeparation islet_separation(const IsletShapeProxy* a, const IsletShapeProxy* b);

/// Reads the header of an image, and nothing else. Errors: not_an_image; other_byte_order; other_version; truncated_image; corrupt_image if the header
/// contradicts itself. Then `out` stays as it was.
ISLET_C_API IsletError islet_read_snapshot(const void* image, size_t image_bytes, IsletSnapshotInfo* out);
/// Copies a world into another block, for example into a larger one when it has grown full. The new world has the same state, ids, settings, hooks, tasks and
/// clock, but no recording; the old one stays as it is. `image` is memory that is used during the call only, at least islet_world_snapshot_bytes(from) bytes.
/// Returns null with *error set, if given: the errors of islet_create_world for the block and the capacity; image_too_small; image_too_large if the capacity
/// cannot hold what the world holds; in_step.
ISLET_C_API IsletWorld* islet_copy_world(const IsletWorld* from, void* block, size_t block_bytes, const IsletCapacity* capacity, void* image, size_t image_bytes,
                                         IsletError* error);
/// Reads the header of a recording, and goes through its calls without making them. On an error `out` stays as it was: image_misaligned; not_a_recording;
/// other_version; truncated_image; corrupt_recording if the header contradicts itself; and the errors of islet_read_snapshot for the recording's first snapshot.
ISLET_C_API IsletError islet_read_recording(const void* recording, size_t recording_bytes, IsletRecordingInfo* out);
/// Whether this version reads bytes of this format. They may be damaged nevertheless.
ISLET_C_API bool islet_format_is_readable(const IsletFormatInfo* info);

/// An island as a complementarity problem: x >= lo, x <= hi and w = M x + q, where w >= 0 if x = lo, w <= 0 if x = hi, and w = 0 between. The pointers are into
/// the memory given to islet_body_export_island. engine/include/islet/island.hpp says what the numbers mean.
typedef struct IsletIslandProblem {
    uint32_t struct_size;  ///< sizeof(IsletIslandProblem)
    uint32_t row_count;
    uint32_t body_count;
    uint32_t entry_count;        ///< of M
    const uint32_t* row_starts;  ///< row_count + 1 of them: row i of M has the entries row_starts[i] <= k < row_starts[i + 1]
    const uint32_t* columns;     ///< of each entry
    const float* values;         ///< of each entry
    const float* q;              ///< row_count of them, as of all that follow but bodies
    const float* lo;
    const float* hi;            ///< for a row with friction: its coefficient
    const uint32_t* friction;   ///< the row of whose x the bounds are multiples, or 0xffffffff
    float* impulses;            ///< x of the last step, scaled to a substep of length h: the warm start. You may write to it.
    const IsletIslandRow* rows;
    const IsletIslandBody* bodies;  ///< body_count of them
} IsletIslandProblem;

static inline IsletIslandProblem islet_default_island_problem(void) {
    IsletIslandProblem def = ISLET_ZERO;
    def.struct_size = sizeof def;
    return def;
}

/// Writes to `memory` the complementarity problem of a dynamic body's island as it stands now, for a substep of h seconds, and points `out` to it. Returns the
/// bytes needed; if `memory` has fewer, writes neither to it nor to `out`. `memory` needs no alignment, and may be null if memory_bytes is 0. Returns 0 on an
/// error: null_id; stale_id; no_dynamic_body; bad_time_step of h; in_step; out_of_range if the problem is too large.
ISLET_C_API size_t islet_body_export_island(const IsletWorld* world, IsletBodyId body, float h, void* memory, size_t memory_bytes, IsletIslandProblem* out);

