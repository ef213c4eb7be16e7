// Who is in an island: a flood fill over contacts and joints. Static and kinematic bodies end it, and are not in it.
#include "../exact.hpp"

#include "../export/island_problem.hpp"
#include "../graph/contacts.hpp"
#include "../graph/joint_graph.hpp"

namespace islet::detail {

namespace {

BitSet take_bits(Arena& arena, std::uint32_t bits) {
    const auto words = static_cast<std::uint32_t>(words_for(bits));
    const BitSet set{arena.take<std::uint64_t>(words), words};
    set.clear_all();
    return set;
}

}  // namespace

IslandMembers find_island(const Core& core, std::uint32_t body, Arena& arena) {
    const State& state = *core.state;
    IslandMembers m;
    m.contacts = take_bits(arena, state.contact_pool.high_water);
    m.joints = take_bits(arena, state.joint_pool.high_water);
    m.bodies = arena.take<std::uint32_t>(state.body_pool.high_water);
    m.place_of = arena.take<std::uint32_t>(state.body_pool.high_water);
    Arena temporary = arena;
    const BitSet reached = take_bits(temporary, state.body_pool.high_water);

    // Each body enters the queue once, when it is reached.
    std::uint32_t end = 0;
    const auto reach = [&](std::uint32_t other) {
        if (other == null_index || !(core.poses[other].inv_mass > 0) || reached.test(other)) return;
        reached.set(other);
        m.bodies[end++] = other;
    };
    reach(body);
    for (std::uint32_t at = 0; at < end; ++at) {
        for_each_contact(core, m.bodies[at], [&](std::uint32_t contact, std::uint32_t side) {
            if ((core.manifolds[contact].flags & contact_touching) == 0) return;
            m.contacts.set(contact);
            reach(other_body(core, contact, side));
        });
        // A gear stands in the lists of the bodies it hangs on, and its two joints hold together what else its row reads.
        for_each_joint(core, m.bodies[at], [&](std::uint32_t joint, std::uint32_t side) {
            if (is_joint_idle(core, core.joints[joint])) return;
            m.joints.set(joint);
            reach(other_joined(core, joint, side));
        });
    }

    // In ascending order, so that nothing depends on where it began.
    reached.for_each([&](std::uint32_t i) {
        m.place_of[i] = m.body_count;
        m.bodies[m.body_count++] = i;
    });
    m.constraint_count = m.contacts.count() + m.joints.count();
    return m;
}

}  // namespace islet::detail
