// Soft bodies: rings full of gas, alone and under load.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "build.hpp"
#include "harness/checks.hpp"
#include "prefabs/soft_body.hpp"
#include "prefab_scene.hpp"
#include "scenes.hpp"

namespace islet::samples {
namespace {

/// The weight of a soft body, N.
double weight_of(const Engine& engine, const Placed& soft, const SoftBodyDef& def) {
    double mass = 0;
    for (std::size_t i = 0; i < def.links; ++i) mass += double(engine.body(soft.first_body + i).mass);
    return 10 * mass;
}

double link_length(const SoftBodyDef& def) { return 2 * double(pi) * double(def.radius) / double(def.links); }

/// Share of its round area.
double fullness(const Engine& engine, const Placed& soft, const SoftBodyDef& def) {
    return double(area_of(engine, soft, def)) / double(round_area(def));
}

/// Width of what lies on the floor, to a link, m.
double patch_of(const Engine& engine, const Placed& soft, const SoftBodyDef& def) {
    double patch = 0;
    for (std::size_t i = 0; i < def.links; ++i) {
        if (engine.body(soft.first_body + i).position.y < 0.5f * def.thickness + 0.002f) patch += link_length(def);
    }
    return patch;
}

/// Area, as a share of the round one, of a ring of the same length pressed between two plates that it touches along `patch` each: the least that a
/// body resting on such a patch can have, since elsewhere it is as round as it can be.
double pressed_area(double patch, double radius) {
    const double r = radius - patch / double(pi);
    return (double(pi) * r * r + 2 * r * patch) / (double(pi) * radius * radius);
}

}  // namespace

Scene make_blob() {
    Scene scene;
    scene.name = "blob";
    scene.steps = 600;
    scene.view = {{-4, -0.7f}, {4, 3.3f}};
    make_stiff(scene);
    add_floor(scene, 5);
    // The same skin, blown up hard and less hard, falls 1 m.
    struct Blob {
        SoftBodyDef def;
        Placed placed;
    };
    std::vector<Blob> blobs;
    for (const float pressure : {120.0f, 60.0f, 30.0f}) {
        const SoftBodyDef def = {.position = {2.6f * static_cast<float>(blobs.size()) - 2.6f, 2},
                                 .radius = 0.9f,
                                 .links = 48,
                                 .density = 5,
                                 .pressure = pressure,
                                 .damping = 1};
        blobs.push_back({def, add_prefab(scene, prefab_of(def))});
    }
    scene.before_step = [blobs](Engine& engine, int) {
        for (const Blob& blob : blobs) apply_pressure(engine, blob.placed, blob.def);
    };

    const double omega = 2 * double(pi) * double(scene.world.solver.joint_hertz);
    scene.check = [blobs, omega](const Engine& engine) {
        std::vector<CheckLine> lines;
        for (const Blob& blob : blobs) {
            // The links that lie on the floor must carry it: the pressure on them is its weight. Those at the
            // ends of the patch are counted as a whole or not at all.
            const std::string name = std::to_string(std::lround(blob.def.pressure)) + " N/m: ";
            const double full = fullness(engine, blob.placed, blob.def), patch = patch_of(engine, blob.placed, blob.def);
            const double due = weight_of(engine, blob.placed, blob.def) * full / double(blob.def.pressure);
            lines.push_back(
                near_line(name + "width of the patch it rests on, due weight / pressure (m)", patch, due, 1.5 * link_length(blob.def)));
            // Its skin, which pulls with pressure times radius, gives as joints do: see make_stiff.
            const double half_mass = 0.5 * double(engine.body(blob.placed.first_body).mass);
            const double stretch = double(blob.def.pressure * blob.def.radius) / (half_mass * omega * omega) / link_length(blob.def);
            const double most = (1 + stretch) * (1 + stretch);
            lines.push_back({name + "area (share of the round one)", full, pressed_area(patch, double(blob.def.radius)), most});
        }
        lines.push_back(at_most("fastest link (m/s)", max_speed(engine), 0.1));
        return lines;
    };
    return scene;
}

Scene make_soft_stack() {
    constexpr float radius = 0.6f;
    Scene scene;
    scene.name = "soft_stack";
    scene.steps = 900;
    scene.view = {{-3.5f, -0.7f}, {3.5f, 4.8f}};
    make_stiff(scene);
    // Two soft bodies between kerbs carry a tray; two in the tray carry a crate.
    const float skin = radius + 0.04f, kerb = 2 * skin;
    add_floor(scene, 4);
    for (const float side : {-1.0f, 1.0f}) add_static(scene, {side * (kerb + 0.25f), 0.2f}, make_box(0.15f, 0.2f));
    struct Soft {
        SoftBodyDef def;
        Placed placed;
    };
    std::vector<Soft> softs;
    const auto add_softs = [&](float y, float pressure) {
        for (const float side : {-1.0f, 1.0f}) {
            const SoftBodyDef def = {
                .position = {side * skin, y + skin}, .radius = radius, .links = 28, .density = 5, .pressure = pressure, .damping = 1};
            softs.push_back({def, add_prefab(scene, prefab_of(def))});
        }
    };
    add_softs(0, 150);
    const float tray_bottom = 2 * skin, tray_top = tray_bottom + 0.2f, half = kerb + 0.25f;
    BodyDef tray;
    tray.type = BodyType::dynamic;
    tray.position = {0, tray_bottom + 0.1f};
    const ShapeDef wood = {.density = 15};
    const std::size_t tray_body = add_body(scene, tray,
                                           {{make_box(half, 0.1f), wood},
                                            {make_offset_box(0.1f, 0.15f, {{-half + 0.1f, 0.25f}, {}}), wood},
                                            {make_offset_box(0.1f, 0.15f, {{half - 0.1f, 0.25f}, {}}), wood}});
    add_softs(tray_top, 100);
    const std::size_t crate = add_dynamic(scene, {0, tray_top + 2 * skin + 0.3f}, make_box(1, 0.3f), {.density = 5});

    scene.before_step = [softs](Engine& engine, int) {
        for (const Soft& soft : softs) apply_pressure(engine, soft.placed, soft.def);
    };
    scene.check = [softs, tray_body, crate](const Engine& engine) {
        double weight = 10 * (double(engine.body(tray_body).mass) + double(engine.body(crate).mass)), patch = 0, force = 0;
        for (const Soft& soft : softs) weight += weight_of(engine, soft.placed, soft.def);
        for (std::size_t i = 0; i < 2; ++i) {
            const Soft& soft = softs[i];
            const double width = patch_of(engine, soft.placed, soft.def);
            patch += width;
            force += width * double(soft.def.pressure) / fullness(engine, soft.placed, soft.def);
        }
        std::vector<CheckLine> lines;
        // The floor carries everything through two patches, each known to a link and a half, as above.
        lines.push_back(
            near_line("pressure on the floor, due the weight of all (N)", force, weight, 3 * link_length(softs[0].def) * force / patch));
        for (const Soft& soft : softs) {
            const std::string name = "soft body at height " + std::to_string(std::lround(double(soft.def.position.y))) + " m: ";
            lines.push_back({name + "area (share of the round one)", fullness(engine, soft.placed, soft.def), 0.7, 1.01});
        }
        const BodyState on_top = engine.body(crate), between = engine.body(tray_body);
        lines.push_back(at_most("the crate turned (rad)", std::abs(double(on_top.angle)), 0.1));
        lines.push_back(at_most("the tray turned (rad)", std::abs(double(between.angle)), 0.1));
        lines.push_back(at_most("the crate is off the middle by (m)", std::abs(double(on_top.position.x)), 0.2));
        lines.push_back(near_line("the crate above the tray, more than half of where it began (m)", double(on_top.position.y - between.position.y),
                                  1.24, 0.44));
        lines.push_back(at_most("fastest body (m/s)", max_speed(engine), 0.1));
        return lines;
    };
    return scene;
}

}  // namespace islet::samples
