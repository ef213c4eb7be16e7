// The names that a shared library of Islet exports: those that the public headers declare, except those in islet::detail.
#pragma once

#if defined(ISLET_SHARED_LIBRARY) && defined(__GNUC__)  // while the library itself is compiled
/// A shared library exports what is declared between these two.
#define ISLET_API_BEGIN _Pragma("GCC visibility push(default)")
#define ISLET_API_END _Pragma("GCC visibility pop")
/// Stands before a function template, so that GCC exports its instantiations too.
#define ISLET_API [[gnu::visibility("default")]]
/// A shared library does not export what is declared between these two, inside the pair above.
#define ISLET_INTERNAL_BEGIN _Pragma("GCC visibility push(hidden)")
#define ISLET_INTERNAL_END _Pragma("GCC visibility pop")
#else
#define ISLET_API_BEGIN
#define ISLET_API_END
#define ISLET_API
#define ISLET_INTERNAL_BEGIN
#define ISLET_INTERNAL_END
#endif
