// What a worker knows of a job: its trees, its query, and its poses where a grid tells them.
#pragma once

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

/// Scenarios of a job that are not to be answered. Any thread may ask, and one adds.
class DroppedScenarios {
  public:
    void add(std::uint64_t scenario);
    /// Cheap as long as there are none.
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
    std::shared_ptr<DroppedScenarios> dropped = std::make_shared<DroppedScenarios>();

    [[nodiscard]] bool uses(TreeId tree) const { return tree_a == tree || tree_b == tree; }
};

/// Errors: BadFrame unless there are two trees; when a tree is not here, the trees have unlike
/// forms, wide ones under a tolerance, or the grid is none.
[[nodiscard]] Result<std::shared_ptr<const WorkerJob>> make_worker_job(AddJob add,
                                                                       const SubtreeCache& cache);

} // namespace cd
