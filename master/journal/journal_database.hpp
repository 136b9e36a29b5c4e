// The journal's index: jobs and groups of results, in SQLite.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/id.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace cd {

/// A change of the database: writes one row or, for Drop, deletes all rows of the job.
struct DatabaseChange {
    enum class Kind : std::uint8_t { Accept, Record, Results, Progress, End, Drop, Alarms };
    Kind kind = Kind::Accept;
    JobId job;     ///< Unused for Alarms.
    Bytes content; ///< Content of the row; empty for Drop.
};

/// Rows of one job.
struct DatabaseJob {
    JobId id;
    Bytes record;
    Bytes progress; ///< Empty before the first progress row.
    Bytes end;      ///< Empty while the job runs.
};

/// The journal's rows: jobs, groups of results, and alarms. One thread at a time may use them.
class JournalDatabase {
  public:
    struct Options {
        /// True: each commit is synced to disk. False: a power loss may destroy everything, a crash
        /// of the master nothing.
        bool synced = true;
        bool create = true; ///< True: create a missing database. False: only read.
        /// Path of some job's file; empty: there is none. Such a file exists only if the journal
        /// has commits, so that a database that looks new beside it has lost its data.
        std::filesystem::path owned = {};
    };

    /// Opens the journal in the directory: `journal.db`, an SQLite database with a write-ahead log,
    /// and `journal.mark`, which has the number of the last commit. SQLite treats damage in the log
    /// as the log's end; the mark reveals the missing commits. It is created before the first
    /// commit. Every row has its own checksum. A database with tables is changed only by `write`.
    /// Errors: NotFound if there is no journal and `create` is false; Io naming a file that is
    /// damaged or unusable.
    [[nodiscard]] static Result<std::unique_ptr<JournalDatabase>>
    open(const std::filesystem::path& directory, const Options& options);
    JournalDatabase() = default;
    JournalDatabase(const JournalDatabase&) = delete;
    JournalDatabase& operator=(const JournalDatabase&) = delete;
    virtual ~JournalDatabase() = default;

    /// Random id of the state directory, made with its journal.
    [[nodiscard]] virtual const Sha256& cluster() const = 0;
    /// Greatest job id ever used; 0: none.
    [[nodiscard]] virtual JobId last_job() const = 0;
    /// Returns all jobs in the order of their ids. Errors: Io.
    [[nodiscard]] virtual Result<std::vector<DatabaseJob>> jobs() const = 0;
    /// Returns the record of one job. Errors: NotFound; Io.
    [[nodiscard]] virtual Result<Bytes> record(JobId job) const = 0;
    /// Returns the encoded alarms; empty before the first alarm. Errors: Io.
    [[nodiscard]] virtual Result<Bytes> alarms() const = 0;
    /// Passes all groups of a job's results to `take`, in commit order. Stops at an error of
    /// `take`. Errors: Io.
    [[nodiscard]] virtual Status
    for_each_results(JobId job,
                     const std::function<Status(std::span<const std::byte>)>& take) const = 0;
    /// Checks that every row of results belongs to an existing job. Errors: Io.
    [[nodiscard]] virtual Status check_owners() const = 0;

    /// Writes all changes in one commit, which is on disk when this returns. After an error no
    /// change is written, and the call may be repeated. Errors: Io.
    [[nodiscard]] virtual Status write(std::span<const DatabaseChange> changes) = 0;

    [[nodiscard]] virtual const std::filesystem::path& path() const = 0;
};

} // namespace cd
