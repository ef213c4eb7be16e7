// Lengths and unit vectors, and the integration of a rotation: what math.hpp declares but does not define, trigonometry apart.
#include "islet/math.hpp"
#include "math/scalar.hpp"

namespace islet {
namespace {

// Squared lengths that can be divided by: below, digits are lost to underflow; above, the square has overflowed. NaN is outside too.
constexpr float least_square = 1e-36f;
constexpr float largest_square = 3.402823466e+38f;
bool has_direction(float square) { return square >= least_square && square <= largest_square; }

}  // namespace

float length(Vec2 a) { return detail::sqrt(dot(a, a)); }

float distance(Vec2 a, Vec2 b) { return length(b - a); }

Vec2 normalize(Vec2 a) {
    const float square = length_squared(a);
    if (!has_direction(square)) return {};
    const float len = detail::sqrt(square);
    return {a.x / len, a.y / len};  // divisions, not a product with 1 / len: a vector along an axis becomes exactly +-1
}

Rot normalize(Rot q) {
    const float square = q.c * q.c + q.s * q.s;
    if (!has_direction(square)) return {};
    const float inv_length = 1.0f / detail::sqrt(square);
    return {q.c * inv_length, q.s * inv_length};
}

/// The step is (1 - d^2/3, d), whose angle is atan(d / (1 - d^2/3)) = d - d^5/45 + ...: the usual (1, d) is off by d^3/3 already. Larger
/// steps fall short of d, but never go beyond half a turn.
Rot integrate(Rot q, float delta_radians) {
    const float d = delta_radians;
    if (!(abs(d) < 1e6f)) return normalize(q);  // NaN, or a square that could overflow
    return normalize(q * Rot{1.0f - d * d * (1.0f / 3.0f), d});
}

}  // namespace islet
