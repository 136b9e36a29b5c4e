// A job at a worker: its trees, its query, and its grid of poses if it has one.
#pragma once

#include "common/geometry/part_runs.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/query.hpp"
#include "proto/messages/work_messages.hpp"
#include "worker/cache/subtree_cache.hpp"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <set>

namespace cd {

/// A set of scenarios that need no answer. One thread adds; any thread may call `contains`.
class DroppedScenarios {
  public:
    void add(std::uint64_t scenario);
    /// Takes no lock while the set is empty.
    [[nodiscard]] bool contains(std::uint64_t scenario) const;

  private:
    std::atomic<bool> any_ = false;
    mutable std::mutex mutex_;
    std::set<std::uint64_t> scenarios_;
};

struct WorkerJob {
    JobId id;
    TreeId tree_a;
    TreeId tree_b;
    Query query;
    std::optional<Grid> grid;
    std::shared_ptr<const BodyPartRuns> parts; ///< Null: contacts are not summed by part.
    /// Scenarios that need no answer from any task.
    std::shared_ptr<DroppedScenarios> dropped = std::make_shared<DroppedScenarios>();

    [[nodiscard]] bool uses(TreeId tree) const { return tree_a == tree || tree_b == tree; }
};

/// Makes a job of the master's message. Errors: BadFrame unless the job has two trees, and for an
/// unknown tree, trees of different forms, an invalid grid, or invalid parts.
[[nodiscard]] Result<std::shared_ptr<const WorkerJob>> make_worker_job(AddJob add,
                                                                       const SubtreeCache& cache);

} // namespace cd
