// Proves which results of an earlier run are reused, and that they and the rest come in order.
#include "client/compare/reused_results.hpp"

#include "tests/client/compare/record_runs.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace cd::tests {

namespace {

std::unique_ptr<PoseSource> poses_at(const std::vector<std::uint64_t>& positions) {
    std::vector<Scenario> scenarios(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        scenarios[i].index = i;
        scenarios[i].poses.b = translation_pose(static_cast<double>(positions[i]), 0, 0);
    }
    return make_list_source(std::move(scenarios));
}

std::vector<std::uint64_t> numbers_to(std::uint64_t count) {
    std::vector<std::uint64_t> numbers(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        numbers[i] = i;
    }
    return numbers;
}

class ReusedResultsTest : public testing::Test {
  protected:
    /// Returns whether the result of each scenario is reused by a run with the same poses.
    std::vector<bool> reused(const std::vector<ScenarioResult>& results,
                             std::uint64_t scenarios,
                             const Query& query) {
        RecordFile records = write_records(folder_ / "records", results);
        const auto poses = poses_at(numbers_to(scenarios));
        const auto found = ReusedResults::find(records, *poses, *poses, query, {});
        EXPECT_TRUE(found);
        std::vector<bool> has;
        for (std::uint64_t i = 0; i < scenarios; ++i) {
            has.push_back(found.value().has(i));
        }
        return has;
    }

    const TemporaryFolder folder_;
};

} // namespace

TEST_F(ReusedResultsTest, FailedAndMissingResultsAreNot) {
    EXPECT_EQ(reused({result_with(0, {}), failed(1), result_with(3, {{4, 5}})}, 5, {}),
              (std::vector<bool>{true, false, false, true, false}));
}

TEST_F(ReusedResultsTest, OfAJobWithMapsOnlyThoseThatListAllPairsAre) {
    ScenarioResult cut = result_with(0, {{1, 1}});
    cut.pair_count = 9;
    const ScenarioResult whole = result_with(1, {{1, 1}, {1, 2}});
    Query query;
    query.limit_pairs = 2;
    EXPECT_EQ(reused({cut, whole}, 2, query), (std::vector<bool>{true, true}));
    query.maps = true;
    EXPECT_EQ(reused({cut, whole}, 2, query), (std::vector<bool>{false, true}));
    query.level = Level::Count;
    ScenarioResult counted = result_with(0, {});
    counted.level = Level::Count;
    counted.kind = ScenarioClass::Cross;
    counted.pair_count = 3;
    ScenarioResult inside = counted;
    inside.index = 1;
    inside.kind = ScenarioClass::Inside;
    inside.pair_count = 0;
    EXPECT_EQ(reused({counted, inside}, 2, query), (std::vector<bool>{false, true}));
}

TEST_F(ReusedResultsTest, OfAJobWithMapsNearPairsAreListed) {
    ScenarioResult near = result_with(0, {{1, 1, PairClass::Near}});
    near.has_clearance = true;
    near.kind = ScenarioClass::Near;
    near.pair_count = 0;
    near.near_count = 2;
    Query query;
    query.limit_pairs = 1;
    query.clearance = 0.5;
    EXPECT_EQ(reused({near}, 1, query), std::vector<bool>{true});
    query.maps = true;
    EXPECT_EQ(reused({near}, 1, query), std::vector<bool>{false}) << "the list is cut";
    near.near_count = 1;
    EXPECT_EQ(reused({near}, 1, query), std::vector<bool>{true});
    query.level = near.level = Level::Count;
    near.pairs.clear();
    EXPECT_EQ(reused({near}, 1, query), std::vector<bool>{false}) << "no pair is known";
}

TEST_F(ReusedResultsTest, TheyAndTheRestComeInOrderFromTheFirstThatIsWanted) {
    // The earlier run has the poses in another order, and some twice.
    constexpr std::uint64_t count = 20'000;
    std::mt19937_64 random(7);
    std::vector<std::uint64_t> places = numbers_to(count);
    std::shuffle(places.begin(), places.end(), random);
    std::vector<ScenarioResult> results;
    for (std::uint64_t i = 0; i < count; ++i) {
        results.push_back(
            result_with(i, {{static_cast<std::uint32_t>(places[i]), 3, PairClass::Proper}}));
    }
    RecordFile records = write_records(folder_ / "records", results);
    std::vector<std::uint64_t> wanted; // Every fifth is unknown to the earlier run.
    for (std::uint64_t i = 0; i < count; ++i) {
        wanted.push_back(i % 5 == 0 ? count + i : i / 2);
    }
    const auto earlier = poses_at(places);
    const auto poses = poses_at(wanted);
    auto found = ReusedResults::find(records, *earlier, *poses, {}, {});
    ASSERT_TRUE(found);
    EXPECT_EQ(found.value().count(), count - count / 5);

    for (const std::uint64_t first : {std::uint64_t{0}, std::uint64_t{12'003}, count}) {
        const auto rest = found.value().rest(*poses, first);
        std::uint64_t next = first;
        ReuseMerge merge(found.value(),
                         *rest,
                         first,
                         [&](const DoneScenario& done) -> Status {
                             EXPECT_EQ(done.result.index, next);
                             EXPECT_EQ(done.result.pairs.front().a, wanted[next]);
                             EXPECT_EQ(done.digest, digest_of(done.result));
                             ++next;
                             return Done{};
                         },
                         {});
        for (std::uint64_t i = 0; i < rest->count(); ++i) {
            const auto scenario = rest->read(i, 1);
            ASSERT_TRUE(scenario);
            EXPECT_EQ(scenario.value().front().index, i);
            const auto at =
                static_cast<std::uint32_t>(scenario.value().front().poses.b.translation().x());
            ASSERT_TRUE(merge.add(done_scenario(result_with(i, {{at, 3}}), {})));
        }
        ASSERT_TRUE(merge.finish());
        EXPECT_EQ(next, count);
    }
}

TEST_F(ReusedResultsTest, AWindowShrinksToTheBytesThatItMayHold) {
    constexpr std::uint64_t count = 500;
    std::mt19937_64 random(11);
    std::vector<std::uint64_t> places = numbers_to(count);
    std::shuffle(places.begin(), places.end(), random);
    std::vector<ScenarioResult> results;
    for (std::uint64_t i = 0; i < count; ++i) {
        if (i % 7 != 0) { // The others have no record.
            results.push_back(result_with(i, {{static_cast<std::uint32_t>(i), 1}}));
        }
    }
    RecordFile records = write_records(folder_ / "records", results);
    const auto earlier = poses_at(numbers_to(count));
    const auto later = poses_at(places);
    const auto match = match_poses(*earlier, *later, Repeats::Pair, {});
    ASSERT_TRUE(match);
    for (const std::uint64_t bytes_max : {0, 100, 3'000, 1'000'000}) {
        MatchedRecords found(records, match.value(), count, bytes_max);
        for (std::uint64_t i = 0; i < count; ++i) {
            const auto result = found.of(i);
            ASSERT_TRUE(result);
            ASSERT_EQ(result.value() == nullptr, places[i] % 7 == 0) << i;
            if (result.value() != nullptr) {
                EXPECT_EQ(result.value()->index, places[i]);
                EXPECT_EQ(result.value()->pairs.front().a, places[i]);
            }
        }
    }
}

TEST_F(ReusedResultsTest, AnErrorOfTheTakerAndAStopEndTheMerge) {
    RecordFile records =
        write_records(folder_ / "records", {result_with(0, {}), result_with(1, {})});
    const auto poses = poses_at({0, 1});
    auto found = ReusedResults::find(records, *poses, *poses, {}, {});
    ASSERT_TRUE(found);
    const auto rest = found.value().rest(*poses, 0);
    EXPECT_EQ(rest->count(), 0u);
    ReuseMerge full(found.value(),
                    *rest,
                    0,
                    [](const DoneScenario&) {
                        return Status(Error{ErrorCode::Io, "full"});
                    },
                    {});
    EXPECT_EQ(full.finish().error().detail, "full");
    ReuseMerge stopped(
        found.value(),
        *rest,
        0,
        [](const DoneScenario&) { return Status(Done{}); },
        [] { return true; });
    EXPECT_EQ(stopped.finish().error().code, ErrorCode::Interrupted);
}

TEST(PoseSubset, ReadsAnyRangeOfItsScenarios) {
    const auto source = poses_at(numbers_to(50));
    PoseSubset subset(*source, {3, 4, 5, 17, 20, 21, 49});
    for (std::uint64_t first = 0; first <= 7; ++first) {
        for (std::uint64_t count = 0; first + count <= 7; ++count) {
            const auto read = subset.read(first, count);
            ASSERT_TRUE(read);
            ASSERT_EQ(read.value().size(), count);
            for (std::uint64_t i = 0; i < count; ++i) {
                EXPECT_EQ(read.value()[i].index, first + i);
                EXPECT_EQ(read.value()[i].poses.b.translation().x(),
                          static_cast<double>(subset.index_of(first + i)));
            }
        }
    }
}

} // namespace cd::tests
