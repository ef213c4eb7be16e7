// The whole public API, called by a fuzzer. Each input is a list of calls, good and bad, on a world so small that every one of its pools fills up: ids
// of living, dead and never born objects; numbers that are ordinary, extreme or no numbers at all.
//
// After each call the world must be as it was if the call was refused, and after each step it must be sound, with every body at a finite place. A world
// that is loaded from a snapshot must have the same future. Prints how many calls were made and how many refused when it ends.
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "islet/island.hpp"
#include "islet/islet.hpp"
#include "islet/mover.hpp"
#include "memory/core.hpp"

namespace {

using namespace islet;

[[noreturn]] void fail(const char* what) {
    std::fprintf(stderr, "islet_fuzz_api: %s\n", what);
    std::abort();
}

constexpr Capacity capacity{.bodies = 12, .shapes = 20, .contacts = 24, .joints = 8, .geometries = 10};

/// What every input starts from anew.
struct Fixture {
    StaticWorld<capacity> storage, twin_storage;
    World* world = nullptr;
    World* twin = nullptr;
    std::vector<std::byte> image, island, recording;
    bool trace = std::getenv("ISLET_FUZZ_TRACE") != nullptr;
    unsigned long inputs = 0, calls = 0, refused = 0, steps = 0;

    Fixture() : image(max_snapshot_bytes(capacity)), island(1 << 16), recording(1 << 20) {}
    ~Fixture() { std::fprintf(stderr, "%lu inputs: %lu calls, %lu of them refused, %lu steps\n", inputs, calls, refused, steps); }
};

Fixture& fixture() {
    static Fixture f;
    return f;
}

/// What the world holds, for who looks into a finding.
void print(const World& w) {
    const SolverDef d = w.solver();
    std::fprintf(stderr, "  gravity %g %g; schedule %d, %u substeps, %u + %u sweeps, order %d, trees %d, block %d, contacts %g Hz, joints %g Hz, omega %g, "
                         "shock %g, tolerance %g\n",
                 double(w.gravity().x), double(w.gravity().y), int(d.schedule), d.substeps, d.iterations, d.relax_iterations, int(d.sweep_order),
                 int(d.joint_trees), int(d.block_contacts), double(d.contact_hertz), double(d.joint_hertz), double(d.omega), double(d.shock), double(d.tolerance));
    for (std::uint32_t slot = 0; slot < capacity.bodies; ++slot) {
        const BodyId b = w.body_at(slot);
        if (!b) continue;
        const Vec2 p = w.center_of_mass(b), v = w.linear_velocity(b);
        std::fprintf(stderr, "  body %u: type %d, mass %g, inertia %g, at %.9g %.9g turned %g, v %g %g, w %g%s\n", slot, int(w.type(b)), double(w.mass(b)),
                     double(w.rotational_inertia(b)), double(p.x), double(p.y), double(w.angle(b)), double(v.x), double(v.y),
                     double(w.angular_velocity(b)), w.is_awake(b) ? "" : ", asleep");
        const detail::Motion& m = detail::Core::of(w).motions[slot];
        std::fprintf(stderr, "    force %g %g, torque %g, slack %g, at rest for %g s, reach %g\n", double(m.force.x), double(m.force.y), double(m.torque),
                     double(m.slack), double(m.sleep_time), double(detail::Core::of(w).poses[slot].max_extent));
        ShapeId all[capacity.shapes];
        const std::uint32_t n = w.shapes(b, all);
        for (std::uint32_t i = 0; i < n; ++i) {
            const Aabb box = w.aabb(all[i]);
            std::fprintf(stderr, "    shape %u: type %d, %g %g to %g %g, friction %g, restitution %g, rolling %g, surface %g\n", all[i].index1 - 1,
                         int(w.shape_type(all[i])), double(box.lower.x), double(box.lower.y), double(box.upper.x), double(box.upper.y),
                         double(w.friction(all[i])), double(w.restitution(all[i])), double(w.rolling_resistance(all[i])), double(w.tangent_speed(all[i])));
        }
    }
    for (std::uint32_t slot = 0; slot < capacity.joints; ++slot) {
        const JointId j = w.joint_at(slot);
        if (!j) continue;
        const Vec2 force = w.joint_force(j);
        std::fprintf(stderr, "  joint %u: type %d, bodies %u %u, force %g %g, torque %g\n", slot, int(w.joint_type(j)), w.body_a(j).index1 - 1,
                     w.body_b(j).index1 - 1, double(force.x), double(force.y), double(w.joint_torque(j)));
    }
    ContactInfo c;
    for (std::uint32_t slot = 0; slot < capacity.contacts; ++slot) {
        if (!w.contact_at(slot, c)) continue;
        std::fprintf(stderr, "  contact %u: shapes %u %u, normal %g %g, friction %g\n", slot, c.shape_a.index1 - 1, c.shape_b.index1 - 1,
                     double(c.normal.x), double(c.normal.y), double(c.friction));
        for (std::uint32_t i = 0; i < c.point_count; ++i) {
            const ContactPoint& p = c.points[i];
            std::fprintf(stderr, "    %g %g, separation %g, impulses %g %g\n", double(p.point.x), double(p.point.y), double(p.separation),
                         double(p.normal_impulse), double(p.tangent_impulse));
        }
    }
}

// Hooks that answer by the ids of what they are asked about, so that worlds with equal ids have equal futures.
constexpr Hooks hooks = {
    [](ShapeId a, ShapeId b, void*) { return (a.index1 * 7 + b.index1) % 5 != 0; },
    [](PreSolve& p, void*) {
        p.enabled = (p.contact.shape_a.index1 + p.contact.shape_b.index1) % 4 != 0;
        p.friction = 0.25f * static_cast<float>(p.contact.shape_a.index1 % 8);
        p.tangent_speed = static_cast<float>(p.contact.shape_b.index1 % 3);
    },
    [](float a, std::uint32_t, float b, std::uint32_t material, void*) { return material % 4 == 3 ? __builtin_nanf("") : a * b; },
    [](float a, std::uint32_t material, float b, std::uint32_t, void*) { return material % 4 == 3 ? 1e30f : a + b; },
    nullptr,
};

/// Makes arguments of the fuzzer's bytes; zeros when they are used up.
class Reader {
public:
    Reader(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}
    bool done() const { return at_ == end_; }
    std::uint32_t byte() { return at_ < end_ ? *at_++ : 0; }
    bool flag() { return (byte() & 1) != 0; }
    std::uint32_t below(std::uint32_t n) { return byte() % n; }

    /// Mostly -16 to 16 in steps of an eighth.
    float number() {
        constexpr float special[] = {__builtin_nanf(""), __builtin_inff(), -__builtin_inff(), 3.4e38f, -3.4e38f, 1e-38f, 1.4e-45f, -0.0f,
                                     1e7f, -1e7f, 1e30f, 1e-12f, 1e6f, 0.005f, 1e-4f, 400};
        const std::uint32_t first = byte();
        if (first < 240) return 0.125f * static_cast<float>(static_cast<int>(first) - 120);
        if (first < 252) return special[below(std::size(special))];
        return std::bit_cast<float>(byte() | byte() << 8 | byte() << 16 | byte() << 24);
    }
    /// Mostly 0 to 4.
    float size() {
        const std::uint32_t first = byte();
        return first < 240 ? static_cast<float>(first) / 60.0f : number();
    }
    Vec2 point() {
        const float x = number();
        return {x, number()};
    }

private:
    const std::uint8_t* at_;
    const std::uint8_t* end_;
};

/// One input's play with a world.
struct Player {
    World& w;
    Reader in;
    Fixture& f;
    BodyId dead_body = {};
    ShapeId dead_shape = {};
    JointId dead_joint = {};
    MoverState mover = {};

    /// Mostly one that lives.
    BodyId body() {
        const std::uint32_t which = in.byte();
        if (which >= 248) return which % 2 == 0 ? dead_body : BodyId{which - 247, in.byte()};
        return w.body_at(which % capacity.bodies);
    }
    ShapeId shape() {
        const BodyId owner = body();
        const std::uint32_t which = in.byte();
        if (which >= 248) return which % 2 == 0 ? dead_shape : ShapeId{which - 247, in.byte()};
        ShapeId all[capacity.shapes];
        const std::uint32_t n = w.shapes(owner, all);
        return n > 0 ? all[which % n] : ShapeId{};
    }
    JointId joint() {
        const std::uint32_t which = in.byte();
        if (which >= 248) return which % 2 == 0 ? dead_joint : JointId{which - 247, in.byte()};
        return w.joint_at(which % capacity.joints);
    }

    BodyDef body_def() {
        BodyDef d;
        d.type = static_cast<BodyType>(in.below(8) < 5 ? 2 : in.below(3));
        d.position = in.point();
        d.angle = in.number();
        const std::uint32_t more = in.byte();
        if ((more & 1) != 0) d.linear_velocity = in.point();
        if ((more & 2) != 0) d.angular_velocity = in.number();
        if ((more & 4) != 0) d.linear_damping = in.size();
        if ((more & 8) != 0) d.gravity_scale = in.number();
        d.awake = (more & 16) == 0;
        d.fixed_rotation = (more & 32) != 0;
        d.bullet = (more & 64) != 0;
        if (d.awake && d.fixed_rotation) {
            const std::uint32_t rare = in.byte();
            d.lock_x = (rare & 1) != 0;
            d.lock_y = (rare & 2) != 0;
            d.enabled = (rare & 12) != 0;
        }
        if ((more & 128) != 0) d.sleep_threshold = in.size();
        return d;
    }
    ShapeDef shape_def() {
        ShapeDef d;
        const std::uint32_t more = in.byte();
        if ((more & 1) != 0) d.friction = in.size();
        if ((more & 2) != 0) d.restitution = 0.25f * in.size();
        if ((more & 4) != 0) d.rolling_resistance = in.size();
        if ((more & 8) != 0) d.tangent_speed = in.number();
        if ((more & 16) != 0) d.density = in.size();
        if ((more & 32) != 0) d.filter = filter();
        if ((more & 64) != 0) {
            const std::uint32_t what = in.byte();
            d.sensor = (what & 1) != 0;
            d.sensor_events = (what & 2) != 0;
            d.hit_events = (what & 4) != 0;
            d.pre_solve = (what & 8) != 0;
            d.material = what;
        }
        return d;
    }
    Filter filter() {
        const std::uint32_t category = in.byte(), mask = in.byte();
        return {category, mask, static_cast<std::int32_t>(in.below(4)) - 2};
    }
    Polygon polygon() {
        switch (in.below(4)) {
        case 0: return make_box(in.size(), in.size());
        case 1: return make_rounded_box(in.size(), in.size(), in.size());
        case 2: {
            Vec2 points[max_polygon_vertices];
            for (Vec2& p : points) p = in.point();
            return make_polygon(compute_hull({points, in.below(max_polygon_vertices + 1)}), in.flag() ? in.size() : 0);
        }
        default: {  // made by hand, and badly
            Polygon p = make_box(in.size(), in.size());
            p.vertices[in.below(max_polygon_vertices)] = in.point();
            p.count = in.below(12);
            return p;
        }
        }
    }
    void create_shape(BodyId owner) {
        const ShapeDef def = shape_def();
        switch (in.below(6)) {
        case 0: w.create_shape(owner, Circle{in.point(), in.size()}, def); break;
        case 1: {
            const Vec2 from = in.point(), to = in.point();
            w.create_shape(owner, Capsule{from, to, in.size()}, def);
            break;
        }
        case 2: {
            const Vec2 from = in.point(), to = in.point();
            w.create_shape(owner, Segment{from, to}, def);
            break;
        }
        case 3: {
            Vec2 points[6];
            for (Vec2& p : points) p = in.point();
            const std::uint32_t count = in.below(7);
            w.create_chain(owner, {points, count}, in.flag(), def);
            break;
        }
        default: w.create_shape(owner, polygon(), def);
        }
    }

    JointSpring spring() {
        const bool on = in.flag();
        const float hertz = in.size(), ratio = in.size();
        return {on, hertz, ratio, in.number()};
    }
    JointLimit limit() {
        const bool on = in.flag();
        const float a = in.number(), b = in.number();
        return in.below(8) == 0 || a <= b ? JointLimit{on, a, b} : JointLimit{on, b, a};
    }
    JointMotor motor() {
        const bool on = in.flag();
        const float speed = in.number();
        return {on, speed, in.size()};
    }
    JointFrame frame() {
        const Vec2 at = in.point();
        return {at, in.number()};
    }
    void create_joint() {
        JointBase base;
        base.body_a = body();
        base.body_b = body();
        const std::uint32_t more = in.byte();
        if ((more & 1) != 0) base.frame_a = frame();
        if ((more & 2) != 0) base.frame_b = frame();
        base.collide_connected = (more & 4) != 0;
        if ((more & 8) != 0) base.break_force = in.size();
        if ((more & 16) != 0) base.break_torque = in.size();
        const JointSpring s = (more & 32) != 0 ? spring() : JointSpring{};
        const JointLimit l = (more & 64) != 0 ? limit() : JointLimit{};
        const JointMotor m = (more & 128) != 0 ? motor() : JointMotor{};
        switch (in.below(joint_type_count)) {
        case 0: w.create_joint(RevoluteJointDef{base, s, l, m, in.size()}); break;
        case 1: w.create_joint(PrismaticJointDef{base, s, l, m, in.size()}); break;
        case 2: w.create_joint(DistanceJointDef{base, in.size(), s, l, m}); break;
        case 3: {
            WeldJointDef d{base};
            d.linear_hertz = in.size();
            d.angular_hertz = in.size();
            w.create_joint(d);
            break;
        }
        case 4: w.create_joint(WheelJointDef{base, s, l, m, in.size()}); break;
        case 5: {
            MotorJointDef d{base};
            d.linear_velocity = in.point();
            d.max_force = in.size();
            d.max_torque = in.size();
            d.linear_hertz = in.size();
            w.create_joint(d);
            break;
        }
        case 6: {
            MouseJointDef d;
            d.body = base.body_a;
            d.target = in.point();
            d.hertz = in.size();
            d.max_force = 100 * in.size();
            w.create_joint(d);
            break;
        }
        case 7: {
            PulleyJointDef d{base};
            d.ground_a = in.point();
            d.ground_b = in.point();
            d.ratio = in.size();
            w.create_joint(d);
            break;
        }
        default: {
            const JointId first = joint(), second = joint();
            w.create_joint(GearJointDef{first, second, in.number()});
        }
        }
    }

    void change_body() {
        const BodyId b = body();
        switch (in.below(28)) {
        case 0: {
            const Vec2 at = in.point();
            w.set_transform(b, at, in.number());
            break;
        }
        case 1: w.set_linear_velocity(b, in.point()); break;
        case 2: w.set_angular_velocity(b, in.number()); break;
        case 3: {
            const Vec2 force = in.point();
            w.apply_force(b, force, in.point());
            break;
        }
        case 4: w.apply_force_to_center(b, in.point()); break;
        case 5: w.apply_torque(b, in.number()); break;
        case 6: {
            const Vec2 impulse = in.point();
            w.apply_linear_impulse(b, impulse, in.point());
            break;
        }
        case 7: w.apply_linear_impulse_to_center(b, in.point()); break;
        case 8: w.apply_angular_impulse(b, in.number()); break;
        case 9: w.set_type(b, static_cast<BodyType>(in.below(3))); break;
        case 10: {
            const float mass = in.size();
            const Vec2 center = in.point();
            w.set_mass(b, {mass, center, in.size()});
            break;
        }
        case 11: w.reset_mass(b); break;
        case 12: w.set_linear_damping(b, in.size()); break;
        case 13: w.set_angular_damping(b, in.size()); break;
        case 14: w.set_gravity_scale(b, in.number()); break;
        case 15: w.set_fixed_rotation(b, in.flag()); break;
        case 16: w.enable_sleep(b, in.flag()); break;
        case 17: w.wake(b); break;
        case 18: w.set_user_data(b, in.byte()); break;
        case 19: w.lock_x(b, in.flag()); break;
        case 20: w.lock_y(b, in.flag()); break;
        case 21:
        case 22: w.set_enabled(b, in.below(3) != 0); break;
        case 23: w.set_bullet(b, in.flag()); break;
        case 24: w.set_sleep_threshold(b, in.size()); break;
        case 25: {
            const Vec2 at = in.point();
            const float angle = in.number();
            w.set_target(b, {at, make_rot(angle)}, in.flag() ? 1.0f / 60 : in.number());
            break;
        }
        default: dead_body = b; w.destroy_body(b);
        }
    }
    void change_shape() {
        const ShapeId s = shape();
        switch (in.below(17)) {
        case 0: w.set_friction(s, in.size()); break;
        case 1: w.set_restitution(s, 0.25f * in.size()); break;
        case 2: w.set_rolling_resistance(s, in.size()); break;
        case 3: w.set_tangent_speed(s, in.number()); break;
        case 4: w.set_filter(s, filter()); break;
        case 5: w.set_user_data(s, in.byte()); break;
        case 6: w.set_circle(s, {in.point(), in.size()}); break;
        case 7: {
            const Vec2 from = in.point(), to = in.point();
            w.set_capsule(s, {from, to, in.size()});
            break;
        }
        case 8: {
            const Vec2 from = in.point();
            w.set_segment(s, {from, in.point()});
            break;
        }
        case 9: w.set_polygon(s, polygon()); break;
        case 10: w.set_density(s, in.size()); break;
        case 11: {
            SurfaceMaterial m = w.material(s);
            m.friction = in.size();
            m.restitution = 0.25f * in.size();
            m.id = in.byte();
            w.set_material(s, m);
            break;
        }
        case 12: w.enable_sensor_events(s, in.flag()); break;
        case 13: w.enable_hit_events(s, in.flag()); break;
        case 14: w.enable_pre_solve(s, in.flag()); break;
        case 15: {
            WindDef wind;
            wind.velocity = in.point();
            wind.drag = in.size();
            wind.lift = in.number();
            w.apply_wind(s, wind);
            break;
        }
        default: dead_shape = s; w.destroy_shape(s);
        }
    }
    void change_joint() {
        const JointId j = joint();
        switch (in.below(13)) {
        case 0: {
            const JointFrame a = frame();
            w.set_frames(j, a, frame());
            break;
        }
        case 1: w.set_collide_connected(j, in.flag()); break;
        case 2: {
            const float force = in.size();
            w.set_break(j, force, in.size());
            break;
        }
        case 3: w.set_user_data(j, in.byte()); break;
        case 4: w.set_spring(j, spring()); break;
        case 5: w.set_limit(j, limit()); break;
        case 6: w.set_motor(j, motor()); break;
        case 7: w.set_joint_friction(j, in.size()); break;
        case 8: w.set_joint_length(j, in.size()); break;
        case 9: {
            const Vec2 v = in.point();
            w.set_joint_velocity(j, v, in.number());
            break;
        }
        case 10: {
            const float force = in.size();
            w.set_joint_strength(j, force, in.size());
            break;
        }
        case 11: w.set_target(j, in.point()); break;
        default: dead_joint = j; w.destroy_joint(j);
        }
    }
    void change_world() {
        switch (in.below(9)) {
        case 0: w.set_gravity(in.point()); break;
        case 1: w.enable_sleep(in.flag()); break;
        case 2: w.enable_continuous(in.flag()); break;
        case 3: w.set_hit_threshold(in.size()); break;
        case 4: {
            ExplosionDef e;
            e.position = in.point();
            e.radius = in.size();
            e.falloff = in.size();
            e.impulse_per_length = in.number();
            w.explode(e);
            break;
        }
        default: {
            SolverDef d = w.solver();
            // Few sweeps: an input should not take seconds.
            switch (in.below(12)) {
            case 0: d.schedule = static_cast<Schedule>(in.below(3)); break;
            case 1: d.substeps = in.below(7); break;
            case 2: d.iterations = in.below(6); break;
            case 3: d.relax_iterations = in.below(6); break;
            case 4: d.contact_hertz = in.size() * 20; break;
            case 5: d.joint_hertz = in.size() * 20; break;
            case 6: d.omega = in.size(); break;
            case 7: d.warm_start = in.flag(); break;
            case 8: d.joint_trees = static_cast<JointTrees>(in.below(4)); break;
            case 9: d.sweep_order = static_cast<SweepOrder>(in.below(5)); break;
            case 10: d.block_contacts = in.flag(); d.measure_residual = in.flag(); break;
            default: d.shock = 0.25f * in.size(); d.tolerance = in.size();
            }
            w.set_solver(d);
        }
        }
    }

    // Reading must not change anything, whatever is read.
    void read() {
        const std::uint64_t hash = w.hash();
        const BodyId b = body();
        float sum = w.transform(b).p.x + w.angle(b) + w.center_of_mass(b).x + w.linear_velocity(b).y + w.velocity_at(b, in.point()).x + w.mass(b);
        sum += w.rotational_inertia(b) + w.residual(b);
        const ShapeId s = shape();
        sum += w.aabb(s).lower.x + w.friction(s) + (w.circle(s) != nullptr ? 1.0f : 0.0f) + (w.polygon(s) != nullptr ? 1.0f : 0.0f);
        const JointId j = joint();
        sum += w.anchor_a(j).x + w.anchor_b(j).x + w.joint_position(j) + w.joint_speed(j) + w.joint_force(j).x + w.joint_torque(j);
        sum += w.joint_error(j).linear + w.motor_force(j) + w.joint_length(j) + w.spring(j).hertz + w.target(j).x + w.ground_a(j).x;
        ContactInfo contact;
        if (w.contact_at(in.byte(), contact)) sum += contact.points[0].separation;
        sum += static_cast<float>(w.counters().tree_height);
        ShapeId seen[4];
        ContactInfo touching[4];
        sum += static_cast<float>(w.sensor_overlaps(s, seen) + w.contacts(b, touching) + w.hit_events().size() + w.sensor_begin_events().size() +
                                  w.sensor_end_events().size() + w.moved_bodies().size() + w.broken_joints().size());
        ask();
        draw();
        IslandProblem problem;
        const float h = in.size();
        w.export_island(b, h, {f.island.data(), in.flag() ? f.island.size() : in.byte()}, problem);
        volatile float sink = sum;
        static_cast<void>(sink);
        if (w.hash() != hash) fail("reading changed the world");
    }
    /// Good arguments must find something finite, bad ones nothing.
    void ask() {
        const Vec2 from = in.point(), way = in.point();
        QueryHit hits[4];
        ShapeId ids[4];
        Surface surfaces[4];
        const auto expect_good = [](const QueryHit& hit) {
            const bool good = is_finite(hit.point) && is_finite(hit.normal) && hit.fraction >= 0 && hit.fraction <= 1 && hit.separation <= 0;
            if (hit && !good) fail("a query found what is not finite");
        };
        const QueryHit first = w.cast_ray(from, way);
        expect_good(first);
        if (w.cast_ray_any(from, way) != bool(first)) fail("two ways to cast a ray disagree");
        const std::uint32_t met = w.cast_ray_all(from, way, hits);
        if ((met > 0) != bool(first) || (met > 0 && !(hits[0].shape == first.shape))) fail("the first of all hits is not the first hit");
        const ShapeProxy proxy = in.flag() ? make_proxy(Circle{in.point(), in.size()}) : make_proxy(polygon());
        const QueryHit cast = w.cast_shape(proxy, way);
        expect_good(cast);
        if (w.cast_shape_any(proxy, way) != bool(cast)) fail("two ways to cast a shape disagree");
        w.overlap_shape(proxy, ids);
        w.overlap_point(from, ids);
        w.overlap_box({from, way}, ids);
        w.surfaces_near(proxy, in.size(), surfaces);
        const ClosestHit closest = w.closest(from, in.size());
        if (closest && !(is_finite(closest.point) && is_finite(closest.normal) && closest.distance >= 0)) fail("the closest point is none");
    }
    void draw() {
        DebugDraw d;
        static unsigned long drawn;
        d.polygon = [](std::span<const Vec2> corners, float, const DrawStyle&, void*) { drawn += corners.size(); };
        d.circle = [](Vec2, float, Vec2, const DrawStyle&, void*) { ++drawn; };
        d.capsule = [](Vec2, Vec2, float, const DrawStyle&, void*) { ++drawn; };
        d.segment = [](Vec2, Vec2, const DrawStyle&, void*) { ++drawn; };
        d.point = [](Vec2, const DrawStyle&, void*) { ++drawn; };
        d.text = [](Vec2, const char* words, const DrawStyle&, void*) { drawn += std::strlen(words); };
        const std::uint32_t more = in.byte();
        d.contacts = d.normals = d.impulses = (more & 1) != 0;
        d.boxes = d.fat_boxes = d.tree = (more & 2) != 0;
        d.centers = d.names = (more & 4) != 0;
        d.body_colors = (more & 8) != 0 ? BodyColors::island : BodyColors::state;
        d.constraint_colors = (more & 16) != 0;
        if ((more & 32) != 0) d.view = {in.point(), in.point()};
        if ((more & 64) != 0) d.size = in.number();
        w.draw(d);
    }

    void walk() {
        MoverInput input;
        input.walk = in.number();
        input.jump = in.below(4) == 0 ? in.size() : 0;
        for (std::uint32_t i = in.below(8) + 1; i > 0; --i) {
            w.step(1.0f / 60);
            if (!step_mover(w, {}, mover, input, 1.0f / 60)) break;
        }
        if (!is_finite(mover.position) || !is_finite(mover.velocity)) fail("a mover is nowhere");
        check();
    }

    void step() {
        const std::uint32_t how = in.byte();
        if (f.trace) print(w);
        if (how >= 250) {
            const float dt = in.number();
            if (f.trace) std::fprintf(stderr, "  a step of %g s\n", double(dt));
            w.step(dt);
            return check();
        }
        for (std::uint32_t i = 0; i <= how % 8; ++i) {
            w.step(how % 16 < 12 ? 1.0f / 60 : 1.0f / (1 + static_cast<float>(how / 16)));
            ++f.steps;
            check();
        }
    }
    void check() {
        const char* broken = w.validate();
        if (broken != nullptr && f.trace) print(w);
        if (broken != nullptr) fail(broken);
        for (std::uint32_t slot = 0; slot < capacity.bodies; ++slot) {
            const BodyId b = w.body_at(slot);
            if (!b) continue;
            const Transform pose = w.transform(b);
            const bool finite = is_finite(pose.p) && is_finite(pose.q.c) && is_finite(pose.q.s) && is_finite(w.linear_velocity(b)) &&
                                is_finite(w.angular_velocity(b));
            if (!finite) fail("a body is at no place, or moves at no speed");
            if (abs(pose.q.c * pose.q.c + pose.q.s * pose.q.s - 1) > 1e-3f) fail("a rotation is none");
        }
    }
    // To another world and back, and a step ahead in both.
    void round_trip() {
        const std::size_t n = w.save(f.image);
        if (n == 0 || n != w.snapshot_bytes()) fail("the world does not fit the image it asks for");
        const std::span<const std::byte> bytes(f.image.data(), n);
        if (f.trace) print(w);
        if (const char* broken = w.validate()) fail(broken);
        if (!f.twin->load(bytes)) fail(describe(f.twin->last_error()));
        if (f.twin->hash() != w.hash()) fail("a loaded world is another");
        f.twin->step(1.0f / 60);
        if (in.flag()) {
            if (!w.restore(bytes)) fail("a world does not take its own image back");
        }
        w.step(1.0f / 60);
        if (f.twin->hash() != w.hash()) fail("a loaded world has another future");
        check();
    }

    /// All that was done, done again by another world.
    void replay_all() {
        const std::uint64_t hash = w.hash();
        const std::size_t n = w.stop_recording();
        if (w.hash() != hash) fail("a recording that ends changes the world");
        const ReplayResult result = replay(*f.twin, {f.recording.data(), n});
        if (result.end != ReplayEnd::complete) fail(result.end == ReplayEnd::differs ? "a replay differs" : describe(result.error));
        if (f.twin->hash() != hash) fail("a replay ends elsewhere");
    }

    void play() {
        if (in.below(4) == 0) {
            w.set_hooks(hooks);
            f.twin->set_hooks(hooks);
        }
        if (in.flag() && !w.start_recording(f.recording, in.flag())) fail("no recording starts");
        for (int i = 0; i < 300 && !in.done(); ++i) {
            ++f.calls;
            const std::uint32_t what = in.below(32);
            if (f.trace) std::fprintf(stderr, "call %d of kind %u; before it: %s\n", i, what, describe(w.last_error()));
            if (what < 7) {
                step();
                continue;
            }
            if (what == 7) {
                walk();
                continue;
            }
            if (what == 8) {
                round_trip();
                continue;
            }
            w.clear_error();
            const std::uint64_t before = w.hash();
            if (what < 13) {
                const BodyId made = w.create_body(body_def());
                if (made) continue;
            } else if (what < 18) {
                create_shape(body());
            } else if (what < 21) {
                create_joint();
            } else if (what < 25) {
                change_body();
            } else if (what < 27) {
                change_shape();
            } else if (what < 30) {
                change_joint();
            } else if (what == 30) {
                change_world();
            } else {
                read();
            }
            const Error error = w.last_error();
            if (error == Error::none) continue;
            ++f.refused;
            // What ends a contact may find no room to report it, and goes on.
            if (error != Error::events_full && error != Error::recording_full && w.hash() != before) fail("a refused call changed the world");
        }
        check();
        if (w.is_recording()) replay_all();
    }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Fixture& f = fixture();
    ++f.inputs;
    f.world = &f.storage.create();
    f.twin = &f.twin_storage.create();
    Player player{*f.world, Reader(data, size), f};
    player.play();
    return 0;
}
