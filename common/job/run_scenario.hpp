// One scenario, from poses to result. The worker, the one-process run and the tests all call this.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/job/query.hpp"
#include "common/job/result/result.hpp"
#include "common/job/scenario.hpp"
#include "common/job/settle.hpp"
#include "common/job/statistics.hpp"
#include "common/search/traverse.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/obb_tree.hpp"
#include "common/tree/wire/subtree_block.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace cd {

/// A result with what it cost.
struct ScenarioRun {
    ScenarioResult result;
    QueryStatistics statistics;
    InsideStatistics inside; ///< Of who settled the class; nothing from `run_on_subtrees`.
    /// At level count: all pairs, sorted, with a query for maps; where none is proper and touches
    /// were to be kept, if they are not too many.
    std::vector<ContactPair> found;
    bool is_stopped = false; ///< It was told to stop. The result only says so, as a failed one.
};

/// One colliding pair of distribution roots with its two subtrees.
struct SubtreePair {
    TreeView a;
    TreeView b;
};

struct RunOptions {
    /// Stages of the pairs' decision before this one are passed over, which changes no answer.
    PairStage first_stage = PairStage::Float;
    StopCheck stop = {};       ///< Asked all along.
    bool keep_touches = false; ///< For `Settler` at level count.
};

/// The contacts under the given pairs of subtrees (paper, 6.4.2, steps 1 to 3). No pairs: separate.
/// The caller keeps the subtrees alive. The result does not depend on the order of the pairs, nor,
/// without a tolerance, on how the trees were cut.
///
/// Level any: contact or separate; the search ends at the first contact, also under a tolerance;
/// without one it is undecided if any boxes were left. Other levels: undecided if any boxes were
/// left, with what was proven so far. (Pairs to be ignored are known by their triangles, so boxes
/// of such pairs may be left undecided as well.) Else cross if any pair is proper, touch if there
/// are pairs and none is proper, separate without pairs: what more there is to say, `Settler` finds
/// in the whole bodies.
[[nodiscard]] ScenarioRun run_on_subtrees(std::span<const SubtreePair> pairs,
                                          const Scenario& scenario,
                                          const Query& query,
                                          const RunOptions& options = {});

/// A search that keeps its memory from one scenario to the next of the same query.
struct KeptSearch {
    std::optional<ContactSearch> search; ///< Made by the first.
};

/// The same with a search that is kept; the query and the options are those of the scenarios
/// before.
[[nodiscard]] ScenarioRun run_on_subtrees(KeptSearch& kept,
                                          std::span<const SubtreePair> pairs,
                                          const Scenario& scenario,
                                          const Query& query,
                                          const RunOptions& options = {});

/// The failed result of a scenario, naming it.
[[nodiscard]] ScenarioResult
failed_result(const Scenario& scenario, const Query& query, const Error& why);

/// Answers scenarios of two whole trees as the cluster does: `run_on_subtrees` and `Settler`
/// (settle.hpp) in one. Under a tolerance the trees are cut at `tolerance_depth` (tolerance.hpp),
/// and this holds a copy of their subtrees.
class ScenarioRunner {
  public:
    /// The trees and the query outlive the runner.
    ScenarioRunner(const ObbTree& a,
                   const ObbTree& b,
                   const Query& query,
                   PairStage first_stage = PairStage::Float,
                   StopCheck stop = {});

    [[nodiscard]] const Query& query() const { return query_; }

    /// For any number of threads at once. For many scenarios a `ScenarioSession` is faster.
    [[nodiscard]] ScenarioRun run(const Scenario& scenario) const;

  private:
    friend class ScenarioSession;
    struct CutTree {
        TreeTop top;
        std::vector<Subtree> subtrees; ///< One for each root.
    };
    [[nodiscard]] static std::shared_ptr<const CutTree> cut(const ObbTree& tree);
    [[nodiscard]] ScenarioRun run_on_cuts(const Scenario& scenario, KeptSearch& kept) const;
    [[nodiscard]] ScenarioRun run_with_kept(const Scenario& scenario, KeptSearch& kept) const;
    [[nodiscard]] bool is_stopped() const { return options_.stop && options_.stop(); }

    const ObbTree& a_;
    const ObbTree& b_;
    const Query& query_;
    RunOptions options_;
    Settler settler_;
    std::shared_ptr<const CutTree> cut_a_; ///< Null without a tolerance.
    std::shared_ptr<const CutTree> cut_b_;
};

/// One thread's way through a runner's scenarios: what one needed of memory serves the next, so
/// that after a few only results allocate.
class ScenarioSession {
  public:
    /// The runner outlives the session.
    explicit ScenarioSession(const ScenarioRunner& runner) : runner_(runner) {}

    /// What `ScenarioRunner::run` says.
    [[nodiscard]] ScenarioRun run(const Scenario& scenario);

    /// A scenario's place among those given, and its run; false ends it.
    using OnRun = std::function<bool(std::size_t place, ScenarioRun run)>;
    /// Runs of poses: each scenario once, in `coherent_order`, in which each finds in the caches
    /// what the one before used. The results are those of `run`. Whether it got to the end.
    bool run_all(std::span<const Scenario> scenarios, const OnRun& done);

  private:
    const ScenarioRunner& runner_;
    KeptSearch kept_;
};

/// One scenario of a `ScenarioRunner`.
[[nodiscard]] ScenarioRun
run_scenario(const ObbTree& a, const ObbTree& b, const Scenario& scenario, const Query& query);

} // namespace cd
