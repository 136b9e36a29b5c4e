// Turns scenarios of one pair of bodies of a scene into a job of two bodies.
#pragma once

#include "client/folder/extracted_case.hpp"
#include "client/job/prepared_job.hpp"
#include "common/core/result.hpp"

namespace cd {

/// A job of two bodies, and scenarios of it.
struct ExtractedPair {
    PreparedJob job; ///< Without poses.
    CaseScenarios scenarios;
};

/// Makes a job of the two bodies of the scenarios, which are of a scene. Indices stay; steps are
/// dropped. `job` has meshes. Errors: BadInput if the scenarios are of several pairs of bodies, or
/// if rules ignore some of the triangles of the pair, since a job of two bodies names them
/// otherwise.
[[nodiscard]] Result<ExtractedPair> pair_of_scene(const PreparedJob& job, CaseScenarios scenarios);

} // namespace cd
