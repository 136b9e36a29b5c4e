// Proves which job sends a worker its next task, and that work of another job waits until the
// worker would run dry.
#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

class Filling : public testing::Test, protected DispatchStage {
  protected:
    Filling() { pace.add_scenario(1'000'000); } // 1000 scenarios/s and thread.

    DispatchJob& open_ranked(std::uint64_t id, const JobRank& rank, std::uint64_t positions) {
        const DispatchTree a{TreeId{1}, {100}, {6400}};
        const DispatchTree b{TreeId{2}, {1}, {64}};
        plan.add_tree(a);
        plan.add_tree(b);
        const ClusterOptions options;
        queue.open(JobId{id}, options, {a, b}, make_policy(options, context), rank);
        DispatchJob& job = queue.at(JobId{id});
        job.unsent.add({{0, positions}}, 0);
        return job;
    }
    [[nodiscard]] std::vector<JobId> jobs_of_tasks() const {
        std::vector<JobId> jobs;
        for (const Action& action : actions) {
            if (const auto* sent = std::get_if<SendUnit>(&action)) {
                jobs.push_back(sent->job);
            }
        }
        return jobs;
    }
    /// Answers the worker's oldest task as predicted, and fills the worker.
    void answer(WorkerProxy& proxy) {
        const auto [id, task] = *proxy.tasks.all().begin();
        const double seconds = 1e-9 * static_cast<double>(task.cost_ns);
        (void)tasks.answer(
            queue.at(task.job), {proxy.id(), id, task.job, task.positions, seconds}, actions);
        tasks.end(proxy, id, std::nullopt, actions);
        ranges.forget_totals();
        filler.fill(proxy, actions);
    }
};

using Jobs = std::vector<JobId>;

TEST_F(Filling, AJobAloneHasTwoTasksAtAWorker) {
    WorkerProxy& one = join(1);
    const DispatchJob& job = open_ranked(1, {}, 100'000);
    filler.give_ranges(actions);
    EXPECT_EQ(jobs_of_tasks(), Jobs{job.id});
    one.tasks.remove(last<SendUnit>().task, PositionRange{0, 1}, 0);
    filler.give_ranges(actions);
    EXPECT_EQ(jobs_of_tasks(), (Jobs{job.id, job.id}));
}

TEST_F(Filling, WhileAHigherPriorityHasWorkNothingElseIsSent) {
    WorkerProxy& one = join(1);
    open_ranked(1, {0, ""}, 100'000);
    filler.give_ranges(actions);
    DispatchJob& high = open_ranked(2, {3, ""}, 350);
    actions.clear();
    filler.give_ranges(actions);
    EXPECT_TRUE(actions.empty()); // The task that was sent is a whole batch.
    while (jobs_of_tasks().empty() || jobs_of_tasks().back() == high.id) {
        answer(one);
    }
    // The last ranges are short. The worker has at most two of them at once, and nothing else.
    EXPECT_TRUE(high.unsent.is_empty());
    EXPECT_EQ(jobs_of_tasks().back(), JobId{1});
    EXPECT_GE(jobs_of_tasks().size(), 5u);
}

TEST_F(Filling, AnAnalysedScenarioOfHigherPriorityOvertakesRanges) {
    WorkerProxy& one = join(1);
    open_ranked(1, {0, ""}, 100'000);
    filler.give_ranges(actions);
    DispatchJob& high = open_ranked(2, {1, ""}, 1);
    high.unsent.take_all();
    add(high, 1);
    queue.set_paused(true);
    allocator.settle(actions);
    EXPECT_EQ(one.buffers.count(), 1u); // It waits for the batch to go on.
    actions.clear();
    answer(one);
    ASSERT_FALSE(jobs_of_tasks().empty());
    EXPECT_EQ(jobs_of_tasks().front(), high.id);
}

TEST_F(Filling, TheFirstJobsPausedInputSendsItsBufferAlthoughOtherInputGoesOn) {
    WorkerProxy& one = join(1);
    DispatchJob& low = open_ranked(1, {0, ""}, 1);
    DispatchJob& high = open_ranked(2, {1, ""}, 1);
    low.unsent.take_all();
    high.unsent.take_all();
    queue.set_paused(false); // Scenarios of the other job still come.
    add(high, 1);
    allocator.settle(actions);
    EXPECT_TRUE(jobs_of_tasks().empty());
    EXPECT_FALSE(queue.nothing_comes(high));
    high.input.is_paused = true;
    EXPECT_TRUE(queue.nothing_comes(high));
    EXPECT_FALSE(queue.nothing_comes(low));
    EXPECT_TRUE(filler.is_ripe(one, high));
    allocator.flush_all(actions);
    EXPECT_EQ(jobs_of_tasks(), Jobs{high.id});
}

TEST_F(Filling, OwnersTakeTurnsByTime) {
    WorkerProxy& one = join(1);
    DispatchJob& ann = open_ranked(1, {0, "ann"}, 1'000'000);
    DispatchJob& bob = open_ranked(2, {0, "bob"}, 1'000'000);
    DispatchJob& bob_too = open_ranked(3, {0, "bob"}, 1'000'000);
    bob_too.range_pace.add(one.id(), 100, 1); // 10 ms each instead of 1 ms.
    filler.give_ranges(actions);
    for (int i = 0; i < 400; ++i) {
        answer(one);
    }
    std::map<JobId, double> seconds;
    for (const Action& action : actions) {
        const auto& sent = std::get<SendUnit>(action); // Ranges come without hints.
        seconds[sent.job] +=
            static_cast<double>(sent.positions.count()) * (sent.job == bob_too.id ? 0.01 : 0.001);
    }
    EXPECT_NEAR(seconds[ann.id] / (seconds[bob.id] + seconds[bob_too.id]), 1, 0.05);
    EXPECT_NEAR(seconds[bob.id] / seconds[bob_too.id], 1, 0.05);
}

TEST_F(Filling, IdleThreadsGetWorkOfAnyJob) {
    join(1, 20);
    const DispatchJob& first = open_ranked(1, {1, ""}, 5);
    const DispatchJob& second = open_ranked(2, {0, ""}, 5);
    filler.give_ranges(actions);
    EXPECT_EQ(jobs_of_tasks(), (Jobs{first.id, second.id}));
}

} // namespace
} // namespace cd::tests
