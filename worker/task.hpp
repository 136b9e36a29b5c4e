// One task at this worker: its scenarios, how many are left, and the results not yet sent.
#pragma once

#include "proto/work_messages.hpp"
#include "worker/executor.hpp"
#include "worker/subtree_cache.hpp"
#include "worker/walk.hpp"
#include "worker/worker_job.hpp"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <unordered_map>
#include <vector>

namespace cd {

/// Of a Batch the colliding roots of each scenario are known; those of a ScenarioRange are found by
/// walks over parts of it.
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

    // ---- Of scenarios whose roots are known ----------------------------------------------------
    /// The distinct subtrees that a scenario needs, ascending.
    [[nodiscard]] std::vector<SubtreeKey> roots_of(std::size_t scenario) const;
    /// The cache holds all of `roots_of(scenario)`.
    [[nodiscard]] ReadyScenario ready(std::size_t scenario, const SubtreeCache& cache) const;

    // ---- Of scenarios whose roots are not known ------------------------------------------------
    /// Some are neither walked nor in a walk.
    [[nodiscard]] bool has_unwalked() const { return walked_ < unwalked_end_; }
    /// The next of them, of which there are: as many as take about `limits::walk_seconds`, and
    /// leave something for each of the worker's threads.
    [[nodiscard]] Walk next_walk(SubtreeCache& cache, unsigned threads);
    /// The scenario waits for subtrees now.
    void keep_roots(Walked::Waiting waiting);
    /// Those that are in no walk end without a result.
    void drop_unwalked() { keep_places(0); }
    /// The same of all but the first so many of the range.
    void keep_places(std::size_t count);

    // ---- What was given back -----------------------------------------------------------------
    [[nodiscard]] std::uint64_t index_of(std::size_t scenario) const {
        return scenarios_.at(scenario).index;
    }
    /// It has ended without a result, since the master wants it back.
    void give_back(std::uint64_t index) { given_back_.insert(index); }
    /// All of it so far.
    [[nodiscard]] Recalled given_back() const;
    /// Scenarios that are not to be answered here.
    [[nodiscard]] const std::shared_ptr<DroppedScenarios>& answered_elsewhere() const {
        return answered_elsewhere_;
    }

    void add(const FinishedScenarios& finished);
    /// Nobody waits for it any more. Threads that run its scenarios look at the flag.
    void abandon() { abandoned_->store(true); }
    [[nodiscard]] std::shared_ptr<const std::atomic<bool>> abandoned() const { return abandoned_; }

    /// So many scenarios of it end without a result.
    void drop(std::size_t scenarios = 1) { unanswered_ -= scenarios; }

    [[nodiscard]] std::uint64_t unanswered() const { return unanswered_; }
    /// Uncompressed, of results not yet taken.
    [[nodiscard]] std::size_t result_bytes() const {
        return results_.records.size() + map_.bytes();
    }
    /// Nothing when there are no new results.
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
    std::set<std::uint64_t> given_back_; ///< Indices, of a batch.
    FinishedScenarios results_;          ///< Not yet taken; without the map,
    ContactMapSum map_;                  ///< which is here.

    std::vector<std::uint32_t> pair_offsets_; ///< Of a batch.
    std::vector<RootPair> pairs_;

    std::unordered_map<std::size_t, std::vector<RootPair>> found_pairs_; ///< By walks.
    std::size_t walked_ = 0;                                             ///< Or in a walk.
    std::size_t unwalked_end_ = 0;
    double scenario_seconds_ = 0; ///< Of those that came back last, each.
};

} // namespace cd
