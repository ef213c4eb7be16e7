// Walking over all objects of a world in the order of their slots, and over those of one body or shape, newest first:
//
//     for (const islet::BodyId body : islet::all_bodies(world)) draw(world.transform(body));
//     for (const islet::ShapeId shape : islet::shapes_of(world, body)) world.set_friction(shape, 0);
//
// The body of a loop over all objects may change the world; objects made meanwhile are visited if their slots come later. In a loop over the shapes or joints
// of a body it may destroy the one that it is at, but no other one of these (a joint's gears die with it); in a loop over contacts it may change nothing. A
// range of a body or shape that does not exist is empty, and an error of the world (stale_id, null_id).
#pragma once

#include <cstdint>

#include "islet/world.hpp"

ISLET_API_BEGIN
namespace islet {

namespace detail {

/// The objects that `Read` finds: bool(const World&, slot, Item&), false for a slot that is free.
template <class Item, auto Read>
class SlotRange {
public:
    class Iterator {
    public:
        Iterator(const World& of, std::uint32_t slot, std::uint32_t end) : world_(&of), slot_(slot), end_(end) { skip(); }
        const Item& operator*() const { return item_; }
        Iterator& operator++() {
            ++slot_;
            skip();
            return *this;
        }
        bool operator!=(const Iterator& other) const { return slot_ != other.slot_; }

    private:
        void skip() {
            while (slot_ < end_ && !Read(*world_, slot_, item_)) ++slot_;
        }

        const World* world_;
        std::uint32_t slot_, end_;
        Item item_ = {};
    };

    SlotRange(const World& of, std::uint32_t slots) : world_(&of), slots_(slots) {}
    Iterator begin() const { return {*world_, 0, slots_}; }
    Iterator end() const { return {*world_, slots_, slots_}; }

private:
    const World* world_;
    std::uint32_t slots_;
};

template <class Id, Id (World::*at)(std::uint32_t) const>
bool read_slot(const World& of, std::uint32_t slot, Id& id) {
    return static_cast<bool>(id = (of.*at)(slot));
}
inline bool read_contact_slot(const World& of, std::uint32_t slot, ContactInfo& contact) { return of.contact_at(slot, contact); }

/// The shapes or joints of a body: `Next` gives the one after another.
template <class Id, Id (World::*Next)(BodyId, Id) const>
class ListRange {
public:
    class Iterator {
    public:
        Iterator() = default;
        Iterator(const World& of, BodyId body) : world_(&of), body_(body), item_((of.*Next)(body, {})) { look_ahead(); }
        const Id& operator*() const { return item_; }
        Iterator& operator++() {
            item_ = next_;
            look_ahead();
            return *this;
        }
        bool operator!=(const Iterator& other) const { return item_ != other.item_; }

    private:
        void look_ahead() { next_ = item_ ? (world_->*Next)(body_, item_) : Id{}; }  // before the loop's body may destroy the item

        const World* world_ = nullptr;
        BodyId body_ = {};
        Id item_ = {}, next_ = {};
    };

    ListRange(const World& of, BodyId body) : world_(&of), body_(body) {}
    Iterator begin() const { return {*world_, body_}; }
    Iterator end() const { return {}; }

private:
    const World* world_;
    BodyId body_;
};

/// The touching contacts of a body or a shape.
template <class Id>
class ContactRange {
public:
    class Iterator {
    public:
        Iterator() = default;
        Iterator(const World& of, Id id) : world_(&of), id_(id), number_(of.next_contact(id, 0, contact_)) {}
        const ContactInfo& operator*() const { return contact_; }
        Iterator& operator++() {
            number_ = world_->next_contact(id_, number_, contact_);
            return *this;
        }
        bool operator!=(const Iterator& other) const { return number_ != other.number_; }

    private:
        const World* world_ = nullptr;
        Id id_ = {};
        ContactInfo contact_ = {};
        std::uint32_t number_ = 0;
    };

    ContactRange(const World& of, Id id) : world_(&of), id_(id) {}
    Iterator begin() const { return {*world_, id_}; }
    Iterator end() const { return {}; }

private:
    const World* world_;
    Id id_;
};

}  // namespace detail

/// Ids of all bodies.
inline auto all_bodies(const World& of) { return detail::SlotRange<BodyId, detail::read_slot<BodyId, &World::body_at>>(of, of.capacity().bodies); }
/// Ids of all shapes.
inline auto all_shapes(const World& of) { return detail::SlotRange<ShapeId, detail::read_slot<ShapeId, &World::shape_at>>(of, of.capacity().shapes); }
/// Ids of all joints.
inline auto all_joints(const World& of) { return detail::SlotRange<JointId, detail::read_slot<JointId, &World::joint_at>>(of, of.capacity().joints); }
/// All contacts that touch, as ContactInfo.
inline auto all_contacts(const World& of) { return detail::SlotRange<ContactInfo, detail::read_contact_slot>(of, of.capacity().contacts); }

/// Ids of the body's shapes.
inline auto shapes_of(const World& of, BodyId body) { return detail::ListRange<ShapeId, &World::next_shape>(of, body); }
/// Ids of the body's joints.
inline auto joints_of(const World& of, BodyId body) { return detail::ListRange<JointId, &World::next_joint>(of, body); }
/// The body's touching contacts, as ContactInfo.
inline auto contacts_of(const World& of, BodyId body) { return detail::ContactRange<BodyId>(of, body); }
/// The shape's touching contacts, as ContactInfo.
inline auto contacts_of(const World& of, ShapeId shape) { return detail::ContactRange<ShapeId>(of, shape); }

}  // namespace islet
ISLET_API_END
