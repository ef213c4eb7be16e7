// Decides which functions are copied into their callers.
//
// The compiler decides well for most functions. These macros are for the others: short ones with many callers, and long ones that a hot loop needs inlined. In
// a build for size (-Os), one copy of each is enough.
#pragma once

#include "islet/compiler.hpp"

#if defined(__OPTIMIZE_SIZE__)
/// One copy in a build for size; elsewhere as the compiler likes.
#define ISLET_SHARED ISLET_NEVER_INLINE inline
/// One copy in a build for size; elsewhere one in every caller.
#define ISLET_COPIED ISLET_NEVER_INLINE inline
/// Before a function that is not inline: a copy of its own in a build for size, even if it has one caller. Inlined into a long caller, its variables would push
/// too much to the stack.
#define ISLET_APART ISLET_NEVER_INLINE
#else
#define ISLET_SHARED inline
#define ISLET_COPIED ISLET_ALWAYS_INLINE inline
#define ISLET_APART
#endif

/// Before a named part of a long function that has no other caller: copied into it in every build.
#define ISLET_PART ISLET_ALWAYS_INLINE inline

namespace islet::detail {

/// The loops of the kernels stand once, and ask in each turn for what is known before: a page loads each byte.
#ifdef __wasm__
inline constexpr bool short_loops = true;
#define ISLET_IN_ONE_LOOP ISLET_INLINED_LAMBDA
#else
inline constexpr bool short_loops = false;
#define ISLET_IN_ONE_LOOP
#endif

}  // namespace islet::detail
