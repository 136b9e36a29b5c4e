// Proves that poses become motions from each to the next, with their ids and times, and that keys
// between which there is no motion are refused by their place.
#include "client/job/job_motions.hpp"

#include "common/motion/body_path.hpp"
#include "common/motion/motion.hpp"
#include "tests/support/motions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace cd::tests {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double resolution = 0.125;

std::unique_ptr<PoseSource> source_of(const std::vector<Pose>& of_b) {
    std::vector<Scenario> scenarios(of_b.size());
    for (std::size_t i = 0; i < of_b.size(); ++i) {
        scenarios[i].index = i;
        scenarios[i].poses.b = of_b[i];
    }
    return make_list_source(std::move(scenarios));
}

Result<JobMotions> motions_of(const std::vector<Pose>& of_b, const PoseLabels& labels = {}) {
    const auto poses = source_of(of_b);
    return make_motions(
        *poses, labels, make_box(Vec3(1, 1, 1)), make_box(Vec3(1, 2, 3)), resolution);
}

std::string problem_with(const std::vector<Pose>& of_b, const PoseLabels& labels = {}) {
    const auto made = motions_of(of_b, labels);
    return made ? "none" : made.error().detail;
}

std::vector<Pose> some_keys() {
    return {moved_pose(Vec3(3, 0, 0)),
            turned_pose(30, Vec3(0, 0, 1), Vec3(0, 0.1, 0)),
            turned_pose(90, Vec3(0, 0, 1), Vec3(0, 4, 0))};
}

} // namespace

TEST(JobMotions, LeadFromEachPoseToTheNext) {
    const auto made = motions_of(some_keys());
    ASSERT_TRUE(made) << made.error().detail;
    ASSERT_EQ(made.value().poses->count(), 2u);
    const auto scenarios = made.value().poses->read(0, 2);
    ASSERT_TRUE(scenarios);
    const BodyRadii radii{body_radius(make_box(Vec3(1, 1, 1)).vertices()),
                          body_radius(make_box(Vec3(1, 2, 3)).vertices())};
    for (std::size_t i = 0; i < 2; ++i) {
        const Scenario& scenario = scenarios.value()[i];
        EXPECT_EQ(scenario.index, i);
        ASSERT_TRUE(scenario.to);
        EXPECT_TRUE(Motion::create(scenario.poses, *scenario.to, radii, resolution));
        EXPECT_NEAR(
            (scenario.poses.b.translation() - some_keys()[i].translation()).norm(), 0, 1e-9);
    }
    EXPECT_EQ(*scenarios.value()[0].to, scenarios.value()[1].poses);
    EXPECT_LT(made.value().moved.b, 1e-9);
    EXPECT_TRUE(made.value().labels.is_empty());
}

TEST(JobMotions, HaveTheTimesOfBothPoses) {
    PoseLabels labels;
    labels.texts = {"start", "middle", "end"};
    labels.times = {0.5, 1.5, 4};
    const auto made = motions_of(some_keys(), labels);
    ASSERT_TRUE(made) << made.error().detail;
    const PoseLabels& of_motions = made.value().labels;
    EXPECT_THAT(of_motions.texts, ElementsAre("start", "middle"));
    EXPECT_THAT(of_motions.times, ElementsAre(0.5, 1.5));
    EXPECT_THAT(of_motions.end_times, ElementsAre(1.5, 4));
    EXPECT_TRUE(of_motions.columns().fit(of_motions, 2));
    EXPECT_EQ(of_motions.time_at(1, 0.5), 2.75);
    EXPECT_EQ(PoseLabels().time_at(7, 0.25), 7.25);
}

TEST(JobMotions, RefuseKeysWithoutAMotionByTheirPlace) {
    EXPECT_THAT(problem_with({moved_pose(Vec3(1, 0, 0))}), HasSubstr("one pose alone"));
    EXPECT_THAT(problem_with({moved_pose(Vec3(3, 0, 0)),
                              moved_pose(Vec3(2, 0, 0)),
                              turned_pose(180, Vec3(0, 0, 1))}),
                HasSubstr("pose 2: "));
    const Pose squeezed = Pose::from_matrix(2 * Mat3::Identity(), Vec3::Zero());
    EXPECT_THAT(problem_with({moved_pose(Vec3(3, 0, 0)), squeezed}), HasSubstr("pose 1: "));
    PoseLabels labels;
    labels.times = {0, 2, 2};
    EXPECT_THAT(problem_with(some_keys(), labels),
                HasSubstr("pose 2: the time 2 is not after 2 of pose 1"));
    // A motion of a thousand kilometres at this resolution has too many parts.
    EXPECT_THAT(problem_with({moved_pose(Vec3(1e6, 0, 0)), moved_pose(Vec3(-1e6, 0, 0))}),
                HasSubstr("pose 1: "));
}

TEST(JobMotions, StepsMoveNoVertexFartherThanAsked) {
    const Mesh body = make_box(Vec3(1, 2, 3));
    PoseLabels labels;
    labels.times = {0, 1, 3};
    for (const double max_step : {1.0, 0.01}) {
        const auto keys = source_of(some_keys());
        const auto made = make_steps(*keys, labels, make_box(Vec3(1, 1, 1)), body, max_step);
        ASSERT_TRUE(made) << made.error().detail;
        const std::uint64_t count = made.value().poses->count();
        ASSERT_EQ(made.value().labels.times.size(), count);
        EXPECT_EQ(made.value().labels.times.back(), 3);
        const auto scenarios = made.value().poses->read(0, count);
        ASSERT_TRUE(scenarios);
        for (const Pose& given : some_keys()) {
            EXPECT_EQ(std::ranges::count_if(
                          scenarios.value(),
                          [&](const Scenario& scenario) { return scenario.poses.b == given; }),
                      1)
                << "the given poses stay";
        }
        double largest = 0;
        for (std::size_t i = 0; i + 1 < count; ++i) {
            const Pose& from = scenarios.value()[i].poses.b;
            const Pose& to = scenarios.value()[i + 1].poses.b;
            EXPECT_FALSE(scenarios.value()[i].to);
            EXPECT_LT(made.value().labels.times[i], made.value().labels.times[i + 1]);
            for (const Vec3& vertex : body.vertices()) {
                const Vec3 moved = to.rotation() * vertex + to.translation() -
                                   (from.rotation() * vertex + from.translation());
                largest = std::max(largest, moved.norm());
            }
        }
        EXPECT_LE(largest, max_step);
        EXPECT_GT(largest, max_step / 8) << "not far more poses than needed";
    }
    const auto keys = source_of(some_keys());
    const auto many = make_steps(*keys, {}, make_box(Vec3(1, 1, 1)), body, 1e-5);
    ASSERT_FALSE(many);
    EXPECT_EQ(many.error().code, ErrorCode::TooLarge);
    EXPECT_THAT(many.error().detail, HasSubstr("take larger steps"));
}

TEST(JobMotions, StepsBelowTheRoundingOfPosesAreRefused) {
    const auto keys = source_of({moved_pose(Vec3(1e6, 0, 0)), moved_pose(Vec3(1e6, 1e-9, 0))});
    const auto made = make_steps(*keys, {}, make_box(Vec3(1, 1, 1)), make_box(Vec3(1, 1, 1)), 1e-9);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::BadInput);
    EXPECT_THAT(made.error().detail, HasSubstr("max_step = 1e-09 is too small"));
}

TEST(JobMotions, BetweenKeysMotionsAreAsNearAsTheySay) {
    const double radius = body_radius(make_box(Vec3(1, 2, 3)).vertices());
    std::mt19937_64 random(7);
    double nearest = 1;
    for (int round = 0; round < 200; ++round) {
        const Pose from = turned_pose(uniform(random, 0, 360), random_axis(random));
        const Quaternion turn =
            turned_pose(uniform(random, 0, 90), random_axis(random)).quaternion();
        const Pose to = Pose::from_quaternion(turn * from.quaternion(), random_point(random, 5));
        const auto made = motions_of({from, to});
        ASSERT_TRUE(made) << made.error().detail;
        const Scenario scenario = made.value().poses->read(0, 1).value()[0];
        const BodyPath rounded = path_between(scenario.poses.b, scenario.to->b).value();
        const BodyPath given = path_between(from, to).value();
        for (int step = 0; step <= 16; ++step) {
            const Pose l = pose_at(rounded, step / 16.0);
            const Pose r = pose_at(given, step / 16.0);
            const double off = (l.rotation() - r.rotation()).norm() * radius +
                               (l.translation() - r.translation()).norm();
            EXPECT_LE(off, made.value().moved_between.b) << round;
            nearest = std::min(nearest, 1 - off / made.value().moved_between.b);
        }
    }
    EXPECT_LT(nearest, 0.99) << "the bound is not far too large";
}

TEST(JobMotions, SayHowFarRoundingMovesTheBodies) {
    EXPECT_EQ(moved_text({2.5e-13, 0}, "mm"),
              "rounding moved the bodies by at most 2.5e-13 and 0 mm");
}

} // namespace cd::tests
