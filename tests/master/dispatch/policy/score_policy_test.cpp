// Proves that each strategy picks the worker the paper prescribes: worked examples on the vectors
// of its Table 1, ties, and the random draw.
#include "master/dispatch/dispatch_parts.hpp"
#include "master/dispatch/policy/best_match_pull.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace cd::tests {
namespace {

/// The two lists of the paper's Table 1: a scenario's roots with their triangles. (The first list's
/// column BB3 is empty in print.)
ScenarioRoots table_1(int scenario) {
    const auto roots = [](std::vector<WeightedRoot> a, std::vector<WeightedRoot> b) {
        return ScenarioRoots{{{TreeId{1}, std::move(a)}, {TreeId{2}, std::move(b)}}};
    };
    switch (scenario) {
    case 1:
        return roots({{4, 1}, {5, 4}}, {{0, 2}, {2, 14}, {3, 6}});
    case 2:
        return roots({{1, 11}, {3, 1}, {4, 1}}, {{0, 2}, {1, 1}, {2, 14}, {3, 6}});
    case 3:
        return roots({{0, 1}, {1, 11}, {3, 1}, {5, 4}}, {{2, 14}, {3, 6}});
    case 4:
        return roots({}, {{1, 1}});
    default:
        return roots({{1, 11}, {3, 1}, {4, 1}}, {{1, 1}, {3, 6}});
    }
}

/// The trees of the table, and workers with some of its scenarios allocated to each; their ids
/// count from 1.
class Cluster : public DispatchParts {
  public:
    Cluster(std::string_view strategy,
            const std::vector<std::set<int>>& allocated,
            std::uint64_t seed = 1) {
        ClusterOptions options;
        options.strategy = strategy;
        options.q = 100;
        options.seed = seed;
        plan.add_tree(a_);
        plan.add_tree(b_);
        queue.open(job_id, options, {a_, b_}, make_policy(options, context));
        for (std::uint64_t i = 0; i < allocated.size(); ++i) {
            WorkerProxy& proxy = pool.add(WorkerId{i + 1}, {"w", 1});
            plan.join(proxy.slot());
            for (const int scenario : allocated[i]) {
                blocks.hold_roots(table_1(scenario), proxy);
            }
        }
    }
    [[nodiscard]] DispatchJob& job() { return queue.at(job_id); }
    /// Fills the worker's buffer up to this share of q, in percent.
    void load(std::uint64_t worker, std::uint64_t percent) {
        for (std::uint64_t i = 0; i < percent; ++i) {
            pool.at(WorkerId{worker}).buffers.add(job_id, i, {});
        }
    }
    /// Triangles of a scenario of the table that the worker holds.
    [[nodiscard]] std::uint64_t score(std::uint64_t worker, int scenario) const {
        const std::uint32_t slot = pool.find(WorkerId{worker})->slot();
        return held_triangles(plan, slot, table_1(scenario));
    }
    /// The worker that gets a scenario of the table; 0: none.
    [[nodiscard]] std::uint64_t pick(int scenario) {
        DispatchScenario wanted;
        wanted.roots = table_1(scenario);
        const WorkerProxy* before = job().policy->would_choose(job(), wanted);
        const WorkerProxy* chosen = job().policy->choose(job(), wanted);
        EXPECT_EQ(chosen, before);
        return chosen == nullptr ? 0 : chosen->id().value;
    }

  private:
    static constexpr JobId job_id{1};

    DispatchTree a_{TreeId{1}, {1, 11, 0, 1, 1, 4}};
    DispatchTree b_{TreeId{2}, {2, 1, 14, 6}};
};

TEST(ScorePolicy, TheScoreIsTheSumOverBothTreesOfTrianglesAlreadyHeld) {
    const Cluster cluster("best-match", {{}, {1}, {4}, {1, 2, 3, 4, 5}});
    // Scenarios 1 and 2 share BB5 of the first tree; BB1, BB3 and BB4 of the second.
    EXPECT_EQ(cluster.score(1, 2), 0u);
    EXPECT_EQ(cluster.score(2, 2), 1u + 2u + 14u + 6u);
    EXPECT_EQ(cluster.score(3, 2), 1u);
    EXPECT_EQ(cluster.score(4, 2), 11u + 1u + 1u + 2u + 1u + 14u + 6u);
    // Scenarios 5 and 1 share BB5 of the first tree and BB4 of the second.
    EXPECT_EQ(cluster.score(2, 5), 1u + 6u);
    EXPECT_EQ(cluster.score(4, 3), 1u + 11u + 1u + 4u + 14u + 6u);
}

TEST(ScorePolicy, BestMatchTakesTheHighestScore) {
    // Scenario 5 scores 7, 11 + 1 + 6, and 1.
    Cluster cluster("best-match", {{1}, {3}, {4}});
    cluster.load(2, 95);
    EXPECT_EQ(cluster.pick(5), 2u);
}

TEST(ScorePolicy, BestMatchLoadWeighsTheScoreByTheFreeShareOfTheBuffer) {
    Cluster cluster("best-match-load", {{1}, {3}});
    // 7 x (1 - 0) equals 18 x (1 - load) at a load of 11/18.
    cluster.load(2, 60);
    EXPECT_EQ(cluster.pick(5), 2u);
    cluster.load(2, 5);
    EXPECT_EQ(cluster.pick(5), 1u);
}

TEST(ScorePolicy, LowestTakesTheLowestScore) {
    Cluster cluster("lowest", {{1}, {3}, {4}});
    cluster.load(3, 90);
    EXPECT_EQ(cluster.pick(5), 3u);
}

TEST(ScorePolicy, EqualsGoToTheFewestScenariosThenToTheSmallestId) {
    for (const std::string_view strategy : {"best-match", "best-match-load", "lowest"}) {
        Cluster cluster(strategy, {{}, {}, {}});
        cluster.pool.at(WorkerId{1}).tasks.start(TaskId{1}, {JobId{1}, PositionRange{0, 1}});
        EXPECT_EQ(cluster.pick(1), 2u);
    }
}

TEST(ScorePolicy, AFullClaimedOrSilentWorkerGetsNothing) {
    for (const std::string_view strategy : {"best-match", "random"}) {
        Cluster cluster(strategy, {{}, {}, {}, {}});
        cluster.load(1, 100);
        cluster.pool.at(WorkerId{2})
            .tasks.start(TaskId{1}, {JobId{1}, PositionRange{0, 1}, true, true});
        cluster.pool.at(WorkerId{3}).set_silent(true);
        EXPECT_EQ(cluster.pick(1), 4u);
        EXPECT_FALSE(cluster.job().policy->may_take(cluster.pool.at(WorkerId{1}), cluster.job()));
        cluster.pool.remove(WorkerId{4});
        EXPECT_EQ(cluster.pick(1), 0u);
    }
}

TEST(BestMatchPull, AFreeWorkerTakesTheMostSimilarAndAmongEqualsTheFirst) {
    const std::vector<std::uint64_t> scores = {3, 9, 3, 0, 9, 3};
    EXPECT_EQ(BestMatchPull::most_similar(scores, 2), (std::vector<std::size_t>{1, 4}));
    EXPECT_EQ(BestMatchPull::most_similar(scores, 4), (std::vector<std::size_t>{0, 1, 2, 4}));
    EXPECT_EQ(BestMatchPull::most_similar(scores, 9).size(), 6u);
    EXPECT_TRUE(BestMatchPull::most_similar({}, 9).empty());
}

TEST(RandomWorker, IsAFunctionOfTheSeedAndReachesEveryWorkerEvenly) {
    Cluster one("random", {{1}, {}, {}}, 7);
    Cluster same("random", {{1}, {}, {}}, 7);
    std::map<std::uint64_t, int> counts;
    for (int i = 0; i < 3000; ++i) {
        const std::uint64_t worker = one.pick(1);
        ASSERT_EQ(worker, same.pick(1));
        ++counts[worker];
    }
    for (const std::uint64_t worker : {1, 2, 3}) {
        EXPECT_NEAR(counts[worker], 1000, 150);
    }
}

} // namespace
} // namespace cd::tests
