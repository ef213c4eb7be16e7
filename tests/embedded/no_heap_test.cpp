// No heap: a world driven through every feature never allocates. Every way to the heap that a C++ program has is replaced by one that counts.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "islet/island.hpp"
#include "islet/islet.hpp"
#include "islet/lcp.hpp"
#include "islet/mover.hpp"
#include "support/joint_world.hpp"

// Sanitizers bring their own malloc, which may not be replaced; the operators may.
#if defined(__SANITIZE_ADDRESS__)
#define ISLET_OWN_MALLOC 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(memory_sanitizer) || __has_feature(thread_sanitizer)
#define ISLET_OWN_MALLOC 0
#endif
#endif
#if !defined(ISLET_OWN_MALLOC)
#if defined(__GLIBC__)
#define ISLET_OWN_MALLOC 1
#else
#define ISLET_OWN_MALLOC 0
#endif
#endif

namespace {

bool counting = false;
long allocations = 0;

void count() { allocations += counting ? 1 : 0; }

}  // namespace

#if ISLET_OWN_MALLOC
// The C library's own functions under their other names; operator new of the C++ runtime ends in malloc, so it is counted too.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t n) { return count(), __libc_malloc(n); }
void* calloc(std::size_t n, std::size_t size) { return count(), __libc_calloc(n, size); }
void* realloc(void* p, std::size_t n) { return count(), __libc_realloc(p, n); }
void* memalign(std::size_t alignment, std::size_t n) { return count(), __libc_memalign(alignment, n); }
void* aligned_alloc(std::size_t alignment, std::size_t n) { return count(), __libc_memalign(alignment, n); }
void free(void* p) {
    if (p != nullptr) count();
    __libc_free(p);
}
}
#else
void* operator new(std::size_t n) {
    count();
    if (void* p = std::malloc(n)) return p;
    std::abort();
}
void operator delete(void* p) noexcept {
    if (p != nullptr) count();
    std::free(p);
}
void operator delete(void* p, std::size_t) noexcept { operator delete(p); }
#endif

namespace {

using namespace islet;

constexpr Capacity capacity{.bodies = 48, .shapes = 64, .contacts = 96, .joints = 24, .geometries = 24};
StaticWorld<capacity> storage;

// Counts from construction on.
struct Watch {
    Watch() {
        allocations = 0;
        counting = true;
    }
    ~Watch() { counting = false; }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;
    long stop() const {
        counting = false;
        return allocations;
    }
};

BodyDef moving(Vec2 position) {
    BodyDef def;
    def.type = BodyType::dynamic;
    def.position = position;
    return def;
}

// Errors are counted without a heap, too.
int errors_heard = 0;

World& build() {
    WorldDef def;
    def.error_hook = [](Error, void*) { ++errors_heard; };
    World& w = storage.create(def);
    const BodyId ground = w.create_body({});
    const Vec2 bowl[] = {{12, 8}, {10, 0}, {-10, 0}, {-12, 8}};
    w.create_chain(ground, bowl, false);
    w.create_shape(ground, Segment{{-3, 1}, {3, 2}});
    for (int i = 0; i < 30; ++i) {
        const BodyId body = w.create_body(moving({static_cast<float>(i % 6) - 3, 3 + 0.8f * static_cast<float>(i)}));
        ShapeDef shape;
        shape.restitution = i % 5 == 0 ? 0.6f : 0;
        shape.rolling_resistance = i % 7 == 0 ? 0.1f : 0;
        shape.tangent_speed = i % 11 == 0 ? 1.0f : 0;
        switch (i % 5) {
        case 0: w.create_shape(body, Circle{{0, 0}, 0.4f}, shape); break;
        case 1: w.create_shape(body, Capsule{{-0.3f, 0}, {0.3f, 0}, 0.2f}, shape); break;
        case 2: w.create_shape(body, make_rounded_box(0.3f, 0.3f, 0.05f), shape); break;
        case 3:
            w.create_shape(body, make_box(0.4f, 0.2f), shape);
            w.create_shape(body, Circle{{0.4f, 0}, 0.2f}, shape);
            break;
        default: {
            const Vec2 points[] = {{0, 0}, {0.6f, 0}, {0.3f, 0.5f}, {0.3f, 0.2f}};
            w.create_shape(body, make_polygon(compute_hull(points)), shape);
        }
        }
    }
    return w;
}

void change_everything(World& w) {
    const BodyId body = w.body_at(5);
    ShapeId shape;
    w.shapes(body, {&shape, 1});
    w.set_transform(body, {0, 9}, 1);
    w.set_linear_velocity(body, {1, 2});
    w.set_angular_velocity(body, 3);
    w.apply_force(body, {1, 2}, {0, 9});
    w.apply_force_to_center(body, {1, 1});
    w.apply_torque(body, 1);
    w.apply_linear_impulse(body, {0.1f, 0}, {0, 9});
    w.apply_linear_impulse_to_center(body, {0.1f, 0});
    w.apply_angular_impulse(body, 0.1f);
    w.set_mass(body, {2, {0.1f, 0}, 1});
    w.reset_mass(body);
    w.set_linear_damping(body, 0.1f);
    w.set_angular_damping(body, 0.1f);
    w.set_gravity_scale(body, 0.5f);
    w.set_fixed_rotation(body, true);
    w.set_fixed_rotation(body, false);
    w.enable_sleep(body, false);
    w.enable_sleep(body, true);
    w.wake(body);
    w.set_user_data(body, 5);
    w.set_friction(shape, 0.3f);
    w.set_restitution(shape, 0.3f);
    w.set_rolling_resistance(shape, 0.3f);
    w.set_tangent_speed(shape, 0.3f);
    w.set_filter(shape, {.group = 3});
    w.set_user_data(shape, 5);
    w.set_type(w.body_at(7), BodyType::kinematic);
    w.set_type(w.body_at(8), BodyType::static_body);
    w.set_type(w.body_at(8), BodyType::dynamic);
    w.destroy_shape(shape);
    w.destroy_body(w.body_at(9));
    w.create_shape(w.create_body(moving({2, 12})), Circle{{0, 0}, 3});
    w.set_gravity({0, -9.81f});
    w.enable_sleep(false);
    w.enable_sleep(true);
}

float read_everything(const World& w) {
    float sum = 0;
    for (std::uint32_t slot = 0; slot < w.capacity().bodies; ++slot) {
        const BodyId id = w.body_at(slot);
        if (!id) continue;
        ShapeId shapes[8];
        const std::uint32_t n = w.shapes(id, shapes);
        for (std::uint32_t i = 0; i < n && i < 8; ++i) {
            sum += w.aabb(shapes[i]).lower.x + w.friction(shapes[i]) + w.restitution(shapes[i]) + w.rolling_resistance(shapes[i]);
            sum += w.circle(shapes[i]) != nullptr || w.polygon(shapes[i]) != nullptr ? 1.0f : 0.0f;
        }
        sum += w.transform(id).p.x + w.angle(id) + w.center_of_mass(id).x + w.local_center_of_mass(id).y + w.mass(id) +
               w.rotational_inertia(id);
        sum += w.linear_velocity(id).x + w.angular_velocity(id) + w.velocity_at(id, {0, 0}).x + w.linear_damping(id) + w.gravity_scale(id);
    }
    ContactInfo info;
    for (std::uint32_t slot = 0; slot < w.capacity().contacts; ++slot) sum += w.contact_at(slot, info) ? info.points[0].separation : 0;
    sum +=
        static_cast<float>(w.begin_touch_events().size() + w.end_touch_events().size() + w.moved_bodies().size() + w.slept_bodies().size());
    return sum + static_cast<float>(w.report().contacts + w.hash() % 2 + (w.validate() == nullptr ? 1u : 0u));
}

TEST(NoHeap, TheCounterCounts) {
    const Watch watch;
    int* volatile p = new int(1);
    delete p;
    EXPECT_GE(watch.stop(), 2) << "an allocation and a release went by unseen: nothing below proves anything";
}

TEST(NoHeap, MakingAWorldAllocatesNothing) {
    const Watch watch;
    build();
    const long n = watch.stop();
    EXPECT_EQ(n, 0);
}

TEST(NoHeap, SteppingAllocatesNothing) {
    World& w = build();
    const Watch watch;
    for (int i = 0; i < 300; ++i) w.step(1.0f / 60);
    const long n = watch.stop();
    EXPECT_EQ(n, 0);
    EXPECT_GT(w.report().contacts, 10u);
}

TEST(NoHeap, NeitherDoesAnySchedule) {
    World& w = build();
    SolverDef classic;
    classic.schedule = Schedule::classic;
    classic.substeps = 1;
    classic.iterations = 10;
    const Watch watch;
    w.set_solver(classic);
    for (int i = 0; i < 100; ++i) w.step(1.0f / 60);
    EXPECT_EQ(watch.stop(), 0);
}

TEST(NoHeap, NoCallAllocates) {
    World& w = build();
    float sum = 0;
    const Watch watch;
    for (int i = 0; i < 5; ++i) {
        for (int k = 0; k < 20; ++k) w.step(1.0f / 60);
        change_everything(w);
        sum += read_everything(w);
    }
    const long n = watch.stop();
    EXPECT_EQ(n, 0);
    EXPECT_TRUE(is_finite(sum));
    EXPECT_EQ(w.validate(), nullptr);
}

void drive_joints(World& w, const test::Machine& m) {
    const JointId hinge = m[JointType::revolute], rod = m[JointType::distance], drive = m[JointType::motor], mouse = m[JointType::mouse];
    w.set_spring(hinge, {.enable = true, .hertz = 3, .damping_ratio = 1, .target = 0});
    w.set_limit(hinge, {.enable = true, .lower = -1, .upper = 1});
    w.set_motor(hinge, {.enable = true, .speed = 1, .max_force = 3});
    w.set_joint_friction(hinge, 0.5f);
    w.set_joint_length(rod, 1.5f);
    w.set_joint_velocity(drive, {1, 0}, 0.5f);
    w.set_joint_strength(drive, 10, 5);
    w.set_target(mouse, {2, 3});
    w.set_frames(rod, {{1, 0}, 0}, {{0, 0.1f}, 0});
    w.set_collide_connected(rod, true);
    w.set_collide_connected(rod, false);
    w.set_user_data(rod, 3);
    w.set_type(m.arm, BodyType::static_body);
    w.step(1.0f / 60);
    w.set_type(m.arm, BodyType::dynamic);
    w.set_break(m[JointType::weld], 1e-3f, 0);
}

float read_joints(const World& w, const test::Machine& m) {
    float sum = 0;
    JointId out[4];
    for (const JointId j : m.joints) {
        if (!w.is_valid(j)) continue;
        const JointError error = w.joint_error(j);
        sum += w.anchor_a(j).x + w.anchor_b(j).y + w.joint_force(j).x + w.joint_torque(j) + error.linear + error.angular;
        sum += w.frame_a(j).angle + w.frame_b(j).angle + static_cast<float>(w.joints(w.body_b(j), out) + w.user_data(j));
        sum += w.joint_position(j) + w.joint_speed(j) + w.spring(j).hertz + w.limit(j).lower + w.motor(j).speed + w.motor_force(j);
        sum += w.joint_friction(j) + w.joint_length(j) + w.target(j).x + w.ground_a(j).x + w.ground_b(j).x;  // most of the wrong type
        sum += w.collide_connected(j) && w.joint_type(j) == JointType::gear ? 1.0f : 0.0f;
    }
    return sum + static_cast<float>(w.joint_count() + w.broken_joints().size() + (w.joint_at(0) ? 1u : 0u));
}

TEST(NoHeap, NoJointAllocates) {
    WorldDef def;
    def.error_hook = [](Error, void*) { ++errors_heard; };
    World& w = storage.create(def);
    float sum = 0;
    const Watch watch;
    const test::Machine m = test::add_machine(w, {0, 0});
    for (int i = 0; i < 30; ++i) w.step(1.0f / 60);
    sum += read_joints(w, m);
    drive_joints(w, m);
    w.step(1.0f / 60);
    const bool broke = w.broken_joints().size() == 1;
    sum += read_joints(w, m);
    while (test::join(w, JointType::revolute, m.left, m.right)) {
    }
    const bool full = w.last_error() == Error::joints_full;
    for (int i = 0; i < 300; ++i) w.step(1.0f / 60);
    w.destroy_joint(m[JointType::prismatic]);
    w.destroy_body(m.left);
    w.step(1.0f / 60);
    const long n = watch.stop();
    EXPECT_EQ(n, 0);
    EXPECT_TRUE(broke);
    EXPECT_TRUE(full);
    EXPECT_FALSE(w.is_valid(m[JointType::gear]));
    EXPECT_TRUE(is_finite(sum));
    EXPECT_EQ(w.validate(), nullptr);
}

TEST(NoHeap, ErrorsAndFullPoolsAllocateNothing) {
    World& w = build();
    errors_heard = 0;
    const Watch watch;
    w.step(0);
    w.step(-1);
    w.destroy_body({});
    w.set_transform({7, 7}, {0, 0}, 0);
    while (const BodyId id = w.create_body(moving({0, 5}))) w.create_shape(id, Circle{{0, 0}, 0.5f});
    for (int i = 0; i < 100; ++i) w.create_shape(w.body_at(1), Circle{{0, 0}, 0.01f * static_cast<float>(i + 1)});
    for (int i = 0; i < 60; ++i) w.step(1.0f / 60);
    const char* sentence = describe(w.last_error());
    const long n = watch.stop();
    EXPECT_EQ(n, 0);
    EXPECT_GT(errors_heard, 10);
    EXPECT_NE(sentence, nullptr);
    EXPECT_EQ(w.validate(), nullptr);
}

TEST(NoHeap, GoingBackAllocatesNothing) {
    World& w = build();
    alignas(snapshot_alignment) static std::byte first[1 << 18], second[1 << 18], packed[1 << 19];
    for (int i = 0; i < 60; ++i) w.step(1.0f / 60);
    const Watch watch;
    const std::size_t n = w.save(first);
    w.step(1.0f / 60);
    const std::size_t m = w.save(second);
    const std::size_t k = delta({first, n}, {second, m}, packed);
    const bool back = w.restore({first, n});
    const std::size_t applied = apply({first, n}, {packed, k}, second);
    const bool forth = w.load({second, applied});
    const bool refused = !w.load({packed, k});
    EXPECT_EQ(watch.stop(), 0);
    EXPECT_TRUE(back && forth && refused);
    EXPECT_EQ(applied, m);
}

TEST(NoHeap, ExportingIslandsAllocatesNothing) {
    World& w = build();
    alignas(float) static std::byte memory[1 << 19];
    const test::Machine m = test::add_machine(w, {40, 0});
    for (int i = 0; i < 60; ++i) w.step(1.0f / 60);
    std::size_t rows = 0;
    bool fit = true;
    const Watch watch;
    IslandProblem out;
    for (std::uint32_t slot = 0; slot < w.capacity().bodies; ++slot) {
        if (w.type(w.body_at(slot)) != BodyType::dynamic) continue;
        fit &= w.export_island(w.body_at(slot), 1.0f / 240, memory, out) <= sizeof memory;
        rows += out.rows.size();
    }
    const bool refused = w.export_island(m.frame, 1.0f / 240, memory, out) == 0;
    const long n = watch.stop();
    EXPECT_EQ(n, 0);
    EXPECT_TRUE(fit && refused);
    EXPECT_GT(rows, 100u);
}

TEST(NoHeap, NoQueryAllocates) {
    World& w = build();
    for (int i = 0; i < 60; ++i) w.step(1.0f / 60);
    QueryHit hits[8];
    ShapeId ids[8];
    std::uint32_t found = 0;
    const CastVisitor count_hit = [](const QueryHit&, void* n) { return ++*static_cast<std::uint32_t*>(n), 1.0f; };
    const OverlapVisitor count_id = [](ShapeId, void* n) { return ++*static_cast<std::uint32_t*>(n), true; };
    const Watch watch;
    const ShapeProxy ball = make_proxy(Circle{{-12, 1}, 0.5f});
    found += w.cast_ray({-12, 1}, {24, 0}) && w.cast_ray_any({-12, 1}, {24, 0}) ? 1u : 0u;
    found += w.cast_ray_all({-12, 1}, {24, 0}, hits) + w.cast_shape_all(ball, {24, 0}, hits);
    w.cast_ray_each({-12, 1}, {24, 0}, {}, count_hit, &found);
    w.cast_shape_each(ball, {24, 0}, {}, count_hit, &found);
    found += w.overlap_box({{-9, 0}, {9, 9}}, ids) + w.overlap_shape(ball, ids) + w.overlap_point({0, 0.5f}, ids);
    w.overlap_box_each({{-9, 0}, {9, 9}}, {}, count_id, &found);
    found += w.closest({0, 5}, 10) ? 1u : 0u;
    const long n = watch.stop();
    EXPECT_EQ(n, 0);
    EXPECT_GT(found, 40u);
}

TEST(NoHeap, NeitherDoSensorsHitsHooksAndWhatLeadsBodies) {
    World& w = build();
    const BodyId floor = w.create_body({}), lift = w.create_body({.type = BodyType::kinematic, .position = {0, 1}});
    w.create_shape(floor, make_box(15, 6), {.sensor = true});
    const Watch watch;
    w.set_hooks({.filter = [](ShapeId, ShapeId, void*) { return true; }, .pre_solve = [](PreSolve& c, void*) { c.friction *= 0.5f; }});
    const ShapeId gate = w.create_shape(lift, make_box(1, 0.2f), {.sensor = true});
    const BodyId crate = w.create_body(moving({1, 9}));
    const ShapeId shape = w.create_shape(crate, make_box(0.4f, 0.4f), {.hit_events = true, .pre_solve = true});
    std::size_t told = 0;
    for (int i = 0; i < 90; ++i) {
        w.set_target(lift, {{0, 1 + 0.02f * static_cast<float>(i)}, {}}, 1.0f / 60);
        w.apply_wind(shape, {.velocity = {3, 0}});
        if (i == 30) w.explode({.position = {0, 1}, .radius = 3, .falloff = 1, .impulse_per_length = 2});
        if (i == 40) w.set_circle(shape, Circle{{0, 0}, 0.4f});
        if (i == 50) w.set_enabled(crate, false);
        if (i == 60) w.set_enabled(crate, true);
        w.lock_x(crate, i % 20 < 10);
        w.step(1.0f / 60);
        ContactInfo contacts[4];
        ShapeId seen[4];
        told += w.sensor_begin_events().size() + w.sensor_end_events().size() + w.hit_events().size() + w.contacts(crate, contacts) + w.sensor_overlaps(gate, seen);
    }
    EXPECT_EQ(watch.stop(), 0);
    EXPECT_GT(told, 20u);
    EXPECT_EQ(w.validate(), nullptr);
}

TEST(NoHeap, AMoverAllocatesNothing) {
    World& w = build();
    MoverState mover{.position = {-9, 4}};
    bool good = true;
    int on_ground = 0;
    const Watch watch;
    for (int i = 0; i < 300; ++i) {
        w.step(1.0f / 60);
        good &= step_mover(w, {}, mover, {.walk = i % 100 < 50 ? 4.0f : -4.0f, .jump = i % 40 == 0 ? 5.0f : 0}, 1.0f / 60);
        on_ground += mover.ground ? 1 : 0;
    }
    const long n = watch.stop();
    EXPECT_EQ(n, 0);
    EXPECT_TRUE(good);
    EXPECT_GT(on_ground, 10);
}

TEST(NoHeap, DrawingAllocatesNothing) {
    World& w = build();
    test::add_machine(w, {40, 0});
    for (int i = 0; i < 60; ++i) w.step(1.0f / 60);
    long drawn = 0;
    DebugDraw draw;
    draw.context = &drawn;
    draw.polygon = [](std::span<const Vec2>, float, const DrawStyle&, void* n) { ++*static_cast<long*>(n); };
    draw.circle = [](Vec2, float, Vec2, const DrawStyle&, void* n) { ++*static_cast<long*>(n); };
    draw.capsule = [](Vec2, Vec2, float, const DrawStyle&, void* n) { ++*static_cast<long*>(n); };
    draw.segment = [](Vec2, Vec2, const DrawStyle&, void* n) { ++*static_cast<long*>(n); };
    draw.point = [](Vec2, const DrawStyle&, void* n) { ++*static_cast<long*>(n); };
    draw.text = [](Vec2, const char*, const DrawStyle&, void* n) { ++*static_cast<long*>(n); };
    draw.contacts = draw.normals = draw.impulses = draw.boxes = draw.fat_boxes = draw.tree = draw.centers = draw.names = true;
    draw.body_colors = BodyColors::island;
    draw.constraint_colors = true;
    const Watch watch;
    w.draw(draw);
    const long n = watch.stop();
    EXPECT_EQ(n, 0);
    EXPECT_GT(drawn, 300);
}

TEST(NoHeap, NoMatrixSolverAllocates) {
    const double m[] = {2, 1, 0, 1, 2, 1, 0, 1, 2}, q[] = {-1, 1, -1}, lo[] = {0, -1, 0}, hi[] = {1, 1, 0.5};
    const std::uint32_t friction[] = {lcp::no_row, lcp::no_row, 0}, blocks[] = {0, 2};
    alignas(double) static std::byte memory[1024];
    int solved = 0;
    const Watch watch;
    for (std::uint8_t method = 0; method <= static_cast<std::uint8_t>(lcp::Method::lemke); ++method) {
        double x[3] = {};
        lcp::Options<double> options;
        options.method = static_cast<lcp::Method>(method);
        options.omega = 0.7;
        if (options.method == lcp::Method::block_pgs) options.blocks = blocks;
        const auto result = lcp::solve<double>({.dense = {m}, .q = q, .lo = lo, .hi = hi, .friction = friction}, options, x, memory);
        solved += result.status == lcp::Status::converged ? 1 : 0;
        solved += lcp::residuals<double>({.dense = {m}, .q = q}, {x, 2}).natural > 1e30 ? 1 : 0;  // refused: the sizes do not fit
    }
    const long n = watch.stop();
    EXPECT_EQ(n, 0);
    EXPECT_EQ(solved, 20);
}

TEST(NoHeap, DestroyingEverythingAllocatesNothing) {
    World& w = build();
    for (int i = 0; i < 60; ++i) w.step(1.0f / 60);
    const Watch watch;
    for (std::uint32_t slot = 0; slot < w.capacity().bodies; ++slot)
        if (const BodyId id = w.body_at(slot)) w.destroy_body(id);
    w.step(1.0f / 60);
    EXPECT_EQ(watch.stop(), 0);
    EXPECT_EQ(w.body_count(), 0u);
    EXPECT_EQ(w.contact_count(), 0u);
}

}  // namespace
