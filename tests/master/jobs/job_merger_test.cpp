// Proves which results enter a job and its journal, and which open a dispute.
#include "master/jobs/job_merger.hpp"

#include "common/job/run_scenario.hpp"
#include "tests/master/parts_stage.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class JobMergerTest : public PartsStage {
  protected:
    MasterJob& job_ = open();
    const std::uint64_t touching_ = scenario_with_contact();
};

TEST_F(JobMergerTest, AnAnswerClosesItsAnalysisAndIsWritten) {
    Analysis analysis;
    analysis.scenario.index = touching_;
    analysis.position = position_of(job_, touching_);
    job_.work()->open.add(std::move(analysis));
    const std::uint64_t changes = job_.changes;
    merge(job_, right_result(touching_), 70);
    EXPECT_EQ(job_.work()->open.size(), 0u);
    EXPECT_EQ(job_.merged.author_of(touching_)->process, 70u);
    EXPECT_EQ(job_.changes, changes + 1);
    run_until_committed(job_);
    EXPECT_TRUE(job_.results->has(touching_));
}

TEST_F(JobMergerTest, ARepeatedResultChangesNothing) {
    merge(job_, right_result(touching_), 70);
    const std::uint64_t changes = job_.changes;
    merge(job_, right_result(touching_), 71);
    EXPECT_EQ(job_.changes, changes);
    EXPECT_EQ(job_.run->disputes, 0u);
    EXPECT_EQ(job_.merged.author_of(touching_)->process, 70u);
}

TEST_F(JobMergerTest, OfAMessageOnlyNewResultsAreWritten) {
    ScenarioResult other = right_result(touching_);
    other.index = touching_ == 0 ? 1 : 0;
    merge(job_, right_result(touching_), 70);
    TakenResults message = taken(right_result(touching_));
    message.add(other, position_of(job_, other.index), {});
    AddResults add{job_.id, job_.results, {}, {}, {}};
    EXPECT_THAT(JobMerger::merge_into(job_, message, author(71), add), IsEmpty());
    ASSERT_EQ(add.results.size(), 1u);
    EXPECT_EQ(add.results.rows()[0].scenario, other.index);
    EXPECT_EQ(add.results.digests()[0], digest_of(other));
    EXPECT_EQ(add.results.record_bytes(), encode_result(other).size());
}

TEST_F(JobMergerTest, ADifferentResultOpensADisputeOnceItIsDurable) {
    merge(job_, wrong_result(touching_), 70);
    merge(job_, right_result(touching_), 71);
    EXPECT_EQ(job_.run->disputes, 1u);
    EXPECT_EQ(job_.merged.author_of(touching_)->process, 70u) << "until it is judged";
    EXPECT_THAT(disputes, IsEmpty()) << "the journal has not committed it";
    run_until([&] { return !disputes.empty(); });
    EXPECT_EQ(disputes.at(0).job, job_.id);
    EXPECT_EQ(disputes.at(0).scenario, touching_);
    EXPECT_EQ(disputes.at(0).second, author(71));
    EXPECT_EQ(disputes.at(0).digest, digest_of(right_result(touching_)));
}

TEST_F(JobMergerTest, TheMastersOwnDifferentResultOpensNoDispute) {
    merge(job_, wrong_result(touching_), 70);
    merge(job_, right_result(touching_), 0);
    EXPECT_EQ(job_.run->disputes, 0u);
    EXPECT_EQ(job_.merged.digest_of(touching_), digest_of(wrong_result(touching_)));
}

TEST_F(JobMergerTest, AFailureOfTheMasterIsNotDisputed) {
    services.merger.fail(job_, placed(job_, touching_), "cancelled");
    EXPECT_TRUE(job_.merged.is_failed_by_master(touching_));
    merge(job_, right_result(touching_), 70);
    EXPECT_EQ(job_.run->disputes, 0u);
    EXPECT_TRUE(job_.merged.is_failed_by_master(touching_));
}

TEST_F(JobMergerTest, AResultOfAScenarioThatTheJobLacksIsDropped) {
    ScenarioResult foreign = right_result(touching_);
    foreign.index = job_.submit.scenarios;
    const std::uint64_t changes = job_.changes;
    merge(job_, foreign, 70);
    EXPECT_EQ(job_.merged.summary().merged(), 0u);
    EXPECT_EQ(job_.changes, changes);
}

TEST_F(JobMergerTest, ARecordThatTheJournalDoesNotTakeFailsTheJob) {
    ScenarioResult sound = right_result(touching_);
    sound.index = touching_ == 0 ? 1 : 0;
    TakenResults message = taken(sound);
    const Bytes large(limits::result_record_bytes_max + 1);
    message.results.add(touching_, {}, large);
    services.merger.merge(job_, std::move(message), author(70));
    ASSERT_FALSE(job_.is_running());
    EXPECT_EQ(job_.merged.summary().merged(), 0u) << "the journal has no result of the message";
    EXPECT_EQ(job_.end->state, JobState::Failed);
    EXPECT_THAT(job_.end->failure, HasSubstr("set limit_pairs"));
}

TEST_F(JobMergerTest, TheFailureOfTheLastScenarioEndsTheJob) {
    for (const Scenario& scenario : reference().scenarios) {
        ASSERT_TRUE(job_.is_running());
        services.merger.fail(job_, placed(job_, scenario.index), "cancelled");
    }
    ASSERT_FALSE(job_.is_running());
    EXPECT_EQ(job_.end->state, JobState::Done);
    EXPECT_EQ(job_.merged.summary().failed, job_.submit.scenarios);
}

} // namespace
} // namespace cd::tests
