// One task of this worker: scenarios, number of unanswered scenarios, and unsent results.
#pragma once

#include "common/core/timing/worker.hpp"
#include "proto/messages/work_messages.hpp"
#include "worker/cache/subtree_cache.hpp"
#include "worker/execution/executor.hpp"
#include "worker/execution/task_pairs.hpp"
#include "worker/execution/task_results.hpp"
#include "worker/execution/walk.hpp"
#include "worker/execution/worker_job.hpp"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace cd {

/// A task in progress. If its work unit is analysed, the unit lists the colliding roots of each
/// scenario; otherwise descents of the upper trees find the roots.
class Task {
  public:
    /// Checks a work unit and makes its task. Errors: BadFrame for a body that the job lacks, a
    /// root that its tree lacks, positions outside the grid, invalid poses, or a wrong number of
    /// poses.
    [[nodiscard]] static Result<Task>
    make(WorkUnit unit, std::shared_ptr<const WorkerJob> job, const SubtreeCache& cache);

    [[nodiscard]] TaskId id() const { return id_; }
    [[nodiscard]] const WorkerJob& job() const { return *job_; }
    [[nodiscard]] std::size_t scenario_count() const { return scenarios_.size(); }
    /// The trees of the scenarios' bodies, ascending.
    [[nodiscard]] const std::set<TreeId>& trees() const { return trees_; }

    // ---- Scenarios whose roots are known ----------------------------------------------------
    /// The distinct subtrees that a scenario needs now, ascending: those of its pairs, and both
    /// upper trees if it needs a descent.
    [[nodiscard]] std::vector<SubtreeKey> roots_of(std::size_t scenario) const;
    /// Whether a scenario needs a descent once `roots_of(scenario)` are cached
    /// (`Walked::Waiting`).
    [[nodiscard]] bool walks_again(std::size_t scenario) const {
        return pairs_.walks_again(scenario);
    }
    /// Returns the descent of a scenario that needs one (`walks_again`).
    [[nodiscard]] Walk walk_of(std::size_t scenario, SubtreeCache& cache) const;
    /// Collects the data of a scenario for a thread. Requires `roots_of(scenario)` to be cached.
    [[nodiscard]] ReadyScenario ready(std::size_t scenario, const SubtreeCache& cache) const;

    // ---- Scenarios whose roots are not known ------------------------------------------------
    /// Whether any scenario has not been given to a descent yet.
    [[nodiscard]] bool has_unwalked() const { return walked_ < unwalked_end_; }
    /// Takes the next scenarios for a descent: as many as take about `timing::walk_seconds`, but
    /// few enough to leave work for every thread. Requires `has_unwalked()`.
    [[nodiscard]] Walk next_walk(SubtreeCache& cache, unsigned threads);
    /// Stores the roots that a descent found for a scenario that lacks subtrees.
    void keep_roots(Walked::Waiting waiting) { pairs_.set(std::move(waiting)); }
    /// Ends, without a result, all scenarios that no descent has taken.
    void drop_unwalked() { keep_first(0); }
    /// Ends, without a result, all scenarios from position `count` on that no descent has taken.
    void keep_first(std::size_t count);

    // ---- Returned scenarios -------------------------------------------------------------------
    [[nodiscard]] std::uint64_t index_of(std::size_t scenario) const {
        return scenarios_.at(scenario).index;
    }
    /// Whether the recall, which is of this task, asks for the scenario.
    [[nodiscard]] bool is_recalled(std::size_t scenario, const Recall& recall) const;
    /// Records that a recalled scenario ended without a result.
    void give_back(std::uint64_t index) { given_back_.insert(index); }
    /// All scenarios returned so far: those that were given back, and of a range the ones that no
    /// descent takes any more.
    [[nodiscard]] Recalled given_back() const;
    /// Scenarios that this worker need not answer, because another worker has.
    [[nodiscard]] const std::shared_ptr<DroppedScenarios>& answered_elsewhere() const {
        return answered_elsewhere_;
    }

    void add(const FinishedScenarios& finished);
    /// Stops the threads that run this task's scenarios, by a flag that they check.
    void abandon() { abandoned_->store(true); }
    [[nodiscard]] std::shared_ptr<const std::atomic<bool>> abandoned() const { return abandoned_; }

    /// Ends `scenarios` scenarios without a result.
    void drop(std::size_t scenarios = 1) { unanswered_ -= scenarios; }

    [[nodiscard]] std::uint64_t unanswered() const { return unanswered_; }
    /// Uncompressed bytes of the results not yet taken.
    [[nodiscard]] std::size_t result_bytes() const { return results_.bytes(); }
    /// Packs and removes the results not yet taken; empty if there are no results.
    [[nodiscard]] std::optional<Results> take_results(bool is_within_host) {
        return results_.take(id_, *job_, is_within_host);
    }

  private:
    Task(TaskId id,
         std::shared_ptr<const WorkerJob> job,
         TaskScenarios scenarios,
         std::set<TreeId> trees);

    /// Plans descents for scenarios of an analysed unit: all motions, and distances that look twice
    /// because they would fetch subtrees otherwise.
    void plan_walks(const SubtreeCache& cache);

    TaskId id_;
    std::shared_ptr<const WorkerJob> job_;
    TaskScenarios scenarios_;
    std::set<TreeId> trees_; ///< The trees of the scenarios' bodies.
    std::uint64_t unanswered_ = 0;
    std::shared_ptr<std::atomic<bool>> abandoned_ = std::make_shared<std::atomic<bool>>(false);
    std::shared_ptr<DroppedScenarios> answered_elsewhere_ = std::make_shared<DroppedScenarios>();
    std::set<std::uint64_t> given_back_; ///< Indices of returned scenarios whose roots were known.
    TaskResults results_;                ///< Results not yet taken.
    TaskPairs pairs_;
    std::size_t walked_ = 0;       ///< Scenarios given to descents so far; 0 if analysed.
    std::size_t unwalked_end_ = 0; ///< One past the last scenario for descents; 0 if analysed.
};

} // namespace cd
