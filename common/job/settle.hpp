// The class of a scenario, as far as only the whole bodies can tell it.
#pragma once

#include "common/core/stop_check.hpp"
#include "common/job/query.hpp"
#include "common/job/result.hpp"
#include "common/job/scenario.hpp"
#include "common/job/statistics.hpp"
#include "common/tree/contact_pair.hpp"
#include "common/tree/obb_tree.hpp"

#include <span>

namespace cd {

/// What spares work, or ends it early.
struct SettleOptions {
    /// All pairs of a result that does not hold them, sorted; or none.
    std::span<const ContactPair> touches = {};
    StopCheck stop = {}; ///< Once it says so, the class is of no use.
};

/// What only the whole bodies can tell (NUMERICS, section 1), for a result of `run_on_subtrees`
/// whose pairs are triangles of these bodies. Called once by whoever merges; returns what it took.
///
/// Of an open body only `surfaces_only` is said. Of two closed ones, from level count on:
///
/// - `inside` where nothing touches and some component of one lies in the other. Not with ignored
///   pairs: parts that may stick in each other say nothing about the rest.
/// - `cross` instead of `touch` where they penetrate without a proper pair (`penetrates`, which
///   says what ignored pairs mean for it).
///
/// Neither depends on which body is A, on the level, nor on `limit_pairs`: where the result does
/// not hold all its pairs, and they are not given, they are searched again, in the whole trees,
/// with the memory that level pairs takes. Other classes stay: no pair can overrule a proper one,
/// and undecided is an answer.
SettleStatistics settle_class(const ObbTree& a,
                              const ObbTree& b,
                              const Scenario& scenario,
                              const Query& query,
                              ScenarioResult& result,
                              const SettleOptions& options = {});

/// True when `settle_class` may have more to do than set a flag: it then deserves a thread. (It is
/// cheap while the bodies' boxes are apart.)
[[nodiscard]] bool
settling_is_work(const ObbTree& a, const ObbTree& b, const ScenarioResult& result);

/// `settle_class`, and its cost.
[[nodiscard]] InsideStatistics settle_with_cost(const ObbTree& a,
                                                const ObbTree& b,
                                                const Scenario& scenario,
                                                const Query& query,
                                                ScenarioResult& result,
                                                const SettleOptions& options = {});

} // namespace cd
