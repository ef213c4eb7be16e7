// A world that uses every feature of islet/config.hpp but the ones named on the command line, and its hash after two seconds, with the
// first error. It is linked once with the whole engine and once with each engine that leaves one feature out (switched_off_test.cpp).
//
//   without NAME...                  with these features switched off from the beginning
//   without --save NAME... FILE      the same, but nothing is done between the steps; the world is saved after a second
//   without --switch NAME... FILE    sleep, continuous collision and seamless floors are switched off after a second; the world is saved then
//   without --load FILE              goes on from there
//   without --crowd                  another world: a crowd of which few move
//   without --apart                  another world: bodies that part
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <islet/islet.hpp>
#include <islet/mover.hpp>

namespace {

using namespace islet;

constexpr int half_steps = 60;
constexpr float dt = 1.0f / 60;

StaticWorld<Capacity{.bodies = 64, .shapes = 110, .contacts = 400, .joints = 24}> storage;

/// The first error of the world.
Error first_error = Error::none;
void note_error(Error error, void*) {
    if (first_error == Error::none) first_error = error;
}

/// The features that the world does not use.
std::vector<std::string> unused;

bool uses(const std::string& feature) { return std::find(unused.begin(), unused.end(), feature) == unused.end(); }
bool uses_joint(const std::string& type) { return uses("joints") && uses(type + "_joints"); }

BodyId add_body(World& world, Vec2 position, Vec2 velocity = {}) {
    return world.create_body({.type = BodyType::dynamic, .position = position, .linear_velocity = velocity});
}

template <class Geometry>
BodyId add(World& world, const Geometry& geometry, Vec2 position, const ShapeDef& def = {}, Vec2 velocity = {}) {
    const BodyId body = add_body(world, position, velocity);
    world.create_shape(body, geometry, def);
    return body;
}

void add_shapes(World& world, BodyId ground) {
    world.create_shape(ground, Circle{{-12, -20}, 20});
    if (uses("polygons")) {
        world.create_shape(world.create_body({.position = {10, -0.5f}}), make_box(12, 0.5f));
        for (int row = 0; row < 3; ++row)
            for (int i = 0; i < 3 - row; ++i)
                add(world, make_box(0.4f, 0.4f), {6 + 0.9f * static_cast<float>(i) + 0.45f * static_cast<float>(row), 0.5f + 0.85f * static_cast<float>(row)});
        if (uses("hulls")) {
            constexpr Vec2 corners[] = {{-0.4f, 0}, {0.4f, 0}, {0, 0.6f}};
            add(world, make_polygon(compute_hull(corners)), {11, 2});
        }
        // Tiles, and a crate that slides over them for two seconds.
        for (int i = 0; i < 30; ++i) world.create_shape(ground, make_offset_box(0.5f, 0.5f, {{40 + static_cast<float>(i), 20}, make_rot(0)}));
        add(world, make_box(0.4f, 0.4f), {40, 20.9f}, {.friction = 0}, {12, 0});
    }
    if (uses("half_spaces")) world.create_shape(ground, HalfSpace{{0, 1}, -3});
    if (uses("segments")) world.create_shape(ground, Segment{{-6, 2}, {-3, 1}});
    if (uses("chains")) world.create_shape(ground, ChainSegment{{-10, 3}, {{-9, 2}, {-6, 2}}, {-5, 3}});
    if (uses("capsules")) add(world, Capsule{{-0.3f, 0}, {0.3f, 0}, 0.2f}, {-5, 3});
    for (int i = 0; i < 4; ++i) add(world, Circle{{}, 0.3f}, {-8.2f + 0.65f * static_cast<float>(i), 3.5f + 0.2f * static_cast<float>(i)});
    if (uses("restitution")) add(world, Circle{{}, 0.3f}, {-12, 3}, {.restitution = 0.7f});
    if (uses("surfaces")) {
        add(world, Circle{{}, 0.3f}, {-4, 4}, {.rolling_resistance = 0.2f, .tangent_speed = 1});
        add(world, Circle{{}, 0.3f}, {12, 0.4f}, {.tangent_speed = 2}, {3, 0});
    }
}

void add_events(World& world, BodyId ground) {
    if (uses("sensors")) world.create_shape(ground, Circle{{-7, 2.5f}, 1}, {.sensor = true});
    if (uses("hits")) add(world, Circle{{}, 0.3f}, {-3.5f, 6}, {.hit_events = true});
    if (uses("one_way")) {
        world.create_shape(ground, Circle{{16, 2}, 1}, {.one_way = {0, 1}});
        add(world, Circle{{}, 0.3f}, {16.2f, 0.5f}, {}, {0, 12});
    }
    if (uses("hooks")) {
        add(world, Circle{{}, 0.3f}, {-11, 4}, {.pre_solve = true, .material = 7});
        world.set_hooks({.filter = [](ShapeId a, ShapeId b, void*) { return a.index1 % 5 != 2 || b.index1 % 7 != 3; },
                         .pre_solve = [](PreSolve& contact, void*) { contact.friction = 0.05f; },
                         .mix_friction = [](float a, std::uint32_t, float b, std::uint32_t m, void*) { return m == 7 ? 0.9f : a * b; }});
    }
}

// Bodies that go farther in a step than the walls before them are thick.
void add_fast(World& world) {
    const BodyId wall = world.create_body({.position = {30, 3}});
    world.create_shape(wall, Circle{{0, 0}, 0.2f});
    world.create_shape(wall, Circle{{0, 0.5f}, 0.2f});
    world.create_shape(wall, Circle{{0, 1}, 0.2f});
    for (int i = 0; i < 3; ++i) add(world, Circle{{}, 0.15f}, {24, 3 + 0.4f * static_cast<float>(i)}, {}, {120 + 40 * static_cast<float>(i), 0});
    add(world, Circle{{}, 0.1f}, {-12, 8}, {}, {0, -90});
    if (uses("continuous") && uses("bullets")) world.set_bullet(add(world, Circle{{}, 0.1f}, {-30, 3.1f}, {}, {350, 0}), true);
}

void add_joints(World& world, BodyId ground) {
    std::uint32_t places = 0;
    const auto pair = [&] {
        const Vec2 at = {-30 - 3 * static_cast<float>(places++), 10};
        const BodyId body = add(world, Circle{{}, 0.4f}, at, {}, {1, 0});
        world.set_angular_velocity(body, 2);
        return JointBase{.body_a = ground, .body_b = body, .frame_a = {{at.x - 1, at.y}, 0}, .frame_b = {{-1, 0}, 0}};
    };
    JointId hinge;
    if (uses_joint("revolute")) {
        hinge = world.create_joint(RevoluteJointDef{.base = pair()});
        JointBase next = pair();
        next.body_a = next.body_b;  // a chain of two, which is solved as a tree
        next.body_b = add(world, Circle{{}, 0.4f}, {-36, 10});
        next.frame_a = {{0, 0}, 0};
        world.create_joint(RevoluteJointDef{.base = next});
    }
    if (uses_joint("revolute") && uses("exact_angles")) world.create_joint(RevoluteJointDef{.base = pair(), .limit = {true, -1, 1}});
    if (uses_joint("prismatic")) world.create_joint(PrismaticJointDef{.base = pair(), .limit = {true, -1, 1}});
    if (uses_joint("distance")) world.create_joint(DistanceJointDef{.base = pair(), .length = 1.5f, .spring = {true, 2, 0.3f}});
    if (uses_joint("weld")) world.create_joint(WeldJointDef{.base = pair(), .angular_hertz = 3});
    if (uses_joint("wheel")) world.create_joint(WheelJointDef{.base = pair()});
    if (uses_joint("motor")) world.create_joint(MotorJointDef{.base = pair(), .linear_velocity = {1, 0}, .max_force = 20, .max_torque = 3});
    if (uses_joint("mouse")) world.create_joint(MouseJointDef{.body = add(world, Circle{{}, 0.4f}, {-20, 9}), .target = {-20, 10}, .max_force = 50});
    if (uses_joint("angle")) world.create_joint(AngleJointDef{.base = pair(), .friction = 1});
    if (uses_joint("pulley")) {
        JointBase base = pair();
        base.body_a = add(world, Circle{{}, 0.5f}, {-90, 10});
        base.frame_a = base.frame_b = {};
        world.create_joint(PulleyJointDef{.base = base, .ground_a = {-90, 14}, .ground_b = {-84, 14}});
    }
    if (uses_joint("gear") && uses_joint("revolute")) {
        const JointId other = world.create_joint(RevoluteJointDef{.base = pair()});
        world.create_joint(GearJointDef{.joint1 = hinge, .joint2 = other, .ratio = 2});
    }
}

// A crowd at rest in layers as games have them (crates meet all, debris meets what has the ground's category alone), of which a few are pushed now and then:
// too few for the whole crowd to be sorted. Far away floats ground that moves. Prints the world's hash.
int run_crowd() {
    static StaticWorld<Capacity{.bodies = 401, .shapes = 401, .contacts = 2000}> room;
    World& world = room.create({.gravity = {0, 0}, .enable_sleep = false, .error_hook = note_error});
    constexpr Filter ground = {1, 7, 0}, crate = {2, 3, 0}, debris = {4, 1, 0};
    add(world, Circle{{}, 0.3f}, {-100, 0}, {.filter = ground});
    BodyId all[400];
    for (int i = 0; i < 400; ++i) {
        const bool stands = i % 3 == 1;
        const Vec2 at = {0.8f * static_cast<float>(i % 20), 0.8f * static_cast<float>(i / 20)};
        all[i] = world.create_body({.type = stands ? BodyType::static_body : BodyType::dynamic, .position = at, .linear_damping = 20});
        world.create_shape(all[i], Circle{{}, 0.3f}, {.filter = stands ? ground : i % 2 == 0 ? crate : debris});
    }
    for (int step = 0; step < 400; ++step) {
        if (step % 20 == 0)
            for (int i = 0; i < 6; ++i)
                world.set_linear_velocity(all[(7 + 3 * step + 67 * i) % 400], {static_cast<float>(step % 9) - 4, i % 2 == 0 ? 9.0f : -9.0f});
        world.step(dt);
    }
    std::printf("%016llx %s\n", static_cast<unsigned long long>(world.hash()), describe(first_error));
    return 0;
}

// Pairs of balls and of boxes that part while their fat boxes still meet, after a hook or a one-way shape has taken the points of their contact away; and
// boxes, balls and capsules side by side whose shapes are up to 1000 km from where their bodies are placed, so that their places are rounded by centimetres.
// Prints the sum of all steps' hashes.
int run_apart() {
    static StaticWorld<Capacity{.bodies = 240, .shapes = 240, .contacts = 2000}> room;
    World& world = room.create({.gravity = {0, 0}, .enable_sleep = false, .error_hook = note_error});
    world.set_hooks({.pre_solve = [](PreSolve& contact, void*) { contact.enabled = false; }});
    constexpr int pairs = 30;
    ShapeId first[pairs];
    BodyId bodies[2 * pairs];
    const auto speed = [](int pair) { return 1.0f + 0.4f * static_cast<float>(pair); };
    for (int i = 0; i < pairs; ++i) {
        const Vec2 at = {10 * static_cast<float>(i), 0};
        const bool asks = i % 2 == 0;  // the hook, and bounces
        const float v = asks ? speed(i) : 0;
        bodies[2 * i] = add_body(world, at);
        bodies[2 * i + 1] = add_body(world, at + Vec2{0.66f, 0.66f}, {v, v});
        const ShapeDef def{.restitution = 0.5f, .pre_solve = asks};
        for (const int k : {2 * i + 1, 2 * i})
            first[i] = i % 4 < 2 ? world.create_shape(bodies[k], Circle{{}, 0.5f}, def) : world.create_shape(bodies[k], make_box(0.4f, 0.4f), def);
    }
    for (int i = 0; i < 160; ++i) {
        const float far = 1000.0f * static_cast<float>(1 << i % 11), place = static_cast<float>(i / 16 * 20), turned = 0.3f * static_cast<float>(i % 5);
        const Vec2 center = {i % 2 == 0 ? far : -far, i % 3 == 0 ? far : 0.5f * far};
        const Vec2 at = {place + 1.03f * static_cast<float>(i % 4), 50 + 1.02f * static_cast<float>(i / 4 % 4)};
        const BodyId body = world.create_body({.type = BodyType::dynamic, .position = at - rotate(make_rot(turned), center), .angle = turned});
        if (i % 7 < 3) world.create_shape(body, Circle{center, 0.5f});
        if (i % 7 == 3 || i % 7 == 4) world.create_shape(body, Capsule{center - Vec2{0.25f, 0}, center + Vec2{0.25f, 0}, 0.25f});
        if (i % 7 > 4) world.create_shape(body, make_offset_box(0.36f, 0.36f, {center, make_rot(0)}));
    }
    std::uint64_t sum = 0;
    for (int step = 0; step < 40; ++step) {
        for (int i = 1; i < pairs; i += 2) {
            if (step == 1) world.set_one_way(first[i], {-1, -1});
            if (step == 1) world.set_linear_velocity(bodies[2 * i], {-speed(i), -speed(i)});
            if (step == 1) world.set_linear_velocity(bodies[2 * i + 1], {speed(i), speed(i)});
            if (step == 2) world.set_one_way(first[i], {});
        }
        world.step(dt);
        sum = 31 * sum + world.hash();
    }
    std::printf("%016llx %s\n", static_cast<unsigned long long>(sum), describe(first_error));
    return 0;
}

/// What a program does between two steps.
struct Player {
    MoverState hero{.position = {9, 0.5f}};
    BodyId ball;

    void act(World& world, int step) {
        if (uses("disabling") && (step == 20 || step == 70)) world.set_enabled(ball, step == 70);
        if (uses("queries")) {
            const QueryHit hit = world.cast_ray({-7, 9}, {0, -12});
            if (hit) world.apply_linear_impulse_to_center(world.body(hit.shape), {0.01f, 0});
        }
        if (uses("queries") && uses("mover")) step_mover(world, {}, hero, {.walk = -3}, dt);
    }
};

}  // namespace

int main(int count, char** words) {
    std::string file;
    bool saves = false, switches = false, loads = false;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (word == "--crowd") return run_crowd();
        if (word == "--apart") return run_apart();
        if (word == "--save" || word == "--switch")
            saves = true, switches = word == "--switch";
        else if (word == "--load")
            loads = true;
        else if ((saves || loads) && i + 1 == count)
            file = word;
        else
            unused.push_back(word);
    }
    World& world = storage.create({.error_hook = note_error});
    if (loads) {
        std::ifstream in(file, std::ios::binary);
        const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
        if (!world.load({reinterpret_cast<const std::byte*>(bytes.data()), bytes.size()})) return std::printf("refused: %s\n", describe(first_error)), 1;
        for (int i = 0; i < half_steps; ++i) world.step(dt);
        std::printf("%016llx %s\n", static_cast<unsigned long long>(world.hash()), describe(first_error));
        return 0;
    }
    static std::byte recording[1 << 18];
    if (uses("recorder")) world.start_recording(recording);
    if (uses("profile")) world.set_clock([](void*) { return std::uint64_t{0}; }, nullptr);
    if (uses("tuning")) world.set_solver({.sweep_order = SweepOrder::upward, .block_contacts = true, .measure_residual = true});
    if (!switches) world.enable_sleep(uses("sleep"));
    if (!switches) world.enable_continuous(uses("continuous"));
    if (!switches) world.enable_seamless_floors(uses("seamless_floors"));
    const BodyId ground = world.create_body({});
    add_shapes(world, ground);
    add_events(world, ground);
    add_fast(world);
    if (uses("sleep")) world.create_shape(world.create_body({.type = BodyType::dynamic, .position = {40, 9}, .awake = false}), Circle{{}, 0.3f});
    if (uses("joints")) add_joints(world, ground);
    Player player{.ball = add(world, Circle{{}, 0.25f}, {-6.5f, 6})};
    for (int i = 0; i < 2 * half_steps; ++i) {
        if (saves && i == half_steps) {
            if (switches && !uses("sleep")) world.enable_sleep(false);
            if (switches && !uses("continuous")) world.enable_continuous(false);
            if (switches && !uses("seamless_floors")) world.enable_seamless_floors(false);
            std::vector<std::byte> image(world.snapshot_bytes());
            world.save(image);
            std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(image.data()), static_cast<std::streamsize>(image.size()));
        }
        if (!saves) player.act(world, i);
        world.step(dt);
    }
    std::printf("%016llx %s\n", static_cast<unsigned long long>(world.hash()), describe(first_error));
    return 0;
}
