// The master's own runs of single scenarios, on whole bodies instead of blocks.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "common/job/result/contact_map.hpp"
#include "master/base/background.hpp"
#include "master/compute/result_check.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace cd {

struct ReferenceResult {
    TakenResults taken; ///< One result; a failure that says "cancelled" if the run was stopped.
    bool is_stopped = false; ///< The run was stopped, so the right result is unknown.
};

/// Runs a scenario on whole bodies, which may take long. Errors: those of the poses.
[[nodiscard]] Result<ReferenceResult> reference_result(const JobMaterial& material,
                                                       OrderedPoses& poses,
                                                       std::uint64_t scenario,
                                                       const StopCheck& stop);

/// Makes the contact map of some scenarios, which may take long. Errors: those of the poses.
[[nodiscard]] Result<ContactMap> reference_map(const JobMaterial& material,
                                               OrderedPoses& poses,
                                               std::span<const std::uint64_t> scenarios);

/// Reference runs in the background that can be stopped by job and scenario.
class ReferenceRuns {
  public:
    using Done = std::function<void(Result<ReferenceResult>)>;

    explicit ReferenceRuns(Background& background) : background_(background) {}

    /// Starts a run; calls `done` at its end unless `close` was called. Does nothing after `close`.
    void start(JobId job,
               std::uint64_t scenario,
               std::shared_ptr<const JobMaterial> material,
               std::shared_ptr<OrderedPoses> poses,
               Done done);
    /// Asks the runs of a job, or of one of its scenarios, to stop; `done` is called nevertheless.
    /// False if there is no such run.
    bool stop(JobId job, std::optional<std::uint64_t> scenario);
    /// Stops all runs. None calls `done` afterwards.
    void close();

  private:
    struct Run {
        std::atomic<bool> is_stopped = false;
        std::atomic<bool> is_closed = false;
    };

    Background& background_;
    std::multimap<std::pair<JobId, std::uint64_t>, std::shared_ptr<Run>> runs_;
    bool is_closed_ = false;
};

} // namespace cd
