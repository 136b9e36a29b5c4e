// Proves that the command line overrides the environment, which overrides the file, and that
// invalid settings give a message and exit code 2.
#include "master/config.hpp"

#include "common/core/limits/master.hpp"
#include "tests/support/process.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace cd::tests {
namespace {

MasterCommandLine parse(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "cdmaster");
    return parse_master_command_line(static_cast<int>(arguments.size()), arguments.data());
}

TEST(MasterConfig, HasDefaultsOnLoopback) {
    const auto line = parse({});
    ASSERT_TRUE(line.config);
    EXPECT_EQ(line.config->listen.host, "127.0.0.1");
    EXPECT_EQ(line.config->listen.port, 7600);
    EXPECT_FALSE(line.config->insecure);
    EXPECT_FALSE(line.config->state.empty());
}

TEST(MasterConfig, TheCommandLineGoesBeforeTheEnvironmentBeforeTheFile) {
    const TemporaryFolder folder;
    const std::string file = (folder / "master.toml").string();
    write_text(file,
               "listen = \"127.0.0.1:1\"\nthreads = 1\nstate = \"from-file\"\ninsecure = true\n");
    setenv("CDMASTER_THREADS", "2", 1);
    setenv("CDMASTER_LISTEN", "127.0.0.1:2", 1);
    const auto line = parse({"--config", file.c_str(), "--listen", "127.0.0.1:3"});
    unsetenv("CDMASTER_THREADS");
    unsetenv("CDMASTER_LISTEN");
    ASSERT_TRUE(line.config) << line.text;
    EXPECT_EQ(line.config->listen.port, 3);
    EXPECT_EQ(line.config->threads, 2u);
    EXPECT_EQ(line.config->state, "from-file");
    EXPECT_TRUE(line.config->insecure);
}

TEST(MasterConfig, WhatIsWrongIsNamed) {
    const TemporaryFolder folder;
    const std::string file = (folder / "master.toml").string();
    const auto expect_error = [](const MasterCommandLine& line, const std::string& words) {
        EXPECT_FALSE(line.config);
        EXPECT_EQ(line.exit_code, 2);
        EXPECT_NE(line.text.find(words), std::string::npos) << line.text;
    };
    expect_error(parse({"--listen", "nowhere"}), "--listen");
    expect_error(parse({"--log-level", "loud"}), "log-level");
    expect_error(parse({"--log-format", "xml"}), "log-format");
    expect_error(parse({"--threads", "many"}), "threads");
    expect_error(parse({"--no-such-option"}), "no-such-option");
    expect_error(parse({"--config", "/no/such/file.toml"}), "file.toml");
    write_text(file, "lisen = \"127.0.0.1:1\"\n");
    expect_error(parse({"--config", file.c_str()}),
                 "line 1: there is no option 'lisen'; did you mean 'listen'?");
    write_text(file, "threads = 1\n\nqwertyuiop = 2\n");
    expect_error(parse({"--config", file.c_str()}), "line 3: there is no option 'qwertyuiop'\n");
    write_text(file, "listen = \n");
    expect_error(parse({"--config", file.c_str()}), "line 1");
    write_text(file, "[table]\nlisten = 1\n");
    expect_error(parse({"--config", file.c_str()}), "table");
}

TEST(MasterConfig, HelpOpensWithExamplesAndIsNoError) {
    const auto line = parse({"--help"});
    EXPECT_FALSE(line.config);
    EXPECT_EQ(line.exit_code, 0);
    EXPECT_EQ(line.text.find("Examples:"), 0u) << line.text;
    EXPECT_EQ(parse({"--version"}).text.find("cdmaster "), 0u);
}

TEST(MasterConfig, TheJoinLineIsWhatAWorkerTypes) {
    EXPECT_EQ(join_line({"127.0.0.1", 7600}), "cdworker --master 127.0.0.1:7600");
    EXPECT_EQ(join_line({"::1", 1}), "cdworker --master [::1]:1");
    EXPECT_EQ(join_line({"10.0.0.1", 1}), "cdworker --master 10.0.0.1:1 --insecure");
    EXPECT_EQ(join_line({"10.0.0.1", 1}, true),
              "cdworker join 10.0.0.1:1 --token TOKEN && cdworker --master 10.0.0.1:1");
}

TEST(MasterConfig, InitTakesTheStateBeforeOrAfterIt) {
    EXPECT_FALSE(parse({}).config->init);
    for (const auto& line : {parse({"init", "--state", "s"}), parse({"--state", "s", "init"})}) {
        ASSERT_TRUE(line.config) << line.text;
        EXPECT_TRUE(line.config->init);
        EXPECT_EQ(line.config->state, "s");
    }
}

TEST(MasterConfig, TimesOfFailuresAreInSecondsAndGoTogether) {
    using namespace std::chrono_literals;
    const FailureTimes usual = parse({}).config->times;
    EXPECT_EQ(usual.heartbeat, 2s);
    EXPECT_EQ(usual.silent_after(), 6s);
    EXPECT_EQ(usual.lost_after, 15s);
    EXPECT_EQ(usual.return_within, 15s);
    EXPECT_EQ(usual.forgotten_after, 10min);
    const auto line = parse({"--heartbeat", "0.05", "--lost-after", "0.3", "--return-within", "0"});
    ASSERT_TRUE(line.config) << line.text;
    EXPECT_EQ(line.config->times.heartbeat, 50ms);
    EXPECT_EQ(line.config->times.lost_after, 300ms);
    EXPECT_EQ(line.config->times.return_within, 0ms);
    const TemporaryFolder folder;
    const std::string file = (folder / "master.toml").string();
    write_text(file, "heartbeat = 0.05\nlost-after = 0.3\n");
    const auto from_file = parse({"--config", file.c_str()});
    ASSERT_TRUE(from_file.config) << from_file.text;
    EXPECT_EQ(from_file.config->times.heartbeat, 50ms);
    EXPECT_EQ(from_file.config->times.lost_after, 300ms);
    EXPECT_EQ(parse({"--lost-after", "5.9"}).exit_code, 2);
    EXPECT_EQ(parse({"--heartbeat", "0.001"}).exit_code, 2);
    EXPECT_EQ(parse({"--heartbeat", "-1"}).exit_code, 2);
    EXPECT_EQ(parse({"--return-within", "100000"}).exit_code, 2);
    EXPECT_EQ(parse({"--return-within", "nan"}).exit_code, 2);
}

TEST(MasterConfig, JobsAreKeptByNumberOrByTime) {
    EXPECT_EQ(parse({}).config->retention.count, limits::jobs_ended_kept_max);
    EXPECT_FALSE(parse({}).config->retention.age);
    EXPECT_EQ(parse({"--keep-jobs", "7"}).config->retention.count, 7u);
    EXPECT_EQ(parse({"--keep-jobs", "30d"}).config->retention.age, std::chrono::hours(24 * 30));
    for (const char* wrong : {"soon", "0", "-1", "1.5"}) {
        const auto line = parse({"--keep-jobs", wrong});
        EXPECT_EQ(line.exit_code, 2) << wrong;
        EXPECT_EQ(line.text.find("cdmaster: --keep-jobs: "), 0u) << line.text;
    }
}

TEST(MasterConfig, CertificatesLiveAsLongAsItSays) {
    EXPECT_EQ(parse({}).config->certificate_life, std::chrono::hours(24 * 7));
    EXPECT_EQ(parse({"--certificate-ttl", "36h"}).config->certificate_life, std::chrono::hours(36));
    EXPECT_EQ(parse({"--certificate-ttl", "1s"}).exit_code, 2);
    EXPECT_EQ(parse({"--certificate-ttl", "soon"}).exit_code, 2);
}

} // namespace
} // namespace cd::tests
