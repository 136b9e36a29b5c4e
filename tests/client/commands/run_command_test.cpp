// Proves that `cdctl run` without a master does a whole job: inputs, ignored parts, output and exit
// codes; wrong inputs end it with one clear line.
#include "client/base/exit_code.hpp"
#include "client/commands/commands.hpp"
#include "client/job/prepared_job.hpp"
#include "common/geometry/simd_target.hpp"
#include "tests/support/obj_file.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

/// Returns a tetrahedron with its corner at (x, 0, 0) as a group of an OBJ file; `first` is its
/// first vertex's number.
std::string tetrahedron(const std::string& name, double x, int first) {
    std::ostringstream text;
    text << "g " << name << "\n";
    for (const auto& [dx, dy, dz] : {std::array{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
        text << "v " << x + dx << " " << dy << " " << dz << "\n";
    }
    for (const auto& [i, j, k] : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
        text << "f " << first + i << " " << first + j << " " << first + k << "\n";
    }
    return text.str();
}

class Run : public testing::Test {
  protected:
    Run() {
        write("a.obj", tetrahedron("wheel_left", 0, 1) + tetrahedron("body", 5, 5));
        write("b.obj", tetrahedron("post", 0, 1));
        // B is away from A, across its wheel, across its body, and touches its body at a corner.
        write("poses.csv",
              "x,y,z,qx,qy,qz,qw\n0,9,0,0,0,0,1\n0.25,0.1,0.1,0,0,0,1\n5.25,0.1,0.1,0,0,0,1\n"
              "6,0,0,0,0,0,1\n");
        command_.job.a = (dir_ / "a.obj").string();
        command_.job.b = (dir_ / "b.obj").string();
        command_.job.poses.file = (dir_ / "poses.csv").string();
        command_.job.output.dir = (dir_ / "out").string();
        command_.job.output.formats = {"csv", "json"};
        command_.folder.overwrite = true;
        command_.folder.fresh = true; // Each run uses a new folder.
        command_.host.threads = 2;
        command_.quiet = true;
    }

    void write(const std::string& name, const std::string& text) const {
        write_text(dir_ / name, text);
    }
    [[nodiscard]] std::string read(const std::string& name) const { return read_text(dir_ / name); }
    [[nodiscard]] nlohmann::json summary() const {
        return nlohmann::json::parse(read("out/summary.json"));
    }

    /// Makes the job that of a file which ignores `pairs`. Body A is called `name`.
    void ignore(const std::string& pairs, const std::string& name = "a") {
        write("job.toml",
              "[a]\nmesh = \"a.obj\"\nname = \"" + name +
                  "\"\n[b]\nmesh = \"b.obj\"\n[poses]\nfile = \"poses.csv\"\n"
                  "[query]\nignore = [[" +
                  pairs + "]]\n");
        command_.job = {};
        command_.job.file = (dir_ / "job.toml").string();
        command_.output = "csv";
    }

    /// Runs the command and keeps its output.
    int run() {
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        const int code = execute(command_);
        stdout_ = testing::internal::GetCapturedStdout();
        stderr_ = testing::internal::GetCapturedStderr();
        return code;
    }

    const TemporaryFolder folder_;
    const fs::path dir_ = folder_.path();
    RunCommand command_;
    std::string stdout_;
    std::string stderr_;
};

} // namespace

TEST_F(Run, GivesEachScenarioItsClass) {
    EXPECT_EQ(run(), exit_done) << stderr_;
    const std::string rows = read("out/scenarios.csv");
    EXPECT_THAT(rows, HasSubstr("\n0,a,b,separate,0,"));
    EXPECT_THAT(rows, HasSubstr("\n1,a,b,cross,"));
    EXPECT_THAT(rows, HasSubstr("\n2,a,b,cross,"));
    EXPECT_THAT(rows, HasSubstr("\n3,a,b,touch,"));
    EXPECT_THAT(stdout_, HasSubstr("tested 4 of 4"));
    EXPECT_THAT(stdout_, HasSubstr("most touched  body 50.0 %, wheel_left 25.0 %"));
    EXPECT_THAT(stdout_, HasSubstr("open it: cdctl view " + command_.job.output.dir + "\n"));
    EXPECT_EQ(stderr_, "");
}

TEST_F(Run, TheDigestIsThatOfOneThread) {
    ASSERT_EQ(run(), exit_done);
    const auto two = summary()["digest"];
    command_.host.threads = 1;
    ASSERT_EQ(run(), exit_done);
    EXPECT_EQ(summary()["digest"], two);
    EXPECT_TRUE(two.is_string());
}

TEST_F(Run, TheMapOfCutListsSaysSo) {
    command_.job.query.limit_pairs = 1;
    ASSERT_EQ(run(), exit_done);
    EXPECT_THAT(stdout_, HasSubstr("were in contact, of the first 1 pair a scenario; digest"));
    EXPECT_EQ(summary()["limit_pairs"], 1);
    EXPECT_EQ(summary()["map_of_listed_pairs"], true);
    command_.job.query.maps = true;
    ASSERT_EQ(run(), exit_done);
    EXPECT_THAT(stdout_, HasSubstr("were in contact; digest"));
    EXPECT_EQ(summary()["map_of_listed_pairs"], false);
}

TEST_F(Run, FailOnDecidesBetweenZeroAndOne) {
    command_.fail_on = FailOn{.touch = true};
    EXPECT_EQ(run(), exit_contacts);
    command_.fail_on = FailOn{.cross = true};
    EXPECT_EQ(run(), exit_contacts);
    write("poses.csv", "x,y,z,qx,qy,qz,qw\n6,0,0,0,0,0,1\n");
    EXPECT_EQ(run(), exit_done);
    command_.fail_on = FailOn{.touch = true};
    EXPECT_EQ(run(), exit_contacts);
    write("poses.csv", "x,y,z,qx,qy,qz,qw\n0,9,0,0,0,0,1\n");
    EXPECT_EQ(run(), exit_done);
}

TEST_F(Run, FailOnNearIsForNearAndContact) {
    Summary summary;
    summary.total = 2;
    summary.separate = 1;
    summary.near = 1;
    EXPECT_EQ(exit_code_of(summary, {.near = true}), exit_contacts);
    EXPECT_EQ(exit_code_of(summary, {.touch = true}), exit_done);
    EXPECT_EQ(exit_code_of(summary, {}), exit_done);
    summary.near = 0;
    summary.separate = 2;
    EXPECT_EQ(exit_code_of(summary, {.near = true}), exit_done);
    for (std::uint64_t Summary::*const worse :
         {&Summary::touch, &Summary::cross, &Summary::inside, &Summary::contact}) {
        Summary one;
        one.total = one.*worse = 1;
        EXPECT_EQ(exit_code_of(one, {.near = true}), exit_contacts);
    }
}

TEST_F(Run, FailOnNearNeedsAClearance) {
    write("poses.csv", "x,y,z,qx,qy,qz,qw\n0,9,0,0,0,0,1\n");
    command_.fail_on = FailOn{.near = true};
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("--fail-on near needs a clearance"));
    command_.job.query.clearance = 7.5;
    EXPECT_EQ(run(), exit_done);
    command_.job.query.clearance = 8.5; // B's corner is 8 above A's.
    EXPECT_EQ(run(), exit_contacts);
    command_.fail_on = FailOn{.touch = true};
    EXPECT_EQ(run(), exit_done);
}

TEST_F(Run, ALargeClearanceIsWarnedOf) {
    command_.job.query.clearance = 0.5;
    EXPECT_EQ(run(), exit_done);
    EXPECT_EQ(stderr_, "");
    command_.job.query.clearance = 2;
    EXPECT_EQ(run(), exit_done);
    EXPECT_THAT(stderr_,
                HasSubstr("warning: the clearance of 2 m exceeds most triangles of a.obj"));
}

TEST_F(Run, FailOnUndecidedIsNoOpenQuestion) {
    Summary summary;
    summary.total = 2;
    summary.separate = 1;
    summary.undecided = 1;
    EXPECT_EQ(exit_code_of(summary, {.touch = true}), exit_incomplete);
    EXPECT_EQ(exit_code_of(summary, {.touch = true, .undecided = true}), exit_contacts);
    EXPECT_EQ(exit_code_of(summary, {}), exit_done);
}

TEST_F(Run, FailOnNewComparesWithABaseline) {
    command_.job.output.dir = (dir_ / "old").string();
    ASSERT_EQ(run(), exit_done) << stderr_;
    command_.job.output.dir = (dir_ / "out").string();
    command_.judge.baseline = (dir_ / "old").string();
    command_.fail_on.news = true;
    EXPECT_EQ(run(), exit_done) << stderr_;
    EXPECT_THAT(stdout_, HasSubstr("old: new 0, active 2, resolved 0, not comparable 0"));

    write("a.obj", tetrahedron("wheel_right", 0, 1) + tetrahedron("body", 5, 5));
    EXPECT_EQ(run(), exit_contacts);
    EXPECT_THAT(stdout_, HasSubstr("old: new 1, active 1, resolved 1"));
    EXPECT_THAT(stdout_, HasSubstr("  new           wheel_right x post: 1 scenario, worst #1"));
    write("s.toml", "[[clash]]\na = \"wheel_*\"\nb = \"*\"\nstatus = \"approved\"\n");
    command_.judge.statuses = (dir_ / "s.toml").string();
    EXPECT_EQ(run(), exit_done) << stderr_;
    EXPECT_THAT(stdout_, HasSubstr("approved 1"));
    command_.fail_on.touch = true;
    EXPECT_EQ(run(), exit_contacts) << "the contacts are there all the same";
}

TEST_F(Run, ABaselineNeedsAFolderAndPairs) {
    ASSERT_EQ(run(), exit_done) << stderr_;
    command_.fail_on.news = true;
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("give --baseline OLD"));
    command_.judge.baseline = command_.job.output.dir;
    command_.job.output.dir.clear();
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("give --out"));
    command_.job.query.level = "count";
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("--fail-on new is about groups, which need level pairs"));
}

TEST_F(Run, FailOnOfLevelAnyIsForContactsAndInsides) {
    command_.job.query.level = "any";
    command_.fail_on = FailOn{.cross = true};
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("--fail-on cross needs level count"));
    command_.fail_on = FailOn{.touch = true};
    EXPECT_EQ(run(), exit_contacts);
    write("poses.csv", "x,y,z,qx,qy,qz,qw\n0,9,0,0,0,0,1\n");
    EXPECT_EQ(run(), exit_done);
}

TEST(ExitCode, UndecidedScenariosLeaveOpenWhetherThereIsAContact) {
    Summary summary;
    summary.total = 2;
    summary.separate = 1;
    summary.undecided = 1;
    EXPECT_EQ(exit_code_of(summary, {}), exit_done);
    EXPECT_EQ(exit_code_of(summary, FailOn{.undecided = true}), exit_contacts);
    EXPECT_EQ(exit_code_of(summary, FailOn{.touch = true}), exit_incomplete);
    summary.touch = 1;
    summary.separate = 0;
    EXPECT_EQ(exit_code_of(summary, FailOn{.touch = true}), exit_contacts);
}

TEST_F(Run, WhatTheStrategyDoesNotLookAtMayNotBeGiven) {
    command_.job.cluster.claim = true;
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("--strategy best-match"));
    command_.job.cluster.strategy = "lowest";
    EXPECT_EQ(run(), exit_done);
    command_.job.cluster.claim = false;
    command_.job.cluster.q = 5;
    EXPECT_EQ(run(), exit_done);
    command_.job.cluster.strategy = "";
    EXPECT_EQ(run(), exit_usage);
}

TEST_F(Run, TheHeaderNamesColumnsThatAreLeftOut) {
    write("poses.csv", "x,y,yaw_deg\n0,9,0\n");
    command_.quiet = false;
    EXPECT_EQ(run(), exit_done) << stderr_;
    EXPECT_THAT(stderr_, HasSubstr("  poses.csv; z, roll, pitch are 0\n"));
}

TEST_F(Run, PosesInAnotherUnitAreSuspected) {
    write("poses.csv", "x,y,z\n1125,0,0\n0,2000,0\n");
    command_.job.query.level = "count";
    EXPECT_EQ(run(), exit_done) << stderr_;
    EXPECT_THAT(
        stdout_,
        HasSubstr("no pose brings B within 1 119 m of A (A is 6.0 m long): are the poses in "
                  "mm? [poses] unit = \"mm\"\n"));
    command_.job.poses.unit = "mm";
    EXPECT_EQ(run(), exit_done) << stderr_;
    EXPECT_THAT(stdout_, testing::Not(HasSubstr("no pose brings")));
    write("poses.csv", "x,y,z\n0,0,9\n");
    command_.job.poses.unit = "";
    EXPECT_EQ(run(), exit_done) << stderr_;
    EXPECT_THAT(stdout_, HasSubstr("no pose brings B within 8.0 m of A (A is 6.0 m long)\n"));
    write("poses.csv", "x,y,z\n0,0,1.0625\n");
    EXPECT_EQ(run(), exit_done) << stderr_;
    EXPECT_THAT(stdout_, HasSubstr("no pose brings B within 0.062 m of A (A is 6.0 m long)\n"));
}

TEST_F(Run, EveryFirstStageHasTheSameDigest) {
    command_.job.query.level = "contacts";
    ASSERT_EQ(run(), exit_done);
    const auto usual = summary();
    command_.host.first_stage = PairStage::WideInteger;
    ASSERT_EQ(run(), exit_done);
    const auto exact = summary();
    EXPECT_EQ(exact["digest"], usual["digest"]);
    EXPECT_GT(usual["statistics"]["settled"]["float"], 0);
    EXPECT_EQ(exact["statistics"]["settled"]["float"], 0);
    EXPECT_EQ(exact["statistics"]["settled"]["double"], 0);
    EXPECT_EQ(exact["statistics"]["candidates"], usual["statistics"]["candidates"]);
}

TEST_F(Run, EverySimdTargetHasTheSameDigest) {
    command_.job.query.level = "contacts";
    ASSERT_EQ(run(), exit_done);
    const auto usual = summary();
    for (const SimdTarget target : available_simd_targets()) {
        command_.host.simd = to_text(target);
        ASSERT_EQ(run(), exit_done) << stderr_;
        EXPECT_EQ(simd_target(), target);
        const auto forced = summary();
        EXPECT_EQ(forced["digest"], usual["digest"]) << to_text(target);
    }
    ASSERT_TRUE(force_simd_target("auto"));
}

TEST_F(Run, ASimdTargetThatIsNotHereIsWrongUsage) {
    command_.host.simd = "abacus";
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("no SIMD target \"abacus\" on this host; there are auto"));
}

TEST_F(Run, PrecisionFloatRoundsOnceAndSaysSo) {
    write("b.obj", tetrahedron("post", 0.1, 1));
    command_.quiet = false;
    EXPECT_EQ(run(), exit_done) << stderr_;
    EXPECT_THAT(stderr_, Not(HasSubstr("rounded to floats")));
    EXPECT_THAT(read("out/summary.json"), HasSubstr("\"precision\": \"double\""));
    command_.job.precision = "float";
    command_.job.output.dir = (dir_ / "rounded").string();
    EXPECT_EQ(run(), exit_done) << stderr_;
    EXPECT_THAT(stderr_, HasSubstr("coordinates rounded to floats, as asked\n"));
    const auto summary = nlohmann::json::parse(read("rounded/summary.json"));
    for (const auto& body : summary["bodies"]) {
        EXPECT_EQ(body["precision"], "float");
        EXPECT_EQ(body["rounded"], true);
    }
}

TEST_F(Run, MapCoordinatesOfAFileKeepTheirMillimetres) {
    // In UTM metres a float's step is 0.5 m: one plate, and another 1 mm above it.
    const auto plate = [](const std::string& z) {
        return "v 500000.125 5400000.25 " + z + "\nv 500001.125 5400000.25 " + z +
               "\nv 500000.125 5400001.25 " + z + "\nf 1 2 3\n";
    };
    write("a.obj", plate("112.001"));
    write("b.obj", plate("112.000"));
    write("poses.csv", "z\n0\n0.001\n0.002\n");
    EXPECT_EQ(run(), exit_done) << stderr_;
    const std::string rows = read("out/scenarios.csv");
    EXPECT_THAT(rows, HasSubstr("\n0,a,b,separate,0,"));
    EXPECT_THAT(rows, HasSubstr("\n2,a,b,separate,0,"));
    EXPECT_THAT(read("out/summary.json"), HasSubstr("\"precision\": \"double\""));
}

TEST_F(Run, AFirstStageIsForThisMachineAlone) {
    command_.host.first_stage = PairStage::Double;
    command_.master.address = "127.0.0.1:1";
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("--first-stage"));
}

TEST_F(Run, APriorityIsForAMaster) {
    command_.master.priority = -1;
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("--priority is for jobs on a master: give --master"));
}

TEST_F(Run, IgnoredPartsAreNotInTheAnswer) {
    ignore("'wheel_*', 'post'");
    EXPECT_EQ(run(), exit_done) << stderr_;
    EXPECT_THAT(stdout_, HasSubstr("\n1,a,b,separate,0,"));
    EXPECT_THAT(stdout_, HasSubstr("\n2,a,b,cross,"));
}

TEST_F(Run, AnIgnoredNameThatMatchesNothingIsAnError) {
    ignore("'whel_left', 'post'");
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("job.toml:9: ignore: no part of A matches \"whel_left\""));
    EXPECT_THAT(stderr_, HasSubstr("did you mean \"wheel_left\"?"));
}

TEST_F(Run, AnIgnoredPartMayHaveItsBodyBeforeIt) {
    for (const char* pair :
         {"'car/wheel_*', 'b/post'", "'c*/wheel_*', 'post'", "'wheel_*', 'b/po*'"}) {
        ignore(pair, "car");
        EXPECT_EQ(run(), exit_done) << stderr_;
        EXPECT_THAT(stdout_, HasSubstr("\n1,car,b,separate,0,")) << pair;
    }
    ignore("'a/wheel_*', 'post'", "car");
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stderr_,
                HasSubstr("job.toml:9: ignore: \"a/wheel_*\" is of another body than A, which is "
                          "called \"car\""));
}

TEST_F(Run, ABackslashTakesTheMeaningOfTheNextCharacter) {
    write("a.obj", tetrahedron("left/wheel*", 0, 1) + tetrahedron("body", 5, 5));
    for (const char* pattern : {"left\\/wheel\\*", "a/left\\/wheel*", "a/left/wheel*"}) {
        ignore("'" + std::string(pattern) + "', 'post'");
        EXPECT_EQ(run(), exit_done) << stderr_;
    }
    ignore("'left/wheel*', 'post'");
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("a / within the name of a part is written \\/"));
    ignore("'left\\/wheel\\?', 'post'");
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("no part of A matches"));
}

TEST_F(Run, ADryRunWritesNothing) {
    command_.dry_run = true;
    command_.quiet = false;
    EXPECT_EQ(run(), exit_done);
    EXPECT_FALSE(fs::exists(dir_ / "out"));
    EXPECT_THAT(stdout_, testing::StartsWith("inputs are fine; about "));
    EXPECT_THAT(stdout_, HasSubstr("; nothing was run\n"));
    EXPECT_THAT(stderr_, testing::StartsWith("  here, 2 threads\n"));
    EXPECT_THAT(stderr_, HasSubstr("A  a.obj"));
    EXPECT_THAT(stderr_, HasSubstr("2 parts"));
}

namespace {

/// Returns a pose file of quaternions in all directions, whose numbers have all their digits.
std::string poses_all_around(int count) {
    std::ostringstream text;
    text.precision(17);
    text << "x,y,z,qx,qy,qz,qw\n";
    for (int i = 0; i < count; ++i) {
        const double turn = 2.4 * i;
        const double tilt = 0.7 * i;
        const double far = 3 * std::sqrt(static_cast<double>(i) / count);
        text << far * std::cos(turn) << "," << far * std::sin(turn) << "," << 0.3 * std::sin(tilt)
             << "," << std::sin(tilt) * std::cos(turn) << "," << std::sin(tilt) * std::sin(turn)
             << ",0," << std::cos(tilt) << "\n";
    }
    return text.str();
}

double bytes_below(const fs::path& folder) {
    double bytes = 0;
    for (const auto& file : fs::recursive_directory_iterator(folder)) {
        bytes += file.is_regular_file() ? static_cast<double>(file.file_size()) : 0;
    }
    return bytes;
}

} // namespace

/// Compares work instead of time, which a busy machine changes.
TEST_F(Run, ADryRunTellsWhatTheRunTakesWithinAFactorOfTwo) {
    write_obj((dir_ / "a.obj").string(), make_torus(1.5, 0.5, 60, 30));
    write("poses.csv", poses_all_around(3000));
    const std::vector<std::string> tables{"csv", "npz"};
    const std::vector<std::string> surfaces{"vtp", "glb"};
    for (const auto& [level, formats] : {std::pair("count", tables),
                                         std::pair("pairs", tables),
                                         std::pair("contacts", tables),
                                         std::pair("pairs", surfaces),
                                         std::pair("contacts", surfaces)}) {
        command_.job.query.level = level;
        command_.job.output.formats = formats;
        command_.dry_run = true;
        command_.output = "json";
        ASSERT_EQ(run(), exit_done) << stderr_;
        const auto told = nlohmann::json::parse(stdout_);
        EXPECT_EQ(told["scenarios"], 3000);
        EXPECT_EQ(told["sampled"], 200);
        EXPECT_GT(told["seconds"]["expected"], 0);
        EXPECT_LE(told["seconds"]["low"], told["seconds"]["high"]);
        EXPECT_TRUE(told["refused"].is_null());
        command_.dry_run = false;
        command_.output = "text";
        ASSERT_EQ(run(), exit_done) << stderr_;
        const auto ran = summary()["statistics"];
        const auto expect_about = [&](double estimated, double real, const char* what) {
            EXPECT_GT(estimated, real / 2) << what << " at level " << level << formats[0];
            EXPECT_LT(estimated, real * 2) << what << " at level " << level << formats[0];
        };
        expect_about(told["bytes"], bytes_below(dir_ / "out"), "bytes");
        expect_about(told["box_tests"], ran["box_tests"], "boxes");
        expect_about(told["triangle_tests"], ran["candidates"], "triangles");
    }
}

TEST_F(Run, ResultsThatNeedAWordAreRefusedWithoutIt) {
    write("poses.csv", poses_all_around(100));
    command_.job.output.dir = (dir_ / "new" / "out").string();
    command_.room.results_bytes_max = 2000;
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stderr_,
                testing::MatchesRegex("cdctl: .*/new/out: the run would take about .* s here "
                                      "\\(.*/s\\), 0.0 MB as csv,json, and .* are free; "
                                      ".*, or say --yes\n"));
    EXPECT_FALSE(fs::exists(dir_ / "new"));

    command_.dry_run = true;
    EXPECT_EQ(run(), exit_done);
    EXPECT_THAT(stdout_,
                HasSubstr("; nothing was run\n" + command_.job.output.dir + ": the run would"));
    command_.output = "json";
    EXPECT_EQ(run(), exit_done);
    EXPECT_THAT(nlohmann::json::parse(stdout_)["refused"].get<std::string>(), HasSubstr("--yes"));
    command_.output = "text";
    command_.dry_run = false;

    command_.room.yes = true;
    EXPECT_EQ(run(), exit_done) << stderr_;
    EXPECT_TRUE(fs::exists(dir_ / "new" / "out" / "summary.json"));
}

TEST_F(Run, AMasterInTheEnvironmentIsHintedAt) {
    ::setenv("CDCTL_MASTER", "node-1:7600", 1);
    command_.quiet = false;
    EXPECT_EQ(run(), exit_done);
    ::unsetenv("CDCTL_MASTER");
    EXPECT_THAT(
        stderr_,
        testing::StartsWith("  here, 2 threads; to run on CDCTL_MASTER: --master node-1:7600\n"));
}

TEST_F(Run, WhatItCostIsToldWhereItIsAskedFor) {
    EXPECT_EQ(run(), exit_done);
    EXPECT_THAT(stdout_, Not(HasSubstr("candidates")));
    command_.statistics = true;
    EXPECT_EQ(run(), exit_done);
    EXPECT_THAT(stdout_, HasSubstr(" candidates a scenario; settled in float "));
    EXPECT_THAT(stdout_, HasSubstr("  inside        looked at in "));
}

TEST_F(Run, RandomPosesNeedNoFile) {
    command_.job.poses.file.clear();
    command_.job.poses.random = 20;
    command_.job.poses.seed = 3;
    command_.output = "json";
    EXPECT_EQ(run(), exit_done) << stderr_;
    EXPECT_EQ(std::count(stdout_.begin(), stdout_.end(), '\n'), 20);
}

TEST_F(Run, AUnitIsAppliedToItsMesh) {
    command_.job.unit_b = "mm";
    command_.quiet = false;
    EXPECT_EQ(run(), exit_done);
    EXPECT_THAT(stderr_, HasSubstr("0.001 x 0.001 x 0.001 m"));
}

TEST_F(Run, MeshesWhoseSizesDifferAsUnitsDoAreWarnedAbout) {
    // A's box has a diagonal of sqrt(38).
    write("b.obj", "v 0 0 0\nv 6164 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(run(), exit_done);
    EXPECT_THAT(stderr_, HasSubstr("times as large as"));
    EXPECT_THAT(stderr_, HasSubstr("mm or m"));
    EXPECT_EQ(std::count(stderr_.begin(), stderr_.end(), '\n'), 1) << stderr_;
}

TEST_F(Run, WrongInputsAreOneLineThatNamesTheFile) {
    command_.job.a = (dir_ / "missing.obj").string();
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("missing.obj"));
    EXPECT_EQ(std::count(stderr_.begin(), stderr_.end(), '\n'), 1);
    EXPECT_FALSE(fs::exists(dir_ / "out"));
}

TEST_F(Run, KeptTreesGiveTheSameDigestAndNeverAnError) {
    const auto digest_at = [&](const std::string& tree_cache, const std::string& level) {
        command_.host.tree_cache = tree_cache;
        command_.job.query.level = level;
        EXPECT_EQ(run(), exit_done) << stderr_;
        return summary()["digest"];
    };
    const fs::path folder = dir_ / "trees";
    for (const char* level : {"any", "contacts"}) {
        const auto expected = digest_at("off", level);
        EXPECT_EQ(digest_at(folder.string(), level), expected) << "that makes them";
        EXPECT_EQ(digest_at(folder.string(), level), expected) << "that finds them";
        EXPECT_EQ(stderr_, "");
        std::size_t damaged = 0;
        for (const auto& entry : fs::directory_iterator(folder)) {
            fs::resize_file(entry.path(), entry.file_size() / 2);
            ++damaged;
        }
        EXPECT_EQ(digest_at(folder.string(), level), expected) << "that makes them again";
        EXPECT_EQ(std::count(stderr_.begin(), stderr_.end(), '\n'), std::ptrdiff_t(damaged));
        EXPECT_THAT(stderr_, HasSubstr("warning: a tree is built anew: "));
        EXPECT_EQ(digest_at(folder.string(), level), expected);
        EXPECT_EQ(stderr_, "");
        EXPECT_EQ(digest_at((dir_ / "a.obj").string(), level), expected) << "that is no folder";
        EXPECT_THAT(stderr_, HasSubstr("warning: a tree is not kept for later runs: "));
    }
}

TEST_F(Run, ExitCodesFollowTheSummary) {
    Summary summary;
    summary.total = 2;
    summary.separate = 1;
    EXPECT_EQ(exit_code_of(summary, FailOn()), exit_incomplete);
    summary.failed = 1;
    EXPECT_EQ(exit_code_of(summary, FailOn()), exit_incomplete);
    summary.failed = 0;
    summary.inside = 1;
    EXPECT_EQ(exit_code_of(summary, FailOn()), exit_done);
    EXPECT_EQ(exit_code_of(summary, {.cross = true}), exit_contacts);
}

} // namespace cd::tests
