// Determines the parts of a scenario's class that depend on whole bodies.
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

/// Options of `Settler::settle` that save work or end it early.
struct SettleOptions {
    /// All pairs of the scenario, sorted, if the result does not list all pairs; empty if unknown.
    std::span<const ContactPair> touches = {};
    StopCheck stop = {}; ///< True ends `settle` early; the class is then meaningless.
    /// The scenario's `relative_pose`; null if `settle` has to compute it.
    const RelativePose* b_to_a = nullptr;
};

/// Refines the class of results of `run_on_subtrees` with the whole bodies (docs/formats.md).
/// Results of Question::Shots stay as they are.
/// The pairs of a result name triangles of these bodies. One settler serves all scenarios of a job.
///
/// If a body is open, only `surfaces_only` is set. For two closed bodies the class becomes:
///
/// - `inside` instead of `separate` or `near` if some component of one body lies in the other. With
/// ignored pairs, a triangle lies inside if it lies in the solid bounded by those triangles of the
/// other body that are not ignored with it. (So a wheel may penetrate the ground that it is ignored
/// with, and the car may not.) These bounding triangles have to be whole components; otherwise the
/// triangle stays undecided, and `insides_skipped` reports that (see `inside_probes`);
/// - `cross` instead of `touch` if the bodies penetrate without a proper pair (see `penetrates`,
/// which documents the effect of ignored pairs).
///
/// Neither class depends on which body is A, on the level or on `limit_pairs`: if neither the
/// result nor the options list all pairs of the scenario, `settle` searches the whole trees again,
/// with the memory that `level pairs` takes. Other classes stay: nothing overrules a proper pair,
/// and contact at `level any` and undecided are complete answers.
class Settler {
  public:
    /// The trees outlive the settler.
    Settler(const ObbTree& a, const ObbTree& b, std::vector<IgnoredRange> ignored);

    /// Settles a result and returns the cost. The code that merges results calls this once per
    /// result; any number of threads may call it at once. If a few box tests decide, no time is
    /// measured, because reading the clock would take as long.
    InsideStatistics settle(const Scenario& scenario,
                            ScenarioResult& result,
                            const SettleOptions& options = {}) const;

    /// Returns true if `settle` may do more than set flags, so that a thread for the call pays.
    [[nodiscard]] bool is_work(const ScenarioResult& result) const;

  private:
    struct Probes {
        InsideProbes of_a;
        InsideProbes of_b;
    };
    [[nodiscard]] const Probes& probes() const;
    /// Returns false only if neither body can lie in the other: their boxes are apart, or no probe
    /// of either body is in the box of the other body.
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
    mutable Probes probes_; ///< Made on first use.
};

} // namespace cd
