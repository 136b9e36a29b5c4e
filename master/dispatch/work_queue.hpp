// Unsent work: the jobs' analysed scenarios, and the order positions that go out without analysis.
#pragma once

#include "master/dispatch/job/dispatch_job.hpp"

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <span>

namespace cd {

/// A scenario whose next loss is the last.
struct Suspect {
    JobId job;
    std::uint64_t scenario = 0;
};

/// Holds the open jobs, each with its waiting scenarios and unsent positions. A scenario is unsent
/// while it waits, is suspect, or is in a worker's buffer.
class WorkQueue {
  public:
    // ---- Jobs ---------------------------------------------------------------------------------
    /// The id must be new.
    void open(JobId job,
              const ClusterOptions& options,
              DispatchTree a,
              DispatchTree b,
              std::unique_ptr<MatchingPolicy> policy);
    /// Drops an open job, its waiting scenarios and suspects. No worker has its scenarios.
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
    /// The job that was served last; the next in order is served next.
    [[nodiscard]] JobId served_last() const { return served_last_; }
    void note_served(JobId job) { served_last_ = job; }

    // ---- Scenarios ----------------------------------------------------------------------------
    /// Number of unsent scenarios of all jobs.
    [[nodiscard]] std::uint64_t unsent() const { return unsent_; }
    /// Queues a scenario that nobody has. True: it is a suspect.
    bool add(DispatchJob& job, std::uint64_t index, DispatchScenario scenario);
    /// Queues scenarios from a buffer before all others of the job.
    void put_back(DispatchJob& job, std::span<const std::uint64_t> scenarios);
    /// Queues scenarios from a task before all others of the job.
    void put_back_sent(DispatchJob& job, std::span<const std::uint64_t> scenarios);
    /// Queues the scenario, which nobody has, as a suspect if it is one.
    bool suspect(const DispatchJob& job, std::uint64_t index, DispatchScenario& scenario);
    /// Removes a scenario that waits or is suspect; its entry stays.
    void remove(DispatchJob& job, std::uint64_t index, const DispatchScenario& scenario);
    /// Scenarios have left for a task, or have left a buffer for good.
    void leave(std::uint64_t scenarios) { unsent_ -= scenarios; }
    /// Each suspect travels alone, to an idle worker, so that one deadly scenario does not take
    /// others with it.
    [[nodiscard]] const std::deque<Suspect>& suspects() const { return suspects_; }
    /// The first suspect, which stays unsent; there must be one.
    Suspect take_suspect();

    // ---- Input --------------------------------------------------------------------------------
    /// No more scenarios arrive for now. Returns what was so before.
    bool set_paused(bool is_paused);
    /// The job has no scenario to hand out, and gets none for now.
    [[nodiscard]] bool nothing_comes(const DispatchJob& job) const {
        return is_paused_ && job.waiting.empty();
    }
    [[nodiscard]] bool is_paused() const { return is_paused_; }
    /// True if some scenario is in no buffer and no task.
    [[nodiscard]] bool something_waits() const;
    /// True if all scenarios and positions are sent, and no more come for now.
    [[nodiscard]] bool is_exhausted() const;

  private:
    std::map<JobId, DispatchJob> jobs_;
    std::deque<Suspect> suspects_;
    JobId served_last_;
    std::uint64_t unsent_ = 0;
    bool is_paused_ = true;
};

} // namespace cd
