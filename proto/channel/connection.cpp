// Opening connections: connecting and accepting.
#include "common/core/host/log.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/channel/channel.hpp"
#include "proto/channel/deadline.hpp"
#include "proto/channel/frame.hpp"
#include "proto/channel/open_socket.hpp"

#include <algorithm>
#include <array>

namespace cd {
namespace {

using boost::system::error_code;

/// First byte of a TLS handshake record (RFC 8446, section 5.1).
constexpr std::byte tls_handshake{22};
/// A fatal alert: protocol version not supported. OpenSSL's clients name it in their error.
constexpr std::array<unsigned char, 7> tls_not_spoken{21, 3, 3, 0, 2, 2, 70};

using Addresses = std::vector<asio::ip::tcp::endpoint>;

asio::awaitable<Addresses> resolve(const Endpoint& endpoint, error_code& error) {
    const auto literal = asio::ip::make_address(endpoint.host, error);
    Addresses addresses;
    if (!error) {
        addresses.emplace_back(literal, endpoint.port);
        co_return addresses;
    }
    asio::ip::tcp::resolver resolver(co_await asio::this_coro::executor);
    const Deadline deadline(resolver, timing::connect_timeout);
    // GCC 12 may destroy a temporary twice in an expression with co_await, so the text has a name.
    const std::string port = std::to_string(endpoint.port);
    const auto found = co_await resolver.async_resolve(
        endpoint.host, port, asio::redirect_error(asio::use_awaitable, error));
    for (const auto& entry : found) {
        addresses.push_back(entry.endpoint());
    }
    co_return addresses;
}

std::string name_of(const Endpoint& endpoint) {
    return endpoint.host + ":" + std::to_string(endpoint.port);
}

Error unreachable(const Endpoint& endpoint, const std::string& why) {
    return {ErrorCode::Disconnected, "cannot connect to " + name_of(endpoint) + ": " + why};
}

/// Switches the connecting end to TLS if the target uses TLS, and checks the peer's role.
asio::awaitable<Status> secure(Stream& stream, const Target& target, std::chrono::seconds timeout) {
    if (target.tls == nullptr) {
        co_return Done{};
    }
    const Status secured = co_await stream.secure(target.tls, TlsEnd::Connecting, timeout);
    if (!secured) {
        co_return Error{secured.error().code,
                        name_of(target.endpoint) + ": " + secured.error().detail};
    }
    const std::optional<Identity>& peer = stream.peer_identity();
    if (!peer || peer->role != target.role) {
        co_return Error{ErrorCode::Refused,
                        name_of(target.endpoint) + " shows the certificate of a " +
                            (peer ? std::string(to_text(peer->role)) : "nobody") + ", not of a " +
                            std::string(to_text(target.role))};
    }
    co_return Done{};
}

/// Ends writing, then reads until the peer closes: unread bytes at a close would reset the
/// connection before the peer has read the last answer.
asio::awaitable<void> end_gently(asio::ip::tcp::socket& socket) {
    error_code error;
    socket.shutdown(asio::ip::tcp::socket::shutdown_send, error);
    const Deadline deadline(socket, timing::close_flush_max);
    std::array<std::byte, 4096> dropped{};
    for (std::size_t bytes = 0; !error && bytes < limits::refused_tls_bytes_max;) {
        bytes += co_await socket.async_read_some(asio::buffer(dropped),
                                                 asio::redirect_error(asio::use_awaitable, error));
    }
}

asio::awaitable<Error> refuse_tls(asio::ip::tcp::socket& socket) {
    error_code ignored;
    co_await asio::async_write(
        socket, asio::buffer(tls_not_spoken), asio::redirect_error(asio::use_awaitable, ignored));
    co_await end_gently(socket);
    co_return Error{ErrorCode::Refused, "TLS at a port that does not speak it"};
}

asio::awaitable<Error> refuse_plaintext(asio::ip::tcp::socket socket) {
    Failure failure;
    failure.code = ErrorCode::Refused;
    failure.detail = speaks_tls_text;
    const auto channel = Channel::make(std::make_unique<Stream>(std::move(socket)));
    channel->send(failure);
    channel->close(true);
    co_await channel->wait_until_closed();
    co_return Error{ErrorCode::Refused, "plaintext at a port of TLS"};
}

} // namespace

asio::awaitable<Result<asio::ip::tcp::socket>> open_socket(Endpoint endpoint,
                                                           std::chrono::seconds timeout) {
    error_code error;
    const Addresses addresses = co_await resolve(endpoint, error);
    std::string why = error ? error.message() : "no such host";
    for (const auto& address : addresses) {
        asio::ip::tcp::socket socket(co_await asio::this_coro::executor);
        {
            const Deadline deadline(socket, timeout);
            co_await socket.async_connect(address,
                                          asio::redirect_error(asio::use_awaitable, error));
            why = deadline.expired() ? "no answer in time" : error.message();
        }
        if (!error) {
            co_return socket;
        }
    }
    co_return unreachable(endpoint, why);
}

asio::awaitable<Result<std::shared_ptr<Channel>>> connect(Target target,
                                                          std::chrono::seconds timeout) {
    Result<asio::ip::tcp::socket> socket = co_await open_socket(target.endpoint, timeout);
    if (!socket) {
        co_return socket.error();
    }
    auto stream = std::make_unique<Stream>(std::move(socket.value()));
    const Status secured = co_await secure(*stream, target, timeout);
    if (!secured) {
        co_return secured.error();
    }
    co_return Channel::make(std::move(stream));
}

asio::awaitable<Status> reach(Endpoint endpoint, std::chrono::seconds timeout) {
    const Result<asio::ip::tcp::socket> socket = co_await open_socket(endpoint, timeout);
    co_return socket ? Status(Done{}) : Status(socket.error());
}

asio::awaitable<Result<std::shared_ptr<Channel>>>
accept_channel(asio::ip::tcp::socket socket,
               std::shared_ptr<const Tls> tls,
               std::chrono::steady_clock::duration timeout) {
    std::byte first{};
    error_code error;
    {
        const Deadline deadline(socket, timeout);
        co_await socket.async_receive(asio::buffer(&first, 1),
                                      asio::socket_base::message_peek,
                                      asio::redirect_error(asio::use_awaitable, error));
        if (deadline.expired()) {
            co_return Error{ErrorCode::Timeout, "nothing was received in time"};
        }
    }
    if (error) {
        co_return stream_error(error);
    }
    const bool speaks_tls = first == tls_handshake;
    if (tls == nullptr && speaks_tls) {
        co_return co_await refuse_tls(socket);
    }
    if (tls != nullptr && !speaks_tls) {
        co_return co_await refuse_plaintext(std::move(socket));
    }
    auto stream = std::make_unique<Stream>(std::move(socket));
    if (tls != nullptr) {
        const Status secured = co_await stream->secure(tls, TlsEnd::Accepting, timeout);
        if (!secured) {
            co_await end_gently(stream->socket());
            co_return secured.error();
        }
    }
    co_return Channel::make(std::move(stream));
}

} // namespace cd
