// The contact update's kernels (graph/contact_lanes.hpp, graph/remake_lanes.hpp) for four lanes (kernel_scalar.cpp), and for eight (kernel_avx2.cpp). Only
// processors with AVX2 may call those.
#pragma once

#include "../graph/contact_lanes.hpp"
#include "../graph/remake_lanes.hpp"

namespace islet::detail {

KeptTouching keep_touching_4(const ContactsInLanes& in, const std::uint32_t* contact);
KeptTouching keep_touching_8(const ContactsInLanes& in, const std::uint32_t* contact);
void tell_apart_4(const ContactsInLanes& in, const std::uint32_t* contact, ToldApart& out);
void tell_apart_8(const ContactsInLanes& in, const std::uint32_t* contact, ToldApart& out);
void remake_4(const ContactsInLanes& in, PairKind kind, const LanePairs& pairs, Remade& out);
void remake_8(const ContactsInLanes& in, PairKind kind, const LanePairs& pairs, Remade& out);

}  // namespace islet::detail
