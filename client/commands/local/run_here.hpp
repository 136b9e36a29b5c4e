// Runs a prepared job in this process, and reports.
#pragma once

#include "client/cli/cli.hpp"
#include "client/commands/compare/earlier_run.hpp"
#include "client/job/prepared_job.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/result.hpp"

namespace cd {

/// A prepared job and what is needed to run it in this process.
struct LocalJob {
    const RunCommand& command;
    PreparedJob& job;
    ThreadPool& pool;
    EarlierRun* earlier = nullptr; ///< The run whose results are reused, if any.
    double prepare_seconds = 0;
};

/// Runs the job into its output folder, or without one if the job has none, and prints the summary.
/// Returns the exit code. Needs an `InterruptGuard`. Errors: as `run_locally` and `FolderRun`;
/// Interrupted, with the number of results that the folder keeps.
[[nodiscard]] Result<int> run_here(const LocalJob& local);

} // namespace cd
