// Proves that a malicious worker with a good certificate neither crashes the master nor fails
// scenarios, takes only bounded memory, and keeps no other worker from serving or joining.
#include "common/core/limits/master.hpp"
#include "proto/channel/connection.hpp"
#include "proto/channel/greeting.hpp"
#include "tests/master/fake_client.hpp"
#include "tests/master/fake_worker.hpp"
#include "tests/master/master_stage.hpp"
#include "tests/support/logged.hpp"

#include <gmock/gmock.h>

#include <functional>

namespace cd::tests {
namespace {

using testing::HasSubstr;

/// Joins, sends heartbeats, and handles each message as the test says.
class Rogue {
  public:
    using Answer = std::function<void(Channel&, const Message&)>;

    Rogue(Master& master, Answer answer, std::uint64_t instance = 66)
        : master_(master), answer_(std::move(answer)), instance_(instance) {
        spawn(master_.context.get_executor(), "a rogue", run());
        master_.run_until([this] { return has_joined || ended; });
    }
    ~Rogue() { hang_up(master_, channel, ended); }

    std::shared_ptr<Channel> channel;
    bool has_joined = false;
    bool ended = false;

  private:
    asio::awaitable<void> run() {
        const Ending ending{ended};
        Target target = master_.target(CertifiedRole::Worker, "rogue");
        auto connected = co_await connect(std::move(target));
        channel = connected.value();
        Hello hello;
        hello.role = Role::Worker;
        hello.name = "rogue";
        hello.threads = 1;
        hello.cache_bytes = 1 << 20;
        hello.instance = instance_;
        const Result<Welcome> welcome = co_await greet(channel, hello);
        has_joined = welcome.has_value();
        while (has_joined) {
            const Result<Message> message = co_await channel->receive(patience);
            if (!message) {
                break;
            }
            if (std::holds_alternative<Heartbeat>(message.value())) {
                channel->send(Heartbeat{});
            }
            answer_(*channel, message.value());
        }
    }

    Master& master_;
    Answer answer_;
    std::uint64_t instance_;
};

void says_nothing(Channel& /*channel*/, const Message& /*message*/) {}

void ends_all(Channel& channel, const Message& message) {
    if (const auto* unit = std::get_if<WorkUnit>(&message)) {
        channel.send(EndOfTask{unit->task});
    }
}

TEST(Rogue, EndingTasksUnansweredFailsNoScenario) {
    const Logged logged;
    Master master;
    Client client(master);
    client.start(reference().submission());
    for (std::uint64_t time = 0; time <= limits::scenario_losses_max; ++time) {
        Rogue rogue(master, ends_all, 66 + time);
        master.run_until([&] { return rogue.ended; });
    }
    EXPECT_THAT(logged.text(), HasSubstr("ended a task without an answer for"));
    const FakeWorker honest(master, {});
    master.run_until([&] { return client.done; });
    expect_right(client);
}

TEST(Rogue, RequestsOfAQuarantinedWorkerDoNoHarm) {
    Master master;
    const FakeWorker liar(master, {.lies_first = true, .instance = 77});
    Client client(master);
    client.start(reference().submission());
    master.run_until([&] {
        const auto workers = master.coordinator.jobs().cluster().workers;
        return !workers.empty() && workers[0].quarantined;
    });
    Rogue again(master, says_nothing, 77);
    for (std::uint64_t tree = 0; tree < 4; ++tree) {
        for (const RootIndex root : {RootIndex{0}, ~RootIndex{0}, ~RootIndex{0} - 5}) {
            again.channel->send(WantSubtrees{TreeId{tree}, {root}});
            again.channel->send(Held{TreeId{tree}, {root}});
            again.channel->send(Evicted{TreeId{tree}, {root}});
            again.channel->send(
                FetchFailed{TreeId{tree}, {root}, WorkerId{1}, PeerOutcome::Damaged});
        }
    }
    again.channel->send(EndOfTask{TaskId{1}});
    again.channel->send(Failure{ErrorCode::Io, "enough"});
    master.run_until([&] { return again.ended; });
}

TEST(Rogue, UnboundedHeldReportsEndTheConnection) {
    const Logged logged;
    Master master;
    Rogue rogue(master, says_nothing);
    std::uint64_t number = 0;
    while (number <= limits::cuts_held_max) {
        Holding holding;
        for (std::size_t i = 0; i < limits::cuts_held_max / 4; ++i) {
            ++number;
            holding.cuts.push_back(sha256(std::as_bytes(std::span(&number, 1))));
        }
        rogue.channel->send(holding);
    }
    master.run_until([&] { return rogue.ended; });
    EXPECT_THAT(logged.text(), HasSubstr("blocks of too many cuts"));
}

TEST(Rogue, OnlyDirectedWorkersCanReportASource) {
    const Logged logged;
    Master master;
    const std::uint16_t port = master.endpoint().port; // The master's probe of this port succeeds.
    const FakeWorker holder(master, {.only_takes = true, .peer_port = port});
    Client client(master);
    client.start_submitting(reference().submission());
    master.run_until([&] { return client.done && holder.batches != 0; });
    Rogue rogue(master, says_nothing);
    for (const PeerOutcome outcome : {PeerOutcome::Damaged, PeerOutcome::Unreachable}) {
        for (const std::vector<RootIndex>& roots : {std::vector<RootIndex>{}, {0}, {1, 2}}) {
            rogue.channel->send(FetchFailed{TreeId{1}, roots, WorkerId{1}, outcome});
        }
    }
    rogue.channel->send(Failure{ErrorCode::Io, "enough"});
    master.run_until([&] { return rogue.ended; });
    EXPECT_THAT(logged.text(), testing::Not(HasSubstr("serves no others any more")));
}

TEST(Rogue, WorkersLeaveRoomForOthers) {
    const Stage stage{.clients = {.workers = {.connections = 2, .all_connections = 3}}};
    Master master({.return_within = std::chrono::milliseconds(0)}, {}, stage);
    Rogue first(master, says_nothing, 1);
    Rogue second(master, says_nothing, 2);
    EXPECT_TRUE(first.has_joined && second.has_joined);
    const Logged logged;
    const Rogue third(master, says_nothing, 3);
    EXPECT_FALSE(third.has_joined);
    EXPECT_THAT(logged.text(), HasSubstr("2 connections, of 2 that it may"));
    first.channel->close();
    master.run_until([&] { return first.ended; });
    master.run_until([&] { return master.server->connections() == 1; });
    EXPECT_TRUE(Rogue(master, says_nothing, 4).has_joined);
}

} // namespace
} // namespace cd::tests
