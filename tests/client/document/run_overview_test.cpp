// Proves that the overview of a run has its classes, worst scenarios and failures.
#include "client/document/run_overview.hpp"

#include "common/job/result/record_file.hpp"
#include "common/job/run_scenario.hpp"
#include "tests/support/distance_results.hpp"
#include "tests/support/process.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/trees.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

ScenarioResult random_result(SeededRandom& random, std::uint64_t index) {
    ScenarioResult result;
    result.index = index;
    const std::uint64_t pairs = random() % 6;
    if (random() % 10 == 0) {
        result.kind = ScenarioClass::Failed;
        result.failure = "it failed";
        return result;
    }
    for (std::uint32_t i = 0; i < pairs; ++i) {
        result.pairs.push_back({i, i, PairClass::Proper});
    }
    result.pair_count = pairs;
    result.kind = pairs == 0 ? ScenarioClass::Separate : ScenarioClass::Cross;
    return result;
}

/// Writes results into a file of records, and opens it.
RecordFile records_of(const TemporaryFolder& folder, const std::vector<ScenarioResult>& results) {
    auto created = RecordWriter::create(folder / "records");
    RecordWriter& writer = created.value();
    for (const ScenarioResult& result : results) {
        if (writer.is_full()) {
            EXPECT_TRUE(writer.flush());
        }
        writer.add(result.index, encode_result(result));
    }
    EXPECT_TRUE(writer.finish());
    auto records = RecordFile::open(folder / "records");
    return std::move(records.value());
}

} // namespace

TEST(RunOverview, FindsTheWorstScenariosAndEveryClass) {
    const auto box = share(make_box({1, 1, 1}));
    for (SeededRandom random : seeds(20)) {
        const TemporaryFolder folder;
        std::vector<ScenarioResult> results;
        for (std::uint64_t i = 0; i < 200; ++i) {
            if (random() % 8 != 0) {
                results.push_back(random_result(random, i));
            }
        }
        const auto overview =
            RunOverview::read(records_of(folder, results), GroupSum({box, box}), 200, {});
        ASSERT_TRUE(overview);
        std::vector<std::uint8_t> classes(200, RunOverview::no_result);
        for (const ScenarioResult& result : results) {
            classes[result.index] = static_cast<std::uint8_t>(result.kind);
        }
        EXPECT_EQ(overview.value().classes(), classes);
        EXPECT_EQ(overview.value().summary().merged(), results.size());
        EXPECT_FALSE(overview.value().digest());

        std::erase_if(results, [](const ScenarioResult& each) { return each.pairs.empty(); });
        std::ranges::stable_sort(results, [](const ScenarioResult& l, const ScenarioResult& r) {
            return l.pair_count > r.pair_count;
        });
        const auto& worst = overview.value().worst();
        ASSERT_EQ(worst.size(), std::min(results.size(), RunOverview::worst_max));
        for (std::size_t i = 0; i < worst.size(); ++i) {
            EXPECT_EQ(worst[i].index, results[i].index);
        }
    }
}

TEST(RunOverview, TheWorstAreOrderedByClassThenByPairs) {
    const TemporaryFolder folder;
    const auto of = [](std::uint64_t index, ScenarioClass kind, std::uint64_t pairs) {
        ScenarioResult result;
        result.index = index;
        result.level = Level::Count;
        result.has_clearance = true;
        result.kind = kind;
        (kind == ScenarioClass::Near ? result.near_count : result.pair_count) = pairs;
        return result;
    };
    const std::vector<ScenarioResult> results{of(0, ScenarioClass::Near, 3),
                                              of(1, ScenarioClass::Touch, 9),
                                              of(2, ScenarioClass::Near, 70),
                                              of(3, ScenarioClass::Separate, 0),
                                              of(4, ScenarioClass::Cross, 2),
                                              of(5, ScenarioClass::Inside, 0),
                                              of(6, ScenarioClass::Near, 70)};
    const auto box = share(make_box({1, 1, 1}));
    const auto overview =
        RunOverview::read(records_of(folder, results), GroupSum({box, box}), 7, {});
    ASSERT_TRUE(overview) << overview.error().detail;
    std::vector<std::uint64_t> worst;
    for (const ScenarioResult& result : overview.value().worst()) {
        worst.push_back(result.index);
    }
    EXPECT_EQ(worst, (std::vector<std::uint64_t>{5, 4, 1, 2, 6, 0}));
    EXPECT_EQ(overview.value().summary().near, 3u);
    EXPECT_EQ(overview.value().summary().near_pairs, 143u);
}

TEST(RunOverview, LeavesOutTheScenariosOfOtherBodies) {
    const TemporaryFolder folder;
    const std::vector<std::string> all{"truck", "car", "wall"};
    const BodyChoice bodies = BodyChoice::of_names(std::span(all).last(1), all).value();
    std::vector<Scenario> scenarios;
    std::vector<ScenarioResult> results;
    for (std::uint64_t i = 0; i < 9; ++i) {
        Scenario scenario;
        scenario.index = i;
        scenario.body_a = i % 3 == 2 ? 1 : 0;
        scenario.body_b = i % 3 == 0 ? 1 : 2;
        scenarios.push_back(scenario);
        ScenarioResult result;
        result.index = i;
        result.body_a = scenario.body_a;
        result.body_b = scenario.body_b;
        result.kind = ScenarioClass::Touch;
        result.pair_count = 1;
        result.pairs = {{0, 0, PairClass::Touch}};
        if (i != 8 && bodies.has(result.body_a, result.body_b)) { // The last has no result.
            results.push_back(result);
        }
    }
    const auto box = share(make_box({1, 1, 1}));
    auto overview =
        RunOverview::read(records_of(folder, results), GroupSum({box, box, box}), 9, {});
    ASSERT_TRUE(overview);
    const auto poses = make_list_source(std::move(scenarios));
    ASSERT_TRUE(overview.value().restrict_to(bodies, *poses, {}));
    EXPECT_EQ(overview.value().bodies(), "wall");
    EXPECT_EQ(overview.value().summary().total, 6u);
    EXPECT_EQ(overview.value().summary().merged(), 5u) << "one of its scenarios has no result";
    const auto touch = static_cast<std::uint8_t>(ScenarioClass::Touch);
    const std::uint8_t out = RunOverview::left_out;
    EXPECT_EQ(overview.value().classes(),
              (std::vector<std::uint8_t>{
                  out, touch, touch, out, touch, touch, out, touch, RunOverview::no_result}));
}

TEST(RunOverview, HasTheLeastDistancesAndAll) {
    const TemporaryFolder folder;
    std::vector<ScenarioResult> results = distance_results();
    for (std::uint64_t i = results.size(); i < 20; ++i) {
        results.push_back(results[0]);
        results.back().index = i;
        results.back().nearest->distance = 1.0 / static_cast<double>(1 + i / 2);
    }
    const auto box = share(make_box({1, 1, 1}));
    const auto read = RunOverview::read(records_of(folder, results), GroupSum({box, box}), 20, {});
    ASSERT_TRUE(read) << read.error().detail;
    const RunOverview& overview = read.value();
    std::vector<std::uint64_t> nearest;
    for (const ScenarioResult& result : overview.nearest()) {
        nearest.push_back(result.index);
        ASSERT_EQ(result.pairs.size(), 1u);
        EXPECT_EQ(result.pairs[0].kind, PairClass::Near);
    }
    EXPECT_EQ(nearest, (std::vector<std::uint64_t>{18, 19, 16, 17, 3, 14, 15, 12, 13, 10}));
    EXPECT_EQ(overview.distances().size(), 18u) << "all but one in contact and one beyond";
    EXPECT_EQ(overview.worst().size(), 2u) << "in contact, and inside";
    EXPECT_EQ(overview.pictured().size(), 12u);
}

TEST(RunOverview, NamesTheFirstFailures) {
    const TemporaryFolder folder;
    std::vector<ScenarioResult> results(RunOverview::failures_max + 5);
    for (std::uint64_t i = 0; i < results.size(); ++i) {
        results[i].index = i;
        results[i].kind = ScenarioClass::Failed;
        results[i].failure = "no " + std::to_string(i);
    }
    const auto box = share(make_box({1, 1, 1}));
    const auto overview =
        RunOverview::read(records_of(folder, results), GroupSum({box, box}), results.size(), {});
    ASSERT_TRUE(overview);
    ASSERT_EQ(overview.value().failures().size(), RunOverview::failures_max);
    EXPECT_EQ(overview.value().failures()[3].reason, "no 3");
}

TEST(RunOverview, RefusesRecordsThatTheRunCannotHave) {
    const TemporaryFolder folder;
    const auto box = share(make_box({1, 1, 1}));
    std::vector<ScenarioResult> results(1);
    results[0].index = 7;
    const auto beyond = RunOverview::read(records_of(folder, results), GroupSum({box, box}), 7, {});
    ASSERT_FALSE(beyond);
    EXPECT_THAT(beyond.error().detail, testing::HasSubstr("scenario 7"));
    results[0].body_b = 2;
    EXPECT_FALSE(RunOverview::read(records_of(folder, results), GroupSum({box, box}), 8, {}));
    results[0].body_b = 1;
    EXPECT_TRUE(RunOverview::read(records_of(folder, results), GroupSum({box, box}), 8, {}));
    const auto stopped = RunOverview::read(
        records_of(folder, results), GroupSum({box, box}), 8, [] { return true; });
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::Interrupted);
}

TEST(RunOverview, RunsTheWorstScenariosAgainForTheirPairs) {
    using namespace std::chrono_literals;
    const TemporaryFolder folder;
    const auto box = share(make_box({1, 1, 1}));
    PreparedJob job;
    job.meshes = {box, box};
    const auto tree = std::make_shared<const ObbTree>(make_tree(make_box({1, 1, 1})));
    job.trees = {tree, tree};
    job.query.level = Level::Count;
    std::vector<Scenario> scenarios(2);
    scenarios[0].poses.b = translation_pose(0.5, 0.5, 0.5);
    scenarios[1].index = 1;
    scenarios[1].poses.b = translation_pose(0.5, 0.25, 0.125);
    job.poses = make_list_source(scenarios);
    std::vector<ScenarioResult> results;
    for (const Scenario& scenario : scenarios) {
        results.push_back(run_scenario(*tree, *tree, scenario, job.query).result);
        ASSERT_TRUE(results.back().pairs.empty());
    }
    auto overview =
        RunOverview::read(records_of(folder, results), GroupSum({box, box}), 2, {}).value();
    ASSERT_EQ(overview.worst().size(), 2u);

    // A run that takes too long, and a signal.
    ASSERT_TRUE(overview.add_pairs_to_worst(job, 0ms, {}));
    EXPECT_TRUE(overview.worst()[0].pairs.empty());
    const Status stopped = overview.add_pairs_to_worst(job, 1h, [] { return true; });
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::Interrupted);

    ASSERT_TRUE(overview.add_pairs_to_worst(job, 1h, {}));
    for (const ScenarioResult& worst : overview.worst()) {
        Query pairs;
        pairs.level = Level::Pairs;
        EXPECT_EQ(worst.pairs,
                  run_scenario(*tree, *tree, scenarios[worst.index], pairs).result.pairs);
        EXPECT_EQ(worst.pairs.size(), worst.pair_count);
    }
}

} // namespace cd::tests
