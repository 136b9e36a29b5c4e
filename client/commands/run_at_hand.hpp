// The run that an argument names: a results folder or a job on a master.
#pragma once

#include "client/cli/cli.hpp"
#include "client/folder/opened_run.hpp"
#include "client/job/prepared_job.hpp"
#include "common/core/result.hpp"

#include <filesystem>
#include <string>

namespace cd {

/// An opened run and its inputs. For a job on a master, the temporary folder that `open` fetched
/// the run into is already removed.
struct RunAtHand {
    OpenedRun run;
    JobInputs inputs;

    /// Opens a folder, or fetches a job into a temporary folder, which is removed even after a
    /// signal. Needs an `InterruptGuard`; once open, a signal ends the process. `tree_cache` is as
    /// for `FetchedJob`. Errors: those of `OpenedRun::open`, `read_inputs` and `FetchedJob`.
    [[nodiscard]] static Result<RunAtHand> open(const std::string& argument,
                                                const MasterOptions& master,
                                                const std::filesystem::path& tree_cache);

    /// Prepares the run's job as it was submitted. Moves `inputs` away, so it may be called once.
    /// Errors: those of `OpenedRun::spec` and `prepare_again`.
    [[nodiscard]] Result<PreparedJob> prepare(Trees trees, TreeCache& cache, ThreadPool& pool);
};

} // namespace cd
