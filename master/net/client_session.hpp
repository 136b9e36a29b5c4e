// Serves one client's connection.
#pragma once

#include "common/core/timing/master.hpp"
#include "master/coordinator/coordinator.hpp"
#include "master/geometry/mesh_upload.hpp"
#include "master/identity/access.hpp"
#include "master/jobs/job_queries.hpp"
#include "master/net/quotas.hpp"
#include "master/submission/job_spool.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace cd {

/// A client's name, and the quotas that limit it.
struct ClientQuota {
    Quotas* quotas; ///< Must outlive the session.
    std::string client;
    std::function<void()> jobs_changed; ///< Called after a job was added to the quotas.
    /// Longest time between two messages of an upload of a mesh or of poses.
    std::chrono::milliseconds submission_idle_max = timing::submission_idle_max;
};

/// Answers a client's requests in order; watches run concurrently. Drops an unfinished mesh or job
/// submission when the connection ends.
class ClientSession : public std::enable_shared_from_this<ClientSession> {
  public:
    /// A request that `access` does not allow is answered with the reason and ends the connection.
    /// A request that exceeds `quota` only fails.
    ClientSession(Coordinator& coordinator,
                  std::shared_ptr<Channel> channel,
                  Access access,
                  ClientQuota quota);

    /// Serves the client, which has got its Welcome. Returns when the connection ends.
    [[nodiscard]] asio::awaitable<void> run();

  private:
    [[nodiscard]] asio::awaitable<void> converse();
    /// Receives the next message. Errors: as `Channel::receive`. If an upload stalls, also sends
    /// the client a Timeout failure.
    [[nodiscard]] asio::awaitable<Result<Message>> receive();

    // Handlers, one per message of a client. Any other message ends the connection.
    asio::awaitable<void> on(MeshesQuery message);
    asio::awaitable<void> on(MeshPart message);
    asio::awaitable<void> on(Submit message);
    asio::awaitable<void> on(PosesPart message);
    asio::awaitable<void> on(PosesEnd message);
    asio::awaitable<void> on(Watch message);
    asio::awaitable<void> on(StatusQuery message);
    asio::awaitable<void> on(ResultsQuery message);
    asio::awaitable<void> on(ContactMapQuery message);
    asio::awaitable<void> on(JobQuery message);
    asio::awaitable<void> on(MeshQuery message);
    asio::awaitable<void> on(PosesQuery message);
    asio::awaitable<void> on(Remove message);
    asio::awaitable<void> on(RemoveMesh message);
    asio::awaitable<void> on(DrainWorkers message);
    asio::awaitable<void> on(Cancel message);
    asio::awaitable<void> on(SetPriority message);
    asio::awaitable<void> on(Explain message);
    asio::awaitable<void> on(TokenCreate message);
    asio::awaitable<void> on(Heartbeat message);
    template <class Other>
    asio::awaitable<void> on(Other message);

    [[nodiscard]] asio::awaitable<Status> take_mesh_part(MeshPart message);
    [[nodiscard]] asio::awaitable<Status> begin_poses(Submit message);
    /// Opens a job with a checked submission, and answers the client. `poses` is null for a grid.
    [[nodiscard]] asio::awaitable<void> open_job(Submit submit, std::shared_ptr<JobSpool> poses);
    /// Sends the job's status at each change. Static with a shared pointer, because the session may
    /// end before the spawned watch starts.
    [[nodiscard]] static asio::awaitable<void> watch(std::shared_ptr<ClientSession> self,
                                                     JobId job);

    /// Counts received bytes against the client's rate limit.
    [[nodiscard]] Status take_bytes(std::uint64_t bytes);
    /// Counts bytes of poses or of a grid against the quota of queued bytes and the rate limit.
    [[nodiscard]] Status queue_bytes(std::uint64_t bytes);
    [[nodiscard]] Status begin_upload(MeshPart& part);
    void drop_upload();
    void drop_poses();
    void refuse(const Error& error);
    void refuse_poses(const Error& error);
    template <class Answer>
    void answer(const Result<Answer>& found);
    /// Checks that the client may change, end or remove the job. Errors: NotFound; Refused.
    [[nodiscard]] Status check_owner(JobId job);

    Coordinator& coordinator_;
    std::shared_ptr<Channel> channel_;
    Access access_;
    ClientQuota quota_;
    std::unique_ptr<MeshUpload> upload_;
    /// The submitted job while its poses arrive.
    Submit submit_;
    /// Prevents the removal of the meshes that the last MeshesQuery asked for.
    std::shared_ptr<const MeshHold> meshes_asked_for_;
    /// Prevents the removal of the meshes of the submission.
    std::shared_ptr<const MeshHold> meshes_submitted_;
    std::shared_ptr<JobSpool> spool_; ///< Null if no poses are arriving.
    std::uint64_t queued_ = 0;        ///< Bytes of the submission that the quota counts.
    std::chrono::steady_clock::time_point progressed_; ///< Last progress of the mesh or the poses.
    /// True after a submission was refused: the rest of its poses is ignored.
    bool refused_ = false;
    std::size_t watches_ = 0;
    JobQueries queries_;
};

} // namespace cd
