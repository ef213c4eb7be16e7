// The contact update in lanes keeps the manifolds that one lane keeps, and tells those shapes apart that one lane tells apart; all comes to the same bits.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "../../engine/src/broadphase/pairs.hpp"
#include "../../engine/src/math/boxes.hpp"
#include "../../engine/src/math/cpu.hpp"
#include "../../engine/src/solver/update_kernels.hpp"
#include "../../engine/src/step/clearance.hpp"
#include "../../engine/src/step/lane_update.hpp"
#include "../../engine/src/step/recycling.hpp"
#include "support/random.hpp"

namespace islet::detail {
namespace {

#if ISLET_MAX_LANES > 1

Rot turned(Rot q, float angle) { return q * make_rot(angle); }

constexpr float dt = 1.0f / 60;

// Contacts near all the limits at which lanes leave one to be looked at by itself. Each body has one shape, of its own index.
struct RandomContacts {
    std::vector<ContactManifold> manifolds;
    std::vector<Contact> contacts;
    std::vector<float> clearances;
    std::vector<Pose> poses;
    std::vector<Motion> motions;
    std::vector<Body> bodies;
    std::vector<Aabb> boxes;
    State state;
    Core core;
    LoadFollower loads{State{}, dt};

    explicit RandomContacts(std::uint32_t count)
        : manifolds(count), contacts(count), clearances(count), poses(count + 1), motions(count + 1), bodies(count + 1), boxes(count + 1) {
        test::Random random(7);
        state.gravity = {0.5f, -9.8f};
        loads.rate = {0.9f, 0.1f};
        for (std::uint32_t i = 0; i <= count; ++i) {
            Aabb& box = boxes[i];
            const Vec2 middle = {random.between(-1, 1), random.between(-1, 1)};
            box = {middle - Vec2{random.between(0, 1.5f), 1}, middle + Vec2{1, random.between(0, 1.5f)}};
            // Some boxes are just beside those before them.
            if (i > 0 && random.one_in(3) && boxes[i - 1].upper.x < 2) {
                box.lower.x = boxes[i - 1].upper.x + random.between(0, 0.02f);
                box.upper.x = box.lower.x + 1;
            }
            if (random.one_in(20)) box.upper.x = endless_reach;
        }
        for (std::uint32_t i = 0; i <= count; ++i) {
            Pose& p = poses[i];
            p.center = {random.between(-1, 1), random.between(-1, 1)};
            p.q = make_rot(random.between(-3, 3));
            p.inv_mass = p.inv_inertia = random.one_in(4) ? 0.0f : 1.0f;
            p.max_extent = random.one_in(3) ? random.between(0.01f, 0.3f) : random.between(0.2f, 3);
            const std::uint32_t flags[] = {pose_moved, pose_fast, pose_learns, pose_alone, pose_deep};
            if (random.one_in(12)) p.flags = flags[random.below(5)];
            if (random.one_in(3)) p.flags |= pose_moved;
            if (random.one_in(3)) p.flags |= random.one_in(2) ? std::uint32_t{pose_fast} : pose_fast | pose_leaves;
            motions[i].v = {random.between(-0.7f, 0.7f), random.between(-0.7f, 0.7f)};
            motions[i].w = i > 0 && !random.one_in(6) ? motions[i - 1].w * random.between(0.93f, 1.07f) : random.between(-0.6f, 0.6f);
            bodies[i].contact_count = 1 + random.below(3);
            bodies[i].local_center = {random.between(-0.5f, 0.5f), random.between(-0.5f, 0.5f)};
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            ContactManifold& m = manifolds[i];
            m.body_a = i;
            m.body_b = i + 1;
            contacts[i].shape_a = i;
            contacts[i].shape_b = i + 1;
            const std::uint32_t others[] = {contact_special, contact_sensor, contact_asks,   contact_one_way,
                                            contact_ahead,   contact_untold, contact_bouncy, contact_hits};
            m.flags = settled_flags | (random.one_in(8) ? 1u : 2u) << contact_count_shift;
            const bool apart = random.one_in(3);
            if (apart) m.flags = apart_flags;
            if (random.one_in(6)) m.flags |= others[random.below(8)];
            if (!apart && random.one_in(20)) m.flags |= contact_ahead | (random.one_in(3) ? std::uint32_t{contact_untold} : 0u);
            if (random.one_in(20)) m.flags &= ~(random.one_in(2) ? std::uint32_t{contact_touching} : std::uint32_t{contact_posed});
            if (random.one_in(4)) m.set_sharers(1 + random.below(3));
            const Pose &a = poses[i], &b = poses[i + 1];
            const float lag = random.one_in(5) ? 0.13f : apart ? 0.003f : 0.0015f, slip = random.one_in(4) ? 0.02f : 0.006f;
            const float both = random.one_in(3) ? random.between(-0.1f, 0.1f) : 0.0f;  // they turned together
            m.rotation_a = turned(a.q, both + random.between(-lag, lag));
            m.rotation_b = turned(b.q, both + random.between(-lag, lag));
            m.normal = rotate(make_rot(random.one_in(2) ? random.between(-3, 3) : random.between(1.2f, 1.9f)), {1, 0});
            m.offset = b.center - a.center + Vec2{random.between(-slip, slip), random.between(-slip, slip)};
            for (std::uint32_t k = 0; k < 2; ++k) {
                m.anchors[k] = {random.between(-1, 1), random.between(-1, 1)};
                m.tangent_impulse[k] = random.between(-1, 1);
                m.normal_impulse[k] = random.one_in(4) ? random.between(0, 0.5f) : random.between(0, 5);
                m.separation[k] = random.between(-0.015f, 0.001f);
            }
            m.friction = 0.6f;
            m.load = random.one_in(30) ? most_load : random.between(-1, 100);
            clearances[i] = random.one_in(4) ? 0.0f : random.between(0, 0.3f);
        }
        core.state = &state;
        core.poses = poses.data();
        core.motions = motions.data();
        core.bodies = bodies.data();
        core.manifolds = manifolds.data();
        core.contacts = contacts.data();
        core.boxes = boxes.data();
        core.clearances = clearances.data();
    }

    const Pose& a(std::uint32_t i) const { return poses[manifolds[i].body_a]; }
    const Pose& b(std::uint32_t i) const { return poses[manifolds[i].body_b]; }
    const Aabb& box_a(std::uint32_t i) const { return boxes[contacts[i].shape_a]; }
    const Aabb& box_b(std::uint32_t i) const { return boxes[contacts[i].shape_b]; }
    bool have_moved(std::uint32_t i) const { return ((a(i).flags | b(i).flags) & pose_moved) != 0; }
};

// Whether lanes have to do with a contact that touches, by its bodies and boxes.
bool are_for_lanes(const RandomContacts& all, std::uint32_t i) {
    return ((all.a(i).flags | all.b(i).flags) & pose_learns) == 0 &&
           (!all.have_moved(i) || (meet(all.box_a(i), all.box_b(i)) && !may_be_endless(all.box_a(i))));
}

// Keeps the manifold as one lane does, if that may.
bool keep_by_itself(const RandomContacts& all, std::uint32_t i, bool follows_deep, ContactManifold& m) {
    const Pose &a = all.a(i), &b = all.b(i);
    if (!lanes_keep(m.flags) || !are_for_lanes(all, i)) return false;
    if (follows_deep && min(m.separation[0], m.separation[1]) < sunk_from && has_floor(a, b)) return false;
    ContactManifold kept = m;
    all.loads.follow(kept);
    turn_along(all.core, kept, a, b);
    if (!can_recycle(all.core, kept, a, b)) return false;
    m = kept;
    return true;
}

// Whether a contact that touches is for lanes, and needs a new manifold.
bool needs_a_new_one(const RandomContacts& all, std::uint32_t i, bool is_kept) {
    const std::uint32_t flags = all.manifolds[i].flags;
    const bool struck = (flags & contact_ahead) != 0 && lanes_keep(flags & ~static_cast<std::uint32_t>(contact_ahead | contact_untold));
    return (lanes_keep(flags) || struck) && are_for_lanes(all, i) && !has_floor(all.a(i), all.b(i)) && !is_kept;
}

using KeepTouching = decltype(keep_touching_4);
using TellApart = decltype(tell_apart_4);

// W contacts from `first`, in some order.
template <std::uint32_t W>
struct Some {
    std::uint32_t contact[W];

    explicit Some(std::uint32_t first) {
        for (std::uint32_t k = 0; k < W; ++k) contact[k] = first + (5 * k + 3) % W;
    }
};

template <std::uint32_t W>
void expect_to_keep_as_one_lane(KeepTouching* keep, bool follows_deep) {
    RandomContacts all(16000);
    std::vector<ContactManifold> wanted = all.manifolds;
    all.state.continuous = follows_deep ? 1 : 0;
    const ContactsInLanes in = contacts_in_lanes(all.core, all.loads.rate, dt, fall_in(all.core, dt));
    std::uint32_t kept = 0, moved = 0, turned = 0, crept = 0, anew = 0, struck = 0;
    for (std::uint32_t i = 0; i + W <= wanted.size(); i += W) {
        const Some<W> some(i);
        std::uint32_t bits = 0, anew_bits = 0;
        for (std::uint32_t k = 0; k < W; ++k) {
            const std::uint32_t contact = some.contact[k];
            ContactManifold& m = wanted[contact];
            const ContactManifold old = m;
            const Pose &a = all.a(contact), &b = all.b(contact);
            const bool is_kept = keep_by_itself(all, contact, follows_deep, m);
            if (needs_a_new_one(all, contact, is_kept)) {
                anew_bits |= 1u << k;
                struck += (m.flags & contact_ahead) != 0;
            }
            if (!is_kept) continue;
            bits |= 1u << k;
            ++kept;
            moved += all.have_moved(contact);
            turned += m.normal != old.normal;
            crept += !has_kept_points(m, a, b, m.count(), inv_mul(m.rotation_a, a.q), inv_mul(m.rotation_b, b.q), recycle_distance);
        }
        anew += static_cast<std::uint32_t>(std::popcount(anew_bits));
        const KeptTouching told = keep(in, some.contact);
        ASSERT_EQ(told.kept, bits) << "contacts from " << i;
        ASSERT_EQ(told.anew, anew_bits) << "contacts from " << i;
    }
    EXPECT_EQ(std::memcmp(all.manifolds.data(), wanted.data(), wanted.size() * sizeof(ContactManifold)), 0);
    EXPECT_GT(kept, wanted.size() / 10);
    EXPECT_GT(moved, kept / 8);  // of those whose boxes changed, some are kept
    EXPECT_GT(turned, kept / 20);
    EXPECT_GT(crept, kept / 100);
    EXPECT_GT(anew, wanted.size() / 10);
    EXPECT_GT(struck, anew / 200);
    EXPECT_LT(kept, wanted.size() * 4 / 5);
}

template <std::uint32_t W>
void expect_to_tell_apart_as_one_lane(TellApart* tell) {
    RandomContacts all(40000);
    const std::vector<ContactManifold> before = all.manifolds;
    const float fall = fall_in(all.core, dt);
    const ContactsInLanes in = contacts_in_lanes(all.core, all.loads.rate, dt, fall);
    std::uint32_t kept = 0, far = 0, fast = 0, by_clearance = 0, on_the_way = 0, anew = 0, parts = 0;
    for (std::uint32_t i = 0; i + W <= before.size(); i += W) {
        const Some<W> some(i);
        ToldApart told;
        tell(in, some.contact, told);
        for (std::uint32_t k = 0; k < W; ++k) {
            const std::uint32_t contact = some.contact[k];
            const ContactManifold& m = before[contact];
            if (m.count() != 0) continue;  // none of those that are asked about
            const Pose &a = all.a(contact), &b = all.b(contact);
            const bool is_kept = (told.kept >> k & 1u) != 0, is_apart = (told.apart >> k & 1u) != 0, is_fast = (told.fast >> k & 1u) != 0;
            const bool boxes_meet = meet(all.box_a(contact), all.box_b(contact));
            const bool near = boxes_meet || may_meet(all.core, m.body_a, all.box_a(contact), m.body_b, all.box_b(contact), dt);
            Approach approach;
            const bool looks = ((a.flags | b.flags) & pose_fast) != 0 && ((m.flags & contact_bouncy) == 0 || has_floor(a, b));
            if (looks) approach = approach_of(a, b, all.motions[m.body_a], all.motions[m.body_b], dt, fall);
            const bool comes_fast = approach.most() > 2.0f * fast_way, undecided = comes_fast && (a.flags & b.flags & pose_fast) != 0 && !has_floor(a, b);
            const bool stays = can_recycle(all.core, m, a, b);
            const float margin = speculative_distance + 2.0f * approach.most() + inexact_by(all.core, m, a, b), most = margin + a.max_extent + b.max_extent;
            const bool circles_apart = length_squared(b.center - a.center) > most * most;
            const float clearance = clearance_now(all.core, contact, a, b, margin);
            if (!lanes_tell_apart(m.flags) || (all.have_moved(contact) && (!near || may_be_endless(all.box_a(contact))))) {
                ASSERT_EQ((told.parts >> k & 1u) != 0, lanes_tell_apart(m.flags) && !near) << "contact " << contact;
                parts += told.parts >> k & 1u;
                ASSERT_FALSE(is_kept || is_apart || (told.anew >> k & 1u) != 0) << "contact " << contact;
                continue;
            }
            ASSERT_EQ(is_kept, stays && !comes_fast) << "contact " << contact;
            ASSERT_EQ(is_apart, (!stays || (comes_fast && !undecided)) && (circles_apart || clearance > 0)) << "contact " << contact;
            ASSERT_EQ(is_fast, is_apart && comes_fast) << "contact " << contact;
            if (is_apart) {
                ASSERT_EQ(told.clearance[k], circles_apart ? 0 : clearance) << "contact " << contact;
            }
            ASSERT_EQ(told.parts >> k & 1u, 0u) << "contact " << contact;
            const bool is_anew = (told.anew >> k & 1u) != 0;
            ASSERT_EQ(is_anew, !is_apart && !has_floor(a, b) && (!stays || (comes_fast && !undecided))) << "contact " << contact;
            kept += is_kept;
            anew += is_anew;
            far += is_apart;
            fast += is_fast;
            by_clearance += is_apart && !circles_apart;
            on_the_way += is_apart && all.have_moved(contact) && !boxes_meet;
        }
    }
    EXPECT_EQ(std::memcmp(all.manifolds.data(), before.data(), before.size() * sizeof(ContactManifold)), 0);
    for (const std::uint32_t count : {kept, far, fast, by_clearance, on_the_way, anew, parts}) EXPECT_GT(count, 40u);
}

TEST(ContactsInLanes, ThoseKeptAreThoseThatOneLaneKeeps) {
    for (const bool follows_deep : {false, true}) {
        expect_to_keep_as_one_lane<4>(keep_touching_4, follows_deep);
#if ISLET_MAX_LANES >= 8
        if (cpu_has_avx2()) expect_to_keep_as_one_lane<8>(keep_touching_8, follows_deep);
#endif
    }
}

TEST(ContactsInLanes, ThoseToldApartAreThoseThatOneLaneTellsApart) {
    expect_to_tell_apart_as_one_lane<4>(tell_apart_4);
#if ISLET_MAX_LANES >= 8
    if (cpu_has_avx2()) expect_to_tell_apart_as_one_lane<8>(tell_apart_8);
#endif
}

#endif

}  // namespace
}  // namespace islet::detail
