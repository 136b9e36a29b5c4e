// Proves which results are merged, which wait, and when a worker may forget them.
#include "master/results/result_ingest.hpp"

#include "common/job/packed_scenarios.hpp"
#include "common/job/result/packed_map.hpp"
#include "tests/master/parts_stage.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class ResultIngestTest : public PartsStage {
  protected:
    /// Opens a job and waits until the worker has a batch of it.
    WorkUnit open_and_send() {
        open();
        services.work.feed();
        return next<WorkUnit>(worker_);
    }
    [[nodiscard]] static std::vector<std::uint64_t> scenarios_of(const WorkUnit& unit) {
        std::vector<std::uint64_t> indices;
        const auto scenarios = unpack_scenarios(unit.scenarios, 100).value();
        for (const Scenario& scenario : scenarios) {
            indices.push_back(scenario.index);
        }
        return indices;
    }
    /// The right answers to the batch.
    [[nodiscard]] static Results answers(const WorkUnit& unit, std::uint64_t sequence) {
        Results results = right_ones(unit.job, scenarios_of(unit), sequence);
        results.task = unit.task;
        return results;
    }
    /// Right results without a task.
    [[nodiscard]] static Results
    right_ones(JobId job, const std::vector<std::uint64_t>& scenarios, std::uint64_t sequence) {
        ByteWriter records;
        Results results{{}, job, 0, {}, true, {}, 0.25, sequence, {}, {}};
        results.traffic.hits = 1;
        std::vector<ScenarioResult> right;
        for (const std::uint64_t index : scenarios) {
            right.push_back(right_result(index));
            const Bytes record = encode_result(right.back());
            records.put(static_cast<std::uint32_t>(record.size()));
            put_bytes(records, record);
            ++results.count;
        }
        results.records = pack_records(records.bytes());
        results.map = packed_sums(right);
        return results;
    }
    [[nodiscard]] static Results
    late(const MasterJob& job, const ScenarioResult& result, std::uint64_t sequence) {
        Results results = late_results(job.id, result);
        results.sequence = sequence;
        return results;
    }
    void send(Results results) {
        services.ingest.came(worker_, std::move(results), [this] { ++done_; });
    }
    /// Waits until so many messages of the worker are acknowledged.
    void run_until_kept(std::size_t count) {
        run_until([&] { return kept[worker_].size() == count; });
    }

    const WorkerId worker_ = join(70);
    const std::uint64_t touching_ = scenario_with_contact();
    int done_ = 0; ///< Messages after which the worker may send others.
};

TEST_F(ResultIngestTest, AnswersAreAcknowledgedWhenTheyAreDurable) {
    const WorkUnit unit = open_and_send();
    MasterJob& job = state.jobs.at(unit.job);
    send(answers(unit, 1));
    EXPECT_EQ(services.tasks.book().find(worker_, unit.task)->checks, 1u);
    run_until([this] { return done_ == 1; });
    EXPECT_EQ(services.tasks.book().find(worker_, unit.task)->checks, 0u);
    for (const std::uint64_t index : scenarios_of(unit)) {
        EXPECT_EQ(job.merged.author_of(index)->process, 70u);
        EXPECT_FALSE(job.work()->open.has(position_of(job, index)));
    }
    EXPECT_THAT(kept[worker_], IsEmpty()) << "nothing is durable yet";
    run_until_kept(1);
    for (const std::uint64_t index : scenarios_of(unit)) {
        EXPECT_TRUE(job.results->has(index));
    }
    EXPECT_EQ(job.tally.compute_seconds, 0.25);
}

TEST_F(ResultIngestTest, ARepeatedMessageIsAcknowledgedAndItsTrafficCountedOnce) {
    const WorkUnit unit = open_and_send();
    send(answers(unit, 7));
    send(answers(unit, 7));
    run_until_kept(2);
    EXPECT_THAT(kept[worker_], ElementsAre(7, 7));
    EXPECT_EQ(state.jobs.at(unit.job).tally.traffic.blocks.hits, 1u);
    EXPECT_EQ(state.jobs.at(unit.job).run->disputes, 0u);
}

TEST_F(ResultIngestTest, InvalidResultsCutTheWorkerOff) {
    const WorkUnit unit = open_and_send();
    Results results = answers(unit, 1);
    ++results.count; // One more than there are.
    send(std::move(results));
    run_until([this] { return done_ == 1; });
    EXPECT_TRUE(state.workers.find(worker_)->is_cut_off);
    EXPECT_FALSE(state.jobs.at(unit.job).merged.has(scenarios_of(unit).at(0)));
    EXPECT_THAT(kept[worker_], IsEmpty());
    connection_ended(worker_);
}

TEST_F(ResultIngestTest, ResultsOfAnUnknownOrQuarantinedWorkerAreDropped) {
    const MasterJob& job = open();
    services.ingest.came(WorkerId{99}, late(job, right_result(touching_), 3), [this] { ++done_; });
    EXPECT_THAT(kept[WorkerId{99}], ElementsAre(3));
    state.alarms.quarantine(70);
    (void)state.workers.quarantine(70);
    send(late(job, right_result(touching_), 4));
    EXPECT_THAT(kept[worker_], ElementsAre(4));
    EXPECT_EQ(done_, 2);
    EXPECT_EQ(job.merged.summary().merged(), 0u);
    state.dispatch.act(state.dispatch->worker_lost(worker_)); // As its quarantine does.
}

TEST_F(ResultIngestTest, ResultsOfAWorkerInQuarantineSinceTheirCheckAreDropped) {
    const MasterJob& job = open();
    send(late(job, right_result(touching_), 4));
    services.quarantine.impose(*state.workers.find(worker_)->author);
    run_until_kept(1);
    EXPECT_EQ(job.merged.summary().merged(), 0u);
}

TEST_F(ResultIngestTest, LateResultsOfARunningJobAreMerged) {
    const MasterJob& job = open();
    send(late(job, right_result(touching_), 1));
    run_until_kept(1);
    EXPECT_EQ(job.merged.author_of(touching_)->process, 70u);
    EXPECT_TRUE(job.results->has(touching_));
}

TEST_F(ResultIngestTest, IfSomeResultsAreKnownTheMasterMakesTheMapOfTheOthers) {
    Submit submit = submission(AnalysisMode::Always);
    submit.query.maps = true;
    MasterJob& job = open(submit);
    merge(job, right_result(touching_), 71);
    std::uint64_t other = touching_ + 1;
    while (right_result(other).pair_count == 0) {
        ++other;
    }
    const auto map_of = [&](std::vector<std::uint64_t> scenarios) {
        return reference_map(*job.work()->material, *job.run->poses, scenarios).value();
    };
    Results both = right_ones(job.id, {touching_, other}, 1);
    both.map = pack_map(map_of({touching_, other}));
    send(std::move(both));
    run_until_kept(1);
    EXPECT_EQ(job.merged.author_of(other)->process, 70u);
    JobMap total = job.map;
    total.finish();
    EXPECT_EQ(total.packed(), pack_map(map_of({other})));
}

TEST_F(ResultIngestTest, IfSomeResultsAreKnownTheMasterSumsTheListsOfTheOthers) {
    const MasterJob& job = open();
    merge(state.jobs.at(job.id), right_result(touching_), 71);
    std::uint64_t other = touching_ + 1;
    while (right_result(other).pair_count == 0) {
        ++other;
    }
    send(right_ones(job.id, {touching_, other}, 1));
    run_until_kept(1);
    const std::vector<ScenarioResult> rest{right_result(other)};
    EXPECT_EQ(job.map.packed_parts(), packed_sums(rest));
    send(right_ones(job.id, {touching_, other}, 2));
    run_until_kept(2);
    EXPECT_EQ(job.map.packed_parts(), packed_sums(rest)) << "each scenario counts once";
}

TEST_F(ResultIngestTest, ResultsThatComeBeforeTheGeometryWaitForIt) {
    MasterJob& job = begin(submission(AnalysisMode::Always));
    send(late(job, right_result(touching_), 1));
    EXPECT_EQ(done_, 1) << "there is memory for them";
    EXPECT_FALSE(job.merged.has(touching_));
    run_until_kept(1);
    EXPECT_NE(job.work(), nullptr);
    EXPECT_TRUE(job.merged.has(touching_));
}

TEST_F(ResultIngestTest, WaitingResultsOfAWorkerThatHasLeftAreForgotten) {
    MasterJob& job = begin(submission(AnalysisMode::Always));
    send(late(job, right_result(touching_), 1));
    services.ingest.forget(worker_);
    run_until([&] { return job.work() != nullptr; });
    send(late(job, right_result(touching_ + 1), 2));
    run_until_kept(1);
    EXPECT_THAT(kept[worker_], ElementsAre(2));
    EXPECT_FALSE(job.merged.has(touching_));
}

TEST_F(ResultIngestTest, ResultsOfAnEndedJobAreOnlyAcknowledged) {
    MasterJob& job = open();
    services.life.end(job, JobState::Cancelled, "cancelled");
    send(late(job, wrong_result(touching_), 1));
    run_until_kept(1);
    EXPECT_EQ(done_, 1);
    EXPECT_FALSE(job.merged.has(touching_));
    EXPECT_THAT(disputes, IsEmpty());
}

TEST_F(ResultIngestTest, ADifferingResultIsAcknowledgedAfterItsDispute) {
    MasterJob& job = open();
    merge(job, right_result(touching_), 71);
    send(late(job, wrong_result(touching_), 1));
    run_until([this] { return done_ == 1; });
    EXPECT_EQ(job.run->disputes, 1u);
    EXPECT_THAT(kept[worker_], IsEmpty());
    run_until_kept(1);
    EXPECT_EQ(disputes.size(), 1u) << "the dispute is durable";
}

TEST_F(ResultIngestTest, TheLastResultEndsTheJob) {
    MasterJob& job = open();
    for (const Scenario& scenario : reference().scenarios) {
        if (scenario.index != touching_) {
            merge(job, right_result(scenario.index), 71);
        }
    }
    send(late(job, right_result(touching_), 1));
    run_until([&] { return !job.is_running(); });
    EXPECT_EQ(job.end->state, JobState::Done);
    run_until_kept(1);
}

} // namespace
} // namespace cd::tests
