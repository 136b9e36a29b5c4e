// Proves that batches get longer where a worker's threads were idle between them, and only there.
#include "master/dispatch/workers/batch_size.hpp"

#include "common/core/timing/master.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

/// A task of two threads, sent at 0 s, that worked so long.
TaskInFlight task(double busy_seconds, bool fetches = false) {
    TaskInFlight ended;
    ended.busy_seconds = busy_seconds;
    ended.fetches = fetches;
    return ended;
}

double after(const TaskInFlight& ended, bool has_successor) {
    BatchSize size;
    size.judge(ended, has_successor, 2, 1.0);
    return size.seconds();
}

TEST(BatchSize, GrowsByHalfIfTheThreadsWereIdle) {
    EXPECT_DOUBLE_EQ(after(task(1.9), true), 1.5 * timing::batch_seconds_start);
    EXPECT_EQ(after(task(2), true), timing::batch_seconds_start);
}

TEST(BatchSize, IgnoresTheLastBatchAndOneThatWaitedForBlocks) {
    EXPECT_EQ(after(task(1), false), timing::batch_seconds_start);
    EXPECT_EQ(after(task(1, true), true), timing::batch_seconds_start);
    EXPECT_EQ(after(task(0), true), timing::batch_seconds_start);
}

TEST(BatchSize, CountsFromTheEndOfTheTaskBefore) {
    BatchSize size;
    size.judge(task(0), true, 2, 1.0);
    size.judge(task(2), true, 2, 2.0); // One second on two threads, all of it busy.
    EXPECT_EQ(size.seconds(), timing::batch_seconds_start);
}

TEST(BatchSize, MeasuresTheRoundTripOfATaskThatAnIdleWorkerGot) {
    BatchSize size;
    EXPECT_EQ(size.seconds_least(), 0);
    size.judge(task(1.92), false, 2, 1.0);
    EXPECT_NEAR(size.seconds_least(), 0.04, 1e-12);
    TaskInFlight next = task(1.9);
    next.sent = 1.1;
    size.judge(next, true, 2, 2.08);
    EXPECT_NEAR(size.seconds_least(), 0.03, 1e-12);
}

TEST(BatchSize, ATaskThatWaitedForTheOneBeforeTellsNoRoundTrip) {
    BatchSize size;
    size.judge(task(0), true, 2, 2.08);
    TaskInFlight queued = task(1.9);
    queued.sent = 1.5;
    size.judge(queued, true, 2, 3.035); // Only 0.005 s after the work of both.
    EXPECT_EQ(size.seconds_least(), 0);
}

TEST(BatchSize, IsNeverMadeLongForARoundTripAlone) {
    BatchSize size;
    size.judge(task(0.2), false, 2, 1.0);
    EXPECT_EQ(size.seconds_least(), timing::batch_seconds_start);
    BatchSize waits;
    waits.judge(task(0.2, true), false, 2, 1.0);
    EXPECT_EQ(waits.seconds_least(), 0);
    BatchSize fetches;
    fetches.note_blocks(0.5);
    fetches.judge(task(1.9), false, 2, 1.0);
    EXPECT_EQ(fetches.seconds_least(), 0);
}

TEST(BatchSize, HasABound) {
    BatchSize size;
    for (int i = 1; i < 100; ++i) {
        size.judge(task(0.1), true, 2, i);
    }
    EXPECT_EQ(size.seconds(), timing::batch_seconds_max);
}

} // namespace
} // namespace cd::tests
