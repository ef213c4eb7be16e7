// Walking over a world's objects, ids as keys, and worlds that move to a larger block.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "islet/hash.hpp"
#include "islet/islet.hpp"
#include "support/joint_world.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

TEST(Ranges, VisitEveryObjectOnceInTheOrderOfSlots) {
    TestWorld w;
    w.add_ground();
    add_machine(*w, {0, 10});
    std::vector<BodyId> boxes;
    for (int i = 0; i < 9; ++i) boxes.push_back(w.add_box({static_cast<float>(i) * 2, 0.5f}));
    w->destroy_body(boxes[3]);
    w.step(5);
    std::vector<BodyId> bodies_seen;
    for (const BodyId body : all_bodies(*w)) bodies_seen.push_back(body);
    EXPECT_EQ(bodies_seen.size(), w->body_count());
    EXPECT_TRUE(std::is_sorted(bodies_seen.begin(), bodies_seen.end()));
    EXPECT_EQ(std::count(bodies_seen.begin(), bodies_seen.end(), boxes[3]), 0);
    std::set<ShapeId> shapes_seen;
    for (const ShapeId shape : all_shapes(*w)) EXPECT_TRUE(shapes_seen.insert(shape).second && w->is_valid(shape));
    EXPECT_EQ(shapes_seen.size(), w->shape_count());
    std::uint32_t joints_seen = 0;
    for (const JointId joint : all_joints(*w)) joints_seen += w->is_valid(joint) ? 1 : 0;
    EXPECT_EQ(joints_seen, w->joint_count());
    std::uint32_t touching = 0;
    for (const ContactInfo& contact : all_contacts(*w)) touching += contact.point_count > 0 ? 1 : 0;
    EXPECT_EQ(touching, w.contacts().size());
    EXPECT_GE(touching, 8u);
}

TEST(Ranges, OfAnEmptyWorldAreEmpty) {
    TestWorld w({.bodies = 1, .shapes = 1, .contacts = 1});
    for (const BodyId body : all_bodies(*w)) ADD_FAILURE() << body.index1;
    for (const JointId joint : all_joints(*w)) ADD_FAILURE() << joint.index1;
}

template <class Range>
auto listed(const Range& range) {
    std::vector<std::decay_t<decltype(*range.begin())>> all;
    for (const auto& item : range) all.push_back(item);
    return all;
}
bool same(const ContactInfo& a, const ContactInfo& b) {
    return a.shape_a == b.shape_a && a.shape_b == b.shape_b && a.normal == b.normal && a.point_count == b.point_count && a.points[0].point == b.points[0].point;
}

// A machine of joints of all types, a pile on compound bodies, and for each body and shape the lists that shapes, joints and contacts write.
TEST(Ranges, OfABodyOrShapeHoldWhatItsListsHold) {
    TestWorld w;
    w.add_ground();
    add_machine(*w, {0, 10});
    for (int i = 0; i < 12; ++i) {
        const BodyId body = w.add_box({static_cast<float>(i % 4) * 1.1f, 0.5f + static_cast<float>(i / 4)});
        w->create_shape(body, Circle{{0, 0.2f}, 0.5f});
        w->create_shape(body, make_offset_box(0.6f, 0.1f, {{0, 0}, {}}));
    }
    w.step(20);
    std::size_t most_shapes = 0, most_joints = 0, most_contacts = 0, most_of_shape = 0;
    const auto expect_contacts = [&](auto of, std::size_t& most) {
        std::vector<ContactInfo> expected(w->contacts(of, {}));
        w->contacts(of, expected);
        const std::vector<ContactInfo> found = listed(contacts_of(*w, of));
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) EXPECT_TRUE(same(found[i], expected[i]));
        most = std::max(most, found.size());
    };
    for (const BodyId body : all_bodies(*w)) {
        std::vector<ShapeId> shapes(w->shapes(body, {}));
        w->shapes(body, shapes);
        EXPECT_EQ(listed(shapes_of(*w, body)), shapes);
        std::vector<JointId> joints(w->joints(body, {}));
        w->joints(body, joints);
        EXPECT_EQ(listed(joints_of(*w, body)), joints);
        expect_contacts(body, most_contacts);
        for (const ShapeId shape : shapes) expect_contacts(shape, most_of_shape);
        most_shapes = std::max(most_shapes, shapes.size());
        most_joints = std::max(most_joints, joints.size());
    }
    EXPECT_GE(most_shapes, 3u);
    EXPECT_GE(most_joints, 2u);
    EXPECT_GE(most_contacts, 4u);
    EXPECT_GE(most_of_shape, 2u);
    EXPECT_TRUE(w.errors.empty());
}

TEST(Ranges, OfABodyMayLoseTheObjectTheyAreAt) {
    TestWorld w;
    const BodyId hub = w.add_box({0, 0});
    for (int i = 0; i < 5; ++i) {
        w->create_shape(hub, Circle{{static_cast<float>(i), 0}, 0.2f});
        RevoluteJointDef hinge;
        hinge.base.body_a = i % 2 == 0 ? hub : w.add_box({5, 5});
        hinge.base.body_b = i % 2 == 0 ? w.add_box({9, 9}) : hub;
        ASSERT_TRUE(w->create_joint(hinge));
    }
    int shapes = 0, joints = 0;
    for (const ShapeId shape : shapes_of(*w, hub)) {
        w->destroy_shape(shape);
        ++shapes;
    }
    for (const JointId joint : joints_of(*w, hub)) {
        w->destroy_joint(joint);
        ++joints;
    }
    EXPECT_EQ(shapes, 6);
    EXPECT_EQ(joints, 5);
    EXPECT_EQ(w->shapes(hub, {}) + w->joints(hub, {}), 0u);
    EXPECT_TRUE(w.errors.empty());
    EXPECT_EQ(w->validate(), nullptr);
}

TEST(Ranges, AreEmptyWhereThereIsNothing) {
    TestWorld w;
    const BodyId none = w->create_body({});
    EXPECT_TRUE(listed(shapes_of(*w, none)).empty() && listed(joints_of(*w, none)).empty() && listed(contacts_of(*w, none)).empty());
    EXPECT_TRUE(w.errors.empty());
    w->destroy_body(none);
    EXPECT_TRUE(listed(shapes_of(*w, none)).empty() && listed(joints_of(*w, none)).empty() && listed(contacts_of(*w, none)).empty());
    EXPECT_TRUE(listed(contacts_of(*w, ShapeId{})).empty());
    EXPECT_EQ(w.errors, (std::vector<Error>{Error::stale_id, Error::stale_id, Error::stale_id, Error::null_id}));
}

TEST(Ranges, RefuseToGoOnFromWhatIsAnotherBodys) {
    TestWorld w;
    const BodyId ground = w.add_ground();
    const BodyId a = w.add_box({0, 0.5f}), b = w.add_box({5, 0.5f}), c = w.add_box({10, 5});
    RevoluteJointDef hinge;
    hinge.base.body_a = a;
    hinge.base.body_b = b;
    const JointId joint = w->create_joint(hinge);
    w.step(3);
    ContactInfo contact;
    const std::uint32_t number = w->next_contact(a, 0, contact);
    ASSERT_NE(number, 0u);
    ASSERT_TRUE(contact.shape_a == w.shape_of(ground) || contact.shape_b == w.shape_of(ground));
    EXPECT_NE(w->next_contact(ground, 0, contact), 0u);
    w.errors.clear();
    const auto refused = [&](auto found) {
        EXPECT_FALSE(found);
        EXPECT_EQ(w->last_error(), Error::out_of_range);
        w->clear_error();
    };
    refused(w->next_shape(b, w.shape_of(a)));
    refused(w->next_joint(c, joint));
    refused(w->next_contact(b, number, contact));
    refused(w->next_contact(w.shape_of(b), number, contact));
    refused(w->next_contact(a, 4000, contact));
    refused(w->next_contact(a, 0xffffffffu, contact));
    EXPECT_EQ(w.errors.size(), 6u);
    w->destroy_joint(joint);
    EXPECT_FALSE(w->next_joint(a, joint));
    EXPECT_EQ(w->last_error(), Error::stale_id);
}

TEST(Ids, AreKeysOfContainers) {
    TestWorld w;
    std::unordered_map<BodyId, int, IdHash> scores;
    std::map<BodyId, int> ordered;
    for (int i = 0; i < 100; ++i) {
        const BodyId body = w.add_box({static_cast<float>(i), 0});
        scores[body] = ordered[body] = i;
        if (i % 3 == 0) w->destroy_body(body);  // the next one has the slot, and another generation
    }
    EXPECT_EQ(scores.size(), 100u);
    EXPECT_EQ(ordered.size(), 100u);
    std::unordered_set<ShapeId, IdHash> shapes_seen;
    for (const ShapeId shape : all_shapes(*w)) shapes_seen.insert(shape);
    EXPECT_EQ(shapes_seen.size(), w->shape_count());
    EXPECT_FALSE(BodyId{} < BodyId{});
    EXPECT_TRUE((BodyId{1, 9} < BodyId{2, 0}) && (BodyId{2, 0} < BodyId{2, 1}));
}

StaticWorld<Capacity{.bodies = 2, .shapes = 2, .contacts = 2}> held;

TEST(StaticWorld, GivesTheWorldThatItHolds) {
    World& made = held.create();
    EXPECT_EQ(&held.get(), &made);
    made.create_body({});
    EXPECT_EQ(held.get().body_count(), 1u);
    static_assert(!std::is_copy_constructible_v<decltype(held)> && !std::is_copy_assignable_v<decltype(held)>);
}

// -- a world in another block -----------------------------------------------------------------------------------------------------------

struct Copied {
    explicit Copied(const Capacity& room) : block(world_bytes(room)), capacity(room) {}
    World* of(const World& world) {
        std::vector<std::byte> image(world.snapshot_bytes());
        return copy_world(world, block.span(), capacity, image, &error);
    }
    Block block;
    Capacity capacity;
    Error error = Error::none;
};

TEST(CopyOfAWorld, GoesOnBitForBitAndHasRoomForMore) {
    TestWorld w({.bodies = 24, .shapes = 24, .contacts = 96, .joints = 16}, {.lanes = 1});
    w.add_ground();
    add_machine(*w, {0, 10});
    while (w->body_count() < 24) w.add_box({static_cast<float>(w->body_count()) * 0.3f, 1});
    w.step(20);
    ASSERT_FALSE(w->create_body({})) << "it is full";
    Copied copy({.bodies = 40, .shapes = 40, .contacts = 300, .joints = 16});
    World* const larger = copy.of(*w);
    ASSERT_NE(larger, nullptr) << describe(copy.error);
    EXPECT_EQ(larger->hash(), w->hash());
    EXPECT_EQ(larger->lanes(), 1u);
    for (int i = 0; i < 60; ++i) {
        w.step();
        larger->step(1.0f / 60);
        ASSERT_EQ(larger->hash(), w->hash()) << i;
    }
    for (const BodyId body : all_bodies(*w)) EXPECT_TRUE(larger->is_valid(body));
    EXPECT_TRUE(larger->create_body({}));
    EXPECT_EQ(larger->validate(), nullptr);
}

TEST(CopyOfAWorld, IsRefusedWhereThereIsNoRoom) {
    TestWorld w({.bodies = 8, .shapes = 8, .contacts = 8});
    for (int i = 0; i < 5; ++i) w.add_box({static_cast<float>(i), 0});
    Copied small({.bodies = 4, .shapes = 8, .contacts = 8});
    EXPECT_EQ(small.of(*w), nullptr);
    EXPECT_EQ(small.error, Error::image_too_large);
    Copied roomy_one({.bodies = 16, .shapes = 16, .contacts = 16});
    std::byte little[8];
    EXPECT_EQ(copy_world(*w, roomy_one.block.span(), roomy_one.capacity, little, &roomy_one.error), nullptr);
    EXPECT_EQ(roomy_one.error, Error::image_too_small);
    std::vector<std::byte> image(w->snapshot_bytes());
    EXPECT_EQ(copy_world(*w, roomy_one.block.span().first(100), roomy_one.capacity, image), nullptr);
    EXPECT_EQ(copy_world(*w, roomy_one.block.span(), {}, image, &roomy_one.error), nullptr);
    EXPECT_EQ(roomy_one.error, Error::bad_capacity);
    EXPECT_EQ(w->body_count(), 5u);
}

TEST(CopyOfAWorld, TakesHooksAlong) {
    static int asked = 0;
    asked = 0;
    TestWorld w;
    Hooks hooks;
    hooks.filter = [](ShapeId, ShapeId, void*) { return ++asked > 0; };
    w->set_hooks(hooks);
    Copied copy(roomy);
    World* const other = copy.of(*w);
    ASSERT_NE(other, nullptr);
    for (const float x : {0.0f, 0.1f}) other->create_shape(other->create_body({.type = BodyType::dynamic, .position = {x, 0}}), Circle{});
    other->step(1.0f / 60);
    EXPECT_EQ(asked, 1);
}

// -- drawing between two steps ----------------------------------------------------------------------------------------------------------

TEST(DrawnPoses, StandInForThoseOfTheBodies) {
    TestWorld w({.bodies = 4, .shapes = 4, .contacts = 4});
    const BodyId ball = w.add_circle({0, 0}), other = w.add_circle({100, 0});
    std::vector<Transform> poses(w->capacity().bodies);
    for (const BodyId body : all_bodies(*w)) poses[body.index1 - 1] = w->transform(body);
    w->set_transform(ball, {4, 8}, 0);
    w->set_transform(other, {100, 2}, 0);
    for (const BodyId body : all_bodies(*w)) poses[body.index1 - 1] = lerp(poses[body.index1 - 1], w->transform(body), 0.25f);
    std::vector<Vec2> centers;
    DebugDraw draw;
    draw.circle = [](Vec2 center, float, Vec2, const DrawStyle&, void* context) { static_cast<std::vector<Vec2>*>(context)->push_back(center); };
    draw.context = &centers;
    draw.poses = poses.data();
    w->draw(draw);
    EXPECT_EQ(centers, (std::vector{Vec2{1, 2}, Vec2{100, 0.5f}}));
    centers.clear();
    draw.view = {{-2, -2}, {2, 4}};
    w->draw(draw);
    EXPECT_EQ(centers, std::vector{(Vec2{1, 2})}) << "what is in view is asked of the poses, too";
}

}  // namespace
}  // namespace islet::test
