// Proves what is told of a scenario while its job is prepared, runs, and has ended.
#include "master/coordinator/explainer.hpp"

#include "master/dispatch/dispatcher.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using testing::HasSubstr;

constexpr JobId job{1};

class Explanations : public testing::Test {
  protected:
    Explanations() {
        Submit submit;
        submit.scenarios = 3;
        board_.add(MasterJob(job, submit, nullptr, {}));
    }
    void start() {
        board_.find(job)->run->work = std::make_unique<JobWork>();
        (void)dispatcher_.job_opened(job,
                                     board_.at(job).submit.cluster,
                                     {{TreeId{1}, {100}, {6400}}, {TreeId{2}, {1}, {64}}});
    }
    void answer(std::uint64_t scenario, WorkerId worker) {
        const auto author = std::make_shared<const Author>(Author{7, worker, "sim", {}});
        (void)board_.find(job)->merged.add(scenario, {}, {}, author);
    }
    static Analysis analysed(std::uint64_t scenario) {
        Analysis analysis;
        analysis.scenario.index = scenario;
        analysis.roots_a = {0};
        analysis.roots_b = {0};
        return analysis;
    }

    JobTable board_;
    Dispatcher dispatcher_;
    Explainer explainer_{board_, dispatcher_, [](WorkerId worker) { return worker.value == 1; }};
};

TEST_F(Explanations, AScenarioThatIsNotThereIsNotFound) {
    EXPECT_EQ(explainer_.needed(JobId{2}, 0).error().code, ErrorCode::NotFound);
    EXPECT_EQ(explainer_.explain(JobId{2}, 0, {}).error().code, ErrorCode::NotFound);
    EXPECT_THAT(explainer_.needed(job, 3).error().detail, HasSubstr("scenarios 0 to 2"));
}

TEST_F(Explanations, AJobThatIsBeingPreparedIsRefused) {
    EXPECT_THAT(explainer_.needed(job, 0).error().detail, HasSubstr("being prepared"));
    EXPECT_EQ(explainer_.explain(job, 0, analysed(0)).error().code, ErrorCode::Refused);
}

TEST_F(Explanations, ARunningJobNeedsAnAnalysisAndNamesItsAuthors) {
    start();
    EXPECT_TRUE(explainer_.needed(job, 0).value().has_value());
    EXPECT_EQ(explainer_.explain(job, 0, {}).error().code, ErrorCode::Refused);
    EXPECT_EQ(explainer_.explain(job, 0, analysed(0)).value().scenario, 0u);
    answer(1, WorkerId{1});
    answer(2, WorkerId{2});
    EXPECT_EQ(explainer_.explain(job, 1, analysed(1)).value().where, "answered by sim (w-1)");
    EXPECT_EQ(explainer_.explain(job, 2, analysed(2)).value().where,
              "answered by sim (w-2), which is not here any more");
}

TEST_F(Explanations, AnEndedJobTellsOnlyWhoAnswered) {
    start();
    answer(1, WorkerId{1});
    board_.end(*board_.find(job), JobState::Cancelled, "", {});
    EXPECT_FALSE(explainer_.needed(job, 1).value());
    EXPECT_EQ(explainer_.explain(job, 0, {}).value().where, "never answered: the job is cancelled");
    const Explained answered = explainer_.explain(job, 1, analysed(1)).value();
    EXPECT_EQ(answered.where, "answered by sim (w-1)");
    EXPECT_TRUE(answered.workers.empty());
}

} // namespace
} // namespace cd::tests
