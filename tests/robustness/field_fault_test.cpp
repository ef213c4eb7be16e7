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
                if (field.name != "limit.lower" || error != Error::out_of_range) {
                    EXPECT_EQ(fault.field, field.name);
                } else {
                    EXPECT_EQ(std::string(fault.field).substr(0, 6), "limit.");
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
