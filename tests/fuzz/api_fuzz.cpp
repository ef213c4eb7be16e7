// The whole public API, called by a fuzzer. Each input is a list of calls, good and bad, on a world so small that every one of its pools fills up: ids
// of living, dead and never born objects; numbers that are ordinary, extreme or no numbers at all. The calls stand in api/, an area a file.
//
// After each call the world must be as it was if the call was refused, and after each step it must be sound, with every body at a finite place. A world
// that is loaded from a snapshot must have the same future. Prints how many calls were made and how many refused when it ends.
#include "fuzz/api/hosts.hpp"
#include "fuzz/api/player.hpp"

namespace islet::fuzz {

namespace {

Fixture& fixture() {
    static Fixture f;
    return f;
}

unsigned errors_told = 0;  // to the error hook, since the last call began

}  // namespace

Fixture::Fixture()
    : spare(world_bytes({.bodies = 16, .shapes = 16, .contacts = 16, .joints = 8}) + 64),
      image(max_snapshot_bytes(capacity)),
      earlier(image.size()),
      packed(max_delta_bytes(image.size())),
      unpacked(image.size()),
      recording(1 << 20),
      longer_recording(1 << 21),
      island(1 << 16) {}

Fixture::~Fixture() { std::fprintf(stderr, "%lu inputs: %lu calls, %lu of them refused, %lu steps\n", inputs, calls, refused, steps); }

// Something to begin with, so that short inputs reach contacts and joints too.
void Player::furnish() {
    const BodyId ground = w.create_body({.position = {0, -1}});
    w.create_shape(ground, make_box(20, 1));
    BodyId below = ground;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const BodyId box = w.create_body({.type = BodyType::dynamic, .position = {0, 0.5f + static_cast<float>(i)}});
        w.create_shape(box, make_box(0.5f, 0.5f));
        if (i > 0) w.create_joint(RevoluteJointDef{.base = {.body_a = below, .body_b = box, .frame_a = {{0, 0.5f}}, .frame_b = {{0, -0.5f}}}});
        below = box;
    }
}

void Player::walk() {
    MoverDef def;
    MoverInput input;
    const std::uint32_t more = in.byte();
    if ((more & 1) != 0) def.capsule = capsule();
    if ((more & 2) != 0) def.up = normalize(in.point());
    if ((more & 4) != 0) def.max_slope = in.size();
    if ((more & 8) != 0) def.step_height = in.size();
    if ((more & 16) != 0) def.mass = in.size() * 50;
    if ((more & 32) != 0) def.max_push_force = in.size() * 200;
    if ((more & 64) != 0) def.snap_distance = in.size();
    if ((more & 128) != 0) def.collides = [](const Surface& surface, void*) { return surface.shape.index1 % 3 != 0; };
    input.walk = in.number();
    input.jump = in.below(4) == 0 ? in.size() : 0;
    for (std::uint32_t i = in.below(8) + 1; i > 0; --i) {
        w.step(1.0f / 60);
        ++f.steps;
        if (!step_mover(w, def, mover, input, 1.0f / 60)) break;
    }
    if (!is_finite(mover.position) || !is_finite(mover.velocity)) fail("a mover is nowhere");
    check();
}

void Player::step() {
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

void Player::check() {
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

void Player::play() {
    if (in.below(4) == 0) {
        w.set_hooks(hooks);
        twin.set_hooks(hooks);
    }
    if (in.flag()) furnish();
    if (in.flag()) start_recording();
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
        errors_told = 0;
        const std::uint64_t before = w.hash();
        if (what < 13) {
            const BodyId made = w.create_body(body_def());
            expect(bool(made) || w.last_error() != Error::none, "no body was made, and nobody says why");
            if (made) continue;
        } else if (what < 18) {
            create_shape(body());
        } else if (what < 21) {
            create_joint();
        } else if (what < 25) {
            change_body();
        } else if (what < 27) {
            change_shape();
        } else if (what < 29) {
            change_joint();
        } else if (what < 31) {
            change_world();
        } else {
            read();
        }
        const Error error = w.last_error();
        expect((error != Error::none) == (errors_told != 0), "the error hook and the last error disagree");
        if (error == Error::none) continue;
        if (what != 31) ++f.refused;
        // What ends a contact may find no room to report it, and goes on.
        if (error != Error::events_full && error != Error::recording_full && what != 31 && w.hash() != before) fail("a refused call changed the world");
    }
    check();
    replay_all();
}

}  // namespace islet::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace islet;
    using namespace islet::fuzz;
    Fixture& f = fixture();
    ++f.inputs;
    WorldDef twin_def;  // differs in what must not make a difference
    twin_def.lanes = size % 2 == 0 ? 1 : 4;
    if (size % 3 == 0) twin_def.tasks = backwards_tasks(4);
    World& twin = f.twin_storage.create(twin_def);
    Player player{f.storage.create(), twin, f, Reader(data, size)};
    WorldDef def = player.in.flag() ? player.world_def() : WorldDef{};
    for (const bool last : {false, true}) {
        def.error_hook = [](Error, void*) { ++errors_told; };
        f.storage.create(def);  // in the same block, so it is the same world
        if (last || player.w.last_error() == Error::none) break;
        def = {};  // what is refused falls back to this; but it is to have the hook
    }
    player.play();
    return 0;
}
