// find_fault names the field for whose sake a definition is refused: each number of each definition gets values that are bad, and values that may be bad.
#include <cstring>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "refusal.hpp"
#include "support/cpp_text.hpp"

namespace {

using namespace islet;
using namespace islet::test;

constexpr float values[] = {test::nan, inf, -inf, -0.001f, 0, 0.0001f, 0.5f, 1.5f, 2, -2, 150, 2.0e4f, -2.0e4f, 2.0e6f, -2.0e6f, 2.0e9f, -2.0e9f, most, -most};
constexpr std::uint32_t counts[] = {0, 1, 64, 65, 256, 257, 0xffffffffu};

/// The numbers of a definition, each with its name and a way to set it.
struct Fields {
    struct Field {
        std::string name;
        std::vector<std::function<void()>> changes;
    };
    std::vector<Field> all;
    std::string prefix;

    template <class T>
    void read(T& def) {
        const std::string before = prefix;
        std::size_t i = 0;
        const auto visit = [&](auto& member) { add(member, before + CppNames<T>::members[i++]); };
        auto each = [&](auto&... members) { (visit(members), ...); };
        detail::members(each, def);
    }

private:
    template <class T>
    void add(T& member, const std::string& name) {
        if constexpr (std::is_same_v<T, Vec2>) {
            add(member.x, name);
            add(member.y, name);
        } else if constexpr (std::is_same_v<T, float>) {
            all.push_back({name, {}});
            for (const float value : values) all.back().changes.push_back([&member, value] { member = value; });
        } else if constexpr (std::is_enum_v<T>) {
            all.push_back({name, {}});
            for (const int value : {0, 1, 2, 3, 7, 255}) all.back().changes.push_back([&member, value] { member = static_cast<T>(value); });
        } else if constexpr (std::is_same_v<T, std::uint32_t>) {
            all.push_back({name, {}});
            for (const std::uint32_t value : counts) all.back().changes.push_back([&member, value] { member = value; });
        } else if constexpr (std::is_class_v<T> && !std::is_same_v<T, BodyId> && !std::is_same_v<T, JointId> && !std::is_same_v<T, Filter>) {
            prefix = name + ".";
            read(member);
        }
    }
};

class FieldFaults : public testing::Test {
protected:
    FieldFaults() {
        a = w.add_box({-3, 5});
        b = w.add_box({3, 5});
        hinge = hinge_of(a);
        other_hinge = hinge_of(b);
    }

    JointId hinge_of(BodyId body) {
        RevoluteJointDef def;
        def.base.body_a = w.add_ground();
        def.base.body_b = body;
        return w->create_joint(def);
    }

    Error error_of(const std::function<void()>& call) {
        w->clear_error();
        call();
        return w->last_error();
    }

    /// For each field and value of `def`, find_fault and `call` agree on the error, and find_fault names the field. Says how many were refused.
    template <class Def>
    int compare(const Def& good, const std::function<void(World&, const Def&)>& call) {
        int refused = 0;
        Def def = good;
        EXPECT_EQ(error_of([&] { call(*w.operator->(), def); }), Error::none) << CppNames<Def>::name;
        EXPECT_EQ(find_fault(def).field, nullptr);
        Fields fields;
        fields.read(def);
        for (const auto& field : fields.all) {
            for (const auto& change : field.changes) {
                def = good;
                change();
                SCOPED_TRACE(cpp_text(def));
                const Error error = error_of([&] { call(*w.operator->(), def); });
                const FieldFault fault = find_fault(def);
                EXPECT_EQ(fault.error, error) << describe(error);
                if (error == Error::none || fault.field == nullptr) {
                    EXPECT_EQ(fault.field, nullptr);
                    continue;
                }
                ++refused;
                // The lower bound is above the upper one as much as the upper one is below it.
                if ((field.name != "limit.lower" && field.name != "lower") || error != Error::out_of_range) {
                    EXPECT_EQ(fault.field, field.name);
                } else {
                    EXPECT_TRUE(fault.field == field.name || fault.field == field.name.substr(0, field.name.size() - 5) + "upper") << fault.field;
                }
            }
        }
        return refused;
    }

    template <class Def>
    int compare_joint(Def def) {
        if constexpr (std::is_same_v<Def, MouseJointDef>) {
            def.body = a;
        } else if constexpr (std::is_same_v<Def, GearJointDef>) {
            def.joint1 = hinge;
            def.joint2 = other_hinge;
        } else {
            def.base.body_a = a;
            def.base.body_b = b;
        }
        return compare<Def>(def, [](World& world, const Def& d) {
            const JointId joint = world.create_joint(d);
            if (joint) world.destroy_joint(joint);
        });
    }

    TestWorld w;
    BodyId a, b;
    JointId hinge, other_hinge;
};

TEST_F(FieldFaults, OfBodies) {
    EXPECT_GT(compare<BodyDef>({}, [](World& world, const BodyDef& d) {
        const BodyId body = world.create_body(d);
        if (body) world.destroy_body(body);
    }), 50);
}

TEST_F(FieldFaults, OfShapes) {
    EXPECT_GT(compare<ShapeDef>({}, [&](World& world, const ShapeDef& d) {
        const ShapeId shape = world.create_shape(a, Circle{{}, 0.5f}, d);
        if (shape) world.destroy_shape(shape);
    }), 40);
}

TEST_F(FieldFaults, OfSolvers) {
    EXPECT_GT(compare<SolverDef>({}, [](World& world, const SolverDef& d) { world.set_solver(d); }), 60);
}

TEST_F(FieldFaults, OfExplosionsAndWind) {
    ExplosionDef explosion;
    explosion.position = {1000, 1000};
    EXPECT_GT(compare<ExplosionDef>(explosion, [](World& world, const ExplosionDef& d) { world.explode(d); }), 20);
    const ShapeId shape = w.shape_of(a);
    EXPECT_GT(compare<WindDef>({}, [&](World& world, const WindDef& d) { world.apply_wind(shape, d); }), 20);
}

TEST_F(FieldFaults, OfJoints) {
    EXPECT_GT(compare_joint(RevoluteJointDef{}), 60);
    EXPECT_GT(compare_joint(PrismaticJointDef{}), 60);
    EXPECT_GT(compare_joint(WheelJointDef{}), 60);
    EXPECT_GT(compare_joint(WeldJointDef{}), 60);
    EXPECT_GT(compare_joint(MotorJointDef{}), 60);
    EXPECT_GT(compare_joint(AngleJointDef{}), 60);
    EXPECT_GT(compare_joint(MouseJointDef{}), 20);
    EXPECT_GT(compare_joint(GearJointDef{}), 10);
    PulleyJointDef pulley;
    pulley.ground_a = {-30, 9};
    pulley.ground_b = {30, 9};
    EXPECT_GT(compare_joint(pulley), 60);
    DistanceJointDef rope;
    rope.limit = {true, 0, 1};
    EXPECT_GT(compare_joint(rope), 60);
}

TEST_F(FieldFaults, OfWhatSettersTake) {
    EXPECT_GT(compare<MassData>({1, {0, 0}, 1}, [&](World& world, const MassData& d) { world.set_mass(a, d); }), 20);
    const ShapeId shape = w.shape_of(a);
    EXPECT_GT(compare<SurfaceMaterial>({}, [&](World& world, const SurfaceMaterial& d) { world.set_material(shape, d); }), 20);
    EXPECT_GT(compare<JointFrame>({}, [&](World& world, const JointFrame& d) { world.set_frames(hinge, d, {}); }), 5);
    EXPECT_GT(compare<JointFrame>({}, [&](World& world, const JointFrame& d) { world.set_frames(hinge, {}, d); }), 5);
    EXPECT_GT(compare<JointSpring>({}, [&](World& world, const JointSpring& d) { world.set_spring(hinge, d); }), 10);
    EXPECT_GT(compare<JointLimit>({}, [&](World& world, const JointLimit& d) { world.set_limit(hinge, d); }), 10);
    EXPECT_GT(compare<JointMotor>({}, [&](World& world, const JointMotor& d) { world.set_motor(hinge, d); }), 5);
    WeldJointDef weld;
    weld.base.body_a = a;
    weld.base.body_b = b;
    const JointId welded = w->create_joint(weld);
    EXPECT_GT(compare<JointSoftness>({}, [&](World& world, const JointSoftness& d) { world.set_softness(welded, d); }), 20);
    AngleJointDef angle;
    angle.base = weld.base;
    const JointId turning = w->create_joint(angle);
    EXPECT_GT(compare<JointRatchet>({}, [&](World& world, const JointRatchet& d) { world.set_ratchet(turning, d); }), 5);
}

TEST_F(FieldFaults, OfMovers) {
    int refused = 0;
    const auto try_all = [&](const char* field, auto&& set) {
        for (const float value : values) {
            MoverDef def;
            set(def, value);
            MoverState hero;
            hero.position = {50, 20};
            const Error error = error_of([&] { step_mover(*w, def, hero, {}, 1.0f / 60); });
            EXPECT_EQ(find_fault(def).error, error) << field << " " << value << ": " << describe(error);
            EXPECT_STREQ(find_fault(def).field, error == Error::none ? nullptr : field) << value;
            refused += error == Error::none ? 0 : 1;
        }
    };
    try_all("capsule", [](MoverDef& d, float x) { d.capsule.radius = x; });
    try_all("up", [](MoverDef& d, float x) { d.up.x = x; });
    try_all("gravity_scale", [](MoverDef& d, float x) { d.gravity_scale = x; });
    try_all("max_slope", [](MoverDef& d, float x) { d.max_slope = x; });
    try_all("step_height", [](MoverDef& d, float x) { d.step_height = x; });
    try_all("snap_distance", [](MoverDef& d, float x) { d.snap_distance = x; });
    try_all("ground_acceleration", [](MoverDef& d, float x) { d.ground_acceleration = x; });
    try_all("air_acceleration", [](MoverDef& d, float x) { d.air_acceleration = x; });
    try_all("mass", [](MoverDef& d, float x) { d.mass = x; });
    try_all("max_push_force", [](MoverDef& d, float x) { d.max_push_force = x; });
    EXPECT_GT(refused, 60);
}

TEST(FieldFaultsOfCapacities, AreThoseForWhichThereIsNoWorld) {
    const char* const names[] = {"bodies", "shapes", "contacts", "joints", "geometries", "hits", "events"};
    std::uint32_t Capacity::*const fields[] = {&Capacity::bodies,     &Capacity::shapes, &Capacity::contacts, &Capacity::joints,
                                               &Capacity::geometries, &Capacity::hits,   &Capacity::events};
    int refused = 0;
    for (int i = 0; i < 7; ++i) {
        for (const std::uint32_t value : {0u, 1u, max_capacity, max_capacity + 1, 0xffffffffu}) {
            Capacity capacity = {4, 4, 4, 4, 4, 4, 4};
            capacity.*fields[i] = value;
            const bool good = islet::is_valid(capacity);
            EXPECT_EQ(find_fault(capacity).error, good ? Error::none : Error::bad_capacity) << names[i] << " " << value;
            EXPECT_STREQ(find_fault(capacity).field, good ? nullptr : names[i]) << value;
            refused += good ? 0 : 1;
        }
    }
    EXPECT_EQ(refused, 7 * 2 + 3);
}

TEST(FieldFaultsOfWorlds, AreThoseForWhichCreateRefuses) {
    const Capacity capacity = {1, 1, 1, 0};
    const Block block(world_bytes(capacity));
    const auto expect = [&](const char* field, auto&& change) {
        WorldDef def;
        change(def);
        Error error = Error::none;
        World::create(block.span(), capacity, def, &error);
        EXPECT_EQ(find_fault(def).error, error);
        EXPECT_STREQ(find_fault(def).field, field);
    };
    expect(nullptr, [](WorldDef&) {});
    expect("gravity", [](WorldDef& d) { d.gravity.y = test::nan; });
    expect("solver.substeps", [](WorldDef& d) { d.solver.substeps = 0; });
    expect("solver.shock", [](WorldDef& d) { d.solver.shock = 0.51f; });
    expect("restitution_threshold", [](WorldDef& d) { d.restitution_threshold = -1; });
    expect("max_speed", [](WorldDef& d) { d.max_speed = 0; });
    expect("max_speed", [](WorldDef& d) { d.max_speed = 2 * max_speed_limit; });
    expect("hit_threshold", [](WorldDef& d) { d.hit_threshold = inf; });
    expect("lanes", [](WorldDef& d) { d.lanes = 2; });
    expect("tasks.workers", [](WorldDef& d) { d.tasks.workers = 65; });
}

}  // namespace
