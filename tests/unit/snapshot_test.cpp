// Saving, going back, and the difference of two images; what is refused, and by which name.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/busy_world.hpp"
#include "support/forge.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

class Snapshot : public testing::Test {
protected:
    Snapshot() { fill_busy(*w); }

    /// Neither door may open, and nothing may change.
    void expect_refused(std::span<const std::byte> image, Error error) {
        const std::uint64_t before = w->hash();
        w->clear_error();
        EXPECT_FALSE(w->load(image));
        EXPECT_EQ(w->last_error(), error) << "load: " << describe(w->last_error());
        w->clear_error();
        EXPECT_FALSE(w->restore(image));
        EXPECT_EQ(w->last_error(), error) << "restore: " << describe(w->last_error());
        SnapshotInfo info;
        if (error != Error::image_too_large) {
            EXPECT_EQ(read_snapshot(image, info), error);
        }
        EXPECT_EQ(w->hash(), before);
        EXPECT_EQ(w->validate(), nullptr);
    }

    TestWorld w{busy_capacity};
};

TEST_F(Snapshot, HoldsWhatTheWorldIsMadeOf) {
    // The world must be worth the name before any other test here means anything.
    ASSERT_EQ(w->validate(), nullptr) << w->validate();
    EXPECT_EQ(w->joint_count(), joint_type_count);
    EXPECT_GT(w->report().touching_contacts, 5u);
    EXPECT_LT(w->report().awake_bodies, w->body_count());
    EXPECT_GT(w->end_touch_events().size(), 0u) << "what was destroyed touched nothing";
    const Image image = save(*w);
    SnapshotInfo info;
    ASSERT_EQ(read_snapshot(image.bytes(), info), Error::none);
    EXPECT_EQ(info.bytes, image.bytes().size());
    EXPECT_EQ(info.capacity, busy_capacity);
    EXPECT_LE(info.bytes, max_snapshot_bytes(busy_capacity));
    EXPECT_EQ(max_snapshot_bytes(info.used) >= info.bytes, true);
}

TEST_F(Snapshot, OfTheSameStateIsTheSameBytes) {
    const Image image = save(*w);
    EXPECT_EQ(save(*w), image);
    w.step(5);
    EXPECT_FALSE(save(*w) == image);
    ASSERT_TRUE(w->restore(image.bytes()));
    EXPECT_EQ(save(*w), image) << "restored, but not the same";
    TestWorld other(busy_capacity);
    ASSERT_TRUE(other->load(image.bytes())) << describe(other->last_error());
    EXPECT_EQ(save(*other), image) << "loaded, but not the same";
}

TEST_F(Snapshot, KeepsWhatTheHashLeavesOut) {
    const Image image = save(*w);
    const std::uint64_t steps = w->step_count();
    std::uint64_t data = 0;
    for (const BodyId body : w.bodies()) data |= w->user_data(body);
    EXPECT_EQ(data, 0x0123456789abcdefull);
    w.step(7);
    for (const BodyId body : w.bodies()) w->set_user_data(body, 1);
    ASSERT_TRUE(w->restore(image.bytes()));
    EXPECT_EQ(w->step_count(), steps);
    data = 0;
    for (const BodyId body : w.bodies()) data |= w->user_data(body);
    EXPECT_EQ(data, 0x0123456789abcdefull);
}

TEST_F(Snapshot, KeepsEndEventsThatNobodyHasReadYet) {
    // Contacts of destroyed bodies end between steps; the next step reports them.
    const Image image = save(*w);
    w->step(1.0f / 60);
    const std::vector<TouchEvent> ended(w->end_touch_events().begin(), w->end_touch_events().end());
    ASSERT_FALSE(ended.empty());
    ASSERT_TRUE(w->restore(image.bytes()));
    EXPECT_TRUE(w->begin_touch_events().empty()) << "events of the time that was undone";
    EXPECT_TRUE(w->moved_bodies().empty());
    w->step(1.0f / 60);
    ASSERT_EQ(w->end_touch_events().size(), ended.size());
    for (std::size_t i = 0; i < ended.size(); ++i) {
        EXPECT_EQ(w->end_touch_events()[i].shape_a, ended[i].shape_a);
        EXPECT_EQ(w->end_touch_events()[i].shape_b, ended[i].shape_b);
    }
    w.step();
    const Image later = save(*w);
    ASSERT_TRUE(w->restore(later.bytes()));
    EXPECT_TRUE(w->end_touch_events().empty()) << "events that were reported already";
}

TEST_F(Snapshot, NeedsRoomForAllOfIt) {
    Image image(w->snapshot_bytes() + 8);
    std::memset(image.bytes().data(), 0xa5, image.bytes().size());
    EXPECT_EQ(w->save(image.bytes().first(w->snapshot_bytes() - 1)), 0u);
    EXPECT_EQ(w->last_error(), Error::image_too_small);
    for (const std::byte b : image.bytes()) ASSERT_EQ(b, std::byte{0xa5}) << "wrote though there was no room";
    EXPECT_EQ(w->save({}), 0u);
    EXPECT_EQ(w->save(image.bytes()), w->snapshot_bytes());
    for (std::size_t i = w->snapshot_bytes(); i < image.bytes().size(); ++i) EXPECT_EQ(image[i], std::byte{0xa5}) << "wrote beyond its end";
}

TEST_F(Snapshot, FitsAnyWorldThatHasRoomForWhatIsUsed) {
    const Image image = save(*w);
    SnapshotInfo info;
    ASSERT_EQ(read_snapshot(image.bytes(), info), Error::none);
    TestWorld least(info.used);
    ASSERT_TRUE(least->load(image.bytes())) << describe(least->last_error());
    EXPECT_EQ(least->hash(), w->hash());
    EXPECT_EQ(least->validate(), nullptr) << least->validate();
    for (std::uint32_t Capacity::*pool : {&Capacity::bodies, &Capacity::shapes, &Capacity::contacts, &Capacity::joints, &Capacity::geometries}) {
        Capacity less = info.used;
        --(less.*pool);
        TestWorld small(less);
        const std::uint64_t before = small->hash();
        EXPECT_FALSE(small->load(image.bytes()));
        EXPECT_EQ(small->last_error(), Error::image_too_large);
        EXPECT_FALSE(small->restore(image.bytes()));
        EXPECT_EQ(small->hash(), before);
    }
}

TEST_F(Snapshot, LoadWantsItAligned) {
    const Image image = save(*w);
    Image shifted(image.bytes().size() + 8);
    std::ranges::copy(image.bytes(), shifted.bytes().begin() + 4);
    const std::span<const std::byte> odd = std::span<const std::byte>(shifted.bytes()).subspan(4, image.bytes().size());
    EXPECT_FALSE(w->load(odd));
    EXPECT_EQ(w->last_error(), Error::image_misaligned);
    EXPECT_TRUE(w->restore(odd)) << "restore only copies, so it need not be";
}

TEST_F(Snapshot, OfTheOtherByteOrderIsRefusedByName) {
    Image image = save(*w);
    const detail::ImageHeader h = header_of(image.bytes());
    set_word(image, 0, __builtin_bswap32(h.head.magic));
    expect_refused(image.bytes(), Error::other_byte_order);
}

TEST_F(Snapshot, OfAnotherVersionOrKindIsRefusedByName) {
    Image image = save(*w);
    set_word(image, 1, word(image, 1) + 1);
    expect_refused(image.bytes(), Error::other_version);
    set_word(image, 0, 0);
    expect_refused(image.bytes(), Error::not_an_image);
    expect_refused({}, Error::truncated_image);
}

TEST_F(Snapshot, OfAnyOtherLengthIsRefused) {
    const Image image = save(*w);
    for (std::size_t n = 0; n < image.bytes().size(); n += n < 100 ? 1 : 97) expect_refused(image.bytes().first(n), Error::truncated_image);
    Image longer(image.bytes().size() + 8);
    std::ranges::copy(image.bytes(), longer.bytes().begin());
    expect_refused(longer.bytes(), Error::truncated_image);
}

TEST_F(Snapshot, WithAnyByteChangedIsNotLoaded) {
    Image image = save(*w);
    const std::uint64_t before = w->hash();
    for (std::size_t i = 0; i < image.bytes().size(); ++i) {
        const std::byte good = image[i];
        for (const std::byte flip : {std::byte{1}, std::byte{0x80}, std::byte{0xff}}) {
            image[i] = good ^ flip;
            ASSERT_FALSE(w->load(image.bytes())) << "byte " << i;
        }
        image[i] = good;
    }
    EXPECT_EQ(w->hash(), before);
    EXPECT_TRUE(w->load(image.bytes()));
}

// -- differences -------------------------------------------------------------------------------------------------------------------------

class Delta : public Snapshot {
protected:
    Image delta_of(const Image& from, const Image& to) {
        Image room(max_delta_bytes(to.bytes().size()));
        Error error = Error::none;
        const std::size_t n = delta(from.bytes(), to.bytes(), room.bytes(), &error);
        EXPECT_EQ(error, Error::none) << describe(error);
        Image packed(n);
        std::ranges::copy(room.bytes().first(n), packed.bytes().begin());
        return packed;
    }
    Image applied(const Image& from, const Image& packed, std::size_t length, Error expected = Error::none) {
        Image out(length);
        Error error = Error::none;
        const std::size_t n = apply(from.bytes(), packed.bytes(), out.bytes(), &error);
        EXPECT_EQ(error, expected) << describe(error);
        EXPECT_EQ(n, expected == Error::none ? length : 0);
        return out;
    }
};

TEST_F(Delta, LeadsFromOneImageToTheOther) {
    Image from = save(*w);
    for (int i = 0; i < 30; ++i) {
        // The world grows and shrinks meanwhile.
        if (i % 3 == 1) w.add_box({30, 6.0f + static_cast<float>(i)}, 0.2f + 0.01f * static_cast<float>(i), 0.2f);
        if (i % 5 == 4) w->destroy_body(w.bodies().back());
        w.step(1 + i % 4);
        const Image to = save(*w);
        const Image packed = delta_of(from, to);
        EXPECT_TRUE(applied(from, packed, to.bytes().size()) == to);
        const Image back = delta_of(to, from);
        EXPECT_TRUE(applied(to, back, from.bytes().size()) == from);
        from = to;
    }
}

TEST_F(Delta, OfNothingIsNextToNothing) {
    const Image image = save(*w);
    const Image packed = delta_of(image, image);
    EXPECT_LT(packed.bytes().size(), detail::delta_header_bytes + detail::image_header_bytes + 20 * 4 + image.bytes().size() / (32 * 128));
    EXPECT_TRUE(applied(image, packed, image.bytes().size()) == image);
}

TEST_F(Delta, IsMuchSmallerThanAnImageOfAWorldMostlyAtRest) {
    TestWorld calm(Capacity{.bodies = 200, .shapes = 200, .contacts = 800});
    calm.add_ground();
    for (int i = 0; i < 150; ++i) calm.add_box({static_cast<float>(i % 50) * 1.5f, 0.5f + static_cast<float>(i / 50)});
    for (int i = 0; i < 120; ++i) calm.step();
    const BodyId ball = calm.add_circle({0, 9});
    calm.step(5);
    ASSERT_LT(calm->report().awake_bodies, 5u) << "the boxes do not sleep";
    const Image from = save(*calm);
    calm.step();
    EXPECT_TRUE(calm->is_valid(ball));
    const Image to = save(*calm);
    const Image packed = delta_of(from, to);
    EXPECT_LT(packed.bytes().size() * 50, to.bytes().size());
}

TEST_F(Delta, IsNeverLargerThanPromised) {
    // The worst case: every word differs in its highest byte.
    const Image from = save(*w);
    Image to = from;
    for (std::size_t i = sizeof(detail::ImageHeader) / 4; i < to.bytes().size() / 4; ++i) set_word(to, i, ~word(to, i));
    seal(to.bytes());
    const Image packed = delta_of(from, to);
    EXPECT_GT(packed.bytes().size(), to.bytes().size());
    EXPECT_LE(packed.bytes().size(), max_delta_bytes(to.bytes().size()));
    EXPECT_TRUE(applied(from, packed, to.bytes().size()) == to);
}

TEST_F(Delta, FitsOnlyTheImageItWasMadeFrom) {
    const Image from = save(*w);
    w.step();
    const Image to = save(*w);
    w.step();
    const Image other = save(*w);
    applied(other, delta_of(from, to), to.bytes().size(), Error::wrong_delta);
}

TEST_F(Delta, NeedsRoom) {
    const Image from = save(*w);
    w.step();
    const Image to = save(*w);
    const Image packed = delta_of(from, to);
    applied(from, packed, to.bytes().size() - 1, Error::image_too_small);
    Image small(packed.bytes().size());
    for (std::size_t n = 0; n < packed.bytes().size(); n += 31) {
        Error error = Error::none;
        EXPECT_EQ(delta(from.bytes(), to.bytes(), small.bytes().first(n), &error), 0u);
        EXPECT_EQ(error, Error::image_too_small);
    }
    EXPECT_EQ(delta(from.bytes(), to.bytes(), small.bytes()), packed.bytes().size());
}

TEST_F(Delta, WithAnyByteChangedOrMissingIsRefused) {
    const Image from = save(*w);
    w.step();
    const Image to = save(*w);
    Image packed = delta_of(from, to);
    Image out(to.bytes().size());
    for (std::size_t i = 0; i < packed.bytes().size(); ++i) {
        const std::byte good = packed[i];
        packed[i] = good ^ std::byte{0x41};
        ASSERT_EQ(apply(from.bytes(), packed.bytes(), out.bytes()), 0u) << "byte " << i;
        packed[i] = good;
        ASSERT_EQ(apply(from.bytes(), packed.bytes().first(i), out.bytes()), 0u) << "without what follows byte " << i;
    }
    EXPECT_EQ(apply(from.bytes(), packed.bytes(), out.bytes()), to.bytes().size());
}

TEST_F(Delta, OfWhatIsNoImageIsRefused) {
    const Image image = save(*w);
    Image out(max_delta_bytes(image.bytes().size()));
    Error error = Error::none;
    EXPECT_EQ(delta({}, image.bytes(), out.bytes(), &error), 0u);
    EXPECT_EQ(error, Error::truncated_image);
    EXPECT_EQ(delta(image.bytes(), out.bytes(), out.bytes(), &error), 0u);
    EXPECT_EQ(error, Error::not_an_image);
    EXPECT_EQ(apply(image.bytes(), image.bytes(), out.bytes(), &error), 0u);
    EXPECT_EQ(error, Error::not_an_image);
}

}  // namespace
}  // namespace islet::test
