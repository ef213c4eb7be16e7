// Which C++ is this? Islet is written for C++20 and compiles as C++17 too, the default of the compilers for many boards. Both give the same bits.
//
// With C++17 there is no StaticWorld<Capacity{...}>: use StaticWorldOf. A program and its engine are compiled with the same standard, or the linker does not
// find the functions that take spans (see ISLET_STD_SPAN).
#pragma once

#if (defined(_MSVC_LANG) && _MSVC_LANG < 201703L) || (!defined(_MSVC_LANG) && __cplusplus < 201703L)
#error "Islet needs C++17 or later: compile with -std=c++17 or -std=c++20 (in CMake: target_compile_features(... cxx_std_20))"
#endif

/// 1 with C++20 or later, 0 with C++17.
#if (defined(_MSVC_LANG) && _MSVC_LANG > 201703L) || (!defined(_MSVC_LANG) && __cplusplus > 201703L)
#define ISLET_CPP20 1
#else
#define ISLET_CPP20 0
#endif

/// Whether islet::span is std::span. Define it as 0 to link a program in C++20 with an engine that was compiled as C++17.
#if !defined(ISLET_STD_SPAN)
#define ISLET_STD_SPAN ISLET_CPP20
#endif

/// Inside a struct: two of them, a and b, are equal if `equal`, which must compare every field.
#define ISLET_EQUAL_IF(Type, equal)                                                  \
    friend constexpr bool operator==(const Type& a, const Type& b) { return equal; } \
    friend constexpr bool operator!=(const Type& a, const Type& b) { return !(a == b); }
