// Proves that the counts of a worker's tasks follow sending, answers, recalls and ends.
#include "master/dispatch/workers/worker_tasks.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

constexpr JobId job{1};
constexpr TaskId batch{1};
constexpr TaskId range{2};

WorkerTasks two_tasks() {
    WorkerTasks tasks;
    tasks.start(batch, {job, PositionRange{4, 3}, true, true, 30, 1.5});
    tasks.start(range, {JobId{2}, PositionRange{10, 10}, false, false, 100, 2});
    return tasks;
}

TEST(WorkerTasks, RemovedPositionsLeaveTheTaskAndTheCounts) {
    WorkerTasks tasks = two_tasks();
    EXPECT_EQ(tasks.left(), 13u);
    EXPECT_EQ(tasks.cost_ns(), 130u);
    tasks.remove(batch, PositionSet::of({4, 5}), 20);
    EXPECT_EQ(tasks.at(batch).positions, (PositionRange{6, 1}));
    EXPECT_EQ(tasks.left(), 11u);
    tasks.remove(range, PositionRange{12, 4}, 40);
    EXPECT_EQ(tasks.at(range).left(), 6u);
    EXPECT_EQ(tasks.at(range).each_ns(), 10u);
    EXPECT_EQ(tasks.cost_ns(), 10u + 60u);
    EXPECT_EQ(tasks.answered(), 0u);
    EXPECT_EQ(tasks.find(TaskId{3}), nullptr);
}

TEST(WorkerTasks, AClaimLastsAsLongAsItsTask) {
    WorkerTasks tasks = two_tasks();
    EXPECT_TRUE(tasks.have_claimed());
    EXPECT_EQ(tasks.end(batch).left(), 3u);
    EXPECT_FALSE(tasks.have_claimed());
    EXPECT_EQ(tasks.left(), 10u);
    EXPECT_EQ(tasks.find(batch), nullptr);
    EXPECT_EQ(tasks.sent(), 2u);
    EXPECT_EQ(tasks.left_of(JobId{2}), 10u);
    EXPECT_EQ(tasks.left_of(JobId{1}), 0u);
}

TEST(WorkerTasks, CopiedPositionsRemainCopiedAfterOthersAreAnswered) {
    WorkerTasks tasks = two_tasks();
    tasks.add_copy(range, {WorkerId{5}, TaskId{9}}, PositionRange{17, 3});
    tasks.remove(range, PositionRange{10, 2}, 20);
    EXPECT_EQ(tasks.at(range).uncopied(), (PositionRange{12, 5}));
    EXPECT_EQ(tasks.at(range).shared.copies.at(0).worker, WorkerId{5});
    EXPECT_FALSE(tasks.at(range).is_copy());
}

TEST(WorkerTasks, TasksOfAClosedJobLastWithoutPositions) {
    WorkerTasks tasks = two_tasks();
    tasks.forget_positions(job);
    EXPECT_EQ(tasks.count_of(job), 1u);
    EXPECT_EQ(tasks.at(batch).left(), 0u);
    EXPECT_EQ(tasks.left(), 10u);
    EXPECT_EQ(tasks.cost_ns(), 100u);
}

TEST(WorkerTasks, AWorkerProgressesWhenItAnswersOrGetsWorkWhileIdle) {
    WorkerTasks tasks = two_tasks();
    EXPECT_EQ(tasks.progressed(), 1.5);
    tasks.note_answers(2, 3);
    EXPECT_EQ(tasks.progressed(), 3);
    EXPECT_EQ(tasks.answered(), 2u);
}

} // namespace
} // namespace cd::tests
