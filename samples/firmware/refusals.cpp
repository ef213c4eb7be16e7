// For a build without all that tools/footprint.sh leaves out at once: each is refused, by name and at no cost to the world, and what is left comes to the same.
// Prints the pyramid's line as firmware.cpp does; fails if anything is not refused. (tests/features asks the same of every name in islet/config.hpp.)
#include <islet/mover.hpp>

#include "board.hpp"
#include "console.hpp"
#include "scenes.hpp"

namespace firmware {
namespace {

using namespace islet;

StaticWorld<scene_capacity> storage;
bool good = true;

/// The call just made must have failed for want of `what`.
void expect_refused(World& world, bool refused, const char* what) {
    const bool named = world.last_error() == Error::feature_cut;
    world.clear_error();
    if (refused && named) return;
    print("not refused: ");
    print(what);
    print("\n");
    good = false;
}

}  // namespace

int run() {
    World& world = storage.create();
    build_pyramid(world);
    const BodyId body = world.create_body({.type = BodyType::dynamic, .position = {0, 100}});
    const BodyId other = world.create_body({.type = BodyType::dynamic, .position = {2, 100}});
    const BodyId ground = world.create_body({});
    const ShapeId box = world.create_shape(body, make_box(1, 1));
    const Vec2 points[] = {{0, 0}, {1, 0}, {2, 0}};
    const JointBase base = {.body_a = body, .body_b = other};
    const std::uint64_t before = world.hash();

    expect_refused(world, !world.create_shape(body, Capsule{{0, 0}, {1, 0}, 1}), "capsules");
    const Vec2 corners[] = {{0, 0}, {1, 0}, {0, 1}};
    expect_refused(world, !world.create_shape(body, make_polygon(compute_hull(corners))), "hulls");
    expect_refused(world, !world.create_shape(body, Segment{{0, 0}, {1, 0}}), "segments");
    expect_refused(world, !world.create_shape(body, ChainSegment{{-1, 0}, {{0, 0}, {1, 0}}, {2, 0}}), "segments of chains");
    expect_refused(world, !world.create_shape(ground, HalfSpace{}), "half-spaces");
    expect_refused(world, world.create_chain(body, points, false) == 0, "chains");
    expect_refused(world, !world.create_shape(body, Circle{{}, 1}, {.restitution = 1}), "restitution");
    expect_refused(world, !world.create_shape(body, Circle{{}, 1}, {.rolling_resistance = 1}), "rolling resistance");
    expect_refused(world, !world.create_shape(body, Circle{{}, 1}, {.tangent_speed = 1}), "tangent speed");
    expect_refused(world, !world.create_shape(body, Circle{{}, 1}, {.sensor = true}), "sensors");
    expect_refused(world, !world.create_shape(body, Circle{{}, 1}, {.hit_events = true}), "hit events");
    expect_refused(world, !world.create_shape(body, Circle{{}, 1}, {.pre_solve = true}), "the pre_solve hook");
    expect_refused(world, !world.create_shape(body, Circle{{}, 1}, {.one_way = {0, 1}}), "one-way shapes");
    world.set_one_way(box, {0, 1});
    expect_refused(world, world.one_way(box) == Vec2{}, "set_one_way");
    world.set_hooks({.filter = [](ShapeId, ShapeId, void*) { return true; }});
    expect_refused(world, world.hooks() == Hooks{}, "hooks");
    expect_refused(world, !world.create_body({.type = BodyType::dynamic, .bullet = true}), "bullets");
    world.set_bullet(body, true);
    expect_refused(world, !world.is_bullet(body), "set_bullet");
    expect_refused(world, !world.create_body({.type = BodyType::dynamic, .enabled = false}), "a disabled body");
    world.set_enabled(body, false);
    expect_refused(world, world.is_enabled(body), "set_enabled");
    world.set_solver({.block_contacts = true});
    expect_refused(world, !world.solver().block_contacts, "tuning");
    world.set_clock([](void*) { return std::uint64_t{0}; }, nullptr);
    expect_refused(world, true, "a clock");
    world.set_restitution(box, 1);
    expect_refused(world, world.restitution(box) == 0, "set_restitution");
    world.set_rolling_resistance(box, 1);
    expect_refused(world, world.rolling_resistance(box) == 0, "set_rolling_resistance");
    world.set_tangent_speed(box, 1);
    expect_refused(world, world.tangent_speed(box) == 0, "set_tangent_speed");
    expect_refused(world, !world.cast_ray({0, 200}, {0, -200}), "a ray");
    expect_refused(world, !world.cast_shape_any(make_proxy(Circle{{0, 200}, 1}), {0, -200}), "a shape's cast");
    ShapeId found[4];
    expect_refused(world, world.overlap_point({0, 100}, found) == 0, "an overlap");
    expect_refused(world, !world.closest({0, 100}, 10), "the closest shape");
    MoverState hero;
    expect_refused(world, !step_mover(world, {}, hero, {}, 1.0f / 60), "the mover");
    world.enable_sleep(true);
    expect_refused(world, true, "enable_sleep");
    expect_refused(world, !world.create_body({.type = BodyType::dynamic, .awake = false}), "a body asleep");
    expect_refused(world, !world.create_joint(RevoluteJointDef{.base = base}), "revolute joints");
    expect_refused(world, !world.create_joint(PrismaticJointDef{.base = base}), "prismatic joints");
    expect_refused(world, !world.create_joint(DistanceJointDef{.base = base}), "distance joints");
    expect_refused(world, !world.create_joint(WeldJointDef{.base = base}), "weld joints");
    expect_refused(world, !world.create_joint(WheelJointDef{.base = base}), "wheel joints");
    expect_refused(world, !world.create_joint(MotorJointDef{.base = base}), "motor joints");
    expect_refused(world, !world.create_joint(MouseJointDef{.body = body, .max_force = 1}), "mouse joints");
    expect_refused(world, !world.create_joint(PulleyJointDef{.base = base, .ground_a = {0, 200}, .ground_b = {2, 200}}), "pulley joints");
    expect_refused(world, !world.create_joint(GearJointDef{}), "gear joints");
    expect_refused(world, !world.create_joint(AngleJointDef{.base = base}), "angle joints");
    if (world.hash() != before) {
        print("a refused call changed the world\n");
        good = false;
    }

    World& fresh = storage.create();
    build_pyramid(fresh);
    for (int i = 0; i < 60; ++i) fresh.step(1.0f / 60);
    print("pyramid steps 60 hash ");
    print_hash(fresh.hash());
    print("\n");
    return good ? 0 : 1;
}

}  // namespace firmware
