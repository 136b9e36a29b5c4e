// What is counted of the subtrees that travel.
#pragma once

#include <cstdint>

namespace cd {

/// What became of the subtrees that scenarios needed at a worker.
struct BlockTraffic {
    std::uint64_t hits = 0;   ///< Needed by a scenario and there already.
    std::uint64_t misses = 0; ///< Asked for, because a scenario needed them.
    std::uint64_t hinted = 0; ///< Asked for, because the master had named them.
    std::uint64_t evictions = 0;
    std::uint64_t master_bytes = 0; ///< Compressed, from the master,
    std::uint64_t peer_bytes = 0;   ///< and from other workers.

    BlockTraffic& operator+=(const BlockTraffic& other);
    friend bool operator==(const BlockTraffic&, const BlockTraffic&) = default;
};

/// Of one worker, since it was welcomed.
struct CacheTraffic {
    BlockTraffic blocks;
    std::uint64_t uploaded_bytes = 0; ///< To other workers.

    friend bool operator==(const CacheTraffic&, const CacheTraffic&) = default;
};

/// Of one job, at all workers, as far as its results have come.
struct JobTraffic {
    BlockTraffic blocks;            ///< A block counts for the job that asked for it; one that is
                                    ///< evicted, for each job that uses its tree.
    std::uint64_t result_bytes = 0; ///< From workers, packed; also what came twice.

    friend bool operator==(const JobTraffic&, const JobTraffic&) = default;
};

} // namespace cd
