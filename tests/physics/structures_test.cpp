// What stands because all of its parts lean on each other: brick walls in bond, houses of cards, thin arches. Each is built at several sizes, from five starts or ten.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "arch.hpp"
#include "measure.hpp"
#include "support/random.hpp"

namespace islet::test {
namespace {

constexpr std::uint64_t house_starts = slow_build ? 1 : 10;

/// m, the farthest that one of the bodies has sunk.
float farthest_sunk(const TestWorld& world, const std::vector<BodyId>& bodies, const std::vector<float>& heights) {
    float most = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) most = max(most, heights[i] - world->center_of_mass(bodies[i]).y);
    return most;
}

/// A wall in bond, six bricks wide: every other row begins and ends with half a brick.
std::vector<BodyId> add_wall(TestWorld& world, int rows, Vec2 brick, float gap, Random& random) {
    std::vector<BodyId> all;
    for (int row = 0; row < rows; ++row) {
        const bool odd = (row & 1) != 0;
        for (int i = 0; i < (odd ? 7 : 6); ++i) {
            const float left = odd ? max(-3.5f + static_cast<float>(i), -3.0f) : -3.0f + static_cast<float>(i);
            const float right = odd ? min(-2.5f + static_cast<float>(i), 3.0f) : -2.0f + static_cast<float>(i);
            const Vec2 at = {0.5f * (left + right) * brick.x + random.between(-0.3f, 0.3f) * gap, (static_cast<float>(row) + 0.5f) * brick.y};
            all.push_back(world.add_box(at, 0.5f * ((right - left) * brick.x - gap), 0.5f * brick.y));
        }
    }
    return all;
}

// Bricks of 2 x 1 m and of 1.5 x 0.5 m. (While the left contact of each brick was solved before its right one, a shear wave went round in walls of 15 to 26
// rows of the first kind, at 0.1 m/s for ever.)
TEST(Structures, WallsInBondComeToRestAndSleep) {
    for (const Vec2 brick : {Vec2{2, 1}, Vec2{1.5f, 0.5f}})
        for (const int rows : {8, 15, 16, 18, 20, 22, 24, 30})
            for (std::uint64_t start = 0; start < (house_starts + 1) / 2; ++start) {
                Random random(start);
                TestWorld world;
                world.add_ground();
                add_wall(world, rows, brick, 0.004f, random);
                for (int i = 0; i < (slow_build ? 60 : 2400) && world->report().awake_bodies + (i == 0) != 0; ++i) world.step();
                if (!slow_build) {
                    EXPECT_EQ(world->report().awake_bodies, 0u) << rows << " rows of bricks of " << brick.x << " m, start " << start;
                }
            }
}

struct House {
    int storeys;
    float card;  // m, its length; it is 0.04 of that thick
    float lean;  // degrees
    float friction;
};

// Storeys of pairs of cards that lean on each other, with cards across the pairs. By the balance of forces a card's feet need friction of tan(lean) / 2 if it bears
// nothing, and of tan(lean) if it bears far more than itself: 0.47 at 25 degrees, 0.58 at 30.
TEST(Structures, HousesOfCardsStand) {
    for (const House& h : {House{4, 1, 25, 0.6f}, House{4, 1, 25, 0.7f}, House{5, 1, 25, 0.7f}, House{4, 1, 30, 0.7f}, House{4, 0.5f, 25, 0.7f}, House{4, 2, 25, 0.7f},
                           House{3, 0.5f, 20, 0.7f}, House{4, 5, 20, 0.7f}})
        for (std::uint64_t start = 0; start < house_starts; ++start) {
            Random random(start);
            TestWorld world;
            world.add_ground(0, 60, rough(h.friction));
            const float angle = h.lean * pi / 180, half = 0.5f * h.card, thick = 0.02f * h.card;
            const Rot lean = make_rot(angle);
            const float storey = 2 * half * lean.c + 2 * thick * lean.s, pair = 2 * half * lean.s + 2 * thick * lean.c;
            std::vector<BodyId> cards;
            std::vector<float> heights;
            float floor = 0;
            const auto add = [&](Vec2 at, Vec2 halves, float turn) {
                cards.push_back(world.add(make_box(halves.x, halves.y), dynamic_at(at, turn), rough(h.friction)));
                heights.push_back(at.y);
            };
            for (int pairs = h.storeys; pairs >= 1; --pairs) {
                for (int i = 0; i < pairs; ++i) {
                    const float x = (2 * static_cast<float>(i) - static_cast<float>(pairs - 1)) * pair + random.between(-0.001f, 0.001f) * h.card;
                    for (const float side : {-1.0f, 1.0f}) add({x + side * 0.5f * pair, floor + 0.5f * storey}, {thick, half}, side * angle);
                }
                floor += storey;
                for (int i = 0; i < pairs - 1; ++i) add({(2 * static_cast<float>(i) - static_cast<float>(pairs - 2)) * pair, floor + thick}, {0.98f * pair, thick}, 0);
                if (pairs > 1) floor += 2 * thick;
            }
            world.step(slow_build ? 30 : 600);
            EXPECT_LT(farthest_sunk(world, cards, heights), 0.1f * h.card)
                << h.storeys << " storeys of cards of " << h.card << " m that lean by " << h.lean << " degrees, friction " << h.friction << ", start " << start;
        }
}

struct Arch {
    int stones;
    float radius, thickness;  // m, inner; share of the radius
};

// An arch stands from a thickness of 0.107 of its mean radius on (Heyman, "The safety of masonry arches", 1969); of these the thinnest has 0.122.
TEST(Structures, ThinArchesOfEverySizeStand) {
    for (const Arch& a : {Arch{31, 3, 0.15f}, Arch{21, 3, 0.13f}, Arch{21, 3, 0.15f}, Arch{21, 0.9f, 0.15f}, Arch{11, 0.3f, 0.15f}, Arch{21, 9, 0.15f}})
        for (std::uint64_t start = 0; start < house_starts; ++start) {
            Random random(start);
            TestWorld world;
            world.add_ground(0, 60, rough(0.8f));
            const std::vector<BodyId> arch = add_arch(world, a.stones, a.radius, a.thickness * a.radius, rough(0.8f), [&] {
                const float x = random.between(-0.001f, 0.001f);
                return a.radius / 3 * Vec2{x, random.between(0, 0.001f)};
            });
            std::vector<float> heights;
            for (const BodyId stone : arch) heights.push_back(world->center_of_mass(stone).y);
            world.step(slow_build ? 30 : 1200);
            EXPECT_LT(farthest_sunk(world, arch, heights), a.thickness * a.radius)
                << a.stones << " stones, inner radius " << a.radius << " m, thickness " << a.thickness << ", start " << start;
        }
}

}  // namespace
}  // namespace islet::test
