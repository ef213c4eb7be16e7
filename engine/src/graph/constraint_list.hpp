// Lists of constraints: each body heads a doubly linked list of its contacts, and one of its joints.
//
// A list holds keys, constraint * 2 + side + 1; 0 ends it. A constraint is in the list of the body at each of its two sides, and leaves both lists in O(1).
// Constraint needs `Key`, and of that type `next[2]` and `prev[2]`.
#pragma once

#include <cstdint>

namespace islet::detail {

inline std::uint32_t constraint_of_key(std::uint32_t key) { return (key - 1) >> 1; }
inline std::uint32_t side_of_key(std::uint32_t key) { return (key - 1) & 1u; }

/// Calls visit(constraint, side) for each constraint from `head` on, newest first; `visit` may remove that constraint.
template <class Constraint, class Visit>
void for_each_constraint(const Constraint* constraints, std::uint32_t head, Visit&& visit) {
    for (std::uint32_t key = head; key != 0;) {
        const std::uint32_t constraint = constraint_of_key(key);
        const std::uint32_t side = side_of_key(key);
        key = constraints[constraint].next[side];
        visit(constraint, side);
    }
}

/// Puts one side of a constraint at the head of a list.
template <class Constraint>
void add_to_list(Constraint* constraints, std::uint32_t constraint, std::uint32_t side, std::uint32_t& head, std::uint32_t& count) {
    const std::uint32_t key = constraint * 2 + side + 1;
    constraints[constraint].prev[side] = 0;
    constraints[constraint].next[side] = static_cast<typename Constraint::Key>(head);
    if (head != 0) constraints[constraint_of_key(head)].prev[side_of_key(head)] = static_cast<typename Constraint::Key>(key);
    head = key;
    ++count;
}

template <class Constraint>
void remove_from_list(Constraint* constraints, std::uint32_t constraint, std::uint32_t side, std::uint32_t& head, std::uint32_t& count) {
    const std::uint32_t prev = constraints[constraint].prev[side];
    const std::uint32_t next = constraints[constraint].next[side];
    if (prev != 0) {
        constraints[constraint_of_key(prev)].next[side_of_key(prev)] = static_cast<typename Constraint::Key>(next);
    } else {
        head = next;
    }
    if (next != 0) constraints[constraint_of_key(next)].prev[side_of_key(next)] = static_cast<typename Constraint::Key>(prev);
    --count;
}

}  // namespace islet::detail
