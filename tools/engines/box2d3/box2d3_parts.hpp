// From a scene's shapes and joints to Box2D 3's.
#pragma once

#include <string>

#include <box2d/box2d.h>

#include "harness/scene.hpp"

namespace islet::engines {

inline b2Vec2 to_b2(Vec2 v) { return {v.x, v.y}; }
inline Vec2 from_b2(b2Vec2 v) { return {v.x, v.y}; }
/// A position, which has doubles in some builds of Box2D.
inline b2Pos to_b2_place(Vec2 v) {
    b2Pos place;
    place.x = v.x;
    place.y = v.y;
    return place;
}
inline Vec2 from_b2_place(b2Pos p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

/// Empty, or the first thing that Box2D 3 lacks to make the shape or the joint.
std::string box2d3_shape_lacks(const samples::SceneShape& shape);
std::string box2d3_joint_lacks(const samples::SceneJoint& joint);

void add_box2d3_shape(b2BodyId body, const samples::SceneShape& shape);
/// `a` of a mouse joint is a static body without shapes.
b2JointId make_box2d3_joint(b2WorldId world, b2BodyId a, b2BodyId b, const samples::JointDef& joint);
/// Passes a definition on to a joint of its kind.
void change_box2d3_joint(b2JointId id, const samples::JointDef& joint);
float box2d3_joint_position(b2JointId id);
float box2d3_joint_speed(b2JointId id);
float box2d3_motor_force(b2JointId id);

}  // namespace islet::engines
