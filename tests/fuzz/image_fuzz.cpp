// Images and deltas from a fuzzer. Each input is a list of edits of an image (or a delta) of a world in which everything there is occurs; in the small profile,
// of one with boxes, balls, triangles and three kinds of joints. Checksums are made right afterwards, so that what gets through the gate is decided by what
// the image holds. Every third input is taken as it is instead, checksum and all.
//
// What is refused must leave the world as it was; what is accepted is stepped 10 times on one, four and sixteen lanes, with disabled bodies enabled and masses
// worked out anew on the way, and must stay sound and equal. Prints how many were accepted
// when it ends.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "support/busy_world.hpp"
#include "support/chorus.hpp"
#include "support/forge.hpp"
#include "state/image.hpp"

namespace {

using namespace islet;
using namespace islet::test;

[[noreturn]] void fail(const char* what) {
    std::fprintf(stderr, "islet_fuzz_images: %s\n", what);
    std::abort();
}

#if ISLET_SMALL
void fill(World& w) {
    w.create_shape(w.create_body({.position = {0, -1}}), make_box(20, 1), {.restitution = 0.3f});
    w.create_shape(w.create_body({.position = {9, 1}, .angle = 0.3f}), make_box(3, 0.5f), {.friction = 0.1f});
    BodyId last{};
    for (int i = 0; i < 15; ++i) {
        const auto x = static_cast<float>(i % 5), y = static_cast<float>(i / 5);
        const BodyId body = w.create_body({.type = BodyType::dynamic, .position = {2.2f * x - 4, 0.6f + 1.1f * y}, .angle = 0.1f * x});
        if (i % 3 == 0) w.create_shape(body, make_box(0.5f, 0.5f));
        if (i % 3 == 1) w.create_shape(body, Circle{{0.1f, 0}, 0.5f}, {.restitution = 0.5f});
        if (i % 3 == 2) w.create_shape(body, make_rounded_box(0.4f, 0.3f, 0.1f), {.friction = 0.9f});
        if (i == 4) w.create_joint(RevoluteJointDef{.base = {.body_a = last, .body_b = body}});
        if (i == 9) w.create_joint(PrismaticJointDef{.base = {.body_a = last, .body_b = body}});
        if (i == 14) w.create_joint(DistanceJointDef{.base = {.body_a = last, .body_b = body}});
        last = body;
    }
}
#else
void fill(World& w) { fill_busy(w); }
#endif

struct Fixture {
    StaticWorld<busy_capacity> source_storage, victim_storage, four_storage, sixteen_storage;
    World& source = source_storage.create();
    World& victim = victim_storage.create({.lanes = 1});
    Chorus all;  // the victim, and what it must stay equal to
    Image before, after, packed, out;
    unsigned long tried = 0, accepted = 0, applied = 0;

    Fixture() {
        all.add(&victim, "one lane");
        all.add(&four_storage.create({.lanes = 4}), "four lanes");
        all.add(&sixteen_storage.create({.lanes = 16}), "sixteen lanes");
        fill(source);
        if (source.last_error() != Error::none) fail("the world it starts from was refused");
        before = save(source);
        for (int i = 0; i < 4; ++i) source.step(1.0f / 60);
        after = save(source);
        packed = Image(max_delta_bytes(after.bytes().size()));
        const std::size_t n = delta(before.bytes(), after.bytes(), packed.bytes());
        Image exact(n);
        std::memcpy(exact.bytes().data(), packed.bytes().data(), n);
        packed = exact;
        out = Image(max_snapshot_bytes(busy_capacity));
        if (!victim.load(before.bytes())) fail("the image it starts from is refused");
    }
    ~Fixture() { std::fprintf(stderr, "%lu inputs: %lu images accepted, %lu deltas applied\n", tried, accepted, applied); }
};

Fixture& fixture() {
    static Fixture f;
    return f;
}

/// Reads the fuzzer's bytes one after the other; zeros at the end.
struct Reader {
    const std::uint8_t* at;
    const std::uint8_t* end;
    bool done() const { return at == end; }
    std::uint32_t byte() { return at < end ? *at++ : 0; }
    std::uint32_t number() {
        const std::uint32_t low = byte();
        return low | byte() << 8;
    }
};

// An edit: set a word to a small number, to another word of the image, to bits that are special, or flip a bit.
void edit(std::span<std::byte> bytes, Reader& in) {
    const std::size_t words = bytes.size() / 4;
    const auto word_at = [&](std::size_t i) {
        std::uint32_t w = 0;
        std::memcpy(&w, bytes.data() + 4 * (i % words), 4);
        return w;
    };
    while (!in.done()) {
        const std::uint32_t kind = in.byte();
        const std::size_t at = in.number() % words;
        const std::uint32_t value = in.number();
        constexpr std::uint32_t special[] = {0, 0xffffffffu, 0x7fc00000u, 0x7f800000u, 0xff800000u, 0x7f7fffffu, 0x80000000u, 0x00000001u,
                                             0x3f800000u, 0x00800000u, 0x7fffffffu, 0x4b189680u};
        std::uint32_t w = word_at(at);
        switch (kind % 8) {
        case 0: w = value; break;
        case 1: w = word_at(value); break;
        case 2: w = special[value % std::size(special)]; break;
        case 3: w ^= 1u << (value % 32); break;
        case 4: w += value; break;
        case 5: w -= value; break;
        case 6: w = value << 16 | (w & 0xffffu); break;
        default: {  // a whole run of words from elsewhere
            const std::size_t length = value % 64;
            const std::size_t from = in.number() % words;
            for (std::size_t k = 0; k < length && at + k < words; ++k) {
                const std::uint32_t other = word_at(from + k);
                std::memcpy(bytes.data() + 4 * (at + k), &other, 4);
            }
            continue;
        }
        }
        std::memcpy(bytes.data() + 4 * at, &w, 4);
    }
}

void attack(Fixture& f, std::span<const std::byte> image) {
    const std::uint64_t hash = f.victim.hash();
    if (!f.victim.load(image)) {
        if (f.victim.hash() != hash) fail("a refused image changed the world");
        return;
    }
    ++f.accepted;
    for (std::uint32_t k = 1; k < f.all.size(); ++k)
        if (!f.all.voice(k).world->load(image)) fail("an image is loaded by one world and refused by another");
    for (int i = 0; i < 10; ++i) {
        f.all.step(1.0f / 60);
        if (i != 1) continue;
        for (std::uint32_t slot = 0; slot < busy_capacity.bodies; ++slot) {  // what was hidden comes out
            const BodyId b = f.victim.body_at(slot);
            if (!b) continue;
            if (!f.victim.is_enabled(b)) f.all.set_enabled(b, true);
            if (slot % 4 == 0) f.all.reset_mass(b);
        }
    }
    f.all.compare(false);
    f.all.check();
    if (!f.victim.restore(f.before.bytes())) fail("the world no longer goes back");
}

}  // namespace

namespace islet::test {

void broken(const char* what) {
    std::fprintf(stderr, "islet_fuzz_images: %s\n", what);
    std::abort();
}

}  // namespace islet::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Fixture& f = fixture();
    ++f.tried;
    Reader in{data, data + size};
    const std::uint32_t what = in.byte();
    if (what % 3 == 0) {  // an image, forged
        Image forged = what % 2 == 0 ? f.before : f.after;
        edit(forged.bytes(), in);
        seal(forged.bytes());
        attack(f, forged.bytes());
    } else if (what % 3 == 1) {  // a delta, forged
        Image forged = f.packed;
        edit(forged.bytes(), in);
        seal(forged.bytes());
        if (apply(f.before.bytes(), forged.bytes(), f.out.bytes()) == 0) {
            // An attacker knows what his delta leads to, and writes that image's checksum into it. What it led to lies in `out`.
            detail::ImageHeader h = header_of(f.out.bytes());
            if (h.head.length < sizeof h || h.head.length > f.out.bytes().size()) return 0;
            h.head.checksum = detail::image_checksum(f.out.bytes().first(static_cast<std::size_t>(h.head.length)));
            std::memcpy(forged.bytes().data() + detail::delta_header_bytes, &h, sizeof h.head);
            seal(forged.bytes());
        }
        const std::size_t n = apply(f.before.bytes(), forged.bytes(), f.out.bytes());
        if (n == 0) return 0;
        ++f.applied;
        attack(f, f.out.bytes().first(n));
    } else {  // bytes as they are, aligned
        Image raw(static_cast<std::size_t>(in.end - in.at));
        std::copy(in.at, in.end, reinterpret_cast<std::uint8_t*>(raw.bytes().data()));
        attack(f, raw.bytes());
        if (apply(f.before.bytes(), raw.bytes(), f.out.bytes()) != 0) ++f.applied;
        if (apply(raw.bytes(), f.packed.bytes(), f.out.bytes()) != 0) ++f.applied;
    }
    return 0;
}
