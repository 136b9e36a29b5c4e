// Proves that the command line parses to the intended command, and that help and wrong usage end
// with their exit codes.
#include "client/cli/cli.hpp"

#include "client/base/exit_code.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace cd::tests {

using testing::HasSubstr;
using testing::StartsWith;

TEST(CommandLine, HelpStartsWithExamples) {
    const CommandLine line = parse_command_line({"--help"});
    EXPECT_FALSE(line.command);
    EXPECT_EQ(line.exit_code, exit_done);
    EXPECT_THAT(line.text, StartsWith("Examples:\n  cdctl demo"));
    EXPECT_THAT(line.text, HasSubstr("Exit codes: 0 done"));
    for (const char* verb : {"run",
                             "demo",
                             "submit",
                             "watch",
                             "wait",
                             "results",
                             "get",
                             "status",
                             "inspect",
                             "join",
                             "token",
                             "priority",
                             "cancel"}) {
        EXPECT_THAT(line.text, HasSubstr(std::string("\n  ") + verb + " "));
        const CommandLine help = parse_command_line({verb, "-h"});
        EXPECT_EQ(help.exit_code, exit_done);
        EXPECT_THAT(help.text, StartsWith("Examples:\n  ")) << verb;
    }
}

TEST(CommandLine, WhatJoinsAndLetsJoinIsRead) {
    const auto join = parse_command_line({"join", "n:1", "--token", "t", "--credential", "c.pem"});
    ASSERT_TRUE(join.command) << join.text;
    const auto& joining = std::get<JoinCommand>(*join.command);
    EXPECT_EQ(joining.master.address, "n:1");
    EXPECT_EQ(joining.token, "t");
    EXPECT_EQ(joining.master.credential, "c.pem");
    const auto line = parse_command_line(
        {"token", "create", "--role", "submitter", "--uses", "50", "--ttl", "2h"});
    ASSERT_TRUE(line.command) << line.text;
    const auto& token = std::get<TokenCommand>(*line.command);
    EXPECT_EQ(token.role, "submitter");
    EXPECT_EQ(token.uses, 50u);
    EXPECT_EQ(token.ttl, "2h");
}

TEST(CommandLine, ACheckOfAJobIsRead) {
    const auto line = parse_command_line({"job", "check", "scene.toml", "-o", "csv", "-q"});
    ASSERT_TRUE(line.command) << line.text;
    const auto& check = std::get<CheckCommand>(*line.command);
    EXPECT_EQ(check.file, "scene.toml");
    EXPECT_EQ(check.output, "csv");
    EXPECT_TRUE(check.quiet);
    EXPECT_EQ(parse_command_line({"job"}).exit_code, exit_usage);
    EXPECT_EQ(parse_command_line({"job", "check"}).exit_code, exit_usage);
    EXPECT_THAT(parse_command_line({"job", "check", "-h"}).text,
                StartsWith("Examples:\n  cdctl job"));
}

TEST(CommandLine, WrongUsageIsTwo) {
    const std::vector<std::vector<std::string>> wrong{{},
                                                      {"rnu"},
                                                      {"run", "--levle", "any"},
                                                      {"run", "--level", "most"},
                                                      {"run", "job.toml", "--fail-on", "love"},
                                                      {"run", "--random", "-3"},
                                                      {"run", "--random", "18446744073709551615"},
                                                      {"run", "j.toml", "--tolerance", "1"},
                                                      {"run", "j.toml", "--first-stage", "half"},
                                                      {"demo", "--a", "a.obj"},
                                                      {"get", "tea"},
                                                      {"join"},
                                                      {"token"},
                                                      {"token", "create", "--role", "master"},
                                                      {"token", "create", "--uses", "0"},
                                                      {"watch"}};
    for (const auto& arguments : wrong) {
        const CommandLine line = parse_command_line(arguments);
        EXPECT_FALSE(line.command);
        EXPECT_EQ(line.exit_code, exit_usage) << testing::PrintToString(arguments);
        EXPECT_THAT(line.text, StartsWith("cdctl: "));
    }
}

TEST(CommandLine, AWrongChoiceIsToldTheOthers) {
    EXPECT_THAT(parse_command_line({"diff", "old", "new", "--fail-on", "most"}).text,
                StartsWith("cdctl: --fail-on: most not in {any,new}\n"));
    EXPECT_THAT(parse_command_line({"run", "job.toml", "--first-stage", "half"}).text,
                StartsWith("cdctl: --first-stage: half not in {float,double,"));
}

TEST(CommandLine, AMistypedVerbIsToldTheNearest) {
    const auto text_of = [](std::vector<std::string> arguments) {
        const CommandLine line = parse_command_line(std::move(arguments));
        EXPECT_EQ(line.exit_code, exit_usage);
        return line.text;
    };
    EXPECT_EQ(text_of({"rnu", "job.toml"}), "cdctl: no verb 'rnu'; did you mean 'run'?\n");
    EXPECT_EQ(text_of({"token", "crate"}),
              "cdctl: no verb 'token crate'; did you mean 'create'?\n");
    EXPECT_EQ(text_of({"zzzzzzzz"}),
              "cdctl: no verb 'zzzzzzzz'; `cdctl --help` lists those that exist\n");
}

TEST(CommandLine, AMistypedOptionIsToldTheNearest) {
    const auto text_of = [](std::vector<std::string> arguments) {
        const CommandLine line = parse_command_line(std::move(arguments));
        EXPECT_EQ(line.exit_code, exit_usage);
        return line.text;
    };
    EXPECT_EQ(text_of({"run", "--a", "a.obj", "--b", "b.obj", "--pose", "p.csv"}),
              "cdctl: no option '--pose' of `cdctl run`; did you mean '--poses'?\n");
    EXPECT_EQ(text_of({"run", "j.toml", "--levle=any"}),
              "cdctl: no option '--levle' of `cdctl run`; did you mean '--level'?\n");
    EXPECT_EQ(text_of({"inspect", "--uint", "mm"}),
              "cdctl: no option '--uint' of `cdctl inspect`; did you mean '--unit'?\n")
        << "although the mesh is missing, too";
    EXPECT_EQ(
        text_of({"--xxxxxxxxxxx"}),
        "cdctl: no option '--xxxxxxxxxxx' of `cdctl`; `cdctl --help` lists those that exist\n");
}

TEST(CommandLine, AloneItPrintsTenLinesToType) {
    const CommandLine line = parse_command_line({});
    EXPECT_EQ(std::count(line.text.begin(), line.text.end(), '\n'), 10);
    EXPECT_THAT(line.text, HasSubstr("\n  cdctl inspect car.obj "));
}

TEST(CommandLine, VersionTellsCommitAndLibraries) {
    const CommandLine line = parse_command_line({"--version"});
    EXPECT_EQ(line.exit_code, exit_done);
    EXPECT_THAT(line.text, testing::AllOf(StartsWith("cdctl "), HasSubstr("\n  commit ")));
    EXPECT_THAT(parse_command_line({"--version", "-o", "json"}).text,
                HasSubstr("\"program\": \"cdctl\""));
    const CommandLine verb = parse_command_line({"version", "-o", "json"});
    ASSERT_TRUE(verb.command) << verb.text;
    EXPECT_EQ(std::get<VersionCommand>(*verb.command).output, "json");
}

TEST(CommandLine, NoExampleNamesAJobThatCannotBe) {
    for (const char* verb : {"watch",
                             "wait",
                             "results",
                             "cancel",
                             "explain",
                             "priority",
                             "rm",
                             "verify",
                             "extract",
                             "diff"}) {
        const std::string help = parse_command_line({verb, "--help"}).text;
        EXPECT_THAT(help, HasSubstr(" j-5692")) << verb;
        EXPECT_THAT(help, HasSubstr("last")) << verb;
        EXPECT_THAT(help, testing::Not(HasSubstr("j-1 "))) << verb;
    }
}

TEST(CommandLine, RunTakesMeshesInsteadOfAFile) {
    const CommandLine line = parse_command_line(
        {"run",       "--a",      "a.obj",     "--b",           "b.stl",     "--unit-b",
         "mm",        "--random", "50",        "--penetration", "0.01",      "0.02",
         "--level",   "count",    "--formats", "csv,json",      "--threads", "3",
         "--fail-on", "touch",    "-o",        "json",          "--quiet"});
    ASSERT_TRUE(line.command) << line.text;
    const auto& run = std::get<RunCommand>(*line.command);
    EXPECT_EQ(run.job.a, "a.obj");
    EXPECT_EQ(run.job.unit_b, "mm");
    EXPECT_EQ(run.job.poses.random, 50u);
    EXPECT_EQ(run.job.poses.penetration, (std::vector<double>{0.01, 0.02}));
    EXPECT_EQ(run.job.query.level, "count");
    EXPECT_EQ(run.job.output.formats, (std::vector<std::string>{"csv", "json"}));
    EXPECT_EQ(run.host.threads, 3u);
    EXPECT_EQ(run.fail_on, (FailOn{.touch = true}));
    EXPECT_EQ(run.output, "json");
    EXPECT_TRUE(run.quiet);
    EXPECT_TRUE(run.master.address.empty());
}

TEST(CommandLine, APriorityIsReadWhereAJobGoesToAMaster) {
    const auto run = parse_command_line({"run", "j.toml", "--master", "n:1", "--priority", "-3"});
    ASSERT_TRUE(run.command) << run.text;
    EXPECT_EQ(std::get<RunCommand>(*run.command).master.priority, -3);
    const auto submit = parse_command_line({"submit", "j.toml", "--priority", "10"});
    ASSERT_TRUE(submit.command) << submit.text;
    EXPECT_EQ(std::get<SubmitCommand>(*submit.command).master.priority, 10);
    EXPECT_EQ(parse_command_line({"run", "j.toml", "--priority", "11"}).exit_code, exit_usage);
    EXPECT_EQ(parse_command_line({"submit", "j.toml", "--priority", "-11"}).exit_code, exit_usage);
}

TEST(CommandLine, APriorityOfAJobThatIsThereMayBeNegative) {
    const auto line = parse_command_line({"priority", "j-5692", "-5", "--master", "n:1"});
    ASSERT_TRUE(line.command) << line.text;
    const auto& change = std::get<PriorityCommand>(*line.command);
    EXPECT_EQ(change.job, "j-5692");
    EXPECT_EQ(change.priority, -5);
    EXPECT_EQ(change.master.address, "n:1");
    EXPECT_EQ(parse_command_line({"priority", "j-5692"}).exit_code, exit_usage);
    EXPECT_EQ(parse_command_line({"priority", "j-5692", "11"}).exit_code, exit_usage);
}

TEST(CommandLine, AFirstStageIsRead) {
    const CommandLine line =
        parse_command_line({"run", "job.toml", "--first-stage", "wide-integer"});
    ASSERT_TRUE(line.command) << line.text;
    EXPECT_EQ(std::get<RunCommand>(*line.command).host.first_stage, PairStage::WideInteger);
}

TEST(CommandLine, TreesAreKeptWhereTheOptionOrTheEnvironmentSays) {
    const auto folder_of = [](std::vector<std::string> arguments) {
        const CommandLine line = parse_command_line(std::move(arguments));
        if (!line.command) {
            return line.text;
        }
        const auto* run = std::get_if<RunCommand>(&*line.command);
        return run != nullptr ? run->host.tree_cache
                              : std::get<SubmitCommand>(*line.command).tree_cache;
    };
    const auto before = [](const char* name) {
        const char* value = ::getenv(name);
        return value == nullptr ? std::optional<std::string>() : std::string(value);
    };
    const auto restore = [](const char* name, const std::optional<std::string>& value) {
        value ? ::setenv(name, value->c_str(), 1) : ::unsetenv(name);
    };
    const auto cache = before("XDG_CACHE_HOME");
    const auto home = before("HOME");
    const auto trees = before("CDCTL_TREE_CACHE");
    ::unsetenv("CDCTL_TREE_CACHE");
    ::setenv("XDG_CACHE_HOME", "/x", 1);
    ::setenv("HOME", "/h", 1);
    EXPECT_EQ(folder_of({"run", "j.toml"}), "/x/cdcluster/trees");
    EXPECT_EQ(folder_of({"submit", "j.toml"}), "/x/cdcluster/trees");
    EXPECT_EQ(folder_of({"run", "j.toml", "--tree-cache", "off"}), "off");
    EXPECT_EQ(folder_of({"submit", "j.toml", "--tree-cache", "here"}), "here");
    ::unsetenv("XDG_CACHE_HOME");
    EXPECT_EQ(folder_of({"run", "j.toml"}), "/h/.cache/cdcluster/trees");
    ::unsetenv("HOME");
    EXPECT_EQ(folder_of({"run", "j.toml"}), "off") << "never where others may write";
    ::setenv("CDCTL_TREE_CACHE", "/t", 1);
    EXPECT_EQ(folder_of({"run", "j.toml"}), "/t");
    EXPECT_EQ(folder_of({"run", "j.toml", "--tree-cache", "off"}), "off");
    restore("XDG_CACHE_HOME", cache);
    restore("HOME", home);
    restore("CDCTL_TREE_CACHE", trees);
}

TEST(CommandLine, RemoteVerbsHaveAMasterOnLoopback) {
    const CommandLine line = parse_command_line({"wait", "j-1", "--fail-on", "cross"});
    ASSERT_TRUE(line.command) << line.text;
    const auto& wait = std::get<WatchCommand>(*line.command);
    EXPECT_EQ(wait.job, "j-1");
    EXPECT_TRUE(wait.only_wait);
    EXPECT_EQ(wait.fail_on, (FailOn{.cross = true}));
    EXPECT_FALSE(wait.master.address.empty());
    EXPECT_FALSE(wait.master.insecure);
}

TEST(ExitCodes, FollowTheKindOfError) {
    EXPECT_EQ(exit_code_of({ErrorCode::BadInput, ""}), 2);
    EXPECT_EQ(exit_code_of({ErrorCode::Incomplete, ""}), 3);
    EXPECT_EQ(exit_code_of({ErrorCode::Disconnected, ""}), 4);
    EXPECT_EQ(exit_code_of({ErrorCode::Refused, ""}), 5);
    EXPECT_EQ(exit_code_of({ErrorCode::Interrupted, ""}, 2), 130);
    EXPECT_EQ(exit_code_of({ErrorCode::Interrupted, ""}, 15), 143);
}

} // namespace cd::tests
