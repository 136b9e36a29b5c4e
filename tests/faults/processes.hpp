// The programs of a simulated cluster: the parts of cdmaster and cdworker, assembled as in their
// main functions, and clients.
#pragma once

#include "master/coordinator/coordinator.hpp"
#include "master/net/server.hpp"
#include "tests/faults/jobs.hpp"
#include "tests/faults/world.hpp"
#include "worker/execution/executor.hpp"
#include "worker/membership/membership.hpp"
#include "worker/peers/peer_server.hpp"

#include <memory>
#include <optional>

namespace cd::tests {

inline constexpr std::uint16_t master_port = 7600;

class MasterProcess {
  public:
    explicit MasterProcess(World& world);

    [[nodiscard]] Host& host() { return host_; }
    /// Null if it could not start.
    [[nodiscard]] Coordinator* coordinator() { return coordinator_.get(); }

  private:
    Host host_;
    AsioLoop loop_{host_.context.get_executor()};
    StoredGeometry geometry_{known_geometry()};
    std::unique_ptr<Pool> compute_;
    std::unique_ptr<Journal> journal_;
    std::unique_ptr<Pool> blocking_;
    std::unique_ptr<Coordinator> coordinator_;
    std::unique_ptr<Server> server_;
};

struct WorkerHabits {
    unsigned threads = 1;
    std::uint64_t cache_bytes = 1 << 20;
    double weight = 1;
    bool serves_peers = true;
    UnkeptBounds unkept = {};
};

class WorkerProcess {
  public:
    WorkerProcess(World& world, std::uint64_t id, const WorkerHabits& habits);

    [[nodiscard]] Host& host() { return host_; }
    /// Acts as on SIGTERM.
    void drain();
    /// True if the worker goes on although the master has acknowledged too few results.
    [[nodiscard]] bool keeps_too_much() const;
    [[nodiscard]] bool has_ended() const { return has_ended_; }
    /// Null before the first session.
    [[nodiscard]] Session* session() { return membership_->session(); }

  private:
    asio::awaitable<void> run();
    asio::awaitable<void> serve(std::shared_ptr<Channel> channel);

    World& world_;
    WorkerHabits habits_;
    Host host_;
    std::unique_ptr<Executor> executor_;
    std::shared_ptr<PeerServer> peer_server_;
    std::unique_ptr<Membership> membership_;
    bool is_draining_ = false;
    bool has_ended_ = false;
};

/// Submits one job and watches it to its end, whatever happens to its connections.
class ClientProcess {
  public:
    ClientProcess(World& world, std::uint64_t id, const KnownJob& job, ClusterOptions options);

    void cancel() { wants_cancel_ = true; }
    [[nodiscard]] const KnownJob& job() const { return job_; }
    /// Set once the job is accepted.
    [[nodiscard]] std::optional<JobId> id() const { return id_; }
    /// Set once the job has ended.
    [[nodiscard]] const std::optional<JobStatus>& end() const { return end_; }

  private:
    asio::awaitable<void> run();
    asio::awaitable<void> converse(std::shared_ptr<Channel> channel);
    void submit(Channel& channel) const;

    World& world_;
    const KnownJob& job_;
    ClusterOptions options_;
    Host host_;
    bool wants_cancel_ = false;
    std::optional<JobId> id_;
    std::optional<JobStatus> end_;
};

} // namespace cd::tests
