// Stores journal entries as segments of records and as index rows that name them: the journal's
// work without its thread.
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

/// Returns the bytes of the entry's records.
[[nodiscard]] std::uint64_t bytes_of(const JournalEntry& entry);
/// Returns the number of results and remarks in the entry.
[[nodiscard]] std::size_t rows_of(const JournalEntry& entry);

struct JournalDisk {
    JournalDatabase& database;
    std::filesystem::path jobs_folder; ///< Folder of the segments.
    bool synced = true;                ///< A segment is synced before the commit that names it.
};

/// Writes the group in one commit, which is on disk when this returns. After an error nothing of
/// the group counts, and the call may be repeated. Errors: Io.
[[nodiscard]] Status write_group(const JournalDisk& disk, std::span<const JournalEntry> group);

// Errors of both functions: Io naming a damaged file; nothing on disk has been changed.
[[nodiscard]] Result<AlarmRecord> recover_alarms(const JournalDatabase& database);
/// Returns all jobs by id, with their committed results.
[[nodiscard]] Result<std::vector<RecoveredJob>> recover_jobs(
    const JournalDatabase& database, const std::filesystem::path& jobs_folder, bool check_records);

/// Contents of a state, damaged or not.
struct ExaminedJobs {
    std::vector<RecoveredJob> jobs; ///< Jobs by id; `results` is empty if they are unreadable.
    std::vector<Error> damage;      ///< One Io error for each damaged file.
};
/// Reads all records against their checksums, and continues past damage.
[[nodiscard]] ExaminedJobs examine_jobs(const JournalDatabase& database,
                                        const std::filesystem::path& jobs_folder);

/// Returns a file of any job in the folder, or none: `JournalDatabase::Options::owned`.
[[nodiscard]] std::filesystem::path file_of_a_job(const std::filesystem::path& jobs_folder);
/// Returns whether this is the name of a job's file.
[[nodiscard]] bool is_of_a_job(const std::string& name);

} // namespace cd
