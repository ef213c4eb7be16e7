// Walking over all objects of a world in the order of their slots:
//
//     for (const islet::BodyId body : islet::all_bodies(world)) draw(world.transform(body));
//
// The loop's body may change the world; objects made meanwhile are visited if their slots come later.
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

}  // namespace detail

/// Ids of all bodies.
inline auto all_bodies(const World& of) { return detail::SlotRange<BodyId, detail::read_slot<BodyId, &World::body_at>>(of, of.capacity().bodies); }
/// Ids of all shapes.
inline auto all_shapes(const World& of) { return detail::SlotRange<ShapeId, detail::read_slot<ShapeId, &World::shape_at>>(of, of.capacity().shapes); }
/// Ids of all joints.
inline auto all_joints(const World& of) { return detail::SlotRange<JointId, detail::read_slot<JointId, &World::joint_at>>(of, of.capacity().joints); }
/// All contacts that touch, as ContactInfo.
inline auto all_contacts(const World& of) { return detail::SlotRange<ContactInfo, detail::read_contact_slot>(of, of.capacity().contacts); }

}  // namespace islet
ISLET_API_END
