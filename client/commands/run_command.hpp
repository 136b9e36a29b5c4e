// The verb `run`, in parts that other verbs use.
#pragma once

#include "client/cli.hpp"
#include "client/folder/folder_run.hpp"
#include "client/prepared_job.hpp"

#include <string>

namespace cd {

/// The verb `run` without its handling of signals; whoever calls it has an `InterruptGuard`.
[[nodiscard]] int run_job(const RunCommand& command);

/// Header and warnings on stderr; warnings also when quiet.
void print_header(const PreparedJob& job, bool quiet);

/// Fills `report.hint`. Reads the poses again where all scenarios are separate. Errors:
/// Interrupted.
[[nodiscard]] Status add_hint(const PreparedJob& job, RunReport& report);

/// How a run here treats its output folder.
[[nodiscard]] FolderRunOptions folder_options(const FolderFlags& flags);
/// How the results of a master's job are written.
[[nodiscard]] FolderRunOptions folder_options(const FolderFlags& flags,
                                              const MasterOptions& master);

/// Says that the folder of a run holds all of its job, adds the formats that it lacks, and writes
/// `command.output` to stdout. The exit code.
[[nodiscard]] int tell_complete(const RunCommand& command, const PreparedJob& job, FolderRun& run);

} // namespace cd
