#include "../exact.hpp"

#include "../bodies/jam.hpp"

#include "../graph/contacts.hpp"
#include "../graph/joint_graph.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

namespace {

float inv_mass_of(const Core& core, std::uint32_t body) { return body != null_index ? core.poses[body].inv_mass : 0.0f; }

// Whether an impulse of the last substep, between two bodies, is that of a jam.
bool is_jammed(const Core& core, float impulse, std::uint32_t body_a, std::uint32_t body_b) {
    return impulse * max(inv_mass_of(core, body_a), inv_mass_of(core, body_b)) > jam_load * core.state->last_substep;
}

bool is_jammed(const Core& core, const Joint& j) { return is_jammed(core, abs(j.force_impulse.x) + abs(j.force_impulse.y), j.body_a, j.body_b); }

bool drives(const Core& core, std::uint32_t body) { return body != null_index && core.bodies[body].type() == BodyType::kinematic; }

void forget_from(Core& core, std::uint32_t body, Arena arena) {
    const auto words = static_cast<std::uint32_t>(words_for(core.capacity.bodies));
    const BitSet found{arena.take<std::uint64_t>(words), words};
    found.clear_all();
    std::uint32_t* queue = arena.take<std::uint32_t>(core.capacity.bodies);
    std::uint32_t end = 0;
    const auto reach = [&](std::uint32_t other) {
        if (other == null_index || !core.is_dynamic(other) || found.test(other)) return;
        found.set(other);
        queue[end++] = other;
    };
    found.set(body);
    queue[end++] = body;
    for (std::uint32_t at = 0; at < end; ++at) {
        for_each_contact(core, queue[at], [&](std::uint32_t contact, std::uint32_t side) {
            ContactManifold& m = core.manifolds[contact];
            if (!is_jammed(core, m.normal_impulse[0] + m.normal_impulse[1], m.body_a, m.body_b)) return;
            m.forget_impulses();
            reach(other_body(core, contact, side));
        });
        for_each_joint(core, queue[at], [&](std::uint32_t joint, std::uint32_t side) {
            Joint& j = core.joints[joint];
            if (!is_jammed(core, j)) return;
            j.forget_impulses();
            reach(other_joined(core, joint, side));
        });
    }
}

}  // namespace

void forget_jam(Core& core, std::uint32_t body) {
    if (drives(core, body)) forget_from(core, body, core.arena());
}

void forget_jam_of_joint(Core& core, std::uint32_t joint) {
    const Joint& j = core.joints[joint];
    if (!(drives(core, j.body_a) || drives(core, j.body_b)) || !is_jammed(core, j)) return;
    for (const std::uint32_t body : {j.body_a, j.body_b})
        if (body != null_index && core.is_dynamic(body)) forget_from(core, body, core.arena());
}

}  // namespace islet::detail
