// Writes jobs and results to disk in groups, on its own thread, and recovers them after a restart.
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

// Entries, written in the order in which they are added.
struct AcceptJob {
    JobRecord job; ///< Its poses are already on disk.
};
struct AddResults {
    JobId job;
    std::shared_ptr<ResultStore> store; ///< The job's store.
    std::vector<JournalResult> results; ///< Their records become readable at the commit.
    JobProgress progress;
    Bytes map; ///< `pack_map` of these results; empty: none.
    InstanceId author = 0;
    std::vector<Remark> remarks = {}; ///< Remarks on these or earlier results.
    /// Scenarios whose results `remarks` withdraws: their records become unreadable.
    std::vector<std::uint64_t> withdrawn = {};
    std::vector<LostPlaces> losses = {};
    /// New state of the alarms. It is committed with the results, so that no action follows from a
    /// quarantine that a crash could undo.
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
using JournalEntry = std::variant<AcceptJob, AddResults, EndJob, DropJob>;

/// A job as recovered from the journal.
struct RecoveredJob {
    JobRecord record;
    JobProgress progress;
    std::optional<JobEnd> end; ///< Empty: the job continues.
    ResultMerger merger{0};
    JobMap map;
    std::uint64_t withdrawn = 0; ///< Number of results withdrawn.
    /// Results; like all members below, only for a job that continues.
    std::vector<ResultRow> done;
    std::vector<InstanceId> authors; ///< Author of each of these results; 0: the master.
    std::vector<Remark> disputes;    ///< Open disputes.
    std::vector<LostPlaces> losses;  ///< In order of the losses; only for a job that continues.
    /// All authors of results that were not withdrawn, also for an ended job.
    std::set<InstanceId> contributors;
    std::shared_ptr<ResultStore> results;
};

struct Recovered {
    Sha256 cluster;                 ///< Unique id of this state.
    JobId last_job;                 ///< Greatest job number ever used.
    std::vector<RecoveredJob> jobs; ///< Jobs, by id.
    AlarmRecord alarms = {};
};

struct JournalOptions {
    std::filesystem::path directory; ///< State directory.
    bool synced = true; ///< False: a power loss may destroy everything, a crash nothing.
    bool create = true; ///< Create a missing journal.
    /// Checks the records of unfinished jobs against their checksums. Records of ended jobs are
    /// checked when read.
    bool check_records = true;
};

/// Callbacks on the journal's thread.
struct JournalEvents {
    /// All entries up to this position are on disk.
    std::function<void(std::uint64_t position)> committed;
    /// The journal cannot write and keeps retrying; an empty text means that it can write again.
    std::function<void(const std::string& why)> paused;
};

/// Files: `journal.db` and, for each job, `jobs/N.results` (`result_store.hpp`). Segments are
/// synced before the commit that names their records.
class Journal {
  public:
    /// Reads the whole journal. Errors: Io naming a file that is damaged or unusable, with a
    /// remedy; nothing on disk has then been changed.
    [[nodiscard]] static Result<std::unique_ptr<Journal>> open(const JournalOptions& options);
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;
    /// Writes all added entries, unless that fails.
    ~Journal();

    /// Returns the content at the opening. Call once.
    [[nodiscard]] Recovered take_recovered();

    /// Starts writing. Call once, before adding entries.
    void start(JournalEvents events);
    /// Returns the entry's position, from 1. Never blocks for the disk. Any thread.
    std::uint64_t add(JournalEntry entry);
    /// Bytes of uncommitted records. Any thread.
    [[nodiscard]] std::uint64_t queued_bytes() const;

    /// Returns a job as accepted. Blocks for the disk. Any thread. Errors: NotFound; Io.
    [[nodiscard]] Result<JobRecord> job(JobId job) const;

    [[nodiscard]] std::filesystem::path results_path(JobId job) const;
    [[nodiscard]] std::filesystem::path poses_path(JobId job) const;
    [[nodiscard]] std::filesystem::path labels_path(JobId job) const;
    /// Returns the job's three possible paths. Not every file need exist.
    [[nodiscard]] std::vector<std::filesystem::path> files_of(JobId job) const {
        return {results_path(job), poses_path(job), labels_path(job)};
    }

  private:
    struct State;
    explicit Journal(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace cd
