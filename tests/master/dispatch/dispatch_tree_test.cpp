// Proves that bodies of one mesh share a tree, and that the dispatcher matches the scenarios of
// many bodies by the blocks of their own two trees.
#include "master/dispatch/dispatch_tree.hpp"

#include "common/core/timing/master.hpp"
#include "master/dispatch/dispatcher.hpp"
#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

constexpr TreeId wall{1};
constexpr TreeId car{2};
constexpr TreeId sign{3};

/// Opens a job with a wall, two cars of one mesh and a sign, as the bodies 0 to 3.
struct Street : DispatchStage {
    explicit Street(std::string_view strategy) {
        const auto tree = [](TreeId id, std::vector<std::uint32_t> triangles) {
            const std::vector<std::uint64_t> bytes(triangles.size(), 6400);
            return std::make_shared<const DispatchTree>(DispatchTree{id, triangles, bytes});
        };
        const auto one = tree(car, {100, 300});
        const DispatchTrees trees({tree(wall, {50, 60, 70}), one, one, tree(sign, {5, 6})});
        for (const auto& each : trees.distinct()) {
            plan.add_tree(*each);
        }
        ClusterOptions options;
        options.strategy = strategy;
        queue.open(JobId{1}, options, trees, make_policy(options, context));
        job = queue.find(JobId{1});
    }

    /// A scenario of two bodies that touches root 0 of the first and root 1 of the second.
    [[nodiscard]] DispatchScenario scenario_of(std::uint32_t a, std::uint32_t b) const {
        AnalysedScenario analysed{0, {0}, {1}, 100, 1'000'000};
        analysed.body_a = a;
        analysed.body_b = b;
        return job->scenario_of(analysed);
    }

    DispatchJob* job = nullptr;
};

TEST(DispatchTrees, EachTreeIsThereOnce) {
    const Street street("best-match");
    const DispatchTrees& trees = street.job->trees;
    EXPECT_EQ(trees.distinct().size(), 3u);
    EXPECT_EQ(trees.distinct()[1]->tree, car);
    EXPECT_EQ(&trees.of(1), &trees.of(2));
    EXPECT_EQ(trees.of(3).tree, sign);
    EXPECT_TRUE(trees.have(wall));
    EXPECT_FALSE(trees.have(TreeId{4}));
}

TEST(DispatchTrees, AScenarioHasTheRootsOfItsBodies) {
    const Street street("best-match");
    const DispatchScenario wanted = street.scenario_of(0, 2);
    EXPECT_EQ(wanted.roots[0].tree, wall);
    EXPECT_EQ(wanted.roots[0].roots[0].weight, 50u);
    EXPECT_EQ(wanted.roots[1].tree, car);
    EXPECT_EQ(wanted.roots[1].roots[0].root, 1u);
    EXPECT_EQ(wanted.roots[1].roots[0].weight, 300u);
}

TEST(DispatchTrees, BlocksOfAMeshAreMissingOnceForAllItsBodies) {
    Street street("earliest-finish");
    WorkerProxy& one = street.join(1);
    DispatchScenario first = street.scenario_of(0, 1);
    MissingBlocks missing = street.blocks.hold(*street.job, first, one);
    missing.hint(one, *street.job, street.actions);
    ASSERT_EQ(street.actions.size(), 2u);
    EXPECT_EQ(std::get<SendHint>(street.actions[0]).tree, wall);
    EXPECT_EQ(std::get<SendHint>(street.actions[1]).tree, car);
    DispatchScenario again = street.scenario_of(0, 2);
    EXPECT_TRUE(street.blocks.hold(*street.job, again, one).is_nothing()) << "the other car";
    // Both cars: of the two roots, the worker has the second one.
    const DispatchScenario cars = street.scenario_of(1, 2);
    EXPECT_EQ(street.blocks.hold_roots(cars.roots, one).of_trees[0].roots,
              std::vector<RootIndex>{0});
}

TEST(DispatchTrees, AWorkerWithTheBlocksOfOneBodyMatchesAnotherOfItsMesh) {
    for (const std::string_view strategy : {"best-match", "earliest-finish"}) {
        Street street(strategy);
        street.join(1);
        WorkerProxy& two = street.join(2);
        DispatchScenario first = street.scenario_of(0, 1);
        street.blocks.hold(*street.job, first, two);
        two.tasks.note_answers(0, 0);
        for (const TreeRoots& side : first.roots) {
            street.plan.arrived(two.slot(), side.tree, side.roots);
        }
        const DispatchScenario other = street.scenario_of(2, 3);
        EXPECT_EQ(held_triangles(street.plan, two.slot(), other.roots), 0u) << "another root";
        const DispatchScenario same = street.scenario_of(0, 2);
        EXPECT_EQ(held_triangles(street.plan, two.slot(), same.roots), 350u);
        EXPECT_EQ(street.job->policy->would_choose(*street.job, same), &two) << strategy;
    }
}

TEST(DispatchTrees, FillingACacheCostsEachTreeOnce) {
    Street street("earliest-finish");
    street.join(1);
    EXPECT_DOUBLE_EQ(street.blocks.costs_of(*street.job).all,
                     7 * 6400 / limits::link_bytes_per_second_start + 7 * timing::block_seconds);
}

TEST(DispatchTrees, TheTreesOfAClosedJobGoUnlessAnotherHasThem) {
    Dispatcher dispatcher;
    const auto tree = [](std::uint64_t id) {
        return std::make_shared<const DispatchTree>(DispatchTree{TreeId{id}, {1}, {64}});
    };
    (void)dispatcher.job_opened(JobId{1}, {}, DispatchTrees({tree(1), tree(2), tree(2), tree(3)}));
    (void)dispatcher.job_opened(JobId{2}, {}, DispatchTrees({tree(3), tree(4)}));
    (void)dispatcher.worker_joined(WorkerId{1}, {"w", 1});
    AnalysedScenario last{0, {0}, {0}, 100, 1'000'000};
    last.body_a = 2;
    last.body_b = 3;
    (void)dispatcher.scenario_analysed(JobId{1}, last);
    (void)dispatcher.input_paused();
    EXPECT_EQ(dispatcher.tasks_of(WorkerId{1}).size(), 1u);
    (void)dispatcher.job_closed(JobId{1});
    dispatcher.check_invariants();
    (void)dispatcher.scenario_analysed(JobId{2}, {0, {0}, {0}, 100, 1'000'000});
    dispatcher.check_invariants();
    (void)dispatcher.job_closed(JobId{2});
    dispatcher.check_invariants();
}

} // namespace
} // namespace cd::tests
