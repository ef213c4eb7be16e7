// Lengths, unit vectors and the integration of a rotation: what math.hpp declares, but for trigonometry.
#include "../exact.hpp"

#include "../math/scalar.hpp"
#include "islet/math.hpp"

namespace islet {
namespace {

bool has_direction(float square) { return square >= detail::least_square && square <= detail::largest_square; }

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

/// Takes sine and cosine by their series up to d^7, and normalises. Steps larger than pi/2, which no body makes, are cut.
Rot integrate(Rot q, float delta_radians) {
    if (delta_radians != delta_radians) return normalize(q);
    const float d = detail::within_bounds(delta_radians, 0.5f * pi);
    const float z = d * d;
    const float c = 1.0f - z * (0.5f - z * (1.0f / 24 - z * (1.0f / 720)));
    const float s = d * (1.0f - z * (1.0f / 6 - z * (1.0f / 120 - z * (1.0f / 5040))));
    return normalize(q * Rot{c, s});
}

}  // namespace islet
