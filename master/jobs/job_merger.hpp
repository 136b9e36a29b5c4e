// Merges results into their job and writes them to the journal.
#pragma once

#include "master/compute/placed_scenario.hpp"
#include "master/compute/result_check.hpp"
#include "master/jobs/job_life.hpp"
#include "master/jobs/thread_meter.hpp"
#include "master/journal/journal_writer.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cd {

/// All results enter a job and the journal through this class.
class JobMerger {
  public:
    /// Both references outlive the merger. `cpu_seconds`: as `ThreadMeter` has it.
    JobMerger(JobLife& life, JournalWriter& writer, std::function<double()> cpu_seconds)
        : life_(life), writer_(writer), meter_(std::move(cpu_seconds)) {}

    /// Merges results of a running job; `author` is null for the master. A second, different result
    /// of a scenario opens a dispute, which the journal announces once durable. Fails the job if a
    /// result exceeds the maximum record size.
    void merge(MasterJob& job, TakenResults taken, const std::shared_ptr<const Author>& author);
    /// Merges the results, and moves the new ones to `add`, which has none and which the caller
    /// writes. Returns a dispute for each scenario that has a different result already.
    [[nodiscard]] static std::vector<Dispute>
    merge_into(MasterJob& job,
               TakenResults& taken,
               const std::shared_ptr<const Author>& author,
               AddResults& add);
    /// Merges a failure as the scenario's result. Ends the job if no other result is missing.
    void fail(MasterJob& job, const PlacedScenario& placed, const std::string& why);

    /// Processor time of the master's own thread for each merged result, s; 0 until it is known.
    [[nodiscard]] double seconds_each() const { return meter_.seconds_each(); }

  private:
    JobLife& life_;
    JournalWriter& writer_;
    ThreadMeter meter_;
};

} // namespace cd
