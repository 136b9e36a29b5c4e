// The master's proxy of one worker (the paper's "local client", section 6.4.3).
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
    double weight = 1;             ///< Factor on its speed in matching by time.
    std::uint64_t cache_bytes = 0; ///< Limit of its subtree cache; 0: no cache.
    WorkerProcess process = 0;     ///< 0: unknown. An earlier session may be lost.
};

/// Scenarios of one job that form the worker's next task.
struct ScenarioBuffer {
    std::vector<std::uint64_t> scenarios;
    std::uint64_t bytes = 0;
    std::uint64_t cost_ns = 0; ///< Predicted time.

    /// Paper, 6.4.3: q scenarios, or more than V kB (of 1000 bytes).
    [[nodiscard]] bool is_full(const ClusterOptions& options) const {
        return scenarios.size() >= options.q || bytes > std::uint64_t{options.v_kb} * 1000;
    }
};

/// Size and cost of a scenario in a buffer or task.
struct ScenarioWeight {
    std::uint64_t bytes = 0;
    std::uint64_t cost_ns = 0;
};

/// A task at the worker, from sending until the worker reports its end.
struct ProxyTask {
    JobId job;
    std::vector<std::uint64_t> scenarios;  ///< Unanswered, in the order sent.
    bool claims = false;                   ///< Until it ends, the worker gets nothing else.
    std::uint64_t cost_ns = 0;             ///< Predicted time of the unanswered part.
    double sent = 0;                       ///< Send time, s.
    bool fetches = false;                  ///< The worker lacked blocks of it when it was sent.
    double busy_seconds = 0;               ///< Measured so far, over the worker's threads.
    std::optional<PlaceRange> places = {}; ///< Ranges only; `scenarios` is empty then.
    std::uint64_t places_left = 0;         ///< Unanswered positions of `places`.
    bool is_copy = false;                  ///< Speculative copy of another task.
    bool has_begun = false;                ///< The rest has begun and cannot be recalled.
    std::uint64_t places_copied = 0;       ///< Number of last positions that have a copy.

    [[nodiscard]] bool is_range() const { return places.has_value(); }
    [[nodiscard]] std::uint64_t left() const { return scenarios.size() + places_left; }
};

/// Tracks a worker's buffers, tasks and counters; makes no decisions.
class WorkerProxy {
  public:
    WorkerProxy(WorkerId id, std::uint32_t slot, WorkerFacts facts)
        : id_(id), slot_(slot), facts_(std::move(facts)) {}

    [[nodiscard]] WorkerId id() const { return id_; }
    /// Small number, unique among the current workers.
    [[nodiscard]] std::uint32_t slot() const { return slot_; }
    [[nodiscard]] const WorkerFacts& facts() const { return facts_; }

    [[nodiscard]] bool is_draining() const { return draining_; }
    void set_draining() { draining_ = true; }
    /// The worker has been silent too long; it keeps its work.
    [[nodiscard]] bool is_silent() const { return silent_; }
    void set_silent(bool silent) { silent_ = silent; }
    /// The worker may get new work.
    [[nodiscard]] bool takes_work() const { return !draining_ && !silent_; }
    /// The paper's label: a task that claims the worker is still running.
    [[nodiscard]] bool is_claimed() const { return claiming_tasks_ != 0; }
    [[nodiscard]] bool is_idle() const { return buffered_ == 0 && tasks_.empty(); }
    [[nodiscard]] std::uint64_t buffered() const { return buffered_; }
    /// Scenarios at the worker, unanswered.
    [[nodiscard]] std::uint64_t working() const { return working_; }

    /// Limit of a job's tasks at the worker: the one being worked on (several, where q scenarios
    /// are fewer than its threads) and one that waits there.
    [[nodiscard]] std::size_t tasks_max(const ClusterOptions& options) const;
    [[nodiscard]] bool has_room_for_task(JobId job, const ClusterOptions& options) const {
        return !is_claimed() && tasks_of(job) < tasks_max(options);
    }
    /// The worker has less work than q scenarios, or than twice its threads.
    [[nodiscard]] bool would_run_dry(const ClusterOptions& options) const;

    // ---- Matching by time ---------------------------------------------------------------------
    [[nodiscard]] WorkerPace& pace() { return pace_; }
    [[nodiscard]] const WorkerPace& pace() const { return pace_; }
    /// Predicted time of buffered and sent work.
    [[nodiscard]] std::uint64_t backlog_ns() const { return buffered_ns_ + working_ns_; }
    [[nodiscard]] std::uint64_t working_ns() const { return working_ns_; }
    /// Triangles of all blocks that it holds.
    [[nodiscard]] std::uint64_t held_triangles() const { return held_triangles_; }
    void add_held(std::uint64_t triangles) { held_triangles_ += triangles; }
    void remove_held(std::uint64_t triangles) { held_triangles_ -= triangles; }
    /// Time at which the last block under way arrives.
    [[nodiscard]] double transfers_end() const { return transfers_end_; }
    void add_transfer(double now, double seconds);
    /// Target duration of a batch while much work is left.
    [[nodiscard]] double batch_seconds() const { return batch_seconds_; }
    /// Batch size in predicted time; changes only by `set_batch_ns`.
    [[nodiscard]] std::uint64_t batch_ns() const { return batch_ns_; }
    void set_batch_ns(std::uint64_t batch_ns) { batch_ns_ = batch_ns; }
    /// Its scenarios are so long that a round trip is negligible; changes only by `set_are_long`.
    [[nodiscard]] bool are_long() const { return are_long_; }
    void set_are_long(bool are_long) { are_long_ = are_long; }
    /// Lengthens batches if this ended one had too much overhead. Ignores batches without a
    /// successor, and those that waited for blocks.
    void judge_batch(const ProxyTask& ended, double now);

    // ---- Buffers and tasks --------------------------------------------------------------------
    /// Empty if nothing is buffered.
    [[nodiscard]] const ScenarioBuffer& buffer(JobId job) const;
    [[nodiscard]] const std::map<JobId, ScenarioBuffer>& buffers() const { return buffers_; }
    void add_to_buffer(JobId job, std::uint64_t scenario, const ScenarioWeight& weight);
    void remove_from_buffer(JobId job, std::uint64_t scenario, const ScenarioWeight& weight);
    /// Removes the first `count` of the buffer; `weight` is their sum.
    void remove_first(JobId job, std::size_t count, const ScenarioWeight& weight);
    /// Sorts the buffer; stable.
    void order_buffer(JobId job, const std::function<bool(std::uint64_t, std::uint64_t)>& before);
    /// Takes the whole buffer, in order.
    ScenarioBuffer take_buffer(JobId job);

    [[nodiscard]] const std::map<TaskId, ProxyTask>& tasks() const { return tasks_; }
    [[nodiscard]] std::size_t tasks_of(JobId job) const;
    void start_task(TaskId task, ProxyTask content);
    /// The job whose buffer was flushed last; the other jobs have their turn before it.
    [[nodiscard]] JobId flushed_last() const { return flushed_last_; }
    /// The scenario must be in the task. `here`: this worker answered it.
    void answer(TaskId task, std::uint64_t scenario, std::uint64_t cost_ns, bool here);
    /// Records answers of a range task; `count` is at most what is left.
    void answer_places(TaskId task, std::uint64_t count);
    /// Cuts a range task to its first `kept` positions. Returns the rest, which is unanswered.
    PlaceRange cut_places(TaskId task, std::uint64_t kept);
    /// Marks the rest of an existing task as begun: it cannot be recalled.
    void set_begun(TaskId task) { tasks_.at(task).has_begun = true; }
    /// Records that `places` more of the last positions of a range task have a copy.
    void add_copied(TaskId task, std::uint64_t places) { tasks_.at(task).places_copied += places; }
    /// Time of its last answer, or of getting work when idle.
    [[nodiscard]] double progressed() const { return progressed_; }
    void note_progress(double now) { progressed_ = now; }
    /// Time of the last check whether others can help it.
    [[nodiscard]] double looked_at() const { return looked_at_; }
    void note_looked_at(double now) { looked_at_ = now; }
    /// Ignored if the task does not exist.
    void note_busy(TaskId task, double seconds);
    /// Drops the task's scenarios; the task itself lasts until it ends.
    void forget_scenarios(TaskId task);
    /// Ends an existing task and returns its unanswered rest.
    ProxyTask end_task(TaskId task);

    /// The fields of `WorkerStatus` that the proxy knows.
    [[nodiscard]] WorkerStatus status() const;

  private:
    void remove_places(ProxyTask& task, std::uint64_t count);

    WorkerId id_;
    std::uint32_t slot_ = 0;
    WorkerFacts facts_;
    bool draining_ = false;
    bool silent_ = false;
    std::map<JobId, ScenarioBuffer> buffers_; ///< Non-empty ones only.
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
    double task_ended_ = 0; ///< End of the last task.
    double progressed_ = 0;
    double looked_at_ = 0;
    double batch_seconds_ = limits::batch_seconds_start;
    std::uint64_t batch_ns_ = 0;
    bool are_long_ = false;
};

} // namespace cd
