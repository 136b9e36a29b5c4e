// Serves one client's connection.
#pragma once

#include "common/core/limits/master.hpp"
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

/// A client's name and the quotas that count it.
struct ClientQuota {
    Quotas* quotas; ///< Must outlive the session.
    std::string client;
    std::function<void()> jobs_changed; ///< Called after a job was added.
    /// Longest time between two messages of a mesh or of poses.
    std::chrono::milliseconds submission_idle_max = limits::submission_idle_max;
};

/// Answers a client's requests in order; watches run beside them. An unfinished mesh or job
/// submission is dropped when the connection ends.
class ClientSession : public std::enable_shared_from_this<ClientSession> {
  public:
    /// A request beyond `access` is answered with the reason and ends the connection. A request
    /// beyond `quota` only fails.
    ClientSession(Coordinator& coordinator,
                  std::shared_ptr<Channel> channel,
                  Access access,
                  ClientQuota quota);

    /// Serves the client after the welcome. Returns when the connection ends.
    [[nodiscard]] asio::awaitable<void> run();

  private:
    [[nodiscard]] asio::awaitable<void> converse();
    /// Errors: those of the channel; Timeout, sent to the client, when a mesh or poses stall.
    [[nodiscard]] asio::awaitable<Result<Message>> receive();
    [[nodiscard]] bool is_submitting() const { return upload_ != nullptr || spool_ != nullptr; }

    // Handlers, one per client message; any other message ends the connection.
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
    asio::awaitable<void> on(Explain message);
    asio::awaitable<void> on(TokenCreate message);
    asio::awaitable<void> on(Heartbeat message);
    template <class Other>
    asio::awaitable<void> on(Other message);

    [[nodiscard]] asio::awaitable<Status> take_mesh_part(MeshPart message);
    [[nodiscard]] asio::awaitable<Status> begin_poses(Submit message);
    /// `poses` is null for a grid.
    [[nodiscard]] asio::awaitable<void> open_job(Submit submit, std::shared_ptr<JobSpool> poses);
    /// Static with a shared pointer: the session may end before the spawned watch starts.
    [[nodiscard]] static asio::awaitable<void> watch(std::shared_ptr<ClientSession> self,
                                                     JobId job);

    [[nodiscard]] Status take_bytes(std::uint64_t bytes);
    /// Counts bytes of poses or of a grid against the client's quota of queued bytes.
    [[nodiscard]] Status queue_bytes(std::uint64_t bytes);
    [[nodiscard]] Status begin_upload(MeshPart& part);
    void drop_upload();
    void drop_poses();
    void refuse(const Error& error);
    void refuse_poses(const Error& error);
    template <class Answer>
    void answer(const Result<Answer>& found);
    /// Checks that the client may end or remove the job. Errors: NotFound; Refused.
    [[nodiscard]] Status check_owner(JobId job);

    Coordinator& coordinator_;
    std::shared_ptr<Channel> channel_;
    Access access_;
    ClientQuota quota_;
    std::unique_ptr<MeshUpload> upload_;
    /// The submitted job whose poses are arriving.
    Submit submit_;
    /// Keep the meshes of the last MeshesQuery and of the submission from being removed.
    std::shared_ptr<const MeshHold> meshes_asked_for_;
    std::shared_ptr<const MeshHold> meshes_submitted_;
    std::shared_ptr<JobSpool> spool_;
    std::uint64_t queued_ = 0; ///< Bytes of the submission counted in the quota.
    std::chrono::steady_clock::time_point progressed_; ///< Last progress of the mesh or the poses.
    /// The submission was refused and the client informed: the rest of its poses is ignored.
    bool refused_ = false;
    std::size_t watches_ = 0;
    JobQueries queries_;
};

} // namespace cd
