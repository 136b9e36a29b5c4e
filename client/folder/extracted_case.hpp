// A few scenarios of a run as a job of their own, to hand on or to look into.
#pragma once

#include "client/prepared_job.hpp"
#include "common/core/result.hpp"
#include "common/core/stop_check.hpp"
#include "common/core/thread_pool.hpp"
#include "common/job/scenario.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace cd {

/// Scenarios with the answers that a run gave them.
struct CaseScenarios {
    std::vector<Scenario> scenarios;
    std::vector<ScenarioResult> results; ///< As many.
};

struct CaseOptions {
    bool minimal = false; ///< Only the triangles that may matter.
    StopCheck stop;       ///< Ends it with Interrupted.
};

/// Writes a.npz, b.npz, poses.csv, job.toml and expected.json into a folder, which is made if
/// missing. `cdctl run` of job.toml gives the digest in expected.json, and the given results but
/// for their indices, which count from 0 there.
///
/// `minimal` keeps the triangles whose boxes meet the other body's box at one of the poses, and
/// writes ids.csv, which leads back to their numbers; the scenarios are run here to know what is
/// expected. An earlier case in the folder is replaced. Errors: Io; BadInput for what such files
/// cannot say (ignored triangles, poses of several forms), for a scenario that failed, for a folder
/// with a job.toml of another kind, and for `minimal` under a tolerance, without any such triangle,
/// or where these give another answer than the run's; Interrupted.
[[nodiscard]] Status write_case(const PreparedJob& job,
                                const CaseScenarios& scenarios,
                                const CaseOptions& options,
                                const std::filesystem::path& dir,
                                ThreadPool& pool);

} // namespace cd
