// Proves that a worker serves only blocks that it holds and a ticket allows, to a bounded number of
// peers at once; and that a fetching worker distinguishes all failures and never accepts a block
// other than the one the master named.
#include "common/core/limits/wire.hpp"
#include "common/core/limits/worker.hpp"
#include "proto/channel/connection.hpp"
#include "proto/channel/endpoint.hpp"
#include "proto/channel/greeting.hpp"
#include "tests/proto/loopback.hpp"
#include "tests/worker/block_source.hpp"
#include "worker/peers/peer_links.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

constexpr TreeId tree{3};

const CutBody& body() {
    static const CutBody made = cut_body(make_torus(1, 0.4, 40, 20), 3);
    return made;
}

/// Replaces a braced list, which GCC 12 rejects in a coroutine.
template <class... Roots>
std::vector<RootIndex> list_of(Roots... roots) {
    return {static_cast<RootIndex>(roots)...};
}

struct Source : BlockSource {
    explicit Source(const asio::any_io_executor& executor) : BlockSource(executor, body(), tree) {}
};

struct Fetched {
    PeerOutcome outcome = PeerOutcome::Given;
    std::vector<RootIndex> roots;
};

asio::awaitable<Fetched> fetch(PeerLinks& links, const FetchFromPeers& directions) {
    Fetched fetched;
    const PeerLinks::OnBlock on_block = [&](const SubtreeBlock& block) {
        EXPECT_EQ(block.compressed, body().blocks[block.root].compressed);
        fetched.roots.push_back(block.root);
    };
    fetched.outcome = co_await links.fetch(directions.sources[0], directions, on_block);
    co_return fetched;
}

TEST(Peers, GiveWhatTheyHold) {
    run_conversation([]() -> asio::awaitable<void> {
        Source source(co_await asio::this_coro::executor);
        PeerLinks links("a test");
        FetchFromPeers asked; // Named, since GCC 12 destroys temporaries of an awaited call twice.
        for (const RootIndex root : list_of(0, 2, 5)) {
            source.hold(root);
        }
        asked = source.directions(list_of(0, 2, 5));
        Fetched fetched = co_await fetch(links, asked);
        EXPECT_EQ(fetched.outcome, PeerOutcome::Given);
        EXPECT_THAT(fetched.roots, UnorderedElementsAre(0, 2, 5));
        EXPECT_EQ(source.server->uploaded_bytes(),
                  body().blocks[0].compressed.size() + body().blocks[2].compressed.size() +
                      body().blocks[5].compressed.size());
        // The next fetch uses the same connection.
        asked = source.directions(list_of(2));
        fetched = co_await fetch(links, asked);
        EXPECT_EQ(fetched.outcome, PeerOutcome::Given);
        EXPECT_THAT(fetched.roots, ElementsAre(2));
    });
}

TEST(Peers, SayWhatTheyDoNotHold) {
    run_conversation([]() -> asio::awaitable<void> {
        Source source(co_await asio::this_coro::executor);
        PeerLinks links("a test");
        FetchFromPeers asked;
        source.hold(1);
        asked = source.directions(list_of(1, 4));
        const Fetched fetched = co_await fetch(links, asked);
        EXPECT_EQ(fetched.outcome, PeerOutcome::Missing);
        EXPECT_THAT(fetched.roots, ElementsAre(1));
    });
}

TEST(Peers, TakeNoTicketTwiceAndNoneThatIsNotTheMasters) {
    run_conversation([]() -> asio::awaitable<void> {
        Source source(co_await asio::this_coro::executor);
        PeerLinks links("a test");
        FetchFromPeers asked;
        source.hold(1);
        const FetchFromPeers directions = source.directions(list_of(1));
        EXPECT_EQ((co_await fetch(links, directions)).outcome, PeerOutcome::Given);
        EXPECT_EQ((co_await fetch(links, directions)).outcome, PeerOutcome::Refused);
        FetchFromPeers forged = source.directions(list_of(1));
        forged.sources[0].proof = Sha256{};
        EXPECT_EQ((co_await fetch(links, forged)).outcome, PeerOutcome::Refused);
        source.server->stop_serving();
        asked = source.directions(list_of(1));
        EXPECT_EQ((co_await fetch(links, asked)).outcome, PeerOutcome::Refused);
    });
}

TEST(Peers, ThatCannotBeReachedAreToldFromOthers) {
    run_conversation([]() -> asio::awaitable<void> {
        const auto executor = co_await asio::this_coro::executor;
        PeerLinks links("a test");
        FetchFromPeers asked;
        {
            Source gone(executor);
            asked = gone.directions(list_of(1));
        }
        // The end of the listener is a separate event.
        co_await asio::post(executor, asio::use_awaitable);
        EXPECT_EQ((co_await fetch(links, asked)).outcome, PeerOutcome::Unreachable);
    });
}

TEST(Peers, AreNotBelievedWhenTheirBlockHasAnotherHash) {
    run_conversation([]() -> asio::awaitable<void> {
        Source source(co_await asio::this_coro::executor);
        PeerLinks links("a test");
        FetchFromPeers asked;
        SubtreeBlock other = body().blocks[2];
        other.root = 1;
        source.blocks[1] = std::make_shared<const SubtreeBlock>(other);
        asked = source.directions(list_of(1));
        const Fetched fetched = co_await fetch(links, asked);
        EXPECT_EQ(fetched.outcome, PeerOutcome::Damaged);
        EXPECT_TRUE(fetched.roots.empty());
    });
}

TEST(Peers, ServeNoMoreAtATimeThanTheyMay) {
    run_conversation([]() -> asio::awaitable<void> {
        const auto executor = co_await asio::this_coro::executor;
        Source source(executor);
        // The block exceeds the buffers of an unread connection.
        SubtreeBlock large = body().blocks[1];
        large.compressed.resize(64u << 20);
        source.blocks[1] = std::make_shared<const SubtreeBlock>(large);
        const Endpoint address{"127.0.0.1", source.server->port()};
        std::vector<std::shared_ptr<Channel>> slow;
        for (std::size_t i = 0; i < limits::peer_uploads_max; ++i) {
            const FetchFromPeers directions = source.directions(list_of(1));
            slow.push_back((co_await connect(address)).value());
            Hello hello;
            hello.role = Role::Peer;
            EXPECT_TRUE(co_await greet(slow.back(), hello));
            slow.back()->send(
                PeerFetch{tree, {1}, directions.sources[0].ticket, directions.sources[0].proof});
        }
        PeerLinks links("a test");
        FetchFromPeers asked;
        PeerOutcome outcome = PeerOutcome::Given;
        // Wait until both are being served, which no event reports.
        while (outcome == PeerOutcome::Given) {
            source.hold(2);
            asked = source.directions(list_of(2));
            outcome = (co_await fetch(links, asked)).outcome;
        }
        EXPECT_EQ(outcome, PeerOutcome::Busy);
        for (const auto& channel : slow) {
            channel->close();
        }
    });
}

TEST(Peers, TurnAwayWhoIsNoPeer) {
    run_conversation([]() -> asio::awaitable<void> {
        Source source(co_await asio::this_coro::executor);
        const Endpoint address{"127.0.0.1", source.server->port()};
        const auto channel = (co_await connect(address)).value();
        const Hello hello;
        EXPECT_FALSE(co_await greet(channel, hello));
    });
}

TEST(Peers, TurnAwayWhoHasNoWorkersCertificate) {
    const WallTime now = std::chrono::system_clock::now();
    const std::chrono::hours hour(1);
    const auto authority = CertificateAuthority::make(now);
    const auto tls_of = [&](CertifiedRole role) {
        return Tls::make(authority.issue({role, "somebody", now - hour, now + hour})).value();
    };
    run_conversation([&]() -> asio::awaitable<void> {
        const auto executor = co_await asio::this_coro::executor;
        const auto slot = std::make_shared<TlsSlot>();
        slot->now = tls_of(CertifiedRole::Worker);
        const auto server = PeerServer::listen(executor, {"127.0.0.1", 0}, slot).value();
        for (const CertifiedRole role :
             {CertifiedRole::Worker, CertifiedRole::Submitter, CertifiedRole::Metrics}) {
            Target target({"127.0.0.1", server->port()}, tls_of(role), CertifiedRole::Worker);
            const auto channel = co_await connect(std::move(target));
            EXPECT_TRUE(channel);
            Hello hello;
            hello.role = Role::Peer;
            const Result<Welcome> welcome = co_await greet(channel.value(), hello);
            EXPECT_EQ(welcome.has_value(), role == CertifiedRole::Worker);
            channel.value()->close();
        }
    });
}

TEST(Peers, LeaveRoomForOtherHosts) {
    run_conversation([]() -> asio::awaitable<void> {
        Source source(co_await asio::this_coro::executor);
        const Endpoint address{"127.0.0.1", source.server->port()};
        Hello hello;
        hello.role = Role::Peer;
        std::vector<std::shared_ptr<Channel>> channels;
        std::size_t welcome = 0;
        for (std::size_t i = 0; i <= limits::peer_connections_max / 2; ++i) {
            Target target(address);
            const auto channel = co_await connect(std::move(target));
            channels.push_back(channel.value());
            const Result<Welcome> answer = co_await greet(channel.value(), hello);
            welcome += answer ? 1 : 0;
        }
        EXPECT_EQ(welcome, limits::peer_connections_max / 2);
        for (const auto& channel : channels) {
            channel->close();
        }
    });
}

} // namespace
} // namespace cd::tests
