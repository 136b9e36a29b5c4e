// Proves that the launch scripts of deploy/ start workers, on one host and under mpirun, that the
// result is an ordinary cluster, and that a signal to the script ends all of it cleanly.
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/support/comes_true.hpp"

#include <csignal>

namespace cd::tests {
namespace {

class Launch : public Cluster {
  protected:
    Process launch(const std::string& script, std::vector<std::string> arguments) {
        std::vector<std::string> command{"/usr/bin/env",
                                         "CDWORKER=" + program("cdworker").string(),
                                         // For Open MPI: a container's user is root.
                                         "OMPI_ALLOW_RUN_AS_ROOT=1",
                                         "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1",
                                         std::string(CD_SOURCE_DIR) + "/deploy/" + script};
        command.insert(command.end(), arguments.begin(), arguments.end());
        return {command, folder_ / script};
    }

    void wait_for_workers(std::size_t count) {
        ASSERT_TRUE(
            comes_true([&] { return connection_->status().value().workers.size() >= count; }));
    }

    void expect_the_digest_of_one_process() {
        const Job job = make_job(60);
        EXPECT_EQ(run(job, Query{}).digest, job.digest_in_one_process(Query{}));
    }
};

TEST_F(Launch, SeveralWorkersOnOneHost) {
    Process script = launch("workers", {"3", "--master", master_->address()});
    wait_for_workers(3);
    expect_the_digest_of_one_process();
    script.signal(SIGTERM);
    EXPECT_EQ(script.wait(), 0) << script.errors();
    EXPECT_TRUE(connection_->status().value().workers.empty());
}

TEST_F(Launch, WorkersUnderMpirun) {
    if (tests::run({"/usr/bin/env", "mpirun", "--version"}).exit_code != 0) {
        ASSERT_FALSE(skips_are_failures()) << "CI is set and mpirun is missing: openmpi-bin";
        GTEST_SKIP() << "no mpirun; install openmpi-bin";
    }
    Process script = launch("mpirun-workers", {"--master", master_->address(), "--", "-np", "2"});
    wait_for_workers(2);
    expect_the_digest_of_one_process();
    script.signal(SIGTERM);
    EXPECT_TRUE(script.wait().has_value()) << script.errors();
    // mpirun kills a worker that has not ended when another one has; the master then waits for it.
    EXPECT_TRUE(comes_true([&] { return connection_->status().value().workers.empty(); }));
}

TEST(LaunchScripts, SayHowTheyAreUsed) {
    const std::string folder = std::string(CD_SOURCE_DIR) + "/deploy/";
    for (const char* script : {"workers", "mpirun-workers"}) {
        const Ran helped = run({folder + script, "--help"});
        EXPECT_EQ(helped.exit_code, 0);
        EXPECT_NE(helped.output.find("--master"), std::string::npos);
        EXPECT_EQ(run({folder + script}).exit_code, 2);
    }
}

} // namespace
} // namespace cd::tests
