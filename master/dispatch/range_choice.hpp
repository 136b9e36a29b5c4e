// Chooses whether a job's next scenarios go out in ranges or are analysed by the master first.
#pragma once

#include <cstdint>
#include <optional>

namespace cd {

/// Cost of missing blocks, in seconds of transfer and of opening them.
struct MissingCosts {
    std::optional<double> matched; ///< Per scenario, at the worker that matched it.
    std::optional<double> any;     ///< Per scenario, at an average worker.
    double all = 0;                ///< Filling every cache with both trees, summed over workers.
    bool all_fits = false;         ///< Both trees fit into every worker's cache.
};

/// Inputs of the choice, in seconds of one thread or of the network thread.
struct RangeCosts {
    std::uint64_t scenarios_left = 0;
    double analysis = 0; ///< Per scenario at the master: the descent of the upper trees.
    double matching = 0; ///< Per scenario: the rest, on the state thread.
    double work = 0;     ///< Per scenario, at a worker.
    double threads_master = 1;
    double threads_workers = 1;
    MissingCosts missing;
};

/// The descent costs the same at the master and at a worker. An analysis costs the matching, and
/// idle workers if the master cannot feed them all. A range costs the blocks that are missing
/// without matching; in total at most the filling of every cache, if both trees fit. False while
/// these costs are unknown.
[[nodiscard]] bool prefers_ranges(const RangeCosts& costs);

} // namespace cd
