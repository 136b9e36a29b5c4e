// Proves that a worker's thread answers a scenario from its subtrees, and stops once the scenario
// is cancelled.
#include "worker/execution/executor.hpp"

#include "common/job/packed_scenarios.hpp"
#include "tests/worker/cut_body.hpp"
#include "worker/execution/task.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace cd::tests {
namespace {

/// Two spheres of one mesh at one position, each as one subtree.
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
    const auto whole = execute(ready, [] { return false; });
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->count, 1u);
    const auto record = std::span(whole->records).subspan(sizeof(std::uint32_t));
    const auto result = decode_result(record);
    ASSERT_TRUE(result) << result.error().detail;
    EXPECT_GT(result.value().pair_count, 6000u);

    EXPECT_FALSE(execute(ready, [] { return true; }));
}

/// The search polls for cancellation. The test blocks that poll until the scenario is cancelled, so
/// the thread is certainly inside the run.
TEST(Executor, AScenarioThatIsCancelledInsideItsRunStopsThereAndFreesItsThread) {
    const CutBody body = cut_body(make_sphere(5), 0);
    const ReadyScenario ready = spheres_in_one_place(body.tree);
    std::size_t questions_of_all = 0;
    const auto never = [&] { return ++questions_of_all == 0; };
    ASSERT_TRUE(execute(ready, never));
    ASSERT_GT(questions_of_all, 4u) << "then this shows little";

    asio::io_context context;
    const auto work = asio::make_work_guard(context);
    Executor executor(context.get_executor(), 1);
    DroppedScenarios dropped;
    std::latch inside(1);
    std::latch cancelled(1);
    std::size_t questions = 0;
    bool has_answer = true;
    bool is_free = false;
    executor.submit([&] {
        const auto stop = [&] {
            if (++questions == 2) {
                inside.count_down();
                cancelled.wait();
            }
            return dropped.contains(ready.scenario.index);
        };
        return Executor::Continuation(
            [&, finished = execute(ready, stop)] { has_answer = finished.has_value(); });
    });
    executor.submit([&] { return Executor::Continuation([&] { is_free = true; }); });
    inside.wait();
    dropped.add(ready.scenario.index);
    cancelled.count_down();
    while (!is_free) {
        context.run_one();
    }
    EXPECT_FALSE(has_answer);
    EXPECT_EQ(questions, 2u) << "it went on after it had been told to stop";
}

TEST(Executor, BothFormsOfSubtreesHaveTheSameAnswer) {
    const CutBody body = cut_body(make_sphere(3), 0);
    const auto wide = execute(spheres_in_one_place(body.tree), {});
    const auto binary = execute(spheres_in_one_place(body.tree, SubtreeForm::Binary), {});
    ASSERT_TRUE(wide && binary);
    EXPECT_EQ(wide->records, binary->records);
}

TEST(Executor, CountsTheRootsOfADistanceAlone) {
    const CutBody body = cut_body(make_sphere(3), 0);
    ReadyScenario ready = spheres_in_one_place(body.tree);
    ready.named = 7;
    EXPECT_EQ(execute(ready, {})->statistics.effort, SearchEffort{});
    Query query;
    query.level = Level::Any;
    query.question = Question::Distance;
    ready.query = std::make_shared<const Query>(query);
    EXPECT_EQ(execute(ready, {})->statistics.effort, (SearchEffort{0, 0, 7, 1}));
}

TEST(Executor, SumsContactsByPartIfThereAreParts) {
    const CutBody body = cut_body(make_sphere(3), 0);
    ReadyScenario ready = spheres_in_one_place(body.tree);
    Query query;
    query.level = Level::Count;
    query.maps = true;
    ready.query = std::make_shared<const Query>(query);
    const auto without = execute(ready, {});
    ASSERT_TRUE(without);
    EXPECT_FALSE(without->map.bodies[0].empty());
    EXPECT_TRUE(without->map.parts.empty());
    const auto half = static_cast<std::uint32_t>(body.tree.mesh().triangles().size() / 2);
    const PartRuns halves = PartRuns::create({{0, 1}, {half, 0}}).value();
    ready.parts = std::make_shared<const BodyPartRuns>(BodyPartRuns{halves, {}});
    const auto finished = execute(ready, {});
    ASSERT_TRUE(finished);
    EXPECT_EQ(finished->map.bodies, without->map.bodies);
    ASSERT_EQ(finished->map.parts.pairs.size(), 2u);
    const auto result = decode_result(std::span(finished->records).subspan(sizeof(std::uint32_t)));
    EXPECT_EQ(finished->map.parts.pairs[0].pairs + finished->map.parts.pairs[1].pairs,
              result.value().pair_count);
}

TEST(WorkerJob, PartsThatAreNoneAreRefused) {
    SubtreeCache cache(1u << 20);
    ASSERT_TRUE(cache.add_tree(cut_body(make_sphere(1), 0).add(TreeId{1})));
    const auto is_taken = [&](std::vector<std::vector<PartRun>> parts) {
        return static_cast<bool>(make_worker_job(
            {JobId{1}, {TreeId{1}, TreeId{1}}, {}, std::nullopt, std::move(parts)}, cache));
    };
    EXPECT_TRUE(is_taken({}));
    EXPECT_TRUE(is_taken({{{0, 0}}, {{0, 1}, {5, 0}}}));
    EXPECT_FALSE(is_taken({{{0, 0}}}));
    EXPECT_FALSE(is_taken({{{0, 0}}, {{0, 0}}, {{0, 0}}}));
    EXPECT_FALSE(is_taken({{{0, 0}}, {{1, 0}}}));
    EXPECT_FALSE(is_taken({{{0, 0}}, {{0, 0}, {0, 1}}}));
}

TEST(WorkerJob, MismatchedTreeFormsAreRefused) {
    SubtreeCache cache(1u << 20);
    ASSERT_TRUE(cache.add_tree(cut_body(make_sphere(1), 0).add(TreeId{1})));
    ASSERT_TRUE(cache.add_tree(cut_body(make_sphere(1), 0, SubtreeForm::Binary).add(TreeId{2})));
    const auto is_taken = [&](std::uint64_t a, std::uint64_t b) {
        return static_cast<bool>(
            make_worker_job({JobId{1}, {TreeId{a}, TreeId{b}}, {}, std::nullopt}, cache));
    };
    EXPECT_TRUE(is_taken(1, 1));
    EXPECT_TRUE(is_taken(2, 2));
    EXPECT_FALSE(is_taken(1, 2));
    EXPECT_FALSE(is_taken(2, 1));
    EXPECT_FALSE(is_taken(1, 3));
}

TEST(WorkerJob, HasAtLeastTwoBodiesAndPartsOfTwoOnly) {
    SubtreeCache cache(1u << 20);
    ASSERT_TRUE(cache.add_tree(cut_body(make_sphere(1), 0).add(TreeId{1})));
    const auto is_taken = [&](std::size_t bodies, std::vector<std::vector<PartRun>> parts) {
        const std::vector<TreeId> trees(bodies, TreeId{1});
        return static_cast<bool>(
            make_worker_job({JobId{1}, trees, {}, std::nullopt, std::move(parts)}, cache));
    };
    EXPECT_FALSE(is_taken(1, {}));
    EXPECT_TRUE(is_taken(2, {{{0, 0}}, {{0, 0}}}));
    EXPECT_TRUE(is_taken(5, {}));
    EXPECT_FALSE(is_taken(5, {{{0, 0}}, {{0, 0}}}));
}

class TaskTest : public testing::Test {
  protected:
    void SetUp() override { ASSERT_TRUE(cache_.add_tree(body_.add(TreeId{1}))); }
    std::shared_ptr<const WorkerJob> make_job(std::optional<Grid> grid = std::nullopt) {
        AddJob add{JobId{1}, {TreeId{1}, TreeId{1}}, {}, std::nullopt};
        if (grid) {
            add.grid = encode_grid(*grid);
        }
        return make_worker_job(add, cache_).value();
    }

    CutBody body_ = cut_body(make_sphere(1), 0);
    SubtreeCache cache_{1u << 20};
};

TEST_F(TaskTest, CancellationStopsItsThreads) {
    const std::vector<Scenario> one(1);
    auto task = Task::make(
        {TaskId{1}, JobId{1}, 0, 1, pack_scenarios(one), {0, 0}, {}}, make_job(), cache_);
    ASSERT_TRUE(task) << task.error().detail;
    const auto abandoned = task.value().abandoned();
    EXPECT_FALSE(*abandoned);
    Task moved = std::move(task.value());
    moved.abandon();
    EXPECT_TRUE(*abandoned);
}

TEST_F(TaskTest, ARangeDescendsOnceInOrderPerThread) {
    Grid grid;
    grid.position[0] = {0, 1, 1000};
    auto made = Task::make({TaskId{1}, JobId{1}, 100, 900, {}, {}, {}}, make_job(grid), cache_);
    ASSERT_TRUE(made) << made.error().detail;
    Task& task = made.value();
    std::size_t next = 0;
    while (task.has_unwalked()) {
        const std::size_t left = 900 - next;
        const Walk part = task.next_walk(cache_, 4);
        EXPECT_EQ(part.begin, next);
        ASSERT_GT(part.end, part.begin);
        EXPECT_LE(part.end - part.begin, left / 8 + 1);
        EXPECT_EQ(part.scenarios.at(part.begin), scenario_on(grid, 100 + part.begin));
        next = part.end;
        FinishedScenarios finished;
        finished.count = static_cast<std::uint32_t>(part.end - part.begin);
        finished.seconds = 1e-7 * finished.count; // Fast scenarios: larger groups follow.
        task.add(finished);
    }
    EXPECT_EQ(next, 900u);
    EXPECT_EQ(task.unanswered(), 0u);
}

TEST_F(TaskTest, OfARangeThatDoesNotExistIsRefused) {
    Grid grid;
    grid.position[0] = {0, 1, 1000};
    const auto refusal = [&](const WorkUnit& unit, const std::optional<Grid>& of) {
        const auto made = Task::make(unit, make_job(of), cache_);
        return made ? "" : made.error().detail;
    };
    EXPECT_EQ(refusal({TaskId{1}, JobId{1}, 999, 1, {}, {}, {}}, grid), "");
    EXPECT_NE(refusal({TaskId{1}, JobId{1}, 999, 2, {}, {}, {}}, grid), "");
    EXPECT_NE(refusal({TaskId{1}, JobId{1}, 1001, 1, {}, {}, {}}, grid), "");
    EXPECT_NE(refusal({TaskId{1}, JobId{1}, 0, 1, {}, {}, {}}, std::nullopt), "") << "no poses";
    const std::vector<Scenario> one(1);
    EXPECT_EQ(refusal({TaskId{1}, JobId{1}, 0, 1, pack_scenarios(one), {}, {}}, std::nullopt), "");
    EXPECT_NE(refusal({TaskId{1}, JobId{1}, 0, 2, pack_scenarios(one), {}, {}}, std::nullopt), "");
}

TEST_F(TaskTest, ATaskHasTheTreesOfItsScenariosBodies) {
    const CutBody cut = cut_body(make_sphere(3), 3);
    ASSERT_TRUE(cache_.add_tree(cut.add(TreeId{2})));
    ASSERT_TRUE(cache_.add_tree(cut_body(make_box(Vec3(1, 1, 1)), 0).add(TreeId{3})));
    const auto job = make_worker_job(
        {JobId{1}, {TreeId{1}, TreeId{2}, TreeId{3}, TreeId{2}}, {}, std::nullopt}, cache_);
    ASSERT_TRUE(job) << job.error().detail;
    const auto task_of = [&](std::uint32_t a, std::uint32_t b, std::vector<RootPair> pairs) {
        const std::vector<Scenario> one{{0, a, b, {}}};
        WorkUnit unit{TaskId{1}, JobId{1}, 0, 1, pack_scenarios(one), {}, {}};
        if (!pairs.empty()) {
            unit.pair_offsets = {0, static_cast<std::uint32_t>(pairs.size())};
            unit.pairs = std::move(pairs);
        }
        return Task::make(std::move(unit), job.value(), cache_);
    };
    const RootIndex last = cut.top.root_count() - 1;
    const auto task = task_of(1, 3, {{0, last}, {last, last}});
    ASSERT_TRUE(task) << task.error().detail;
    EXPECT_EQ(task.value().trees(), std::set{TreeId{2}});
    EXPECT_EQ(task.value().roots_of(0),
              (std::vector<SubtreeKey>{{TreeId{2}, 0}, {TreeId{2}, last}}));
    EXPECT_EQ(task_of(0, 1, {}).value().trees(), (std::set{TreeId{1}, TreeId{2}}));
    EXPECT_TRUE(task_of(0, 1, {{0, last}}));
    EXPECT_FALSE(task_of(0, 2, {{0, last}})) << "body 2 has one root";
    EXPECT_FALSE(task_of(1, 3, {{0, last + 1}}));
    EXPECT_FALSE(task_of(0, 4, {})) << "the job has four bodies";
    EXPECT_FALSE(task_of(1, 1, {}));
    EXPECT_FALSE(task_of(2, 1, {}));
}

} // namespace cd::tests
