#include "../exact.hpp"

#include "../island/height_order.hpp"

#include "../island/heap_sort.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

namespace {

constexpr float most_lightness = 1.0e4f;
constexpr float least_level = 0.5f;  // the least part of a contact's normal against gravity with which one body lies on the other

void sort_by_height(PlannedConstraint* contacts, std::uint32_t count) {
    heap_sort(contacts, count,
              [](const PlannedConstraint& a, const PlannedConstraint& b) { return a.height != b.height ? a.height < b.height : a.index < b.index; });
}

// From the lowest along `up`.
void sort_along(const Core& core, Vec2 up, PlannedConstraint* contacts, std::uint32_t count) {
    for (std::uint32_t k = 0; k < count; ++k) {
        const ContactManifold& m = core.manifolds[contacts[k].index];
        contacts[k].height = sort_key(dot(up, core.poses[m.body_a].center + m.anchors[0]));
    }
    sort_by_height(contacts, count);
}

}  // namespace

void put_in_order(const Core& core, PlannedConstraint* contacts, std::uint32_t count) {
    const auto order = static_cast<SweepOrder>(core.state->solver.sweep_order);
    if (order != SweepOrder::as_found) sort_along(core, order == SweepOrder::upward ? up_of(core) : -up_of(core), contacts, count);
    for (std::uint32_t k = 0; k < count; ++k) contacts[k].color = no_color;
}

void lighten_by_height(const Core& core, PlannedConstraint* contacts, std::uint32_t count, float* lightness) {
    const Vec2 up = up_of(core);
    const float mobility = 1 - core.state->solver.shock;
    for (std::uint32_t i = 0; i < core.state->body_pool.high_water; ++i) lightness[i] = 1;
    sort_along(core, up, contacts, count);
    for (std::uint32_t k = 0; k < count; ++k) {
        const ContactManifold& m = core.manifolds[contacts[k].index];
        const float level = dot(up, m.normal);  // above 0: B lies on A
        const std::uint32_t below = level > 0 ? m.body_a : m.body_b, above = level > 0 ? m.body_b : m.body_a;
        if (abs(level) < least_level || core.poses[below].inv_mass == 0) continue;
        lightness[above] = max(lightness[above], lightness[below] < most_lightness * mobility ? lightness[below] / mobility : most_lightness);
    }
    for (std::uint32_t k = 0; k < count; ++k) contacts[k].height = 0;  // by slot
    sort_by_height(contacts, count);
    for (std::uint32_t k = 0; k < count; ++k) contacts[k].color = core.manifolds[contacts[k].index].color();
}

}  // namespace islet::detail
