// Proves that each step tests each bundle of lines with the bodies that it may hit, and leaves none
// out that it does hit.
#include "client/bundle/scene_bundles.hpp"

#include "client/bundle/shot_plan.hpp"
#include "common/job/run_scenario.hpp"
#include "tests/support/line_scene.hpp"
#include "tests/support/trees.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;

/// Steps whose poses are given.
class GivenSteps final : public StepPoses {
  public:
    explicit GivenSteps(std::vector<PosesOfStep> steps) : steps_(std::move(steps)) {}

    [[nodiscard]] std::uint64_t steps() const override { return steps_.size(); }
    [[nodiscard]] Result<PosesOfStep> read(std::uint64_t step) override { return steps_[step]; }
    [[nodiscard]] std::vector<double> times() const override { return times_of_steps; }

    std::vector<double> times_of_steps;

  private:
    std::vector<PosesOfStep> steps_;
};

/// Lines from six directions and bodies of a scene.
struct Yard {
    ShotsSpec spec;
    std::vector<std::shared_ptr<const Mesh>> meshes;
    std::vector<PosesOfStep> steps;
    std::vector<bool> are_ignored;

    Yard() {
        spec.grid.spacing = 0.25;
        spec.grid.tile = 4;
        spec.azimuth_deg = {0, 210, 3};
        spec.elevation_deg = {-20, 90, 2};
    }

    void add_body(Mesh mesh) {
        meshes.push_back(share(std::move(mesh)));
        are_ignored.push_back(false);
    }

    [[nodiscard]] LineTargets targets() const {
        LineTargets targets;
        for (const auto& mesh : meshes) {
            targets.bodies.push_back({bounding_box(mesh->vertices())});
        }
        targets.are_ignored = are_ignored;
        return targets;
    }
    [[nodiscard]] Aabb box() const {
        GivenSteps given(steps);
        return box_of_steps(targets(), given).value();
    }
    [[nodiscard]] Mesh lines() const { return shot_mesh(spec, box()).value(); }
    [[nodiscard]] std::vector<BundlePose> bundles() const {
        return shot_poses(spec, box()).value();
    }

    [[nodiscard]] std::unique_ptr<SceneBundles> make(std::vector<double> times = {}) const {
        auto given = std::make_unique<GivenSteps>(steps);
        given->times_of_steps = std::move(times);
        auto made = SceneBundles::create(
            targets(), {bundles(), bounding_box(lines().vertices())}, std::move(given));
        EXPECT_TRUE(made) << made.error().detail;
        return std::move(made.value());
    }
};

Pose at(double x, double y, double z) {
    return Pose::from_quaternion({1, 0, 0, 0}, Vec3(x, y, z));
}

std::vector<Scenario> all_of(SceneBundles& bundles) {
    return bundles.read(0, bundles.count()).value();
}

/// Bodies at random places, some absent at some steps.
Yard random_yard(std::mt19937_64& random) {
    Yard yard;
    yard.add_body(make_torus(0.6, 0.2, 16, 8));
    yard.add_body(make_sphere(1));
    yard.add_body(make_box(Vec3(0.5, 3, 0.125)));
    for (int step = 0; step < 3; ++step) {
        PosesOfStep poses;
        for (std::size_t body = 0; body < yard.meshes.size(); ++body) {
            poses.emplace_back(make_pose(random, 2));
        }
        yard.steps.push_back(std::move(poses));
    }
    yard.steps[1][2].reset();
    return yard;
}

} // namespace

TEST(SceneBundles, ScenariosAreByStepBundleAndBody) {
    std::mt19937_64 random(3);
    const Yard yard = random_yard(random);
    const auto made = yard.make({0.5, 1.5, 4});
    const std::vector<Scenario> scenarios = all_of(*made);
    const std::vector<BundlePose> bundles = yard.bundles();
    ASSERT_GT(scenarios.size(), 100u);
    std::set<std::tuple<std::uint64_t, std::uint32_t>> keys;
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        const Scenario& scenario = scenarios[i];
        EXPECT_EQ(scenario.index, i);
        EXPECT_EQ(scenario.body_b, 3u) << "the lines";
        ASSERT_LT(scenario.body_a, 3u);
        const std::uint64_t step = made->steps()->step_of(i);
        ASSERT_EQ(*scenario.step / bundles.size(), step);
        EXPECT_EQ(scenario.poses.a, *yard.steps[step][scenario.body_a]);
        EXPECT_EQ(scenario.poses.b, bundles[*scenario.step % bundles.size()].pose);
        EXPECT_TRUE(keys.emplace(*scenario.step, scenario.body_a).second);
    }
    EXPECT_TRUE(std::ranges::is_sorted(
        scenarios, {}, [](const Scenario& s) { return std::tuple(*s.step, s.body_a); }));
    EXPECT_EQ(made->steps()->steps(), 3u);
    EXPECT_EQ(made->steps()->time_of(2), 4);
    EXPECT_THAT(made->absences(), testing::ElementsAre(0, 0, 1));
    for (const StepCoverage& step : made->steps()->coverage()) {
        EXPECT_EQ(step.total(), 3 * bundles.size());
    }
    EXPECT_EQ(made->steps()->coverage()[1].absent, bundles.size());
    EXPECT_GT(made->steps()->coverage()[0].apart, 0u);
    const auto some = made->read(7, 60).value();
    EXPECT_TRUE(std::ranges::equal(some, std::span(scenarios).subspan(7, 60)));
}

TEST(SceneBundles, NoBodyThatABundleHitsIsLeftOut) {
    std::mt19937_64 random(8);
    std::uint64_t hits = 0;
    for (int round = 0; round < 4; ++round) {
        const Yard yard = random_yard(random);
        const auto made = yard.make();
        std::set<std::pair<std::uint64_t, std::uint32_t>> tested;
        for (const Scenario& scenario : all_of(*made)) {
            tested.emplace(*scenario.step, scenario.body_a);
        }
        const std::vector<BundlePose> bundles = yard.bundles();
        const ObbTree lines = make_tree(yard.lines());
        for (std::uint32_t body = 0; body < yard.meshes.size(); ++body) {
            const ObbTree tree = make_tree(*yard.meshes[body]);
            for (std::uint64_t place = 0; place < yard.steps.size() * bundles.size(); ++place) {
                const auto& pose = yard.steps[place / bundles.size()][body];
                if (!pose) {
                    continue;
                }
                const PosePair poses{*pose, bundles[place % bundles.size()].pose};
                const std::uint64_t count =
                    run_scenario(tree, lines, make_scenario(poses), shots_query(Level::Count))
                        .result.pair_count;
                hits += count;
                EXPECT_TRUE(count == 0 || tested.contains({place, body}));
            }
        }
    }
    EXPECT_GT(hits, 10'000u);
}

TEST(SceneBundles, ABodyAtTheIdentityHasTheBundlesOfAJobOfTwoBodies) {
    Yard yard;
    yard.add_body(boxes_and_plate());
    yard.steps = {{Pose()}};
    const Aabb box = bounding_box(yard.meshes[0]->vertices());
    EXPECT_EQ(yard.box().min, box.min);
    EXPECT_EQ(yard.box().max, box.max);
    const std::vector<BundlePose> bundles = shot_poses(yard.spec, box).value();
    const auto made = yard.make();
    const std::vector<Scenario> scenarios = all_of(*made);
    const ObbTree tree = make_tree(*yard.meshes[0]);
    const ObbTree lines = make_tree(yard.lines());
    auto next = scenarios.begin();
    for (std::size_t i = 0; i < bundles.size(); ++i) {
        const Scenario alone = make_scenario({Pose(), bundles[i].pose});
        const auto result = run_scenario(tree, lines, alone, shots_query(Level::Pairs)).result;
        if (next == scenarios.end() || *next->step != i) {
            EXPECT_EQ(result.pair_count, 0u);
            continue;
        }
        EXPECT_EQ(next->poses, alone.poses);
        const auto same = run_scenario(tree, lines, *next, shots_query(Level::Pairs)).result;
        EXPECT_EQ(same.pairs, result.pairs);
        EXPECT_EQ(same.hits, result.hits);
        ++next;
    }
    EXPECT_EQ(next, scenarios.end());
}

TEST(SceneBundles, FixedBodiesAreTestedAtEachStepAndIgnoredOnesAtNone) {
    Yard yard;
    yard.add_body(make_box(Vec3(1, 1, 1)));
    yard.add_body(make_box(Vec3(1, 1, 1)));
    yard.are_ignored[1] = true;
    yard.steps = {{Pose(), at(0, 40, 0)}, {Pose(), at(0, 40, 0)}};
    EXPECT_LE(yard.box().max.y(), 1) << "an ignored body needs no lines";
    auto targets = yard.targets();
    targets.bodies[0].is_fixed = true;
    const auto bundles = yard.bundles();
    const auto made = SceneBundles::create(targets,
                                           {bundles, bounding_box(yard.lines().vertices())},
                                           std::make_unique<GivenSteps>(yard.steps));
    ASSERT_TRUE(made);
    const auto coverage = made.value()->steps()->coverage();
    EXPECT_GT(coverage[0].tested, 0u);
    EXPECT_EQ(coverage[0], coverage[1]);
    EXPECT_EQ(coverage[0].ignored, bundles.size());
    EXPECT_EQ(coverage[0].tested + coverage[0].apart, bundles.size());
}

TEST(SceneBundles, WithoutABodyThereIsNoBox) {
    Yard yard;
    yard.add_body(make_box(Vec3(1, 1, 1)));
    yard.steps = {{std::nullopt}};
    GivenSteps given(yard.steps);
    const auto box = box_of_steps(yard.targets(), given);
    ASSERT_FALSE(box);
    EXPECT_EQ(box.error().code, ErrorCode::BadInput);
    EXPECT_THAT(box.error().detail, HasSubstr("is there at any step"));
    const auto stopped = box_of_steps(yard.targets(), given, [] { return true; });
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::Interrupted);
}

} // namespace cd::tests
