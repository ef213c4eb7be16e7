#include "cloth.hpp"

namespace islet::samples {
namespace {

/// Ties nodes that are some columns and rows apart, wherever both exist. `right` may be negative.
void tie(Assembler& into, const ClothDef& def, int right, int down, const JointSpring& spring) {
    DistanceJointDef tie;
    tie.length = def.spacing * length({static_cast<float>(right), static_cast<float>(down)});
    tie.spring = spring;
    const int columns = static_cast<int>(def.columns), rows = static_cast<int>(def.rows);
    for (int row = 0; row + down < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            if (column + right < 0 || column + right >= columns) continue;
            const int from = row * columns + column;
            into.joint(static_cast<std::size_t>(from), static_cast<std::size_t>(from + down * columns + right), tie);
        }
    }
}

}  // namespace

std::size_t cloth_node(const ClothDef& def, std::size_t column, std::size_t row) { return row * def.columns + column; }

std::size_t cloth_rods(const ClothDef& def) { return (def.columns - 1) * def.rows + def.columns * (def.rows - 1); }

void assemble(const ClothDef& def, Assembler& into) {
    BodyDef node;
    node.type = BodyType::dynamic;
    node.fixed_rotation = true;
    node.linear_damping = def.damping;
    ShapeDef thread;
    thread.density = def.weight * def.spacing * def.spacing / (pi * def.radius * def.radius);
    thread.filter.group = -def.group;
    for (std::size_t row = 0; row < def.rows; ++row) {
        for (std::size_t column = 0; column < def.columns; ++column) {
            node.position = def.corner + def.spacing * Vec2{static_cast<float>(column), -static_cast<float>(row)};
            into.body(node);
            into.shape(Circle{{}, def.radius}, thread);
        }
    }

    tie(into, def, 1, 0, {});
    tie(into, def, 0, 1, {});
    const JointSpring bending = {.enable = true, .hertz = def.bending_hertz, .damping_ratio = def.damping_ratio};
    const JointSpring shear = {.enable = true, .hertz = def.shear_hertz, .damping_ratio = def.damping_ratio};
    if (def.bending_hertz > 0) {
        tie(into, def, 2, 0, bending);
        tie(into, def, 0, 2, bending);
    }
    if (def.shear_hertz > 0) {
        tie(into, def, 1, 1, shear);
        tie(into, def, -1, 1, shear);
    }
}

}  // namespace islet::samples
