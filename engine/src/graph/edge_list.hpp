// Lists of constraints: each body heads a doubly linked list of its contacts, and one of its joints.
//
// A list holds keys, constraint * 2 + side + 1; 0 ends it. A constraint is in the list of the body at each of its two sides, and leaves both lists in O(1).
// Constraint needs `next[2]` and `prev[2]`.
#pragma once

#include <cstdint>

namespace islet::detail {

inline std::uint32_t edge_of_key(std::uint32_t key) { return (key - 1) >> 1; }
inline std::uint32_t side_of_key(std::uint32_t key) { return (key - 1) & 1u; }

/// Calls visit(edge, side) for each edge from `head` on, newest first; `visit` may remove that edge.
template <class Edge, class Visit>
void for_each_edge(const Edge* edges, std::uint32_t head, Visit&& visit) {
    for (std::uint32_t key = head; key != 0;) {
        const std::uint32_t edge = edge_of_key(key);
        const std::uint32_t side = side_of_key(key);
        key = edges[edge].next[side];
        visit(edge, side);
    }
}

/// Puts one side of an edge at the head of a list.
template <class Edge>
void link_edge(Edge* edges, std::uint32_t edge, std::uint32_t side, std::uint32_t& head, std::uint32_t& count) {
    const std::uint32_t key = edge * 2 + side + 1;
    edges[edge].prev[side] = 0;
    edges[edge].next[side] = head;
    if (head != 0) edges[edge_of_key(head)].prev[side_of_key(head)] = key;
    head = key;
    ++count;
}

template <class Edge>
void unlink_edge(Edge* edges, std::uint32_t edge, std::uint32_t side, std::uint32_t& head, std::uint32_t& count) {
    const std::uint32_t prev = edges[edge].prev[side];
    const std::uint32_t next = edges[edge].next[side];
    if (prev != 0) {
        edges[edge_of_key(prev)].next[side_of_key(prev)] = next;
    } else {
        head = next;
    }
    if (next != 0) edges[edge_of_key(next)].prev[side_of_key(next)] = prev;
    --count;
}

}  // namespace islet::detail
