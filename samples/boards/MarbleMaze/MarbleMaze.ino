// A marble in a maze, seen from above: tilt the board until it rolls into the hole. Needs a display of 128x64 dots (SSD1306) and an accelerometer
// (MPU-6050) on the pins of I2C, the sensor's axes along those of the display.
#include "display.h"

using namespace islet;

static StaticWorldOf<2, 24, 32> storage;
static World* world;
static Display display;
static BodyId marble;
static const Vec2 start = {1.5f, 5};
static uint32_t frames, wins;

/// The acceleration that the sensor feels, m/s^2, from registers 0x3b to 0x3e: two numbers of 16 bits, 16384 for the acceleration of gravity.
static Vec2 tilt() {
    Wire.beginTransmission(0x68);
    Wire.write(uint8_t(0x3b));
    Wire.endTransmission();
    Wire.requestFrom(0x68, 4);
    uint8_t bytes[4];
    for (uint8_t& byte : bytes) byte = uint8_t(Wire.read());
    const int16_t x = int16_t(bytes[0] << 8 | bytes[1]), y = int16_t(bytes[2] << 8 | bytes[3]);
    return {float(x) * (10.0f / 16384), float(y) * (10.0f / 16384)};
}

void setup() {
    Serial.begin(115200);
    Wire.begin();
    Wire.setClock(400000);
    display.begin();
    Wire.beginTransmission(0x68);
    Wire.write(uint8_t(0x6b));  // the sensor wakes up
    Wire.write(uint8_t(0));
    Wire.endTransmission();

    WorldDef settings;
    settings.enable_sleep = false;  // gravity turns, and wakes nobody
    world = &storage.create(settings);
    static const Segment walls[] = {
        {{0, 0}, {12.7f, 0}},         {{12.7f, 0}, {12.7f, 6.3f}}, {{12.7f, 6.3f}, {0, 6.3f}},   {{0, 6.3f}, {0, 0}},       // around
        {{3.2f, 6.3f}, {3.2f, 1.6f}}, {{6.4f, 0}, {6.4f, 4.7f}},   {{9.6f, 6.3f}, {9.6f, 1.6f}},                            // across
        {{1.6f, 3}, {3.2f, 3}},       {{4.8f, 4}, {6.4f, 4}},      {{6.4f, 2}, {8, 2}},          {{11.2f, 3}, {12.7f, 3}},  // shelves
    };
    const BodyId maze = world->create_body({});
    for (const Segment& wall : walls) world->create_shape(maze, wall);
    ShapeDef hole;
    hole.sensor = true;
    hole.sensor_events = true;
    world->create_shape(maze, Circle{{11.5f, 5.3f}, 0.5f}, hole);

    BodyDef def;
    def.type = BodyType::dynamic;
    def.position = start;
    def.linear_damping = 0.4f;
    marble = world->create_body(def);
    ShapeDef steel;
    steel.restitution = 0.3f;
    steel.friction = 0.1f;
    steel.sensor_events = true;
    world->create_shape(marble, Circle{{}, 0.4f}, steel);
    if (world->last_error() != Error::none) Serial.println(describe(world->last_error()));
}

void loop() {
    const unsigned long begin = millis();
    ++frames;
    world->set_gravity(tilt());
    world->step(1.0f / 30);
    if (!world->sensor_begin_events().empty()) {
        ++wins;
        Serial.print("in the hole after frames: ");
        Serial.println(frames);
        world->set_transform(marble, start, 0);
        world->set_linear_velocity(marble, {});
    }
    display.clear();
    world->draw(painter(display));
    display.show();
    while (millis() - begin < 33) {}
}
