// The state of the master: the parts of the coordinator apart from its services.
#pragma once

#include "common/core/limits/master.hpp"
#include "master/base/background.hpp"
#include "master/base/disk_retries.hpp"
#include "master/base/event_loop.hpp"
#include "master/blocks/block_delivery.hpp"
#include "master/compute/job_geometry.hpp"
#include "master/dispatch/dispatch_driver.hpp"
#include "master/geometry/geometry_store.hpp"
#include "master/geometry/tree_registry.hpp"
#include "master/jobs/feed/analysis_feed.hpp"
#include "master/jobs/job_table.hpp"
#include "master/jobs/job_waits.hpp"
#include "master/jobs/thread_meter.hpp"
#include "master/journal/journal_writer.hpp"
#include "master/verify/alarms.hpp"
#include "master/workers/awaited_workers.hpp"
#include "master/workers/worker_directory.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>

namespace cd {

struct CoordinatorOptions {
    Durability durability = Durability::Synced;
    FailureTimes times = {};
    std::uint64_t results_aside_bytes_max = limits::results_aside_bytes_max;
    JobRetention retention = {};
    ResultCheck check = take_results;
    FeedLimits feed = {};
    DispatcherOptions dispatch = {};
    bool knows_owners = false; ///< As in `JobStart::Parts`.
    /// Processor time of the coordinator's thread, s.
    std::function<double()> cpu_seconds = thread_cpu_seconds;
};

/// Resources and options of the coordinator. Everything referenced outlives the coordinator.
struct CoordinatorParts {
    asio::any_io_executor executor; ///< Has one thread, which alone accesses the state.
    EventLoop& loop;                ///< Its functions run on the executor's thread.
    Network& network;
    Geometry& geometry;
    GeometryStore* store; ///< The meshes on disk, for clients' sessions; null without sessions.
    Pool& compute;        ///< Runs analyses and checks results.
    Pool& blocking;       ///< Runs tasks that block on the disk or on `compute`.
    /// Not started yet. Must stop after the coordinator, and before the executor's context.
    Journal& journal;
    std::filesystem::path directory; ///< Spool directory for incoming poses.
    CoordinatorOptions options = {};
};

/// The members of the coordinator that the services share.
struct MasterState {
    struct Hooks {
        WorkerEvents& workers;
        std::function<void(const Action&)> perform;
        std::function<void()> after_each; ///< Called after each continuation of background work.
    };

    MasterState(const CoordinatorParts& parts, const Hooks& hooks);
    MasterState(const MasterState&) = delete;
    MasterState& operator=(const MasterState&) = delete;
    ~MasterState() { loop.close(); }

    EventLoop& loop;
    Background background;
    JobTable jobs;
    JobWaits waits;
    WorkerDirectory workers;
    TreeRegistry trees;
    BlockDelivery blocks;
    DispatchDriver dispatch;
    JournalWriter writer;
    DiskRetries retries;
    Alarms alarms;
    AwaitedWorkers awaited;
};

} // namespace cd
