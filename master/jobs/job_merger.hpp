// Merges results into their job and writes them to the journal.
#pragma once

#include "master/compute/result_check.hpp"
#include "master/jobs/job_life.hpp"
#include "master/journal/journal_writer.hpp"

#include <memory>
#include <optional>
#include <string>

namespace cd {

/// The only path by which results enter a job and the journal.
class JobMerger {
  public:
    /// Both outlive the merger.
    JobMerger(JobLife& life, JournalWriter& writer) : life_(life), writer_(writer) {}

    /// Merges results of a running job; `author` is null for the master. A second, different result
    /// of a scenario opens a dispute, which the journal announces. Ends a job whose results exceed
    /// the record size.
    void merge(MasterJob& job, TakenResults taken, const std::shared_ptr<const Author>& author);
    /// Merges one result into `add`, which the caller writes. Moves the record of `taken`. Returns
    /// the dispute if the scenario has another result.
    [[nodiscard]] static std::optional<Dispute>
    merge_one(MasterJob& job,
              TakenResult& taken,
              const std::shared_ptr<const Author>& author,
              AddResults& add);
    /// Gives the scenario a failure as its result, and ends the job if it is the last.
    void fail(MasterJob& job, const Scenario& scenario, const std::string& why);

  private:
    JobLife& life_;
    JournalWriter& writer_;
};

} // namespace cd
