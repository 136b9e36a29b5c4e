// The searches of joined trees that a job's descents use one after the other.
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

/// The search of two joined trees. The first use of a search reads the trees, and further ones
/// expect the answers of neighbouring poses again, so it is kept for further descents.
class JoinedSearch {
  public:
    using Tree = std::shared_ptr<const WideTree>;

    JoinedSearch(const Tree& a, const Tree& b) : trees_(a, b) {}
    JoinedSearch(const JoinedSearch&) = delete;
    JoinedSearch& operator=(const JoinedSearch&) = delete;

    /// Runs a scenario of the trees' bodies; all calls share the query. The caller keeps the trees.
    [[nodiscard]] ScenarioRun
    run(const Scenario& scenario, const Query& query, const RunOptions& options);
    /// Whether this searches these trees. The trees of a search may be gone.
    [[nodiscard]] bool is_of(const Tree& a, const Tree& b) const {
        return trees_.first.lock() == a && trees_.second.lock() == b;
    }
    [[nodiscard]] bool has_lost_a_tree() const {
        return trees_.first.expired() || trees_.second.expired();
    }

  private:
    std::pair<std::weak_ptr<const WideTree>, std::weak_ptr<const WideTree>> trees_;
    KeptSearch kept_;
    StopCheck stop_; ///< That of the running scenario: the kept search has the first one's options.
};

/// Searches that no descent uses now. Any thread may call the members.
class JoinedSearches {
  public:
    using Tree = JoinedSearch::Tree;

    /// Returns the search of two trees that was given back last, or a new one.
    [[nodiscard]] std::unique_ptr<JoinedSearch> take(const Tree& a, const Tree& b);
    /// Keeps a search. Drops those whose trees are gone, and of too many the one kept longest.
    void give_back(std::unique_ptr<JoinedSearch> search);

  private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<JoinedSearch>> kept_; ///< The one given back last comes last.
};

} // namespace cd
