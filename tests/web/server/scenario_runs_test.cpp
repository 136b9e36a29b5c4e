// Proves that the page's scenarios are run one at a time, that a bounded number waits, and that one
// run answers all who ask for its scenario.
#include "web/server/scenario_runs.hpp"

#include "common/core/limits/web.hpp"
#include "web/server/page_server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

namespace cd::tests {
namespace {

/// A pool whose functions run when the test says so.
class HeldPool final : public Pool {
  public:
    void post(std::function<void()> function) override { held_.push_back(std::move(function)); }
    [[nodiscard]] unsigned size() const override { return 1; }

    [[nodiscard]] std::size_t held() const { return held_.size(); }
    void run_first() {
        held_.front()();
        held_.pop_front();
    }

  private:
    std::deque<std::function<void()>> held_;
};

class ScenarioRunsTest : public testing::Test {
  protected:
    /// Asks for a scenario of the only job; keeps the answer.
    void ask(std::uint64_t scenario) {
        const auto run = [this, scenario]() -> Result<ScenarioRuns::View> {
            ran_.push_back(scenario);
            auto view = std::make_shared<ScenarioView>();
            view->result.emplace();
            return ScenarioRuns::View(view);
        };
        runs_.ask(
            {"j-1", scenario}, run, [this, scenario](const Result<ScenarioRuns::View>& found) {
                answered_.emplace_back(scenario, found ? 200u : error_answer(found.error()).status);
            });
    }
    /// Runs the first waiting scenario and delivers its answer.
    void run_one() {
        pool_.run_first();
        context_.restart();
        context_.poll();
    }

    asio::io_context context_;
    HeldPool pool_;
    ScenarioRuns runs_{context_.get_executor(), pool_};
    std::vector<std::uint64_t> ran_;
    std::vector<std::pair<std::uint64_t, unsigned>> answered_;
};

using Answers = std::vector<std::pair<std::uint64_t, unsigned>>;

} // namespace

TEST_F(ScenarioRunsTest, OneRunsFourWaitAndTheFifthWaitingIsRefused) {
    static_assert(limits::page_runs_waiting_max == 4);
    for (std::uint64_t scenario = 0; scenario < 6; ++scenario) {
        ask(scenario);
    }
    EXPECT_EQ(answered_, (Answers{{5, 503}}));
    for (std::size_t i = 0; i < 5; ++i) {
        ASSERT_EQ(pool_.held(), 1u);
        run_one();
    }
    EXPECT_EQ(pool_.held(), 0u);
    EXPECT_EQ(answered_, (Answers{{5, 503}, {0, 200}, {1, 200}, {2, 200}, {3, 200}, {4, 200}}));
    ask(5);
    run_one();
    EXPECT_EQ(answered_.back(), std::pair(std::uint64_t{5}, 200u));
}

TEST_F(ScenarioRunsTest, OneRunAnswersAllWhoAskForItsScenario) {
    ask(7);
    ask(8);
    for (int i = 0; i < 10; ++i) {
        ask(7);
        ask(8);
    }
    run_one();
    run_one();
    EXPECT_THAT(ran_, testing::ElementsAre(7, 8));
    EXPECT_EQ(answered_.size(), 22u);
    ask(7); // It is kept.
    EXPECT_EQ(pool_.held(), 0u);
    EXPECT_EQ(answered_.size(), 23u);
}

} // namespace cd::tests
