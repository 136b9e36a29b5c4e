// A cluster with one worker behind a faulty network.
#pragma once

#include "tests/cluster/faulty_proxy.hpp"
#include "tests/cluster/mortal_master.hpp"
#include "tests/support/comes_true.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace cd::tests {

/// Seconds between heartbeats. A short time keeps the tests short; no result depends on it.
inline constexpr const char* quick_heartbeat = "0.05";

/// Workers have unlimited time to return: any repeated scenario is a defect.
class BrokenNetwork : public MortalCluster {
  protected:
    explicit BrokenNetwork(Links links = Links::Plain, const char* heartbeat = quick_heartbeat)
        : MortalCluster({"--heartbeat", heartbeat, "--lost-after", "600", "--return-within", "600"},
                        links) {}

    /// Starts a job with one worker behind the proxy.
    void start_job(std::uint64_t scenarios) {
        job_ = make_job(scenarios);
        start_worker_at(proxy_.address(), 2, {"--no-peers"});
        connection_ = connect();
        id_ = submit(*connection_, job_, Query{});
    }
    /// Waits until so many more scenarios are merged.
    void progress(std::uint64_t more) {
        done_ = watch_until(*connection_, id_, done_ + more).summary.merged();
    }

    template <class Condition>
    ClusterStatus status_when(Condition condition) {
        const auto deadline = std::chrono::steady_clock::now() + patience;
        for (;;) {
            const auto status = connection_->status();
            EXPECT_TRUE(status) << status.error().detail;
            if (!status || condition(status.value())) {
                return status ? status.value() : ClusterStatus{};
            }
            if (std::chrono::steady_clock::now() > deadline) {
                ADD_FAILURE() << "this did not come: " << master_.log();
                return status.value();
            }
        }
    }
    void wait_for_state(WorkerState state) {
        status_when([&](const ClusterStatus& status) {
            return std::any_of(status.workers.begin(),
                               status.workers.end(),
                               [&](const WorkerStatus& worker) { return worker.state == state; });
        });
    }

    /// Expects the right result, and that no scenario ran twice.
    void expect_right(bool nothing_again = true) {
        const JobStatus status = finish(*connection_, id_);
        EXPECT_EQ(status.state, JobState::Done) << status.failure;
        EXPECT_EQ(status.digest, job_.digest_in_one_process(Query{}));
        EXPECT_EQ(status.summary.failed, 0u);
        EXPECT_EQ(fetched(*connection_, status), job_.scenarios.size());
        const auto cluster = connection_->status();
        ASSERT_TRUE(cluster);
        EXPECT_EQ(cluster.value().alarm_count, 0u);
        std::printf("resumed %llu, lost %llu, scenarios given back %llu of %zu\n",
                    static_cast<unsigned long long>(cluster.value().losses.sessions_resumed),
                    static_cast<unsigned long long>(cluster.value().losses.workers_lost),
                    static_cast<unsigned long long>(cluster.value().losses.scenarios_given_back),
                    job_.scenarios.size());
        if (nothing_again) {
            EXPECT_EQ(cluster.value().losses.workers_lost, 0u);
            EXPECT_EQ(cluster.value().losses.scenarios_given_back, 0u);
        }
        if (HasFailure()) {
            std::printf("%s\n", master_.log().c_str());
        }
    }
    [[nodiscard]] std::uint64_t resumed() {
        const auto status = connection_->status();
        return status ? status.value().losses.sessions_resumed : 0;
    }

    FaultyProxy proxy_{master_.port(), "127.0.0.2"};
    Job job_;
    std::unique_ptr<Connection> connection_;
    JobId id_;
    std::uint64_t done_ = 0;
};

} // namespace cd::tests
