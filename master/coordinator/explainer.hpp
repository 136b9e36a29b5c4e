// Explains one scenario: the workers' scores for it while its job runs, and who answered it.
#pragma once

#include "common/core/id.hpp"
#include "common/core/result.hpp"
#include "master/compute/analyser.hpp"
#include "master/dispatch/view/dispatch_view.hpp"
#include "master/jobs/job_table.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace cd {

/// A read-only view of jobs, dispatcher and workers, made for one question.
class Explainer {
  public:
    /// `is_here` returns true for a worker that has neither left nor been lost. Jobs and dispatcher
    /// outlive the explainer.
    Explainer(const JobTable& jobs,
              const DispatchView& dispatcher,
              std::function<bool(WorkerId)> is_here)
        : jobs_(jobs), dispatcher_(dispatcher), is_here_(std::move(is_here)) {}

    /// Returns the data needed to analyse the scenarios of a running job. Errors: NotFound; Refused
    /// unless the job runs and its geometry is loaded.
    [[nodiscard]] Result<AnalysisInput> input(JobId job) const;
    /// Returns the data for the analysis that `explain` needs; empty for an ended job. Errors:
    /// NotFound; Refused while the job is being prepared.
    [[nodiscard]] Result<std::optional<AnalysisInput>> needed(JobId job,
                                                              std::uint64_t scenario) const;
    /// Returns the score that each worker would get for the scenario now. For an ended job, returns
    /// only who answered, and ignores `analysis`. Errors: NotFound; Refused for a running job
    /// without `analysis`.
    [[nodiscard]] Result<Explained>
    explain(JobId job, std::uint64_t scenario, std::optional<Analysis> analysis) const;

  private:
    [[nodiscard]] Explained score(const MasterJob& job, Analysis analysis) const;
    [[nodiscard]] Explained explain_ended(const MasterJob& job, std::uint64_t scenario) const;
    [[nodiscard]] std::string
    answered_by(const MasterJob& job, std::uint64_t scenario, bool needs_worker) const;

    const JobTable& jobs_;
    const DispatchView& dispatcher_;
    std::function<bool(WorkerId)> is_here_;
};

} // namespace cd
