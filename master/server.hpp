// Listens, greets whoever connects, and hands the connection to its kind of session.
#pragma once

#include "common/core/result.hpp"
#include "master/coordinator.hpp"
#include "proto/asio.hpp"
#include "proto/channel.hpp"
#include "proto/listener.hpp"

#include <cstdint>
#include <map>
#include <memory>

namespace cd {

class Server {
  public:
    /// Listens at once; port 0 lets the system choose one. Errors: BadInput for a host that is no
    /// address of this machine; Io when the port is taken or may not be used.
    [[nodiscard]] static Result<std::unique_ptr<Server>>
    listen(const asio::any_io_executor& executor,
           const Endpoint& endpoint,
           Coordinator& coordinator,
           std::shared_ptr<const TlsSlot> tls = std::make_shared<TlsSlot>());

    [[nodiscard]] std::uint16_t port() const { return listener_->port(); }
    /// Accepts connections from now on.
    void start();
    /// Closes the listener and all connections.
    void close();

  private:
    Server(std::unique_ptr<Listener> listener,
           Coordinator& coordinator,
           std::shared_ptr<const TlsSlot> tls);

    void accept(asio::ip::tcp::socket socket);
    [[nodiscard]] asio::awaitable<void> serve(std::uint64_t connection,
                                              asio::ip::tcp::socket socket);
    [[nodiscard]] asio::awaitable<void> converse(std::shared_ptr<Channel> channel);

    std::unique_ptr<Listener> listener_;
    Coordinator& coordinator_;
    std::shared_ptr<const TlsSlot> tls_;
    /// Null until it is secured, if it is to be.
    std::map<std::uint64_t, std::shared_ptr<Channel>> connections_;
    std::uint64_t connection_last_ = 0;
};

} // namespace cd
