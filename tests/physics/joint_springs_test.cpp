// Springs of joints against the exact solution of the damped oscillator.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <vector>

#include "measure.hpp"
#include "support/joint_world.hpp"

namespace islet::test {
namespace {

constexpr double substep = 1.0 / 240;  // s, at the default four substeps

/// x(t) of x'' + 2 z w x' + w^2 x = 0 from x = 1 at rest.
double exact_swing(double w, double z, double t) {
    if (z < 1) {
        const double d = w * std::sqrt(1 - z * z);
        return std::exp(-z * w * t) * (std::cos(d * t) + z * w / d * std::sin(d * t));
    }
    if (z == 1) return std::exp(-w * t) * (1 + w * t);
    const double s = std::sqrt(z * z - 1), r1 = -w * (z - s), r2 = -w * (z + s);
    return (r2 * std::exp(r1 * t) - r1 * std::exp(r2 * t)) / (r2 - r1);
}

struct Case {
    float hertz, damping_ratio;
};
const Case cases[] = {{0.5f, 0}, {0.5f, 0.1f}, {1, 0}, {1, 0.1f}, {1, 0.5f}, {1, 0.7f}, {1, 1}, {1, 2}, {2, 0.05f}, {2, 0.5f}, {2, 1}, {5, 0.3f}, {5, 1}};

/// Largest difference from the exact swing over two periods, of a coordinate that starts at `start` from its target.
template <class Position>
double worst_difference(TestWorld& world, const Case& c, double start, Position&& position) {
    const double w = 2 * std::numbers::pi * double(c.hertz), z = double(c.damping_ratio);
    double worst = 0;
    const int steps = static_cast<int>(120 / double(c.hertz));
    for (int i = 1; i <= steps; ++i) {
        world.step();
        worst = std::fmax(worst, std::abs(position() / start - exact_swing(w, z, i * double(step_time))));
    }
    return worst;
}

// Taking the first force a whole substep at once shifts the swing by half a substep: w h / 2 at most, and a little for the damper.
double allowed(const Case& c) { return 0.55 * 2 * std::numbers::pi * double(c.hertz) * substep + 0.002; }

TEST(JointSpring, OfASliderSwingsAndDecaysAsTheExactSolution) {
    for (const Case& c : cases) {
        SCOPED_TRACE(testing::Message() << c.hertz << " Hz, " << c.damping_ratio);
        TestWorld world(room_for_joints, weightless());
        const BodyId wall = world->create_body({}), body = world.add_circle({1, 0});
        const JointId j = world->create_joint(
            PrismaticJointDef{.base = {.body_a = wall, .body_b = body}, .spring = {.enable = true, .hertz = c.hertz, .damping_ratio = c.damping_ratio}});
        EXPECT_LT(worst_difference(world, c, 1, [&] { return double(world->joint_position(j)); }), allowed(c));
    }
}

TEST(JointSpring, OfAHingeSwingsAndDecaysAsTheExactSolution) {
    for (const Case& c : cases) {
        SCOPED_TRACE(testing::Message() << c.hertz << " Hz, " << c.damping_ratio);
        TestWorld world(room_for_joints, weightless());
        const BodyId wall = world->create_body({}), body = world.add(make_box(1, 0.1f), dynamic_at({0, 0}, 0.5f));
        const JointId j = world->create_joint(
            RevoluteJointDef{.base = {.body_a = wall, .body_b = body}, .spring = {.enable = true, .hertz = c.hertz, .damping_ratio = c.damping_ratio}});
        EXPECT_LT(worst_difference(world, c, 0.5, [&] { return double(world->joint_position(j)); }), allowed(c));
    }
}

TEST(JointSpring, OfADistanceJointSwingsAboutItsLength) {
    // Both bodies move; the frequency is that of the pair, whatever its masses.
    for (const Case& c : cases) {
        SCOPED_TRACE(testing::Message() << c.hertz << " Hz, " << c.damping_ratio);
        TestWorld world(room_for_joints, weightless());
        const BodyId light = world.add_circle({0, 0}, 0.2f), heavy = world.add_circle({3.5f, 0}, 0.5f, dense(7));
        world->create_joint(DistanceJointDef{
            .base = {.body_a = light, .body_b = heavy}, .length = 3, .spring = {.enable = true, .hertz = c.hertz, .damping_ratio = c.damping_ratio}});
        const auto stretch = [&] { return double(world->position(heavy).x) - double(world->position(light).x) - 3; };
        EXPECT_LT(worst_difference(world, c, 0.5, stretch), allowed(c));
    }
}

TEST(JointSpring, OfAWheelCarriesACarByForceOverStiffness) {
    // A body of mass m on a spring of frequency f rests m g / k = g / (2 pi f)^2 below its target, exactly.
    TestWorld world(room_for_joints, sleepless());
    const BodyId wall = world->create_body({}), body = world.add_circle({0, 0});
    const float hertz = 2;
    const JointId j = world->create_joint(
        WheelJointDef{.base = {.body_a = wall, .body_b = body, .frame_a = {{}, pi / 2}}, .spring = {.enable = true, .hertz = hertz, .damping_ratio = 0.7f}});
    world.step(300);
    const double w = 2 * std::numbers::pi * double(hertz);
    EXPECT_NEAR(double(world->joint_position(j)), -g / (w * w), 1e-5);
    EXPECT_NEAR(double(world->joint_force(j).y), double(world->mass(body)) * g, 0.01 * double(world->mass(body)) * g);
}

/// The springs of welds, of a point or of an angle, and those of a motor and of a mouse joint's point.
enum class Soft { weld_point, weld_angle, motor, mouse };
const Soft of_welds[] = {Soft::weld_point, Soft::weld_angle};
const char* const soft_names[] = {"weld, point", "weld, angle", "motor joint", "mouse joint"};
constexpr float no_bound = 1.0e9f;  // N, N m

/// A weld whose point and angle have the same spring.
JointId tie(World& world, const JointBase& base, float hertz, float ratio) {
    return world.create_joint(
        WeldJointDef{.base = base, .linear_hertz = hertz, .linear_damping_ratio = ratio, .angular_hertz = hertz, .angular_damping_ratio = ratio});
}

/// A box that such a spring pulls to another, which is `partner` times as heavy, or to a wall where that is 0.
struct Sprung {
    TestWorld world;
    BodyId wall, box;
    JointId joint;
    Soft soft;

    Sprung(Soft kind, const Case& c, float start, float partner = 0, WorldDef def = weightless()) : world(room_for_joints, def), soft(kind) {
        wall = partner > 0 ? world.add(make_box(0.5f, 0.3f), dynamic_at({0, 0}), dense(partner)) : world->create_body({});
        box = world.add(make_box(0.5f, 0.3f), kind == Soft::weld_angle ? dynamic_at({0, 0}, start) : dynamic_at({start, 0}), dense(1));
        if (kind == Soft::mouse) {
            joint = world->create_joint(
                MouseJointDef{.body = box, .target = {start, 0}, .hertz = c.hertz, .damping_ratio = c.damping_ratio, .max_force = no_bound});
            world->set_target(joint, {0, 0});
        } else if (kind == Soft::motor) {
            joint = world->create_joint(MotorJointDef{
                .base = {.body_a = wall, .body_b = box}, .max_force = no_bound, .linear_hertz = c.hertz, .linear_damping_ratio = c.damping_ratio});
        } else {
            joint = tie(*world, {.body_a = wall, .body_b = box}, c.hertz, c.damping_ratio);
        }
    }
    double error() const {
        return soft == Soft::weld_angle ? double(world->angle(box)) - double(world->angle(wall))
                                        : double(world->position(box).x) - double(world->position(wall).x);
    }
};

struct Swing {
    double hertz, damping_ratio;
};

/// The swing that a series of places shows. Those of a damped oscillator keep x[n + 1] = t x[n] - d x[n - 1], where d = exp(-2 z w dt) and
/// t = 2 exp(-z w dt) cos(w sqrt(1 - z^2) dt); t and d are found by least squares.
Swing swing_of(const std::vector<double>& x, double dt) {
    double aa = 0, ab = 0, bb = 0, ac = 0, bc = 0;
    for (std::size_t n = 1; n + 1 < x.size(); ++n) {
        const double a = x[n], b = x[n - 1], c = x[n + 1];
        aa += a * a, ab += a * b, bb += b * b, ac += a * c, bc += b * c;
    }
    const double det = aa * bb - ab * ab, t = (ac * bb - bc * ab) / det, d = -(bc * aa - ac * ab) / det;
    const std::complex<double> root = 0.5 * (t + std::sqrt(std::complex<double>(t * t - 4 * d)));
    const std::complex<double> s1 = std::log(root) / dt, s2 = std::log(d / root) / dt;  // their product is w^2, their sum -2 z w
    const double w = std::sqrt(std::abs(s1 * s2));
    return {w / (2 * std::numbers::pi), -(s1 + s2).real() / (2 * w)};
}

/// Expects the frequency (Hz) and the damping ratio asked for, of an error that `step` returns after each step.
template <class Step>
void expect_swing(const Case& asked, Step&& step) {
    std::vector<double> places;
    for (int i = 0; i < static_cast<int>(60 / asked.hertz) + 6; ++i) places.push_back(step());  // one period, and some steps more
    const Swing swing = swing_of(places, double(step_time));
    EXPECT_NEAR(swing.hertz, double(asked.hertz), 0.005 * double(asked.hertz));
    EXPECT_NEAR(swing.damping_ratio, double(asked.damping_ratio), 0.013);
}

/// Calls visit(asked, partner) for frequencies, damping ratios and masses of the other body, beside that of the swinging one; 0 is a wall.
template <class Visit>
void for_swings(const char* name, Visit&& visit) {
    for (const float partner : {0.0f, 0.001f, 1.0f, 1000.0f}) {
        for (const float hertz : {0.5f, 1.0f, 2.0f, 5.0f, 10.0f}) {
            for (const float ratio : {0.0f, 0.1f, 0.5f, 1.0f}) {
                SCOPED_TRACE(testing::Message() << name << ", " << hertz << " Hz, " << ratio << ", partner " << partner);
                visit(Case{hertz, ratio}, partner);
            }
        }
    }
}

// What is asked is what comes: a user who sets 5 Hz and 0.1 measures no other swing, whatever the bodies weigh.
TEST(JointSpring, OfAWeldHasTheFrequencyAndTheDampingRatioAskedFor) {
    for (const Soft soft : of_welds) {
        for_swings(soft_names[static_cast<int>(soft)], [&](const Case& asked, float partner) {
            Sprung s(soft, asked, 0.5f, partner);
            expect_swing(asked, [&] {
                s.world.step();
                return s.error();
            });
        });
    }
}

/// A box on a joint with such a spring, half a metre or half a radian from its target, and what holds it: a box `partner` times as heavy, or a wall.
template <class Def>
void expect_swings_of(const char* name, bool turns, Def def) {
    for_swings(name, [&](const Case& asked, float partner) {
        TestWorld world(room_for_joints, weightless());
        const BodyId wall = partner > 0 ? world.add(make_box(0.5f, 0.3f), dynamic_at({0, 0}), dense(partner)) : world->create_body({});
        const BodyId box = world.add(make_box(0.5f, 0.3f), turns ? dynamic_at({0, 0}, 0.5f) : dynamic_at({2.5f, 0}), dense(1));
        Def made = def;
        made.base.body_a = wall;
        made.base.body_b = box;
        made.spring = {.enable = true, .hertz = asked.hertz, .damping_ratio = asked.damping_ratio};
        world->create_joint(made);
        expect_swing(asked, [&] {
            world.step();
            return turns ? double(world->angle(box)) - double(world->angle(wall)) : double(world->position(box).x) - double(world->position(wall).x) - 2;
        });
    });
}

TEST(JointSpring, OfEveryCoordinateHasTheFrequencyAndTheDampingRatioAskedFor) {
    const JointBase apart = {.frame_a = {{2, 0}}};  // of the joints along a line: at its target the box is 2 m away
    expect_swings_of("slider", false, PrismaticJointDef{.base = apart});
    expect_swings_of("wheel", false, WheelJointDef{.base = apart});
    expect_swings_of("distance", false, DistanceJointDef{.length = 2});
    expect_swings_of("hinge", true, RevoluteJointDef{});
    expect_swings_of("angle", true, AngleJointDef{});
}

TEST(JointSpring, OfAWeldSwingsAndDecaysAsTheExactSolution) {
    for (const Soft soft : of_welds) {
        for (const Case& c : cases) {
            SCOPED_TRACE(testing::Message() << soft_names[static_cast<int>(soft)] << ", " << c.hertz << " Hz, " << c.damping_ratio);
            Sprung s(soft, c, 0.5f);
            EXPECT_LT(worst_difference(s.world, c, 0.5, [&] { return s.error(); }), allowed(c));
        }
    }
}

// What hangs on a spring of frequency f rests g / (2 pi f)^2 below its target, at any damping and with any number of substeps and of sweeps.
TEST(JointSpring, OfWeldMotorAndMouseGivesWayByForceOverStiffness) {
    SolverDef solvers[4];
    solvers[1].substeps = 1;
    solvers[2].relax_iterations = 0;
    solvers[3].relax_iterations = 3;
    for (const SolverDef& solver : solvers) {
        for (const Soft soft : {Soft::weld_point, Soft::motor, Soft::mouse}) {
            for (const Case& c : {Case{2, 0.3f}, Case{5, 1}, Case{10, 0.5f}, Case{30, 0.5f}}) {
                SCOPED_TRACE(testing::Message() << soft_names[static_cast<int>(soft)] << ", " << c.hertz << " Hz, " << c.damping_ratio);
                WorldDef def = sleepless();
                def.solver = solver;
                Sprung s(soft, c, 0, 0, def);
                s.world.step(600);
                const double w = 2 * std::numbers::pi * double(c.hertz), sag = g / (w * w);
                EXPECT_NEAR(-double(s.world->position(s.box).y), sag, 0.001 * sag + 1e-6);
                EXPECT_NEAR(double(s.world->joint_force(s.joint).y), g * double(s.world->mass(s.box)), 0.001 * g * double(s.world->mass(s.box)));
            }
        }
    }
}

/// Velocity of a mouse joint's point after a sweep, at C from its target: the implicit spring's, v / (1 + a2) - h w^2 C / (1 + a2).
double mouse_speed(double v, double c, const Case& spring) {
    const double hw = 2 * std::numbers::pi * double(spring.hertz) * substep;
    return (v - hw * hw / substep * c) / (1 + 2 * double(spring.damping_ratio) * hw + hw * hw);
}

// A mouse joint's spring is implicit in the sweep before the bodies move and in the one after. So a hand is calm: its ratio is larger than asked by about h w.
TEST(JointSpring, OfAMouseIsImplicitBeforeAndAfterTheMove) {
    for (const Case& c : {Case{1, 0}, Case{2, 0.5f}, Case{5, 0}, Case{5, 0.7f}, Case{10, 1}, Case{30, 0.1f}}) {
        SCOPED_TRACE(testing::Message() << c.hertz << " Hz, " << c.damping_ratio);
        Sprung s(Soft::mouse, c, 0.5f);
        double x = 0.5, v = 0;
        for (int i = 0; i < 120; ++i) {
            s.world.step();
            for (int k = 0; k < 4; ++k) {
                x += substep * mouse_speed(v, x, c);
                v = mouse_speed(v, x, c);
            }
            EXPECT_NEAR(s.error(), x, 1e-5);
            EXPECT_NEAR(double(s.world->linear_velocity(s.box).x), v, 1e-4);
        }
    }
}

// Wherever a hand grips, the gripped point sets off straight to the target, as fast as a body held at its centre.
TEST(JointSpring, OfAMouseMovesItsPointStraightToTheTarget) {
    for (const Case& c : {Case{1, 0}, Case{5, 0.7f}, Case{10, 1}}) {
        for (const Vec2 grip : {Vec2{0, 0}, Vec2{0.5f, 0.3f}, Vec2{-0.5f, 0.1f}, Vec2{0, 2}}) {
            for (const Vec2 way : {Vec2{0.01f, 0}, Vec2{0, 0.01f}, Vec2{-0.006f, 0.008f}}) {  // m; short, so that the point's arc is straight
                SCOPED_TRACE(testing::Message() << c.hertz << " Hz, grip " << grip.x << " " << grip.y << ", way " << way.x << " " << way.y);
                WorldDef def = weightless();
                def.solver.substeps = 1;
                TestWorld world(room_for_joints, def);
                const BodyId box = world.add(make_box(0.5f, 0.3f), dynamic_at({0, 0}));
                const JointId j =
                    world->create_joint(MouseJointDef{.body = box, .target = grip, .hertz = c.hertz, .damping_ratio = c.damping_ratio, .max_force = no_bound});
                world->set_target(j, grip + way);
                world->step(static_cast<float>(substep));
                const double size = double(length(way)), first = mouse_speed(0, -size, c), speed = mouse_speed(0, -size + substep * first, c);
                const Vec2 v = world->velocity_at(box, world->anchor_b(j));
                EXPECT_NEAR(double(v.x), speed * double(way.x) / size, 0.005 * speed);
                EXPECT_NEAR(double(v.y), speed * double(way.y) / size, 0.005 * speed);
            }
        }
    }
}

double moving_energy(const TestWorld& world, std::span<const BodyId> bodies) {
    double sum = 0;
    for (const BodyId body : bodies) {
        const Vec2 v = world->linear_velocity(body);
        const double turn = double(world->angular_velocity(body));
        sum += 0.5 * (double(world->mass(body)) * double(dot(v, v)) + double(world->rotational_inertia(body)) * turn * turn);
    }
    return sum;
}

/// The most that the bodies' energy of motion comes to, in parts of what they had at first, when no spring was stretched. An undamped spring gives back what
/// it took. The energy of a leapfrog step (symplectic Euler) swings about the true one by a share of h w / 2 (Hairer, Lubich, Wanner, "Geometric Numerical
/// Integration", I.1), so the largest is to the first as 1 + h w / 2 to 1 - h w / 2.
double most_energy(TestWorld& world, std::span<const BodyId> bodies, int steps, float dt = step_time) {
    const double first = moving_energy(world, bodies);
    double most = 0;
    for (int i = 0; i < steps; ++i) {
        world->step(dt);
        most = std::fmax(most, moving_energy(world, bodies) / first);
    }
    return most;
}
double allowed_energy(double hw) { return (1 + 0.5 * hw) / (1 - 0.5 * hw); }

// Two bodies that hang on each other by points and by angle, far from their centres, and tumble. The stiffness of the point is the same in all directions: one
// that goes with K would turn with the bodies, and such a force has no potential.
TEST(JointSpring, OfAWeldMakesNoEnergyWhereBodiesTumble) {
    for (const float hertz : {0.5f, 1.0f}) {
        for (const float ratio : {1.0f, 1000.0f}) {
            for (const float spin : {-4.0f, -1.0f, 2.0f, 5.0f}) {
                SCOPED_TRACE(testing::Message() << hertz << " Hz, masses 1 : " << ratio << ", " << spin << " rad/s");
                TestWorld world(room_for_joints, weightless());
                const BodyId a = world.add(make_box(0.5f, 0.2f), dynamic_at({0, 0}), dense(ratio));
                const BodyId b = world.add(make_box(0.5f, 0.2f), dynamic_at({1, 0}), dense(1));
                tie(*world, {.body_a = a, .body_b = b, .frame_a = {{0.5f, 0.1f}}, .frame_b = {{-0.5f, 0.1f}}}, hertz, 0);
                world->set_linear_velocity(b, {0.3f, -0.8f});
                world->set_angular_velocity(b, spin);
                const BodyId both[] = {a, b};
                // The swing across the arm is the fastest: it moves the point with 1 / m + r^2 / I = 3.9 / m, twice as fast as the mass alone.
                EXPECT_LT(most_energy(world, both, 1800), allowed_energy(2 * 2 * std::numbers::pi * double(hertz) * substep));
            }
        }
    }
}

// A rope of twenty soft welds, and a box that thirty of them hold at its rim, stiff and soft, in long and short substeps.
TEST(JointSpring, OfManyWeldsMakesNoEnergyHoweverStiff) {
    struct Timing {
        float dt;
        std::uint32_t substeps;
        float stiffest_rope;  // Hz: beyond, one sweep does not solve springs that are all coupled, however they are integrated
    };
    for (const Timing t : {Timing{step_time, 4, 60}, Timing{1.0f / 30, 1, 10}, Timing{step_time, 1, 15}}) {
        for (const float hertz : {1.0f, 5.0f, 15.0f, 60.0f}) {
            for (const bool rope : {true, false}) {
                if (rope && hertz > t.stiffest_rope) continue;
                SCOPED_TRACE(testing::Message() << (rope ? "in a row, " : "around a box, ") << hertz << " Hz, " << 1 / t.dt << " steps a second of "
                                                << t.substeps);
                WorldDef def = weightless();
                def.solver.substeps = t.substeps;
                TestWorld world({.bodies = 40, .shapes = 40, .contacts = 64, .joints = 40}, def);
                std::vector<BodyId> bodies;
                for (int i = 0; rope && i < 20; ++i) {
                    bodies.push_back(world.add(make_box(0.5f, 0.1f), dynamic_at({static_cast<float>(i), 0}), {.filter = {.group = -1}}));
                    world->set_linear_velocity(bodies.back(), {0.5f * static_cast<float>(i % 3 - 1), 0.5f * static_cast<float>(i % 5 - 2)});
                    world->set_angular_velocity(bodies.back(), 0.1f * static_cast<float>(i) - 1);
                    if (i == 0) continue;
                    tie(*world, {.body_a = bodies[bodies.size() - 2], .body_b = bodies.back(), .frame_a = {{0.5f, 0}}, .frame_b = {{-0.5f, 0}}}, hertz, 0);
                }
                if (!rope) {
                    const BodyId wall = world->create_body({});
                    bodies.push_back(world.add_box({0, 0}));
                    world->set_linear_velocity(bodies[0], {0.5f, 0.3f});
                    for (int i = 0; i < 30; ++i) {
                        const Rot q = make_rot(2 * pi * static_cast<float>(i) / 30);
                        const Vec2 at = {0.5f * q.c, 0.5f * q.s};
                        tie(*world, {.body_a = wall, .body_b = bodies[0], .frame_a = {at}, .frame_b = {at}}, hertz, 0);
                    }
                }
                EXPECT_LT(most_energy(world, bodies, static_cast<int>(10 / t.dt), t.dt), 1.3) << "it swings up";
            }
        }
    }
}

// A door closer: where the damping ratio z is large, what is left of the error falls by the rate w (z - sqrt(z^2 - 1)), and does not stand still.
TEST(JointSpring, OfALargeDampingRatioClosesSlowlyAtTheRateAskedFor) {
    for (const std::uint32_t substeps : {2u, 4u, 8u}) {
        for (const Case& c : {Case{1, 5}, Case{1, 100}, Case{5, 10}, Case{5, 100}, Case{5, 1000}, Case{10, 30}, Case{30, 100}, Case{30, 1000}}) {
            for (const bool weld : {true, false}) {
                SCOPED_TRACE(testing::Message() << (weld ? "weld, " : "slider, ") << c.hertz << " Hz, " << c.damping_ratio << ", " << substeps << " substeps");
                WorldDef def = weightless();
                def.solver.substeps = substeps;
                TestWorld world(room_for_joints, def);
                const BodyId wall = world->create_body({}), ball = world.add_circle({1, 0});
                if (weld) {
                    tie(*world, {.body_a = wall, .body_b = ball}, c.hertz, c.damping_ratio);
                } else {
                    world->create_joint(PrismaticJointDef{.base = {.body_a = wall, .body_b = ball},
                                                          .spring = {.enable = true, .hertz = c.hertz, .damping_ratio = c.damping_ratio}});
                }
                const double w = 2 * std::numbers::pi * double(c.hertz), z = double(c.damping_ratio), rate = w / (z + std::sqrt(z * z - 1));
                const int steps = std::max(30, static_cast<int>(60 * 0.5 / rate));  // half a second at least, in which most springs lose a third
                world.step(6);
                const double before = double(world->position(ball).x);
                world.step(std::min(steps, 1200));
                const double found = std::log(before / double(world->position(ball).x)) / (std::min(steps, 1200) * double(step_time));
                EXPECT_NEAR(found / rate, 1, 0.03);
            }
        }
    }
}

// A square net of 6 x 6 balls, each tied to its neighbours and across by undamped springs, that is thrown about: soft and stiff, in long and short substeps.
TEST(JointSpring, OfANetMakesNoEnergyHoweverStiff) {
    constexpr int side = 6;
    for (const std::uint32_t substeps : {1u, 2u, 4u, 8u}) {
        for (const float hertz : {1.0f, 5.0f, 15.0f, 60.0f}) {
            if (hertz > 15.0f * static_cast<float>(substeps)) continue;  // one sweep does not solve springs that are all coupled, however they are integrated
            for (const float ratio : {1.0f, 100.0f}) {
                SCOPED_TRACE(testing::Message() << hertz << " Hz, " << substeps << " substeps, one ball in three " << ratio << " times as heavy");
                WorldDef def = weightless();
                def.solver.substeps = substeps;
                TestWorld world({.bodies = side * side, .shapes = side * side, .contacts = 16, .joints = 200}, def);
                std::vector<BodyId> balls;
                for (int i = 0; i < side * side; ++i) {
                    const Vec2 at = {static_cast<float>(i % side), static_cast<float>(i / side)};
                    balls.push_back(world.add_circle(at, 0.2f, {.density = i % 3 == 0 ? ratio : 1, .filter = {.group = -1}}));
                    world->set_linear_velocity(balls.back(), {0.5f * static_cast<float>(i % 3 - 1), 0.5f * static_cast<float>(i % 5 - 2)});
                }
                const auto spring = [&](int from, int to, float length) {
                    world->create_joint(DistanceJointDef{.base = {.body_a = balls[static_cast<std::size_t>(from)], .body_b = balls[static_cast<std::size_t>(to)]},
                                                         .length = length,
                                                         .spring = {.enable = true, .hertz = hertz, .damping_ratio = 0}});
                };
                const float diagonal = std::numbers::sqrt2_v<float>;
                for (int i = 0; i < side * side; ++i) {
                    const bool last = i % side == side - 1, top = i / side == side - 1;
                    if (!last) spring(i, i + 1, 1);
                    if (!top) spring(i, i + side, 1);
                    if (!last && !top) spring(i, i + side + 1, diagonal), spring(i + 1, i + side, diagonal);
                }
                EXPECT_LT(most_energy(world, balls, 600), 1.3) << "it swings up";
            }
        }
    }
}

// What hangs on a slider's or a distance joint's spring rests by force over stiffness below its target, however the step is divided.
TEST(JointSpring, OfSliderAndDistanceGivesWayByForceOverStiffness) {
    SolverDef solvers[5];
    solvers[1].substeps = 1;
    solvers[2].relax_iterations = 0;
    solvers[3].relax_iterations = 3;
    solvers[4].omega = 1.3f;
    for (const SolverDef& solver : solvers) {
        for (const bool line : {true, false}) {
            for (const Case& c : {Case{2, 0.3f}, Case{5, 1}, Case{10, 0.5f}, Case{30, 0.5f}}) {
                SCOPED_TRACE(testing::Message() << (line ? "slider, " : "distance, ") << c.hertz << " Hz, " << c.damping_ratio);
                WorldDef def = sleepless();
                def.solver = solver;
                TestWorld world(room_for_joints, def);
                const BodyId wall = world->create_body({}), ball = world.add_circle({0, -2});
                const JointSpring spring = {.enable = true, .hertz = c.hertz, .damping_ratio = c.damping_ratio};
                const JointId j =
                    line ? world->create_joint(PrismaticJointDef{.base = {.body_a = wall, .body_b = ball, .frame_a = {{0, -2}, pi / 2}}, .spring = spring})
                         : world->create_joint(DistanceJointDef{.base = {.body_a = wall, .body_b = ball}, .length = 2, .spring = spring});
                world.step(600);
                const double w = 2 * std::numbers::pi * double(c.hertz), sag = g / (w * w);
                EXPECT_NEAR(-double(world->position(ball).y) - 2, sag, 0.001 * sag + 1e-6);
                EXPECT_NEAR(std::abs(double(world->joint_force(j).y)), g * double(world->mass(ball)), 0.001 * g * double(world->mass(ball)));
            }
        }
    }
}

TEST(JointSpring, MouseJointBringsItsPointToTheTargetAndNoForceMoreThanAllowed) {
    TestWorld world(room_for_joints, sleepless());
    const BodyId box = world.add_box({0, 0});
    world->set_angular_damping(box, 4);  // or it would swing below its corner for long
    const double weight = double(world->mass(box)) * g;
    const JointId j = world->create_joint(MouseJointDef{.body = box, .target = {0.4f, 0.4f}, .max_force = static_cast<float>(3 * weight)});
    world->set_target(j, {2, 3});
    double strongest = 0;
    for (int i = 0; i < 900; ++i) {
        world.step();
        strongest = std::fmax(strongest, double(length(world->joint_force(j))));
    }
    EXPECT_LE(strongest, 3 * weight * 1.0001);
    EXPECT_GT(strongest, 2.9 * weight) << "the bound was never reached: the test shows nothing";
    // It hangs below the target by what its weight stretches the spring: m_eff g / k, a few centimetres at 5 Hz.
    EXPECT_NEAR(double(world->anchor_b(j).x), 2, 0.01);
    EXPECT_NEAR(double(world->anchor_b(j).y), 3, 0.03);
    // The force balances the weight, the corner hangs above the centre.
    EXPECT_NEAR(double(world->joint_force(j).y) / weight, 1, 0.01);
    EXPECT_NEAR(double(world->center_of_mass(box).x), 2, 0.05);
}

}  // namespace
}  // namespace islet::test
