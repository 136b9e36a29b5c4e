// Runs one scenario, from poses to result. Workers, the one-process run and tests all call this.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/job/kept_searches.hpp"
#include "common/job/query.hpp"
#include "common/job/result/result.hpp"
#include "common/job/scenario.hpp"
#include "common/job/settle.hpp"
#include "common/job/statistics.hpp"
#include "common/job/trees_by_body.hpp"
#include "common/motion/cut_bodies.hpp"
#include "common/motion/motion_bound.hpp"
#include "common/search/subtree_pair.hpp"
#include "common/tree/obb_tree.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace cd {

/// The result of one run of a scenario, with its cost.
struct ScenarioRun {
    ScenarioResult result;
    QueryStatistics statistics;
    InsideStatistics inside; ///< Cost of `Settler::settle`; zero from `run_on_subtrees`.
    /// Sorted pairs. If the query has maps: all pairs found. Otherwise, at `level count` with
    /// `keep_touches`: all contacts if none is proper and the search could keep all. Else empty.
    std::vector<ContactPair> found;
    /// True if `stop` ended the run. Then `result` has the class Failed and the reason "stopped".
    bool is_stopped = false;
};

struct RunOptions {
    /// Skips the stages of the pair decision before this one, which changes no answer.
    PairStage first_stage = PairStage::Float;
    StopCheck stop = {};       ///< Polled throughout the run; true ends the run.
    bool keep_touches = false; ///< Keeps touching pairs at `level count`, for `Settler`.
    PairDecision decision = PairDecision::Exact;
    // For Question::Motion alone:
    BodyRadii radii = {}; ///< Of the scenario's bodies.
    /// The cut bodies of a motion; each subtree that the motion needs is in a pair (`query_roots`).
    /// Null if the bodies are not cut; then the only pair has the whole trees.
    const CutBodies* cut = nullptr;
};

/// Finds the contacts under the given pairs of subtrees (paper, 6.4.2, steps 1 to 3). Without pairs
/// the scenario is separate, or the motion free. The caller keeps the subtrees alive. The result
/// does not depend on the order of the pairs, nor on how the trees are cut.
///
/// At `level any` the search ends at the first contact, and the class is contact; without one it is
/// separate. At other levels the class is cross if any pair is proper, touch if there are pairs and
/// none is proper, and separate without pairs; `Settler` refines it with the whole bodies. With a
/// clearance the class is near instead of separate if a pair is within the clearance.
[[nodiscard]] ScenarioRun run_on_subtrees(std::span<const SubtreePair> pairs,
                                          const Scenario& scenario,
                                          const Query& query,
                                          const RunOptions& options = {});

/// Runs a scenario as the overload without `kept` does, but reuses the search in `kept`. All calls
/// with one `kept` share the query, the options and the two trees; the bodies may differ.
[[nodiscard]] ScenarioRun run_on_subtrees(KeptSearch& kept,
                                          std::span<const SubtreePair> pairs,
                                          const Scenario& scenario,
                                          const Query& query,
                                          const RunOptions& options = {});

/// Returns a failed result, whose `failure` names the scenario and has the detail of `why`.
[[nodiscard]] ScenarioResult
failed_result(const Scenario& scenario, const Query& query, const Error& why);

/// Runs scenarios on whole trees: `run_on_subtrees` and `Settler` (settle.hpp) in one.
class ScenarioRunner {
  public:
    /// The trees and the query outlive the runner.
    ScenarioRunner(TreesByBody trees,
                   const Query& query,
                   PairStage first_stage = PairStage::Float,
                   StopCheck stop = {});
    /// Runs scenarios of the bodies 0 and 1.
    ScenarioRunner(const ObbTree& a,
                   const ObbTree& b,
                   const Query& query,
                   PairStage first_stage = PairStage::Float,
                   StopCheck stop = {})
        : ScenarioRunner(TreesByBody(a, b), query, first_stage, std::move(stop)) {}

    [[nodiscard]] const Query& query() const { return query_; }

    /// Any number of threads may call `run` at once. For many scenarios a `ScenarioSession` is
    /// faster.
    [[nodiscard]] ScenarioRun run(const Scenario& scenario) const;

  private:
    friend class ScenarioSession;
    [[nodiscard]] ScenarioRun run_with_kept(const Scenario& scenario, KeptSearch& kept) const;

    TreesByBody trees_;
    const Query& query_;
    std::array<RunOptions, 2> options_; ///< [1]: for scenarios of two closed bodies.
    std::vector<double> radii_;         ///< Of each body, with Question::Motion; else empty.
    Settler settler_;
};

/// Runs scenarios on one thread. The session reuses memory, so that after a few scenarios only
/// results allocate. It is fastest if scenarios of the same trees and neighbouring poses follow
/// each other.
class ScenarioSession {
  public:
    /// The runner outlives the session.
    explicit ScenarioSession(const ScenarioRunner& runner) : runner_(runner) {}

    /// Runs one scenario; the result is that of `ScenarioRunner::run`.
    [[nodiscard]] ScenarioRun run(const Scenario& scenario);

  private:
    const ScenarioRunner& runner_;
    KeptSearches<const ObbTree*> kept_;
};

/// Runs one scenario in a `ScenarioRunner` made for it.
[[nodiscard]] ScenarioRun
run_scenario(const ObbTree& a, const ObbTree& b, const Scenario& scenario, const Query& query);

} // namespace cd
