// The runs of a sweep.
#include "sweep.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "harness/checks.hpp"
#include "harness/scene_fields.hpp"
#include "replay_file.hpp"
#include "scene_files/near_names.hpp"
#include "scene_files/printable.hpp"
#include "scenes/random.hpp"
#include "workers/thread_pool.hpp"

namespace islet::tools {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

template <class T>
concept Number = std::is_arithmetic_v<T>;
template <class T>
concept Named = enum_names<T> != nullptr;

/// A number of a definition from one of the command line, which must be of its kind: whole, or 0 or 1.
template <Number T>
void set(T& field, double value, const std::string& name) {
    if constexpr (std::is_same_v<T, bool>) {
        if (value != 0 && value != 1) throw SweepError(fmt::format("{} is 0 or 1, not {}", name, value));
    } else if constexpr (std::is_integral_v<T>) {
        if (value != std::floor(value) || value < 0 || value > 4e9) throw SweepError(fmt::format("{} is a whole number, not {}", name, value));
    }
    field = static_cast<T>(value);
}

std::size_t count_of(const char* const* names) {
    std::size_t count = 0;
    while (names[count] != nullptr) ++count;
    return count;
}

/// Sets the field of that name, of all that are numbers or enumerations.
struct FieldSetter {
    const std::string& name;
    double value = 0;
    bool found = false;

    template <class T>
    void operator()(const char* field, T& at, const T&) {
        if constexpr (Number<T>) {
            if (name != field) return;
            found = true;
            set(at, value, name);
        } else if constexpr (Named<T>) {
            if (name != field) return;
            found = true;
            at = static_cast<T>(value);
        }
    }
};

/// All fields that are numbers or enumerations: their names, and those of their values, which are null for numbers.
struct FieldNames {
    std::map<std::string, const char* const*>& names;

    template <class T>
    void operator()(const char* field, T&, const T&) {
        if constexpr (Number<T>)
            names.emplace(field, nullptr);
        else if constexpr (Named<T>)
            names.emplace(field, enum_names<T>);
    }
};

template <class Change>
void for_shapes(Scene& scene, Change&& change) {
    for (SceneBody& body : scene.bodies)
        for (SceneShape& shape : body.shapes) change(shape.def);
}

template <class Change>
void for_dynamic(Scene& scene, Change&& change) {
    for (SceneBody& body : scene.bodies)
        if (body.def.type == BodyType::dynamic) change(body.def);
}

using Setter = void (*)(Scene&, double);

/// Parameters that are no field of SolverDef or WorldDef.
const std::map<std::string, Setter>& own_parameters() {
    static const std::map<std::string, Setter> parameters = {
        {"gravity", [](Scene& s, double v) { s.world.gravity.y = -static_cast<float>(v); }},
        {"gravity_x", [](Scene& s, double v) { s.world.gravity.x = static_cast<float>(v); }},
        {"dt", [](Scene& s, double v) { s.dt = static_cast<float>(v); }},
        {"friction", [](Scene& s, double v) { for_shapes(s, [v](ShapeDef& d) { d.friction = static_cast<float>(v); }); }},
        {"restitution", [](Scene& s, double v) { for_shapes(s, [v](ShapeDef& d) { d.restitution = static_cast<float>(v); }); }},
        {"rolling_resistance", [](Scene& s, double v) { for_shapes(s, [v](ShapeDef& d) { d.rolling_resistance = static_cast<float>(v); }); }},
        {"density", [](Scene& s, double v) { for_shapes(s, [v](ShapeDef& d) { d.density = static_cast<float>(v); }); }},
        {"linear_damping", [](Scene& s, double v) { for_dynamic(s, [v](BodyDef& d) { d.linear_damping = static_cast<float>(v); }); }},
        {"angular_damping", [](Scene& s, double v) { for_dynamic(s, [v](BodyDef& d) { d.angular_damping = static_cast<float>(v); }); }},
        {"gravity_scale", [](Scene& s, double v) { for_dynamic(s, [v](BodyDef& d) { d.gravity_scale = static_cast<float>(v); }); }},
    };
    return parameters;
}

/// All parameters, with the names of their values.
const std::map<std::string, const char* const*>& parameters() {
    static const std::map<std::string, const char* const*> all = [] {
        std::map<std::string, const char* const*> names;
        for (const auto& own : own_parameters()) names.emplace(own.first, nullptr);
        FieldNames collect{names};
        SolverDef solver;
        fields(collect, solver, SolverDef{});
        WorldDef world;
        fields(collect, world, WorldDef{});
        return names;
    }();
    return all;
}

void set_parameter(Scene& scene, const std::string& name, double value) {
    if (const auto own = own_parameters().find(name); own != own_parameters().end()) return own->second(scene, value);
    FieldSetter setter{name, value};
    fields(setter, scene.world.solver, SolverDef{});
    if (!setter.found) fields(setter, scene.world, WorldDef{});
}

/// Moves each dynamic body by up to `most` along x and y.
void nudge(Scene& scene, std::uint64_t seed, float most) {
    if (seed == 0) return;
    Random random(seed);
    for_dynamic(scene, [&](BodyDef& def) {
        def.position.x += random.uniform(-most, most);
        def.position.y += random.uniform(-most, most);
    });
}

double number(const std::string& text, const std::string& whole) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        throw SweepError(fmt::format("'{}': '{}' is no number", printable(whole), printable(text)));
    return value;
}

/// The place of a value's name.
double place_of(const std::string& text, const char* const* names, const std::string& parameter) {
    const std::vector<std::string> all(names, names + count_of(names));
    const auto found = std::find(all.begin(), all.end(), text);
    if (found == all.end()) throw SweepError(fmt::format("{} is one of {}, not '{}'", parameter, fmt::join(all, ", "), printable(text)));
    return static_cast<double>(found - all.begin());
}

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == at)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

std::string point_name(const Sweep& sweep, std::uint64_t point) {
    std::vector<std::string> parts;
    const std::vector<std::size_t> places = sweep.places(point);
    for (std::size_t i = 0; i < places.size(); ++i) parts.push_back(sweep.axes[i].name + "=" + value_text(sweep.axes[i].name, sweep.axes[i].values[places[i]]));
    return fmt::format("{}", fmt::join(parts, ", "));
}

double drift_of(const Scene& scene, const Engine& engine) {
    double most = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (scene.bodies[i].def.type == BodyType::dynamic && engine.exists(i))
            most = std::max(most, drift_from(places_of(scene, i, i + 1), engine, i).distance);
    return most;
}

SweepRun run_one(const Sweep& sweep, const SceneMaker& make, std::uint64_t index) {
    const Scene scene = scene_of(sweep, make, index);
    IsletEngine engine;
    engine.load(scene);
    SweepRun run;
    run.index = index;
    int awake_until = 0;  // steps
    for (int step = 0; step < scene.steps; ++step) {
        engine.advance(scene, step, scene.dt);
        const StepReport report = engine.world().report();
        run.dropped_contacts += report.dropped_contacts;
        if (report.awake_bodies > 0) awake_until = step + 1;
    }
    run.hash = engine.world().hash();
    const double kinetic = kinetic_energy(engine);
    run.values = {drift_of(scene, engine),
                  kinetic + potential_energy(engine, scene.world.gravity),
                  kinetic,
                  engine.max_penetration(),
                  static_cast<double>(engine.max_joint_error().linear),
                  awake_until < scene.steps ? awake_until * static_cast<double>(scene.dt) : none};
    for (double& value : run.values)
        if (!std::isfinite(value)) value = none;
    return run;
}

}  // namespace

std::uint64_t Sweep::points() const {
    std::uint64_t count = 1;
    for (const SweepAxis& axis : axes) count *= axis.values.size();
    return count;
}

std::vector<std::size_t> Sweep::places(std::uint64_t point) const {
    std::vector<std::size_t> places(axes.size());
    for (std::size_t i = axes.size(); i-- > 0;) {
        places[i] = static_cast<std::size_t>(point % axes[i].values.size());
        point /= axes[i].values.size();
    }
    return places;
}

std::vector<std::string> parameter_names() {
    std::vector<std::string> names;
    for (const auto& parameter : parameters()) names.push_back(parameter.first);
    return names;
}

const char* const* value_names(const std::string& parameter) {
    const auto found = parameters().find(parameter);
    return found == parameters().end() ? nullptr : found->second;
}

std::string value_text(const std::string& parameter, double value, int digits) {
    const char* const* const names = value_names(parameter);
    if (names != nullptr && value >= 0 && value < static_cast<double>(count_of(names))) return names[static_cast<std::size_t>(value)];
    return digits >= 17 ? fmt::format("{}", value) : fmt::format("{:.{}g}", value, digits);
}

SweepAxis read_axis(const std::string& text) {
    constexpr double most_values = 10'000;
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw SweepError(fmt::format("'{}' is not NAME=FIRST:LAST:COUNT or NAME=VALUE,VALUE,...", printable(text)));
    SweepAxis axis;
    axis.name = text.substr(0, equals);
    if (const auto names = parameter_names(); std::find(names.begin(), names.end(), axis.name) == names.end()) {
        const std::vector<std::string> near = near_names(axis.name, names);
        throw SweepError(fmt::format("there is no parameter '{}'; {}: {}", printable(axis.name), near.empty() ? "there are" : "near names",
                                     fmt::join(near.empty() ? names : near, ", ")));
    }
    const std::vector<std::string> range = split(text.substr(equals + 1), ':');
    const char* const* const names = value_names(axis.name);
    if (names != nullptr || range.size() == 1) {
        for (const std::string& value : split(text.substr(equals + 1), ',')) axis.values.push_back(names != nullptr ? place_of(value, names, axis.name) : number(value, text));
        return axis;
    }
    if (range.size() != 3) throw SweepError(fmt::format("'{}': a range is FIRST:LAST:COUNT", printable(text)));
    const double first = number(range[0], text), last = number(range[1], text), count = number(range[2], text);
    if (count != std::floor(count) || count < 1 || count > most_values)
        throw SweepError(fmt::format("'{}': the count must be 1 to {}", printable(text), most_values));
    for (double i = 0; i < count; ++i) axis.values.push_back(i == count - 1 && count > 1 ? last : first + (last - first) * i / std::max(1.0, count - 1));
    return axis;
}

Scene scene_of(const Sweep& sweep, const SceneMaker& make, std::uint64_t run) {
    Scene scene = make(sweep.start);
    const std::vector<std::size_t> places = sweep.places(run / sweep.seeds);
    for (std::size_t i = 0; i < places.size(); ++i) set_parameter(scene, sweep.axes[i].name, sweep.axes[i].values[places[i]]);
    if (sweep.steps) scene.steps = *sweep.steps;
    nudge(scene, run % sweep.seeds, static_cast<float>(sweep.nudge));
    return scene;
}

void prepare(Sweep& sweep, const SceneMaker& make, std::uint64_t memory_limit) {
    constexpr std::uint64_t most_runs = 10'000'000;
    for (const SweepAxis& axis : sweep.axes)
        if (std::count_if(sweep.axes.begin(), sweep.axes.end(), [&](const SweepAxis& other) { return other.name == axis.name; }) > 1)
            throw SweepError(fmt::format("{} is varied twice", axis.name));
    std::uint64_t points = 1;
    for (const SweepAxis& axis : sweep.axes) points = std::min(points * axis.values.size(), most_runs + 1);
    if (points * std::min(sweep.seeds, most_runs) > most_runs) throw SweepError(fmt::format("these are more than {} runs", most_runs));
    for (std::uint64_t point = 0; point < points; ++point) {
        try {
            const Scene scene = scene_of(sweep, make, point * sweep.seeds);
            if (!(scene.dt >= min_time_step && scene.dt <= 1)) throw SweepError("a time step must be from 1e-6 to 1 s");
            if (const std::string why = beyond_memory_limit(capacity_of(scene), memory_limit); !why.empty()) throw SweepError(why);
            IsletEngine engine;
            engine.load(scene);
            if (point == 0) sweep.fingerprint = engine.world().hash();
        } catch (const std::exception& error) {
            throw SweepError(sweep.axes.empty() ? std::string(error.what()) : fmt::format("{}: {}", point_name(sweep, point), error.what()));
        }
    }
}

std::vector<SweepRun> run_sweep(const Sweep& sweep, const SceneMaker& make, std::uint32_t jobs, std::uint64_t shard, std::uint64_t shards,
                                const std::function<void(int)>& progress) {
    const std::uint64_t all = sweep.runs(), count = shard < all ? (all - shard - 1) / shards + 1 : 0;
    struct Work {
        const Sweep& sweep;
        const SceneMaker& make;
        std::uint64_t shard, shards;
        const std::function<void(int)>& progress;
        std::vector<SweepRun> runs;
        std::mutex mutex;
        int done = 0;
        std::string error;  // of the first run that failed

        static void run(void* data, std::uint32_t i) {
            Work& work = *static_cast<Work*>(data);
            const std::uint64_t index = work.shard + i * work.shards;
            std::string error;
            try {
                work.runs[i] = run_one(work.sweep, work.make, index);
            } catch (const std::exception& failed) { error = fmt::format("run {}: {}", index, failed.what()); }
            const std::lock_guard<std::mutex> lock(work.mutex);
            if (work.error.empty()) work.error = error;
            work.progress(++work.done);
        }
    } work{sweep, make, shard, shards, progress, std::vector<SweepRun>(static_cast<std::size_t>(count)), {}, 0, {}};
    ThreadPool pool(std::min<std::uint32_t>(jobs, max_workers));
    pool.parallel_for(static_cast<std::uint32_t>(count), Work::run, &work);
    if (!work.error.empty()) throw SweepError(work.error);
    return std::move(work.runs);
}

}  // namespace islet::tools
