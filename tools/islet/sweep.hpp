// `islet sweep`: a scene run for every combination of some parameters' values, each from many starts, and what the runs came to.
//
// Runs are numbered: run i is seed i % seeds of point i / seeds, and points count as digits do, the last parameter fastest. So any share of the runs can be
// made anywhere (a shard), and shards put together are what one process makes.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "harness/scene.hpp"

namespace islet::tools {

using namespace samples;

/// What is wrong with a sweep, in a sentence.
struct SweepError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A parameter and the values it takes; of an enumeration, the values' places in its list of names.
struct SweepAxis {
    std::string name;
    std::vector<double> values;
};

struct Sweep {
    std::string scene;         // as the command line names it
    std::optional<int> start;  // of a scene that has several
    std::optional<int> steps;  // the scene's own if not given
    double nudge = 0.001;      // m, half the width of what moves starting positions
    std::uint64_t seeds = 10;  // seed 0 leaves the scene as it is
    std::vector<SweepAxis> axes;
    std::uint64_t fingerprint = 0;  // hash of the scene's world before the first step: two files may share a name

    std::uint64_t points() const;
    std::uint64_t runs() const { return points() * seeds; }
    /// Which value of each axis a point has.
    std::vector<std::size_t> places(std::uint64_t point) const;
};

enum class Measure { drift, energy, kinetic_energy, penetration, joint_error, sleep_time };
inline constexpr std::size_t measure_count = 6;
struct MeasureInfo {
    const char *name, *unit, *meaning;
};
inline constexpr std::array<MeasureInfo, measure_count> measures = {{
    {"drift", "m", "the farthest that a dynamic body of the scene is from its start"},
    {"energy", "J", "kinetic and potential energy of all bodies"},
    {"kinetic_energy", "J", "kinetic energy of all bodies"},
    {"penetration", "m", "the deepest overlap"},
    {"joint_error", "m", "the farthest that a joint is from what it locks"},
    {"sleep_time", "s", "when the last body fell asleep; none if one is awake at the end"},
}};

/// What one run came to after its last step. What there is none of, or is no number, is NaN.
struct SweepRun {
    std::uint64_t index = 0, hash = 0;
    std::uint64_t dropped_contacts = 0;  // summed over the steps
    std::array<double, measure_count> values{};
};

/// Some or all of a sweep's runs, by rising index.
struct SweepPart {
    Sweep sweep;
    std::vector<SweepRun> runs;
};

/// Smallest, mean and largest of one measure over a point's seeds; of those that have it.
struct SweepFigure {
    std::uint64_t count = 0;
    double least = 0, mean = 0, most = 0;
};

/// A row of the table.
struct SweepPoint {
    std::vector<double> values;  // of the parameters
    std::array<SweepFigure, measure_count> figures;
    std::uint64_t hash = 0;  // of the runs' hashes, in the order of their seeds
};

struct SweepTable {
    std::vector<SweepPoint> points;
    std::uint64_t hash = 0;  // of all runs' hashes
};

/// "friction=0.1:0.9:9" (first, last, how many, evenly spaced), "substeps=1,2,4,8" or "schedule=soft,classic". Throws SweepError.
SweepAxis read_axis(const std::string& text);
/// The names of a parameter's values, in order, up to a null; null for a number.
const char* const* value_names(const std::string& parameter);
/// A value as it stands in tables: a name, or a number with so many digits at most.
std::string value_text(const std::string& parameter, double value, int digits = 17);
/// Names of all parameters, in order.
std::vector<std::string> parameter_names();

/// Makes the scene as it stands, or one of its starts, anew for each run: scripts of two runs must not share what they remember. Throws what it likes.
using SceneMaker = std::function<Scene(std::optional<int> start)>;

/// The scene of one run.
Scene scene_of(const Sweep& sweep, const SceneMaker& make, std::uint64_t run);
/// Checks that each point makes a world, and sets the fingerprint. Throws SweepError, which names the point; or what `make` throws.
void prepare(Sweep& sweep, const SceneMaker& make, std::uint64_t memory_limit);
/// Makes the runs shard, shard + shards, ... on so many threads, each run on one. `progress` is told how many are done, from one thread at a time.
std::vector<SweepRun> run_sweep(const Sweep& sweep, const SceneMaker& make, std::uint32_t jobs, std::uint64_t shard, std::uint64_t shards,
                                const std::function<void(int done)>& progress);

/// A part as JSON and back; every number survives. Throws SweepError.
std::string manifest_of(const SweepPart& part);
SweepPart read_manifest(const std::string& text);
/// Puts parts of one sweep together; a run may stand in several if its results are the same. Throws SweepError: parts of two sweeps, results that differ, or
/// runs that are missing.
SweepPart merge(const std::vector<SweepPart>& parts, const std::vector<std::string>& names);

/// Of a whole sweep.
SweepTable tabulate(const SweepPart& whole);
std::string table_of(const Sweep& sweep, const SweepTable& table);
std::string json_of(const Sweep& sweep, const SweepTable& table);
/// A line for each run.
std::string csv_of(const SweepPart& part);
/// Throws SweepError if there can be no picture of the sweep: nothing varies, or no number does first.
void check_plot(const Sweep& sweep);
/// A panel for each measure against the first parameter: mean as a line, smallest to largest as a band; a colour for each combination of the others.
std::string plot_of(const Sweep& sweep, const SweepTable& table);

}  // namespace islet::tools
