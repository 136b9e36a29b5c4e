// Proves, with real processes, that a token's use still counts in the next master incarnation, and
// that no recorded conversation of an earlier one admits anyone.
#include "proto/access/credential_file.hpp"
#include "tests/cluster/mortal_master.hpp"
#include "tests/support/comes_true.hpp"

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

class SecuredRestart : public MortalCluster {
  protected:
    SecuredRestart() : MortalCluster({}, Links::Secured) {}
};

/// The master's clock is wrong for a while, so TLS rejects all its workers.
TEST_F(SecuredRestart, AKnownWorkerRetriesAfterTlsRefusals) {
    Process& worker = start_worker();
    auto connection = connect();
    EXPECT_TRUE(comes_true([&] { return connection->status().value().workers.size() == 1; }));
    connection.reset();
    master_.kill();
    const std::filesystem::path identity = folder_ / "state/identity";
    std::filesystem::rename(identity, folder_ / "right");
    (void)make_identity();
    master_.start();
    const auto refusals = [&] {
        const std::string log = worker.errors();
        std::size_t count = 0;
        for (std::size_t at = 0;
             (at = log.find("refused, retrying for", at + 1)) != std::string::npos;) {
            ++count;
        }
        return count;
    };
    EXPECT_TRUE(comes_true([&] { return refusals() >= 3; })) << worker.errors();
    EXPECT_THAT(worker.errors(), HasSubstr("clocks"));
    EXPECT_TRUE(worker.is_running());
    master_.kill();
    std::filesystem::remove_all(identity);
    std::filesystem::rename(folder_ / "right", identity);
    master_.start();
    connection = connect();
    EXPECT_TRUE(comes_true([&] { return connection->status().value().workers.size() == 1; }));
    EXPECT_TRUE(worker.is_running());
}

} // namespace
} // namespace cd::tests
