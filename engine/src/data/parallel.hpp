// Cutting a stage of the step into ranges for the user's task system.
//
// Nothing may depend on who runs which range, nor on their order: a range writes to what is its own alone (its bodies, its contacts, its words of a bit
// set, its slot of an array), and what changes shared state is committed afterwards, in index order, by the thread that steps the world. Where workers can
// change a word at once, a range may also set bits, add counts and take least values in shared words, whose order decides nothing.
#pragma once

#include "../data/core.hpp"
#include "../math/float_mode.hpp"
#include "../math/inlining.hpp"

// 0 compiles the parallel paths out: for_ranges is then one plain call. The small profile has none.
#if !defined(ISLET_THREADS)
#define ISLET_THREADS (ISLET_SMALL == 0)
#endif

// Whether workers can change one word at once: not in a build for size, nor where a processor has no instruction for that with 64 bits (a Cortex-M, for
// example), which would call a library.
#if ISLET_THREADS && !defined(__OPTIMIZE_SIZE__) && defined(__GCC_ATOMIC_LLONG_LOCK_FREE) && __GCC_ATOMIC_LLONG_LOCK_FREE == 2
#define ISLET_SHARES_WORDS 1
#else
#define ISLET_SHARES_WORDS 0
#endif

namespace islet::detail {

inline constexpr bool has_threads = ISLET_THREADS != 0;

inline bool has_workers(const Core& core) {
#if ISLET_THREADS
    return core.workers > 1;
#else
    static_cast<void>(core);
    return false;
#endif
}

inline std::uint32_t worker_count(const Core& core) { return has_workers(core) ? core.workers : 1; }

/// Steps with so many workers from now on. A plan is made for its number of workers.
inline void set_workers(Core& core, std::uint32_t workers) {
    if (!has_threads || workers == core.workers) return;
    core.workers = static_cast<std::uint8_t>(workers);
    core.forget_plan();
}

/// The workers of a task system. (Builds without threads have one.)
inline std::uint32_t workers_of(const TaskSystem& tasks) { return has_threads && tasks.parallel_for != nullptr ? tasks.workers : 1; }

/// Asks the task system how many workers are ready for a step that begins.
inline void count_workers(Core& core) {
    const TaskSystem& tasks = core.tasks;
    std::uint32_t workers = workers_of(tasks);
    if (workers > 1 && tasks.ready_workers != nullptr) {
        const std::uint32_t ready = tasks.ready_workers(tasks.context);
        workers = ready == 0 ? 1 : ready < workers ? ready : workers;
    }
    set_workers(core, workers);
}

/// Whether there are so many workers that it pays if they share work that one alone would do in two thirds of the time.
inline bool has_many_workers(const Core& core) { return worker_count(core) >= 4; }

/// A grain for ranges whose costs differ: a quarter where many workers would wait for the last one.
inline std::uint32_t fine_grain(const Core& core, std::uint32_t grain) { return has_many_workers(core) ? (grain + 3) / 4 : grain; }

/// Whether a world's workers change words at once.
inline bool shares_words(const Core& core) { return ISLET_SHARES_WORDS != 0 && has_many_workers(core); }

#if ISLET_SHARES_WORDS
/// Sets a bit of a word that other workers may be changing. Returns whether it was set before.
inline bool set_at_once(BitSet set, std::uint32_t i) {
    const std::uint64_t bit = std::uint64_t{1} << i % 64;
    return (__atomic_fetch_or(set.words + i / 64, bit, __ATOMIC_RELAXED) & bit) != 0;
}
#endif

/// Ranges that for_ranges cuts `count` items into.
inline std::uint32_t range_count(std::uint32_t count, std::uint32_t grain) { return (count + grain - 1) / grain; }

/// For for_ranges: items of a range, a multiple of `unit`, so that each worker gets as many ranges as the others. At most `grain`, and if there are more items
/// than `grain`, about a third of it at least.
inline std::uint32_t fair_grain(const Core& core, std::uint32_t count, std::uint32_t grain, std::uint32_t unit) {
    const std::uint32_t workers = worker_count(core), most = 3 * count / grain;
    std::uint32_t ranges = range_count(range_count(count, grain), workers) * workers;
    if (ranges > most) ranges = most > 1 ? most : 1;
    const std::uint32_t items = range_count(range_count(count, ranges), unit) * unit;
    return items < grain ? items : grain;
}

/// In a counting sort: turns the number of a place's items into the index of its first, `start`, and returns where the items end.
ISLET_PART std::uint32_t lay_out(std::uint32_t& place, std::uint32_t start) {
    const std::uint32_t items = place;
    place = start;
    return start + items;
}

/// How items are cut into at most `most` ranges for for_ranges where each range has something of its own; into one if there are no workers.
template <std::uint32_t most>
struct RangeCut {
    static constexpr std::uint32_t room = has_threads ? most : 1;
    std::uint32_t grain, count = 1;

    /// `least`: items that are worth a task.
    RangeCut(const Core& core, std::uint32_t items, std::uint32_t least) : grain(range_count(items, room)) {
        if (grain < least) grain = least;
        if (has_workers(core)) count = range_count(items, grain);
    }
    /// The part that begins with the item `first`.
    std::uint32_t of(std::uint32_t first) const { return has_threads ? first / grain : 0; }
};

/// Calls work(first, end) for ranges that together cover 0 <= i < count: all in one on this thread if there are no workers or no more than `grain`
/// items, else `grain` items each, by the task system. A range begins at a multiple of the grain. A grain should be worth a few microseconds.
template <class Work>
ISLET_ALWAYS_INLINE inline void for_ranges(const Core& core, std::uint32_t count, std::uint32_t grain, Work&& work) {
#if ISLET_THREADS
    if (count > grain && has_workers(core)) {
        struct Task {
            Work& work;
            std::uint32_t count, grain;
            static void run(void* data, std::uint32_t index) {
                const DefaultFloatMode mode;  // each thread has its own
                const Task& task = *static_cast<const Task*>(data);
                const std::uint32_t first = index * task.grain;
                task.work(first, task.count - first < task.grain ? task.count : first + task.grain);
            }
        } task{work, count, grain};
        core.tasks.parallel_for(core.tasks.context, range_count(count, grain), Task::run, &task);
        return;
    }
#else
    static_cast<void>(core);
    static_cast<void>(grain);
#endif
    if (count > 0) work(0u, count);
}

}  // namespace islet::detail
