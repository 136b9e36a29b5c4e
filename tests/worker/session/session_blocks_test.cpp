// Proves that a session requests only blocks it lacks, reports their cost, and keeps serving its
// connection while blocks wait to be opened.
#include "common/core/limits/worker.hpp"
#include "tests/worker/session_stage.hpp"

#include <gmock/gmock.h>

#include <latch>

namespace cd::tests {
namespace {

TEST(Session, ResultsTellWhatTheirJobCostTheNetwork) {
    perform(unlimited, 2, [](Stage& master) -> asio::awaitable<void> {
        const auto scenarios = make_scenarios(0, 120);
        // Too few scenarios for the worker to join its blocks. On joined trees, each scenario
        // counts all blocks as hits.
        const auto first = std::span(scenarios).first(limits::join_descents_min / 2);
        master.channel->send(make_batch(TaskId{1}, first));
        co_await master.serve_until_ended(1);
        EXPECT_GT(master.traffic.misses, 0u);
        EXPECT_EQ(master.traffic.misses, master.subtrees_sent);
        const WorkUnit again = make_batch(TaskId{2}, first);
        std::uint64_t needs = 0;
        for (std::size_t i = 0; i < first.size(); ++i) {
            const auto pairs = std::span(again.pairs)
                                   .subspan(again.pair_offsets[i],
                                            again.pair_offsets[i + 1] - again.pair_offsets[i]);
            needs += roots_of_a(pairs).size() + roots_of_b(pairs).size();
        }
        // In a range, too, each scenario counts.
        const std::uint64_t hits_before = master.traffic.hits;
        master.records.clear();
        master.channel->send(make_range(TaskId{2}, first));
        co_await master.serve_until_ended(2);
        EXPECT_EQ(master.traffic.hits, hits_before + needs);
        master.channel->send(make_range(TaskId{3}, std::span(scenarios).subspan(first.size())));
        co_await master.serve_until_ended(3);
        EXPECT_EQ(master.traffic.misses, master.subtrees_sent);
        EXPECT_EQ(master.traffic.master_bytes, master.bytes_sent);
        EXPECT_EQ(master.traffic.peer_bytes, 0u);
        EXPECT_EQ(master.traffic.evictions, 0u);
    });
}

TEST(Session, WhatIsHintedComesBeforeAScenarioNeedsIt) {
    perform(unlimited, 1, [](Stage& master) -> asio::awaitable<void> {
        const auto scenarios = make_scenarios(0, 40);
        const WorkUnit batch = make_batch(TaskId{1}, scenarios);
        const std::vector<RootIndex> roots_a = roots_of_a(batch.pairs);
        const std::vector<RootIndex> roots_b = roots_of_b(batch.pairs);
        master.channel->send(Hint{JobId{1}, tree_a, roots_a});
        master.channel->send(Hint{JobId{1}, tree_b, roots_b});
        master.channel->send(Hint{JobId{1}, tree_a, roots_a}); // In flight.
        const std::size_t count = roots_a.size() + roots_b.size();
        const std::function<bool()> are_asked = [&] { return master.subtrees_sent == count; };
        co_await master.serve_until(are_asked);
        EXPECT_EQ(master.subtrees_sent, count);
        master.channel->send(batch);
        co_await master.serve_until_ended(1);
        expect_all_right(master, scenarios);
        EXPECT_EQ(master.subtrees_sent, count);
        EXPECT_EQ(master.traffic.hinted, count);
        EXPECT_EQ(master.traffic.misses, 0u);
        EXPECT_EQ(master.traffic.master_bytes, master.bytes_sent);
    });
}

TEST(Session, OnlyRangesRequestUpperTrees) {
    perform(1, 2, [](Stage& master) -> asio::awaitable<void> {
        const auto scenarios = make_scenarios(0, 60);
        master.channel->send(make_batch(TaskId{1}, std::span(scenarios).first(20)));
        co_await master.serve_until_ended(1);
        EXPECT_FALSE(master.given.contains({tree_a, top_root}));
        EXPECT_FALSE(master.given.contains({tree_b, top_root}));
        master.channel->send(make_range(TaskId{2}, std::span(scenarios).subspan(20, 20)));
        master.channel->send(make_range(TaskId{3}, std::span(scenarios).subspan(40)));
        co_await master.serve_until_ended(3);
        // Reports each upper tree once: the master knows of it, although the cache has no room.
        EXPECT_TRUE(master.held.contains({tree_a, top_root}));
        EXPECT_TRUE(master.held.contains({tree_b, top_root}));
        expect_all_right(master, scenarios);
    });
}

TEST(Session, EvictionsCountForTheJobWhoseTreeTheyAreOf) {
    perform(1, 1, [](Stage& master) -> asio::awaitable<void> {
        const auto scenarios = make_scenarios(100, 20);
        master.channel->send(make_batch(TaskId{1}, scenarios));
        co_await master.serve_until_ended(1);
        EXPECT_GT(master.traffic.evictions, 0u);
        EXPECT_LE(master.traffic.evictions, master.subtrees_evicted);
        EXPECT_EQ(master.traffic.master_bytes, master.bytes_sent);
    });
}

TEST(Session, TheConnectionIsServedWhileBlocksWaitForAThreadToOpenThem) {
    perform(unlimited, 1, [](Stage& master) -> asio::awaitable<void> {
        std::latch released(1);
        master.executor.submit([&released] {
            released.wait(); // The only thread opens no block meanwhile.
            return Executor::Continuation([] {});
        });
        Subtrees wrong;
        wrong.tree = tree_a;
        wrong.blocks = {bodies().a.blocks[0]};
        wrong.blocks[0].hash.bytes[0] ^= std::byte{1};
        master.channel->send(wrong);
        master.channel->send(make_batch(TaskId{1}, make_scenarios(0, 2)));
        // If the connection's thread opened blocks, it would report the error before reading on.
        bool wants = false;
        while (!wants && master.complaint.empty()) {
            const std::optional<Message> message = co_await master.serve_one();
            EXPECT_TRUE(message);
            if (!message) {
                break;
            }
            wants = std::holds_alternative<WantSubtrees>(*message);
        }
        EXPECT_TRUE(wants);
        EXPECT_EQ(master.complaint, "");
        released.count_down();
        co_await master.serve_until_ended(1);
        EXPECT_THAT(master.complaint, testing::HasSubstr("hash"));
    });
}

} // namespace
} // namespace cd::tests
