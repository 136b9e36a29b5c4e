// Proves that scenarios of removed jobs and trees, and recalled ones, are dropped and freed if they
// have not begun, and that all others are answered.
#include "tests/worker/session_stage.hpp"

namespace cd::tests {
namespace {

TEST(Session, WhatWaitsForARemovedJobIsDroppedAndItsTreesStay) {
    perform(unlimited, 1, [](Stage& master) -> asio::awaitable<void> {
        const auto scenarios = make_scenarios(600, 400);
        master.channel->send(make_range(TaskId{1}, scenarios));
        master.channel->send(RemoveJob{JobId{1}});
        master.channel->send(AddJob{JobId{1}, {tree_a, tree_b}, {}, {}});
        co_await master.serve_until_ended(1);
        EXPECT_LT(master.records.size(), scenarios.size());
        master.records.clear();
        master.channel->send(make_range(TaskId{2}, std::span(scenarios).first(30)));
        co_await master.serve_until_ended(2);
        expect_all_right(master, std::span(scenarios).first(30));
    });
}

TEST(Session, BlocksOfRemovedTreesAreKeptAndReportedWhenTheTreesComeAgain) {
    perform(unlimited, 1, [](Stage& master) -> asio::awaitable<void> {
        const auto scenarios = make_scenarios(200, 10);
        master.channel->send(make_batch(TaskId{1}, scenarios));
        co_await master.serve_until_ended(1);
        const std::size_t sent_before = master.subtrees_sent;
        EXPECT_GT(sent_before, 0u);

        master.channel->send(RemoveTree{tree_a});
        master.channel->send(RemoveTree{tree_b});
        master.add_job();
        master.records.clear();
        master.channel->send(make_batch(TaskId{2}, scenarios));
        co_await master.serve_until_ended(2);
        expect_all_right(master, scenarios);
        EXPECT_EQ(master.subtrees_sent, sent_before);
    });
}

TEST(Session, WhatWaitsForARemovedTreeIsDroppedWithIt) {
    perform(unlimited, 1, [](Stage& master) -> asio::awaitable<void> {
        const auto scenarios = make_scenarios(300, 10);
        master.channel->send(make_batch(TaskId{1}, scenarios));
        master.channel->send(RemoveTree{tree_b});
        // The master serves no requests, so the removal comes first.
        while (!master.ended.contains(TaskId{1})) {
            Result<Message> message = co_await master.channel->receive(patience);
            EXPECT_TRUE(message);
            if (!message) {
                break;
            }
            if (const auto* ended = std::get_if<EndOfTask>(&message.value())) {
                master.on(*ended);
            }
        }
        EXPECT_LT(master.records.size(), scenarios.size());
    });
}

/// The returned scenario's blocks are evicted: nothing else needs them, and the cache is full.
TEST(Session, BlocksOfReturnedScenariosAreRequestedAgain) {
    perform(1, 1, [](Stage& master) -> asio::awaitable<void> {
        std::uint64_t index = 0;
        while (make_batch(TaskId{1}, make_scenarios(index, 1)).pairs.empty()) {
            ++index; // Until it needs blocks.
        }
        const auto scenarios = make_scenarios(index, 1);
        Recall recall;
        recall.task = TaskId{1};
        recall.scenarios.push_back(index);
        master.channel->send(make_batch(TaskId{1}, scenarios));
        while (master.ended.empty()) {
            const std::optional<Message> message = co_await master.serve_one();
            EXPECT_TRUE(message);
            if (!message) {
                co_return;
            }
            if (std::holds_alternative<WantSubtrees>(*message)) {
                master.channel->send(recall);
            }
        }
        EXPECT_TRUE(master.records.empty());
        master.channel->send(make_batch(TaskId{2}, scenarios));
        co_await master.serve_until_ended(2);
        EXPECT_EQ(master.records.size(), 1u);
    });
}

} // namespace
} // namespace cd::tests
