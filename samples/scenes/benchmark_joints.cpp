// The part of the benchmark that joints carry, again with the dimensions that Box2D 3 measures itself with.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "benchmark_doll.hpp"
#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {

Scene make_joint_grid() {
    constexpr std::size_t side = 100, held = 7;
    Scene scene = sleepless_scene("joint_grid", 500, {{-20, -135}, {120, 5}});
    ShapeDef material;
    material.filter = {.category = 2, .mask = ~2u, .group = 0};

    BodyDef def;
    const auto is_held = [](std::size_t column, std::size_t row) {
        return row == 0 && column >= side / 2 - held / 2 && column <= side / 2 + held / 2;
    };
    RevoluteJointDef above, beside;
    above.base.frame_a.position = {0, -0.5f};
    above.base.frame_b.position = {0, 0.5f};
    beside.base.frame_a.position = {0.5f, 0};
    beside.base.frame_b.position = {-0.5f, 0};
    for (std::size_t column = 0; column < side; ++column) {
        for (std::size_t row = 0; row < side; ++row) {
            def.type = is_held(column, row) ? BodyType::static_body : BodyType::dynamic;
            def.position = {static_cast<float>(column), -static_cast<float>(row)};
            const std::size_t body = add_body(scene, def, {{Circle{{}, 0.4f}, material}});
            if (row > 0) add_joint(scene, body - 1, body, above);
            // Box2D also makes the six joints between neighbours that are held, which do nothing. Islet refuses such joints.
            if (column > 0 && !(is_held(column, row) && is_held(column - 1, row))) add_joint(scene, body - side, body, beside);
        }
    }

    // Joints are springs of joint_hertz on their effective mass, here half a disc's. The held discs share all the weight through nine joints, the outer
    // ones carry about twice their share, and the net swings.
    scene.check = [hertz = double(scene.world.solver.joint_hertz)](const Engine& engine) {
        const double disc = double(engine.body(0).mass), omega = 2 * std::numbers::pi * hertz;
        const double share = disc * 10 * double(side * side) / double(held + 2), give = share / (0.5 * disc * omega * omega);
        std::vector<CheckLine> lines = count_lines(engine, side * side, side * side, 0, 2 * side * (side - 1) - (held - 1));
        lines.push_back(at_most("farthest a joint has come apart (m)", double(engine.max_joint_error().linear), 3 * give));
        lines.push_back(at_most("fastest body (m/s)", max_speed(engine), 60));
        return lines;
    };
    return scene;
}

Scene make_tumbler() {
    constexpr int count = 45;
    constexpr float rate = 25 * pi / 180;  // rad/s
    Scene scene;
    scene.name = "tumbler";
    scene.steps = 750;
    scene.view = {{-17, -6}, {17, 26}};
    const std::size_t ground = add_body(scene, {}, {});

    ShapeDef heavy;
    heavy.density = 50;
    BodyDef drum;
    drum.type = BodyType::dynamic;
    drum.position = {0, 10};
    const std::size_t drum_index = add_body(scene, drum,
                                            {{make_offset_box(0.5f, 10, {{10, 0}, {}}), heavy},
                                             {make_offset_box(0.5f, 10, {{-10, 0}, {}}), heavy},
                                             {make_offset_box(10, 0.5f, {{0, 10}, {}}), heavy},
                                             {make_offset_box(10, 0.5f, {{0, -10}, {}}), heavy}});
    RevoluteJointDef axle = hinge_at(scene, ground, drum_index, drum.position);
    axle.motor = {.enable = true, .speed = rate, .max_force = 1e8f};
    const std::size_t joint = add_joint(scene, ground, drum_index, axle);

    const Polygon box = make_box(0.125f, 0.125f);
    for (int row = 0; row < count; ++row) {
        for (int column = 0; column < count; ++column) {
            const Vec2 place = {0.4f * static_cast<float>(column) - 0.2f * count, 0.4f * static_cast<float>(row) - 0.2f * count + 10};
            add_dynamic(scene, place, box);
        }
    }

    scene.check = [joint, angle = double(rate) * double(scene.steps) * double(scene.dt)](const Engine& engine) {
        std::vector<CheckLine> lines = count_lines(engine, 2027, 2029, 8823, 1);
        lines.push_back(near_line("angle of the drum (rad)", double(engine.joint_position(joint)), angle, 0.02));
        lines.push_back(near_line("its speed (rad/s)", double(engine.joint_speed(joint)), double(rate), 0.01 * double(rate)));
        // The walls' outer corners are 14.8 m from the axle.
        lines.push_back(at_most("boxes that got out", double(count_outside(engine, {{-14.9f, -4.9f}, {14.9f, 24.9f}})), 0));
        lines.push_back(at_most("the axle came apart (m)", double(engine.max_joint_error().linear), 0.01));
        lines.push_back(at_most("deepest overlap (m)", engine.max_penetration(), 0.25));
        return lines;
    };
    return scene;
}

Scene make_spinner() {
    constexpr int points = 360, count = 2 * 3038;
    constexpr float radius = 40, rate = 5;  // m, rad/s
    constexpr Vec2 middle = {0, 32};
    Scene scene;
    scene.name = "spinner";
    scene.steps = 500;
    scene.view = {{-42, -10}, {42, 74}};

    // Clockwise: the inside is on the right.
    Chain ring;
    ring.loop = true;
    const Rot turn = make_rot(-2 * pi / points);
    Vec2 spoke = {radius, 0};
    for (int i = 0; i < points; ++i) {
        ring.points.push_back(spoke + middle);
        spoke = rotate(turn, spoke);
    }
    ShapeDef slippery;
    slippery.friction = 0.1f;
    const std::size_t ground = add_body(scene, {}, {{ring, slippery}});

    BodyDef def;
    def.type = BodyType::dynamic;
    def.position = {0, 12};
    def.enable_sleep = false;
    ShapeDef smooth;
    smooth.friction = 0;
    const std::size_t paddle = add_body(scene, def, {{make_rounded_box(0.4f, 20, 0.2f), smooth}});
    RevoluteJointDef axle = hinge_at(scene, ground, paddle, def.position);
    axle.motor = {.enable = true, .speed = rate, .max_force = 1e30f};
    const std::size_t joint = add_joint(scene, ground, paddle, axle);

    ShapeDef light;
    light.friction = 0.1f;
    light.restitution = 0.1f;
    light.density = 0.25f;
    const SceneGeometry kinds[] = {Capsule{{-0.25f, 0}, {0.25f, 0}, 0.25f}, Circle{{}, 0.35f}, make_box(0.35f, 0.35f)};
    constexpr int row = 92;  // bodies from x = -23 to 22.5
    for (int i = 0; i < count; ++i)
        add_dynamic(scene, {-23 + 0.5f * static_cast<float>(i % row), 2 + 0.5f * static_cast<float>(i / row)}, kinds[i % 3], light);

    scene.check = [joint, paddle, angle = double(rate) * double(scene.steps) * double(scene.dt), middle](const Engine& engine) {
        std::size_t lost = 0;
        for (std::size_t i = paddle + 1; i < engine.body_slots(); ++i) {
            if (distance(engine.body(i).position, middle) > radius) ++lost;
        }
        std::vector<CheckLine> lines = count_lines(engine, 6078, 6437, 23049, 1);
        lines.push_back(near_line("angle of the paddle (rad)", double(engine.joint_position(joint)), angle, 0.1));
        lines.push_back(near_line("its speed (rad/s)", double(engine.joint_speed(joint)), double(rate), 0.05));
        // The paddle's tip, at 100 m/s, passes 0.2 m beyond the ring's lowest point: what it catches there is pressed through.
        lines.push_back(at_most("bodies that got through the ring, of 6076", double(lost), 0.01 * count));
        lines.push_back(at_most("the axle came apart (m)", double(engine.max_joint_error().linear), 0.05));
        return lines;
    };
    return scene;
}

namespace {

/// The columns of ragdolls that come down on the rain's five floors.
struct Rain {
    static constexpr std::size_t floors = 5, columns = 40, group = 5;
    static constexpr int cells = 500;                            // of a floor
    static constexpr float cell = 0.5f, storey = 45, drop = 40;  // m

    std::vector<Placed> dolls[floors][columns];
    std::size_t made = 0, next = 0;  // columns made so far; the one to be made anew after that

    static std::vector<Prefab> group_at(std::size_t floor, std::size_t column) {
        constexpr float span = cell * cells, pitch = span / columns;
        Vec2 place = {-0.5f * span + pitch * (static_cast<float>(column) + 0.5f), drop + storey * static_cast<float>(floor)};
        std::vector<Prefab> dolls;
        for (std::size_t i = 0; i < group; ++i) {
            dolls.push_back(make_benchmark_doll({.position = place, .group = static_cast<int>(i) + 1}));
            place.x += 0.5f;
        }
        return dolls;
    }

    void make(Engine& engine, std::size_t column) {
        for (std::size_t floor = 0; floor < floors; ++floor) {
            dolls[floor][column].clear();
            for (const Prefab& doll : group_at(floor, column)) dolls[floor][column].push_back(create_prefab(engine, doll));
        }
    }

    void destroy(Engine& engine, std::size_t column) {
        for (std::size_t floor = 0; floor < floors; ++floor) {
            for (const Placed& doll : dolls[floor][column]) {
                for (std::size_t i = 0; i < bone_count; ++i) engine.destroy_body(doll.first_body + i);
            }
        }
    }

    void advance(Engine& engine) {
        if (made < columns) {
            make(engine, made++);
        } else {
            destroy(engine, next);
            make(engine, next);
            next = (next + 1) % columns;
        }
    }
};

}  // namespace

Scene make_rain() {
    constexpr int interval = 8;  // steps between columns
    Scene scene;
    scene.name = "rain";
    scene.steps = 1000;
    scene.view = {{-126, -6}, {126, 228}};

    std::vector<SceneShape> floors;
    const Polygon box = make_box(0.5f * Rain::cell, 0.5f * Rain::cell);
    for (std::size_t floor = 0; floor < Rain::floors; ++floor) {
        for (int i = 0; i <= Rain::cells; ++i) {
            const Vec2 place = {Rain::cell * (static_cast<float>(i) - 0.5f * Rain::cells), Rain::storey * static_cast<float>(floor)};
            floors.push_back({transform_polygon({place, {}}, box), {}});
        }
    }
    add_body(scene, {}, std::move(floors));

    // The first column belongs to the scene; step 0 has nothing left to make.
    Rain start;
    std::size_t shapes = 0;
    for (std::size_t floor = 0; floor < Rain::floors; ++floor) {
        for (const Prefab& doll : Rain::group_at(floor, 0)) {
            start.dolls[floor][0].push_back(add_prefab(scene, doll));
            for (const SceneBody& bone : doll.bodies) shapes += bone.shapes.size();
        }
    }
    start.made = 1;
    constexpr std::size_t dolls = Rain::floors * Rain::group;  // of a column
    scene.extra_bodies = static_cast<std::uint32_t>((Rain::columns - 1) * dolls * bone_count);
    scene.extra_joints = static_cast<std::uint32_t>((Rain::columns - 1) * dolls * (bone_count - 1));
    scene.extra_shapes = static_cast<std::uint32_t>((Rain::columns - 1) * shapes);
    scene.before_step = [start, rain = std::make_shared<Rain>()](Engine& engine, int step) {
        if (step == 0)
            *rain = start;
        else if (step % interval == 0)
            rain->advance(engine);
    };

    scene.check = [](const Engine& engine) {
        std::vector<CheckLine> lines = count_lines(engine, 11001, 15505, 20651, 10000);
        lines.push_back(at_most("farthest a joint has come apart (m)", double(engine.max_joint_error().linear), 0.1));
        lines.push_back(at_most("deepest overlap (m)", engine.max_penetration(), 0.25));
        // A fall of 40 m ends at 28 m/s.
        lines.push_back(at_most("fastest bone (m/s)", max_speed(engine), 60));
        return lines;
    };
    return scene;
}

}  // namespace islet::samples
