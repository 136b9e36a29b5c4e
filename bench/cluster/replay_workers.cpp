// Measures the master with replaying workers. Each speaks the real protocol over its own connection
// and answers with a job's true records, found in advance; a task takes as long as finding them
// took, or no time. Prints first the job's digest by these records: the master must arrive at it
// too. See README.md.
//
//   replay_workers JOB --master 127.0.0.1:7600 [--workers 64] [--no-waits]
#include "client/job/prepared_job.hpp"
#include "client/spec/job_file.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/limits/worker.hpp"
#include "common/core/timing/wire.hpp"
#include "common/job/packed_scenarios.hpp"
#include "common/job/result/merge.hpp"
#include "common/job/result/packed_records.hpp"
#include "common/job/run_scenario.hpp"
#include "common/job/settle.hpp"
#include "proto/channel/channel.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

namespace cd::bench {

namespace {

struct Options {
    std::string job;
    std::string master;
    unsigned workers = 64;
    bool waits = true;
};

/// Every scenario's record from a worker's search, and the time it took.
struct Recorded {
    std::vector<Bytes> records;
    std::vector<float> seconds;
    Sha256 digest; ///< The job's digest as computed in one process.
};

Result<Recorded> record(const PreparedJob& job, ThreadPool& pool) {
    const std::uint64_t count = job.poses->count();
    const auto scenarios = job.poses->read(0, count);
    if (!scenarios) {
        return scenarios.error();
    }
    Recorded recorded{std::vector<Bytes>(count), std::vector<float>(count), {}};
    std::vector<Sha256> digests(count);
    std::vector<ScenarioFacts> facts(count);
    const SubtreePair whole{job.trees[0]->view(), job.trees[1]->view()};
    const Settler settler(*job.trees[0], *job.trees[1], job.query.ignored);
    parallel_for(pool, count, [&](std::size_t i) {
        const auto begin = std::chrono::steady_clock::now();
        ScenarioRun run = run_on_subtrees({&whole, 1}, scenarios.value()[i], job.query);
        recorded.records[i] = encode_result(run.result);
        recorded.seconds[i] =
            std::chrono::duration<float>(std::chrono::steady_clock::now() - begin).count();
        // The master does the remaining steps.
        settler.settle(scenarios.value()[i], run.result);
        digests[i] = digest_of(run.result);
        facts[i] = facts_of(run.result);
    });
    ResultMerger merger(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        (void)merger.add(i, facts[i], digests[i]);
    }
    recorded.digest = merger.digest().value();
    return recorded;
}

class ReplayWorker {
  public:
    ReplayWorker(asio::any_io_executor executor, const Recorded& recorded, const Options& options)
        : executor_(std::move(executor)), recorded_(recorded), options_(options) {}

    asio::awaitable<void> run(Endpoint master, std::string name) {
        const auto connected = co_await connect(master);
        if (!connected) {
            std::fprintf(stderr, "%s\n", connected.error().detail.c_str());
            co_return;
        }
        channel_ = connected.value();
        Hello hello;
        hello.role = Role::Worker;
        hello.name = name;
        hello.build = "replay";
        hello.threads = 1;
        const auto welcome = co_await greet(channel_, hello);
        if (!welcome) {
            std::fprintf(stderr, "%s\n", welcome.error().detail.c_str());
            co_return;
        }
        spawn(executor_, "heartbeats", send_heartbeats());
        for (;;) {
            const Result<Message> message = co_await channel_->receive(timing::peer_lost_after);
            if (!message) {
                co_return;
            }
            if (const auto* unit = std::get_if<WorkUnit>(&message.value())) {
                // Has a name because GCC 12 destroys temporaries in such a call twice.
                const std::vector<std::uint64_t> indices = indices_of(*unit);
                co_await answer(unit->task, unit->job, indices);
            }
        }
    }

  private:
    static std::vector<std::uint64_t> indices_of(const Bytes& packed) {
        const Result<std::vector<Scenario>> scenarios =
            unpack_scenarios(packed, limits::scenarios_max);
        std::vector<std::uint64_t> indices;
        for (const Scenario& scenario : scenarios.value()) {
            indices.push_back(scenario.index);
        }
        return indices;
    }
    static std::vector<std::uint64_t> indices_of(const WorkUnit& range) {
        if (!range.scenarios.empty()) {
            return indices_of(range.scenarios);
        }
        std::vector<std::uint64_t> indices(range.count);
        std::iota(indices.begin(), indices.end(), range.first);
        return indices;
    }

    asio::awaitable<void>
    answer(TaskId task, JobId job, const std::vector<std::uint64_t>& indices) {
        std::span<const std::uint64_t> left(indices);
        while (!left.empty()) {
            Results results;
            results.task = task;
            results.job = job;
            Bytes records;
            while (!left.empty() && records.size() < limits::results_flush_bytes) {
                const Bytes& one = recorded_.records[left.front()];
                const auto size = static_cast<std::uint32_t>(one.size());
                const auto size_bytes = std::as_bytes(std::span(&size, 1));
                records.insert(records.end(), size_bytes.begin(), size_bytes.end());
                records.insert(records.end(), one.begin(), one.end());
                results.compute_seconds += recorded_.seconds[left.front()];
                ++results.count;
                left = left.subspan(1);
            }
            if (options_.waits) {
                asio::steady_timer timer(executor_);
                timer.expires_after(std::chrono::duration_cast<std::chrono::nanoseconds>(
                    std::chrono::duration<double>(results.compute_seconds)));
                boost::system::error_code ignored;
                co_await timer.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
            }
            results.records = pack_records(records);
            channel_->send(results);
            co_await channel_->wait_until_queued_below(limits::write_queue_bytes_max);
        }
        channel_->send(EndOfTask{task});
    }

    asio::awaitable<void> send_heartbeats() {
        asio::steady_timer timer(executor_);
        while (channel_->is_open()) {
            channel_->send(Heartbeat{});
            timer.expires_after(timing::heartbeat_period);
            boost::system::error_code ignored;
            co_await timer.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
        }
    }

    asio::any_io_executor executor_;
    const Recorded& recorded_;
    const Options& options_;
    std::shared_ptr<Channel> channel_;
};

Status run(const Options& options) {
    auto spec = read_job_file(options.job);
    if (!spec) {
        return spec.error();
    }
    ThreadPool pool(0);
    TreeCache cache("", 0);
    auto job = prepare_job(std::move(spec.value()), Trees::Always, cache, pool);
    if (!job) {
        return job.error();
    }
    const auto recorded = record(job.value(), pool);
    if (!recorded) {
        return recorded.error();
    }
    const auto endpoint = parse_endpoint(options.master);
    if (!endpoint) {
        return endpoint.error();
    }
    asio::io_context context(1);
    std::vector<std::unique_ptr<ReplayWorker>> workers;
    for (unsigned i = 0; i < options.workers; ++i) {
        workers.push_back(
            std::make_unique<ReplayWorker>(context.get_executor(), recorded.value(), options));
        spawn(context.get_executor(),
              "worker",
              workers.back()->run(endpoint.value(), "replay-" + std::to_string(i)));
    }
    std::printf("digest %s\n", to_hex(recorded.value().digest).c_str());
    std::puts("ready");
    std::fflush(stdout);
    context.run();
    return Done{};
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    cd::bench::Options options;
    CLI::App app("Workers that answer a job's scenarios with what was found before");
    app.add_option("JOB", options.job, "The job file")->required();
    app.add_option("--master", options.master, "Where to connect")->required();
    app.add_option("--workers", options.workers, "Connections")->check(CLI::PositiveNumber);
    app.add_flag("!--no-waits", options.waits, "Answer at once");
    CLI11_PARSE(app, argc, argv);
    const cd::Status status = cd::bench::run(options);
    if (!status) {
        std::fprintf(stderr, "%s\n", status.error().detail.c_str());
        return 1;
    }
    return 0;
}
