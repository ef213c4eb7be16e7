// Settled contacts that are kept in lanes are those that one lane keeps, and what they hold comes to the same bits.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "../../engine/src/broadphase/pairs.hpp"
#include "../../engine/src/math/boxes.hpp"
#include "../../engine/src/math/cpu.hpp"
#include "../../engine/src/step/recycling.hpp"
#include "support/random.hpp"

namespace islet::detail {
namespace {

#if ISLET_MAX_LANES > 1

Rot turned(Rot q, float angle) { return q * make_rot(angle); }

// Contacts near all the limits at which one is not settled any more. Each body has one shape, of its own index.
struct RandomContacts {
    std::vector<ContactManifold> manifolds;
    std::vector<Contact> contacts;
    std::vector<Pose> poses;
    std::vector<Motion> motions;
    std::vector<Aabb> boxes;

    explicit RandomContacts(std::uint32_t count) : manifolds(count), contacts(count), poses(count + 1), motions(count + 1), boxes(count + 1) {
        test::Random random(7);
        for (Aabb& box : boxes) {
            const Vec2 middle = {random.between(-1, 1), random.between(-1, 1)};
            box = {middle - Vec2{random.between(0, 1.5f), 1}, middle + Vec2{1, random.between(0, 1.5f)}};
            if (random.one_in(20)) box.upper.x = endless_reach;
        }
        for (Pose& p : poses) {
            p.center = {random.between(-1, 1), random.between(-1, 1)};
            p.q = make_rot(random.between(-3, 3));
            p.inv_mass = p.inv_inertia = random.one_in(4) ? 0.0f : 1.0f;
            p.max_extent = random.between(0.2f, 3);
            const std::uint32_t flags[] = {pose_moved, pose_fast, pose_learns, pose_alone, pose_deep};
            if (random.one_in(12)) p.flags = flags[random.below(5)];
            if (random.one_in(3)) p.flags |= pose_moved;
        }
        for (Motion& motion : motions) motion.w = random.between(-0.1f, 0.1f);
        for (std::uint32_t i = 0; i < count; ++i) {
            ContactManifold& m = manifolds[i];
            m.body_a = i;
            m.body_b = i + 1;
            contacts[i].shape_a = i;
            contacts[i].shape_b = i + 1;
            const std::uint32_t others[] = {contact_special, contact_sensor, contact_asks,   contact_one_way,
                                            contact_ahead,   contact_untold, contact_bouncy, contact_hits};
            m.flags = settled_flags | (random.one_in(8) ? random.below(3) : 2u) << contact_count_shift;
            const bool apart = random.one_in(4);
            if (apart) m.flags = apart_flags;
            if (random.one_in(6)) m.flags |= others[random.below(8)];
            if (random.one_in(20)) m.flags &= ~(random.one_in(2) ? std::uint32_t{contact_touching} : std::uint32_t{contact_posed});
            const Pose &a = poses[i], &b = poses[i + 1];
            const float lag = random.one_in(5) ? 0.13f : apart ? 0.003f : 0.0015f, slip = random.one_in(4) ? 0.02f : 0.006f;
            m.rotation_a = turned(a.q, random.between(-lag, lag));
            m.rotation_b = turned(b.q, random.between(-lag, lag));
            m.normal = rotate(make_rot(random.between(-3, 3)), {1, 0});
            m.offset = b.center - a.center + Vec2{random.between(-slip, slip), random.between(-slip, slip)};
            for (std::uint32_t k = 0; k < 2; ++k) {
                m.anchors[k] = {random.between(-1, 1), random.between(-1, 1)};
                m.normal_impulse[k] = random.between(0, 5);
                m.separation[k] = random.between(-0.015f, 0.001f);
            }
            m.load = random.one_in(30) ? most_load : random.between(-1, 100);
        }
    }
};

bool is_kept_by_one_lane(const RandomContacts& all, std::uint32_t i, const ContactManifold& m, bool follows_deep) {
    const Pose &a = all.poses[m.body_a], &b = all.poses[m.body_b];
    const Aabb &box_a = all.boxes[all.contacts[i].shape_a], &box_b = all.boxes[all.contacts[i].shape_b];
    const bool deep = min(m.separation[0], m.separation[1]) < sunk_from && has_floor(a, b);
    const bool stay_near = ((a.flags | b.flags) & pose_moved) == 0 || (meet(box_a, box_b) && !may_be_endless(box_a));
    return (m.flags & contact_special) == 0 && is_settled(all.motions.data(), m, a, b) && stay_near && !(follows_deep && deep);
}

using KeepSettled = decltype(keep_settled_4);

template <std::uint32_t W>
void expect_as_one_lane(KeepSettled* keep, bool follows_deep) {
    RandomContacts all(8000);
    std::vector<ContactManifold> wanted = all.manifolds;
    LoadFollower loads{State{}, 1.0f / 60};
    loads.rate = {0.9f, 0.1f};
    const ContactsToKeep in{all.manifolds.data(), all.contacts.data(), all.poses.data(), all.motions.data(),
                            all.boxes.data(),     widest_box,          loads.rate,       follows_deep};
    std::uint32_t settled = 0, moved = 0, apart = 0, lagging = 0;
    for (std::uint32_t i = 0; i + W <= wanted.size(); i += W) {
        std::uint32_t contact[W], bits = 0;
        for (std::uint32_t k = 0; k < W; ++k) {
            contact[k] = i + (5 * k + 3) % W;  // in any order
            ContactManifold& m = wanted[contact[k]];
            if (!is_kept_by_one_lane(all, contact[k], m, follows_deep)) continue;
            bits |= 1u << k;
            moved += ((all.poses[m.body_a].flags | all.poses[m.body_b].flags) & pose_moved) != 0;
            apart += m.count() == 0;
            lagging += m.count() != 0 && abs(inv_mul(m.rotation_a, all.poses[m.body_a].q).s) > least_lag;
            loads.follow(m);
            ++settled;
        }
        ASSERT_EQ(keep(in, contact), bits) << "contacts from " << i;
    }
    EXPECT_EQ(std::memcmp(all.manifolds.data(), wanted.data(), wanted.size() * sizeof(ContactManifold)), 0);
    EXPECT_GT(settled, wanted.size() / 8);
    EXPECT_GT(moved, settled / 8);  // of those whose boxes changed, some are kept
    EXPECT_GT(apart, settled / 20);
    EXPECT_GT(lagging, settled / 20);
    EXPECT_LT(settled, wanted.size() * 4 / 5);
}

TEST(SettledContacts, InLanesAreThoseThatOneLaneKeeps) {
    for (const bool follows_deep : {false, true}) {
        expect_as_one_lane<4>(keep_settled_4, follows_deep);
#if ISLET_MAX_LANES >= 8
        if (cpu_has_avx2()) expect_as_one_lane<8>(keep_settled_8, follows_deep);
#endif
    }
}

#endif

}  // namespace
}  // namespace islet::detail
