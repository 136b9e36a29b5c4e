// Proves that the page reads a sample of a job over a connection in a few round trips.
#include "client/view/remote_reader.hpp"

#include "common/job/packed_scenarios.hpp"
#include "common/job/result/packed_records.hpp"
#include "tests/client/fake_master.hpp"
#include "web/server/cluster/cluster_jobs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace cd::tests {

namespace {

constexpr std::uint64_t total = 10'000'000;
constexpr std::uint64_t sample = 4096;
constexpr std::uint64_t places_at_once = 1000; ///< In an answer of this master.

/// The scenario's index decides its class; those that seven divides have no result.
ScenarioResult result_of(std::uint64_t scenario) {
    ScenarioResult result;
    result.index = scenario;
    result.kind = scenario % 2 == 0 ? ScenarioClass::Cross : ScenarioClass::Separate;
    result.pair_count = scenario % 2 == 0 ? 1 + scenario % 100 : 0;
    result.level = Level::Count;
    return result;
}

bool has_result(std::uint64_t scenario) {
    return scenario % 7 != 0;
}

ResultsPart part_of(const ResultsQuery& query) {
    ResultsPart part{query.job, query.first, query.first, {}, 0, {}};
    ByteWriter records;
    for (; part.next < query.first + std::min(query.count, places_at_once); ++part.next) {
        const std::uint64_t scenario = sampled_scenario(part.next, query.sample, total);
        if (!has_result(scenario)) {
            continue;
        }
        const Bytes record = encode_result(result_of(scenario));
        records.put(static_cast<std::uint32_t>(record.size()));
        put_bytes(records, record);
        part.held.push_back({part.next, 1});
        ++part.count;
    }
    part.records = pack_records(records.bytes());
    return part;
}

JobPoses part_of(const PosesQuery& query) {
    JobPoses part{query.job, query.first, std::min(query.count, places_at_once), {}, {}};
    std::vector<Scenario> scenarios(part.count);
    for (std::uint64_t i = 0; i < part.count; ++i) {
        scenarios[i].index = sampled_scenario(query.first + i, query.sample, total);
        scenarios[i].poses.b = Pose::from_matrix(
            Mat3::Identity(), Vec3(static_cast<double>(scenarios[i].index), 0, 0));
    }
    part.scenarios = pack_scenarios(scenarios);
    return part;
}

Submit submission() {
    Submit submit;
    submit.name = "test";
    submit.cluster.strategy = "best-match";
    submit.scenarios = total;
    return submit;
}

std::optional<std::vector<Message>> answer(const Message& message) {
    if (std::holds_alternative<Hello>(message)) {
        return FakeMaster::welcome();
    }
    if (const auto* results = std::get_if<ResultsQuery>(&message)) {
        return std::vector<Message>{part_of(*results)};
    }
    if (const auto* poses = std::get_if<PosesQuery>(&message)) {
        return std::vector<Message>{part_of(*poses)};
    }
    if (const auto* job = std::get_if<JobQuery>(&message)) {
        return std::vector<Message>{JobDescription{job->job, 0, submission()}};
    }
    return std::nullopt;
}

RemoteReader reader_of(const FakeMaster& master, asio::io_context& context) {
    const auto open = [&master] {
        return Connection::open(master.address(), false, [] { return false; });
    };
    return RemoteReader(context.get_executor(), open, {}, 1);
}

PagedJob sampled_job() {
    PagedJob job;
    job.status.job = JobId{1};
    job.status.summary.total = total;
    return job;
}

} // namespace

TEST(RemoteReader, ASampleTakesAFewRoundTrips) {
    FakeMaster master(answer);
    asio::io_context context;
    RemoteReader reader = reader_of(master, context);
    const PagedJob job = sampled_job();
    ScenarioChoice choice;
    choice.sample = sample;

    const auto records = reader.records(job.status.job, total);
    ASSERT_TRUE(records);
    const auto classes = classes_of(records.value(), job, choice);
    const auto counts = counts_of(records.value(), job, choice);
    const auto poses = poses_of(reader, job, choice);
    ASSERT_TRUE(classes) << classes.error().detail;
    ASSERT_TRUE(counts) << counts.error().detail;
    ASSERT_TRUE(poses) << poses.error().detail;
    ASSERT_EQ(classes.value().size(), sample);
    ASSERT_EQ(poses.value().numbers.size(), 12 * sample);
    for (std::uint64_t i = 0; i < sample; ++i) {
        const std::uint64_t scenario = i * total / sample;
        const ScenarioResult right = result_of(scenario);
        const auto kind = static_cast<std::uint8_t>(right.kind);
        EXPECT_EQ(classes.value()[i], has_result(scenario) ? kind : no_class);
        EXPECT_EQ(counts.value()[i], has_result(scenario) ? right.pair_count : 0);
        EXPECT_EQ(poses.value().numbers[12 * i + 3], static_cast<double>(scenario));
    }
    EXPECT_EQ(master.received_of<ResultsQuery>().size(), 2 * 5u);
    EXPECT_EQ(master.received_of<PosesQuery>().size(), 5u);
    EXPECT_EQ(master.received().size(), 1 + 2 * 5 + 1 + 5u) << "greeting, results, job, poses";
}

TEST(RemoteReader, OtherScenariosThanThoseOfTheSampleAreRefused) {
    FakeMaster master([](const Message& message) -> std::optional<std::vector<Message>> {
        auto given = answer(message);
        for (Message& each : *given) {
            if (auto* poses = std::get_if<JobPoses>(&each)) {
                std::vector<Scenario> scenarios(poses->count);
                poses->scenarios = pack_scenarios(scenarios);
            }
            if (auto* results = std::get_if<ResultsPart>(&each)) {
                *results = part_of(ResultsQuery{results->job, results->first, 3});
            }
        }
        return given;
    });
    asio::io_context context;
    RemoteReader reader = reader_of(master, context);
    const PagedJob job = sampled_job();
    ScenarioChoice choice;
    choice.sample = sample;
    const auto records = reader.records(job.status.job, total);
    ASSERT_TRUE(records);
    EXPECT_EQ(classes_of(records.value(), job, choice).error().code, ErrorCode::BadFrame);
    EXPECT_EQ(poses_of(reader, job, choice).error().code, ErrorCode::BadFrame);
}

} // namespace cd::tests
