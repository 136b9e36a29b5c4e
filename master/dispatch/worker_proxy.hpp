// The master's side of one worker (the paper's "local client", section 6.4.3).
#pragma once

#include "common/core/id.hpp"
#include "common/core/limits/master.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "master/base/worker_process.hpp"
#include "master/dispatch/worker_pace.hpp"
#include "proto/messages/client_messages.hpp"
#include "proto/messages/cluster_options.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cd {

struct WorkerFacts {
    std::string name;
    std::uint32_t threads = 1;
    double weight = 1;             ///< Multiplies its speed, where matching is by time.
    std::uint64_t cache_bytes = 0; ///< The limit of its subtree cache; 0: none.
    WorkerProcess process = 0;     ///< 0: not known. A session of it may have been lost before.
};

/// Scenarios of one job that go to the worker as the next task.
struct ScenarioBuffer {
    std::vector<std::uint64_t> scenarios;
    std::uint64_t bytes = 0;
    std::uint64_t cost_ns = 0; ///< Predicted.

    /// Paper, 6.4.3: q scenarios, or more than V kB (of 1000 bytes).
    [[nodiscard]] bool is_full(const ClusterOptions& options) const {
        return scenarios.size() >= options.q || bytes > std::uint64_t{options.v_kb} * 1000;
    }
};

/// What of a scenario counts in a buffer and in a task.
struct ScenarioWeight {
    std::uint64_t bytes = 0;
    std::uint64_t cost_ns = 0;
};

/// A batch at the worker, from its sending until the worker says that it has ended.
struct ProxyTask {
    JobId job;
    std::vector<std::uint64_t> scenarios;  ///< Not yet answered, in the order sent.
    bool claims = false;                   ///< While it lasts, the worker gets nothing else.
    std::uint64_t cost_ns = 0;             ///< Predicted, of those not yet answered.
    double sent = 0;                       ///< When, in seconds.
    bool fetches = false;                  ///< Not all of its blocks were there when it was sent.
    double busy_seconds = 0;               ///< Measured so far, over the worker's threads.
    std::optional<PlaceRange> places = {}; ///< Of a range; it has no `scenarios`.
    std::uint64_t places_left = 0;         ///< Of these, not yet answered.
    bool is_copy = false;                  ///< Another task has the same.
    bool has_begun = false;                ///< All that is left of it: none can be recalled.
    std::uint64_t places_copied = 0;       ///< Of the range the last ones.

    [[nodiscard]] bool is_range() const { return places.has_value(); }
    [[nodiscard]] std::uint64_t left() const { return scenarios.size() + places_left; }
};

/// Buffers, tasks and counts. Decides nothing.
class WorkerProxy {
  public:
    WorkerProxy(WorkerId id, std::uint32_t slot, WorkerFacts facts)
        : id_(id), slot_(slot), facts_(std::move(facts)) {}

    [[nodiscard]] WorkerId id() const { return id_; }
    /// A small number that no other worker has as long as this one is here.
    [[nodiscard]] std::uint32_t slot() const { return slot_; }
    [[nodiscard]] const WorkerFacts& facts() const { return facts_; }

    [[nodiscard]] bool is_draining() const { return draining_; }
    void set_draining() { draining_ = true; }
    /// Nothing was heard of it for too long; what it has, it keeps.
    [[nodiscard]] bool is_silent() const { return silent_; }
    void set_silent(bool silent) { silent_ = silent; }
    /// It may be given something.
    [[nodiscard]] bool takes_work() const { return !draining_ && !silent_; }
    /// The paper's label: a task that claims the worker is not over.
    [[nodiscard]] bool is_claimed() const { return claiming_tasks_ != 0; }
    /// Nothing buffered and no task.
    [[nodiscard]] bool is_idle() const { return buffered_ == 0 && tasks_.empty(); }
    [[nodiscard]] std::uint64_t buffered() const { return buffered_; }
    /// At the worker and not yet answered.
    [[nodiscard]] std::uint64_t working() const { return working_; }

    /// How many tasks of a job may stand at the worker: the one being worked on (several,
    /// where q scenarios are fewer than its threads) and one more that waits there.
    [[nodiscard]] std::size_t tasks_max(const ClusterOptions& options) const;
    [[nodiscard]] bool has_room_for_task(JobId job, const ClusterOptions& options) const {
        return !is_claimed() && tasks_of(job) < tasks_max(options);
    }
    /// Less work stands at the worker than a buffer, or than twice its threads.
    [[nodiscard]] bool would_run_dry(const ClusterOptions& options) const;

    // ---- By time ------------------------------------------------------------------------------
    [[nodiscard]] WorkerPace& pace() { return pace_; }
    [[nodiscard]] const WorkerPace& pace() const { return pace_; }
    /// Predicted, buffered or at the worker.
    [[nodiscard]] std::uint64_t backlog_ns() const { return buffered_ns_ + working_ns_; }
    [[nodiscard]] std::uint64_t working_ns() const { return working_ns_; }
    /// What it holds of all trees.
    [[nodiscard]] std::uint64_t held_triangles() const { return held_triangles_; }
    void add_held(std::uint64_t triangles) { held_triangles_ += triangles; }
    void remove_held(std::uint64_t triangles) { held_triangles_ -= triangles; }
    /// When the last block under way will be there.
    [[nodiscard]] double transfers_end() const { return transfers_end_; }
    void add_transfer(double now, double seconds);
    /// How long a batch should last, before it is known how much is left to do.
    [[nodiscard]] double batch_seconds() const { return batch_seconds_; }
    /// How much of a job goes together. It changes only when it is set.
    [[nodiscard]] std::uint64_t batch_ns() const { return batch_ns_; }
    void set_batch_ns(std::uint64_t batch_ns) { batch_ns_ = batch_ns; }
    /// Scenarios take it so long that a round trip is nothing against one. The same.
    [[nodiscard]] bool are_long() const { return are_long_; }
    void set_are_long(bool are_long) { are_long_ = are_long; }
    /// Lets batches grow if this one, which has ended, cost too much beside its work. Says nothing
    /// where nothing stood behind it, or where it had to wait for blocks.
    void judge_batch(const ProxyTask& ended, double now);

    // ---- Buffers and tasks --------------------------------------------------------------------
    /// Empty where nothing is buffered.
    [[nodiscard]] const ScenarioBuffer& buffer(JobId job) const;
    [[nodiscard]] const std::map<JobId, ScenarioBuffer>& buffers() const { return buffers_; }
    void add_to_buffer(JobId job, std::uint64_t scenario, const ScenarioWeight& weight);
    void remove_from_buffer(JobId job, std::uint64_t scenario, const ScenarioWeight& weight);
    /// The first `count` of the buffer, which weigh that together.
    void remove_first(JobId job, std::size_t count, const ScenarioWeight& weight);
    /// Equals stay in their order.
    void order_buffer(JobId job, const std::function<bool(std::uint64_t, std::uint64_t)>& before);
    /// What was buffered, in order; nothing is left of it.
    ScenarioBuffer take_buffer(JobId job);

    [[nodiscard]] const std::map<TaskId, ProxyTask>& tasks() const { return tasks_; }
    [[nodiscard]] std::size_t tasks_of(JobId job) const;
    void start_task(TaskId task, ProxyTask content);
    /// Whose buffer was flushed last; the others have their turn before it.
    [[nodiscard]] JobId flushed_last() const { return flushed_last_; }
    /// The scenario is in the task. `here`: this worker answered it.
    void answer(TaskId task, std::uint64_t scenario, std::uint64_t cost_ns, bool here);
    /// So many places of the task, which is a range, are answered; no more than are left.
    void answer_places(TaskId task, std::uint64_t count);
    /// The task, which is a range, keeps the first so many of its places. The others, which were
    /// not answered.
    PlaceRange cut_places(TaskId task, std::uint64_t kept);
    /// The task is here: what is left of it cannot be recalled.
    void set_begun(TaskId task) { tasks_.at(task).has_begun = true; }
    /// The task is a range, and so many more of its last places have a copy.
    void add_copied(TaskId task, std::uint64_t places) { tasks_.at(task).places_copied += places; }
    /// When it answered last, or got something to do.
    [[nodiscard]] double progressed() const { return progressed_; }
    void note_progress(double now) { progressed_ = now; }
    /// When it was last seen whether others can help it.
    [[nodiscard]] double looked_at() const { return looked_at_; }
    void note_looked_at(double now) { looked_at_ = now; }
    /// Of a task that is not here: nothing.
    void note_busy(TaskId task, double seconds);
    /// The task's scenarios are no longer of interest; the task itself lasts until it ends.
    void forget_scenarios(TaskId task);
    /// The task is here; what is left of it, to be done elsewhere.
    ProxyTask end_task(TaskId task);

    /// Of `WorkerStatus`, what is known here.
    [[nodiscard]] WorkerStatus status() const;

  private:
    void remove_places(ProxyTask& task, std::uint64_t count);

    WorkerId id_;
    std::uint32_t slot_ = 0;
    WorkerFacts facts_;
    bool draining_ = false;
    bool silent_ = false;
    std::map<JobId, ScenarioBuffer> buffers_; ///< None of them empty.
    std::map<TaskId, ProxyTask> tasks_;
    std::uint64_t buffered_ = 0;
    std::uint64_t working_ = 0;
    std::size_t claiming_tasks_ = 0;
    JobId flushed_last_;
    std::uint64_t tasks_sent_ = 0;
    std::uint64_t scenarios_answered_ = 0;

    WorkerPace pace_;
    std::uint64_t buffered_ns_ = 0;
    std::uint64_t working_ns_ = 0;
    std::uint64_t held_triangles_ = 0;
    double transfers_end_ = 0;
    double task_ended_ = 0; ///< The last one.
    double progressed_ = 0;
    double looked_at_ = 0;
    double batch_seconds_ = limits::batch_seconds_start;
    std::uint64_t batch_ns_ = 0;
    bool are_long_ = false;
};

} // namespace cd
