// One worker's conversation with the master.
#pragma once

#include "master/coordinator/coordinator.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace cd {

/// Reads what the worker says, on one connection: its session may outlive it.
class WorkerSession : public std::enable_shared_from_this<WorkerSession> {
  public:
    WorkerSession(Coordinator& coordinator,
                  std::shared_ptr<Channel> channel,
                  const Reception& reception);

    /// The whole conversation after the welcome. Ends when the connection does.
    [[nodiscard]] asio::awaitable<void> run(Hello hello);

  private:
    // One for each message that a worker sends; all others end the connection.
    void on(const Heartbeat& message);
    void on(const WantSubtrees& message);
    void on(const Evicted& message);
    void on(const Held& message);
    void on(const Holding& message);
    void on(const Standing& message);
    void on(const FetchFailed& message);
    void on(const Drain& message);
    void on(const Failure& message);
    void on(Results& message);
    void on(const EndOfTask& message);
    void on(const Recalled& message);
    template <class Other>
    void on(const Other& message);

    [[nodiscard]] static asio::awaitable<void> send_heartbeats(std::shared_ptr<WorkerSession> self);
    /// A worker that is faster than the merge is read more slowly.
    [[nodiscard]] asio::awaitable<void> wait_for_room();

    Coordinator& coordinator_;
    std::shared_ptr<Channel> channel_;
    Reception reception_;
    WorkerId worker_;
    asio::steady_timer heartbeat_;
    asio::steady_timer room_; ///< Cancelled when results have been merged.
    std::shared_ptr<WorkerIntake> intake_;
};

} // namespace cd
