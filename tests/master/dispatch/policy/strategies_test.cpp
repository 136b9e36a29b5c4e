// Proves that users know the strategies of the master, that each has its own policy, and that a
// file and a line make another one.
#include "master/dispatch/policy/strategies.hpp"

#include "master/dispatch/dispatcher.hpp"
#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace cd::tests {
namespace {

TEST(Strategies, UsersKnowThoseOfTheMaster) {
    std::vector<std::string_view> names;
    for (const RegisteredStrategy& strategy : registered_strategies()) {
        names.push_back(strategy.name);
        EXPECT_TRUE(is_strategy_name(strategy.name)) << strategy.name;
        EXPECT_TRUE(check_strategy(strategy.name));
    }
    EXPECT_EQ(names, strategy_names());
    ASSERT_NE(find_strategy(ClusterOptions().strategy), nullptr);
}

TEST(Strategies, EachHasItsOwnPolicyAndClaimsIfUsersMayAskForIt) {
    DispatchStage stage;
    std::set<std::string_view> reasons;
    for (const Strategy& strategy : strategies) {
        ClusterOptions options;
        options.strategy = strategy.name;
        options.claim = true;
        const DispatchJob& job = stage.open(reasons.size() + 1, options);
        reasons.insert(job.policy->why());
        EXPECT_EQ(job.policy->claims(job), strategy.uses_q) << strategy.name;
        EXPECT_EQ(job.policy->moves_work(), strategy.name == "earliest-finish");
        EXPECT_EQ(job.policy->workers_pull(), strategy.name == "best-match-pull");
    }
    EXPECT_EQ(reasons.size(), strategies.size());
}

TEST(Strategies, EachSaysWhyNoWorkerIsChosen) {
    DispatchStage stage;
    const WorkerProxy& one = stage.join(1, 8);
    std::set<std::string_view> reasons;
    for (const Strategy& strategy : strategies) {
        const DispatchJob& job = stage.open(strategy.name, 2, stage.queue.jobs().size() + 1);
        reasons.insert(job.policy->why_none());
        // The worker takes scenarios into its buffer unless it pulls them.
        EXPECT_EQ(job.policy->bounds(one, job).buffered == 0, job.policy->workers_pull());
        EXPECT_NE(job.policy->bounds(one, job).batch, 0u);
        EXPECT_NE(job.policy->bounds(one, job).tasks, 0u);
    }
    EXPECT_EQ(reasons.size(), 2u) << "one text for strategies that choose, one for pulling";
}

TEST(Strategies, AnUnknownNameIsRefusedWithTheKnownOnes) {
    const Status unknown = check_strategy("fastest");
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::BadInput);
    EXPECT_THAT(unknown.error().detail, testing::HasSubstr("\"fastest\"; this master has best-m"));
    EXPECT_THAT(unknown.error().detail, testing::HasSubstr(", lowest, "));
}

/// The worker that joined last.
class Newest final : public MatchingPolicy {
  public:
    using MatchingPolicy::MatchingPolicy;

    [[nodiscard]] WorkerProxy* would_choose(const DispatchJob& job,
                                            const DispatchScenario& /*scenario*/) const override {
        WorkerProxy* newest = context().pool.in_order().back();
        return may_take(*newest, job) ? newest : nullptr;
    }
    [[nodiscard]] std::string_view why() const override { return "it joined last"; }
};
constexpr RegisteredStrategy newest_only[] = {{"newest", make_as<Newest>}};

TEST(Strategies, AnotherOneIsAPolicyAndALine) {
    Dispatcher dispatcher({.strategies = newest_only});
    for (const std::uint64_t worker : {1, 2, 3}) {
        (void)dispatcher.worker_joined(WorkerId{worker}, {"w", 1});
    }
    ClusterOptions options;
    options.strategy = "newest";
    options.q = 1;
    (void)dispatcher.job_opened(
        JobId{1}, options, {{TreeId{1}, {1}, {64}}, {TreeId{2}, {1}, {64}}});
    const AnalysedScenario scenario{0, {0}, {0}, 100, 1'000'000};
    EXPECT_EQ(dispatcher.explain(JobId{1}, scenario).why, "it joined last");
    const Actions actions = dispatcher.scenario_analysed(JobId{1}, scenario);
    ASSERT_EQ(actions.size(), 1u);
    EXPECT_EQ(std::get<SendUnit>(actions.front()).worker, WorkerId{3});
    dispatcher.check_invariants();
}

} // namespace
} // namespace cd::tests
