// Proves that a motion has one result for whole trees and for subtrees of any cut, that its class
// and pairs are those at its event, and that a scenario that is no motion fails.

#include "common/job/answer_poses.hpp"
#include "common/job/run_motion.hpp"
#include "common/job/run_scenario.hpp"
#include "tests/common/job/in_parts.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/trees.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;

constexpr double resolution = 0.02;

Query motion_query(Level level, Until until, std::optional<double> clearance = {}) {
    Query query = query_of(level);
    query.question = Question::Motion;
    query.motion = MotionQuery{resolution, until};
    query.clearance = clearance;
    return query;
}

/// Rounds both keys and makes the motion of two bodies between them.
Scenario moving(const ObbTree& a, const ObbTree& b, const PosePair& from, const PosePair& to) {
    const BodyRadii radii{body_radius(a.mesh().vertices()), body_radius(b.mesh().vertices())};
    const auto keys = round_keys(std::array{from, to}, radii, resolution);
    EXPECT_TRUE(keys) << (keys ? "" : keys.error().detail);
    Scenario scenario = make_scenario(keys.value().keys[0], 17);
    scenario.to = keys.value().keys[1];
    return scenario;
}

/// Moves B along x past or onto A, which rests.
Scenario along_x(const ObbTree& a, const ObbTree& b, double from, double to, double y = 0) {
    return moving(a,
                  b,
                  {moved_pose(Vec3::Zero()), moved_pose({from, y, 0})},
                  {moved_pose(Vec3::Zero()), moved_pose({to, y, 0})});
}

std::vector<ContactPair> pairs_at(const ObbTree& a, const ObbTree& b, const PosePair& poses) {
    return contact_pairs(a, b, poses);
}

} // namespace

TEST(MotionScenario, PartsGiveTheSameRecordAsTheWhole) {
    std::mt19937_64 shapes(7);
    std::vector<ObbTree> trees;
    trees.push_back(make_tree(make_sphere(2)));
    trees.push_back(make_tree(make_gridded_box(Vec3(1.5, 1, 1), 4)));
    trees.push_back(make_tree(make_triangle_soup(shapes, 60)));
    std::map<ScenarioClass, int> classes;
    for (SeededRandom random : seeds(60)) {
        const ObbTree& a = trees[random() % trees.size()];
        const ObbTree& b = trees[random() % trees.size()];
        const Pose start = make_pose(random, 2.5);
        const Pose other = make_pose(random, 0.2);
        const Vec3 axis = random_axis(random);
        const double degrees = uniform(random, 0, 60);
        const Scenario scenario =
            moving(a,
                   b,
                   {other, start},
                   {key_after(other, 5, axis, Vec3(0.1, 0, 0)),
                    key_after(start, degrees, axis, random_point(random, 1.5))});
        const bool is_wide = suits_wide_tree(a.view()) && suits_wide_tree(b.view());
        for (const Level level : {Level::Any, Level::Pairs}) {
            const auto until = static_cast<Until>(random() % 3);
            const auto clearance =
                random() % 2 == 0 ? std::nullopt : std::optional(uniform(random, 0, 0.1));
            const Query query = motion_query(level, until, clearance);
            const std::array<std::uint32_t, 2> depths{static_cast<std::uint32_t>(random() % 8),
                                                      static_cast<std::uint32_t>(random() % 8)};
            const SubtreeForm form =
                is_wide && random() % 4 > 0 ? SubtreeForm::Wide : SubtreeForm::Binary;
            const ScenarioResult whole = run_scenario(a, b, scenario, query).result;
            const Bytes record = encode_result(whole);
            const ScenarioResult parts = run_in_parts(a, b, depths, form, scenario, query, random);
            ASSERT_EQ(encode_result(parts), record);
            const auto decoded = decode_result(record);
            ASSERT_TRUE(decoded) << decoded.error().detail;
            EXPECT_EQ(encode_result(decoded.value()), record);
            ++classes[whole.kind];
        }
    }
    EXPECT_GT(classes[ScenarioClass::Separate], 5);
    EXPECT_GT(classes[ScenarioClass::Contact], 5);
    EXPECT_GT(classes[ScenarioClass::Near], 2);
    EXPECT_GT(classes[ScenarioClass::Cross] + classes[ScenarioClass::Touch], 5);
}

TEST(MotionScenario, PairsAreThoseAtTheEvent) {
    const ObbTree a = make_tree(make_gridded_box(Vec3(1, 1, 1), 3));
    const ObbTree b = make_tree(make_sphere(2));
    const Scenario onto = along_x(a, b, 4, 0.25);
    for (const Until until : {Until::Contact, Until::End}) {
        const ScenarioResult result =
            run_scenario(a, b, onto, motion_query(Level::Pairs, until)).result;
        ASSERT_TRUE(result.motion && result.motion->event());
        EXPECT_EQ(result.motion->end, MotionEnd::Contact);
        EXPECT_GT(result.pair_count, 0u);
        EXPECT_EQ(result.pairs, pairs_at(a, b, poses_of_answer(onto, result)));
        EXPECT_EQ(result.kind,
                  run_scenario(a, b, at_answer(onto, result), query_of(Level::Pairs)).result.kind);
    }
    const Scenario out = along_x(a, b, 0.25, 4);
    const ScenarioResult free =
        run_scenario(a, b, out, motion_query(Level::Pairs, Until::Free)).result;
    ASSERT_TRUE(free.motion && free.motion->event());
    EXPECT_EQ(free.motion->end, MotionEnd::Free);
    EXPECT_EQ(free.pairs, pairs_at(a, b, poses_of_answer(out, free)));
    EXPECT_FALSE(free.pairs.empty());
    const double tau = std::ldexp(*free.motion->event(), -static_cast<int>(free.motion->depth));
    EXPECT_EQ(poses_of_answer(out, free).b.translation().x(),
              (1 - tau) * out.poses.b.translation().x() + tau * out.to->b.translation().x());
}

TEST(MotionScenario, FreeMotionsAreSeparateOrInside) {
    const ObbTree large = make_tree(make_gridded_box(Vec3(4, 4, 4), 3));
    const ObbTree small = make_tree(make_box(Vec3(0.5, 0.5, 0.5)));
    for (const Level level : {Level::Any, Level::Pairs}) {
        const Query query = motion_query(level, Until::Contact);
        EXPECT_EQ(run_scenario(large, small, along_x(large, small, 8, 6), query).result.kind,
                  ScenarioClass::Separate);
        const ScenarioResult inside =
            run_scenario(large, small, along_x(large, small, -0.5, 0.5), query).result;
        EXPECT_EQ(inside.kind, ScenarioClass::Inside);
        EXPECT_EQ(inside.motion->end, MotionEnd::Free);
        EXPECT_TRUE(decode_result(encode_result(inside)));
    }
}

TEST(MotionScenario, PassingWithinTheResolutionIsUndecidedWithItsBound) {
    const ObbTree box = make_tree(make_gridded_box(Vec3(1, 1, 1), 2));
    const double gap = resolution / 16;
    const Scenario past = along_x(box, box, -2.3, 2.2, 1 + gap);
    const ScenarioResult result =
        run_scenario(box, box, past, motion_query(Level::Any, Until::End)).result;
    EXPECT_EQ(result.kind, ScenarioClass::Undecided);
    EXPECT_EQ(result.motion->end, MotionEnd::Free);
    EXPECT_TRUE(result.motion->has_open_run());
    EXPECT_GE(result.distance_bound, gap);
    EXPECT_LE(result.distance_bound, resolution);
    // A clearance above the gap is an event instead.
    const ScenarioResult near =
        run_scenario(box, box, past, motion_query(Level::Pairs, Until::Contact, 2 * gap)).result;
    EXPECT_EQ(near.kind, ScenarioClass::Near);
    EXPECT_GT(near.near_count, 0u);
    EXPECT_EQ(near.pair_count, 0u);
}

TEST(MotionScenario, ThatDoesNotMoveFails) {
    const ObbTree box = make_tree(make_box(Vec3(1, 1, 1)));
    const Scenario rests = make_scenario({moved_pose(Vec3::Zero()), moved_pose({3, 0, 0})}, 4);
    const ScenarioResult result =
        run_scenario(box, box, rests, motion_query(Level::Any, Until::Contact)).result;
    EXPECT_EQ(result.kind, ScenarioClass::Failed);
    EXPECT_THAT(result.failure, HasSubstr("scenario 4: "));
    EXPECT_THAT(result.failure, HasSubstr("without a pose to move to"));
    EXPECT_TRUE(decode_result(encode_result(result)));
}

TEST(MotionScenario, AStopEndsIt) {
    const ObbTree box = make_tree(make_gridded_box(Vec3(1, 1, 1), 2));
    int polls = 0;
    RunOptions options;
    options.stop = [&] { return ++polls > 10; };
    const Query query = motion_query(Level::Any, Until::End);
    options.radii = radii_of(radii_for(TreesByBody(box, box), query), Scenario{});
    const SubtreePair whole{box.view(), box.view()};
    const ScenarioRun run = run_on_subtrees({&whole, 1}, along_x(box, box, 3, 0), query, options);
    EXPECT_TRUE(run.is_stopped);
}

} // namespace cd::tests
