// Proves that a credential is read back as written, is readable by its owner only, and that an
// invalid file, or one that others may read, is not used.
#include "proto/access/credential_file.hpp"

#include "common/core/limits/wire.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/channel/tls.hpp"
#include "tests/support/process.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

Credential some_credential() {
    const WallTime now = std::chrono::system_clock::now();
    const auto authority = CertificateAuthority::make(now);
    return authority.issue({CertifiedRole::Worker, "blade-3", now, now + 1h});
}

TEST(CredentialFile, ComesBackAndIsForItsOwnerAlone) {
    const TemporaryFolder folder;
    const fs::path path = credential_path(folder / "deeper", {"node-1", 7600});
    EXPECT_EQ(path.filename(), "node-1_7600.pem");
    const Credential written = some_credential();
    ASSERT_TRUE(write_credential(path, written));
    EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    const auto read = read_credential(path);
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_EQ(read.value().key, written.key);
    EXPECT_EQ(read.value().certificate, written.certificate);
    EXPECT_EQ(read.value().authority, written.authority);
    EXPECT_TRUE(Tls::make(read.value()));
    const Credential next = some_credential();
    ASSERT_TRUE(write_credential(path, next));
    EXPECT_EQ(read_credential(path).value().key, next.key);
}

TEST(CredentialFile, WhatOthersMayReadIsNotUsed) {
    const TemporaryFolder folder;
    const fs::path path = folder / "c.pem";
    ASSERT_TRUE(write_credential(path, some_credential()));
    for (const fs::perms others : {fs::perms::group_read, fs::perms::others_read}) {
        fs::permissions(path, fs::perms::owner_read | others);
        EXPECT_EQ(read_credential(path).error().code, ErrorCode::Refused);
    }
}

TEST(CredentialFile, WhatBelongsToAnotherIsNotUsed) {
    if (::geteuid() != 0) {
        GTEST_SKIP() << "only root gives files away";
    }
    const TemporaryFolder folder;
    const fs::path path = folder / "c.pem";
    ASSERT_TRUE(write_credential(path, some_credential()));
    ASSERT_EQ(::chown(path.c_str(), 12345, 12345), 0);
    EXPECT_EQ(read_credential(path).error().code, ErrorCode::Refused);
    EXPECT_EQ(read_credential(folder.path()).error().code, ErrorCode::Io) << "no file";
}

/// Sets the folder for relative names while it lives.
class WorkingFolder {
  public:
    explicit WorkingFolder(const fs::path& folder) { fs::current_path(folder); }
    WorkingFolder(const WorkingFolder&) = delete;
    WorkingFolder& operator=(const WorkingFolder&) = delete;
    ~WorkingFolder() { fs::current_path(before_); }

  private:
    fs::path before_ = fs::current_path();
};

TEST(CredentialFile, ItsNameMayStandAlone) {
    const TemporaryFolder folder;
    const WorkingFolder here(folder.path());
    ASSERT_TRUE(check_can_write("me.pem"));
    EXPECT_FALSE(fs::exists("me.pem")) << "nothing is left of a try";
    const Status written = write_credential("me.pem", some_credential());
    ASSERT_TRUE(written) << written.error().detail;
    EXPECT_TRUE(read_credential("me.pem"));
}

TEST(CredentialFile, WhereNoneCanBeWrittenIsKnownBefore) {
    const TemporaryFolder folder;
    std::ofstream(folder / "file") << "text";
    for (const fs::path& path : {fs::path(folder / "file") / "me.pem",
                                 fs::path(folder.path()) / "",
                                 folder.path(),
                                 fs::path("/proc/none/me.pem"),
                                 fs::path()}) {
        EXPECT_FALSE(check_can_write(path)) << path;
    }
    EXPECT_TRUE(check_can_write(fs::path(folder / "new") / "me.pem"));
    EXPECT_EQ(fs::status(folder / "new").permissions(), fs::perms::owner_all);
}

TEST(CredentialFile, WhatIsNoneIsRefused) {
    const TemporaryFolder folder;
    const fs::path path = folder / "c.pem";
    EXPECT_EQ(read_credential(path).error().code, ErrorCode::NotFound);
    const Credential good = some_credential();
    for (const std::string& text :
         {std::string(), std::string("hello"), good.key, good.certificate}) {
        ASSERT_TRUE(write_private(path, text));
        EXPECT_EQ(read_credential(path).error().code, ErrorCode::BadInput);
    }
    ASSERT_TRUE(write_private(path, std::string(5 * limits::certificate_bytes_max, 'x')));
    EXPECT_EQ(read_credential(path).error().code, ErrorCode::TooLarge);
}

TEST(CredentialFile, IsRenewedWhenHalfOfItsTimeIsOver) {
    const WallTime now = std::chrono::system_clock::now();
    const Identity identity{
        CertifiedRole::Worker, "w", now - timing::clock_difference_max, now + 24h};
    EXPECT_EQ(renew_at(identity), now + 12h);
}

} // namespace
} // namespace cd::tests
