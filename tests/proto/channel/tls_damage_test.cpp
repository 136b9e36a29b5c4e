// Proves that no damaged bit of a TLS handshake is accepted, and that hardly one looks like a
// refusal, after which a worker does not return.
#include "proto/channel/connection.hpp"
#include "proto/channel/greeting.hpp"
#include "proto/channel/tls.hpp"
#include "tests/proto/loopback.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <optional>

namespace cd::tests {
namespace {

using asio::ip::tcp;
using boost::system::error_code;

/// Coprime to the usual lengths and alignments.
constexpr std::size_t places_apart = 13;
constexpr std::size_t nowhere = SIZE_MAX;

/// A connection that passes through the test.
struct Relay {
    std::optional<tcp::socket> front; ///< The connecting end.
    std::optional<tcp::socket> back;
    std::array<std::size_t, 2> damaged_place{nowhere,
                                             nowhere}; ///< First towards the back, then the front.
    std::array<std::size_t, 2> bytes{};
};

asio::awaitable<void> carry(std::shared_ptr<Relay> relay, std::size_t direction) {
    tcp::socket& from = direction == 0 ? *relay->front : *relay->back;
    tcp::socket& to = direction == 0 ? *relay->back : *relay->front;
    Bytes buffer(16384);
    error_code error;
    while (!error) {
        const std::size_t came = co_await from.async_read_some(
            asio::buffer(buffer), asio::redirect_error(asio::use_awaitable, error));
        const std::size_t place = relay->damaged_place[direction] - relay->bytes[direction];
        if (place < came) {
            buffer[place] ^= std::byte{0x10};
        }
        relay->bytes[direction] += came;
        error_code ignored;
        co_await asio::async_write(to,
                                   asio::buffer(buffer.data(), came),
                                   asio::redirect_error(asio::use_awaitable, ignored));
    }
    to.shutdown(tcp::socket::shutdown_send, error);
}

asio::awaitable<void> welcome(tcp::socket socket, std::shared_ptr<const Tls> tls) {
    const auto channel = co_await accept_channel(std::move(socket), tls, patience);
    if (!channel) {
        co_return;
    }
    const Result<Hello> hello = co_await accept_hello(channel.value());
    if (hello) {
        const Welcome welcome;
        channel.value()->send(welcome);
        channel.value()->close(true);
    }
}

asio::awaitable<void>
accept(tcp::acceptor& acceptor, std::shared_ptr<Relay> relay, std::shared_ptr<const Tls> tls) {
    const auto executor = co_await asio::this_coro::executor;
    relay->front = co_await acceptor.async_accept(asio::use_awaitable);
    SocketEnds ends = co_await connect_sockets();
    relay->back = std::move(ends.left);
    spawn(executor, "welcome", welcome(std::move(ends.right), tls));
    spawn(executor, "there", carry(relay, 0));
    spawn(executor, "back", carry(relay, 1));
}

/// Returns the connecting end's outcome.
asio::awaitable<Result<Welcome>> meet(std::shared_ptr<const Tls> worker,
                                      std::shared_ptr<const Tls> master,
                                      std::shared_ptr<Relay> relay) {
    const auto executor = co_await asio::this_coro::executor;
    const tcp::endpoint any_port(asio::ip::address_v4::loopback(), 0);
    tcp::acceptor acceptor(executor, any_port);
    spawn(executor, "accept", accept(acceptor, relay, master));
    Target target{{"127.0.0.1", acceptor.local_endpoint().port()}, worker};
    const auto channel = co_await connect(std::move(target), std::chrono::seconds(1));
    if (!channel) {
        co_return channel.error();
    }
    const Hello hello;
    const Result<Welcome> answer = co_await greet(channel.value(), hello, std::chrono::seconds(1));
    channel.value()->close();
    co_return answer;
}

TEST(TlsDamage, HardlyABitLooksLikeARefusal) {
    const WallTime now = std::chrono::system_clock::now();
    const auto authority = CertificateAuthority::make(now);
    const auto tls_of = [&](CertifiedRole role) {
        const std::chrono::hours hour(1);
        return Tls::make(authority.issue({role, "somebody", now - hour, now + hour})).value();
    };
    const auto worker = tls_of(CertifiedRole::Worker);
    const auto master = tls_of(CertifiedRole::Master);
    std::size_t tried = 0;
    std::size_t refused = 0;
    run_conversation([&]() -> asio::awaitable<void> {
        const auto whole = std::make_shared<Relay>();
        const Result<Welcome> good = co_await meet(worker, master, whole);
        EXPECT_TRUE(good) << good.error().detail;
        for (const std::size_t direction : std::array<std::size_t, 2>{0, 1}) {
            for (std::size_t place = 0; place < whole->bytes[direction]; place += places_apart) {
                const auto relay = std::make_shared<Relay>();
                relay->damaged_place[direction] = place;
                const Result<Welcome> answer = co_await meet(worker, master, relay);
                ++tried;
                refused += !answer && answer.error().code == ErrorCode::Refused ? 1 : 0;
            }
        }
    });
    EXPECT_GT(tried, 200u);
    EXPECT_LT(refused * 50, tried) << refused << " of " << tried;
}

} // namespace
} // namespace cd::tests
