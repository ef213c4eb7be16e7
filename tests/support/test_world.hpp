// The one way to make a world in a test: on the host, of any capacity, with short words for what tests drop into it.
#pragma once

#include <cstdint>
#include <new>
#include <span>
#include <vector>

#include "islet/islet.hpp"

namespace islet::test {

/// Room enough for most tests.
inline constexpr Capacity roomy{.bodies = 512, .shapes = 1024, .contacts = 4096, .joints = 512};

/// A block of memory aligned as World::create demands.
class Block {
public:
    explicit Block(std::size_t bytes)
        : size_(bytes), data_(static_cast<std::byte*>(::operator new (bytes, std::align_val_t{world_alignment}))) {}
    ~Block() { ::operator delete (data_, std::align_val_t{world_alignment}); }
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;
    std::span<std::byte> span() const { return {data_, size_}; }

private:
    std::size_t size_;
    std::byte* data_;
};

/// A world and the errors it reported. Not copyable, does not move.
class TestWorld {
public:
    explicit TestWorld(const Capacity& capacity = roomy, WorldDef def = {}) : block_(world_bytes(capacity)) {
        def.error_hook = [](Error error, void* self) { static_cast<TestWorld*>(self)->errors.push_back(error); };
        def.error_context = this;
        world_ = World::create(block_.span(), capacity, def);
    }

    World& operator*() const { return *world_; }
    World* operator->() const { return world_; }
    /// Null if the definition was refused; the reason is in `errors`.
    World* get() const { return world_; }

    // -- bodies with one shape ---------------------------------------------------------------------------------------------------

    template <class Geometry>
    BodyId add(const Geometry& geometry, const BodyDef& body, const ShapeDef& shape = {}) {
        const BodyId id = world_->create_body(body);
        if (id) world_->create_shape(id, geometry, shape);
        return id;
    }
    template <class Geometry>
    BodyId add(const Geometry& geometry, Vec2 center, const ShapeDef& shape = {}, BodyType type = BodyType::dynamic) {
        BodyDef body;
        body.type = type;
        body.position = center;
        return add(geometry, body, shape);
    }
    /// A static floor whose top is at height `top`.
    BodyId add_ground(float top = 0, float half_width = 100, const ShapeDef& shape = {}) {
        return add(make_box(half_width, 1), Vec2{0, top - 1}, shape, BodyType::static_body);
    }
    BodyId add_box(Vec2 center, float hx = 0.5f, float hy = 0.5f, const ShapeDef& shape = {}, BodyType type = BodyType::dynamic) {
        return add(make_box(hx, hy), center, shape, type);
    }
    BodyId add_circle(Vec2 center, float radius = 0.5f, const ShapeDef& shape = {}, BodyType type = BodyType::dynamic) {
        return add(Circle{{0, 0}, radius}, center, shape, type);
    }
    BodyId add_capsule(Vec2 center, float half_length = 0.5f, float radius = 0.25f, const ShapeDef& shape = {},
                       BodyType type = BodyType::dynamic) {
        return add(Capsule{{-half_length, 0}, {half_length, 0}, radius}, center, shape, type);
    }
    /// The newest shape of a body.
    ShapeId shape_of(BodyId body) const {
        ShapeId id;
        world_->shapes(body, {&id, 1});
        return id;
    }

    /// The body's joints, newest first.
    std::vector<JointId> joints_of(BodyId body) const {
        std::vector<JointId> all(world_->joints(body, {}));
        world_->joints(body, all);
        return all;
    }

    // -- time --------------------------------------------------------------------------------------------------------------------

    void step(int steps = 1, float dt = 1.0f / 60) {
        for (int i = 0; i < steps; ++i) world_->step(dt);
    }

    // -- reading -----------------------------------------------------------------------------------------------------------------

    std::vector<BodyId> bodies() const {
        std::vector<BodyId> all;
        for (std::uint32_t slot = 0; slot < world_->capacity().bodies; ++slot)
            if (const BodyId id = world_->body_at(slot)) all.push_back(id);
        return all;
    }
    /// The touching contacts, by slot.
    std::vector<ContactInfo> contacts() const {
        std::vector<ContactInfo> all;
        ContactInfo info;
        for (std::uint32_t slot = 0; slot < world_->capacity().contacts; ++slot)
            if (world_->contact_at(slot, info)) all.push_back(info);
        return all;
    }
    /// True if every body's pose and velocity is finite.
    bool is_finite() const {
        for (const BodyId id : bodies()) {
            const Transform pose = world_->transform(id);
            if (!islet::is_finite(pose.p) || !islet::is_finite(Vec2{pose.q.c, pose.q.s})) return false;
            if (!islet::is_finite(world_->linear_velocity(id)) || !islet::is_finite(world_->angular_velocity(id))) return false;
        }
        return true;
    }

    /// Every error the world reported through its hook, in order.
    std::vector<Error> errors;

private:
    Block block_;
    World* world_ = nullptr;
};

}  // namespace islet::test
