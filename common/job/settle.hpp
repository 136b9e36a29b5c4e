// Determines the parts of a scenario's class that depend on whole bodies.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/geometry/pose.hpp"
#include "common/job/result/result.hpp"
#include "common/job/scenario.hpp"
#include "common/job/statistics.hpp"
#include "common/job/trees_by_body.hpp"
#include "common/search/contact_pair.hpp"
#include "common/solid/inside_probes.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace cd {

/// Options of `Settler::settle` that save work or end it early.
struct SettleOptions {
    /// All pairs of the scenario, sorted, if the result does not list all pairs; empty if unknown.
    std::span<const ContactPair> touches = {};
    StopCheck stop = {}; ///< True ends `settle` early; the class is then meaningless.
    /// The `relative_pose` of the answer's poses; null if `settle` has to compute it.
    const RelativePose* b_to_a = nullptr;
};

/// Refines the class of results of `run_on_subtrees` with the whole bodies (docs/formats.md).
/// Results of Question::Shots stay as they are. Those of motions are settled under the poses of
/// their answer (`poses_of_answer`). The pairs of a result name triangles of the
/// scenario's two bodies. One settler serves all scenarios of a job.
///
/// If one of the two bodies is open, only `surfaces_only` is set. For two closed bodies the class
/// becomes:
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
    /// The trees outlive the settler. The ignored ranges are in order (`are_in_order`).
    Settler(TreesByBody trees, std::vector<IgnoredRange> ignored);
    /// Settles scenarios of the bodies 0 and 1.
    Settler(const ObbTree& a, const ObbTree& b, std::vector<IgnoredRange> ignored)
        : Settler(TreesByBody(a, b), std::move(ignored)) {}

    /// Settles a result and returns the cost. The code that merges results calls this once per
    /// result; any number of threads may call it at once. If a few box tests decide, no time is
    /// measured, because reading the clock would take as long.
    InsideStatistics settle(const Scenario& scenario,
                            ScenarioResult& result,
                            const SettleOptions& options = {}) const;

    /// Returns true if `settle` may do more than set flags, so that a thread for the call pays.
    [[nodiscard]] bool is_work(const ScenarioResult& result) const;
    /// Does what `settle` does for a result without work (`is_work`), which needs no poses.
    void set_flags(ScenarioResult& result) const;

  private:
    /// Probes that are made on first use.
    struct LazyProbes {
        std::once_flag once;
        InsideProbes probes;
    };
    [[nodiscard]] bool are_closed(std::uint32_t body_a, std::uint32_t body_b) const;
    /// Returns the triangles of two bodies that are ignored with each other.
    [[nodiscard]] std::span<const IgnoredRange> ignored_in(const Scenario& scenario) const {
        return ignored_of(ignored_, scenario.body_a, scenario.body_b);
    }
    /// Returns false if some triangle of a body stays undecided, because those that bound the other
    /// body without the ignored ones are not whole components.
    [[nodiscard]] bool decides_insides(std::uint32_t body_a, std::uint32_t body_b) const;
    /// Returns the probes of a body in another body.
    [[nodiscard]] const InsideProbes& probes(std::uint32_t inner, std::uint32_t outer) const;
    [[nodiscard]] const InsideProbes& probes_of_a(const Scenario& scenario) const {
        return probes(scenario.body_a, scenario.body_b);
    }
    [[nodiscard]] const InsideProbes& probes_of_b(const Scenario& scenario) const {
        return probes(scenario.body_b, scenario.body_a);
    }
    /// Returns false only if neither body can lie in the other: their boxes are apart, or no probe
    /// of either body is in the box of the other body.
    [[nodiscard]] bool may_be_inside(const Scenario& scenario, const RelativePose* b_to_a) const;
    /// Settles with the scenario's poses those of the answer.
    [[nodiscard]] InsideStatistics
    settle_at(const Scenario& scenario, ScenarioResult& result, const SettleOptions& options) const;
    [[nodiscard]] SettleStatistics settle_closed(const Scenario& scenario,
                                                 ScenarioResult& result,
                                                 const SettleOptions& options) const;
    [[nodiscard]] bool is_inside(const Scenario& scenario, SettleStatistics& statistics) const;
    [[nodiscard]] bool is_cross(const Scenario& scenario,
                                const ScenarioResult& result,
                                const SettleOptions& options,
                                SettleStatistics& statistics) const;

    TreesByBody trees_;
    std::vector<IgnoredRange> ignored_;
    /// The probes of each tree in any body with which it ignores no triangles.
    mutable std::map<const ObbTree*, LazyProbes> of_trees_;
    /// The probes of a body in another one, for bodies that ignore triangles with each other.
    mutable std::map<std::pair<std::uint32_t, std::uint32_t>, LazyProbes> of_pairs_;
};

} // namespace cd
