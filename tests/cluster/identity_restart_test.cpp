// Proves, with real processes, that a use of a token counts in the master's next life, too, and
// that no conversation of the life before lets anyone in.
#include "proto/credential_file.hpp"
#include "tests/cluster/mortal_master.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::HasSubstr;

TEST(IdentityRestart, ATokenThatWasUsedUpStaysSo) {
    const TemporaryFolder folder;
    const std::filesystem::path state = folder / "state";
    ASSERT_EQ(tests::run({program("cdmaster").string(), "init", "--state", state}).exit_code, 0);
    MortalMaster master(folder);
    const Ran made = tests::run({program("cdctl").string(),
                                 "token",
                                 "create",
                                 "--uses",
                                 "2",
                                 "--master",
                                 master.address(),
                                 "--credential",
                                 state / "identity" / "admin.pem"});
    ASSERT_EQ(made.exit_code, 0) << made.errors;
    const std::string token = made.output.substr(0, made.output.find('\n'));
    const auto join = [&](const std::string& name) {
        return tests::run({program("cdworker").string(),
                           "join",
                           master.address(),
                           "--token",
                           token,
                           "--state",
                           folder / name});
    };
    EXPECT_EQ(join("one").exit_code, 0);
    master.kill();
    master.start();
    EXPECT_EQ(join("two").exit_code, 0) << "one use was left";
    master.kill();
    master.start();
    EXPECT_EQ(join("three").exit_code, 5);
    EXPECT_THAT(master.log(), HasSubstr("the token is exhausted"));
    EXPECT_TRUE(std::filesystem::is_empty(folder / "three"));
}

} // namespace
} // namespace cd::tests
