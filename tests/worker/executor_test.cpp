// Proves that a worker's thread answers a scenario from its subtrees, and that it stops when nobody
// waits for the answer any more.
#include "worker/executor.hpp"

#include "tests/worker/cut_body.hpp"
#include "worker/task.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cd::tests {
namespace {

/// Two spheres of one mesh in one place, each as one subtree.
ReadyScenario spheres_in_one_place(const ObbTree& tree) {
    ReadyScenario ready;
    ready.query = std::make_shared<const Query>();
    ready.pairs = {{0, 0}};
    ready.roots_a = ready.roots_b = {0};
    const auto whole = std::make_shared<const Subtree>(extract_subtree(tree, 0));
    ready.subtrees_a = ready.subtrees_b = {whole};
    return ready;
}

} // namespace

TEST(Executor, AnswersAScenarioOrStopsWhenTold) {
    const CutBody body = cut_body(make_sphere(4), 0);
    const ReadyScenario ready = spheres_in_one_place(body.tree);
    const FinishedScenario whole = execute(ready, [] { return false; });
    EXPECT_FALSE(whole.is_stopped);
    const auto result = decode_result(whole.record);
    ASSERT_TRUE(result) << result.error().detail;
    EXPECT_GT(result.value().pair_count, 6000u);

    const FinishedScenario stopped = execute(ready, [] { return true; });
    EXPECT_TRUE(stopped.is_stopped);
}

TEST(Executor, MakesWideTreesForExactSearchesAlone) {
    const CutBody body = cut_body(make_sphere(3), 0);
    const auto is_prepared = [](const ReadyScenario& ready) {
        return !ready.subtrees_a[0]->view().wide.nodes.empty();
    };
    ReadyScenario ready = spheres_in_one_place(body.tree);
    const std::uint64_t bytes = ready.subtrees_a[0]->memory_bytes();
    Query coarse;
    coarse.tolerance = 0.1;
    ready.query = std::make_shared<const Query>(coarse);
    EXPECT_FALSE(execute(ready, [] { return false; }).is_stopped);
    EXPECT_FALSE(is_prepared(ready));
    // Another job's scenario of the same subtree.
    ready.query = std::make_shared<const Query>();
    EXPECT_FALSE(execute(ready, [] { return false; }).is_stopped);
    EXPECT_TRUE(is_prepared(ready));
    EXPECT_EQ(ready.subtrees_a[0]->memory_bytes(), bytes) << "what a cache counted stays so";
}

TEST(Executor, ThreadsThatMeetASubtreeFirstAgreeOnItsWideTree) {
    const CutBody body = cut_body(make_sphere(4), 0);
    const ReadyScenario ready = spheres_in_one_place(body.tree);
    ThreadPool pool(4);
    std::vector<FinishedScenario> finished(8);
    std::vector<const WideNode*> trees(finished.size());
    parallel_for(pool, finished.size(), [&](std::size_t i) {
        finished[i] = execute(ready, [] { return false; });
        trees[i] = ready.subtrees_a[0]->view().wide.nodes.data();
    });
    for (std::size_t i = 0; i < finished.size(); ++i) {
        EXPECT_EQ(finished[i].record, finished[0].record);
        EXPECT_EQ(trees[i], trees[0]);
    }
}

TEST(Task, ThatNobodyWaitsForTellsItsThreads) {
    const CutBody body = cut_body(make_sphere(1), 0);
    SubtreeCache cache(1u << 20);
    ASSERT_TRUE(cache.add_tree(TreeId{1}, cut_tree(body.tree, 0)));
    Batch batch;
    batch.task = TaskId{1};
    batch.tree_a = batch.tree_b = TreeId{1};
    batch.scenarios = pack_scenarios({});
    batch.pair_offsets = {0};
    auto task = Task::make(std::move(batch), cache);
    ASSERT_TRUE(task) << task.error().detail;
    const auto abandoned = task.value().abandoned();
    EXPECT_FALSE(*abandoned);
    Task moved = std::move(task.value());
    moved.abandon();
    EXPECT_TRUE(*abandoned);
}

} // namespace cd::tests
