// Proves that an identity is made whole or not at all, and is read by a check of another user.
#include "master/identity/identity.hpp"

#include "tests/support/process.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>

namespace cd::tests {
namespace {

namespace fs = std::filesystem;

const MasterIdentity::Options hour_long{std::chrono::hours(1)};

/// Makes an identity; the system kills the process that writes more than `bytes` into a file.
[[noreturn]] void init_with_files_up_to(rlim_t bytes, const fs::path& state) {
    std::signal(SIGXFSZ, SIG_DFL);
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::_exit(MasterIdentity::init(state, hour_long) ? 0 : 1);
}

TEST(MasterIdentityInit, AProcessThatDiesLeavesNothingHalf) {
    const TemporaryFolder whole;
    ASSERT_TRUE(MasterIdentity::init(whole.path(), hour_long));
    const auto bytes = [&](const char* file) { return fs::file_size(whole / "identity" / file); };
    const auto key = bytes("authority.key");
    const auto certificate = bytes("authority.pem");
    const auto admin = bytes("admin.pem");
    ASSERT_TRUE(key < certificate && certificate < admin);
    // The process dies while it writes the key, the certificate, and the admin's credential.
    for (const auto limit : {key / 2, (key + certificate) / 2, (certificate + admin) / 2}) {
        const TemporaryFolder state;
        EXPECT_EXIT(
            init_with_files_up_to(limit, state.path()), testing::KilledBySignal(SIGXFSZ), "");
        EXPECT_FALSE(fs::exists(state / "identity"));
        EXPECT_TRUE(MasterIdentity::check(state.path()));
        EXPECT_TRUE(MasterIdentity::init(state.path(), hour_long)) << "it begins anew";
        EXPECT_TRUE(fs::exists(MasterIdentity::admin_path(state.path())));
        EXPECT_FALSE(fs::exists(state / "identity.new"));
        const auto opened = MasterIdentity::open(state.path(), hour_long);
        EXPECT_TRUE(opened && opened.value());
    }
}

TEST(MasterIdentityInit, AnEmptyFolderIsFilled) {
    const TemporaryFolder state;
    fs::create_directory(state / "identity");
    ASSERT_TRUE(MasterIdentity::init(state.path(), hour_long));
    EXPECT_TRUE(fs::exists(MasterIdentity::admin_path(state.path())));
}

TEST(MasterIdentityInit, ASecondOneKeepsTheAuthority) {
    const TemporaryFolder state;
    ASSERT_TRUE(MasterIdentity::init(state.path(), hour_long));
    const std::string authority = read_text(state / "identity/authority.pem");
    const std::string admin = read_text(state / "identity/admin.pem");
    ASSERT_TRUE(MasterIdentity::init(state.path(), hour_long));
    EXPECT_EQ(read_text(state / "identity/authority.pem"), authority);
    EXPECT_NE(read_text(state / "identity/admin.pem"), admin);
}

TEST(MasterIdentityCheck, TheFilesOfAnotherUserAreReadByRoot) {
    if (::geteuid() != 0) {
        GTEST_SKIP() << "only root can give files away";
    }
    const TemporaryFolder state;
    ASSERT_TRUE(MasterIdentity::init(state.path(), hour_long));
    for (const auto& file : fs::directory_iterator(state / "identity")) {
        ASSERT_EQ(::chown(file.path().c_str(), 12345, 12345), 0);
    }
    EXPECT_TRUE(MasterIdentity::check(state.path()));
    EXPECT_FALSE(MasterIdentity::open(state.path(), hour_long)) << "it would write files of root";
}

} // namespace
} // namespace cd::tests
