// Manifolds that lanes make are those that the narrow phase makes for one pair, bit by bit; where lanes leave a pair, that has corners that meet.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "../../engine/src/broadphase/pairs.hpp"
#include "../../engine/src/collide/distance.hpp"
#include "../../engine/src/collide/outline.hpp"
#include "../../engine/src/geometry/convex.hpp"
#include "../../engine/src/graph/contacts.hpp"
#include "../../engine/src/math/cpu.hpp"
#include "../../engine/src/shapes/manifolds.hpp"
#include "../../engine/src/shapes/shape_types.hpp"
#include "../../engine/src/solver/update_kernels.hpp"
#include "../../engine/src/step/lane_update.hpp"
#include "support/random.hpp"

namespace islet::detail {
namespace {

#if ISLET_MAX_LANES > 1

constexpr float frame_time = 1.0f / 60;

Polygon some_polygon(test::Random& random) {
    Vec2 corners[max_polygon_vertices];
    const std::uint32_t count = 3 + random.below(6);
    const float size = random.between(0.1f, 1.5f);
    for (Vec2& corner : corners) corner = {random.between(-size, size), random.between(-size, size)};
    const Polygon polygon = make_polygon(compute_hull({corners, count}), random.one_in(3) ? random.between(0, 0.2f) : 0.0f);
    return polygon.count >= 3 ? polygon : make_box(size, size);
}
Polygon some_box(test::Random& random) {
    const float h = random.between(0.05f, 1.5f), w = random.one_in(3) ? h : random.between(0.05f, 1.5f);
    const Vec2 center = random.one_in(2) ? Vec2{} : Vec2{random.between(-1, 1), random.between(-1, 1)};
    const float angle = random.one_in(2) ? 0.0f : random.between(-3, 3);
    return make_offset_box(h, w, {center, make_rot(angle)}, random.one_in(3) ? random.between(0, 0.2f) : 0.0f);
}
Capsule some_capsule(test::Random& random) {
    const Vec2 from = {random.between(-1, 1), random.between(-1, 1)};
    const float angle = random.between(-3, 3), length = random.between(0.01f, 1.5f);
    return {from, from + length * rotate(make_rot(angle), {1, 0}), random.between(0.02f, 0.5f)};
}
Circle some_circle(test::Random& random) {
    return {random.one_in(2) ? Vec2{} : Vec2{random.between(-1, 1), random.between(-1, 1)}, random.between(0.02f, 1)};
}

// Pairs of one kind that touch, nearly touch, or do not, with old manifolds of all sorts. The bodies of pair i are 2 i and 2 i + 1, and so are the geometries.
struct RandomPairs {
    std::vector<ContactManifold> manifolds;
    std::vector<float> clearances;
    std::vector<Pose> poses;
    std::vector<Motion> motions;
    std::vector<Body> bodies;
    std::vector<Geometry> geometries;
    State state;
    Core core;

    RandomPairs(PairKind kind, std::uint32_t count)
        : manifolds(count), clearances(count, -1.0f), poses(2 * count), motions(2 * count), bodies(2 * count), geometries(2 * count) {
        test::Random random(static_cast<unsigned>(kind) + 1);
        for (std::uint32_t i = 0; i < 2 * count; ++i) {
            geometries[i] = shape_for(kind, i % 2 == 0, random);
            Pose& p = poses[i];
            // Some are far out, some turned alike, so that faces are parallel.
            const Vec2 at = i % 2 == 1 ? poses[i - 1].center : random.one_in(4) ? Vec2{random.between(-9000, 9000), 400} : Vec2{};
            const float apart = random.one_in(3) ? 0.5f : 1.8f;
            p.center = at + Vec2{random.between(-apart, apart), random.between(-apart, apart)};
            p.q = i % 2 == 1 && random.one_in(3) ? poses[i - 1].q : make_rot(random.one_in(4) ? 1.5707963f * random.between(0, 3) : random.between(-3, 3));
            p.inv_mass = p.inv_inertia = 1;
            p.max_extent = random.between(0.2f, 2);
            if (random.one_in(3)) p.flags = pose_fast;
            motions[i].v = {random.between(-3, 3), random.between(-3, 3)};
            motions[i].w = random.between(-4, 4);
            bodies[i].local_center = random.one_in(2) ? Vec2{} : Vec2{random.between(-0.5f, 0.5f), random.between(-0.5f, 0.5f)};
            bodies[i].min_extent = random.between(0.02f, 0.3f);
        }
        // Some circles are on a capsule's axis but for rounding, or on another circle's centre.
        for (std::uint32_t i = 0; i < 2 * count && kind >= PairKind::capsule_circle; i += 2) {
            if (!random.one_in(12)) continue;
            poses[i + 1].center = poses[i].center;
            poses[i + 1].q = poses[i].q;
            bodies[i + 1].local_center = bodies[i].local_center;
            const Capsule& line = geometries[i].capsule;
            geometries[i + 1].circle.center =
                kind == PairKind::circles ? geometries[i].circle.center : lerp(line.point1, line.point2, random.between(-0.2f, 1.2f));
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            ContactManifold& m = manifolds[i];
            m.body_a = 2 * i;
            m.body_b = 2 * i + 1;
            const std::uint32_t points = random.below(3);
            m.flags = contact_posed | points << contact_count_shift | (points > 0 || random.one_in(5) ? std::uint32_t{contact_touching} : 0u);
            if (random.one_in(8)) m.flags |= contact_bouncy;
            if (points > 0 && random.one_in(6)) m.flags |= contact_ahead | (random.one_in(3) ? std::uint32_t{contact_untold} : 0u);
            for (std::uint32_t k = 0; k < points; ++k) {
                m.normal_impulse[k] = random.between(0, 5);
                m.tangent_impulse[k] = random.between(-2, 2);
            }
            // Ids that a new manifold may have, too.
            m.ids = random.below(4) << 8 | random.below(4) | random.below(4) << 24 | random.below(4) << 16;
            m.load = random.one_in(30) ? most_load : random.between(-1, 100);
            m.friction = 0.6f;
        }
        state.gravity = {0.5f, -9.8f};
        state.solver.substeps = 4;
        state.continuous = 1;
        core.state = &state;
        core.poses = poses.data();
        core.motions = motions.data();
        core.bodies = bodies.data();
        core.manifolds = manifolds.data();
        core.geometries = geometries.data();
        core.clearances = clearances.data();
    }

    static Geometry shape_for(PairKind kind, bool is_a, test::Random& random) {
        switch (kind) {
            case PairKind::boxes: return geometry_of(some_box(random));
            case PairKind::polygons: return geometry_of(some_polygon(random));
            case PairKind::polygon_capsule: return is_a ? geometry_of(some_polygon(random)) : geometry_of(some_capsule(random));
            case PairKind::capsules: return geometry_of(some_capsule(random));
            case PairKind::polygon_circle: return is_a ? geometry_of(some_polygon(random)) : geometry_of(some_circle(random));
            case PairKind::capsule_circle: return is_a ? geometry_of(some_capsule(random)) : geometry_of(some_circle(random));
            case PairKind::circles: break;
        }
        return geometry_of(some_circle(random));
    }
};

Manifold manifold_of_pair(PairKind kind, const Geometry& a, const Geometry& b, const Transform& b_in_a, float margin) {
    switch (kind) {
        case PairKind::boxes: return collide_boxes(a.polygon, b.polygon, b_in_a, margin);
        case PairKind::polygons: return collide(a.polygon, b.polygon, b_in_a, margin);
        case PairKind::polygon_capsule: return collide(a.polygon, b.capsule, b_in_a, margin);
        case PairKind::capsules: return collide(a.capsule, b.capsule, b_in_a, margin);
        case PairKind::polygon_circle: return collide(a.polygon, b.circle, b_in_a, margin);
        case PairKind::capsule_circle: return collide(a.capsule, b.circle, b_in_a, margin);
        case PairKind::circles: break;
    }
    return collide(a.circle, b.circle, b_in_a, margin);
}

// How the two bodies of a pair come together (approach_to in step/contact_update.cpp).
Approach approach_of_pair(const RandomPairs& all, std::uint32_t i, float fall) {
    const ContactManifold& m = all.manifolds[i];
    const Pose &a = all.poses[m.body_a], &b = all.poses[m.body_b];
    const Motion &of_a = all.motions[m.body_a], &of_b = all.motions[m.body_b];
    if (((a.flags | b.flags) & pose_fast) == 0 || (m.flags & contact_bouncy) != 0) return {};
    const Approach approach = approach_of(a, b, of_a, of_b, frame_time, m.count() == 0 ? fall : 0);
    if ((a.flags & b.flags & pose_fast) == 0) return approach;
    const float way = approach.most(), slower = min(length_squared(of_a.v), length_squared(of_b.v));
    const float smaller = min(all.bodies[m.body_a].min_extent, all.bodies[m.body_b].min_extent);
    return way * way < 16 * frame_time * frame_time * slower && way <= smaller ? Approach{} : approach;
}

// What the contact of a pair becomes, and the clearance that is noted of it. False if the pair is not for lanes: its shapes may meet later in the step.
bool remake_by_itself(const RandomPairs& all, PairKind kind, std::uint32_t i, const ContactsInLanes& in, ContactManifold& m, float& clearance) {
    const Pose &a = all.poses[m.body_a], &b = all.poses[m.body_b];
    const Approach approach = approach_of_pair(all, i, in.fall);
    const bool fast = approach.most() > in.comes_fast;
    const float margin = fast ? speculative_distance + 2 * approach.most() : speculative_distance;
    const Stand stand = stand_now(all.core, m.body_a, m.body_b);
    const Transform b_in_a = pose_between(all.core, m.body_a, m.body_b, stand);
    Manifold found = manifold_of_pair(kind, all.geometries[m.body_a], all.geometries[m.body_b], b_in_a, margin);
    if (fast && found.count > 0 && least_separation(found) > speculative_distance) {
        const float gap = least_separation(found) + dot(rotate(a.q, found.normal), approach.way);
        if (!(gap > approach.turn + 1.1f * touch_gap)) return false;
        found = {};  // they only pass
    }
    if (found.count == 0) clearance = found.clearance;
    const ContactManifold old = m;
    if (old.count() != 0) {
        const float load = in.rate.keep * old.load + in.rate.gain * (old.normal_impulse[0] + old.normal_impulse[1]);
        m.load = load >= 0 && load < most_load ? load : 0;
    }
    if (found.count == 0) m.load = 0;
    m.offset = stand.offset;
    m.rotation_a = a.q;
    m.rotation_b = b.q;
    m.normal = rotate(a.q, found.normal);
    m.ids = 0;
    for (std::uint32_t k = 0; k < 2; ++k) {
        m.anchors[k] = {0, 0};
        m.separation[k] = m.normal_impulse[k] = m.tangent_impulse[k] = 0;
        if (k >= found.count) continue;
        m.anchors[k] = rotate(a.q, found.points[k].point - all.bodies[m.body_a].local_center);
        m.separation[k] = found.points[k].separation;
        m.ids |= static_cast<std::uint32_t>(found.points[k].id) << 16 * k;
        for (std::uint32_t j = 0; j < old.count() && (old.flags & contact_ahead) == 0; ++j) {  // those of a blow are not kept
            if ((old.ids >> 16 * j & 0xffffu) != found.points[k].id) continue;
            m.normal_impulse[k] = old.normal_impulse[j];
            m.tangent_impulse[k] = old.tangent_impulse[j];
        }
    }
    const bool lands = found.count > 0 && approach.turn - dot(m.normal, approach.way) > 2 * speculative_distance;
    m.flags = (old.flags & ~(3u << contact_count_shift | contact_ahead)) | found.count << contact_count_shift | (lands ? std::uint32_t{contact_ahead} : 0u);
    return true;
}

template <std::uint32_t W>
void expect_to_remake_as_one_lane(PairKind kind, decltype(remake_4)* remake) {
    SCOPED_TRACE(testing::Message() << "kind " << static_cast<int>(kind) << ", " << W << " lanes");
    RandomPairs all(kind, 16000);
    const LoadRate rate = {0.9f, 0.1f};
    const ContactsInLanes in = contacts_in_lanes(all.core, rate, frame_time, fall_in(all.core, frame_time));
    std::uint32_t none = 0, one = 0, two = 0, matched = 0, ahead = 0, left = 0, left_early = 0;
    for (std::uint32_t first = 0; first + W <= all.manifolds.size(); first += W) {
        LanePairs pairs;
        for (std::uint32_t k = 0; k < W; ++k) {
            pairs.contact[k] = first + (5 * k + 3) % W;
            pairs.geometry_a[k] = 2 * pairs.contact[k];
            pairs.geometry_b[k] = 2 * pairs.contact[k] + 1;
        }
        const std::vector<ContactManifold> before(all.manifolds.begin() + first, all.manifolds.begin() + first + W);
        ContactManifold wanted[W];
        float clearances[W];
        bool is_for_lanes[W];
        for (std::uint32_t k = 0; k < W; ++k) {
            const std::uint32_t i = pairs.contact[k];
            wanted[k] = all.manifolds[i];
            clearances[k] = -1;
            is_for_lanes[k] = remake_by_itself(all, kind, i, in, wanted[k], clearances[k]);
        }
        Remade out;
        remake(in, kind, pairs, out);
        for (std::uint32_t k = 0; k < W; ++k) {
            const std::uint32_t i = pairs.contact[k];
            const ContactManifold &m = all.manifolds[i], &old = before[i - first];
            const bool is_done = (out.done >> k & 1u) != 0;
            if (!is_done) {
                ++left;
                left_early += !is_for_lanes[k];
                ASSERT_EQ(std::memcmp(&m, &old, sizeof m), 0) << "contact " << i << " was left, but is not as it was";
                ASSERT_EQ(out.changed >> k & 1u, 0u);
                ASSERT_EQ(all.clearances[i], -1);
                continue;
            }
            ASSERT_TRUE(is_for_lanes[k]) << "contact " << i;
            ASSERT_EQ(std::memcmp(&m, &wanted[k], sizeof m), 0) << "contact " << i;
            const bool changes = (m.count() != 0) != ((m.flags & contact_touching) != 0) || (m.flags & contact_untold) != 0;
            ASSERT_EQ((out.changed >> k & 1u) != 0, changes) << "contact " << i;
            if (m.count() == 0) {
                ASSERT_EQ(all.clearances[i], clearances[k]) << "contact " << i;
            }
            none += m.count() == 0;
            one += m.count() == 1;
            two += m.count() == 2;
            matched += m.normal_impulse[0] != 0 || m.normal_impulse[1] != 0;
            ahead += (m.flags & contact_ahead) != 0;
        }
    }
    const bool has_faces = kind <= PairKind::capsules;
    EXPECT_GT(none, 1000u);
    EXPECT_GT(one, 300u);
    EXPECT_GT(matched, 20u);
    EXPECT_GT(ahead, 20u);
    if (has_faces) {
        EXPECT_GT(two, 300u);
    } else {
        EXPECT_EQ(left, left_early);  // no corners meet: all are decided
    }
    EXPECT_LT(left, 16000u / 2);
    if (kind != PairKind::boxes) {
        EXPECT_LT(left - left_early, 16000u / 6);  // what overlaps where faces do not meet, and what alone of its lanes has corners that meet
    }
}

TEST(RemakeInLanes, ManifoldsAreThoseOfOnePair) {
    for (std::uint32_t kind = 0; kind < pair_kinds; ++kind) {
        expect_to_remake_as_one_lane<4>(static_cast<PairKind>(kind), remake_4);
#if ISLET_MAX_LANES >= 8
        if (cpu_has_avx2()) expect_to_remake_as_one_lane<8>(static_cast<PairKind>(kind), remake_8);
#endif
    }
}

// Two outlines that look at each other across a gap of any size, or overlap; their sides are often parallel, or nearly so.
struct TwoCores {
    Vec2 corners[2][max_polygon_vertices];
    std::uint32_t count[2];

    explicit TwoCores(test::Random& random) {
        const float angle = random.one_in(3) ? 0.0f : random.between(-3, 3), lean = random.one_in(2) ? 0.0f : random.between(-1e-4f, 1e-4f);
        const float gaps[] = {0.01f, 1e-3f, 1e-5f, 1e-7f, 0, -0.01f, -0.5f};
        const float gap = gaps[random.below(7)] * random.between(0.5f, 1.5f), along = random.between(-1.5f, 1.5f);
        for (std::uint32_t k = 0; k < 2; ++k) {
            // The half of a rounded outline below or above a line, and of a capsule the line alone.
            const float side = k == 0 ? -1.0f : 1.0f;
            count[k] = 2 + random.below(7);
            for (std::uint32_t i = 0; i < count[k]; ++i) {
                const float turn = side * 3.1415927f * static_cast<float>(i) / static_cast<float>(count[k] - 1) + (k == 0 ? 0.0f : lean);
                const Vec2 at = rotate(make_rot(turn), {0.5f, 0});
                corners[k][i] = rotate(make_rot(angle), at + (k == 0 ? Vec2{0, 0} : Vec2{along, gap}));
            }
        }
    }
};

TEST(RemakeInLanes, CoresAreAsFarApartAsOnePairOfThem) {
    using L = Lane4;
    test::Random random(11);
    std::uint32_t apart = 0, along_edges = 0, others = 0;
    for (std::uint32_t turn = 0; turn < 20000; ++turn) {
        std::vector<TwoCores> pairs;
        for (std::uint32_t k = 0; k < L::width; ++k) pairs.emplace_back(random);
        LaneOutline<L> outlines[2];
        for (std::uint32_t side = 0; side < 2; ++side) {
            LaneOutline<L>& o = outlines[side];
            o.most = 2;
            for (const TwoCores& pair : pairs) o.most = std::max(o.most, pair.count[side]);
            for (std::uint32_t i = 0; i < o.most; ++i)
                for (std::uint32_t k = 0; k < L::width; ++k) {
                    const Vec2 corner = pairs[k].corners[side][i < pairs[k].count[side] ? i : 0];
                    o.vertices[i].x[k] = corner.x;
                    o.vertices[i].y[k] = corner.y;
                }
        }
        const LaneDistances<L> found = core_distances(outlines[0], outlines[1], 15);
        for (std::uint32_t k = 0; k < L::width; ++k) {
            const TwoCores& pair = pairs[k];
            const DistanceResult wanted = core_distance(pair.corners[0], pair.count[0], pair.corners[1], pair.count[1]);
            const bool is_other = wanted.normal == Vec2{};
            ASSERT_EQ((found.others >> k & 1u) != 0, is_other) << "turn " << turn;
            others += is_other;
            if (is_other) continue;
            ++apart;
            along_edges += wanted.count == 2;
            ASSERT_EQ(found.distance[k], wanted.distance) << "turn " << turn;
            ASSERT_EQ((Vec2{found.normal.x[k], found.normal.y[k]}), wanted.normal) << "turn " << turn;
            ASSERT_EQ((Vec2{found.point_a.x[k], found.point_a.y[k]}), wanted.point_a) << "turn " << turn;
            ASSERT_EQ((Vec2{found.point_b.x[k], found.point_b.y[k]}), wanted.point_b) << "turn " << turn;
            ASSERT_EQ(found.id[k], wanted.index_a[0] << 8 | wanted.index_b[0]) << "turn " << turn;
        }
    }
    EXPECT_GT(apart, 20000u);
    EXPECT_GT(along_edges, 10000u);
    EXPECT_GT(others, 10000u);
}

#endif

}  // namespace
}  // namespace islet::detail
