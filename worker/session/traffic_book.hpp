// Counts the network traffic of a worker's geometry by job.
#pragma once

#include "proto/messages/traffic.hpp"
#include "proto/messages/work_messages.hpp"
#include "worker/cache/subtree_cache.hpp"

#include <cstdint>
#include <map>

namespace cd {

/// A block counts for the job that asked for it last, even if it comes several times.
class TrafficBook {
  public:
    void job_added(JobId job) { jobs_.try_emplace(job); }
    void job_removed(JobId job);
    void tree_removed(TreeId tree);

    /// Scenarios of the job found that many of the subtrees that they needed.
    void found(JobId job, std::uint64_t subtrees);
    /// A scenario of the job is the first to ask for the subtree.
    void missed(JobId job, const SubtreeKey& key);
    /// A hint asks for the subtree before a scenario needs it.
    void hinted(JobId job, const SubtreeKey& key);
    void evicted(JobId job);
    void came_from_master(const SubtreeKey& key, std::uint64_t bytes);
    void came_from_peer(const SubtreeKey& key, std::uint64_t bytes);

    /// Counts of all jobs since the start.
    [[nodiscard]] const BlockTraffic& total() const { return total_; }
    /// Of the job, since the call before.
    [[nodiscard]] BlockTraffic take(JobId job);

  private:
    /// In total, and for the job if it is here.
    void add(JobId job, const BlockTraffic& traffic);
    /// 0 where nobody did.
    [[nodiscard]] JobId who_asked(const SubtreeKey& key) const;

    BlockTraffic total_;
    std::map<JobId, BlockTraffic> jobs_;
    std::map<SubtreeKey, JobId> asked_by_;
};

} // namespace cd
