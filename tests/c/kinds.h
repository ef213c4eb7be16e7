// A small program in C for each kind of thing that a game does (kinds.c). Each returns a checksum of all that it was told, as kinds_test.cpp has it in C++.
#ifndef ISLET_TESTS_C_KINDS_H
#define ISLET_TESTS_C_KINDS_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

uint64_t stack_of_c(void);
uint64_t events_of_c(void);
uint64_t queries_of_c(void);
uint64_t mover_of_c(void);
uint64_t snapshots_of_c(void);
uint64_t recording_of_c(void);
uint64_t tasks_of_c(void);
uint64_t drawing_of_c(void);
uint64_t matrix_of_c(void);

#ifdef __cplusplus
}
#endif

/// A checksum of what was told, word by word (FNV-1a). It begins with 14695981039346656037.
static inline uint64_t with_word(uint64_t sum, uint64_t word) { return (sum ^ word) * 1099511628211u; }

#endif
