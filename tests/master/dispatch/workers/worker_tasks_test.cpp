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
    tasks.start(batch, {job, {4, 5, 6}, true, 30, 1.5});
    tasks.start(range, {JobId{2}, {}, false, 100, 2, false, 0, PlaceRange{10, 10}, 10});
    return tasks;
}

TEST(WorkerTasks, AnAnswerLeavesTheTaskAndTheCounts) {
    WorkerTasks tasks = two_tasks();
    EXPECT_EQ(tasks.left(), 13u);
    EXPECT_EQ(tasks.cost_ns(), 130u);
    tasks.answer(batch, 5, 10, true);
    tasks.answer(batch, 4, 10, false);
    EXPECT_EQ(tasks.at(batch).scenarios, std::vector<std::uint64_t>{6});
    EXPECT_EQ(tasks.left(), 11u);
    EXPECT_EQ(tasks.answered(), 1u);
    tasks.answer_places(range, 4);
    EXPECT_EQ(tasks.at(range).places_left, 6u);
    EXPECT_EQ(tasks.cost_ns(), 10u + 60u);
    EXPECT_EQ(tasks.answered(), 5u);
}

TEST(WorkerTasks, AClaimLastsAsLongAsItsTask) {
    WorkerTasks tasks = two_tasks();
    EXPECT_TRUE(tasks.have_claimed());
    EXPECT_EQ(tasks.end(batch).scenarios.size(), 3u);
    EXPECT_FALSE(tasks.have_claimed());
    EXPECT_EQ(tasks.left(), 10u);
    EXPECT_FALSE(tasks.contains(batch));
    EXPECT_EQ(tasks.sent(), 2u);
    EXPECT_EQ(tasks.last_job(), JobId{2});
}

TEST(WorkerTasks, ACutKeepsAtLeastWhatIsAnswered) {
    WorkerTasks tasks = two_tasks();
    tasks.add_copied(range, 5);
    EXPECT_EQ(tasks.cut_places(range, 8), (PlaceRange{18, 2}));
    EXPECT_EQ(tasks.at(range).places_copied, 3u);
    tasks.answer_places(range, 6);
    EXPECT_EQ(tasks.cut_places(range, 0), (PlaceRange{16, 2}));
    EXPECT_EQ(tasks.at(range).left(), 0u);
    EXPECT_EQ(tasks.cut_places(range, 99), (PlaceRange{16, 0}));
}

TEST(WorkerTasks, TasksOfAClosedJobLastWithoutScenarios) {
    WorkerTasks tasks = two_tasks();
    tasks.forget_scenarios(job);
    EXPECT_EQ(tasks.count_of(job), 1u);
    EXPECT_EQ(tasks.at(batch).left(), 0u);
    EXPECT_EQ(tasks.left(), 10u);
    EXPECT_EQ(tasks.cost_ns(), 100u);
}

TEST(WorkerTasks, AnIdleWorkerProgressesWhenItGetsWork) {
    WorkerTasks tasks = two_tasks();
    EXPECT_EQ(tasks.progressed(), 1.5);
    tasks.note_progress(3);
    EXPECT_EQ(tasks.progressed(), 3);
}

} // namespace
} // namespace cd::tests
