// Proves that each position of a job without a result is queued or at the dispatcher: when ranges
// are given, returned or lost, and when results are withdrawn.
#include "master/jobs/feed/range_feed.hpp"

#include "common/job/packed_scenarios.hpp"
#include "tests/master/parts_stage.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class RangeFeedTest : public PartsStage {
  protected:
    /// Opens a job of 90 positions on a grid, where positions equal indices.
    MasterJob& open_grid() {
        Grid grid;
        grid.position = {GridAxis{0, 3, 90}, GridAxis{0, 0, 1}, GridAxis{0, 0, 1}};
        Submit submit = submission(AnalysisMode::Never);
        submit.grid = encode_grid(grid);
        submit.scenarios = grid.count();
        submit.poses.kind = PosesKind::Grid;
        return open(submit, std::make_shared<OrderedPoses>(grid));
    }
    /// The master's state after an answer to a scenario on a grid.
    void answer(MasterJob& job, std::uint64_t index, InstanceId process = 70) {
        ScenarioResult result = right_result(0);
        result.index = index;
        merge(job, std::move(result), process);
        state.dispatch.act(state.dispatch->answered({{}, {}, job.id, PositionRange{index, 1}}));
    }
    /// The worker is lost, and nothing is handed out again.
    void lose(WorkerId worker) {
        services.tasks.book().forget(worker);
        state.dispatch.act(state.dispatch->worker_lost(worker));
    }
    [[nodiscard]] SendUnit last_range() const { return performed<SendUnit>().back(); }
    [[nodiscard]] static std::vector<PositionRange> queued(const MasterJob& job) {
        std::vector<PositionRange> positions;
        for (const PositionQueue::Piece& piece : job.work()->todo.pieces()) {
            positions.push_back(piece.positions);
        }
        return positions;
    }

    RangeFeed& ranges_ = services.ranges;
};

TEST_F(RangeFeedTest, PositionsOfAGridAreGivenUntilTheDispatcherHasEnough) {
    MasterJob& job = open_grid();
    ranges_.give(job);
    EXPECT_EQ(job.work()->todo.left(), 90u) << "there is no worker";
    join(70, 4);
    ranges_.give(job);
    EXPECT_EQ(job.work()->todo.left(), 0u);
    ASSERT_FALSE(performed<SendUnit>().empty());
    EXPECT_EQ(performed<SendUnit>()[0].positions.runs().front().first, 0u);
}

TEST_F(RangeFeedTest, PosesOfAListAreLoadedFirst) {
    MasterJob& job = open(AnalysisMode::Never);
    join(70);
    ranges_.give(job);
    EXPECT_EQ(job.work()->positions_loading, 90u);
    EXPECT_THAT(performed<SendUnit>(), IsEmpty());
    run_until([&] { return job.work()->positions_loading == 0; });
    const SendUnit sent = performed<SendUnit>().at(0);
    ASSERT_NE(sent.window, nullptr);
    const PositionRange positions = sent.positions.runs().front();
    EXPECT_EQ(unpack_scenarios(next<WorkUnit>(sent.worker).scenarios, 90).value(),
              job.run->poses->read(positions.first, positions.count).value());
}

TEST_F(RangeFeedTest, PosesThatCannotBeReadAreQueuedAgainAndTheJobWaits) {
    MasterJob& job = open(submission(AnalysisMode::Never), failing_poses());
    join(70);
    ranges_.give(job);
    run_until([&] { return services.life.is_waiting(job.id); });
    EXPECT_EQ(job.work()->todo.left(), 90u);
    EXPECT_EQ(job.work()->positions_loading, 0u);
    EXPECT_EQ(job.run->paused, "the disk is gone");
    run_until([&] { return !performed<SendUnit>().empty(); });
    EXPECT_EQ(job.run->paused, "");
}

TEST_F(RangeFeedTest, AnsweredPositionsAreNotGiven) {
    MasterJob& job = open_grid();
    answer(job, 0);
    answer(job, 2);
    join(70);
    ranges_.give(job);
    EXPECT_EQ(performed<SendUnit>().at(0).positions, (PositionRange{1, 1}));
    EXPECT_EQ(performed<SendUnit>().at(1).positions.runs().front().first, 3u);
}

TEST_F(RangeFeedTest, PositionsThatWereNotSentAreTakenBack) {
    MasterJob& job = open_grid();
    join(70);
    ranges_.give(job);
    const std::uint64_t unsent = state.dispatch.view().positions_unsent(job.id);
    ASSERT_NE(unsent, 0u);
    ranges_.take_back(job);
    EXPECT_EQ(job.work()->todo.left(), unsent);
    EXPECT_EQ(state.dispatch.view().positions_unsent(job.id), 0u);
    ranges_.take_back(job); // Nothing is left.
    EXPECT_EQ(job.work()->todo.left(), unsent);
}

TEST_F(RangeFeedTest, UnansweredPositionsOfALostWorkerAreQueuedWithTheirLoss) {
    MasterJob& job = open_grid();
    const WorkerId worker = join(70, 90); // Gets all positions at once.
    ranges_.give(job);
    ASSERT_EQ(last_range().positions, (PositionRange{0, 90}));
    answer(job, 0);
    answer(job, 40);
    lose(worker);
    EXPECT_EQ(job.work()->todo.left(), 88u);
    for (const PositionQueue::Piece& piece : job.work()->todo.pieces()) {
        EXPECT_EQ(piece.losses.count(), 1u);
    }
    EXPECT_TRUE(state.dispatch.view().unanalysed(job.id).is_empty());
}

TEST_F(RangeFeedTest, ReturnedPositionsGoOutAgainWithoutALoss) {
    MasterJob& job = open_grid();
    const WorkerId worker = join(70, 90);
    ranges_.give(job);
    const TaskId first = last_range().task;
    services.tasks.recalled(worker, Recalled{first, {}, 60});
    EXPECT_EQ(job.tally.help.recalled, 30u);
    EXPECT_EQ(job.work()->todo.left(), 0u);
    EXPECT_EQ(last_range().positions, (PositionRange{60, 30}));
    EXPECT_THAT(performed<PositionsLost>(), IsEmpty());
    // The worker has returned 70 already. Now it also returns 3 and 50, which are in the middle of
    // its first range.
    services.tasks.recalled(worker, Recalled{first, {3, 50, 70}, 60});
    EXPECT_EQ(job.tally.help.recalled, 32u);
}

TEST_F(RangeFeedTest, WithdrawnScenariosAreQueuedOnce) {
    MasterJob& job = open_grid();
    (void)job.work()->todo.take(80); // As if a worker had answered them.
    for (std::uint64_t index = 0; index < 80; ++index) {
        answer(job, index);
    }
    for (const std::uint64_t index : {4, 5, 7}) {
        job.merged.withdraw_one(index);
    }
    ranges_.give_again(job, {7, 4, 5, 80, 81}); // The last are in the queue.
    EXPECT_THAT(queued(job),
                ElementsAre(PositionRange{7, 1}, PositionRange{4, 2}, PositionRange{80, 10}));
    ranges_.give_again(job, {4, 5});
    EXPECT_EQ(job.work()->todo.left(), 13u);
}

TEST_F(RangeFeedTest, WithdrawnScenariosOfAListAreQueuedByTheirPositions) {
    MasterJob& job = open(AnalysisMode::Never);
    (void)job.work()->todo.take(90);
    for (const Scenario& scenario : reference().scenarios) {
        merge(job, right_result(scenario.index), 70);
    }
    job.merged.withdraw_one(11);
    ranges_.give_again(job, {11});
    EXPECT_EQ(job.work()->positions_loading, 1u);
    run_until([&] { return job.work()->positions_loading == 0; });
    EXPECT_THAT(queued(job), ElementsAre(PositionRange{position_of(job, 11), 1}));
}

} // namespace
} // namespace cd::tests
