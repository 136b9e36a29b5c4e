// Searches of joined trees, which the descents of a job reuse.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/job/kept_searches.hpp"
#include "common/job/run_scenario.hpp"
#include "common/search/subtree_pair.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace cd {

/// The search of two joined trees. Reuse saves its setup, which reads all nodes, and lets it expect
/// the answers of neighbouring poses.
class JoinedSearch {
  public:
    using Tree = std::shared_ptr<const WideTree>;

    JoinedSearch(const Tree& a, const Tree& b) : trees_(a, b) {}
    JoinedSearch(const JoinedSearch&) = delete;
    JoinedSearch& operator=(const JoinedSearch&) = delete;

    /// Runs a scenario of the trees' bodies. All calls have the same query. The caller keeps the
    /// trees alive.
    [[nodiscard]] ScenarioRun
    run(const Scenario& scenario, const Query& query, const RunOptions& options);
    /// Whether this is the search of these trees.
    [[nodiscard]] bool is_of(const Tree& a, const Tree& b) const {
        return trees_.first.lock() == a && trees_.second.lock() == b;
    }
    [[nodiscard]] bool has_lost_a_tree() const {
        return trees_.first.expired() || trees_.second.expired();
    }

  private:
    std::pair<std::weak_ptr<const WideTree>, std::weak_ptr<const WideTree>> trees_;
    KeptSearch kept_;
    StopCheck
        stop_; ///< Stops the current run. `kept_` calls it through the options of its first run.
};

/// The searches that no descent uses at the moment. Thread-safe.
class JoinedSearches {
  public:
    using Tree = JoinedSearch::Tree;

    /// Returns the most recently returned search of two trees, or a new one.
    [[nodiscard]] std::unique_ptr<JoinedSearch> take(const Tree& a, const Tree& b);
    /// Keeps a search. Drops searches of released trees, and the oldest one above the limit.
    void give_back(std::unique_ptr<JoinedSearch> search);

  private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<JoinedSearch>> kept_; ///< Most recent last.
};

} // namespace cd
