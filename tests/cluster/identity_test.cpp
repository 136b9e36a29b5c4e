// Proves, with real processes, that a cluster with an identity gives the right answer under TLS,
// geometry between workers included; and that a peer without rights is refused with a log line on
// the master and exit code 5.
#include "client/remote/membership.hpp"
#include "proto/access/credential_file.hpp"
#include "proto/access/join_token.hpp"
#include "proto/channel/asio_tls.hpp"
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/support/comes_true.hpp"
#include "tests/support/obj_file.hpp"
#include "tests/support/shapes.hpp"
#include "web/status/job_id.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <cstdlib>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr std::chrono::seconds patience{60};

class SecuredCluster : public Cluster {
  protected:
    void prepare() override {
        const Ran made =
            tests::run({program("cdmaster").string(), "init", "--state", state().string()});
        ASSERT_EQ(made.exit_code, 0) << made.errors;
        EXPECT_THAT(made.output, HasSubstr("authority   "));
    }

    [[nodiscard]] std::shared_ptr<const Tls> tls() const override {
        return Tls::make(read_credential(admin()).value()).value();
    }

    [[nodiscard]] fs::path state() const { return folder_ / "state"; }
    [[nodiscard]] fs::path admin() const { return state() / "identity" / "admin.pem"; }
    [[nodiscard]] std::string log() const { return read_text(folder_ / "master.log"); }

    [[nodiscard]] CertificateAuthority authority() const {
        return std::move(CertificateAuthority::parse(read_text(state() / "identity/authority.pem"),
                                                     read_text(state() / "identity/authority.key"))
                             .value());
    }

    /// Writes a credential as the authority itself could have issued it.
    [[nodiscard]] fs::path write_issued(const CertificateAuthority& issuer,
                                        CertifiedRole role,
                                        std::chrono::seconds until = 1h,
                                        const std::string& holder = "someone") const {
        const WallTime now = std::chrono::system_clock::now();
        const fs::path path = folder_ / (holder + "-" + std::string(to_text(role)) + ".pem");
        EXPECT_TRUE(write_credential(path, issuer.issue({role, holder, now - 2h, now + until})));
        return path;
    }

    [[nodiscard]] Ran cdctl(std::vector<std::string> words, const fs::path& credential) const {
        words.insert(words.begin(), program("cdctl").string());
        words.insert(words.end(),
                     {"--master", master_->address(), "--credential", credential.string()});
        return tests::run(words);
    }

    [[nodiscard]] std::string token(const std::string& role, const std::string& uses) const {
        const Ran made = cdctl({"token", "create", "--role", role, "--uses", uses}, admin());
        EXPECT_EQ(made.exit_code, 0) << made.errors;
        return made.output.substr(0, made.output.find('\n'));
    }

    [[nodiscard]] Ran join_worker(const std::string& token_text,
                                  const fs::path& place,
                                  const std::vector<std::string>& options = {}) const {
        std::vector<std::string> words{program("cdworker").string(),
                                       "join",
                                       master_->address(),
                                       "--token",
                                       token_text,
                                       "--state",
                                       place.string()};
        words.insert(words.end(), options.begin(), options.end());
        return tests::run(words);
    }

    Process& start_joined(const std::string& token_text, const std::string& name) {
        const fs::path place = folder_ / name;
        const Ran joined = join_worker(token_text, place);
        EXPECT_EQ(joined.exit_code, 0) << joined.output << joined.errors;
        return start_worker(1, {"--state", place.string()});
    }
};

// ---- Authorised peers --------------------------------------------------------------------

TEST_F(SecuredCluster, AWholeJobWithPeersHasTheSameDigest) {
    const Job job = make_job(300);
    const std::string worker_token = token("worker", "3");
    for (const char* name : {"one", "two", "three"}) {
        start_joined(worker_token, name);
    }
    ClusterOptions everything_everywhere = many_blocks();
    everything_everywhere.strategy = "random";
    everything_everywhere.q = 4;
    const JobStatus status = run(job, Query{}, everything_everywhere);
    ASSERT_EQ(status.state, JobState::Done);
    EXPECT_EQ(status.digest, job.digest_in_one_process(Query{}));
    const auto cluster = connection_->status();
    ASSERT_TRUE(cluster);
    std::uint64_t from_peers = 0;
    for (const WorkerStatus& worker : cluster.value().workers) {
        from_peers += worker.cache.blocks.peer_bytes;
    }
    EXPECT_GT(from_peers, 0u);
    EXPECT_THAT(log(), HasSubstr("tls=true"));
}

TEST_F(SecuredCluster, AJobIsRemovedByItsOwnerOrAnAdmin) {
    write_text(folder_ / "box.obj",
               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    const fs::path ilan = write_issued(authority(), CertifiedRole::Submitter, 1h, "ilan");
    const fs::path uri = write_issued(authority(), CertifiedRole::Submitter, 1h, "uri");
    const std::string box = (folder_ / "box.obj").string();
    const auto submit = [&] {
        const Ran ran =
            cdctl({"submit", "--a", box, "--b", box, "--random", "10", "--seed", "1", "-o", "name"},
                  ilan);
        EXPECT_EQ(ran.exit_code, 0) << ran.errors;
        return ran.output.substr(0, ran.output.find_first_of(" \n"));
    };
    const std::string first = submit();
    EXPECT_THAT(cdctl({"get", "jobs"}, uri).output, HasSubstr("ilan"));
    for (const auto& words : std::vector<std::vector<std::string>>{
             {"rm", first, "--cancel", "--yes"}, {"cancel", first}}) {
        const Ran refused = cdctl(words, uri);
        EXPECT_EQ(refused.exit_code, 5);
        EXPECT_THAT(refused.errors, HasSubstr("belongs to 'ilan'"));
    }
    EXPECT_EQ(cdctl({"rm", "last", "--yes"}, uri).exit_code, 2) << "uri has none";
    EXPECT_EQ(cdctl({"rm", first, "--cancel", "--yes"}, ilan).exit_code, 0);
    EXPECT_EQ(cdctl({"rm", submit(), "--cancel", "--yes"}, admin()).exit_code, 0);
    EXPECT_EQ(cdctl({"drain", "--all"}, ilan).exit_code, 5);
    EXPECT_EQ(cdctl({"drain", "--all"}, admin()).exit_code, 0);
}

TEST_F(SecuredCluster, AClientJoinsAndDoesWhatItsRoleMay) {
    const fs::path credential = folder_ / "me.pem";
    const Ran joined = tests::run({program("cdctl").string(),
                                   "join",
                                   master_->address(),
                                   "--token",
                                   token("submitter", "1"),
                                   "--credential",
                                   credential.string()});
    ASSERT_EQ(joined.exit_code, 0) << joined.errors;
    EXPECT_THAT(joined.output, HasSubstr("as submitter"));
    EXPECT_EQ(cdctl({"status"}, credential).exit_code, 0);
    const Ran token_asked = cdctl({"token", "create"}, credential);
    EXPECT_EQ(token_asked.exit_code, 5);
    EXPECT_THAT(token_asked.errors, HasSubstr("does not allow 'token create'"));
    EXPECT_THAT(log(), HasSubstr("does not allow 'token create'"));
}

class ShortLived : public SecuredCluster {
  protected:
    void prepare() override {
        ::setenv("CDMASTER_CERTIFICATE_TTL", "4s", 1);
        SecuredCluster::prepare();
    }
    void TearDown() override {
        ::unsetenv("CDMASTER_CERTIFICATE_TTL");
        SecuredCluster::TearDown();
    }
};

TEST_F(ShortLived, AWorkerRenewsItsCertificateByItself) {
    start_joined(token("worker", "1"), "one");
    const Result<Endpoint> master = parse_endpoint(master_->address());
    const fs::path path = credential_path(folder_ / "one", master.value());
    const std::string first = read_text(path);
    EXPECT_TRUE(comes_true([&] { return read_text(path) != first; }));
    EXPECT_TRUE(read_credential(path));
    // Everything continues after the first certificate expires.
    const auto end =
        read_identity(first.substr(first.find("-----BEGIN CERTIFICATE"))).value().until;
    EXPECT_TRUE(comes_true([&] { return std::chrono::system_clock::now() > end; }));
    const Job job = make_job(50);
    const JobStatus status = run(job, Query{});
    EXPECT_EQ(status.digest, job.digest_in_one_process(Query{}));
    EXPECT_THAT(workers_.front()->errors(), HasSubstr("certificate renewed"));
    // The first certificate's session ends with it and resumes with the next certificate.
    EXPECT_TRUE(comes_true([&] { return log().find("session ended") != std::string::npos; }));
    EXPECT_TRUE(comes_true([&] { return log().find("worker came back") != std::string::npos; }));
    EXPECT_THAT(log(), HasSubstr("has expired"));
}

TEST_F(ShortLived, AWaitThatIsLongerThanTheCredentialLivesRenewsIt) {
    const std::string me = (folder_ / "me.pem").string();
    ASSERT_EQ(tests::run({program("cdctl").string(),
                          "join",
                          master_->address(),
                          "--token",
                          token("submitter", "1"),
                          "--credential",
                          me})
                  .exit_code,
              0);
    const auto end_of = [](const std::string& credential) {
        return read_identity(credential.substr(credential.find("-----BEGIN CERTIFICATE")))
            .value()
            .until;
    };
    const auto first = end_of(read_text(me));
    const Job job = make_job(50);
    const JobId id = submit(job, Query{}, many_blocks());
    Process wait({program("cdctl").string(),
                  "wait",
                  job_id_text(id),
                  "--master",
                  master_->address(),
                  "--credential",
                  me},
                 folder_ / "wait");
    // Waits past the expiry of the first and the next certificate.
    EXPECT_TRUE(comes_true(
        [&] { return std::chrono::system_clock::now() > first + 4s || !wait.is_running(); }));
    EXPECT_TRUE(wait.is_running()) << wait.errors();
    EXPECT_GT(end_of(read_text(me)), first);
    start_joined(token("worker", "1"), "one");
    EXPECT_EQ(wait.wait(), 0) << wait.errors();
}

TEST_F(SecuredCluster, ItsStateIsForItsUserAlone) {
    EXPECT_EQ(fs::status(state()).permissions(), fs::perms::owner_all);
}

TEST_F(SecuredCluster, ATokenIsNotSpentOnACredentialThatCannotBeWritten) {
    const std::string once = token("submitter", "1");
    const auto join_to = [&](const std::string& path) {
        return tests::run({program("cdctl").string(),
                           "join",
                           master_->address(),
                           "--token",
                           once,
                           "--credential",
                           path});
    };
    EXPECT_NE(join_to((folder_ / "master.log").string() + "/me.pem").exit_code, 0);
    EXPECT_EQ(join_to((folder_ / "me.pem").string()).exit_code, 0);
}

TEST_F(SecuredCluster, NobodyJoinsAsTheMaster) {
    const Ran ran = join_worker(token("worker", "1"), folder_ / "one", {"--name", "master"});
    EXPECT_EQ(ran.exit_code, 5) << ran.errors;
    EXPECT_THAT(log(), HasSubstr("nobody joins under the name 'master'"));
}

TEST_F(SecuredCluster, NobodyJoinsUnderANameThatPeopleCannotRead) {
    const std::string once = token("worker", "1");
    const auto join_as = [&](const std::string& name) {
        return join_worker(once, folder_ / "one", {"--name", name});
    };
    for (const char* name : {"\xff", "a\nb", "evil ", " evil"}) {
        const Ran ran = join_as(name);
        EXPECT_EQ(ran.exit_code, 2) << ran.errors;
        EXPECT_THAT(ran.errors, HasSubstr("name")) << name;
    }
    EXPECT_EQ(join_as("\xc3\x84 friend").exit_code, 0) << "and the token was not spent";
}

// ---- Refused peers -----------------------------------------------------------------------

TEST_F(SecuredCluster, PlaintextIsRefused) {
    const Ran ran = cdctl({"status"}, "none");
    EXPECT_EQ(ran.exit_code, 5);
    EXPECT_THAT(ran.errors, HasSubstr("the master speaks TLS: cdctl join"));
    // The master logs it when the peer is gone; the peer has read the reason.
    EXPECT_TRUE(
        comes_true([&] { return log().find("plaintext at a port of TLS") != std::string::npos; }));
    Process& worker = start_worker();
    EXPECT_EQ(worker.wait(), 5);
}

TEST_F(SecuredCluster, AnotherAuthoritysCertificateIsRefused) {
    const auto other = CertificateAuthority::make(std::chrono::system_clock::now());
    const fs::path stranger = write_issued(other, CertifiedRole::Admin);
    const Ran ran = cdctl({"status"}, stranger);
    EXPECT_EQ(ran.exit_code, 5);
    EXPECT_THAT(ran.errors, HasSubstr("certificate"));
    EXPECT_THAT(log(), HasSubstr("connection refused"));
    // Trusts the cluster's authority, but shows a certificate signed by another.
    Credential mixed = read_credential(stranger).value();
    mixed.authority = authority().certificate();
    ASSERT_TRUE(write_credential(stranger, mixed));
    const Ran spy = cdctl({"status"}, stranger);
    EXPECT_EQ(spy.exit_code, 5);
    EXPECT_THAT(spy.errors, HasSubstr("unknown CA"));
    EXPECT_THAT(log(), HasSubstr("certificate is not good"));
}

TEST_F(SecuredCluster, AnExpiredCertificateIsRefused) {
    const Ran ran = cdctl({"status"}, write_issued(authority(), CertifiedRole::Admin, -1h));
    EXPECT_EQ(ran.exit_code, 5);
    EXPECT_THAT(ran.errors, HasSubstr("certificate expired"));
    EXPECT_THAT(log(), HasSubstr("certificate has expired"));
}

TEST_F(SecuredCluster, AnotherRoleIsRefused) {
    const fs::path worker = write_issued(authority(), CertifiedRole::Worker);
    const Ran as_client = cdctl({"status"}, worker);
    EXPECT_EQ(as_client.exit_code, 5);
    EXPECT_THAT(log(), HasSubstr("the certificate of a worker is not that of a client"));

    const fs::path metrics = write_issued(authority(), CertifiedRole::Metrics);
    EXPECT_EQ(cdctl({"status"}, metrics).exit_code, 0);
    const std::string box = folder_ / "box.obj";
    write_obj(box, make_box({1, 1, 1}));
    const Ran submits = cdctl({"run", "--a", box, "--b", box, "--random", "2"}, metrics);
    EXPECT_EQ(submits.exit_code, 5) << submits.errors;
    EXPECT_THAT(log(), HasSubstr("the certificate of a metrics does not allow 'meshes query'"));

    const Result<Endpoint> master = parse_endpoint(master_->address());
    const fs::path place = folder_ / "wrong";
    ASSERT_TRUE(write_credential(
        credential_path(place, master.value()),
        read_credential(write_issued(authority(), CertifiedRole::Submitter)).value()));
    Process& as_worker = start_worker(1, {"--state", place.string()});
    EXPECT_EQ(as_worker.wait(), 5);
    EXPECT_THAT(log(), HasSubstr("the certificate of a submitter is not that of a worker"));
}

TEST_F(SecuredCluster, ARefusedHolderIsDisconnectedAndNotAdmittedAgain) {
    const fs::path client = write_issued(authority(), CertifiedRole::Submitter);
    const auto open = Connection::open(
        master_->address(),
        false,
        [] { return false; },
        Tls::make(read_credential(client).value()).value());
    ASSERT_TRUE(open && open.value()->status());
    const fs::path place = folder_ / "worker";
    ASSERT_TRUE(write_credential(
        credential_path(place, parse_endpoint(master_->address()).value()),
        read_credential(write_issued(authority(), CertifiedRole::Worker)).value()));
    Process& worker = start_worker(1, {"--state", place.string()});
    EXPECT_TRUE(comes_true([&] { return log().find("holder=\"someone\"") != std::string::npos; }));

    write_text(state() / "refused", "someone\n");
    EXPECT_FALSE(open.value()->status());
    const Ran again = cdctl({"status"}, client);
    EXPECT_EQ(again.exit_code, 5);
    EXPECT_THAT(again.errors, HasSubstr("refused by this cluster"));
    EXPECT_EQ(worker.wait(), 5);
    EXPECT_THAT(log(), HasSubstr("session ended"));
    EXPECT_TRUE(connection_->status()) << "others go on";
}

TEST_F(SecuredCluster, AnExhaustedOrWrongTokenIsRefused) {
    const std::string once = token("worker", "1");
    EXPECT_EQ(join_worker(once, folder_ / "one").exit_code, 0);
    EXPECT_EQ(join_worker(once, folder_ / "two").exit_code, 5);
    EXPECT_THAT(log(), HasSubstr("the token is exhausted"));
    JoinToken wrong = parse_join_token(once).value();
    wrong.secret = random_secret();
    EXPECT_EQ(join_worker(to_text(wrong), folder_ / "two").exit_code, 5);
    EXPECT_THAT(log(), HasSubstr("not proven"));
    // The pin is another master's, so this master never learns the token.
    JoinToken elsewhere = parse_join_token(token("worker", "1")).value();
    elsewhere.authority = random_secret();
    EXPECT_EQ(join_worker(to_text(elsewhere), folder_ / "two").exit_code, 5);
    EXPECT_TRUE(fs::is_empty(folder_ / "two"));
    EXPECT_EQ(join_worker("no token", folder_ / "two").exit_code, 2);
}

// ---- Conversations none of our programs hold -----------------------------------------------

/// Holds a conversation with the master that ends with an error.
Error refusal(const std::function<asio::awaitable<Error>()>& conversation) {
    asio::io_context context(1);
    Error result{ErrorCode::Incomplete, "it did not end"};
    asio::co_spawn(context, conversation(), [&](const std::exception_ptr& thrown, Error error) {
        if (thrown) {
            std::rethrow_exception(thrown);
        }
        result = std::move(error);
    });
    context.run_for(patience);
    return result;
}

asio::awaitable<Error> greet_as(Target target, Role role) {
    const auto channel = co_await connect(std::move(target));
    if (!channel) {
        co_return channel.error();
    }
    Hello hello;
    hello.role = role;
    const Result<Welcome> welcome = co_await greet(channel.value(), hello);
    co_return welcome ? Error{ErrorCode::Incomplete, "welcome"} : welcome.error();
}

TEST_F(SecuredCluster, WithoutACertificateNobodyIsWelcome) {
    const Endpoint master = parse_endpoint(master_->address()).value();
    const auto nobody = Tls::make_joining(authority().fingerprint());
    for (const Role role : {Role::Client, Role::Worker}) {
        const Error error = refusal([&] { return greet_as({master, nobody}, role); });
        EXPECT_EQ(error.code, ErrorCode::Refused);
        EXPECT_THAT(error.detail, HasSubstr("no certificate was shown"));
    }
    EXPECT_THAT(log(), HasSubstr("no certificate was shown"));
}

/// Joins as the token allows, and records its message in `said` for a replay.
asio::awaitable<Error> say_join(Endpoint master, JoinToken token, std::optional<Join>& said) {
    Target target{std::move(master), Tls::make_joining(token.authority)};
    const auto channel = co_await connect(std::move(target));
    Hello hello;
    hello.role = Role::Joiner;
    const Result<Welcome> welcome = co_await greet(channel.value(), hello);
    EXPECT_TRUE(welcome);
    if (!said) {
        Join join;
        join.token = token.id;
        join.name = "recorded";
        join.request = make_certificate_request().request;
        join.proof = join_proof(token, channel.value()->binding().value(), join.request);
        said = std::move(join);
    }
    channel.value()->send(*said);
    const Result<Message> answer = co_await channel.value()->receive(patience);
    EXPECT_TRUE(answer);
    const auto* const failure = std::get_if<Failure>(&answer.value());
    co_return failure == nullptr ? Error{ErrorCode::Incomplete, "certified"}
                                 : Error{failure->code, failure->detail};
}

TEST_F(SecuredCluster, AReplayedJoinIsRefused) {
    const Endpoint master = parse_endpoint(master_->address()).value();
    const JoinToken many = parse_join_token(token("worker", "5")).value();
    std::optional<Join> said;
    EXPECT_EQ(refusal([&] { return say_join(master, many, said); }).detail, "certified");
    const Error replayed = refusal([&] { return say_join(master, many, said); });
    EXPECT_EQ(replayed.code, ErrorCode::Refused);
    EXPECT_THAT(replayed.detail, HasSubstr("replayed"));
    EXPECT_THAT(log(), HasSubstr("replayed"));
}

TEST_F(SecuredCluster, TlsOnePointTwoIsRefused) {
    const Endpoint master = parse_endpoint(master_->address()).value();
    asio::io_context context(1);
    asio::ssl::context old(asio::ssl::context::tlsv12_client);
    asio::ssl::stream<asio::ip::tcp::socket> stream(context, old);
    stream.lowest_layer().connect({asio::ip::make_address(master.host), master.port});
    boost::system::error_code error;
    stream.handshake(asio::ssl::stream_base::client, error);
    EXPECT_THAT(error.message(), HasSubstr("protocol version"));
    stream.lowest_layer().close();
    EXPECT_TRUE(
        comes_true([&] { return log().find("unsupported protocol") != std::string::npos; }));
}

TEST_F(Cluster, TlsAtAPlainPortEndsWithAClearError) {
    const WallTime now = std::chrono::system_clock::now();
    const auto authority = CertificateAuthority::make(now);
    const fs::path credential = folder_ / "c.pem";
    ASSERT_TRUE(write_credential(
        credential, authority.issue({CertifiedRole::Admin, "me", now - 1h, now + 1h})));
    const Ran ran = tests::run({program("cdctl").string(),
                                "status",
                                "--master",
                                master_->address(),
                                "--credential",
                                credential.string()});
    EXPECT_EQ(ran.exit_code, 5);
    EXPECT_THAT(ran.errors, HasSubstr("speaks no TLS"));
    EXPECT_TRUE(comes_true([&] {
        return read_text(folder_ / "master.log").find("TLS at a port that does not speak it") !=
               std::string::npos;
    }));
}

TEST_F(Cluster, BeyondLoopbackThereIsNoStartWithoutAnIdentity) {
    const std::vector<std::string> command{program("cdmaster").string(),
                                           "--listen",
                                           "0.0.0.0:0",
                                           "--port-file",
                                           (folder_ / "port").string(),
                                           "--state",
                                           (folder_ / "other").string()};
    const Ran refused = tests::run(command);
    EXPECT_EQ(refused.exit_code, 5);
    EXPECT_THAT(refused.errors, HasSubstr("cdmaster init"));
    ASSERT_EQ(
        tests::run({program("cdmaster").string(), "init", "--state", (folder_ / "other").string()})
            .exit_code,
        0);
    fs::remove(folder_ / "port");
    Process master(command, folder_ / "beyond");
    EXPECT_TRUE(comes_true([&] { return fs::exists(folder_ / "port"); }));
    EXPECT_TRUE(master.is_running());
}

} // namespace
} // namespace cd::tests
