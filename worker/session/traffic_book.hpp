// Counts a worker's network traffic of geometry, per job.
#pragma once

#include "proto/messages/traffic.hpp"
#include "proto/messages/work_messages.hpp"
#include "worker/cache/subtree_cache.hpp"

#include <cstdint>
#include <map>
#include <set>

namespace cd {

/// Counts blocks per job. A block counts once per arrival, for the job that requested it last.
class TrafficBook {
  public:
    /// `trees`: those of the job's bodies.
    void job_added(JobId job, std::set<TreeId> trees);
    void job_removed(JobId job);
    /// Removes the jobs that use the tree, and the requests for its blocks.
    void tree_removed(TreeId tree);
    [[nodiscard]] bool has(JobId job) const { return jobs_.contains(job); }

    /// Counts cache hits: cached subtrees that scenarios of the job needed.
    void found(JobId job, std::uint64_t subtrees);
    /// Counts a cache miss: a scenario of the job is the first to request the subtree.
    void missed(JobId job, const SubtreeKey& key);
    /// Counts a subtree that only a hint requests.
    void hinted(JobId job, const SubtreeKey& key);
    /// Counts an eviction for each job that uses the tree.
    void evicted(TreeId tree);
    void came_from_master(const SubtreeKey& key, std::uint64_t bytes);
    void came_from_peer(const SubtreeKey& key, std::uint64_t bytes);

    /// Traffic of all jobs since the start of the session.
    [[nodiscard]] const BlockTraffic& total() const { return total_; }
    /// Returns the job's traffic since the last call for this job.
    [[nodiscard]] BlockTraffic take(JobId job);

  private:
    struct Job {
        std::set<TreeId> trees;
        BlockTraffic traffic; ///< Counted since `take` was last called for the job.
    };

    /// Adds to the total, and to the job if it is known.
    void add(JobId job, const BlockTraffic& traffic);
    /// Returns the job that requested the block last; 0 if no job did.
    [[nodiscard]] JobId who_asked(const SubtreeKey& key) const;

    BlockTraffic total_;
    std::map<JobId, Job> jobs_;
    std::map<SubtreeKey, JobId> asked_by_;
};

} // namespace cd
