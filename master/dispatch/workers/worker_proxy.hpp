// The master's proxy of one worker (the paper's "local client", section 6.4.3).
#pragma once

#include "common/core/id.hpp"
#include "master/base/instance_id.hpp"
#include "master/dispatch/worker_pace.hpp"
#include "master/dispatch/workers/batch_size.hpp"
#include "master/dispatch/workers/worker_buffers.hpp"
#include "master/dispatch/workers/worker_tasks.hpp"
#include "proto/messages/client_messages.hpp"
#include "proto/messages/cluster_options.hpp"

#include <cstdint>
#include <string>

namespace cd {

struct WorkerFacts {
    std::string name;
    std::uint32_t threads = 1;
    double weight = 1;             ///< Factor on the worker's speed in matching by time.
    std::uint64_t cache_bytes = 0; ///< Limit of the worker's subtree cache; 0: no limit known.
    InstanceId process = 0;        ///< The worker's process; 0: unknown.
};

/// Tracks whether a worker takes work, and which work it has. Makes no decisions.
class WorkerProxy {
  public:
    WorkerProxy(WorkerId id, std::uint32_t slot, WorkerFacts facts)
        : id_(id), slot_(slot), facts_(std::move(facts)) {}

    [[nodiscard]] WorkerId id() const { return id_; }
    /// Small number, unique among the current workers.
    [[nodiscard]] std::uint32_t slot() const { return slot_; }
    [[nodiscard]] const WorkerFacts& facts() const { return facts_; }

    void set_draining() { draining_ = true; }
    [[nodiscard]] bool is_draining() const { return draining_; }
    /// True after too many missed heartbeats. The worker keeps the work that was sent to it.
    [[nodiscard]] bool is_silent() const { return silent_; }
    void set_silent(bool silent) { silent_ = silent; }
    /// True if the worker may get new work.
    [[nodiscard]] bool takes_work() const { return !draining_ && !silent_; }
    [[nodiscard]] bool is_claimed() const { return tasks.have_claimed(); }
    [[nodiscard]] bool is_idle() const { return buffers.count() == 0 && tasks.all().empty(); }
    /// Number of scenarios that are in the worker's buffers, or unanswered in its tasks.
    [[nodiscard]] std::uint64_t scenarios() const { return buffers.count() + tasks.left(); }
    /// Predicted time of buffered and sent work.
    [[nodiscard]] std::uint64_t backlog_ns() const { return buffers.cost_ns() + tasks.cost_ns(); }

    /// Limit of a job's tasks at the worker: as many as occupy its threads with q scenarios each,
    /// and one that waits there.
    [[nodiscard]] std::size_t tasks_max(const ClusterOptions& options) const;
    [[nodiscard]] bool has_room_for_task(JobId job, const ClusterOptions& options) const {
        return !is_claimed() && tasks.count_of(job) < tasks_max(options);
    }
    /// True if the worker has fewer unanswered scenarios than q or than twice its threads.
    [[nodiscard]] bool would_run_dry(const ClusterOptions& options) const;
    /// True if the worker has less unanswered work than a batch, or fewer scenarios than threads.
    [[nodiscard]] bool would_run_dry_by_time() const {
        return tasks.cost_ns() < batch.cost_ns() || tasks.left() < facts_.threads;
    }

    /// Time at which the last block under way arrives, s.
    [[nodiscard]] double transfers_end() const { return transfers_end_; }
    /// Queues a transfer that takes `seconds` behind all transfers under way. `now` in s.
    void add_transfer(double now, double seconds);
    /// Time of the last check whether others can help the worker, s.
    [[nodiscard]] double looked_at() const { return looked_at_; }
    void note_looked_at(double now) { looked_at_ = now; }

    /// The fields of `WorkerStatus` that the proxy knows.
    [[nodiscard]] WorkerStatus status() const;

    WorkerBuffers buffers;
    WorkerTasks tasks;
    BatchSize batch;
    WorkerPace pace;

  private:
    WorkerId id_;
    std::uint32_t slot_ = 0;
    WorkerFacts facts_;
    bool draining_ = false;
    bool silent_ = false;
    double transfers_end_ = 0;
    double looked_at_ = 0;
};

} // namespace cd
