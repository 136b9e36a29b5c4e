// Proves that records come back as they were added, whatever their order and size, in runs that end
// at the first that is missing or at the limit of bytes.

#include "master/result_store.hpp"

#include "common/core/limits.hpp"
#include "common/job/packed_records.hpp"
#include "tests/support/process.hpp"

#include <gtest/gtest.h>

#include <random>

namespace cd::tests {
namespace {

Bytes make_record(std::uint64_t scenario, std::size_t size) {
    Bytes record(size);
    for (std::size_t i = 0; i < size; ++i) {
        record[i] = static_cast<std::byte>((scenario * 31 + i) & 0xff);
    }
    return record;
}

std::vector<Bytes> records_of(const ResultsPart& part) {
    const Result<Bytes> bytes = unpack_records(part.records, 1u << 30);
    EXPECT_TRUE(bytes);
    std::vector<Bytes> records;
    ByteReader in(bytes.value());
    for (std::uint32_t i = 0; i < part.count; ++i) {
        const auto text = in.get_array<std::uint8_t>(in.get<std::uint32_t>());
        const auto record = std::as_bytes(std::span(text));
        records.emplace_back(record.begin(), record.end());
    }
    EXPECT_TRUE(in.complete());
    return records;
}

class ResultStoreTest : public testing::Test {
  protected:
    std::unique_ptr<ResultStore> make_store(std::uint64_t scenarios) {
        return std::move(ResultStore::create(folder_ / "results", scenarios).value());
    }
    TemporaryFolder folder_;
};

TEST_F(ResultStoreTest, GivesRecordsInTheOrderOfScenarios) {
    constexpr std::uint64_t count = 3000;
    const auto store = make_store(count);
    std::vector<std::uint64_t> order(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        order[i] = i * 1009 % count;
    }
    for (const std::uint64_t i : order) {
        EXPECT_FALSE(store->has(i));
        ASSERT_TRUE(store->add(i, make_record(i, 1 + i % 2000))); // Over one buffer in all.
        EXPECT_TRUE(store->has(i));
    }
    EXPECT_EQ(store->count(), count);

    std::uint64_t next = 0;
    while (next < count) {
        const auto part = store->read(next, count, 100'000);
        ASSERT_TRUE(part) << part.error().detail;
        ASSERT_GT(part.value().count, 0u);
        EXPECT_EQ(part.value().first, next);
        std::size_t bytes = 0;
        for (const Bytes& record : records_of(part.value())) {
            ASSERT_EQ(record, make_record(next, 1 + next % 2000));
            bytes += record.size();
            ++next;
        }
        EXPECT_LE(bytes, 100'000u);
    }
    EXPECT_EQ(next, count);
}

TEST_F(ResultStoreTest, StopsAtTheFirstThatIsMissing) {
    const auto store = make_store(10);
    for (const std::uint64_t i : {0, 1, 2, 4, 9}) {
        ASSERT_TRUE(store->add(i, make_record(i, 5)));
    }
    EXPECT_EQ(store->read(0, 10, 1000).value().count, 3u);
    EXPECT_EQ(store->read(1, 1, 1000).value().count, 1u);
    EXPECT_EQ(store->read(3, 10, 1000).value().count, 0u);
    EXPECT_EQ(store->read(9, ~std::uint64_t{0}, 1000).value().count, 1u);
    EXPECT_EQ(store->read(10, 10, 1000).value().count, 0u);
    EXPECT_EQ(store->read(~std::uint64_t{0}, 10, 1000).value().count, 0u);
    EXPECT_EQ(store->read(0, 0, 1000).value().count, 0u);
}

TEST_F(ResultStoreTest, OneRecordOverTheLimitIsGivenAlone) {
    const auto store = make_store(3);
    ASSERT_TRUE(store->add(0, make_record(0, 10)));
    ASSERT_TRUE(store->add(1, make_record(1, 3 * limits::result_buffer_bytes_max)));
    ASSERT_TRUE(store->add(2, make_record(2, 10)));
    EXPECT_EQ(store->read(0, 3, 100).value().count, 1u);
    const auto part = store->read(1, 3, 100).value();
    ASSERT_EQ(part.count, 1u);
    EXPECT_EQ(records_of(part)[0], make_record(1, 3 * limits::result_buffer_bytes_max));
}

TEST_F(ResultStoreTest, AJobOfAnAbsurdSizeTakesNoMemoryUntilItHasResults) {
    const auto store = make_store(limits::scenarios_max);
    ASSERT_TRUE(store->add(limits::scenarios_max - 1, make_record(1, 10)));
    EXPECT_EQ(store->count(), 1u);
    EXPECT_EQ(store->read(limits::scenarios_max - 1, 5, 100).value().count, 1u);
}

TEST_F(ResultStoreTest, LeavesNoFile) {
    const auto store = make_store(1);
    ASSERT_TRUE(store->add(0, make_record(0, 10)));
    EXPECT_TRUE(std::filesystem::is_empty(folder_ / "results"));
}

} // namespace
} // namespace cd::tests
