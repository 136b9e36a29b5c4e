// Parts of the verb `run` that other verbs use.
#pragma once

#include "client/cli/cli.hpp"
#include "client/commands/compare/earlier_run.hpp"
#include "client/folder/folder_run.hpp"
#include "client/job/prepared_job.hpp"
#include "client/remote/connection.hpp"
#include "common/core/result.hpp"

#include <memory>

namespace cd {

/// Performs the verb `run` without signal handling; the caller holds an `InterruptGuard`.
[[nodiscard]] Result<int> run_job(const RunCommand& command);

/// Performs `run --master`: submits, watches, fetches, reports. The caller has printed the job's
/// header and holds an `InterruptGuard`; an interrupt cancels the job. With `earlier`, only the
/// scenarios that the earlier run lacks are submitted.
[[nodiscard]] Result<int> run_on_master(const RunCommand& command,
                                        PreparedJob& job,
                                        std::unique_ptr<Connection> connection,
                                        EarlierRun* earlier);

/// Prints the summary of a run, and returns the exit code.
[[nodiscard]] Result<int>
end_run(const RunCommand& command, const RunReport& report, bool stdout_is_used);

/// Prints a job's header and warnings on stderr; if quiet, only the warnings.
void print_header(const PreparedJob& job, bool quiet);

/// Sets `report.hint` if every scenario is separate, which takes a further read of all poses.
/// Errors: Interrupted.
[[nodiscard]] Status add_hint(const PreparedJob& job, RunReport& report);

/// Returns the folder options of a local run.
[[nodiscard]] FolderRunOptions folder_options(const FolderFlags& flags);
/// Returns the folder options for the results of a job on a master.
[[nodiscard]] FolderRunOptions folder_options(const FolderFlags& flags,
                                              const MasterOptions& master);

/// Reports that the folder already holds the run, adds missing formats, and writes `command.output`
/// to stdout. Returns the exit code.
[[nodiscard]] Result<int>
tell_complete(const RunCommand& command, const PreparedJob& job, FolderRun& run);

} // namespace cd
