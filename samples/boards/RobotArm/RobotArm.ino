// A robot arm of three links, whose joints follow three potentiometers as far as their limits let them. Says over the serial port which joint is at a limit.
// Needs a display of 128x64 dots (SSD1306) on the pins of I2C, and potentiometers on A0, A1 and A2.
#include "display.h"

using namespace islet;

static StaticWorldOf<4, 4, 8, 3, 4> storage;
static World* world;
static Display display;
static JointId joints[3];
static uint32_t frames;

static const float limits[] = {1.2f, 1.4f, 1.4f};   // rad, to both sides
static const float strengths[] = {600, 300, 100};   // N m
static const float lengths[] = {2.2f, 1.8f, 1.2f};  // m
static const int pots[] = {A0, A1, A2};
static bool at_limit[3];

void setup() {
    Serial.begin(115200);
    Wire.begin();
    Wire.setClock(400000);
    display.begin();

    world = &storage.create();
    BodyDef foot;
    foot.position = {6.4f, 0.6f};
    BodyId below = world->create_body(foot);
    world->create_shape(below, make_box(0.6f, 0.5f));
    Vec2 at = {0, 0.5f};  // the joint, in the link below it
    float height = 1.1f;  // and in the world, m
    for (int i = 0; i < 3; ++i) {
        BodyDef link;
        link.type = BodyType::dynamic;
        link.position = {6.4f, height};
        link.enable_sleep = false;
        const BodyId body = world->create_body(link);
        world->create_shape(body, Capsule{{0, 0.2f}, {0, lengths[i] - 0.2f}, 0.2f});
        RevoluteJointDef joint;
        joint.base.body_a = below;
        joint.base.body_b = body;
        joint.base.frame_a.position = at;
        joint.limit = {true, -limits[i], limits[i]};
        joint.motor = {true, 0, strengths[i]};
        joints[i] = world->create_joint(joint);
        below = body;
        at = {0, lengths[i]};
        height += lengths[i];
    }
    if (world->last_error() != Error::none) Serial.println(describe(world->last_error()));
}

void loop() {
    const unsigned long start = millis();
    ++frames;
    for (int i = 0; i < 3; ++i) {
        const float wanted = float(analogRead(pots[i]) - 512) / 256;  // rad: -2 to 2, more than the limits allow
        const float angle = world->joint_position(joints[i]);
        const float speed = 4 * (wanted - angle);
        world->set_motor(joints[i], {true, speed > 3 ? 3 : speed < -3 ? -3 : speed, strengths[i]});
        const bool now = angle > limits[i] - 0.02f || angle < -limits[i] + 0.02f;
        if (now != at_limit[i]) {
            Serial.print(now ? "at its limit: joint " : "free again: joint ");
            Serial.println(i);
        }
        at_limit[i] = now;
    }
    world->step(1.0f / 30);
    display.clear();
    world->draw(painter(display));
    display.show();
    while (millis() - start < 33) {}
}
