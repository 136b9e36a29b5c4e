// Proves that `cdctl run` answers jobs of motions, and that inputs without a motion end it with one
// line that names the place, and with exit code 2.
#include "client/base/exit_code.hpp"
#include "client/commands/commands.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace cd::tests {

namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string motion = "[motion]\nresolution = 0.01\n";

class MotionCommand : public testing::Test {
  protected:
    MotionCommand() {
        for (const std::string name : {"a.obj", "b.obj"}) {
            write_text(dir_ / name,
                       "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
        }
    }

    /// Runs a job with the text after its bodies; `keys` is the content of keys.csv. The table
    /// [poses] begins in line 5.
    int run(const std::string& text, const std::string& keys = "") {
        write_text(dir_ / "keys.csv", keys);
        write_text(dir_ / "job.toml",
                   "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\n" + text);
        RunCommand command;
        command.job.file = (dir_ / "job.toml").string();
        command.job.output.dir = (dir_ / "out").string();
        command.job.output.formats = {"csv"};
        command.folder.overwrite = true;
        command.folder.fresh = true;
        command.host.threads = 1;
        command.quiet = true;
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        const int code = execute(command);
        stdout_ = testing::internal::GetCapturedStdout();
        stderr_ = testing::internal::GetCapturedStderr();
        return code;
    }

    /// Expects that a job is refused with one line that begins with the name of a file in the
    /// folder and what follows it.
    void expect_refused(const std::string& text, const std::string& keys, const std::string& line) {
        EXPECT_EQ(run(text, keys), exit_usage) << text << keys;
        EXPECT_THAT(stderr_, StartsWith("cdctl: " + dir_.string() + "/" + line));
        EXPECT_EQ(std::ranges::count(stderr_, '\n'), 1) << stderr_;
        EXPECT_THAT(stderr_, EndsWith("\n"));
    }

    const TemporaryFolder folder_;
    const std::filesystem::path dir_ = folder_.path();
    std::string stdout_;
    std::string stderr_;
};

const std::string file = "file = \"keys.csv\"\n" + motion;

} // namespace

TEST_F(MotionCommand, AnswersEachMotionWithItsTimes) {
    EXPECT_EQ(run(file, "t,x,y\n10,3,0\n11,3,2\n15,0.1,0.1\n"), exit_done) << stderr_;
    const std::string rows = read_text(dir_ / "out/scenarios.csv");
    EXPECT_THAT(rows, HasSubstr("\n0,a,b,separate,"));
    EXPECT_THAT(rows, HasSubstr(",contact,1"));
    EXPECT_THAT(stderr_, HasSubstr("note: keys of motions are rounded to a grid"));
}

TEST_F(MotionCommand, AMotionThatEndsAtItsLimitHasNoBound) {
    // The apex of B slides along the lowest face of A, 1e-7 below it.
    const std::string keys = "x,y,z\n-5,0.1,-1.0000001\n5,0.1,-1.0000001\n";
    EXPECT_EQ(run("file = \"keys.csv\"\n[motion]\nresolution = 1e-5\n", keys), exit_done);
    EXPECT_THAT(stdout_, HasSubstr("or more keys where a motion ends at its limit of parts"));
    const std::string limited = read_text(dir_ / "out/scenarios.csv");
    EXPECT_THAT(limited, HasSubstr("\n0,a,b,undecided,0,limit,0."));
    EXPECT_THAT(limited, HasSubstr(",0,inf,"));
    // A larger resolution reaches the end, with a bound.
    EXPECT_EQ(run("file = \"keys.csv\"\n[motion]\nresolution = 1e-2\n", keys), exit_done);
    EXPECT_THAT(read_text(dir_ / "out/scenarios.csv"),
                HasSubstr("\n0,a,b,undecided,0,free,,,0,0.0"));
}

TEST_F(MotionCommand, NearnessIsThatOfTheKeysAlone) {
    // Between its keys, B passes through A; the way out is free from the begin.
    EXPECT_EQ(run(file + "until = \"free\"\n", "x\n-3\n3\n"), exit_done) << stderr_;
    EXPECT_THAT(stdout_, HasSubstr("no key of a motion brings B within 2.0 m of A"));
}

TEST_F(MotionCommand, VelocitiesBendThePathBetweenTwoRows) {
    // B is thrown over A and lands as far behind it as it started before it.
    const std::string thrown =
        "t,x,z,vx,vy,vz,ax,ay,az\n0,-3,0,6,0,5,0,0,-10\n1,3,0,6,0,-5,0,0,-10\n";
    const std::string chord = file + "chord = 0.01\n";
    EXPECT_EQ(run(chord, thrown), exit_done) << stderr_;
    EXPECT_THAT(stderr_, HasSubstr(" keys of the curve, within 0.01 m, by which the clearance"));
    EXPECT_THAT(read_text(dir_ / "out/scenarios.csv"), Not(HasSubstr("contact")));
    // A motion straight from row to row passes through A.
    EXPECT_EQ(run(file, "t,x,z\n0,-3,0\n1,3,0\n"), exit_done) << stderr_;
    EXPECT_THAT(read_text(dir_ / "out/scenarios.csv"), HasSubstr(",contact,"));
    // Poses can be inserted on the curve as well.
    EXPECT_EQ(run("file = \"keys.csv\"\nmax_step = 0.5\n", thrown), exit_done) << stderr_;
    EXPECT_THAT(read_text(dir_ / "out/scenarios.csv"), Not(HasSubstr("touch")));
    EXPECT_EQ(run("file = \"keys.csv\"\n", thrown), exit_done);
    EXPECT_THAT(stderr_, HasSubstr("keys.csv: its velocities count with [motion] or max_step"));
}

TEST_F(MotionCommand, VelocitiesThatMissTheNextRowAreRefusedByItsLine) {
    expect_refused(
        file + "chord = 0.01\n",
        "t,x,z,vx,vy,vz\n0,-3,0,6,0,5\n1,3,0,6,0,-5\n",
        "keys.csv: line 3: the velocities of the row before miss this pose by up to 5, ");
    expect_refused(file + "chord = 0.01\n",
                   "x,z\n-3,0\n3,0\n",
                   "job.toml:9: [motion]: chord is for line, arc, screw and drive");
    expect_refused(file,
                   "t,x,vx,vy,vz\n1,-3,6,0,0\n1,3,6,0,0\n",
                   "keys.csv: line 3: the time 1 is not after 1 of line 2");
    // Errors of keys name the row from which their curve starts.
    expect_refused(file,
                   "x,vx,vy,vz\n0,3e6,0,0\n3e6,0,0,0\n",
                   "keys.csv: line 3: the bodies move too far between two keys");
}

TEST_F(MotionCommand, KeysWithoutAMotionAreRefusedByTheirLine) {
    expect_refused(file, "x\n1\n", "keys.csv: there is one pose alone");
    expect_refused(file,
                   "# in metres\n\nx,yaw_deg\n3,0\n3,90\n3,-90\n",
                   "keys.csv: line 6: two keys of a motion are turned by 180 degrees");
    expect_refused(
        file, "t,x\n0,3\n1,2\n\n1,0\n", "keys.csv: line 5: the time 1 is not after 1 of line 3");
    expect_refused("of = \"both\"\n" + file,
                   "scenario,body,x,yaw_deg\n1,b,3,0\n0,b,3,0\n0,a,0,0\n1,a,0,180\n",
                   "keys.csv: lines 5 and 2: two keys of a motion are turned by 180 degrees");
    expect_refused("rigid_tolerance = 10\n" + file,
                   "m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23\n1,0,0,3,0,1,0,0,0,0,1,0\n"
                   "2,0,0,3,0,2,0,0,0,0,2,0\n",
                   "keys.csv: line 3: the matrix of a key is no rotation");
    expect_refused(
        file, "x\n3000000\n0\n", "keys.csv: line 3: the bodies move too far between two keys");
}

TEST_F(MotionCommand, WrongNumbersAreRefusedByTheirLineInTheJob) {
    const std::string keys = "x\n3\n0\n";
    expect_refused("file = \"keys.csv\"\n[motion]\nuntil = \"end\"\n",
                   keys,
                   "job.toml:7: [motion]: resolution is missing");
    expect_refused("file = \"keys.csv\"\n[motion]\nresolution = 0\n",
                   keys,
                   "job.toml:8: [motion]: resolution is a length above 0");
    expect_refused(file + "[query]\nlevel = \"contacts\"\n",
                   keys,
                   "job.toml:10: [query]: motions of [motion] are asked at level any or pairs");
    const std::string line = "line = { from = [3.3, 0, 0], to = [0, 0, 0] }\n";
    expect_refused(line + motion + "chord = 0\n", keys, "job.toml:9: [motion]: chord is a length");
    expect_refused(line + motion + "chord = 3e-12\n",
                   keys,
                   "job.toml:9: [motion]: chord = 3e-12 is too small");
    expect_refused("file = \"keys.csv\"\nmax_step = -1\n", keys, "job.toml:7: ");
}

} // namespace cd::tests
