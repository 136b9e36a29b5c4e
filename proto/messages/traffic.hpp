// Counters of subtree traffic.
#pragma once

#include <cstdint>

namespace cd {

/// Counts the blocks that workers found in their caches, requested, received and evicted.
struct BlockTraffic {
    std::uint64_t hits = 0;   ///< Blocks that a scenario needed and that were cached.
    std::uint64_t misses = 0; ///< Blocks requested because a scenario needed them.
    std::uint64_t hinted = 0; ///< Blocks requested because of a hint.
    std::uint64_t evictions = 0;
    std::uint64_t master_bytes = 0; ///< Compressed bytes received from the master.
    std::uint64_t peer_bytes = 0;   ///< Compressed bytes received from other workers.

    BlockTraffic& operator+=(const BlockTraffic& other);
    friend bool operator==(const BlockTraffic&, const BlockTraffic&) = default;
};

/// Traffic of one worker.
struct CacheTraffic {
    BlockTraffic blocks; ///< Evictions since the process started; all else since the session began.
    std::uint64_t uploaded_bytes = 0; ///< Bytes sent to other workers since the process started.

    friend bool operator==(const CacheTraffic&, const CacheTraffic&) = default;
};

/// Traffic of one job, summed over the Results messages that the master has received.
struct JobTraffic {
    /// A block counts for the job that requested it; an eviction counts for each job that uses the
    /// tree.
    BlockTraffic blocks;
    std::uint64_t result_bytes = 0; ///< Results from workers as sent, including duplicates.

    friend bool operator==(const JobTraffic&, const JobTraffic&) = default;
};

} // namespace cd
