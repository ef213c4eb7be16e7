/// Makes a world in `block`, which must be aligned to ISLET_WORLD_ALIGNMENT and hold at least islet_world_bytes(capacity) bytes. The world then owns all of it.
/// Returns null, and sets *error if given, if the block, the capacity or the definition breaks a rule, or if the engine was compiled in a way that changes the
/// bits (inexact_build). def may be null. There is nothing to destroy: the block is yours again when you no longer use the world.
ISLET_C_API IsletWorld* islet_create_world(void* block, size_t block_bytes, const IsletCapacity* capacity, const IsletWorldDef* def, IsletError* error);

/// The error of the last call that failed, since creation or islet_world_clear_error; null_pointer if `world` is null.
ISLET_C_API IsletError islet_world_last_error(const IsletWorld* world);
ISLET_C_API IsletError islet_world_clear_error(IsletWorld* world);
/// A sentence: what was wrong and how to mend it. Never null.
ISLET_C_API const char* islet_describe(IsletError error);

/// The first field for whose sake islet_create_world refuses the definition, as the functions for other definitions do. If def is null, null_pointer; if a struct
/// has a wrong size, struct_size.
ISLET_C_API IsletFieldFault islet_find_world_def_fault(const IsletWorldDef* def);

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

/// A fleet: many worlds of one capacity, which start as copies of one world and step together. It lives in memory of yours (islet_create_fleet). Errors of a
/// fleet are returned, and no hook is told of them. not_a_fleet: the pointer points to something else, or the fleet was moved.
typedef struct IsletFleet IsletFleet;

/// What islet_fleet_step does. A count of 0 stands for nothing to do; all arrays are read and written during the call only.
typedef struct IsletFleetStep {
    uint32_t struct_size;  ///< sizeof(IsletFleetStep)
    float dt;              ///< s, ISLET_MIN_TIME_STEP to 1
    uint32_t repeat;       ///< Steps of each world, 1 to 1000; each repeats the actions.
    uint32_t reserved;     ///< 0
    const uint8_t* mask;   ///< islet_fleet_size() numbers: where one is 0, that world stays as it is. None: all step.
    size_t mask_count;
    const IsletDrive* drives;
    size_t drives_count;
    const float* actions;  ///< islet_fleet_size() rows of drives_count numbers. Finite.
    size_t actions_count;
    const IsletSense* senses;
    size_t senses_count;
    float* observations;  ///< islet_fleet_size() rows of islet_sense_columns() numbers. Rows of worlds that did not step stay as they are.
    size_t observations_count;
} IsletFleetStep;

static inline IsletFleetStep islet_default_fleet_step(void) {
    IsletFleetStep what = ISLET_ZERO;
    what.struct_size = sizeof what;
    what.dt = 1.0f / 60;
    what.repeat = 1;
    return what;
}

/// Bytes of memory that a fleet needs; 0 if the capacity is not valid or null, or there is no world or no worker, or more than 2^20 worlds or
/// ISLET_MAX_WORKERS.
ISLET_C_API size_t islet_fleet_bytes(uint32_t worlds, const IsletCapacity* capacity, uint32_t workers);
/// Makes a fleet of `worlds` copies of `prototype` in `block`, which must be aligned to ISLET_WORLD_ALIGNMENT and hold at least
/// islet_fleet_bytes(worlds, the prototype's capacity, tasks->workers) bytes. The worlds have the prototype's state, settings and hooks, but no recording and
/// no clock; each steps on one thread, and `tasks` steps many at a time. Hooks are then called on several threads at once. tasks may be null: one thread.
/// There is nothing to destroy. Returns null with *error set, if given: block_too_small; block_misaligned; out_of_range (of worlds or workers); in_step (of the
/// prototype); null_pointer; struct_size.
ISLET_C_API IsletFleet* islet_create_fleet(void* block, size_t block_bytes, const IsletWorld* prototype, uint32_t worlds, const IsletTaskSystem* tasks,
                                           IsletError* error);
/// How many worlds there are.
ISLET_C_API uint32_t islet_fleet_size(const IsletFleet* fleet);
/// World k, 0 <= k < islet_fleet_size(). It can be read and changed like any other. Null if there is none.
ISLET_C_API IsletWorld* islet_fleet_world(IsletFleet* fleet, uint32_t k);
/// In each world that the mask names: applies the actions and steps, `repeat` times, then observes. An action or a sense whose body or joint is gone from a
/// world, or is of the wrong type, does nothing there, or reads 0. Errors: bad_time_step; out_of_range (repeat, an unknown kind, arrays of other sizes);
/// not_finite (an action, a scale or a ray).
ISLET_C_API IsletError islet_fleet_step(IsletFleet* fleet, const IsletFleetStep* what);
/// Observes without a step. Errors as in islet_fleet_step.
ISLET_C_API IsletError islet_fleet_observe(IsletFleet* fleet, const IsletSense* senses, size_t senses_count, float* observations, size_t observations_count,
                                           const uint8_t* mask, size_t mask_count);
/// Takes world k back to an image made by this program (islet_world_save of a world of no greater capacity), and changes bodies at random: the same seed gives
/// the same changes. Errors: out_of_range (k, or a negative width); not_finite; those of islet_world_restore. A body that the image does not hold is left out.
ISLET_C_API IsletError islet_fleet_reset(IsletFleet* fleet, uint32_t k, const void* image, size_t image_bytes, uint64_t seed,
                                         const IsletVariation* variations, size_t variations_count);
/// Makes world `to` a copy of world `from`; a recording of `to` ends. Errors: out_of_range.
ISLET_C_API IsletError islet_fleet_copy(IsletFleet* fleet, uint32_t from, uint32_t to);
/// Makes each world k a copy of world parents[k], at once, to go on with the best futures of a search. A parent stays as it is: parents[parents[k]] is
/// parents[k], and so does a recording of it. Errors: out_of_range (a parent that is not so, or not islet_fleet_size() of them).
ISLET_C_API IsletError islet_fleet_fork(IsletFleet* fleet, const uint32_t* parents, size_t parents_count);
