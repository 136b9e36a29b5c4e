// Proves that a session's link keeps results until they are acknowledged, sends them again over the
// next connection, and tells why a connection or a session has ended.
#include "worker/session/session_link.hpp"

#include "tests/worker/session/parts.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace cd::tests {
namespace {

struct Linked {
    std::shared_ptr<TestHub> hub;
    std::shared_ptr<CarryOver> keep;
    SessionLink& link;
    std::shared_ptr<Channel> master;
    Status answer = Done{}; ///< Of the session, to each message.
    std::size_t handled = 0;
};

using Part = std::function<asio::awaitable<void>(Linked&)>;

/// Runs the part with a link to a master played by the test.
void with_link(const Part& part, const UnkeptBounds& bounds = {}, SessionTimes times = {}) {
    run_conversation([&]() -> asio::awaitable<void> {
        const auto home = co_await asio::this_coro::executor;
        Executor executor(home, 1);
        const auto hub = std::make_shared<TestHub>(executor);
        const auto keep = std::make_shared<CarryOver>(unlimited, bounds);
        Ends ends = co_await connect_greeted_ends();
        Linked* linked_ptr = nullptr;
        SessionLink::Calls calls;
        calls.handle = [&](Message&) {
            ++linked_ptr->handled;
            return linked_ptr->answer;
        };
        calls.send_heartbeat = [] {};
        SessionLink link(*hub, std::move(ends.left), keep, times, std::move(calls));
        Linked linked{hub, keep, link, std::move(ends.right)};
        linked_ptr = &linked;
        co_await part(linked);
        linked.master->close();
        linked.link.end(SessionEnd::Terminated);
        co_await asio::post(home, asio::use_awaitable); // Coroutines of the link end.
    });
}

template <class T>
asio::awaitable<T> next(Linked& linked) {
    Result<Message> message = co_await linked.master->receive(patience);
    EXPECT_TRUE(message);
    T* const expected = message ? std::get_if<T>(&message.value()) : nullptr;
    EXPECT_NE(expected, nullptr) << "another message came";
    co_return expected == nullptr ? T{} : std::move(*expected);
}

Results some_results(std::uint32_t count) {
    Results results;
    results.task = TaskId{1};
    results.job = JobId{1};
    results.count = count;
    return results;
}

TEST(SessionLink, SendsUnacknowledgedResultsAgainThenTheInventory) {
    with_link([](Linked& linked) -> asio::awaitable<void> {
        for (const std::uint32_t count : {1u, 2u, 3u}) {
            linked.link.send_results(some_results(count));
            EXPECT_EQ((co_await next<Results>(linked)).count, count);
        }
        const std::vector<std::uint64_t> acknowledged(1, 2);
        linked.link.results_kept(acknowledged);
        Ends ends = co_await connect_greeted_ends();
        linked.master = std::move(ends.right);
        Inventory inventory;
        inventory.jobs.push_back(JobId{5});
        linked.link.resume(std::move(ends.left), inventory);
        EXPECT_EQ((co_await next<Results>(linked)).count, 1u);
        EXPECT_EQ((co_await next<Results>(linked)).count, 3u);
        EXPECT_EQ((co_await next<Inventory>(linked)).jobs, inventory.jobs);
        EXPECT_TRUE(linked.link.has_unkept_results());
        EXPECT_FALSE(linked.link.has_ended());
    });
}

TEST(SessionLink, AnInventoryTooLargeForOneMessageEndsTheSession) {
    with_link([](Linked& linked) -> asio::awaitable<void> {
        Inventory inventory;
        inventory.trees.resize(1);
        std::vector<RootIndex>& held = inventory.trees[0].held;
        held.resize(limits::message_roots_bytes_max / sizeof(RootIndex));
        std::iota(held.begin(), held.end(), 0);
        Ends ends = co_await connect_greeted_ends();
        linked.link.resume(std::move(ends.left), inventory);
        const SessionEnd end = co_await linked.link.serve();
        EXPECT_EQ(end, SessionEnd::Disagreed) << "it is to begin another session";
        EXPECT_EQ(linked.link.reason(), "its inventory exceeds the limit of a message");
        const Result<Message> nothing = co_await ends.right->receive(patience);
        EXPECT_FALSE(nothing);
    });
}

TEST(SessionLink, TakesNoMoreResultsThanMayBeUnacknowledged) {
    const UnkeptBounds bounds{1u << 20, 2};
    const auto part = [](Linked& linked) -> asio::awaitable<void> {
        EXPECT_TRUE(linked.link.takes_results());
        linked.link.send_results(some_results(1));
        EXPECT_TRUE(linked.link.takes_results());
        linked.link.send_results(some_results(2));
        EXPECT_FALSE(linked.link.takes_results());
        const std::vector<std::uint64_t> acknowledged(1, 1);
        linked.link.results_kept(acknowledged);
        EXPECT_TRUE(linked.link.takes_results());
        co_return;
    };
    with_link(part, bounds);
}

TEST(SessionLink, TellsTheMasterWhyItDisagrees) {
    with_link([](Linked& linked) -> asio::awaitable<void> {
        linked.answer = Error{ErrorCode::BadFrame, "no such tree"};
        const Terminate message{"any message"};
        linked.master->send(message);
        const SessionEnd end = co_await linked.link.serve();
        EXPECT_EQ(end, SessionEnd::Disagreed);
        EXPECT_EQ(linked.handled, 1u);
        const Failure failure = co_await next<Failure>(linked);
        EXPECT_EQ(failure.detail, "no such tree");
        EXPECT_EQ(linked.link.reason(), "no such tree");
        const Error later{ErrorCode::BadFrame, "too late"};
        linked.link.refuse(later);
        EXPECT_EQ(linked.link.reason(), "no such tree") << "the first reason counts";
    });
}

TEST(SessionLink, NoticesASilentMaster) {
    SessionTimes times;
    times.silent_after = std::chrono::milliseconds(1);
    const auto part = [](Linked& linked) -> asio::awaitable<void> {
        const SessionEnd end = co_await linked.link.serve();
        EXPECT_EQ(end, SessionEnd::Lost) << "another connection may resume the session";
        EXPECT_TRUE(linked.link.met_silence());
        EXPECT_FALSE(linked.link.is_open());
    };
    with_link(part, {}, times);
}

TEST(SessionLink, ALostConnectionIsNoSilence) {
    with_link([](Linked& linked) -> asio::awaitable<void> {
        linked.master->close();
        const SessionEnd end = co_await linked.link.serve();
        EXPECT_EQ(end, SessionEnd::Lost);
        EXPECT_FALSE(linked.link.met_silence());
        EXPECT_NE(linked.link.reason(), "");
    });
}

} // namespace
} // namespace cd::tests
