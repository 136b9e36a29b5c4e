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
ReadyScenario spheres_in_one_place(const ObbTree& tree, SubtreeForm form = SubtreeForm::Wide) {
    ReadyScenario ready;
    ready.query = std::make_shared<const Query>();
    ready.pairs = {{0, 0}};
    ready.roots_a = ready.roots_b = {0};
    const auto whole = std::make_shared<const Subtree>(extract_subtree(tree, 0, form));
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

TEST(Executor, BothFormsOfSubtreesHaveTheSameAnswer) {
    const CutBody body = cut_body(make_sphere(3), 0);
    const FinishedScenario wide = execute(spheres_in_one_place(body.tree), {});
    const FinishedScenario binary =
        execute(spheres_in_one_place(body.tree, SubtreeForm::Binary), {});
    EXPECT_EQ(wide.record, binary.record);
}

TEST(Task, OfTreesWhoseFormsDoNotSuitIsRefused) {
    const CutBody body = cut_body(make_sphere(1), 0);
    SubtreeCache cache(1u << 20);
    ASSERT_TRUE(cache.add_tree(TreeId{1}, cut_tree(body.tree, 0), SubtreeForm::Wide));
    ASSERT_TRUE(cache.add_tree(TreeId{2}, cut_tree(body.tree, 0), SubtreeForm::Binary));
    const auto is_taken = [&](std::uint64_t a, std::uint64_t b, double tolerance) {
        Batch batch;
        batch.tree_a = TreeId{a};
        batch.tree_b = TreeId{b};
        batch.query.tolerance = tolerance;
        batch.scenarios = pack_scenarios({});
        batch.pair_offsets = {0};
        return static_cast<bool>(Task::make(std::move(batch), cache));
    };
    EXPECT_TRUE(is_taken(1, 1, 0));
    EXPECT_TRUE(is_taken(2, 2, 0));
    EXPECT_TRUE(is_taken(2, 2, 0.5));
    EXPECT_FALSE(is_taken(1, 1, 0.5));
    EXPECT_FALSE(is_taken(1, 2, 0));
    EXPECT_FALSE(is_taken(2, 1, 0));
}

TEST(Task, ThatNobodyWaitsForTellsItsThreads) {
    const CutBody body = cut_body(make_sphere(1), 0);
    SubtreeCache cache(1u << 20);
    ASSERT_TRUE(cache.add_tree(TreeId{1}, cut_tree(body.tree, 0), body.form));
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
