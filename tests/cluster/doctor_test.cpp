// Proves that `cdctl doctor` finds faults of real clusters.
#include "common/core/version.hpp"
#include "proto/channel/channel.hpp"
#include "tests/cluster/cdctl_runs.hpp"
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/support/comes_true.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <cstdlib>

namespace cd::tests {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// Opens a connection on which a worker has greeted the master. The connection lasts as long as the
/// object.
class GreetedWorker {
  public:
    GreetedWorker(const std::string& master, const Hello& hello) {
        spawn(
            context_.get_executor(), "worker", greet_master(parse_endpoint(master).value(), hello));
        context_.run();
        EXPECT_NE(channel_, nullptr);
    }

  private:
    asio::awaitable<void> greet_master(Endpoint master, Hello hello) {
        auto channel = co_await connect({master, nullptr, CertifiedRole::Master});
        if (!channel) {
            co_return;
        }
        const Result<Welcome> welcome = co_await greet(channel.value(), hello);
        EXPECT_TRUE(welcome);
        channel_ = channel.value();
        context_.stop(); // The channel reads ahead forever.
    }

    asio::io_context context_{1};
    std::shared_ptr<Channel> channel_;
};

class DoctorOfACluster : public Cluster {
  protected:
    void prepare() override { ::setenv("CDMASTER_HTTP", "127.0.0.1:0", 1); }
    void TearDown() override {
        ::unsetenv("CDMASTER_HTTP");
        Cluster::TearDown();
    }

    [[nodiscard]] std::string http() const {
        std::smatch found;
        const std::string log = read_text(folder_ / "master.log");
        EXPECT_TRUE(std::regex_search(log, found, std::regex("http listening: .*port=([0-9]+)")));
        return "127.0.0.1:" + found[1].str();
    }
    [[nodiscard]] Ran doctor(const std::vector<std::string>& options) const {
        std::vector<std::string> words{cdctl(), "doctor"};
        words.insert(words.end(), options.begin(), options.end());
        return cd::tests::run(words);
    }
    [[nodiscard]] Ran doctor() const {
        return doctor({"--master", master_->address(), "--http", http()});
    }
    /// Asks the doctor until it says this, or for long.
    [[nodiscard]] Ran doctor_until(const std::string& text) const {
        Ran ran = doctor();
        (void)comes_true([&] {
            ran = doctor();
            return ran.output.find(text) != std::string::npos;
        });
        return ran;
    }
};

TEST_F(DoctorOfACluster, ASoundClusterHasNoFault) {
    start_worker();
    const Ran ran = doctor_until("1 worker, version");
    EXPECT_EQ(ran.exit_code, 0) << ran.output << ran.errors;
    EXPECT_THAT(ran.output, ContainsRegex("^ok    this machine     [a-z0-9]+, [0-9]+ threads?, "));
    EXPECT_THAT(ran.output, HasSubstr("\nok    tree cache       off: each run builds its trees\n"));
    EXPECT_THAT(ran.output, HasSubstr("\nok    credential       none"));
    EXPECT_THAT(ran.output,
                ContainsRegex("\nok    master           127[0-9.:]+, version " +
                              std::string(version) +
                              " as here, no TLS, you are `[^`]+`, clock [-+]0\\.[0-9] s\n"));
    EXPECT_THAT(ran.output,
                HasSubstr("\nok    workers          1 worker, version " + std::string(version) +
                          ", each can be reached by the others\n"));
    EXPECT_THAT(ran.output,
                ContainsRegex("\n(ok  |warn)  disk             master has .* of .*\n$"));
    EXPECT_EQ(ran.errors, "");
}

TEST_F(DoctorOfACluster, AWorkerOfAnotherVersionBehindAFirewallIsFound) {
    start_worker();
    Hello hello;
    hello.role = Role::Worker;
    hello.name = "old";
    hello.build = "0.0.7";
    hello.threads = 1;
    hello.peer_port = 1; // Nobody listens there.
    const GreetedWorker old(master_->address(), hello);
    const Ran ran = doctor_until("cannot reach");
    EXPECT_EQ(ran.exit_code, 1) << ran.output;
    EXPECT_THAT(
        ran.output,
        ContainsRegex("\nFAIL  workers          w-[0-9]+ old: version 0\\.0\\.7, the master " +
                      std::string(version) + ": upgrade it\n"));
    EXPECT_THAT(ran.output,
                ContainsRegex("\nwarn  workers          w-[0-9]+ old: others cannot reach its "
                              "port 1 \\(firewall\\?\\), so the master serves\n"));
}

TEST_F(DoctorOfACluster, WithoutTheHttpPortTheRestIsTold) {
    const Ran ran = doctor({"--master", master_->address(), "--http", "none", "-o", "json"});
    EXPECT_EQ(ran.exit_code, 0) << ran.output << ran.errors;
    const auto json = nlohmann::json::parse(ran.output);
    EXPECT_EQ(json[4]["topic"], "workers");
    EXPECT_EQ(json[4]["grade"], "warn");
    EXPECT_THAT(json[4]["text"].get<std::string>(), HasSubstr("none is here: start cdworker"));
    start_worker();
    EXPECT_TRUE(comes_true([&] {
        return doctor({"--master", master_->address(), "--http", "none"})
                   .output.find("1 worker; their versions and ports are unknown: --http none") !=
               std::string::npos;
    }));
    const Ran wrong = doctor({"--master", master_->address(), "--http", "127.0.0.1:1"});
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_THAT(wrong.output,
                HasSubstr("\nFAIL  master's HTTP    --http 127.0.0.1:1: cannot connect to"));
}

TEST_F(DoctorOfACluster, AMasterThatDoesNotAnswerIsAFault) {
    const Ran nobody = doctor({"--master", "127.0.0.1:1"});
    EXPECT_EQ(nobody.exit_code, 1);
    EXPECT_THAT(nobody.output, HasSubstr("\nFAIL  master           cannot connect to 127.0.0.1:1"));
    EXPECT_THAT(nobody.output, Not(HasSubstr("workers")));
    const Ran http_port = doctor({"--master", http()});
    EXPECT_EQ(http_port.exit_code, 1);
    EXPECT_THAT(http_port.output, ContainsRegex("\nFAIL  master           .*--http port"));
    const Ran address = doctor({"--master", "nowhere"});
    EXPECT_EQ(address.exit_code, 2) << "wrong usage, not a fault of a cluster";
}

TEST_F(DoctorOfACluster, OwnFaultsAreFound) {
    write_text(folder_ / "me.pem", "no credential\n");
    std::filesystem::permissions(folder_ / "me.pem", std::filesystem::perms::owner_all);
    const Ran ran = doctor({"--master",
                            master_->address(),
                            "--credential",
                            (folder_ / "me.pem").string(),
                            "--tree-cache",
                            (folder_ / "me.pem" / "trees").string()});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_THAT(ran.output, ContainsRegex("\nFAIL  credential       .*me\\.pem"));
    EXPECT_THAT(ran.output, ContainsRegex("\nwarn  tree cache       .*is no folder"));
    const Ran simd = cd::tests::run({"/usr/bin/env",
                                     "CD_SIMD=mmx",
                                     cdctl(),
                                     "doctor",
                                     "--master",
                                     master_->address(),
                                     "--http",
                                     "none"});
    EXPECT_EQ(simd.exit_code, 1);
    EXPECT_THAT(simd.output, ContainsRegex("^FAIL  this machine     .*mmx"));
}

TEST_F(DoctorOfACluster, AWrongClockIsFound) {
    const auto doctor_ahead_by = [this](const std::string& seconds) {
        return cd::tests::run({"/usr/bin/env",
                               "LD_PRELOAD=" CD_SHIFTED_CLOCK,
                               "ASAN_OPTIONS=verify_asan_link_order=0",
                               "CD_CLOCK_SHIFT=" + seconds,
                               cdctl(),
                               "doctor",
                               "--master",
                               master_->address(),
                               "--http",
                               http()});
    };
    const Ran minute = doctor_ahead_by("60");
    EXPECT_EQ(minute.exit_code, 0) << minute.output << minute.errors;
    EXPECT_THAT(
        minute.output,
        ContainsRegex("\nwarn  master           .*, clock -(59|60)\\.[0-9] s: set the clocks"));
    const Ran hours = doctor_ahead_by("-7200");
    EXPECT_EQ(hours.exit_code, 1);
    EXPECT_THAT(
        hours.output,
        ContainsRegex("\nFAIL  master           .*, clock \\+7200\\.[0-9] s: set the clocks"));
}

TEST(Doctor, AFullDiskIsFound) {
    std::vector<std::string> mount{"/usr/bin/unshare", "--mount"};
    if (::geteuid() != 0) {
        mount.insert(mount.end(), {"--user", "--map-root-user"});
    }
    const auto with = [&](const std::vector<std::string>& words) {
        std::vector<std::string> command = mount;
        command.insert(command.end(), words.begin(), words.end());
        return command;
    };
    if (cd::tests::run(with({"/bin/true"})).exit_code != 0) {
        GTEST_SKIP() << "this user may not mount";
    }
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "state");
    const Process master(with({"/bin/sh",
                               "-c",
                               "mount -t tmpfs -o size=64m cdcluster \"$0\" && exec \"$@\"",
                               folder / "state",
                               program("cdmaster").string(),
                               "--listen",
                               "127.0.0.1:0",
                               "--port-file",
                               folder / "port",
                               "--state",
                               folder / "state"}),
                         folder / "master");
    ASSERT_TRUE(comes_true([&] { return std::filesystem::exists(folder / "port"); }))
        << master.errors();
    const std::string port = read_text(folder / "port");
    const Ran ran = cd::tests::run({program("cdctl").string(),
                                    "doctor",
                                    "--master",
                                    "127.0.0.1:" + port.substr(0, port.find('\n')),
                                    "--http",
                                    "none"});
    EXPECT_EQ(ran.exit_code, 1) << ran.output << ran.errors;
    EXPECT_THAT(
        ran.output,
        ContainsRegex(
            "\nFAIL  disk             master has 6[0-9]\\.[0-9] MiB for its state; `cdctl rm`"));
}

} // namespace
} // namespace cd::tests
