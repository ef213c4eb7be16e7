// What follows no rule: functions of the C interface that are written by hand, and what all the others call.
#include "glue.hpp"

namespace islet::c {

IsletError refuse(const IsletWorld* world, int error) {
    if (world != nullptr) detail::replace_error(of(world), static_cast<Error>(error), true);
    return static_cast<IsletError>(error);
}

Error begin(IsletWorld* world) { return detail::replace_error(of(world), Error::none, false); }

IsletError end(IsletWorld* world, Error before) {
    const Error error = of(world).last_error();
    if (error == Error::none) detail::replace_error(of(world), before, false);
    return static_cast<IsletError>(error);
}

const void* take_exact(const IsletWorld* world, const void* given, std::uint32_t size, std::uint32_t start) {
    std::uint32_t claimed = 0;
    if (given != nullptr) std::memcpy(&claimed, given, sizeof claimed);
    if (claimed == size) return static_cast<const char*>(given) + start;
    refuse(world, why(given));
    return nullptr;
}

// -- drawing --------------------------------------------------------------------------------------------------------------------------

namespace {

const IsletDrawStyle* c_style(const DrawStyle& style) { return cast<const IsletDrawStyle>(&style); }
const DebugDraw& user(void* context) { return *static_cast<const DebugDraw*>(context); }

void draw_polygon(std::span<const Vec2> corners, float radius, const DrawStyle& style, void* context) {
    using Function = void (*)(const IsletVec2*, std::size_t, float, const IsletDrawStyle*, void*);
    function<Function>(user(context).polygon)(cast<const IsletVec2>(corners.data()), corners.size(), radius, c_style(style), user(context).context);
}
void draw_circle(Vec2 center, float radius, Vec2 axis, const DrawStyle& style, void* context) {
    using Function = void (*)(IsletVec2, float, IsletVec2, const IsletDrawStyle*, void*);
    function<Function>(user(context).circle)(out(center), radius, out(axis), c_style(style), user(context).context);
}
void draw_capsule(Vec2 point1, Vec2 point2, float radius, const DrawStyle& style, void* context) {
    using Function = void (*)(IsletVec2, IsletVec2, float, const IsletDrawStyle*, void*);
    function<Function>(user(context).capsule)(out(point1), out(point2), radius, c_style(style), user(context).context);
}
void draw_segment(Vec2 point1, Vec2 point2, const DrawStyle& style, void* context) {
    using Function = void (*)(IsletVec2, IsletVec2, const IsletDrawStyle*, void*);
    function<Function>(user(context).segment)(out(point1), out(point2), c_style(style), user(context).context);
}
void draw_point(Vec2 point, const DrawStyle& style, void* context) {
    using Function = void (*)(IsletVec2, const IsletDrawStyle*, void*);
    function<Function>(user(context).point)(out(point), c_style(style), user(context).context);
}
void draw_text(Vec2 point, const char* text, const DrawStyle& style, void* context) {
    using Function = void (*)(IsletVec2, const char*, const IsletDrawStyle*, void*);
    function<Function>(user(context).text)(out(point), text, c_style(style), user(context).context);
}

}  // namespace

Drawing::Drawing(const DebugDraw& of_c) : given(of_c), functions(of_c) {
    functions.context = &given;
    if (given.polygon != nullptr) functions.polygon = draw_polygon;
    if (given.circle != nullptr) functions.circle = draw_circle;
    if (given.capsule != nullptr) functions.capsule = draw_capsule;
    if (given.segment != nullptr) functions.segment = draw_segment;
    if (given.point != nullptr) functions.point = draw_point;
    if (given.text != nullptr) functions.text = draw_text;
}

namespace {

/// Points to a struct that the caller may leave out. False if its size is wrong.
template <class T>
bool take_if_given(const typename Twin<T>::Type* given, T& to) {
    if (given == nullptr) return true;
    Room<T> room;
    const T* taken = take<T>(nullptr, given, room);
    if (taken == nullptr) return false;
    to = *taken;
    return true;
}

/// Whether a capacity can be written where the caller wants it, if anywhere.
bool fits_if_wanted(const IsletCapacity* out) { return out == nullptr || fits<Capacity>(nullptr, out); }

}  // namespace
}  // namespace islet::c

using namespace islet;
using namespace islet::c;

extern "C" {

IsletWorld* islet_create_world(void* block, size_t block_bytes, const IsletCapacity* capacity, const IsletWorldDef* given, IsletError* error) {
    IsletError ignored = ISLET_ERROR_NONE;
    if (error == nullptr) error = &ignored;
    Room<Capacity> room;
    const Capacity* taken = take<Capacity>(nullptr, capacity, room);
    WorldDef def;
    *error = ISLET_ERROR_NONE;
    if (block == nullptr) *error = ISLET_ERROR_NULL_POINTER;
    if (taken == nullptr) *error = why(capacity);
    if (given != nullptr) {
        if (given->struct_size != sizeof *given || !take_if_given(given->solver, def.solver) || !take_if_given(given->hooks, def.hooks) ||
            !take_if_given(given->tasks, def.tasks)) {
            *error = ISLET_ERROR_STRUCT_SIZE;
        } else {
            def.gravity = in<Vec2>(given->gravity);
            def.enable_sleep = given->enable_sleep;
            def.restitution_threshold = given->restitution_threshold;
            def.max_speed = given->max_speed;
            def.hit_threshold = given->hit_threshold;
            def.continuous = given->continuous;
            def.lanes = given->lanes;
            def.error_hook = function<ErrorHook>(given->error_hook);
            def.error_context = given->error_context;
            def.clock = given->clock;
            def.clock_context = given->clock_context;
        }
    }
    if (*error != ISLET_ERROR_NONE) {
        if (def.error_hook != nullptr) def.error_hook(static_cast<Error>(*error), def.error_context);
        return nullptr;
    }
    return reinterpret_cast<IsletWorld*>(World::create({static_cast<std::byte*>(block), block_bytes}, *taken, def, reinterpret_cast<Error*>(error)));
}

IsletError islet_world_last_error(const IsletWorld* world) {
    return world == nullptr ? static_cast<IsletError>(ISLET_ERROR_NULL_POINTER) : out(of(world).last_error());
}

IsletError islet_world_clear_error(IsletWorld* world) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    of(world).clear_error();
    return ISLET_ERROR_NONE;
}

const char* islet_describe(IsletError error) {
    if (error == ISLET_ERROR_NULL_POINTER) return "A pointer that must not be null is: check what the call was given, the world among it.";
    if (error == ISLET_ERROR_STRUCT_SIZE)
        return "A struct has no size that this version of Islet knows: start from its islet_default_..., which sets struct_size.";
    return islet::describe(in<Error>(error));
}

IsletSeparation islet_separation(const IsletShapeProxy* a, const IsletShapeProxy* b) {
    static constexpr ShapeProxy none = {};
    return out(islet::separation(a == nullptr ? none : *cast<const ShapeProxy>(a), b == nullptr ? none : *cast<const ShapeProxy>(b)));
}

IsletError islet_read_snapshot(const void* image, size_t image_bytes, IsletSnapshotInfo* info) {
    if (info == nullptr || (image == nullptr && image_bytes != 0)) return ISLET_ERROR_NULL_POINTER;
    if (info->struct_size != sizeof *info || !fits_if_wanted(info->capacity) || !fits_if_wanted(info->used)) return ISLET_ERROR_STRUCT_SIZE;
    SnapshotInfo found;
    const Error error = islet::read_snapshot(span_of<const std::byte>(image, image_bytes), found);
    if (error != Error::none) return out(error);
    info->bytes = found.bytes;
    if (info->capacity != nullptr) give<Capacity>(info->capacity, found.capacity);
    if (info->used != nullptr) give<Capacity>(info->used, found.used);
    return ISLET_ERROR_NONE;
}

IsletError islet_read_recording(const void* recording, size_t recording_bytes, IsletRecordingInfo* info) {
    if (info == nullptr || (recording == nullptr && recording_bytes != 0)) return ISLET_ERROR_NULL_POINTER;
    if (info->struct_size != sizeof *info || !fits_if_wanted(info->capacity) || !fits_if_wanted(info->needed)) return ISLET_ERROR_STRUCT_SIZE;
    RecordingInfo found;
    const Error error = islet::read_recording(span_of<const std::byte>(recording, recording_bytes), found);
    if (error != Error::none) return out(error);
    info->bytes = found.bytes;
    info->bodies = found.bodies;
    if (info->capacity != nullptr) give<Capacity>(info->capacity, found.capacity);
    if (info->needed != nullptr) give<Capacity>(info->needed, found.needed);
    return ISLET_ERROR_NONE;
}

bool islet_format_is_readable(const IsletFormatInfo* info) {
    Room<FormatInfo> room;
    const FormatInfo* taken = take<FormatInfo>(nullptr, info, room);
    return taken != nullptr && taken->is_readable();
}

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
