// The scenarios of a range on one thread of a worker: the colliding roots of each are found here,
// and what has all its subtrees runs at once.
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
#include <memory>
#include <vector>

namespace cd {

/// The scenarios of a task, as they came or as a grid tells them.
class TaskScenarios {
  public:
    /// Places [first, first + count) of the job's grid, which exist.
    TaskScenarios(std::shared_ptr<const WorkerJob> job, std::uint64_t first, std::size_t count)
        : job_(std::move(job)), first_(first), size_(count) {}
    explicit TaskScenarios(std::vector<Scenario> list)
        : list_(std::make_shared<const std::vector<Scenario>>(std::move(list))),
          size_(list_->size()) {}

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] Scenario at(std::size_t place) const;

  private:
    std::shared_ptr<const std::vector<Scenario>> list_; ///< Null: the grid's.
    std::shared_ptr<const WorkerJob> job_;
    std::uint64_t first_ = 0;
    std::size_t size_ = 0;
};

/// Some of a task's scenarios, with all that it takes to walk them, whatever becomes of the cache
/// meanwhile.
struct Walk {
    std::shared_ptr<const WorkerJob> job;
    TaskScenarios scenarios;
    std::size_t begin = 0; ///< Places in the task.
    std::size_t end = 0;
    std::shared_ptr<const PartialObbTree> a;
    std::shared_ptr<const PartialObbTree> b;
    std::shared_ptr<const DroppedScenarios> answered_elsewhere;
};

/// Results of scenarios, in bulk.
struct FinishedScenarios {
    Bytes records; ///< `encode_result`, each behind its length as u32.
    std::uint32_t count = 0;
    QueryStatistics statistics;
    double seconds = 0; ///< Of one thread.
    ContactMap map;     ///< Of these scenarios, where the query is for maps.

    void add(const Bytes& record);
};

struct Walked {
    struct Waiting {
        std::size_t scenario = 0; ///< Its place in the task.
        std::vector<RootPair> pairs;
    };

    FinishedScenarios finished;
    std::vector<Waiting> waiting; ///< Lack subtrees.
    std::vector<SubtreeKey> used; ///< Subtrees that others had,
    std::uint64_t found = 0;      ///< and how many they had, summed over them.
    std::size_t left = 0;         ///< Not answered: it was told to stop, or they were dropped.
};

/// `clock` is told which scenario runs.
[[nodiscard]] Walked walk(const Walk& walk, const StopCheck& stop, ScenarioClock& clock);

} // namespace cd
