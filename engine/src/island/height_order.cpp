#include "../exact.hpp"

#include "../island/height_order.hpp"

#include "../constraint/solver_body.hpp"

#include "../math/key_sort.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

namespace {

constexpr float most_lightness = 1.0e4f;
constexpr float least_level = 0.5f;  // the least part of a contact's normal against gravity with which one body lies on the other

ISLET_NEVER_INLINE void sort_by_height(PlannedConstraint* contacts, std::uint32_t count) {
    sort_by_gaps(contacts, count,
                 [](const PlannedConstraint& a, const PlannedConstraint& b) { return a.height != b.height ? a.height < b.height : a.index < b.index; });
}

// From the lowest along `up`.
ISLET_NEVER_INLINE void sort_along(const Core& core, Vec2 up, PlannedConstraint* contacts, std::uint32_t count) {
    for (std::uint32_t k = 0; k < count; ++k) {
        const ContactManifold& m = core.manifolds[contacts[k].index];
        contacts[k].height = sort_key(dot(up, core.poses[m.body_a].center + m.anchors[0]));
    }
    sort_by_height(contacts, count);
}

/// Which body of a contact lies on the other.
struct Support {
    std::uint32_t below, above;
    float level;  // part of the normal against gravity, 0 to 1
};

Support support_of(const ContactManifold& m, Vec2 up) {
    const float level = dot(up, m.normal);
    return level > 0 ? Support{m.body_a, m.body_b, level} : Support{m.body_b, m.body_a, -level};
}

// N s in a substep: what a body passes on to those below it.
struct Load {
    float real, taken;  // as it is, and as the solve takes it

    float factor() const {
        const float f = real / taken;
        return f >= 1 && f <= most_lightness ? f : 1;
    }
};

enum class Impulses { real, taken };

// Works out the loads of all bodies from the impulses of the contacts, from the highest contact to the lowest.
const Load* weigh_loads(const Core& core, Vec2 up, const PlannedConstraint* contacts, std::uint32_t count, const float* lightness, Impulses impulses,
                        Arena& temporary) {
    const std::uint32_t bodies = core.state->body_pool.high_water;
    Load* const loads = temporary.take<Load>(bodies);
    const float fall = length(core.state->gravity) * core.state->last_substep;
    for (std::uint32_t i = 0; i < bodies; ++i) {
        const float weight = is_positive(core.poses[i].inv_mass) ? fall / core.poses[i].inv_mass : 0;
        loads[i] = {weight, weight / lightness[i]};
    }
    for (std::uint32_t k = count; k-- > 0;) {
        const ContactManifold& m = core.manifolds[contacts[k].index];
        const Support s = support_of(m, up);
        if (s.level < least_level) continue;
        const float passed = s.level * (m.normal_impulse[0] + m.normal_impulse[1]), factor = loads[s.above].factor();
        loads[s.below].real += impulses == Impulses::real ? passed : passed * factor;
        loads[s.below].taken += impulses == Impulses::taken ? passed : passed / factor;
    }
    return loads;
}

// Turns the impulses of contacts, sorted by height, into those of the lighter bodies, or back. They differ as the load does that the contact passes on, and as
// its lighter body does at least. (With less, a contact that turns to the side would throw up what is light.)
ISLET_NEVER_INLINE void turn_impulses(const Core& core, const PlannedConstraint* contacts, std::uint32_t count, const float* lightness, Impulses from,
                                      Arena temporary) {
    const Vec2 up = up_of(*core.state);
    const Load* const loads = weigh_loads(core, up, contacts, count, lightness, from, temporary);
    for (std::uint32_t k = 0; k < count; ++k) {
        ContactManifold& m = core.manifolds[contacts[k].index];
        const Support s = support_of(m, up);
        float factor = max(lightness[m.body_a], lightness[m.body_b]);
        if (s.level >= least_level) factor = max(factor, loads[s.above].factor());
        if (from == Impulses::real) factor = 1 / factor;
        for (float* impulse : {m.normal_impulse, m.normal_impulse + 1, m.tangent_impulse, m.tangent_impulse + 1, &m.load}) {
            *impulse *= factor;
            if (!(abs(*impulse) < unsound_impulse)) *impulse = 0;  // of a point that is not there, which no kernel forgets: an image may hold any number
        }
    }
}

}  // namespace

void put_in_order(const Core& core, PlannedConstraint* contacts, std::uint32_t count) {
    const auto order = static_cast<SweepOrder>(core.state->solver.sweep_order);
    if (order != SweepOrder::as_found) sort_along(core, order == SweepOrder::upward ? up_of(*core.state) : -up_of(*core.state), contacts, count);
    for (std::uint32_t k = 0; k < count; ++k) contacts[k].color = no_color;
}

void lighten_by_height(const Core& core, PlannedConstraint* contacts, std::uint32_t count, float* lightness, Arena temporary) {
    const Vec2 up = up_of(*core.state);
    const float mobility = 1 - core.state->solver.shock;
    for (std::uint32_t i = 0; i < core.state->body_pool.high_water; ++i) lightness[i] = 1;
    sort_along(core, up, contacts, count);
    for (std::uint32_t k = 0; k < count; ++k) {
        const Support s = support_of(core.manifolds[contacts[k].index], up);
        if (s.level < least_level || !is_positive(core.poses[s.below].inv_mass)) continue;
        const float below = lightness[s.below];
        lightness[s.above] = max(lightness[s.above], below < most_lightness * mobility ? below / mobility : most_lightness);
    }
    turn_impulses(core, contacts, count, lightness, Impulses::real, temporary);
    for (std::uint32_t k = 0; k < count; ++k) contacts[k].height = 0;  // by slot
    sort_by_height(contacts, count);
}

void restore_impulses(const Core& core, const float* lightness, Arena temporary) {
    PlannedConstraint* const contacts = temporary.take<PlannedConstraint>(core.state->contact_pool.count);
    std::uint32_t count = 0;
    core.awake_contacts.for_each([&](std::uint32_t i) {
        if ((core.manifolds[i].flags & contact_touching) != 0) contacts[count++].index = i;
    });
    sort_along(core, up_of(*core.state), contacts, count);
    turn_impulses(core, contacts, count, lightness, Impulses::taken, temporary);
}

}  // namespace islet::detail
