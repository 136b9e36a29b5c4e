// Proves that blocks sent between workers over a network that damages, cuts or swallows them come
// from the next source or from the master instead, and that no result changes.
#include "tests/cluster/faulty_proxy.hpp"
#include "tests/worker/block_source.hpp"
#include "tests/worker/session_stage.hpp"
#include "worker/peers/peer_links.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using Fault = std::function<void(FaultyProxy&)>;

const Fault damaged = [](FaultyProxy& proxy) {
    proxy.damage(false);
    proxy.set(Weather::Fair);
};
const Fault cut = [](FaultyProxy& proxy) {
    proxy.cut();
    proxy.set(Weather::Fair);
};
const Fault swallowed = [](FaultyProxy& proxy) { proxy.set(Weather::Swallowed); };

asio::awaitable<void> strike(FaultyProxy& proxy, std::uint64_t pieces, Fault fault) {
    asio::steady_timer timer(co_await asio::this_coro::executor);
    while (proxy.delayed() < pieces) {
        timer.expires_after(std::chrono::milliseconds(1));
        co_await timer.async_wait(asio::use_awaitable);
    }
    fault(proxy);
}

// ---- One fetch ------------------------------------------------------------------------------

/// Returns how a fetch ends if its one large block suffers the fault; the next fetch must succeed.
asio::awaitable<PeerOutcome> fetch_struck(Fault fault) {
    const auto executor = co_await asio::this_coro::executor;
    BlockSource source(executor, bodies().a, tree_a);
    SubtreeBlock large = bodies().a.blocks[0];
    large.compressed.resize(2u << 20);
    source.blocks[0] = std::make_shared<const SubtreeBlock>(large);
    FaultyProxy proxy(source.server->port());
    proxy.set(Weather::Paced);
    PeerLinks links("a test");
    std::size_t blocks = 0;
    const PeerLinks::OnBlock on_block = [&](const SubtreeBlock& block) {
        ++blocks;
        EXPECT_EQ(block.compressed, large.compressed);
    };
    spawn(executor, "strike", strike(proxy, 8, fault)); // Greeting and request take three pieces.
    std::vector<RootIndex> roots(1);
    FetchFromPeers asked = source.directions(roots, proxy.port());
    const PeerOutcome outcome = co_await links.fetch(asked.sources[0], asked, on_block);
    EXPECT_EQ(blocks, 0u);
    EXPECT_GE(proxy.delayed(), 8u) << "it was struck too late";

    proxy.set(Weather::Fair);
    asked = source.directions(roots, proxy.port());
    const PeerOutcome next = co_await links.fetch(asked.sources[0], asked, on_block);
    EXPECT_EQ(next, PeerOutcome::Given);
    EXPECT_EQ(blocks, 1u);
    co_return outcome;
}

CD_CONVERSATION(PeerFaults, ABlockThatIsDamagedOnItsWayIsNotTaken) {
    EXPECT_EQ(co_await fetch_struck(damaged), PeerOutcome::Unreachable);
}

CD_CONVERSATION(PeerFaults, AFetchThatIsCutFailsAtOnce) {
    EXPECT_EQ(co_await fetch_struck(cut), PeerOutcome::Unreachable);
}

CD_CONVERSATION(PeerFaults, APeerThatFallsSilentIsWaitedForNoLongerThanAnAnswerMayTake) {
    EXPECT_EQ(co_await fetch_struck(swallowed), PeerOutcome::Unreachable);
}

/// Cuts all connections once bytes of an answer are lost.
asio::awaitable<void> cut_after_loss(FaultyProxy& proxy) {
    asio::steady_timer timer(co_await asio::this_coro::executor);
    while (proxy.swallowed() == 0) {
        timer.expires_after(std::chrono::milliseconds(1));
        co_await timer.async_wait(asio::use_awaitable);
    }
    proxy.set(Weather::Fair);
    proxy.cut();
}

/// A ticket is for one use. The fetch is repeated over a new connection, since the peer may just
/// have closed the idle one; but here the peer had taken the ticket.
CD_CONVERSATION(PeerFaults, AFetchWhoseAnswerIsLostOnAnIdleConnectionIsNotCalledRefused) {
    const auto executor = co_await asio::this_coro::executor;
    BlockSource source(executor, bodies().a, tree_a);
    FaultyProxy proxy(source.server->port());
    bool is_lossy = false;
    source.server->serve(source.key, [&](const SubtreeKey&) {
        proxy.set(is_lossy ? Weather::Swallowed : Weather::Fair);
        return std::make_shared<const SubtreeBlock>(bodies().a.blocks[0]);
    });
    PeerLinks links("a test");
    const PeerLinks::OnBlock on_block = [](const SubtreeBlock&) {};
    const std::vector<RootIndex> roots(1);
    FetchFromPeers asked = source.directions(roots, proxy.port());
    const PeerOutcome first = co_await links.fetch(asked.sources[0], asked, on_block);
    EXPECT_EQ(first, PeerOutcome::Given);
    is_lossy = true;
    spawn(executor, "cut", cut_after_loss(proxy));
    asked = source.directions(roots, proxy.port());
    const PeerOutcome second = co_await links.fetch(asked.sources[0], asked, on_block);
    EXPECT_EQ(second, PeerOutcome::Unreachable);
}

// ---- A session ------------------------------------------------------------------------------

constexpr WorkerId far_worker{7};
constexpr WorkerId near_worker{8};

/// Two workers that hold the blocks of one body; only the first is behind the proxy.
struct Sources {
    explicit Sources(const asio::any_io_executor& executor)
        : far(executor, bodies().a, tree_a), near(executor, bodies().a, tree_a) {
        far.hold_all();
        near.hold_all();
    }
    FetchFromPeers directions(const std::vector<RootIndex>& roots, bool has_next) {
        FetchFromPeers made = far.question(roots);
        made.sources.push_back(far.ticket_for(roots, far_worker, proxy.port()));
        if (has_next) {
            made.sources.push_back(near.ticket_for(roots, near_worker));
        }
        return made;
    }

    BlockSource far;
    BlockSource near;
    FaultyProxy proxy{far.server->port()};
};

struct Story {
    std::vector<FetchFailed> failed;
    std::size_t given_by_master = 0; ///< Roots of this body.
};

/// Runs a task for which the master names the sources once. Expects right results.
asio::awaitable<Story> do_task(Stage& stage, Sources& sources, bool has_next) {
    FakeMaster& master = stage;
    const auto scenarios = make_scenarios(0, 40);
    master.channel->send(make_batch(TaskId{1}, scenarios));
    Story story;
    bool is_sent = false;
    while (master.ended.empty()) {
        Result<Message> message = co_await master.channel->receive(patience);
        EXPECT_TRUE(message);
        if (!message) {
            break;
        }
        const auto* const want = std::get_if<WantSubtrees>(&message.value());
        const bool is_of_body = want != nullptr && want->tree == tree_a;
        if (const auto* const failure = std::get_if<FetchFailed>(&message.value())) {
            story.failed.push_back(*failure);
        } else if (is_of_body && !std::exchange(is_sent, true)) {
            for (const RootIndex root : want->roots) {
                master.given.insert({tree_a, root});
            }
            master.channel->send(sources.directions(want->roots, has_next));
        } else {
            story.given_by_master += is_of_body ? want->roots.size() : 0;
            std::visit([&](auto& content) { master.on(content); }, message.value());
        }
    }
    expect_all_right(master, scenarios);
    co_return story;
}

/// The fault hits the proxied source after so many pieces: 1 is in the greeting, 3 in the request.
void expect_others_serve(std::uint64_t pieces, const Fault& fault, bool has_next = true) {
    perform(unlimited, 1, [&](Stage& stage) -> asio::awaitable<void> {
        const auto executor = co_await asio::this_coro::executor;
        Sources sources(executor);
        sources.proxy.set(Weather::Paced);
        spawn(executor, "strike", strike(sources.proxy, pieces, fault));
        const Story story = co_await do_task(stage, sources, has_next);
        EXPECT_EQ(story.failed.size(), 1u);
        if (!story.failed.empty()) {
            EXPECT_EQ(story.failed[0].source, far_worker);
            EXPECT_EQ(story.failed[0].outcome, PeerOutcome::Unreachable);
        }
        EXPECT_EQ(story.given_by_master == 0, has_next);
        EXPECT_EQ(sources.near.server->uploaded_bytes() != 0, has_next);
    });
}

TEST(PeerFaults, TheNextSourceServesWhenBytesAreDamaged) {
    expect_others_serve(1, damaged);
    expect_others_serve(3, damaged);
}

TEST(PeerFaults, TheNextSourceServesWhenTheConnectionIsCut) {
    expect_others_serve(1, cut);
    expect_others_serve(3, cut);
}

TEST(PeerFaults, TheNextSourceServesWhenThePeerFallsSilent) {
    expect_others_serve(1, swallowed);
}

TEST(PeerFaults, WithoutAnotherSourceTheMasterServes) {
    expect_others_serve(3, damaged, false);
    expect_others_serve(3, cut, false);
}

TEST(PeerFaults, ABlockThatWasDamagedBeforeItWasSentIsRefusedByItsHash) {
    perform(unlimited, 1, [](Stage& stage) -> asio::awaitable<void> {
        Sources sources(co_await asio::this_coro::executor);
        for (auto& [root, block] : sources.far.blocks) {
            SubtreeBlock damaged_block = *block;
            damaged_block.compressed[damaged_block.compressed.size() / 2] ^= std::byte{0x10};
            block = std::make_shared<const SubtreeBlock>(damaged_block);
        }
        const Story story = co_await do_task(stage, sources, true);
        EXPECT_GT(story.given_by_master, 0u);
        EXPECT_EQ(story.failed.size(), story.given_by_master);
        for (const FetchFailed& failure : story.failed) {
            EXPECT_EQ(failure.source, far_worker);
            EXPECT_EQ(failure.outcome, PeerOutcome::Damaged);
        }
    });
}

} // namespace
} // namespace cd::tests
