// I2C, with a display (SSD1306) and an accelerometer (MPU-6050) on it: stub.cpp.
#pragma once

#include <Arduino.h>

struct TwoWire {
    void begin() {}
    void setClock(uint32_t) {}
    void beginTransmission(int address);
    void write(int byte);
    void endTransmission() {}
    void requestFrom(int address, int count);
    int read();
};
extern TwoWire Wire;
