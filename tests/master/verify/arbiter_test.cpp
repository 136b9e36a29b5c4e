// Proves who is wrong when two results of a scenario differ, and what follows from it.
#include "master/verify/arbiter.hpp"

#include "tests/master/parts_stage.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

Sha256 hash(unsigned char value) {
    Sha256 made;
    made.bytes[0] = static_cast<std::byte>(value);
    return made;
}

/// Whether the first and the second result are wrong, where 1 is right.
std::pair<bool, bool> wrong(std::optional<unsigned char> first, unsigned char second) {
    const auto merged = first ? std::optional(hash(*first)) : std::nullopt;
    const Verdict verdict = judge(merged, hash(second), hash(1));
    return {verdict.first_is_wrong, verdict.second_is_wrong};
}

TEST(Judgement, AResultThatIsNotTheRightOneIsWrong) {
    EXPECT_EQ(wrong(1, 2), std::pair(false, true));
    EXPECT_EQ(wrong(2, 1), std::pair(true, false));
    EXPECT_EQ(wrong(2, 3), std::pair(true, true));
    EXPECT_EQ(wrong(2, 2), std::pair(true, true));
    EXPECT_EQ(wrong(1, 1), std::pair(false, false));
}

TEST(Judgement, WithoutAMergedResultOnlyTheOtherIsJudged) {
    EXPECT_EQ(wrong({}, 1), std::pair(false, false));
    EXPECT_EQ(wrong({}, 2), std::pair(false, true));
}

class ArbiterTest : public PartsStage {
  protected:
    /// Merges two different results of the scenario, from processes 70 and 71.
    Dispute dispute(const ScenarioResult& first, const ScenarioResult& second) {
        merge(job_, first, 70);
        merge(job_, second, 71);
        run_until([this] { return !disputes.empty(); });
        return disputes.at(0);
    }
    void run_until_settled() {
        run_until([this] { return !job_.is_running() || job_.run->disputes == 0; });
    }
    /// A result that is neither right nor equal to `wrong_result`.
    [[nodiscard]] ScenarioResult failed() const {
        ScenarioResult result = wrong_result(index_);
        result.kind = ScenarioClass::Failed;
        result.failure = "too hard for me";
        return result;
    }
    [[nodiscard]] bool is_right() const {
        return job_.merged.has(index_) &&
               job_.merged.digest_of(index_) == digest_of(right_result(index_));
    }

    MasterJob& job_ = open();
    const std::uint64_t index_ = scenario_with_contact();
};

TEST_F(ArbiterTest, AWrongFirstResultIsCorrectedAndItsWorkerQuarantined) {
    services.arbiter.settle(dispute(wrong_result(index_), right_result(index_)));
    run_until_settled();
    EXPECT_TRUE(is_right());
    EXPECT_EQ(job_.merged.author_of(index_), nullptr) << "it is the master's own";
    EXPECT_TRUE(state.alarms.is_quarantined(70));
    EXPECT_FALSE(state.alarms.is_quarantined(71));
    EXPECT_EQ(state.alarms.record().count, 1u);
    EXPECT_THAT(state.alarms.record().last.at(0), HasSubstr("the first one, of w70"));
    run_until_committed(job_);
    EXPECT_FALSE(state.alarms.take_changed()) << "the journal has the alarm";
}

TEST_F(ArbiterTest, ADisputeWaitsForPosesThatCannotBeRead) {
    const Dispute one = dispute(wrong_result(index_), right_result(index_));
    job_.run->poses = failing_poses();
    services.arbiter.settle(one);
    run_until([this] { return !job_.run->paused.empty(); });
    EXPECT_THAT(job_.run->paused, HasSubstr("the disk is gone"));
    EXPECT_EQ(state.alarms.record().count, 0u);
    run_until_settled();
    EXPECT_TRUE(is_right());
    EXPECT_TRUE(state.alarms.is_quarantined(70));
    EXPECT_THAT(job_.run->paused, IsEmpty());
}

TEST_F(ArbiterTest, AWrongSecondResultOnlyQuarantinesItsWorker) {
    services.arbiter.settle(dispute(right_result(index_), wrong_result(index_)));
    run_until_settled();
    EXPECT_TRUE(is_right());
    EXPECT_EQ(job_.merged.author_of(index_)->process, 70u);
    EXPECT_FALSE(state.alarms.is_quarantined(70));
    EXPECT_TRUE(state.alarms.is_quarantined(71));
    EXPECT_EQ(job_.tally.withdrawn, 0u);
}

TEST_F(ArbiterTest, TwoWrongResultsQuarantineBothWorkers) {
    services.arbiter.settle(dispute(wrong_result(index_), failed()));
    run_until_settled();
    EXPECT_TRUE(is_right());
    EXPECT_TRUE(state.alarms.is_quarantined(70));
    EXPECT_TRUE(state.alarms.is_quarantined(71));
    EXPECT_EQ(state.alarms.record().count, 2u);
}

TEST_F(ArbiterTest, AWorkerInQuarantineIsNotReportedAgain) {
    state.alarms.quarantine(71);
    services.arbiter.settle(dispute(right_result(index_), wrong_result(index_)));
    run_until_settled();
    EXPECT_EQ(state.alarms.record().count, 0u);
}

TEST_F(ArbiterTest, AStoppedRunBlamesNobodyAndFailsTheScenario) {
    const auto released = occupy(blocking);
    services.arbiter.settle(dispute(wrong_result(index_), right_result(index_)));
    EXPECT_TRUE(services.references.stop(job_.id, index_));
    released->count_down();
    run_until_settled();
    EXPECT_EQ(state.alarms.record().count, 0u);
    EXPECT_THAT(state.alarms.quarantined(), IsEmpty());
    EXPECT_TRUE(job_.merged.is_failed_by_master(index_));
}

TEST_F(ArbiterTest, TheLastDisputeEndsACompleteJob) {
    for (const Scenario& scenario : reference().scenarios) {
        if (scenario.index != index_) {
            merge(job_, right_result(scenario.index), 71);
        }
    }
    const Dispute last = dispute(right_result(index_), wrong_result(index_));
    services.life.end_if_complete(job_);
    ASSERT_TRUE(job_.is_running());
    // The other results are of the wrong worker, and are withdrawn.
    services.arbiter.settle(last);
    run_until_settled();
    ASSERT_TRUE(job_.is_running());
    EXPECT_EQ(job_.merged.summary().merged(), 1u);
    for (const Scenario& scenario : reference().scenarios) {
        merge(job_, right_result(scenario.index), 72);
    }
    services.life.end_if_complete(job_);
    EXPECT_EQ(job_.end->state, JobState::Done);
}

TEST_F(ArbiterTest, ADisputeOfAnEndedJobIsNotSettled) {
    const Dispute late = dispute(wrong_result(index_), right_result(index_));
    services.life.end(job_, JobState::Cancelled, "cancelled");
    services.arbiter.settle(late);
    EXPECT_FALSE(services.references.stop(job_.id, std::nullopt)) << "there is no run";
    EXPECT_EQ(state.alarms.record().count, 0u);
}

} // namespace
} // namespace cd::tests
