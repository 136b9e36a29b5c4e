// Carries out clients' requests about jobs that wait for the disk.
#pragma once

#include "common/core/result.hpp"
#include "master/submission/job_spool.hpp"
#include "proto/channel/asio.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstdint>
#include <memory>

namespace cd {

class Coordinator;

/// A request returns when the journal has committed what it did. Runs on the coordinator's thread.
class JobRequests {
  public:
    /// The coordinator must outlive this and every pending request.
    explicit JobRequests(Coordinator& coordinator) : coordinator_(coordinator) {}

    /// Opens a job whose submission has been checked. `poses` are complete, or null for a grid.
    /// Errors: Refused; Io.
    [[nodiscard]] asio::awaitable<Result<JobId>> open(Submit submit,
                                                      std::shared_ptr<JobSpool> poses);
    /// Cancels the job. Does nothing if it has ended. Waits at most `limits::cancel_wait_max`,
    /// since the disk may be full: then the status still says Running. Errors: NotFound.
    [[nodiscard]] asio::awaitable<Result<JobStatus>> cancel(JobId job);
    /// Fails the scenario and stops it on all workers; the job continues. Errors: NotFound; Refused
    /// if the scenario has an undisputed result; Io if the poses cannot be read.
    [[nodiscard]] asio::awaitable<Result<JobStatus>> cancel_scenario(JobId job,
                                                                     std::uint64_t scenario);
    /// Scores the workers for a scenario as of now. For an ended job it reports only who answered.
    /// Errors: NotFound; Refused while the job is being prepared; Io if the poses cannot be read.
    [[nodiscard]] asio::awaitable<Result<Explained>> explain(JobId job, std::uint64_t scenario);

  private:
    Coordinator& coordinator_;
};

} // namespace cd
