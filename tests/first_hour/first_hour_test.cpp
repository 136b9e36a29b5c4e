// Proves that the first hour of a stranger goes well: what is typed wrong, given in a wrong unit or
// run with nobody there is answered by one line that names the way out. With CD_TRANSCRIPT set it
// prints all that was typed and answered (tests/first_hour/run).
#include "tests/cluster/cdctl_runs.hpp"
#include "tests/cluster/mortal_master.hpp"
#include "tests/support/comes_true.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>

#include <csignal>
#include <cstdlib>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::StartsWith;

class FirstHour : public testing::Test {
  protected:
    FirstHour() {
        write_obj(folder_ / "car.obj", make_torus(2, 0.8, 60, 30));
        write_obj(folder_ / "post.obj", make_box({0.2, 0.2, 1}));
        write_text(folder_ / "poses.csv", "x,y,yaw_deg\n2,0,0\n2,0.1,45\n9,0,0\n");
    }

    [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name; }

    /// The meshes and a pose file, as options.
    [[nodiscard]] std::vector<std::string> bodies(const std::string& poses) const {
        return {"--a", path("car.obj"), "--b", path("post.obj"), "--poses", path(poses)};
    }

    /// Runs cdctl, and prints what was typed and answered where that is wanted.
    [[nodiscard]] Ran type(std::vector<std::string> words,
                           const std::vector<std::string>& more = {}) const {
        words.insert(words.end(), more.begin(), more.end());
        words.insert(words.begin(), cdctl());
        const Ran ran = tests::run(words);
        words.front() = "cdctl";
        print(words, ran.errors + ran.output, ran.exit_code);
        return ran;
    }

    void print(const std::vector<std::string>& words, std::string text, int exit_code) const {
        if (std::getenv("CD_TRANSCRIPT") == nullptr) {
            return;
        }
        std::string line = "$";
        for (const std::string& word : words) {
            line += " " + word;
        }
        text = line + "\n" + text + "(exit code " + std::to_string(exit_code) + ")\n\n";
        const std::string folder = folder_.path().string() + "/";
        for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder)) {
            text.erase(at, folder.size());
        }
        std::fputs(text.c_str(), stdout);
    }

    static std::size_t lines(const std::string& text) {
        return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    }

    TemporaryFolder folder_;
};

} // namespace

TEST_F(FirstHour, AWordThatIsMistypedIsAnsweredWithTheRightOne) {
    EXPECT_EQ(lines(type({}).errors), 10u);
    EXPECT_EQ(type({"rnu", "job.toml"}).errors, "cdctl: no verb 'rnu'; did you mean 'run'?\n");
    const Ran option = type({"run", "--a", path("car.obj"), "--pose", path("poses.csv")});
    EXPECT_EQ(option.exit_code, 2);
    EXPECT_EQ(option.errors, "cdctl: no option '--pose' of `cdctl run`; did you mean '--poses'?\n");
    EXPECT_THAT(type({"--version"}).output, HasSubstr("\n  commit "));
}

TEST_F(FirstHour, MeshesAreInspectedAndCadFilesNamed) {
    EXPECT_THAT(type({"inspect", path("car.obj")}).output, HasSubstr("closed"));
    write_text(folder_ / "part.step", "ISO-10303-21;\nHEADER;\n");
    const Ran cad = type({"inspect", path("part.step")});
    EXPECT_EQ(cad.exit_code, 2);
    EXPECT_THAT(cad.errors, HasSubstr("part.step: is a CAD model (STEP)"));
    EXPECT_EQ(lines(cad.errors), 1u);
    write_text(folder_ / "car.zip", "PK");
    EXPECT_THAT(type({"inspect", path("car.zip")}).errors, HasSubstr("unpack it"));
}

TEST_F(FirstHour, ADryRunTellsTimeAndSizeAndARunWhereItIs) {
    const Ran dry = type({"run", "--dry-run", "--out", path("out")}, bodies("poses.csv"));
    EXPECT_EQ(dry.exit_code, 0) << dry.errors;
    EXPECT_THAT(dry.output, StartsWith("inputs are fine; about "));
    EXPECT_THAT(dry.output, testing::EndsWith(" MB; nothing was run\n"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
    const Ran ran = type({"run", "--threads", "2", "--out", path("out")}, bodies("poses.csv"));
    EXPECT_EQ(ran.exit_code, 0) << ran.errors;
    EXPECT_THAT(ran.errors, StartsWith("  here, 2 threads\n"));
    EXPECT_THAT(ran.errors, HasSubstr("poses.csv; z, roll, pitch are 0"));
    EXPECT_THAT(ran.output, HasSubstr("tested 3 of 3"));
}

TEST_F(FirstHour, AWrongUnitIsSuspected) {
    write_text(folder_ / "yaw.csv", "x,y,z,roll,pitch,yaw\n0,0,0,0,0,1\n");
    EXPECT_THAT(type({"run"}, bodies("yaw.csv")).errors,
                HasSubstr("yaw.csv: line 1: column 'roll' does not say its unit: name it roll_deg "
                          "or roll_rad"));
    write_text(folder_ / "mm.csv", "x,y\n2000,0\n2000,100\n");
    const Ran far = type({"run"}, bodies("mm.csv"));
    EXPECT_EQ(far.exit_code, 0);
    EXPECT_THAT(far.output, HasSubstr("are the poses in mm? [poses] unit = \"mm\"\n"));
    const Ran near = type({"run", "--poses-unit", "mm"}, bodies("mm.csv"));
    EXPECT_THAT(near.output, HasSubstr("separate  0 "));
}

TEST_F(FirstHour, NoMasterIsSaidBeforeInputsAreRead) {
    const Ran none = type({"run", "--master", "127.0.0.1:1"}, bodies("none.csv"));
    EXPECT_EQ(none.exit_code, 4);
    EXPECT_EQ(none.errors,
              "cdctl: cannot connect to 127.0.0.1:1: Connection refused; is cdmaster running "
              "there? without --master the job runs here\n");
    EXPECT_THAT(type({"status", "--master", "127.0.0.1:1"}).errors,
                testing::EndsWith("; is cdmaster running there?\n"));
}

TEST_F(FirstHour, ARunWithoutWorkersSaysSoAndGoesOnWhenOneComes) {
    const MortalMaster master(folder_);
    std::vector<std::string> words{cdctl(), "run", "--master", master.address()};
    const std::vector<std::string> inputs = bodies("poses.csv");
    words.insert(words.end(), inputs.begin(), inputs.end());
    Process run(words, folder_ / "run");
    EXPECT_TRUE(comes_true([&] {
        return run.errors().find("no worker is here: start cdworker --master " +
                                 master.address()) != std::string::npos;
    })) << run.errors();
    Process worker({program("cdworker").string(), "--master", master.address(), "--threads", "1"},
                   folder_ / "worker");
    const auto code = run.wait();
    EXPECT_EQ(code, 0) << run.errors();
    EXPECT_THAT(run.errors(), StartsWith("  on " + master.address() + ", 0 workers\n"));
    EXPECT_THAT(run.output(), HasSubstr("tested 3 of 3"));
    words.front() = "cdctl";
    print(words, run.errors() + run.output(), code.value_or(-1));
}

TEST_F(FirstHour, ControlCEndsARunAtOnce) {
    std::vector<std::string> words{
        cdctl(), "run", "--a", path("car.obj"), "--b", path("post.obj"), "--random", "100000000"};
    Process run(words, folder_ / "run");
    EXPECT_TRUE(comes_true([&] { return run.errors().find("  poses ") != std::string::npos; }));
    run.signal(SIGINT);
    EXPECT_EQ(run.wait(), 130);
    words.front() = "cdctl";
    print(words, run.errors(), 130);
}

TEST_F(FirstHour, AFullDiskUnderStandardOutputIsNoticed) {
    const std::string to_full = " > /dev/full";
    const std::string run = cdctl() + " run -q --a " + path("car.obj") + " --b " +
                            path("post.obj") + " --poses " + path("poses.csv");
    for (const std::string& command : {cdctl() + " inspect " + path("car.obj"), run}) {
        const Ran full = tests::run({"/bin/sh", "-c", command + to_full});
        EXPECT_EQ(full.exit_code, 3) << command;
        EXPECT_EQ(lines(full.errors), 1u) << full.errors;
        EXPECT_THAT(full.errors, StartsWith("cdctl: standard output: "));
    }
}

} // namespace cd::tests
