// Proves that random scenarios do not depend on the number of threads or the count, that they are
// of the paper's kind (small to medium penetration), and that bodies that cannot meet end the
// search.

#include "common/job/poses/random_poses.hpp"

#include "common/core/limits/engine.hpp"
#include "common/geometry/aabb.hpp"
#include "common/job/poses/made_poses.hpp"
#include "common/search/contact_search.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>

namespace cd::tests {

namespace {

bool collides(const ObbTree& a, const ObbTree& b, const PosePair& poses) {
    return make_search(a.view(), b.view(), poses)->any(a.view(), b.view());
}

} // namespace

TEST(RandomPoses, AreTheSameForAnyNumberOfThreadsAndAnyCount) {
    const ObbTree a = make_tree(make_torus(1, 0.3, 16, 8));
    const ObbTree b = make_tree(make_box(Vec3(0.4, 0.6, 0.9)));
    RandomPoses options;
    options.count = 40;
    ThreadPool one(1);
    ThreadPool three(3);
    const auto scenarios = make_random_poses(options, a, b, one);
    ASSERT_EQ(scenarios.size(), 40u);
    EXPECT_EQ(make_random_poses(options, a, b, three), scenarios);
    options.count = 7;
    const auto fewer = make_random_poses(options, a, b, three);
    EXPECT_EQ(fewer, std::vector<Scenario>(scenarios.begin(), scenarios.begin() + 7));
    options.seed = 2;
    EXPECT_NE(make_random_poses(options, a, b, one), fewer);
}

TEST(RandomPoses, PushABallIntoABallByTheShareAskedFor) {
    const ObbTree ball = make_tree(make_sphere(4));
    RandomPoses options;
    options.count = 60;
    options.penetration_min = 0.01;
    options.penetration_max = 0.04;
    ThreadPool pool(2);
    const double diagonal = bounding_box(ball.mesh().vertices()).diagonal();
    Vec3 sum = Vec3::Zero();
    for (const Scenario& scenario : make_random_poses(options, ball, ball, pool)) {
        EXPECT_EQ(scenario.poses.a, Pose{});
        EXPECT_EQ(scenario.poses.b.kind(), Pose::Kind::Quaternion);
        EXPECT_TRUE(collides(ball, ball, scenario.poses));
        const double penetration = (2 - scenario.poses.b.translation().norm()) / diagonal;
        EXPECT_GT(penetration, 0.01 - 0.001);
        EXPECT_LT(penetration, 0.04 + 0.003) << "the facets lie up to 0.3 % inside the sphere";
        sum += scenario.poses.b.translation().normalized();
    }
    EXPECT_LT(sum.norm() / 60, 0.4) << "directions come from all sides";
}

TEST(RandomPoses, WithoutPenetrationTheBodiesJustCollide) {
    const ObbTree a = make_tree(make_box(Vec3(1, 2, 3)));
    const ObbTree b = make_tree(make_torus(0.5, 0.1, 12, 6));
    RandomPoses options;
    options.count = 20;
    options.penetration_min = 0;
    options.penetration_max = 0;
    ThreadPool pool(2);
    for (const Scenario& scenario : make_random_poses(options, a, b, pool)) {
        EXPECT_TRUE(collides(a, b, scenario.poses));
        // A thousandth farther out on the line there is no contact.
        const Vec3 outwards = scenario.poses.b.translation() * 1.002;
        const Pose apart = Pose::from_quaternion(scenario.poses.b.quaternion(), outwards);
        EXPECT_FALSE(collides(a, b, {Pose{}, apart}));
    }
}

TEST(RandomPoses, BodiesThatCannotMeetEndTheSearch) {
    // Two distant points, and a point between them: no line ever collides.
    const ObbTree far_points =
        make_tree(make_mesh({Vec3(-1, 0, 0), Vec3(1, 0, 0)}, {{0, 0, 0}, {1, 1, 1}}));
    const ObbTree point = make_tree(make_mesh({Vec3(0.1, 0.2, 0.3)}, {{0, 0, 0}}));
    RandomPoses options;
    options.count = 3;
    ThreadPool pool(1);
    for (const Scenario& scenario : make_random_poses(options, far_points, point, pool)) {
        EXPECT_TRUE(scenario.poses.b.is_finite());
        EXPECT_FALSE(collides(far_points, point, scenario.poses));
    }
}

TEST(ComputedPoses, AreTheSameInRunsOfAnySize) {
    const ObbTree a = make_tree(make_torus(1, 0.3, 16, 8));
    const ObbTree b = make_tree(make_box(Vec3(0.4, 0.6, 0.9)));
    RandomPoses options;
    options.count = 90;
    ThreadPool pool(2);
    const auto expected = make_random_poses(options, a, b, pool);
    for (const std::uint64_t run : {1u, 7u, 16u, 90u}) {
        const auto source = make_computed_source(
            options.count, random_scenarios(options, a, b), 2, [] { return false; });
        ASSERT_EQ(source->count(), 90u);
        std::vector<Scenario> scenarios;
        while (scenarios.size() < 90) {
            const auto read =
                source->read(scenarios.size(), std::min<std::uint64_t>(run, 90 - scenarios.size()));
            ASSERT_TRUE(read);
            scenarios.insert(scenarios.end(), read.value().begin(), read.value().end());
        }
        EXPECT_EQ(scenarios, expected) << run;
        EXPECT_EQ(source->read(40, 1).value(), std::vector<Scenario>{expected[40]});
        EXPECT_EQ(source->read(3, 20).value(),
                  std::vector<Scenario>(expected.begin() + 3, expected.begin() + 23))
            << "also backwards";
    }
}

TEST(ComputedPoses, AreMadeAheadInBoundedNumber) {
    std::atomic<std::uint64_t> made = 0;
    const std::uint64_t count = std::uint64_t(1) << 40;
    constexpr std::uint64_t ahead_max =
        limits::computed_windows_max * limits::computed_window_scenarios;
    {
        const auto source = make_computed_source(
            count,
            [&](std::uint64_t index) {
                ++made;
                return make_scenario({}, index);
            },
            1,
            [] { return false; });
        ASSERT_TRUE(source->read(0, 100));
        EXPECT_EQ(source->read(count - 2, 2).value().back().index, count - 1);
        EXPECT_EQ(source->read(1000, 2).value().front().index, 1000u);
    }
    EXPECT_GE(made, 104u);
    EXPECT_LE(made, 3 * (ahead_max + 100)) << "for each of the three reads";
}

TEST(ComputedPoses, AReadThatIsStoppedEnds) {
    std::atomic<bool> stopped = false;
    const auto source = make_computed_source(
        1000,
        [&](std::uint64_t index) {
            while (!stopped) {
                std::this_thread::yield();
            }
            return make_scenario({}, index);
        },
        1,
        [&] {
            stopped = true;
            return true;
        });
    const auto read = source->read(0, 600);
    ASSERT_FALSE(read) << "no scenario is there before the read is stopped";
    EXPECT_EQ(read.error().code, ErrorCode::Interrupted);
}

} // namespace cd::tests
