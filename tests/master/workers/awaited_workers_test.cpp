// Proves that after a restart a job waits exactly until all workers that may bring its results have
// reported and these are checked; and never beyond the time limit.
#include "master/workers/awaited_workers.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

constexpr JobId job{3};
constexpr AwaitedWorkers::Time start{std::chrono::seconds(100)};
constexpr AwaitedWorkers::Time latest{std::chrono::seconds(115)};

TEST(AwaitedWorkers, HoldNothingBackWhereNobodyIsAwaited) {
    EXPECT_FALSE(AwaitedWorkers().holds_back(job, start));
    EXPECT_FALSE(AwaitedWorkers({job}, {}, latest).holds_back(job, start));
}

TEST(AwaitedWorkers, HoldTheirJobsBackUntilEachHasToldAll) {
    AwaitedWorkers awaited({job}, {7, 8}, latest);
    EXPECT_FALSE(awaited.holds_back(JobId{4}, start)) << "a job of after the restart";
    awaited.has_told_all(7);
    awaited.has_told_all(9);
    EXPECT_TRUE(awaited.holds_back(job, start));
    awaited.has_told_all(8);
    EXPECT_FALSE(awaited.holds_back(job, start));
}

TEST(AwaitedWorkers, HoldAJobBackWhileItsResultsAreChecked) {
    AwaitedWorkers awaited({job}, {7}, latest);
    awaited.check_begins(job);
    awaited.check_begins(job);
    awaited.check_begins(JobId{4});
    awaited.has_told_all(7);
    awaited.check_ends(job);
    EXPECT_TRUE(awaited.holds_back(job, start));
    awaited.check_ends(job);
    EXPECT_FALSE(awaited.holds_back(job, start));
}

TEST(AwaitedWorkers, HoldNothingBackForLongerThanMayBeWaited) {
    AwaitedWorkers awaited({job}, {7}, latest);
    awaited.check_begins(job);
    EXPECT_TRUE(awaited.holds_back(job, latest - std::chrono::nanoseconds(1)));
    EXPECT_FALSE(awaited.holds_back(job, latest));
}

} // namespace
} // namespace cd::tests
