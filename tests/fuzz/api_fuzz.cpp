// The whole public API, called by a fuzzer. Each input is a list of calls, good and bad, on a world so small that every one of its pools fills up: ids
// of living, dead and never born objects; numbers that are ordinary, extreme or no numbers at all. The calls stand in api/, an area a file.
//
// Three worlds, of one lane, four and sixteen, are given the same calls, and must be equal after each step; after each call they must be as they were if it
// was refused, and after each step sound, with every body at a finite place. A world that is loaded from a snapshot must have the same future. Prints how many calls were made and how many refused when it ends.
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
    const BodyId ground = all.create_body(BodyDef{.position = Vec2{0, -1} + in.family->origin});
    all.create_shape(ground, make_box(20, 1), ShapeDef{});
    BodyId below = ground;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const BodyId box = all.create_body(BodyDef{.type = BodyType::dynamic, .position = Vec2{0, 0.5f + static_cast<float>(i)} + in.family->origin});
        all.create_shape(box, make_box(0.5f, 0.5f), ShapeDef{});
        if (i > 0) all.create_joint(RevoluteJointDef{.base = {.body_a = below, .body_b = box, .frame_a = {{0, 0.5f}}, .frame_b = {{0, -0.5f}}}});
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
        all.step(1.0f / 60);
        ++f.steps;
        // What it does to one world it does to the others.
        const MoverState before = mover;
        const bool walked = step_mover(w, def, mover, input, 1.0f / 60);
        for (std::uint32_t k = 1; k < all.size(); ++k) {
            MoverState other = before;
            step_mover(*all.voice(k).world, def, other, input, 1.0f / 60);
            expect(other.position.x == mover.position.x && other.position.y == mover.position.y, "a mover goes elsewhere in another world");
        }
        all.compare(false);
        if (!walked) break;
    }
    if (!is_finite(mover.position) || !is_finite(mover.velocity)) test::broken("a mover is nowhere");
    check();
}

void Player::step() {
    const std::uint32_t how = in.byte();
    if (f.trace) print(w);
    if (how >= 250) {
        const float dt = in.number();
        if (f.trace) std::fprintf(stderr, "  a step of %g s\n", double(dt));
        all.step(dt);
        return;
    }
    for (std::uint32_t i = 0; i <= how % 8; ++i) {
        all.step(how % 16 < 12 ? 1.0f / 60 : 1.0f / (1 + static_cast<float>(how / 16)));
        ++f.steps;
    }
}

void Player::check() {
    if (f.trace && w.validate() != nullptr) print(w);
    all.check();
}

// A recording does not hold them: one that goes on ends, and is replayed with those that it was made with.
void Player::set_hooks(std::uint32_t number) {
    replay_all();
    recorded = {};
    errors_told = 0;
    all.set_hooks(number);
    twin.set_hooks(w.hooks());
}

// No part of the state: nothing may depend on it.
void Player::change_host() {
    const std::uint64_t hash = w.hash();
    w.set_tasks(in.below(4) == 0 ? TaskSystem{nullptr, nullptr, in.byte()} : backwards_tasks(in.below(8)));
    w.set_clock(in.flag() ? count_ticks : nullptr);
    if (in.flag()) move_recording();
    expect(w.hash() == hash, "the clock or the workers are part of the state");
}

void Player::play() {
    if (in.below(4) == 0) set_hooks(in.byte() | 1);
    if (in.flag()) furnish();
    if (in.flag()) start_recording();
    for (int i = 0; i < 300 && !in.done(); ++i) {
        ++f.calls;
        const std::uint32_t what = in.below(33);
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
        if (what == 32) {
            change_host();
            continue;
        }
        w.clear_error();
        errors_told = 0;
        const std::uint64_t before = w.hash();
        if (what < 13) {
            const BodyId made = all.create_body(body_def());
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
        if (error != Error::events_full && error != Error::recording_full && what != 31 && w.hash() != before) test::broken("a refused call changed the world");
    }
    check();
    replay_all();
}

}  // namespace islet::fuzz

namespace islet::test {

void broken(const char* what) {
    std::fprintf(stderr, "islet_fuzz_api: %s\n", what);
    std::abort();
}

}  // namespace islet::test

// The same calls go to a world of one lane, one of four and one of eight, whose workers come in other orders; after each step they are compared.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace islet;
    using namespace islet::fuzz;
    Fixture& f = fixture();
    ++f.inputs;
    Reader in(data, size);
    in.family = &families[size % std::size(families)];
    WorldDef def;
    {
        static StaticWorld<capacity> none;
        test::Chorus nobody;
        nobody.add(&none.create(), "");
        Caller caller(nobody, in);
        if (caller.in.flag()) def = caller.world_def();
        in = caller.in;
    }
    WorldDef twin_def = def;  // differs in what must not make a difference
    twin_def.lanes = 4;
    twin_def.tasks = backwards_tasks(4);
    f.all.clear();
    static constexpr const char* names[] = {"one lane", "four lanes", "sixteen lanes"};
    for (std::uint32_t i = 0; i < 3; ++i) {
        def.lanes = i == 0 ? (def.lanes == 3 ? 3 : 1) : i == 1 ? 4 : 16;  // (3 is refused)
        if (i == 0) def.error_hook = [](Error, void*) { ++errors_told; };
        World& made = f.storage[i].create(def);
        if (i == 0 && made.last_error() != Error::none) {  // what is refused falls back to this; but it is to have the hook
            def = {};
            twin_def = {};
            --i;
            continue;
        }
        f.all.add(&made, names[i]);
        def.error_hook = nullptr;
        def.tasks = backwards_tasks(2 + i);
    }
    Player player(f.twin_storage.create(twin_def), f, in);
    player.play();
    return 0;
}
