// A cluster of real processes on loopback, on a port chosen by the system, and a job for it.
#pragma once

#include "client/local/local_cluster.hpp"
#include "client/remote/connection.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/job/result/contact_map.hpp"
#include "common/job/run_scenario.hpp"
#include "common/tree/build/build.hpp"
#include "tests/support/parts.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cd::tests {

/// Two meshes, scenarios, and the result of one process.
struct Job {
    std::shared_ptr<const ObbTree> a;
    std::shared_ptr<const ObbTree> b;
    std::vector<Scenario> scenarios;

    [[nodiscard]] Sha256 digest_in_one_process(const Query& query) const {
        ResultMerger merger(scenarios.size());
        const ScenarioRunner runner(*a, *b, query);
        for (const Scenario& scenario : scenarios) {
            EXPECT_EQ(merger.add(runner.run(scenario).result), ResultMerger::Outcome::Added);
        }
        return merger.digest().value();
    }

    [[nodiscard]] ContactMap map_in_one_process(const Query& query) const {
        ContactMapSum sum(body_part_runs(a->mesh(), b->mesh()));
        const ScenarioRunner runner(*a, *b, query);
        for (const Scenario& scenario : scenarios) {
            const ScenarioRun run = runner.run(scenario);
            sum.add(run.result, run.found);
        }
        return sum.take();
    }
};

/// Puts B at random positions around A, apart or in contact. One pose of four is a matrix, the rest
/// quaternions; sometimes A is posed, too.
[[nodiscard]] inline std::vector<Scenario> mixed_scenarios(std::uint64_t count, double reach) {
    std::mt19937_64 random(11);
    std::vector<Scenario> scenarios(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        scenarios[i].index = i;
        scenarios[i].poses.b =
            i % 4 == 0 ? make_matrix_pose(random, reach) : make_pose(random, reach);
        if (i % 7 == 0) {
            scenarios[i].poses.a = make_pose(random, 0.2);
        }
    }
    return scenarios;
}

/// Makes a job whose first scenarios each outlast any test (some billions of triangle pairs to
/// test); the others take no time.
[[nodiscard]] inline Job make_long_job(std::uint64_t long_ones, std::uint64_t short_ones) {
    std::mt19937_64 random(3);
    ThreadPool pool(2);
    Job job;
    job.a = std::make_shared<const ObbTree>(
        build_tree(share(make_triangle_soup(random, 60000, 2)), {}, pool));
    job.b = job.a;
    job.scenarios.resize(long_ones + short_ones);
    for (std::uint64_t i = 0; i < job.scenarios.size(); ++i) {
        job.scenarios[i].index = i;
        job.scenarios[i].poses.b = translation_pose(i < long_ones ? 0 : 100, 0, 0);
    }
    return job;
}

/// Makes a job of a torus and a sphere in parts, both closed so that `inside` occurs.
[[nodiscard]] inline Job make_job(std::uint64_t count, double reach = 1.6) {
    ThreadPool pool(2);
    Job job;
    const auto torus = share(in_parts(make_torus(1, 0.4, 100, 40), 7));
    const auto sphere = share(in_parts(make_sphere(4), 3));
    job.a = std::make_shared<const ObbTree>(build_tree(torus, {}, pool));
    job.b = std::make_shared<const ObbTree>(build_tree(sphere, {}, pool));
    job.scenarios = mixed_scenarios(count, reach);
    return job;
}

/// Cuts small bodies into many blocks; otherwise each would be one block and placement untested.
[[nodiscard]] inline ClusterOptions many_blocks() {
    ClusterOptions options;
    options.depths = {12, 6};
    return options;
}

[[nodiscard]] inline std::unique_ptr<Connection> connect_to(const std::string& address,
                                                            std::shared_ptr<const Tls> tls) {
    auto opened = Connection::open(
        address, false, [] { return false; }, std::move(tls));
    EXPECT_TRUE(opened) << opened.error().detail;
    return opened ? std::move(opened.value()) : nullptr;
}

[[nodiscard]] inline std::vector<std::string>
worker_command(const std::string& address,
               const std::string& name,
               unsigned threads,
               const std::vector<std::string>& options) {
    std::vector<std::string> command{program("cdworker").string(),
                                     "--master",
                                     address,
                                     "--threads",
                                     std::to_string(threads),
                                     "--name",
                                     name};
    command.insert(command.end(), options.begin(), options.end());
    return command;
}

inline JobId submit_job(Connection& connection,
                        const Job& job,
                        const Query& query,
                        const ClusterOptions& options,
                        std::int32_t priority = 0) {
    const std::vector<NamedMesh> meshes{{"a", job.a->mesh_pointer()}, {"b", job.b->mesh_pointer()}};
    const Status uploaded = connection.upload(meshes, [](auto&&...) {});
    EXPECT_TRUE(uploaded) << uploaded.error().detail;
    Submit message;
    message.name = "test";
    message.priority = priority;
    message.bodies = {{job.a->mesh().hash()}, {job.b->mesh().hash()}};
    message.query = query;
    message.cluster = options;
    const auto poses = make_list_source(job.scenarios);
    const auto accepted = connection.submit(message, *poses);
    EXPECT_TRUE(accepted) << accepted.error().detail;
    return accepted ? accepted.value() : JobId{};
}

/// Waits for the job's end and returns its last status. Calls `changed` with every status.
inline JobStatus finish_job(
    Connection& connection,
    JobId job,
    const std::function<void(const JobStatus&)>& changed = [](const JobStatus&) {}) {
    const auto status = connection.watch(job, changed);
    EXPECT_TRUE(status) << status.error().detail;
    return status ? status.value() : JobStatus{};
}

class Cluster : public testing::Test {
  protected:
    void SetUp() override {
        prepare();
        const LocalClusterOptions options{
            program("cdmaster").parent_path(), folder_ / "state", folder_.path(), 0};
        auto started = LocalCluster::start(options, [] { return false; });
        ASSERT_TRUE(started) << started.error().detail;
        master_.emplace(std::move(started.value()));
        connection_ = connect();
    }

    void TearDown() override {
        if (HasFailure() && master_) {
            std::printf("%s\n", read_text(folder_ / "master.log").c_str());
        }
    }

    [[nodiscard]] std::unique_ptr<Connection> connect() const {
        return connect_to(master_->address(), tls());
    }

    virtual void prepare() {}
    /// TLS of the test's own connections; null is plain.
    [[nodiscard]] virtual std::shared_ptr<const Tls> tls() const { return nullptr; }

    /// Starts one more worker, which joins by itself.
    Process& start_worker(unsigned threads = 1, const std::vector<std::string>& options = {}) {
        const std::string name = "worker" + std::to_string(workers_.size());
        workers_.push_back(std::make_unique<Process>(
            worker_command(master_->address(), name, threads, options), folder_ / name));
        return *workers_.back();
    }

    JobId submit(const Job& job, const Query& query, const ClusterOptions& options) {
        return submit_job(*connection_, job, query, options);
    }

    JobStatus finish(JobId job, const std::function<void(const JobStatus&)>& changed) {
        return finish_job(*connection_, job, changed);
    }

    JobStatus
    run(const Job& job, const Query& query, const ClusterOptions& options = many_blocks()) {
        return finish(submit(job, query, options), [](const JobStatus&) {});
    }

    TemporaryFolder folder_;
    std::optional<LocalCluster> master_;
    std::unique_ptr<Connection> connection_;
    std::vector<std::unique_ptr<Process>> workers_;
};

} // namespace cd::tests
