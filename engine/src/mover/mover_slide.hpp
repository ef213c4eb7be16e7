// How a mover slides: which surfaces it touches, which way between them it may go, and how far that way is free.
#pragma once

#include "islet/mover.hpp"

namespace islet::detail {

// A mover keeps `mover_gap` away from every surface, and its casts stop at half of that. So a cast along a surface grazes neither the surface nor its seams.
inline constexpr float mover_cast_gap = 0.5f * mover_gap;
// Surfaces up to this much farther away than the gap count as touched, m.
inline constexpr float mover_touch = 2e-5f;
// The most touched surfaces that count, the closest ones. More at once are rare in two dimensions, and casts stop at all of them.
inline constexpr std::uint32_t mover_planes = 8;

/// A mover's step while it is made.
struct Mover {
    World& world;
    const MoverDef& def;
    MoverState state;
    Vec2 up, right;
    float least_up;  // along `up`, of the normal of ground to stand on: cosine of the steepest slope
    float dt;
    Vec2 start;         // m, the position before the step
    float leaving = 0;  // m, how much farther than it wanted to go it has gone in this step to leave what overlaps it

    /// The middle of the capsule's lower end.
    Vec2 support() const;
    /// The height of a point above the feet, m.
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

/// The surfaces that the mover touches, closest first, at most mover_planes.
Touched touched_by(const Mover& m);
/// The vector nearest to `wanted` that keeps all bounds; `room` says whether there is one. If there is none, a vector that breaks no bound by much more than
/// necessary.
Vec2 within_bounds(Vec2 wanted, const Bound* bounds, std::uint32_t count, bool& room);
/// The bounds that touched surfaces set to the way: not closer than the gap, or, if the mover is already closer, away from the surface. A mover that is deep in
/// a surface, since that has moved or a body fell onto it, does not leave it at once.
void set_bounds(Mover& m, const Touched& t, Bound (&bounds)[mover_planes]);
/// The piece of a way that keeps the bounds, not much longer than the way. If there is none, the mover is squeezed.
Vec2 next_piece(Mover& m, Vec2 way, const Bound* bounds, std::uint32_t count);
/// Goes a fraction of a piece of a way.
void go(Mover& m, float fraction, Vec2 piece, Vec2 way);
/// The first surface that the mover, kept a distance away, meets on a way. A surface that it already touches counts only if the way leads into it.
struct Met {
    float fraction = 1;  // of the way that is free
    bool hit = false;
    Surface surface;
};
Met way_ahead(const Mover& m, Vec2 way, float distance = mover_cast_gap);
/// Moves along `way`, and where surfaces bar it, along these.
void slide(Mover& m, Vec2 way);
/// True if a ray of length `depth` down from a point first meets ground whose slope is not too steep to stand on; `normal` gets its normal.
bool finds_ground(const Mover& m, Vec2 from, float depth, Vec2& normal);
/// True if the touched surface is ground to stand on, or the edge of such ground; `top` gets the ground's normal.
bool is_edge(const Mover& m, const Surface& s, Vec2& top);
/// True if the mover can stand on the surface, by its slope or because it is the edge of such ground. `face` gets the normal along which it walks.
bool can_stand_on(const Mover& m, const Surface& s, Vec2& face);

}  // namespace islet::detail
