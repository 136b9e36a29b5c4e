// Proves that a batch gives the records that were added, with their digests and in the form of the
// segment.
#include "master/base/result_batch.hpp"

#include "common/core/files/disk_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cd::tests {
namespace {

ScenarioResult counted(std::uint64_t scenario, std::uint64_t pairs) {
    ScenarioResult result;
    result.index = scenario;
    result.level = Level::Count;
    result.kind = pairs == 0 ? ScenarioClass::Separate : ScenarioClass::Touch;
    result.pair_count = pairs;
    return result;
}

ScenarioResult failed(std::uint64_t scenario) {
    ScenarioResult result;
    result.index = scenario;
    result.kind = ScenarioClass::Failed;
    result.failure = "why";
    return result;
}

ResultBatch some_batch() {
    ResultBatch batch;
    batch.add(counted(7, 0));
    batch.add(failed(3));
    batch.add(counted(8, 5));
    return batch;
}

TEST(ResultBatch, HasRowsDigestsAndRecordsInOrder) {
    const ResultBatch batch = some_batch();
    const std::vector<ScenarioResult> results{counted(7, 0), failed(3), counted(8, 5)};
    ASSERT_EQ(batch.size(), results.size());
    ByteWriter stored;
    std::size_t i = 0;
    batch.for_each([&](const ResultRow& row, std::span<const std::byte> record) {
        const Bytes expected = encode_result(results[i]);
        EXPECT_TRUE(std::ranges::equal(record, expected));
        EXPECT_EQ(row, (ResultRow{results[i].index, expected.size(), facts_of(results[i])}));
        EXPECT_EQ(batch.digests()[i], digest_of(results[i]));
        put_bytes(stored, record);
        stored.put(record_footer(row.scenario, record));
        ++i;
    });
    EXPECT_EQ(batch.stored(), stored.bytes());
    EXPECT_EQ(batch.record_bytes(), stored.size() - 3 * record_footer_bytes);
}

TEST(ResultBatch, ARecordMayBeAddedAsItIs) {
    ResultBatch batch;
    const ScenarioResult result = counted(8, 5);
    batch.add(8, facts_of(result), encode_result(result));
    ResultBatch encoded;
    encoded.add(result);
    EXPECT_EQ(batch.stored(), encoded.stored());
    EXPECT_EQ(batch.digests()[0], encoded.digests()[0]);
}

TEST(ResultBatch, SettledResultsAreAddedLikeOthers) {
    ResultBatch batch;
    ResultBatch expected;
    for (std::uint64_t scenario = 0; scenario < 40; ++scenario) {
        const ScenarioResult result = counted(scenario, scenario % 3);
        batch.add_settled(result, encode_result(result));
        expected.add(result);
    }
    EXPECT_TRUE(std::ranges::equal(batch.rows(), expected.rows()));
    EXPECT_EQ(batch.digests(), expected.digests());
    EXPECT_EQ(batch.stored(), expected.stored());
}

TEST(ResultBatch, WithoutSomeResultsTheOthersStay) {
    const ResultBatch rest = some_batch().without(std::vector<std::size_t>{0, 2});
    ASSERT_EQ(rest.size(), 1u);
    ResultBatch expected;
    expected.add(failed(3));
    EXPECT_EQ(rest.stored(), expected.stored());
    EXPECT_EQ(rest.rows()[0], expected.rows()[0]);
    EXPECT_EQ(rest.digests()[0], expected.digests()[0]);
}

TEST(ResultBatch, TheFooterTellsAnotherScenarioOrRecord) {
    const Bytes record(5, std::byte{1});
    const Bytes other(5, std::byte{2});
    EXPECT_NE(record_footer(1, record), record_footer(2, record));
    EXPECT_NE(record_footer(1, record), record_footer(1, other));
}

} // namespace
} // namespace cd::tests
