// Random worlds to be asked, whose angles are half of them multiples of a quarter or nearly so (support/hard_shapes.hpp): every type of shape on static, kinematic, dynamic and sleeping bodies, sensors, disabled bodies, filters of all kinds, and
// holes where shapes were destroyed. And what notes down what a query tells its caller.
#pragma once

#include <vector>

#include "known.hpp"
#include "shapes.hpp"
#include "support/effort.hpp"
#include "support/hard_shapes.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace random_worlds {

using namespace islet;
using test::Known;
using test::TestWorld;

inline bool wanted(const Known& k, const QueryFilter& f) {
    return k.enabled && (!k.sensor || f.sensors) && (f.mask & k.filter.category) != 0 && (k.filter.mask & f.category) != 0;
}

inline ShapeDef random_def(exact::Random& r) {
    ShapeDef def;
    if (r.below(4) == 0) def.filter = {1u << r.below(3), r.below(8), 0};
    def.sensor = r.below(8) == 0;
    return def;
}

// Bodies of all types strewn about, some asleep, a few moved by hand; then some are destroyed, and time goes on.
inline void fill(TestWorld& w, exact::Random& r, int bodies, double reach) {
    const auto random_body = [&](BodyType type) {
        BodyDef def;
        def.type = type;
        def.position = {r.in(-reach, reach), r.in(-reach, reach)};
        def.angle = test::hard_angle(r);
        def.linear_velocity = {r.in(-3, 3), r.in(-3, 3)};
        def.angular_velocity = r.in(-2, 2);
        def.awake = r.below(3) != 0;
        def.enabled = r.below(10) != 0;
        return w->create_body(def);
    };
    for (int i = 0; i < bodies; ++i) {
        const BodyId body = random_body(static_cast<BodyType>(r.below(3)));
        const auto point = [&] { return Vec2{r.in(-2, 2), r.in(-2, 2)}; };
        for (std::uint32_t n = 1 + r.below(2); n > 0; --n) {
            const ShapeDef def = random_def(r);
            switch (r.below(6)) {
            case 0: w->create_shape(body, Circle{point(), r.in(0.1, 1)}, def); break;
            case 1: w->create_shape(body, Capsule{point(), point(), r.in(0.1, 1)}, def); break;
            case 2: w->create_shape(body, Segment{point(), point()}, def); break;
            case 3: w->create_shape(body, test::hard_polygon(r, 1.5), def); break;
            case 4: w->create_shape(body, test::hard_polygon(r, 1, r.in(0.05, 0.5)), def); break;
            default: {
                const Vec2 points[] = {{3, r.in(-1, 1)}, {1, r.in(-1, 1)}, {-1, r.in(-1, 1)}, {-3, r.in(-1, 1)}};
                w->create_chain(body, points, false, def);
            }
            }
        }
    }
    const auto all = w.bodies();
    for (std::size_t i = 0; i < all.size(); i += 9) w->destroy_body(all[i]);
    w.step(1 + static_cast<int>(r.below(4)));
    for (std::size_t i = 4; i < all.size(); i += 9) w->set_transform(all[i], {r.in(-reach, reach), r.in(-reach, reach)}, test::hard_angle(r));
    for (std::size_t i = 5; i < all.size(); i += 9) w->destroy_shape(w.shape_of(all[i]));
    w.errors.clear();
}

inline QueryFilter random_filter(exact::Random& r) {
    return r.below(2) == 0 ? QueryFilter{} : QueryFilter{.category = 1u << r.below(3), .mask = r.below(8), .sensors = r.below(2) == 0};
}

inline constexpr double size = 12;  // half of a world's width

template <class Test>
void in_random_worlds(int worlds, Test&& test) {
    exact::Random r;
    for (int i = 0; i < worlds; ++i) {
        TestWorld w;
        // Mostly resting or mostly awake ones, few or many.
        fill(w, r, 10 + static_cast<int>(r.below(50)), size);
        const std::vector<Known> known = known_shapes(w);
        test(r, w, known);
        if (testing::Test::HasFatalFailure()) return;
        ASSERT_TRUE(w.errors.empty());
    }
}

inline bool same(const QueryHit& a, const QueryHit& b) {
    return a.shape == b.shape && a.point == b.point && a.normal == b.normal && a.fraction == b.fraction && a.separation == b.separation;
}

// What a visitor notes, and how it answers.
struct Notes {
    std::vector<QueryHit> hits;
    std::size_t stop_after = ~std::size_t{0};
    enum Answer { go_on, ignore, cut } answer = go_on;
    static float visit(const QueryHit& hit, void* context) {
        Notes& notes = *static_cast<Notes*>(context);
        notes.hits.push_back(hit);
        if (notes.hits.size() == notes.stop_after) return 0;
        return notes.answer == go_on ? 1.0f : notes.answer == ignore ? -1.0f : hit.fraction;
    }
};

struct IdNotes {
    std::vector<ShapeId> ids;
    std::size_t stop_after = ~std::size_t{0};
    static bool visit(ShapeId id, void* context) {
        IdNotes& notes = *static_cast<IdNotes*>(context);
        notes.ids.push_back(id);
        return notes.ids.size() != notes.stop_after;
    }
};

}  // namespace random_worlds
