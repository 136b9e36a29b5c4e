// Proves that a record file returns all added records, whole or sparse, and that a file truncated
// or damaged at any byte gives whole, right blocks or an error.
#include "common/job/result/record_file.hpp"

#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace cd::tests {

namespace {

using testing::HasSubstr;

/// Makes a distinct result for each index; a few have pairs.
ScenarioResult result_of(std::uint64_t index) {
    ScenarioResult result;
    result.index = index;
    for (std::uint32_t i = 0; i < index % 4; ++i) {
        result.pairs.push_back({i,
                                static_cast<std::uint32_t>(index + i),
                                i == 0 ? PairClass::Proper : PairClass::Touch});
    }
    result.pair_count = result.pairs.size();
    result.kind = result.pairs.empty() ? ScenarioClass::Separate : ScenarioClass::Cross;
    return result;
}

Bytes bytes_of(const std::filesystem::path& path) {
    const std::string text = read_text(path);
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

void put(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    write_text(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

class RecordFiles : public testing::Test {
  protected:
    /// Adds scenarios [first, end) in blocks of `block` records each.
    static void
    add(RecordWriter& writer, std::uint64_t first, std::uint64_t end, std::uint64_t block) {
        for (std::uint64_t i = first; i < end; ++i) {
            writer.add(i, encode_result(result_of(i)));
            if ((i + 1) % block == 0 || writer.is_full()) {
                ASSERT_TRUE(writer.flush());
            }
        }
    }

    /// Returns the number of records; expects each to be right, and that they begin with scenario
    /// 0.
    static std::uint64_t checked(const RecordFile& file) {
        std::uint64_t next = 0;
        const Status read = file.for_each([&](const RecordView& record) -> Status {
            EXPECT_EQ(record.result.index, next);
            EXPECT_TRUE(std::ranges::equal(record.bytes, encode_result(result_of(next))));
            ++next;
            return Done{};
        });
        EXPECT_TRUE(read) << read.error().detail;
        return next;
    }

    TemporaryFolder folder_;
    const std::filesystem::path path_ = folder_ / "records";
};

TEST_F(RecordFiles, RecordsThatAreNotKeptAreAsMissing) {
    auto writer = RecordWriter::create(path_);
    ASSERT_TRUE(writer);
    add(writer.value(), 0, 100, 32);
    ASSERT_TRUE(writer.value().finish());
    auto file = RecordFile::open(path_);
    ASSERT_TRUE(file);
    ASSERT_NE(file.value().find(33).value(), nullptr) << "its block is kept now";
    file.value().keep_only([](const ScenarioResult& result) { return result.index % 10 == 0; });
    std::vector<std::uint64_t> indices;
    ASSERT_TRUE(file.value().for_each([&](const RecordView& record) -> Status {
        indices.push_back(record.result.index);
        return Done{};
    }));
    EXPECT_EQ(indices, (std::vector<std::uint64_t>{0, 10, 20, 30, 40, 50, 60, 70, 80, 90}));
    EXPECT_EQ(file.value().read(1).value().size(), 3u) << "40, 50 and 60";
    EXPECT_EQ(file.value().find(33).value(), nullptr);
    EXPECT_NE(file.value().find(50).value(), nullptr);
}

TEST_F(RecordFiles, AFileGivesBackWhatWasAdded) {
    {
        auto writer = RecordWriter::create(path_);
        ASSERT_TRUE(writer);
        add(writer.value(), 0, 10'000, 1u << 20);
        ASSERT_TRUE(writer.value().finish());
    }
    auto file = RecordFile::open(path_);
    ASSERT_TRUE(file) << file.error().detail;
    EXPECT_EQ(file.value().count(), 10'000u);
    EXPECT_EQ(file.value().blocks(), 3u) << "of 4,096 records each";
    EXPECT_EQ(checked(file.value()), 10'000u);
    for (const std::uint64_t scenario : {0, 1, 4095, 4096, 9999}) {
        const auto found = file.value().find(scenario);
        ASSERT_TRUE(found && found.value());
        EXPECT_EQ(found.value()->bytes, encode_result(result_of(scenario)));
    }
    const auto none = file.value().find(10'000);
    ASSERT_TRUE(none);
    EXPECT_EQ(none.value(), nullptr);
}

TEST_F(RecordFiles, ScenariosWithoutAResultAreLeftOut) {
    {
        auto writer = RecordWriter::create(path_);
        ASSERT_TRUE(writer);
        for (std::uint64_t i = 5; i < 9'000; i += 7) {
            writer.value().add(i, encode_result(result_of(i)));
        }
        ASSERT_TRUE(writer.value().finish());
    }
    auto file = RecordFile::open(path_);
    ASSERT_TRUE(file) << file.error().detail;
    for (std::uint64_t i = 0; i < 100; ++i) {
        const auto found = file.value().find(i);
        ASSERT_TRUE(found);
        EXPECT_EQ(found.value() != nullptr, i >= 5 && (i - 5) % 7 == 0) << i;
    }
}

TEST_F(RecordFiles, AFileCutAtAnyByteReadsToItsLastWholeBlock) {
    std::vector<std::uint64_t> ends; // File size after each block of three.
    {
        auto writer = RecordWriter::create(path_);
        ASSERT_TRUE(writer);
        ends.push_back(std::filesystem::file_size(path_));
        for (std::uint64_t block = 0; block < 4; ++block) {
            add(writer.value(), 3 * block, 3 * block + 3, 3);
            ends.push_back(std::filesystem::file_size(path_));
        }
        ASSERT_TRUE(writer.value().finish());
    }
    const Bytes whole = bytes_of(path_);
    for (std::size_t size = 0; size <= whole.size(); ++size) {
        SCOPED_TRACE(testing::Message() << "cut at " << size);
        put(path_, std::span(whole).first(size));
        std::uint64_t expected = 0;
        while (expected + 1 < ends.size() && ends[expected + 1] <= size) {
            ++expected;
        }
        const auto read = RecordFile::open_unfinished(path_);
        ASSERT_TRUE(read) << read.error().detail;
        EXPECT_EQ(checked(read.value()), 3 * expected);
        EXPECT_EQ(RecordFile::open(path_).has_value(), size == whole.size());
    }
}

TEST_F(RecordFiles, WritingGoesOnAfterTheLastWholeBlock) {
    {
        auto writer = RecordWriter::create(path_);
        ASSERT_TRUE(writer);
        add(writer.value(), 0, 95, 10);
    } // Without an end; five records were never written.
    const auto size = std::filesystem::file_size(path_);
    std::filesystem::resize_file(path_, size - 1);
    {
        auto writer = RecordWriter::resume(path_);
        ASSERT_TRUE(writer) << writer.error().detail;
        EXPECT_EQ(writer.value().written(), 80u);
        ASSERT_TRUE(writer.value().cut_before(75));
        EXPECT_EQ(writer.value().written(), 70u);
        add(writer.value(), 70, 120, 50);
        ASSERT_TRUE(writer.value().finish());
    }
    const auto file = RecordFile::open(path_);
    ASSERT_TRUE(file) << file.error().detail;
    EXPECT_EQ(checked(file.value()), 120u);
    {
        auto writer = RecordWriter::resume(path_);
        ASSERT_TRUE(writer);
        EXPECT_EQ(writer.value().written(), 120u) << "a finished file goes on, too";
    }
}

TEST_F(RecordFiles, DamageIsAnErrorOrEndsTheFile) {
    {
        auto writer = RecordWriter::create(path_);
        ASSERT_TRUE(writer);
        add(writer.value(), 0, 6, 3);
        ASSERT_TRUE(writer.value().finish());
    }
    const Bytes whole = bytes_of(path_);
    for (std::size_t at = 0; at < whole.size(); ++at) {
        SCOPED_TRACE(testing::Message() << "byte " << at);
        Bytes damaged = whole;
        damaged[at] ^= std::byte{0x10};
        put(path_, damaged);
        if (const auto scanned = RecordFile::open_unfinished(path_)) {
            EXPECT_LE(checked(scanned.value()), 6u);
        } else {
            EXPECT_THAT(scanned.error().detail, HasSubstr(path_.string()));
        }
        // Bytes 12 to 15 have no meaning.
        const auto opened = RecordFile::open(path_);
        const Status read =
            opened ? opened.value().for_each([](const RecordView&) -> Status { return Done{}; })
                   : Status(opened.error());
        EXPECT_EQ(read.has_value(), at >= 12 && at < 16);
        if (!read) {
            EXPECT_THAT(read.error().detail, HasSubstr(path_.string()));
        }
    }
}

TEST_F(RecordFiles, BlocksWhoseScenariosOverlapAreDamage) {
    {
        auto writer = RecordWriter::create(path_);
        ASSERT_TRUE(writer);
        for (const std::uint64_t scenario : {0, 10}) {
            writer.value().add(scenario, encode_result(result_of(scenario)));
        }
        ASSERT_TRUE(writer.value().flush());
        writer.value().add(5, encode_result(result_of(5)));
        ASSERT_TRUE(writer.value().finish());
    }
    auto file = RecordFile::open(path_);
    ASSERT_TRUE(file) << file.error().detail;
    const Status read = file.value().for_each([](const RecordView&) -> Status { return Done{}; });
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().detail, HasSubstr(path_.string() + " is damaged"));
    EXPECT_FALSE(file.value().find(0));
}

TEST_F(RecordFiles, AFileOfAnotherKindIsNamed) {
    write_text(path_, "scenario,class,count\n0,separate,0\n");
    for (const auto& file : {RecordFile::open(path_), RecordFile::open_unfinished(path_)}) {
        ASSERT_FALSE(file);
        EXPECT_EQ(file.error().code, ErrorCode::Io);
        EXPECT_THAT(file.error().detail, HasSubstr(path_.string()));
    }
    EXPECT_FALSE(RecordWriter::resume(path_));
    EXPECT_EQ(RecordFile::open(folder_ / "none").error().code, ErrorCode::NotFound);
}

} // namespace

} // namespace cd::tests
