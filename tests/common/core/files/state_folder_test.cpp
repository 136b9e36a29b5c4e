// Proves that a program's state is private to its user, and that folders of other users are not
// touched.
#include "common/core/files/state_folder.hpp"

#include "tests/support/process.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace cd::tests {
namespace {

namespace fs = std::filesystem;

TEST(PrivateFolder, IsForItsUserAloneWhenItIsMade) {
    const TemporaryFolder folder;
    for (const char* name : {"one", "above/two", "three/"}) {
        ASSERT_TRUE(make_private_folder(folder / name));
        EXPECT_EQ(fs::status(folder / name).permissions(), fs::perms::owner_all) << name;
    }
    EXPECT_NE(fs::status(folder / "above").permissions(), fs::perms::owner_all);
}

TEST(PrivateFolder, OneThatIsThereStaysAsItIs) {
    const TemporaryFolder folder;
    const fs::path there = folder / "there";
    fs::create_directory(there);
    const fs::perms before = fs::perms::owner_all | fs::perms::group_read;
    fs::permissions(there, before);
    ASSERT_TRUE(make_private_folder(there));
    EXPECT_EQ(fs::status(there).permissions(), before);
    std::ofstream(folder / "file") << "text";
    EXPECT_FALSE(make_private_folder(folder / "file"));
    EXPECT_FALSE(make_private_folder(folder / "file" / "below"));
}

} // namespace
} // namespace cd::tests
