// Proves that each strategy picks the worker the paper prescribes: worked examples on the vectors
// of its Table 1, ties, and the random draw.
#include "master/dispatch/policy/matchmaker.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace cd::tests {
namespace {

/// The two lists of the paper's Table 1: a scenario's roots with their triangles. (The first list's
/// column BB3 is empty in print.)
ScenarioRoots table_1(int scenario) {
    switch (scenario) {
    case 1:
        return {{{4, 1}, {5, 4}}, {{0, 2}, {2, 14}, {3, 6}}};
    case 2:
        return {{{1, 11}, {3, 1}, {4, 1}}, {{0, 2}, {1, 1}, {2, 14}, {3, 6}}};
    case 3:
        return {{{0, 1}, {1, 11}, {3, 1}, {5, 4}}, {{2, 14}, {3, 6}}};
    case 4:
        return {{}, {{1, 1}}};
    default:
        return {{{1, 11}, {3, 1}, {4, 1}}, {{1, 1}, {3, 6}}};
    }
}

/// Workers with some scenarios of the table allocated to each.
class Cluster {
  public:
    explicit Cluster(const std::vector<std::set<int>>& allocated) {
        const auto workers = static_cast<std::uint32_t>(allocated.size());
        a_.grow(workers);
        b_.grow(workers);
        for (std::uint32_t worker = 0; worker < workers; ++worker) {
            for (const int scenario : allocated[worker]) {
                const ScenarioRoots roots = table_1(scenario);
                for (const WeightedRoot& root : roots.a) {
                    a_.set(worker, root.root);
                }
                for (const WeightedRoot& root : roots.b) {
                    b_.set(worker, root.root);
                }
            }
        }
    }
    /// Returns the workers' scores in order of their ids.
    [[nodiscard]] std::vector<std::uint64_t> scores(int scenario) const {
        std::vector<std::uint64_t> sums(a_.sum_count(), 0);
        const ScenarioRoots roots = table_1(scenario);
        a_.add_held(roots.a, sums);
        b_.add_held(roots.b, sums);
        sums.resize(a_.holder_count());
        return sums;
    }
    /// Worker ids count from 1.
    [[nodiscard]] std::vector<WorkerCandidate> candidates(int scenario,
                                                          std::vector<double> loads = {}) const {
        const std::vector<std::uint64_t> held = scores(scenario);
        loads.resize(held.size(), 0);
        std::vector<WorkerCandidate> list;
        for (std::size_t i = 0; i < held.size(); ++i) {
            list.push_back({WorkerId{i + 1}, held[i], loads[i], 0});
        }
        return list;
    }

  private:
    RootHolders a_{6, 0};
    RootHolders b_{4, 0};
};

std::optional<WorkerId> pick(Strategy strategy, const std::vector<WorkerCandidate>& candidates) {
    Matchmaker matchmaker(strategy, 1);
    return matchmaker.choose(candidates);
}

TEST(Matchmaker, TheScoreIsTheSumOverBothTreesOfTrianglesAlreadyHeld) {
    const Cluster cluster({{}, {1}, {4}, {1, 2, 3, 4, 5}});
    // Scenarios 1 and 2 share BB5 of the first tree; BB1, BB3 and BB4 of the second.
    EXPECT_EQ(cluster.scores(2),
              (std::vector<std::uint64_t>{0, 1 + 2 + 14 + 6, 1, 11 + 1 + 1 + 2 + 1 + 14 + 6}));
    // Scenarios 5 and 1 share BB5 of the first tree and BB4 of the second.
    EXPECT_EQ(cluster.scores(5)[1], 1u + 6u);
    EXPECT_EQ(cluster.scores(3)[3], 1u + 11u + 1u + 4u + 14u + 6u);
}

TEST(Matchmaker, BestMatchTakesTheHighestScore) {
    const Cluster cluster({{1}, {3}, {4}});
    // Scenario 5 scores 7, 11 + 1 + 6, and 1.
    EXPECT_EQ(pick(Strategy::BestMatch, cluster.candidates(5, {0, 0.95, 0})), WorkerId{2});
}

TEST(Matchmaker, BestMatchLoadWeighsTheScoreByTheFreeShareOfTheBuffer) {
    const Cluster cluster({{1}, {3}});
    // 7 x (1 - 0) equals 18 x (1 - load) at a load of 11/18.
    EXPECT_EQ(pick(Strategy::BestMatchLoad, cluster.candidates(5, {0, 0.60})), WorkerId{2});
    EXPECT_EQ(pick(Strategy::BestMatchLoad, cluster.candidates(5, {0, 0.65})), WorkerId{1});
}

TEST(Matchmaker, LowestTakesTheLowestScore) {
    const Cluster cluster({{1}, {3}, {4}});
    EXPECT_EQ(pick(Strategy::Lowest, cluster.candidates(5, {0, 0, 0.9})), WorkerId{3});
}

TEST(Matchmaker, EqualsGoToTheFewestScenariosThenToTheSmallestId) {
    for (const Strategy strategy :
         {Strategy::BestMatch, Strategy::BestMatchLoad, Strategy::Lowest}) {
        EXPECT_EQ(pick(strategy,
                       {{WorkerId{3}, 7, 0, 2}, {WorkerId{5}, 7, 0, 1}, {WorkerId{9}, 7, 0, 1}}),
                  WorkerId{5});
    }
}

TEST(Matchmaker, AFreeWorkerTakesTheMostSimilarAndAmongEqualsTheFirst) {
    const std::vector<std::uint64_t> scores = {3, 9, 3, 0, 9, 3};
    EXPECT_EQ(Matchmaker::most_similar(scores, 2), (std::vector<std::size_t>{1, 4}));
    EXPECT_EQ(Matchmaker::most_similar(scores, 4), (std::vector<std::size_t>{0, 1, 2, 4}));
    EXPECT_EQ(Matchmaker::most_similar(scores, 9).size(), 6u);
    EXPECT_TRUE(Matchmaker::most_similar({}, 9).empty());
}

TEST(Matchmaker, WithoutCandidatesThereIsNoWorker) {
    for (const Strategy strategy : {Strategy::BestMatch, Strategy::Random}) {
        EXPECT_EQ(pick(strategy, {}), std::nullopt);
    }
}

TEST(Matchmaker, RandomIsAFunctionOfTheSeedAndReachesEveryWorkerEvenly) {
    const std::vector<WorkerCandidate> candidates = Cluster({{1}, {}, {}}).candidates(1);
    Matchmaker one(Strategy::Random, 7);
    Matchmaker same(Strategy::Random, 7);
    std::map<WorkerId, int> counts;
    for (int i = 0; i < 3000; ++i) {
        const auto worker = one.choose(candidates);
        ASSERT_EQ(worker, same.choose(candidates));
        ++counts[worker.value()];
    }
    for (const WorkerCandidate& candidate : candidates) {
        EXPECT_NEAR(counts[candidate.worker], 1000, 150);
    }
}

} // namespace
} // namespace cd::tests
