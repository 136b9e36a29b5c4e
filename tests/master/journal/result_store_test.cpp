// Proves that records return as added, whatever their order and size, in runs that end at the first
// missing record or at the byte limit.

#include "master/journal/result_store.hpp"

#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
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
    EXPECT_FALSE(part.are_packed);
    std::vector<Bytes> records;
    ByteReader in(part.records);
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
        return ResultStore::create(path(), JobId{7}, scenarios);
    }
    [[nodiscard]] std::filesystem::path path() const { return folder_ / "7.results"; }
    TemporaryFolder folder_;
};

ResultBatch batch_of(std::uint64_t scenario, const Bytes& record) {
    ResultBatch batch;
    batch.add(scenario, {}, record);
    return batch;
}

Status write(ResultStore& store, const ResultBatch& batch) {
    return store.write(std::vector<const ResultBatch*>{&batch});
}

Status add(ResultStore& store, std::uint64_t scenario, const Bytes& record) {
    const ResultBatch one = batch_of(scenario, record);
    Status written = write(store, one);
    if (written) {
        store.commit();
    }
    return written;
}

TEST_F(ResultStoreTest, GivesRecordsInTheOrderOfScenarios) {
    constexpr std::uint64_t count = 3000;
    const auto store = make_store(count);
    std::vector<std::uint64_t> order(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        order[i] = i * 1009 % count;
    }
    for (const std::uint64_t i : order) {
        EXPECT_FALSE(store->has(i));
        ASSERT_TRUE(add(*store, i, make_record(i, 1 + i % 2000))); // Exceeds one buffer in total.
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

TEST_F(ResultStoreTest, AReadSkipsMissingRecordsAndReturnsWhereToGoOn) {
    const auto store = make_store(10);
    for (const std::uint64_t i : {0, 1, 2, 4, 9}) {
        ASSERT_TRUE(add(*store, i, make_record(i, 5)));
    }
    const auto expect = [&](std::uint64_t first,
                            std::uint64_t count,
                            std::uint64_t next,
                            const std::vector<ScenarioInterval>& held) {
        const ResultsPart part = store->read(first, count, 1000).value();
        EXPECT_EQ(part.first, first);
        EXPECT_EQ(part.next, next);
        EXPECT_EQ(part.held, held) << first << " " << count;
        EXPECT_EQ(records_of(part).size(), part.count);
    };
    expect(0, 10, 10, {{0, 3}, {4, 1}, {9, 1}});
    expect(1, 1, 2, {{1, 1}});
    expect(3, 1, 4, {});
    expect(3, 5, 8, {{4, 1}});
    expect(9, ~std::uint64_t{0}, 10, {{9, 1}});
    expect(10, 10, 10, {});
    expect(~std::uint64_t{0}, 10, ~std::uint64_t{0}, {});
    expect(0, 0, 0, {});
    const ResultsPart little = store->read(1, 9, 20).value();
    EXPECT_EQ(little.next, 4u);
    EXPECT_EQ(little.held, (std::vector<ScenarioInterval>{{1, 2}}));
}

TEST_F(ResultStoreTest, ASampleHasTheRecordsOfItsPlaces) {
    const auto store = make_store(10);
    for (const std::uint64_t i : {0, 1, 2, 5, 7, 9}) {
        ASSERT_TRUE(add(*store, i, make_record(i, 5 + i)));
    }
    // The places of a sample of 4 are the scenarios 0, 2, 5 and 7; of 20, each twice.
    const ResultsPart all = store->read(0, 4, 1000, 4).value();
    EXPECT_EQ(all.held, (std::vector<ScenarioInterval>{{0, 4}}));
    EXPECT_EQ(all.next, 4u);
    EXPECT_EQ(records_of(all),
              (std::vector<Bytes>{
                  make_record(0, 5), make_record(2, 7), make_record(5, 10), make_record(7, 12)}));
    const ResultsPart rest = store->read(3, 10, 1000, 4).value();
    EXPECT_EQ(rest.held, (std::vector<ScenarioInterval>{{3, 1}}));
    EXPECT_EQ(rest.next, 4u);
    EXPECT_EQ(store->read(5, 8, 1000, 20).value().held,
              (std::vector<ScenarioInterval>{{5, 1}, {10, 2}}));
    const ResultsPart little = store->read(0, 4, 20, 4).value();
    EXPECT_EQ(little.next, 2u);
}

TEST_F(ResultStoreTest, OneRecordOverTheLimitIsGivenAlone) {
    const auto store = make_store(3);
    ASSERT_TRUE(add(*store, 0, make_record(0, 10)));
    ASSERT_TRUE(add(*store, 1, make_record(1, 3 * limits::result_buffer_bytes_max)));
    ASSERT_TRUE(add(*store, 2, make_record(2, 10)));
    EXPECT_EQ(store->read(0, 3, 100).value().count, 1u);
    const auto part = store->read(1, 3, 100).value();
    ASSERT_EQ(part.count, 1u);
    EXPECT_EQ(records_of(part)[0], make_record(1, 3 * limits::result_buffer_bytes_max));
}

TEST_F(ResultStoreTest, AJobOfAnAbsurdSizeTakesNoMemoryUntilItHasResults) {
    const auto store = make_store(limits::scenarios_max);
    ASSERT_TRUE(add(*store, limits::scenarios_max - 1, make_record(1, 10)));
    EXPECT_EQ(store->count(), 1u);
    EXPECT_EQ(store->read(limits::scenarios_max - 1, 5, 100).value().count, 1u);
}

TEST_F(ResultStoreTest, UncommittedRecordsAreUnreadableAndOverwritten) {
    const auto store = make_store(3);
    const Bytes first = make_record(0, 100);
    const Bytes second = make_record(1, 60);
    const ResultBatch dropped = batch_of(0, first);
    ASSERT_TRUE(write(*store, dropped));
    EXPECT_FALSE(store->has(0));
    ASSERT_TRUE(add(*store, 1, second));
    EXPECT_EQ(store->count(), 1u);
    EXPECT_EQ(records_of(store->read(1, 1, 1000).value())[0], second);
    EXPECT_TRUE(store->verify());
}

TEST_F(ResultStoreTest, TheLastOfSeveralRecordsOfAScenarioCounts) {
    const auto store = make_store(3);
    ASSERT_TRUE(add(*store, 1, make_record(0, 100)));
    ASSERT_TRUE(add(*store, 1, make_record(1, 60)));
    EXPECT_EQ(store->count(), 1u);
    EXPECT_EQ(records_of(store->read(1, 1, 1000).value())[0], make_record(1, 60));
}

TEST_F(ResultStoreTest, AClosedStoreHoldsNoFileOpenAndIsStillReadAndWritten) {
    const auto is_open = [this] {
        const auto descriptors = std::filesystem::directory_iterator("/proc/self/fd");
        return std::any_of(begin(descriptors), end(descriptors), [this](const auto& descriptor) {
            std::error_code gone;
            return std::filesystem::read_symlink(descriptor.path(), gone) == path();
        });
    };
    const auto store = make_store(3);
    ASSERT_TRUE(add(*store, 1, make_record(1, 60)));
    EXPECT_TRUE(is_open());
    store->close();
    EXPECT_FALSE(is_open());
    EXPECT_EQ(records_of(store->read(1, 1, 1000).value())[0], make_record(1, 60));
    EXPECT_TRUE(store->verify());
    EXPECT_FALSE(is_open());
    ASSERT_TRUE(add(*store, 2, make_record(2, 70)));
    EXPECT_EQ(records_of(store->read(1, 2, 1000).value())[1], make_record(2, 70));
    EXPECT_TRUE(store->verify());
}

TEST_F(ResultStoreTest, AReopenedStoreHasItsCommittedRecords) {
    std::uint64_t end = 0;
    {
        const auto store = make_store(100);
        for (std::uint64_t i = 0; i < 50; ++i) {
            ASSERT_TRUE(add(*store, i, make_record(i, 1 + 7 * i)));
        }
        end = store->end();
        const ResultBatch uncommitted = batch_of(70, make_record(70, 30));
        ASSERT_TRUE(write(*store, uncommitted));
    }
    const auto store = std::move(ResultStore::open(path(), JobId{7}, 100, end).value());
    std::uint64_t at = ResultStore::create(folder_ / "empty", JobId{7}, 1)->end();
    for (std::uint64_t i = 0; i < 50; ++i) {
        const RecordPlace place = ResultStore::place_at(at, 1 + 7 * i);
        ASSERT_TRUE(store->restore(i, place));
        at = ResultStore::end_of(place);
    }
    EXPECT_EQ(at, end);
    EXPECT_TRUE(store->verify());
    EXPECT_EQ(store->count(), 50u);
    EXPECT_EQ(records_of(store->read(0, 100, 1u << 20).value())[49], make_record(49, 1 + 7 * 49));
    EXPECT_FALSE(store->restore(60, {end, 5})) << "a record behind the end";
    EXPECT_FALSE(ResultStore::open(path(), JobId{8}, 100, end)) << "of another job";
    EXPECT_FALSE(ResultStore::open(path(), JobId{7}, 100, end + 1000)) << "cut short";
    EXPECT_FALSE(ResultStore::open(folder_ / "none", JobId{7}, 100, end)) << "not there";
}

TEST_F(ResultStoreTest, BatchesAreWrittenTogetherAndReadInAnyOrder) {
    constexpr std::uint64_t count = 2000;
    const auto store = make_store(count);
    std::vector<ResultBatch> batches(3);
    for (std::uint64_t i = 0; i < count; ++i) { // Every third is in the same batch.
        batches[i % 3].add(i, {}, make_record(i, 1 + i % 700));
    }
    std::vector<const ResultBatch*> all;
    for (const ResultBatch& batch : batches) {
        all.push_back(&batch);
    }
    ASSERT_TRUE(store->write(all));
    store->commit();
    std::uint64_t next = 0;
    for (const Bytes& record : records_of(store->read(0, count, 1u << 30).value())) {
        ASSERT_EQ(record, make_record(next, 1 + next % 700));
        ++next;
    }
    EXPECT_EQ(next, count);
    std::vector<std::uint64_t> visited;
    ASSERT_TRUE(store->verify([&](std::uint64_t scenario, std::span<const std::byte> record) {
        EXPECT_TRUE(std::ranges::equal(record, make_record(scenario, 1 + scenario % 700)));
        visited.push_back(scenario);
    }));
    ASSERT_EQ(visited.size(), count);
    EXPECT_EQ(visited[1], 3u) << "in the order of the file";
    EXPECT_EQ(visited.back(), 1997u);
}

TEST_F(ResultStoreTest, ARecordOfAnotherScenarioIsDamage) {
    std::uint64_t end = 0;
    {
        const auto store = make_store(2);
        ASSERT_TRUE(add(*store, 0, make_record(0, 10)));
        ASSERT_TRUE(add(*store, 1, make_record(1, 10)));
        end = store->end();
    }
    const auto store = std::move(ResultStore::open(path(), JobId{7}, 2, end).value());
    const RecordPlace first = ResultStore::place_at(ResultStore::first_end(), 10);
    ASSERT_TRUE(store->restore(0, ResultStore::place_at(ResultStore::end_of(first), 10)));
    EXPECT_FALSE(store->verify());
    EXPECT_FALSE(store->read(0, 1, 1000));
}

TEST_F(ResultStoreTest, EveryFlippedByteIsSeenAndNamed) {
    std::uint64_t end = 0;
    {
        const auto store = make_store(4);
        for (std::uint64_t i = 0; i < 4; ++i) {
            ASSERT_TRUE(add(*store, i, make_record(i, 10 + i)));
        }
        end = store->end();
    }
    const std::string good = read_text(path());
    for (std::size_t byte = 0; byte < good.size(); ++byte) {
        std::string bad = good;
        bad[byte] = static_cast<char>(bad[byte] ^ 0x10);
        write_text(path(), bad);
        const auto store = ResultStore::open(path(), JobId{7}, 4, end);
        Status status = store ? Status(Done{}) : Status(store.error());
        std::uint64_t at = 28; // End of the header.
        for (std::uint64_t i = 0; status && i < 4; ++i) {
            const RecordPlace place = ResultStore::place_at(at, 10 + i);
            status = store.value()->restore(i, place);
            at = ResultStore::end_of(place);
        }
        status = status ? store.value()->verify() : status;
        ASSERT_FALSE(status) << "byte " << byte;
        EXPECT_NE(status.error().detail.find("7.results"), std::string::npos);
    }
}

} // namespace
} // namespace cd::tests
