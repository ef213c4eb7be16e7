// As much of Arduino as the sketches use, for a host and for emulators. stub.cpp says what is behind it.
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#if !defined(SKETCH_IN_TREE)
// What some packages define, to the harm of what is included later; the one-file form bears it.
#define abs(x) ((x) > 0 ? (x) : -(x))
#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#define round(x) ((x) >= 0 ? (long)((x) + 0.5) : (long)((x)-0.5))
#define radians(deg) ((deg)*0.017453292519943295)
#define degrees(rad) ((rad)*57.29577951308232)
#define sq(x) ((x) * (x))
#define bit(b) (1UL << (b))
#endif

constexpr int A0 = 0, A1 = 1, A2 = 2;

/// Each call is a millisecond later than the one before.
unsigned long millis();
/// 0 to 1023.
int analogRead(int pin);

struct SerialPort {
    void begin(unsigned long) {}
    void print(const char* text);
    void println(const char* text);
    void println(long number);
    void println(int number) { println(long{number}); }
    void println(uint32_t number) { println(static_cast<long>(number)); }
};
extern SerialPort Serial;

void setup();
void loop();
