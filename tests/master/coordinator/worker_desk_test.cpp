// Proves what the master makes of a worker's joining, silence, return and leaving, and of what it
// says of its blocks.
#include "master/coordinator/worker_desk.hpp"

#include "tests/master/parts_stage.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr RootIndex no_root = 1u << 30;

class WorkerDeskTest : public PartsStage {
  protected:
    /// Opens a job and waits until the worker has a batch of it.
    MasterJob& open_and_send(WorkerId worker) {
        MasterJob& job = open();
        services.work.feed();
        next<WorkUnit>(worker);
        return job;
    }
    [[nodiscard]] std::uint64_t working(WorkerId worker) const {
        return state.dispatch.view().worker_status(worker).working;
    }
    [[nodiscard]] bool is_cut_off(WorkerId worker) {
        return state.workers.find(worker)->is_cut_off;
    }
};

TEST_F(WorkerDeskTest, AWorkerThatJoinsIsWatchedAndGetsWork) {
    MasterJob& job = open();
    EXPECT_FALSE(desk.is_watching());
    const WorkerId worker = join(70);
    EXPECT_TRUE(desk.is_watching());
    EXPECT_THAT(state.dispatch.view().workers(), ElementsAre(worker));
    EXPECT_TRUE(job.work()->todo.empty()) << "its scenarios are analysed for the worker";
}

TEST_F(WorkerDeskTest, AProcessInQuarantineJoinsWithoutWork) {
    state.alarms.quarantine(70);
    const WorkerId worker = join(70);
    EXPECT_TRUE(state.workers.find(worker)->is_quarantined);
    EXPECT_THAT(state.dispatch.view().workers(), IsEmpty());
}

TEST_F(WorkerDeskTest, ASilentWorkerGetsWorkWhenItIsHeardAgain) {
    const WorkerId worker = join(70);
    desk.worker_silent(worker);
    open(AnalysisMode::Never);
    services.work.feed();
    EXPECT_EQ(working(worker), 0u);
    desk.worker_heard_again(worker);
    run_until([&] { return working(worker) != 0; });
}

TEST_F(WorkerDeskTest, AWorkerThatReturnsWithoutItsTasksGetsThemAgain) {
    const WorkerId worker = join(70);
    const MasterJob& job = open_and_send(worker);
    const auto tasks = state.dispatch.view().tasks_of(worker);
    const std::uint64_t unanswered = state.dispatch.view().unanswered(job.id);
    resume(worker);
    EXPECT_FALSE(state.workers.find(worker)->is_settled);
    desk.came(worker, Inventory{});
    EXPECT_TRUE(state.workers.find(worker)->is_settled);
    EXPECT_EQ(state.dispatch.view().unanswered(job.id), unanswered);
    EXPECT_THAT(performed<PositionsLost>(), IsEmpty());
    EXPECT_THAT(state.dispatch.view().tasks_of(worker), testing::Not(testing::Contains(tasks[0])));
    EXPECT_NE(working(worker), 0u);
    EXPECT_EQ(received<AddJob>(worker).size(), 1u) << "over its new connection";
}

TEST_F(WorkerDeskTest, AWorkerThatReturnsKeepsTheTasksThatItHas) {
    const WorkerId worker = join(70);
    const MasterJob& job = open_and_send(worker);
    const auto tasks = state.dispatch.view().tasks_of(worker);
    resume(worker);
    Inventory inventory;
    inventory.jobs = {job.id};
    for (const TreeId tree : job.work()->trees) {
        inventory.trees.push_back({tree, {}});
    }
    for (const TaskId task : tasks) {
        inventory.tasks.push_back({task, {}, 0});
    }
    desk.came(worker, inventory);
    const auto now = state.dispatch.view().tasks_of(worker);
    for (const TaskId task : tasks) {
        EXPECT_THAT(now, testing::Contains(task));
    }
    EXPECT_THAT(received<AddJob>(worker), IsEmpty()) << "it has the job";
}

TEST_F(WorkerDeskTest, ADrainingWorkerIsToldAgainWhenItReturns) {
    const WorkerId worker = join(70);
    desk.drain(worker);
    EXPECT_EQ(received<Drain>(worker).size(), 1u);
    resume(worker);
    EXPECT_THAT(received<Drain>(worker), IsEmpty());
    desk.came(worker, Inventory{});
    EXPECT_EQ(received<Drain>(worker).size(), 1u);
}

TEST_F(WorkerDeskTest, AnInventoryWithAnUnknownRootCutsTheWorkerOff) {
    const WorkerId worker = join(70);
    const MasterJob& job = open_and_send(worker);
    resume(worker);
    Inventory inventory;
    inventory.trees = {{job.work()->trees[0], {no_root}}};
    desk.came(worker, inventory);
    EXPECT_TRUE(is_cut_off(worker));
    EXPECT_FALSE(state.workers.find(worker)->is_settled);
}

TEST_F(WorkerDeskTest, AnUnknownRootCutsTheWorkerOff) {
    const WorkerId asker = join(70);
    const WorkerId holder = join(71);
    const MasterJob& job = open();
    const TreeId tree = job.work()->trees[0];
    desk.came(asker, WantSubtrees{TreeId{99}, {no_root}}); // The tree may be gone by now.
    EXPECT_FALSE(is_cut_off(asker));
    desk.came(asker, WantSubtrees{tree, {no_root}});
    EXPECT_TRUE(is_cut_off(asker));
    desk.came(holder, Held{tree, {no_root}});
    EXPECT_TRUE(is_cut_off(holder));
}

TEST_F(WorkerDeskTest, AWorkerGetsTheBlocksThatItWants) {
    const WorkerId worker = join(70);
    const MasterJob& job = open();
    const TreeId tree = job.work()->trees[0];
    desk.came(worker, WantSubtrees{tree, {0}});
    const Subtrees sent = next<Subtrees>(worker);
    EXPECT_EQ(sent.tree, tree);
    ASSERT_EQ(sent.blocks.size(), 1u);
    EXPECT_EQ(sent.blocks[0].root, 0u);
    EXPECT_EQ(desk.work_of(worker).subtrees_sent, 1u);
}

TEST_F(WorkerDeskTest, ATerminatedWorkerIsToldAndItsWorkIsNotLost) {
    const WorkerId worker = join(70);
    const MasterJob& job = open_and_send(worker);
    const std::uint64_t unanswered = state.dispatch.view().unanswered(job.id);
    desk.terminate(worker);
    EXPECT_EQ(working(worker), 0u);
    EXPECT_EQ(state.dispatch.view().unanswered(job.id), unanswered);
    EXPECT_THAT(performed<PositionsLost>(), IsEmpty());
    check_invariants(state, services);
    next<Terminate>(worker);
    connection_ended(worker);
    EXPECT_EQ(state.workers.find(worker), nullptr);
    EXPECT_EQ(state.workers.counts().lost, 0u);
}

TEST_F(WorkerDeskTest, TheWorkOfALostWorkerWaitsAgainAndCountsAsLost) {
    const WorkerId worker = join(70);
    const MasterJob& job = open_and_send(worker);
    const std::uint64_t unanswered = state.dispatch.view().unanswered(job.id);
    lose(worker);
    EXPECT_THAT(state.dispatch.view().workers(), IsEmpty());
    EXPECT_EQ(services.tasks.book().size(), 0u);
    EXPECT_EQ(state.dispatch.view().unanswered(job.id), unanswered);
    EXPECT_FALSE(performed<PositionsLost>().empty());
}

} // namespace
} // namespace cd::tests
