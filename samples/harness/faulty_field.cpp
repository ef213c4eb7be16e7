#include "faulty_field.hpp"

#include <utility>

#include "scene_fields.hpp"
#include "spawn.hpp"

namespace islet::samples {
namespace {

/// Gives the first so many fields of a definition their defaults, and knows the last of them.
class Restored {
public:
    explicit Restored(int count) : left_(count) {}

    template <class T>
    void operator()(const char* name, T& value, const T& usual) {
        if constexpr (requires(Restored & io) { fields(io, value, usual); }) {
            const std::string outer = prefix_;
            prefix_ += std::string(name) + ".";
            fields(*this, value, usual);
            prefix_ = outer;
        } else if (left_ > 0) {
            --left_;
            value = usual;
            last_ = prefix_ + name;
        }
    }
    /// No more fields than were to be restored.
    bool is_all() const { return left_ > 0; }
    const std::string& last() const { return last_; }

private:
    int left_;
    std::string prefix_, last_;
};

/// The field whose default, after those before it have theirs, makes it good: each of those left it bad. `visit` shows a definition's fields to what it is given.
template <class Def, class Visit, class IsGood>
std::string first_cure(const Def& def, const Visit& visit, const IsGood& is_good) {
    for (int count = 1;; ++count) {
        Def trial = def;
        Restored restored(count);
        visit(restored, trial);
        if (restored.is_all()) return {};
        if (is_good(trial)) return restored.last();
    }
}

constexpr auto visit_fields = [](Restored& io, auto& def) { fields(io, def, std::remove_cvref_t<decltype(def)>{}); };

bool can_make(World& world, const SceneBody& body) {
    world.clear_error();
    const BodyId id = spawn(world, body);
    const bool is_good = world.last_error() == Error::none;
    if (id) world.destroy_body(id);
    return is_good;
}

}  // namespace

std::string faulty_field(World& world, const SceneBody& body) {
    const auto bare = [](const BodyDef& def) { return SceneBody{def, {}}; };
    if (!can_make(world, bare(body.def)))
        return first_cure(body.def, visit_fields, [&](const BodyDef& def) { return can_make(world, bare(def)); });
    for (std::size_t i = 0; i < body.shapes.size(); ++i) {
        const auto with = [&](const ShapeDef& def) { return SceneBody{body.def, {{body.shapes[i].geometry, def}}}; };
        if (can_make(world, with(body.shapes[i].def))) continue;
        const std::string field =
            first_cure(body.shapes[i].def, visit_fields, [&](const ShapeDef& def) { return can_make(world, with(def)); });
        const std::string place = "shapes[" + std::to_string(i) + "].";
        return place + (field.empty() ? geometry_names[body.shapes[i].geometry.index()] : field);
    }
    return {};
}

std::string faulty_field(World& world, const SceneJoint& joint, std::span<const BodyId> bodies, std::span<const JointId> joints) {
    const auto is_good = [&](const auto& def) {
        world.clear_error();
        const JointId id = spawn(world, SceneJoint{joint.body_a, joint.body_b, def}, bodies, joints);
        if (id) world.destroy_joint(id);
        return world.last_error() == Error::none;
    };
    const auto visit = [](Restored& io, auto& def) { joint_fields(io, def, std::remove_cvref_t<decltype(def)>{}); };
    return std::visit([&](const auto& def) { return first_cure(def, visit, is_good); }, joint.def);
}

std::string faulty_field(const WorldDef& def, const std::function<bool(const WorldDef&)>& is_good) {
    return first_cure(def, visit_fields, is_good);
}

}  // namespace islet::samples
