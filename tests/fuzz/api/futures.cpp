// The same future again: worlds that are saved and loaded, packed and unpacked, recorded and replayed, on other lanes and workers.
#include <algorithm>
#include <cstring>

#include "player.hpp"

namespace islet::fuzz {

// To another world and back, and a step ahead in both.
void Player::round_trip() {
    const std::size_t n = w.save(f.image);
    expect(n != 0 && n == w.snapshot_bytes(), "the world does not fit the image it asks for");
    const std::span<std::byte> bytes(f.image.data(), n);
    if (f.trace) print(w);
    if (const char* broken = w.validate()) test::broken(broken);
    SnapshotInfo info;
    expect(read_snapshot(bytes, info) == Error::none && info.bytes == n && info.capacity == capacity, "an image does not say what it is");
    if (!twin.load(bytes)) test::broken(describe(twin.last_error()));
    expect(twin.hash() == w.hash(), "a loaded world is another");
    pack(bytes);
    if (in.below(4) == 0) damage(bytes);
    twin.step(1.0f / 60);
    if (in.flag()) expect(w.restore(bytes), "a world does not take its own image back");
    all.step(1.0f / 60);
    expect(twin.hash() == w.hash(), "a loaded world has another future");
    check();
}

// The way from the image before to this one, packed: there and back, and with too little room.
void Player::pack(std::span<const std::byte> bytes) {
    const std::span<const std::byte> earlier(f.earlier.data(), earlier_bytes);
    if (earlier_bytes != 0) {
        Error error = Error::none;
        const std::size_t packed = delta(earlier, bytes, f.packed, &error);
        if (packed == 0) test::broken(describe(error));
        const std::span<std::byte> way(f.packed.data(), packed);
        const std::size_t n = apply(earlier, way, f.unpacked, &error);
        if (n == 0) test::broken(describe(error));
        expect(n == bytes.size() && std::memcmp(f.unpacked.data(), bytes.data(), n) == 0, "a delta leads to another image");
        if (in.below(4) == 0) {
            const std::size_t room = in.byte() * 8;
            expect(room >= packed || delta(earlier, bytes, {f.unpacked.data(), room}, &error) == 0, "a delta was written where it has no room");
            expect(room >= n || apply(earlier, way, {f.unpacked.data(), room}, &error) == 0, "an image was written where it has no room");
            const std::size_t at = (in.byte() | in.byte() << 8) % packed;
            way[at] ^= static_cast<std::byte>(1 + in.below(255));
            expect(apply(earlier, way, f.unpacked, &error) == 0 && error != Error::none, "a damaged delta was applied");
        }
    }
    std::copy(bytes.begin(), bytes.end(), f.earlier.begin());
    earlier_bytes = bytes.size();
}

// What has a byte that is not its own must be refused, and what refuses it be as it was.
void Player::damage(std::span<std::byte> bytes) {
    const std::uint64_t hash = twin.hash();
    std::byte& victim = bytes[(in.byte() | in.byte() << 8) % bytes.size()];
    const std::byte flip = static_cast<std::byte>(1 + in.below(255));
    victim ^= flip;
    expect(!twin.load(bytes) && twin.last_error() != Error::none, "a damaged image was loaded");
    victim ^= flip;
    expect(!twin.load(bytes.first(bytes.size() - 8 * (1 + in.below(8)))), "half an image was loaded");
    expect(twin.hash() == hash, "a refused image changed the world");
}

void Player::start_recording() {
    recorded = f.recording;
    const std::uint32_t how = in.byte();
    if (how % 4 == 3) recorded = recorded.first(4096 + 128 * (how / 4));  // it may end by itself, or never begin
    const bool started = w.start_recording(recorded, (how & 4) != 0);
    const bool is_cut = !started && w.last_error() == Error::feature_cut;  // in the small profile
    if (!started && !is_cut) expect(w.last_error() == Error::recording_full && how % 4 == 3, "no recording starts");
    expect(started == w.is_recording() && started == (w.recorded_bytes() != 0), "a recording goes on that was not started, or the other way round");
    if (!started) recorded = {};
}

void Player::move_recording() {
    const std::span<std::byte> longer = f.longer_recording;
    const std::span<std::byte> to = in.below(4) == 0 ? longer.subspan(in.below(16), in.byte() * 64) : longer;
    const std::size_t bytes = w.recorded_bytes();
    const bool was = w.is_recording();
    const bool moved = (recorded.data() != to.data() || !was) && w.move_recording(to);
    expect(was || !moved, "a recording was moved that there is not");
    expect(w.recorded_bytes() == bytes && w.is_recording() == was, "a recording lost something when it was moved");
    if (moved) recorded = to;
}

/// All that was done, done again by another world.
void Player::replay_all() {
    if (recorded.empty()) return;
    const bool whole = w.is_recording();  // or there was no more room, and it holds what was done before
    const std::uint64_t hash = w.hash();
    std::span<std::byte> bytes = recorded;
    if (whole) {
        const std::size_t n = w.stop_recording();
        expect(w.hash() == hash, "a recording that ends changes the world");
        if (n != 0) bytes = bytes.first(n);
        else expect(w.last_error() == Error::recording_full, "a recording does not end");
    }
    RecordingInfo info;
    if (const Error error = read_recording(bytes, info); error != Error::none) test::broken(describe(error));
    expect(info.capacity == capacity && info.bytes <= bytes.size(), "a recording does not say what it is");

    const ReplayResult result = replay(twin, bytes);
    if (result.end != ReplayEnd::complete) test::broken(result.end == ReplayEnd::differs ? "a replay differs" : describe(result.error));
    expect(!whole || twin.hash() == hash, "a replay ends elsewhere");

    if (in.flag()) {  // as far as asked for
        const std::uint64_t steps = in.byte();
        const ReplayResult part = replay(twin, bytes, steps);
        expect(part.end == (steps < result.steps ? ReplayEnd::stopped : ReplayEnd::complete) || steps == result.steps, "a replay ends too late or too early");
        expect(part.steps == std::min(steps, result.steps), "a replay takes other steps than it was asked for");
    }
    if (in.below(4) == 0) {  // and damaged
        bytes[(in.byte() | in.byte() << 8 | in.byte() << 16) % info.bytes] ^= static_cast<std::byte>(1 + in.below(255));
        replay(twin, bytes);
        if (const char* broken = twin.validate()) test::broken(broken);
    }
}

}  // namespace islet::fuzz
