// Proves that the comparison of motions counts missed, invented and early impacts, and that ours
// has the bracket of two boxes whose impact is known.
#include "bench/peers/motions/contest.hpp"

#include "bench/peers/motions/motion_scenes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cd::tests {
namespace {

using namespace cd::bench;
using Kind = Impact::Kind;

PathOutcome outcome(Kind kind, double t0, double t1) {
    return {true, Ending::Done, 1, {kind, t0, t1}};
}

TEST(MotionContest, CountsMissedAndInventedImpacts) {
    const std::vector ours{outcome(Kind::Found, 0.5, 0.6),
                           outcome(Kind::None, 1, 1),
                           outcome(Kind::Found, 0.5, 0.6),
                           outcome(Kind::Undecided, 1, 1),
                           outcome(Kind::Found, 0.5, 0.6)};
    const std::vector theirs{outcome(Kind::None, 1, 1),
                             outcome(Kind::Found, 0.2, 0.2),
                             PathOutcome{true, Ending::TimedOut, 0, {}},
                             outcome(Kind::Found, 0.2, 0.2),
                             PathOutcome{}};

    const ImpactErrors errors = compare_impacts(ours, theirs);

    EXPECT_EQ(errors.missed, 1);
    EXPECT_EQ(errors.invented, 1);
    EXPECT_EQ(errors.unanswered, 1);
    EXPECT_TRUE(errors.shares_off.empty());
}

TEST(MotionContest, TimesInsideOfTheBracketAreRight) {
    const std::vector ours(3, outcome(Kind::Found, 0.5, 0.75));
    const std::vector theirs{outcome(Kind::Found, 0.25, 0.25),
                             outcome(Kind::Found, 0.5, 0.5),
                             outcome(Kind::Found, 1, 1)};

    EXPECT_EQ(compare_impacts(ours, theirs).shares_off, (std::vector{-0.25, 0.0, 0.25}));
}

TEST(MotionContest, OursBracketsTheImpactsOfBoxes) {
    MotionSceneOptions options;
    options.scenes.poses = 3;
    options.only = "t"; // Without the models, which are not there.
    std::size_t paths = 0;
    for (const MotionScene& scene : motion_scenes(options)) {
        SCOPED_TRACE(scene.name);
        const std::vector engines{our_motions()};
        // The boxes meet after 14 of 16, the box and the wall after 4.9995 of 10.
        const double time = scene.name == "two boxes" ? 14.0 / 16 : (4.9995 - 0.5e-6) / 10;
        const auto outcomes = run_motion_contest(scene, engines, {});
        for (const PathOutcome& found : outcomes[0]) {
            EXPECT_EQ(found.impact.kind, Kind::Found);
            EXPECT_LE(found.impact.t0, time);
            EXPECT_GE(found.impact.t1, time);
            EXPECT_LE(found.impact.t1 - found.impact.t0, 4 * scene.resolution);
            ++paths;
        }
    }
    EXPECT_EQ(paths, 6);
}

} // namespace
} // namespace cd::tests
