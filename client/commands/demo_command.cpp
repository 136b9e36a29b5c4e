// The verb `demo`: a job on two vehicles, run by a cluster that it starts on this machine.
#include "client/base/cache_folder.hpp"
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/base/temporary_folder.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/remote_session.hpp"
#include "client/commands/run_command.hpp"
#include "client/commands/viewing.hpp"
#include "client/demo/demo_vehicles.hpp"
#include "client/local/local_cluster.hpp"
#include "client/trees/tree_cache.hpp"
#include "common/core/errors.hpp"
#include "common/core/timing/client.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

namespace cd {

namespace {

constexpr unsigned demo_workers = 2;

/// Returns a job as in the paper (section 7): random directions and orientations, with a small or
/// medium penetration.
RunCommand demo_run(const DemoCommand& command, const std::filesystem::path& cache) {
    RunCommand run;
    run.job.a = command.a;
    run.job.b = command.b;
    run.job.name = "demo";
    run.job.poses.random = command.scenarios;
    run.job.poses.seed = 1;
    run.job.poses.penetration = {0.005, 0.05};
    run.job.query.level = "count";
    run.job.query.maps = true;
    run.job.output.dir = command.out.empty() ? (cache / "demo-results").string() : command.out;
    run.folder.fresh = true;
    run.folder.overwrite = command.out.empty(); // The demo may overwrite its default folder.
    run.master.credential = "none";
    run.quiet = command.quiet;
    return run;
}

/// Waits until all workers have joined, so that the first line of the run counts all of them.
/// Errors: Incomplete and Timeout naming the logs; as `Connection`.
Status wait_for_workers(LocalCluster& cluster,
                        const LocalClusterOptions& options,
                        const MasterOptions& master) {
    auto connection = CD_TRY(open_master(master));
    const auto deadline = std::chrono::steady_clock::now() + timing::local_start_max;
    while (std::chrono::steady_clock::now() < deadline) {
        const ClusterStatus status = CD_TRY(connection->status());
        if (worker_count(status) >= options.workers) {
            return Done{};
        }
        if (!cluster.is_running()) {
            return Error{ErrorCode::Incomplete,
                         "cdworker ended at once; see " + options.logs.string()};
        }
        CD_TRY(connection->pause(timing::process_poll_period));
    }
    return Error{ErrorCode::Timeout, "the workers do not join; see " + options.logs.string()};
}

/// Shows the newest job of the cluster in the browser until a signal comes.
Status show_page(const MasterOptions& master) {
    const auto job = CD_TRY(open_job(master, "last"));
    auto gateway = CD_TRY(PageGateway::listen(0));
    ClusterViewing what{master, job.id, default_tree_cache()};
    what.serving.ends_idle = false;
    view_cluster(*gateway, what);
    return Done{};
}

} // namespace

Result<int> perform(const DemoCommand& command) {
    const InterruptGuard interrupts;
    const auto cache = cache_dir();
    RunCommand run = demo_run(command, cache);
    if (run.job.a.empty()) {
        const auto vehicles =
            CD_TRY(command.vehicles == "debian" ? find_debian_vehicles(cache)
                                                : write_vehicles(cache / "demo-vehicles"));
        run.job.a = vehicles[0].string();
        run.job.b = vehicles[1].string();
    }
    // A master refuses the state of another version, so the demo's state lasts only as long as it.
    const auto state = CD_TRY(TemporaryFolder::make("cdctl-demo"));
    const LocalClusterOptions options{
        program_folder(),
        state.path(),
        cache / "demo-logs",
        demo_workers,
        std::max(1u, std::thread::hardware_concurrency() / demo_workers)};
    auto cluster = CD_TRY(LocalCluster::start(options, &InterruptGuard::has_come));
    run.master.address = cluster.address();
    if (!command.quiet) {
        std::fprintf(stderr,
                     "  cluster  cdmaster on %s and %u workers; logs in %s\n",
                     run.master.address.c_str(),
                     options.workers,
                     options.logs.c_str());
    }
    CD_TRY(wait_for_workers(cluster, options, run.master));
    const int code = CD_TRY(run_job(run));
    if (code == exit_done && !command.no_wait && ::isatty(STDOUT_FILENO) != 0) {
        CD_TRY(show_page(run.master));
    }
    return code;
}

} // namespace cd
