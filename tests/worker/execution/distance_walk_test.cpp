// Proves that a descent asks for the subtrees of a distance in two looks, that the second look asks
// only for those that may be nearer than what the first found, and that the record is that of the
// whole bodies, whatever is cached.
#include "common/job/distance_looks.hpp"
#include "common/job/query_roots.hpp"
#include "common/job/run_scenario.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/worker/execution/walks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

struct Depths {
    std::uint32_t a = 5;
    std::uint32_t b = 6;
};

Scenario beside(double x) {
    return make_scenario({Pose{}, translation_pose(x, 0.3, 0.1)});
}

/// A worker that has the upper trees of a torus and a box, and blocks as they are given.
class DistanceWalker {
  public:
    explicit DistanceWalker(const Depths& depths = {}, std::vector<IgnoredRange> ignored = {})
        : torus_(cut_body(make_torus(1, 0.3, 60, 30), depths.a)),
          box_(cut_body(make_gridded_box(Vec3(1.2, 0.3, 0.2), 12), depths.b)),
          held_torus_(held_top(torus_)),
          held_box_(held_top(box_)) {
        job_->trees = {TreeId{1}, TreeId{2}};
        job_->query.level = Level::Any;
        job_->query.question = Question::Distance;
        job_->query.ignored = std::move(ignored);
    }

    void set_up_to(std::optional<double> up_to) { job_->query.up_to = up_to; }

    /// Runs one scenario with the blocks given so far.
    [[nodiscard]] Walked walk_one(const Scenario& scenario) const {
        const Walk part{job_,
                        TaskScenarios(std::vector{scenario}),
                        0,
                        1,
                        {{TreeId{1}, std::make_shared<const PartialObbTree>(held_torus_)},
                         {TreeId{2}, std::make_shared<const PartialObbTree>(held_box_)}},
                        std::make_shared<const DroppedScenarios>()};
        ScenarioClock clock(JobId{1});
        return walk(part, {}, clock);
    }
    void give(const std::vector<RootPair>& pairs) {
        for (const RootPair& pair : pairs) {
            if (given_.insert({TreeId{1}, pair.a}).second) {
                fill(held_torus_, torus_, pair.a);
            }
            if (given_.insert({TreeId{2}, pair.b}).second) {
                fill(held_box_, box_, pair.b);
            }
        }
    }
    /// Gives the blocks that a scenario waits for until it is answered, and returns its record.
    [[nodiscard]] ScenarioResult run(const Scenario& scenario) {
        for (int walks = 0; walks < 3; ++walks) {
            const Walked walked = walk_one(scenario);
            if (walked.waiting.empty()) {
                return results_of(walked.finished).at(0);
            }
            give(walked.waiting[0].pairs);
        }
        ADD_FAILURE() << "a third look";
        return {};
    }

    [[nodiscard]] std::vector<RootPair> named(const Scenario& scenario) const {
        return query_roots(torus_.top, box_.top, scenario, job_->query).value().pairs;
    }
    [[nodiscard]] std::vector<RootPair> nearest(const Scenario& scenario) const {
        return first_look(torus_.top, box_.top, scenario.poses, named(scenario));
    }
    [[nodiscard]] ScenarioResult whole(const Scenario& scenario) const {
        const SubtreePair both{torus_.tree.view(), box_.tree.view()};
        return run_on_subtrees({&both, 1}, scenario, job_->query).result;
    }
    [[nodiscard]] std::size_t blocks_given() const { return given_.size(); }

  private:
    CutBody torus_;
    CutBody box_;
    PartialObbTree held_torus_;
    PartialObbTree held_box_;
    std::set<SubtreeKey> given_;
    std::shared_ptr<WorkerJob> job_ = std::make_shared<WorkerJob>();
};

std::size_t blocks_of(const std::vector<RootPair>& pairs) {
    return roots_of_a(pairs).size() + roots_of_b(pairs).size();
}

} // namespace

TEST(DistanceWalk, TheSecondLookAsksForRootsThatMayBeNearer) {
    DistanceWalker worker;
    const Scenario scenario = beside(3.5);
    const std::vector<RootPair> named = worker.named(scenario);
    const Walked first = worker.walk_one(scenario);
    EXPECT_EQ(first.finished.count, 0u);
    ASSERT_EQ(first.waiting.size(), 1u);
    EXPECT_TRUE(first.waiting[0].walks_again);
    EXPECT_EQ(first.waiting[0].pairs, worker.nearest(scenario));

    worker.give(first.waiting[0].pairs);
    const Walked second = worker.walk_one(scenario);
    EXPECT_EQ(second.finished.count, 0u);
    EXPECT_GT(second.finished.statistics.box_tests, first.finished.statistics.box_tests)
        << "the work of the first look counts";
    ASSERT_EQ(second.waiting.size(), 1u);
    EXPECT_FALSE(second.waiting[0].walks_again);
    EXPECT_LT(blocks_of(second.waiting[0].pairs), blocks_of(named));

    worker.give(second.waiting[0].pairs);
    const Walked last = worker.walk_one(scenario);
    EXPECT_TRUE(last.waiting.empty());
    EXPECT_EQ(first.finished.statistics.effort, SearchEffort{});
    EXPECT_EQ(second.finished.statistics.effort, SearchEffort{}) << "a scenario counts at its end";
    const SearchEffort effort = last.finished.statistics.effort;
    EXPECT_EQ(second.waiting[0].named, named.size());
    EXPECT_EQ(effort.roots_named, named.size());
    EXPECT_LT(effort.roots_used, effort.roots_named);
    EXPECT_GT(effort.roots_used, 0u);
    EXPECT_LE(effort.roots_used, second.waiting[0].pairs.size());
    EXPECT_EQ(last.found, worker.blocks_given());
    EXPECT_EQ(encode_result(results_of(last.finished).at(0)),
              encode_result(worker.whole(scenario)));
}

TEST(DistanceWalk, RecordsAreThoseOfTheWhole) {
    std::size_t contacts = 0;
    std::size_t with_distance = 0;
    for (SeededRandom random : seeds(60)) {
        const Depths depths{static_cast<std::uint32_t>(1 + random() % 6),
                            static_cast<std::uint32_t>(1 + random() % 6)};
        std::vector<IgnoredRange> ignored;
        if (random() % 3 == 0) {
            ignored = {{0, 900, 0, 300}};
        }
        DistanceWalker worker(depths, ignored);
        if (random() % 3 == 0) {
            worker.set_up_to(0.5);
        }
        for (std::uint64_t i = 0; i < 3; ++i) { // Under blocks of the scenarios before.
            const Scenario scenario = make_scenario({Pose{}, make_pose(random, 1.8)}, i);
            const ScenarioResult whole = worker.whole(scenario);
            ASSERT_EQ(encode_result(worker.run(scenario)), encode_result(whole)) << i;
            contacts += whole.kind == ScenarioClass::Contact ? 1 : 0;
            with_distance += whole.nearest ? 1 : 0;
        }
    }
    EXPECT_GT(contacts, 20u);
    EXPECT_GT(with_distance, 60u);
}

TEST(DistanceWalk, FewPairsAreLookedAtOnce) {
    const DistanceWalker worker({1, 1});
    const Scenario scenario = beside(3.5);
    const std::vector<RootPair> named = worker.named(scenario);
    ASSERT_LE(named.size(), 4u);
    ASSERT_FALSE(named.empty());
    const Walked walked = worker.walk_one(scenario);
    ASSERT_EQ(walked.waiting.size(), 1u);
    EXPECT_FALSE(walked.waiting[0].walks_again);
    EXPECT_EQ(walked.waiting[0].pairs, named);
}

TEST(DistanceWalk, AContactInTheFirstLookNeedsNothingElse) {
    std::size_t in_first_look = 0;
    for (SeededRandom random : seeds(40)) {
        DistanceWalker worker;
        const Scenario scenario = make_scenario({Pose{}, make_pose(random, 1)});
        const Walked first = worker.walk_one(scenario);
        ASSERT_EQ(first.waiting.size(), 1u);
        EXPECT_TRUE(first.waiting[0].walks_again);
        worker.give(first.waiting[0].pairs);
        const Walked second = worker.walk_one(scenario);
        if (second.waiting.empty()) {
            ++in_first_look;
            EXPECT_EQ(results_of(second.finished).at(0).kind, ScenarioClass::Contact);
            EXPECT_LT(worker.blocks_given(), blocks_of(worker.named(scenario)));
        }
    }
    EXPECT_GT(in_first_look, 0u);
}

TEST(DistanceWalk, CachedRootsNarrowTheSecondLook) {
    const Scenario scenario = beside(3.5);
    DistanceWalker alone;
    EXPECT_TRUE(alone.run(scenario).nearest);
    DistanceWalker neighbour;
    EXPECT_TRUE(neighbour.run(beside(3.49)).nearest);
    const std::size_t before = neighbour.blocks_given();
    EXPECT_TRUE(neighbour.run(scenario).nearest);
    EXPECT_LT(neighbour.blocks_given() - before, alone.blocks_given() / 4);
}

} // namespace cd::tests
