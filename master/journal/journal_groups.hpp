// Writes groups of journal entries to the jobs' segments and to the index, and reads them again.
// Has no thread; `Journal` writes on a thread of its own.
#pragma once

#include "common/core/result.hpp"
#include "master/journal/journal.hpp"
#include "master/journal/journal_database.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace cd {

/// Returns the bytes of the entry's records and map.
[[nodiscard]] std::uint64_t bytes_of(const JournalEntry& entry);
/// Returns the number of results, remarks and losses in the entry.
[[nodiscard]] std::size_t rows_of(const JournalEntry& entry);

struct JournalDisk {
    JournalDatabase& database;
    std::filesystem::path jobs_folder; ///< Folder of the segments.
    bool synced = true;                ///< True: sync segments before the index commit.
};

/// Writes the group in one commit, which is on disk when this returns. After an error no entry of
/// the group is committed, and the call may be repeated. Errors: Io.
[[nodiscard]] Status write_group(const JournalDisk& disk, std::span<const JournalEntry> group);

// The next two functions change nothing on disk. Errors: Io naming a damaged file.
[[nodiscard]] Result<AlarmRecord> recover_alarms(const JournalDatabase& database);
/// Returns all jobs with their committed results, and the alarms. Checks the records of unfinished
/// jobs.
[[nodiscard]] Result<Recovered> recover(const JournalDatabase& database,
                                        const std::filesystem::path& jobs_folder);

/// The jobs found in a state directory, and the damage.
struct ExaminedJobs {
    std::vector<RecoveredJob> jobs; ///< By id; `results` is null if the segment is unusable.
    std::vector<Error> damage;      ///< One Io error for each damaged file.
};
/// Reads everything and checks all checksums. Continues after damage.
[[nodiscard]] ExaminedJobs examine_jobs(const JournalDatabase& database,
                                        const std::filesystem::path& jobs_folder);

/// Returns the path of some job's file in the folder, for `JournalDatabase::Options::owned`; empty
/// if the folder has none.
[[nodiscard]] std::filesystem::path file_of_a_job(const std::filesystem::path& jobs_folder);
/// Returns whether this is the name of a job's file.
[[nodiscard]] bool is_of_a_job(const std::string& name);

} // namespace cd
