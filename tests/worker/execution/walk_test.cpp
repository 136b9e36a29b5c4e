// Proves that a descent answers each scenario of a sweep as a descent of that scenario alone does,
// that it spares work where the same subtrees touch again, and that it finds the trees of the
// scenario's bodies.
#include "worker/execution/walk.hpp"

#include "common/job/run_scenario.hpp"
#include "common/job/settle.hpp"
#include "tests/support/many_bodies.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/worker/execution/walks.hpp"
#include "worker/cache/joined_trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

struct SweepQuery {
    Level level = Level::Any;
    SubtreeForm form = SubtreeForm::Wide;
};

/// A torus, cut in 16, and a box that moves into its wall in small steps, cut in 64.
class Sweep {
  public:
    explicit Sweep(const SweepQuery& wanted)
        : torus_(cut_body(make_torus(1, 0.3, 60, 30), 4, wanted.form)),
          box_(cut_body(make_gridded_box(Vec3(1.2, 0.3, 0.2), 12), 6, wanted.form)),
          held_torus_(held(torus_)),
          held_box_(held(box_)) {
        auto job = std::make_shared<WorkerJob>();
        job->trees = {TreeId{1}, TreeId{2}};
        job->query.level = wanted.level;
        job_ = std::move(job);
    }

    /// Returns the records of scenarios [begin, end) of 100, which one descent runs.
    [[nodiscard]] Walked walk_over(std::size_t begin, std::size_t end) const {
        return walk_over(begin, end, held_torus_, held_box_);
    }
    /// Returns the same if the worker has joined the blocks of one tree, or of both.
    [[nodiscard]] Walked walk_over_joined(bool both) const {
        std::map<TreeId, JoinedTrees::Joined> joined{{TreeId{2}, join(held_box_)}};
        if (both) {
            joined.emplace(TreeId{1}, join(held_torus_));
        }
        return walk_over(0, 100, held_torus_, held_box_, std::move(joined));
    }
    /// Returns the same if the worker lacks one of the box's subtrees.
    [[nodiscard]] Walked walk_without(RootIndex root, std::size_t begin, std::size_t end) const {
        PartialObbTree box = held_box_;
        box.empty(root);
        return walk_over(begin, end, held_torus_, std::move(box));
    }
    /// Returns whole trees' answers to all scenarios at `level any`.
    [[nodiscard]] std::vector<ScenarioClass> classes() const {
        std::vector<ScenarioClass> classes;
        for (const Scenario& scenario : scenarios()) {
            classes.push_back(
                run_scenario(torus_.tree, box_.tree, scenario, query_of(Level::Any)).result.kind);
        }
        return classes;
    }

    [[nodiscard]] std::size_t roots() const {
        return held_torus_.root_count() + held_box_.root_count();
    }

  private:
    static JoinedTrees::Joined join(const PartialObbTree& tree) {
        const auto blocks = std::make_shared<const PartialObbTree>(tree);
        return JoinedTrees::Step{blocks, nullptr}.run();
    }
    static std::vector<Scenario> scenarios() {
        std::vector<Scenario> all;
        for (std::uint64_t i = 0; i < 100; ++i) {
            const double place = 2.13 - 0.023 * static_cast<double>(i);
            all.push_back(make_scenario({Pose{}, translation_pose(place, 0.1, 0.05)}, i));
        }
        return all;
    }
    [[nodiscard]] Walked walk_over(std::size_t begin,
                                   std::size_t end,
                                   PartialObbTree a,
                                   PartialObbTree b,
                                   std::map<TreeId, JoinedTrees::Joined> joined = {}) const {
        const Walk part{job_,
                        TaskScenarios(scenarios()),
                        begin,
                        end,
                        {{TreeId{1}, std::make_shared<const PartialObbTree>(std::move(a))},
                         {TreeId{2}, std::make_shared<const PartialObbTree>(std::move(b))}},
                        std::make_shared<const DroppedScenarios>(),
                        std::move(joined)};
        ScenarioClock clock(JobId{1});
        return walk(part, {}, clock);
    }

    CutBody torus_;
    CutBody box_;
    PartialObbTree held_torus_;
    PartialObbTree held_box_;
    std::shared_ptr<const WorkerJob> job_;
};

} // namespace

TEST(Walk, AnswersEachScenarioOfASweepAsIfItWereAlone) {
    for (const SweepQuery& query : {SweepQuery{},
                                    SweepQuery{.form = SubtreeForm::Binary},
                                    SweepQuery{.level = Level::Pairs}}) {
        const Sweep sweep(query);
        const Walked together = sweep.walk_over(0, 100);
        FinishedScenarios alone;
        for (std::size_t i = 0; i < 100; ++i) {
            const FinishedScenarios one = sweep.walk_over(i, i + 1).finished;
            alone.records.insert(alone.records.end(), one.records.begin(), one.records.end());
            alone.statistics += one.statistics;
        }
        EXPECT_EQ(together.finished.count, 100u);
        EXPECT_EQ(together.left, 0u);
        EXPECT_EQ(together.finished.records, alone.records);
        if (query.level == Level::Any) {
            EXPECT_LT(together.finished.statistics.box_tests, alone.statistics.box_tests * 3 / 4);
        }
    }
}

TEST(Walk, JoinedTreesHaveTheSameRecords) {
    for (const Level level : {Level::Any, Level::Count, Level::Pairs, Level::Contacts}) {
        const Sweep sweep({.level = level});
        const Walked apart = sweep.walk_over(0, 100);
        const Walked one = sweep.walk_over_joined(false);
        EXPECT_EQ(one.finished.records, apart.finished.records);
        EXPECT_EQ(one.found, apart.found);
        const Walked joined = sweep.walk_over_joined(true);
        EXPECT_EQ(joined.finished.records, apart.finished.records);
        EXPECT_EQ(joined.found, 100 * sweep.roots());
        EXPECT_EQ(joined.used.size(), sweep.roots());
        EXPECT_NE(joined.finished.statistics.box_tests, apart.finished.statistics.box_tests);
    }
}

TEST(Walk, AContactUnderCachedSubtreesNeedsNoOthers) {
    const Sweep sweep({});
    const std::vector<ScenarioClass> classes = sweep.classes();
    EXPECT_GT(std::ranges::count(classes, ScenarioClass::Contact), 10);
    EXPECT_GT(std::ranges::count(classes, ScenarioClass::Separate), 10);
    std::size_t waiting_alone = 0;
    std::size_t waiting_together = 0;
    for (RootIndex root = 0; root < 64; root += 8) {
        for (std::size_t i = 0; i < 100; ++i) {
            waiting_alone += sweep.walk_without(root, i, i + 1).waiting.size();
        }
        const Walked together = sweep.walk_without(root, 0, 100);
        waiting_together += together.waiting.size();
        EXPECT_EQ(together.finished.count + together.waiting.size(), 100u);
        for (const ScenarioResult& result : results_of(together.finished)) {
            EXPECT_EQ(result.kind, classes[result.index]);
        }
    }
    EXPECT_LT(waiting_together, waiting_alone);
}

TEST(Walk, ScenariosOfManyBodiesHaveTheRecordsOfOneProcess) {
    const ManyBodies job = make_many_bodies(6);
    std::map<const ObbTree*, TreeId> ids;
    std::map<TreeId, std::shared_ptr<const PartialObbTree>> trees;
    auto worker_job = std::make_shared<WorkerJob>();
    for (const auto& tree : job.trees) {
        const TreeId next{ids.size() + 1};
        const TreeId id = ids.try_emplace(tree.get(), next).first->second;
        worker_job->trees.push_back(id);
        if (id == next) {
            trees.emplace(id,
                          std::make_shared<const PartialObbTree>(held(cut_body(tree->mesh(), 4))));
        }
    }
    ASSERT_EQ(trees.size(), 3u);
    worker_job->query.level = Level::Any;
    worker_job->query.ignored = {{0, 300, 0, 512, 1, 3}};
    const Walk part{worker_job,
                    TaskScenarios(job.scenarios),
                    0,
                    job.scenarios.size(),
                    trees,
                    std::make_shared<const DroppedScenarios>()};
    ScenarioClock clock(JobId{1});
    const Walked walked = walk(part, {}, clock);
    const std::vector<ScenarioResult> results = results_of(walked.finished);
    ASSERT_EQ(results.size(), job.scenarios.size());
    const TreesByBody whole(job.trees);
    const Settler settler(whole, worker_job->query.ignored);
    const ScenarioRunner runner(whole, worker_job->query);
    for (std::size_t i = 0; i < results.size(); ++i) {
        ScenarioResult settled = results[i];
        (void)settler.settle(job.scenarios[i], settled);
        EXPECT_EQ(encode_result(settled), encode_result(runner.run(job.scenarios[i]).result));
    }
    std::set<TreeId> used;
    for (const SubtreeKey& key : walked.used) {
        used.insert(key.tree);
    }
    EXPECT_EQ(used.size(), 3u);
}

} // namespace cd::tests
