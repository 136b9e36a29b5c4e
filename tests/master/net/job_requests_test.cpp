// Proves that a request about a job returns when what it did is durable.
#include "master/net/job_requests.hpp"

#include "tests/master/fake_client.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

class Requests : public testing::Test {
  protected:
    template <class Answer>
    static asio::awaitable<void> keep(asio::awaitable<Answer> request,
                                      std::optional<Answer>& answer) {
        answer.emplace(co_await std::move(request));
    }
    template <class Answer>
    Answer run(asio::awaitable<Answer> request) {
        std::optional<Answer> answer;
        spawn(master_.context.get_executor(), "request", keep(std::move(request), answer));
        master_.run_until([&] { return answer.has_value(); });
        return std::move(*answer);
    }
    /// A job whose meshes are missing, so that it waits for them.
    JobId open() {
        Submit submit = reference().submission();
        Grid grid;
        submit.scenarios = grid.count();
        submit.grid = encode_grid(grid);
        return run(requests_.open(std::move(submit), nullptr)).value();
    }

    Master master_;
    JobRequests requests_{master_.coordinator};
};

TEST_F(Requests, AnOpenedJobIsInTheJournal) {
    const JobId job = open();
    EXPECT_EQ(master_.journal->job(job).value().submit.name, "test");
    EXPECT_EQ(master_.coordinator.jobs().status(job).value().state, JobState::Running);
}

TEST_F(Requests, ANewPriorityIsInTheJournal) {
    const JobId job = open();
    EXPECT_EQ(run(requests_.set_priority(job, -7)).value().turn.priority, -7);
    EXPECT_EQ(master_.journal->job(job).value().submit.priority, -7);
}

TEST_F(Requests, ACancelledJobHasEndedAndStaysSo) {
    const JobId job = open();
    EXPECT_EQ(run(requests_.cancel(job)).value().state, JobState::Cancelled);
    EXPECT_EQ(run(requests_.cancel(job)).value().state, JobState::Cancelled);
    EXPECT_EQ(run(requests_.cancel_scenario(job, 0)).error().code, ErrorCode::Refused);
    EXPECT_THAT(run(requests_.explain(job, 0)).value().where, testing::HasSubstr("never answered"));
}

TEST_F(Requests, ACancelledScenarioIsFailedAndEndsTheJobIfItIsTheLast) {
    const JobId job = open();
    EXPECT_EQ(run(requests_.cancel_scenario(job, 1)).error().code, ErrorCode::NotFound);
    EXPECT_EQ(run(requests_.explain(job, 0)).error().code, ErrorCode::Refused)
        << "it is being prepared";
    EXPECT_EQ(run(requests_.cancel_scenario(job, 0)).value().summary.failed, 1u);
    master_.run_until(
        [&] { return master_.coordinator.jobs().status(job).value().state == JobState::Done; });
}

TEST_F(Requests, AnUnknownJobIsNotFound) {
    EXPECT_EQ(run(requests_.cancel(JobId{9})).error().code, ErrorCode::NotFound);
    EXPECT_EQ(run(requests_.set_priority(JobId{9}, 1)).error().code, ErrorCode::NotFound);
    EXPECT_EQ(run(requests_.cancel_scenario(JobId{9}, 0)).error().code, ErrorCode::NotFound);
    EXPECT_EQ(run(requests_.explain(JobId{9}, 0)).error().code, ErrorCode::NotFound);
}

} // namespace
} // namespace cd::tests
