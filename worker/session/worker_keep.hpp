// What a worker keeps from one session to the next: results that are not acknowledged, subtrees,
// and how much it has done.
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

/// Of results that are not acknowledged; at either of them nothing new is begun.
struct UnkeptBounds {
    std::uint64_t bytes = limits::results_unkept_bytes_max;
    std::size_t messages = limits::results_unkept_messages_max;
};

/// Messages of results that the master has not acknowledged yet.
class UnkeptResults {
  public:
    explicit UnkeptResults(const UnkeptBounds& bounds = {}) : bounds_(bounds) {}

    /// Gives the message its number.
    void add(Results& results);
    /// The master has them. Unknown numbers are ignored.
    void kept(std::span<const std::uint64_t> sequences);
    void clear();

    /// To be sent again in a new session, in the order in which they were added: from now on they
    /// are of no task, whose number may mean another one there.
    [[nodiscard]] std::vector<Results> again();
    /// To be sent again in a session that goes on.
    [[nodiscard]] const std::map<std::uint64_t, Results>& messages() const { return messages_; }
    [[nodiscard]] bool empty() const { return messages_.empty(); }
    /// False: nothing new is to be begun.
    [[nodiscard]] bool has_room() const;

  private:
    UnkeptBounds bounds_;
    std::map<std::uint64_t, Results> messages_;
    std::uint64_t last_ = 0;
    std::uint64_t bytes_ = 0; ///< Of their records and maps.
};

/// Between two sessions it holds both; during one the cache is the session's.
struct WorkerKeep {
    explicit WorkerKeep(std::uint64_t cache_bytes, const UnkeptBounds& bounds = {})
        : results(bounds), cache(cache_bytes) {}

    /// Of another cluster nothing that was kept means anything: it goes.
    void enter(const Sha256& its_cluster);

    UnkeptResults results;
    SubtreeCache cache;
    Sha256 cluster; ///< Of the last session; zeros before the first.
    /// Scenarios that were run to their end, whatever became of the results.
    std::shared_ptr<std::atomic<std::uint64_t>> computed =
        std::make_shared<std::atomic<std::uint64_t>>();
};

} // namespace cd
