// Proves that each client message is allowed to exactly the roles that may send it.
#include "master/identity/access.hpp"

#include "common/core/timing/master.hpp"
#include "master/identity/identity.hpp"
#include "proto/access/join_token.hpp"
#include "tests/proto/sample_messages.hpp"
#include "tests/support/process.hpp"

#include <gtest/gtest.h>

#include <set>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

class AccessOfRoles : public testing::Test {
  protected:
    void SetUp() override {
        const MasterIdentity::Options options{1h};
        ASSERT_TRUE(MasterIdentity::init(folder_.path(), options));
        identity_ = std::move(MasterIdentity::open(folder_.path(), options).value());
        ASSERT_NE(identity_, nullptr);
    }

    [[nodiscard]] Access of(CertifiedRole role) const {
        return {*identity_, Identity{role, "someone", {}, identity_->now() + 1h}};
    }

    TemporaryFolder folder_;
    std::unique_ptr<MasterIdentity> identity_;
};

TEST_F(AccessOfRoles, EachRoleMaySendOnlyItsMessages) {
    const Message status{StatusQuery{}};
    const Message submit{Submit{}};
    const Message token{TokenCreate{}};
    const auto may = [&](CertifiedRole role, const Message& message) {
        return of(role).check(message).has_value();
    };
    EXPECT_TRUE(may(CertifiedRole::Metrics, status));
    EXPECT_FALSE(may(CertifiedRole::Metrics, submit));
    EXPECT_FALSE(may(CertifiedRole::Metrics, token));
    EXPECT_TRUE(may(CertifiedRole::Submitter, status));
    EXPECT_TRUE(may(CertifiedRole::Submitter, submit));
    EXPECT_FALSE(may(CertifiedRole::Submitter, token));
    EXPECT_TRUE(may(CertifiedRole::Admin, token));
    EXPECT_TRUE(may(CertifiedRole::Admin, submit));
    for (const Message& message : sample_messages()) {
        // The metrics role may only send status queries and heartbeats.
        const bool looks = std::holds_alternative<StatusQuery>(message) ||
                           std::holds_alternative<Heartbeat>(message);
        EXPECT_EQ(may(CertifiedRole::Metrics, message), looks) << message.index();
        EXPECT_FALSE(may(CertifiedRole::Worker, message)) << message.index();
        EXPECT_FALSE(may(CertifiedRole::Master, message)) << message.index();
        EXPECT_FALSE(Access(*identity_, std::nullopt).check(message)) << message.index();
        EXPECT_TRUE(Access().check(message)) << "without TLS";
    }
}

TEST_F(AccessOfRoles, AJobIsEndedByItsOwnerAndByAnAdmin) {
    EXPECT_EQ(of(CertifiedRole::Submitter).owner(), "someone");
    EXPECT_TRUE(of(CertifiedRole::Submitter).check_owner("someone"));
    const Status foreign = of(CertifiedRole::Submitter).check_owner("another");
    EXPECT_EQ(foreign.error().code, ErrorCode::Refused);
    EXPECT_NE(foreign.error().detail.find("'another'"), std::string::npos);
    EXPECT_TRUE(of(CertifiedRole::Admin).check_owner("another"));
    Access plain;
    plain.set_user("me@here");
    EXPECT_EQ(plain.owner(), "me@here");
    EXPECT_TRUE(plain.check_owner("you@there")) << "who is here may all";
}

TEST_F(AccessOfRoles, AnAdminSubmitsAtAPriorityAboveZero) {
    EXPECT_TRUE(of(CertifiedRole::Submitter).check_priority(0));
    EXPECT_TRUE(of(CertifiedRole::Submitter).check_priority(-10));
    const Status refused = of(CertifiedRole::Submitter).check_priority(1);
    EXPECT_EQ(refused.error().code, ErrorCode::Refused);
    EXPECT_NE(refused.error().detail.find("priority 1 needs the role admin"), std::string::npos);
    EXPECT_NE(refused.error().detail.find("'someone' is a submitter"), std::string::npos);
    EXPECT_TRUE(of(CertifiedRole::Admin).check_priority(10));
    EXPECT_TRUE(Access().check_priority(10)) << "without TLS";
}

TEST_F(AccessOfRoles, AnAdminSendsWorkersAwayAndRemovesMeshes) {
    for (const Message& message : {Message{DrainWorkers{}}, Message{RemoveMesh{}}}) {
        EXPECT_FALSE(of(CertifiedRole::Submitter).check(message));
        EXPECT_TRUE(of(CertifiedRole::Admin).check(message));
    }
    EXPECT_TRUE(of(CertifiedRole::Submitter).check(Message{Remove{}}));
    EXPECT_TRUE(of(CertifiedRole::Submitter).check(Message{JobQuery{}}));
}

TEST_F(AccessOfRoles, APeerGreetsInTheRoleOfItsCertificate) {
    EXPECT_TRUE(of(CertifiedRole::Worker).check(Role::Worker));
    EXPECT_FALSE(of(CertifiedRole::Worker).check(Role::Client));
    for (const CertifiedRole role :
         {CertifiedRole::Submitter, CertifiedRole::Admin, CertifiedRole::Metrics}) {
        EXPECT_TRUE(of(role).check(Role::Client));
        EXPECT_FALSE(of(role).check(Role::Worker));
    }
    EXPECT_FALSE(of(CertifiedRole::Master).check(Role::Worker));
    EXPECT_FALSE(of(CertifiedRole::Master).check(Role::Client));
    const Access nobody(*identity_, std::nullopt);
    EXPECT_TRUE(nobody.check(Role::Joiner));
    EXPECT_FALSE(nobody.check(Role::Worker));
    EXPECT_FALSE(nobody.check(Role::Client));
    EXPECT_TRUE(Access().check(Role::Worker));
    EXPECT_TRUE(Access().check(Role::Client));
    EXPECT_FALSE(Access().check(Role::Joiner)) << "without TLS there is nothing to join";
}

TEST_F(AccessOfRoles, AnExpiredCertificateAllowsNothing) {
    for (const auto left : {0s, -1s}) {
        const Access late(*identity_,
                          Identity{CertifiedRole::Admin, "someone", {}, identity_->now() + left});
        EXPECT_EQ(late.check_holder().error().code, ErrorCode::Refused);
        EXPECT_FALSE(late.check(Role::Client));
        EXPECT_FALSE(late.check(Role::Joiner));
        EXPECT_FALSE(late.check(Message{StatusQuery{}}));
    }
    EXPECT_TRUE(of(CertifiedRole::Admin).check_holder());
}

TEST_F(AccessOfRoles, ARefusedHolderMayDoNothingAnyMore) {
    const Access someone = of(CertifiedRole::Admin);
    const auto may = [&] {
        const bool may_ask = someone.check(Message{StatusQuery{}}).has_value();
        EXPECT_EQ(someone.check_holder().has_value(), may_ask);
        EXPECT_EQ(someone.check(Role::Client).has_value(), may_ask);
        EXPECT_EQ(someone.check(Role::Joiner).has_value(), may_ask);
        const auto request = make_certificate_request().request;
        EXPECT_EQ(identity_->renew(Renew{request}, *someone.holder()).has_value(), may_ask);
        return may_ask;
    };
    EXPECT_TRUE(may());
    write_text(folder_ / "refused", "someone else\nsome\n");
    EXPECT_TRUE(may());
    write_text(folder_ / "refused", "other\n  someone \r\n");
    EXPECT_FALSE(may());
    Join join;
    join.name = "someone";
    EXPECT_NE(identity_->join(join, {}).error().detail.find("refused by this cluster"),
              std::string::npos);
    std::filesystem::remove(folder_ / "refused");
    EXPECT_TRUE(may());
    // An unreadable list refuses every certificate.
    std::filesystem::create_directory(folder_ / "refused");
    EXPECT_FALSE(may());
}

TEST_F(AccessOfRoles, AnIdentityIsMadeOnceAndStaysTheSame) {
    const TemporaryFolder other;
    const MasterIdentity::Options options{1h};
    EXPECT_EQ(MasterIdentity::open(other.path(), options).value(), nullptr);
    const auto admin = MasterIdentity::admin_path(folder_.path());
    const std::string first = read_text(admin);
    ASSERT_TRUE(MasterIdentity::init(folder_.path(), options));
    EXPECT_NE(read_text(admin), first);
    const auto again = MasterIdentity::open(folder_.path(), options);
    EXPECT_EQ(again.value()->fingerprint(), identity_->fingerprint());
    write_text(folder_ / "identity/authority.pem", "damaged");
    EXPECT_EQ(MasterIdentity::open(folder_.path(), options).error().code, ErrorCode::BadInput);
    EXPECT_FALSE(MasterIdentity::init(folder_.path(), options)) << "nothing is overwritten";
    EXPECT_EQ(read_text(folder_ / "identity/authority.pem"), "damaged");
}

TEST_F(AccessOfRoles, TheMastersNameIsRefusedToJoiners) {
    const auto made = identity_->create_token({CertifiedRole::Worker, 3600, 2});
    const JoinToken token = parse_join_token(made.value().token).value();
    const auto join_as = [&](const std::string& name) {
        Join join;
        join.token = token.id;
        join.name = name;
        join.request = make_certificate_request().request;
        join.proof = join_proof(token, Sha256{}, join.request);
        return identity_->join(join, Sha256{});
    };
    for (const char* name : {"master", "Master", "master.", "admin", "cdcluster authority"}) {
        const auto refused = join_as(name);
        ASSERT_FALSE(refused) << name;
        EXPECT_EQ(refused.error().code, ErrorCode::Refused);
        EXPECT_NE(refused.error().detail.find("choose another"), std::string::npos);
    }
    // The refusal spends no use of the token.
    EXPECT_TRUE(join_as("master-2"));
    EXPECT_TRUE(join_as("the master"));
    EXPECT_FALSE(join_as("worker"));
}

TEST_F(AccessOfRoles, TheMastersOwnCertificateIsRenewedInTime) {
    WallTime now = std::chrono::system_clock::now();
    const MasterIdentity::Options options{1h, [&now] { return now; }};
    const auto identity = std::move(MasterIdentity::open(folder_.path(), options).value());
    const auto first = identity->tls()->now;
    ASSERT_TRUE(identity->keep_valid());
    EXPECT_EQ(identity->tls()->now, first);
    const std::string admin = read_text(MasterIdentity::admin_path(folder_.path()));
    now += timing::master_certificate_life / 2 + 1h;
    ASSERT_TRUE(identity->keep_valid());
    EXPECT_NE(identity->tls()->now, first);
    EXPECT_NE(read_text(MasterIdentity::admin_path(folder_.path())), admin);
}

} // namespace
} // namespace cd::tests
