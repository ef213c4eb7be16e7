// clang's own headers of intrinsics ask for these.
#pragma once
#include <stddef.h>
extern "C" {
void* malloc(size_t);
void free(void*);
}
