// As much of Arduino as the sketches use, for a host and for emulators. stub.cpp says what is behind it.
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

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
