// The class of a scenario, as far as only the whole bodies can tell it.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/geometry/pose.hpp"
#include "common/job/result/result.hpp"
#include "common/job/scenario.hpp"
#include "common/job/statistics.hpp"
#include "common/search/contact_pair.hpp"
#include "common/solid/inside_probes.hpp"
#include "common/tree/obb_tree.hpp"

#include <mutex>
#include <span>
#include <vector>

namespace cd {

/// What spares work, or ends it early.
struct SettleOptions {
    /// All pairs of a result that does not hold them, sorted; or none.
    std::span<const ContactPair> touches = {};
    StopCheck stop = {}; ///< Once it says so, the class is of no use.
    /// The scenario's `relative_pose` if it is at hand, else null.
    const RelativePose* b_to_a = nullptr;
};

/// What only the whole bodies can tell (NUMERICS, section 1), for results of `run_on_subtrees`
/// whose pairs are triangles of these bodies. One for all scenarios of a job.
///
/// Of an open body only `surfaces_only` is said. Of two closed ones:
///
/// - `inside` where nothing touches and some component of one lies in the other. With ignored pairs
///   a triangle lies inside what the triangles of the other body that are not ignored with it
///   bound. (So a wheel may stick in the ground that it is ignored with, and the car may not.) They
///   have to be whole components; of the other triangles nothing is said, and `insides_skipped`
///   says that there are such. `inside_probes` has the rule.
/// - `cross` instead of `touch` where they penetrate without a proper pair (`penetrates`, which
///   says what ignored pairs mean for it).
///
/// Neither depends on which body is A, on the level, nor on `limit_pairs`: where the result does
/// not hold all its pairs, and they are not given, they are searched again, in the whole trees,
/// with the memory that level pairs takes. Other classes stay: no pair can overrule a proper one,
/// contact at level any says all that was asked, and undecided is an answer.
class Settler {
  public:
    /// The trees outlive it.
    Settler(const ObbTree& a, const ObbTree& b, std::vector<IgnoredRange> ignored);

    /// Called once by whoever merges; returns what it took. For any number of threads at once.
    /// Where a few tests of boxes decide, no time is told: reading the clock would take as long.
    InsideStatistics settle(const Scenario& scenario,
                            ScenarioResult& result,
                            const SettleOptions& options = {}) const;

    /// True when `settle` may have more to do than set flags: it then deserves a thread.
    [[nodiscard]] bool is_work(const ScenarioResult& result) const;

  private:
    struct Probes {
        InsideProbes of_a;
        InsideProbes of_b;
    };
    [[nodiscard]] const Probes& probes() const;
    /// False only if neither body can lie in the other: their boxes are apart, or no probe of one
    /// is in the box of the other.
    [[nodiscard]] bool may_be_inside(const PosePair& poses, const RelativePose* b_to_a) const;
    [[nodiscard]] SettleStatistics settle_closed(const Scenario& scenario,
                                                 ScenarioResult& result,
                                                 const SettleOptions& options) const;
    [[nodiscard]] bool is_inside(const PosePair& poses, SettleStatistics& statistics) const;
    [[nodiscard]] bool is_cross(const PosePair& poses,
                                const ScenarioResult& result,
                                const SettleOptions& options,
                                SettleStatistics& statistics) const;

    const ObbTree& a_;
    const ObbTree& b_;
    std::vector<IgnoredRange> ignored_;
    bool are_closed_;
    mutable std::once_flag once_;
    mutable Probes probes_; ///< Made when first needed.
};

} // namespace cd
