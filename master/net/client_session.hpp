// One client's conversation with the master.
#pragma once

#include "common/core/limits/master.hpp"
#include "master/coordinator/coordinator.hpp"
#include "master/geometry/mesh_upload.hpp"
#include "master/identity/access.hpp"
#include "master/jobs/job_queries.hpp"
#include "master/jobs/job_spool.hpp"
#include "master/net/quotas.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace cd {

/// One client's part of the quotas.
struct ClientQuota {
    Quotas* quotas; ///< Outlives the session.
    std::string client;
    std::function<void()> jobs_changed; ///< Called when one was added.
    /// Between two messages, while a mesh or poses are coming.
    std::chrono::milliseconds submission_idle_max = limits::submission_idle_max;
};

/// Answers a client's requests, one after the other; watches go on beside them. What a client did
/// not finish (a mesh, a job's poses) goes with its connection.
class ClientSession : public std::enable_shared_from_this<ClientSession> {
  public:
    /// Who asks for more than `access` allows is told so, and the connection ends; for more than
    /// `quota` allows, and the request fails.
    ClientSession(Coordinator& coordinator,
                  std::shared_ptr<Channel> channel,
                  Access access,
                  ClientQuota quota);

    /// The whole conversation after the welcome. Ends when the connection does.
    [[nodiscard]] asio::awaitable<void> run();

  private:
    [[nodiscard]] asio::awaitable<void> converse();
    /// Errors: those of the channel; Timeout, told, when a mesh or poses do not go on.
    [[nodiscard]] asio::awaitable<Result<Message>> receive();
    [[nodiscard]] bool is_submitting() const { return upload_ != nullptr || spool_ != nullptr; }

    // One for each message that a client sends; all others end the connection.
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
    /// No poses with a grid.
    [[nodiscard]] asio::awaitable<void> open_job(Submit submit, std::shared_ptr<JobSpool> poses);
    /// It begins some time after it was spawned, and the session may have ended by then.
    [[nodiscard]] static asio::awaitable<void> watch(std::shared_ptr<ClientSession> self,
                                                     JobId job);

    [[nodiscard]] Status take_bytes(std::uint64_t bytes);
    /// The same, of poses or a grid.
    [[nodiscard]] Status queue_bytes(std::uint64_t bytes);
    [[nodiscard]] Status begin_upload(MeshPart& part);
    void drop_upload();
    void drop_poses();
    void refuse(const Error& error);
    void refuse_poses(const Error& error);
    template <class Answer>
    void answer(const Result<Answer>& found);
    /// Whether the client may end or remove the job. Errors: NotFound; Refused.
    [[nodiscard]] Status check_owner(JobId job);

    Coordinator& coordinator_;
    std::shared_ptr<Channel> channel_;
    Access access_;
    ClientQuota quota_;
    std::unique_ptr<MeshUpload> upload_;
    /// A submitted job whose poses are coming.
    Submit submit_;
    /// Keep the meshes of the last MeshesQuery and of the submission from being removed.
    std::shared_ptr<const MeshHold> meshes_asked_for_;
    std::shared_ptr<const MeshHold> meshes_submitted_;
    std::shared_ptr<JobSpool> spool_;
    std::uint64_t queued_ = 0;                         ///< Bytes of it, in the quota.
    std::chrono::steady_clock::time_point progressed_; ///< The mesh or the poses.
    /// The submission was refused and the client knows it: the rest of its poses is ignored.
    bool refused_ = false;
    std::size_t watches_ = 0;
    JobQueries queries_;
};

} // namespace cd
