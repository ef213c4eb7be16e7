// Random worlds of absurd numbers: sound after each step, and with the same hash on one, four, eight and sixteen lanes.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "support/image.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace {

using namespace islet;
using namespace islet::test;

constexpr Capacity small_room{.bodies = 40, .shapes = 60, .contacts = 160, .joints = 40};

/// Any number from tiny to huge, mostly an ordinary one.
class Numbers : public Random {
public:
    explicit Numbers(std::uint64_t seed) : Random(seed), wildness_(below(4)) {}
    bool is_wild() { return wildness_ != 0 && one_in(wildness_ == 1 ? 30 : wildness_ == 2 ? 8 : 2); }
    /// Between the two; if wild, by powers of ten between the two others.
    float pick(float lo, float hi, float least, float most) { return is_wild() ? std::pow(10.0f, between(std::log10(least), std::log10(most))) : between(lo, hi); }
    float sign() { return one_in(2) ? 1.0f : -1.0f; }
    Vec2 place() { return {between(-6, 6), between(0, 8)}; }

private:
    std::uint32_t wildness_;
};

float mix_little(float a, std::uint32_t, float b, std::uint32_t, void*) { return 0.5f * a * b; }
float mix_none(float, std::uint32_t, float, std::uint32_t, void*) { return 0; }
float mix_much(float a, std::uint32_t, float b, std::uint32_t, void*) { return a + b + 0.3f; }
void speed_up(PreSolve& p, void*) {
    p.tangent_speed = static_cast<float>(p.contact.shape_a.index1 % 3);
    p.enabled = p.contact.shape_b.index1 % 5 != 0;
}

/// Plays a world from its seed. Everything is drawn before it is done, so that worlds of the same seed are done the same to.
class Play {
public:
    Play(std::uint64_t seed, std::uint32_t lanes) : draw_(seed) {
        WorldDef def;
        def.lanes = lanes;
        def.solver = solver();
        def.gravity = {draw_.is_wild() ? draw_.pick(0, 1, 1e-3f, 1e38f) : 0, -draw_.pick(1, 20, 1e-3f, 1e38f)};
        def.max_speed = draw_.pick(100, 400, 1e-2f, 1e6f);
        def.restitution_threshold = draw_.pick(0, 2, 1e-6f, 1e6f);
        world_ = std::make_unique<TestWorld>(small_room, def);
        TestWorld& w = *world_;
        const BodyId ground = w.add(make_box(20, 1), Vec2{0, -1}, surface(), BodyType::static_body);
        bodies_.push_back(ground);
        const Vec2 hills[] = {{10, 2}, {5, 0.5f}, {0, 0.3f}, {-5, 0.6f}, {-10, 2}};
        w->create_chain(ground, hills, false, surface());
        for (std::uint32_t i = 6 + draw_.below(24); i > 0; --i) add_body();
        for (std::uint32_t i = draw_.below(12); i > 0; --i) add_joint();
    }

    World& world() { return **world_; }

    /// Changes something or nothing, and steps.
    void step() {
        while (!draw_.one_in(3)) change();
        const float dt = draw_.one_in(4) ? std::pow(10.0f, draw_.between(-6, 0)) : 1.0f / 60;
        world().step(max(dt, min_time_step));
    }

    const char* fault() {
        const char* broken = world().validate();
        return broken != nullptr ? broken : world_->is_finite() ? nullptr : "a body is nowhere";
    }

private:
    SolverDef solver() {
        SolverDef d;
        if (draw_.one_in(3)) return d;
        d.schedule = draw_.one_in(3) ? Schedule::classic : Schedule::soft;
        d.substeps = 1 + draw_.below(draw_.one_in(8) ? 64 : 6);
        d.iterations = 1 + draw_.below(4);
        d.relax_iterations = draw_.below(3);
        d.contact_hertz = draw_.pick(1, 100, 1e-6f, 1e30f);
        d.contact_damping_ratio = draw_.pick(0, 10, 1e-6f, 1e30f);
        d.contact_push_speed = draw_.pick(0, 10, 1e-6f, 1e38f);
        d.joint_hertz = draw_.pick(1, 100, 1e-6f, 1e30f);
        d.joint_damping_ratio = draw_.pick(0, 10, 1e-6f, 1e30f);
        d.baumgarte = draw_.between(0, 1);
        d.omega = draw_.one_in(2) ? 1.0f : draw_.between(0.05f, 1.99f);
        d.warm_start = !draw_.one_in(6);
        d.joint_trees = static_cast<JointTrees>(draw_.below(3));
        d.sweep_order = draw_.one_in(3) ? static_cast<SweepOrder>(draw_.below(4)) : SweepOrder::colored;
        d.block_contacts = draw_.one_in(5);
        d.shock = draw_.one_in(5) ? draw_.between(0, max_shock) : 0;
        d.measure_residual = draw_.one_in(5);
        d.tolerance = draw_.one_in(5) ? draw_.between(0, 0.1f) : 0;
        return d;
    }

    SurfaceMaterial material() {
        SurfaceMaterial m;
        if (draw_.one_in(2)) m.friction = draw_.pick(0, 1, 1e-9f, 1e9f);
        if (draw_.one_in(3)) m.restitution = draw_.between(0, 1);
        if (draw_.one_in(3)) m.rolling_resistance = draw_.pick(0, 0.3f, 1e-9f, 1e9f);
        if (draw_.one_in(4)) m.tangent_speed = draw_.sign() * draw_.pick(0, 5, 1e-9f, 1e6f);
        return m;
    }

    ShapeDef surface() {
        const SurfaceMaterial m = material();
        ShapeDef d{.friction = m.friction, .restitution = m.restitution, .rolling_resistance = m.rolling_resistance, .tangent_speed = m.tangent_speed};
        d.density = draw_.pick(0.2f, 5, 1e-30f, 1e38f);
        d.hit_events = draw_.one_in(4);
        d.pre_solve = draw_.one_in(6);
        return d;
    }

    void add_body() {
        TestWorld& w = *world_;
        BodyDef def;
        def.type = draw_.one_in(12) ? BodyType::kinematic : BodyType::dynamic;
        def.position = draw_.place();
        def.angle = draw_.between(-4, 4);
        def.linear_velocity = {draw_.sign() * draw_.pick(0, 5, 1e-45f, 1e38f), draw_.sign() * draw_.pick(0, 5, 1e-45f, 1e38f)};
        def.angular_velocity = draw_.sign() * draw_.pick(0, 5, 1e-45f, 1e38f);
        def.linear_damping = draw_.one_in(4) ? draw_.pick(0, 1, 1e-6f, 1e38f) : 0;
        def.fixed_rotation = draw_.one_in(10);
        def.lock_x = draw_.one_in(20);
        const BodyId body = w->create_body(def);
        bodies_.push_back(body);
        for (std::uint32_t i = draw_.one_in(5) ? 2 : 1; i > 0; --i) {
            const float size = draw_.pick(0.2f, 0.8f, 1e-2f, 1e5f), other = draw_.pick(0.2f, 0.8f, 1e-2f, 1e5f);
            const ShapeDef shape = surface();
            const Vec2 at = i > 1 ? Vec2{draw_.sign() * draw_.pick(0, 1, 1e-2f, 1e6f), draw_.between(-1, 1)} : Vec2{0, 0};
            switch (draw_.below(3)) {
            case 0: w->create_shape(body, Circle{at, size}, shape); break;
            case 1: w->create_shape(body, Capsule{at, at + Vec2{other, 0}, size}, shape); break;
            default: w->create_shape(body, make_offset_box(size, other, {at, {}}), shape);
            }
        }
    }

    BodyId some_body() { return bodies_[draw_.below(static_cast<std::uint32_t>(bodies_.size()))]; }

    JointSpring spring() { return {draw_.one_in(2), draw_.pick(0, 10, 1e-9f, 1e38f), draw_.pick(0, 2, 1e-9f, 1e38f), draw_.sign() * draw_.pick(0, 1, 1e-9f, 1e38f)}; }
    JointLimit limit() {
        const float lower = draw_.pick(0, 1, 1e-9f, 1e38f);
        return {draw_.one_in(2), lower, lower + draw_.pick(0, 1, 1e-9f, 1e38f)};
    }
    JointMotor motor() { return {draw_.one_in(2), draw_.sign() * draw_.pick(0, 5, 1e-9f, 1e38f), draw_.pick(0, 100, 1e-9f, 1e38f)}; }

    void add_joint() {
        World& w = world();
        JointBase base;
        base.body_a = some_body();
        base.body_b = some_body();
        base.frame_a = {{draw_.sign() * draw_.pick(0, 1, 1e-6f, 1e7f), draw_.between(-1, 1)}, draw_.between(-3, 3)};
        base.frame_b = {{draw_.between(-1, 1), draw_.sign() * draw_.pick(0, 1, 1e-6f, 1e7f)}, draw_.between(-3, 3)};
        base.collide_connected = draw_.one_in(2);
        const JointSpring s = spring();
        const JointLimit l = limit();
        const JointMotor m = motor();
        const float x = draw_.one_in(2) ? draw_.pick(0, 5, 1e-6f, 1e38f) : 0, y = draw_.pick(0.1f, 3, 1e-2f, 1e6f);
        const Vec2 p = draw_.place(), q = draw_.place();
        JointId made;
        switch (draw_.below(10)) {
        case 0: made = w.create_joint(RevoluteJointDef{base, s, l, m, x}); break;
        case 1: made = w.create_joint(RevoluteJointDef{.base = base}); break;
        case 2: made = w.create_joint(PrismaticJointDef{base, s, l, m, x}); break;
        case 3: made = w.create_joint(DistanceJointDef{base, y, s, l, m}); break;
        case 4: made = w.create_joint(WeldJointDef{base, x, m.max_force, s.hertz, s.damping_ratio}); break;
        case 5: made = w.create_joint(WheelJointDef{base, s, l, m, x}); break;
        case 6: made = w.create_joint(MotorJointDef{base, {m.speed, s.target}, m.speed, m.max_force, x, s.hertz, 1, x, 1}); break;
        case 7: made = w.create_joint(MouseJointDef{base.body_b, p, s.hertz, s.damping_ratio, m.max_force}); break;
        case 8: made = w.create_joint(AngleJointDef{base, s, l, m, x, {draw_.one_in(2) ? 0 : draw_.sign() * draw_.pick(0.002f, 3, 0.001f, 100), p.x}}); break;
        default: made = w.create_joint(PulleyJointDef{base, p, q, min(y, max_ratio)});
        }
        if (!made) return;
        if (joints_.size() >= 2 && draw_.one_in(4)) w.create_joint(GearJointDef{joints_[0], joints_[1], draw_.sign() * draw_.pick(0.1f, 2, 1e-3f, 1e6f), 0});
        joints_.push_back(made);
    }

    void change() {
        TestWorld& w = *world_;
        const BodyId body = some_body();
        std::vector<ShapeId> shapes(4);
        shapes.resize(std::min<std::size_t>(4, w->shapes(body, shapes)));
        const ShapeId shape = shapes.empty() ? ShapeId{} : shapes[draw_.below(static_cast<std::uint32_t>(shapes.size()))];
        const SurfaceMaterial m = material();
        const JointId joint = joints_.empty() ? JointId{} : joints_[draw_.below(static_cast<std::uint32_t>(joints_.size()))];
        const float x = draw_.sign() * draw_.pick(0, 10, 1e-45f, 1e38f), y = draw_.sign() * draw_.pick(0, 10, 1e-45f, 1e38f);
        const JointSpring s = spring();
        const JointLimit l = limit();
        const JointMotor motor_now = motor();
        switch (draw_.below(24)) {
        case 0: w->set_material(shape, m); break;
        case 1: w->set_rolling_resistance(shape, draw_.one_in(2) ? 0 : m.rolling_resistance); break;
        case 2: w->set_tangent_speed(shape, draw_.one_in(2) ? 0 : m.tangent_speed); break;
        case 3: w->set_restitution(shape, draw_.one_in(2) ? 0 : m.restitution); break;
        case 4: w->set_friction(shape, m.friction); break;
        case 5: w->enable_hit_events(shape, draw_.one_in(2)); break;
        case 6: w->enable_pre_solve(shape, draw_.one_in(2)); break;
        case 7: {
            constexpr float (*mixing[])(float, std::uint32_t, float, std::uint32_t, void*) = {nullptr, mix_none, mix_little, mix_much};
            Hooks hooks;
            hooks.mix_friction = mixing[draw_.below(4)];
            hooks.mix_restitution = mixing[draw_.below(4)];
            hooks.pre_solve = draw_.one_in(2) ? speed_up : nullptr;
            w->set_hooks(hooks);
            break;
        }
        case 8: w->set_spring(joint, s); break;
        case 9: w->set_limit(joint, l); break;
        case 10: w->set_motor(joint, motor_now); break;
        case 11: w->set_joint_friction(joint, draw_.one_in(2) ? 0 : std::abs(x)); break;
        case 12: w->set_linear_velocity(body, {x, y}); break;
        case 13: w->set_angular_velocity(body, x); break;
        case 14: w->apply_force(body, {x, y}, draw_.place()); break;
        case 15: w->apply_linear_impulse(body, {x, y}, draw_.place()); break;
        case 16: w->apply_torque(body, x); break;
        case 17: w->set_mass(body, {draw_.pick(0.1f, 10, 1e-12f, 1e30f), {draw_.sign() * draw_.pick(0, 1, 1e-3f, 1e7f), 0}, draw_.pick(0.1f, 10, 1e-15f, 1e30f)}); break;
        case 18: w->set_gravity({draw_.is_wild() ? x : 0, draw_.is_wild() ? y : -10.0f}); break;
        case 19: w->set_solver(solver()); break;
        case 20: w->set_transform(body, draw_.place(), draw_.between(-3, 3)); break;
        case 21: w->set_fixed_rotation(body, draw_.one_in(2)); break;
        case 22: w->set_joint_length(joint, std::abs(x)); break;
        default: w->set_joint_velocity(joint, {x, y}, x);
        }
    }

    Numbers draw_;
    std::unique_ptr<TestWorld> world_;
    std::vector<BodyId> bodies_;
    std::vector<JointId> joints_;
};

constexpr std::uint64_t seeds = 400;
constexpr int steps = 12;

TEST(ExtremeWorlds, AreSoundAfterEveryStepAndCanBeLoaded) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        Play play(seed, 0);
        for (int i = 0; i < steps; ++i) {
            play.step();
            ASSERT_STREQ(play.fault(), nullptr) << "seed " << seed << ", step " << i;
        }
        const Image image = save(play.world());
        TestWorld other(small_room);
        ASSERT_TRUE(other->load(image.bytes())) << "seed " << seed;
    }
}

TEST(ExtremeWorlds, HaveTheSameBitsOnAnyLanes) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        Play one(seed, 1), four(seed, 4), eight(seed, 8);
        for (int i = 0; i < steps; ++i) {
            for (Play* play : {&one, &four, &eight}) play->step();
            const std::uint64_t hash = one.world().hash();
            ASSERT_TRUE(four.world().hash() == hash && eight.world().hash() == hash) << "seed " << seed << ", step " << i;
        }
    }
}

}  // namespace
