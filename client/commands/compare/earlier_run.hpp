// The earlier run that `run --reuse` names.
#pragma once

#include "client/cli/cli.hpp"
#include "client/commands/run_at_hand.hpp"
#include "client/compare/reused_results.hpp"
#include "client/folder/run_manifest.hpp"
#include "client/job/prepared_job.hpp"
#include "common/core/result.hpp"

#include <string>
#include <utility>

namespace cd {

/// An earlier run of a job, whose results the job may reuse.
class EarlierRun {
  public:
    /// Opens a results folder or fetches a job, as `open_run_at_hand` does, without reading its
    /// meshes. Errors: as `open_run_at_hand`; BadInput if no result can be reused
    /// (`check_reusable`), and for a job without a master's address.
    [[nodiscard]] static Result<EarlierRun> open(const std::string& argument,
                                                 const MasterOptions& master,
                                                 const std::string& tree_cache,
                                                 const PreparedJob& job,
                                                 ThreadPool& pool);

    /// Returns how the job's run.json names the run.
    [[nodiscard]] const ManifestReuse& named() const { return named_; }
    /// Finds the results for the job's scenarios. Unless `quiet`, a line on stderr tells their
    /// number. This object must outlive them. Errors: as `ReusedResults::find`.
    [[nodiscard]] Result<ReusedResults> results_for(const PreparedJob& job, bool quiet);

  private:
    EarlierRun(RunAtHand opened, ManifestReuse named)
        : opened_(std::move(opened)), named_(std::move(named)) {}

    RunAtHand opened_;
    ManifestReuse named_;
};

} // namespace cd
