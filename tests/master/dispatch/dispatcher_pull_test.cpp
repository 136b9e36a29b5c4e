// Proves that with `best-match-pull` a free worker takes, from the waiting scenarios, the q for
// which it holds most (section 5.1 of the paper).
#include "master/dispatch/dispatcher.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

constexpr JobId job{1};

using Lists = std::vector<std::vector<std::uint64_t>>;

class Pulling : public testing::Test {
  protected:
    void open(std::uint32_t q, bool claim, std::uint32_t v_kb = 1000) {
        ClusterOptions options;
        options.strategy = "best-match-pull";
        options.q = q;
        options.claim = claim;
        options.v_kb = v_kb;
        keep(dispatcher_.job_opened(job, options, {{TreeId{1}, {5, 7, 9, 11}}, {TreeId{2}, {2}}}));
    }
    void join(std::uint64_t worker) { keep(dispatcher_.worker_joined(WorkerId{worker}, {"w", 1})); }
    void feed(std::vector<RootIndex> roots_of_each) {
        for (const RootIndex root : roots_of_each) {
            keep(dispatcher_.scenario_analysed(job, {next_++, {root}, {0}, 400}));
        }
    }
    void pause() { keep(dispatcher_.input_paused()); }
    void finish(std::size_t batch) {
        const SendUnit sent = batches_.at(batch);
        keep(dispatcher_.answered({sent.worker, sent.task, job, sent.positions}));
        keep(dispatcher_.task_ended(sent.worker, sent.task));
    }
    void keep(const Actions& actions) {
        dispatcher_.check_invariants();
        for (const Action& action : actions) {
            if (!std::holds_alternative<PositionsLost>(action)) {
                batches_.push_back(std::get<SendUnit>(action));
            }
        }
    }
    [[nodiscard]] Lists sent() const {
        Lists lists;
        for (const SendUnit& batch : batches_) {
            lists.push_back(batch.positions.list());
        }
        return lists;
    }

    Dispatcher dispatcher_;
    std::vector<SendUnit> batches_;
    std::uint64_t next_ = 0;
};

TEST_F(Pulling, AFreeWorkerGetsTheMostSimilarWaitingScenarios) {
    open(2, true);
    feed({1, 1, 3, 0, 3, 2, 1, 3, 1, 0});
    pause();
    join(1); // The worker holds nothing, so it takes the first two.
    ASSERT_EQ(sent(), (Lists{{0, 1}}));
    finish(0); // Root 1 gives 7 triangles and B's 2, against B's 2 alone.
    ASSERT_EQ(sent(), (Lists{{0, 1}, {6, 8}}));
    finish(1); // No waiting scenario needs root 1.
    ASSERT_EQ(sent(), (Lists{{0, 1}, {6, 8}, {2, 3}}));
    finish(2); // Roots 3 and 0: 11 triangles win over 5.
    ASSERT_EQ(sent(), (Lists{{0, 1}, {6, 8}, {2, 3}, {4, 7}}));
    finish(3);
    ASSERT_EQ(sent().back(), (std::vector<std::uint64_t>{5, 9}));
}

TEST_F(Pulling, EachWorkerGathersItsOwnScenarios) {
    open(1, true);
    join(1);
    join(2);
    feed({1, 3});
    ASSERT_EQ(sent(), (Lists{{0}, {1}}));
    feed({3, 1, 3, 1});
    finish(0);
    finish(1);
    ASSERT_EQ(sent(), (Lists{{0}, {1}, {3}, {2}}));
    EXPECT_EQ(batches_[2].worker, WorkerId{1});
    EXPECT_EQ(batches_[3].worker, WorkerId{2});
}

TEST_F(Pulling, APartialTaskIsSentOnlyWhenNothingMoreComes) {
    open(3, false);
    join(1);
    feed({0, 0});
    EXPECT_EQ(sent(), Lists{});
    EXPECT_EQ(dispatcher_.unsent(), 2u);
    pause();
    EXPECT_EQ(sent(), (Lists{{0, 1}}));
    EXPECT_EQ(dispatcher_.unsent(), 0u);
}

TEST_F(Pulling, WithoutClaimingTheNextTaskStandsAtTheWorkerBeforeItIsDone) {
    open(2, false);
    join(1);
    feed({0, 1, 2, 3, 0, 1});
    EXPECT_EQ(sent(), (Lists{{0, 1}, {2, 3}}));
    finish(0);
    EXPECT_EQ(sent(), (Lists{{0, 1}, {2, 3}, {4, 5}}));
}

TEST_F(Pulling, ATaskEndsWithTheScenarioThatMakesItMoreThanV) {
    open(100, true, 1); // Scenarios have 400 bytes: three exceed 1 kB.
    feed({0, 0, 0, 0, 0});
    pause();
    join(1);
    EXPECT_EQ(sent(), (Lists{{0, 1, 2}}));
}

TEST_F(Pulling, ScenariosOfALostWorkerGoToTheNext) {
    open(2, true);
    join(1);
    feed({0, 1, 2});
    keep(dispatcher_.worker_lost(WorkerId{1}));
    EXPECT_EQ(dispatcher_.unsent(), 3u);
    join(2);
    EXPECT_EQ(sent(), (Lists{{0, 1}, {0, 1}}));
}

} // namespace
} // namespace cd::tests
