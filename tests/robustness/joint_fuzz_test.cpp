// Random calls, good and bad, on joints of every type between bodies that come, go and change: every invariant holds, every number stays finite.
#include "physics/measure.hpp"
#include "random_calls.hpp"
#include "refusal.hpp"
#include "support/island.hpp"
#include "support/joint_world.hpp"
#include "support/random.hpp"

namespace {

using namespace islet;
using namespace islet::test;

class JointFuzzer {
public:
    JointFuzzer(std::uint64_t seed, std::uint32_t lanes)
        : random_(seed), w_(Capacity{.bodies = 16, .shapes = 16, .contacts = 48, .joints = 40}, def(lanes)) {}

    // One hash over everything that could be seen on the way.
    std::uint64_t run(int operations) {
        const std::uint64_t seen = random_calls(w_, operations, [this] { act(); });
        EXPECT_GT(steps_, operations / 10) << "hardly any step was good";
        EXPECT_GT(broken_, 0u) << "no joint broke";
        EXPECT_GT(islands_, operations / 1000) << "hardly any island was large";
        return seen;
    }

    std::uint32_t made(JointType type) const { return made_[static_cast<std::size_t>(type)]; }

private:
    static WorldDef def(std::uint32_t lanes) {
        WorldDef d;
        d.lanes = lanes;
        return d;
    }

    // Numbers as a program with bugs would pass them: mostly sane, now and then not.
    float number(float lo, float hi) {
        if (!random_.one_in(60)) return random_.between(lo, hi);
        const float odd[] = {0, -0.0f, test::nan, inf, -inf, -1, 1e-6f, 1e4f, -1e4f, 1e20f, -1e20f, 3e38f, lo, hi};
        return odd[random_.below(std::size(odd))];
    }
    Vec2 point(float reach) { return {number(-reach, reach), number(-reach, reach)}; }
    BodyId body() {
        if (random_.one_in(50)) return {random_.below(20), random_.below(6)};
        return w_->body_at(random_.below(16));
    }
    JointId joint() {
        if (random_.one_in(30)) return {random_.below(45), random_.below(8)};
        return w_->joint_at(random_.below(40));
    }
    JointFrame frame() { return {point(1), number(-7, 7)}; }

    void create_body() {
        BodyDef d;
        d.type = static_cast<BodyType>((random_.below(5) + 2) / 3);
        d.position = point(4);
        d.angle = number(-4, 4);
        d.linear_velocity = point(3);
        d.enable_sleep = !random_.one_in(8);
        d.awake = !random_.one_in(4);
        d.fixed_rotation = random_.one_in(6);
        const BodyId id = w_->create_body(d);
        if (id && !random_.one_in(4)) w_->create_shape(id, make_box(0.4f, 0.3f), {.density = random_.one_in(9) ? number(0, 1e6f) : 1});
    }

    JointBase base() {
        JointBase b;
        b.body_a = body();
        b.body_b = body();
        b.frame_a = frame();
        b.frame_b = frame();
        b.collide_connected = random_.one_in(3);
        if (random_.one_in(4)) b.break_force = number(0, 500);
        if (random_.one_in(4)) b.break_torque = number(0, 100);
        return b;
    }
    JointSpring spring() { return {random_.one_in(2), number(0, 60), number(0, 2), number(-2, 2)}; }
    JointLimit limit() {
        const float low = number(-2, 2);
        return {random_.one_in(2), low, low + number(0, 9)};
    }
    JointMotor motor() { return {random_.one_in(2), number(-20, 20), number(0, 300)}; }
    float friction() { return random_.one_in(3) ? number(0, 20) : 0; }
    JointRatchet ratchet() { return {random_.one_in(2) ? 0 : number(-2, 2), number(-4, 4)}; }
    float hertz() { return random_.one_in(2) ? number(0, 30) : 0; }

    JointId geared() {
        for (int i = 0; i < 20; ++i) {
            const JointId j = w_->joint_at(random_.below(40));
            if (j && (w_->joint_type(j) == JointType::revolute || w_->joint_type(j) == JointType::prismatic)) return j;
        }
        return joint();
    }

    JointId make(JointType type) {
        switch (type) {
        case JointType::revolute: return w_->create_joint(RevoluteJointDef{base(), spring(), limit(), motor(), friction()});
        case JointType::prismatic: return w_->create_joint(PrismaticJointDef{base(), spring(), limit(), motor(), friction()});
        case JointType::distance: return w_->create_joint(DistanceJointDef{base(), number(0.01f, 4), spring(), limit(), motor()});
        case JointType::weld: return w_->create_joint(WeldJointDef{base(), hertz(), number(0, 2), hertz(), number(0, 2)});
        case JointType::wheel: return w_->create_joint(WheelJointDef{base(), spring(), limit(), motor(), friction()});
        case JointType::motor:
            return w_->create_joint(MotorJointDef{base(), point(5), number(-5, 5), number(0, 300), number(0, 100), hertz(), number(0, 2),
                                                  hertz(), number(0, 2)});
        case JointType::mouse: return w_->create_joint(MouseJointDef{body(), point(5), number(0.1f, 20), number(0, 2), number(0, 1000)});
        case JointType::pulley: return w_->create_joint(PulleyJointDef{base(), point(8), point(8), number(0.1f, 3)});
        case JointType::angle: return w_->create_joint(AngleJointDef{base(), spring(), limit(), motor(), friction(), ratchet()});
        case JointType::gear: break;
        }
        return w_->create_joint(GearJointDef{geared(), geared(), number(-3, 3), random_.one_in(3) ? number(0, 50) : 0});
    }

    void create_joint() {
        // Gears need hinges and sliders, which are rare enough.
        const JointType type = random_.one_in(5) ? JointType::gear : joint_types[random_.below(random_.one_in(2) ? 2 : joint_type_count)];
        if (make(type)) ++made_[static_cast<std::size_t>(type)];
    }

    void change_joint() {
        const JointId j = joint();
        switch (random_.below(17)) {
        case 16: w_->set_ratchet(j, ratchet()); break;
        case 0: w_->set_spring(j, spring()); break;
        case 1: w_->set_limit(j, limit()); break;
        case 2: w_->set_motor(j, motor()); break;
        case 3: w_->set_joint_friction(j, friction()); break;
        case 4: w_->set_joint_length(j, number(0, 4)); break;
        case 5: w_->set_joint_velocity(j, point(5), number(-5, 5)); break;
        case 6: w_->set_joint_strength(j, number(0, 300), number(0, 300)); break;
        case 7: w_->set_target(j, point(5)); break;
        case 8: w_->set_frames(j, frame(), frame()); break;
        case 9: w_->set_collide_connected(j, random_.one_in(2)); break;
        case 10: w_->set_break(j, number(0, 500), number(0, 100)); break;
        case 11: w_->set_user_data(j, random_.bits()); break;
        default: read(j);
        }
    }

    void read(JointId j) {
        if (!w_->is_valid(j)) return;
        const JointError error = w_->joint_error(j);
        EXPECT_TRUE(is_finite(error.linear) && is_finite(error.angular));
        EXPECT_TRUE(is_finite(w_->joint_force(j)) && is_finite(w_->joint_torque(j)));
        EXPECT_TRUE(is_finite(w_->joint_position(j)) && is_finite(w_->joint_speed(j)) && is_finite(w_->motor_force(j)));
        EXPECT_TRUE(is_finite(w_->anchor_a(j)) && is_finite(w_->anchor_b(j)));
    }

    void look_at_an_island() {
        const float times[] = {1.0f / 240, 1.0f / 60, 1e-6f, 1, 0, test::nan};
        const ExportedIsland island(*w_, body(), times[random_.below(std::size(times))]);
        if (island.bytes() == 0) return;
        const char* fault = fault_in(*island);
        EXPECT_EQ(fault, nullptr) << fault;
        islands_ += island->rows.size() > 5 ? 1 : 0;
    }

    void change_body() {
        const BodyId b = body();
        switch (random_.below(12)) {
        case 0: w_->set_transform(b, point(4), number(-4, 4)); break;
        case 1: w_->set_linear_velocity(b, point(10)); break;
        case 2: w_->set_angular_velocity(b, number(-10, 10)); break;
        case 3: w_->apply_force(b, point(50), point(4)); break;
        case 4: w_->apply_angular_impulse(b, number(-5, 5)); break;
        case 5:
        case 6: w_->set_type(b, static_cast<BodyType>(random_.below(3))); break;
        case 7: w_->set_mass(b, {number(0.1f, 10), point(0.5f), number(0, 5)}); break;
        case 8: w_->reset_mass(b); break;
        case 9: w_->set_fixed_rotation(b, random_.one_in(2)); break;
        case 10: w_->enable_sleep(b, !random_.one_in(3)); break;
        default: w_->wake(b);
        }
    }

    void change_world() {
        if (random_.one_in(2)) return w_->set_gravity(random_.one_in(2) ? Vec2{0, -10} : Vec2{});
        SolverDef d;
        d.schedule = random_.one_in(4) ? Schedule::classic : Schedule::soft;
        d.substeps = 1 + random_.below(6);
        d.iterations = 1 + random_.below(3);
        d.relax_iterations = random_.below(3);
        d.joint_hertz = number(1, 200);
        d.joint_damping_ratio = number(0, 5);
        d.omega = number(0.5f, 1.5f);
        d.warm_start = !random_.one_in(4);
        d.joint_trees = static_cast<JointTrees>(random_.below(3));
        d.sweep_order = static_cast<SweepOrder>(random_.below(4));
        d.block_contacts = random_.one_in(4);
        d.shock = random_.one_in(3) ? number(0, max_shock) : 0;
        d.measure_residual = random_.one_in(3);
        d.tolerance = random_.one_in(4) ? number(0, 1e-2f) : 0;
        w_->set_solver(d);
    }

    void step() {
        const float times[] = {1.0f / 60, 1.0f / 60, 1.0f / 60, 1.0f / 60, 1.0f / 240, 1.0f / 20, 1, 1e-6f, 0, test::nan};
        // Now and then long enough for what rests to fall asleep.
        for (int i = random_.one_in(40) ? 60 : 0; i > 0; --i) w_->step(times[random_.below(std::size(times))]);
        const std::uint64_t before = w_->step_count();
        w_->step(times[random_.below(std::size(times))]);
        if (w_->step_count() == before) return;  // refused: the events are of a step before
        ++steps_;
        broken_ += w_->broken_joints().size();
        for (const JointBreakEvent& e : w_->broken_joints()) {
            EXPECT_FALSE(w_->is_valid(e.joint));
            EXPECT_TRUE(w_->is_valid(e.body_b));
            EXPECT_TRUE(is_finite(e.force) && is_finite(e.torque));
        }
    }

    void act() {
        // Pools drift between full and empty.
        const bool crowded = random_.one_in(2);
        switch (random_.below(15)) {
        case 0: create_body(); break;
        case 1: crowded ? w_->destroy_body(body()) : create_body(); break;
        case 2:
        case 3: create_joint(); break;
        case 4: crowded ? w_->destroy_joint(joint()) : create_joint(); break;
        case 5:
        case 6: change_joint(); break;
        case 7:
        case 8: random_.one_in(12) ? change_world() : change_body(); break;
        case 9: look_at_an_island(); break;
        default: step();
        }
    }

    Random random_;
    TestWorld w_;
    std::uint32_t made_[joint_type_count] = {};
    std::size_t broken_ = 0;
    int steps_ = 0, islands_ = 0;
};

class JointFuzz : public testing::TestWithParam<int> {};

TEST_P(JointFuzz, RandomCallsBreakNoInvariantAndGiveTheSameBitsTwice) {
    const auto seed = static_cast<std::uint64_t>(GetParam());
    constexpr int operations = slow_build ? 4000 : 20000;
    JointFuzzer fuzzer(seed, 0);
    const std::uint64_t first = fuzzer.run(operations);
    if (HasFailure()) return;
    for (const JointType type : joint_types) EXPECT_GE(fuzzer.made(type), operations / 4000u) << name_of(type);
    EXPECT_EQ(first, JointFuzzer(seed, seed % 2 == 0 ? 1 : 4).run(operations)) << "lanes change the bits";
}

INSTANTIATE_TEST_SUITE_P(Seeds, JointFuzz, testing::Range(1, 9));

}  // namespace
