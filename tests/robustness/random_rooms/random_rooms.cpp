// Throws random polygons into random rooms, and counts those that get out or stay deep in a wall for long.
//
//     islet_random_rooms [--rooms N] [--seed S] [--ground NAME] [--corners N] [--print]
//
// Each room has a seed of its own, S, S + 1 and so on, and is the same with every compiler. NAME is crossing (eight polygons between four walls of 2 cm that
// cross at their ends; unless told otherwise), rooms, ramps, grooves, stairs or gears (six polygons each; of gears one turns). The polygons have N corners, or
// 3 to 8 in turn. --print names the rooms that count. Exit status 0: none; 1: some; 2: wrong usage.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "support/polygon_sites.hpp"

using namespace islet;
using namespace islet::test;

namespace {

constexpr const char* names[] = {"rooms", "ramps", "grooves", "stairs", "gears", "crossing"};
constexpr int crossing = 5;
constexpr int longest_deep = 10;  // steps

int wrong_usage() {
    std::fprintf(stderr, "usage: islet_random_rooms [--rooms N] [--seed S] [--ground crossing|rooms|ramps|grooves|stairs|gears] [--corners N] [--print]\n");
    return 2;
}

struct Result {
    int outside = 0;       // bodies
    bool is_deep = false;  // an overlap of more than 1 cm for longer than ten steps, at less than 1 m/s
    double deepest = 0;    // m, in the steps looked at
};

Result try_room(int ground, std::uint32_t corners, std::uint64_t seed) {
    Random random(seed);
    Site site(random.between(0, ground == crossing ? 0.6f : 0.4f));
    Vec2 lower = {-2, 4.2f}, upper = {2, 6};
    if (ground == crossing) {
        build_crossing_walls(site, random);
        lower = {-1.4f, -0.9f};
        upper = {1.4f, 0.9f};
    } else {
        build(site, static_cast<Ground>(ground), random);
    }
    const int bodies = ground == crossing ? 8 : 6;
    const float speed = ground == crossing ? 5 : 3;
    for (int i = 0; i < bodies; ++i) {
        const Polygon polygon = random_polygon(random, corners);
        site.throw_in(polygon, random_throw(random, lower, upper, speed));
    }
    // Most of the time lies behind when it is looked at; what is wedged stays so.
    site.world.step(ground == crossing ? 300 : 400);
    site.run(40);
    Result result;
    for (const Site::Piece& p : site.thrown) {
        const Vec2 at = site.world->center_of_mass(p.body);
        const bool in = ground == crossing ? std::fabs(at.x) < 2 && std::fabs(at.y) < 1.5f : std::fabs(at.x) < 3 && at.y > 0;
        if (!in) ++result.outside;
    }
    result.is_deep = site.longest_deep > longest_deep;
    result.deepest = site.deepest;
    return result;
}

}  // namespace

int main(int argc, char** argv) {
    std::uint64_t rooms = 1000, seed = 1;
    std::uint32_t corners = 0;
    int ground = crossing;
    bool prints = false;
    for (int i = 1; i < argc; ++i) {
        const std::string option = argv[i];
        if (option == "--print") {
            prints = true;
            continue;
        }
        if (i + 1 >= argc) return wrong_usage();
        const char* value = argv[++i];
        if (option == "--rooms") {
            rooms = std::strtoull(value, nullptr, 10);
        } else if (option == "--seed") {
            seed = std::strtoull(value, nullptr, 10);
        } else if (option == "--corners") {
            corners = static_cast<std::uint32_t>(std::atoi(value));
            if (corners < 3 || corners > 8) return wrong_usage();
        } else if (option == "--ground") {
            ground = 0;
            while (ground <= crossing && std::strcmp(value, names[ground]) != 0) ++ground;
            if (ground > crossing) return wrong_usage();
        } else {
            return wrong_usage();
        }
    }
    if (rooms == 0) return wrong_usage();

    unsigned long long outside = 0, deep = 0, leaking = 0;
    double deepest = 0;
    for (std::uint64_t i = 0; i < rooms; ++i) {
        const std::uint32_t count = corners != 0 ? corners : 3 + static_cast<std::uint32_t>((seed + i) % 6);
        const Result result = try_room(ground, count, seed + i);
        outside += static_cast<unsigned long long>(result.outside);
        leaking += result.outside != 0 ? 1 : 0;
        deep += result.is_deep ? 1 : 0;
        deepest = std::fmax(deepest, result.deepest);
        if (prints && (result.outside != 0 || result.is_deep))
            std::printf("seed %llu, %u corners: %d outside, %s%.4f m at most\n", static_cast<unsigned long long>(seed + i), count, result.outside,
                        result.is_deep ? "deep for long, " : "", result.deepest);
    }
    std::printf("%llu sites of %s: %llu bodies outside in %llu of them, %llu with an overlap of more than 1 cm for longer than %d steps, %.4f m at most\n",
                static_cast<unsigned long long>(rooms), names[ground], outside, leaking, deep, longest_deep, deepest);
    return outside == 0 && deep == 0 ? 0 : 1;
}
