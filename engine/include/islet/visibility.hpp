// Which names a shared library of Islet shows: what the public headers declare, but for the engine's own (islet::detail).
#pragma once

#if defined(ISLET_SHARED_LIBRARY) && defined(__GNUC__)  // while the library itself is compiled
/// What is declared between these two is part of a shared library's interface.
#define ISLET_API_BEGIN _Pragma("GCC visibility push(default)")
#define ISLET_API_END _Pragma("GCC visibility pop")
/// Before a function template: so are its instantiations, which GCC forgets otherwise.
#define ISLET_API [[gnu::visibility("default")]]
/// What is declared between these two, within those above, is not.
#define ISLET_INTERNAL_BEGIN _Pragma("GCC visibility push(hidden)")
#define ISLET_INTERNAL_END _Pragma("GCC visibility pop")
#else
#define ISLET_API_BEGIN
#define ISLET_API_END
#define ISLET_API
#define ISLET_INTERNAL_BEGIN
#define ISLET_INTERNAL_END
#endif
