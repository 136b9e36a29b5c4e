// Chooses whether a job's next scenarios go out in ranges or are analysed by the master first.
#pragma once

#include <cstdint>
#include <optional>

namespace cd {

/// Cost of missing blocks: seconds to transfer and decode them.
struct MissingCosts {
    std::optional<double> matched; ///< For each scenario, at the worker chosen by matching.
    std::optional<double> any;     ///< For each scenario, at an average worker.
    double all = 0;                ///< Time to fill every cache with the job's trees, in total.
    bool all_fits = false;         ///< True if the trees fit into every worker's cache.
    double of_byte = 0;            ///< For each byte of a batch, on an average worker's link.
};

/// Inputs of the choice. Times are seconds of one thread.
struct RangeCosts {
    std::uint64_t scenarios_left = 0;
    double analysis = 0; ///< Time per scenario on a pool thread: the descent of the upper trees.
    double matching = 0; ///< Time per scenario on the state thread: matching and sending.
    /// Bytes that an analysed scenario takes in a batch, less those that it takes in a range.
    double analysed_bytes = 0;
    double work = 0; ///< Time per scenario on a worker's thread.
    double threads_master = 1;
    double threads_workers = 1;
    MissingCosts missing;
};

/// True if ranges cost less than analysis on the master. The descent of the upper trees costs
/// equally much in both cases. Analysis adds the time for matching, and idle workers if the master
/// cannot feed them all, and the bytes of colliding roots on the workers' links. Ranges add the
/// blocks that workers miss without matching, in total at most the filling of every cache, if the
/// job's trees fit. True without measurements if no worker misses a block; otherwise false while
/// `missing` is unknown.
[[nodiscard]] bool prefers_ranges(const RangeCosts& costs);

} // namespace cd
