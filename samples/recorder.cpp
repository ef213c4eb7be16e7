#include "recorder.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "scenes/checks.hpp"

namespace islet::samples {
namespace {

constexpr float touching = 0.005f;  // m; points farther apart than this are only watched by the solver

std::int32_t parts_of_turn(double angle, std::int32_t turn) {
    const double turns = angle / (2 * double(pi));
    return std::isfinite(turns) ? static_cast<std::int32_t>(std::llround(turns * turn)) & (turn - 1) : 0;
}

/// A shape in its body's frame: what DebugDraw says of its geometry alone.
Outline outline_of(const World& world, ShapeId shape) {
    Outline outline;
    DebugDraw draw;
    draw.context = &outline;
    static constexpr auto keep = [](void* to, float radius, std::vector<Vec2> points) { *static_cast<Outline*>(to) = {radius, std::move(points)}; };
    draw.circle = [](Vec2 center, float radius, Vec2, const DrawStyle&, void* to) { keep(to, radius, {center}); };
    draw.capsule = [](Vec2 a, Vec2 b, float radius, const DrawStyle&, void* to) { keep(to, radius, {a, b}); };
    draw.polygon = [](std::span<const Vec2> p, float radius, const DrawStyle&, void* to) { keep(to, radius, {p.begin(), p.end()}); };
    draw.segment = [](Vec2 a, Vec2 b, const DrawStyle&, void* to) { keep(to, -1, {a, b}); };
    world.draw_shape(draw, shape, {}, {});
    return outline;
}

std::string key_of(const Model& model) {
    std::string key;
    for (const Outline& outline : model) {
        key.append(reinterpret_cast<const char*>(&outline.radius), sizeof outline.radius);
        key += static_cast<char>('0' + outline.points.size());
        key.append(reinterpret_cast<const char*>(outline.points.data()), outline.points.size() * sizeof(Vec2));
    }
    return key;
}

/// The same line but for rounding.
bool nearly_same(const JointLine& a, const JointLine& b) {
    constexpr int rounding = 2;  // quanta
    const auto same_point = [](const JointPoint& p, const JointPoint& q) {
        return p.frame == q.frame && p.is_dot == q.is_dot && std::abs(p.x - q.x) <= rounding && std::abs(p.y - q.y) <= rounding;
    };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_point);
}

}  // namespace

Scale::Scale(const Aabb& view)
    : origin_x(0.5 * (double(view.lower.x) + double(view.upper.x))), origin_y(0.5 * (double(view.lower.y) + double(view.upper.y))) {
    const double extent = std::max(double(view.upper.x) - double(view.lower.x), double(view.upper.y) - double(view.lower.y));
    quantum = std::exp2(std::clamp(std::floor(std::log2(extent / 65536)), -20.0, 10.0));
}

std::int32_t Scale::quanta(double metres) const {
    const double n = metres / quantum;
    return std::isfinite(n) ? static_cast<std::int32_t>(std::lround(std::clamp(n, -double(farthest), double(farthest)))) : 0;
}

Recorder::Recorder(const Run& run, std::size_t budget) : run_(run), budget_(budget), scale_(run.scene.view) {
    known_.resize(run.engine.world().capacity().bodies);
    shapes_.resize(run.engine.world().capacity().shapes);
    record({});
}

void Recorder::observe(const StepRecord& step) {
    if (keeps(step.step)) record(step);
    const auto size = [this] { return writer_.bytes().size() + numbers_.size() * sizeof(FrameNumbers); };
    while (size() > budget_ && numbers_.size() > 2) thin();
}

void Recorder::record(const StepRecord& step) {
    FrameNumbers numbers;
    const EngineCounts counts = run_.engine.counts();
    numbers.step = step.step;
    numbers.ms = step.ms;
    numbers.kinetic_energy = kinetic_energy(run_.engine);
    numbers.potential_energy = potential_energy(run_.engine, run_.scene.world.gravity);
    numbers.bodies = counts.bodies;
    numbers.contacts = counts.contacts;
    numbers.islands = counts.islands;
    read_bodies();
    for (std::size_t id = 0; id < frame_.bodies.size(); ++id) {
        const bool moves = frame_.bodies.has(id) && frame_.kinds[id].type != static_cast<std::uint32_t>(BodyType::static_body);
        if (moves && frame_.awake[id] != 0) ++numbers.awake_bodies;
    }
    read_contacts(numbers);
    read_joints(numbers);
    writer_.add(frame_);
    numbers_.push_back(numbers);
}

void Recorder::read_bodies() {
    const World& world = run_.engine.world();
    frame_.bodies.clear();
    for (std::uint32_t slot = 0; slot < world.capacity().bodies; ++slot) {
        const BodyId body = world.body_at(slot);
        if (!body) continue;
        const std::uint32_t id = id_of(slot, body);
        const Vec2 p = world.position(body);
        frame_.bodies.put(id, {scale_.x(double(p.x)), scale_.y(double(p.y)), parts_of_turn(double(world.angle(body)), body_turn)});
        frame_.awake[id] = world.type(body) == BodyType::static_body || world.is_awake(body) ? 1 : 0;
    }
}

/// The body's id in the recording: a new one if the slot has another body now, or if its type or shapes have changed.
std::uint32_t Recorder::id_of(std::uint32_t slot, BodyId body) {
    const World& world = run_.engine.world();
    Known& known = known_[slot];
    const BodyType type = world.type(body);
    const std::span<const ShapeId> shapes(shapes_.data(), world.shapes(body, shapes_));
    if (known.body == body && known.type == type && std::equal(shapes.begin(), shapes.end(), known.shapes.begin(), known.shapes.end()))
        return known.id;
    const auto id = static_cast<std::uint32_t>(frame_.bodies.size());
    known = {body, type, {shapes.begin(), shapes.end()}, id};
    frame_.bodies.resize(id + 1);
    frame_.awake.resize(id + 1);
    frame_.kinds.push_back({static_cast<std::uint32_t>(type), model_of(known.shapes)});
    return id;
}

/// Bodies of the same shapes share a model.
std::uint32_t Recorder::model_of(const std::vector<ShapeId>& shapes) {
    Model model;
    // A body tells its newest shape first; drawn in the order they were made, later ones lie on top.
    for (auto shape = shapes.rbegin(); shape != shapes.rend(); ++shape) model.push_back(outline_of(run_.engine.world(), *shape));
    const auto [entry, is_new] = model_index_.try_emplace(key_of(model), static_cast<std::uint32_t>(models_.size()));
    if (is_new) models_.push_back(std::move(model));
    return entry->second;
}

/// A contact has the same slot for as long as it lasts: its points have two ids of their own.
void Recorder::read_contacts(FrameNumbers& numbers) {
    const World& world = run_.engine.world();
    frame_.contacts.clear();
    ContactInfo contact;
    for (std::uint32_t slot = 0; slot < world.capacity().contacts; ++slot) {
        if (!world.contact_at(slot, contact)) continue;
        bool touches = false;
        for (std::uint32_t i = 0; i < contact.point_count; ++i) {
            const ContactPoint& point = contact.points[i];
            numbers.max_penetration = std::max(numbers.max_penetration, -double(point.separation));
            if (point.separation >= touching) continue;
            touches = true;
            if (!has_contacts_) continue;
            const double angle = std::atan2(double(contact.normal.y), double(contact.normal.x));
            const std::int32_t x = scale_.quanta((double(point.point.x) - scale_.origin_x) / contact_quanta);
            const std::int32_t y = scale_.quanta((double(point.point.y) - scale_.origin_y) / contact_quanta);
            frame_.contacts.put(2 * std::size_t{slot} + i, {x, y, parts_of_turn(angle, contact_turn)});
        }
        if (touches) ++numbers.touching;
    }
}

JointPoint Recorder::quantised(const RecordedJoint::Point& point) const {
    if (!point.body) return {0, point.is_anchor, scale_.x(double(point.place.x)), scale_.y(double(point.place.y))};
    const Vec2 local = inv_transform_point(run_.engine.world().transform(point.body), point.place);
    return {known_[point.body.index1 - 1].id + 1, point.is_anchor, scale_.quanta(double(local.x)), scale_.quanta(double(local.y))};
}

void Recorder::read_joints(FrameNumbers& numbers) {
    const World& world = run_.engine.world();
    Table<JointLine>& joints = frame_.joints;
    joints.clear();
    JointLine line;
    for (const RecordedJoint& joint : collect_joints(world)) {
        line.clear();
        for (const RecordedJoint::Point& point : joint.line) line.push_back(quantised(point));
        // What is fixed to a body comes back from the world with its last digits shaken: only a real move is written.
        if (joint.slot < joints.size() && nearly_same(joints.entries[joint.slot], line))
            joints.live[joint.slot] = 1;
        else
            joints.put(joint.slot, line);
        ++numbers.joints;
        numbers.max_joint_error = std::max(numbers.max_joint_error, joint.linear_error);
    }
}

bool Recorder::keeps(int step) const { return step % stride_ == 0 || step == run_.scene.steps; }

void Recorder::thin() {
    // Thirty frames a second still look smooth; of thousands of contacts there is little to see, yet they are most of a recording's bytes.
    if (stride_ == 1 || !has_contacts_)
        stride_ *= 2;
    else
        has_contacts_ = false;
    RecordingReader reader(writer_.bytes());
    RecordingWriter thinner;
    std::vector<FrameNumbers> kept;
    for (const FrameNumbers& numbers : numbers_) {
        reader.next();
        if (!keeps(numbers.step)) continue;
        Frame frame = reader.frame();
        if (!has_contacts_) frame.contacts.clear();
        thinner.add(frame);
        kept.push_back(numbers);
    }
    writer_ = std::move(thinner);
    numbers_ = std::move(kept);
}

}  // namespace islet::samples
