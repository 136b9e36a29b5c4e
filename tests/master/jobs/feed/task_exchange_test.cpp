// Proves what a worker gets with a task, when a task ends, and what happens to its unanswered work.
#include "master/jobs/feed/task_exchange.hpp"

#include "common/job/packed_scenarios.hpp"
#include "tests/master/parts_stage.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class TaskExchangeTest : public PartsStage {
  protected:
    /// Opens a job, and sends the workers their first tasks.
    MasterJob& open_and_send() {
        MasterJob& job = open();
        services.work.feed();
        run_until([this] { return tasks_.book().size() != 0; });
        return job;
    }
    [[nodiscard]] SendUnit first() const { return performed<SendUnit>().at(0); }
    [[nodiscard]] Lease* lease_of(const SendUnit& unit) {
        return tasks_.book().find(unit.worker, unit.task);
    }

    TaskExchange& tasks_ = services.tasks;
    const WorkerId worker_ = join(70);
};

TEST_F(TaskExchangeTest, JobAndTreesGoAheadOfTheFirstBatch) {
    const MasterJob& job = open_and_send();
    const WorkUnit unit = next<WorkUnit>(worker_);
    EXPECT_EQ(unit.job, job.id);
    EXPECT_EQ(unit.task, first().task);
    EXPECT_EQ(unit.results_wait_ms, 50u);
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
    const auto& content = *lease_of(first())->content;
    ASSERT_EQ(content.analyses.size(), scenarios.size());
    ASSERT_EQ(unit.pair_offsets.size(), scenarios.size() + 1);
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        const auto analysis = job.work()->open.find(position_of(job, scenarios[i].index));
        EXPECT_EQ(content.analyses[i], analysis);
        EXPECT_EQ(std::vector(unit.pairs.begin() + unit.pair_offsets[i],
                              unit.pairs.begin() + unit.pair_offsets[i + 1]),
                  analysis->pairs);
    }
}

TEST_F(TaskExchangeTest, ATaskEndsWhenItsLastResultsAreChecked) {
    const MasterJob& job = open_and_send();
    const SendUnit unit = first();
    lease_of(unit)->checks = 1;
    tasks_.ended(worker_, unit.task);
    ASSERT_NE(lease_of(unit), nullptr);
    const auto content = lease_of(unit)->content;
    for (const auto& analysis : content->analyses) {
        merge(state.jobs.at(job.id), right_result(analysis->scenario.index), 70);
    }
    state.dispatch.act(state.dispatch->answered({worker_, unit.task, job.id, unit.positions}));
    tasks_.checked(worker_, unit.task);
    EXPECT_EQ(lease_of(unit), nullptr);
    EXPECT_FALSE(state.workers.find(worker_)->is_cut_off);
    tasks_.checked(worker_, unit.task); // The task is gone.
}

TEST_F(TaskExchangeTest, AnotherWorkerCannotEndATask) {
    const WorkerId other = join(71);
    open_and_send();
    const WorkerId thief = first().worker == other ? worker_ : other;
    tasks_.ended(thief, first().task);
    ASSERT_NE(lease_of(first()), nullptr);
    EXPECT_FALSE(lease_of(first())->ended);
}

TEST_F(TaskExchangeTest, AWorkerThatEndsATaskUnansweredIsCutOffAndItsWorkIsNotLost) {
    const MasterJob& job = open_and_send();
    const std::uint64_t unanswered = state.dispatch.view().unanswered(job.id);
    tasks_.ended(worker_, first().task);
    EXPECT_TRUE(state.workers.find(worker_)->is_cut_off);
    EXPECT_EQ(state.dispatch.view().worker_status(worker_).working, 0u);
    EXPECT_EQ(state.dispatch.view().unanswered(job.id), unanswered) << "it waits again";
    EXPECT_THAT(performed<PositionsLost>(), IsEmpty());
    connection_ended(worker_);
}

TEST_F(TaskExchangeTest, ATaskThatIsNotInTheInventoryIsSentAgain) {
    const MasterJob& job = open_and_send();
    const std::uint64_t unanswered = state.dispatch.view().unanswered(job.id);
    const SendUnit unit = first();
    tasks_.compare(worker_, {});
    EXPECT_EQ(lease_of(unit), nullptr);
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
    EXPECT_THAT(performed<PositionsLost>(), IsEmpty());
}

TEST_F(TaskExchangeTest, ACancelledPositionIsDroppedByItsIndexFromItsTaskAlone) {
    const MasterJob& job = open_and_send();
    const std::uint64_t position = first().positions.list().back();
    tasks_.send(CallOff{worker_, first().task, PositionRange{position, 1}});
    tasks_.send(CallOff{worker_, TaskId{1000}, PositionRange{position, 1}}); // It has ended.
    const std::vector<DropScenario> drops = received<DropScenario>(worker_);
    ASSERT_EQ(drops.size(), 1u);
    EXPECT_EQ(position_of(job, drops[0].scenario), position);
    EXPECT_EQ(drops[0].task, first().task);
}

TEST_F(TaskExchangeTest, PositionsAreAskedBackByTheirIndicesAndQueuedWhenReturned) {
    const MasterJob& job = open_and_send();
    const SendUnit unit = first();
    tasks_.send(AskBack{worker_, unit.task, unit.positions});
    const Recall recall = next<Recall>(worker_);
    EXPECT_EQ(recall.scenarios.size(), unit.positions.count());
    EXPECT_TRUE(std::ranges::is_sorted(recall.scenarios));
    tasks_.recalled(worker_, {unit.task, {recall.scenarios.back(), 1'000'000}, 0});
    EXPECT_EQ(job.tally.help.recalled, 1u);
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
