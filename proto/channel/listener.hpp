// Accepts connections on one address.
#pragma once

#include "common/core/result.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/endpoint.hpp"

#include <functional>
#include <memory>

namespace cd {

/// Listens after `open` and accepts after `start`, until it is closed or destroyed.
class Listener {
  public:
    using OnSocket = std::function<void(asio::ip::tcp::socket)>;

    /// Listens on an endpoint; for port 0 the system chooses a port. Errors: BadInput for a host
    /// without an address; Io.
    [[nodiscard]] static Result<std::unique_ptr<Listener>>
    open(const asio::any_io_executor& executor, const Endpoint& endpoint);
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;
    ~Listener();

    [[nodiscard]] std::uint16_t port() const;
    /// Calls `on_socket` on the executor's thread for each connection.
    void start(OnSocket on_socket);
    void close();

  private:
    struct State;
    explicit Listener(std::shared_ptr<State> state);
    [[nodiscard]] static asio::awaitable<void> accept_all(std::shared_ptr<State> state);
    std::shared_ptr<State> state_;
};

} // namespace cd
