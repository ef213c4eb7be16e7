// Checks of arguments for the public functions. Each records the error, and returns whether the call may go on.
#pragma once

#include "../data/core.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

/// Slot of a live body, shape or joint, or null_index with the error recorded.
std::uint32_t find_slot(const Core& core, BodyId id);
std::uint32_t find_slot(const Core& core, ShapeId id);
std::uint32_t find_slot(const Core& core, JointId id);

inline bool check(const Core& core, bool good, Error error) {
    if (!good) core.fail(error);
    return good;
}

/// What this build leaves out (islet/config.hpp) is refused: for `there` pass a constant has_..., or that the call needs no such thing.
inline bool check_there(const Core& core, bool there) { return check(core, there, Error::feature_cut); }

/// False, with in_step recorded, while the world is calling a function of the user's (Inside, Closed). Every public function that changes the world, or reads
/// all of it, checks this first. Functions with an id check it through the next function.
ISLET_SHARED bool check_open(const Core& core) { return check(core, core.inside == outside, Error::in_step); }

/// The slot of an object to be changed. (Functions that only read have a const Core, so they call the three functions above.)
template <class Id>
ISLET_SHARED std::uint32_t find_slot(Core& core, Id id) {
    return check_open(core) ? find_slot(static_cast<const Core&>(core), id) : null_index;
}

/// The body of a public function that reads something of the object `id`, with the core c and its slot i. Zero if the id is not good.
#define ISLET_READ(value)                     \
    const Core& c = core();                   \
    const std::uint32_t i = find_slot(c, id); \
    if (i == null_index) return {};           \
    return value

/// True if no number is infinite or NaN: zero times any other number is zero.
template <class... Floats>
ISLET_SHARED bool all_finite(Floats... a) {
    return ((0.0f * a) + ...) == 0.0f;
}
inline bool check_finite(const Core& core, float a) { return check(core, is_finite(a), Error::not_finite); }
inline bool check_finite(const Core& core, Vec2 a) { return check(core, is_finite(a), Error::not_finite); }
/// Finite and lo <= a <= hi.
inline bool check_range(const Core& core, float a, float lo, float hi) { return check_finite(core, a) && check(core, a >= lo && a <= hi, Error::out_of_range); }
inline constexpr float no_limit = 3.402823466e38f;  // the largest float

inline bool check_position(const Core& core, Vec2 p) {
    return check_range(core, p.x, -max_position, max_position) && check_range(core, p.y, -max_position, max_position);
}

ISLET_SHARED bool check_pose(const Core& core, const Transform& t) {
    return check_position(core, t.p) && check(core, all_finite(t.q.c, t.q.s), Error::not_finite) &&
           check(core, abs(t.q.c * t.q.c + t.q.s * t.q.s - 1.0f) <= 1.0e-3f, Error::out_of_range);
}

inline bool is_time_step(float dt) { return dt >= min_time_step && dt <= 1; }

}  // namespace islet::detail
