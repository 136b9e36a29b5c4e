// Opens channels: connects to a peer, or accepts one.
#pragma once

#include "common/core/result.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"
#include "proto/channel/endpoint.hpp"
#include "proto/channel/tls.hpp"

#include <chrono>
#include <memory>
#include <utility>

namespace cd {

/// The endpoint, security and role of a peer to connect to.
struct Target {
    Target(Endpoint there, // Enough by itself for plain TCP.
           std::shared_ptr<const Tls> secured_by = nullptr,
           CertifiedRole expected = CertifiedRole::Master)
        : endpoint(std::move(there)), tls(std::move(secured_by)), role(expected) {}

    Endpoint endpoint;
    std::shared_ptr<const Tls> tls; ///< Null: plain TCP.
    CertifiedRole role;             ///< The role that the peer's certificate must name.
};

/// Connects; each step must finish within the timeout. Errors: Disconnected naming host and port;
/// Refused if one end rejects the other's certificate, or the peer has another role.
[[nodiscard]] asio::awaitable<Result<std::shared_ptr<Channel>>>
connect(Target target, std::chrono::seconds timeout = timing::connect_timeout);

/// Checks that the endpoint accepts TCP connections, with any protocol. Errors: Disconnected naming
/// host and port.
[[nodiscard]] asio::awaitable<Status> reach(Endpoint endpoint, std::chrono::seconds timeout);

/// Wraps an accepted socket in a channel, after a TLS handshake unless `tls` is null, within the
/// timeout. A peer that uses TLS when `tls` is null, or plain TCP otherwise, gets an error in its
/// own protocol. Errors: those of `Stream::secure`.
[[nodiscard]] asio::awaitable<Result<std::shared_ptr<Channel>>>
accept_channel(asio::ip::tcp::socket socket,
               std::shared_ptr<const Tls> tls,
               std::chrono::steady_clock::duration timeout = timing::connect_timeout);

} // namespace cd
