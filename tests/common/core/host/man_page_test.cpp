// Proves that a manual page has a program's options and subcommands, and that no text of theirs is
// taken for a request of man(7).
#include "common/core/host/man_page.hpp"

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace cd::tests {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(ManPage, HasOptionsDefaultsEnvironmentAndSubcommands) {
    CLI::App app("Examples:\n  tool --x 1\n.start", "tool");
    std::string port = "7600";
    app.add_option("-p,--port", port, "The port\n  of it")
        ->type_name("N")
        ->capture_default_str()
        ->envname("TOOL_PORT");
    app.add_option("--secret", port, "hidden text")->group("");
    CLI::App* below = app.add_subcommand("join", "Joins.\nExamples:\n  tool join 'x'");
    below->add_option("what", port, "A \\name")->type_name("WHAT");
    ::setenv("SOURCE_DATE_EPOCH", "86400", 1);
    const std::string page = man_page(app, 8, "does a thing");
    ::unsetenv("SOURCE_DATE_EPOCH");

    EXPECT_THAT(page, StartsWith(".TH TOOL 8 1970-01-02 \"cdcluster "));
    EXPECT_THAT(page, HasSubstr(".SH NAME\ntool \\- does a thing\n"));
    EXPECT_THAT(page, HasSubstr(".nf\nExamples:\n  tool \\-\\-x 1\n\\&.start\n.fi\n"));
    EXPECT_THAT(page,
                HasSubstr("\\-\\-port\\fR \\fIN\\fR\nThe port\n.br\nof it\n.br\nDefault: 7600\n"
                          ".br\nEnvironment: TOOL_PORT\n"));
    EXPECT_THAT(page, HasSubstr(".SS tool join\nJoins.\n.PP\n.nf\nExamples:\n"));
    EXPECT_THAT(page, HasSubstr("tool join \\(aqx\\(aq"));
    EXPECT_THAT(page, HasSubstr(".TP\n\\fIWHAT\\fR\nA \\ename\n"));
    EXPECT_THAT(page, Not(HasSubstr("hidden")));
}

} // namespace
} // namespace cd::tests
