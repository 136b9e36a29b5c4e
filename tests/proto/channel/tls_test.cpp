// Proves that a secured connection carries the same messages, that certificates identify both ends,
// and that a peer outside the cluster, or without TLS 1.3, is refused with a reason at both ends.
#include "proto/channel/tls.hpp"

#include "proto/channel/asio_tls.hpp"
#include "proto/channel/connection.hpp"
#include "proto/codec/codec.hpp"
#include "tests/proto/loopback.hpp"
#include "tests/proto/sample_messages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

WallTime now() {
    return std::chrono::system_clock::now();
}

/// A cluster's authority, which issues credentials.
struct Cluster {
    CertificateAuthority authority = CertificateAuthority::make(now());

    [[nodiscard]] std::shared_ptr<const Tls> tls(CertifiedRole role,
                                                 std::chrono::seconds from = -60s,
                                                 std::chrono::seconds until = 3600s) const {
        const Identity identity{role, "someone", now() + from, now() + until};
        return Tls::make(authority.issue(identity)).value();
    }
};

using Channels = Result<std::shared_ptr<Channel>>;

constexpr const char* not_yet = "not yet";

/// Both ends of one connection attempt.
struct Attempt {
    Channels left = Error{ErrorCode::Timeout, not_yet};
    Channels right = Error{ErrorCode::Timeout, not_yet};
};

asio::awaitable<void> accept_right(asio::ip::tcp::acceptor& acceptor,
                                   std::shared_ptr<const Tls> tls,
                                   Attempt& attempt,
                                   asio::steady_timer& done) {
    asio::ip::tcp::socket socket = co_await acceptor.async_accept(asio::use_awaitable);
    attempt.right = co_await accept_channel(std::move(socket), tls, patience);
    done.cancel();
}

/// Connects and sends a Hello. A refusal may come only with the answer: an end that shows a
/// certificate does not wait for its verification.
asio::awaitable<Attempt> try_to_connect(std::shared_ptr<const Tls> left,
                                        std::shared_ptr<const Tls> right,
                                        CertifiedRole expected = CertifiedRole::Master) {
    const auto executor = co_await asio::this_coro::executor;
    const asio::ip::tcp::endpoint any_port(asio::ip::address_v4::loopback(), 0);
    asio::ip::tcp::acceptor acceptor(executor, any_port);
    asio::steady_timer done(executor, asio::steady_timer::time_point::max());
    Attempt attempt;
    spawn(executor, "accept", accept_right(acceptor, right, attempt, done));
    Target target{{"127.0.0.1", acceptor.local_endpoint().port()}, left, expected};
    attempt.left = co_await connect(std::move(target));
    if (attempt.left) {
        Hello hello;
        attempt.left.value()->send(hello);
    }
    const auto is_decided = [&] {
        return attempt.right || attempt.right.error().detail != not_yet;
    };
    // The accepting end waits for the refused one, so keep reading.
    while (attempt.left && !attempt.right) {
        const Result<Message> answer = co_await attempt.left.value()->receive(10ms);
        if (answer) {
            const auto& failure = std::get<Failure>(answer.value());
            attempt.left = Error{failure.code, failure.detail};
        } else if (answer.error().code != ErrorCode::Timeout) {
            attempt.left = answer.error();
        }
    }
    while (!is_decided()) {
        boost::system::error_code ignored;
        co_await done.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    }
    co_return attempt;
}

TEST(Tls, CarriesEveryMessageAndNamesBothEnds) {
    run_conversation([]() -> asio::awaitable<void> {
        const Cluster cluster;
        Attempt ends = co_await try_to_connect(cluster.tls(CertifiedRole::Worker),
                                               cluster.tls(CertifiedRole::Master));
        EXPECT_TRUE(ends.left && ends.right);
        Channel& left = *ends.left.value();
        Channel& right = *ends.right.value();
        EXPECT_EQ(left.peer_identity()->role, CertifiedRole::Master);
        EXPECT_EQ(right.peer_identity()->role, CertifiedRole::Worker);
        EXPECT_EQ(right.peer_identity()->name, "someone");
        EXPECT_TRUE(left.is_secured() && right.is_secured());
        EXPECT_EQ(left.binding().value(), right.binding().value());
        const Result<Message> hello = co_await right.receive(patience);
        EXPECT_TRUE(hello);
        for (const Message& message : sample_messages()) {
            left.send(message);
            const Result<Message> came = co_await right.receive(patience);
            EXPECT_TRUE(came);
            EXPECT_EQ(encode_message(came.value()), encode_message(message));
        }
        left.close(true);
        const Result<Message> end = co_await right.receive(patience);
        EXPECT_EQ(end.error().code, ErrorCode::Disconnected);
    });
}

TEST(Tls, LargeMessagesPassInBothDirectionsAtOnce) {
    run_conversation([]() -> asio::awaitable<void> {
        const Cluster cluster;
        Attempt ends = co_await try_to_connect(cluster.tls(CertifiedRole::Worker),
                                               cluster.tls(CertifiedRole::Master));
        Channel& left = *ends.left.value();
        Channel& right = *ends.right.value();
        Welcome welcome;
        right.send(welcome);
        Results results;
        results.records.assign(20u << 20, std::byte{7});
        left.send(results);
        right.send(results);
        for (Channel* channel : {&left, &right}) {
            const Result<Message> greeting = co_await channel->receive(patience);
            EXPECT_TRUE(greeting);
            const Result<Message> came = co_await channel->receive(patience);
            EXPECT_EQ(std::get<Results>(came.value()).records, results.records);
        }
        left.close();
        right.close();
    });
}

TEST(Tls, EachConnectionHasABindingOfItsOwn) {
    run_conversation([]() -> asio::awaitable<void> {
        const Cluster cluster;
        const auto worker = cluster.tls(CertifiedRole::Worker);
        const auto master = cluster.tls(CertifiedRole::Master);
        Attempt first = co_await try_to_connect(worker, master);
        Attempt second = co_await try_to_connect(worker, master);
        EXPECT_NE(first.left.value()->binding().value(), second.left.value()->binding().value());
    });
}

TEST(Tls, APeerWithoutCertificateHasNoRole) {
    run_conversation([]() -> asio::awaitable<void> {
        const Cluster cluster;
        Attempt ends = co_await try_to_connect(Tls::make_joining(cluster.authority.fingerprint()),
                                               cluster.tls(CertifiedRole::Master));
        EXPECT_TRUE(ends.left && ends.right);
        EXPECT_FALSE(ends.right.value()->peer_identity());
        EXPECT_EQ(ends.left.value()->peer_identity()->role, CertifiedRole::Master);
    });
}

TEST(Tls, NobodySendsLargeMessages) {
    run_conversation([]() -> asio::awaitable<void> {
        const Cluster cluster;
        Attempt ends = co_await try_to_connect(Tls::make_joining(cluster.authority.fingerprint()),
                                               cluster.tls(CertifiedRole::Master));
        Channel& right = *ends.right.value();
        const Result<Message> hello = co_await right.receive(patience);
        EXPECT_TRUE(hello);
        ends.left.value()->send(Heartbeat{});
        const Result<Message> small = co_await right.receive(patience);
        EXPECT_TRUE(small);
        ends.left.value()->send(Subtrees{});
        const Result<Message> large = co_await right.receive(patience);
        EXPECT_EQ(large.error().code, ErrorCode::BadFrame);
        EXPECT_THAT(large.error().detail, HasSubstr("no certificate"));
        ends.left.value()->close();
    });
}

TEST(Tls, APinOfAnotherAuthorityIsNoticedByWhoJoins) {
    run_conversation([]() -> asio::awaitable<void> {
        const Cluster cluster;
        const Cluster other;
        Attempt ends = co_await try_to_connect(Tls::make_joining(other.authority.fingerprint()),
                                               cluster.tls(CertifiedRole::Master));
        EXPECT_EQ(ends.left.error().code, ErrorCode::Refused);
        EXPECT_THAT(ends.left.error().detail, HasSubstr("certificate"));
        EXPECT_EQ(ends.right.error().code, ErrorCode::Refused);
    });
}

TEST(Tls, ACertificateOfAnotherAuthorityIsRefusedByWhicheverEnd) {
    run_conversation([]() -> asio::awaitable<void> {
        const Cluster cluster;
        const Cluster other;
        Attempt strangers = co_await try_to_connect(other.tls(CertifiedRole::Worker),
                                                    cluster.tls(CertifiedRole::Master));
        EXPECT_EQ(strangers.left.error().code, ErrorCode::Refused);
        EXPECT_EQ(strangers.right.error().code, ErrorCode::Refused);
        // Trusts the cluster, but shows a certificate of another authority.
        const Identity identity{CertifiedRole::Worker, "spy", now() - 1min, now() + 1h};
        Credential mixed = other.authority.issue(identity);
        mixed.authority = cluster.authority.certificate();
        Attempt spy =
            co_await try_to_connect(Tls::make(mixed).value(), cluster.tls(CertifiedRole::Master));
        EXPECT_EQ(spy.left.error().code, ErrorCode::Refused);
        EXPECT_THAT(spy.left.error().detail, HasSubstr("unknown CA"));
        EXPECT_EQ(spy.right.error().code, ErrorCode::Refused);
        EXPECT_THAT(spy.right.error().detail, HasSubstr("certificate"));
    });
}

TEST(Tls, ACertificateOutOfItsTimeIsRefused) {
    run_conversation([]() -> asio::awaitable<void> {
        const Cluster cluster;
        const auto master = cluster.tls(CertifiedRole::Master);
        Attempt late =
            co_await try_to_connect(cluster.tls(CertifiedRole::Worker, -100s, -10s), master);
        EXPECT_EQ(late.left.error().code, ErrorCode::Refused);
        EXPECT_THAT(late.left.error().detail, HasSubstr("certificate expired"));
        EXPECT_EQ(late.right.error().code, ErrorCode::Refused);
        EXPECT_THAT(late.right.error().detail, HasSubstr("certificate has expired"));
        Attempt early =
            co_await try_to_connect(cluster.tls(CertifiedRole::Worker, 1000s, 2000s), master);
        EXPECT_EQ(early.left.error().code, ErrorCode::Refused);
        EXPECT_THAT(early.right.error().detail, HasSubstr("not yet valid"));
    });
}

TEST(Tls, NobodyButAMasterIsTakenForOne) {
    run_conversation([]() -> asio::awaitable<void> {
        const Cluster cluster;
        const auto worker = cluster.tls(CertifiedRole::Worker);
        Attempt ends = co_await try_to_connect(worker, worker);
        EXPECT_EQ(ends.left.error().code, ErrorCode::Refused);
        EXPECT_THAT(ends.left.error().detail, HasSubstr("of a worker, not of a master"));
        Attempt peers = co_await try_to_connect(worker, worker, CertifiedRole::Worker);
        EXPECT_TRUE(peers.left && peers.right);
        // The key usage of a submitter's certificate does not permit accepting connections.
        Attempt submitter = co_await try_to_connect(
            worker, cluster.tls(CertifiedRole::Submitter), CertifiedRole::Submitter);
        EXPECT_EQ(submitter.left.error().code, ErrorCode::Refused);
    });
}

TEST(Tls, PlaintextAtAPortOfTlsIsToldSo) {
    run_conversation([]() -> asio::awaitable<void> {
        const Cluster cluster;
        Attempt ends = co_await try_to_connect(nullptr, cluster.tls(CertifiedRole::Master));
        EXPECT_EQ(ends.left.error().code, ErrorCode::Refused);
        EXPECT_THAT(ends.left.error().detail, HasSubstr("the master speaks TLS: cdctl join"));
        EXPECT_EQ(ends.right.error().code, ErrorCode::Refused);
        EXPECT_THAT(ends.right.error().detail, HasSubstr("plaintext"));
    });
}

TEST(Tls, TlsAtAPlainPortIsToldSo) {
    run_conversation([]() -> asio::awaitable<void> {
        const Cluster cluster;
        Attempt ends = co_await try_to_connect(cluster.tls(CertifiedRole::Worker), nullptr);
        EXPECT_EQ(ends.left.error().code, ErrorCode::Refused);
        EXPECT_THAT(ends.left.error().detail, HasSubstr("speaks no TLS"));
        EXPECT_EQ(ends.right.error().code, ErrorCode::Refused);
    });
}

TEST(Tls, AnOlderVersionIsRefused) {
    run_conversation([]() -> asio::awaitable<void> {
        const Cluster cluster;
        const auto executor = co_await asio::this_coro::executor;
        const asio::ip::tcp::endpoint any_port(asio::ip::address_v4::loopback(), 0);
        asio::ip::tcp::acceptor acceptor(executor, any_port);
        asio::steady_timer done(executor, asio::steady_timer::time_point::max());
        Attempt attempt;
        const auto master = cluster.tls(CertifiedRole::Master);
        spawn(executor, "accept", accept_right(acceptor, master, attempt, done));
        asio::ssl::context context(asio::ssl::context::tlsv12_client);
        asio::ssl::stream<asio::ip::tcp::socket> old(executor, context);
        co_await old.lowest_layer().async_connect(acceptor.local_endpoint(), asio::use_awaitable);
        boost::system::error_code error;
        co_await old.async_handshake(asio::ssl::stream_base::client,
                                     asio::redirect_error(asio::use_awaitable, error));
        EXPECT_THAT(error.message(), HasSubstr("protocol version"));
        old.lowest_layer().close();
        boost::system::error_code ignored;
        co_await done.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
        EXPECT_EQ(attempt.right.error().code, ErrorCode::Refused);
        EXPECT_THAT(attempt.right.error().detail, HasSubstr("unsupported protocol"));
    });
}

TEST(Tls, WhoNeverEndsTheHandshakeIsDropped) {
    run_conversation([]() -> asio::awaitable<void> {
        const Cluster cluster;
        const auto master = cluster.tls(CertifiedRole::Master);
        const auto executor = co_await asio::this_coro::executor;
        const asio::ip::tcp::endpoint any_port(asio::ip::address_v4::loopback(), 0);
        asio::ip::tcp::acceptor acceptor(executor, any_port);
        // Nothing at all, and the beginning of a record that promises more.
        for (const std::string& said :
             {std::string(), std::string("\x16\x03\x01\x02\x00\x01", 6)}) {
            asio::ip::tcp::socket slow(executor);
            co_await slow.async_connect(acceptor.local_endpoint(), asio::use_awaitable);
            if (!said.empty()) {
                co_await asio::async_write(slow, asio::buffer(said), asio::use_awaitable);
            }
            asio::ip::tcp::socket socket = co_await acceptor.async_accept(asio::use_awaitable);
            asio::steady_timer closes(executor, 200ms);
            closes.async_wait([&slow](const boost::system::error_code&) { slow.close(); });
            const Channels channel = co_await accept_channel(std::move(socket), master, 20ms);
            EXPECT_EQ(channel.error().code, ErrorCode::Timeout);
            boost::system::error_code ignored;
            co_await closes.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
        }
    });
}

TEST(Tls, TextsThatDoNotBelongTogetherAreNoCredential) {
    const Cluster cluster;
    const Identity identity{CertifiedRole::Worker, "w", now() - 1min, now() + 1h};
    const Credential good = cluster.authority.issue(identity);
    const Credential other = cluster.authority.issue(identity);
    EXPECT_TRUE(Tls::make(good));
    EXPECT_FALSE(Tls::make({other.key, good.certificate, good.authority}));
    EXPECT_FALSE(Tls::make({good.key, good.certificate, ""}));
    EXPECT_FALSE(Tls::make({good.key, "nonsense", good.authority}));
    EXPECT_FALSE(Tls::make({"", good.certificate, good.authority}));
}

} // namespace
} // namespace cd::tests
