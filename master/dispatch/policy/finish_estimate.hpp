// Estimates when a worker would finish a scenario: the score of the strategy `earliest-finish`, in
// seconds from now.
#pragma once

#include <cstdint>

namespace cd {

/// Speeds and load of a worker, as inputs of the estimate.
struct WorkerPowers {
    double speed = 1;            ///< Predicted seconds of work that one thread does per second.
    double bytes_per_second = 1; ///< Transfer rate of blocks to the worker.
    double threads = 1;
    double backlog_ns = 0;                        ///< Predicted time of its buffered and sent work.
    double transfers_seconds = 0;                 ///< Time until all blocks under way arrive.
    std::uint64_t room_bytes = ~std::uint64_t{0}; ///< Free space in its cache.
};

/// Needs of a scenario at a worker: thread time and blocks.
struct ScenarioNeeds {
    std::uint64_t cost_ns = 0; ///< Predicted time on one thread of speed 1.
    std::uint64_t missing_bytes = 0;
    std::uint64_t missing_blocks = 0;
    std::uint64_t coming_bytes = 0; ///< Needed blocks that are under way.
    double bytes_of_memory = 0; ///< Wire bytes per byte in the cache; 0: blocks take no room there.
};

/// Terms of the estimate in seconds; nothing is counted twice.
struct FinishTerms {
    double backlog = 0;  ///< The worker's other work, over all threads.
    double coming = 0;   ///< The remaining transfer of blocks under way.
    double transfer = 0; ///< The transfer of the missing bytes.
    double blocks = 0;   ///< Requesting and decoding the missing blocks.
    double eviction = 0; ///< Fetching evicted blocks again later.
    double work = 0;     ///< The scenario, on one thread.

    [[nodiscard]] double total() const {
        return backlog + coming + transfer + blocks + eviction + work;
    }
};

[[nodiscard]] FinishTerms estimate_finish(const WorkerPowers& worker, const ScenarioNeeds& needs);

} // namespace cd
