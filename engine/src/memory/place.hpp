// A placement new without <new>: the engine needs no C++ runtime.
#pragma once

#include <cstddef>

struct IsletPlace {};
inline void* operator new(std::size_t, void* at, IsletPlace) noexcept { return at; }
