// Proves that each position of a job without a result is queued, at the dispatcher or in a task:
// when ranges are given, ended, returned or lost, and when results are withdrawn.
#include "master/jobs/work/range_feed.hpp"

#include "tests/master/parts_stage.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class RangeFeedTest : public PartsStage {
  protected:
    /// Opens a job of 90 places on a grid, where positions equal indices.
    MasterJob& open_grid() {
        Grid grid;
        grid.position = {GridAxis{0, 3, 90}, GridAxis{0, 0, 1}, GridAxis{0, 0, 1}};
        Submit submit = submission(AnalysisMode::Never);
        submit.grid = encode_grid(grid);
        submit.scenarios = grid.count();
        submit.poses.kind = PosesKind::Grid;
        return open(submit, make_grid_source(grid));
    }
    void answer(MasterJob& job, std::uint64_t index, InstanceId process = 70) {
        ScenarioResult result = right_result(0);
        result.index = index;
        merge(job, std::move(result), process);
    }
    /// The dispatcher loses the worker; nothing is handed out again.
    void lose(WorkerId worker) { state.dispatch.act(state.dispatch->worker_lost(worker)); }
    [[nodiscard]] SendRange last_range() const { return performed<SendRange>().back(); }
    [[nodiscard]] static std::vector<PlaceRange> queued(const MasterJob& job) {
        std::vector<PlaceRange> places;
        for (const PlaceQueue::Piece& piece : job.work()->todo.pieces()) {
            places.push_back(piece.places);
        }
        return places;
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
    ASSERT_FALSE(performed<SendRange>().empty());
    EXPECT_EQ(performed<SendRange>()[0].places.first, 0u);
}

TEST_F(RangeFeedTest, PosesOfAListAreLoadedFirst) {
    MasterJob& job = open(AnalysisMode::Never);
    join(70);
    ranges_.give(job);
    EXPECT_EQ(job.work()->places_loading, 90u);
    EXPECT_THAT(performed<SendRange>(), IsEmpty());
    run_until([&] { return job.work()->places_loading == 0; });
    const SendRange sent = performed<SendRange>().at(0);
    const auto window = services.tasks.book().find(sent.task)->content->range->window;
    ASSERT_NE(window, nullptr);
    const std::span<const Scenario> scenarios = window->at(sent.places);
    EXPECT_EQ(unpack_scenarios(next<WorkUnit>(sent.worker).scenarios, 90).value(),
              std::vector(scenarios.begin(), scenarios.end()));
}

TEST_F(RangeFeedTest, PosesThatCannotBeReadAreQueuedAgainAndTheJobWaits) {
    MasterJob& job = open(submission(AnalysisMode::Never), std::make_shared<FailingPoses>(1));
    join(70);
    ranges_.give(job);
    run_until([&] { return services.life.is_waiting(job.id); });
    EXPECT_EQ(job.work()->todo.left(), 90u);
    EXPECT_EQ(job.work()->places_loading, 0u);
    EXPECT_EQ(job.run->paused, "the disk is gone");
    run_until([&] { return !performed<SendRange>().empty(); });
    EXPECT_EQ(job.run->paused, "");
}

TEST_F(RangeFeedTest, AnsweredPositionsAreNotGiven) {
    MasterJob& job = open_grid();
    answer(job, 0);
    answer(job, 2);
    join(70);
    ranges_.give(job);
    EXPECT_EQ(performed<SendRange>().at(0).places, (PlaceRange{1, 1}));
    EXPECT_EQ(performed<SendRange>().at(1).places.first, 3u);
}

TEST_F(RangeFeedTest, PositionsThatWereNotSentAreTakenBack) {
    MasterJob& job = open_grid();
    join(70);
    ranges_.give(job);
    const std::uint64_t unsent = state.dispatch.view().places_unsent(job.id);
    ASSERT_NE(unsent, 0u);
    ranges_.take_back(job);
    EXPECT_EQ(job.work()->todo.left(), unsent);
    EXPECT_EQ(state.dispatch.view().places_unsent(job.id), 0u);
    ranges_.take_back(job); // Nothing is left.
    EXPECT_EQ(job.work()->todo.left(), unsent);
}

TEST_F(RangeFeedTest, UnansweredPositionsOfALostWorkerAreQueuedWithTheirLoss) {
    MasterJob& job = open_grid();
    const WorkerId worker = join(70, 90); // Gets all positions at once.
    ranges_.give(job);
    ASSERT_EQ(last_range().places, (PlaceRange{0, 90}));
    answer(job, 0);
    answer(job, 40);
    lose(worker);
    EXPECT_EQ(job.work()->todo.left(), 88u);
    for (const PlaceQueue::Piece& piece : job.work()->todo.pieces()) {
        EXPECT_EQ(piece.losses.count(), 1u);
    }
    EXPECT_THAT(services.tasks.book().all(), IsEmpty());
}

TEST_F(RangeFeedTest, ALostCopyIsNotQueuedWhileItsOriginalRuns) {
    MasterJob& job = open_grid();
    join(70, 90);
    ranges_.give(job);
    const SendRange original = last_range();
    auto content = services.tasks.book().find(original.task)->content;
    Lease copy{WorkerId{9}, content};
    copy.places = PlaceRange{0, 90};
    services.tasks.book().add(TaskId{1000}, std::move(copy));
    ranges_.ended({TaskId{1000}, job.id, {0, 90}, InstanceId{71}});
    EXPECT_EQ(job.work()->todo.left(), 0u);
    EXPECT_EQ(services.tasks.book().all().size(), 1u);
}

TEST_F(RangeFeedTest, ReturnedPositionsAreQueuedWithoutALoss) {
    MasterJob& job = open_grid();
    const WorkerId worker = join(70, 90);
    ranges_.give(job);
    services.tasks.recalled(worker, Recalled{last_range().task, {}, 60});
    EXPECT_EQ(job.tally.help.recalled, 30u);
    EXPECT_EQ(services.tasks.book().find(last_range().task)->places, (PlaceRange{0, 60}));
    ASSERT_THAT(queued(job), ElementsAre(PlaceRange{60, 30}));
    EXPECT_TRUE(job.work()->todo.front().losses.none());
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
    EXPECT_THAT(queued(job), ElementsAre(PlaceRange{7, 1}, PlaceRange{4, 2}, PlaceRange{80, 10}));
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
    EXPECT_EQ(job.work()->places_loading, 1u);
    run_until([&] { return job.work()->places_loading == 0; });
    const auto window = job.work()->order->window_of(0).value();
    EXPECT_THAT(queued(job), ElementsAre(PlaceRange{window->position_of(11), 1}));
}

} // namespace
} // namespace cd::tests
