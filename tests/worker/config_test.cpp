// Proves that a worker's command line overrides the environment, which overrides the file, and that
// invalid options give a one-line message and exit code 2.
#include "worker/config.hpp"

#include "common/core/host/memory_limit.hpp"
#include "tests/support/process.hpp"
#include "worker/run_worker.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

namespace cd::tests {
namespace {

using testing::HasSubstr;

WorkerCommandLine parse(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "cdworker");
    return parse_worker_command_line(static_cast<int>(arguments.size()), arguments.data());
}

/// An environment variable, set during a test.
class Environment {
  public:
    Environment(const char* name, const char* value) : name_(name) { ::setenv(name, value, 1); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;
    ~Environment() { ::unsetenv(name_); }

  private:
    const char* name_;
};

/// Writes a file; returns its path.
std::string file_with(const TemporaryFolder& folder, const char* name, const std::string& text) {
    write_text(folder / name, text);
    return (folder / name).string();
}

TEST(WorkerConfig, DefaultsAreForAMasterOnThisMachine) {
    const WorkerCommandLine line = parse({});
    ASSERT_TRUE(line.config) << line.text;
    EXPECT_EQ(line.config->master.host, "127.0.0.1");
    EXPECT_EQ(line.config->master.port, 7600);
    EXPECT_EQ(line.config->cache_bytes, memory_limit() / 2);
    EXPECT_EQ(line.config->threads, 0u);
    EXPECT_FALSE(line.config->insecure);
    EXPECT_FALSE(line.config->name.empty());
    EXPECT_EQ(line.config->times.drain_timeout, std::chrono::seconds(25));
    EXPECT_FALSE(line.config->times.leave.idle);
    EXPECT_FALSE(line.config->times.leave.orphaned);
}

TEST(WorkerConfig, WhenToLeaveIsAnOptionOrAKeyOfTheFile) {
    const TemporaryFolder folder;
    const std::string file = file_with(folder, "w.toml", "idle-exit = 60\norphan-exit = 600\n");
    const WorkerCommandLine line = parse({"--config", file.c_str(), "--idle-exit", "5"});
    ASSERT_TRUE(line.config) << line.text;
    EXPECT_EQ(line.config->times.leave.idle, std::chrono::seconds(5));
    EXPECT_EQ(line.config->times.leave.orphaned, std::chrono::seconds(600));
}

TEST(WorkerConfig, OptionsAreRead) {
    const WorkerCommandLine line = parse({"--master",
                                          "node:1",
                                          "--threads",
                                          "3",
                                          "--cache",
                                          "512MiB",
                                          "--weight",
                                          "0.5",
                                          "--name",
                                          "n",
                                          "--simd",
                                          "avx2",
                                          "--insecure",
                                          "--log-level",
                                          "debug",
                                          "--connect-for",
                                          "7",
                                          "--drain-timeout",
                                          "9"});
    ASSERT_TRUE(line.config) << line.text;
    EXPECT_EQ(line.config->master.host, "node");
    EXPECT_EQ(line.config->threads, 3u);
    EXPECT_EQ(line.config->cache_bytes, std::uint64_t{512} << 20);
    EXPECT_EQ(line.config->weight, 0.5);
    EXPECT_EQ(line.config->name, "n");
    EXPECT_EQ(line.config->simd, "avx2");
    EXPECT_TRUE(line.config->insecure);
    EXPECT_EQ(line.config->log.level, "debug");
    EXPECT_EQ(line.config->times.connect_for, std::chrono::seconds(7));
    EXPECT_EQ(line.config->times.drain_timeout, std::chrono::seconds(9));
}

TEST(WorkerConfig, TheCommandLineGoesBeforeTheEnvironmentBeforeTheFile) {
    const TemporaryFolder folder;
    const std::string file =
        file_with(folder,
                  "worker.toml",
                  "threads = 1\nname = \"from the file\"\ncache = \"1MiB\"\ninsecure = true\n");
    const Environment name("CDWORKER_NAME", "from the environment");
    const Environment cache("CDWORKER_CACHE", "2MiB");
    const WorkerCommandLine line = parse({"--config", file.c_str(), "--cache", "3MiB"});
    ASSERT_TRUE(line.config) << line.text;
    EXPECT_EQ(line.config->threads, 1u);
    EXPECT_TRUE(line.config->insecure);
    EXPECT_EQ(line.config->name, "from the environment");
    EXPECT_EQ(line.config->cache_bytes, std::uint64_t{3} << 20);
}

TEST(WorkerConfig, WhatIsWrongIsUsage) {
    const TemporaryFolder folder;
    const std::string unknown = file_with(folder, "unknown.toml", "thread = 1\n");
    const std::string broken = file_with(folder, "broken.toml", "threads = \n");
    const std::vector<std::vector<const char*>> wrong{
        {"--master", "nowhere"},
        {"--cache", "much"},
        {"--weight", "0"},
        {"--threads", "-1"},
        {"--threads", "x"},
        {"--log-level", "loud"},
        {"--idle-exit", "0"},
        {"--orphan-exit", "-1"},
        {"--orphan-exit", "soon"},
        {"--frobnicate"},
        {"--name", "a\nb"},
        {"--config", "/no/such/f"},
        {"--config", unknown.c_str()},
        {"--config", broken.c_str()},
    };
    for (const auto& arguments : wrong) {
        const WorkerCommandLine line = parse(arguments);
        EXPECT_FALSE(line.config) << arguments.front();
        EXPECT_EQ(line.exit_code, 2) << arguments.front();
        EXPECT_THAT(line.text, testing::StartsWith("cdworker: ")) << arguments.front();
    }
}

TEST(WorkerConfig, HelpOpensWithExamplesAndTellsTheExitCodes) {
    const WorkerCommandLine help = parse({"--help"});
    EXPECT_FALSE(help.config);
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_THAT(help.text, testing::StartsWith("Examples:"));
    EXPECT_THAT(help.text, HasSubstr("Exit codes: 0"));
    EXPECT_THAT(parse({"--version"}).text, HasSubstr("cdworker 0."));
}

TEST(WorkerConfig, HelpIsUnderstoodByWhoReadsOneLineOfIt) {
    const std::string help = parse({"--help"}).text;
    EXPECT_THAT(help, HasSubstr("Number of threads that compute"));
    EXPECT_THAT(help, HasSubstr("Name of this worker in logs and reports"));
    EXPECT_THAT(help, HasSubstr("Get a certificate from a master"));
    const std::string join = parse({"join", "--help"}).text;
    EXPECT_THAT(join, HasSubstr("Token that `cdctl token create` printed"));
    EXPECT_THAT(join, HasSubstr("File with the token in its first line"));
}

TEST(WorkerConfig, SizesHaveUnits) {
    EXPECT_EQ(parse_size("123").value(), 123u);
    EXPECT_EQ(parse_size("4GiB").value(), std::uint64_t{4} << 30);
    EXPECT_EQ(parse_size("1.5 KiB").value(), 1536u);
    EXPECT_EQ(parse_size("2MB").value(), 2'000'000u);
    for (const char* text :
         {"", "GiB", "-1", "4gib", "4GiBs", "1e30", "nan", "inf", "99999999TiB"}) {
        EXPECT_FALSE(parse_size(text)) << text;
    }
}

TEST(RunWorker, RefusesToLeaveLoopbackUnasked) {
    WorkerConfig config;
    config.master = {"192.0.2.1", 7600};
    EXPECT_EQ(run_worker(config), 5);
}

TEST(RunWorker, GivesUpOnAMasterThatIsNotThere) {
    WorkerConfig config;
    config.master = {"127.0.0.1", 1};
    config.threads = 1;
    config.times.connect_for = std::chrono::seconds(0);
    EXPECT_EQ(run_worker(config), 4);
}

TEST(WorkerConfig, JoinNamesAMasterAndAToken) {
    EXPECT_FALSE(parse({}).config->join);
    JoinToken token;
    token.id = 7;
    token.secret = random_secret();
    const std::string text = to_text(token);
    const auto line = parse({"join", "node-1:7600", "--token", text.c_str(), "--state", "here"});
    ASSERT_TRUE(line.config) << line.text;
    EXPECT_EQ(line.config->join->secret, token.secret);
    EXPECT_EQ(line.config->master.host, "node-1");
    EXPECT_EQ(line.config->state, "here");
    const TemporaryFolder folder;
    const std::string file = file_with(folder, "token", text + "\n");
    const auto from_file = parse({"join", "node-1:7600", "--token-file", file.c_str()});
    ASSERT_TRUE(from_file.config) << from_file.text;
    EXPECT_EQ(from_file.config->join->id, 7u);
    EXPECT_EQ(parse({"join"}).exit_code, 2);
    EXPECT_EQ(parse({"join", "node-1:7600"}).exit_code, 2);
    EXPECT_EQ(parse({"join", "node-1:7600", "--token", "x"}).exit_code, 2);
    EXPECT_EQ(parse({"join", "node-1:7600", "--token-file", "/no/file"}).exit_code, 2);
}

} // namespace
} // namespace cd::tests
