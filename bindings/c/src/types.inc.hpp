// Which types of C stand for which of C++. Made by bindings/c/generate.py; do not edit.
//
//   ISLET_C_SAME(X)   the same size and fields
//   ISLET_C_GROWS(X)  the same after the first bytes of the C struct: X(type, bytes)
#pragma once

#define ISLET_C_SAME(X) \
    X(ShapeType) \
    X(DrawPart) \
    X(BodyColors) \
    X(Error) \
    X(Schedule) \
    X(JointTrees) \
    X(SweepOrder) \
    X(BodyType) \
    X(JointType) \
    X(DriveKind) \
    X(SenseKind) \
    X(FormatKind) \
    X(RowKind) \
    X(ReplayEnd) \
    X(Vec2) \
    X(Rot) \
    X(Transform) \
    X(Aabb) \
    X(Circle) \
    X(Capsule) \
    X(Segment) \
    X(ChainSegment) \
    X(HalfSpace) \
    X(Hull) \
    X(Polygon) \
    X(MassData) \
    X(DrawStyle) \
    X(BodyId) \
    X(ShapeId) \
    X(Filter) \
    X(SurfaceMaterial) \
    X(TouchEvent) \
    X(SensorEvent) \
    X(HitEvent) \
    X(ContactPoint) \
    X(ContactInfo) \
    X(PreSolve) \
    X(JointId) \
    X(JointFrame) \
    X(JointSpring) \
    X(JointSoftness) \
    X(JointLimit) \
    X(JointMotor) \
    X(JointBase) \
    X(JointRatchet) \
    X(JointError) \
    X(JointBreakEvent) \
    X(FieldFault) \
    X(ShapeProxy) \
    X(CastHit) \
    X(Separation) \
    X(QueryFilter) \
    X(QueryHit) \
    X(ClosestHit) \
    X(Surface) \
    X(Drive) \
    X(Sense) \
    X(Variation) \
    X(RowEnd) \
    X(IslandRow) \
    X(IslandBody) \
    X(MoverState)

#define ISLET_C_GROWS(X) \
    X(DebugDraw, 8) \
    X(TaskSystem, 8) \
    X(Capacity, 4) \
    X(Hooks, 8) \
    X(SolverDef, 4) \
    X(BodyDef, 8) \
    X(ShapeDef, 8) \
    X(ExplosionDef, 4) \
    X(WindDef, 4) \
    X(StepReport, 4) \
    X(StepProfile, 8) \
    X(WorldCounters, 8) \
    X(RevoluteJointDef, 8) \
    X(PrismaticJointDef, 8) \
    X(DistanceJointDef, 8) \
    X(WeldJointDef, 8) \
    X(WheelJointDef, 8) \
    X(MotorJointDef, 8) \
    X(MouseJointDef, 8) \
    X(PulleyJointDef, 8) \
    X(GearJointDef, 8) \
    X(AngleJointDef, 8) \
    X(FormatInfo, 4) \
    X(MoverDef, 8) \
    X(MoverInput, 4) \
    X(ReplayResult, 8)

namespace islet::c {
/// The first version of a struct that has grown since.
template <class T>
struct First;
}  // namespace islet::c

template <>
struct islet::c::First<islet::TaskSystem> {
    std::uint32_t struct_size;
    std::uint32_t reserved;
    void (*parallel_for)(void* context, uint32_t count, void (*task)(void* data, uint32_t index), void* data);
    void* context;
    uint32_t workers;
};
template <>
struct islet::c::First<islet::Capacity> {
    std::uint32_t struct_size;
    uint32_t bodies;
    uint32_t shapes;
    uint32_t contacts;
    uint32_t joints;
    uint32_t geometries;
    uint32_t hits;
};
