#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/remote_session.hpp"
#include "client/commands/run_command.hpp"
#include "client/local/local_cluster.hpp"
#include "client/trees/demo_vehicles.hpp"
#include "common/core/timing/client.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

namespace cd {

namespace {

constexpr unsigned demo_workers = 2;

/// A job as in the paper (section 7): random directions and orientations, with a small or medium
/// penetration.
RunCommand demo_run(const DemoCommand& command, const std::filesystem::path& cache) {
    RunCommand run;
    run.job.a = command.a;
    run.job.b = command.b;
    run.job.name = "demo";
    run.job.poses.random = command.scenarios;
    run.job.poses.seed = 1;
    run.job.poses.penetration = {0.005, 0.05};
    run.job.output.dir = command.out.empty() ? (cache / "demo-results").string() : command.out;
    run.folder.fresh = true;
    run.folder.overwrite = command.out.empty(); // The default folder belongs to the demo.
    run.quiet = command.quiet;
    return run;
}

Status use_vehicles(const std::filesystem::path& cache, RunCommand& run) {
    if (!run.job.a.empty()) {
        return Done{};
    }
    const auto vehicles = find_vehicles(cache);
    if (!vehicles) {
        return vehicles.error();
    }
    run.job.a = vehicles.value()[0].string();
    run.job.b = vehicles.value()[1].string();
    return Done{};
}

/// Waits until all workers have joined, so that the first line that the run prints counts them.
/// Errors: Incomplete and Timeout naming the logs; those of `Connection`.
Status wait_for_workers(LocalCluster& cluster,
                        const LocalClusterOptions& options,
                        const MasterOptions& master) {
    auto connection = open_master(master);
    if (!connection) {
        return connection.error();
    }
    const auto deadline = std::chrono::steady_clock::now() + timing::local_start_max;
    while (std::chrono::steady_clock::now() < deadline) {
        const auto status = connection.value()->status();
        if (!status) {
            return status.error();
        }
        if (worker_count(status.value()) >= options.workers) {
            return Done{};
        }
        if (!cluster.is_running()) {
            return Error{ErrorCode::Incomplete,
                         "cdworker ended at once; see " + options.logs.string()};
        }
        if (Status paused = connection.value()->pause(timing::process_poll_period); !paused) {
            return paused;
        }
    }
    return Error{ErrorCode::Timeout, "the workers do not join; see " + options.logs.string()};
}

} // namespace

int execute(const DemoCommand& command) {
    const InterruptGuard interrupts;
    const auto cache = cache_dir();
    RunCommand run = demo_run(command, cache);
    if (Status found = use_vehicles(cache, run); !found) {
        return fail(found.error());
    }
    LocalClusterOptions options;
    options.programs = program_folder();
    options.state = cache / "demo-state";
    options.logs = cache / "demo-logs";
    options.workers = demo_workers;
    options.threads = std::max(1u, std::thread::hardware_concurrency() / demo_workers);
    auto cluster = LocalCluster::start(options, &InterruptGuard::has_come);
    if (!cluster) {
        return fail(cluster.error());
    }
    run.master.address = cluster.value().address();
    run.master.credential = "none";
    if (!command.quiet) {
        std::fprintf(stderr,
                     "  cluster  cdmaster on %s and %u workers; logs in %s\n",
                     run.master.address.c_str(),
                     options.workers,
                     options.logs.c_str());
    }
    if (Status joined = wait_for_workers(cluster.value(), options, run.master); !joined) {
        return fail(joined.error());
    }
    return run_job(run);
}

} // namespace cd
