// Proves that results are kept in order until acknowledged, in a bounded amount, and never sent to
// another cluster.
#include "worker/session/carry_over.hpp"

#include "common/core/limits/worker.hpp"
#include "tests/proto/sample_messages.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

Results some_results(std::uint64_t job, std::size_t bytes = 10) {
    Results results;
    results.task = TaskId{7};
    results.job = JobId{job};
    results.records = some_bytes(bytes);
    return results;
}

std::vector<std::uint64_t> jobs_of(const std::vector<Results>& messages) {
    std::vector<std::uint64_t> jobs;
    for (const Results& message : messages) {
        EXPECT_EQ(message.task, TaskId{0});
        jobs.push_back(message.job.value);
    }
    return jobs;
}

TEST(UnkeptResults, AreKeptInOrderUntilTheyAreAcknowledged) {
    UnkeptResults unkept;
    std::vector<std::uint64_t> sequences;
    for (std::uint64_t job = 1; job <= 4; ++job) {
        Results results = some_results(job);
        unkept.add(results);
        sequences.push_back(results.sequence);
    }
    unkept.kept(std::vector<std::uint64_t>{sequences[2], sequences[0], 999});
    EXPECT_EQ(jobs_of(unkept.again()), (std::vector<std::uint64_t>{2, 4}));
    unkept.kept(std::vector<std::uint64_t>{sequences[0]}); // A repetition has no effect.
    unkept.kept(std::vector<std::uint64_t>{sequences[1], sequences[3]});
    EXPECT_TRUE(unkept.empty());
}

TEST(UnkeptResults, EarlierSessionsResultsCarryNoTask) {
    UnkeptResults unkept;
    Results before = some_results(1);
    unkept.add(before);
    ASSERT_EQ(unkept.again().size(), 1u); // A new session begins.
    Results now = some_results(2);
    unkept.add(now);
    std::vector<TaskId> tasks; // The session resumes over another connection.
    for (const auto& [sequence, message] : unkept.messages()) {
        tasks.push_back(message.task);
    }
    EXPECT_EQ(tasks, (std::vector<TaskId>{TaskId{}, TaskId{7}}));
}

TEST(UnkeptResults, HaveRoomForSoMuchOnly) {
    UnkeptResults unkept;
    const std::size_t half = limits::results_unkept_bytes_max / 2;
    Results first = some_results(1, half);
    unkept.add(first);
    EXPECT_TRUE(unkept.has_room());
    Results second = some_results(2, half);
    unkept.add(second);
    EXPECT_FALSE(unkept.has_room());
    unkept.kept(std::vector<std::uint64_t>{first.sequence});
    EXPECT_TRUE(unkept.has_room());
}

TEST(UnkeptResults, AreCountedByJob) {
    UnkeptResults unkept;
    for (const std::uint64_t job : {2u, 1u, 2u}) {
        Results results = some_results(job);
        results.count = static_cast<std::uint32_t>(10 * job);
        results.compute_seconds = 0.5;
        unkept.add(results);
    }
    const auto jobs = unkept.by_job();
    ASSERT_EQ(jobs.size(), 2u);
    EXPECT_EQ(jobs.at(JobId{1}).scenarios, 10u);
    EXPECT_EQ(jobs.at(JobId{2}).scenarios, 40u);
    EXPECT_EQ(jobs.at(JobId{2}).compute_seconds, 1);
    unkept.kept(std::vector<std::uint64_t>{1, 3});
    EXPECT_EQ(unkept.by_job().size(), 1u);
}

TEST(UnkeptResults, CountTheirMapsToo) {
    UnkeptResults unkept({1000, 100});
    Results results = some_results(1);
    results.map.resize(1000);
    unkept.add(results);
    EXPECT_FALSE(unkept.has_room());
    unkept.kept(std::vector<std::uint64_t>{results.sequence});
    EXPECT_TRUE(unkept.has_room());
}

TEST(CarryOver, DropsWhatBelongsToAnotherCluster) {
    CarryOver keep(1000);
    keep.enter(some_hash(1));
    Results results = some_results(1);
    keep.results.add(results);
    keep.enter(some_hash(1));
    EXPECT_FALSE(keep.results.empty());
    keep.enter(some_hash(2));
    EXPECT_TRUE(keep.results.empty());
}

} // namespace
} // namespace cd::tests
