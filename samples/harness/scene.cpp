// How much room a scene needs.
#include "scene.hpp"

#include <algorithm>
#include <set>

namespace islet::samples {
namespace {

void append_floats(std::string& bytes, std::initializer_list<Vec2> points, float radius) {
    for (const Vec2 p : points) bytes.append(reinterpret_cast<const char*>(&p), sizeof p);
    bytes.append(reinterpret_cast<const char*>(&radius), sizeof radius);
}

/// The geometry's numbers as bytes, headed by its kind: equal exactly for geometries that a world stores once. Chains are not asked.
std::string key_of(const SceneGeometry& geometry) {
    std::string bytes(1, static_cast<char>('0' + geometry.index()));
    if (const auto* circle = std::get_if<Circle>(&geometry)) append_floats(bytes, {circle->center}, circle->radius);
    if (const auto* capsule = std::get_if<Capsule>(&geometry)) append_floats(bytes, {capsule->point1, capsule->point2}, capsule->radius);
    if (const auto* segment = std::get_if<Segment>(&geometry)) append_floats(bytes, {segment->point1, segment->point2}, 0);
    if (const auto* half_space = std::get_if<HalfSpace>(&geometry)) append_floats(bytes, {half_space->normal}, half_space->offset);
    if (const auto* polygon = std::get_if<Polygon>(&geometry)) {
        for (std::uint32_t i = 0; i < polygon->count; ++i)
            append_floats(bytes, {polygon->vertices[i], polygon->normals[i]}, polygon->radius);
    }
    return bytes;
}

std::uint32_t chain_segments(const Chain& chain) {
    const auto points = static_cast<std::uint32_t>(chain.points.size());
    return chain.loop ? points : points - std::min(points, 1u);
}

}  // namespace

Capacity capacity_of(const Scene& scene) {
    std::uint64_t shapes = 0, moving_shapes = 0, chain_geometries = 0;
    std::set<std::string> geometries;
    for (const SceneBody& body : scene.bodies) {
        for (const SceneShape& shape : body.shapes) {
            std::uint32_t count = 1;
            if (const auto* chain = std::get_if<Chain>(&shape.geometry)) {
                count = chain_segments(*chain);
                chain_geometries += count;
            } else {
                geometries.insert(key_of(shape.geometry));
            }
            shapes += count;
            if (body.def.type != BodyType::static_body) moving_shapes += count;
        }
    }
    shapes += scene.extra_shapes;
    moving_shapes += scene.extra_shapes;
    // A dense pile has 3 to 5 pairs of overlapping fat boxes a shape; the rest is room for a pile being squeezed.
    constexpr std::uint32_t pairs_per_shape = 7, spare_pairs = 32;
    // A file may ask for more than can be: no world has such a capacity, and none is made.
    const auto room = [](std::uint64_t n) { return static_cast<std::uint32_t>(std::min<std::uint64_t>(n, 0xffffffffu)); };
    Capacity capacity;
    capacity.bodies = std::max(1u, room(scene.bodies.size() + std::uint64_t{scene.extra_bodies}));
    capacity.shapes = std::max(1u, room(shapes));
    capacity.contacts = room(pairs_per_shape * moving_shapes + spare_pairs + scene.extra_contacts);
    capacity.joints = room(scene.joints.size() + std::uint64_t{scene.extra_joints});
    capacity.geometries = std::max(1u, room(geometries.size() + chain_geometries + scene.extra_shapes));
    return capacity;
}

}  // namespace islet::samples
