// The run that an argument names: a results folder, or a job of a master.
#pragma once

#include "client/cli.hpp"
#include "client/folder/opened_run.hpp"
#include "client/prepared_job.hpp"
#include "common/core/result.hpp"

#include <filesystem>
#include <string>

namespace cd {

/// An opened run and its inputs. There is no folder behind a job's.
struct RunAtHand {
    OpenedRun run;
    JobInputs inputs;

    /// Opens a folder, or fetches all that there is of a job by way of a temporary one, which no
    /// signal leaves behind. Needs an `InterruptGuard`, which ends the process from then on.
    /// `tree_cache` as for `FetchedJob`. Errors: those of `OpenedRun::open`, `read_inputs` and
    /// `FetchedJob`.
    [[nodiscard]] static Result<RunAtHand> open(const std::string& argument,
                                                const MasterOptions& master,
                                                const std::filesystem::path& tree_cache);
};

} // namespace cd
