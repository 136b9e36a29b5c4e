// Whether a job's next scenarios go out in ranges, or are analysed by the master first.
#pragma once

#include <cstdint>
#include <optional>

namespace cd {

/// What scenarios lack, in seconds of transfer and of opening blocks.
struct MissingCosts {
    std::optional<double> matched; ///< Of a scenario, with the worker that matched it.
    std::optional<double> any;     ///< Of a scenario, with any worker.
    double all = 0;                ///< Until each worker holds all of both trees, over all workers.
    bool all_fits = false;         ///< In every worker's cache.
};

/// What the choice is made from. Seconds of one thread, or of the network thread.
struct RangeCosts {
    std::uint64_t scenarios_left = 0;
    double analysis = 0; ///< Of the master, a scenario: the walk down the tops,
    double matching = 0; ///< and what follows on the one thread that keeps the state.
    double work = 0;     ///< Of a worker, a scenario.
    double threads_master = 1;
    double threads_workers = 1;
    MissingCosts missing;
};

/// The walk costs the same wherever it is done. An analysis costs the matching, and what workers
/// wait for it when there are more of them than the master can feed. A range costs the blocks that
/// are missing because nobody matched it; in all no more than filling every cache, where that fits.
/// False while that is not known.
[[nodiscard]] bool prefers_ranges(const RangeCosts& costs);

} // namespace cd
