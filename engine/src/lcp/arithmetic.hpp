// Arithmetic that the methods share, for float and double.
#pragma once

namespace islet::lcp {

template <class T>
struct Numbers;

template <>
struct Numbers<float> {
    static constexpr float epsilon = __FLT_EPSILON__;  // from 1 to the next number
    static constexpr float smallest = __FLT_MIN__;     // positive and normal
    static constexpr float infinity = __builtin_inff();
    static constexpr float shrink = 0x1p-77f;  // the sum of max_rows products of any two numbers, each times this, does not overflow
};

template <>
struct Numbers<double> {
    static constexpr double epsilon = __DBL_EPSILON__;
    static constexpr double smallest = __DBL_MIN__;
    static constexpr double infinity = __builtin_inf();
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
