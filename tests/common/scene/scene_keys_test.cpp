// Proves that any two bodies of a scene have an exact motion between its keys, that keys are a
// function of the poses, and that what is no key is named by its step and body.

#include "common/scene/scene_keys.hpp"

#include "common/core/limits/engine.hpp"
#include "common/motion/motion.hpp"
#include "common/motion/motion_keys.hpp"
#include "tests/common/scene/listed_steps.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/rounds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cd::tests {

namespace {

using testing::HasSubstr;

/// Bodies, their poses at each step, and the resolution of their motions.
struct Moves {
    std::vector<PlacedBody> bodies;
    std::vector<PosesOfStep> steps;
    double resolution = 1e-3;

    [[nodiscard]] Result<std::unique_ptr<SceneKeys>> keys() const {
        return SceneKeys::create(std::make_unique<ListedSteps>(steps), bodies, resolution);
    }
};

Moves random_moves(std::mt19937_64& random) {
    Moves made;
    made.resolution = std::pow(10, uniform(random, -4, 0));
    const double reach = std::exp2(uniform(random, -10, 10));
    PosesOfStep poses;
    for (int body = 0; body < 4; ++body) {
        made.bodies.push_back({{}, false, uniform(random, 0, 1), "body." + std::to_string(body)});
        poses.emplace_back(body == 0 ? make_matrix_pose(random, reach) : make_pose(random, reach));
    }
    for (int step = 0; step < 5; ++step) {
        made.steps.push_back(poses);
        if (random() % 3 == 0) {
            made.steps.back()[random() % 4].reset();
        }
        for (std::size_t body = 1; body < 4; ++body) {
            poses[body] = key_after(*poses[body],
                                    uniform(random, 0, 100),
                                    random_axis(random),
                                    random_point(random, 1));
        }
    }
    return made;
}

std::vector<PosesOfStep> read_all(SceneKeys& keys) {
    std::vector<PosesOfStep> steps;
    for (std::uint64_t step = 0; step < keys.steps(); ++step) {
        steps.push_back(keys.read(step).value());
    }
    return steps;
}

/// A motion of two bodies of a scene, from a step to the next.
struct PairMotion {
    PosePair from;
    PosePair to;
    BodyRadii radii;

    [[nodiscard]] Result<Motion> at(double resolution) const {
        return Motion::create(from, to, radii, resolution);
    }
};

std::vector<PairMotion> motions_of(const Moves& moves, const std::vector<PosesOfStep>& steps) {
    std::vector<PairMotion> motions;
    for (std::size_t step = 0; step + 1 < steps.size(); ++step) {
        const PosesOfStep& from = steps[step];
        const PosesOfStep& to = steps[step + 1];
        for (std::size_t b = 1; b < from.size(); ++b) {
            for (std::size_t a = 0; a < b; ++a) {
                if (from[a] && from[b] && to[a] && to[b]) {
                    motions.push_back({{*from[a], *from[b]},
                                       {*to[a], *to[b]},
                                       {moves.bodies[a].radius, moves.bodies[b].radius}});
                }
            }
        }
    }
    return motions;
}

/// The keys of all steps on a grid that has so many bits less.
std::vector<PosesOfStep> on_finer_grid(const Moves& moves, KeyGrid grid, unsigned less) {
    grid.bits -= less;
    std::vector<PosesOfStep> steps = moves.steps;
    for (PosesOfStep& poses : steps) {
        for (auto& pose : poses) {
            pose = pose ? std::optional(grid.rounded(unit_key(*pose).value())) : std::nullopt;
        }
    }
    return steps;
}

} // namespace

TEST(SceneKeys, AnyTwoBodiesHaveAnExactMotionBetweenThem) {
    std::uint64_t motions = 0;
    std::uint64_t refused_if_finer = 0;
    for (SeededRandom random : seeds(raised(80))) {
        const Moves moves = random_moves(random);
        const auto keys = moves.keys();
        ASSERT_TRUE(keys) << keys.error().detail;
        for (const PairMotion& each : motions_of(moves, read_all(*keys.value()))) {
            const auto motion = each.at(moves.resolution);
            ASSERT_TRUE(motion) << motion.error().detail;
            EXPECT_LT(motion.value().depth(), keys.value()->grid().bits);
            ++motions;
        }
        if (keys.value()->grid().bits > 6) {
            const auto finer = on_finer_grid(moves, keys.value()->grid(), 6);
            for (const PairMotion& each : motions_of(moves, finer)) {
                refused_if_finer += each.at(moves.resolution) ? 0 : 1;
            }
        }
    }
    EXPECT_GT(motions, 500u);
    EXPECT_GT(refused_if_finer, 100u) << "a finer grid has poses that are not exact";
}

TEST(SceneKeys, AreAFunctionOfThePosesAndAsNearAsTheySay) {
    for (SeededRandom random : seeds(30)) {
        const Moves moves = random_moves(random);
        const auto keys = moves.keys();
        ASSERT_TRUE(keys);
        const std::vector<PosesOfStep> steps = read_all(*keys.value());
        EXPECT_EQ(read_all(*moves.keys().value()), steps);
        double farthest = 0;
        for (std::size_t step = 0; step < steps.size(); ++step) {
            for (std::size_t body = 0; body < moves.bodies.size(); ++body) {
                ASSERT_EQ(steps[step][body].has_value(), moves.steps[step][body].has_value());
                if (!steps[step][body]) {
                    continue;
                }
                EXPECT_TRUE(keys.value()->grid().holds(*steps[step][body]));
                const Vec3 point(moves.bodies[body].radius, 0, 0);
                const Vec3 moved =
                    steps[step][body]->apply(point) - moves.steps[step][body]->apply(point);
                farthest = std::max(farthest, moved.norm());
            }
        }
        EXPECT_LE(farthest, keys.value()->moved() * (1 + 1e-9) + 1e-12);
        EXPECT_GT(keys.value()->moved(), 0);
        EXPECT_LT(keys.value()->moved(), moves.resolution);
    }
}

TEST(SceneKeys, TheGridDoesNotDependOnWhichBodiesMayMeet) {
    // Two vehicles 1000 m apart move 2 m each; the third rests.
    Moves moves;
    moves.resolution = 1.0 / 64;
    moves.bodies = {{{}, false, 2, "one"}, {{}, false, 2, "two"}, {{}, true, 2, "post"}};
    const Pose post = moved_pose({5, 5, 0});
    moves.steps = {{moved_pose({0, 0, 0}), moved_pose({1000, 0, 0}), post},
                   {moved_pose({2, 0, 0}), moved_pose({998, 0, 0}), post}};
    const auto keys = moves.keys();
    ASSERT_TRUE(keys);
    // Each moves 1 m from the middle, so M is 2, a little more: eight halvings.
    EXPECT_EQ(keys.value()->grid().bits, 9u);
    EXPECT_EQ(keys.value()->grid().exponent, 10);
}

TEST(SceneKeys, BodiesThatRideTogetherNeedNoMoreThanTheMostHalvings) {
    Moves moves;
    moves.resolution = 1e-6;
    moves.bodies = {{{}, false, 2, "truck"}, {{}, false, 2, "trailer"}};
    moves.steps = {{moved_pose({0, 0, 0}), moved_pose({-5, 0, 0})},
                   {moved_pose({30, 0, 0}), moved_pose({25, 0, 0})}};
    const auto keys = moves.keys();
    ASSERT_TRUE(keys) << keys.error().detail;
    EXPECT_EQ(keys.value()->grid().bits, limits::motion_depth_max + 1);
    const auto motions = motions_of(moves, read_all(*keys.value()));
    ASSERT_EQ(motions.size(), 1u);
    const auto motion = motions[0].at(moves.resolution);
    ASSERT_TRUE(motion) << motion.error().detail;
    EXPECT_EQ(motion.value().depth(), 0u);
}

TEST(SceneKeys, ErrorsNameTheStepAndTheBody) {
    const Pose rest = moved_pose({0, 0, 0});
    const auto problem = [&](const Pose& pose) {
        Moves moves;
        moves.bodies = {{{}, false, 1, "car"}, {{}, false, 1, "lorry"}};
        moves.steps = {{rest, rest}, {rest, rest}, {rest, pose}};
        const auto keys = moves.keys();
        EXPECT_FALSE(keys);
        return keys ? "none" : keys.error().detail;
    };
    EXPECT_THAT(problem(moved_pose({std::numeric_limits<double>::infinity(), 0, 0})),
                HasSubstr("step 2: lorry: a key of a motion has a number that is not finite"));
    EXPECT_THAT(problem(Pose::from_matrix(2 * Mat3::Identity(), Vec3::Zero())),
                HasSubstr("step 2: lorry: the matrix of a key is no rotation"));
    EXPECT_THAT(problem(turned_pose(180, Vec3(0, 0, 1))),
                HasSubstr("step 1: lorry: two keys of a motion are turned by 180 degrees"));
}

TEST(SceneKeys, StopWhenAsked) {
    Moves moves;
    moves.bodies = {{{}, false, 1, "car"}};
    moves.steps = {{moved_pose({0, 0, 0})}};
    const auto keys = SceneKeys::create(
        std::make_unique<ListedSteps>(moves.steps), moves.bodies, 1, [] { return true; });
    ASSERT_FALSE(keys);
    EXPECT_EQ(keys.error().code, ErrorCode::Interrupted);
}

} // namespace cd::tests
