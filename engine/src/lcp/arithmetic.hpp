// Arithmetic that the methods share, for float and double.
#pragma once

#include "islet/compiler.hpp"

namespace islet::lcp {

template <class T>
struct Numbers;

template <>
struct Numbers<float> {
    static constexpr float epsilon = 0x1p-23f;    // from 1 to the next number
    static constexpr float smallest = 0x1p-126f;  // positive and normal
    static constexpr float infinity = __builtin_huge_valf();
    static constexpr float shrink = 0x1p-77f;  // the sum of max_rows products of any two numbers, each times this, does not overflow
};

template <>
struct Numbers<double> {
    static constexpr double epsilon = 0x1p-52;
    static constexpr double smallest = 0x1p-1022;
    static constexpr double infinity = __builtin_huge_val();
    static constexpr double shrink = 0x1p-525;
};

template <class T>
constexpr T magnitude(T a) {
    return a < T(0) ? -a : a;
}

template <class T>
constexpr T larger(T a, T b) {
    return a > b ? a : b;
}

/// A NaN stays one.
template <class T>
constexpr T clamp(T a, T lo, T hi) {
    return a < lo ? lo : (a > hi ? hi : a);
}

template <class T>
constexpr bool is_finite(T a) {
    return a - a == T(0);
}

/// The larger of two magnitudes. A NaN counts as the largest, so that no comparison loses it.
template <class T>
constexpr T worse(T most, T a) {
    if (a != a) return Numbers<T>::infinity;
    return a > most ? a : most;
}

}  // namespace islet::lcp
