// Hooks by number: they answer by the ids of what they are asked about, so that worlds with equal ids have equal futures; and sometimes with what is
// no number. Their text is there too, for programs that print a program.
#pragma once

#include "islet/islet.hpp"

namespace islet::test {

#define ISLET_HOOK_MENU(...) \
    __VA_ARGS__ \
    inline constexpr char hook_menu_text[] = #__VA_ARGS__;

// clang-format off
ISLET_HOOK_MENU(
inline Hooks hooks_of(std::uint32_t n) {
    Hooks h;
    if (n % 2 == 0) return h;
    switch (n / 2 % 4) {
        case 1: h.filter = [](ShapeId a, ShapeId b, void*) { return (a.index1 * 7 + b.index1) % 5 != 0; }; break;
        case 2: h.filter = [](ShapeId a, ShapeId b, void*) { return (a.index1 + b.index1) % 2 != 0; }; break;
        default: break;
    }
    switch (n / 8 % 4) {
        case 1: h.pre_solve = [](PreSolve& p, void*) {
            p.enabled = (p.contact.shape_a.index1 + p.contact.shape_b.index1) % 4 != 0;
            p.friction = 0.25f * float(p.contact.shape_a.index1 % 8);
            p.tangent_speed = float(p.contact.shape_b.index1 % 3);
        }; break;
        case 2: h.pre_solve = [](PreSolve& p, void*) { p.tangent_speed = p.contact.shape_b.index1 % 2 == 0 ? -3.5f : 0; }; break;
        case 3: h.pre_solve = [](PreSolve& p, void*) { p.enabled = p.contact.normal.y > 0.1f; p.friction = 1e9f; }; break;
        default: break;
    }
    switch (n / 32 % 4) {
        case 1: h.mix_friction = [](float a, std::uint32_t, float b, std::uint32_t material, void*) { return material % 4 == 3 ? __builtin_nanf("") : a * b; }; break;
        case 2: h.mix_friction = [](float, std::uint32_t, float, std::uint32_t, void*) { return 0.0f; }; break;
        default: break;
    }
    switch (n / 128 % 4) {
        case 1: h.mix_restitution = [](float a, std::uint32_t material, float b, std::uint32_t, void*) { return material % 4 == 3 ? 1e30f : a + b; }; break;
        case 2: h.mix_restitution = [](float, std::uint32_t, float, std::uint32_t, void*) { return 0.0f; }; break;
        case 3: h.mix_restitution = [](float, std::uint32_t, float, std::uint32_t, void*) { return 0.75f; }; break;
        default: break;
    }
    return h;
}
)
// clang-format on
#undef ISLET_HOOK_MENU

}  // namespace islet::test
