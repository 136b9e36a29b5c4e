// The network by which a program connects to others and accepts connections: TCP, or a simulation.
#pragma once

#include "common/core/result.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"
#include "proto/channel/tls.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace cd {

/// An accepted connection without a channel yet. Unless `accept` is called, the connection closes
/// with the last copy.
struct Incoming {
    asio::ip::address address; ///< Unspecified if the peer has disconnected already.
    std::string peer;          ///< HOST:PORT, for logs.
    /// Makes the channel, as `accept_channel` does. Call once; this object must outlive the call.
    std::function<asio::awaitable<Result<std::shared_ptr<Channel>>>(std::shared_ptr<const Tls>)>
        accept;
};

/// Accepts connections on one address from `start` until it is closed or destroyed.
class ChannelListener {
  public:
    using OnIncoming = std::function<void(Incoming)>;

    ChannelListener() = default;
    ChannelListener(const ChannelListener&) = delete;
    ChannelListener& operator=(const ChannelListener&) = delete;
    virtual ~ChannelListener() = default;

    [[nodiscard]] virtual std::uint16_t port() const = 0;
    /// Calls `on_incoming` on the executor's thread for each connection.
    virtual void start(OnIncoming on_incoming) = 0;
    virtual void close() = 0;
};

class Network {
  public:
    Network() = default;
    Network(const Network&) = delete;
    Network& operator=(const Network&) = delete;
    virtual ~Network() = default;

    /// Errors: those of the function `connect`.
    [[nodiscard]] virtual asio::awaitable<Result<std::shared_ptr<Channel>>>
    connect(Target target, std::chrono::seconds timeout) = 0;
    /// Errors: those of the function `reach`.
    [[nodiscard]] virtual asio::awaitable<Status> reach(Endpoint endpoint,
                                                        std::chrono::seconds timeout) = 0;
    /// Listens at once. Errors: those of `Listener::open`.
    [[nodiscard]] virtual Result<std::unique_ptr<ChannelListener>>
    listen(const asio::any_io_executor& executor, const Endpoint& endpoint) = 0;
};

/// The network of this host.
[[nodiscard]] Network& tcp_network();

} // namespace cd
