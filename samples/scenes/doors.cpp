// One joint at work: doors on hinges, a seesaw, an elevator on a slider.
#include <algorithm>
#include <cmath>
#include <memory>

#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {

Scene make_door() {
    constexpr float half_length = 0.9f, half_width = 0.06f, spacing = 4.5f, right_angle = 0.5f * pi;
    constexpr float spin = 2, friction = 8;                               // rad/s, N m: of the door that coasts
    constexpr float closing_speed = 1, closing_torque = 50, ajar = 1.2f;  // rad/s, N m, rad: of the door that closes itself
    Scene scene;
    scene.name = "door";
    scene.world.gravity = {0, 0};
    scene.steps = 240;
    scene.view = {{-8.2f, -2.6f}, {8, 3}};

    // Three doorways seen from above, hinges on the left.
    constexpr float doorway = 2 * half_length + 0.1f;
    std::vector<SceneShape> posts;
    for (int i = -1; i <= 2; ++i) {
        const float right = spacing * static_cast<float>(i) - 1.05f;
        posts.push_back({make_offset_box(0.5f * (spacing - doorway), 0.1f, {{right - 0.5f * (spacing - doorway), 0}, {}}), {}});
    }
    const std::size_t wall = add_body(scene, {}, std::move(posts));
    ShapeDef oak;
    oak.density = 20;
    const auto add_door = [&](float middle, float angle, float rate, RevoluteJointDef hinge) {
        const Vec2 pivot = {middle - 1, 0};
        const Rot q = make_rot(angle);
        BodyDef def;
        def.type = BodyType::dynamic;
        def.position = pivot + rotate(q, {half_length, 0});
        def.angle = angle;
        def.angular_velocity = rate;
        def.linear_velocity = rate * left_perp(def.position - pivot);
        const std::size_t door = add_body(scene, def, {{make_box(half_length, half_width), oak}});
        hinge.base.frame_a.position = pivot;
        hinge.base.frame_b.position = {-half_length, 0};
        return add_joint(scene, wall, door, hinge);
    };

    RevoluteJointDef struck;  // by a ball: flies open to its limit
    struck.limit = {.enable = true, .lower = -right_angle, .upper = right_angle};
    struck.friction = 3;
    const std::size_t struck_joint = add_door(-spacing, 0, 0, struck);
    RevoluteJointDef coasting;
    coasting.friction = friction;
    const std::size_t coasting_joint = add_door(0, 0, spin, coasting);
    const std::size_t coasting_door = scene.bodies.size() - 1;
    RevoluteJointDef closing;
    closing.limit = {.enable = true, .lower = 0, .upper = right_angle};
    closing.motor = {.enable = true, .speed = -closing_speed, .max_force = closing_torque};
    const std::size_t closing_joint = add_door(spacing, ajar, 0, closing);

    BodyDef ball;
    ball.type = BodyType::dynamic;
    ball.position = {-spacing + 0.4f, -2};
    ball.linear_velocity = {0, 4};
    scene.traced = {add_body(scene, ball, {{Circle{{}, 0.25f}, oak}})};

    struct Seen {
        double widest = 0, half_closed = 0;
    };
    const auto seen = std::make_shared<Seen>();
    scene.after_step = [seen, struck_joint, closing_joint](const Engine& engine, int step) {
        if (step == 0) *seen = {};
        seen->widest = std::max(seen->widest, double(engine.joint_position(struck_joint)));
        if (step + 1 == 40) seen->half_closed = double(engine.joint_speed(closing_joint));
    };
    // Friction takes I w^2 / 2 = torque * angle; each substep may add or spare its own turn.
    const double h = double(scene.dt) / scene.world.solver.substeps;
    scene.check = [=](const Engine& engine) -> std::vector<CheckLine> {
        const BodyState door = engine.body(coasting_door);
        const double inertia = double(door.inertia) + double(door.mass) * double(half_length * half_length);
        const double coast = 0.5 * inertia * double(spin * spin) / double(friction);
        return {
            near_line("the struck door came to rest at its limit (rad)", double(engine.joint_position(struck_joint)), double(right_angle), 0.05),
            at_most("farthest it went (rad)", seen->widest, double(right_angle) + 0.03),
            near_line("angle at which friction stopped the second (rad)", double(engine.joint_position(coasting_joint)), coast,
                      double(spin) * h + 0.01 * coast),
            near_line("the third closes (rad/s)", seen->half_closed, -double(closing_speed), 0.01),
            near_line("and is shut (rad)", double(engine.joint_position(closing_joint)), 0, 0.01),
            near_line("where its motor pushes on (N m)", double(engine.motor_force(closing_joint)), -double(closing_torque), 0.5),
            at_most("farthest a hinge came apart (m)", double(engine.max_joint_error().linear), 0.002),
        };
    };
    return scene;
}

Scene make_seesaw() {
    constexpr int drop_step = 240;
    constexpr float half_length = 3, half_height = 0.1f, pivot = 1, tilt = 15 * pi / 180, half = 0.25f, friction = 6;
    Scene scene = sleepless_scene("seesaw", 540, {{-4.6f, -0.6f}, {4.6f, 3.2f}});
    const std::size_t floor = add_floor(scene, 6);
    scene.bodies[floor].shapes.push_back({polygon_of({{-0.5f, 1}, {0.5f, 1}, {0, 2}}), {}});  // the stand

    ShapeDef plank_wood;
    plank_wood.density = 5;
    const std::size_t plank = add_dynamic(scene, {0, pivot}, make_box(half_length, half_height), plank_wood);
    RevoluteJointDef hinge = hinge_at(scene, floor, plank, {0, pivot});
    hinge.limit = {.enable = true, .lower = -tilt, .upper = tilt};
    hinge.friction = friction;  // boxes stand above the pivot: without it level would be no stable place
    const std::size_t joint = add_joint(scene, floor, plank, hinge);

    const auto box = [](float x, float y, float mass) {
        SceneBody body;
        body.def.type = BodyType::dynamic;
        body.def.position = {x, y};
        ShapeDef material;
        material.density = mass / (4 * half * half);
        body.shapes.push_back({make_box(half, half), material});
        return body;
    };
    // One kilogram at 2.4 m bears up two at 1.2 m; then another kilogram is dropped on the left.
    scene.bodies.push_back(box(-2.4f, pivot + half_height + half, 1));
    scene.bodies.push_back(box(1.2f, pivot + half_height + half, 2));
    scene.extra_bodies = scene.extra_shapes = 1;
    scene.before_step = [box](Engine& engine, int step) {
        if (step == drop_step) engine.create_body(box(-1.6f, 2.2f, 1));
    };

    struct Seen {
        double angle = 0, force = 0;
    };
    const auto seen = std::make_shared<Seen>();
    scene.after_step = [seen, joint](const Engine& engine, int step) {
        if (step + 1 == drop_step) *seen = {double(engine.joint_position(joint)), double(engine.joint_force(joint).y)};
    };
    scene.check = [seen, joint, plank](const Engine& engine) -> std::vector<CheckLine> {
        const double weight = 10 * (double(engine.body(plank).mass) + 3);
        return {
            near_line("angle with 1 kg at 2.4 m against 2 kg at 1.2 m (rad)", seen->angle, 0, 0.01),
            near_line("the hinge bears them all (N)", seen->force, weight, 0.01 * weight),
            near_line("angle with another kilogram on the left, at its limit (rad)", double(engine.joint_position(joint)), double(tilt), 0.01),
            near_line("the hinge bears that too (N)", double(engine.joint_force(joint).y), weight + 10, 0.01 * weight),
            at_most("boxes fallen off", double(count_outside(engine, {{-3.2f, 0.4f}, {3.2f, 4}})), 0),
            at_most("the hinge came apart (m)", double(engine.max_joint_error().linear), 0.002),
        };
    };
    return scene;
}

Scene make_elevator() {
    constexpr int up_step = 60, riding_step = 180, waiting_step = 380, down_step = 400;
    constexpr float rise = 6, up_speed = 2, down_speed = 1.5f, strength = 1500;  // m, m/s, N
    constexpr float half_width = 1.2f, half_height = 1.2f, wall = 0.08f;
    Scene scene = sleepless_scene("elevator", 720, {{-7.5f, -0.8f}, {7.5f, 9.4f}});
    add_floor(scene, 8);
    // Two storeys to go to, and the shaft's back.
    scene.bodies[0].shapes.push_back({make_offset_box(2.5f, 0.1f, {{4.2f, rise + 0.9f}, {}}), {}});
    scene.bodies[0].shapes.push_back({make_offset_box(2.5f, 0.1f, {{-4.2f, rise + 0.9f}, {}}), {}});

    ShapeDef steel;
    steel.density = 20;
    BodyDef def;
    def.type = BodyType::dynamic;
    def.position = {0, half_height + 2 * wall};
    std::vector<SceneShape> walls;
    for (const float side : {-1.0f, 1.0f}) {
        walls.push_back({make_offset_box(half_width, wall, {{0, side * half_height}, {}}), steel});
        walls.push_back({make_offset_box(wall, half_height, {{side * half_width, 0}, {}}), steel});
    }
    const std::size_t cabin = add_body(scene, def, std::move(walls));
    PrismaticJointDef slider = slider_at(scene, 0, cabin, def.position, {0, 1});
    slider.limit = {.enable = true, .lower = 0, .upper = rise};
    slider.motor = {.enable = true, .speed = 0, .max_force = strength};
    const std::size_t joint = add_joint(scene, 0, cabin, slider);

    const std::size_t first_rider = scene.bodies.size();
    const float floor = def.position.y - half_height + wall;
    add_dynamic(scene, {-0.7f, floor + 0.3f}, make_box(0.3f, 0.3f), steel);
    add_dynamic(scene, {-0.05f, floor + 0.25f}, make_box(0.25f, 0.25f), steel);
    add_dynamic(scene, {0.7f, floor + 0.35f}, make_box(0.35f, 0.35f), steel);
    add_dynamic(scene, {-0.7f, floor + 0.8f}, make_box(0.2f, 0.2f), steel);

    scene.before_step = [joint](Engine& engine, int step) {
        if (step == up_step) engine.set_motor(joint, {.enable = true, .speed = up_speed, .max_force = strength});
        if (step == down_step) engine.set_motor(joint, {.enable = true, .speed = -down_speed, .max_force = strength});
    };
    struct Seen {
        double speed = 0, force = 0, top = 0;
    };
    const auto seen = std::make_shared<Seen>();
    scene.after_step = [seen, joint](const Engine& engine, int step) {
        if (step == 0) *seen = {};
        if (step + 1 == riding_step) {
            seen->speed = double(engine.joint_speed(joint));
            seen->force = double(engine.motor_force(joint));
        }
        if (step + 1 == waiting_step) seen->top = double(engine.joint_position(joint));
    };
    scene.check = [seen, joint, cabin, first_rider](const Engine& engine) -> std::vector<CheckLine> {
        double mass = double(engine.body(cabin).mass);
        std::size_t lost = 0;
        const Vec2 middle = engine.body(cabin).position;
        for (std::size_t i = first_rider; i < engine.body_slots(); ++i) {
            const BodyState rider = engine.body(i);
            mass += double(rider.mass);
            if (abs(rider.position.x - middle.x) > half_width || abs(rider.position.y - middle.y) > half_height) ++lost;
        }
        return {
            near_line("speed on the way up (m/s)", seen->speed, double(up_speed), 0.01),
            near_line("the motor lifts cabin and riders (N)", seen->force, 10 * mass, 0.02 * 10 * mass),
            near_line("height at the top, its upper limit (m)", seen->top, double(rise), 0.01),
            near_line("height in the end, its lower limit (m)", double(engine.joint_position(joint)), 0, 0.01),
            at_most("riders lost", double(lost), 0),
            at_most("off its rail (m)", double(engine.max_joint_error().linear), 0.01),
            at_most("tilted (rad)", double(engine.max_joint_error().angular), 0.005),
        };
    };
    return scene;
}

}  // namespace islet::samples
