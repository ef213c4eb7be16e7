// Images and deltas from an attacker, who gets every checksum right: each is refused with the world untouched, or accepted and then a world in
// which every invariant holds and goes on holding. (tests/fuzz does the same with millions of images.)
#include <gtest/gtest.h>

#include "bodies/sleep.hpp"
#include "graph/constraint_list.hpp"
#include "physics/measure.hpp"
#include "support/busy_world.hpp"
#include "support/forge.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

class Attack : public testing::Test {
protected:
    Attack() {
        TestWorld source(busy_capacity);
        fill_busy(*source);
        const std::vector<BodyId> bodies = source.bodies();
        for (std::size_t i = 0; i < bodies.size(); i += 5) source->set_enabled(bodies[i], false);
        for (int i = 0; i < 4; ++i) {
            const BodyId off = source->create_body({.position = {60 + 3 * static_cast<float>(i), 0}, .enabled = false});
            EXPECT_TRUE(source->create_shape(off, make_box(1, 1)));
        }
        image_ = save(*source);
        TestWorld victim(busy_capacity);
        EXPECT_TRUE(victim->load(image_.bytes()));
    }

    /// Loads a forged image. If it is taken, the world must be sound and stay so.
    void attack(Image& forged, const char* what, std::size_t where) {
        seal(forged.bytes());
        const std::uint64_t before = victim_->hash();
        if (!victim_->load(forged.bytes())) {
            ++refused_;
            ASSERT_EQ(victim_->hash(), before) << what << ", word " << where;
            return;
        }
        ++accepted_;
        const char* broken = victim_->validate();
        ASSERT_EQ(broken, nullptr) << broken << ": " << what << ", word " << where << ", at once";
        // A step longer than the last one scales warm starts up, a shorter one down.
        for (const float dt : {1.0f, 1.0f / 60, 1.0f / 60, 1.0f / 1000, 0.1f, 1.0f / 60, 1.0f / 60, 1.0f / 60}) victim_->step(dt);
        broken = victim_->validate();
        ASSERT_EQ(broken, nullptr) << broken << ": " << what << ", word " << where << ", 8 steps later";
        if (!random_.one_in(slow_build ? 30 : 4)) return;
        ASSERT_TRUE(victim_->load(forged.bytes()));
        for (int round = 0; round < 2; ++round) {
            use(round);
            broken = victim_->validate();
            ASSERT_EQ(broken, nullptr) << broken << ": " << what << ", word " << where << ", used, round " << round;
        }
        ASSERT_TRUE(second_->load(save(*victim_).bytes())) << what << ", word " << where << ": its own image is refused";
    }

    /// What is in the image in places that no step looks at, calls may.
    void use(int round) {
        World& w = *victim_;
        for (const BodyId body : victim_.bodies()) {
            if (round == 0 && !w.is_enabled(body)) continue;
            const ShapeId shape = victim_.shape_of(body);
            switch ((body.index1 + static_cast<std::uint32_t>(round)) % 8) {
                case 0: w.set_enabled(body, !w.is_enabled(body)); break;
                case 1: w.set_type(body, w.type(body) == BodyType::static_body ? BodyType::dynamic : BodyType::static_body); break;
                case 2: w.reset_mass(body); break;
                case 3: w.set_transform(body, w.position(body), w.angle(body)); break;
                case 4:
                    if (shape) w.set_circle(shape, Circle{{0, 0}, 0.4f});
                    break;
                case 5: w.destroy_body(body); break;
                case 6: w.create_shape(body, make_box(0.2f, 0.1f)); break;
                default:
                    if (shape) w.destroy_shape(shape);
            }
        }
        for (const BodyId body : victim_.bodies()) w.set_enabled(body, true);
        for (std::uint32_t slot = 0; slot < w.capacity().joints; slot += 3)
            if (const JointId joint = w.joint_at(slot)) w.destroy_joint(joint);
        while (const BodyId body = w.create_body({.type = BodyType::dynamic, .position = {3, 3}}))
            w.create_shape(body, Circle{{0, 0}, 0.1f * static_cast<float>(body.index1 % 9 + 1)});
        for (int i = 0; i < 3; ++i) w.step(1.0f / 60);
    }

    Image image_;
    TestWorld victim_{busy_capacity}, second_{busy_capacity};
    int accepted_ = 0, refused_ = 0;
    Random random_{7};
};

TEST_F(Attack, EveryWordMayLie) {
    const std::size_t words = image_.bytes().size() / 4;
    const std::size_t stride = slow_build ? 5 : 1;
    for (std::size_t i = 0; i < words; i += stride) {
        const std::uint32_t good = word(image_, i);
        // No slot, the last slot, the next one, no number, an infinite one, a huge one, the other sign, another bit.
        for (const std::uint32_t lie :
             {0u, 0xffffffffu, good + 1, good - 1, 0x7fc00000u, 0x7f800000u, 0x7f000000u, 0x7f7fffffu, good ^ 0x80000000u, good ^ 0x100u}) {
            if (lie == good) continue;
            Image forged = image_;
            set_word(forged, i, lie);
            ASSERT_NO_FATAL_FAILURE(attack(forged, "a lie", i));
        }
    }
    EXPECT_GT(accepted_, 1000) << "hardly any lie was harmless: the test does not reach behind the gate";
    EXPECT_GT(refused_, 1000);
}

// Every number that the next step or a reader would meet: of the world, of bodies, contacts and joints.
TEST_F(Attack, NoNumberMayBeInfiniteOrNone) {
    using namespace detail;
    const ImageHeader h = header_of(image_.bytes());
    struct Field {
        const char* what;
        std::size_t at, bytes;  // of floats in one record that is in use
    };
    ASSERT_TRUE(victim_->load(image_.bytes()));
    std::uint32_t contact = 0;
    ContactInfo info;
    while (contact < victim_->capacity().contacts && !victim_->contact_at(contact, info)) ++contact;
    ASSERT_LT(contact, victim_->capacity().contacts);
    std::vector<Field> fields;
    std::size_t at = sizeof h;
    Core nowhere;
    for_each_part(nowhere, h, [&](auto& part, std::uint64_t bytes) {
        using Record = std::remove_cvref_t<decltype(*part)>;
        const auto add = [&](const char* what, std::size_t first, std::size_t end) { fields.push_back({what, at + first, end - first}); };
        if constexpr (std::is_same_v<Record, State>) add("gravity", offsetof(State, gravity), offsetof(State, solver));
        if constexpr (std::is_same_v<Record, Pose>) add("a pose", 0, offsetof(Pose, flags));
        if constexpr (std::is_same_v<Record, Motion>) add("a motion", 0, sizeof(Motion));
        if constexpr (std::is_same_v<Record, Body>) {
            add("a body", 0, offsetof(Body, flags));
            add("a body's stretch", offsetof(Body, stretch), offsetof(Body, stretch) + 4);
        }
        if constexpr (std::is_same_v<Record, ContactManifold>)
            add("a contact", contact * sizeof(Record) + offsetof(ContactManifold, normal), (contact + 1) * sizeof(Record));
        if constexpr (std::is_same_v<Record, Joint>) {
            add("a joint", offsetof(Joint, local_a), offsetof(Joint, gear_count));
            add("a joint's impulse", offsetof(Joint, impulse), offsetof(Joint, user_data));
        }
        at += bytes;
    });
    for (const Field& field : fields) {
        for (std::size_t i = field.at; i < field.at + field.bytes; i += 4) {
            for (const std::uint32_t none : {0x7fc00000u, 0xffc00000u, 0x7f800000u, 0xff800000u}) {
                Image forged = image_;
                set_word(forged, i / 4, none);
                seal(forged.bytes());
                EXPECT_FALSE(victim_->load(forged.bytes())) << field.what << ", byte " << i - field.at;
            }
        }
    }
}

TEST_F(Attack, TwoWordsMayBeExchangedAndRecordsRepeated) {
    Random random(7);
    const auto words = static_cast<std::uint32_t>(image_.bytes().size() / 4);
    for (int i = 0; i < (slow_build ? 3000 : 30000); ++i) {
        Image forged = image_;
        const std::uint32_t at = random.below(words);
        if (i % 2 == 0) {
            const std::uint32_t with = random.below(words);
            set_word(forged, at, word(image_, with));
            set_word(forged, with, word(image_, at));
        } else {
            const std::uint32_t lengths[] = {8, 18, 24, 32, 58};
            const std::uint32_t length = lengths[random.below(5)];
            for (std::uint32_t k = 0; k < length && at + length + k < words; ++k) set_word(forged, at + length + k, word(image_, at + k));
        }
        ASSERT_NO_FATAL_FAILURE(attack(forged, "an exchange", at));
    }
    EXPECT_GT(accepted_, 100);
    EXPECT_GT(refused_, 1000);
}

// A ball touches at one point. The impulse of the other, which is not there, may be any finite number. Shock propagation turns all impulses into those of
// lighter bodies and back; rounded up, the largest number would overflow.
TEST(Attacks, AnImpulseAtAPointThatIsNotThereStaysFiniteUnderShock) {
    for (int shock = 1; shock <= 50; ++shock) {
        WorldDef def;
        def.solver.shock = 0.01f * static_cast<float>(shock);
        def.enable_sleep = false;
        TestWorld source(roomy, def);
        source.add_ground();
        for (int i = 0; i < 4; ++i) source.add_circle({0, 0.5f + static_cast<float>(i)});
        for (int i = 0; i < 30; ++i) source->step(1.0f / 60);
        ASSERT_EQ(source->contact_count(), 4u);
        for (std::uint32_t i = 0; i < 4; ++i) detail::Core::of(*source).manifolds[i].normal_impulse[1] = 3.402823466e38f;
        TestWorld victim(roomy, def);
        ASSERT_TRUE(victim->load(save(*source).bytes()));
        for (int i = 0; i < 10; ++i) victim->step(1.0f / 60);
        EXPECT_EQ(victim->validate(), nullptr) << def.solver.shock;
    }
}

// The load on a joint's limits outlives a step, and is scaled when the step's length changes.
TEST(Attacks, ALoadOnLimitsStaysFiniteInStepsOfAnyLength) {
    const auto limited = []<class Def>(Def def, float lower, float upper) {
        def.limit = {.enable = true, .lower = lower, .upper = upper};
        return def;
    };
    for (int kind = 0; kind < 5; ++kind)
        for (const float load : {3.4e38f, -3.4e38f, 1.0e37f, -1.0e30f, 1.0e28f})
            for (const float dt : {1.0f, 0.1f, 1.0f / 60, 1.0e-4f}) {
                TestWorld source;
                const BodyId frame = source.add_box({0, 10}, 0.5f, 0.5f, {}, BodyType::static_body), bob = source.add_box({2, 10}, 0.5f, 0.5f);
                const JointBase base{.body_a = frame, .body_b = bob, .frame_a = {{1, 0}}, .frame_b = {{-1, 0}}};
                const JointId joint = kind == 0   ? source->create_joint(limited(RevoluteJointDef{.base = base}, -0.1f, 0.1f))
                                      : kind == 1 ? source->create_joint(limited(PrismaticJointDef{.base = base}, -0.1f, 0.1f))
                                      : kind == 2 ? source->create_joint(limited(WheelJointDef{.base = base}, -0.1f, 0.1f))
                                      : kind == 3 ? source->create_joint(limited(DistanceJointDef{.base = base, .length = 1}, 0.5f, 1.5f))
                                                  : source->create_joint(limited(AngleJointDef{.base = base, .ratchet = {.step = 0.1f}}, -0.1f, 0.1f));
                ASSERT_TRUE(joint) << kind;
                for (int i = 0; i < 30; ++i) source->step(1.0f / 60);
                detail::Core::of(*source).joints[joint.index1 - 1].limit_load = load;
                TestWorld victim;
                if (!victim->load(save(*source).bytes())) continue;
                for (const float length : {dt, 1.0f / 60, 1.0f}) {
                    victim->step(length);
                    ASSERT_STREQ(victim->validate(), nullptr)
                        << "joint " << kind << ", load " << load << ", a step of " << length << " s, first " << dt << " s";
                }
            }
}

// No few words make this one: a box asleep on a kinematic floor that is awake. Such a box has no batch, so nothing may touch it and want to be solved.
TEST(Attacks, NothingSleepsOnWhatIsAwake) {
    TestWorld source;
    source.add_box({0, -1}, 20, 1, {}, BodyType::kinematic);
    const BodyId box = source.add_box({0, 0.5f});
    for (int i = 0; i < 10; ++i) source->step(1.0f / 60);
    ASSERT_GT(source->report().touching_contacts, 0u);
    detail::put_to_sleep(detail::Core::of(*source), box.index1 - 1);
    EXPECT_NE(source->validate(), nullptr);

    const Image image = save(*source);
    TestWorld victim;
    EXPECT_FALSE(victim->load(image.bytes())) << "the next step would write outside the world's block";
}

// The same with a hinge, which a plan of trees would give to a batch that does not exist.
TEST(Attacks, NothingSleepsThatHangsOnWhatIsAwake) {
    WorldDef def;
    def.solver.joint_trees = JointTrees::all;
    TestWorld source(roomy, def);
    const auto hang = [&](BodyId on, Vec2 at) {
        const BodyId body = source.add_circle(at + Vec2{0, -1});
        EXPECT_TRUE(source->create_joint(RevoluteJointDef{.base = {.body_a = on, .body_b = body, .frame_a = {at}, .frame_b = {{0, 1}}}}));
        return body;
    };
    BodyDef kinematic;
    kinematic.type = BodyType::kinematic;
    const BodyId hanging = hang(source->create_body(kinematic), {0, 10});
    hang(source->create_body({}), {5, 10});
    source->step(1.0f / 60);
    ASSERT_EQ(source->validate(), nullptr);
    detail::Core::of(*source).awake_bodies.clear(hanging.index1 - 1);
    EXPECT_NE(source->validate(), nullptr);

    const Image image = save(*source);
    TestWorld victim;
    EXPECT_FALSE(victim->load(image.bytes())) << "the next step would write outside the world's block";
}

// A gear hangs on the bodies that its joints move. Hung on the other end of one, it would tie bodies together that no walk over an island meets.
TEST(Attacks, AGearHangsOnWhatItsJointsMove) {
    TestWorld source;
    const BodyId ground1 = source->create_body({}), ground2 = source->create_body({});
    const BodyId wheel1 = source.add_circle({0, 5}), wheel2 = source.add_circle({5, 5});
    const JointId joint1 = source->create_joint(RevoluteJointDef{.base = {.body_a = ground1, .body_b = wheel1, .frame_a = {{0, 5}}}});
    const JointId joint2 = source->create_joint(RevoluteJointDef{.base = {.body_a = ground2, .body_b = wheel2, .frame_a = {{5, 5}}}});
    const JointId gear = source->create_joint(GearJointDef{.joint1 = joint1, .joint2 = joint2});
    ASSERT_TRUE(gear);
    ASSERT_EQ(source->validate(), nullptr);
    detail::Core& core = detail::Core::of(*source);
    const std::uint32_t i = gear.index1 - 1, from = wheel2.index1 - 1, to = ground2.index1 - 1;
    detail::remove_from_list(core.joints, i, 1, core.bodies[from].joint_head, core.bodies[from].joint_count);
    core.joints[i].body_b = to;
    detail::add_to_list(core.joints, i, 1, core.bodies[to].joint_head, core.bodies[to].joint_count);

    const Image image = save(*source);
    TestWorld victim;
    EXPECT_FALSE(victim->load(image.bytes()));
}

// A disabled body has no leaf in the tree, so its boxes may be any that hold its shapes. Enabled again it must get its own.
TEST(Attacks, ADisabledBodyIsSoundWhenItIsEnabled) {
    for (const BodyType type : {BodyType::static_body, BodyType::kinematic, BodyType::dynamic}) {
        SCOPED_TRACE(int(type));
        TestWorld source;
        source.add_ground();
        const BodyId box = source.add_box({0, 0.5f}, 0.5f, 0.5f, {}, type);
        source->set_enabled(box, false);
        Image image = save(*source);
        const detail::ImageHeader h = header_of(image.bytes());
        detail::Core nowhere;
        std::size_t at = sizeof h;
        detail::for_each_part(nowhere, h, [&](auto& part, std::uint64_t bytes) {
            if (static_cast<const void*>(&part) == static_cast<const void*>(&nowhere.boxes)) {
                std::byte* where = image.bytes().data() + at + (source.shape_of(box).index1 - 1) * sizeof(Aabb);
                Aabb box_there;
                std::memcpy(&box_there, where, sizeof box_there);
                box_there = expand(box_there, 3);
                std::memcpy(where, &box_there, sizeof box_there);
            }
            at += bytes;
        });
        seal(image.bytes());
        TestWorld victim;
        if (!victim->load(image.bytes())) continue;
        ASSERT_EQ(victim->validate(), nullptr);
        victim->set_enabled(box, true);
        EXPECT_STREQ(victim->validate(), nullptr);
        victim.step(5);
        EXPECT_STREQ(victim->validate(), nullptr);
        TestWorld other;
        EXPECT_TRUE(other->load(save(*victim).bytes()));
    }
}

}  // namespace
}  // namespace islet::test
