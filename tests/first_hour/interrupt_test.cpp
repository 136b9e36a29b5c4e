// Proves that one signal ends a run at once in every phase: waiting for an input, making poses, or
// running.
#include "tests/cluster/cdctl_runs.hpp"
#include "tests/support/comes_true.hpp"
#include "tests/support/shapes.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>

namespace cd::tests {

namespace {

using testing::HasSubstr;

/// Runs `cdctl run` on two spheres and stops it by one signal.
class Interrupt : public testing::Test {
  protected:
    Interrupt() { write_obj(folder_ / "ball.obj", make_sphere(3)); }

    [[nodiscard]] Process start(const std::vector<std::string>& more) const {
        std::vector<std::string> command{cdctl(), "run", "--tree-cache", "off"};
        command.insert(command.end(), more.begin(), more.end());
        return {command, folder_ / "run"};
    }

    [[nodiscard]] std::string fifo(const std::string& name) const {
        const std::string path = folder_ / name;
        EXPECT_EQ(::mkfifo(path.c_str(), 0600), 0);
        return path;
    }

    /// Returns when a process has opened the FIFO to read; nothing is ever written.
    static void wait_for_reader(const std::string& path) {
        EXPECT_TRUE(comes_true([&] {
            const int writer = ::open(path.c_str(), O_WRONLY | O_NONBLOCK);
            return writer >= 0;
        })) << path;
    }

    /// It takes half a second; the rest is for a busy machine.
    static void expect_end(Process& process, int signal) {
        process.signal(signal);
        EXPECT_EQ(process.wait(std::chrono::seconds(5)), 128 + signal) << process.errors();
        EXPECT_THAT(process.errors(), HasSubstr("cdctl: interrupted"));
    }

    std::string ball() const { return folder_ / "ball.obj"; }

    TemporaryFolder folder_;
};

} // namespace

TEST_F(Interrupt, EndsARunThatWaitsForPoses) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const std::string poses = fifo("poses" + std::to_string(signal) + ".csv");
        Process run = start({"--a", ball(), "--b", ball(), "--poses", poses});
        wait_for_reader(poses);
        expect_end(run, signal);
    }
}

TEST_F(Interrupt, WorkThatTakesLongIsTold) {
    const std::string other = fifo("other.csv");
    Process quiet({cdctl(), "run", "-q", "--a", ball(), "--b", ball(), "--poses", other},
                  folder_ / "quiet");
    wait_for_reader(other); // It reads for longer than `run`, which tells of it.
    const std::string poses = fifo("poses.csv");
    Process run = start({"--a", ball(), "--b", ball(), "--poses", poses});
    EXPECT_TRUE(comes_true([&] {
        return run.errors().find("reading poses.csv...\n") != std::string::npos;
    })) << run.errors();
    EXPECT_EQ(quiet.errors(), "");
}

TEST_F(Interrupt, EndsWhatOpensAFolderAgain) {
    write_text(folder_ / "poses.csv", "x\n0\n");
    const std::string out = folder_ / "out";
    Process run = start({"--a",
                         ball(),
                         "--b",
                         ball(),
                         "--poses",
                         folder_ / "poses.csv",
                         "--no-inputs",
                         "--out",
                         out});
    ASSERT_EQ(run.wait(), 0) << run.errors();
    std::filesystem::remove(folder_ / "poses.csv");
    const std::string poses = fifo("poses.csv");
    const std::vector<std::vector<std::string>> commands{
        {"run", out}, {"verify", out}, {"extract", out, "0", "--out", folder_ / "case"}};
    for (std::vector<std::string> command : commands) {
        SCOPED_TRACE(command.front());
        command.insert(command.begin(), cdctl());
        Process process(command, folder_ / "again");
        wait_for_reader(poses);
        expect_end(process, SIGINT);
    }
    EXPECT_FALSE(std::filesystem::exists(folder_ / "case"));
}

TEST_F(Interrupt, AFifoAsMeshIsRefused) {
    Process run = start({"--a", fifo("mesh.obj"), "--b", ball(), "--random", "10"});
    EXPECT_EQ(run.wait(), 2);
    EXPECT_THAT(run.errors(), HasSubstr("mesh.obj is no regular file"));
}

TEST_F(Interrupt, EndsARunOfRandomPosesOfAnyNumber) {
    Process run = start({"--a", ball(), "--b", ball(), "--random", "1000000000000"});
    ASSERT_TRUE(comes_true([&] { return run.errors().find("  poses ") != std::string::npos; }));
    expect_end(run, SIGTERM);
}

} // namespace cd::tests
