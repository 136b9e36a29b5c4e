// Handles clients' requests about jobs: to start, cancel, remove and query them.
#pragma once

#include "common/core/result.hpp"
#include "master/compute/placed_scenario.hpp"
#include "master/coordinator/explainer.hpp"
#include "master/coordinator/master_services.hpp"
#include "master/coordinator/master_state.hpp"
#include "master/coordinator/status_view.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace cd {

class JobDesk {
  public:
    /// All references outlive the desk.
    JobDesk(MasterState& state, MasterServices& services, const Geometry& geometry)
        : state_(state), services_(services), geometry_(geometry) {}

    // ---- Starting jobs --------------------------------------------------------------------------
    /// Allocates the id of a new job. The caller must then call `begin` or `give_up`. Errors:
    /// Refused when too many jobs or scenarios run; Io while the journal cannot write.
    [[nodiscard]] Result<JobId> allot(std::uint64_t scenarios);
    void give_up(JobId job) { state_.jobs.give_up(job); }
    /// Writes an allotted job to the journal. Once that is durable, wakes the coroutines that wait
    /// for the job.
    void write(const JobRecord& job) { state_.writer.write(AcceptJob{job}); }
    /// Starts a new job, which the journal has committed.
    void begin(const JobRecord& record,
               std::shared_ptr<ResultStore> results,
               std::shared_ptr<OrderedPoses> poses);
    /// Coroutines that wait for the acceptance, the end or the removal of a job.
    [[nodiscard]] JobWaits& waits() { return state_.waits; }

    // ---- Changing jobs --------------------------------------------------------------------------
    /// Gives a running job another priority, and writes that to the journal. Returns the position
    /// there. Once that is durable, wakes the coroutines that wait for the job. Errors: NotFound;
    /// Refused if the job has ended; Io while the journal cannot write.
    [[nodiscard]] Result<std::uint64_t> set_priority(JobId job, std::int32_t priority);
    /// True if the journal has committed the entry at this position.
    [[nodiscard]] bool is_durable(std::uint64_t position) const {
        return state_.writer.is_durable(position);
    }

    // ---- Ending jobs ----------------------------------------------------------------------------
    /// Ends a running job. Once that is durable, wakes the coroutines that wait for the job. Does
    /// nothing if the job has ended. Errors: NotFound.
    [[nodiscard]] Result<JobStatus> cancel(JobId job);
    /// Forgets an ended job. Once the journal has deleted it, wakes the coroutines that wait for
    /// the job and removes its files. Errors: NotFound; Refused while it runs; Io while the journal
    /// cannot write.
    [[nodiscard]] Status forget(JobId job);
    /// Forgets jobs whose retention has expired. `now` is in seconds since 1970.
    void forget_expired(std::uint64_t now);
    /// Stops the master's run of a disputed scenario, which then counts as failed. False if the
    /// master does not run it.
    [[nodiscard]] bool cancel_disputed(JobId job, std::uint64_t scenario);
    /// The poses of a running job. Errors: NotFound; Refused if the job has ended or the scenario
    /// has a result.
    [[nodiscard]] Result<std::shared_ptr<OrderedPoses>> poses_of_unanswered(JobId job,
                                                                            std::uint64_t scenario);
    /// Marks the scenario as failed, and stops it on all workers; the job continues. Errors:
    /// NotFound; Refused if the job has ended or the scenario has a result.
    [[nodiscard]] Status cancel_scenario(JobId job, const PlacedScenario& placed);

    // ---- Questions ------------------------------------------------------------------------------
    /// Null if there is no such job.
    [[nodiscard]] const MasterJob* find(JobId job) const { return state_.jobs.find(job); }
    /// Errors: NotFound.
    [[nodiscard]] Result<JobStatus> status(JobId job) const;
    [[nodiscard]] ClusterStatus cluster() const;
    /// Explains scenarios as of now.
    [[nodiscard]] Explainer explainer() const;
    /// Errors: NotFound; Refused for the triangles of a job that is not done.
    [[nodiscard]] Result<ContactMapAnswer> contact_map(const ContactMapQuery& query) const;
    /// What was handed to the journal since the master started.
    [[nodiscard]] const JournalWriter::Counts& written() const { return state_.writer.counts(); }
    /// Disk error because of which the journal cannot write now; empty if it can.
    [[nodiscard]] const std::string& paused() const { return state_.writer.paused(); }

  private:
    [[nodiscard]] StatusView view() const;

    MasterState& state_;
    MasterServices& services_;
    const Geometry& geometry_;
    Clock::time_point started_ = state_.loop.now();
};

} // namespace cd
