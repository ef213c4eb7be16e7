#include "play.hpp"

#include <algorithm>
#include <thread>

namespace islet::lockstep {

namespace {

constexpr Capacity other_room{.bodies = 96, .shapes = 400, .contacts = 1024, .joints = 96, .geometries = 300, .hits = 300};

// A world lies anywhere in so much more than it needs: no bit may depend on an address.
constexpr std::size_t spare_bytes = 1 << 16;

// One thread that claims to be two, and runs the last task first.
void backwards(void*, std::uint32_t count, void (*task)(void*, std::uint32_t), void* data) {
    for (std::uint32_t i = count; i-- > 0;) task(data, i);
}
// The odd ones first.
void odd_first(void*, std::uint32_t count, void (*task)(void*, std::uint32_t), void* data) {
    for (std::uint32_t i = 1; i < count; i += 2) task(data, i);
    for (std::uint32_t i = 0; i < count; i += 2) task(data, i);
}
void on_threads(void*, std::uint32_t count, void (*task)(void*, std::uint32_t), void* data) {
    std::thread other([&] {
        for (std::uint32_t i = 1; i < count; i += 2) task(data, i);
    });
    for (std::uint32_t i = 0; i < count; i += 2) task(data, i);
    other.join();
}

}  // namespace

Setup setup_of(std::uint64_t seed, int family) {
    test::Random random(seed);
    Setup s;
    s.seed = seed;
    const std::uint32_t drawn = random.below(12);
    // Half of all are ordinary.
    s.family = family >= 0 ? static_cast<std::uint32_t>(family) : drawn < 6 ? 0 : drawn - 5;
    const std::uint32_t bodies = 4 + random.below(random.one_in(3) ? 44 : 14);
    s.capacity = {.bodies = bodies, .shapes = 2 * bodies + 8, .contacts = 8 * bodies + 16, .joints = bodies};
    if (random.one_in(6)) s.capacity.contacts = 4 + random.below(2 * bodies);
    if (random.one_in(8)) s.capacity.shapes = bodies;
    if (random.one_in(8)) s.capacity.geometries = 3 + random.below(bodies);
    if (random.one_in(8)) s.capacity.hits = 1 + random.below(4);
    if (random.one_in(8)) s.capacity.events = 1 + random.below(6);
    const fuzz::Family& kind = fuzz::families[s.family];
    s.def.gravity = random.one_in(8) ? Vec2{random.between(-1, 1) * kind.gravity, random.between(-1, 1) * kind.gravity} : Vec2{0, -kind.gravity};
    if (random.one_in(8)) s.def.gravity = {0, 0};
    s.def.enable_sleep = !random.one_in(4);
    s.def.continuous = !random.one_in(4);
    if (random.one_in(3)) s.def.restitution_threshold = random.between(0, 2);
    if (random.one_in(3)) s.def.hit_threshold = random.between(0, 2);
    if (random.one_in(6)) s.def.max_speed = random.between(1, 1000);
    SolverDef& d = s.def.solver;
    if (random.one_in(3)) d.substeps = 1 + random.below(6);
    if (random.one_in(5)) d.schedule = Schedule::classic;
    if (random.one_in(3)) d.iterations = 1 + random.below(8);
    if (random.one_in(3)) d.relax_iterations = random.below(4);
    if (random.one_in(4)) d.sweep_order = static_cast<SweepOrder>(random.below(4));
    if (random.one_in(4)) d.joint_trees = static_cast<JointTrees>(random.below(3));
    if (random.one_in(8)) d.block_contacts = true;
    if (random.one_in(8)) d.shock = random.between(0, max_shock);
    if (random.one_in(4)) d.measure_residual = true;
    if (random.one_in(6)) d.tolerance = random.between(0, 0.1f);
    if (random.one_in(8)) d.warm_start = false;
    if (random.one_in(6)) d.omega = random.between(0.5f, 1.9f);
    if (kind.relaxed) d.omega = 1.5f;
    if (random.one_in(4)) d.contact_hertz = random.between(1, 240);
    if (random.one_in(4)) d.contact_damping_ratio = random.between(0, 10);
    s.threads = random.one_in(200);
    return s;
}

const Capacity Stand::largest{.bodies = 64, .shapes = 128, .contacts = 512, .joints = 64};

Stand::Stand()
    : blocks_{test::Block(world_bytes(largest) + spare_bytes), test::Block(world_bytes(largest) + spare_bytes), test::Block(world_bytes(largest) + spare_bytes),
              test::Block(world_bytes(other_room) + spare_bytes), test::Block(world_bytes(largest) + spare_bytes)} {}

void Stand::begin(const Setup& setup, Chorus& all) {
    all.clear();
    static constexpr const char* names[] = {"one lane", "four lanes", "sixteen lanes", "other capacity"};
    test::Random random(setup.seed ^ 0x5bd1e995u);
    for (std::uint32_t i = 0; i < 5; ++i) {
        WorldDef def = setup.def;
        Capacity capacity = setup.capacity;
        if (i == 3) capacity = other_room;
        def.lanes = i == 0 ? 1 : i == 1 ? 4 : i == 2 ? 16 : random.one_in(2) ? 4 : 8;
        if (i == 1) def.tasks = {backwards, nullptr, 2};
        if (i == 2) def.tasks = {setup.threads ? on_threads : odd_first, nullptr, 2};
        Error error = Error::none;
        World* world = World::create(blocks_[i].span().subspan(world_alignment * random.below(spare_bytes / world_alignment)), capacity, def, &error);
        if (world == nullptr) test::broken(describe(error));
        const bool sings = setup.images ? i == 0 || i == 2 - setup.seed % 2 : i < 4;
        if (sings) all.add(world, names[i], i == 3);
        else if (i == 4) all.replayer = world;
    }
}

void Life::refill() {
    for (std::size_t i = 0; i < sizeof bytes_; i += 8) {
        const std::uint64_t bits = random_.bits();
        std::memcpy(bytes_ + i, &bits, 8);
    }
    in = fuzz::Reader(bytes_, sizeof bytes_, *in.family);
}

float Life::usual_step() {
    switch (setup_.seed % 8) {
    case 0: return 1.0f / 120;
    case 1: return 1.0f / 30;
    case 2: return 1.0f / 240;
    default: return 1.0f / 60;
    }
}

// One in three plain, the others with something.
ShapeDef Life::surface() {
    ShapeDef d;
    if (random_.one_in(3)) return d;
    d = shape_def();
    d.filter = random_.one_in(4) ? d.filter : Filter{};
    d.sensor = d.sensor && random_.one_in(3);
    if (!(d.density > 0)) d.density = 1;
    return d;
}

void Life::add_shape(BodyId owner, float size) {
    const ShapeDef def = surface();
    if (in.family->wild > 0 && random_.one_in(4)) size *= random_.one_in(2) ? 1e-2f : 1000;
    const float other = size * (random_.one_in(2) ? 1 : random_.between(0.2f, 1));
    switch (random_.below(7)) {
    case 0:
    case 1: all.create_shape(owner, Circle{{}, size}, def); break;
    case 2: all.create_shape(owner, Capsule{{-size, 0}, {size, 0}, 0.5f * other}, def); break;
    case 3: all.create_shape(owner, make_rounded_box(0.7f * size, 0.7f * other, 0.3f * other), def); break;
    case 4: all.create_shape(owner, polygon(), def); break;
    default: all.create_shape(owner, make_box(size, other), def);
    }
}

BodyId Life::add(Vec2 at, bool dynamic) {
    refill();
    BodyDef d = random_.one_in(4) ? body_def() : BodyDef{};
    d.type = dynamic ? (random_.one_in(12) ? BodyType::kinematic : BodyType::dynamic) : BodyType::static_body;
    d.position = at + in.family->origin;
    d.angle = random_.one_in(3) ? in.number() : 0;
    d.awake = d.awake || !random_.one_in(4);
    return all.create_body(d);
}

// Something to begin with in which much happens.
void Life::furnish() {
    const std::uint32_t kind = random_.below(8), n = setup_.capacity.bodies - std::min(setup_.capacity.bodies - 2, 1 + random_.below(4));
    const Vec2 origin = in.family->origin;
    const BodyId ground = all.create_body(BodyDef{.position = origin});
    if (kind == 4 || kind == 7) {
        const Vec2 hills[] = {{40, 6}, {12, 1}, {6, 0}, {0, 0.5f}, {-6, 0}, {-12, 2}, {-40, 6}};
        all.create_chain(ground, hills, false, surface());
    } else {
        all.create_shape(ground, make_offset_box(40, 1, {{0, -1}, {}}), surface());
    }
    if (kind == 3) {
        for (const float side : {-1.0f, 1.0f}) all.create_shape(ground, make_offset_box(0.1f, 10, {{side * 6, 8}, {}}), ShapeDef{});
        all.create_shape(ground, make_offset_box(8, 0.1f, {{0, 15}, {}}), ShapeDef{});
    }
    const float size = random_.one_in(2) ? 0.5f : random_.between(0.1f, 1);
    BodyId before = ground;
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
        const float k = static_cast<float>(i);
        Vec2 at = {-4 + 2 * size * static_cast<float>(i % 5), size + 2 * size * static_cast<float>(i / 5)};  // a pile
        if (kind == 1) at = {(k - 0.5f * static_cast<float>(n)) * 2.2f * size, size};                             // a row
        if (kind == 2) at = {0, size + 2 * size * k};                                                         // a tower
        if (kind == 3) at = {random_.between(-5, 5), random_.between(1, 14)};                                 // a room
        if (kind == 6) at = {0, 2};                                                                           // a crowd
        const BodyId made = add(at);
        if (!made) break;
        if (random_.one_in(16) && kind != 1) continue;
        add_shape(made, size);
        if (random_.one_in(8)) add_shape(made, 0.5f * size);
        if (kind == 3 || kind == 1) all.set_linear_velocity(made, Vec2{random_.between(-8, 8), kind == 1 ? 0 : random_.between(-8, 8)});
        if (kind == 5 || (kind == 7 && random_.one_in(2))) {  // a chain of hinges and others
            refill();
            const Vec2 middle = 0.5f * (w.position(before) + w.position(made));
            const JointBase base = {.body_a = before, .body_b = made, .frame_a = {inv_transform_point(w.transform(before), middle), 0},
                                    .frame_b = {inv_transform_point(w.transform(made), middle), 0}, .collide_connected = random_.one_in(2)};
            switch (random_.below(7)) {
            case 3: {
                const JointLimit limit = {.enable = random_.one_in(2), .lower = -0.5f, .upper = 0.5f};
                all.create_joint(AngleJointDef{.base = base, .limit = limit, .ratchet = {.step = random_.one_in(2) ? 0.0f : 0.2f}});
                break;
            }
            case 0: all.create_joint(WeldJointDef{.base = base, .angular_hertz = random_.one_in(2) ? 0.0f : 5.0f}); break;
            case 1: all.create_joint(DistanceJointDef{.base = base, .length = size, .spring = {.enable = random_.one_in(2), .hertz = 3}}); break;
            case 2: all.create_joint(PrismaticJointDef{.base = base, .limit = {.enable = true, .lower = -0.5f, .upper = 0.5f}}); break;
            default: all.create_joint(RevoluteJointDef{.base = base, .motor = {.enable = random_.one_in(4), .speed = 2, .max_force = 10}});
            }
        }
        before = made;
    }
    for (std::uint32_t i = random_.below(4); i > 0; --i) {
        refill();
        create_joint();
    }
}

void Life::change() {
    refill();
    w.clear_error();
    const std::uint64_t before = w.hash();
    switch (random_.below(20)) {
    case 0: all.create_body(body_def()); break;
    case 1: {
        const Vec2 at = {random_.between(-5, 5), random_.between(0, 5)};
        if (const BodyId made = add(at)) add_shape(made, 0.5f);
        return;
    }
    case 2:
    case 3: create_shape(body()); break;
    case 4: create_joint(); break;
    case 5:
    case 6:
    case 7:
    case 8:
    case 9: change_body(); break;
    case 10:
    case 11:
    case 12:
    case 13: change_shape(); break;
    case 14:
    case 15: change_joint(); break;
    case 16: {  // what made a contact special, taken away
        const ShapeId s = shape();
        switch (in.below(5)) {
        case 0: all.set_rolling_resistance(s, 0.0f); break;
        case 1: all.set_restitution(s, 0.0f); break;
        case 2: all.set_tangent_speed(s, 0.0f); break;
        case 3: all.set_friction(s, 0.0f); break;
        default: all.set_material(s, SurfaceMaterial{});
        }
        break;
    }
    case 17: {  // a soft push for something
        const BodyId b = body();
        all.apply_linear_impulse_to_center(b, Vec2{random_.between(-3, 3), random_.between(-3, 3)} * (w.mass(b) > 0 ? w.mass(b) : 1.0f));
        break;
    }
    case 18: {
        const std::uint32_t low = in.byte();
        set_hooks(random_.one_in(3) ? 0 : low | in.below(2) << 8 | 1);
        return;
    }
    default: change_world();
    }
    const Error error = w.last_error();
    if (error != Error::none && error != Error::events_full && error != Error::recording_full && w.hash() != before) test::broken("a refused call changed the world");
}

void Life::call() {
    const std::uint32_t what = random_.below(32);
    if (setup_.dense && what < 16 && what % 8 != 0) return change();
    if (what < 16) {
        if (setup_.dense) return all.step(usual_step());
        for (std::uint32_t i = 1 + random_.below(random_.one_in(8) ? 40 : 6); i > 0; --i) all.step(usual_step());
        return;
    }
    if (what == 16) {
        refill();
        float dt = 0.01f * in.size();
        switch (random_.below(5)) {
        case 0: dt = 1; break;
        case 1: dt = in.size(); break;
        case 2: {  // any at all
            const float powers[] = {1e-2f, 1e-4f, 1e-6f, 1e-9f, 1e-12f, 1e-18f, 1e-24f, 1e-36f, 1e-44f};
            dt = powers[random_.below(9)];
            break;
        }
        default: break;
        }
        all.step(dt);
        return;
    }
    if (what == 17) return all.travel(random_.below(3));
    if (what == 18) return random_.one_in(2) ? all.begin_recording() : all.end_recording();
    change();
}

void play(const Setup& setup, Chorus& all, std::uint32_t calls) {
    test::Random random(setup.seed * 3 + 1);
    Life life(all, random, setup);
    if (random.one_in(6)) life.set_hooks(random.below(512) | 1);
    if (!random.one_in(10)) life.furnish();
    if (random.one_in(4)) all.begin_recording();
    all.travel(0);
    const std::uint32_t n = 10 + random.below(random.one_in(4) ? 200 : 60);
    for (std::uint32_t i = 0; i < n && i < calls; ++i) life.call();
    all.compare(false);
    all.check();
    all.end_recording();
}

}  // namespace islet::lockstep
