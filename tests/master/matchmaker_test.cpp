// Proves that each strategy picks the worker that the paper's words ask for: worked examples on the
// vectors of its Table 1, ties, and the random draw.
#include "master/matchmaker.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace cd::tests {
namespace {

/// The two lists of Table 1: the roots that a scenario touches, with their triangles. (The column
/// BB3 of its first list is empty in print.)
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

/// A worker that was allocated the given scenarios of the table.
struct Holder {
    explicit Holder(std::set<int> scenarios) {
        for (const int scenario : scenarios) {
            const ScenarioRoots roots = table_1(scenario);
            for (const auto& root : roots.a) {
                a.set(root.root, root.triangles);
            }
            for (const auto& root : roots.b) {
                b.set(root.root, root.triangles);
            }
        }
    }
    [[nodiscard]] WorkerCandidate
    as_candidate(std::uint64_t id, double load = 0, std::uint64_t has = 0) const {
        return {WorkerId{id}, &a, &b, load, has};
    }

    RootIndicator a{6};
    RootIndicator b{4};
};

std::optional<WorkerId>
pick(Strategy strategy, int scenario, const std::vector<WorkerCandidate>& candidates) {
    Matchmaker matchmaker(strategy, 1);
    return matchmaker.choose(table_1(scenario), candidates);
}

TEST(Matchmaker, TheScoreIsTheSumOverBothTreesOfTrianglesAlreadyHeld) {
    const Holder nothing({});
    const Holder first({1});
    const Holder fourth({4});
    const Holder all({1, 2, 3, 4, 5});

    EXPECT_EQ(Matchmaker::score(table_1(2), nothing.as_candidate(1)), 0u);
    // Scenarios 1 and 2 share BB5 of the first tree; BB1, BB3 and BB4 of the second.
    EXPECT_EQ(Matchmaker::score(table_1(2), first.as_candidate(1)), 1u + 2u + 14u + 6u);
    // And 5 shares with 1: BB5, and BB4 of the second.
    EXPECT_EQ(Matchmaker::score(table_1(5), first.as_candidate(1)), 1u + 6u);
    EXPECT_EQ(Matchmaker::score(table_1(2), fourth.as_candidate(1)), 1u);
    EXPECT_EQ(Matchmaker::score(table_1(3), all.as_candidate(1)), 1u + 11u + 1u + 4u + 14u + 6u);
}

TEST(Matchmaker, AHeldRootCountsOnceWhateverItsSizeAtTheHolder) {
    Holder holder({});
    holder.a.set(1, 7);
    EXPECT_EQ(Matchmaker::score(table_1(2), holder.as_candidate(1)), 11u);
}

TEST(Matchmaker, BestMatchTakesTheHighestScore) {
    const Holder first({1});
    const Holder third({3});
    const Holder fourth({4});
    // Scenario 5 scores 7, 11 + 1 + 6, and 1.
    EXPECT_EQ(pick(Strategy::BestMatch,
                   5,
                   {first.as_candidate(1), third.as_candidate(2, 0.95), fourth.as_candidate(3)}),
              WorkerId{2});
}

TEST(Matchmaker, BestMatchLoadWeighsTheScoreByTheFreeShareOfTheBuffer) {
    const Holder first({1});
    const Holder third({3});
    // 7 x (1 - 0) against 18 x (1 - load): even at a load of 11/18.
    EXPECT_EQ(
        pick(Strategy::BestMatchLoad, 5, {first.as_candidate(1), third.as_candidate(2, 0.60)}),
        WorkerId{2});
    EXPECT_EQ(
        pick(Strategy::BestMatchLoad, 5, {first.as_candidate(1), third.as_candidate(2, 0.65)}),
        WorkerId{1});
}

TEST(Matchmaker, LowestTakesTheLowestScore) {
    const Holder first({1});
    const Holder third({3});
    const Holder fourth({4});
    EXPECT_EQ(pick(Strategy::Lowest,
                   5,
                   {first.as_candidate(1), third.as_candidate(2), fourth.as_candidate(3, 0.9)}),
              WorkerId{3});
}

TEST(Matchmaker, EqualsGoToTheFewestScenariosThenToTheSmallestId) {
    const Holder none({});
    for (const Strategy strategy :
         {Strategy::BestMatch, Strategy::BestMatchLoad, Strategy::Lowest}) {
        EXPECT_EQ(pick(strategy,
                       1,
                       {none.as_candidate(3, 0, 2),
                        none.as_candidate(5, 0, 1),
                        none.as_candidate(9, 0, 1)}),
                  WorkerId{5});
    }
}

TEST(Matchmaker, WithoutCandidatesThereIsNoWorker) {
    for (const Strategy strategy : {Strategy::BestMatch, Strategy::Random}) {
        EXPECT_EQ(pick(strategy, 1, {}), std::nullopt);
    }
}

TEST(Matchmaker, RandomIsAFunctionOfTheSeedAndReachesEveryWorkerEvenly) {
    const Holder first({1});
    const Holder none({});
    const std::vector<WorkerCandidate> candidates = {
        first.as_candidate(1), none.as_candidate(2), none.as_candidate(3)};
    Matchmaker one(Strategy::Random, 7);
    Matchmaker same(Strategy::Random, 7);
    std::map<WorkerId, int> counts;
    for (int i = 0; i < 3000; ++i) {
        const auto worker = one.choose(table_1(1), candidates);
        ASSERT_EQ(worker, same.choose(table_1(1), candidates));
        ++counts[worker.value()];
    }
    for (const WorkerCandidate& candidate : candidates) {
        EXPECT_NEAR(counts[candidate.worker], 1000, 150);
    }
}

} // namespace
} // namespace cd::tests
