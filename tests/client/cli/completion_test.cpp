// Proves which words complete a command line of cdctl.
#include "client/cli/cli.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

CompleteCommand completed(std::vector<std::string> words) {
    words.insert(words.begin(), "complete");
    const CommandLine line = parse_command_line(words);
    EXPECT_TRUE(line.command && std::holds_alternative<CompleteCommand>(*line.command));
    return std::get<CompleteCommand>(*line.command);
}

TEST(Completion, VerbsAreFoundInTheirOrder) {
    EXPECT_THAT(completed({"re"}).words, ElementsAre("results", "report"));
    EXPECT_THAT(completed({"token", ""}).words, ElementsAre("create"));
    EXPECT_THAT(completed({""}).words, Contains("completion"));
    EXPECT_THAT(completed({""}).words, Not(Contains("complete")));
    EXPECT_THAT(completed({}).words, Contains("run"));
    EXPECT_THAT(completed({"nonsense", ""}).words, Contains("run"));
}

TEST(Completion, OptionsAreThoseOfTheVerb) {
    EXPECT_THAT(completed({"run", "--lev"}).words, ElementsAre("--level"));
    EXPECT_THAT(completed({"status", "--lev"}).words, IsEmpty());
    EXPECT_THAT(completed({"status", "-"}).words, Contains("--master"));
    EXPECT_THAT(completed({"token", "create", "--"}).words, Contains("--role"));
    EXPECT_THAT(completed({"run", "--", "--lev"}).words, IsEmpty());
}

TEST(Completion, ValuesAreTheChoicesOfTheirOption) {
    EXPECT_THAT(completed({"run", "--level", "c"}).words, ElementsAre("count", "contacts"));
    EXPECT_THAT(completed({"run", "--level=c"}).words,
                ElementsAre("--level=count", "--level=contacts"));
    // As bash cuts the line.
    EXPECT_THAT(completed({"run", "--level", "=", "c"}).words, ElementsAre("count", "contacts"));
    EXPECT_THAT(completed({"run", "--level", "="}).words, Contains("any"));
    EXPECT_THAT(completed({"run", "-o", ""}).words, ElementsAre("text", "json", "csv"));
    EXPECT_THAT(completed({"run", "--fail-on", "touch,un"}).words, ElementsAre("touch,undecided"));
    EXPECT_THAT(completed({"diff", "--fail-on", ""}).words, ElementsAre("any", "new"));
    EXPECT_THAT(completed({"run", "--first-stage", "d"}).words,
                ElementsAre("double", "double-double"));
    EXPECT_THAT(completed({"get", "w"}).words, ElementsAre("workers"));
    EXPECT_THAT(completed({"completion", "z"}).words, ElementsAre("zsh"));
    EXPECT_THAT(completed({"run", "--threads", ""}).words, IsEmpty());
}

TEST(Completion, FilesAndJobsAreWantedWhereTheyAreTaken) {
    EXPECT_TRUE(completed({"run", ""}).has_files);
    EXPECT_FALSE(completed({"run", ""}).job_begin);
    EXPECT_TRUE(completed({"run", "--a", ""}).has_files);
    EXPECT_FALSE(completed({"run", "job.toml", ""}).has_files) << "it takes one job file";
    EXPECT_TRUE(completed({"inspect", "a.obj", ""}).has_files) << "it takes several meshes";
    EXPECT_FALSE(completed({"watch", ""}).has_files);
    EXPECT_EQ(completed({"watch", "j-5"}).job_begin, "j-5");
    EXPECT_FALSE(completed({"explain", "j-5", ""}).job_begin) << "a scenario's number";
    EXPECT_EQ(completed({"priority", "j-5"}).job_begin, "j-5");
    EXPECT_FALSE(completed({"priority", "j-5", ""}).job_begin) << "a number";
    EXPECT_EQ(completed({"rm", "j-1", "j-5"}).job_begin, "j-5");
    EXPECT_EQ(completed({"diff", "out", "j-5"}).job_begin, "j-5");
    EXPECT_TRUE(completed({"diff", "out", "j-5"}).has_files);
    EXPECT_EQ(completed({"report", "--baseline", "j-5"}).job_begin, "j-5");
}

TEST(Completion, TheMasterIsTheOneThatTheLineNames) {
    const CompleteCommand named =
        completed({"watch", "--master", "node-1:7600", "--insecure", "--credential=me.pem", "j-"});
    EXPECT_EQ(named.job_begin, "j-");
    EXPECT_EQ(named.master.address, "node-1:7600");
    EXPECT_EQ(named.master.credential, "me.pem");
    EXPECT_TRUE(named.master.insecure);
    EXPECT_EQ(completed({"watch", "j-"}).master.address, "127.0.0.1:7600");
}

TEST(Completion, AnUnknownShellIsRefused) {
    const CommandLine line = parse_command_line({"completion", "tcsh"});
    EXPECT_EQ(line.exit_code, 2);
    EXPECT_THAT(line.text, StartsWith("cdctl: shell: tcsh not in {bash,zsh,fish}"));
}

} // namespace
} // namespace cd::tests
