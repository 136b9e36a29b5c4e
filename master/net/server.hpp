// Listens, exchanges greetings with peers, and hands each connection to the session for its role.
#pragma once

#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"
#include "common/core/timing/master.hpp"
#include "master/coordinator/coordinator.hpp"
#include "master/identity/access.hpp"
#include "master/identity/identity.hpp"
#include "master/net/quotas.hpp"
#include "proto/access/refusals.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"
#include "proto/channel/network.hpp"
#include "proto/channel/seats.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>

namespace cd {

/// Limits of clients and of workers' connections; tests lower them.
struct ClientLimits {
    Quotas::Limits quotas = {};
    Quotas::Limits workers = {.connections = limits::worker_connections_max,
                              .all_connections = limits::all_worker_connections_max};
    std::chrono::milliseconds submission_idle_max = timing::submission_idle_max;
    std::size_t greetings = limits::greetings_max; ///< Connections without a Welcome so far.
};

class Server {
  public:
    /// Listens at once on the coordinator's network; with port 0 the system chooses one. With an
    /// `identity`, which must outlive the server, accepts only TLS. Errors: BadInput for a host
    /// that is no address of this machine; Io if the port is in use or not permitted.
    [[nodiscard]] static Result<std::unique_ptr<Server>>
    listen(const asio::any_io_executor& executor,
           const Endpoint& endpoint,
           Coordinator& coordinator,
           MasterIdentity* identity = nullptr,
           const ClientLimits& clients = {});

    [[nodiscard]] std::uint16_t port() const { return listener_->port(); }
    /// Number of open connections, with or without a Welcome.
    [[nodiscard]] std::size_t connections() const { return connections_.size(); }
    /// Starts accepting connections.
    void start();
    /// Closes the listener, all connections, and the coordinator.
    void close();

  private:
    Server(std::unique_ptr<ChannelListener> listener,
           Coordinator& coordinator,
           MasterIdentity* identity,
           const ClientLimits& clients);

    void accept(Incoming incoming);
    [[nodiscard]] asio::awaitable<void>
    serve(std::uint64_t connection, Incoming incoming, Seats::Seat seat);
    // These members release the slot `seat` when the peer gets its Welcome.
    [[nodiscard]] asio::awaitable<void> converse(std::shared_ptr<Channel> channel,
                                                 Seats::Seat& seat);
    [[nodiscard]] asio::awaitable<void>
    welcome_as(std::shared_ptr<Channel> channel, Hello hello, Access access, Seats::Seat& seat);
    [[nodiscard]] asio::awaitable<void> serve_client(std::shared_ptr<Channel> channel,
                                                     Welcome welcome,
                                                     Access access,
                                                     Seats::Seat& seat);
    void refuse_greeting(Channel& channel, const Error& error);
    /// File with the clients of running jobs, for the quotas after a restart.
    [[nodiscard]] std::filesystem::path jobs_path() const;
    void save_jobs();
    void restore_jobs();

    std::unique_ptr<ChannelListener> listener_;
    Coordinator& coordinator_;
    MasterIdentity* identity_; ///< Null: no TLS.
    /// All open connections by number. A channel is null until its TLS handshake has finished.
    std::map<std::uint64_t, std::shared_ptr<Channel>> connections_;
    std::uint64_t connection_last_ = 0;
    /// Slots of connections without a session as a worker or client: their peers are being greeted,
    /// join, or are being refused.
    Seats greetings_;
    Refusals refusals_;
    ClientLimits clients_;
    Quotas quotas_;
    Quotas worker_quotas_; ///< Limits workers' connections.
};

} // namespace cd
