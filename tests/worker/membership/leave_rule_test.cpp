// Proves when a worker leaves by itself, with a clock of the test's own.
#include "worker/membership/leave_rule.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

constexpr WorkerMoment idle{true, false, 0};
constexpr WorkerMoment busy{true, true, 0};
constexpr WorkerMoment alone{false, false, 0};
constexpr WorkerMoment alone_with_results{false, true, 0};

/// Observes a worker at chosen times after a start.
class Watched {
  public:
    explicit Watched(const LeaveLimits& limits) : rule_(limits) {}

    /// Lets `time` pass, then observes.
    Leave after(std::chrono::milliseconds time, const WorkerMoment& moment) {
        now_ += time;
        return rule_.observe(moment, now_);
    }

  private:
    LeaveRule rule_;
    LeaveRule::Time now_{1h};
};

constexpr LeaveLimits idle_10{10s, {}};
constexpr LeaveLimits orphaned_10{{}, 10s};
constexpr LeaveLimits both_10{10s, 10s};

TEST(LeaveRule, WithoutLimitsAWorkerStays) {
    EXPECT_TRUE(LeaveRule({}).is_off());
    EXPECT_FALSE(LeaveRule(idle_10).is_off());
    EXPECT_FALSE(LeaveRule(orphaned_10).is_off());
    Watched worker({});
    for (const WorkerMoment& moment : {idle, busy, alone}) {
        EXPECT_EQ(worker.after(1000h, moment), Leave::Not);
        EXPECT_EQ(worker.after(1000h, moment), Leave::Not);
    }
}

TEST(LeaveRule, LeavesAfterTheTimeWithoutWork) {
    Watched worker(idle_10);
    EXPECT_EQ(worker.after(0s, idle), Leave::Not);
    EXPECT_EQ(worker.after(9999ms, idle), Leave::Not);
    EXPECT_EQ(worker.after(1ms, idle), Leave::Idle);
    EXPECT_EQ(worker.after(1s, idle), Leave::Idle) << "it still has no work";
}

TEST(LeaveRule, WorkBeginsTheIdleTimeAnew) {
    Watched worker(idle_10);
    EXPECT_EQ(worker.after(0s, idle), Leave::Not);
    EXPECT_EQ(worker.after(9s, busy), Leave::Not);
    EXPECT_EQ(worker.after(100h, busy), Leave::Not) << "however long it works";
    EXPECT_EQ(worker.after(9s, idle), Leave::Not) << "it worked until now";
    EXPECT_EQ(worker.after(9s, idle), Leave::Not);
    EXPECT_EQ(worker.after(1s, idle), Leave::Idle);
}

TEST(LeaveRule, WorkBetweenTwoObservationsCounts) {
    Watched worker(idle_10);
    EXPECT_EQ(worker.after(0s, {true, false, 5}), Leave::Not);
    EXPECT_EQ(worker.after(9s, {true, false, 6}), Leave::Not);
    EXPECT_EQ(worker.after(9s, {true, false, 6}), Leave::Not);
    EXPECT_EQ(worker.after(20s, {true, false, 7}), Leave::Not);
    EXPECT_EQ(worker.after(10s, {true, false, 7}), Leave::Idle);
}

TEST(LeaveRule, ResultsThatNoMasterHasAcknowledgedAreWork) {
    Watched worker(both_10);
    EXPECT_EQ(worker.after(0s, idle), Leave::Not);
    EXPECT_EQ(worker.after(20s, busy), Leave::Not);
    EXPECT_EQ(worker.after(20s, busy), Leave::Not);
}

TEST(LeaveRule, IdleTimeStandsStillWithoutAMaster) {
    Watched worker(idle_10);
    EXPECT_EQ(worker.after(0s, idle), Leave::Not);
    EXPECT_EQ(worker.after(6s, idle), Leave::Not);
    EXPECT_EQ(worker.after(1s, alone), Leave::Not);
    EXPECT_EQ(worker.after(1000h, alone), Leave::Not);
    EXPECT_EQ(worker.after(1s, idle), Leave::Not);
    EXPECT_EQ(worker.after(3s, idle), Leave::Not);
    EXPECT_EQ(worker.after(1s, idle), Leave::Idle) << "6 s before and 4 s after";
}

TEST(LeaveRule, LeavesAfterTheTimeWithoutAMaster) {
    Watched worker(orphaned_10);
    EXPECT_EQ(worker.after(0s, busy), Leave::Not);
    EXPECT_EQ(worker.after(1h, idle), Leave::Not);
    EXPECT_EQ(worker.after(1s, alone_with_results), Leave::Not);
    EXPECT_EQ(worker.after(9999ms, alone_with_results), Leave::Not);
    EXPECT_EQ(worker.after(1ms, alone_with_results), Leave::Orphaned);
}

TEST(LeaveRule, AMasterThatComesBackBeginsTheTimeAnew) {
    Watched worker(both_10);
    EXPECT_EQ(worker.after(0s, idle), Leave::Not);
    EXPECT_EQ(worker.after(1s, alone), Leave::Not);
    EXPECT_EQ(worker.after(9s, alone), Leave::Not);
    EXPECT_EQ(worker.after(0s, busy), Leave::Not);
    EXPECT_EQ(worker.after(1s, alone), Leave::Not);
    EXPECT_EQ(worker.after(9s, alone), Leave::Not);
    EXPECT_EQ(worker.after(1s, alone), Leave::Orphaned);
}

TEST(LeaveRule, BeforeTheFirstMasterNothingIsCounted) {
    Watched worker(both_10);
    EXPECT_EQ(worker.after(0s, alone), Leave::Not);
    EXPECT_EQ(worker.after(1000h, alone), Leave::Not) << "--connect-for applies";
    EXPECT_EQ(worker.after(0s, idle), Leave::Not);
    EXPECT_EQ(worker.after(9s, idle), Leave::Not);
    EXPECT_EQ(worker.after(1s, idle), Leave::Idle);
}

} // namespace
} // namespace cd::tests
