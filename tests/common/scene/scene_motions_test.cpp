// Proves that the scenarios of a scene with motions are those of all pairs of bodies present at
// both ends whose boxes over the whole motion come within reach; that each motion whose result
// tells something is among them; and that the scene's digest does not depend on the boxes.

#include "common/job/result/merge.hpp"
#include "common/job/run_scenario.hpp"
#include "common/job/trees_by_body.hpp"
#include "common/scene/scene_keys.hpp"
#include "common/scene/scene_poses.hpp"
#include "common/scene/swept_box.hpp"
#include "tests/common/scene/listed_steps.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/trees.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>

namespace cd::tests {

namespace {

using testing::HasSubstr;

constexpr double resolution = 0.02;

/// A scene whose trees and poses are at hand.
struct MovingScene {
    BodyTrees trees;
    std::vector<bool> is_fixed;
    std::vector<PosesOfStep> steps;
    std::vector<BodyPair> ignored = {};
    double reach = reach_of_motions(0, resolution);

    [[nodiscard]] Scene scene() const {
        Scene made{{}, PairSet(trees.size()), reach, resolution};
        for (std::size_t body = 0; body < trees.size(); ++body) {
            const auto& vertices = trees[body]->mesh().vertices();
            made.bodies.push_back({bounding_box(vertices),
                                   is_fixed[body],
                                   body_radius(vertices),
                                   "body." + std::to_string(body)});
        }
        for (const BodyPair& pair : ignored) {
            made.ignored.add(std::array{pair.a}, std::array{pair.b});
        }
        return made;
    }
    [[nodiscard]] Result<std::unique_ptr<ScenePoses>> opened() const {
        return ScenePoses::create(scene(), std::make_unique<ListedSteps>(steps));
    }
    [[nodiscard]] std::unique_ptr<ScenePoses> open() const {
        auto made = opened();
        EXPECT_TRUE(made) << (made ? "" : made.error().detail);
        return std::move(made.value());
    }
    [[nodiscard]] ScenarioResult run(const Scenario& scenario) const {
        Query query;
        query.level = Level::Any;
        query.question = Question::Motion;
        query.motion = MotionQuery{resolution, Until::Contact};
        return ScenarioRunner(TreesByBody(trees), query).run(scenario).result;
    }
};

std::shared_ptr<const ObbTree> box_of(const Vec3& size) {
    return std::make_shared<const ObbTree>(make_tree(make_box(size)));
}

MovingScene random_scene(std::mt19937_64& random) {
    MovingScene made;
    const std::size_t bodies = 3 + random() % 4;
    PosesOfStep poses;
    for (std::uint32_t body = 0; body < bodies; ++body) {
        made.trees.push_back(box_of(Vec3(uniform(random, 0.2, 2), uniform(random, 0.2, 2), 0.8)));
        made.is_fixed.push_back(random() % 3 == 0);
        poses.emplace_back(make_pose(random, 2.0));
        if (body > 0 && random() % 4 == 0) {
            made.ignored.push_back({body - 1, body});
        }
    }
    for (int step = 0; step < 4; ++step) {
        made.steps.push_back(poses);
        for (std::size_t body = 0; body < bodies; ++body) {
            if (made.is_fixed[body]) {
                continue;
            }
            poses[body] = key_after(
                *poses[body], uniform(random, 0, 60), random_axis(random), random_point(random, 1));
            if (random() % 6 == 0) {
                made.steps.back()[body].reset();
            }
        }
    }
    return made;
}

/// All pairs of bodies at all steps, as motions between the scene's keys.
std::vector<Scenario> all_motions(const MovingScene& scene) {
    const Scene placed = scene.scene();
    const auto keys =
        SceneKeys::create(std::make_unique<ListedSteps>(scene.steps), placed.bodies, resolution);
    EXPECT_TRUE(keys);
    std::vector<Scenario> motions;
    for (std::uint64_t step = 0; step + 1 < scene.steps.size(); ++step) {
        const PosesOfStep from = keys.value()->read(step).value();
        const PosesOfStep to = keys.value()->read(step + 1).value();
        for (std::uint32_t a = 0; a < from.size(); ++a) {
            for (std::uint32_t b = a + 1; b < from.size(); ++b) {
                const bool is_settled = step > 0 && scene.is_fixed[a] && scene.is_fixed[b];
                if (from[a] && from[b] && to[a] && to[b] && !is_settled &&
                    !placed.ignored.has({a, b})) {
                    motions.push_back(
                        {0, a, b, {*from[a], *from[b]}, step, PosePair{*to[a], *to[b]}});
                }
            }
        }
    }
    return motions;
}

bool have_boxes_that_meet(const MovingScene& scene, const Scenario& motion) {
    const Scene placed = scene.scene();
    const auto box = [&](std::uint32_t body, const Pose& from, const Pose& to) {
        const PlacedBody& each = placed.bodies[body];
        return swept_box({each.box, each.radius, path_between(from, to).value()}, scene.reach / 2);
    };
    const WorldBox a = box(motion.body_a, motion.poses.a, motion.to->a);
    const WorldBox b = box(motion.body_b, motion.poses.b, motion.to->b);
    return std::ranges::all_of(std::array{0u, 1u, 2u}, [&](std::size_t i) {
        return a.high.at(i) >= b.low.at(i) && b.high.at(i) >= a.low.at(i);
    });
}

auto place_of(const Scenario& scenario) {
    return std::tuple(*scenario.step, scenario.body_a, scenario.body_b);
}

/// A bullet that jumps over a wall between two steps, and a body far away.
MovingScene bullet_and_wall() {
    MovingScene scene;
    for (const Vec3& size : {Vec3(0.1, 0.1, 0.1), Vec3(0.01, 4, 4), Vec3(1, 1, 1)}) {
        scene.trees.push_back(box_of(size));
    }
    scene.is_fixed = {false, true, true};
    const std::optional<Pose> wall = moved_pose({0, 0, 0});
    const std::optional<Pose> far = moved_pose({50, 0, 0});
    for (const double x : {-6.0, -3.0, 3.0, 6.0}) {
        scene.steps.push_back({moved_pose({x, 0, 0}), wall, far});
    }
    return scene;
}

} // namespace

TEST(SceneMotions, AreThoseOfAllPairsByBruteForce) {
    std::uint64_t tested = 0;
    std::uint64_t apart = 0;
    for (SeededRandom random : seeds(raised(120))) {
        const MovingScene scene = random_scene(random);
        std::vector<Scenario> expected;
        const std::vector<Scenario> all = all_motions(scene);
        for (const Scenario& motion : all) {
            if (have_boxes_that_meet(scene, motion)) {
                expected.push_back(motion);
                expected.back().index = expected.size() - 1;
            }
        }
        const auto poses = scene.open();
        ASSERT_EQ(poses->count(), expected.size());
        EXPECT_EQ(poses->read(0, poses->count()).value(), expected);
        EXPECT_EQ(poses->steps()->steps(), scene.steps.size() - 1);
        StepCoverage coverage;
        for (const StepCoverage& step : poses->steps()->coverage()) {
            coverage += step;
            const std::uint64_t bodies = scene.trees.size();
            EXPECT_EQ(step.total(), bodies * (bodies - 1) / 2);
        }
        EXPECT_EQ(coverage.tested, expected.size());
        EXPECT_EQ(coverage.apart, all.size() - expected.size());
        tested += coverage.tested;
        apart += coverage.apart;
    }
    EXPECT_GT(tested, 200u);
    EXPECT_GT(apart, 200u);
}

TEST(SceneMotions, HaveEachMotionThatTellsSomething) {
    std::map<ScenarioClass, int> classes;
    for (SeededRandom random : seeds(raised(40))) {
        const MovingScene scene = random_scene(random);
        const auto poses = scene.open();
        const std::vector<Scenario> tested = poses->read(0, poses->count()).value();
        for (const Scenario& motion : all_motions(scene)) {
            const ScenarioResult result = scene.run(motion);
            ++classes[result.kind];
            if (facts_of(result).tells()) {
                EXPECT_TRUE(std::ranges::any_of(tested, [&](const Scenario& each) {
                    return place_of(each) == place_of(motion);
                }));
            }
        }
    }
    EXPECT_GT(classes[ScenarioClass::Separate], 200);
    EXPECT_GT(classes[ScenarioClass::Contact], 50);
    EXPECT_EQ(classes[ScenarioClass::Failed], 0);
}

TEST(SceneMotions, TheDigestDoesNotDependOnTheBoxes) {
    std::uint64_t more = 0;
    for (SeededRandom random : seeds(15)) {
        MovingScene scene = random_scene(random);
        const auto digest = [&](std::uint64_t& count) {
            const auto poses = scene.open();
            const std::vector<Scenario> scenarios = poses->read(0, poses->count()).value();
            count = scenarios.size();
            ResultMerger merger(count, SceneHead{});
            for (const Scenario& scenario : scenarios) {
                EXPECT_EQ(merger.add(scene.run(scenario)), ResultMerger::Outcome::Added);
            }
            return merger.digest();
        };
        std::uint64_t near = 0;
        std::uint64_t all = 0;
        const auto expected = digest(near);
        scene.reach = 100;
        EXPECT_EQ(digest(all), expected);
        more += all - near;
    }
    EXPECT_GT(more, 100u);
}

TEST(SceneMotions, WhatJumpsOverAWallBetweenTwoStepsMeetsItThere) {
    const MovingScene scene = bullet_and_wall();
    const auto poses = scene.open();
    const auto& coverage = poses->steps()->coverage();
    ASSERT_EQ(coverage.size(), 3u);
    EXPECT_EQ(coverage[0], (StepCoverage{0, 3, 0, 0, 0}));
    EXPECT_EQ(coverage[1], (StepCoverage{1, 1, 0, 1, 0}));
    EXPECT_EQ(coverage[2], (StepCoverage{0, 2, 0, 1, 0}));
    const ScenarioResult result = scene.run(poses->read(0, 1).value()[0]);
    EXPECT_EQ(result.kind, ScenarioClass::Contact);
    EXPECT_EQ(result.step, 1u);
    // The front of the bullet is at 0.05 - 3 + 6 tau, and the wall begins at -0.005.
    const double unit = std::ldexp(1.0, -static_cast<int>(result.motion->depth));
    const double meets = 2.945 / 6;
    EXPECT_LE(result.motion->t0 * unit, meets);
    EXPECT_GE(result.motion->t1 * unit, meets);
    EXPECT_LE((result.motion->t1 - result.motion->t0) * unit * 6, 4 * resolution);
    // Without motions the bodies never come near.
    Scene at_rest = scene.scene();
    at_rest.resolution.reset();
    const auto rest =
        ScenePoses::create(std::move(at_rest), std::make_unique<ListedSteps>(scene.steps));
    ASSERT_TRUE(rest);
    EXPECT_EQ(rest.value()->count(), 0u);
}

TEST(SceneMotions, ABodyIsAbsentThatIsSoAtOneEnd) {
    MovingScene scene = bullet_and_wall();
    scene.steps[3][0].reset();
    const auto poses = scene.open();
    EXPECT_EQ(poses->steps()->coverage()[1].tested, 1u);
    EXPECT_EQ(poses->steps()->coverage()[2], (StepCoverage{0, 0, 0, 1, 2}));
    EXPECT_EQ(poses->absences()[0], 1u);
    scene.steps[2][0].reset();
    EXPECT_EQ(scene.open()->absences()[0], 2u);
    EXPECT_EQ(scene.open()->count(), 0u);
}

TEST(SceneMotions, TimesHaveTheEndOfTheLast) {
    MovingScene scene = bullet_and_wall();
    const auto timed = ScenePoses::create(
        scene.scene(),
        std::make_unique<ListedSteps>(scene.steps, std::vector<double>{0, 0.5, 1.5, 4}));
    ASSERT_TRUE(timed);
    EXPECT_EQ(timed.value()->steps()->time_at(1, 0.5), 1.0);
    EXPECT_EQ(timed.value()->steps()->time_at(2, 1), 4.0);
    EXPECT_GT(timed.value()->moved(), 0);
    EXPECT_LT(timed.value()->moved(), 1e-9);
}

TEST(SceneMotions, OneStepAloneIsRefused) {
    MovingScene scene = bullet_and_wall();
    scene.steps.resize(1);
    const auto made = scene.opened();
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::BadInput);
    EXPECT_THAT(made.error().detail, HasSubstr("there is one step alone"));
}

TEST(SceneMotions, AMotionOfTooManyHalvingsIsNamed) {
    MovingScene scene = bullet_and_wall();
    scene.steps[2][0] = moved_pose({1e5, 0, 0});
    const auto made = scene.opened();
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::TooLarge);
    EXPECT_THAT(made.error().detail,
                HasSubstr("step 1: body.0 and body.1: the bodies move too far between two keys"));
    // Nobody asks about a pair that the rules ignore.
    scene.ignored = {{0, 1}, {0, 2}};
    EXPECT_TRUE(scene.opened());
}

} // namespace cd::tests
