// Removes jobs and meshes at a client's request, with all files that nothing else needs.
#pragma once

#include "common/core/result.hpp"
#include "proto/channel/asio.hpp"
#include "proto/messages/client_messages.hpp"

namespace cd {

class Coordinator;

/// The journal forgets a job before its files are deleted. A crash thus leaves at most files
/// without a job, which the next start removes. Runs on the coordinator's thread.
class JobRemoval {
  public:
    /// The coordinator must outlive this object and every pending removal.
    explicit JobRemoval(Coordinator& coordinator) : coordinator_(coordinator) {}

    /// Removes the job with its results and poses, and the meshes that no other job uses, with
    /// their trees and blocks. Errors: NotFound; Refused for a running job, unless `wish.cancel`;
    /// Io.
    [[nodiscard]] asio::awaitable<Result<Removed>> remove(Remove wish);
    /// Removes the mesh with its tree and blocks. Errors: NotFound; Refused while a job or a
    /// submission uses it; Io.
    [[nodiscard]] asio::awaitable<Result<Removed>> remove(RemoveMesh wish);

  private:
    /// Cancels a running job if `wish.cancel`, and waits for the end. Returns the status of the
    /// ended job. Errors: NotFound; Refused if it runs and may not be cancelled; Io.
    [[nodiscard]] asio::awaitable<Result<JobStatus>> ended(Remove wish);

    Coordinator& coordinator_;
};

} // namespace cd
