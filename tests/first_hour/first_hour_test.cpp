// Proves that a newcomer's first hour goes well: typing errors, wrong units and missing programs
// are answered by one line with a remedy. With CD_TRANSCRIPT set it prints all input and output
// (tests/first_hour/run).
#include "client/commands/commands.hpp"
#include "proto/identity/certificate.hpp"
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

    /// Returns the options for the meshes and a pose file.
    [[nodiscard]] std::vector<std::string> bodies(const std::string& poses) const {
        return {"--a", path("car.obj"), "--b", path("post.obj"), "--poses", path(poses)};
    }

    /// Runs cdctl; prints input and output if a transcript is wanted.
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
    EXPECT_THAT(dry.output,
                testing::MatchesRegex("inputs are fine; about [0-9.]+( to [0-9.]+)? s here "
                                      "\\([0-9.]+ ?[kM]?/s\\), [0-9.]+ MB; nothing was run\n"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
    const Ran ran = type({"run", "--threads", "2", "--out", path("out")}, bodies("poses.csv"));
    EXPECT_EQ(ran.exit_code, 0) << ran.errors;
    EXPECT_THAT(ran.errors, StartsWith("  here, 2 threads\n"));
    EXPECT_THAT(ran.errors, HasSubstr("poses.csv; z, roll, pitch are 0"));
    EXPECT_THAT(ran.output, HasSubstr("tested 3 of 3"));
}

TEST_F(FirstHour, AChangedPoseIsRunAloneAndAChangedMeshIsCompared) {
    const std::string old_run = path("old");
    ASSERT_EQ(type({"run", "--out", old_run}, bodies("poses.csv")).exit_code, 0);
    write_text(folder_ / "poses.csv", "x,y,yaw_deg\n2,0,0\n9,1,0\n9,0,0\n2,0.1,45\n");
    const Ran reused = type({"run", "--reuse", old_run, "--out", path("new")}, bodies("poses.csv"));
    EXPECT_EQ(reused.exit_code, 0) << reused.errors;
    EXPECT_THAT(reused.errors, HasSubstr("3 of 4 results are those of " + old_run + "\n"));
    EXPECT_THAT(reused.output, HasSubstr("\n  reused        3 of 4 results of an earlier run\n"));
    EXPECT_EQ(digest_of(reused), digest_of(type({"run"}, bodies("poses.csv"))));

    write_obj(folder_ / "post.obj", make_box({0.2, 0.2, 0.5}));
    const Ran other = type({"run", "--reuse", old_run}, bodies("poses.csv"));
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_EQ(other.output, "");
    EXPECT_THAT(other.errors, HasSubstr("cdctl: nothing can be reused: B changed ("));
    ASSERT_EQ(type({"run", "--out", path("newer")}, bodies("poses.csv")).exit_code, 0);
    const Ran changed = type({"diff", path("new"), path("newer")});
    EXPECT_EQ(changed.exit_code, 0) << changed.errors;
    EXPECT_THAT(changed.output, StartsWith("B changed ("));
    EXPECT_THAT(changed.output, HasSubstr("  scenarios     4 in both, matched by index\n"));
}

TEST_F(FirstHour, ARunIsReportedAndJudgedByAnEarlierOne) {
    const std::string old_run = path("released");
    write_text(folder_ / "free.csv", "x,y,yaw_deg\n9,0,0\n9,0,45\n");
    ASSERT_EQ(type({"run", "--out", old_run}, bodies("free.csv")).exit_code, 0);
    write_text(folder_ / "poses.csv", "x,y,yaw_deg\n2.8,0,0\n2.8,0.1,45\n9,0,0\n");
    const std::vector<std::string> judged{
        "run", "--out", path("out"), "--baseline", old_run, "--fail-on", "new"};
    const Ran news = type(judged, bodies("poses.csv"));
    EXPECT_EQ(news.exit_code, 1) << news.errors;
    EXPECT_THAT(news.output, HasSubstr("  baseline      " + old_run + ": new 1, active 0"));
    write_text(folder_ / "clashes.toml",
               "[[clash]]\na = \"*\"\nb = \"*\"\nstatus = \"approved\"\nnote = \"wanted\"\n");
    std::vector<std::string> approved = judged;
    approved.insert(approved.end(), {"--statuses", path("clashes.toml")});
    EXPECT_EQ(type(approved, bodies("poses.csv")).exit_code, 0) << "the folder has the run already";

    const Ran report = type({"report",
                             path("out"),
                             "-o",
                             path("report.html"),
                             "--baseline",
                             old_run,
                             "--statuses",
                             path("clashes.toml"),
                             "--fail-on",
                             "new"});
    EXPECT_EQ(report.exit_code, 0) << report.errors;
    EXPECT_EQ(report.output, path("report.html") + ", " + path("groups.csv") + "\n");
    const std::string page = read_text(folder_ / "report.html");
    EXPECT_THAT(page, HasSubstr("The bodies are in contact in 2 of 3 scenarios"));
    EXPECT_THAT(page, HasSubstr("<td>approved</td><td>wanted</td>"));
    EXPECT_THAT(page, testing::Not(HasSubstr("<script")));
    EXPECT_EQ(type({"report", path("out"), "-o", path("r.html"), "--fail-on", "new"}).errors,
              "cdctl: --fail-on new compares with an earlier run: give --baseline OLD\n");
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
    const Ran submit = type({"submit", "--master", "127.0.0.1:1"}, bodies("none.csv"));
    EXPECT_EQ(submit.exit_code, 4);
    EXPECT_EQ(submit.errors, none.errors);
    EXPECT_THAT(type({"status", "--master", "127.0.0.1:1"}).errors,
                testing::EndsWith("; is cdmaster running there?\n"));
}

TEST_F(FirstHour, AMistypedFolderIsSaidToBeMissing) {
    const std::vector<std::string> there{"--master", "127.0.0.1:1"};
    for (const std::vector<std::string>& words : {std::vector<std::string>{"results", "nosuch"},
                                                  {"verify", "nosuch"},
                                                  {"diff", "nosuch", "nosuch"},
                                                  {"report", "nosuch"},
                                                  {"extract", "nosuch", "0"}}) {
        const Ran none = type(words, there);
        EXPECT_EQ(none.exit_code, 4);
        EXPECT_EQ(none.errors,
                  "cdctl: there is no folder 'nosuch', so it was taken as a job of the master: "
                  "cannot connect to 127.0.0.1:1: Connection refused; is cdmaster running there? "
                  "--master names another one\n");
    }
    const MortalMaster master(folder_);
    const Ran unknown = type({"results", "nosuch", "--master", master.address()});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_EQ(unknown.errors,
              "cdctl: there is no folder 'nosuch', and the master has no job 'nosuch'; see `cdctl "
              "get jobs`\n");
}

TEST_F(FirstHour, AMissingFolderForTemporaryFilesIsNamed) {
    const std::string missing = path("missing");
    std::vector<std::string> dry_run{"run", "--dry-run", "--out", path("out")};
    const std::vector<std::string> inputs = bodies("poses.csv");
    dry_run.insert(dry_run.end(), inputs.begin(), inputs.end());
    for (const auto& words : {std::vector<std::string>{"extract", "last", "0"}, dry_run}) {
        std::vector<std::string> command{"/usr/bin/env", "TMPDIR=" + missing, cdctl()};
        command.insert(command.end(), words.begin(), words.end());
        const Ran ran = tests::run(command);
        EXPECT_EQ(ran.exit_code, 2);
        EXPECT_THAT(
            ran.errors,
            testing::EndsWith("cdctl: cannot create a folder in " + missing +
                              ": No such file or directory; set TMPDIR to another folder\n"));
    }
}

TEST_F(FirstHour, TheOtherPortOfAMasterIsRecognised) {
    const MortalMaster master(folder_, {"--http", "127.0.0.1:0"});
    std::smatch found;
    std::string log;
    ASSERT_TRUE(comes_true([&] {
        log = master.log();
        return std::regex_search(log, found, std::regex("http listening: host=.* port=([0-9]+)"));
    })) << log;
    const std::string http_port = "127.0.0.1:" + found[1].str();
    const Ran http = type({"status", "--master", http_port});
    EXPECT_EQ(http.exit_code, 5);
    EXPECT_EQ(http.errors,
              "cdctl: a web server answers: that is the master's --http port; give the port of its "
              "--listen, 7600 by default\n");
    const CertificateAuthority authority =
        CertificateAuthority::make(std::chrono::system_clock::now());
    const std::chrono::hours hour(1);
    const WallTime now = std::chrono::system_clock::now();
    ASSERT_TRUE(write_credential(
        folder_ / "me.pem", authority.issue({CertifiedRole::Admin, "me", now - hour, now + hour})));
    const Ran tls = type({"status", "--master", http_port, "--credential", path("me.pem")});
    EXPECT_EQ(tls.exit_code, 5);
    EXPECT_THAT(tls.errors, testing::EndsWith("; is that the master's --http port?\n"));
}

TEST_F(FirstHour, LargeResultsAreRefusedBeforeTheJobIsSubmitted) {
    const MortalMaster master(folder_);
    RunCommand command;
    command.job.a = path("car.obj");
    command.job.b = path("post.obj");
    command.job.poses.random = 100;
    command.job.output.dir = path("out");
    command.master.address = master.address();
    command.room.results_bytes_max = 1000;
    testing::internal::CaptureStderr();
    EXPECT_EQ(execute(command), 2);
    EXPECT_THAT(testing::internal::GetCapturedStderr(),
                testing::ContainsRegex("cdctl: .*/out: the run would take about .* s here "
                                       "\\(.*/s\\), .* MB as csv,npz, and .*or say --yes\n$"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
    EXPECT_EQ(type({"get", "jobs", "-o", "name", "--master", master.address()}).output, "");
}

TEST_F(FirstHour, ARunWithoutWorkersSaysSoAndGoesOnWhenOneComes) {
    const MortalMaster master(folder_);
    std::vector<std::string> words{cdctl(), "run", "--master", master.address()};
    const std::vector<std::string> inputs = bodies("poses.csv");
    words.insert(words.end(), inputs.begin(), inputs.end());
    Process run(words, folder_ / "run");
    EXPECT_TRUE(comes_true([&] {
        return run.errors().find("no worker is connected: start cdworker --master " +
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

TEST_F(FirstHour, FollowersOfAJobAreToldThatNoWorkerIsThere) {
    const MortalMaster master(folder_);
    const Ran submitted = type({"submit", "--master", master.address()}, bodies("poses.csv"));
    EXPECT_EQ(submitted.exit_code, 0) << submitted.errors;
    std::vector<std::vector<std::string>> commands;
    std::vector<std::unique_ptr<Process>> followers;
    for (const char* verb : {"watch", "wait"}) {
        commands.push_back({cdctl(), verb, "last", "--master", master.address()});
        followers.push_back(std::make_unique<Process>(commands.back(), folder_ / verb));
    }
    for (const auto& follower : followers) {
        EXPECT_TRUE(comes_true([&] {
            return follower->errors().find("  no worker is connected: start cdworker --master " +
                                           master.address()) != std::string::npos;
        })) << follower->errors();
    }
    const Process worker(
        {program("cdworker").string(), "--master", master.address(), "--threads", "1"},
        folder_ / "worker");
    for (std::size_t i = 0; i < followers.size(); ++i) {
        EXPECT_EQ(followers[i]->wait(), 0) << followers[i]->errors();
        commands[i].front() = "cdctl";
        print(commands[i], followers[i]->errors() + followers[i]->output(), 0);
    }
    EXPECT_THAT(followers[0]->output(), HasSubstr("tested 3 of 3"));
    EXPECT_EQ(followers[1]->output(), "") << "wait prints nothing but what is waited for";
    EXPECT_EQ(lines(followers[1]->errors()), 1u) << followers[1]->errors();
}

TEST_F(FirstHour, AJobIsRemoved) {
    const MortalMaster master(folder_);
    const Process worker(
        {program("cdworker").string(), "--master", master.address(), "--threads", "1"},
        folder_ / "worker");
    const std::vector<std::string> there{"--master", master.address()};
    EXPECT_EQ(type({"run", "-q", "--master", master.address()}, bodies("poses.csv")).exit_code, 0);
    EXPECT_THAT(type({"status"}, there).output, HasSubstr("on the master's disk: "));
    EXPECT_THAT(type({"get", "jobs"}, there).output,
                testing::ContainsRegex("OWNER +.*BEGAN.*\n.*@.* 20[0-9][0-9]-"));
    const Ran asked = type({"rm", "last"}, there);
    EXPECT_EQ(asked.exit_code, 2);
    EXPECT_THAT(asked.errors,
                testing::MatchesRegex("cdctl: job j-[0-9a-f]+ would be removed for good\n"
                                      "cdctl: nothing was removed; add --yes\n"));
    const Ran removed = type({"rm", "last", "--yes"}, there);
    EXPECT_EQ(removed.exit_code, 0) << removed.errors;
    EXPECT_THAT(removed.output, testing::MatchesRegex("job j-[0-9a-f]+ removed, .* freed\n"));
    const Ran gone = type({"results", "last", "--out", path("out")}, there);
    EXPECT_EQ(gone.exit_code, 2);
    EXPECT_THAT(gone.errors, HasSubstr("the master has no job of '"));
}

TEST_F(FirstHour, TheDemoRunsOnAClusterOfItsOwnAndEndsIt) {
    // Earlier versions kept the master's state here. The demo must not read it.
    const std::filesystem::path left = folder_ / "cache/cdcluster/demo-state";
    const std::filesystem::path temporary = folder_ / "temporary";
    std::filesystem::create_directories(left);
    std::filesystem::create_directories(temporary);
    write_text(left / "journal.db", "of another version");
    Process demo({"/usr/bin/env",
                  "XDG_CACHE_HOME=" + path("cache"),
                  "TMPDIR=" + temporary.string(),
                  cdctl(),
                  "demo",
                  "--scenarios",
                  "20",
                  "--out",
                  path("out")},
                 folder_ / "demo");
    EXPECT_EQ(demo.wait(std::chrono::seconds(60)), 0) << demo.errors();
    EXPECT_THAT(demo.errors(), HasSubstr("  cluster  cdmaster on 127.0.0.1:"));
    EXPECT_THAT(demo.errors(), testing::ContainsRegex("  A  truck.obj .* parts\n  B  car.obj"));
    EXPECT_THAT(demo.errors(), testing::ContainsRegex("\n  on 127.0.0.1:[0-9]+, 2 workers\n"));
    EXPECT_THAT(demo.output(), HasSubstr("tested 20 of 20"));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "out/summary.json"));
    EXPECT_TRUE(std::filesystem::is_empty(temporary));
    for (const char* log : {"master.log", "worker-1.log", "worker-2.log"}) {
        EXPECT_THAT(read_text(folder_ / "cache/cdcluster/demo-logs" / log), HasSubstr("ended: "));
    }
    print({"cdctl", "demo", "--scenarios", "20"}, demo.errors() + demo.output(), 0);
}

TEST_F(FirstHour, ControlCEndsARunAtOnce) {
    std::vector<std::string> words{
        cdctl(), "run", "--a", path("car.obj"), "--b", path("post.obj"), "--random", "100000000"};
    Process run(words, folder_ / "run");
    EXPECT_TRUE(comes_true([&] { return run.errors().find("  poses ") != std::string::npos; }));
    // Wait until the run has begun; before, the signal itself would end the process.
    EXPECT_TRUE(
        comes_true([&] { return run.errors().find("/100 000 000 ") != std::string::npos; }));
    run.signal(SIGINT);
    EXPECT_EQ(run.wait(), 130);
    EXPECT_THAT(
        run.errors(),
        testing::EndsWith("cdctl: interrupted; no results were kept, since there was no --out\n"));
    words.front() = "cdctl";
    print(words, run.errors(), 130);
}

TEST_F(FirstHour, AfterControlCTheSameCommandGoesOn) {
    std::vector<std::string> words{cdctl(), "run", "--threads", "1", "--random", "20000"};
    words.insert(words.end(),
                 {"--a", path("car.obj"), "--b", path("post.obj"), "--out", path("out")});
    Process run(words, folder_ / "run");
    const auto kept = folder_ / "out/.part/records";
    EXPECT_TRUE(comes_true([&] {
        std::error_code error;
        return std::filesystem::file_size(kept, error) > 1000 && !error;
    })) << run.errors();
    run.signal(SIGINT);
    EXPECT_EQ(run.wait(), 130) << run.errors();
    EXPECT_THAT(run.errors(),
                testing::ContainsRegex("cdctl: interrupted; [0-9 ]+ of 20 000 are kept in .*/out; "
                                       "the same command resumes the run\n$"));
    words.front() = "cdctl";
    print(words, run.errors(), 130);
    words.erase(words.begin());
    const Ran again = type(words);
    EXPECT_EQ(again.exit_code, 0) << again.errors;
    EXPECT_THAT(again.errors, testing::ContainsRegex("\nresumed at [0-9 ]+ of 20 000\n"));
    EXPECT_THAT(again.output, HasSubstr("tested 20 000 of 20 000"));
}

TEST_F(FirstHour, AFullDiskUnderStandardOutputIsNoticed) {
    const std::string to_full = " > /dev/full";
    const std::string run = cdctl() + " run -q --a " + path("car.obj") + " --b " +
                            path("post.obj") + " --poses " + path("poses.csv");
    for (const std::string& command :
         {cdctl() + " inspect " + path("car.obj"), run, run + " -o csv", run + " -o json"}) {
        const Ran full = tests::run({"/bin/sh", "-c", command + to_full});
        EXPECT_EQ(full.exit_code, 3) << command;
        EXPECT_EQ(lines(full.errors), 1u) << full.errors;
        EXPECT_THAT(full.errors, StartsWith("cdctl: standard output: "));
    }
}

} // namespace cd::tests
