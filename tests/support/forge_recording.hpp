// Recordings as an attacker would make them: changed at will, with sums that are right again.
#pragma once

#include <cstring>
#include <span>
#include <vector>

#include "islet/recording.hpp"
#include "support/forge.hpp"
#include "calls/recorder.hpp"

namespace islet::test {

namespace forge_detail {

using detail::members;  // what a call's arguments consist of

/// Counts the words of a call's arguments, without the points of a chain.
struct ArgumentWords {
    std::size_t words = 0;
    template <class... T>
    constexpr void operator()(T&... values) {
        (one(values), ...);
    }
    template <class T>
    constexpr void one(T& a) {
        if constexpr (requires { members(*this, a); }) members(*this, a);
        else words += sizeof(T) == 8 ? 2 : 1;
    }
    constexpr void one(std::span<const Vec2>&) { ++words; }
};

template <class... Args>
std::size_t argument_words() {
    ArgumentWords count;
    const auto add = [&count](auto a) { count(a); };
    (add(Args{}), ...);
    return count.words;
}

/// Words of the call's arguments; 0 if there is no such call.
inline std::size_t words_of_call(detail::Call call) {
    switch (call) {
#define ISLET_FORGE_WORDS(name, function, ...) \
    case detail::Call::name: return argument_words<__VA_ARGS__>();
        ISLET_CALLS(ISLET_FORGE_WORDS)
#undef ISLET_FORGE_WORDS
        default: return 0;
    }
}

}  // namespace forge_detail

/// Makes the sums of a recording right: those of its snapshots, those that each step carries, and the last. Returns where the hash of each step stands, in
/// bytes. Ends at the first call that is none: what follows is never made.
inline std::vector<std::size_t> seal_recording(std::span<std::byte> recording) {
    using detail::Call;
    std::vector<std::size_t> hashes;
    detail::RecordingHead head;
    if (recording.size() < sizeof head) return hashes;
    std::memcpy(&head, recording.data(), sizeof head);
    if (head.image_bytes > recording.size() - sizeof head) return hashes;
    seal(recording.subspan(sizeof head, static_cast<std::size_t>(head.image_bytes)));
    const std::size_t end = recording.size() / 4 * 4;
    std::size_t at = detail::calls_at(head.image_bytes);
    std::uint64_t sum = 0;
    const auto skip = [&](std::uint64_t words) {
        for (; words > 0 && at < end; --words, at += 4) {
            std::uint32_t w = 0;
            std::memcpy(&w, recording.data() + at, 4);
            sum = detail::mixed(sum, w);
        }
        return words == 0;
    };
    const auto peek = [&](std::size_t where, auto& value) {
        if (where + sizeof value <= end) std::memcpy(&value, recording.data() + where, sizeof value);
    };
    while (at < end) {
        const std::uint64_t before = sum;
        Call call{};
        peek(at, call);
        skip(1);
        std::uint32_t count = 0;
        if (call == Call::ended || call == Call::stepped) {
            if (end - at < 8) break;
            std::memcpy(recording.data() + at, &before, 8);
            skip(2);
            if (call == Call::ended) break;
            hashes.push_back(at);
            skip(2);
            peek(at, count);
            if (!skip(1) || !skip(count)) break;
        } else if (call == Call::image) {
            std::uint64_t size = 0;
            peek(at, size);
            skip(2);
            if (at % 8 != 0) skip(1);
            if (size > end - at) break;
            seal(recording.subspan(at, static_cast<std::size_t>(size)));
            skip((size + 3) / 4);
        } else {
            const std::size_t words = forge_detail::words_of_call(call);
            if (words == 0) break;
            if (call == Call::create_chain) {
                peek(at + 8, count);
                if (!skip(3 + 2 * std::uint64_t{count})) break;
                skip(words - 3);
            } else if (!skip(words)) {
                break;
            }
        }
    }
    head.sum = sum;
    std::memcpy(recording.data(), &head, sizeof head);
    return hashes;
}

/// Replays a recording whose calls were changed, and makes its sums and the hashes of its steps right until all of it is replayed or it is refused.
inline ReplayResult replay_forged(World& world, std::span<std::byte> recording) {
    ReplayResult result;
    for (std::uint64_t right = 0;; right = result.steps) {  // steps whose hashes are right
        const std::vector<std::size_t> hashes = seal_recording(recording);
        result = replay(world, recording);
        if (result.end != ReplayEnd::differs || result.steps <= right || result.steps > hashes.size()) return result;
        std::memcpy(recording.data() + hashes[static_cast<std::size_t>(result.steps) - 1], &result.hash, 8);
    }
}

}  // namespace islet::test
