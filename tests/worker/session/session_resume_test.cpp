// Proves that a session outlives its connection, and its results and subtrees outlive the session:
// no scenario is answered twice or lost.
#include "tests/worker/session_stage.hpp"

#include <memory>

namespace cd::tests {
namespace {

TEST(Session, WhatIsNotAcknowledgedIsSentAgainAndSubtreesAreKept) {
    const auto keep = std::make_shared<CarryOver>(unlimited);
    keep->enter(some_hash(1));
    const auto scenarios = make_scenarios(600, 30);
    std::map<std::uint64_t, Bytes> first_time;
    const Play first = [&](Stage& master) -> asio::awaitable<void> {
        master.acknowledges = false;
        master.channel->send(make_batch(TaskId{1}, scenarios));
        co_await master.serve_until_ended(1);
        EXPECT_TRUE(master.cuts_held.empty());
        first_time = master.records;
    };
    perform(unlimited, 1, first, true, keep);
    keep->enter(some_hash(1));

    const auto more = make_scenarios(630, 10);
    const Play second = [&](Stage& master) -> asio::awaitable<void> {
        for (RootIndex root = 0; root < bodies().a.blocks.size(); ++root) {
            master.held.insert({tree_a, root}); // A request for it would be an error.
        }
        for (RootIndex root = 0; root < bodies().b.blocks.size(); ++root) {
            master.held.insert({tree_b, root});
        }
        master.channel->send(make_batch(TaskId{1}, scenarios));
        // Results of the earlier session come first, and count for no current task.
        const std::function<bool()> are_back = [&] {
            return master.records.size() == scenarios.size();
        };
        co_await master.serve_until(are_back);
        EXPECT_EQ(master.records, first_time);
        EXPECT_EQ(master.tasks_of_results, std::set<TaskId>{TaskId{0}});
        EXPECT_EQ(master.cuts_held.size(), 2u);
        master.records.clear();
        co_await master.serve_until_ended(1);
        expect_all_right(master, scenarios);
        EXPECT_EQ(master.subtrees_sent, 0u);
    };
    perform(unlimited, 1, second, true, keep);
    keep->enter(some_hash(1));
    EXPECT_TRUE(keep->results.empty()) << "all were acknowledged";
    EXPECT_EQ(keep->cache.parked().size(), 2u);
    keep->enter(some_hash(2));
    EXPECT_TRUE(keep->cache.parked().empty()) << "of another cluster";
}

/// Keeps a session over several connections; the master played here remembers what it received.
asio::awaitable<void>
lose_the_connection_again_and_again(asio::io_context& context, Executor& executor, int losses) {
    Ends ends = co_await connect_greeted_ends();
    const auto session = std::make_shared<Session>(std::move(ends.left),
                                                   executor,
                                                   std::make_shared<CarryOver>(unlimited),
                                                   PeerParts{},
                                                   quick_times);
    FakeMaster master(std::move(ends.right));
    master.acknowledges = false;
    const auto scenarios = make_scenarios(700, 200);
    master.add_job();
    for (std::uint64_t task = 1; task <= 4; ++task) {
        const auto part = std::span(scenarios).subspan(50 * (task - 1), 50);
        task % 2 == 0 ? master.channel->send(make_batch(TaskId{task}, part))
                      : master.channel->send(make_range(TaskId{task}, part));
    }
    std::map<std::uint64_t, Bytes> records;
    std::set<TaskId> unended{TaskId{1}, TaskId{2}, TaskId{3}, TaskId{4}};
    for (int connection = 0; connection <= losses; ++connection) {
        std::optional<SessionEnd> how;
        const auto serve = [](std::shared_ptr<Session> of,
                              std::shared_ptr<Channel> over,
                              std::optional<SessionEnd>& end) -> asio::awaitable<void> {
            if (over == nullptr) {
                end = co_await of->run();
            } else {
                end = co_await of->resume(over);
            }
        };
        std::shared_ptr<Channel> over;
        if (connection != 0) {
            Ends next = co_await connect_greeted_ends();
            over = std::move(next.left);
            master.channel = std::move(next.right);
            master.records.clear();
            master.ended.clear();
            master.held.clear(); // The session repeats its pending requests.
            master.inventory.reset();
        }
        spawn(context.get_executor(), "session", serve(session, std::move(over), how));
        // After some messages each connection breaks, except the last.
        const bool is_last = connection == losses;
        for (int heard = 0; is_last ? !unended.empty() : heard < 12 + 5 * connection; ++heard) {
            const std::optional<Message> message = co_await master.serve_one();
            EXPECT_TRUE(message);
            if (!message) {
                co_return;
            }
            for (const TaskId task : master.ended) {
                unended.erase(task);
            }
            // The first message of a session is an empty Inventory.
            const auto* now = std::get_if<Inventory>(&*message);
            if (now != nullptr && connection > 0) {
                EXPECT_EQ(now->trees.size(), 2u);
                EXPECT_EQ(now->jobs, std::vector<JobId>{JobId{1}});
                unended.clear(); // Unnamed tasks have ended; their results came before.
                for (const Recalled& task : now->tasks) {
                    unended.insert(task.task);
                }
            }
        }
        for (const auto& [index, record] : master.records) {
            const auto [place, is_new] = records.emplace(index, record);
            EXPECT_EQ(place->second, record);
        }
        EXPECT_EQ(master.tasks_of_results.count(TaskId{0}), 0u) << "tasks are those of before";
        master.channel->close();
        while (!how) {
            co_await asio::post(executor.home(), asio::use_awaitable);
        }
        EXPECT_EQ(how, SessionEnd::Lost);
    }
    master.records = records;
    expect_all_right(master, scenarios);
    session->leave();
}

TEST(Session, OutlivesItsConnectionAndDoesNothingTwice) {
    for (const int losses : {1, 4}) {
        asio::io_context context;
        Executor executor(context.get_executor(), 2);
        asio::co_spawn(context,
                       lose_the_connection_again_and_again(context, executor, losses),
                       [](const std::exception_ptr& thrown) { EXPECT_FALSE(thrown); });
        context.run_for(patience);
        EXPECT_TRUE(context.stopped()) << "something is still under way";
    }
}

} // namespace
} // namespace cd::tests
