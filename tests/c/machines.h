// The scene of machines.c: steps it and writes the world's hash after each of `count` steps. Returns the sum of the events' counts.
#ifndef ISLET_TESTS_C_MACHINES_H
#define ISLET_TESTS_C_MACHINES_H

#include <stdint.h>

#ifdef __cplusplus
extern "C"
#endif
    unsigned
    machines(uint64_t* hashes, unsigned count);

#endif
