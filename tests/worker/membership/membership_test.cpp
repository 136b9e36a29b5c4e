// Proves that a worker told to stop hands over all it has, even if its connection or master is away
// at that moment, and ends within its time limit in any case.
#include "worker/membership/membership.hpp"

#include "tests/worker/session_stage.hpp"

#include <array>
#include <memory>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

/// A worker's membership, and the masters that the test plays one after the other.
struct Bond {
    explicit Bond(asio::io_context& context)
        : executor(context.get_executor(), 1), membership(executor, unlimited) {}

    Executor executor;
    Membership membership;
    std::optional<SessionEnd> how; ///< How the last connection ended.
};

asio::awaitable<void> serve(Bond& bond, std::shared_ptr<Channel> channel) {
    bond.how.reset();
    Hello hello;
    hello.role = Role::Worker;
    PeerParts peers;
    const Result<Served> served =
        co_await bond.membership.serve(std::move(channel), std::move(hello), std::move(peers));
    EXPECT_TRUE(served);
    bond.how = served ? served.value().how : SessionEnd::Lost;
}

/// Accepts another connection and greets. Equal `epoch` (of the master's process) resumes the
/// session. `heartbeat` is the announced period; the master sends none, so it must be long enough
/// that a slow machine does not declare the master silent.
asio::awaitable<FakeMaster>
welcome(Bond& bond, std::uint64_t epoch, std::chrono::milliseconds heartbeat = patience) {
    Ends ends = co_await connect_ends();
    spawn(bond.executor.home(), "worker", serve(bond, std::move(ends.left)));
    const Result<Hello> hello = co_await accept_hello(ends.right);
    EXPECT_TRUE(hello);
    Welcome answer;
    answer.id = 5;
    answer.cluster = some_hash(1);
    answer.epoch = epoch;
    answer.is_resumed = hello && hello.value().resumed.epoch == epoch;
    answer.heartbeat_ms = static_cast<std::uint32_t>(heartbeat.count());
    answer.lost_after_ms = 10 * answer.heartbeat_ms;
    ends.right->send(answer);
    FakeMaster master(std::move(ends.right));
    co_return master;
}

asio::awaitable<void> end_of_connection(Bond& bond) {
    while (!bond.how) {
        co_await asio::post(bond.executor.home(), asio::use_awaitable);
    }
}

asio::awaitable<void> end_of_connection(Bond& bond, const FakeMaster& master) {
    master.channel->close();
    co_await end_of_connection(bond);
}

/// Leaves results that the first master did not acknowledge.
asio::awaitable<void> leave_unacknowledged(Bond& bond, std::span<const Scenario> scenarios) {
    FakeMaster master = co_await welcome(bond, 1);
    master.acknowledges = false;
    master.add_job();
    master.channel->send(make_batch(TaskId{1}, scenarios));
    co_await master.serve_until_ended(1);
    EXPECT_EQ(master.records.size(), scenarios.size());
    co_await end_of_connection(bond, master);
}

using BondPlay = std::function<asio::awaitable<void>(Bond&)>;

void perform_bond(const BondPlay& play) {
    asio::io_context context;
    Bond bond(context);
    asio::co_spawn(
        context, play(bond), [](const std::exception_ptr& thrown) { EXPECT_FALSE(thrown); });
    context.run_for(patience);
    EXPECT_TRUE(context.stopped()) << "something is still under way";
}

TEST(Membership, ToldToEndWithoutAConnectionItHandsOverWhatItHasOverTheNextOne) {
    for (const std::uint64_t epoch : {1u, 2u}) { // The same master, then a restarted one.
        const auto scenarios = make_scenarios(600, 20);
        perform_bond([&](Bond& bond) -> asio::awaitable<void> {
            co_await leave_unacknowledged(bond, scenarios);
            EXPECT_TRUE(bond.membership.has_work());
            EXPECT_TRUE(bond.membership.drain(patience, [] { ADD_FAILURE() << "out of time"; }));
            FakeMaster master = co_await welcome(bond, epoch);
            co_await master.serve_until_ended(99); // Until the connection ends.
            expect_all_right(master, scenarios);
            EXPECT_TRUE(master.worker_drains);
            EXPECT_EQ(bond.how, SessionEnd::Drained);
            EXPECT_FALSE(bond.membership.has_work());
            bond.membership.end();
        });
    }
}

TEST(Membership, WithoutWorkOrConnectionItEndsAtOnce) {
    perform_bond([](Bond& bond) -> asio::awaitable<void> {
        FakeMaster master = co_await welcome(bond, 1);
        co_await end_of_connection(bond, master);
        EXPECT_FALSE(bond.membership.drain(patience, [] {}));
        bond.membership.end();
    });
}

TEST(Membership, AnUnansweredDrainEndsAtItsTimeout) {
    const auto scenarios = make_scenarios(600, 5);
    perform_bond([&](Bond& bond) -> asio::awaitable<void> {
        co_await leave_unacknowledged(bond, scenarios);
        bool is_out_of_time = false;
        EXPECT_TRUE(bond.membership.drain(20ms, [&] { is_out_of_time = true; }));
        while (!is_out_of_time) {
            co_await asio::post(bond.executor.home(), asio::use_awaitable);
        }
        EXPECT_FALSE(bond.membership.unkept().empty()) << "it must not say that it was drained";
    });
}

TEST(Membership, EachQuickReconnectDoublesTheSilenceTimeout) {
    // Three heartbeats, six heartbeats, and the time the master waits for this worker in any case.
    static constexpr std::array<std::chrono::milliseconds, 4> times{60ms, 120ms, 200ms, 200ms};
    perform_bond([](Bond& bond) -> asio::awaitable<void> {
        for (std::size_t i = 0; i + 1 < times.size(); ++i) {
            const auto since = std::chrono::steady_clock::now();
            const FakeMaster master = co_await welcome(bond, 1, 20ms);
            co_await end_of_connection(bond);
            EXPECT_EQ(bond.how, SessionEnd::Lost);
            EXPECT_GE(std::chrono::steady_clock::now() - since, times[i]);
            EXPECT_EQ(bond.membership.patience(), times[i + 1]);
        }
        bond.membership.end();
    });
}

TEST(Membership, AGoodConnectionResetsTheSilenceTimeout) {
    perform_bond([](Bond& bond) -> asio::awaitable<void> {
        const FakeMaster silent = co_await welcome(bond, 1, 20ms);
        co_await end_of_connection(bond);
        EXPECT_EQ(bond.membership.patience(), 120ms);
        const auto since = std::chrono::steady_clock::now();
        const FakeMaster master = co_await welcome(bond, 1, 20ms);
        while (std::chrono::steady_clock::now() - since < 600ms) {
            master.channel->send(Heartbeat{});
            co_await asio::post(bond.executor.home(), asio::use_awaitable);
        }
        co_await end_of_connection(bond);
        EXPECT_EQ(bond.membership.patience(), 60ms);
        bond.membership.end();
    });
}

TEST(Membership, ABrokenConnectionIsNoSilence) {
    perform_bond([](Bond& bond) -> asio::awaitable<void> {
        const FakeMaster master = co_await welcome(bond, 1, 20ms);
        co_await end_of_connection(bond, master);
        EXPECT_EQ(bond.membership.patience(), 60ms);
        bond.membership.end();
    });
}

} // namespace
} // namespace cd::tests
