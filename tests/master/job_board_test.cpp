// Proves how many scenarios may be of jobs that run, which jobs that have ended are kept, and that
// the one whose end is being told is always among them.
#include "master/job_board.hpp"

#include "common/core/limits.hpp"
#include "common/core/limits_master.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Jobs : public testing::Test {
  protected:
    JobId open(std::uint64_t scenarios) {
        const JobId id = board_.next(scenarios).value();
        Submit submit;
        submit.scenarios = scenarios;
        board_.add(MasterJob(id, submit, nullptr, now_));
        return id;
    }
    void end(JobId id) {
        now_ += 1s;
        board_.end(*board_.find(id), JobState::Cancelled, "", now_);
    }
    /// Those that are dropped for it.
    std::vector<JobId> announce(JobId id) { return board_.announce(*board_.find(id)); }
    std::vector<JobId> end_and_announce(JobId id) {
        end(id);
        return announce(id);
    }

    JobBoard board_;
    Clock::time_point now_;
};

TEST_F(Jobs, OfSoManyScenariosRunAtATime) {
    open(limits::scenarios_running_max - 10);
    const JobId little = open(4);
    const auto more = board_.next(7);
    EXPECT_EQ(more.error().code, ErrorCode::Refused);
    EXPECT_THAT(more.error().detail, HasSubstr("268435457 scenarios"));
    EXPECT_TRUE(board_.next(6));
    end(little);
    EXPECT_TRUE(board_.next(7));
}

TEST_F(Jobs, ThatEndedFirstAreDroppedFirst) {
    const JobId longest = open(1);
    const JobId first = open(1);
    const JobId second = open(1);
    EXPECT_THAT(end_and_announce(second), IsEmpty());
    EXPECT_THAT(end_and_announce(first), IsEmpty());
    for (std::size_t i = 2; i < limits::jobs_ended_kept_max; ++i) {
        ASSERT_THAT(end_and_announce(open(1)), IsEmpty());
    }
    EXPECT_THAT(end_and_announce(longest), ElementsAre(second)) << "it has just come to its end";
    ASSERT_NE(board_.find(longest), nullptr);
    EXPECT_EQ(board_.find(longest)->state, JobState::Cancelled);
    EXPECT_THAT(end_and_announce(open(1)), ElementsAre(first));
}

TEST_F(Jobs, WithManyScenariosAreKeptInFewerNumbers) {
    const std::uint64_t half = limits::scenarios_ended_kept_max / 2;
    const JobId first = open(half);
    const JobId second = open(half);
    EXPECT_THAT(end_and_announce(first), IsEmpty());
    EXPECT_THAT(end_and_announce(second), IsEmpty());
    EXPECT_THAT(end_and_announce(open(1)), ElementsAre(first));
    const JobId largest = open(limits::scenarios_ended_kept_max + 1);
    EXPECT_THAT(end_and_announce(largest), testing::SizeIs(2));
    EXPECT_NE(board_.find(largest), nullptr) << "the latest stays";
}

TEST_F(Jobs, WhoseEndIsNotToldAreNotDropped) {
    const JobId silent = open(limits::scenarios_ended_kept_max);
    const JobId told = open(limits::scenarios_ended_kept_max);
    end(silent);
    EXPECT_THAT(end_and_announce(told), IsEmpty());
    EXPECT_THAT(announce(silent), ElementsAre(told));
}

} // namespace
} // namespace cd::tests
