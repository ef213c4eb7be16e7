#include "html.hpp"
#include "common/hash_text.hpp"
#include "scene_files/printable.hpp"
#include "scenes/catalogue.hpp"

#include <bit>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace islet::tools {

/// The page with places for the title, the run and the movie. Made from player/ by embed_player.cmake.
extern const char player_source[];

namespace {

using Json = nlohmann::ordered_json;

/// A column of the numbers: its name in the player, and how it is read.
struct Column {
    const char* name;
    double (*of)(const FrameNumbers&);
};

constexpr Column columns[] = {
    {"ms", [](const FrameNumbers& n) { return n.ms; }},
    {"kineticEnergy", [](const FrameNumbers& n) { return n.kinetic_energy; }},
    {"potentialEnergy", [](const FrameNumbers& n) { return n.potential_energy; }},
    {"bodies", [](const FrameNumbers& n) { return double(n.bodies); }},
    {"awakeBodies", [](const FrameNumbers& n) { return double(n.awake_bodies); }},
    {"islands", [](const FrameNumbers& n) { return double(n.islands); }},
    {"contacts", [](const FrameNumbers& n) { return double(n.contacts); }},
    {"touching", [](const FrameNumbers& n) { return double(n.touching); }},
    {"maxPenetration", [](const FrameNumbers& n) { return n.max_penetration; }},
    {"joints", [](const FrameNumbers& n) { return double(n.joints); }},
    {"maxJointError", [](const FrameNumbers& n) { return n.max_joint_error; }},
};

void append_float(std::string& bytes, double value) {
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(bits >> shift & 0xff);
}

/// Column after column, a little-endian float for each frame.
std::string numbers_of(const MovieMaker& movie) {
    std::string bytes;
    for (const Column& column : columns) {
        for (const FrameNumbers& numbers : movie.numbers()) append_float(bytes, column.of(numbers));
    }
    return bytes;
}

/// Each traced body's path, a point per frame; a recorded step that the run has no point of ends it.
std::string trails_of(const Run& run, const MovieMaker& movie) {
    std::string bytes;
    for (const Trail& trail : run.trails) {
        for (const FrameNumbers& numbers : movie.numbers()) {
            const Vec2 p = trail.at(static_cast<std::size_t>(numbers.step));
            append_float(bytes, double(p.x) - movie.scale().origin_x);
            append_float(bytes, double(p.y) - movie.scale().origin_y);
        }
    }
    return bytes;
}

/// A list of models, each a list of outlines, each [radius, x, y, x, y, ...], for a sensor with a word before them. Written by hand: as few digits as give the same float back.
std::string models_json(const std::vector<Model>& models) {
    std::string text = "[";
    for (const Model& model : models) {
        text += text.size() > 1 ? ",\n[" : "\n[";
        for (const Outline& outline : model) {
            if (&outline != model.data()) text += ',';
            text += fmt::format("[{}{}", outline.solid ? "" : "\"sensor\",", outline.radius);
            for (const Vec2 p : outline.points) text += fmt::format(",{},{}", p.x, p.y);
            text += ']';
        }
        text += ']';
    }
    return text + "]";
}

Json run_json(const Run& run, const RunResult& result, const MovieMaker& movie) {
    const Scale& scale = movie.scale();
    const SceneInfo* info = find_scene(result.scene);
    Json names = Json::array();
    for (const Column& column : columns) names.push_back(column.name);
    Json looks = Json::array();
    for (const BodyLook look : movie.looks()) looks.push_back(static_cast<int>(look));
    return {
        {"scene", printable(result.scene)},
        {"description", info != nullptr ? info->description : ""},
        {"steps", result.steps},
        {"dt", result.dt},
        {"substeps", result.substeps},
        {"hash", hash_text(result.hash)},
        {"dropped", result.most_dropped_contacts},
        {"checked", result.checked},
        {"passed", result.passed()},
        {"stride", movie.stride()},
        {"contacts", movie.has_contacts()},
        {"frames", movie.numbers().size()},
        {"quantum", scale.quantum},
        {"contactQuantum", scale.quantum * contact_quanta},
        {"bodyTurn", body_turn},
        {"contactTurn", contact_turn},
        {"betweenParts", between_parts},
        {"origin", {scale.origin_x, scale.origin_y}},
        {"view",
         {double(run.scene.view.lower.x), double(run.scene.view.lower.y), double(run.scene.view.upper.x), double(run.scene.view.upper.y)}},
        {"columns", std::move(names)},
        {"looks", std::move(looks)},
        {"trails", run.trails.size()},
    };
}

/// As JSON inside a script, in which no tag can begin.
std::string script_text(const Json& json) {
    std::string out;
    for (const char c : json.dump()) out += c == '<' ? "\\u003c" : std::string(1, c);
    return out;
}

}  // namespace

std::string base64(const std::string& bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t j = 0; j < 3; ++j) three = three << 8 | (i + j < bytes.size() ? static_cast<std::uint8_t>(bytes[i + j]) : 0u);
        for (std::size_t j = 0; j < 4; ++j) text += i + j <= bytes.size() ? digits[three >> (18 - 6 * j) & 63] : '=';
    }
    return text;
}

std::string player_page(const Run& run, const RunResult& result, const MovieMaker& movie) {
    const std::string_view source = player_source;
    std::string page;
    std::size_t done = 0;
    // The places come in this order, and what is put into one is not searched for the next.
    const auto fill = [&](std::string_view place, const std::string& text) {
        const std::size_t at = source.find(place, done);
        if (at == std::string_view::npos) throw std::logic_error("the player has no place for " + std::string(place));
        page += source.substr(done, at - done);
        page += text;
        done = at + place.size();
    };
    fill("{{title}}", markup(result.scene));
    fill("{{run}}", script_text(run_json(run, result, movie)));
    fill("{{models}}", models_json(movie.models()));
    fill("{{numbers}}", base64(numbers_of(movie)));
    fill("{{trails}}", base64(trails_of(run, movie)));
    fill("{{movie}}", base64(movie.bytes()));
    page += source.substr(done);
    return page;
}

}  // namespace islet::tools
