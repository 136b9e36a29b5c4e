// The journal's index: jobs and groups of results in SQLite. The only user of SQLite.
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

/// Writes one row, or deletes it with all rows of its job. Alarms belong to no job.
struct DatabaseChange {
    enum class Kind : std::uint8_t { Accept, Results, Progress, End, Drop, Alarms };
    Kind kind = Kind::Accept;
    JobId job;
    Bytes content; ///< Empty for Drop.
};

/// Rows of one job.
struct DatabaseJob {
    JobId id;
    Bytes record;
    Bytes progress; ///< Empty before the first progress row.
    Bytes end;      ///< Empty while the job runs.
};

/// `journal.db` with its write-ahead log, and `journal.mark` with the number of the last commit. In
/// the log alone, damage looks like its end; the mark tells them apart. The mark is created before
/// the first commit. Every row has its own checksum. One thread at a time.
class JournalDatabase {
  public:
    struct Options {
        bool synced = true; ///< False: a power loss may destroy everything, a crash nothing.
        bool create = true; ///< Create a missing database.
        /// A file that exists only beside a journal with commits; empty: none. A seemingly new
        /// database beside such a file has lost its data.
        std::filesystem::path owned = {};
    };

    /// Errors: Io naming a file that is damaged or unusable, with a remedy. Nothing on disk changes
    /// after an error, or before `write`.
    [[nodiscard]] static Result<std::unique_ptr<JournalDatabase>>
    open(const std::filesystem::path& directory, const Options& options);
    JournalDatabase(const JournalDatabase&) = delete;
    JournalDatabase& operator=(const JournalDatabase&) = delete;
    ~JournalDatabase();

    /// Unique id of this state, created with it.
    [[nodiscard]] const Sha256& cluster() const;
    /// Greatest job number ever used.
    [[nodiscard]] JobId last_job() const;
    /// Returns all jobs, by id. Errors: Io.
    [[nodiscard]] Result<std::vector<DatabaseJob>> jobs() const;
    /// The record of one job. Errors: NotFound; Io.
    [[nodiscard]] Result<Bytes> record(JobId job) const;
    /// Returns the alarms; empty before the first. Errors: Io.
    [[nodiscard]] Result<Bytes> alarms() const;
    /// Passes all groups of a job's results to `take`, in commit order. Stops at an error of
    /// `take`. Errors: Io.
    [[nodiscard]] Status
    for_each_results(JobId job,
                     const std::function<Status(std::span<const std::byte>)>& take) const;
    /// Checks that all results belong to an existing job. Errors: Io.
    [[nodiscard]] Status check_owners() const;

    /// Writes all changes in one commit, which is on disk when this returns. After an error none is
    /// written, and the call may be repeated. Errors: Io.
    [[nodiscard]] Status write(std::span<const DatabaseChange> changes);

    [[nodiscard]] const std::filesystem::path& path() const;

  private:
    struct State;
    explicit JournalDatabase(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace cd
