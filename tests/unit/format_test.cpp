// Formats are told from the first bytes, whatever version wrote them, and a sentence names both versions.
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include <islet/islet.hpp>

namespace islet {
namespace {

using Words = std::vector<std::uint32_t>;

std::span<const std::byte> bytes_of(const Words& words) { return std::as_bytes(std::span(words)); }

std::string sentence(const FormatInfo& info) {
    char text[128];
    const std::size_t length = describe_format(info, text);
    EXPECT_EQ(length, std::strlen(text));
    EXPECT_LE(length, 120u);
    return text;
}

// A world's snapshot, a delta and a recording, as words.
struct Written {
    Words snapshot, delta, recording;

    Written() {
        static StaticWorld<Capacity{.bodies = 4, .shapes = 4, .contacts = 8, .joints = 0}> storage;
        World& world = storage.create({});
        snapshot.resize(world.snapshot_bytes() / 4);
        EXPECT_GT(world.save(std::as_writable_bytes(std::span(snapshot))), 0u);
        delta.resize(max_delta_bytes(snapshot.size() * 4) / 4);
        EXPECT_GT(islet::delta(bytes_of(snapshot), bytes_of(snapshot), std::as_writable_bytes(std::span(delta))), 0u);
        // Recordings are aligned to 8 bytes, as what a vector allocates is.
        recording.resize(4096);
        EXPECT_TRUE(world.start_recording(std::as_writable_bytes(std::span(recording))));
        recording.resize(world.stop_recording() / 4);
    }
};

void expect_format(const Words& words, FormatKind kind, std::uint32_t format, bool readable) {
    const FormatInfo info = read_format(bytes_of(words));
    EXPECT_EQ(info.kind, kind);
    EXPECT_EQ(info.format, format);
    EXPECT_EQ(info.is_readable(), readable);
}

TEST(Format, OfWhatThisVersionWritesIsReadable) {
    const Written w;
    expect_format(w.snapshot, FormatKind::snapshot, snapshot_format, true);
    expect_format(w.delta, FormatKind::delta, delta_format, true);
    expect_format(w.recording, FormatKind::recording, recording_format, true);
}

TEST(Format, OfAnotherVersionIsToldAndTheSentenceNamesBoth) {
    Written w;
    for (Words* words : {&w.snapshot, &w.delta, &w.recording}) (*words)[1] = 4000000000u;
    expect_format(w.snapshot, FormatKind::snapshot, 4000000000u, false);
    expect_format(w.delta, FormatKind::delta, 4000000000u, false);
    expect_format(w.recording, FormatKind::recording, 4000000000u, false);
    EXPECT_EQ(sentence(read_format(bytes_of(w.snapshot))),
              "This is a snapshot of format 4000000000; Islet " ISLET_VERSION_STRING " reads format " + std::to_string(snapshot_format) + ".");
    EXPECT_EQ(sentence(read_format(bytes_of(w.recording))),
              "This is a recording of format 4000000000; Islet " ISLET_VERSION_STRING " reads format " + std::to_string(recording_format) + ".");

    // What else reads them says the same.
    SnapshotInfo snapshot;
    RecordingInfo recording;
    EXPECT_EQ(read_snapshot(bytes_of(w.snapshot), snapshot), Error::other_version);
    EXPECT_EQ(read_recording(bytes_of(w.recording), recording), Error::other_version);
}

TEST(Format, OfARecordingsSnapshotIsToldToo) {
    Written w;
    const std::size_t at = 48 / 4;  // behind the recording's own head
    ASSERT_EQ(w.recording[at], w.snapshot[0]);
    w.recording[at + 1] = 3;
    const FormatInfo info = read_format(bytes_of(w.recording));
    EXPECT_TRUE(info.in_recording);
    EXPECT_EQ(info.format, 3u);
    EXPECT_FALSE(info.is_readable());
    EXPECT_EQ(sentence(info), "This is a recording that begins with a snapshot of format 3; Islet " ISLET_VERSION_STRING " reads format " +
                                  std::to_string(snapshot_format) + ".");
}

TEST(Format, OfTheOtherByteOrderIsTold) {
    Written w;
    for (Words* words : {&w.snapshot, &w.delta, &w.recording})
        for (std::uint32_t& word : *words) word = __builtin_bswap32(word);
    expect_format(w.snapshot, FormatKind::snapshot, snapshot_format, false);
    expect_format(w.delta, FormatKind::delta, delta_format, false);
    expect_format(w.recording, FormatKind::recording, recording_format, false);
    EXPECT_NE(sentence(read_format(bytes_of(w.delta))).find("of the other byte order"), std::string::npos);
}

TEST(Format, OfOtherBytesIsUnknown) {
    const Written w;
    EXPECT_EQ(read_format({}).kind, FormatKind::unknown);
    EXPECT_EQ(read_format(bytes_of(w.snapshot).first(7)).kind, FormatKind::unknown);
    EXPECT_EQ(read_format(bytes_of(w.snapshot).first(8)).kind, FormatKind::snapshot);
    EXPECT_EQ(read_format(bytes_of(w.recording).first(60)).kind, FormatKind::recording);
    EXPECT_EQ(sentence(read_format(bytes_of({1, 2, 3}))), "These bytes are nothing that Islet " ISLET_VERSION_STRING " knows.");
}

TEST(Format, ASentenceEndsWhereItsRoomDoes) {
    const FormatInfo info{FormatKind::snapshot, 3, snapshot_format};
    const std::string whole = sentence(info);
    for (std::size_t room = 0; room <= whole.size() + 1; ++room) {
        std::string out(room + 4, '#');
        EXPECT_EQ(describe_format(info, {out.data(), room}), whole.size());
        EXPECT_EQ(out.substr(room), "####");
        if (room > 0) {
            EXPECT_EQ(out.substr(0, room), whole.substr(0, room - 1) + '\0');
        }
    }
}

TEST(Version, SaysTheSameAsNumbersAndAsText) {
    EXPECT_EQ(ISLET_VERSION_STRING,
              std::to_string(ISLET_VERSION_MAJOR) + "." + std::to_string(ISLET_VERSION_MINOR) + "." + std::to_string(ISLET_VERSION_PATCH));
    EXPECT_EQ(ISLET_VERSION, ISLET_VERSION_MAJOR * 10000 + ISLET_VERSION_MINOR * 100 + ISLET_VERSION_PATCH);
}

}  // namespace
}  // namespace islet
