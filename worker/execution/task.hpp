// One task at this worker: its scenarios, how many are left, and the results not yet sent.
#pragma once

#include "common/core/limits/worker.hpp"
#include "proto/messages/work_messages.hpp"
#include "worker/cache/subtree_cache.hpp"
#include "worker/execution/executor.hpp"
#include "worker/execution/walk.hpp"
#include "worker/execution/worker_job.hpp"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <unordered_map>
#include <vector>

namespace cd {

/// A Batch names the colliding roots of each scenario; for a ScenarioRange, walks over parts of it
/// find them.
class Task {
  public:
    /// Errors: BadFrame when the batch names a root that its tree does not have, or its poses are
    /// none.
    [[nodiscard]] static Result<Task>
    make(Batch batch, std::shared_ptr<const WorkerJob> job, const SubtreeCache& cache);
    /// Errors: BadFrame for places that the grid does not have, or poses that are not as many as
    /// announced.
    [[nodiscard]] static Result<Task> make(const ScenarioRange& range,
                                           std::shared_ptr<const WorkerJob> job);

    [[nodiscard]] TaskId id() const { return id_; }
    [[nodiscard]] const WorkerJob& job() const { return *job_; }
    [[nodiscard]] std::size_t scenario_count() const { return scenarios_.size(); }

    // ---- Scenarios whose roots are known ----------------------------------------------------
    /// The distinct subtrees that a scenario needs, ascending.
    [[nodiscard]] std::vector<SubtreeKey> roots_of(std::size_t scenario) const;
    /// The cache holds all of `roots_of(scenario)`.
    [[nodiscard]] ReadyScenario ready(std::size_t scenario, const SubtreeCache& cache) const;

    // ---- Scenarios whose roots are not known ------------------------------------------------
    /// Whether some scenarios are neither walked nor in a walk.
    [[nodiscard]] bool has_unwalked() const { return walked_ < unwalked_end_; }
    /// The next of them, of which there are: as many as take about `limits::walk_seconds`, and
    /// leave something for each of the worker's threads.
    [[nodiscard]] Walk next_walk(SubtreeCache& cache, unsigned threads);
    /// The scenario waits for subtrees now.
    void keep_roots(Walked::Waiting waiting);
    /// Ends all scenarios that are in no walk, without a result.
    void drop_unwalked() { keep_places(0); }
    /// Ends those of them that are not among the first `count` of the range.
    void keep_places(std::size_t count);

    // ---- Scenarios given back -----------------------------------------------------------------
    [[nodiscard]] std::uint64_t index_of(std::size_t scenario) const {
        return scenarios_.at(scenario).index;
    }
    /// The scenario has ended without a result, because the master wants it back.
    void give_back(std::uint64_t index) { given_back_.insert(index); }
    /// Everything given back so far.
    [[nodiscard]] Recalled given_back() const;
    /// Scenarios that this worker need not answer.
    [[nodiscard]] const std::shared_ptr<DroppedScenarios>& answered_elsewhere() const {
        return answered_elsewhere_;
    }

    void add(const FinishedScenarios& finished);
    /// Abandons the task. Threads that run its scenarios check the flag.
    void abandon() { abandoned_->store(true); }
    [[nodiscard]] std::shared_ptr<const std::atomic<bool>> abandoned() const { return abandoned_; }

    /// Ends that many scenarios without a result.
    void drop(std::size_t scenarios = 1) { unanswered_ -= scenarios; }

    [[nodiscard]] std::uint64_t unanswered() const { return unanswered_; }
    /// Uncompressed bytes of the results not yet taken.
    [[nodiscard]] std::size_t result_bytes() const {
        return results_.records.size() + map_.bytes();
    }
    /// Empty if there are no new results.
    [[nodiscard]] std::optional<Results> take_results();

  private:
    Task(TaskId id, std::shared_ptr<const WorkerJob> job, TaskScenarios scenarios);
    [[nodiscard]] std::span<const RootPair> pairs_of(std::size_t scenario) const;

    TaskId id_;
    std::shared_ptr<const WorkerJob> job_;
    TaskScenarios scenarios_;
    std::uint64_t unanswered_ = 0;
    std::shared_ptr<std::atomic<bool>> abandoned_ = std::make_shared<std::atomic<bool>>(false);
    std::shared_ptr<DroppedScenarios> answered_elsewhere_ = std::make_shared<DroppedScenarios>();
    std::set<std::uint64_t> given_back_; ///< Indices; for batches.
    FinishedScenarios results_;          ///< Not yet taken; without the map.
    ContactMapSum map_;                  ///< The map of `results_`.

    std::vector<std::uint32_t> pair_offsets_; ///< For batches.
    std::vector<RootPair> pairs_;

    std::unordered_map<std::size_t, std::vector<RootPair>> found_pairs_; ///< Found by walks.
    std::size_t walked_ = 0; ///< Including those in a walk.
    std::size_t unwalked_end_ = 0;
    double scenario_seconds_ = 0; ///< For one scenario, of the last that returned.
};

} // namespace cd
