// Unsent work: the jobs' analysed scenarios, and the positions that go out without analysis.
#pragma once

#include "master/dispatch/job/dispatch_job.hpp"
#include "master/dispatch/order/job_order.hpp"

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace cd {

/// A scenario that is given up when it is lost with one more worker.
struct Suspect {
    JobId job;
    std::uint64_t position = 0;
};

/// Holds the open jobs, each with its waiting scenarios and unsent positions. A scenario is unsent
/// while it is in its job's queue, is a suspect, or is in a worker's buffer.
class WorkQueue {
  public:
    // ---- Jobs ---------------------------------------------------------------------------------
    /// Adds a job, whose id must be new.
    void open(JobId job,
              const ClusterOptions& options,
              DispatchTrees trees,
              std::unique_ptr<MatchingPolicy> policy,
              JobRank rank = {});
    void set_priority(JobId job, std::int32_t priority);
    /// Drops an open job, its waiting scenarios and suspects. Buffers and tasks must have none of
    /// its scenarios.
    void close(JobId job);
    [[nodiscard]] std::map<JobId, DispatchJob>& jobs() { return jobs_; }
    [[nodiscard]] const std::map<JobId, DispatchJob>& jobs() const { return jobs_; }
    /// Null if the job is not open.
    [[nodiscard]] DispatchJob* find(JobId job);
    [[nodiscard]] const DispatchJob* find(JobId job) const;
    /// The job must be open.
    [[nodiscard]] DispatchJob& at(JobId job) { return jobs_.at(job); }
    [[nodiscard]] const DispatchJob& at(JobId job) const { return jobs_.at(job); }
    [[nodiscard]] bool is_tree_used(TreeId tree) const;
    /// The order in which open jobs get the workers' threads.
    [[nodiscard]] JobOrder& order() { return order_; }
    [[nodiscard]] const JobOrder& order() const { return order_; }
    /// The order in which open jobs get the threads of the master's pool, for their analysis.
    [[nodiscard]] JobOrder& analysis_order() { return analysis_order_; }
    /// All open jobs, whose work goes out first first.
    [[nodiscard]] std::vector<DispatchJob*> in_order();

    // ---- Scenarios ----------------------------------------------------------------------------
    /// Number of unsent analysed scenarios of all jobs. Positions that go out without analysis are
    /// counted by `DispatchView::positions_unsent`.
    [[nodiscard]] std::uint64_t unsent() const { return unsent_; }
    /// Queues a new scenario at the end. Returns whether it is a suspect.
    bool add(DispatchJob& job, std::uint64_t position, DispatchScenario scenario);
    /// Returns scenarios from a buffer to the head of the job's queue.
    void put_back(DispatchJob& job, std::span<const std::uint64_t> positions);
    /// Returns scenarios from a task to the head of the job's queue.
    void put_back_sent(DispatchJob& job, std::span<const std::uint64_t> positions);
    /// Queues the scenario as a suspect and returns true, if it is one. It must be in no task.
    bool suspect(DispatchJob& job, std::uint64_t position, DispatchScenario& scenario);
    /// Removes an unsent scenario from the queue or the suspects, but not from the job. A buffered
    /// scenario must have left its buffer.
    void remove(DispatchJob& job, std::uint64_t position, const DispatchScenario& scenario);
    /// Counts scenarios of the job as no longer unsent: sent in a task, or dropped with the job.
    void leave(DispatchJob& job, std::uint64_t scenarios) { add_unsent(job, 0 - scenarios); }
    /// All suspects. Each goes alone to an idle worker, so that a scenario that kills the worker
    /// does not make others count as lost.
    [[nodiscard]] const std::deque<Suspect>& suspects() const { return suspects_; }
    /// Removes the first suspect, which still counts as unsent. There must be one.
    Suspect take_suspect();

    // ---- Input --------------------------------------------------------------------------------
    /// Sets whether the input is paused, so that no scenarios come for now. Returns the old value.
    bool set_paused(bool is_paused);
    /// True if the job gets no scenario for now: all input is paused, or the job's own.
    [[nodiscard]] bool input_rests(const DispatchJob& job) const {
        return is_paused_ || job.input.is_paused;
    }
    /// True if the job has no waiting scenario, and gets none for now.
    [[nodiscard]] bool nothing_comes(const DispatchJob& job) const {
        return input_rests(job) && job.waiting.empty();
    }
    /// True if some scenario waits, or is a suspect.
    [[nodiscard]] bool something_waits() const;
    /// True if all scenarios and positions are sent, and no more come for now.
    [[nodiscard]] bool is_exhausted() const;

  private:
    void add_unsent(DispatchJob& job, std::uint64_t scenarios) {
        unsent_ += scenarios;
        job.input.unsent += scenarios;
    }

    std::map<JobId, DispatchJob> jobs_;
    JobOrder order_;
    JobOrder analysis_order_;
    std::deque<Suspect> suspects_;
    std::uint64_t unsent_ = 0;
    bool is_paused_ = true;
};

} // namespace cd
