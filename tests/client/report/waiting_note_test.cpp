// Proves that a delayed job names what it waits for, the worst first.
#include "client/report/waiting_note.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

namespace {

WorkerStatus worker(std::uint64_t id, WorkerState state, double silent_seconds = 0) {
    WorkerStatus status;
    status.worker = WorkerId{id};
    status.name = "node-" + std::to_string(id);
    status.state = state;
    status.silent_seconds = silent_seconds;
    return status;
}

struct Note : testing::Test {
    [[nodiscard]] WaitingNote note() const { return waiting_note(job, cluster, "node-1:7600"); }

    JobStatus job;
    ClusterStatus cluster;
};

} // namespace

TEST_F(Note, AJobThatGoesOnOrHasEndedNeedsNothing) {
    cluster.workers = {worker(1, WorkerState::Alive)};
    EXPECT_EQ(note().text, "");
    EXPECT_FALSE(note().stands_still);
    cluster.workers.clear();
    job.paused = "disk full";
    for (const JobState ended : {JobState::Done, JobState::Failed, JobState::Cancelled}) {
        job.state = ended;
        EXPECT_EQ(note().text, "");
    }
}

TEST_F(Note, APauseIsToldBeforeAllElse) {
    job.paused = "mesh 3f9c is damaged\n";
    EXPECT_EQ(note().text, "paused: mesh 3f9c is damaged\\n");
    EXPECT_TRUE(note().stands_still);
}

TEST_F(Note, WithoutWorkersItSaysHowToStartOne) {
    EXPECT_EQ(note().text, "no worker is connected: start cdworker --master node-1:7600");
    EXPECT_TRUE(note().stands_still);
    cluster.workers = {worker(1, WorkerState::Lost), worker(2, WorkerState::Lost)};
    EXPECT_EQ(note().text, "no worker is connected: start cdworker --master node-1:7600")
        << "those that are lost are not here";
}

TEST_F(Note, SilentWorkersAreNamed) {
    cluster.workers = {worker(1, WorkerState::Alive),
                       worker(2, WorkerState::Silent, 4.2),
                       worker(3, WorkerState::Silent, 2),
                       worker(4, WorkerState::Lost)};
    EXPECT_EQ(note().text, "silent: node-2 and 1 more, for 4 s; others get the work if that lasts");
    EXPECT_FALSE(note().stands_still);
}

TEST_F(Note, LostWorkersAreNamedWhileOthersGoOn) {
    cluster.workers = {worker(1, WorkerState::Lost), worker(2, WorkerState::Alive)};
    EXPECT_EQ(note().text, "lost: node-1; others do the work");
    EXPECT_FALSE(note().stands_still);
}

} // namespace cd::tests
