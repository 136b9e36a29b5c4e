// Runs part of a scenario range on one thread: finds the colliding roots of each scenario, and
// tests at once the scenarios whose subtrees are all cached. A distance needs the subtrees of its
// nearest roots first, and then those of the roots that may be nearer than what was found. For a
// motion, the colliding roots are found again for each of its poses.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/job/result/contact_map.hpp"
#include "common/job/scenario.hpp"
#include "common/job/statistics.hpp"
#include "common/tree/partial_tree.hpp"
#include "worker/execution/scenario_clock.hpp"
#include "worker/execution/worker_job.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace cd {

/// The scenarios of a task, from a list or from the job's grid.
class TaskScenarios {
  public:
    /// Takes positions [first, first + count) of the job's grid, which must exist.
    TaskScenarios(std::shared_ptr<const WorkerJob> job, std::uint64_t first, std::size_t count)
        : job_(std::move(job)), first_(first), size_(count) {}
    explicit TaskScenarios(std::vector<Scenario> list)
        : list_(std::make_shared<const std::vector<Scenario>>(std::move(list))),
          size_(list_->size()) {}

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] Scenario at(std::size_t which) const;
    /// The trees of the scenarios' bodies.
    [[nodiscard]] std::set<TreeId> trees(const WorkerJob& job) const;

  private:
    std::shared_ptr<const std::vector<Scenario>> list_; ///< Null: the grid gives the scenarios.
    std::shared_ptr<const WorkerJob> job_;
    std::uint64_t first_ = 0;
    std::size_t size_ = 0;
};

/// Input of one descent: some of a range's scenarios, and snapshots of their trees that stay valid
/// while the cache changes.
struct Walk {
    std::shared_ptr<const WorkerJob> job;
    TaskScenarios scenarios;
    std::size_t begin = 0; ///< First position in the task.
    std::size_t end = 0;   ///< One past the last position in the task.
    std::map<TreeId, std::shared_ptr<const PartialObbTree>> trees;
    std::shared_ptr<const DroppedScenarios> answered_elsewhere;
    std::map<TreeId, std::shared_ptr<const WideTree>> joined = {}; ///< Joined ones of `trees`.
};

/// Results of several scenarios.
struct FinishedScenarios {
    Bytes records; ///< Output of `encode_result`, each record after its length as u32.
    std::uint32_t count = 0;
    QueryStatistics statistics;
    double seconds = 0; ///< Thread time.
    ContactMap map;     ///< Empty unless the query asks for maps.

    void add(const Bytes& record);
    /// Counts the pairs of roots of a scenario, if it asks for a distance.
    void count_roots(const Query& query, std::size_t named, std::size_t used);
};

/// Output of one descent.
struct Walked {
    /// A scenario with missing subtrees.
    struct Waiting {
        std::size_t scenario = 0;    ///< Position in the task.
        std::vector<RootPair> pairs; ///< Those whose subtrees it needs now.
        /// Whether the scenario needs another descent once its subtrees are cached: a motion always
        /// does, and a distance whose `pairs` are only the nearest ones (`first_look`).
        bool walks_again = false;
        std::size_t named = 0; ///< Number of pairs that may have its answer, at least `pairs`.
    };

    FinishedScenarios finished;
    std::vector<Waiting> waiting; ///< Not answered, because subtrees are missing.
    std::vector<SubtreeKey> used; ///< Cached subtrees that the scenarios need.
    std::uint64_t found = 0;      ///< Number of subtrees used, summed over the scenarios run.
    std::size_t left = 0;         ///< Scenarios not answered because of a stop or a drop.
};

/// Runs the scenarios of one descent in order and sets `clock` for each.
[[nodiscard]] Walked walk(const Walk& walk, const StopCheck& stop, ScenarioClock& clock);

} // namespace cd
