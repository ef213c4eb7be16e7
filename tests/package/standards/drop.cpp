// A program in C++17, and in C++20 too: a crate falls on a chain of lines. Prints the world's hash. standard_test.sh compiles it.
#include <cstdio>
#include <type_traits>
#include <vector>

#include <islet/islet.hpp>

using namespace islet;

// What becomes a span, and what does not.
struct Point3 : Vec2 {
    float z = 0;
};
template <class From, class To>
constexpr bool becomes = std::is_convertible_v<From, To>;
static_assert(becomes<Vec2 (&)[3], span<const Vec2>> && becomes<Vec2 (&)[3], span<Vec2>> && becomes<std::vector<Vec2>&, span<Vec2>>);
static_assert(becomes<std::vector<Vec2>, span<const Vec2>> && becomes<const std::vector<Vec2>&, span<const Vec2>> && becomes<span<Vec2>, span<const Vec2>>);
static_assert(!becomes<span<const Vec2>, span<Vec2>> && !becomes<const std::vector<Vec2>&, span<Vec2>> && !becomes<const Vec2 (&)[3], span<Vec2>>);
static_assert(!becomes<Point3 (&)[3], span<const Vec2>> && !becomes<std::vector<Point3>&, span<const Vec2>> && !becomes<int, span<const Vec2>>);

static StaticWorldOf<8, 8, 24> storage;

int main() {
    WorldDef def;
    def.gravity = {0, -9.81f};
    World& world = storage.create(def);
    const std::vector<Vec2> points = {{6, 0}, {2, 0}, {-2, 0}, {-6, 0}};
    ShapeId made[3];
    if (world.create_chain(world.create_body({}), points, false, {}, made) != 3) return 1;
    BodyDef crate;
    crate.type = BodyType::dynamic;
    crate.position = {1, 4};
    crate.angle = 0.5f;
    const BodyId body = world.create_body(crate);
    world.create_shape(body, make_box(0.5f, 0.5f));
    std::size_t touches = 0;
    for (int i = 0; i < 120; ++i) {
        world.step(1.0f / 60);
        for (const TouchEvent& touch : world.begin_touch_events()) touches += touch.shape_a == made[1] || touch.shape_b == made[1];
    }
    // Spans of the engine's own, and parts of them.
    const Vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {9, 9}};
    const span all{corners};
    if (all.size() != 4 || all.first(3).back() != corners[2] || all.subspan(1).front() != corners[1] || all.subspan(1, 2).size() != 2 ||
        all.last(1)[0] != corners[3] || all.empty() || !span<Vec2>{}.empty() || compute_hull(all.first(3)).count != 3)
        return 1;
    if (touches == 0 || world.last_error() != Error::none) return 1;
    std::printf("%016llx\n", static_cast<unsigned long long>(world.hash()));
}
