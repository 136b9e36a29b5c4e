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

/// One row that is written, or with all that belong to the job deleted. The alarms are of no job.
struct DatabaseChange {
    enum class Kind : std::uint8_t { Accept, Results, Progress, End, Drop, Alarms };
    Kind kind = Kind::Accept;
    JobId job;
    Bytes content; ///< Nothing for Drop.
};

/// What stands in the index of one job.
struct DatabaseJob {
    JobId id;
    Bytes record;
    Bytes progress; ///< Empty before the first.
    Bytes end;      ///< Empty while it runs.
};

/// `journal.db` with its write-ahead log, and `journal.mark`, which holds the number of the last
/// commit: the log's own checksums make damage look like an end, and this tells the two apart. It
/// gets its name before the first commit, so that none with commits is without it.
/// Every row has a checksum of its own. One thread at a time.
class JournalDatabase {
  public:
    struct Options {
        bool synced = true; ///< False: a loss of power may cost everything, a crash nothing.
        bool create = true; ///< Where there is none.
        /// One of the files that only a journal with commits has beside it; or none. What looks
        /// like a new state beside such a file has lost the rest.
        std::filesystem::path owned = {};
    };

    /// Errors: Io, naming the file that cannot be used or is damaged and what to do. Then, and
    /// until `write` is called, nothing on the disk is changed.
    [[nodiscard]] static Result<std::unique_ptr<JournalDatabase>>
    open(const std::filesystem::path& directory, const Options& options);
    JournalDatabase(const JournalDatabase&) = delete;
    JournalDatabase& operator=(const JournalDatabase&) = delete;
    ~JournalDatabase();

    /// Names this state among all others; made with it.
    [[nodiscard]] const Sha256& cluster() const;
    /// The greatest number that a job has ever had.
    [[nodiscard]] JobId last_job() const;
    /// By id. Errors: Io.
    [[nodiscard]] Result<std::vector<DatabaseJob>> jobs() const;
    /// The record of one job. Errors: NotFound; Io.
    [[nodiscard]] Result<Bytes> record(JobId job) const;
    /// Empty before the first. Errors: Io.
    [[nodiscard]] Result<Bytes> alarms() const;
    /// All groups of results of a job in the order of their commits. An error of `take` ends it.
    /// Errors: Io.
    [[nodiscard]] Status
    for_each_results(JobId job,
                     const std::function<Status(std::span<const std::byte>)>& take) const;
    /// No job has results that is not there. Errors: Io.
    [[nodiscard]] Status check_owners() const;

    /// All of it in one commit, which is on the disk when this returns; or, with an error, none of
    /// it, and it may be tried again. Errors: Io.
    [[nodiscard]] Status write(std::span<const DatabaseChange> changes);

    [[nodiscard]] const std::filesystem::path& path() const;

  private:
    struct State;
    explicit JournalDatabase(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace cd
