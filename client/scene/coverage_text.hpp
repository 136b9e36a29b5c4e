// What became of the pairs of bodies of a scene, for people and for programs.
#pragma once

#include "client/scene/scene_bodies.hpp"
#include "common/scene/step_index.hpp"

#include <cstdint>
#include <span>
#include <string>

namespace cd {

/// Returns "4 812 of 124 750 pairs tested, 119 938 apart by their boxes", and what else there is:
/// pairs that are ignored, of fixed bodies, or of an absent body.
[[nodiscard]] std::string coverage_line(const StepCoverage& coverage);

/// Returns the coverage of all steps together, of the step with the most pairs, and of the bodies
/// that are absent at some step, in lines with newlines that begin with `indent`. `absences` has
/// for each body at how many steps it is absent. Of many absent bodies, the first are named.
[[nodiscard]] std::string coverage_text(const StepIndex& steps,
                                        std::span<const std::uint64_t> absences,
                                        const SceneBodies& scene,
                                        const std::string& indent);

/// The columns of CSV tables about steps: the numbers of pairs of bodies by `StepCoverage`.
inline constexpr const char* coverage_columns = "step,time,tested,apart,ignored,fixed,absent";
/// Returns the fields of `coverage_columns` of a step.
[[nodiscard]] std::string coverage_row(const StepIndex& steps, std::uint64_t step);
/// Returns a CSV table with `coverage_columns` and a row for each step.
[[nodiscard]] std::string coverage_csv(const StepIndex& steps);

} // namespace cd
