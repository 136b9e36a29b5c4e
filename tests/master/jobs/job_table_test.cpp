// Proves how many scenarios running jobs may have, which ended jobs are kept, and that a job whose
// end is being announced is always kept.
#include "master/jobs/job_table.hpp"

#include "common/core/limits/master.hpp"

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
    /// Returns the jobs dropped in favour of `id`.
    std::vector<JobId> announce(JobId id) { return board_.announce(*board_.find(id)); }
    std::vector<JobId> end_and_announce(JobId id) {
        end(id);
        return announce(id);
    }

    JobTable board_;
    Clock::time_point now_;
};

TEST_F(Jobs, RunningScenariosAreBounded) {
    open(limits::scenarios_running_max - 10);
    const JobId little = open(4);
    const auto more = board_.next(7);
    EXPECT_EQ(more.error().code, ErrorCode::Refused);
    EXPECT_THAT(more.error().detail, HasSubstr("268435457 scenarios"));
    board_.give_up(board_.next(6).value());
    end(little);
    EXPECT_TRUE(board_.next(7));
}

TEST_F(Jobs, TheOldestEndedJobIsDroppedFirst) {
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
    EXPECT_EQ(board_.find(longest)->state(), JobState::Cancelled);
    EXPECT_THAT(end_and_announce(open(1)), ElementsAre(first));
}

TEST_F(Jobs, CountFromTheirBeginning) {
    const JobId first = board_.next(limits::scenarios_running_max - 5).value();
    EXPECT_FALSE(board_.next(6));
    board_.give_up(first);
    const JobId second = board_.next(limits::scenarios_running_max - 5).value();
    Submit submit;
    submit.scenarios = limits::scenarios_running_max - 5;
    board_.add(MasterJob(second, submit, nullptr, now_));
    EXPECT_FALSE(board_.next(6)) << "once, and not twice";
    EXPECT_TRUE(board_.next(5));
}

TEST_F(Jobs, WithManyResultsAreKeptInFewerNumbers) {
    board_ = JobTable(10);
    const auto end_with = [&](std::uint64_t results) {
        const JobId id = open(100);
        for (std::uint64_t i = 0; i < results; ++i) {
            (void)board_.find(id)->merged.add(i, {}, Sha256{}, nullptr);
        }
        return std::pair(id, end_and_announce(id));
    };
    const auto [first, none] = end_with(5);
    const auto [second, neither] = end_with(5);
    EXPECT_THAT(none, IsEmpty());
    EXPECT_THAT(neither, IsEmpty());
    EXPECT_THAT(end_with(0).second, IsEmpty());
    EXPECT_THAT(end_with(1).second, ElementsAre(first));
    const auto [largest, displaced] = end_with(11);
    EXPECT_THAT(displaced, testing::Contains(second));
    EXPECT_NE(board_.find(largest), nullptr) << "the latest stays";
}

TEST_F(Jobs, OfManyScenariosWithoutResultsDisplaceNobody) {
    const JobId little = open(10);
    EXPECT_THAT(end_and_announce(little), IsEmpty());
    for (int i = 0; i < 3; ++i) {
        EXPECT_THAT(end_and_announce(open(limits::client_scenarios_max)), IsEmpty());
    }
}

TEST_F(Jobs, UnannouncedEndedJobsAreKept) {
    std::vector<JobId> jobs;
    for (std::size_t i = 0; i <= limits::jobs_ended_kept_max; ++i) {
        jobs.push_back(open(1));
        end(jobs.back());
    }
    for (std::size_t i = 1; i < jobs.size(); ++i) {
        ASSERT_THAT(announce(jobs[i]), IsEmpty());
    }
    EXPECT_THAT(announce(jobs[0]), ElementsAre(jobs[1]));
}

TEST_F(Jobs, AreKeptInTheNumberThatIsAskedFor) {
    board_ = JobTable(limits::results_ended_kept_max, parse_retention("1").value());
    const JobId first = open(1);
    const JobId second = open(1);
    EXPECT_THAT(end_and_announce(first), IsEmpty());
    EXPECT_THAT(end_and_announce(second), ElementsAre(first));
    EXPECT_EQ(board_.find(first), nullptr);
    EXPECT_NE(board_.find(second), nullptr);
}

TEST_F(Jobs, AreKeptForTheTimeThatIsAskedFor) {
    board_ = JobTable(limits::results_ended_kept_max, parse_retention("30d").value());
    const JobId running = open(1);
    const JobId ended = open(1);
    EXPECT_THAT(end_and_announce(ended), IsEmpty());
    const std::uint64_t at = board_.find(ended)->end->ended;
    EXPECT_THAT(board_.drop_expired(at + 30 * 86'400), IsEmpty());
    EXPECT_THAT(board_.drop_expired(at + 30 * 86'400 + 1), ElementsAre(ended));
    EXPECT_EQ(board_.find(ended), nullptr);
    EXPECT_NE(board_.find(running), nullptr);
}

} // namespace
} // namespace cd::tests
