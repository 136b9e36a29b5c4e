// Writes jobs and results to disk in groups, on its own thread, and recovers them after a restart.
#pragma once

#include "common/core/result.hpp"
#include "master/journal/alarm_record.hpp"
#include "master/journal/commit_times.hpp"
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
#include <utility>
#include <variant>
#include <vector>

namespace cd {

// Kinds of entries. The journal writes entries in the order in which they are added.
struct AcceptJob {
    JobRecord job; ///< The job's poses must be on disk already.
};
/// Replaces the record of an accepted job.
struct ChangeJob {
    JobRecord job;
};
struct AddResults {
    JobId job;
    std::shared_ptr<ResultStore> store; ///< The job's store.
    ResultBatch results;                ///< The commit makes the records readable.
    JobProgress progress;
    Bytes map;                        ///< Packed contact map of these results; empty: none.
    InstanceId author = 0;            ///< Worker process that gave the results; 0: the master.
    std::vector<Remark> remarks = {}; ///< Remarks on these or earlier results.
    /// Scenarios whose results are withdrawn: the commit makes their records unreadable.
    std::vector<std::uint64_t> withdrawn = {};
    std::vector<LostPositions> losses = {}; ///< Positions that were lost with a worker.
    /// New state of the alarms, if changed. One commit writes it with the rest of the entry, so
    /// that a crash cannot undo a quarantine but keep its consequences.
    std::optional<AlarmRecord> alarms = {};
};
struct EndJob {
    JobId job;
    JobEnd end;
    JobProgress progress;
};
/// Removes all rows of the job, but not its files.
struct DropJob {
    JobId job;
};
using JournalEntry = std::variant<AcceptJob, ChangeJob, AddResults, EndJob, DropJob>;

/// A job as recovered from the journal.
struct RecoveredJob {
    JobRecord record;
    JobProgress progress;
    std::optional<JobEnd> end; ///< Empty: the job continues.
    ResultMerger merger{0};
    JobMap map;
    std::uint64_t withdrawn = 0;       ///< Number of results withdrawn.
    std::vector<ResultRow> done;       ///< Valid results; only for a job that continues.
    std::vector<InstanceId> authors;   ///< Author of each result in `done`; 0: the master.
    std::vector<Remark> disputes;      ///< Open disputes.
    std::vector<LostPositions> losses; ///< In time order; only for a job that continues.
    /// All processes with results that were not withdrawn.
    std::set<InstanceId> contributors;
    std::shared_ptr<ResultStore> results;
};

struct Recovered {
    Sha256 cluster;                 ///< Random id of the state directory, made with its journal.
    JobId last_job;                 ///< Greatest job id ever used; 0: none.
    std::vector<RecoveredJob> jobs; ///< Sorted by id.
    AlarmRecord alarms = {};
};

struct JournalOptions {
    std::filesystem::path directory; ///< State directory.
    /// True: each commit is synced to disk. False: a power loss may destroy everything, a crash of
    /// the master nothing.
    bool synced = true;
    bool create = true; ///< True: create a missing journal. False: also change nothing on disk.
};

/// Callbacks on the journal's thread.
struct JournalEvents {
    /// Called when all entries up to this position are committed.
    std::function<void(std::uint64_t position)> committed;
    /// Called when the journal cannot write, because of the error `why`, and keeps retrying. An
    /// empty `why`: it can write again.
    std::function<void(const std::string& why)> paused;
};

/// Commits entries in the order in which they are added, and reports the commits.
class Journal {
  public:
    /// Reads the whole journal of a state directory. Files: the index `journal.db` and, for each
    /// job N, the segment `jobs/N.results` (`result_store.hpp`). A segment is synced before the
    /// index commit that refers to its records. A thread of the journal writes. The destructor
    /// writes all added entries, unless that fails. Records of unfinished jobs are checked, those
    /// of ended jobs when they are read. Errors: Io naming a file that is damaged or unusable, with
    /// a remedy. An error leaves the disk unchanged.
    [[nodiscard]] static Result<std::unique_ptr<Journal>> open(const JournalOptions& options);
    /// `jobs_folder` holds the files of the jobs.
    explicit Journal(std::filesystem::path jobs_folder) : jobs_folder_(std::move(jobs_folder)) {}
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;
    virtual ~Journal() = default;

    /// Returns the content that was found when the journal was opened. Call once.
    [[nodiscard]] virtual Recovered take_recovered() = 0;

    /// Starts writing. Call once, before adding entries.
    virtual void start(JournalEvents events) = 0;
    /// Queues the entry. Returns its position; the first is 1. Never blocks for the disk. Any
    /// thread.
    virtual std::uint64_t add(JournalEntry entry) = 0;
    /// Bytes of the records and maps that are queued, that is, not committed yet. Any thread.
    [[nodiscard]] virtual std::uint64_t queued_bytes() const = 0;

    /// Commits since the journal was opened, by their duration. Any thread. A journal that is not
    /// on disk has none.
    [[nodiscard]] virtual CommitTimes::Counts commit_times() const { return {}; }

    /// Returns an accepted job's record. Blocks for the disk. Any thread. Errors: NotFound; Io.
    [[nodiscard]] virtual Result<JobRecord> job(JobId job) const = 0;

    [[nodiscard]] const std::filesystem::path& jobs_folder() const { return jobs_folder_; }
    [[nodiscard]] std::filesystem::path results_path(JobId job) const {
        return jobs_folder_ / (std::to_string(job.value) + ".results");
    }
    [[nodiscard]] std::filesystem::path poses_path(JobId job) const {
        return jobs_folder_ / (std::to_string(job.value) + ".poses");
    }
    [[nodiscard]] std::filesystem::path labels_path(JobId job) const {
        return jobs_folder_ / (std::to_string(job.value) + ".labels");
    }
    /// Returns the job's three possible paths. Not every file need exist.
    [[nodiscard]] std::vector<std::filesystem::path> files_of(JobId job) const {
        return {results_path(job), poses_path(job), labels_path(job)};
    }

  private:
    std::filesystem::path jobs_folder_;
};

} // namespace cd
