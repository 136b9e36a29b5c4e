// Proves that a descent requests the subtrees of a motion once, and that with only these subtrees
// cached the record equals that of the whole bodies.
#include "common/job/query_roots.hpp"
#include "common/job/run_motion.hpp"
#include "common/job/run_scenario.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/worker/execution/walks.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <vector>

namespace cd::tests {

namespace {

constexpr double resolution = 0.001;

/// A worker that has the upper trees of a long box and a torus.
class MotionWalk : public testing::TestWithParam<Level> {
  protected:
    MotionWalk() {
        job_->trees = {TreeId{1}, TreeId{2}};
        job_->query.level = GetParam();
        job_->query.question = Question::Motion;
        job_->query.motion = MotionQuery{resolution, Until::Contact};
        job_->radii = {radii_.a, radii_.b};
    }

    /// The torus moves along y, from one distance from the box's axis to another, at its end x = 9.
    [[nodiscard]] Scenario along_y(double from, double to) const {
        const auto keys =
            round_keys(std::array{PosePair{moved_pose(Vec3::Zero()), moved_pose({9, from, 0.2})},
                                  PosePair{moved_pose(Vec3::Zero()), moved_pose({9, to, 0.2})}},
                       radii_,
                       resolution)
                .value()
                .keys;
        Scenario scenario = make_scenario(keys[0]);
        scenario.to = keys[1];
        return scenario;
    }
    [[nodiscard]] Walked walk_one(const Scenario& scenario) const {
        const Walk part{job_,
                        TaskScenarios(std::vector{scenario}),
                        0,
                        1,
                        {{TreeId{1}, std::make_shared<const PartialObbTree>(held_box_)},
                         {TreeId{2}, std::make_shared<const PartialObbTree>(held_torus_)}},
                        std::make_shared<const DroppedScenarios>()};
        ScenarioClock clock(JobId{1});
        return walk(part, {}, clock);
    }
    void give(const std::vector<RootPair>& pairs) {
        for (const RootIndex root : roots_of_a(pairs)) {
            fill(held_box_, box_, root);
        }
        for (const RootIndex root : roots_of_b(pairs)) {
            fill(held_torus_, torus_, root);
        }
    }
    [[nodiscard]] ScenarioResult whole(const Scenario& scenario) const {
        RunOptions options;
        options.radii = radii_;
        const SubtreePair both{box_.tree.view(), torus_.tree.view()};
        return run_on_subtrees({&both, 1}, scenario, job_->query, options).result;
    }

    CutBody box_ = cut_body(make_gridded_box(Vec3(20, 1, 1), 12), 6);
    CutBody torus_ = cut_body(make_torus(1, 0.3, 60, 30), 4);
    BodyRadii radii_{body_radius(box_.tree.mesh().vertices()),
                     body_radius(torus_.tree.mesh().vertices())};
    PartialObbTree held_box_ = held_top(box_);
    PartialObbTree held_torus_ = held_top(torus_);
    std::shared_ptr<WorkerJob> job_ = std::make_shared<WorkerJob>();
};

} // namespace

TEST_P(MotionWalk, AsksForItsSubtreesOnceAndIsAnsweredByThem) {
    const Scenario onto = along_y(6, -6);
    const Walked first = walk_one(onto);
    EXPECT_EQ(first.finished.count, 0u);
    ASSERT_EQ(first.waiting.size(), 1u);
    EXPECT_TRUE(first.waiting[0].walks_again);
    const std::vector<RootPair>& named = first.waiting[0].pairs;
    EXPECT_LT(roots_of_a(named).size(), box_.top.root_count());
    give(named);
    const Walked second = walk_one(onto);
    ASSERT_EQ(second.finished.count, 1u);
    const ScenarioResult result = results_of(second.finished).at(0);
    EXPECT_TRUE(result.motion->event());
    EXPECT_EQ(encode_result(result), encode_result(whole(onto)));
    EXPECT_EQ(second.used.size(), roots_of_a(named).size() + roots_of_b(named).size());
}

TEST_P(MotionWalk, OutOfReachNeedsNoSubtrees) {
    const Scenario past = along_y(90, 80);
    const Walked walked = walk_one(past);
    ASSERT_EQ(walked.finished.count, 1u);
    EXPECT_EQ(encode_result(results_of(walked.finished).at(0)), encode_result(whole(past)));
}

INSTANTIATE_TEST_SUITE_P(Levels, MotionWalk, testing::Values(Level::Any, Level::Pairs));

} // namespace cd::tests
