// A gripper that fetches a box.
#include <algorithm>
#include <cmath>
#include <memory>

#include "build.hpp"
#include "harness/checks.hpp"
#include "prefabs/gripper.hpp"
#include "prefab_scene.hpp"
#include "scenes.hpp"

namespace islet::samples {
namespace {

/// The next speed of an axis that goes to `target`: at most 0.9 m/s, slower the nearer it is, and with at most 3 m/s^2 when it starts.
float approach(float target, float position, float speed) {
    constexpr float gain = 3, fastest = 0.9f, change = 3.0f / 60;
    return clamp(clamp(gain * (target - position), -fastest, fastest), speed - change, speed + change);
}

/// What the gripper is told to do from a step on.
struct Task {
    int step;
    float travel, lift;  // m, where to
    bool close;
};

}  // namespace

Scene make_gripper_scene() {
    constexpr float carry = 2, height = 1.1f, half = 0.3f, pedestal = 0.4f;  // m
    Scene scene;
    scene.name = "gripper";
    scene.steps = 1080;
    scene.view = {{-3, -0.6f}, {3, 3.4f}};
    add_floor(scene, 4);
    for (const float x : {-0.5f * carry, 0.5f * carry}) add_static(scene, {x, 0.5f * pedestal}, make_box(0.5f, 0.5f * pedestal));
    const GripperDef def = {.rail = {0, 3}, .rail_length = 5};
    const Placed gripper = add_prefab(scene, prefab_of(def));
    const auto part = [&](GripperPart which) { return gripper.first_body + static_cast<std::size_t>(which); };
    const auto axis = [&](GripperAxis which) { return gripper.first_joint + static_cast<std::size_t>(which); };
    const std::size_t palm = part(GripperPart::palm), travel = axis(GripperAxis::travel), lift = axis(GripperAxis::lift);
    const std::size_t box = add_dynamic(scene, {-0.5f * carry, pedestal + half}, make_box(half, half), {.friction = 0.5f, .density = 10});
    scene.traced = {box};

    // Down until the fingers' tips, which are 0.8 m under the palm, which starts 0.5 m under the rail, are 0.1 m above the pedestal.
    const float down = pedestal + 0.1f + 0.8f - (3 - 0.5f);
    const Task tasks[] = {
        {0, -0.5f * carry, 0, false},
        {120, -0.5f * carry, down, false},
        {270, -0.5f * carry, down, true},
        {330, -0.5f * carry, down + height, true},
        {480, 0.5f * carry, down + height, true},
        {690, 0.5f * carry, down, true},
        {870, 0.5f * carry, down, false},
        {930, 0.5f * carry, 0, false},
    };
    constexpr int gripped = 330, let_go = 870;

    struct Seen {
        Vec2 held;  // the box seen from the palm, when it is gripped
        double slip = 0, highest = 0, acceleration = 0, turn = 0;
        float speed = 0;
    };
    const auto seen = std::make_shared<Seen>();
    scene.before_step = [=, list = std::vector<Task>(std::begin(tasks), std::end(tasks))](Engine& engine, int step) {
        Task task = list[0];
        for (const Task& next : list) task = next.step <= step ? next : task;
        command(engine, gripper, def,
                {.travel = approach(task.travel, engine.joint_position(travel), engine.joint_speed(travel)),
                 .lift = approach(task.lift, engine.joint_position(lift), engine.joint_speed(lift)),
                 .close = task.close});
    };
    scene.after_step = [=](const Engine& engine, int step) {
        if (step == 0) *seen = {};
        const Vec2 place = engine.body(box).position - engine.body(palm).position;
        if (step == gripped) seen->held = place;
        if (step >= gripped && step < let_go) {
            seen->slip = std::max(seen->slip, double(distance(place, seen->held)));
            seen->turn = std::max(seen->turn, std::abs(double(engine.body(box).angle)));
        }
        seen->highest = std::max(seen->highest, double(engine.body(box).position.y));
    };
    scene.check = [=](const Engine& engine) -> std::vector<CheckLine> {
        const BodyState now = engine.body(box);
        // Two fingers of friction sqrt(1 * 0.5) and 100 N each hold 141 N by friction; the box weighs 36 N.
        const double hold = 2 * double(def.grip) * std::sqrt(double(def.friction) * 0.5) / (10 * double(now.mass));
        return {
            {"what friction holds over the box's weight", hold, 2, 10},
            {"the box was lifted to (m)", seen->highest, double(pedestal + half) + 0.95 * double(height),
             double(pedestal + half + height) + 0.1},
            at_most("the box slipped in the fingers (m)", seen->slip, 0.01),
            at_most("it turned while it was carried (rad)", seen->turn, 0.02),
            near_line("it was carried to the right by (m)", double(now.position.x) + 0.5 * double(carry), double(carry), 0.02),
            near_line("it stands at height (m)", double(now.position.y), double(pedestal + half), 0.01),
            at_most("it moves (m/s)", double(length(now.linear_velocity)), 0.01),
            at_most("a joint came apart (m)", double(engine.max_joint_error().linear), 0.01),
        };
    };
    return scene;
}

}  // namespace islet::samples
