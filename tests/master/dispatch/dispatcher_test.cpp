// Proves the dispatcher's promises, event by event: when buffers are flushed, what claiming does,
// which worker gets which scenario, and what happens to a lost worker's scenarios.
#include "master/dispatch/dispatcher.hpp"

#include "common/core/limits/master.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

constexpr JobId job_1{1};
constexpr JobId job_2{2};
constexpr WorkerId worker_1{1};
constexpr WorkerId worker_2{2};

/// A dispatcher that checks its invariants after each event; records the actions.
class Driver {
  public:
    void join(WorkerId worker, std::uint32_t threads = 1, InstanceId process = 0) {
        keep(dispatcher.worker_joined(worker, {"w", threads, 1, 0, process}));
    }
    void open(JobId job, ClusterOptions options) {
        keep(dispatcher.job_opened(
            job,
            options,
            {{TreeId{10 * job.value}, {5, 7, 9, 11}}, {TreeId{10 * job.value + 1}, {2, 3}}}));
    }
    void feed(JobId job, std::uint64_t first, std::uint64_t count, RootIndex root = 0) {
        for (std::uint64_t index = first; index < first + count; ++index) {
            keep(dispatcher.scenario_analysed(job, {index, {root}, {0}, 100}));
        }
    }
    void pause() { keep(dispatcher.input_paused()); }
    void answer_all(const SendUnit& batch) {
        keep(dispatcher.answered({batch.worker, batch.task, batch.job, batch.positions}));
    }
    /// The worker answers one position, of whatever task.
    void answer(WorkerId worker, std::uint64_t position) {
        keep(dispatcher.answered({worker, {}, job_1, PositionRange{position, 1}}));
    }
    void finish(const SendUnit& batch) {
        answer_all(batch);
        keep(dispatcher.task_ended(batch.worker, batch.task));
    }
    void keep(Actions actions) {
        dispatcher.check_invariants();
        for (Action& action : actions) {
            if (auto* batch = std::get_if<SendUnit>(&action)) {
                batches.push_back(*batch);
            } else if (const auto* told = std::get_if<PositionsLost>(&action)) {
                EXPECT_EQ(told->job, job_1);
                EXPECT_TRUE(told->is_analysed);
                for (const std::uint64_t position : told->positions.list()) {
                    lost.push_back(position);
                }
            } else {
                given_up.push_back(std::get<GiveUp>(action));
            }
        }
    }
    /// Returns the scenarios of the batches since the last call.
    std::vector<std::vector<std::uint64_t>> sent() {
        std::vector<std::vector<std::uint64_t>> lists;
        for (const SendUnit& batch : batches) {
            lists.push_back(batch.positions.list());
        }
        batches.clear();
        return lists;
    }

    Dispatcher dispatcher;
    std::vector<SendUnit> batches;
    std::vector<std::uint64_t> lost;
    std::vector<GiveUp> given_up;
};

using Lists = std::vector<std::vector<std::uint64_t>>;

ClusterOptions options_with(std::uint32_t q, bool claim) {
    ClusterOptions options;
    options.strategy = "best-match";
    options.q = q;
    options.claim = claim;
    return options;
}

TEST(Dispatcher, ABufferIsFlushedAtQ) {
    Driver driver;
    driver.join(worker_1);
    driver.open(job_1, options_with(3, false));
    driver.feed(job_1, 0, 2);
    EXPECT_EQ(driver.sent(), Lists{});
    EXPECT_EQ(driver.dispatcher.unsent(), 2u);
    driver.feed(job_1, 2, 1);
    EXPECT_EQ(driver.sent(), (Lists{{0, 1, 2}}));
    EXPECT_EQ(driver.dispatcher.unsent(), 0u);
}

TEST(Dispatcher, ABufferIsFlushedWhenItHoldsMoreThanV) {
    Driver driver;
    driver.join(worker_1);
    ClusterOptions options = options_with(1000, false);
    options.v_kb = 1; // Each scenario has 100 bytes: ten make 1 kB, the eleventh exceeds it.
    driver.open(job_1, options);
    driver.feed(job_1, 0, 10);
    EXPECT_EQ(driver.sent(), Lists{});
    driver.feed(job_1, 10, 1);
    EXPECT_EQ(driver.sent(), (Lists{{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}}));
}

TEST(Dispatcher, ADryWorkerGetsAPartOfABufferOnlyWhenNothingMoreComes) {
    Driver driver;
    driver.join(worker_1);
    driver.open(job_1, options_with(3, false));
    driver.feed(job_1, 0, 1);
    EXPECT_EQ(driver.sent(), Lists{});
    driver.pause();
    EXPECT_EQ(driver.sent(), (Lists{{0}}));
    // More input may come, so buffers fill again.
    driver.feed(job_1, 1, 1);
    EXPECT_EQ(driver.sent(), Lists{});
}

TEST(Dispatcher, AWorkerWithEnoughToDoDoesNotGetAPart) {
    Driver driver;
    driver.join(worker_1);
    driver.open(job_1, options_with(3, false));
    driver.feed(job_1, 0, 4);
    driver.pause();
    ASSERT_EQ(driver.batches.size(), 1u);
    const SendUnit first = driver.batches[0];
    // After one answer less than a buffer of work is in flight, so the rest is sent.
    driver.answer(worker_1, 0);
    ASSERT_EQ(driver.batches.size(), 2u);
    EXPECT_EQ(driver.batches[1].positions.list(), (std::vector<std::uint64_t>{3}));
}

TEST(Dispatcher, AClaimedWorkerGetsNothingUntilAllResultsOfItsTaskAreBack) {
    Driver driver;
    driver.join(worker_1);
    driver.open(job_1, options_with(2, true));
    driver.feed(job_1, 0, 5);
    ASSERT_EQ(driver.batches.size(), 1u);
    const SendUnit first = driver.batches[0];
    EXPECT_TRUE(driver.dispatcher.worker_status(worker_1).claimed);
    EXPECT_EQ(driver.dispatcher.worker_status(worker_1).buffered, 0u);

    driver.answer_all(first);
    EXPECT_EQ(driver.batches.size(), 1u); // Answered, but the task has not ended.
    driver.keep(driver.dispatcher.task_ended(worker_1, first.task));
    ASSERT_EQ(driver.batches.size(), 2u);
    EXPECT_EQ(driver.batches[1].positions.list(), (std::vector<std::uint64_t>{2, 3}));
}

TEST(Dispatcher, WithoutClaimingTwoTasksStandAtAWorkerAndABufferFillsBehindThem) {
    Driver driver;
    driver.join(worker_1);
    driver.open(job_1, options_with(2, false));
    driver.feed(job_1, 0, 9);
    EXPECT_EQ(driver.batches.size(), 2u);
    const WorkerStatus status = driver.dispatcher.worker_status(worker_1);
    EXPECT_FALSE(status.claimed);
    EXPECT_EQ(status.working, 4u);
    EXPECT_EQ(status.buffered, 2u);
    EXPECT_EQ(driver.dispatcher.unsent(), 5u);

    driver.finish(SendUnit(driver.batches[0]));
    EXPECT_EQ(driver.sent(), (Lists{{0, 1}, {2, 3}, {4, 5}}));
}

TEST(Dispatcher, AWorkerOfManyCoresGetsATaskForEachBufferOfThem) {
    Driver driver;
    driver.join(worker_1, 7);
    driver.open(job_1, options_with(2, false));
    driver.feed(job_1, 0, 100);
    // Four tasks of 2 scenarios for 7 threads, and one task that waits.
    EXPECT_EQ(driver.batches.size(), 5u);
}

TEST(Dispatcher, ScenariosWaitInOrderForTheFirstWorker) {
    Driver driver;
    driver.open(job_1, options_with(2, false));
    driver.feed(job_1, 0, 5);
    driver.pause();
    EXPECT_EQ(driver.dispatcher.unsent(), 5u);
    driver.join(worker_1);
    EXPECT_EQ(driver.sent(), (Lists{{0, 1}, {2, 3}}));
}

TEST(Dispatcher, BestMatchGathersScenariosOfTheSameRoots) {
    Driver driver;
    driver.join(worker_1);
    driver.join(worker_2);
    driver.open(job_1, options_with(4, false));
    driver.feed(job_1, 0, 1, 2); // To the first worker, since no worker holds anything.
    driver.feed(job_1, 1, 1, 3); // Roots of both trees count; root 0 of B also attracts it to the
                                 // first worker.
    driver.feed(job_1, 2, 2, 2);
    EXPECT_EQ(driver.sent(), (Lists{{0, 1, 2, 3}}));
}

TEST(Dispatcher, EvictedRootsDrawNoMore) {
    Driver driver;
    driver.join(worker_1);
    driver.join(worker_2);
    driver.open(job_1, options_with(2, false));
    driver.feed(job_1, 0, 2, 1);
    driver.finish(SendUnit(driver.batches.at(0)));
    EXPECT_EQ(driver.batches.at(0).worker, worker_1);

    driver.feed(job_1, 2, 2, 1);
    driver.finish(SendUnit(driver.batches.at(1)));
    EXPECT_EQ(driver.batches.at(1).worker, worker_1); // The worker holds root 1.

    const std::vector<RootIndex> evicted_a = {0, 1, 2, 3, 99};
    const std::vector<RootIndex> evicted_b = {0, 1};
    driver.keep(driver.dispatcher.roots_evicted(worker_1, TreeId{10}, evicted_a));
    driver.keep(driver.dispatcher.roots_evicted(worker_1, TreeId{11}, evicted_b));
    driver.keep(driver.dispatcher.roots_evicted(worker_1, TreeId{77}, evicted_b));
    driver.feed(job_1, 4, 1, 1);
    driver.feed(job_1, 5, 1, 2);
    driver.pause();
    // As for new workers: the first worker gets the first; the next follows the shared root of B.
    EXPECT_EQ(driver.batches.at(2).worker, worker_1);
    EXPECT_EQ(driver.batches.at(2).positions.list(), (std::vector<std::uint64_t>{4, 5}));
}

TEST(Dispatcher, LowestSpreadsWhatBestMatchWouldGather) {
    Driver driver;
    driver.join(worker_1);
    driver.join(worker_2);
    ClusterOptions options = options_with(8, false);
    options.strategy = "lowest";
    driver.open(job_1, options);
    driver.feed(job_1, 0, 2, 2);
    driver.pause();
    EXPECT_EQ(driver.sent(), (Lists{{0}, {1}}));
}

TEST(Dispatcher, TheScenariosOfALostWorkerGoFirst) {
    Driver driver;
    driver.join(worker_1);
    driver.open(job_1, options_with(2, false));
    driver.feed(job_1, 0, 8); // Two tasks, a buffer of 2, and 2 waiting.
    driver.answer(worker_1, 1);
    driver.sent();
    driver.keep(driver.dispatcher.worker_lost(worker_1));
    EXPECT_EQ(driver.dispatcher.unsent(), 7u);
    driver.pause();
    driver.join(worker_2);
    EXPECT_EQ(driver.sent(), (Lists{{0, 2}, {3, 4}}));
}

TEST(Dispatcher, ADrainingWorkerFinishesItsTasksAndGetsNothingMore) {
    Driver driver;
    driver.join(worker_1);
    driver.join(worker_2);
    driver.open(job_1, options_with(2, true));
    driver.feed(job_1, 0, 3); // A task at the first worker, one scenario in the second's buffer.
    ASSERT_EQ(driver.batches.size(), 1u);
    driver.keep(driver.dispatcher.worker_draining(worker_2));
    EXPECT_EQ(driver.dispatcher.worker_status(worker_2).buffered, 0u);
    driver.pause();
    EXPECT_EQ(driver.batches.size(), 1u);
    driver.finish(SendUnit(driver.batches[0]));
    ASSERT_EQ(driver.batches.size(), 2u);
    EXPECT_EQ(driver.batches[1].worker, worker_1);
    EXPECT_EQ(driver.batches[1].positions.list(), (std::vector<std::uint64_t>{2}));
}

TEST(Dispatcher, ASilentWorkerKeepsItsTasksAndGetsNothingUntilItIsHeard) {
    Driver driver;
    driver.join(worker_1);
    driver.join(worker_2);
    driver.open(job_1, options_with(2, false));
    driver.feed(job_1, 0, 2);
    ASSERT_EQ(driver.batches.size(), 1u);
    const WorkerId holder = driver.batches[0].worker;
    driver.feed(job_1, 2, 1); // Into a buffer.
    driver.keep(driver.dispatcher.worker_silent(holder));
    driver.keep(driver.dispatcher.worker_silent(holder)); // No effect.
    EXPECT_EQ(driver.dispatcher.worker_status(holder).working, 2u);
    EXPECT_EQ(driver.dispatcher.worker_status(holder).buffered, 0u);
    driver.batches.clear();
    driver.feed(job_1, 3, 20);
    driver.pause();
    for (const SendUnit& batch : driver.batches) {
        EXPECT_NE(batch.worker, holder);
    }
    EXPECT_FALSE(driver.batches.empty());
    driver.batches.clear();
    driver.keep(driver.dispatcher.worker_heard(holder));
    ASSERT_FALSE(driver.batches.empty());
    EXPECT_EQ(driver.batches[0].worker, holder);
}

TEST(Dispatcher, ATaskThatNeverCameGoesBackAndIsNoLoss) {
    Driver driver;
    driver.join(worker_1);
    driver.open(job_1, options_with(2, false));
    driver.feed(job_1, 0, 2);
    for (unsigned round = 0; round < 2 * limits::scenario_losses_max; ++round) {
        ASSERT_EQ(driver.batches.size(), 1u) << "it goes out again, and as one task";
        const SendUnit batch = std::exchange(driver.batches, {}).front();
        EXPECT_EQ(batch.positions.list(), (std::vector<std::uint64_t>{0, 1}));
        driver.keep(driver.dispatcher.task_unbegun(batch.worker, batch.task));
        driver.keep(driver.dispatcher.task_unbegun(batch.worker, batch.task)); // No effect.
        driver.pause();
    }
    EXPECT_TRUE(driver.given_up.empty());
}

TEST(Dispatcher, ATaskThatEndsWithoutAllAnswersHasTheRestDoneAgain) {
    Driver driver;
    driver.join(worker_1);
    driver.open(job_1, options_with(3, false));
    driver.feed(job_1, 0, 3);
    driver.pause();
    const SendUnit batch = driver.batches.at(0);
    driver.answer(worker_1, 1);
    driver.sent();
    driver.keep(driver.dispatcher.task_ended(worker_1, batch.task));
    EXPECT_EQ(driver.sent(), (Lists{{0, 2}}));
    // A task ends once.
    driver.keep(driver.dispatcher.task_ended(worker_1, batch.task));
    EXPECT_EQ(driver.sent(), Lists{});
}

TEST(Dispatcher, WorkReturnedByADrainingWorkerIsNotLost) {
    Driver driver;
    driver.open(job_1, options_with(2, false));
    driver.feed(job_1, 0, 2);
    for (std::uint64_t i = 1; i <= 2 * limits::scenario_losses_max; ++i) {
        driver.join(WorkerId{i});
        const SendUnit batch = driver.batches.back();
        EXPECT_EQ(batch.worker, WorkerId{i});
        EXPECT_EQ(batch.positions.list(), (std::vector<std::uint64_t>{0, 1}));
        driver.keep(driver.dispatcher.worker_draining(WorkerId{i}));
        driver.keep(driver.dispatcher.task_ended(WorkerId{i}, batch.task));
        driver.keep(driver.dispatcher.worker_lost(WorkerId{i}));
    }
    EXPECT_TRUE(driver.given_up.empty());
    EXPECT_EQ(driver.dispatcher.unsent(), 2u);
}

TEST(Dispatcher, AProcessThatIsLostAgainIsNoEvidenceAgainstAScenario) {
    Driver driver;
    driver.open(job_1, options_with(1, false));
    driver.feed(job_1, 0, 1);
    driver.pause();
    std::uint64_t sessions = 0;
    const auto lose_with = [&](InstanceId process) {
        driver.join(WorkerId{++sessions}, 1, process);
        ASSERT_EQ(driver.batches.size(), sessions) << "it goes out again";
        driver.keep(driver.dispatcher.worker_lost(WorkerId{sessions}));
    };
    for (std::size_t i = 0; i < limits::losses_again_that_count / 2; ++i) {
        lose_with(70);
        lose_with(71);
        EXPECT_TRUE(driver.given_up.empty()) << "it was with two";
    }
    lose_with(72);
    EXPECT_EQ(driver.given_up, (std::vector<GiveUp>{{job_1, 0}}));
}

TEST(Dispatcher, LossesFromBeforeTheMasterBeganCount) {
    for (std::uint64_t before = 0; before <= limits::scenario_losses_max; ++before) {
        Driver driver;
        driver.open(job_1, options_with(4, false));
        AnalysedScenario scenario{0, {0}, {0}, 100};
        for (InstanceId process = 1; process <= before; ++process) {
            scenario.losses.add(process);
        }
        driver.keep(driver.dispatcher.scenario_analysed(job_1, scenario));
        driver.pause();
        std::uint64_t workers = 0;
        while (driver.given_up.empty() && workers <= limits::scenario_losses_max) {
            const WorkerId worker{++workers};
            driver.join(worker, 1, 100 + workers);
            driver.keep(driver.dispatcher.worker_lost(worker));
        }
        EXPECT_EQ(driver.given_up, (std::vector<GiveUp>{{job_1, 0}}));
        EXPECT_EQ(workers, limits::scenario_losses_max - before);
        EXPECT_EQ(driver.lost,
                  std::vector<std::uint64_t>(workers - std::min(workers, std::uint64_t{1}), 0))
            << "each is told but the last, which gives the scenario up";
    }
}

TEST(Dispatcher, OneDeadlyScenarioIsGivenUpAndItsNeighboursAreNot) {
    constexpr std::uint64_t deadly = 5;
    Driver driver;
    driver.open(job_1, options_with(4, false));
    driver.feed(job_1, 0, 12);
    driver.pause();
    std::uint64_t workers = 0;
    std::uint64_t deaths = 0;
    std::vector<std::uint64_t> answered;
    driver.join(WorkerId{++workers});
    for (std::size_t i = 0; i < driver.batches.size(); ++i) {
        const SendUnit batch = driver.batches[i];
        if (batch.worker != WorkerId{workers}) {
            continue; // The worker is dead.
        }
        if (batch.positions.contains(deadly)) {
            ++deaths;
            driver.keep(driver.dispatcher.worker_lost(batch.worker));
            driver.join(WorkerId{++workers});
            continue;
        }
        const std::vector<std::uint64_t> list = batch.positions.list();
        answered.insert(answered.end(), list.begin(), list.end());
        driver.finish(batch);
    }
    EXPECT_EQ(deaths, limits::scenario_losses_max);
    EXPECT_EQ(driver.given_up, (std::vector<GiveUp>{{job_1, deadly}}));
    std::ranges::sort(answered);
    EXPECT_EQ(answered, (std::vector<std::uint64_t>{0, 1, 2, 3, 4, 6, 7, 8, 9, 10, 11}));
    EXPECT_EQ(driver.dispatcher.unsent(), 0u);
}

TEST(Dispatcher, JobsShareAWorkerInTurns) {
    Driver driver;
    driver.open(job_1, options_with(2, true));
    driver.open(job_2, options_with(2, true));
    driver.feed(job_1, 0, 8);
    driver.feed(job_2, 0, 8);
    driver.join(worker_1);
    for (std::size_t i = 0; i < 6; ++i) {
        ASSERT_GT(driver.batches.size(), i);
        driver.finish(SendUnit(driver.batches[i]));
    }
    for (std::size_t i = 0; i + 1 < 6; ++i) {
        EXPECT_NE(driver.batches[i].job, driver.batches[i + 1].job) << i;
    }
}

TEST(Dispatcher, AClosedJobLeavesNothingBehindAndItsLateResultsAreIgnored) {
    Driver driver;
    driver.join(worker_1);
    driver.open(job_1, options_with(2, true));
    driver.open(job_2, options_with(2, true));
    driver.feed(job_1, 0, 5);
    driver.feed(job_2, 0, 1);
    const SendUnit batch = driver.batches.at(0);
    driver.keep(driver.dispatcher.job_closed(job_1));
    driver.pause();
    EXPECT_EQ(driver.dispatcher.unsent(), 1u);
    EXPECT_EQ(driver.dispatcher.worker_status(worker_1).working, 0u);
    EXPECT_TRUE(driver.dispatcher.worker_status(worker_1).claimed); // It still computes.
    driver.answer_all(batch);
    EXPECT_EQ(driver.batches.size(), 1u);
    driver.keep(driver.dispatcher.task_ended(worker_1, batch.task));
    ASSERT_EQ(driver.batches.size(), 2u);
    EXPECT_EQ(driver.batches[1].job, job_2);
}

TEST(Dispatcher, AnAnswerFromElsewhereTakesTheScenarioFromWhereverItIs) {
    Driver driver;
    driver.join(worker_1);
    driver.open(job_1, options_with(2, true));
    driver.feed(job_1, 0, 4);
    driver.keep(driver.dispatcher.worker_lost(worker_1));
    driver.answer(worker_1, 0); // Waits.
    driver.join(worker_2);
    EXPECT_EQ(driver.batches.at(1).positions.list(), (std::vector<std::uint64_t>{1, 2}));
    driver.answer(worker_1, 2); // Not its own.
    EXPECT_EQ(driver.dispatcher.worker_status(worker_2).working, 1u);
    EXPECT_EQ(driver.dispatcher.worker_status(worker_2).scenarios, 0u);
    driver.answer(worker_1, 2); // No effect.
    EXPECT_EQ(driver.dispatcher.worker_status(worker_2).working, 1u);
}

} // namespace
} // namespace cd::tests
