// Proves that a folder with locks passes the check, which leaves nothing there. tests/deploy/slurm
// proves what a master says of a file system without locks.
#include "master/base/file_locks.hpp"

#include "tests/support/process.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

TEST(FileLocks, AFolderWithLocksPassesAndStaysEmpty) {
    const TemporaryFolder folder;
    EXPECT_TRUE(check_file_locks(folder.path()));
    EXPECT_TRUE(check_file_locks(folder.path())) << "the first check has dropped its locks";
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(FileLocks, WithoutRoomForAFileNothingIsSaid) {
    const TemporaryFolder folder;
    EXPECT_TRUE(check_file_locks(folder / "none"));
}

} // namespace
} // namespace cd::tests
