// How a step scales with workers, told without them: one thread runs the tasks of N workers one after another and times each. From that follows what N workers
// would take if whoever is free took the next task, and if neither starting a task nor waiting for one cost anything.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <islet/tasks.hpp>

#include "scenes/catalogue.hpp"

namespace islet::tools {

/// The stages of a step, in the order of World::step.
inline constexpr std::array<const char*, 5> span_stages = {"pairs", "collide", "islands", "solve", "finish"};

/// What one stage of one step took, ms: what the stepping thread did alone, and the tasks that workers share.
struct StageTimes {
    std::vector<double> alone = {0};        // before the first job, between two jobs, after the last: one more than jobs
    std::vector<std::vector<double>> jobs;  // each call of TaskSystem::parallel_for: its tasks, in order

    double work() const;                            // of all together
    double alone_work() const;                      // of what is not part of a job
    double chain() const;                           // with as many workers as there are tasks: each job takes as long as its longest task
    double time_with(std::uint32_t workers) const;  // each worker that is free takes the next task of the job
};

using StepTimes = std::array<StageTimes, span_stages.size()>;

/// A task system of `workers` workers that runs all tasks on the calling thread, and a clock for the same world, which tells it where the stages end. It must
/// outlive the world's last step.
class SpanMeter {
public:
    /// Reads a clock that counts nanoseconds.
    using Now = std::function<std::uint64_t()>;

    /// Without `now` the clock is that of the machine.
    explicit SpanMeter(std::uint32_t workers, Now now = {});
    SpanMeter(const SpanMeter&) = delete;
    SpanMeter& operator=(const SpanMeter&) = delete;

    TaskSystem tasks();
    /// WorldDef::clock; its context is the meter.
    static std::uint64_t tick(void* meter);
    /// What each step took, in order.
    const std::vector<StepTimes>& steps() const { return steps_; }

private:
    void run(std::uint32_t count, void (*task)(void* data, std::uint32_t index), void* data);
    void end_stretch(std::uint64_t now);

    std::uint32_t workers_;
    Now now_;
    std::uint64_t begin_ = 0;  // of what the stepping thread does alone now
    std::size_t stage_ = span_stages.size();
    std::vector<StepTimes> steps_;
};

/// Of two runs that made the same tasks, the lesser time of each: what disturbed a run does not count. Throws std::logic_error if the tasks are others.
void take_least(std::vector<StepTimes>& least, const std::vector<StepTimes>& other);

/// A stage, or the whole step ("step"), in ms a step: means over the steps.
struct SpanRow {
    std::string stage;
    double one_worker = 0;     // what the stage takes without a task system
    double work = 0;           // of the tasks of the most workers, and of what the stepping thread does alone
    double alone = 0;          // of that, what the stepping thread does alone
    double chain = 0;          // the longest chain: what no number of workers makes shorter
    std::vector<double> time;  // with each number of workers
};

struct SpanResult {
    std::string scene;
    int steps = 0;
    std::size_t bodies = 0, contacts = 0;  // after the last step
    std::vector<std::uint32_t> workers;
    std::vector<SpanRow> rows;  // the stages, and the step last
};

struct SpanOptions {
    std::vector<const samples::SceneInfo*> scenes;
    std::optional<int> steps;       // the scene's own if not given
    std::optional<int> most_steps;  // of a scene's own
    int repeat = 3;                 // runs, of which the least time of each task counts
    std::vector<std::uint32_t> workers = {2, 4, 8, 16};
};

/// The rows of a scene: `one` are the steps of one worker, `several` those of each number of workers.
std::vector<SpanRow> span_rows(const std::vector<StepTimes>& one, const std::vector<std::uint32_t>& workers,
                               const std::vector<std::vector<StepTimes>>& several);
/// Scene by scene, in Islet. `ended` is told each result, and `stepped` how many steps were taken of how many.
std::vector<SpanResult> measure_span(const SpanOptions& options, const std::function<void(int, int)>& stepped,
                                     const std::function<void(const SpanResult&)>& ended);

std::string span_table(const SpanResult& result);
std::string json_of(const std::vector<SpanResult>& results);

}  // namespace islet::tools
