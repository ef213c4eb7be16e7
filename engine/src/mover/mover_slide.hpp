// How a mover gets on: what it touches, how far it may go between what it touches, and how far the way is free.
#pragma once

#include "islet/mover.hpp"

namespace islet::detail {

// A mover hovers `mover_gap` above every surface; casts stop at half of that. So a cast along a surface never grazes it, nor the seams of what it is made of.
inline constexpr float mover_cast_gap = 0.5f * mover_gap;
// Surfaces this much farther away are still touched, m.
inline constexpr float mover_touch = 2e-5f;
// The closest surfaces that are looked at; more are rarely touched at once in two dimensions, and casts mind them all.
inline constexpr std::uint32_t mover_planes = 8;

/// A step in the making.
struct Mover {
    World& world;
    const MoverDef& def;
    MoverState state;
    Vec2 up, right;
    float least_up;  // of a normal that can be stood on: cosine of the steepest slope
    float dt;

    /// The middle of the capsule's lower end.
    Vec2 support() const;
    /// Height of a point above the feet, m.
    float height_of(Vec2 point) const;
};

struct Touched {
    Surface surfaces[mover_planes];
    std::uint32_t count = 0;
};

/// A bound on the next piece of way, x: dot(normal, x) >= least.
struct Bound {
    Vec2 normal;
    float least = 0;
};

/// The surfaces that the mover touches, closest first; no more than mover_planes.
Touched touched_by(const Mover& m);
/// The vector nearest to `wanted` that keeps all bounds; `room` says whether there is one. If not, one that breaks none by much more than it must.
Vec2 within_bounds(Vec2 wanted, const Bound* bounds, std::uint32_t count, bool& room);
/// The bound that a touched surface sets to way: not closer than the gap; if already closer, away from it.
Bound bound_of(const Surface& s);
/// First surface that the mover, kept a cast's gap away, meets on a way; what it already touches is in the way only if it leads into it.
struct Met {
    float fraction = 1;  // of the way that is free
    bool hit = false;
    Surface surface;
};
Met way_ahead(const Mover& m, Vec2 way);
/// Moves along `way` and, where that is barred, along what bars it.
void slide(Mover& m, Vec2 way);
/// True if a ray of length `depth` down from a point first meets ground that can be stood on by its slope; `normal` gets what it meets.
bool finds_ground(const Mover& m, Vec2 from, float depth, Vec2& normal);
/// True if the surface touched is the edge of one that can be stood on, or such a one itself; `top` gets its normal.
bool is_edge(const Mover& m, const Surface& s, Vec2& top);
/// True if the surface can be stood on: by its slope, or because it is the edge of something that can. `face` gets the normal to walk by.
bool can_stand_on(const Mover& m, const Surface& s, Vec2& face);

}  // namespace islet::detail
