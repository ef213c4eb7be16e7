#include "../exact.hpp"

#include "../graph/hooks.hpp"

#include "../calls/checks.hpp"
#include "../graph/contacts.hpp"
#include "../graph/mixing.hpp"
#include "../math/scalar.hpp"

namespace islet {

using namespace detail;

namespace detail {

bool is_allowed_by_hook(const Core& core, std::uint32_t shape_1, std::uint32_t shape_2) {
    const std::uint32_t first = shape_1 < shape_2 ? shape_1 : shape_2;
    return core.hooks.filter(core.shape_id(first), core.shape_id(shape_1 + shape_2 - first), core.hooks.context);
}

bool stops_by_hook(const Core& core, std::uint32_t shape, std::uint32_t other) {
    const bool is_static = core.bodies[core.shapes[other].body].type() == BodyType::static_body;
    return is_static ? have_contact(core, shape, other) : is_allowed_by_hook(core, shape, other);
}

float friction_by_hook(const Core& core, const Shape& a, const Shape& b) {
    const Closed closed(core);
    const float mixed = core.hooks.mix_friction(a.friction, a.material, b.friction, b.material, core.hooks.context);
    return mixed >= 0 ? min(mixed, max_coefficient) : 0.0f;  // 0 for NaN too
}

float restitution_by_hook(const Core& core, const Shape& a, const Shape& b) {
    const Closed closed(core);
    const float mixed = core.hooks.mix_restitution(a.restitution, a.material, b.restitution, b.material, core.hooks.context);
    return has_restitution && mixed >= 0 ? min(mixed, 1.0f) : 0.0f;
}

void ask_pre_solve(Core& core, std::uint32_t index) {
    ContactManifold& m = core.manifolds[index];
    Contact& c = core.contacts[index];
    PreSolve asked;
    read_contact(core, index, asked.contact);
    asked.friction = m.friction;
    asked.tangent_speed = surface_of(core, index).tangent_speed;
    const PreSolve before = asked;
    core.hooks.pre_solve(asked, core.hooks.context);

    if (!asked.enabled) {
        m.forget_points();  // so that the hook is called again in the next step
        if ((m.flags & contact_one_way) != 0) m.flags |= contact_passes | contact_dropped;
        return m.forget_impulses();
    }
    if (asked.friction != before.friction && check_range(core, asked.friction, 0, max_coefficient)) m.friction = asked.friction;
    if (asked.tangent_speed == before.tangent_speed || !check_range(core, asked.tangent_speed, -max_speed_limit, max_speed_limit)) return;
    if (!check_there(core, has_surfaces)) return;
    c.set_own_speed(asked.tangent_speed);
    if ((m.flags & contact_special) == 0) m.rolling_impulse = 0;
    m.flags |= contact_special;
}

}  // namespace detail

Hooks World::hooks() const { return core().hooks; }

void World::set_hooks(const Hooks& hooks) {
    if (check_open(core()) && check_there(core(), are_there(hooks))) core().hooks = hooks;
}

}  // namespace islet
