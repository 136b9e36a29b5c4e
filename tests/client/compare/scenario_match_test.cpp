// Proves which scenarios of two runs are taken for the same.
#include "client/compare/scenario_match.hpp"

#include "client/compare/scenario_keys.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace cd::tests {

namespace {

std::vector<Scenario> at_positions(const std::vector<double>& positions) {
    std::vector<Scenario> scenarios(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        scenarios[i].index = i;
        scenarios[i].poses.b = translation_pose(positions[i], 0, 0);
    }
    return scenarios;
}

std::vector<int> matched(const ScenarioMatch& match, std::size_t count) {
    std::vector<int> earlier;
    for (std::size_t i = 0; i < count; ++i) {
        earlier.push_back(static_cast<int>(match.earlier(i).value_or(UINT64_MAX)));
    }
    return earlier;
}

std::vector<int> match_positions(const std::vector<double>& earlier,
                                 const std::vector<double>& later,
                                 Repeats repeats) {
    const auto old_source = make_list_source(at_positions(earlier));
    const auto new_source = make_list_source(at_positions(later));
    const auto match = match_poses(*old_source, *new_source, repeats, {});
    EXPECT_TRUE(match);
    EXPECT_EQ(match.value().by(), MatchedBy::Poses);
    return matched(match.value(), later.size());
}

} // namespace

TEST(ScenarioMatch, EqualPosesAreMatchedInAnyOrder) {
    EXPECT_EQ(match_positions({1, 2, 3}, {3, 4, 1}, Repeats::Pair), (std::vector{2, -1, 0}));
    EXPECT_EQ(match_positions({1, -0.0}, {0.0, 5}, Repeats::Pair), (std::vector{1, -1}));
}

TEST(ScenarioMatch, TheNthOfEqualPosesIsMatchedWithTheNthOrAllWithTheFirst) {
    EXPECT_EQ(match_positions({7, 1, 7, 7}, {7, 7, 1, 1, 7, 7}, Repeats::Pair),
              (std::vector{0, 2, 1, -1, 3, -1}));
    EXPECT_EQ(match_positions({7, 1, 7, 7}, {7, 7, 1, 1, 7, 7}, Repeats::Share),
              (std::vector{0, 0, 1, 1, 0, 0}));
}

TEST(ScenarioMatch, PosesOfEqualNumbersInAnotherFormDiffer) {
    PosePair matrix;
    matrix.b = translation_pose(1, 2, 3);
    PosePair quaternion;
    quaternion.b = Pose::from_quaternion({}, {1, 2, 3});
    PosePair of_a;
    of_a.a = matrix.b;
    EXPECT_NE(key_of(make_scenario(matrix)), key_of(make_scenario(quaternion)));
    EXPECT_NE(key_of(make_scenario(matrix)), key_of(make_scenario(of_a)));
    EXPECT_EQ(key_of(make_scenario(matrix)),
              key_of(make_scenario({Pose(), translation_pose(1, 2, 3)})));
}

TEST(ScenarioMatch, AgreesWithASlowTwin) {
    std::mt19937_64 random(5);
    for (int round = 0; round < 20; ++round) {
        std::vector<double> earlier(300);
        std::vector<double> later(300);
        for (std::size_t i = 0; i < 300; ++i) {
            earlier[i] = static_cast<double>(random() % 200);
            later[i] = static_cast<double>(random() % 200);
        }
        std::vector<bool> is_taken(300);
        std::vector<int> expected;
        for (const double position : later) {
            std::size_t i = 0;
            while (i < 300 && (is_taken[i] || earlier[i] != position)) {
                ++i;
            }
            expected.push_back(i < 300 ? static_cast<int>(i) : -1);
            if (i < 300) {
                is_taken[i] = true;
            }
        }
        EXPECT_EQ(match_positions(earlier, later, Repeats::Pair), expected) << "round " << round;
    }
}

TEST(ScenarioMatch, RunsAreMatchedByIndexThenIdsThenPoses) {
    const auto earlier = make_list_source(at_positions({1, 2, 3}));
    const auto later = make_list_source(at_positions({3, 2, 9}));
    PoseLabels numbers;
    numbers.integers = {10, 20, 30};
    PoseLabels texts;
    texts.texts = {"20", "thirty", "10"};
    const PoseLabels none;
    const auto match = [&](const PoseLabels& was, const PoseLabels& is, bool are_equal) {
        auto found = match_runs({*earlier, was}, {*later, is}, are_equal, {});
        EXPECT_TRUE(found);
        return std::move(found.value());
    };
    EXPECT_EQ(match(numbers, texts, true).by(), MatchedBy::Index);
    EXPECT_EQ(matched(match(numbers, texts, true), 3), (std::vector{0, 1, 2}));
    EXPECT_EQ(match(numbers, texts, false).by(), MatchedBy::Id);
    EXPECT_EQ(matched(match(numbers, texts, false), 3), (std::vector{1, -1, 0}));
    EXPECT_EQ(match(numbers, texts, false).count(), 2u);
    EXPECT_EQ(match(numbers, none, false).by(), MatchedBy::Poses);
    EXPECT_EQ(matched(match(numbers, none, false), 3), (std::vector{2, 1, -1}));
}

TEST(ScenarioMatch, EqualGridsAreMatchedByIndex) {
    Grid grid;
    grid.position[0] = {0, 1, 5};
    const auto earlier = make_grid_source(grid);
    const auto equal = make_grid_source(grid);
    EXPECT_EQ(match_poses(*earlier, *equal, Repeats::Share, {}).value().by(), MatchedBy::Index);
    grid.position[0].count = 9;
    const auto finer = make_grid_source(grid);
    const auto match = match_poses(*earlier, *finer, Repeats::Share, {});
    EXPECT_EQ(matched(match.value(), 9), (std::vector{0, -1, 1, -1, 2, -1, 3, -1, 4}));
}

TEST(ScenarioMatch, WhatIsNotKeptHasNoMatch) {
    ScenarioMatch match = ScenarioMatch::by_index(4);
    match.keep_if(4, [](std::uint64_t index) { return index != 2; });
    EXPECT_EQ(matched(match, 5), (std::vector{0, 1, -1, 3, -1}));
    EXPECT_EQ(match.count(), 3u);
}

TEST(ScenarioMatch, AStopEndsTheMatching) {
    const auto source = make_list_source(at_positions({1, 2}));
    const auto match = match_poses(*source, *source, Repeats::Pair, [] { return true; });
    ASSERT_FALSE(match);
    EXPECT_EQ(match.error().code, ErrorCode::Interrupted);
}

} // namespace cd::tests
