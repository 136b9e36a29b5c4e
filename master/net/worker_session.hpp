// Serves one worker's connection.
#pragma once

#include "master/coordinator/coordinator.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace cd {

/// Reads a worker's messages on one connection. The worker's session in `WorkerDirectory` may
/// outlive the connection.
class WorkerSession : public std::enable_shared_from_this<WorkerSession> {
  public:
    WorkerSession(Coordinator& coordinator,
                  std::shared_ptr<Channel> channel,
                  const Reception& reception);

    /// Serves the worker, which has got its Welcome. Returns when the connection ends.
    [[nodiscard]] asio::awaitable<void> run(Hello hello);

  private:
    // Handlers, one per message of a worker. Any other message ends the connection.
    void on(const Heartbeat& message);
    void on(const WantSubtrees& message);
    void on(const Evicted& message);
    void on(const Held& message);
    void on(const Holding& message);
    void on(const Inventory& message);
    void on(const FetchFailed& message);
    void on(const Drain& message);
    void on(const Failure& message);
    void on(Results& message);
    void on(const EndOfTask& message);
    void on(const Recalled& message);
    template <class Other>
    void on(const Other& message);

    [[nodiscard]] static asio::awaitable<void> send_heartbeats(std::shared_ptr<WorkerSession> self);
    /// Waits while too many result messages of the worker's process are being checked or wait for
    /// the journal.
    [[nodiscard]] asio::awaitable<void> wait_for_room();

    Coordinator& coordinator_;
    std::shared_ptr<Channel> channel_;
    Reception reception_;
    WorkerId worker_;
    asio::steady_timer heartbeat_;
    asio::steady_timer room_; ///< Cancelled when the intake has room again.
    std::shared_ptr<WorkerIntake> intake_;
};

} // namespace cd
