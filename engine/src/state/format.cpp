// What some bytes are, and a sentence about it.
#include "../exact.hpp"

#include "islet/format.hpp"

#include "../calls/recorder.hpp"
#include "../state/image.hpp"

namespace islet {

using namespace detail;

namespace {

FormatInfo format_by(std::uint32_t magic, std::uint32_t format) {
    switch (magic) {
        case image_magic: return {FormatKind::snapshot, format, snapshot_format};
        case delta_magic: return {FormatKind::delta, format, delta_format};
        case recording_magic: return {FormatKind::recording, format, recording_format};
        default: return {};
    }
}

// By the first two words, which everything that Islet writes begins with: what it is, and its format.
FormatInfo format_at(span<const std::byte> bytes) {
    std::uint32_t words[2];
    if (bytes.data() == nullptr || bytes.size() < sizeof words) return {};
    ISLET_MEMCPY(words, bytes.data(), sizeof words);
    FormatInfo info = format_by(words[0], words[1]);
    if (info.kind != FormatKind::unknown) return info;
    info = format_by(swapped_bytes(words[0]), swapped_bytes(words[1]));
    info.other_byte_order = info.kind != FormatKind::unknown;
    return info;
}

/// Appends to a text. What finds no room is counted alone.
struct Sentence {
    span<char> out;
    std::size_t length = 0;

    void put(char c) {
        if (length + 1 < out.size()) out[length] = c;
        ++length;
    }
    void put(const char* text) {
        for (; *text != 0; ++text) put(*text);
    }
    void put(std::uint32_t n) {
        std::uint32_t unit = 1;
        while (n / unit >= 10) unit *= 10;
        for (; unit > 0; unit /= 10) put(static_cast<char>('0' + n / unit % 10));
    }
};

const char* name_of(FormatKind kind) {
    switch (kind) {
        case FormatKind::snapshot: return "a snapshot";
        case FormatKind::delta: return "a delta";
        case FormatKind::recording: return "a recording";
        case FormatKind::unknown: break;
    }
    return "nothing";
}

}  // namespace

FormatInfo read_format(span<const std::byte> bytes) {
    const FormatInfo info = format_at(bytes);
    if (info.kind != FormatKind::recording || !info.is_readable() || bytes.size() <= sizeof(RecordingHead)) return info;
    FormatInfo snapshot = format_at(bytes.subspan(sizeof(RecordingHead)));
    if (snapshot.kind != FormatKind::snapshot || snapshot.is_readable()) return info;
    snapshot.in_recording = true;
    return snapshot;
}

std::size_t describe_format(const FormatInfo& info, span<char> out) {
    Sentence s{out};
    if (info.kind == FormatKind::unknown) {
        s.put("These bytes are nothing that Islet " ISLET_VERSION_STRING " knows");
    } else {
        s.put("This is ");
        s.put(info.in_recording ? "a recording that begins with a snapshot" : name_of(info.kind));
        s.put(" of format ");
        s.put(info.format);
        if (info.other_byte_order) s.put(", of the other byte order");
        s.put("; Islet " ISLET_VERSION_STRING " reads format ");
        s.put(info.readable);
    }
    s.put('.');
    if (!out.empty()) out[s.length < out.size() ? s.length : out.size() - 1] = 0;
    return s.length;
}

}  // namespace islet
