// Brings jobs and results to the disk, in groups, on a thread of its own; and back after a restart.
#pragma once

#include "common/core/result.hpp"
#include "master/journal/alarm_record.hpp"
#include "master/journal/job_map.hpp"
#include "master/journal/journal_records.hpp"
#include "master/journal/result_group.hpp"
#include "master/journal/result_store.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace cd {

/// A result with its record.
struct JournalResult {
    ResultRow row;
    Bytes record;
};

// What is written, in the order in which it is added.
struct AcceptJob {
    JobRecord job; ///< Its poses are on the disk.
};
struct AddResults {
    JobId job;
    std::shared_ptr<ResultStore> store; ///< The job's.
    std::vector<JournalResult> results; ///< Their records can be read when they are committed.
    JobProgress progress;
    Bytes map; ///< Of these results, `pack_map`; or none.
    WorkerProcess author = 0;
    std::vector<Remark> remarks = {}; ///< On these results, or earlier ones.
    std::vector<LostPlaces> losses = {};
    /// As they stand from now on. They are committed with the results, so that nothing follows
    /// from a quarantine that may be forgotten.
    std::optional<AlarmRecord> alarms = {};
};
struct EndJob {
    JobId job;
    JobEnd end;
    JobProgress progress;
};
/// All that is kept of the job goes, but its files.
struct DropJob {
    JobId job;
};
using JournalEntry = std::variant<AcceptJob, AddResults, EndJob, DropJob>;

/// A job as the journal has it.
struct RecoveredJob {
    JobRecord record;
    JobProgress progress;
    std::optional<JobEnd> end; ///< Nothing: it is to go on.
    ResultMerger merger{0};
    JobMap map;
    /// Scenarios that have results; of one that is to go on, as is the rest.
    std::vector<std::uint64_t> done;
    /// Whose result each of these is. 0 also where somebody else vouches for it.
    std::vector<WorkerProcess> authors;
    std::vector<Remark> disputes;         ///< That are not settled.
    std::vector<LostPlaces> losses;       ///< In their order; of one that is to go on.
    std::set<WorkerProcess> contributors; ///< All authors of results; also of one that has ended.
    std::shared_ptr<ResultStore> results;
};

struct Recovered {
    Sha256 cluster;                 ///< Names this state among all others.
    JobId last_job;                 ///< The greatest number that a job has had.
    std::vector<RecoveredJob> jobs; ///< By id.
    AlarmRecord alarms = {};
};

struct JournalOptions {
    std::filesystem::path directory; ///< Of the state.
    bool synced = true; ///< False: a loss of power may cost everything, a crash nothing.
    bool create = true; ///< Where there is none.
    /// Read the records of jobs that are to go on against their checksums. Those of jobs that have
    /// ended are checked when they are read.
    bool check_records = true;
};

/// Called on the journal's thread.
struct JournalEvents {
    /// All entries up to this position are on the disk.
    std::function<void(std::uint64_t position)> committed;
    /// It cannot write, and tries again from time to time; or, with an empty text, can again.
    std::function<void(const std::string& why)> paused;
};

/// `journal.db` and, for each job, `jobs/N.results` (`result_store.hpp`). The segments are synced
/// before the commit that names their records.
class Journal {
  public:
    /// Reads all there is. Errors: Io naming the file that is damaged or cannot be used, and what
    /// to do; then nothing on the disk has been changed.
    [[nodiscard]] static Result<std::unique_ptr<Journal>> open(const JournalOptions& options);
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;
    /// Writes what was added, unless that fails.
    ~Journal();

    /// What stood in it when it was opened; once.
    [[nodiscard]] Recovered take_recovered();

    /// Begins to write. Called once, before anything is added.
    void start(JournalEvents events);
    /// Never blocks for the disk. The position of the entry, from 1. Any thread.
    std::uint64_t add(JournalEntry entry);
    /// Bytes of the records that are not committed yet. Any thread.
    [[nodiscard]] std::uint64_t queued_bytes() const;

    /// A job as it was accepted. Blocks for the disk. Any thread. Errors: NotFound; Io.
    [[nodiscard]] Result<JobRecord> job(JobId job) const;

    [[nodiscard]] std::filesystem::path results_path(JobId job) const;
    [[nodiscard]] std::filesystem::path poses_path(JobId job) const;
    [[nodiscard]] std::filesystem::path labels_path(JobId job) const;
    /// The three paths above. A job need not have all these files.
    [[nodiscard]] std::vector<std::filesystem::path> files_of(JobId job) const {
        return {results_path(job), poses_path(job), labels_path(job)};
    }

  private:
    struct State;
    explicit Journal(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace cd
