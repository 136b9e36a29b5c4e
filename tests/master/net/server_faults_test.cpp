// Proves that the digest is that of the same scenarios without a cluster, whatever workers do: they
// die, forget, lie, are too slow or send invalid messages.
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "master/compute/record_size.hpp"
#include "proto/channel/connection.hpp"
#include "proto/channel/greeting.hpp"
#include "tests/master/fake_client.hpp"
#include "tests/master/fake_worker.hpp"
#include "tests/master/master_stage.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/logged.hpp"

#include <latch>

namespace cd::tests {
namespace {

TEST(Server, RangesOfAWorkerThatDiesAreAnalysedAndDoneByAnother) {
    Master master;
    const FakeWorker bad(master, {.dies_at_range = 2});
    Client client(master);
    Submit submit = reference().submission();
    submit.cluster.analysis = AnalysisMode::Never;
    client.start(submit);
    master.run_until([&] { return bad.ranges >= 2; });
    const FakeWorker other(master, {});
    master.run_until([&] { return client.done; });
    expect_right(client);
    EXPECT_GT(bad.batches + other.batches, 0u);
}

TEST(Server, AWorkerThatDiesHasItsScenariosDoneByAnother) {
    Master master;
    FakeWorker mortal(master, {.dies_at_batch = 2});
    FakeWorker other(master, {});
    Client client(master);
    client.start(reference().submission());
    master.run_until([&] { return client.done; });
    expect_right(client);
    EXPECT_TRUE(mortal.ended);
}

/// Simulates a master that stood still while a worker reconnected repeatedly.
TEST(Server, AbandonedConnectionsOfOneProcessCountNoLoss) {
    Master master;
    Client client(master);
    client.start(reference().submission());
    {
        std::vector<std::unique_ptr<FakeWorker>> sessions;
        for (std::uint32_t i = 0; i <= limits::scenario_losses_max; ++i) {
            sessions.push_back(std::make_unique<FakeWorker>(
                master, FakeWorker::Habits{.only_takes = true, .instance = 7}));
            master.run_until([&] { return sessions.back()->batches != 0; });
        }
    }
    FakeWorker other(master, {});
    master.run_until([&] { return client.done; });
    expect_right(client);
}

TEST(Server, RepeatedAnswersDoNoHarm) {
    Master master;
    const FakeWorker twice(master, {.answers_twice = true});
    Client client(master);
    client.start(reference().submission());
    master.run_until([&] { return client.done; });
    expect_right(client);
}

TEST(Server, DifferingResultsKeepTheRightOneAndQuarantineTheWorker) {
    for (const FakeWorker::Habits& habits :
         {FakeWorker::Habits{.lies_first = true},
          FakeWorker::Habits{.lies_second = true},
          FakeWorker::Habits{.lies_first = true, .lies_say_failed = true},
          FakeWorker::Habits{.lies_second = true, .lies_say_failed = true}}) {
        const Logged log;
        Master master;
        FakeWorker liar(master, habits);
        Client client(master);
        client.start(reference().submission());
        master.run_until([&] {
            const ClusterStatus status = master.coordinator.jobs().cluster();
            return status.workers.size() == 1 && status.workers[0].quarantined;
        });
        EXPECT_FALSE(master.coordinator.jobs().cluster().alarms.empty());
        FakeWorker good(master, {});
        master.run_until([&] { return client.done; });
        expect_right(client);
        EXPECT_NE(log.text().find(" critical test ALARM: "), std::string::npos) << log.text();
    }
}

TEST(Server, OtherAnswersOfAQuarantinedWorkerAreWithdrawnAndDoneAgain) {
    for (const AnalysisMode mode : {AnalysisMode::Always, AnalysisMode::Never}) {
        Master master;
        FakeWorker liar(master, {.lies_first = true, .lies_alone = 3});
        Client client(master);
        Submit submit = reference().submission();
        submit.cluster.analysis = mode;
        client.start(submit);
        master.run_until([&] {
            const ClusterStatus status = master.coordinator.jobs().cluster();
            return status.workers.size() == 1 && status.workers[0].quarantined;
        });
        const ClusterStatus status = master.coordinator.jobs().cluster();
        EXPECT_GT(status.jobs.at(0).withdrawn, 1u);
        EXPECT_GT(status.alarm_count, 0u);
        EXPECT_EQ(status.jobs.at(0).state, JobState::Running);
        FakeWorker good(master, {});
        master.run_until([&] { return client.done; });
        expect_right(client);
    }
}

TEST(Server, AScenarioThatTakesItsWorkersDownFailsAndTheJobGoesOn) {
    const std::uint64_t deadly = scenario_with_contact();
    for (const AnalysisMode mode : {AnalysisMode::Always, AnalysisMode::Never}) {
        Master master;
        Client client(master);
        Submit submit = reference().submission();
        submit.cluster.analysis = mode;
        client.start(submit);
        std::vector<std::unique_ptr<FakeWorker>> workers;
        master.run_until([&] {
            if (workers.empty() || workers.back()->ended) {
                workers.push_back(
                    std::make_unique<FakeWorker>(master, FakeWorker::Habits{.dies_of = deadly}));
            }
            return client.done;
        });
        const JobStatus& last = client.statuses.back();
        EXPECT_EQ(last.state, JobState::Done) << last.failure;
        EXPECT_EQ(last.summary.failed, 1u);
        EXPECT_EQ(last.summary.merged(), reference().scenarios.size());
        EXPECT_LE(workers.size(), limits::scenario_losses_max + 2u);
    }
}

/// The scenario's result is withdrawn, and then the scenario kills every worker that gets it.
TEST(Server, AWithdrawnScenarioThatKillsWorkersFailsUnrunByTheMaster) {
    Master master;
    Client client(master);
    client.start(reference().submission());
    constexpr std::uint64_t liars_process = 7;
    {
        const FakeWorker liar(master,
                              {.lies_alone = 3, .instance = liars_process, .batches_max = 3});
        master.run_until([&] { return liar.kept == 3; });
    }
    const std::uint64_t deadly =
        wrong_scenario(*master.coordinator.jobs().find(*client.job)->results).value();
    {
        const FakeWorker again(master, {.lies_first = true, .instance = liars_process});
        master.run_until([&] { return master.coordinator.alarms().record().count != 0; });
    }
    std::vector<std::unique_ptr<FakeWorker>> workers;
    master.run_until([&] {
        if (workers.empty() || workers.back()->ended) {
            workers.push_back(std::make_unique<FakeWorker>(master,
                                                           FakeWorker::Habits{
                                                               .dies_of = deadly,
                                                               .instance = 100 + workers.size(),
                                                           }));
        }
        return client.done;
    });
    const JobStatus& last = client.statuses.back();
    EXPECT_EQ(last.state, JobState::Done) << last.failure;
    EXPECT_EQ(last.summary.failed, 1u);
    EXPECT_EQ(last.summary.merged(), reference().scenarios.size());
    EXPECT_EQ(workers.size(), limits::scenario_losses_max + 1u);
}

TEST(Server, TasksOfAQuarantinedWorkerCountNoLoss) {
    Master master;
    const FakeWorker liar(master, {.lies_first = true, .instance = 7, .batches_max = 1});
    Client client(master);
    client.start(reference().submission());
    master.run_until([&] { return master.coordinator.alarms().record().count != 0; });
    ASSERT_GT(liar.batches, 1u) << "it has more";
    for (std::uint64_t lost = 1; lost < limits::scenario_losses_max; ++lost) {
        const FakeWorker mortal(master, {.only_takes = true, .instance = 7 + lost});
        master.run_until([&] { return mortal.batches != 0; });
    }
    const FakeWorker good(master, {});
    master.run_until([&] { return client.done; });
    expect_right(client);
}

TEST(Server, AScenarioThatTakesLongIsShownWithItsWorker) {
    Master master;
    Client client(master);
    client.start(reference().submission());
    master.run_until([&] { return client.job.has_value(); });
    FakeWorker worker(master, {});
    master.run_until([&] { return master.coordinator.jobs().cluster().workers.size() == 1; });
    const WorkerId id = master.coordinator.jobs().cluster().workers[0].worker;
    const auto shown = [&] {
        return master.coordinator.jobs().status(*client.job).value().long_scenarios;
    };
    master.coordinator.workers().heartbeat_came(
        id, {1, 0, 1, {}, RunningScenario{*client.job, 3, 9.5}});
    EXPECT_TRUE(shown().empty()) << "not long yet";
    master.coordinator.workers().heartbeat_came(id,
                                                {2, 0, 1, {}, RunningScenario{*client.job, 3, 75}});
    ASSERT_EQ(shown().size(), 1u);
    EXPECT_EQ(shown()[0].scenario, 3u);
    EXPECT_EQ(shown()[0].worker, id);
    EXPECT_EQ(shown()[0].name, "fake");
    EXPECT_EQ(master.coordinator.jobs().cluster().jobs.at(0).long_scenarios.size(), 1u);
    master.coordinator.workers().heartbeat_came(id, {3, 0, 1, {}, {}});
    EXPECT_TRUE(shown().empty());
    master.run_until([&] { return client.done; });
}

TEST(Server, AScenarioMayBeCancelledAndTheJobGoesOn) {
    const std::uint64_t scenario = scenario_with_contact();
    Master master;
    Client client(master);
    client.start(reference().submission());
    master.run_until(
        [&] { return client.job && master.coordinator.jobs().explainer().input(*client.job); });
    const auto ask = [&](const Message& message) {
        Client other(master);
        other.start_asking({message});
        master.run_until([&] { return other.done; });
        const auto* failure = std::get_if<Failure>(&other.answer->value());
        return failure == nullptr ? std::string("fine") : failure->detail;
    };
    EXPECT_EQ(ask(Cancel{*client.job, scenario}), "fine");
    EXPECT_NE(ask(Cancel{*client.job, scenario}).find("has a result"), std::string::npos);
    EXPECT_NE(ask(Cancel{*client.job, 10'000}).find("no scenario"), std::string::npos);
    FakeWorker worker(master, {});
    master.run_until([&] { return client.done; });
    EXPECT_EQ(client.statuses.back().state, JobState::Done);
    EXPECT_EQ(client.statuses.back().summary.failed, 1u);
    EXPECT_EQ(client.statuses.back().summary.merged(), reference().scenarios.size());
}

TEST(Server, AScenarioCancelledAtAWorkerStaysCancelledWhenItsAnswerComes) {
    const std::uint64_t scenario = scenario_with_contact();
    Master master;
    Client client(master);
    client.start(reference().submission());
    FakeWorker worker(master, {.holds = scenario});
    master.run_until([&] { return worker.is_held; });
    Client other(master);
    other.start_asking({Cancel{client.job.value(), scenario}});
    master.run_until([&] { return other.done && worker.dropped == scenario; });
    worker.go_on();
    master.run_until([&] { return client.done; });
    EXPECT_EQ(client.statuses.back().state, JobState::Done);
    EXPECT_EQ(client.statuses.back().summary.failed, 1u);
    EXPECT_EQ(client.statuses.back().summary.merged(), reference().scenarios.size());
    EXPECT_EQ(master.coordinator.jobs().cluster().alarm_count, 0u);
}

/// A worker's connection that sends many results of an earlier session until it is closed.
struct Pour {
    std::shared_ptr<Channel> channel;
    WorkerId worker;
    bool ended = false;
};

asio::awaitable<void> pour(Master& master, JobId job, Pour& state) {
    const Ending ending{state.ended};
    state.channel = (co_await connect(master.endpoint())).value();
    Hello hello;
    hello.role = Role::Worker;
    hello.name = "impatient";
    hello.instance = 7;
    const Result<Welcome> welcome = co_await greet(state.channel, hello);
    for (std::uint64_t sequence = 1; sequence <= 3 * limits::results_in_hand_max; ++sequence) {
        Results results;
        results.job = job;
        results.sequence = sequence;
        results.records = pack_records({});
        state.channel->send(results);
    }
    state.worker = WorkerId{welcome.value().id};
    for (;;) {
        const Result<Message> message = co_await state.channel->receive(patience);
        if (!message) {
            break;
        }
    }
}

/// The journal or the disk is full, so no result can be acknowledged.
TEST(Server, RepeatedReconnectsDoNotRaiseTheResultsInFlightNorLeak) {
    std::latch released(1);
    Master master({.heartbeat = std::chrono::milliseconds(20),
                   .return_within = std::chrono::milliseconds(0)});
    FakeWorker other(master, {.batches_max = 1});
    Client client(master);
    client.start_submitting(reference().submission());
    // Waits until the job is prepared.
    master.run_until([&] { return client.done && other.batches != 0; });
    for (unsigned thread = 0; thread < master.blocking.size(); ++thread) {
        master.blocking.post([&] { released.wait(); });
    }
    const std::size_t connections = master.server->connections();
    for (int round = 0; round < 2; ++round) {
        Pour connection;
        spawn(master.context.get_executor(), "worker", pour(master, *client.job, connection));
        master.run_until([&] {
            return connection.worker != WorkerId{} &&
                   master.coordinator.workers().intake_of(connection.worker)->messages ==
                       limits::results_in_hand_max;
        });
        hang_up(master, connection.channel, connection.ended);
        master.run_until([&] { return master.server->connections() == connections; });
    }
    released.count_down();
}

/// A master that has the meshes, and no room for more.
struct FullMaster : Master {
    FullMaster() {
        {
            FakeWorker worker(*this, {});
            Client first(*this);
            first.start(reference().submission());
            run_until([&] { return first.done; });
        }
        std::filesystem::rename(directory / "blocks", directory / "away");
    }
    void make_room() const { std::filesystem::rename(directory / "away", directory / "blocks"); }

    [[nodiscard]] static Submit other_submission() {
        Submit submit = reference().submission();
        submit.cluster.set_depth(0, 5); // No blocks of this depth exist.
        return submit;
    }
    /// Waits until the job is paused for lack of room.
    JobStatus wait_until_paused(JobId job) {
        const auto status = [&] { return coordinator.jobs().status(job).value(); };
        run_until([&] { return status().state != JobState::Running || !status().paused.empty(); });
        return status();
    }
};

TEST(Server, ANoRoomRefusalHidesTheMastersPaths) {
    Master master;
    Client client(master);
    const Bytes bytes = reference().a.canonical_bytes();
    const FileSizeLimit full(100);
    client.start_asking({MeshPart{reference().a.hash(), "ball", bytes.size(), 0, bytes}});
    master.run_until([&] { return client.done; });
    const auto* failure = std::get_if<Failure>(&client.answer->value());
    ASSERT_NE(failure, nullptr);
    EXPECT_EQ(failure->code, ErrorCode::Io);
    EXPECT_EQ(failure->detail, "its disk is full or cannot be written; its log says why");
    EXPECT_EQ(failure->detail.find(master.directory.string()), std::string::npos);
}

TEST(Server, AJobWhoseBlocksCannotBeWrittenWaitsAndGoesOnWhenTheyCan) {
    FullMaster master;
    FakeWorker worker(master, {});
    Client client(master);
    client.start(FullMaster::other_submission());
    master.run_until([&] { return client.job.has_value(); });
    const JobStatus status = master.wait_until_paused(*client.job);
    EXPECT_EQ(status.state, JobState::Running) << status.failure;
    EXPECT_NE(status.paused.find("blocks"), std::string::npos) << status.paused;
    const ClusterStatus all = master.coordinator.jobs().cluster();
    EXPECT_TRUE(all.jobs.at(0).paused.empty()) << "it has ended";
    EXPECT_EQ(all.jobs.at(1).paused, status.paused);
    master.make_room();
    master.run_until([&] { return client.done; });
    expect_right(client);
    EXPECT_TRUE(client.statuses.back().paused.empty());
}

TEST(Server, AJobThatWaitsForRoomMayBeCancelledAndTheMasterEnded) {
    FullMaster master;
    {
        Client client(master);
        client.start(FullMaster::other_submission());
        Client left(master);
        left.start_submitting(FullMaster::other_submission());
        master.run_until([&] { return client.job && left.done; });
        EXPECT_EQ(master.wait_until_paused(*client.job).state, JobState::Running);
        EXPECT_EQ(master.wait_until_paused(*left.job).state, JobState::Running);
        Client other(master);
        other.start_asking({Cancel{*client.job, std::nullopt}});
        master.run_until([&] { return client.done && other.done; });
        EXPECT_EQ(client.statuses.back().state, JobState::Cancelled);
        EXPECT_TRUE(client.statuses.back().paused.empty());
    }
    // The master can end without pending work, although a job still waits.
    master.end();
    EXPECT_TRUE(master.context.stopped());
}

/// Stands for a scenario whose check takes hours.
TEST(Server, CancellingADisputedScenarioQuarantinesNoWorker) {
    Master master;
    Client client(master);
    client.start(reference().submission());
    master.run_until(
        [&] { return client.job && master.coordinator.jobs().explainer().input(*client.job); });
    std::latch released(1);
    for (unsigned thread = 0; thread < master.blocking.size(); ++thread) {
        master.blocking.post([&] { released.wait(); }); // Blocks the master's runs.
    }
    auto liar = std::make_unique<FakeWorker>(
        master, FakeWorker::Habits{.lies_second = true, .instance = 7, .batches_max = 1});
    master.run_until([&] { return liar->kept == 2; });
    std::uint64_t cancelled = 0;
    for (const Scenario& scenario : reference().scenarios) {
        if (!master.coordinator.jobs().find(*client.job)->results->has(scenario.index)) {
            continue;
        }
        Client other(master);
        other.start_asking({Cancel{*client.job, scenario.index}});
        master.run_until([&] { return other.done; });
        cancelled += std::holds_alternative<Failure>(other.answer->value()) ? 0 : 1;
    }
    EXPECT_GT(cancelled, 0u);
    released.count_down();
    liar.reset(); // The other worker takes over its remaining work.
    FakeWorker good(master, {});
    master.run_until([&] { return client.done; });
    EXPECT_EQ(client.statuses.back().state, JobState::Done);
    EXPECT_EQ(client.statuses.back().summary.failed, cancelled);
    EXPECT_EQ(client.statuses.back().summary.merged(), reference().scenarios.size());
    EXPECT_EQ(master.coordinator.jobs().cluster().alarm_count, 0u);
}

TEST(Server, ARecordThatTheJournalDoesNotTakeIsAnErrorThatNamesTheLimit) {
    EXPECT_TRUE(check_record_size(3, limits::result_record_bytes_max));
    const Status large = check_record_size(3, limits::result_record_bytes_max + 1);
    ASSERT_FALSE(large);
    EXPECT_EQ(large.error().code, ErrorCode::TooLarge);
    EXPECT_NE(large.error().detail.find("scenario 3 takes 268435457 bytes; at most 268435456"),
              std::string::npos)
        << large.error().detail;
}

TEST(Server, InvalidResultsAndUnknownRootsCutTheWorkerOff) {
    for (const FakeWorker::Habits& habits :
         {FakeWorker::Habits{.sends_rubbish = true}, FakeWorker::Habits{.holds_too_much = true}}) {
        Master master;
        FakeWorker bad(master, habits);
        Client client(master);
        client.start(reference().submission());
        master.run_until([&] { return bad.ended; });
        FakeWorker good(master, {});
        master.run_until([&] { return client.done; });
        expect_right(client);
    }
}

} // namespace
} // namespace cd::tests
