// The functions of islet.h, and checks that its structs are those of C++.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

namespace islet::c {

static_assert(sizeof(ShapeType) == sizeof(IsletShapeType) && static_cast<int>(ShapeType::half_space) == ISLET_SHAPE_TYPE_HALF_SPACE);
static_assert(sizeof(DrawPart) == sizeof(IsletDrawPart) && static_cast<int>(DrawPart::name) == ISLET_DRAW_PART_NAME);
static_assert(sizeof(BodyColors) == sizeof(IsletBodyColors) && static_cast<int>(BodyColors::island) == ISLET_BODY_COLORS_ISLAND);
static_assert(sizeof(FormatKind) == sizeof(IsletFormatKind) && static_cast<int>(FormatKind::recording) == ISLET_FORMAT_KIND_RECORDING);
static_assert(sizeof(Error) == sizeof(IsletError) && static_cast<int>(Error::endless_shape) == ISLET_ERROR_ENDLESS_SHAPE);
static_assert(sizeof(Schedule) == sizeof(IsletSchedule) && static_cast<int>(Schedule::classic) == ISLET_SCHEDULE_CLASSIC);
static_assert(sizeof(JointTrees) == sizeof(IsletJointTrees) && static_cast<int>(JointTrees::all) == ISLET_JOINT_TREES_ALL);
static_assert(sizeof(SweepOrder) == sizeof(IsletSweepOrder) && static_cast<int>(SweepOrder::downward) == ISLET_SWEEP_ORDER_DOWNWARD);
static_assert(sizeof(BodyType) == sizeof(IsletBodyType) && static_cast<int>(BodyType::dynamic) == ISLET_BODY_TYPE_DYNAMIC);
static_assert(sizeof(RowKind) == sizeof(IsletRowKind) && static_cast<int>(RowKind::joint_friction) == ISLET_ROW_KIND_JOINT_FRICTION);
static_assert(sizeof(JointType) == sizeof(IsletJointType) && static_cast<int>(JointType::angle) == ISLET_JOINT_TYPE_ANGLE);
static_assert(sizeof(ReplayEnd) == sizeof(IsletReplayEnd) && static_cast<int>(ReplayEnd::refused) == ISLET_REPLAY_END_REFUSED);

static_assert(sizeof(IsletVec2) == sizeof(Vec2) && alignof(IsletVec2) == alignof(Vec2));
static_assert(offsetof(IsletVec2, x) == offsetof(Vec2, x) && sizeof(IsletVec2::x) == sizeof(Vec2::x));
static_assert(offsetof(IsletVec2, y) == offsetof(Vec2, y) && sizeof(IsletVec2::y) == sizeof(Vec2::y));
static_assert(sizeof(IsletRot) == sizeof(Rot) && alignof(IsletRot) == alignof(Rot));
static_assert(offsetof(IsletRot, c) == offsetof(Rot, c) && sizeof(IsletRot::c) == sizeof(Rot::c));
static_assert(offsetof(IsletRot, s) == offsetof(Rot, s) && sizeof(IsletRot::s) == sizeof(Rot::s));
static_assert(sizeof(IsletTransform) == sizeof(Transform) && alignof(IsletTransform) == alignof(Transform));
static_assert(offsetof(IsletTransform, p) == offsetof(Transform, p) && sizeof(IsletTransform::p) == sizeof(Transform::p));
static_assert(offsetof(IsletTransform, q) == offsetof(Transform, q) && sizeof(IsletTransform::q) == sizeof(Transform::q));
static_assert(sizeof(IsletAabb) == sizeof(Aabb) && alignof(IsletAabb) == alignof(Aabb));
static_assert(offsetof(IsletAabb, lower) == offsetof(Aabb, lower) && sizeof(IsletAabb::lower) == sizeof(Aabb::lower));
static_assert(offsetof(IsletAabb, upper) == offsetof(Aabb, upper) && sizeof(IsletAabb::upper) == sizeof(Aabb::upper));
static_assert(sizeof(IsletCircle) == sizeof(Circle) && alignof(IsletCircle) == alignof(Circle));
static_assert(offsetof(IsletCircle, center) == offsetof(Circle, center) && sizeof(IsletCircle::center) == sizeof(Circle::center));
static_assert(offsetof(IsletCircle, radius) == offsetof(Circle, radius) && sizeof(IsletCircle::radius) == sizeof(Circle::radius));
static_assert(sizeof(IsletCapsule) == sizeof(Capsule) && alignof(IsletCapsule) == alignof(Capsule));
static_assert(offsetof(IsletCapsule, point1) == offsetof(Capsule, point1) && sizeof(IsletCapsule::point1) == sizeof(Capsule::point1));
static_assert(offsetof(IsletCapsule, point2) == offsetof(Capsule, point2) && sizeof(IsletCapsule::point2) == sizeof(Capsule::point2));
static_assert(offsetof(IsletCapsule, radius) == offsetof(Capsule, radius) && sizeof(IsletCapsule::radius) == sizeof(Capsule::radius));
static_assert(sizeof(IsletSegment) == sizeof(Segment) && alignof(IsletSegment) == alignof(Segment));
static_assert(offsetof(IsletSegment, point1) == offsetof(Segment, point1) && sizeof(IsletSegment::point1) == sizeof(Segment::point1));
static_assert(offsetof(IsletSegment, point2) == offsetof(Segment, point2) && sizeof(IsletSegment::point2) == sizeof(Segment::point2));
static_assert(sizeof(IsletChainSegment) == sizeof(ChainSegment) && alignof(IsletChainSegment) == alignof(ChainSegment));
static_assert(offsetof(IsletChainSegment, ghost1) == offsetof(ChainSegment, ghost1) && sizeof(IsletChainSegment::ghost1) == sizeof(ChainSegment::ghost1));
static_assert(offsetof(IsletChainSegment, segment) == offsetof(ChainSegment, segment) && sizeof(IsletChainSegment::segment) == sizeof(ChainSegment::segment));
static_assert(offsetof(IsletChainSegment, ghost2) == offsetof(ChainSegment, ghost2) && sizeof(IsletChainSegment::ghost2) == sizeof(ChainSegment::ghost2));
static_assert(sizeof(IsletHalfSpace) == sizeof(HalfSpace) && alignof(IsletHalfSpace) == alignof(HalfSpace));
static_assert(offsetof(IsletHalfSpace, normal) == offsetof(HalfSpace, normal) && sizeof(IsletHalfSpace::normal) == sizeof(HalfSpace::normal));
static_assert(offsetof(IsletHalfSpace, offset) == offsetof(HalfSpace, offset) && sizeof(IsletHalfSpace::offset) == sizeof(HalfSpace::offset));
static_assert(sizeof(IsletHull) == sizeof(Hull) && alignof(IsletHull) == alignof(Hull));
static_assert(offsetof(IsletHull, points) == offsetof(Hull, points) && sizeof(IsletHull::points) == sizeof(Hull::points));
static_assert(offsetof(IsletHull, count) == offsetof(Hull, count) && sizeof(IsletHull::count) == sizeof(Hull::count));
static_assert(sizeof(IsletPolygon) == sizeof(Polygon) && alignof(IsletPolygon) == alignof(Polygon));
static_assert(offsetof(IsletPolygon, vertices) == offsetof(Polygon, vertices) && sizeof(IsletPolygon::vertices) == sizeof(Polygon::vertices));
static_assert(offsetof(IsletPolygon, normals) == offsetof(Polygon, normals) && sizeof(IsletPolygon::normals) == sizeof(Polygon::normals));
static_assert(offsetof(IsletPolygon, centroid) == offsetof(Polygon, centroid) && sizeof(IsletPolygon::centroid) == sizeof(Polygon::centroid));
static_assert(offsetof(IsletPolygon, radius) == offsetof(Polygon, radius) && sizeof(IsletPolygon::radius) == sizeof(Polygon::radius));
static_assert(offsetof(IsletPolygon, count) == offsetof(Polygon, count) && sizeof(IsletPolygon::count) == sizeof(Polygon::count));
static_assert(sizeof(IsletMassData) == sizeof(MassData) && alignof(IsletMassData) == alignof(MassData));
static_assert(offsetof(IsletMassData, mass) == offsetof(MassData, mass) && sizeof(IsletMassData::mass) == sizeof(MassData::mass));
static_assert(offsetof(IsletMassData, center) == offsetof(MassData, center) && sizeof(IsletMassData::center) == sizeof(MassData::center));
static_assert(offsetof(IsletMassData, inertia) == offsetof(MassData, inertia) && sizeof(IsletMassData::inertia) == sizeof(MassData::inertia));
static_assert(sizeof(IsletDrawStyle) == sizeof(DrawStyle) && alignof(IsletDrawStyle) == alignof(DrawStyle));
static_assert(offsetof(IsletDrawStyle, color) == offsetof(DrawStyle, color) && sizeof(IsletDrawStyle::color) == sizeof(DrawStyle::color));
static_assert(offsetof(IsletDrawStyle, part) == offsetof(DrawStyle, part) && sizeof(IsletDrawStyle::part) == sizeof(DrawStyle::part));
static_assert(offsetof(IsletDrawStyle, solid) == offsetof(DrawStyle, solid) && sizeof(IsletDrawStyle::solid) == sizeof(DrawStyle::solid));
static_assert(offsetof(IsletDrawStyle, slot) == offsetof(DrawStyle, slot) && sizeof(IsletDrawStyle::slot) == sizeof(DrawStyle::slot));
static_assert(sizeof(IsletDebugDraw) == sizeof(DebugDraw) + start_of<DebugDraw> && start_of<DebugDraw> == offsetof(IsletDebugDraw, polygon));
static_assert(offsetof(IsletDebugDraw, polygon) == offsetof(DebugDraw, polygon) + start_of<DebugDraw> && sizeof(IsletDebugDraw::polygon) == sizeof(DebugDraw::polygon));
static_assert(offsetof(IsletDebugDraw, circle) == offsetof(DebugDraw, circle) + start_of<DebugDraw> && sizeof(IsletDebugDraw::circle) == sizeof(DebugDraw::circle));
static_assert(offsetof(IsletDebugDraw, capsule) == offsetof(DebugDraw, capsule) + start_of<DebugDraw> && sizeof(IsletDebugDraw::capsule) == sizeof(DebugDraw::capsule));
static_assert(offsetof(IsletDebugDraw, segment) == offsetof(DebugDraw, segment) + start_of<DebugDraw> && sizeof(IsletDebugDraw::segment) == sizeof(DebugDraw::segment));
static_assert(offsetof(IsletDebugDraw, point) == offsetof(DebugDraw, point) + start_of<DebugDraw> && sizeof(IsletDebugDraw::point) == sizeof(DebugDraw::point));
static_assert(offsetof(IsletDebugDraw, text) == offsetof(DebugDraw, text) + start_of<DebugDraw> && sizeof(IsletDebugDraw::text) == sizeof(DebugDraw::text));
static_assert(offsetof(IsletDebugDraw, context) == offsetof(DebugDraw, context) + start_of<DebugDraw> && sizeof(IsletDebugDraw::context) == sizeof(DebugDraw::context));
static_assert(offsetof(IsletDebugDraw, view) == offsetof(DebugDraw, view) + start_of<DebugDraw> && sizeof(IsletDebugDraw::view) == sizeof(DebugDraw::view));
static_assert(offsetof(IsletDebugDraw, size) == offsetof(DebugDraw, size) + start_of<DebugDraw> && sizeof(IsletDebugDraw::size) == sizeof(DebugDraw::size));
static_assert(offsetof(IsletDebugDraw, impulse_scale) == offsetof(DebugDraw, impulse_scale) + start_of<DebugDraw> && sizeof(IsletDebugDraw::impulse_scale) == sizeof(DebugDraw::impulse_scale));
static_assert(offsetof(IsletDebugDraw, shapes) == offsetof(DebugDraw, shapes) + start_of<DebugDraw> && sizeof(IsletDebugDraw::shapes) == sizeof(DebugDraw::shapes));
static_assert(offsetof(IsletDebugDraw, joints) == offsetof(DebugDraw, joints) + start_of<DebugDraw> && sizeof(IsletDebugDraw::joints) == sizeof(DebugDraw::joints));
static_assert(offsetof(IsletDebugDraw, contacts) == offsetof(DebugDraw, contacts) + start_of<DebugDraw> && sizeof(IsletDebugDraw::contacts) == sizeof(DebugDraw::contacts));
static_assert(offsetof(IsletDebugDraw, normals) == offsetof(DebugDraw, normals) + start_of<DebugDraw> && sizeof(IsletDebugDraw::normals) == sizeof(DebugDraw::normals));
static_assert(offsetof(IsletDebugDraw, impulses) == offsetof(DebugDraw, impulses) + start_of<DebugDraw> && sizeof(IsletDebugDraw::impulses) == sizeof(DebugDraw::impulses));
static_assert(offsetof(IsletDebugDraw, boxes) == offsetof(DebugDraw, boxes) + start_of<DebugDraw> && sizeof(IsletDebugDraw::boxes) == sizeof(DebugDraw::boxes));
static_assert(offsetof(IsletDebugDraw, fat_boxes) == offsetof(DebugDraw, fat_boxes) + start_of<DebugDraw> && sizeof(IsletDebugDraw::fat_boxes) == sizeof(DebugDraw::fat_boxes));
static_assert(offsetof(IsletDebugDraw, tree) == offsetof(DebugDraw, tree) + start_of<DebugDraw> && sizeof(IsletDebugDraw::tree) == sizeof(DebugDraw::tree));
static_assert(offsetof(IsletDebugDraw, centers) == offsetof(DebugDraw, centers) + start_of<DebugDraw> && sizeof(IsletDebugDraw::centers) == sizeof(DebugDraw::centers));
static_assert(offsetof(IsletDebugDraw, names) == offsetof(DebugDraw, names) + start_of<DebugDraw> && sizeof(IsletDebugDraw::names) == sizeof(DebugDraw::names));
static_assert(offsetof(IsletDebugDraw, body_colors) == offsetof(DebugDraw, body_colors) + start_of<DebugDraw> && sizeof(IsletDebugDraw::body_colors) == sizeof(DebugDraw::body_colors));
static_assert(offsetof(IsletDebugDraw, constraint_colors) == offsetof(DebugDraw, constraint_colors) + start_of<DebugDraw> && sizeof(IsletDebugDraw::constraint_colors) == sizeof(DebugDraw::constraint_colors));
static_assert(sizeof(IsletFormatInfo) == sizeof(FormatInfo) + start_of<FormatInfo> && start_of<FormatInfo> == offsetof(IsletFormatInfo, kind));
static_assert(offsetof(IsletFormatInfo, kind) == offsetof(FormatInfo, kind) + start_of<FormatInfo> && sizeof(IsletFormatInfo::kind) == sizeof(FormatInfo::kind));
static_assert(offsetof(IsletFormatInfo, format) == offsetof(FormatInfo, format) + start_of<FormatInfo> && sizeof(IsletFormatInfo::format) == sizeof(FormatInfo::format));
static_assert(offsetof(IsletFormatInfo, readable) == offsetof(FormatInfo, readable) + start_of<FormatInfo> && sizeof(IsletFormatInfo::readable) == sizeof(FormatInfo::readable));
static_assert(offsetof(IsletFormatInfo, in_recording) == offsetof(FormatInfo, in_recording) + start_of<FormatInfo> && sizeof(IsletFormatInfo::in_recording) == sizeof(FormatInfo::in_recording));
static_assert(offsetof(IsletFormatInfo, other_byte_order) == offsetof(FormatInfo, other_byte_order) + start_of<FormatInfo> && sizeof(IsletFormatInfo::other_byte_order) == sizeof(FormatInfo::other_byte_order));
static_assert(sizeof(IsletTaskSystem) == sizeof(TaskSystem) + start_of<TaskSystem> && start_of<TaskSystem> == offsetof(IsletTaskSystem, parallel_for));
static_assert(offsetof(IsletTaskSystem, parallel_for) == offsetof(TaskSystem, parallel_for) + start_of<TaskSystem> && sizeof(IsletTaskSystem::parallel_for) == sizeof(TaskSystem::parallel_for));
static_assert(offsetof(IsletTaskSystem, context) == offsetof(TaskSystem, context) + start_of<TaskSystem> && sizeof(IsletTaskSystem::context) == sizeof(TaskSystem::context));
static_assert(offsetof(IsletTaskSystem, workers) == offsetof(TaskSystem, workers) + start_of<TaskSystem> && sizeof(IsletTaskSystem::workers) == sizeof(TaskSystem::workers));
static_assert(sizeof(IsletBodyId) == sizeof(BodyId) && alignof(IsletBodyId) == alignof(BodyId));
static_assert(offsetof(IsletBodyId, index1) == offsetof(BodyId, index1) && sizeof(IsletBodyId::index1) == sizeof(BodyId::index1));
static_assert(offsetof(IsletBodyId, generation) == offsetof(BodyId, generation) && sizeof(IsletBodyId::generation) == sizeof(BodyId::generation));
static_assert(sizeof(IsletShapeId) == sizeof(ShapeId) && alignof(IsletShapeId) == alignof(ShapeId));
static_assert(offsetof(IsletShapeId, index1) == offsetof(ShapeId, index1) && sizeof(IsletShapeId::index1) == sizeof(ShapeId::index1));
static_assert(offsetof(IsletShapeId, generation) == offsetof(ShapeId, generation) && sizeof(IsletShapeId::generation) == sizeof(ShapeId::generation));
static_assert(sizeof(IsletCapacity) == sizeof(Capacity) + start_of<Capacity> && start_of<Capacity> == offsetof(IsletCapacity, bodies));
static_assert(offsetof(IsletCapacity, bodies) == offsetof(Capacity, bodies) + start_of<Capacity> && sizeof(IsletCapacity::bodies) == sizeof(Capacity::bodies));
static_assert(offsetof(IsletCapacity, shapes) == offsetof(Capacity, shapes) + start_of<Capacity> && sizeof(IsletCapacity::shapes) == sizeof(Capacity::shapes));
static_assert(offsetof(IsletCapacity, contacts) == offsetof(Capacity, contacts) + start_of<Capacity> && sizeof(IsletCapacity::contacts) == sizeof(Capacity::contacts));
static_assert(offsetof(IsletCapacity, joints) == offsetof(Capacity, joints) + start_of<Capacity> && sizeof(IsletCapacity::joints) == sizeof(Capacity::joints));
static_assert(offsetof(IsletCapacity, geometries) == offsetof(Capacity, geometries) + start_of<Capacity> && sizeof(IsletCapacity::geometries) == sizeof(Capacity::geometries));
static_assert(offsetof(IsletCapacity, hits) == offsetof(Capacity, hits) + start_of<Capacity> && sizeof(IsletCapacity::hits) == sizeof(Capacity::hits));
static_assert(sizeof(IsletHooks) == sizeof(Hooks) + start_of<Hooks> && start_of<Hooks> == offsetof(IsletHooks, filter));
static_assert(offsetof(IsletHooks, filter) == offsetof(Hooks, filter) + start_of<Hooks> && sizeof(IsletHooks::filter) == sizeof(Hooks::filter));
static_assert(offsetof(IsletHooks, pre_solve) == offsetof(Hooks, pre_solve) + start_of<Hooks> && sizeof(IsletHooks::pre_solve) == sizeof(Hooks::pre_solve));
static_assert(offsetof(IsletHooks, mix_friction) == offsetof(Hooks, mix_friction) + start_of<Hooks> && sizeof(IsletHooks::mix_friction) == sizeof(Hooks::mix_friction));
static_assert(offsetof(IsletHooks, mix_restitution) == offsetof(Hooks, mix_restitution) + start_of<Hooks> && sizeof(IsletHooks::mix_restitution) == sizeof(Hooks::mix_restitution));
static_assert(offsetof(IsletHooks, context) == offsetof(Hooks, context) + start_of<Hooks> && sizeof(IsletHooks::context) == sizeof(Hooks::context));
static_assert(sizeof(IsletSolverDef) == sizeof(SolverDef) + start_of<SolverDef> && start_of<SolverDef> == offsetof(IsletSolverDef, schedule));
static_assert(offsetof(IsletSolverDef, schedule) == offsetof(SolverDef, schedule) + start_of<SolverDef> && sizeof(IsletSolverDef::schedule) == sizeof(SolverDef::schedule));
static_assert(offsetof(IsletSolverDef, substeps) == offsetof(SolverDef, substeps) + start_of<SolverDef> && sizeof(IsletSolverDef::substeps) == sizeof(SolverDef::substeps));
static_assert(offsetof(IsletSolverDef, iterations) == offsetof(SolverDef, iterations) + start_of<SolverDef> && sizeof(IsletSolverDef::iterations) == sizeof(SolverDef::iterations));
static_assert(offsetof(IsletSolverDef, relax_iterations) == offsetof(SolverDef, relax_iterations) + start_of<SolverDef> && sizeof(IsletSolverDef::relax_iterations) == sizeof(SolverDef::relax_iterations));
static_assert(offsetof(IsletSolverDef, contact_hertz) == offsetof(SolverDef, contact_hertz) + start_of<SolverDef> && sizeof(IsletSolverDef::contact_hertz) == sizeof(SolverDef::contact_hertz));
static_assert(offsetof(IsletSolverDef, contact_damping_ratio) == offsetof(SolverDef, contact_damping_ratio) + start_of<SolverDef> && sizeof(IsletSolverDef::contact_damping_ratio) == sizeof(SolverDef::contact_damping_ratio));
static_assert(offsetof(IsletSolverDef, contact_push_speed) == offsetof(SolverDef, contact_push_speed) + start_of<SolverDef> && sizeof(IsletSolverDef::contact_push_speed) == sizeof(SolverDef::contact_push_speed));
static_assert(offsetof(IsletSolverDef, joint_hertz) == offsetof(SolverDef, joint_hertz) + start_of<SolverDef> && sizeof(IsletSolverDef::joint_hertz) == sizeof(SolverDef::joint_hertz));
static_assert(offsetof(IsletSolverDef, joint_damping_ratio) == offsetof(SolverDef, joint_damping_ratio) + start_of<SolverDef> && sizeof(IsletSolverDef::joint_damping_ratio) == sizeof(SolverDef::joint_damping_ratio));
static_assert(offsetof(IsletSolverDef, baumgarte) == offsetof(SolverDef, baumgarte) + start_of<SolverDef> && sizeof(IsletSolverDef::baumgarte) == sizeof(SolverDef::baumgarte));
static_assert(offsetof(IsletSolverDef, omega) == offsetof(SolverDef, omega) + start_of<SolverDef> && sizeof(IsletSolverDef::omega) == sizeof(SolverDef::omega));
static_assert(offsetof(IsletSolverDef, warm_start) == offsetof(SolverDef, warm_start) + start_of<SolverDef> && sizeof(IsletSolverDef::warm_start) == sizeof(SolverDef::warm_start));
static_assert(offsetof(IsletSolverDef, joint_trees) == offsetof(SolverDef, joint_trees) + start_of<SolverDef> && sizeof(IsletSolverDef::joint_trees) == sizeof(SolverDef::joint_trees));
static_assert(offsetof(IsletSolverDef, joint_tree_load) == offsetof(SolverDef, joint_tree_load) + start_of<SolverDef> && sizeof(IsletSolverDef::joint_tree_load) == sizeof(SolverDef::joint_tree_load));
static_assert(offsetof(IsletSolverDef, sweep_order) == offsetof(SolverDef, sweep_order) + start_of<SolverDef> && sizeof(IsletSolverDef::sweep_order) == sizeof(SolverDef::sweep_order));
static_assert(offsetof(IsletSolverDef, block_contacts) == offsetof(SolverDef, block_contacts) + start_of<SolverDef> && sizeof(IsletSolverDef::block_contacts) == sizeof(SolverDef::block_contacts));
static_assert(offsetof(IsletSolverDef, shock) == offsetof(SolverDef, shock) + start_of<SolverDef> && sizeof(IsletSolverDef::shock) == sizeof(SolverDef::shock));
static_assert(offsetof(IsletSolverDef, measure_residual) == offsetof(SolverDef, measure_residual) + start_of<SolverDef> && sizeof(IsletSolverDef::measure_residual) == sizeof(SolverDef::measure_residual));
static_assert(offsetof(IsletSolverDef, tolerance) == offsetof(SolverDef, tolerance) + start_of<SolverDef> && sizeof(IsletSolverDef::tolerance) == sizeof(SolverDef::tolerance));
static_assert(sizeof(IsletBodyDef) == sizeof(BodyDef) + start_of<BodyDef> && start_of<BodyDef> == offsetof(IsletBodyDef, type));
static_assert(offsetof(IsletBodyDef, type) == offsetof(BodyDef, type) + start_of<BodyDef> && sizeof(IsletBodyDef::type) == sizeof(BodyDef::type));
static_assert(offsetof(IsletBodyDef, position) == offsetof(BodyDef, position) + start_of<BodyDef> && sizeof(IsletBodyDef::position) == sizeof(BodyDef::position));
static_assert(offsetof(IsletBodyDef, angle) == offsetof(BodyDef, angle) + start_of<BodyDef> && sizeof(IsletBodyDef::angle) == sizeof(BodyDef::angle));
static_assert(offsetof(IsletBodyDef, linear_velocity) == offsetof(BodyDef, linear_velocity) + start_of<BodyDef> && sizeof(IsletBodyDef::linear_velocity) == sizeof(BodyDef::linear_velocity));
static_assert(offsetof(IsletBodyDef, angular_velocity) == offsetof(BodyDef, angular_velocity) + start_of<BodyDef> && sizeof(IsletBodyDef::angular_velocity) == sizeof(BodyDef::angular_velocity));
static_assert(offsetof(IsletBodyDef, linear_damping) == offsetof(BodyDef, linear_damping) + start_of<BodyDef> && sizeof(IsletBodyDef::linear_damping) == sizeof(BodyDef::linear_damping));
static_assert(offsetof(IsletBodyDef, angular_damping) == offsetof(BodyDef, angular_damping) + start_of<BodyDef> && sizeof(IsletBodyDef::angular_damping) == sizeof(BodyDef::angular_damping));
static_assert(offsetof(IsletBodyDef, gravity_scale) == offsetof(BodyDef, gravity_scale) + start_of<BodyDef> && sizeof(IsletBodyDef::gravity_scale) == sizeof(BodyDef::gravity_scale));
static_assert(offsetof(IsletBodyDef, sleep_threshold) == offsetof(BodyDef, sleep_threshold) + start_of<BodyDef> && sizeof(IsletBodyDef::sleep_threshold) == sizeof(BodyDef::sleep_threshold));
static_assert(offsetof(IsletBodyDef, enable_sleep) == offsetof(BodyDef, enable_sleep) + start_of<BodyDef> && sizeof(IsletBodyDef::enable_sleep) == sizeof(BodyDef::enable_sleep));
static_assert(offsetof(IsletBodyDef, awake) == offsetof(BodyDef, awake) + start_of<BodyDef> && sizeof(IsletBodyDef::awake) == sizeof(BodyDef::awake));
static_assert(offsetof(IsletBodyDef, fixed_rotation) == offsetof(BodyDef, fixed_rotation) + start_of<BodyDef> && sizeof(IsletBodyDef::fixed_rotation) == sizeof(BodyDef::fixed_rotation));
static_assert(offsetof(IsletBodyDef, lock_x) == offsetof(BodyDef, lock_x) + start_of<BodyDef> && sizeof(IsletBodyDef::lock_x) == sizeof(BodyDef::lock_x));
static_assert(offsetof(IsletBodyDef, lock_y) == offsetof(BodyDef, lock_y) + start_of<BodyDef> && sizeof(IsletBodyDef::lock_y) == sizeof(BodyDef::lock_y));
static_assert(offsetof(IsletBodyDef, enabled) == offsetof(BodyDef, enabled) + start_of<BodyDef> && sizeof(IsletBodyDef::enabled) == sizeof(BodyDef::enabled));
static_assert(offsetof(IsletBodyDef, bullet) == offsetof(BodyDef, bullet) + start_of<BodyDef> && sizeof(IsletBodyDef::bullet) == sizeof(BodyDef::bullet));
static_assert(offsetof(IsletBodyDef, user_data) == offsetof(BodyDef, user_data) + start_of<BodyDef> && sizeof(IsletBodyDef::user_data) == sizeof(BodyDef::user_data));
static_assert(sizeof(IsletFilter) == sizeof(Filter) && alignof(IsletFilter) == alignof(Filter));
static_assert(offsetof(IsletFilter, category) == offsetof(Filter, category) && sizeof(IsletFilter::category) == sizeof(Filter::category));
static_assert(offsetof(IsletFilter, mask) == offsetof(Filter, mask) && sizeof(IsletFilter::mask) == sizeof(Filter::mask));
static_assert(offsetof(IsletFilter, group) == offsetof(Filter, group) && sizeof(IsletFilter::group) == sizeof(Filter::group));
static_assert(sizeof(IsletSurfaceMaterial) == sizeof(SurfaceMaterial) && alignof(IsletSurfaceMaterial) == alignof(SurfaceMaterial));
static_assert(offsetof(IsletSurfaceMaterial, friction) == offsetof(SurfaceMaterial, friction) && sizeof(IsletSurfaceMaterial::friction) == sizeof(SurfaceMaterial::friction));
static_assert(offsetof(IsletSurfaceMaterial, restitution) == offsetof(SurfaceMaterial, restitution) && sizeof(IsletSurfaceMaterial::restitution) == sizeof(SurfaceMaterial::restitution));
static_assert(offsetof(IsletSurfaceMaterial, rolling_resistance) == offsetof(SurfaceMaterial, rolling_resistance) && sizeof(IsletSurfaceMaterial::rolling_resistance) == sizeof(SurfaceMaterial::rolling_resistance));
static_assert(offsetof(IsletSurfaceMaterial, tangent_speed) == offsetof(SurfaceMaterial, tangent_speed) && sizeof(IsletSurfaceMaterial::tangent_speed) == sizeof(SurfaceMaterial::tangent_speed));
static_assert(offsetof(IsletSurfaceMaterial, id) == offsetof(SurfaceMaterial, id) && sizeof(IsletSurfaceMaterial::id) == sizeof(SurfaceMaterial::id));
static_assert(sizeof(IsletShapeDef) == sizeof(ShapeDef) + start_of<ShapeDef> && start_of<ShapeDef> == offsetof(IsletShapeDef, friction));
static_assert(offsetof(IsletShapeDef, friction) == offsetof(ShapeDef, friction) + start_of<ShapeDef> && sizeof(IsletShapeDef::friction) == sizeof(ShapeDef::friction));
static_assert(offsetof(IsletShapeDef, restitution) == offsetof(ShapeDef, restitution) + start_of<ShapeDef> && sizeof(IsletShapeDef::restitution) == sizeof(ShapeDef::restitution));
static_assert(offsetof(IsletShapeDef, rolling_resistance) == offsetof(ShapeDef, rolling_resistance) + start_of<ShapeDef> && sizeof(IsletShapeDef::rolling_resistance) == sizeof(ShapeDef::rolling_resistance));
static_assert(offsetof(IsletShapeDef, tangent_speed) == offsetof(ShapeDef, tangent_speed) + start_of<ShapeDef> && sizeof(IsletShapeDef::tangent_speed) == sizeof(ShapeDef::tangent_speed));
static_assert(offsetof(IsletShapeDef, density) == offsetof(ShapeDef, density) + start_of<ShapeDef> && sizeof(IsletShapeDef::density) == sizeof(ShapeDef::density));
static_assert(offsetof(IsletShapeDef, filter) == offsetof(ShapeDef, filter) + start_of<ShapeDef> && sizeof(IsletShapeDef::filter) == sizeof(ShapeDef::filter));
static_assert(offsetof(IsletShapeDef, sensor) == offsetof(ShapeDef, sensor) + start_of<ShapeDef> && sizeof(IsletShapeDef::sensor) == sizeof(ShapeDef::sensor));
static_assert(offsetof(IsletShapeDef, sensor_events) == offsetof(ShapeDef, sensor_events) + start_of<ShapeDef> && sizeof(IsletShapeDef::sensor_events) == sizeof(ShapeDef::sensor_events));
static_assert(offsetof(IsletShapeDef, hit_events) == offsetof(ShapeDef, hit_events) + start_of<ShapeDef> && sizeof(IsletShapeDef::hit_events) == sizeof(ShapeDef::hit_events));
static_assert(offsetof(IsletShapeDef, pre_solve) == offsetof(ShapeDef, pre_solve) + start_of<ShapeDef> && sizeof(IsletShapeDef::pre_solve) == sizeof(ShapeDef::pre_solve));
static_assert(offsetof(IsletShapeDef, one_way) == offsetof(ShapeDef, one_way) + start_of<ShapeDef> && sizeof(IsletShapeDef::one_way) == sizeof(ShapeDef::one_way));
static_assert(offsetof(IsletShapeDef, material) == offsetof(ShapeDef, material) + start_of<ShapeDef> && sizeof(IsletShapeDef::material) == sizeof(ShapeDef::material));
static_assert(offsetof(IsletShapeDef, user_data) == offsetof(ShapeDef, user_data) + start_of<ShapeDef> && sizeof(IsletShapeDef::user_data) == sizeof(ShapeDef::user_data));
static_assert(sizeof(IsletTouchEvent) == sizeof(TouchEvent) && alignof(IsletTouchEvent) == alignof(TouchEvent));
static_assert(offsetof(IsletTouchEvent, shape_a) == offsetof(TouchEvent, shape_a) && sizeof(IsletTouchEvent::shape_a) == sizeof(TouchEvent::shape_a));
static_assert(offsetof(IsletTouchEvent, shape_b) == offsetof(TouchEvent, shape_b) && sizeof(IsletTouchEvent::shape_b) == sizeof(TouchEvent::shape_b));
static_assert(sizeof(IsletSensorEvent) == sizeof(SensorEvent) && alignof(IsletSensorEvent) == alignof(SensorEvent));
static_assert(offsetof(IsletSensorEvent, sensor) == offsetof(SensorEvent, sensor) && sizeof(IsletSensorEvent::sensor) == sizeof(SensorEvent::sensor));
static_assert(offsetof(IsletSensorEvent, visitor) == offsetof(SensorEvent, visitor) && sizeof(IsletSensorEvent::visitor) == sizeof(SensorEvent::visitor));
static_assert(sizeof(IsletHitEvent) == sizeof(HitEvent) && alignof(IsletHitEvent) == alignof(HitEvent));
static_assert(offsetof(IsletHitEvent, shape_a) == offsetof(HitEvent, shape_a) && sizeof(IsletHitEvent::shape_a) == sizeof(HitEvent::shape_a));
static_assert(offsetof(IsletHitEvent, shape_b) == offsetof(HitEvent, shape_b) && sizeof(IsletHitEvent::shape_b) == sizeof(HitEvent::shape_b));
static_assert(offsetof(IsletHitEvent, point) == offsetof(HitEvent, point) && sizeof(IsletHitEvent::point) == sizeof(HitEvent::point));
static_assert(offsetof(IsletHitEvent, normal) == offsetof(HitEvent, normal) && sizeof(IsletHitEvent::normal) == sizeof(HitEvent::normal));
static_assert(offsetof(IsletHitEvent, speed) == offsetof(HitEvent, speed) && sizeof(IsletHitEvent::speed) == sizeof(HitEvent::speed));
static_assert(sizeof(IsletExplosionDef) == sizeof(ExplosionDef) + start_of<ExplosionDef> && start_of<ExplosionDef> == offsetof(IsletExplosionDef, position));
static_assert(offsetof(IsletExplosionDef, position) == offsetof(ExplosionDef, position) + start_of<ExplosionDef> && sizeof(IsletExplosionDef::position) == sizeof(ExplosionDef::position));
static_assert(offsetof(IsletExplosionDef, radius) == offsetof(ExplosionDef, radius) + start_of<ExplosionDef> && sizeof(IsletExplosionDef::radius) == sizeof(ExplosionDef::radius));
static_assert(offsetof(IsletExplosionDef, falloff) == offsetof(ExplosionDef, falloff) + start_of<ExplosionDef> && sizeof(IsletExplosionDef::falloff) == sizeof(ExplosionDef::falloff));
static_assert(offsetof(IsletExplosionDef, impulse_per_length) == offsetof(ExplosionDef, impulse_per_length) + start_of<ExplosionDef> && sizeof(IsletExplosionDef::impulse_per_length) == sizeof(ExplosionDef::impulse_per_length));
static_assert(offsetof(IsletExplosionDef, mask) == offsetof(ExplosionDef, mask) + start_of<ExplosionDef> && sizeof(IsletExplosionDef::mask) == sizeof(ExplosionDef::mask));
static_assert(sizeof(IsletWindDef) == sizeof(WindDef) + start_of<WindDef> && start_of<WindDef> == offsetof(IsletWindDef, velocity));
static_assert(offsetof(IsletWindDef, velocity) == offsetof(WindDef, velocity) + start_of<WindDef> && sizeof(IsletWindDef::velocity) == sizeof(WindDef::velocity));
static_assert(offsetof(IsletWindDef, drag) == offsetof(WindDef, drag) + start_of<WindDef> && sizeof(IsletWindDef::drag) == sizeof(WindDef::drag));
static_assert(offsetof(IsletWindDef, lift) == offsetof(WindDef, lift) + start_of<WindDef> && sizeof(IsletWindDef::lift) == sizeof(WindDef::lift));
static_assert(offsetof(IsletWindDef, density) == offsetof(WindDef, density) + start_of<WindDef> && sizeof(IsletWindDef::density) == sizeof(WindDef::density));
static_assert(offsetof(IsletWindDef, wake) == offsetof(WindDef, wake) + start_of<WindDef> && sizeof(IsletWindDef::wake) == sizeof(WindDef::wake));
static_assert(sizeof(IsletStepReport) == sizeof(StepReport) + start_of<StepReport> && start_of<StepReport> == offsetof(IsletStepReport, bodies));
static_assert(offsetof(IsletStepReport, bodies) == offsetof(StepReport, bodies) + start_of<StepReport> && sizeof(IsletStepReport::bodies) == sizeof(StepReport::bodies));
static_assert(offsetof(IsletStepReport, awake_bodies) == offsetof(StepReport, awake_bodies) + start_of<StepReport> && sizeof(IsletStepReport::awake_bodies) == sizeof(StepReport::awake_bodies));
static_assert(offsetof(IsletStepReport, shapes) == offsetof(StepReport, shapes) + start_of<StepReport> && sizeof(IsletStepReport::shapes) == sizeof(StepReport::shapes));
static_assert(offsetof(IsletStepReport, contacts) == offsetof(StepReport, contacts) + start_of<StepReport> && sizeof(IsletStepReport::contacts) == sizeof(StepReport::contacts));
static_assert(offsetof(IsletStepReport, touching_contacts) == offsetof(StepReport, touching_contacts) + start_of<StepReport> && sizeof(IsletStepReport::touching_contacts) == sizeof(StepReport::touching_contacts));
static_assert(offsetof(IsletStepReport, recycled_contacts) == offsetof(StepReport, recycled_contacts) + start_of<StepReport> && sizeof(IsletStepReport::recycled_contacts) == sizeof(StepReport::recycled_contacts));
static_assert(offsetof(IsletStepReport, dropped_contacts) == offsetof(StepReport, dropped_contacts) + start_of<StepReport> && sizeof(IsletStepReport::dropped_contacts) == sizeof(StepReport::dropped_contacts));
static_assert(offsetof(IsletStepReport, dropped_events) == offsetof(StepReport, dropped_events) + start_of<StepReport> && sizeof(IsletStepReport::dropped_events) == sizeof(StepReport::dropped_events));
static_assert(offsetof(IsletStepReport, dropped_hits) == offsetof(StepReport, dropped_hits) + start_of<StepReport> && sizeof(IsletStepReport::dropped_hits) == sizeof(StepReport::dropped_hits));
static_assert(offsetof(IsletStepReport, islands) == offsetof(StepReport, islands) + start_of<StepReport> && sizeof(IsletStepReport::islands) == sizeof(StepReport::islands));
static_assert(offsetof(IsletStepReport, colors) == offsetof(StepReport, colors) + start_of<StepReport> && sizeof(IsletStepReport::colors) == sizeof(StepReport::colors));
static_assert(offsetof(IsletStepReport, overflow_contacts) == offsetof(StepReport, overflow_contacts) + start_of<StepReport> && sizeof(IsletStepReport::overflow_contacts) == sizeof(StepReport::overflow_contacts));
static_assert(offsetof(IsletStepReport, batches) == offsetof(StepReport, batches) + start_of<StepReport> && sizeof(IsletStepReport::batches) == sizeof(StepReport::batches));
static_assert(offsetof(IsletStepReport, joints) == offsetof(StepReport, joints) + start_of<StepReport> && sizeof(IsletStepReport::joints) == sizeof(StepReport::joints));
static_assert(offsetof(IsletStepReport, awake_joints) == offsetof(StepReport, awake_joints) + start_of<StepReport> && sizeof(IsletStepReport::awake_joints) == sizeof(StepReport::awake_joints));
static_assert(offsetof(IsletStepReport, overflow_joints) == offsetof(StepReport, overflow_joints) + start_of<StepReport> && sizeof(IsletStepReport::overflow_joints) == sizeof(StepReport::overflow_joints));
static_assert(offsetof(IsletStepReport, sweeps) == offsetof(StepReport, sweeps) + start_of<StepReport> && sizeof(IsletStepReport::sweeps) == sizeof(StepReport::sweeps));
static_assert(offsetof(IsletStepReport, residual) == offsetof(StepReport, residual) + start_of<StepReport> && sizeof(IsletStepReport::residual) == sizeof(StepReport::residual));
static_assert(sizeof(IsletStepProfile) == sizeof(StepProfile) + start_of<StepProfile> && start_of<StepProfile> == offsetof(IsletStepProfile, pairs));
static_assert(offsetof(IsletStepProfile, pairs) == offsetof(StepProfile, pairs) + start_of<StepProfile> && sizeof(IsletStepProfile::pairs) == sizeof(StepProfile::pairs));
static_assert(offsetof(IsletStepProfile, collide) == offsetof(StepProfile, collide) + start_of<StepProfile> && sizeof(IsletStepProfile::collide) == sizeof(StepProfile::collide));
static_assert(offsetof(IsletStepProfile, islands) == offsetof(StepProfile, islands) + start_of<StepProfile> && sizeof(IsletStepProfile::islands) == sizeof(StepProfile::islands));
static_assert(offsetof(IsletStepProfile, solve) == offsetof(StepProfile, solve) + start_of<StepProfile> && sizeof(IsletStepProfile::solve) == sizeof(StepProfile::solve));
static_assert(offsetof(IsletStepProfile, finish) == offsetof(StepProfile, finish) + start_of<StepProfile> && sizeof(IsletStepProfile::finish) == sizeof(StepProfile::finish));
static_assert(offsetof(IsletStepProfile, total) == offsetof(StepProfile, total) + start_of<StepProfile> && sizeof(IsletStepProfile::total) == sizeof(StepProfile::total));
static_assert(sizeof(IsletWorldCounters) == sizeof(WorldCounters) + start_of<WorldCounters> && start_of<WorldCounters> == offsetof(IsletWorldCounters, bytes));
static_assert(offsetof(IsletWorldCounters, bytes) == offsetof(WorldCounters, bytes) + start_of<WorldCounters> && sizeof(IsletWorldCounters::bytes) == sizeof(WorldCounters::bytes));
static_assert(offsetof(IsletWorldCounters, snapshot_bytes) == offsetof(WorldCounters, snapshot_bytes) + start_of<WorldCounters> && sizeof(IsletWorldCounters::snapshot_bytes) == sizeof(WorldCounters::snapshot_bytes));
static_assert(offsetof(IsletWorldCounters, geometries) == offsetof(WorldCounters, geometries) + start_of<WorldCounters> && sizeof(IsletWorldCounters::geometries) == sizeof(WorldCounters::geometries));
static_assert(offsetof(IsletWorldCounters, tree_shapes) == offsetof(WorldCounters, tree_shapes) + start_of<WorldCounters> && sizeof(IsletWorldCounters::tree_shapes) == sizeof(WorldCounters::tree_shapes));
static_assert(offsetof(IsletWorldCounters, tree_height) == offsetof(WorldCounters, tree_height) + start_of<WorldCounters> && sizeof(IsletWorldCounters::tree_height) == sizeof(WorldCounters::tree_height));
static_assert(offsetof(IsletWorldCounters, colors) == offsetof(WorldCounters, colors) + start_of<WorldCounters> && sizeof(IsletWorldCounters::colors) == sizeof(WorldCounters::colors));
static_assert(offsetof(IsletWorldCounters, uncolored) == offsetof(WorldCounters, uncolored) + start_of<WorldCounters> && sizeof(IsletWorldCounters::uncolored) == sizeof(WorldCounters::uncolored));
static_assert(sizeof(IsletContactPoint) == sizeof(ContactPoint) && alignof(IsletContactPoint) == alignof(ContactPoint));
static_assert(offsetof(IsletContactPoint, point) == offsetof(ContactPoint, point) && sizeof(IsletContactPoint::point) == sizeof(ContactPoint::point));
static_assert(offsetof(IsletContactPoint, separation) == offsetof(ContactPoint, separation) && sizeof(IsletContactPoint::separation) == sizeof(ContactPoint::separation));
static_assert(offsetof(IsletContactPoint, normal_impulse) == offsetof(ContactPoint, normal_impulse) && sizeof(IsletContactPoint::normal_impulse) == sizeof(ContactPoint::normal_impulse));
static_assert(offsetof(IsletContactPoint, tangent_impulse) == offsetof(ContactPoint, tangent_impulse) && sizeof(IsletContactPoint::tangent_impulse) == sizeof(ContactPoint::tangent_impulse));
static_assert(offsetof(IsletContactPoint, feature) == offsetof(ContactPoint, feature) && sizeof(IsletContactPoint::feature) == sizeof(ContactPoint::feature));
static_assert(sizeof(IsletContactInfo) == sizeof(ContactInfo) && alignof(IsletContactInfo) == alignof(ContactInfo));
static_assert(offsetof(IsletContactInfo, shape_a) == offsetof(ContactInfo, shape_a) && sizeof(IsletContactInfo::shape_a) == sizeof(ContactInfo::shape_a));
static_assert(offsetof(IsletContactInfo, shape_b) == offsetof(ContactInfo, shape_b) && sizeof(IsletContactInfo::shape_b) == sizeof(ContactInfo::shape_b));
static_assert(offsetof(IsletContactInfo, normal) == offsetof(ContactInfo, normal) && sizeof(IsletContactInfo::normal) == sizeof(ContactInfo::normal));
static_assert(offsetof(IsletContactInfo, points) == offsetof(ContactInfo, points) && sizeof(IsletContactInfo::points) == sizeof(ContactInfo::points));
static_assert(offsetof(IsletContactInfo, point_count) == offsetof(ContactInfo, point_count) && sizeof(IsletContactInfo::point_count) == sizeof(ContactInfo::point_count));
static_assert(offsetof(IsletContactInfo, friction) == offsetof(ContactInfo, friction) && sizeof(IsletContactInfo::friction) == sizeof(ContactInfo::friction));
static_assert(offsetof(IsletContactInfo, restitution) == offsetof(ContactInfo, restitution) && sizeof(IsletContactInfo::restitution) == sizeof(ContactInfo::restitution));
static_assert(sizeof(IsletPreSolve) == sizeof(PreSolve) && alignof(IsletPreSolve) == alignof(PreSolve));
static_assert(offsetof(IsletPreSolve, contact) == offsetof(PreSolve, contact) && sizeof(IsletPreSolve::contact) == sizeof(PreSolve::contact));
static_assert(offsetof(IsletPreSolve, enabled) == offsetof(PreSolve, enabled) && sizeof(IsletPreSolve::enabled) == sizeof(PreSolve::enabled));
static_assert(offsetof(IsletPreSolve, friction) == offsetof(PreSolve, friction) && sizeof(IsletPreSolve::friction) == sizeof(PreSolve::friction));
static_assert(offsetof(IsletPreSolve, tangent_speed) == offsetof(PreSolve, tangent_speed) && sizeof(IsletPreSolve::tangent_speed) == sizeof(PreSolve::tangent_speed));
static_assert(sizeof(IsletRowEnd) == sizeof(RowEnd) && alignof(IsletRowEnd) == alignof(RowEnd));
static_assert(offsetof(IsletRowEnd, body) == offsetof(RowEnd, body) && sizeof(IsletRowEnd::body) == sizeof(RowEnd::body));
static_assert(offsetof(IsletRowEnd, linear) == offsetof(RowEnd, linear) && sizeof(IsletRowEnd::linear) == sizeof(RowEnd::linear));
static_assert(offsetof(IsletRowEnd, angular) == offsetof(RowEnd, angular) && sizeof(IsletRowEnd::angular) == sizeof(RowEnd::angular));
static_assert(sizeof(IsletIslandRow) == sizeof(IslandRow) && alignof(IsletIslandRow) == alignof(IslandRow));
static_assert(offsetof(IsletIslandRow, kind) == offsetof(IslandRow, kind) && sizeof(IsletIslandRow::kind) == sizeof(IslandRow::kind));
static_assert(offsetof(IsletIslandRow, slot) == offsetof(IslandRow, slot) && sizeof(IsletIslandRow::slot) == sizeof(IslandRow::slot));
static_assert(offsetof(IsletIslandRow, index) == offsetof(IslandRow, index) && sizeof(IsletIslandRow::index) == sizeof(IslandRow::index));
static_assert(offsetof(IsletIslandRow, end_count) == offsetof(IslandRow, end_count) && sizeof(IsletIslandRow::end_count) == sizeof(IslandRow::end_count));
static_assert(offsetof(IsletIslandRow, ends) == offsetof(IslandRow, ends) && sizeof(IsletIslandRow::ends) == sizeof(IslandRow::ends));
static_assert(offsetof(IsletIslandRow, bias) == offsetof(IslandRow, bias) && sizeof(IsletIslandRow::bias) == sizeof(IslandRow::bias));
static_assert(offsetof(IsletIslandRow, softness) == offsetof(IslandRow, softness) && sizeof(IsletIslandRow::softness) == sizeof(IslandRow::softness));
static_assert(sizeof(IsletIslandBody) == sizeof(IslandBody) && alignof(IsletIslandBody) == alignof(IslandBody));
static_assert(offsetof(IsletIslandBody, id) == offsetof(IslandBody, id) && sizeof(IsletIslandBody::id) == sizeof(IslandBody::id));
static_assert(offsetof(IsletIslandBody, inv_mass) == offsetof(IslandBody, inv_mass) && sizeof(IsletIslandBody::inv_mass) == sizeof(IslandBody::inv_mass));
static_assert(offsetof(IsletIslandBody, inv_inertia) == offsetof(IslandBody, inv_inertia) && sizeof(IsletIslandBody::inv_inertia) == sizeof(IslandBody::inv_inertia));
static_assert(offsetof(IsletIslandBody, v_free) == offsetof(IslandBody, v_free) && sizeof(IsletIslandBody::v_free) == sizeof(IslandBody::v_free));
static_assert(offsetof(IsletIslandBody, w_free) == offsetof(IslandBody, w_free) && sizeof(IsletIslandBody::w_free) == sizeof(IslandBody::w_free));
static_assert(sizeof(IsletJointId) == sizeof(JointId) && alignof(IsletJointId) == alignof(JointId));
static_assert(offsetof(IsletJointId, index1) == offsetof(JointId, index1) && sizeof(IsletJointId::index1) == sizeof(JointId::index1));
static_assert(offsetof(IsletJointId, generation) == offsetof(JointId, generation) && sizeof(IsletJointId::generation) == sizeof(JointId::generation));
static_assert(sizeof(IsletJointFrame) == sizeof(JointFrame) && alignof(IsletJointFrame) == alignof(JointFrame));
static_assert(offsetof(IsletJointFrame, position) == offsetof(JointFrame, position) && sizeof(IsletJointFrame::position) == sizeof(JointFrame::position));
static_assert(offsetof(IsletJointFrame, angle) == offsetof(JointFrame, angle) && sizeof(IsletJointFrame::angle) == sizeof(JointFrame::angle));
static_assert(sizeof(IsletJointSpring) == sizeof(JointSpring) && alignof(IsletJointSpring) == alignof(JointSpring));
static_assert(offsetof(IsletJointSpring, enable) == offsetof(JointSpring, enable) && sizeof(IsletJointSpring::enable) == sizeof(JointSpring::enable));
static_assert(offsetof(IsletJointSpring, hertz) == offsetof(JointSpring, hertz) && sizeof(IsletJointSpring::hertz) == sizeof(JointSpring::hertz));
static_assert(offsetof(IsletJointSpring, damping_ratio) == offsetof(JointSpring, damping_ratio) && sizeof(IsletJointSpring::damping_ratio) == sizeof(JointSpring::damping_ratio));
static_assert(offsetof(IsletJointSpring, target) == offsetof(JointSpring, target) && sizeof(IsletJointSpring::target) == sizeof(JointSpring::target));
static_assert(sizeof(IsletJointLimit) == sizeof(JointLimit) && alignof(IsletJointLimit) == alignof(JointLimit));
static_assert(offsetof(IsletJointLimit, enable) == offsetof(JointLimit, enable) && sizeof(IsletJointLimit::enable) == sizeof(JointLimit::enable));
static_assert(offsetof(IsletJointLimit, lower) == offsetof(JointLimit, lower) && sizeof(IsletJointLimit::lower) == sizeof(JointLimit::lower));
static_assert(offsetof(IsletJointLimit, upper) == offsetof(JointLimit, upper) && sizeof(IsletJointLimit::upper) == sizeof(JointLimit::upper));
static_assert(sizeof(IsletJointMotor) == sizeof(JointMotor) && alignof(IsletJointMotor) == alignof(JointMotor));
static_assert(offsetof(IsletJointMotor, enable) == offsetof(JointMotor, enable) && sizeof(IsletJointMotor::enable) == sizeof(JointMotor::enable));
static_assert(offsetof(IsletJointMotor, speed) == offsetof(JointMotor, speed) && sizeof(IsletJointMotor::speed) == sizeof(JointMotor::speed));
static_assert(offsetof(IsletJointMotor, max_force) == offsetof(JointMotor, max_force) && sizeof(IsletJointMotor::max_force) == sizeof(JointMotor::max_force));
static_assert(sizeof(IsletJointBase) == sizeof(JointBase) && alignof(IsletJointBase) == alignof(JointBase));
static_assert(offsetof(IsletJointBase, body_a) == offsetof(JointBase, body_a) && sizeof(IsletJointBase::body_a) == sizeof(JointBase::body_a));
static_assert(offsetof(IsletJointBase, body_b) == offsetof(JointBase, body_b) && sizeof(IsletJointBase::body_b) == sizeof(JointBase::body_b));
static_assert(offsetof(IsletJointBase, frame_a) == offsetof(JointBase, frame_a) && sizeof(IsletJointBase::frame_a) == sizeof(JointBase::frame_a));
static_assert(offsetof(IsletJointBase, frame_b) == offsetof(JointBase, frame_b) && sizeof(IsletJointBase::frame_b) == sizeof(JointBase::frame_b));
static_assert(offsetof(IsletJointBase, collide_connected) == offsetof(JointBase, collide_connected) && sizeof(IsletJointBase::collide_connected) == sizeof(JointBase::collide_connected));
static_assert(offsetof(IsletJointBase, break_force) == offsetof(JointBase, break_force) && sizeof(IsletJointBase::break_force) == sizeof(JointBase::break_force));
static_assert(offsetof(IsletJointBase, break_torque) == offsetof(JointBase, break_torque) && sizeof(IsletJointBase::break_torque) == sizeof(JointBase::break_torque));
static_assert(offsetof(IsletJointBase, user_data) == offsetof(JointBase, user_data) && sizeof(IsletJointBase::user_data) == sizeof(JointBase::user_data));
static_assert(sizeof(IsletRevoluteJointDef) == sizeof(RevoluteJointDef) + start_of<RevoluteJointDef> && start_of<RevoluteJointDef> == offsetof(IsletRevoluteJointDef, base));
static_assert(offsetof(IsletRevoluteJointDef, base) == offsetof(RevoluteJointDef, base) + start_of<RevoluteJointDef> && sizeof(IsletRevoluteJointDef::base) == sizeof(RevoluteJointDef::base));
static_assert(offsetof(IsletRevoluteJointDef, spring) == offsetof(RevoluteJointDef, spring) + start_of<RevoluteJointDef> && sizeof(IsletRevoluteJointDef::spring) == sizeof(RevoluteJointDef::spring));
static_assert(offsetof(IsletRevoluteJointDef, limit) == offsetof(RevoluteJointDef, limit) + start_of<RevoluteJointDef> && sizeof(IsletRevoluteJointDef::limit) == sizeof(RevoluteJointDef::limit));
static_assert(offsetof(IsletRevoluteJointDef, motor) == offsetof(RevoluteJointDef, motor) + start_of<RevoluteJointDef> && sizeof(IsletRevoluteJointDef::motor) == sizeof(RevoluteJointDef::motor));
static_assert(offsetof(IsletRevoluteJointDef, friction) == offsetof(RevoluteJointDef, friction) + start_of<RevoluteJointDef> && sizeof(IsletRevoluteJointDef::friction) == sizeof(RevoluteJointDef::friction));
static_assert(sizeof(IsletPrismaticJointDef) == sizeof(PrismaticJointDef) + start_of<PrismaticJointDef> && start_of<PrismaticJointDef> == offsetof(IsletPrismaticJointDef, base));
static_assert(offsetof(IsletPrismaticJointDef, base) == offsetof(PrismaticJointDef, base) + start_of<PrismaticJointDef> && sizeof(IsletPrismaticJointDef::base) == sizeof(PrismaticJointDef::base));
static_assert(offsetof(IsletPrismaticJointDef, spring) == offsetof(PrismaticJointDef, spring) + start_of<PrismaticJointDef> && sizeof(IsletPrismaticJointDef::spring) == sizeof(PrismaticJointDef::spring));
static_assert(offsetof(IsletPrismaticJointDef, limit) == offsetof(PrismaticJointDef, limit) + start_of<PrismaticJointDef> && sizeof(IsletPrismaticJointDef::limit) == sizeof(PrismaticJointDef::limit));
static_assert(offsetof(IsletPrismaticJointDef, motor) == offsetof(PrismaticJointDef, motor) + start_of<PrismaticJointDef> && sizeof(IsletPrismaticJointDef::motor) == sizeof(PrismaticJointDef::motor));
static_assert(offsetof(IsletPrismaticJointDef, friction) == offsetof(PrismaticJointDef, friction) + start_of<PrismaticJointDef> && sizeof(IsletPrismaticJointDef::friction) == sizeof(PrismaticJointDef::friction));
static_assert(sizeof(IsletDistanceJointDef) == sizeof(DistanceJointDef) + start_of<DistanceJointDef> && start_of<DistanceJointDef> == offsetof(IsletDistanceJointDef, base));
static_assert(offsetof(IsletDistanceJointDef, base) == offsetof(DistanceJointDef, base) + start_of<DistanceJointDef> && sizeof(IsletDistanceJointDef::base) == sizeof(DistanceJointDef::base));
static_assert(offsetof(IsletDistanceJointDef, length) == offsetof(DistanceJointDef, length) + start_of<DistanceJointDef> && sizeof(IsletDistanceJointDef::length) == sizeof(DistanceJointDef::length));
static_assert(offsetof(IsletDistanceJointDef, spring) == offsetof(DistanceJointDef, spring) + start_of<DistanceJointDef> && sizeof(IsletDistanceJointDef::spring) == sizeof(DistanceJointDef::spring));
static_assert(offsetof(IsletDistanceJointDef, limit) == offsetof(DistanceJointDef, limit) + start_of<DistanceJointDef> && sizeof(IsletDistanceJointDef::limit) == sizeof(DistanceJointDef::limit));
static_assert(offsetof(IsletDistanceJointDef, motor) == offsetof(DistanceJointDef, motor) + start_of<DistanceJointDef> && sizeof(IsletDistanceJointDef::motor) == sizeof(DistanceJointDef::motor));
static_assert(sizeof(IsletWeldJointDef) == sizeof(WeldJointDef) + start_of<WeldJointDef> && start_of<WeldJointDef> == offsetof(IsletWeldJointDef, base));
static_assert(offsetof(IsletWeldJointDef, base) == offsetof(WeldJointDef, base) + start_of<WeldJointDef> && sizeof(IsletWeldJointDef::base) == sizeof(WeldJointDef::base));
static_assert(offsetof(IsletWeldJointDef, linear_hertz) == offsetof(WeldJointDef, linear_hertz) + start_of<WeldJointDef> && sizeof(IsletWeldJointDef::linear_hertz) == sizeof(WeldJointDef::linear_hertz));
static_assert(offsetof(IsletWeldJointDef, linear_damping_ratio) == offsetof(WeldJointDef, linear_damping_ratio) + start_of<WeldJointDef> && sizeof(IsletWeldJointDef::linear_damping_ratio) == sizeof(WeldJointDef::linear_damping_ratio));
static_assert(offsetof(IsletWeldJointDef, angular_hertz) == offsetof(WeldJointDef, angular_hertz) + start_of<WeldJointDef> && sizeof(IsletWeldJointDef::angular_hertz) == sizeof(WeldJointDef::angular_hertz));
static_assert(offsetof(IsletWeldJointDef, angular_damping_ratio) == offsetof(WeldJointDef, angular_damping_ratio) + start_of<WeldJointDef> && sizeof(IsletWeldJointDef::angular_damping_ratio) == sizeof(WeldJointDef::angular_damping_ratio));
static_assert(sizeof(IsletWheelJointDef) == sizeof(WheelJointDef) + start_of<WheelJointDef> && start_of<WheelJointDef> == offsetof(IsletWheelJointDef, base));
static_assert(offsetof(IsletWheelJointDef, base) == offsetof(WheelJointDef, base) + start_of<WheelJointDef> && sizeof(IsletWheelJointDef::base) == sizeof(WheelJointDef::base));
static_assert(offsetof(IsletWheelJointDef, spring) == offsetof(WheelJointDef, spring) + start_of<WheelJointDef> && sizeof(IsletWheelJointDef::spring) == sizeof(WheelJointDef::spring));
static_assert(offsetof(IsletWheelJointDef, limit) == offsetof(WheelJointDef, limit) + start_of<WheelJointDef> && sizeof(IsletWheelJointDef::limit) == sizeof(WheelJointDef::limit));
static_assert(offsetof(IsletWheelJointDef, motor) == offsetof(WheelJointDef, motor) + start_of<WheelJointDef> && sizeof(IsletWheelJointDef::motor) == sizeof(WheelJointDef::motor));
static_assert(offsetof(IsletWheelJointDef, friction) == offsetof(WheelJointDef, friction) + start_of<WheelJointDef> && sizeof(IsletWheelJointDef::friction) == sizeof(WheelJointDef::friction));
static_assert(sizeof(IsletMotorJointDef) == sizeof(MotorJointDef) + start_of<MotorJointDef> && start_of<MotorJointDef> == offsetof(IsletMotorJointDef, base));
static_assert(offsetof(IsletMotorJointDef, base) == offsetof(MotorJointDef, base) + start_of<MotorJointDef> && sizeof(IsletMotorJointDef::base) == sizeof(MotorJointDef::base));
static_assert(offsetof(IsletMotorJointDef, linear_velocity) == offsetof(MotorJointDef, linear_velocity) + start_of<MotorJointDef> && sizeof(IsletMotorJointDef::linear_velocity) == sizeof(MotorJointDef::linear_velocity));
static_assert(offsetof(IsletMotorJointDef, angular_velocity) == offsetof(MotorJointDef, angular_velocity) + start_of<MotorJointDef> && sizeof(IsletMotorJointDef::angular_velocity) == sizeof(MotorJointDef::angular_velocity));
static_assert(offsetof(IsletMotorJointDef, max_force) == offsetof(MotorJointDef, max_force) + start_of<MotorJointDef> && sizeof(IsletMotorJointDef::max_force) == sizeof(MotorJointDef::max_force));
static_assert(offsetof(IsletMotorJointDef, max_torque) == offsetof(MotorJointDef, max_torque) + start_of<MotorJointDef> && sizeof(IsletMotorJointDef::max_torque) == sizeof(MotorJointDef::max_torque));
static_assert(offsetof(IsletMotorJointDef, linear_hertz) == offsetof(MotorJointDef, linear_hertz) + start_of<MotorJointDef> && sizeof(IsletMotorJointDef::linear_hertz) == sizeof(MotorJointDef::linear_hertz));
static_assert(offsetof(IsletMotorJointDef, linear_damping_ratio) == offsetof(MotorJointDef, linear_damping_ratio) + start_of<MotorJointDef> && sizeof(IsletMotorJointDef::linear_damping_ratio) == sizeof(MotorJointDef::linear_damping_ratio));
static_assert(offsetof(IsletMotorJointDef, angular_hertz) == offsetof(MotorJointDef, angular_hertz) + start_of<MotorJointDef> && sizeof(IsletMotorJointDef::angular_hertz) == sizeof(MotorJointDef::angular_hertz));
static_assert(offsetof(IsletMotorJointDef, angular_damping_ratio) == offsetof(MotorJointDef, angular_damping_ratio) + start_of<MotorJointDef> && sizeof(IsletMotorJointDef::angular_damping_ratio) == sizeof(MotorJointDef::angular_damping_ratio));
static_assert(sizeof(IsletMouseJointDef) == sizeof(MouseJointDef) + start_of<MouseJointDef> && start_of<MouseJointDef> == offsetof(IsletMouseJointDef, body));
static_assert(offsetof(IsletMouseJointDef, body) == offsetof(MouseJointDef, body) + start_of<MouseJointDef> && sizeof(IsletMouseJointDef::body) == sizeof(MouseJointDef::body));
static_assert(offsetof(IsletMouseJointDef, target) == offsetof(MouseJointDef, target) + start_of<MouseJointDef> && sizeof(IsletMouseJointDef::target) == sizeof(MouseJointDef::target));
static_assert(offsetof(IsletMouseJointDef, hertz) == offsetof(MouseJointDef, hertz) + start_of<MouseJointDef> && sizeof(IsletMouseJointDef::hertz) == sizeof(MouseJointDef::hertz));
static_assert(offsetof(IsletMouseJointDef, damping_ratio) == offsetof(MouseJointDef, damping_ratio) + start_of<MouseJointDef> && sizeof(IsletMouseJointDef::damping_ratio) == sizeof(MouseJointDef::damping_ratio));
static_assert(offsetof(IsletMouseJointDef, max_force) == offsetof(MouseJointDef, max_force) + start_of<MouseJointDef> && sizeof(IsletMouseJointDef::max_force) == sizeof(MouseJointDef::max_force));
static_assert(offsetof(IsletMouseJointDef, user_data) == offsetof(MouseJointDef, user_data) + start_of<MouseJointDef> && sizeof(IsletMouseJointDef::user_data) == sizeof(MouseJointDef::user_data));
static_assert(sizeof(IsletPulleyJointDef) == sizeof(PulleyJointDef) + start_of<PulleyJointDef> && start_of<PulleyJointDef> == offsetof(IsletPulleyJointDef, base));
static_assert(offsetof(IsletPulleyJointDef, base) == offsetof(PulleyJointDef, base) + start_of<PulleyJointDef> && sizeof(IsletPulleyJointDef::base) == sizeof(PulleyJointDef::base));
static_assert(offsetof(IsletPulleyJointDef, ground_a) == offsetof(PulleyJointDef, ground_a) + start_of<PulleyJointDef> && sizeof(IsletPulleyJointDef::ground_a) == sizeof(PulleyJointDef::ground_a));
static_assert(offsetof(IsletPulleyJointDef, ground_b) == offsetof(PulleyJointDef, ground_b) + start_of<PulleyJointDef> && sizeof(IsletPulleyJointDef::ground_b) == sizeof(PulleyJointDef::ground_b));
static_assert(offsetof(IsletPulleyJointDef, ratio) == offsetof(PulleyJointDef, ratio) + start_of<PulleyJointDef> && sizeof(IsletPulleyJointDef::ratio) == sizeof(PulleyJointDef::ratio));
static_assert(sizeof(IsletGearJointDef) == sizeof(GearJointDef) + start_of<GearJointDef> && start_of<GearJointDef> == offsetof(IsletGearJointDef, joint1));
static_assert(offsetof(IsletGearJointDef, joint1) == offsetof(GearJointDef, joint1) + start_of<GearJointDef> && sizeof(IsletGearJointDef::joint1) == sizeof(GearJointDef::joint1));
static_assert(offsetof(IsletGearJointDef, joint2) == offsetof(GearJointDef, joint2) + start_of<GearJointDef> && sizeof(IsletGearJointDef::joint2) == sizeof(GearJointDef::joint2));
static_assert(offsetof(IsletGearJointDef, ratio) == offsetof(GearJointDef, ratio) + start_of<GearJointDef> && sizeof(IsletGearJointDef::ratio) == sizeof(GearJointDef::ratio));
static_assert(offsetof(IsletGearJointDef, break_torque) == offsetof(GearJointDef, break_torque) + start_of<GearJointDef> && sizeof(IsletGearJointDef::break_torque) == sizeof(GearJointDef::break_torque));
static_assert(offsetof(IsletGearJointDef, user_data) == offsetof(GearJointDef, user_data) + start_of<GearJointDef> && sizeof(IsletGearJointDef::user_data) == sizeof(GearJointDef::user_data));
static_assert(sizeof(IsletJointRatchet) == sizeof(JointRatchet) && alignof(IsletJointRatchet) == alignof(JointRatchet));
static_assert(offsetof(IsletJointRatchet, step) == offsetof(JointRatchet, step) && sizeof(IsletJointRatchet::step) == sizeof(JointRatchet::step));
static_assert(offsetof(IsletJointRatchet, phase) == offsetof(JointRatchet, phase) && sizeof(IsletJointRatchet::phase) == sizeof(JointRatchet::phase));
static_assert(sizeof(IsletAngleJointDef) == sizeof(AngleJointDef) + start_of<AngleJointDef> && start_of<AngleJointDef> == offsetof(IsletAngleJointDef, base));
static_assert(offsetof(IsletAngleJointDef, base) == offsetof(AngleJointDef, base) + start_of<AngleJointDef> && sizeof(IsletAngleJointDef::base) == sizeof(AngleJointDef::base));
static_assert(offsetof(IsletAngleJointDef, spring) == offsetof(AngleJointDef, spring) + start_of<AngleJointDef> && sizeof(IsletAngleJointDef::spring) == sizeof(AngleJointDef::spring));
static_assert(offsetof(IsletAngleJointDef, limit) == offsetof(AngleJointDef, limit) + start_of<AngleJointDef> && sizeof(IsletAngleJointDef::limit) == sizeof(AngleJointDef::limit));
static_assert(offsetof(IsletAngleJointDef, motor) == offsetof(AngleJointDef, motor) + start_of<AngleJointDef> && sizeof(IsletAngleJointDef::motor) == sizeof(AngleJointDef::motor));
static_assert(offsetof(IsletAngleJointDef, friction) == offsetof(AngleJointDef, friction) + start_of<AngleJointDef> && sizeof(IsletAngleJointDef::friction) == sizeof(AngleJointDef::friction));
static_assert(offsetof(IsletAngleJointDef, ratchet) == offsetof(AngleJointDef, ratchet) + start_of<AngleJointDef> && sizeof(IsletAngleJointDef::ratchet) == sizeof(AngleJointDef::ratchet));
static_assert(sizeof(IsletJointError) == sizeof(JointError) && alignof(IsletJointError) == alignof(JointError));
static_assert(offsetof(IsletJointError, linear) == offsetof(JointError, linear) && sizeof(IsletJointError::linear) == sizeof(JointError::linear));
static_assert(offsetof(IsletJointError, angular) == offsetof(JointError, angular) && sizeof(IsletJointError::angular) == sizeof(JointError::angular));
static_assert(sizeof(IsletJointBreakEvent) == sizeof(JointBreakEvent) && alignof(IsletJointBreakEvent) == alignof(JointBreakEvent));
static_assert(offsetof(IsletJointBreakEvent, joint) == offsetof(JointBreakEvent, joint) && sizeof(IsletJointBreakEvent::joint) == sizeof(JointBreakEvent::joint));
static_assert(offsetof(IsletJointBreakEvent, body_a) == offsetof(JointBreakEvent, body_a) && sizeof(IsletJointBreakEvent::body_a) == sizeof(JointBreakEvent::body_a));
static_assert(offsetof(IsletJointBreakEvent, body_b) == offsetof(JointBreakEvent, body_b) && sizeof(IsletJointBreakEvent::body_b) == sizeof(JointBreakEvent::body_b));
static_assert(offsetof(IsletJointBreakEvent, force) == offsetof(JointBreakEvent, force) && sizeof(IsletJointBreakEvent::force) == sizeof(JointBreakEvent::force));
static_assert(offsetof(IsletJointBreakEvent, torque) == offsetof(JointBreakEvent, torque) && sizeof(IsletJointBreakEvent::torque) == sizeof(JointBreakEvent::torque));
static_assert(offsetof(IsletJointBreakEvent, user_data) == offsetof(JointBreakEvent, user_data) && sizeof(IsletJointBreakEvent::user_data) == sizeof(JointBreakEvent::user_data));
static_assert(sizeof(IsletShapeProxy) == sizeof(ShapeProxy) && alignof(IsletShapeProxy) == alignof(ShapeProxy));
static_assert(offsetof(IsletShapeProxy, points) == offsetof(ShapeProxy, points) && sizeof(IsletShapeProxy::points) == sizeof(ShapeProxy::points));
static_assert(offsetof(IsletShapeProxy, count) == offsetof(ShapeProxy, count) && sizeof(IsletShapeProxy::count) == sizeof(ShapeProxy::count));
static_assert(offsetof(IsletShapeProxy, radius) == offsetof(ShapeProxy, radius) && sizeof(IsletShapeProxy::radius) == sizeof(ShapeProxy::radius));
static_assert(offsetof(IsletShapeProxy, one_sided) == offsetof(ShapeProxy, one_sided) && sizeof(IsletShapeProxy::one_sided) == sizeof(ShapeProxy::one_sided));
static_assert(sizeof(IsletCastHit) == sizeof(CastHit) && alignof(IsletCastHit) == alignof(CastHit));
static_assert(offsetof(IsletCastHit, hit) == offsetof(CastHit, hit) && sizeof(IsletCastHit::hit) == sizeof(CastHit::hit));
static_assert(offsetof(IsletCastHit, fraction) == offsetof(CastHit, fraction) && sizeof(IsletCastHit::fraction) == sizeof(CastHit::fraction));
static_assert(offsetof(IsletCastHit, point) == offsetof(CastHit, point) && sizeof(IsletCastHit::point) == sizeof(CastHit::point));
static_assert(offsetof(IsletCastHit, normal) == offsetof(CastHit, normal) && sizeof(IsletCastHit::normal) == sizeof(CastHit::normal));
static_assert(offsetof(IsletCastHit, separation) == offsetof(CastHit, separation) && sizeof(IsletCastHit::separation) == sizeof(CastHit::separation));
static_assert(sizeof(IsletSeparation) == sizeof(Separation) && alignof(IsletSeparation) == alignof(Separation));
static_assert(offsetof(IsletSeparation, distance) == offsetof(Separation, distance) && sizeof(IsletSeparation::distance) == sizeof(Separation::distance));
static_assert(offsetof(IsletSeparation, point_a) == offsetof(Separation, point_a) && sizeof(IsletSeparation::point_a) == sizeof(Separation::point_a));
static_assert(offsetof(IsletSeparation, point_b) == offsetof(Separation, point_b) && sizeof(IsletSeparation::point_b) == sizeof(Separation::point_b));
static_assert(offsetof(IsletSeparation, normal) == offsetof(Separation, normal) && sizeof(IsletSeparation::normal) == sizeof(Separation::normal));
static_assert(sizeof(IsletQueryFilter) == sizeof(QueryFilter) && alignof(IsletQueryFilter) == alignof(QueryFilter));
static_assert(offsetof(IsletQueryFilter, category) == offsetof(QueryFilter, category) && sizeof(IsletQueryFilter::category) == sizeof(QueryFilter::category));
static_assert(offsetof(IsletQueryFilter, mask) == offsetof(QueryFilter, mask) && sizeof(IsletQueryFilter::mask) == sizeof(QueryFilter::mask));
static_assert(offsetof(IsletQueryFilter, sensors) == offsetof(QueryFilter, sensors) && sizeof(IsletQueryFilter::sensors) == sizeof(QueryFilter::sensors));
static_assert(sizeof(IsletQueryHit) == sizeof(QueryHit) && alignof(IsletQueryHit) == alignof(QueryHit));
static_assert(offsetof(IsletQueryHit, shape) == offsetof(QueryHit, shape) && sizeof(IsletQueryHit::shape) == sizeof(QueryHit::shape));
static_assert(offsetof(IsletQueryHit, point) == offsetof(QueryHit, point) && sizeof(IsletQueryHit::point) == sizeof(QueryHit::point));
static_assert(offsetof(IsletQueryHit, normal) == offsetof(QueryHit, normal) && sizeof(IsletQueryHit::normal) == sizeof(QueryHit::normal));
static_assert(offsetof(IsletQueryHit, fraction) == offsetof(QueryHit, fraction) && sizeof(IsletQueryHit::fraction) == sizeof(QueryHit::fraction));
static_assert(offsetof(IsletQueryHit, separation) == offsetof(QueryHit, separation) && sizeof(IsletQueryHit::separation) == sizeof(QueryHit::separation));
static_assert(sizeof(IsletClosestHit) == sizeof(ClosestHit) && alignof(IsletClosestHit) == alignof(ClosestHit));
static_assert(offsetof(IsletClosestHit, shape) == offsetof(ClosestHit, shape) && sizeof(IsletClosestHit::shape) == sizeof(ClosestHit::shape));
static_assert(offsetof(IsletClosestHit, point) == offsetof(ClosestHit, point) && sizeof(IsletClosestHit::point) == sizeof(ClosestHit::point));
static_assert(offsetof(IsletClosestHit, normal) == offsetof(ClosestHit, normal) && sizeof(IsletClosestHit::normal) == sizeof(ClosestHit::normal));
static_assert(offsetof(IsletClosestHit, distance) == offsetof(ClosestHit, distance) && sizeof(IsletClosestHit::distance) == sizeof(ClosestHit::distance));
static_assert(sizeof(IsletSurface) == sizeof(Surface) && alignof(IsletSurface) == alignof(Surface));
static_assert(offsetof(IsletSurface, shape) == offsetof(Surface, shape) && sizeof(IsletSurface::shape) == sizeof(Surface::shape));
static_assert(offsetof(IsletSurface, point) == offsetof(Surface, point) && sizeof(IsletSurface::point) == sizeof(Surface::point));
static_assert(offsetof(IsletSurface, normal) == offsetof(Surface, normal) && sizeof(IsletSurface::normal) == sizeof(Surface::normal));
static_assert(offsetof(IsletSurface, separation) == offsetof(Surface, separation) && sizeof(IsletSurface::separation) == sizeof(Surface::separation));
static_assert(sizeof(IsletReplayResult) == sizeof(ReplayResult) + start_of<ReplayResult> && start_of<ReplayResult> == offsetof(IsletReplayResult, end));
static_assert(offsetof(IsletReplayResult, end) == offsetof(ReplayResult, end) + start_of<ReplayResult> && sizeof(IsletReplayResult::end) == sizeof(ReplayResult::end));
static_assert(offsetof(IsletReplayResult, error) == offsetof(ReplayResult, error) + start_of<ReplayResult> && sizeof(IsletReplayResult::error) == sizeof(ReplayResult::error));
static_assert(offsetof(IsletReplayResult, steps) == offsetof(ReplayResult, steps) + start_of<ReplayResult> && sizeof(IsletReplayResult::steps) == sizeof(ReplayResult::steps));
static_assert(offsetof(IsletReplayResult, recorded_hash) == offsetof(ReplayResult, recorded_hash) + start_of<ReplayResult> && sizeof(IsletReplayResult::recorded_hash) == sizeof(ReplayResult::recorded_hash));
static_assert(offsetof(IsletReplayResult, hash) == offsetof(ReplayResult, hash) + start_of<ReplayResult> && sizeof(IsletReplayResult::hash) == sizeof(ReplayResult::hash));
static_assert(offsetof(IsletReplayResult, body) == offsetof(ReplayResult, body) + start_of<ReplayResult> && sizeof(IsletReplayResult::body) == sizeof(ReplayResult::body));
static_assert(sizeof(IsletMoverDef) == sizeof(MoverDef) + start_of<MoverDef> && start_of<MoverDef> == offsetof(IsletMoverDef, capsule));
static_assert(offsetof(IsletMoverDef, capsule) == offsetof(MoverDef, capsule) + start_of<MoverDef> && sizeof(IsletMoverDef::capsule) == sizeof(MoverDef::capsule));
static_assert(offsetof(IsletMoverDef, up) == offsetof(MoverDef, up) + start_of<MoverDef> && sizeof(IsletMoverDef::up) == sizeof(MoverDef::up));
static_assert(offsetof(IsletMoverDef, gravity_scale) == offsetof(MoverDef, gravity_scale) + start_of<MoverDef> && sizeof(IsletMoverDef::gravity_scale) == sizeof(MoverDef::gravity_scale));
static_assert(offsetof(IsletMoverDef, max_slope) == offsetof(MoverDef, max_slope) + start_of<MoverDef> && sizeof(IsletMoverDef::max_slope) == sizeof(MoverDef::max_slope));
static_assert(offsetof(IsletMoverDef, step_height) == offsetof(MoverDef, step_height) + start_of<MoverDef> && sizeof(IsletMoverDef::step_height) == sizeof(MoverDef::step_height));
static_assert(offsetof(IsletMoverDef, snap_distance) == offsetof(MoverDef, snap_distance) + start_of<MoverDef> && sizeof(IsletMoverDef::snap_distance) == sizeof(MoverDef::snap_distance));
static_assert(offsetof(IsletMoverDef, ground_acceleration) == offsetof(MoverDef, ground_acceleration) + start_of<MoverDef> && sizeof(IsletMoverDef::ground_acceleration) == sizeof(MoverDef::ground_acceleration));
static_assert(offsetof(IsletMoverDef, air_acceleration) == offsetof(MoverDef, air_acceleration) + start_of<MoverDef> && sizeof(IsletMoverDef::air_acceleration) == sizeof(MoverDef::air_acceleration));
static_assert(offsetof(IsletMoverDef, mass) == offsetof(MoverDef, mass) + start_of<MoverDef> && sizeof(IsletMoverDef::mass) == sizeof(MoverDef::mass));
static_assert(offsetof(IsletMoverDef, max_push_force) == offsetof(MoverDef, max_push_force) + start_of<MoverDef> && sizeof(IsletMoverDef::max_push_force) == sizeof(MoverDef::max_push_force));
static_assert(offsetof(IsletMoverDef, filter) == offsetof(MoverDef, filter) + start_of<MoverDef> && sizeof(IsletMoverDef::filter) == sizeof(MoverDef::filter));
static_assert(offsetof(IsletMoverDef, collides) == offsetof(MoverDef, collides) + start_of<MoverDef> && sizeof(IsletMoverDef::collides) == sizeof(MoverDef::collides));
static_assert(offsetof(IsletMoverDef, context) == offsetof(MoverDef, context) + start_of<MoverDef> && sizeof(IsletMoverDef::context) == sizeof(MoverDef::context));
static_assert(sizeof(IsletMoverState) == sizeof(MoverState) && alignof(IsletMoverState) == alignof(MoverState));
static_assert(offsetof(IsletMoverState, position) == offsetof(MoverState, position) && sizeof(IsletMoverState::position) == sizeof(MoverState::position));
static_assert(offsetof(IsletMoverState, velocity) == offsetof(MoverState, velocity) && sizeof(IsletMoverState::velocity) == sizeof(MoverState::velocity));
static_assert(offsetof(IsletMoverState, ground) == offsetof(MoverState, ground) && sizeof(IsletMoverState::ground) == sizeof(MoverState::ground));
static_assert(offsetof(IsletMoverState, ground_normal) == offsetof(MoverState, ground_normal) && sizeof(IsletMoverState::ground_normal) == sizeof(MoverState::ground_normal));
static_assert(offsetof(IsletMoverState, ground_point) == offsetof(MoverState, ground_point) && sizeof(IsletMoverState::ground_point) == sizeof(MoverState::ground_point));
static_assert(offsetof(IsletMoverState, squeezed) == offsetof(MoverState, squeezed) && sizeof(IsletMoverState::squeezed) == sizeof(MoverState::squeezed));
static_assert(sizeof(IsletMoverInput) == sizeof(MoverInput) + start_of<MoverInput> && start_of<MoverInput> == offsetof(IsletMoverInput, walk));
static_assert(offsetof(IsletMoverInput, walk) == offsetof(MoverInput, walk) + start_of<MoverInput> && sizeof(IsletMoverInput::walk) == sizeof(MoverInput::walk));
static_assert(offsetof(IsletMoverInput, jump) == offsetof(MoverInput, jump) + start_of<MoverInput> && sizeof(IsletMoverInput::jump) == sizeof(MoverInput::jump));
static_assert(ISLET_PI == pi);
static_assert(ISLET_MAX_POLYGON_VERTICES == max_polygon_vertices);
static_assert(ISLET_DRAW_COLOR_STATIC_BODY == draw_color::static_body);
static_assert(ISLET_DRAW_COLOR_KINEMATIC == draw_color::kinematic);
static_assert(ISLET_DRAW_COLOR_AWAKE == draw_color::awake);
static_assert(ISLET_DRAW_COLOR_ASLEEP == draw_color::asleep);
static_assert(ISLET_DRAW_COLOR_BULLET == draw_color::bullet);
static_assert(ISLET_DRAW_COLOR_DISABLED == draw_color::disabled);
static_assert(ISLET_DRAW_COLOR_SENSOR == draw_color::sensor);
static_assert(ISLET_DRAW_COLOR_JOINT == draw_color::joint);
static_assert(ISLET_DRAW_COLOR_IDLE_JOINT == draw_color::idle_joint);
static_assert(ISLET_DRAW_COLOR_LIMIT == draw_color::limit);
static_assert(ISLET_DRAW_COLOR_PRESSING == draw_color::pressing);
static_assert(ISLET_DRAW_COLOR_TOUCHING == draw_color::touching);
static_assert(ISLET_DRAW_COLOR_SPECULATIVE == draw_color::speculative);
static_assert(ISLET_DRAW_COLOR_NORMAL == draw_color::normal);
static_assert(ISLET_DRAW_COLOR_NORMAL_IMPULSE == draw_color::normal_impulse);
static_assert(ISLET_DRAW_COLOR_FRICTION_IMPULSE == draw_color::friction_impulse);
static_assert(ISLET_DRAW_COLOR_BOX == draw_color::box);
static_assert(ISLET_DRAW_COLOR_FAT_BOX == draw_color::fat_box);
static_assert(ISLET_DRAW_COLOR_TREE_BOX == draw_color::tree_box);
static_assert(ISLET_DRAW_COLOR_CENTER == draw_color::center);
static_assert(ISLET_DRAW_COLOR_X_AXIS == draw_color::x_axis);
static_assert(ISLET_DRAW_COLOR_Y_AXIS == draw_color::y_axis);
static_assert(ISLET_DRAW_COLOR_NAME == draw_color::name);
static_assert(ISLET_DRAW_COLOR_OVERFLOW == draw_color::overflow);
static_assert(ISLET_SNAPSHOT_FORMAT == snapshot_format);
static_assert(ISLET_DELTA_FORMAT == delta_format);
static_assert(ISLET_RECORDING_FORMAT == recording_format);
static_assert(ISLET_MAX_WORKERS == max_workers);
static_assert(ISLET_MAX_POSITION == max_position);
static_assert(ISLET_MAX_COEFFICIENT == max_coefficient);
static_assert(ISLET_MAX_SPEED_LIMIT == max_speed_limit);
static_assert(ISLET_MIN_TIME_STEP == min_time_step);
static_assert(ISLET_MAX_SHOCK == max_shock);
static_assert(ISLET_CONSTRAINT_COLOR_COUNT == constraint_color_count);
static_assert(ISLET_NO_BODY == no_body);
static_assert(ISLET_JOINT_TYPE_COUNT == joint_type_count);
static_assert(ISLET_MAX_RATIO == max_ratio);
static_assert(ISLET_WORLD_ALIGNMENT == world_alignment);
static_assert(ISLET_MAX_CAPACITY == max_capacity);
static_assert(ISLET_MAX_TRANSLATION == max_translation);
static_assert(ISLET_RECORDING_ALIGNMENT == recording_alignment);
static_assert(ISLET_SNAPSHOT_ALIGNMENT == snapshot_alignment);
static_assert(ISLET_MOVER_GAP == mover_gap);

}  // namespace islet::c

using namespace islet;
using namespace islet::c;

extern "C" {

IsletVec2 islet_vec2_add(IsletVec2 a, IsletVec2 b) {
    return out(in<Vec2>(a) + in<Vec2>(b));
}

IsletVec2 islet_vec2_subtract(IsletVec2 a, IsletVec2 b) {
    return out(in<Vec2>(a) - in<Vec2>(b));
}

IsletVec2 islet_vec2_negate(IsletVec2 a) {
    return out(-in<Vec2>(a));
}

IsletVec2 islet_vec2_scale(float s, IsletVec2 a) {
    return out(s * in<Vec2>(a));
}

float islet_vec2_dot(IsletVec2 a, IsletVec2 b) {
    return islet::dot(in<Vec2>(a), in<Vec2>(b));
}

float islet_vec2_cross(IsletVec2 a, IsletVec2 b) {
    return islet::cross(in<Vec2>(a), in<Vec2>(b));
}

IsletVec2 islet_vec2_cross_rate(float w, IsletVec2 r) {
    return out(islet::cross(w, in<Vec2>(r)));
}

IsletVec2 islet_vec2_left_perp(IsletVec2 a) {
    return out(islet::left_perp(in<Vec2>(a)));
}

IsletVec2 islet_vec2_right_perp(IsletVec2 a) {
    return out(islet::right_perp(in<Vec2>(a)));
}

float islet_vec2_length_squared(IsletVec2 a) {
    return islet::length_squared(in<Vec2>(a));
}

float islet_vec2_distance_squared(IsletVec2 a, IsletVec2 b) {
    return islet::distance_squared(in<Vec2>(a), in<Vec2>(b));
}

IsletVec2 islet_vec2_lerp(IsletVec2 a, IsletVec2 b, float t) {
    return out(islet::lerp(in<Vec2>(a), in<Vec2>(b), t));
}

IsletVec2 islet_vec2_min(IsletVec2 a, IsletVec2 b) {
    return out(islet::min(in<Vec2>(a), in<Vec2>(b)));
}

IsletVec2 islet_vec2_max(IsletVec2 a, IsletVec2 b) {
    return out(islet::max(in<Vec2>(a), in<Vec2>(b)));
}

IsletVec2 islet_rot_rotate(IsletRot q, IsletVec2 v) {
    return out(islet::rotate(in<Rot>(q), in<Vec2>(v)));
}

IsletVec2 islet_rot_inv_rotate(IsletRot q, IsletVec2 v) {
    return out(islet::inv_rotate(in<Rot>(q), in<Vec2>(v)));
}

IsletRot islet_rot_multiply(IsletRot q, IsletRot r) {
    return out(in<Rot>(q) * in<Rot>(r));
}

IsletRot islet_rot_inverse(IsletRot q) {
    return out(islet::inverse(in<Rot>(q)));
}

IsletRot islet_rot_inv_mul(IsletRot q, IsletRot r) {
    return out(islet::inv_mul(in<Rot>(q), in<Rot>(r)));
}

IsletVec2 islet_transform_point(IsletTransform t, IsletVec2 v) {
    return out(islet::transform_point(in<Transform>(t), in<Vec2>(v)));
}

IsletVec2 islet_inv_transform_point(IsletTransform t, IsletVec2 v) {
    return out(islet::inv_transform_point(in<Transform>(t), in<Vec2>(v)));
}

IsletTransform islet_transform_inv_mul(IsletTransform a, IsletTransform b) {
    return out(islet::inv_mul(in<Transform>(a), in<Transform>(b)));
}

bool islet_aabb_overlaps(IsletAabb a, IsletAabb b) {
    return islet::overlaps(in<Aabb>(a), in<Aabb>(b));
}

bool islet_aabb_contains(IsletAabb outer, IsletAabb inner) {
    return islet::contains(in<Aabb>(outer), in<Aabb>(inner));
}

IsletAabb islet_aabb_merge(IsletAabb a, IsletAabb b) {
    return out(islet::merge(in<Aabb>(a), in<Aabb>(b)));
}

IsletAabb islet_aabb_expand(IsletAabb a, float margin) {
    return out(islet::expand(in<Aabb>(a), margin));
}

float islet_aabb_perimeter(IsletAabb a) {
    return islet::perimeter(in<Aabb>(a));
}

bool islet_vec2_is_finite(IsletVec2 a) {
    return islet::is_finite(in<Vec2>(a));
}

float islet_vec2_length(IsletVec2 a) {
    return islet::length(in<Vec2>(a));
}

float islet_vec2_distance(IsletVec2 a, IsletVec2 b) {
    return islet::distance(in<Vec2>(a), in<Vec2>(b));
}

IsletVec2 islet_vec2_normalize(IsletVec2 a) {
    return out(islet::normalize(in<Vec2>(a)));
}

IsletRot islet_make_rot(float radians) {
    return out(islet::make_rot(radians));
}

float islet_rot_angle(IsletRot q) {
    return islet::angle_of(in<Rot>(q));
}

float islet_atan2(float y, float x) {
    return islet::atan2(y, x);
}

IsletRot islet_rot_normalize(IsletRot q) {
    return out(islet::normalize(in<Rot>(q)));
}

IsletRot islet_rot_integrate(IsletRot q, float delta_radians) {
    return out(islet::integrate(in<Rot>(q), delta_radians));
}

IsletHull islet_compute_hull(const IsletVec2* points, size_t points_count) {
    if (points == nullptr && points_count != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(Hull{});
    return out(islet::compute_hull(span_of<const Vec2>(points, points_count)));
}

IsletPolygon islet_make_polygon(const IsletHull* hull, float radius) {
    if (hull == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(Polygon{});
    return out(islet::make_polygon(*cast<const Hull>(hull), radius));
}

IsletPolygon islet_make_box(float hx, float hy) {
    return out(islet::make_box(hx, hy));
}

IsletPolygon islet_make_rounded_box(float hx, float hy, float radius) {
    return out(islet::make_rounded_box(hx, hy, radius));
}

IsletPolygon islet_make_offset_box(float hx, float hy, IsletTransform pose, float radius) {
    return out(islet::make_offset_box(hx, hy, in<Transform>(pose), radius));
}

IsletPolygon islet_transform_polygon(IsletTransform t, const IsletPolygon* p) {
    if (p == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(Polygon{});
    return out(islet::transform_polygon(in<Transform>(t), *cast<const Polygon>(p)));
}

bool islet_circle_is_valid(const IsletCircle* c) {
    if (c == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), false;
    return islet::is_valid(*cast<const Circle>(c));
}

bool islet_capsule_is_valid(const IsletCapsule* c) {
    if (c == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), false;
    return islet::is_valid(*cast<const Capsule>(c));
}

bool islet_segment_is_valid(const IsletSegment* s) {
    if (s == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), false;
    return islet::is_valid(*cast<const Segment>(s));
}

bool islet_chain_segment_is_valid(const IsletChainSegment* s) {
    if (s == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), false;
    return islet::is_valid(*cast<const ChainSegment>(s));
}

bool islet_half_space_is_valid(const IsletHalfSpace* h) {
    if (h == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), false;
    return islet::is_valid(*cast<const HalfSpace>(h));
}

bool islet_polygon_is_valid(const IsletPolygon* p) {
    if (p == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), false;
    return islet::is_valid(*cast<const Polygon>(p));
}

IsletMassData islet_circle_compute_mass(const IsletCircle* c, float density) {
    if (c == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(MassData{});
    return out(islet::compute_mass(*cast<const Circle>(c), density));
}

IsletMassData islet_capsule_compute_mass(const IsletCapsule* c, float density) {
    if (c == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(MassData{});
    return out(islet::compute_mass(*cast<const Capsule>(c), density));
}

IsletMassData islet_polygon_compute_mass(const IsletPolygon* p, float density) {
    if (p == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(MassData{});
    return out(islet::compute_mass(*cast<const Polygon>(p), density));
}

IsletAabb islet_circle_compute_aabb(const IsletCircle* c, IsletTransform t) {
    if (c == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(Aabb{});
    return out(islet::compute_aabb(*cast<const Circle>(c), in<Transform>(t)));
}

IsletAabb islet_capsule_compute_aabb(const IsletCapsule* c, IsletTransform t) {
    if (c == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(Aabb{});
    return out(islet::compute_aabb(*cast<const Capsule>(c), in<Transform>(t)));
}

IsletAabb islet_segment_compute_aabb(const IsletSegment* s, IsletTransform t) {
    if (s == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(Aabb{});
    return out(islet::compute_aabb(*cast<const Segment>(s), in<Transform>(t)));
}

IsletAabb islet_polygon_compute_aabb(const IsletPolygon* p, IsletTransform t) {
    if (p == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(Aabb{});
    return out(islet::compute_aabb(*cast<const Polygon>(p), in<Transform>(t)));
}

IsletDrawColor islet_distinct_color(uint32_t n) {
    return islet::distinct_color(n);
}

void islet_draw_circle(const IsletDebugDraw* draw, const IsletCircle* circle, IsletTransform pose, const IsletDrawStyle* style) {
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = take<DebugDraw>(nullptr, draw, draw_room);
    if (draw_taken == nullptr) return;
    const Drawing drawing(*draw_taken);
    if (circle == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), void();
    if (style == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), void();
    islet::draw_shape(drawing.functions, *cast<const Circle>(circle), in<Transform>(pose), *cast<const DrawStyle>(style));
}

void islet_draw_capsule(const IsletDebugDraw* draw, const IsletCapsule* capsule, IsletTransform pose, const IsletDrawStyle* style) {
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = take<DebugDraw>(nullptr, draw, draw_room);
    if (draw_taken == nullptr) return;
    const Drawing drawing(*draw_taken);
    if (capsule == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), void();
    if (style == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), void();
    islet::draw_shape(drawing.functions, *cast<const Capsule>(capsule), in<Transform>(pose), *cast<const DrawStyle>(style));
}

void islet_draw_segment(const IsletDebugDraw* draw, const IsletSegment* segment, IsletTransform pose, const IsletDrawStyle* style) {
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = take<DebugDraw>(nullptr, draw, draw_room);
    if (draw_taken == nullptr) return;
    const Drawing drawing(*draw_taken);
    if (segment == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), void();
    if (style == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), void();
    islet::draw_shape(drawing.functions, *cast<const Segment>(segment), in<Transform>(pose), *cast<const DrawStyle>(style));
}

void islet_draw_polygon(const IsletDebugDraw* draw, const IsletPolygon* polygon, IsletTransform pose, const IsletDrawStyle* style) {
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = take<DebugDraw>(nullptr, draw, draw_room);
    if (draw_taken == nullptr) return;
    const Drawing drawing(*draw_taken);
    if (polygon == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), void();
    if (style == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), void();
    islet::draw_shape(drawing.functions, *cast<const Polygon>(polygon), in<Transform>(pose), *cast<const DrawStyle>(style));
}

IsletError islet_read_format(const void* bytes, size_t bytes_bytes, IsletFormatInfo* out) {
    if (bytes == nullptr && bytes_bytes != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER);
    if (!fits<FormatInfo>(nullptr, out)) return why(out);
    give<FormatInfo>(out, islet::read_format(span_of<const std::byte>(bytes, bytes_bytes)));
    return ISLET_ERROR_NONE;
}

size_t islet_describe_format(const IsletFormatInfo* info, char* out, size_t out_bytes) {
    Room<FormatInfo> info_room;
    const FormatInfo* info_taken = take<FormatInfo>(nullptr, info, info_room);
    if (info_taken == nullptr) return 0;
    if (out == nullptr && out_bytes != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), 0;
    return islet::describe_format(*info_taken, span_of<char>(out, out_bytes));
}

bool islet_capacity_is_valid(const IsletCapacity* c) {
    Room<Capacity> c_room;
    const Capacity* c_taken = take<Capacity>(nullptr, c, c_room);
    if (c_taken == nullptr) return false;
    return islet::is_valid(*c_taken);
}

size_t islet_world_bytes(const IsletCapacity* capacity) {
    Room<Capacity> capacity_room;
    const Capacity* capacity_taken = take<Capacity>(nullptr, capacity, capacity_room);
    if (capacity_taken == nullptr) return 0;
    return islet::world_bytes(*capacity_taken);
}

IsletShapeProxy islet_make_circle_proxy(const IsletCircle* circle) {
    if (circle == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(ShapeProxy{});
    return out(islet::make_proxy(*cast<const Circle>(circle)));
}

IsletShapeProxy islet_make_capsule_proxy(const IsletCapsule* capsule) {
    if (capsule == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(ShapeProxy{});
    return out(islet::make_proxy(*cast<const Capsule>(capsule)));
}

IsletShapeProxy islet_make_segment_proxy(const IsletSegment* segment) {
    if (segment == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(ShapeProxy{});
    return out(islet::make_proxy(*cast<const Segment>(segment)));
}

IsletShapeProxy islet_make_polygon_proxy(const IsletPolygon* polygon) {
    if (polygon == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(ShapeProxy{});
    return out(islet::make_proxy(*cast<const Polygon>(polygon)));
}

IsletShapeProxy islet_make_chain_segment_proxy(const IsletChainSegment* segment) {
    if (segment == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(ShapeProxy{});
    return out(islet::make_proxy(*cast<const ChainSegment>(segment)));
}

IsletShapeProxy islet_make_proxy(const IsletVec2* points, size_t points_count, float radius) {
    if (points == nullptr && points_count != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(ShapeProxy{});
    return out(islet::make_proxy(span_of<const Vec2>(points, points_count), radius));
}

IsletShapeProxy islet_make_box_proxy(IsletAabb box) {
    return out(islet::make_proxy(in<Aabb>(box)));
}

IsletShapeProxy islet_transform_proxy(IsletTransform t, const IsletShapeProxy* p) {
    if (p == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(ShapeProxy{});
    return out(islet::transform_proxy(in<Transform>(t), *cast<const ShapeProxy>(p)));
}

bool islet_proxy_is_valid(const IsletShapeProxy* p) {
    if (p == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), false;
    return islet::is_valid(*cast<const ShapeProxy>(p));
}

IsletCastHit islet_cast_ray(const IsletShapeProxy* target, IsletVec2 origin, IsletVec2 translation) {
    if (target == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(CastHit{});
    return out(islet::cast_ray(*cast<const ShapeProxy>(target), in<Vec2>(origin), in<Vec2>(translation)));
}

IsletCastHit islet_cast_shape(const IsletShapeProxy* moving, IsletVec2 translation, const IsletShapeProxy* target) {
    if (moving == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(CastHit{});
    if (target == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), out(CastHit{});
    return out(islet::cast_shape(*cast<const ShapeProxy>(moving), in<Vec2>(translation), *cast<const ShapeProxy>(target)));
}

bool islet_proxy_overlaps(const IsletShapeProxy* a, const IsletShapeProxy* b) {
    if (a == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), false;
    if (b == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), false;
    return islet::overlaps(*cast<const ShapeProxy>(a), *cast<const ShapeProxy>(b));
}

bool islet_proxy_contains(const IsletShapeProxy* shape, IsletVec2 point) {
    if (shape == nullptr) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), false;
    return islet::contains(*cast<const ShapeProxy>(shape), in<Vec2>(point));
}

IsletError islet_replay(IsletWorld* world, const void* recording, size_t recording_bytes, uint64_t steps, IsletReplayResult* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (recording == nullptr && recording_bytes != 0) return refuse(world, ISLET_ERROR_NULL_POINTER);
    if (!fits<ReplayResult>(world, out)) return why(out);
    give<ReplayResult>(out, islet::replay(of(world), span_of<const std::byte>(recording, recording_bytes), steps));
    return ISLET_ERROR_NONE;
}

size_t islet_max_snapshot_bytes(const IsletCapacity* capacity) {
    Room<Capacity> capacity_room;
    const Capacity* capacity_taken = take<Capacity>(nullptr, capacity, capacity_room);
    if (capacity_taken == nullptr) return 0;
    return islet::max_snapshot_bytes(*capacity_taken);
}

size_t islet_max_delta_bytes(size_t to_bytes) {
    return islet::max_delta_bytes(to_bytes);
}

size_t islet_delta(const void* from, size_t from_bytes, const void* to, size_t to_bytes, void* out, size_t out_bytes, IsletError* error) {
    if (from == nullptr && from_bytes != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), 0;
    if (to == nullptr && to_bytes != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), 0;
    if (out == nullptr && out_bytes != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), 0;
    return islet::delta(span_of<const std::byte>(from, from_bytes), span_of<const std::byte>(to, to_bytes), span_of<std::byte>(out, out_bytes), cast<Error>(error));
}

size_t islet_apply(const void* from, size_t from_bytes, const void* delta, size_t delta_bytes, void* out, size_t out_bytes, IsletError* error) {
    if (from == nullptr && from_bytes != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), 0;
    if (delta == nullptr && delta_bytes != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), 0;
    if (out == nullptr && out_bytes != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), 0;
    return islet::apply(span_of<const std::byte>(from, from_bytes), span_of<const std::byte>(delta, delta_bytes), span_of<std::byte>(out, out_bytes), cast<Error>(error));
}

IsletError islet_world_step(IsletWorld* world, float dt) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).step(dt);
    return end(world, before);
}

IsletVec2 islet_world_gravity(const IsletWorld* world) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).gravity());
}

IsletError islet_world_set_gravity(IsletWorld* world, IsletVec2 gravity) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_gravity(in<Vec2>(gravity));
    return end(world, before);
}

IsletError islet_world_solver(const IsletWorld* world, IsletSolverDef* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<SolverDef>(world, out)) return why(out);
    give<SolverDef>(out, of(world).solver());
    return ISLET_ERROR_NONE;
}

IsletError islet_world_set_solver(IsletWorld* world, const IsletSolverDef* solver) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    Room<SolverDef> solver_room;
    const SolverDef* solver_taken = take<SolverDef>(world, solver, solver_room);
    if (solver_taken == nullptr) return why(solver);
    const Error before = begin(world);
    of(world).set_solver(*solver_taken);
    return end(world, before);
}

float islet_body_residual(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).residual(in<BodyId>(body));
}

IsletError islet_world_tasks(const IsletWorld* world, IsletTaskSystem* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<TaskSystem>(world, out)) return why(out);
    give<TaskSystem>(out, of(world).tasks());
    return ISLET_ERROR_NONE;
}

IsletError islet_world_set_tasks(IsletWorld* world, const IsletTaskSystem* tasks) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    Room<TaskSystem> tasks_room;
    const TaskSystem* tasks_taken = take<TaskSystem>(world, tasks, tasks_room);
    if (tasks_taken == nullptr) return why(tasks);
    const Error before = begin(world);
    of(world).set_tasks(*tasks_taken);
    return end(world, before);
}

IsletError islet_world_profile(const IsletWorld* world, IsletStepProfile* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<StepProfile>(world, out)) return why(out);
    give<StepProfile>(out, of(world).profile());
    return ISLET_ERROR_NONE;
}

IsletError islet_world_set_clock(IsletWorld* world, IsletClock clock, void* context) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_clock(function<Clock>(clock), context);
    return end(world, before);
}

IsletError islet_world_counters(const IsletWorld* world, IsletWorldCounters* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<WorldCounters>(world, out)) return why(out);
    give<WorldCounters>(out, of(world).counters());
    return ISLET_ERROR_NONE;
}

IsletError islet_world_enable_sleep(IsletWorld* world, bool enable) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).enable_sleep(enable);
    return end(world, before);
}

bool islet_world_continuous(const IsletWorld* world) {
    if (world == nullptr) return false;
    return of(world).continuous();
}

IsletError islet_world_enable_continuous(IsletWorld* world, bool enable) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).enable_continuous(enable);
    return end(world, before);
}

IsletError islet_world_hooks(const IsletWorld* world, IsletHooks* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<Hooks>(world, out)) return why(out);
    give<Hooks>(out, of(world).hooks());
    return ISLET_ERROR_NONE;
}

IsletError islet_world_set_hooks(IsletWorld* world, const IsletHooks* hooks) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    Room<Hooks> hooks_room;
    const Hooks* hooks_taken = take<Hooks>(world, hooks, hooks_room);
    if (hooks_taken == nullptr) return why(hooks);
    const Error before = begin(world);
    of(world).set_hooks(*hooks_taken);
    return end(world, before);
}

float islet_world_hit_threshold(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).hit_threshold();
}

IsletError islet_world_set_hit_threshold(IsletWorld* world, float speed) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_hit_threshold(speed);
    return end(world, before);
}

IsletError islet_world_explode(IsletWorld* world, const IsletExplosionDef* explosion) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    Room<ExplosionDef> explosion_room;
    const ExplosionDef* explosion_taken = take<ExplosionDef>(world, explosion, explosion_room);
    if (explosion_taken == nullptr) return why(explosion);
    const Error before = begin(world);
    of(world).explode(*explosion_taken);
    return end(world, before);
}

IsletError islet_world_capacity(const IsletWorld* world, IsletCapacity* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<Capacity>(world, out)) return why(out);
    give<Capacity>(out, of(world).capacity());
    return ISLET_ERROR_NONE;
}

IsletError islet_world_report(const IsletWorld* world, IsletStepReport* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<StepReport>(world, out)) return why(out);
    give<StepReport>(out, of(world).report());
    return ISLET_ERROR_NONE;
}

uint64_t islet_world_hash(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).hash();
}

uint64_t islet_world_step_count(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).step_count();
}

const char* islet_world_validate(const IsletWorld* world) {
    if (world == nullptr) return nullptr;
    return of(world).validate();
}

size_t islet_world_snapshot_bytes(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).snapshot_bytes();
}

size_t islet_world_save(const IsletWorld* world, void* out, size_t out_bytes) {
    if (world == nullptr) return 0;
    if (out == nullptr && out_bytes != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).save(span_of<std::byte>(out, out_bytes));
}

bool islet_world_restore(IsletWorld* world, const void* image, size_t image_bytes) {
    if (world == nullptr) return false;
    if (image == nullptr && image_bytes != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), false;
    return of(world).restore(span_of<const std::byte>(image, image_bytes));
}

bool islet_world_load(IsletWorld* world, const void* image, size_t image_bytes) {
    if (world == nullptr) return false;
    if (image == nullptr && image_bytes != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), false;
    return of(world).load(span_of<const std::byte>(image, image_bytes));
}

bool islet_world_start_recording(IsletWorld* world, void* buffer, size_t buffer_bytes, bool bodies) {
    if (world == nullptr) return false;
    if (buffer == nullptr && buffer_bytes != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), false;
    return of(world).start_recording(span_of<std::byte>(buffer, buffer_bytes), bodies);
}

bool islet_world_is_recording(const IsletWorld* world) {
    if (world == nullptr) return false;
    return of(world).is_recording();
}

size_t islet_world_recorded_bytes(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).recorded_bytes();
}

bool islet_world_move_recording(IsletWorld* world, void* buffer, size_t buffer_bytes) {
    if (world == nullptr) return false;
    if (buffer == nullptr && buffer_bytes != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), false;
    return of(world).move_recording(span_of<std::byte>(buffer, buffer_bytes));
}

size_t islet_world_stop_recording(IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).stop_recording();
}

IsletTouchEventSpan islet_world_begin_touch_events(const IsletWorld* world) {
    if (world == nullptr) return {};
    const auto found = of(world).begin_touch_events();
    return {cast<const IsletTouchEvent>(found.data()), found.size()};
}

IsletTouchEventSpan islet_world_end_touch_events(const IsletWorld* world) {
    if (world == nullptr) return {};
    const auto found = of(world).end_touch_events();
    return {cast<const IsletTouchEvent>(found.data()), found.size()};
}

IsletSensorEventSpan islet_world_sensor_begin_events(const IsletWorld* world) {
    if (world == nullptr) return {};
    const auto found = of(world).sensor_begin_events();
    return {cast<const IsletSensorEvent>(found.data()), found.size()};
}

IsletSensorEventSpan islet_world_sensor_end_events(const IsletWorld* world) {
    if (world == nullptr) return {};
    const auto found = of(world).sensor_end_events();
    return {cast<const IsletSensorEvent>(found.data()), found.size()};
}

IsletHitEventSpan islet_world_hit_events(const IsletWorld* world) {
    if (world == nullptr) return {};
    const auto found = of(world).hit_events();
    return {cast<const IsletHitEvent>(found.data()), found.size()};
}

IsletBodyIdSpan islet_world_moved_bodies(const IsletWorld* world) {
    if (world == nullptr) return {};
    const auto found = of(world).moved_bodies();
    return {cast<const IsletBodyId>(found.data()), found.size()};
}

IsletBodyIdSpan islet_world_slept_bodies(const IsletWorld* world) {
    if (world == nullptr) return {};
    const auto found = of(world).slept_bodies();
    return {cast<const IsletBodyId>(found.data()), found.size()};
}

IsletJointBreakEventSpan islet_world_broken_joints(const IsletWorld* world) {
    if (world == nullptr) return {};
    const auto found = of(world).broken_joints();
    return {cast<const IsletJointBreakEvent>(found.data()), found.size()};
}

IsletBodyId islet_create_body(IsletWorld* world, const IsletBodyDef* def) {
    if (world == nullptr) return out(BodyId{});
    Room<BodyDef> def_room;
    const BodyDef* def_taken = take<BodyDef>(world, def, def_room);
    if (def_taken == nullptr) return out(BodyId{});
    return out(of(world).create_body(*def_taken));
}

IsletError islet_destroy_body(IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).destroy_body(in<BodyId>(body));
    return end(world, before);
}

bool islet_body_is_valid(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return false;
    return of(world).is_valid(in<BodyId>(body));
}

uint32_t islet_world_body_count(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).body_count();
}

IsletBodyId islet_world_body_at(const IsletWorld* world, uint32_t slot) {
    if (world == nullptr) return out(BodyId{});
    return out(of(world).body_at(slot));
}

IsletTransform islet_body_transform(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return out(Transform{});
    return out(of(world).transform(in<BodyId>(body)));
}

IsletVec2 islet_body_position(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).position(in<BodyId>(body)));
}

float islet_body_angle(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).angle(in<BodyId>(body));
}

IsletVec2 islet_body_center_of_mass(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).center_of_mass(in<BodyId>(body)));
}

IsletVec2 islet_body_local_center_of_mass(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).local_center_of_mass(in<BodyId>(body)));
}

IsletVec2 islet_body_linear_velocity(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).linear_velocity(in<BodyId>(body)));
}

float islet_body_angular_velocity(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).angular_velocity(in<BodyId>(body));
}

IsletVec2 islet_body_velocity_at(const IsletWorld* world, IsletBodyId body, IsletVec2 point) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).velocity_at(in<BodyId>(body), in<Vec2>(point)));
}

IsletError islet_body_set_transform(IsletWorld* world, IsletBodyId body, IsletVec2 position, float angle) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_transform(in<BodyId>(body), in<Vec2>(position), angle);
    return end(world, before);
}

IsletError islet_body_set_linear_velocity(IsletWorld* world, IsletBodyId body, IsletVec2 velocity) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_linear_velocity(in<BodyId>(body), in<Vec2>(velocity));
    return end(world, before);
}

IsletError islet_body_set_angular_velocity(IsletWorld* world, IsletBodyId body, float velocity) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_angular_velocity(in<BodyId>(body), velocity);
    return end(world, before);
}

IsletError islet_body_set_target(IsletWorld* world, IsletBodyId body, IsletTransform target, float dt) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_target(in<BodyId>(body), in<Transform>(target), dt);
    return end(world, before);
}

IsletError islet_body_apply_force(IsletWorld* world, IsletBodyId body, IsletVec2 force, IsletVec2 point) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).apply_force(in<BodyId>(body), in<Vec2>(force), in<Vec2>(point));
    return end(world, before);
}

IsletError islet_body_apply_force_to_center(IsletWorld* world, IsletBodyId body, IsletVec2 force) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).apply_force_to_center(in<BodyId>(body), in<Vec2>(force));
    return end(world, before);
}

IsletError islet_body_apply_torque(IsletWorld* world, IsletBodyId body, float torque) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).apply_torque(in<BodyId>(body), torque);
    return end(world, before);
}

IsletError islet_body_apply_linear_impulse(IsletWorld* world, IsletBodyId body, IsletVec2 impulse, IsletVec2 point) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).apply_linear_impulse(in<BodyId>(body), in<Vec2>(impulse), in<Vec2>(point));
    return end(world, before);
}

IsletError islet_body_apply_linear_impulse_to_center(IsletWorld* world, IsletBodyId body, IsletVec2 impulse) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).apply_linear_impulse_to_center(in<BodyId>(body), in<Vec2>(impulse));
    return end(world, before);
}

IsletError islet_body_apply_angular_impulse(IsletWorld* world, IsletBodyId body, float impulse) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).apply_angular_impulse(in<BodyId>(body), impulse);
    return end(world, before);
}

IsletBodyType islet_body_type(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return out(BodyType{});
    return out(of(world).type(in<BodyId>(body)));
}

IsletError islet_body_set_type(IsletWorld* world, IsletBodyId body, IsletBodyType type) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_type(in<BodyId>(body), in<BodyType>(type));
    return end(world, before);
}

float islet_body_mass(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).mass(in<BodyId>(body));
}

float islet_body_rotational_inertia(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).rotational_inertia(in<BodyId>(body));
}

IsletError islet_body_set_mass(IsletWorld* world, IsletBodyId body, const IsletMassData* mass) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (mass == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_mass(in<BodyId>(body), *cast<const MassData>(mass));
    return end(world, before);
}

IsletError islet_body_reset_mass(IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).reset_mass(in<BodyId>(body));
    return end(world, before);
}

float islet_body_linear_damping(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).linear_damping(in<BodyId>(body));
}

IsletError islet_body_set_linear_damping(IsletWorld* world, IsletBodyId body, float damping) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_linear_damping(in<BodyId>(body), damping);
    return end(world, before);
}

float islet_body_angular_damping(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).angular_damping(in<BodyId>(body));
}

IsletError islet_body_set_angular_damping(IsletWorld* world, IsletBodyId body, float damping) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_angular_damping(in<BodyId>(body), damping);
    return end(world, before);
}

float islet_body_gravity_scale(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).gravity_scale(in<BodyId>(body));
}

IsletError islet_body_set_gravity_scale(IsletWorld* world, IsletBodyId body, float scale) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_gravity_scale(in<BodyId>(body), scale);
    return end(world, before);
}

bool islet_body_is_rotation_fixed(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return false;
    return of(world).is_rotation_fixed(in<BodyId>(body));
}

IsletError islet_body_set_fixed_rotation(IsletWorld* world, IsletBodyId body, bool fixed) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_fixed_rotation(in<BodyId>(body), fixed);
    return end(world, before);
}

bool islet_body_is_x_locked(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return false;
    return of(world).is_x_locked(in<BodyId>(body));
}

bool islet_body_is_y_locked(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return false;
    return of(world).is_y_locked(in<BodyId>(body));
}

IsletError islet_body_lock_x(IsletWorld* world, IsletBodyId body, bool lock) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).lock_x(in<BodyId>(body), lock);
    return end(world, before);
}

IsletError islet_body_lock_y(IsletWorld* world, IsletBodyId body, bool lock) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).lock_y(in<BodyId>(body), lock);
    return end(world, before);
}

bool islet_body_is_enabled(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return false;
    return of(world).is_enabled(in<BodyId>(body));
}

IsletError islet_body_set_enabled(IsletWorld* world, IsletBodyId body, bool enabled) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_enabled(in<BodyId>(body), enabled);
    return end(world, before);
}

bool islet_body_is_bullet(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return false;
    return of(world).is_bullet(in<BodyId>(body));
}

IsletError islet_body_set_bullet(IsletWorld* world, IsletBodyId body, bool bullet) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_bullet(in<BodyId>(body), bullet);
    return end(world, before);
}

IsletError islet_body_enable_sleep(IsletWorld* world, IsletBodyId body, bool enable) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).enable_sleep(in<BodyId>(body), enable);
    return end(world, before);
}

float islet_body_sleep_threshold(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).sleep_threshold(in<BodyId>(body));
}

IsletError islet_body_set_sleep_threshold(IsletWorld* world, IsletBodyId body, float threshold) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_sleep_threshold(in<BodyId>(body), threshold);
    return end(world, before);
}

bool islet_body_is_awake(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return false;
    return of(world).is_awake(in<BodyId>(body));
}

IsletError islet_body_wake(IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).wake(in<BodyId>(body));
    return end(world, before);
}

uint64_t islet_body_user_data(const IsletWorld* world, IsletBodyId body) {
    if (world == nullptr) return 0;
    return of(world).user_data(in<BodyId>(body));
}

IsletError islet_body_set_user_data(IsletWorld* world, IsletBodyId body, uint64_t data) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_user_data(in<BodyId>(body), data);
    return end(world, before);
}

uint32_t islet_body_contacts(const IsletWorld* world, IsletBodyId body, IsletContactInfo* out, size_t out_count) {
    if (world == nullptr) return 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).contacts(in<BodyId>(body), span_of<ContactInfo>(out, out_count));
}

uint32_t islet_body_shapes(const IsletWorld* world, IsletBodyId body, IsletShapeId* out, size_t out_count) {
    if (world == nullptr) return 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).shapes(in<BodyId>(body), span_of<ShapeId>(out, out_count));
}

IsletShapeId islet_create_circle(IsletWorld* world, IsletBodyId body, const IsletCircle* circle, const IsletShapeDef* def) {
    if (world == nullptr) return out(ShapeId{});
    if (circle == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), out(ShapeId{});
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = def == nullptr ? take_default<ShapeDef>() : take<ShapeDef>(world, def, def_room);
    if (def_taken == nullptr) return out(ShapeId{});
    return out(of(world).create_shape(in<BodyId>(body), *cast<const Circle>(circle), *def_taken));
}

IsletShapeId islet_create_capsule(IsletWorld* world, IsletBodyId body, const IsletCapsule* capsule, const IsletShapeDef* def) {
    if (world == nullptr) return out(ShapeId{});
    if (capsule == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), out(ShapeId{});
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = def == nullptr ? take_default<ShapeDef>() : take<ShapeDef>(world, def, def_room);
    if (def_taken == nullptr) return out(ShapeId{});
    return out(of(world).create_shape(in<BodyId>(body), *cast<const Capsule>(capsule), *def_taken));
}

IsletShapeId islet_create_segment(IsletWorld* world, IsletBodyId body, const IsletSegment* segment, const IsletShapeDef* def) {
    if (world == nullptr) return out(ShapeId{});
    if (segment == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), out(ShapeId{});
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = def == nullptr ? take_default<ShapeDef>() : take<ShapeDef>(world, def, def_room);
    if (def_taken == nullptr) return out(ShapeId{});
    return out(of(world).create_shape(in<BodyId>(body), *cast<const Segment>(segment), *def_taken));
}

IsletShapeId islet_create_polygon(IsletWorld* world, IsletBodyId body, const IsletPolygon* polygon, const IsletShapeDef* def) {
    if (world == nullptr) return out(ShapeId{});
    if (polygon == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), out(ShapeId{});
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = def == nullptr ? take_default<ShapeDef>() : take<ShapeDef>(world, def, def_room);
    if (def_taken == nullptr) return out(ShapeId{});
    return out(of(world).create_shape(in<BodyId>(body), *cast<const Polygon>(polygon), *def_taken));
}

IsletShapeId islet_create_chain_segment(IsletWorld* world, IsletBodyId body, const IsletChainSegment* segment, const IsletShapeDef* def) {
    if (world == nullptr) return out(ShapeId{});
    if (segment == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), out(ShapeId{});
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = def == nullptr ? take_default<ShapeDef>() : take<ShapeDef>(world, def, def_room);
    if (def_taken == nullptr) return out(ShapeId{});
    return out(of(world).create_shape(in<BodyId>(body), *cast<const ChainSegment>(segment), *def_taken));
}

IsletShapeId islet_create_half_space(IsletWorld* world, IsletBodyId body, const IsletHalfSpace* half_space, const IsletShapeDef* def) {
    if (world == nullptr) return out(ShapeId{});
    if (half_space == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), out(ShapeId{});
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = def == nullptr ? take_default<ShapeDef>() : take<ShapeDef>(world, def, def_room);
    if (def_taken == nullptr) return out(ShapeId{});
    return out(of(world).create_shape(in<BodyId>(body), *cast<const HalfSpace>(half_space), *def_taken));
}

uint32_t islet_create_chain(IsletWorld* world, IsletBodyId body, const IsletVec2* points, size_t points_count, bool loop, const IsletShapeDef* def,
    IsletShapeId* out, size_t out_count) {
    if (world == nullptr) return 0;
    if (points == nullptr && points_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = def == nullptr ? take_default<ShapeDef>() : take<ShapeDef>(world, def, def_room);
    if (def_taken == nullptr) return 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).create_chain(in<BodyId>(body), span_of<const Vec2>(points, points_count), loop, *def_taken, span_of<ShapeId>(out, out_count));
}

IsletError islet_destroy_shape(IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).destroy_shape(in<ShapeId>(shape));
    return end(world, before);
}

bool islet_shape_is_valid(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return false;
    return of(world).is_valid(in<ShapeId>(shape));
}

uint32_t islet_world_shape_count(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).shape_count();
}

IsletBodyId islet_shape_body(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return out(BodyId{});
    return out(of(world).body(in<ShapeId>(shape)));
}

IsletShapeType islet_shape_type(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return out(ShapeType{});
    return out(of(world).shape_type(in<ShapeId>(shape)));
}

const IsletCircle* islet_shape_circle(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return nullptr;
    return cast<const IsletCircle>(of(world).circle(in<ShapeId>(shape)));
}

const IsletCapsule* islet_shape_capsule(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return nullptr;
    return cast<const IsletCapsule>(of(world).capsule(in<ShapeId>(shape)));
}

const IsletSegment* islet_shape_segment(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return nullptr;
    return cast<const IsletSegment>(of(world).segment(in<ShapeId>(shape)));
}

const IsletPolygon* islet_shape_polygon(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return nullptr;
    return cast<const IsletPolygon>(of(world).polygon(in<ShapeId>(shape)));
}

const IsletChainSegment* islet_shape_chain_segment(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return nullptr;
    return cast<const IsletChainSegment>(of(world).chain_segment(in<ShapeId>(shape)));
}

const IsletHalfSpace* islet_shape_half_space(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return nullptr;
    return cast<const IsletHalfSpace>(of(world).half_space(in<ShapeId>(shape)));
}

IsletError islet_shape_set_circle(IsletWorld* world, IsletShapeId shape, const IsletCircle* circle) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (circle == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_circle(in<ShapeId>(shape), *cast<const Circle>(circle));
    return end(world, before);
}

IsletError islet_shape_set_capsule(IsletWorld* world, IsletShapeId shape, const IsletCapsule* capsule) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (capsule == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_capsule(in<ShapeId>(shape), *cast<const Capsule>(capsule));
    return end(world, before);
}

IsletError islet_shape_set_segment(IsletWorld* world, IsletShapeId shape, const IsletSegment* segment) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (segment == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_segment(in<ShapeId>(shape), *cast<const Segment>(segment));
    return end(world, before);
}

IsletError islet_shape_set_polygon(IsletWorld* world, IsletShapeId shape, const IsletPolygon* polygon) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (polygon == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_polygon(in<ShapeId>(shape), *cast<const Polygon>(polygon));
    return end(world, before);
}

IsletError islet_shape_set_half_space(IsletWorld* world, IsletShapeId shape, const IsletHalfSpace* half_space) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (half_space == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_half_space(in<ShapeId>(shape), *cast<const HalfSpace>(half_space));
    return end(world, before);
}

float islet_shape_density(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return 0;
    return of(world).density(in<ShapeId>(shape));
}

IsletError islet_shape_set_density(IsletWorld* world, IsletShapeId shape, float density) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_density(in<ShapeId>(shape), density);
    return end(world, before);
}

IsletAabb islet_shape_aabb(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return out(Aabb{});
    return out(of(world).aabb(in<ShapeId>(shape)));
}

float islet_shape_friction(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return 0;
    return of(world).friction(in<ShapeId>(shape));
}

IsletError islet_shape_set_friction(IsletWorld* world, IsletShapeId shape, float friction) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_friction(in<ShapeId>(shape), friction);
    return end(world, before);
}

float islet_shape_restitution(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return 0;
    return of(world).restitution(in<ShapeId>(shape));
}

IsletError islet_shape_set_restitution(IsletWorld* world, IsletShapeId shape, float restitution) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_restitution(in<ShapeId>(shape), restitution);
    return end(world, before);
}

float islet_shape_rolling_resistance(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return 0;
    return of(world).rolling_resistance(in<ShapeId>(shape));
}

IsletError islet_shape_set_rolling_resistance(IsletWorld* world, IsletShapeId shape, float resistance) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_rolling_resistance(in<ShapeId>(shape), resistance);
    return end(world, before);
}

float islet_shape_tangent_speed(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return 0;
    return of(world).tangent_speed(in<ShapeId>(shape));
}

IsletError islet_shape_set_tangent_speed(IsletWorld* world, IsletShapeId shape, float speed) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_tangent_speed(in<ShapeId>(shape), speed);
    return end(world, before);
}

IsletSurfaceMaterial islet_shape_material(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return out(SurfaceMaterial{});
    return out(of(world).material(in<ShapeId>(shape)));
}

IsletError islet_shape_set_material(IsletWorld* world, IsletShapeId shape, const IsletSurfaceMaterial* material) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (material == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_material(in<ShapeId>(shape), *cast<const SurfaceMaterial>(material));
    return end(world, before);
}

bool islet_shape_is_sensor(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return false;
    return of(world).is_sensor(in<ShapeId>(shape));
}

uint32_t islet_shape_sensor_overlaps(const IsletWorld* world, IsletShapeId sensor, IsletShapeId* out, size_t out_count) {
    if (world == nullptr) return 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).sensor_overlaps(in<ShapeId>(sensor), span_of<ShapeId>(out, out_count));
}

bool islet_shape_sensor_events_enabled(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return false;
    return of(world).sensor_events_enabled(in<ShapeId>(shape));
}

IsletError islet_shape_enable_sensor_events(IsletWorld* world, IsletShapeId shape, bool enable) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).enable_sensor_events(in<ShapeId>(shape), enable);
    return end(world, before);
}

bool islet_shape_hit_events_enabled(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return false;
    return of(world).hit_events_enabled(in<ShapeId>(shape));
}

IsletError islet_shape_enable_hit_events(IsletWorld* world, IsletShapeId shape, bool enable) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).enable_hit_events(in<ShapeId>(shape), enable);
    return end(world, before);
}

bool islet_shape_pre_solve_enabled(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return false;
    return of(world).pre_solve_enabled(in<ShapeId>(shape));
}

IsletError islet_shape_enable_pre_solve(IsletWorld* world, IsletShapeId shape, bool enable) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).enable_pre_solve(in<ShapeId>(shape), enable);
    return end(world, before);
}

IsletVec2 islet_shape_one_way(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).one_way(in<ShapeId>(shape)));
}

IsletError islet_shape_set_one_way(IsletWorld* world, IsletShapeId shape, IsletVec2 direction) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_one_way(in<ShapeId>(shape), in<Vec2>(direction));
    return end(world, before);
}

IsletError islet_shape_apply_wind(IsletWorld* world, IsletShapeId shape, const IsletWindDef* wind) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    Room<WindDef> wind_room;
    const WindDef* wind_taken = take<WindDef>(world, wind, wind_room);
    if (wind_taken == nullptr) return why(wind);
    const Error before = begin(world);
    of(world).apply_wind(in<ShapeId>(shape), *wind_taken);
    return end(world, before);
}

IsletFilter islet_shape_filter(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return out(Filter{});
    return out(of(world).filter(in<ShapeId>(shape)));
}

IsletError islet_shape_set_filter(IsletWorld* world, IsletShapeId shape, const IsletFilter* filter) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (filter == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_filter(in<ShapeId>(shape), *cast<const Filter>(filter));
    return end(world, before);
}

uint64_t islet_shape_user_data(const IsletWorld* world, IsletShapeId shape) {
    if (world == nullptr) return 0;
    return of(world).user_data(in<ShapeId>(shape));
}

IsletError islet_shape_set_user_data(IsletWorld* world, IsletShapeId shape, uint64_t data) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_user_data(in<ShapeId>(shape), data);
    return end(world, before);
}

uint32_t islet_world_contact_count(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).contact_count();
}

bool islet_world_contact_at(const IsletWorld* world, uint32_t slot, IsletContactInfo* out) {
    if (world == nullptr) return false;
    if (out == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), false;
    return of(world).contact_at(slot, *cast<ContactInfo>(out));
}

IsletJointId islet_create_revolute_joint(IsletWorld* world, const IsletRevoluteJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<RevoluteJointDef> def_room;
    const RevoluteJointDef* def_taken = take<RevoluteJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_prismatic_joint(IsletWorld* world, const IsletPrismaticJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<PrismaticJointDef> def_room;
    const PrismaticJointDef* def_taken = take<PrismaticJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_distance_joint(IsletWorld* world, const IsletDistanceJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<DistanceJointDef> def_room;
    const DistanceJointDef* def_taken = take<DistanceJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_weld_joint(IsletWorld* world, const IsletWeldJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<WeldJointDef> def_room;
    const WeldJointDef* def_taken = take<WeldJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_wheel_joint(IsletWorld* world, const IsletWheelJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<WheelJointDef> def_room;
    const WheelJointDef* def_taken = take<WheelJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_motor_joint(IsletWorld* world, const IsletMotorJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<MotorJointDef> def_room;
    const MotorJointDef* def_taken = take<MotorJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_mouse_joint(IsletWorld* world, const IsletMouseJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<MouseJointDef> def_room;
    const MouseJointDef* def_taken = take<MouseJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_pulley_joint(IsletWorld* world, const IsletPulleyJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<PulleyJointDef> def_room;
    const PulleyJointDef* def_taken = take<PulleyJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_gear_joint(IsletWorld* world, const IsletGearJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<GearJointDef> def_room;
    const GearJointDef* def_taken = take<GearJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_angle_joint(IsletWorld* world, const IsletAngleJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<AngleJointDef> def_room;
    const AngleJointDef* def_taken = take<AngleJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletError islet_destroy_joint(IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).destroy_joint(in<JointId>(joint));
    return end(world, before);
}

bool islet_joint_is_valid(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return false;
    return of(world).is_valid(in<JointId>(joint));
}

uint32_t islet_world_joint_count(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).joint_count();
}

IsletJointId islet_world_joint_at(const IsletWorld* world, uint32_t slot) {
    if (world == nullptr) return out(JointId{});
    return out(of(world).joint_at(slot));
}

uint32_t islet_body_joints(const IsletWorld* world, IsletBodyId body, IsletJointId* out, size_t out_count) {
    if (world == nullptr) return 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).joints(in<BodyId>(body), span_of<JointId>(out, out_count));
}

IsletJointType islet_joint_type(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointType{});
    return out(of(world).joint_type(in<JointId>(joint)));
}

IsletBodyId islet_joint_body_a(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(BodyId{});
    return out(of(world).body_a(in<JointId>(joint)));
}

IsletBodyId islet_joint_body_b(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(BodyId{});
    return out(of(world).body_b(in<JointId>(joint)));
}

IsletJointFrame islet_joint_frame_a(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointFrame{});
    return out(of(world).frame_a(in<JointId>(joint)));
}

IsletJointFrame islet_joint_frame_b(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointFrame{});
    return out(of(world).frame_b(in<JointId>(joint)));
}

IsletError islet_joint_set_frames(IsletWorld* world, IsletJointId joint, const IsletJointFrame* frame_a, const IsletJointFrame* frame_b) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (frame_a == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    if (frame_b == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_frames(in<JointId>(joint), *cast<const JointFrame>(frame_a), *cast<const JointFrame>(frame_b));
    return end(world, before);
}

IsletVec2 islet_joint_anchor_a(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).anchor_a(in<JointId>(joint)));
}

IsletVec2 islet_joint_anchor_b(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).anchor_b(in<JointId>(joint)));
}

bool islet_joint_collide_connected(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return false;
    return of(world).collide_connected(in<JointId>(joint));
}

IsletError islet_joint_set_collide_connected(IsletWorld* world, IsletJointId joint, bool collide) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_collide_connected(in<JointId>(joint), collide);
    return end(world, before);
}

IsletError islet_joint_set_break(IsletWorld* world, IsletJointId joint, float force, float torque) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_break(in<JointId>(joint), force, torque);
    return end(world, before);
}

uint64_t islet_joint_user_data(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).user_data(in<JointId>(joint));
}

IsletError islet_joint_set_user_data(IsletWorld* world, IsletJointId joint, uint64_t data) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_user_data(in<JointId>(joint), data);
    return end(world, before);
}

float islet_joint_position(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).joint_position(in<JointId>(joint));
}

float islet_joint_speed(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).joint_speed(in<JointId>(joint));
}

IsletJointSpring islet_joint_spring(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointSpring{});
    return out(of(world).spring(in<JointId>(joint)));
}

IsletError islet_joint_set_spring(IsletWorld* world, IsletJointId joint, const IsletJointSpring* spring) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (spring == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_spring(in<JointId>(joint), *cast<const JointSpring>(spring));
    return end(world, before);
}

IsletJointLimit islet_joint_limit(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointLimit{});
    return out(of(world).limit(in<JointId>(joint)));
}

IsletError islet_joint_set_limit(IsletWorld* world, IsletJointId joint, const IsletJointLimit* limit) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (limit == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_limit(in<JointId>(joint), *cast<const JointLimit>(limit));
    return end(world, before);
}

IsletJointMotor islet_joint_motor(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointMotor{});
    return out(of(world).motor(in<JointId>(joint)));
}

IsletError islet_joint_set_motor(IsletWorld* world, IsletJointId joint, const IsletJointMotor* motor) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (motor == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_motor(in<JointId>(joint), *cast<const JointMotor>(motor));
    return end(world, before);
}

float islet_joint_friction(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).joint_friction(in<JointId>(joint));
}

IsletError islet_joint_set_friction(IsletWorld* world, IsletJointId joint, float friction) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_joint_friction(in<JointId>(joint), friction);
    return end(world, before);
}

float islet_joint_motor_force(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).motor_force(in<JointId>(joint));
}

IsletJointRatchet islet_joint_ratchet(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointRatchet{});
    return out(of(world).ratchet(in<JointId>(joint)));
}

IsletError islet_joint_set_ratchet(IsletWorld* world, IsletJointId joint, const IsletJointRatchet* ratchet) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (ratchet == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_ratchet(in<JointId>(joint), *cast<const JointRatchet>(ratchet));
    return end(world, before);
}

float islet_joint_length(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).joint_length(in<JointId>(joint));
}

IsletError islet_joint_set_length(IsletWorld* world, IsletJointId joint, float length) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_joint_length(in<JointId>(joint), length);
    return end(world, before);
}

IsletError islet_joint_set_velocity(IsletWorld* world, IsletJointId joint, IsletVec2 linear, float angular) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_joint_velocity(in<JointId>(joint), in<Vec2>(linear), angular);
    return end(world, before);
}

IsletError islet_joint_set_strength(IsletWorld* world, IsletJointId joint, float max_force, float max_torque) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_joint_strength(in<JointId>(joint), max_force, max_torque);
    return end(world, before);
}

IsletVec2 islet_joint_target(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).target(in<JointId>(joint)));
}

IsletError islet_joint_set_target(IsletWorld* world, IsletJointId joint, IsletVec2 target) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_target(in<JointId>(joint), in<Vec2>(target));
    return end(world, before);
}

IsletVec2 islet_joint_ground_a(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).ground_a(in<JointId>(joint)));
}

IsletVec2 islet_joint_ground_b(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).ground_b(in<JointId>(joint)));
}

IsletVec2 islet_joint_force(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).joint_force(in<JointId>(joint)));
}

float islet_joint_torque(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).joint_torque(in<JointId>(joint));
}

IsletJointError islet_joint_error(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointError{});
    return out(of(world).joint_error(in<JointId>(joint)));
}

IsletQueryHit islet_world_cast_ray(const IsletWorld* world, IsletVec2 origin, IsletVec2 translation, const IsletQueryFilter* filter) {
    if (world == nullptr) return out(QueryHit{});
    return out(of(world).cast_ray(in<Vec2>(origin), in<Vec2>(translation), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter)));
}

bool islet_world_cast_ray_any(const IsletWorld* world, IsletVec2 origin, IsletVec2 translation, const IsletQueryFilter* filter) {
    if (world == nullptr) return false;
    return of(world).cast_ray_any(in<Vec2>(origin), in<Vec2>(translation), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter));
}

uint32_t islet_world_cast_ray_all(const IsletWorld* world, IsletVec2 origin, IsletVec2 translation, IsletQueryHit* out, size_t out_count,
    const IsletQueryFilter* filter) {
    if (world == nullptr) return 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).cast_ray_all(in<Vec2>(origin), in<Vec2>(translation), span_of<QueryHit>(out, out_count), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter));
}

void islet_world_cast_ray_each(const IsletWorld* world, IsletVec2 origin, IsletVec2 translation, const IsletQueryFilter* filter, IsletCastVisitor visit,
    void* context) {
    if (world == nullptr) return;
    of(world).cast_ray_each(in<Vec2>(origin), in<Vec2>(translation), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter), function<CastVisitor>(visit), context);
}

IsletQueryHit islet_world_cast_shape(const IsletWorld* world, const IsletShapeProxy* shape, IsletVec2 translation, const IsletQueryFilter* filter) {
    if (world == nullptr) return out(QueryHit{});
    if (shape == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), out(QueryHit{});
    return out(of(world).cast_shape(*cast<const ShapeProxy>(shape), in<Vec2>(translation), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter)));
}

bool islet_world_cast_shape_any(const IsletWorld* world, const IsletShapeProxy* shape, IsletVec2 translation, const IsletQueryFilter* filter) {
    if (world == nullptr) return false;
    if (shape == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), false;
    return of(world).cast_shape_any(*cast<const ShapeProxy>(shape), in<Vec2>(translation), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter));
}

uint32_t islet_world_cast_shape_all(const IsletWorld* world, const IsletShapeProxy* shape, IsletVec2 translation, IsletQueryHit* out, size_t out_count,
    const IsletQueryFilter* filter) {
    if (world == nullptr) return 0;
    if (shape == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).cast_shape_all(*cast<const ShapeProxy>(shape), in<Vec2>(translation), span_of<QueryHit>(out, out_count), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter));
}

void islet_world_cast_shape_each(const IsletWorld* world, const IsletShapeProxy* shape, IsletVec2 translation, const IsletQueryFilter* filter,
    IsletCastVisitor visit, void* context) {
    if (world == nullptr) return;
    if (shape == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), void();
    of(world).cast_shape_each(*cast<const ShapeProxy>(shape), in<Vec2>(translation), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter), function<CastVisitor>(visit), context);
}

uint32_t islet_world_overlap_box(const IsletWorld* world, IsletAabb box, IsletShapeId* out, size_t out_count, const IsletQueryFilter* filter) {
    if (world == nullptr) return 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).overlap_box(in<Aabb>(box), span_of<ShapeId>(out, out_count), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter));
}

uint32_t islet_world_overlap_shape(const IsletWorld* world, const IsletShapeProxy* shape, IsletShapeId* out, size_t out_count,
    const IsletQueryFilter* filter) {
    if (world == nullptr) return 0;
    if (shape == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).overlap_shape(*cast<const ShapeProxy>(shape), span_of<ShapeId>(out, out_count), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter));
}

uint32_t islet_world_overlap_point(const IsletWorld* world, IsletVec2 point, IsletShapeId* out, size_t out_count, const IsletQueryFilter* filter) {
    if (world == nullptr) return 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).overlap_point(in<Vec2>(point), span_of<ShapeId>(out, out_count), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter));
}

void islet_world_overlap_box_each(const IsletWorld* world, IsletAabb box, const IsletQueryFilter* filter, IsletOverlapVisitor visit, void* context) {
    if (world == nullptr) return;
    of(world).overlap_box_each(in<Aabb>(box), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter), function<OverlapVisitor>(visit), context);
}

void islet_world_overlap_shape_each(const IsletWorld* world, const IsletShapeProxy* shape, const IsletQueryFilter* filter, IsletOverlapVisitor visit,
    void* context) {
    if (world == nullptr) return;
    if (shape == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), void();
    of(world).overlap_shape_each(*cast<const ShapeProxy>(shape), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter), function<OverlapVisitor>(visit), context);
}

void islet_world_overlap_point_each(const IsletWorld* world, IsletVec2 point, const IsletQueryFilter* filter, IsletOverlapVisitor visit, void* context) {
    if (world == nullptr) return;
    of(world).overlap_point_each(in<Vec2>(point), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter), function<OverlapVisitor>(visit), context);
}

IsletClosestHit islet_world_closest(const IsletWorld* world, IsletVec2 point, float max_distance, const IsletQueryFilter* filter) {
    if (world == nullptr) return out(ClosestHit{});
    return out(of(world).closest(in<Vec2>(point), max_distance, filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter)));
}

uint32_t islet_world_surfaces_near(const IsletWorld* world, const IsletShapeProxy* shape, float within, IsletSurface* out, size_t out_count,
    const IsletQueryFilter* filter) {
    if (world == nullptr) return 0;
    if (shape == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).surfaces_near(*cast<const ShapeProxy>(shape), within, span_of<Surface>(out, out_count), filter == nullptr ? *take_default<QueryFilter>() : *cast<const QueryFilter>(filter));
}

void islet_world_draw(const IsletWorld* world, const IsletDebugDraw* draw) {
    if (world == nullptr) return;
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = take<DebugDraw>(world, draw, draw_room);
    if (draw_taken == nullptr) return;
    const Drawing drawing(*draw_taken);
    of(world).draw(drawing.functions);
}

void islet_world_draw_shape(const IsletWorld* world, const IsletDebugDraw* draw, IsletShapeId shape, IsletTransform pose, const IsletDrawStyle* style) {
    if (world == nullptr) return;
    Room<DebugDraw> draw_room;
    const DebugDraw* draw_taken = take<DebugDraw>(world, draw, draw_room);
    if (draw_taken == nullptr) return;
    const Drawing drawing(*draw_taken);
    if (style == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), void();
    of(world).draw_shape(drawing.functions, in<ShapeId>(shape), in<Transform>(pose), *cast<const DrawStyle>(style));
}

bool islet_step_mover(IsletWorld* world, const IsletMoverDef* def, IsletMoverState* state, const IsletMoverInput* input, float dt) {
    if (world == nullptr) return false;
    Room<MoverDef> def_room;
    const MoverDef* def_taken = take<MoverDef>(world, def, def_room);
    if (def_taken == nullptr) return false;
    if (state == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER), false;
    Room<MoverInput> input_room;
    const MoverInput* input_taken = take<MoverInput>(world, input, input_room);
    if (input_taken == nullptr) return false;
    return islet::step_mover(of(world), *def_taken, *cast<MoverState>(state), *input_taken, dt);
}

}  // extern "C"
