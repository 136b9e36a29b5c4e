// Tests that an HDF5 file appears only once it is complete, and that equal arrays make equal files.
// tests/export reads such files with h5py.
#include "client/formats/h5.hpp"

#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <numeric>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::StartsWith;
namespace fs = std::filesystem;

/// Appends more than a chunk of an array of rows, and some rows in pieces.
Status fill(ArrayFile& file) {
    const std::size_t rows = file.add_array({"group/rows", NpyType::U4, 2});
    const std::size_t numbers = file.add_array({"numbers", NpyType::F8});
    std::vector<std::uint32_t> values(100001);
    std::iota(values.begin(), values.end(), 0u);
    const std::array<std::uint32_t, 1> last{7};
    const std::array<double, 2> some{0.5, -1};
    for (const Status& status : {file.append(rows, std::span<const std::uint32_t>(values)),
                                 file.append(rows, std::span<const std::uint32_t>(last)),
                                 file.append(numbers, std::span<const double>(some))}) {
        if (!status) {
            return status;
        }
    }
    return Done{};
}

TEST(H5File, AppearsOnceItIsWholeAndIsTheSameEachTime) {
    const TemporaryFolder folder;
    for (const char* const name : {"a.h5", "b.h5"}) {
        H5Writer writer(folder / name);
        ASSERT_TRUE(fill(writer));
        EXPECT_FALSE(fs::exists(folder / name));
        ASSERT_TRUE(writer.finish());
    }
    EXPECT_THAT(read_text(folder / "a.h5"), StartsWith("\x89HDF\r\n\x1a\n"));
    EXPECT_EQ(read_text(folder / "a.h5"), read_text(folder / "b.h5"));
    EXPECT_LT(fs::file_size(folder / "a.h5"), 200000u) << "of 400,016 bytes";
}

TEST(H5File, IsTheSameIfSeveralThreadsWriteFiles) {
    const TemporaryFolder folder;
    const auto write = [&](const std::string& name) {
        H5Writer writer(folder / name);
        EXPECT_TRUE(fill(writer));
        EXPECT_TRUE(writer.finish());
    };
    write("alone.h5");
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < 4; ++i) {
            threads.emplace_back(write, std::to_string(i) + ".h5");
        }
    }
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(read_text(folder / (std::to_string(i) + ".h5")), read_text(folder / "alone.h5"));
    }
}

TEST(H5File, ThatIsAbandonedLeavesNothing) {
    const TemporaryFolder folder;
    {
        H5Writer writer(folder / "a.h5");
        ASSERT_TRUE(fill(writer));
        EXPECT_FALSE(fs::is_empty(folder.path()));
    }
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(H5File, NamesWhatCannotBeWritten) {
    const TemporaryFolder folder;
    H5Writer nowhere(folder / "missing" / "a.h5");
    const Status written = fill(nowhere);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::Io);
    EXPECT_THAT(written.error().detail, HasSubstr("missing/a.h5: cannot be written"));

    H5Writer writer(folder / "a.h5");
    const std::size_t array = writer.add_array({".", NpyType::U1});
    const std::array<std::uint8_t, 1> value{1};
    const Status named = writer.append(array, std::span<const std::uint8_t>(value));
    ASSERT_FALSE(named);
    EXPECT_THAT(named.error().detail, HasSubstr("'.'"));
}

} // namespace

} // namespace cd::tests
