// Chains of planks: a hanging bridge that bears boxes, and one that breaks.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {
namespace {

constexpr int planks = 24;  // of a bridge
constexpr float plank_half_length = 0.25f, plank_half_height = 0.05f, span = 11.5f;

/// A bridge between two abutments, as bodies and joints of a scene.
struct Bridge {
    std::size_t ground = 0, first_plank = 0, first_joint = 0;  // planks + 1 joints
    static constexpr std::size_t joints = planks + 1;
};

/// 24 planks of half a metre and a kilogram, hinged end to end between two abutments 11.5 m apart whose tops are at y = 0. They start as a V.
Bridge add_bridge(Scene& scene, float break_force) {
    Bridge bridge;
    std::vector<SceneShape> abutments;
    for (const float side : {-1.0f, 1.0f})
        abutments.push_back({make_offset_box(1.5f, 1.5f, {{side * (0.5f * span + 1.5f), -1.5f}, {}}), {}});
    bridge.ground = add_body(scene, {}, std::move(abutments));
    bridge.first_plank = scene.bodies.size();
    bridge.first_joint = scene.joints.size();

    ShapeDef wood;
    wood.density = 20;
    const Polygon plank = make_box(plank_half_length, plank_half_height);
    constexpr float length = 2 * plank_half_length, total = length * planks;
    const Vec2 down = (1 / total) * Vec2{span, -std::sqrt(total * total - span * span)}, up = {down.x, -down.y};
    Vec2 end = {-0.5f * span, 0};
    std::size_t previous = bridge.ground;
    const auto join = [&](std::size_t next) {
        RevoluteJointDef hinge = hinge_at(scene, previous, next, end);
        hinge.base.break_force = break_force;
        add_joint(scene, previous, next, hinge);
        previous = next;
    };
    for (int i = 0; i < planks; ++i) {
        const Vec2 along = i < planks / 2 ? down : up;
        BodyDef def;
        def.type = BodyType::dynamic;
        def.position = end + plank_half_length * along;
        def.angle = atan2(along.y, along.x);
        // Damping lets it come to rest within seconds. It also takes h c = 0.4 % of the weight, as it acts on what gravity adds in a substep of h.
        def.linear_damping = 1;
        def.angular_damping = 4;
        join(add_body(scene, def, {{plank, wood}}));
        end = end + length * along;
    }
    end = {0.5f * span, 0};
    join(bridge.ground);
    return bridge;
}

SceneBody box_at(Vec2 place, float half, float density) {
    SceneBody body;
    body.def.type = BodyType::dynamic;
    body.def.position = place;
    ShapeDef material;
    material.density = density;
    body.shapes.push_back({make_box(half, half), material});
    return body;
}

/// How a chain of equal rods hangs: rod i has the slope w (i + 1/2 - n / 2) / H, w the weight of one; H, the pull along x, is what makes it fit the span.
/// Each rod is longer by `give` times the pull.
struct HangingChain {
    double pull = 0;  // N
    double sag = 0;   // m, of the middle
};

HangingChain hang(double weight, double give) {
    const auto length_at = [give](double pull) { return 2 * double(plank_half_length) + give * pull; };
    const auto width = [&](double pull) {
        const double length = length_at(pull);
        double sum = 0;
        for (int i = 0; i < planks; ++i) {
            const double slope = weight * (i + 0.5 - 0.5 * planks) / pull;
            sum += length / std::sqrt(1 + slope * slope);
        }
        return sum;
    };
    double low = weight, high = 1e6 * weight;
    for (int i = 0; i < 200; ++i) {
        const double middle = std::sqrt(low * high);
        (width(middle) < double(span) ? low : high) = middle;
    }
    HangingChain chain{low, 0};
    for (int i = 0; i < planks / 2; ++i) {
        const double slope = weight * (i + 0.5 - 0.5 * planks) / low;
        chain.sag -= length_at(low) * slope / std::sqrt(1 + slope * slope);
    }
    return chain;
}

/// Height of the hinge in the middle.
double middle_of(const Engine& engine, const Bridge& bridge) {
    const BodyState plank = engine.body(bridge.first_plank + planks / 2);
    return double(plank.position.y) - double(plank_half_length) * double(make_rot(plank.angle).s);
}

/// What hangs on the abutments, N: the first hinge pulls the first plank, the last one pulls the ground.
struct Ends {
    Vec2 left, right;
};

Ends ends_of(const Engine& engine, const Bridge& bridge) {
    const Vec2 last = engine.joint_force(bridge.first_joint + Bridge::joints - 1);
    return {engine.joint_force(bridge.first_joint), {-last.x, -last.y}};
}

}  // namespace

Scene make_bridge() {
    constexpr int loaded_step = 540, boxes = 5;
    constexpr float half = 0.3f, density = 5;
    Scene scene = sleepless_scene("bridge", 1260, {{-8.8f, -3.6f}, {8.8f, 2}});
    const Bridge bridge = add_bridge(scene, 0);
    scene.extra_bodies = scene.extra_shapes = boxes;
    scene.before_step = [](Engine& engine, int step) {
        if (step != loaded_step) return;
        for (int i = 0; i < boxes; ++i) engine.create_body(box_at({0.7f * static_cast<float>(i - boxes / 2), 0.2f}, half, density));
    };

    struct Seen {
        double middle = 0;
        Ends ends;
    };
    const auto seen = std::make_shared<Seen>();
    scene.after_step = [seen, bridge](const Engine& engine, int step) {
        if (step + 1 == loaded_step) *seen = {middle_of(engine, bridge), ends_of(engine, bridge)};
    };
    // A joint between two planks gives way by load / (m w^2), m half a plank's mass, w = 2 pi * joint_hertz. Stiffer engines hang higher, as rigid planks do.
    scene.check = [seen, bridge, omega = 2 * std::numbers::pi * double(scene.world.solver.joint_hertz)](const Engine& engine) {
        const double mass = double(engine.body(bridge.first_plank).mass), weight = 10 * mass;
        const double load = boxes * 10 * double(density) * 4 * double(half * half);
        const HangingChain rigid = hang(weight, 0), chain = hang(weight, 1 / (0.5 * mass * omega * omega));
        const Ends ends = ends_of(engine, bridge);
        std::size_t fallen = 0;
        for (std::size_t i = bridge.first_plank + planks; i < engine.body_slots(); ++i) {
            if (double(engine.body(i).position.y) < middle_of(engine, bridge)) ++fallen;
        }
        return std::vector<CheckLine>{
            {"height of the middle, as a chain hangs (m)", seen->middle, -chain.sag - 0.02, -rigid.sag + 0.02},
            {"pull along x then (N)", -double(seen->ends.left.x), 0.98 * chain.pull, 1.02 * rigid.pull},
            near_line("what the abutments bear then, the planks' weight (N)", double(seen->ends.left.y + seen->ends.right.y),
                      planks * weight, 0.02 * planks * weight),
            near_line("what they bear with the boxes (N)", double(ends.left.y + ends.right.y), planks * weight + load,
                      0.03 * (planks * weight + load)),
            near_line("sum of their pulls along x (N)", double(ends.left.x + ends.right.x), 0, 0.02 * chain.pull),
            at_most("boxes fallen off", double(fallen), 0),
            at_most("farthest a hinge came apart (m)", double(engine.max_joint_error().linear), 0.01),
        };
    };
    return scene;
}

Scene make_breakable_bridge() {
    constexpr int light_step = 360, heavy_step = 720, boxes = 3;
    constexpr float strength = 700;  // N
    constexpr float radius = 0.6f, ball_mass = 60;
    Scene scene = sleepless_scene("breakable_bridge", 960, {{-8.8f, -6.2f}, {8.8f, 2.4f}});
    const Bridge bridge = add_bridge(scene, strength);
    add_static(scene, {0, -6}, make_box(10, 0.2f));
    const std::size_t first_box = scene.bodies.size(), ball = first_box + boxes;
    scene.extra_bodies = scene.extra_shapes = boxes + 1;
    scene.before_step = [](Engine& engine, int step) {
        if (step == light_step) {
            for (int i = 0; i < boxes; ++i) engine.create_body(box_at({0.8f * static_cast<float>(i - 1), -0.9f}, 0.3f, 5));
        }
        if (step == heavy_step) {
            SceneBody heavy;
            heavy.def.type = BodyType::dynamic;
            heavy.def.position = {0.3f, 1.5f};
            ShapeDef iron;
            iron.density = ball_mass / (pi * radius * radius);
            heavy.shapes.push_back({Circle{{}, radius}, iron});
            engine.create_body(heavy);
        }
    };

    struct Seen {
        std::size_t before = 0;  // joints just before the heavy ball came
        double largest = 0;      // N, force of a joint that held
    };
    const auto seen = std::make_shared<Seen>();
    scene.after_step = [seen, bridge](const Engine& engine, int step) {
        if (step == 0) *seen = {};
        if (step + 1 == heavy_step) seen->before = engine.counts().joints;
        for (std::size_t i = 0; i < Bridge::joints; ++i) {
            if (!engine.joint_exists(bridge.first_joint + i)) continue;
            seen->largest = std::max(seen->largest, double(length(engine.joint_force(bridge.first_joint + i))));
        }
    };
    // The planks alone pull with 260 N at their ends, the boxes add half as much; a ball of 60 kg at rest in the middle would make it 1400 N.
    scene.check = [seen, ball](const Engine& engine) -> std::vector<CheckLine> {
        return {
            near_line("joints that bear the three boxes", double(seen->before), double(Bridge::joints), 0),
            {"joints left after the ball of 60 kg", double(engine.counts().joints), 1, double(Bridge::joints) - 1},
            {"largest force that a joint withstood (N)", seen->largest, 0.3 * double(strength), double(strength)},
            near_line("height of the ball, on the floor at -5.8 (m)", double(engine.body(ball).position.y), -5.8 + double(radius), 0.25),
        };
    };
    return scene;
}

}  // namespace islet::samples
