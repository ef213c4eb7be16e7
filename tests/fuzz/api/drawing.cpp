// The world handed to functions that draw.
#include <cstring>

#include "player.hpp"

namespace islet::fuzz {

void Player::draw() {
    DebugDraw d;
    static unsigned long drawn;
    d.polygon = [](std::span<const Vec2> corners, float, const DrawStyle&, void*) { drawn += corners.size(); };
    d.circle = [](Vec2, float, Vec2, const DrawStyle&, void*) { ++drawn; };
    d.capsule = [](Vec2, Vec2, float, const DrawStyle&, void*) { ++drawn; };
    d.segment = [](Vec2, Vec2, const DrawStyle&, void*) { ++drawn; };
    d.point = [](Vec2, const DrawStyle&, void*) { ++drawn; };
    d.text = [](Vec2, const char* words, const DrawStyle&, void*) { drawn += std::strlen(words); };
    const std::uint32_t without = in.byte();  // functions left null are skipped
    if ((without & 1) != 0) d.polygon = nullptr;
    if ((without & 2) != 0) d.circle = nullptr;
    if ((without & 4) != 0) d.capsule = nullptr;
    if ((without & 8) != 0) d.segment = nullptr;
    if ((without & 16) != 0) d.point = nullptr;
    if ((without & 32) != 0) d.text = nullptr;
    const std::uint32_t more = in.byte();
    d.contacts = d.normals = d.impulses = (more & 1) != 0;
    d.boxes = d.fat_boxes = d.tree = (more & 2) != 0;
    d.centers = d.names = (more & 4) != 0;
    d.body_colors = (more & 8) != 0 ? BodyColors::island : BodyColors::state;
    d.constraint_colors = (more & 16) != 0;
    if ((more & 32) != 0) {
        const Vec2 lower = in.point();
        d.view = {lower, in.point()};
    }
    if ((more & 64) != 0) d.size = in.number();
    if ((more & 128) != 0) d.impulse_scale = in.number();
    w.draw(d);

    const Vec2 at = in.point();
    const Transform pose = {at, make_rot(in.number())};
    const DrawStyle style = {.color = distinct_color(in.byte())};
    w.draw_shape(d, shape(), pose, style);
    switch (in.below(4)) {
    case 0: draw_shape(d, circle(), pose, style); break;
    case 1: draw_shape(d, capsule(), pose, style); break;
    case 2: draw_shape(d, segment(), pose, style); break;
    default: draw_shape(d, polygon(), pose, style);
    }
}

}  // namespace islet::fuzz
