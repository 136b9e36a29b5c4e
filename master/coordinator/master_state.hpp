// What the master knows and by what it acts: the parts of the coordinator without its services.
#pragma once

#include "common/core/limits/master.hpp"
#include "master/base/background.hpp"
#include "master/base/disk_retries.hpp"
#include "master/base/timers.hpp"
#include "master/blocks/block_delivery.hpp"
#include "master/dispatch/dispatch_driver.hpp"
#include "master/geometry/geometry_store.hpp"
#include "master/geometry/tree_registry.hpp"
#include "master/jobs/job_table.hpp"
#include "master/jobs/job_waits.hpp"
#include "master/journal/journal_writer.hpp"
#include "master/verify/alarms.hpp"
#include "master/workers/awaited_workers.hpp"
#include "master/workers/worker_directory.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>

namespace cd {

/// References to what the coordinator uses; all of it outlives the coordinator.
struct CoordinatorParts {
    asio::any_io_executor executor; ///< Runs on one thread, which owns all state.
    GeometryStore& geometry;
    ThreadPool& compute;  ///< Runs analyses and checks results.
    ThreadPool& blocking; ///< Runs tasks that block on the disk or on `compute`.
    /// Not started yet. Must stop before the executor's context, and after the coordinator.
    Journal& journal;
    std::filesystem::path directory; ///< Spool directory for incoming poses.
    Durability durability = Durability::Synced;
    FailureTimes times;
    std::uint64_t results_aside_bytes_max = limits::results_aside_bytes_max;
    JobRetention retention = {};
};

struct MasterState {
    struct Hooks {
        WorkerEvents& workers;
        std::function<void(const Action&)> perform;
        std::function<void()> after_each; ///< Called after each outcome of background work.
    };

    MasterState(const CoordinatorParts& parts, const Hooks& hooks);
    MasterState(const MasterState&) = delete;
    MasterState& operator=(const MasterState&) = delete;

    Background background;
    Timers timers;
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
