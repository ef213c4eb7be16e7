// A board for a sketch: the display on which it draws, and a hand that tilts the board and turns the potentiometers, the same on every machine. Made into one
// file with the sketch, which SKETCH_FILE names. Runs the sketch for SKETCH_FRAMES frames and prints some of them as text, two dots above each other as one
// character. At the end it prints a line as the firmware does, and the hash of all frames:
//
//   Balls steps 300 hash 0123456789abcdef instructions 812345 most 912345
//   dots 0123456789abcdef
//   stack 1234
#include <Arduino.h>
#include <Wire.h>

#include "../../firmware/board.hpp"
#include "../../firmware/console.hpp"

namespace stub {

using firmware::print;

constexpr int width = 128, height = 64;
uint32_t frame;        // of the sketch
unsigned long now_ms;  // each question about the time takes one
int device;            // that is spoken to
bool first, data;      // the first byte of a transmission says what follows: commands or dots
uint8_t dots[width * height / 8];
size_t place;  // of the next byte of dots
uint64_t sum = 0xcbf29ce484222325u;
uint8_t sensor[4];
size_t sensor_place;

// How the board is held from a frame on, in 1/16384 of the acceleration of gravity.
struct Tilt {
    uint32_t frame;
    int16_t x, y;
};
constexpr Tilt tilts[] = {{0, 0, 0},          {15, -6000, -8000}, {60, 9000, -6000},  {105, -5000, 9000}, {150, 9000, 7000},
                          {200, 5000, -9000}, {245, 9000, -6000}, {280, -5000, 9000}, {330, 5000, 9000},  {380, 0, 0}};

void feel() {
    const Tilt* now = tilts;
    for (const Tilt& tilt : tilts)
        if (tilt.frame <= frame) now = &tilt;
    const uint16_t words[] = {static_cast<uint16_t>(now->x), static_cast<uint16_t>(now->y)};
    for (size_t i = 0; i < 4; ++i) sensor[i] = static_cast<uint8_t>(i % 2 == 0 ? words[i / 2] >> 8 : words[i / 2]);
    sensor_place = 0;
}

// 0 to 1023 and back, in `period` frames.
int swing(uint32_t period) {
    const uint32_t at = (frame + period / 4) % period;
    const uint32_t way = at < period / 2 ? at : period - at;
    return static_cast<int>(way * 2 * 1023 / period);
}

void show() {
    for (int y = 0; y < height; y += 2) {
        char row[width + 2];
        int end = 0;
        for (int x = 0; x < width; ++x) {
            const int two = dots[y / 8 * width + x] >> y % 8 & 3;
            row[x] = " '.:"[two];
            if (two != 0) end = x + 1;
        }
        row[end] = '\n';
        row[end + 1] = 0;
        print(row);
    }
}

}  // namespace stub

SerialPort Serial;
TwoWire Wire;

unsigned long millis() { return stub::now_ms++; }
int analogRead(int pin) { return stub::swing(pin == A0 ? 200 : pin == A1 ? 120 : 80); }

void SerialPort::print(const char* text) { stub::print(text); }
void SerialPort::println(const char* text) {
    print(text);
    print("\n");
}
void SerialPort::println(long number) {
    firmware::print_decimal(static_cast<uint32_t>(number));
    print("\n");
}

void TwoWire::beginTransmission(int address) {
    stub::device = address;
    stub::first = true;
}
void TwoWire::write(int byte) {
    if (stub::device != 0x3c) return;
    if (stub::first) {
        stub::data = byte == 0x40;
        stub::first = false;
        if (!stub::data) stub::place = 0;  // the commands set the window: all of the display
        return;
    }
    if (!stub::data || stub::place == sizeof stub::dots) return;
    stub::dots[stub::place++] = static_cast<uint8_t>(byte);
    stub::sum = (stub::sum ^ static_cast<uint8_t>(byte)) * 0x100000001b3u;  // FNV-1a
}
void TwoWire::requestFrom(int, int) { stub::feel(); }
int TwoWire::read() { return stub::sensor[stub::sensor_place++ % 4]; }

#include SKETCH_FILE

namespace firmware {

int run() {
    setup();
    std::uint64_t taken = 0, most = 0;
    for (stub::frame = 1; stub::frame <= SKETCH_FRAMES; ++stub::frame) {
        const std::uint64_t before = instructions();
        loop();
        const std::uint64_t one = instructions() - before;
        taken += one;
        most = one > most ? one : most;
        if (stub::frame % SKETCH_SHOWN != 0) continue;
        print("frame ");
        print_decimal(stub::frame);
        print("\n");
        stub::show();
    }
    print(SKETCH_NAME " steps ");
    print_decimal(SKETCH_FRAMES);
    print(" hash ");
    print_hash(world->hash());
    print(" instructions ");
    print_decimal(static_cast<std::uint32_t>(taken / SKETCH_FRAMES));
    print(" most ");
    print_decimal(static_cast<std::uint32_t>(most));
    print("\ndots ");
    print_hash(stub::sum);
    print("\nstack ");
    print_decimal(static_cast<std::uint32_t>(stack_used()));
    print("\n");
    return world->last_error() == islet::Error::none ? 0 : 1;
}

}  // namespace firmware
