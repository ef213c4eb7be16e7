#include "movie_maker.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "first_contacts.hpp"
#include "harness/checks.hpp"

namespace islet::tools {
namespace {

std::int32_t parts_of_turn(double angle, std::int32_t turn) {
    const double turns = angle / (2 * double(pi));
    return std::isfinite(turns) ? static_cast<std::int32_t>(std::llround(turns * turn)) & (turn - 1) : 0;
}

/// What the player needs of a shape that was drawn.
Outline outline_of(const Drawing& drawing, const Stroke& stroke) {
    const std::span<const Vec2> points = drawing.points(stroke);
    const bool is_circle = stroke.figure == Stroke::Figure::circle, is_line = stroke.figure == Stroke::Figure::segment;
    return {is_line ? -1 : stroke.radius, stroke.style.solid, {points.begin(), is_circle ? points.begin() + 1 : points.end()}};
}

std::string key_of(const Model& model) {
    std::string key;
    for (const Outline& outline : model) {
        key.append(reinterpret_cast<const char*>(&outline.radius), sizeof outline.radius);
        key += static_cast<char>((outline.solid ? '0' : 'A') + outline.points.size());
        key.append(reinterpret_cast<const char*>(outline.points.data()), outline.points.size() * sizeof(Vec2));
    }
    return key;
}

BodyLook look_of(DrawColor color) {
    switch (color) {
    case draw_color::static_body: return BodyLook::static_body;
    case draw_color::kinematic: return BodyLook::kinematic;
    case draw_color::asleep: return BodyLook::asleep;
    case draw_color::bullet: return BodyLook::bullet;
    case draw_color::disabled: return BodyLook::disabled;
    default: return BodyLook::awake;
    }
}

JointMark::Kind kind_of(Stroke::Figure figure) {
    switch (figure) {
    case Stroke::Figure::point: return JointMark::dot;
    case Stroke::Figure::circle: return JointMark::ring;
    case Stroke::Figure::polygon: return JointMark::loop;
    default: return JointMark::line;
    }
}

JointMark::Look joint_look_of(DrawColor color) {
    return color == draw_color::limit ? JointMark::limit : color == draw_color::idle_joint ? JointMark::idle : JointMark::plain;
}

/// Calls visit(strokes) for what is of the same slot, by rising slots.
template <class Visit>
void for_each_slot(std::vector<const Stroke*>& strokes, const Visit& visit) {
    const auto slot_of = [](const Stroke* stroke) { return stroke->style.slot; };
    std::stable_sort(strokes.begin(), strokes.end(), [&](const Stroke* a, const Stroke* b) { return slot_of(a) < slot_of(b); });
    for (auto first = strokes.begin(); first != strokes.end();) {
        const auto end = std::find_if(first, strokes.end(), [&](const Stroke* s) { return slot_of(s) != slot_of(*first); });
        visit(std::span<const Stroke* const>(first, end));
        first = end;
    }
}

/// m, how far two shapes overlap at most.
double deepest_contact(const World& world) {
    double deepest = 0;
    ContactInfo contact;
    for (std::uint32_t slot = 0; slot < world.capacity().contacts; ++slot) {
        if (!world.contact_at(slot, contact)) continue;
        for (std::uint32_t i = 0; i < contact.point_count; ++i) deepest = std::max(deepest, -double(contact.points[i].separation));
    }
    return deepest;
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

MovieMaker::MovieMaker(const Run& run, std::size_t budget) : run_(run), budget_(budget), scale_(run.scene.view) {
    const World& world = run.engine.world();
    known_.resize(world.capacity().bodies);
    shapes_.resize(world.capacity().shapes);
    // Joints are drawn as large as in a picture of the first moment that is as wide as the SVG's.
    constexpr double picture_width = 1200;  // px
    drawing_.add(world, {});
    what_.size = joint_mark_size(typical_size(drawing_), picture_width / (double(run.scene.view.upper.x) - double(run.scene.view.lower.x)));
    what_.contacts = what_.normals = true;
    record({});
}

void MovieMaker::observe(const StepRecord& step) {
    if (keeps(step.step)) record(step);
    const auto size = [this] { return writer_.bytes().size() + numbers_.size() * sizeof(FrameNumbers); };
    while (size() > budget_ && numbers_.size() > 2) thin();
}

void MovieMaker::record(const StepRecord& step) {
    FrameNumbers numbers;
    const EngineCounts counts = run_.engine.counts();
    numbers.step = step.step;
    numbers.ms = step.ms;
    numbers.kinetic_energy = kinetic_energy(run_.engine);
    numbers.potential_energy = potential_energy(run_.engine, run_.scene.world.gravity);
    numbers.bodies = counts.bodies;
    // Before the first step the world knows no contacts.
    std::optional<FirstContacts> first;
    if (run_.engine.world().step_count() == 0) first.emplace(run_.engine.world());
    const World& touching = first ? first->world() : run_.engine.world();
    numbers.contacts = touching.contact_count();
    numbers.islands = touching.report().islands;
    numbers.joints = counts.joints;
    // Before the first step nobody has measured it yet.
    numbers.max_joint_error = double(step.step > 0 ? step.joint_error.linear : run_.engine.max_joint_error().linear);
    numbers.max_penetration = deepest_contact(touching);

    drawing_.clear();
    DebugDraw only_contacts = what_, others = what_;
    only_contacts.shapes = only_contacts.joints = false;
    others.contacts = others.normals = false;
    drawing_.add(run_.engine.world(), others);
    drawing_.add(touching, only_contacts);
    std::vector<const Stroke*> shapes, contacts, joints;
    for (const Stroke& stroke : drawing_.strokes()) {
        const DrawPart part = stroke.style.part;
        (part == DrawPart::shape ? shapes : part == DrawPart::joint ? joints : contacts).push_back(&stroke);
    }
    frame_.bodies.clear();
    frame_.contacts.clear();
    frame_.joints.clear();
    for_each_slot(shapes, [&](Strokes strokes) { read_body(strokes, numbers); });
    for_each_slot(contacts, [&](Strokes strokes) { read_contact(strokes, numbers); });
    for_each_slot(joints, [&](Strokes strokes) { read_joint(strokes); });
    writer_.add(frame_, figures_.figures());
    numbers_.push_back(numbers);
}

/// A body is drawn by its shapes; where it is goes into the frame, and what they look like from there is its model.
void MovieMaker::read_body(Strokes shapes, FrameNumbers& numbers) {
    const World& world = run_.engine.world();
    const BodyId body = world.body_at(shapes.front()->style.slot);
    const Vec2 p = world.position(body);
    const std::uint32_t id = id_of(shapes, body);
    frame_.bodies.put(id, {scale_.x(double(p.x)), scale_.y(double(p.y)), parts_of_turn(double(world.angle(body)), body_turn)});
    const auto solid = std::find_if(shapes.begin(), shapes.end(), [](const Stroke* shape) { return shape->style.solid; });
    frame_.looks[id] = solid != shapes.end() ? look_of((*solid)->style.color) : BodyLook::static_body;
    looks_.insert(frame_.looks[id]);
    if (world.type(body) != BodyType::static_body && world.is_awake(body)) ++numbers.awake_bodies;
}

/// The body's id in the movie: a new one if the slot has another body now, or if the one it had would no longer show what was drawn.
std::uint32_t MovieMaker::id_of(Strokes shapes, BodyId body) {
    Known& known = known_[shapes.front()->style.slot];
    if (known.body == body && shows(models_[known.model], shapes, run_.engine.world().transform(body))) return known.id;
    const auto id = static_cast<std::uint32_t>(frame_.bodies.size());
    known = {body, model_of(shapes, body), id};
    frame_.bodies.resize(id + 1);
    frame_.looks.resize(id + 1);
    frame_.models.push_back(known.model);
    return id;
}

bool MovieMaker::shows(const Model& model, Strokes shapes, const Transform& pose) const {
    const auto is_shown = [&](const Outline& known, const Stroke* shape) {
        const Outline drawn = outline_of(drawing_, *shape);
        const auto is_there = [&](Vec2 a, Vec2 b) { return double(distance(transform_point(pose, a), b)) <= scale_.quantum; };
        return known.radius == drawn.radius && known.solid == drawn.solid &&
               std::equal(known.points.begin(), known.points.end(), drawn.points.begin(), drawn.points.end(), is_there);
    };
    return std::equal(model.begin(), model.end(), shapes.begin(), shapes.end(), is_shown);
}

/// The shapes drawn in the body's frame, without the rounding of where it is. Bodies of the same shapes share a model.
std::uint32_t MovieMaker::model_of(Strokes shapes, BodyId body) {
    const World& world = run_.engine.world();
    std::vector<ShapeId> ids(shapes_.begin(), shapes_.begin() + world.shapes(body, shapes_));
    std::sort(ids.begin(), ids.end(), [](ShapeId a, ShapeId b) { return a.index1 < b.index1; });  // as World::draw goes
    Drawing local;
    for (const ShapeId shape : ids) local.add_shape(world, shape);
    Model model;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        model.push_back(outline_of(local, local.strokes()[i]));
        model.back().solid = shapes[i]->style.solid;
    }
    const auto [entry, is_new] = model_index_.try_emplace(key_of(model), static_cast<std::uint32_t>(models_.size()));
    if (is_new) models_.push_back(std::move(model));
    return entry->second;
}

/// Of each point a dot is drawn and then, if the surfaces touch there, its normal. A contact has the same slot for as long as it lasts: its points have two
/// ids of their own.
void MovieMaker::read_contact(Strokes dots_and_normals, FrameNumbers& numbers) {
    std::size_t next = 2 * std::size_t{dots_and_normals.front()->style.slot};  // id of the next point
    bool touches = false;
    for (const Stroke* stroke : dots_and_normals) {
        if (stroke->style.part == DrawPart::contact) {
            ++next;
            continue;
        }
        touches = true;
        if (!has_contacts_) break;
        const Vec2 from = drawing_.points(*stroke)[0], way = drawing_.points(*stroke)[1] - from;
        const std::int32_t x = scale_.quanta((double(from.x) - scale_.origin_x) / contact_quanta);
        const std::int32_t y = scale_.quanta((double(from.y) - scale_.origin_y) / contact_quanta);
        frame_.contacts.put(next - 1, {x, y, parts_of_turn(std::atan2(double(way.y), double(way.x)), contact_turn)});
    }
    if (touches) ++numbers.touching;
}

QuantaPoint MovieMaker::exact_quanta(Vec2 place) const {
    return {(double(place.x) - scale_.origin_x) / scale_.quantum, (double(place.y) - scale_.origin_y) / scale_.quantum};
}

std::uint32_t MovieMaker::frame_of(BodyId body, QuantaPose& pose) const {
    if (!body) return 0;
    const Known& known = known_[body.index1 - 1];
    if (known.body != body || !frame_.bodies.has(known.id)) return 0;
    const World& world = run_.engine.world();
    const double angle = double(world.angle(body));
    pose = {exact_quanta(world.position(body)), std::cos(angle), std::sin(angle)};
    return known.id + 1;
}

void MovieMaker::read_joint(Strokes marks) {
    const World& world = run_.engine.world();
    const std::uint32_t slot = marks.front()->style.slot;
    const JointId joint = world.joint_at(slot);
    JointFrames frames;
    frames.id_a = frame_of(world.body_a(joint), frames.a);
    frames.id_b = frame_of(world.body_b(joint), frames.b);
    drawn_joint_.marks.clear();
    drawn_joint_.points.clear();
    for (const Stroke* stroke : marks) {
        const JointMark::Kind kind = kind_of(stroke->figure);
        // A ring does not show how it turns.
        const std::span<const Vec2> points = drawing_.points(*stroke).first(kind == JointMark::ring ? 1 : stroke->point_count);
        const std::int32_t radius = kind == JointMark::ring ? scale_.quanta(double(stroke->radius)) : 0;
        drawn_joint_.marks.push_back({kind, joint_look_of(stroke->style.color), radius, static_cast<std::uint32_t>(points.size())});
        for (const Vec2 p : points) drawn_joint_.points.push_back(exact_quanta(p));
    }
    find_ends(drawn_joint_, frames);
    frame_.joints.put(slot, figures_.entry_of(slot, drawn_joint_, frames));
}

bool MovieMaker::keeps(int step) const { return step % stride_ == 0 || step == run_.scene.steps; }

void MovieMaker::thin() {
    // Thirty frames a second still look smooth; of thousands of contacts there is little to see, yet they are most of a movie's bytes.
    if (stride_ == 1 || !has_contacts_)
        stride_ *= 2;
    else
        has_contacts_ = false;
    MovieReader reader(writer_.bytes());
    MovieWriter thinner;
    std::vector<FrameNumbers> kept;
    for (const FrameNumbers& numbers : numbers_) {
        reader.next();
        if (!keeps(numbers.step)) continue;
        Frame frame = reader.frame();
        if (!has_contacts_) frame.contacts.clear();
        thinner.add(frame, reader.figures());
        kept.push_back(numbers);
    }
    writer_ = std::move(thinner);
    numbers_ = std::move(kept);
}

}  // namespace islet::tools
