// State that a worker keeps between sessions: unacknowledged results, subtrees, and a count of
// computed scenarios.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/limits/worker.hpp"
#include "proto/messages/work_messages.hpp"
#include "worker/cache/subtree_cache.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace cd {

/// Bounds of unacknowledged results. At either bound the worker begins no new scenario.
struct UnkeptBounds {
    std::uint64_t bytes = limits::results_unkept_bytes_max;
    std::size_t messages = limits::results_unkept_messages_max;
};

/// Results of one job that are lost with the worker.
struct UnkeptOfJob {
    std::uint64_t scenarios = 0;
    double compute_seconds = 0;
};

/// Result messages that the master has not acknowledged yet.
class UnkeptResults {
  public:
    explicit UnkeptResults(const UnkeptBounds& bounds = {}) : bounds_(bounds) {}

    /// Stores the message and sets its sequence number.
    void add(Results& results);
    /// Drops acknowledged messages. Ignores unknown numbers.
    void kept(std::span<const std::uint64_t> sequences);
    void clear();

    /// The messages to send in a new session, in order. Clears their task ids for good, since a
    /// new session numbers its tasks from the start.
    [[nodiscard]] std::vector<Results> again();
    /// The messages to send again in a resumed session, by sequence number.
    [[nodiscard]] const std::map<std::uint64_t, Results>& messages() const { return messages_; }
    [[nodiscard]] bool empty() const { return messages_.empty(); }
    [[nodiscard]] std::map<JobId, UnkeptOfJob> by_job() const;
    /// Whether new scenarios may begin.
    [[nodiscard]] bool has_room() const;

  private:
    UnkeptBounds bounds_;
    std::map<std::uint64_t, Results> messages_;
    std::uint64_t last_ = 0;  ///< Last sequence number used.
    std::uint64_t bytes_ = 0; ///< Size of all records and maps.
};

/// Owns results and cache between sessions. During a session, the session owns the cache.
struct CarryOver {
    explicit CarryOver(std::uint64_t cache_bytes, const UnkeptBounds& bounds = {})
        : results(bounds), cache(cache_bytes) {}

    /// Begins a session with a cluster. Drops the results and the parked trees if the last session
    /// was with another cluster.
    void enter(const Sha256& its_cluster);

    UnkeptResults results;
    SubtreeCache cache;
    Sha256 cluster; ///< Cluster of the last session; zeros before the first.
    /// Scenarios computed to the end, even if their results were dropped.
    std::shared_ptr<std::atomic<std::uint64_t>> computed =
        std::make_shared<std::atomic<std::uint64_t>>();
};

} // namespace cd
