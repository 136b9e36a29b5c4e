// Carries out clients' requests that wait for the disk: to open, rank, cancel and explain jobs.
#pragma once

#include "common/core/result.hpp"
#include "common/core/timing/master.hpp"
#include "master/submission/job_spool.hpp"
#include "proto/channel/asio.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstdint>
#include <memory>

namespace cd {

class Coordinator;

/// `open`, `set_priority` and `cancel` return when the journal has committed the change. Runs on
/// the coordinator's thread.
class JobRequests {
  public:
    /// The coordinator must outlive this object and every pending request.
    explicit JobRequests(Coordinator& coordinator) : coordinator_(coordinator) {}

    /// Opens a job whose submission has been checked. `poses` must be complete; null for a grid.
    /// Errors: Refused if too many jobs run; Io.
    [[nodiscard]] asio::awaitable<Result<JobId>> open(Submit submit,
                                                      std::shared_ptr<JobSpool> poses);
    /// Gives a running job another priority. Errors: NotFound; Refused if the job has ended; Io if
    /// the disk does not take it within `timing::cancel_wait_max`.
    [[nodiscard]] asio::awaitable<Result<JobStatus>> set_priority(JobId job, std::int32_t priority);
    /// Cancels the job. Does nothing if it has ended. Waits at most `timing::cancel_wait_max` for
    /// the disk, which may be full; after that, returns a status that still says Running. Errors:
    /// NotFound.
    [[nodiscard]] asio::awaitable<Result<JobStatus>> cancel(JobId job);
    /// Marks the scenario as failed, and stops it on all workers; the job continues. If the master
    /// runs the scenario to decide a dispute, stops only that run. Errors: NotFound; Refused if the
    /// job has ended or the scenario has an undisputed result; Io if the poses cannot be read.
    [[nodiscard]] asio::awaitable<Result<JobStatus>> cancel_scenario(JobId job,
                                                                     std::uint64_t scenario);
    /// Scores the workers for a scenario as of now, and runs the search of a motion or of a
    /// distance, for at most `timing::explained_search_max`, to tell what it takes. For an ended
    /// job, reports only who answered the scenario. Errors: NotFound; Refused while the job is
    /// being prepared; Io if the poses cannot be read.
    [[nodiscard]] asio::awaitable<Result<Explained>> explain(JobId job, std::uint64_t scenario);

  private:
    Coordinator& coordinator_;
};

} // namespace cd
