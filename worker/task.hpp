// One task at this worker: its scenarios, how many are left, and the results not yet sent.
#pragma once

#include "proto/message.hpp"
#include "worker/executor.hpp"
#include "worker/subtree_cache.hpp"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace cd {

class Task {
  public:
    /// Errors: BadFrame when the batch names a tree that is not there, a root that the tree does
    /// not have, trees of unlike forms, wide ones under a tolerance, or poses that are none.
    [[nodiscard]] static Result<Task> make(Batch batch, const SubtreeCache& cache);

    [[nodiscard]] TaskId id() const { return batch_.task; }
    [[nodiscard]] bool uses(TreeId tree) const {
        return batch_.tree_a == tree || batch_.tree_b == tree;
    }
    [[nodiscard]] std::size_t scenario_count() const { return scenarios_.size(); }

    /// The distinct subtrees that a scenario needs, ascending.
    [[nodiscard]] std::vector<SubtreeKey> roots_of(std::size_t scenario) const;
    /// The cache holds all of `roots_of(scenario)`.
    [[nodiscard]] ReadyScenario ready(std::size_t scenario, const SubtreeCache& cache) const;

    void add(const FinishedScenario& finished);
    /// Nobody waits for it any more. Threads that run its scenarios look at the flag.
    void abandon() { abandoned_->store(true); }
    [[nodiscard]] std::shared_ptr<const std::atomic<bool>> abandoned() const { return abandoned_; }

    /// A scenario of it ends without a result.
    void drop() { --unanswered_; }

    [[nodiscard]] std::uint64_t unanswered() const { return unanswered_; }
    /// Uncompressed, of results not yet taken.
    [[nodiscard]] std::size_t result_bytes() const { return records_.size(); }
    /// Nothing when there are no new results.
    [[nodiscard]] std::optional<Results> take_results();

  private:
    Task(Batch batch, std::vector<Scenario> scenarios);
    [[nodiscard]] std::span<const RootPair> pairs_of(std::size_t scenario) const;

    Batch batch_;
    std::shared_ptr<const Query> query_;
    std::vector<Scenario> scenarios_;
    std::uint64_t unanswered_ = 0;
    std::shared_ptr<std::atomic<bool>> abandoned_ = std::make_shared<std::atomic<bool>>(false);
    Bytes records_;   ///< Each behind its length as u32.
    Results results_; ///< Counts of what is in `records_`.
};

} // namespace cd
