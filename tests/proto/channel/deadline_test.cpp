// Proves that a deadline bounds all operations during its life, whenever they begin, so that a peer
// that sends little by little gets no more time than a silent one.
#include "proto/channel/deadline.hpp"

#include "proto/channel/channel.hpp"
#include "proto/channel/http/http.hpp"
#include "tests/proto/loopback.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;
using boost::system::error_code;

/// An operation that lasts until it is cancelled.
using Operation = asio::steady_timer;

asio::awaitable<error_code> run(Operation& operation) {
    operation.expires_after(patience);
    error_code error;
    co_await operation.async_wait(asio::redirect_error(asio::use_awaitable, error));
    co_return error;
}

CD_CONVERSATION(Deadline, WhatIsBegunAfterItsEndIsCancelledToo) {
    Operation operation(co_await asio::this_coro::executor);
    asio::steady_timer meanwhile(co_await asio::this_coro::executor);
    const Deadline deadline(operation, 1ms);
    // No operation is pending when the deadline ends.
    while (!deadline.expired()) {
        meanwhile.expires_after(1ms);
        co_await meanwhile.async_wait(asio::use_awaitable);
    }
    for (int i = 0; i < 3; ++i) {
        const error_code error = co_await run(operation);
        EXPECT_EQ(error, asio::error::operation_aborted);
    }
}

CD_CONVERSATION(Deadline, ItsEndIsThatOfItsOwner) {
    Operation operation(co_await asio::this_coro::executor);
    {
        const Deadline deadline(operation, 1ms);
        const error_code error = co_await run(operation);
        EXPECT_EQ(error, asio::error::operation_aborted);
    }
    // Several of the deadline's periods later.
    operation.expires_after(200ms);
    error_code error;
    co_await operation.async_wait(asio::redirect_error(asio::use_awaitable, error));
    EXPECT_FALSE(error);
}

/// A connection on which these bytes have arrived, and no others ever will. They take several
/// reads, none of which waits when an expired deadline cancels.
struct Flooded {
    asio::ip::tcp::socket silent;
    std::unique_ptr<Stream> stream;
};

asio::awaitable<Flooded> flood(std::string bytes) {
    SocketEnds ends = co_await connect_sockets();
    asio::ip::tcp::socket& silent = ends.left;
    asio::ip::tcp::socket& socket = ends.right;
    asio::write(silent, asio::buffer(bytes));
    co_return Flooded{std::move(silent), std::make_unique<Stream>(std::move(socket))};
}

CD_CONVERSATION(Deadline, AHandshakeThatIsReadWhenItEndsEndsWithIt) {
    const WallTime now = std::chrono::system_clock::now();
    const Identity master{CertifiedRole::Master, "master", now - 1min, now + 1h};
    const auto tls = Tls::make(CertificateAuthority::make(now).issue(master)).value();
    // A ClientHello of 128 KiB in records of one byte each.
    std::string bytes;
    for (const char byte : std::string("\x01\x02\x00\x00", 4) + std::string(8000, 'x')) {
        bytes += std::string("\x16\x03\x01\x00\x01", 5) + byte;
    }
    Flooded flooded = co_await flood(std::move(bytes));
    const Status secured = co_await flooded.stream->secure(tls, TlsEnd::Accepting, 0ms);
    EXPECT_EQ(secured.error().code, ErrorCode::Timeout);
}

CD_CONVERSATION(Deadline, ARequestThatIsReadWhenItEndsEndsWithIt) {
    Flooded flooded = co_await flood("GET /" + std::string(12'000, 'x'));
    serve_http(
        std::move(flooded.stream),
        [](const HttpRequest&, const HttpRespond& respond) { respond({}); },
        0ms);
    char nothing = 0;
    error_code error;
    co_await flooded.silent.async_read_some(asio::buffer(&nothing, 1),
                                            asio::redirect_error(asio::use_awaitable, error));
    EXPECT_TRUE(error);
}

} // namespace
} // namespace cd::tests
