// What the C tests share: a check that prints what does not hold, and a count of them.
#ifndef ISLET_TESTS_C_CHECK_H
#define ISLET_TESTS_C_CHECK_H

#include <stdio.h>

static int failures = 0;
static int checks = 0;

#define CHECK(condition)                                                          \
    do {                                                                          \
        ++checks;                                                                 \
        if (!(condition)) {                                                       \
            printf("%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition); \
            ++failures;                                                           \
        }                                                                         \
    } while (0)

static int result(void) {
    printf("%d checks, %d failures\n", checks, failures);
    return failures == 0 ? 0 : 1;
}

#endif
