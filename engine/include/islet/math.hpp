// Vectors, rotations, transforms and boxes: plain data and the arithmetic on it.
//
// Every operator is forced inline, so the engine's copy is compiled with the engine's flags: the flags of a user's file never change the engine's results.
// Functions of more than a few operations are not inline.
#pragma once

#include <cstdint>

#include "islet/compiler.hpp"
#include "islet/version.hpp"
#include "islet/visibility.hpp"

#define ISLET_INLINE ISLET_ALWAYS_INLINE constexpr inline

ISLET_API_BEGIN
namespace islet {

inline constexpr float pi = 3.14159265358979f;

/// A point or direction, metres unless said otherwise.
struct Vec2 {
    float x = 0;
    float y = 0;
    ISLET_EQUAL_IF(Vec2, a.x == b.x && a.y == b.y)
};

/// A rotation as cosine and sine of its angle; by default the angle is 0. Invariant: c^2 + s^2 = 1 but for rounding.
struct Rot {
    float c = 1;
    float s = 0;
    ISLET_EQUAL_IF(Rot, a.c == b.c && a.s == b.s)
};

/// A pose: rotate by q, then move by p (metres).
struct Transform {
    Vec2 p = {};
    Rot q = {};
    ISLET_EQUAL_IF(Transform, a.p == b.p && a.q == b.q)
};

/// An axis-aligned box, m. Valid when lower <= upper on both axes.
struct Aabb {
    Vec2 lower = {};
    Vec2 upper = {};
    ISLET_EQUAL_IF(Aabb, a.lower == b.lower && a.upper == b.upper)
};

ISLET_INLINE Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
ISLET_INLINE Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
ISLET_INLINE Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
ISLET_INLINE Vec2 operator*(float s, Vec2 a) { return {s * a.x, s * a.y}; }
ISLET_INLINE Vec2 operator*(Vec2 a, float s) { return {s * a.x, s * a.y}; }
ISLET_INLINE Vec2& operator+=(Vec2& a, Vec2 b) { return a = a + b; }
ISLET_INLINE Vec2& operator-=(Vec2& a, Vec2 b) { return a = a - b; }
ISLET_INLINE Vec2& operator*=(Vec2& a, float s) { return a = s * a; }

/// The scalar product, |a| |b| times the cosine of the angle between them, in the product of their units.
ISLET_INLINE float dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// z of the three-dimensional cross product a x b, in the product of their units.
ISLET_INLINE float cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// w (rad/s, about z) crossed with r: the velocity of a point at r on a body turning at w.
ISLET_INLINE Vec2 cross(float w, Vec2 r) { return {-w * r.y, w * r.x}; }
/// a turned by +90 degrees.
ISLET_INLINE Vec2 left_perp(Vec2 a) { return {-a.y, a.x}; }
/// a turned by -90 degrees.
ISLET_INLINE Vec2 right_perp(Vec2 a) { return {a.y, -a.x}; }
/// |a|^2, in the square of its unit.
ISLET_INLINE float length_squared(Vec2 a) { return dot(a, a); }
/// |b - a|^2, m^2.
ISLET_INLINE float distance_squared(Vec2 a, Vec2 b) { return length_squared(b - a); }
/// The point at the fraction t of the way from a to b; t may be outside 0 to 1.
ISLET_INLINE Vec2 lerp(Vec2 a, Vec2 b, float t) { return a + t * (b - a); }

/// The smaller of two numbers of one unit; b if either is NaN.
ISLET_INLINE float min(float a, float b) { return a < b ? a : b; }
/// The larger of two numbers of one unit; b if either is NaN.
ISLET_INLINE float max(float a, float b) { return a > b ? a : b; }
/// |a|, in its unit.
ISLET_INLINE float abs(float a) { return detail::magnitude_of(a); }
/// The number of the range lo to hi nearest to a, in their one unit; NaN stays NaN.
ISLET_INLINE float clamp(float a, float lo, float hi) { return a < lo ? lo : (a > hi ? hi : a); }
/// The smaller of each coordinate.
ISLET_INLINE Vec2 min(Vec2 a, Vec2 b) { return {min(a.x, b.x), min(a.y, b.y)}; }
/// The larger of each coordinate.
ISLET_INLINE Vec2 max(Vec2 a, Vec2 b) { return {max(a.x, b.x), max(a.y, b.y)}; }

/// v turned by q.
ISLET_INLINE Vec2 rotate(Rot q, Vec2 v) { return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y}; }
/// v turned by the inverse of q.
ISLET_INLINE Vec2 inv_rotate(Rot q, Vec2 v) { return {q.c * v.x + q.s * v.y, -q.s * v.x + q.c * v.y}; }
/// First r, then q.
ISLET_INLINE Rot operator*(Rot q, Rot r) { return {q.c * r.c - q.s * r.s, q.s * r.c + q.c * r.s}; }
/// The same turn the other way.
ISLET_INLINE Rot inverse(Rot q) { return {q.c, -q.s}; }
/// inverse(q) * r: the rotation that leads from q to r.
ISLET_INLINE Rot inv_mul(Rot q, Rot r) { return {q.c * r.c + q.s * r.s, q.c * r.s - q.s * r.c}; }

/// The point v of a body with the pose t, seen from the world, m.
ISLET_INLINE Vec2 transform_point(const Transform& t, Vec2 v) { return rotate(t.q, v) + t.p; }
/// The point v of the world, seen from a body with the pose t, m.
ISLET_INLINE Vec2 inv_transform_point(const Transform& t, Vec2 v) { return inv_rotate(t.q, v - t.p); }
/// The pose of b seen from a: inverse(a) * b.
ISLET_INLINE Transform inv_mul(const Transform& a, const Transform& b) { return {inv_rotate(a.q, b.p - a.p), inv_mul(a.q, b.q)}; }

/// Whether two boxes share a point; boxes that touch do.
ISLET_INLINE bool overlaps(const Aabb& a, const Aabb& b) {
    return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y && b.lower.y <= a.upper.y;
}
/// Whether no point of inner is outside outer.
ISLET_INLINE bool contains(const Aabb& outer, const Aabb& inner) {
    return outer.lower.x <= inner.lower.x && outer.lower.y <= inner.lower.y && inner.upper.x <= outer.upper.x && inner.upper.y <= outer.upper.y;
}
/// The smallest box that contains both.
ISLET_INLINE Aabb merge(const Aabb& a, const Aabb& b) { return {min(a.lower, b.lower), max(a.upper, b.upper)}; }
/// The box with each side moved outward by margin, m.
ISLET_INLINE Aabb expand(const Aabb& a, float margin) { return {{a.lower.x - margin, a.lower.y - margin}, {a.upper.x + margin, a.upper.y + margin}}; }
/// The sum of the four sides, m.
ISLET_INLINE float perimeter(const Aabb& a) { return 2.0f * ((a.upper.x - a.lower.x) + (a.upper.y - a.lower.y)); }

/// True for every number but NaN and the infinities, in any unit.
ISLET_INLINE bool is_finite(float a) { return (__builtin_bit_cast(std::uint32_t, a) << 1) < 0xff000000u; }
ISLET_INLINE bool is_finite(Vec2 a) { return is_finite(a.x) && is_finite(a.y); }

/// Euclidean length, in the unit of a; correctly rounded square root, the same bits everywhere.
float length(Vec2 a);
/// length(b - a), m.
float distance(Vec2 a, Vec2 b);
/// a / |a|, or the zero vector if |a| is below 1e-18 m, above 1e19 m (its square overflows) or not finite.
Vec2 normalize(Vec2 a);

/// Sine and cosine of any finite angle in radians, the same bits on every machine. The error is stated and tested in math/trig.cpp.
/// Huge angles are reduced exactly, but are themselves rounded (0.004 rad at 1e5); a non-finite angle gives the identity rotation.
Rot make_rot(float radians);
/// Angle of q in (-pi, pi], radians.
float angle_of(Rot q);
/// Angle of the vector (x, y) in (-pi, pi], radians; 0 for the zero vector or a non-finite one. The same bits everywhere.
float atan2(float y, float x);
/// q scaled back to unit length; the identity if q is degenerate.
Rot normalize(Rot q);
/// Between two rotations by the fraction t, the short way: q at t = 0, r at t = 1, with nearly steady speed. For turns of less than half a circle.
ISLET_ALWAYS_INLINE inline Rot lerp(Rot q, Rot r, float t) { return normalize(Rot{q.c + t * (r.c - q.c), q.s + t * (r.s - q.s)}); }
/// Between two poses by the fraction t, for drawing between two steps.
ISLET_ALWAYS_INLINE inline Transform lerp(const Transform& a, const Transform& b, float t) { return {lerp(a.p, b.p, t), lerp(a.q, b.q, t)}; }
/// q turned further by an angle d (radians) and normalised: the integration of an angular velocity over a step. Within 1e-7 rad for |d| <= 0.5 and
/// 1e-3 rad for |d| <= pi/2; larger turns are cut to pi/2, and a NaN turns nothing.
Rot integrate(Rot q, float delta_radians);

}  // namespace islet
ISLET_API_END
