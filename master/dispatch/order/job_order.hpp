// Decides whose work goes out first: jobs by priority, then owners and their jobs by fair shares.
#pragma once

#include "common/core/id.hpp"
#include "master/dispatch/worker_pace.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <utility>

namespace cd {

/// A job's rank among other jobs.
struct JobRank {
    std::int32_t priority = 0; ///< Jobs of higher priority go first.
    std::string owner = {};    ///< Jobs of one owner divide the owner's share.
};

/// Orders the open jobs. The highest priority goes first. Among equal priorities, the owner goes
/// first that has had the least thread time, and of its jobs the one that has had the least: a
/// deficit round robin whose turns are tasks. Thread time is measured for answered work, and
/// predicted for work in flight. A new owner or job starts level with the one that has had the
/// least, so it neither owes nor saves anything.
class JobOrder {
  public:
    /// The job must be new.
    void open(JobId job, JobRank rank);
    /// Gives an open job another priority, among whose jobs it starts level like a new one. Its
    /// work in flight counts there.
    void set_priority(JobId job, std::int32_t priority);
    /// Forgets the job. Ignores work of a job that is not open from then on.
    void close(JobId job);
    /// True if the work of `one` goes out before that of `other`. Both must be open. This is a
    /// strict order: of two different jobs, one comes before the other.
    [[nodiscard]] bool comes_before(JobId one, JobId other) const;

    /// Number of threads of all workers, which bounds the time that a waiting owner saves up.
    void set_threads(std::uint64_t threads) { threads_ = threads; }
    /// Counts work as in flight. `predicted_ns`: its predicted time on one thread.
    void sent(JobId job, std::uint64_t predicted_ns);
    /// Removes work from what is in flight: answered, returned or lost.
    void left(JobId job, std::uint64_t predicted_ns);
    /// Counts thread time of answered work, which must have left the flight. `busy_seconds`: as
    /// measured, 0 if unknown. `now` in s, never decreasing.
    void answered(JobId job, std::uint64_t predicted_ns, double busy_seconds, double now);

    /// Predicted time of the job's work in flight.
    [[nodiscard]] std::uint64_t in_flight_ns(JobId job) const { return jobs_.at(job).in_flight_ns; }
    /// The job's part, 0 to 1, of the thread time that open jobs had in the last
    /// `timing::share_shown_seconds` or so. 0 if the job is not open.
    [[nodiscard]] double share(JobId job, double now) const;

  private:
    /// The jobs of one owner that have one priority.
    struct Owner {
        double used = 0; ///< Thread time of its jobs, s; at first that of the other owners.
        std::uint64_t jobs = 0;
    };
    using OwnerKey = std::pair<std::int32_t, std::string>;
    struct Job {
        JobRank rank;
        Owner* owner = nullptr;
        double settled = 0; ///< Thread time of answered work, s; at first that of its siblings.
        std::uint64_t in_flight_ns = 0;
        LearnedRate cost;     ///< Measured seconds per predicted second.
        double recent = 0;    ///< Thread time of answers, decayed, as of `recent_at`, s.
        double recent_at = 0; ///< Time of the last answer, s.

        /// Thread time that the work in flight will take, s.
        [[nodiscard]] double in_flight() const;
        /// Thread time that the job has had, or will have had once nothing is in flight, s.
        [[nodiscard]] double used() const { return settled + in_flight(); }
        [[nodiscard]] double recent_until(double now) const;
    };

    /// The entry of an owner that may be new.
    [[nodiscard]] Owner& owner_of(const JobRank& rank);
    /// Counts the job, which has no owner, to the one of its rank, level with its siblings.
    void join_owner(Job& job);
    void leave_owner(Job& job);
    [[nodiscard]] Job* find(JobId job);
    /// Changes the job by `change`, and its owner's thread time alike.
    template <class Change>
    void charge(Job& job, const Change& change);
    /// Limits what other owners of the priority, and other jobs of the owner, have saved up.
    void limit_credit(const Job& job);

    std::map<JobId, Job> jobs_;
    std::map<OwnerKey, Owner> owners_;
    std::uint64_t threads_ = 1;
};

} // namespace cd
