// Writes a few scenarios of a run as a separate job, to share or to examine.
#pragma once

#include "client/job/prepared_job.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/result.hpp"
#include "common/job/scenario.hpp"

#include <filesystem>
#include <vector>

namespace cd {

/// Scenarios of a run, with the results that the run found for them.
struct CaseScenarios {
    std::vector<Scenario> scenarios;
    std::vector<ScenarioResult> results; ///< One result for each scenario.
};

struct CaseOptions {
    bool minimal = false; ///< Keep only triangles that can be in contact.
    StopCheck stop;       ///< Once it returns true, `write_case` fails with Interrupted.
};

/// Writes NAME.npz of each body (`body_file_names`), poses.csv, job.toml and expected.json into a
/// folder, which is created if missing. `cdctl run` of this job.toml gives the digest in
/// expected.json and the given results, with scenarios numbered from 0. An earlier case in the
/// folder is replaced.
///
/// `minimal` keeps only the triangles whose boxes overlap the other body's box at one of the poses.
/// It runs the scenarios here for the expected results, and writes ids.csv, which maps triangles to
/// their numbers in the run.
///
/// The job has no motions (`rest_at_answers`).
///
/// Errors: Io; Interrupted; BadInput for a job that such files cannot express (ignored triangles
/// that no rule names, poses in several forms), for a failed scenario, and for a folder with the
/// job.toml of another job; with `minimal` also if a body keeps no triangle, and if a result
/// differs from the run's.
[[nodiscard]] Status write_case(const PreparedJob& job,
                                const CaseScenarios& scenarios,
                                const CaseOptions& options,
                                const std::filesystem::path& dir,
                                ThreadPool& pool);

} // namespace cd
