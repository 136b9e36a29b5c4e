// Runs one scenario that is a motion: when the bodies are free of each other.
#pragma once

#include "common/core/result.hpp"
#include "common/job/run_scenario.hpp"
#include "common/motion/motion.hpp"
#include "common/motion/tree_questions.hpp"

#include <span>
#include <vector>

namespace cd {

/// Returns the radius of each body, with Question::Motion; else nothing. Bodies of one mesh share
/// the work.
[[nodiscard]] std::vector<double> radii_for(const TreesByBody& trees, const Query& query);

/// Returns the radii of a scenario's bodies from those of all bodies (`radii_for`).
[[nodiscard]] inline BodyRadii radii_of(std::span<const double> radii, const Scenario& scenario) {
    return radii.empty() ? BodyRadii{} : BodyRadii{radii[scenario.body_a], radii[scenario.body_b]};
}

/// Makes the motion of a scenario. Errors: BadInput for a scenario without a second pair of poses;
/// those of `Motion::create`.
[[nodiscard]] Result<Motion>
motion_of(const Scenario& scenario, const Query& query, const BodyRadii& radii);

/// Returns how far apart at its middle (`Motion::at_middle` of the whole) two triangles may be that
/// matter for the answer to a motion, in the job's unit. May be infinite.
[[nodiscard]] double reach_of_motion(const Motion& motion, const Query& query);

/// Searches a motion of whole or cut bodies. Fills the result except for the pairs at the event.
/// Leaves the search at the poses of the answer (`poses_of_answer`) with the query's clearance.
///
/// The options of `search` have a clearance. Returns false if `options.stop` ended the run.
[[nodiscard]] bool find_motion(ContactSearch& search,
                               const MovingTrees& trees,
                               const Motion& motion,
                               const Scenario& scenario,
                               const Query& query,
                               const RunOptions& options,
                               ScenarioRun& run);

/// Fills the result of a motion whose bodies are out of reach of each other, and counts its cells.
void note_free_motion(const Motion& motion, const Query& query, ScenarioRun& run);

} // namespace cd
