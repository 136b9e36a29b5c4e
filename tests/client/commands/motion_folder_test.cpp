// Proves what the verbs make of a results folder with motions: that `verify` finds the same,
// `extract` gives cases, pictures and scenes of the event, `report` shows the time, `diff` and
// `--reuse` tell other questions apart, and `--fail-on` fails if a motion is undecided.
#include "client/base/exit_code.hpp"
#include "client/commands/commands.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <string>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::Not;

/// B passes A at a distance of 0.001, hits it, moves inside its reach, and leaves it.
const std::string keys = "id,t,x,y,z\npass,0,1.001,-0.5,0\nup,10,1.001,0.5,0\nin,20,0.2,0.2,0.2\n"
                         "out,30,0.2,0.2,0.2\nend,40,5,0.2,0.2\n";

class MotionFolder : public testing::Test {
  protected:
    MotionFolder() {
        for (const std::string name : {"a.obj", "b.obj"}) {
            write_text(dir_ / name,
                       "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
        }
        write_text(dir_ / "keys.csv", keys);
        command_.host.threads = 1;
        command_.quiet = true;
    }

    /// Runs the motions into a folder.
    int run(const std::string& out, const std::string& motion, FailOn fail_on = {}) {
        write_text(dir_ / "job.toml",
                   "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\nfile = \"keys.csv\"\n"
                   "[motion]\n" +
                       motion + "\n[query]\nlevel = \"pairs\"\n");
        command_.job.file = (dir_ / "job.toml").string();
        command_.job.output.dir = (dir_ / out).string();
        command_.job.output.formats = {"csv"};
        command_.fail_on = fail_on;
        return told(command_);
    }

    /// Executes a command; returns its exit code.
    template <class Command>
    int told(const Command& command) {
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        const int code = execute(command);
        stdout_ = testing::internal::GetCapturedStdout();
        stderr_ = testing::internal::GetCapturedStderr();
        return code;
    }

    int extract(const std::string& scenarios, const std::string& as, bool minimal = false) {
        ExtractCommand command;
        command.run = (dir_ / "out").string();
        command.scenarios = scenarios;
        command.as = as;
        command.out = (dir_ / as).string();
        command.minimal = minimal;
        command.threads = 1;
        return told(command);
    }

    [[nodiscard]] nlohmann::json json_of(const std::string& name) const {
        return nlohmann::json::parse(read_text(dir_ / name));
    }

    const TemporaryFolder folder_;
    const std::filesystem::path dir_ = folder_.path();
    RunCommand command_;
    std::string stdout_;
    std::string stderr_;
};

} // namespace

TEST_F(MotionFolder, VerifyAndASecondRunFindTheSame) {
    ASSERT_EQ(run("out", "resolution = 0.01\nuntil = \"end\""), exit_done) << stderr_;
    VerifyCommand verify;
    verify.run = (dir_ / "out").string();
    verify.threads = 1;
    EXPECT_EQ(told(verify), exit_done);
    EXPECT_THAT(stdout_, HasSubstr("4 the same, 0 different, 0 could not be run"));
    const auto digest = json_of("out/run.json")["digest"];
    command_.job.file = (dir_ / "out").string();
    command_.job.output.dir = (dir_ / "again").string();
    ASSERT_EQ(told(command_), exit_done) << stderr_;
    EXPECT_EQ(json_of("again/run.json")["digest"], digest);
    EXPECT_EQ(json_of("again/run.json")["query"]["until"], "end");
}

TEST_F(MotionFolder, ACaseRestsAtTheEvent) {
    ASSERT_EQ(run("out", "resolution = 0.01"), exit_done) << stderr_;
    for (const bool minimal : {false, true}) {
        ASSERT_EQ(extract("1-2", "case", minimal), exit_done) << stderr_;
        const auto expected = json_of("case/expected.json");
        EXPECT_EQ(expected["scenarios"][0]["class"], "cross");
        EXPECT_THAT(read_text(dir_ / "case/job.toml"), Not(HasSubstr("[motion]")));
        RunCommand again = command_;
        again.job.file = (dir_ / "case/job.toml").string();
        again.job.output.dir = (dir_ / "of_case").string();
        again.folder.overwrite = true;
        ASSERT_EQ(told(again), exit_done) << stderr_;
        EXPECT_EQ(json_of("of_case/run.json")["digest"], expected["digest"]);
    }
    ASSERT_EQ(extract("1", "png"), exit_done) << stderr_;
    EXPECT_TRUE(std::filesystem::exists(dir_ / "png/1.png"));
    ASSERT_EQ(extract("1-2", "vtp"), exit_done) << stderr_;
    EXPECT_TRUE(std::filesystem::exists(dir_ / "vtp/b-1.vtp"));
}

TEST_F(MotionFolder, AReportShowsTheTime) {
    ASSERT_EQ(run("out", "resolution = 0.01"), exit_done) << stderr_;
    EXPECT_EQ(json_of("out/summary.json")["question"], "motion");
    ReportCommand report;
    report.run = (dir_ / "out").string();
    report.out = (dir_ / "report.html").string();
    report.threads = 1;
    ASSERT_EQ(told(report), exit_done) << stderr_;
    const std::string page = read_text(dir_ / "report.html");
    pugi::xml_document document;
    const auto parsed =
        document.load_buffer(page.data(), page.size(), pugi::parse_default | pugi::parse_doctype);
    EXPECT_TRUE(parsed) << parsed.description();
    EXPECT_THAT(page, HasSubstr("<p>The first contact is between t "));
    EXPECT_THAT(page,
                HasSubstr(", in #1, id up. 1 motion is undecided: in open parts of the time "
                          "the bodies come within "));
    EXPECT_THAT(page, HasSubstr("<h2>Motions</h2>"));
    EXPECT_THAT(page, HasSubstr("<td>#0, id pass</td><td>0</td><td><svg "));
    EXPECT_THAT(page, HasSubstr("#1, id up, t 10 to 20, cross, "));
    EXPECT_THAT(page, HasSubstr(", first in contact between t "));
    EXPECT_THAT(page, HasSubstr("1 scenario: undecided, since parts of the time stay open"));
}

TEST_F(MotionFolder, AnotherResolutionIsAnotherQuestion) {
    ASSERT_EQ(run("out", "resolution = 0.01"), exit_done) << stderr_;
    command_.reuse = (dir_ / "out").string();
    EXPECT_EQ(run("reused", "resolution = 0.0001"), exit_usage);
    EXPECT_THAT(stderr_,
                HasSubstr("nothing can be reused: query changed (motion until contact with "
                          "resolution 1e-04, was until contact with resolution 0.01)"));
    ASSERT_EQ(run("reused", "resolution = 0.01"), exit_done) << stderr_;
    EXPECT_EQ(json_of("reused/run.json")["digest"], json_of("out/run.json")["digest"]);
    EXPECT_EQ(json_of("reused/run.json")["reused_from"]["scenarios"], 4);
    command_.reuse.clear();
    ASSERT_EQ(run("finer", "resolution = 0.0001"), exit_done) << stderr_;
    DiffCommand diff;
    diff.earlier = (dir_ / "out").string();
    diff.later = (dir_ / "finer").string();
    diff.out = (dir_ / "diff").string();
    diff.threads = 1;
    ASSERT_EQ(told(diff), exit_done) << stderr_;
    const std::string rows = read_text(dir_ / "diff/diff.csv");
    EXPECT_THAT(rows, HasSubstr("\n0,0,a,b,undecided,separate,"));
    EXPECT_THAT(rows, HasSubstr("\n1,1,a,b,cross,cross,"));
    EXPECT_THAT(rows, Not(HasSubstr("\n2,2,"))) << "in contact from the begin in both";
}

TEST_F(MotionFolder, AnUndecidedMotionFailsIfAsked) {
    const std::string coarse = "resolution = 0.01";
    EXPECT_EQ(run("undecided", coarse, {.undecided = true}), exit_contacts) << stderr_;
    EXPECT_EQ(run("touch", coarse, {.touch = true}), exit_contacts) << stderr_;
    write_text(dir_ / "keys.csv", "x,y\n1.001,-0.5\n1.001,0.5\n");
    EXPECT_EQ(run("alone", coarse), exit_done) << stderr_;
    EXPECT_EQ(run("open", coarse, {.touch = true}), exit_incomplete) << stderr_;
    EXPECT_EQ(run("free", "resolution = 0.0001", {.touch = true, .undecided = true}), exit_done)
        << stderr_;
}

} // namespace cd::tests
