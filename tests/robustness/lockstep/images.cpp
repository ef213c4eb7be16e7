#include "images.hpp"

#include "support/busy_world.hpp"
#include "support/forge_recording.hpp"

namespace islet::lockstep {

namespace {

using test::Random;
using Words = std::vector<std::uint64_t>;

std::span<std::byte> bytes_of(Words& words) { return {reinterpret_cast<std::byte*>(words.data()), words.size() * 8}; }
std::span<const std::byte> bytes_of(const Words& words) { return {reinterpret_cast<const std::byte*>(words.data()), words.size() * 8}; }

struct Edit {
    std::uint32_t at, word;  // the 32-bit word that is written
};

std::uint32_t word_at(const Words& image, std::size_t at) {
    std::uint32_t w = 0;
    std::memcpy(&w, bytes_of(image).data() + 4 * at, 4);
    return w;
}

/// Loads an image with some words changed and its checksum made right.
struct LoadDeed final : test::Deed {
    std::shared_ptr<const Words> base;
    std::vector<Edit> edits;

    Words forged() const {
        Words image = *base;
        for (const Edit& e : edits) std::memcpy(bytes_of(image).data() + 4 * e.at, &e.word, 4);
        if (!edits.empty()) test::seal(bytes_of(image));
        return image;
    }
    void run(Chorus& all) const override;
    std::string text() const override {
        std::string s = "{\n" + what_changed() + "        static const unsigned long long image[] = {";
        char word[32];
        for (const std::uint64_t w : forged()) {
            std::snprintf(word, sizeof word, "0x%llx,", static_cast<unsigned long long>(w));
            s += word;
        }
        return s + "};\n        load(image, sizeof image);\n    }";
    }
    std::string what_changed() const {
        std::string s;
        const detail::ImageHeader h = test::header_of(bytes_of(*base));
        for (const Edit& e : edits) {
            std::size_t at = sizeof h / 4, part = 0;
            char line[160];
            std::snprintf(line, sizeof line, "        // word %u of the header or behind: %08x instead of %08x\n", e.at, e.word, word_at(*base, e.at));
            detail::Core nowhere;
            detail::for_each_part(nowhere, h, [&](const auto* pointer, std::uint64_t bytes) {
                const std::size_t record = sizeof *pointer / 4, words = static_cast<std::size_t>(bytes / 4);
                const float f = __builtin_bit_cast(float, e.word), old = __builtin_bit_cast(float, word_at(*base, e.at));
                if (e.at >= at && e.at < at + words)
                    std::snprintf(line, sizeof line, "        // %s, record %d, word %d of %d: %08x (%g) instead of %08x (%g)\n",
                                  part < std::size(test::chorus_detail::part_names) ? test::chorus_detail::part_names[part] : "events waiting",
                                  int((e.at - at) / record), int((e.at - at) % record), int(record), e.word, double(f), word_at(*base, e.at), double(old));
                at += words;
                ++part;
            });
            s += line;
        }
        return s;
    }
    std::uint32_t numbers() const override { return static_cast<std::uint32_t>(edits.size()); }
    std::shared_ptr<const Deed> simpler(std::uint32_t k, std::uint32_t how) const override {
        if (how != 0 || k >= edits.size()) return nullptr;
        auto other = std::make_shared<LoadDeed>(*this);
        other->edits.erase(other->edits.begin() + k);
        return other;
    }
};

/// True if it was loaded: by all or by none.
bool load(Chorus& all, std::span<const std::byte> image) {
    const std::uint64_t before = all.first().hash();
    const bool loaded = all.first().load(image);
    if (!loaded && all.first().hash() != before) test::broken("a refused image changed the world");
    if (!loaded) return false;
    for (std::uint32_t i = 1; i < all.size(); ++i)
        if (!all.voice(i).world->load(image)) test::broken("an image is loaded by one world and refused by another");
    all.compare(false);
    if (const char* fault = all.first().validate()) test::broken(fault);
    return true;
}

void LoadDeed::run(Chorus& all) const {
    all.log_deed(all.log != nullptr ? std::make_shared<LoadDeed>(*this) : nullptr);
    const Words image = forged();
    load(all, bytes_of(image));
}

/// A word that an attacker would write.
std::uint32_t evil(std::uint32_t old, Random& random) {
    constexpr std::uint32_t special[] = {0, 0xffffffffu, 0x7fc00000u, 0x7f800000u, 0xff800000u, 0x7f7fffffu, 0x80000000u, 1u, 2u, 3u, 0x3f800000u, 0xbf800000u,
                                         0x00800000u, 0x7fffffffu, 0x4b189680u, 0xcb189680u, 0x0da24260u, 0x7149f2cau, 0x4b18967fu, 0x3f000000u};
    const float f = __builtin_bit_cast(float, old);
    switch (random.below(9)) {
    case 0:
    case 1: return special[random.below(std::size(special))];
    case 2: return old ^ 1u << random.below(32);
    case 3: return old + (random.one_in(2) ? 1 : 0xffffffffu);
    case 4: {
        constexpr float by[] = {-1, 1.0000002f, 0.5f, 2, 10, 1e-3f, 1e3f, 1e9f, 1e-9f, 1e20f};
        return __builtin_bit_cast(std::uint32_t, f * by[random.below(10)]);
    }
    case 5: return __builtin_bit_cast(std::uint32_t, random.between(-20, 20));
    case 6: return random.below(64);
    case 7: return __builtin_bit_cast(std::uint32_t, f + random.between(-1, 1));
    default: return static_cast<std::uint32_t>(random.bits());
    }
}

// Field-wise: a word of a record of one of the image's arrays, made evil, or as in another record.
void add_edits(const Words& image, std::vector<Edit>& edits, Random& random) {
    const detail::ImageHeader h = test::header_of(bytes_of(image));
    struct Part {
        std::size_t begin, words, record;
    };
    Part parts[24];
    std::uint32_t n = 0;
    std::size_t at = sizeof h / 4;
    detail::Core nowhere;
    detail::for_each_part(nowhere, h, [&](const auto* pointer, std::uint64_t bytes) {
        if (bytes > 0) parts[n++] = {at, static_cast<std::size_t>(bytes / 4), sizeof *pointer / 4};
        at += static_cast<std::size_t>(bytes / 4);
    });
    const auto write = [&](std::size_t where, std::uint32_t word) { edits.push_back({static_cast<std::uint32_t>(where), word}); };
    for (std::uint32_t i = 1 + (random.one_in(2) ? random.below(4) : 0); i > 0; --i) {
        if (random.one_in(64)) {  // the header, or anything
            const std::size_t where = random.one_in(2) ? random.below(sizeof h / 4) : random.below(static_cast<std::uint32_t>(image.size() * 2));
            write(where, evil(word_at(image, where), random));
            continue;
        }
        const Part& part = parts[random.below(n)];
        const auto records = static_cast<std::uint32_t>(part.words / part.record);
        const std::size_t record = random.below(records), field = random.below(static_cast<std::uint32_t>(part.record));
        const std::size_t where = part.begin + record * part.record + field;
        if (random.one_in(8)) {  // a box, or another vector: both of its numbers
            for (std::size_t k = 0; k < 4 && field + k < part.record; ++k) write(where + k, evil(word_at(image, where + k), random));
        } else if (random.one_in(6)) {
            write(where, word_at(image, part.begin + random.below(records) * part.record + field));
        } else if (random.one_in(12) && part.record == 4) {  // larger or smaller on all sides
            const float by = random.one_in(2) ? random.between(0, 4) : -0.01f;
            for (std::size_t k = 0; k < 4; ++k) {
                const float f = __builtin_bit_cast(float, word_at(image, where - field + k));
                write(where - field + k, __builtin_bit_cast(std::uint32_t, k < 2 ? f - by : f + by));
            }
        } else {
            write(where, evil(word_at(image, where), random));
        }
    }
}

}  // namespace

ImageHunt::ImageHunt() {
    static StaticWorld<Capacity{.bodies = 2, .shapes = 2, .contacts = 2}> storage;
    World& w = storage.create();
    w.create_shape(w.create_body({.type = BodyType::dynamic}), Circle{});
    home_.resize(w.snapshot_bytes() / 8);
    w.save(bytes_of(home_));
}

Setup ImageHunt::setup(std::uint64_t seed) {
    Setup s;
    s.seed = seed;
    s.capacity = {.bodies = 40, .shapes = 64, .contacts = 160, .joints = 16};
    s.images = true;
    return s;
}

ImageHunt::Base ImageHunt::make_base(std::uint64_t seed) {
    Base base;
    for (int tries = 0; tries < 100; ++tries, seed += 0x10000) {
        Setup setup = setup_of(seed, -1);
        setup.capacity = {.bodies = 3 + static_cast<std::uint32_t>(seed % 5), .shapes = 16, .contacts = 24, .joints = 5};
        if (seed % 16 == 15) setup.capacity = test::busy_capacity;
        setup.images = true;
        Chorus all;
        stand_.begin(setup, all);
        World& w = all.first();
        all.clear();
        all.add(&w, "");  // one is enough here
        all.checks = false;
        try {
            Random random(seed);
            Life life(all, random, setup);
            if (seed % 16 == 15) test::fill_busy(w);
            else life.furnish();
            for (std::uint32_t i = seed % 16 == 15 ? 0 : random.below(12); i > 0; --i) life.call();
            if (w.body_count() == 0 || w.validate() != nullptr) continue;
            if (w.is_recording()) w.stop_recording();
            base.image.resize(w.snapshot_bytes() / 8);
            w.save(bytes_of(base.image));
            Words tape(1 << 13);
            const bool records = w.start_recording(bytes_of(tape));
            for (std::uint32_t i = 0; i < 6; ++i) {
                life.change();
                w.step(1.0f / 60);
            }
            base.recording_bytes = records && w.is_recording() ? w.stop_recording() : 0;
            tape.resize((base.recording_bytes + 7) / 8);
            base.recording = tape;
            base.later.resize(w.snapshot_bytes() / 8);
            w.save(bytes_of(base.later));
            if (w.validate() != nullptr) continue;
        } catch (const Broken&) {
            continue;  // that is for who hunts worlds
        }
        base.delta.resize(max_delta_bytes(base.later.size() * 8) / 8 + 1);
        base.delta_bytes = delta(bytes_of(base.image), bytes_of(base.later), bytes_of(base.delta));
        base.delta.resize((base.delta_bytes + 7) / 8);
        return base;
    }
    test::broken("no world to make images of can be made");
}

void ImageHunt::fill(std::uint64_t bank) {
    if (bank == bank_) return;
    bank_ = bank;
    bases_.clear();
    for (std::uint64_t i = 0; i < 32; ++i) bases_.push_back(make_base(bank * 32 + i + 1));
}

void ImageHunt::attack(std::uint64_t seed, Chorus& all) {
    fill(seed >> 16);
    Random random(seed);
    const Base& base = bases_[random.below(static_cast<std::uint32_t>(bases_.size()))];
    bool& at_home = at_home_[seed % 2];
    if (!at_home || all.log != nullptr) {
        if (all.log != nullptr) {  // the finding's calls begin with it
            auto deed = std::make_shared<LoadDeed>();
            deed->base = std::make_shared<Words>(home_);
            deed->run(all);
            all.told = 0;
        } else if (!load(all, bytes_of(home_))) {
            test::broken("the image to begin with is refused");
        }
    }
    at_home = true;
    const Setup setup = ImageHunt::setup(seed);

    if (recordings_alone && base.recording_bytes == 0) return;
    if (base.recording_bytes > 0 && (random.one_in(32) || recordings_alone)) {  // a recording with something else in it
        scratch_ = base.recording;
        std::span<std::byte> bytes = bytes_of(scratch_).first(base.recording_bytes);
        std::uint64_t image_bytes = 0;
        std::memcpy(&image_bytes, bytes.data() + offsetof(detail::RecordingHead, image_bytes), 8);
        const std::size_t calls = detail::calls_at(image_bytes);
        for (std::uint32_t i = 1 + random.below(3); i > 0; --i) {
            const std::size_t at = random.one_in(8) ? random.below(static_cast<std::uint32_t>(bytes.size() / 4))
                                                    : calls / 4 + random.below(static_cast<std::uint32_t>((bytes.size() - calls) / 4));
            const std::uint32_t word = evil(word_at(scratch_, at), random);
            std::memcpy(bytes.data() + 4 * at, &word, 4);
        }
        const ReplayResult result = test::replay_forged(all.first(), bytes);
        ++replays;
        if (result.end == ReplayEnd::complete) ++complete_replays;
        if (const char* fault = all.first().validate()) test::broken(fault);
        all.check();
        for (std::uint32_t i = 0; i < all.size(); ++i) all.voice(i).world->set_hooks({});
        at_home = false;
        return;
    }
    auto deed = std::make_shared<LoadDeed>();
    if (random.one_in(16)) {  // a delta: what it leads to is an image, whose checksum an attacker makes right
        scratch_ = base.delta;
        for (std::uint32_t i = 1 + random.below(3); i > 0; --i) {
            const std::size_t at = detail::delta_header_bytes / 4 + random.below(static_cast<std::uint32_t>((base.delta_bytes - detail::delta_header_bytes) / 4));
            const std::uint32_t word = evil(word_at(scratch_, at), random);
            std::memcpy(bytes_of(scratch_).data() + 4 * at, &word, 4);
        }
        const std::span<std::byte> packed = bytes_of(scratch_).first(base.delta_bytes);
        test::seal(packed);
        static Words out;
        out.resize(max_snapshot_bytes(Stand::largest) / 8 + 1);
        std::size_t n = apply(bytes_of(base.image), packed, bytes_of(out));
        if (n == 0) {
            detail::ImageHeader h = test::header_of(bytes_of(out));
            if (h.head.length < sizeof h || h.head.length > out.size() * 8) return;
            h.head.checksum = detail::image_checksum(bytes_of(out).first(static_cast<std::size_t>(h.head.length)));
            std::memcpy(packed.data() + detail::delta_header_bytes, &h, sizeof h.head);
            test::seal(packed);
            n = apply(bytes_of(base.image), packed, bytes_of(out));
        }
        if (n == 0 || n % 8 != 0) return;
        ++deltas;
        deed->base = std::make_shared<Words>(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(n / 8));
    } else {
        const Words& image = random.one_in(2) ? base.image : base.later;
        deed->base = std::make_shared<Words>(image);
        add_edits(image, deed->edits, random);
    }
    all.log_deed(deed);
    const Words forged = deed->forged();
    if (!load(all, bytes_of(forged))) return;
    ++accepted;
    at_home = false;
    Life life(all, random, setup);
    for (std::uint32_t i = 0; i < 10; ++i) {
        all.step(1.0f / 60);
        if (i == 1) {  // what was hidden comes out
            const World& w = all.first();
            const std::uint32_t slots = w.capacity().bodies < 16 ? w.capacity().bodies : 16;
            for (std::uint32_t slot = 0; slot < slots; ++slot) {
                const BodyId b = w.body_at(slot);
                if (!b) continue;
                if (!w.is_enabled(b)) all.set_enabled(b, true);
                if (random.one_in(4)) all.reset_mass(b);
                if (random.one_in(4)) all.wake(b);
            }
        }
        if (i > 1 && random.one_in(3)) life.change();
    }
    all.compare(false);
    all.check();
    if (random.one_in(4)) {
        scratch_.resize(all.first().snapshot_bytes() / 8);
        all.first().save(bytes_of(scratch_));
        if (!load(all, bytes_of(scratch_))) test::broken("its own image is refused");
    }
    if (all.first().hooks() != Hooks{}) all.set_hooks(0);
}

}  // namespace islet::lockstep
