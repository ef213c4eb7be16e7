// Twelve balls in a box that turns over every five seconds. Needs a display of 128x64 dots (SSD1306) on the pins of I2C.
#include "display.h"

using namespace islet;

// Room for the box and 12 balls. All of it is static: the compiler's report of memory includes the world.
static StaticWorldOf<13, 16, 64, 0, 8> storage;
static World* world;
static Display display;
static uint32_t frames;

void setup() {
    Serial.begin(115200);
    Wire.begin();
    Wire.setClock(400000);
    display.begin();

    WorldDef settings;
    settings.enable_sleep = false;  // gravity turns, and wakes nobody
    world = &storage.create(settings);
    static const Vec2 inside[] = {{12.7f, 0}, {0, 0}, {0, 6.3f}, {12.7f, 6.3f}};
    ShapeDef wall;
    world->create_chain(world->create_body({}), inside, true, wall);
    for (int i = 0; i < 12; ++i) {
        BodyDef ball;
        ball.type = BodyType::dynamic;
        ball.position = {1.25f + 2 * float(i % 6), i < 6 ? 2.0f : 4.0f};
        ball.linear_velocity = {float(i % 5) - 2, 0};
        ShapeDef rubber;
        rubber.restitution = 0.7f;
        world->create_shape(world->create_body(ball), Circle{{}, i % 3 == 0 ? 0.75f : i % 3 == 1 ? 0.5f : 0.4f}, rubber);
    }
    if (world->last_error() != Error::none) Serial.println(describe(world->last_error()));
}

void loop() {
    const unsigned long start = millis();
    if (++frames % 150 == 0) world->set_gravity(-world->gravity());
    world->step(1.0f / 30);
    display.clear();
    world->draw(painter(display));
    display.show();
    while (millis() - start < 33) {}
}
