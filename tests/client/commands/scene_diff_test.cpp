// Proves that `cdctl diff` compares scenes by step and bodies, that it takes pairs of bodies whose
// boxes are apart for separate, and that its exit codes say so.
#include "client/base/exit_code.hpp"
#include "client/commands/commands.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace cd::tests {

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class SceneDiff : public testing::Test {
  protected:
    SceneDiff() {
        write_text(dir_ / "body.obj",
                   "o part\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                   "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    }

    /// Runs a scene of a, b and c into a folder. They are at `poses`, rows of step, body and x,
    /// unless b has another key with poses of its own.
    void run(const std::string& name,
             const std::string& poses,
             const std::string& more = "",
             const std::string& key_of_b = "") {
        write_text(dir_ / "poses.csv", "step,body,x\n" + poses);
        write_text(dir_ / "job.toml",
                   "[bodies]\na = { mesh = \"body.obj\" }\nb = { mesh = \"body.obj\"" + key_of_b +
                       " }\nc = { mesh = \"body.obj\" }\n[poses]\nfile = \"poses.csv\"\nabsent = "
                       "\"nan\"\n" +
                       more);
        RunCommand command;
        command.job.file = (dir_ / "job.toml").string();
        command.job.output.dir = (dir_ / name).string();
        command.host.threads = 1;
        command.quiet = true;
        EXPECT_EQ(captured(command), exit_done) << stderr_;
    }
    int diff(DiffFailOn fail_on) {
        DiffCommand command;
        command.earlier = (dir_ / "old").string();
        command.later = (dir_ / "new").string();
        command.out = (dir_ / "diff").string();
        command.fail_on = fail_on;
        command.threads = 1;
        return captured(command);
    }
    template <class Command>
    int captured(const Command& command) {
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        const int code = execute(command);
        stdout_ = testing::internal::GetCapturedStdout();
        stderr_ = testing::internal::GetCapturedStderr();
        return code;
    }

    const TemporaryFolder folder_;
    const std::filesystem::path dir_ = folder_.path();
    std::string stdout_;
    std::string stderr_;
};

/// At step 0, a meets b; at step 1 nobody meets anybody.
const std::string apart_later = "0,a,0\n0,b,0.25\n0,c,9\n1,a,0\n1,b,5\n1,c,9\n";
/// At step 0 nobody meets anybody; at step 1, a meets c.
const std::string apart_first = "0,a,0\n0,b,5\n0,c,9\n1,a,0\n1,b,5\n1,c,0.25\n";
const std::string any = "[query]\nlevel = \"any\"\n";

} // namespace

TEST_F(SceneDiff, PairsWhoseBoxesAreApartAreSeparate) {
    run("old", apart_later);
    run("new", apart_first);
    EXPECT_EQ(diff(DiffFailOn::New), exit_contacts);
    EXPECT_THAT(stdout_,
                AllOf(HasSubstr("  scenarios     2 in both, matched by step and bodies; 2 of them "
                                "apart by their boxes in one run\n"),
                      HasSubstr("  changed       2 of 2\n"),
                      HasSubstr("    new: a/part x c/part: 1 scenario, "),
                      HasSubstr("    resolved: a/part x b/part: 1 scenario, ")));
    const std::string rows = read_text(dir_ / "diff/diff.csv");
    EXPECT_THAT(rows, HasSubstr("\n0,,a,c,separate,cross,0,"));
    EXPECT_THAT(rows, HasSubstr("\n,0,a,b,cross,separate,"));
}

TEST_F(SceneDiff, AContactThatIsNewAtLevelAnyIsADifference) {
    run("old", apart_later, any);
    run("new", apart_first, any);
    EXPECT_EQ(diff(DiffFailOn::Any), exit_contacts) << stdout_;
    EXPECT_EQ(diff(DiffFailOn::New), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("--fail-on new: " + (dir_ / "old").string() + ": groups need"));
}

TEST_F(SceneDiff, AScenarioThatIsSeparateInBothRunsIsNoChange) {
    // In the later run the boxes of a and b meet at step 0, and their triangles do not.
    run("old", "0,a,0\n0,b,5\n0,c,9\n1,a,0\n1,b,0.25\n1,c,9\n");
    write_text(dir_ / "y.csv", "x,y\n0.875,0.875\n0.25,0\n");
    run("new", "0,a,0\n0,c,9\n1,a,0\n1,c,9\n", "", ", poses = \"y.csv\"");
    EXPECT_EQ(diff(DiffFailOn::Any), exit_done) << stdout_;
    EXPECT_THAT(stdout_,
                AllOf(HasSubstr("2 in both, matched by step and bodies; 1 of them apart"),
                      HasSubstr("  changed       0 of 2\n")));
}

TEST_F(SceneDiff, WhatARunMayHaveLeftOutForAnotherReasonIsNotTested) {
    // Rules ignore the pair, or a body is absent at that step.
    run("old", apart_later);
    for (const auto& [poses, rules] :
         {std::pair(apart_first, std::string("[rules]\norder = [{ ignore = [\"a\", \"b\"] }]\n")),
          std::pair(std::string("0,a,0\n0,b,5\n0,c,nan\n1,a,0\n1,b,5\n1,c,0.25\n"),
                    std::string())}) {
        std::filesystem::remove_all(dir_ / "new");
        run("new", poses, rules);
        diff(DiffFailOn::Never);
        EXPECT_THAT(stdout_, HasSubstr("not comparable: a/part x b/part")) << stdout_;
    }
    // Of equal rules, that ignore another pair, boxes are known to be the reason.
    const std::string rules = "[rules]\norder = [{ ignore = [\"b\", \"c\"] }]\n";
    for (const auto& [name, poses] :
         {std::pair("old", apart_later), std::pair("new", apart_first)}) {
        std::filesystem::remove_all(dir_ / name);
        run(name, poses, rules);
    }
    diff(DiffFailOn::Never);
    EXPECT_THAT(stdout_, AllOf(HasSubstr("resolved: a/part x b/part"), Not(HasSubstr("not comp"))));
}

} // namespace cd::tests
