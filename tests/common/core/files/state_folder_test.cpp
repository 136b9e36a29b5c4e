// Proves that a program's state is private to its user, and that folders of other users are not
// touched.
#include "common/core/files/state_folder.hpp"

#include "tests/support/process.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>

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

TEST(PrivateFolder, AnExistingFolderIsUnchanged) {
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

/// Sets an environment variable, or removes it, for the life of this object.
class Variable {
  public:
    Variable(const char* name, const char* value) : name_(name) {
        if (const char* before = std::getenv(name)) {
            before_ = before;
        }
        set(value);
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;
    ~Variable() { set(before_ ? before_->c_str() : nullptr); }

  private:
    void set(const char* value) const {
        if (value == nullptr) {
            unsetenv(name_);
        } else {
            setenv(name_, value, 1);
        }
    }

    const char* name_;
    std::optional<std::string> before_;
};

TEST(StateFolder, IsAnAbsolutePathAlsoWithoutAHome) {
    const Variable no_state("XDG_STATE_HOME", nullptr);
    {
        const Variable home("HOME", "/home/ada");
        EXPECT_EQ(state_folder(), "/home/ada/.local/state/cdcluster");
    }
    const Variable no_home("HOME", nullptr);
    EXPECT_EQ(state_folder(), fs::current_path() / "cdcluster-state");
}

} // namespace
} // namespace cd::tests
