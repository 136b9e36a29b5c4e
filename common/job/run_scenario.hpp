// One scenario, from poses to result. The worker, the one-process run and the tests all call this.
#pragma once

#include "common/job/query.hpp"
#include "common/job/result.hpp"
#include "common/job/scenario.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/obb_tree.hpp"
#include "common/tree/point_in_solid.hpp"
#include "common/tree/subtree_block.hpp"

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace cd {

/// A result with what it cost.
struct ScenarioRun {
    ScenarioResult result;
    QueryStatistics statistics;
    SettleStatistics settling; ///< Of `settle_class`, apart; zero after `run_on_subtrees`.
};

/// One colliding pair of distribution roots with its two subtrees.
struct SubtreePair {
    TreeView a;
    TreeView b;
};

/// The contacts under the given pairs of subtrees (paper, 6.4.2, steps 1 to 3). No pairs: separate.
/// The caller keeps the subtrees alive. The result does not depend on how the trees were cut, nor
/// on the order of the pairs.
///
/// Level any: contact or separate; the search ends at the first contact. Else cross if any pair is
/// proper, touch if there are pairs and none is proper, separate without pairs: what more there is
/// to say, `settle_class` finds in the whole bodies.
[[nodiscard]] ScenarioRun
run_on_subtrees(std::span<const SubtreePair> pairs, const Scenario& scenario, const Query& query);

/// `run_on_subtrees` and `settle_class` (settle.hpp) in one, on whole trees.
[[nodiscard]] ScenarioRun
run_scenario(const ObbTree& a, const ObbTree& b, const Scenario& scenario, const Query& query);

} // namespace cd
