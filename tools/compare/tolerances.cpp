#include "judge.hpp"

namespace islet::compare {

const std::vector<Tolerance>& tolerances() {
    static const std::vector<Tolerance> list = {
        {.scene = "hello", .steps = 180}, {.scene = "projectile", .steps = 90}, {.scene = "bounce", .steps = 150, .horizon = 90},
        {.scene = "friction_ramp", .steps = 180}, {.scene = "rolling", .steps = 120}, {.scene = "newtons_cradle", .steps = 130},
        {.scene = "far_from_origin", .steps = 600},
        {.scene = "pyramid", .steps = 600},
        {.scene = "vertical_stack", .steps = 600},
        {.scene = "dominoes", .steps = 600, .horizon = 100},
        {.scene = "card_house", .steps = 600},
        {.scene = "arch", .steps = 600},
        {.scene = "mass_ratio", .steps = 600},
        {.scene = "confined", .steps = 900},
        {.scene = "cairn", .steps = 600},
    };
    return list;
}

}  // namespace islet::compare
