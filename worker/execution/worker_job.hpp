// A job at a worker: the trees of its bodies, its query, and its grid of poses if it has one.
#pragma once

#include "common/geometry/part_runs.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/query.hpp"
#include "common/job/scenario.hpp"
#include "proto/messages/work_messages.hpp"
#include "worker/cache/subtree_cache.hpp"
#include "worker/execution/joined_searches.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <vector>

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
    std::vector<TreeId> trees; ///< The tree of each body.
    Query query;
    std::optional<Grid> grid;
    std::shared_ptr<const BodyPartRuns> parts; ///< Null: contacts are not summed by part.
    std::vector<double> radii;                 ///< Of each body, in a job of motions; else empty.
    /// Scenarios that need no answer from any task.
    std::shared_ptr<DroppedScenarios> dropped = std::make_shared<DroppedScenarios>();

    std::shared_ptr<JoinedSearches> joined_searches = std::make_shared<JoinedSearches>();

    [[nodiscard]] TreeId tree_a(const Scenario& scenario) const { return trees[scenario.body_a]; }
    [[nodiscard]] TreeId tree_b(const Scenario& scenario) const { return trees[scenario.body_b]; }
    [[nodiscard]] bool uses(TreeId tree) const {
        return std::ranges::find(trees, tree) != trees.end();
    }
};

/// Makes a job of the master's message. Errors: BadFrame for fewer than two bodies, an unknown
/// tree, trees of different forms, an invalid grid, invalid parts, parts of other than two bodies,
/// or a motion without the radius of each body.
[[nodiscard]] Result<std::shared_ptr<const WorkerJob>> make_worker_job(AddJob add,
                                                                       const SubtreeCache& cache);

} // namespace cd
