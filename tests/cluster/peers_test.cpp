// Proves that workers get geometry from each other without effect on the answer, and that workers
// fall back to the master if a peer is unreachable or sends nothing.
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/support/comes_true.hpp"

#include <csignal>

namespace cd::tests {
namespace {

/// Every scenario, and so every worker, needs nearly all of both bodies.
ClusterOptions everything_everywhere() {
    ClusterOptions options = many_blocks();
    options.strategy = "random";
    options.q = 4;
    return options;
}

struct Geometry {
    std::uint64_t from_master = 0;
    std::uint64_t from_peers = 0;
    std::uint64_t to_peers = 0;
};

Geometry geometry_of(const ClusterStatus& status) {
    Geometry bytes;
    for (const WorkerStatus& worker : status.workers) {
        bytes.from_master += worker.subtree_bytes_sent;
        bytes.from_peers += worker.cache.blocks.peer_bytes;
        bytes.to_peers += worker.cache.uploaded_bytes;
    }
    return bytes;
}

TEST_F(Cluster, GeometryTravelsBetweenWorkers) {
    const Job job = make_job(300);
    for (int i = 0; i < 3; ++i) {
        start_worker();
    }
    const JobStatus status = run(job, Query{}, everything_everywhere());
    ASSERT_EQ(status.state, JobState::Done);
    EXPECT_EQ(status.digest, job.digest_in_one_process(Query{}));
    // The final job status reports all bytes sent for it; the master learns of uploads with the
    // workers' next heartbeats.
    const BlockTraffic& blocks = status.traffic.blocks;
    Geometry bytes;
    EXPECT_TRUE(comes_true([&] {
        bytes = geometry_of(connection_->status().value());
        return bytes.to_peers == blocks.peer_bytes;
    })) << bytes.to_peers
        << " of " << blocks.peer_bytes;
    EXPECT_EQ(blocks.master_bytes, bytes.from_master);
    EXPECT_GT(bytes.from_peers, 0u);
    EXPECT_GT(bytes.to_peers, 0u);
    EXPECT_GT(bytes.from_master, 0u);
    EXPECT_GT(blocks.hits, 0u);
    EXPECT_GT(blocks.misses, 0u);
    EXPECT_EQ(blocks.evictions, 0u);
    EXPECT_GT(status.traffic.result_bytes, 0u);
}

TEST_F(Cluster, AWorkerThatHasServedPeersEndsWhenItHasDrained) {
    const Job job = make_job(300);
    for (int i = 0; i < 3; ++i) {
        start_worker();
    }
    ASSERT_EQ(run(job, Query{}, everything_everywhere()).state, JobState::Done);
    ASSERT_GT(geometry_of(connection_->status().value()).from_peers, 0u);
    for (const auto& worker : workers_) {
        worker->signal(SIGTERM);
        // Idle connections of other workers would keep it for a minute.
        EXPECT_EQ(worker->wait(std::chrono::seconds(30)), 0) << worker->errors();
    }
}

TEST_F(Cluster, HintsLetWorkersFetchBlocksAhead) {
    const Job job = make_job(300);
    start_worker();
    start_worker();
    ClusterOptions options = many_blocks();
    options.analysis = AnalysisMode::Always;
    for (const bool hints : {true, false}) {
        options.hints = hints;
        const JobStatus status = run(job, Query{}, options);
        EXPECT_EQ(status.digest, job.digest_in_one_process(Query{}));
        EXPECT_EQ(status.traffic.blocks.hinted != 0, hints);
    }
}

TEST_F(Cluster, WithoutPeersTheMasterGivesEverything) {
    const Job job = make_job(300);
    for (int i = 0; i < 3; ++i) {
        start_worker(1, {"--no-peers"});
    }
    const JobStatus status = run(job, Query{}, everything_everywhere());
    EXPECT_EQ(status.digest, job.digest_in_one_process(Query{}));
    const auto cluster = connection_->status();
    ASSERT_TRUE(cluster);
    EXPECT_EQ(geometry_of(cluster.value()).from_peers, 0u);
    EXPECT_EQ(status.traffic.blocks.peer_bytes, 0u);
}

TEST_F(Cluster, GeometryTenTimesTheCacheHasTheSameDigest) {
    const Job job = make_job(120);
    for (int i = 0; i < 2; ++i) {
        start_worker(1, {"--cache", "150KiB"});
    }
    const JobStatus status = run(job, Query{}, everything_everywhere());
    EXPECT_EQ(status.digest, job.digest_in_one_process(Query{}));
    const auto cluster = connection_->status();
    ASSERT_TRUE(cluster);
    for (const WorkerStatus& worker : cluster.value().workers) {
        EXPECT_GT(worker.cache.blocks.evictions, 0u);
    }
    EXPECT_GT(status.traffic.blocks.evictions, 0u);
    const std::uint64_t once =
        160 * (job.a->mesh().triangles().size() + job.b->mesh().triangles().size());
    EXPECT_GT(once, 10 * (150u << 10)) << "the cache is not small any more";
}

TEST_F(Cluster, AStoppedWorkerDoesNotKeepGeometryFromOthers) {
    const Job job = make_job(400);
    Process& first = start_worker();
    bool stopped = false;
    const JobId id = submit(job, Query{}, everything_everywhere());
    const JobStatus status = finish(id, [&](const JobStatus& now) {
        if (!stopped && now.summary.merged() > 40) {
            // The stopped worker holds all blocks, the master knows it, and it answers nobody.
            stopped = true;
            first.signal(SIGSTOP);
            start_worker();
            start_worker();
        }
    });
    first.signal(SIGCONT);
    ASSERT_TRUE(stopped);
    ASSERT_EQ(status.state, JobState::Done);
    EXPECT_EQ(status.digest, job.digest_in_one_process(Query{}));
}

} // namespace
} // namespace cd::tests
