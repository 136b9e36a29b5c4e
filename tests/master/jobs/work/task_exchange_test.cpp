// Proves what a worker gets with a task, when a task ends, and what happens to its unanswered work.
#include "master/jobs/work/task_exchange.hpp"

#include "tests/master/parts_stage.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class TaskExchangeTest : public PartsStage {
  protected:
    /// Opens a job, and sends the worker its first batches.
    MasterJob& open_and_send() {
        MasterJob& job = open();
        services.work.feed();
        run_until([this] { return !tasks_.book().all().empty(); });
        return job;
    }
    [[nodiscard]] TaskId first_task() { return tasks_.book().all().begin()->first; }
    /// The worker has this range of the job, of 10 positions on a grid.
    TaskId give_range(const MasterJob& job, WorkerId worker, std::uint64_t task) {
        auto content = std::make_shared<TaskContent>();
        content->job = job.id;
        content->range =
            RangeContent{{0, 10},
                         std::make_shared<const PoseWindow>(std::vector(
                             reference().scenarios.begin(), reference().scenarios.begin() + 10)),
                         nullptr};
        Lease lease{worker, std::move(content)};
        lease.places = PlaceRange{0, 10};
        tasks_.book().add(TaskId{task}, std::move(lease));
        return TaskId{task};
    }

    TaskExchange& tasks_ = services.tasks;
    const WorkerId worker_ = join(70);
};

TEST_F(TaskExchangeTest, JobAndTreesGoAheadOfTheFirstBatch) {
    const MasterJob& job = open_and_send();
    const WorkUnit unit = next<WorkUnit>(worker_);
    EXPECT_EQ(unit.job, job.id);
    EXPECT_TRUE(unit.task == first_task());
    const std::vector<Message>& came = ends.at(worker_).came;
    EXPECT_EQ(std::get<AddTree>(came.at(0)).tree, job.work()->trees[0]);
    EXPECT_EQ(std::get<AddTree>(came.at(1)).tree, job.work()->trees[1]);
    EXPECT_EQ(std::get<AddJob>(came.at(2)).job, job.id);
    EXPECT_TRUE(std::holds_alternative<WorkUnit>(came.at(3)));
    EXPECT_EQ(received<AddJob>(worker_).size(), 1u) << "however many batches";
}

TEST_F(TaskExchangeTest, ABatchHasTheRootPairsOfItsScenarios) {
    const MasterJob& job = open_and_send();
    const WorkUnit unit = next<WorkUnit>(worker_);
    const auto scenarios = unpack_scenarios(unit.scenarios, 100).value();
    const auto& content = *tasks_.book().find(unit.task)->content;
    ASSERT_EQ(content.scenarios.size(), scenarios.size());
    ASSERT_EQ(unit.pair_offsets.size(), scenarios.size() + 1);
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        const auto analysis = job.work()->open.find(scenarios[i].index);
        EXPECT_EQ(content.scenarios[i], analysis);
        EXPECT_EQ(std::vector(unit.pairs.begin() + unit.pair_offsets[i],
                              unit.pairs.begin() + unit.pair_offsets[i + 1]),
                  analysis->pairs);
    }
}

TEST_F(TaskExchangeTest, ATaskEndsWhenItsLastResultsAreChecked) {
    const MasterJob& job = open_and_send();
    const TaskId task = first_task();
    tasks_.book().find(task)->checks = 1;
    tasks_.ended(worker_, task);
    EXPECT_NE(tasks_.book().find(task), nullptr);
    for (const auto& analysis : tasks_.book().find(task)->content->scenarios) {
        merge(state.jobs.at(job.id), right_result(analysis->scenario.index), 70);
        state.dispatch.act(
            state.dispatch->scenario_answered(worker_, job.id, analysis->scenario.index));
    }
    tasks_.checked(task);
    EXPECT_EQ(tasks_.book().find(task), nullptr);
    EXPECT_FALSE(state.workers.find(worker_)->is_cut_off);
    tasks_.checked(task); // The task is gone.
}

TEST_F(TaskExchangeTest, AnotherWorkerCannotEndATask) {
    const WorkerId other = join(71);
    open_and_send();
    const TaskId task = first_task();
    const WorkerId thief = tasks_.book().find(task)->worker == other ? worker_ : other;
    tasks_.ended(thief, task);
    ASSERT_NE(tasks_.book().find(task), nullptr);
    EXPECT_FALSE(tasks_.book().find(task)->ended);
}

TEST_F(TaskExchangeTest, AWorkerThatEndsATaskUnansweredIsCutOffAndItsWorkIsNotLost) {
    const MasterJob& job = open_and_send();
    const std::uint64_t unanswered = state.dispatch.view().unanswered(job.id);
    tasks_.ended(worker_, first_task());
    EXPECT_TRUE(state.workers.find(worker_)->is_cut_off);
    EXPECT_EQ(state.dispatch.view().worker_status(worker_).working, 0u);
    EXPECT_EQ(state.dispatch.view().unanswered(job.id), unanswered) << "it waits again";
    EXPECT_THAT(performed<ScenariosLost>(), IsEmpty());
    connection_ended(worker_);
}

TEST_F(TaskExchangeTest, ATaskThatIsNotInTheInventoryIsSentAgain) {
    const MasterJob& job = open_and_send();
    const std::uint64_t unanswered = state.dispatch.view().unanswered(job.id);
    const TaskId task = first_task();
    tasks_.compare(worker_, {});
    EXPECT_EQ(tasks_.book().find(task), nullptr);
    EXPECT_FALSE(state.workers.find(worker_)->is_cut_off) << "the task never reached it";
    EXPECT_EQ(state.dispatch.view().unanswered(job.id), unanswered);
    services.work.feed();
    EXPECT_NE(state.dispatch.view().worker_status(worker_).working, 0u);
}

TEST_F(TaskExchangeTest, AWorkerWhoseWorkIsTakenBackGetsNoMore) {
    const MasterJob& job = open_and_send();
    const std::uint64_t unanswered = state.dispatch.view().unanswered(job.id);
    tasks_.take_all_back(worker_);
    services.work.feed();
    EXPECT_THAT(state.dispatch.view().tasks_of(worker_), IsEmpty());
    EXPECT_TRUE(state.dispatch.view().worker_status(worker_).draining);
    EXPECT_EQ(state.dispatch.view().unanswered(job.id), unanswered);
    EXPECT_THAT(performed<ScenariosLost>(), IsEmpty());
}

TEST_F(TaskExchangeTest, AnAnsweredScenarioIsCancelledInCopiesOnly) {
    const MasterJob& job = open(AnalysisMode::Never);
    const WorkerId winner = join(71);
    const TaskId copy = give_range(job, worker_, 1000);
    const TaskId original = give_range(job, winner, 1001);
    tasks_.call_off_copies(job.id, winner, 3);
    tasks_.call_off_copies(job.id, winner, 50); // Not in the range.
    tasks_.call_off_copies(JobId{99}, winner, 4);
    const std::vector<DropScenario> drops = received<DropScenario>(worker_);
    ASSERT_EQ(drops.size(), 1u);
    EXPECT_EQ(drops[0].scenario, 3u);
    EXPECT_EQ(drops[0].task, copy);
    EXPECT_THAT(received<DropScenario>(winner), IsEmpty());
    EXPECT_TRUE(tasks_.book().find(copy)->is_called_off);
    EXPECT_FALSE(tasks_.book().find(original)->is_called_off);
    tasks_.book().take(copy);
    tasks_.book().take(original);
}

TEST_F(TaskExchangeTest, ACancelledScenarioIsDroppedByTheWorkersThatKnowItsJob) {
    const WorkerId late = join(71);
    MasterJob& job = open();
    tasks_.send(SendHint{worker_, job.id, job.work()->trees[0], {0}});
    tasks_.drop(job.id, 5);
    EXPECT_EQ(received<DropScenario>(worker_).at(0).scenario, 5u);
    EXPECT_THAT(received<DropScenario>(late), IsEmpty());
    job.work()->cancelled.push_back(5);
    tasks_.send(SendHint{late, job.id, job.work()->trees[0], {0}});
    EXPECT_EQ(received<DropScenario>(late).at(0).scenario, 5u) << "it knows the job now";
}

} // namespace
} // namespace cd::tests
