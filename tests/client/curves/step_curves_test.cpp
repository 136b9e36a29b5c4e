// Proves that keys between the steps of a scene keep every point near the paths of bodies with and
// without velocities, that fewer keys do not, and that rows that contradict each other are refused.
#include "client/curves/step_curves.hpp"

#include "common/job/poses/pose_source.hpp"
#include "common/motion/motion_keys.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr double degree = 3.14159265358979323846 / 180;

class ListedSteps final : public StepPoses {
  public:
    ListedSteps(std::vector<PosesOfStep> poses, std::vector<double> times)
        : poses_(std::move(poses)), times_(std::move(times)) {}

    [[nodiscard]] std::uint64_t steps() const override { return poses_.size(); }
    [[nodiscard]] std::vector<double> times() const override { return times_; }
    [[nodiscard]] Result<PosesOfStep> read(std::uint64_t step) override { return poses_[step]; }

  private:
    std::vector<PosesOfStep> poses_;
    std::vector<double> times_;
};

const PoseRates braking{Vec3(12, 0, 0), Vec3(-4, 1, 0), Vec3(0.1, 0, 80 * degree)};
const PoseRates rising{Vec3(0, 0, 1), Vec3(0, 2, 0), Vec3(0, 300 * degree, 0)};

/// A scene of three steps: `car` brakes and then rises, `arm` turns by 170 degrees and by 60, and
/// `wall` rests.
struct CurvedScene {
    std::vector<PosesOfStep> poses;
    std::vector<double> times{10, 12, 12.5};
    std::vector<PoseRates> rates{braking, rising, {}};
    std::vector<PlacedBody> bodies;
    const Mesh mesh = make_box(Vec3(1, 2, 3));

    CurvedScene() {
        const Pose begin = moved_pose(Vec3(1, 2, 3));
        const Pose middle = curve(begin, 0).at(2);
        const Pose end = curve(middle, 1).at(0.5);
        const auto arm = [](double degrees) {
            return Pose::from_quaternion(quaternion_from_euler(0, 0, degrees),
                                         Vec3(degrees / 10, 0, 0));
        };
        const Pose wall = moved_pose(Vec3(0, 9, 0));
        poses = {{begin, arm(0), wall}, {middle, arm(170), wall}, {end, arm(230), wall}};
        const double radius = body_radius(mesh.vertices());
        bodies = {{bounding_box(mesh.vertices()), false, radius, "car"},
                  {bounding_box(mesh.vertices()), false, radius, "arm"},
                  {bounding_box(mesh.vertices()), true, radius, "wall"}};
    }

    [[nodiscard]] CurvePhase curve(const Pose& from, std::size_t step) const {
        return curve_of(from, rates[step], times[step + 1] - times[step]).value();
    }
    [[nodiscard]] Result<std::unique_ptr<CurvedSteps>> made(double off_max) const {
        StepRates of_car;
        of_car.bodies = {{0, 0}};
        of_car.rates = rates;
        of_car.name = [](std::uint64_t step, std::size_t) {
            return "car.csv: line " + std::to_string(step + 2);
        };
        return CurvedSteps::create(
            std::make_unique<ListedSteps>(poses, times), {of_car}, bodies, off_max);
    }
    [[nodiscard]] std::string problem(double off_max = 1e-3) const {
        const auto steps = made(off_max);
        return steps ? "none" : steps.error().detail;
    }
    /// Returns where a body is to be at a share of a step.
    [[nodiscard]] Pose right(std::size_t step, std::uint32_t body, double share) const {
        const Pose from = unit_key(*poses[step][body]).value();
        return body == 0
                   ? curve(from, step).at(share * (times[step + 1] - times[step]))
                   : pose_at(path_between(from, unit_key(*poses[step + 1][body]).value()).value(),
                             share);
    }
};

/// Returns how far motions between every `stride`-th key take a body's corners from its path.
double
largest_error(const CurvedScene& scene, CurvedSteps& keys, std::uint32_t body, std::size_t stride) {
    const std::vector<double> times = keys.times();
    double largest = 0;
    std::size_t next = 0;
    for (std::size_t key = 0; key + 1 < times.size(); key = next) {
        const std::size_t step = times[key] < scene.times[1] ? 0 : 1;
        next = key + 1;
        while (next - key < stride && times[next] < scene.times[step + 1]) {
            ++next;
        }
        const BodyPath path = path_between(unit_key(*keys.read(key).value()[body]).value(),
                                           unit_key(*keys.read(next).value()[body]).value())
                                  .value();
        const double seconds = scene.times[step + 1] - scene.times[step];
        for (int i = 0; i <= 32; ++i) {
            const double time = times[key] + i / 32.0 * (times[next] - times[key]);
            const Pose right = scene.right(step, body, (time - scene.times[step]) / seconds);
            const Pose moved = pose_at(path, i / 32.0);
            for (const Vec3& vertex : scene.mesh.vertices()) {
                largest = std::max(largest, (moved.apply(vertex) - right.apply(vertex)).norm());
            }
        }
    }
    return largest;
}

} // namespace

TEST(StepCurves, KeysKeepEveryPointNearThePaths) {
    const CurvedScene scene;
    for (const double off_max : {1.0, 1e-2, 1e-4}) {
        const auto keys = scene.made(off_max);
        ASSERT_TRUE(keys) << keys.error().detail;
        for (const std::uint32_t body : {0u, 1u}) {
            EXPECT_LE(largest_error(scene, *keys.value(), body, 1), off_max / 2);
        }
        EXPECT_LE(largest_error(scene, *keys.value(), 2, 1), 1e-12);
    }
    const auto keys = scene.made(1e-2);
    EXPECT_GT(largest_error(scene, *keys.value(), 0, 4), 5e-3);
}

TEST(StepCurves, ABodyWithoutVelocitiesAsksForKeysWhereOthersHaveThem) {
    // Cutting a step of a large turn changes its pace, so it takes keys enough for that.
    CurvedScene scene;
    scene.rates = {{Vec3(1, 0, 0), Vec3(-0.1, 0, 0), Vec3::Zero()}, {}, {}};
    scene.poses[1][0] = scene.curve(*scene.poses[0][0], 0).at(2);
    scene.poses[2][0] = scene.poses[1][0];
    const auto keys = scene.made(1e-2);
    ASSERT_TRUE(keys) << keys.error().detail;
    EXPECT_LE(largest_error(scene, *keys.value(), 1, 1), 5e-3);
    for (PosesOfStep& step : scene.poses) {
        step[1] = scene.poses[0][1];
    }
    EXPECT_GT(keys.value()->steps(), scene.made(1e-2).value()->steps());
}

TEST(StepCurves, TheGivenPosesAreKeysAtTheirTimes) {
    const CurvedScene scene;
    const auto keys = scene.made(1e-3);
    ASSERT_TRUE(keys) << keys.error().detail;
    const std::vector<double> times = keys.value()->times();
    ASSERT_EQ(times.size(), keys.value()->steps());
    EXPECT_TRUE(std::ranges::is_sorted(times, std::ranges::less_equal()));
    for (std::size_t step = 0; step < 3; ++step) {
        const auto found = std::ranges::find(times, scene.times[step]);
        ASSERT_NE(found, times.end());
        const auto key = static_cast<std::uint64_t>(found - times.begin());
        EXPECT_EQ(keys.value()->read(key).value(), scene.poses[step]);
    }
    EXPECT_EQ(times.front(), 10);
    EXPECT_EQ(times.back(), 12.5);
}

TEST(StepCurves, AStraightPathHasTheGivenStepsAlone) {
    CurvedScene scene;
    scene.times.clear();
    scene.rates.assign(3, {Vec3(3, 0, 0), Vec3::Zero(), Vec3::Zero()});
    for (std::size_t step = 0; step < 3; ++step) {
        scene.poses[step][0] = moved_pose(Vec3(3.0 * static_cast<double>(step), 0, 0));
    }
    const auto keys = scene.made(1e-9);
    ASSERT_TRUE(keys) << keys.error().detail;
    EXPECT_EQ(keys.value()->steps(), 3u);
    EXPECT_EQ(keys.value()->times(), (std::vector<double>{0, 1, 2}));
}

TEST(StepCurves, ABodyThatIsAbsentAtAStepIsAbsentOnTheWay) {
    CurvedScene scene;
    scene.poses[2][0].reset();
    const auto keys = scene.made(1e-3);
    ASSERT_TRUE(keys) << keys.error().detail;
    const std::vector<double> times = keys.value()->times();
    for (std::uint64_t key = 0; key < times.size(); ++key) {
        EXPECT_EQ(keys.value()->read(key).value()[0].has_value(), times[key] <= 12) << key;
    }
    scene.poses[0][0].reset();
    // Nobody needs keys then.
    EXPECT_EQ(scene.made(1e-3).value()->steps(), 3u);
}

TEST(StepCurves, RowsThatContradictEachOtherAreRefused) {
    const auto with_gap = [](double gap) {
        CurvedScene scene;
        const Pose& pose = *scene.poses[1][0];
        scene.poses[1][0] =
            Pose::from_quaternion(pose.quaternion(), pose.translation() + Vec3(0, gap, 0));
        scene.poses[2][0] = scene.curve(*scene.poses[1][0], 1).at(0.5);
        return scene.problem();
    };
    EXPECT_EQ(with_gap(0.00024), "none");
    EXPECT_THAT(with_gap(0.00026),
                StartsWith("car.csv: line 3: the velocities of the row before miss this pose by up "
                           "to 0.00026, more than a quarter of 0.001; "));
    CurvedScene late;
    late.times[2] = 12;
    EXPECT_EQ(late.problem(), "car.csv: line 4: the time 12 is not after 12 of the step before");
}

TEST(StepCurves, WhatCannotBeFollowedIsRefused) {
    EXPECT_THAT(CurvedScene().problem(1e-12),
                HasSubstr("car.csv: line 2: numbers of 64 bits do not tell the curve"));
    CurvedScene turned;
    turned.poses[2][1] = Pose::from_quaternion(quaternion_from_euler(0, 0, 350), Vec3::Zero());
    EXPECT_THAT(turned.problem(),
                StartsWith("step 1: arm: two keys of a motion are turned by 180"));
    CurvedScene fast;
    fast.rates[0] = {Vec3::Zero(), Vec3::Zero(), Vec3(0, 0, 1e7)};
    fast.poses[1][0] = fast.curve(*fast.poses[0][0], 0).at(2);
    fast.poses[2][0] = fast.curve(*fast.poses[1][0], 1).at(0.5);
    EXPECT_THAT(fast.problem(), StartsWith("step 0: the curve takes more than 1e+06 keys"));
}

} // namespace cd::tests
