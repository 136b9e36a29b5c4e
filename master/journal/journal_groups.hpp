// What entries of the journal are on the disk: segments of records, and rows of the index that name
// them. The journal's work without its thread.
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

/// Of the records in it.
[[nodiscard]] std::uint64_t bytes_of(const JournalEntry& entry);
/// Results in it, and remarks.
[[nodiscard]] std::size_t rows_of(const JournalEntry& entry);

struct JournalDisk {
    JournalDatabase& database;
    std::filesystem::path jobs_folder; ///< Of the segments.
    bool synced = true;                ///< A segment is synced before the commit that names it.
};

/// All of the group in one commit, which is on the disk when this returns; or, with an error,
/// nothing of it that counts, and it may be tried again. Errors: Io.
[[nodiscard]] Status write_group(const JournalDisk& disk, std::span<const JournalEntry> group);

// Errors of both: Io naming the file that is damaged; nothing on the disk has been changed.
[[nodiscard]] Result<AlarmRecord> recover_alarms(const JournalDatabase& database);
/// All jobs by id, with what of their results is committed.
[[nodiscard]] Result<std::vector<RecoveredJob>> recover_jobs(
    const JournalDatabase& database, const std::filesystem::path& jobs_folder, bool check_records);

/// What there is of a state, damaged or not.
struct ExaminedJobs {
    std::vector<RecoveredJob> jobs; ///< By id; without `results` where they cannot be read at all.
    std::vector<Error> damage;      ///< As above; of each file one.
};
/// Reads all records against their checksums, and goes on behind what is damaged.
[[nodiscard]] ExaminedJobs examine_jobs(const JournalDatabase& database,
                                        const std::filesystem::path& jobs_folder);

/// Of whatever job, if there is one in the folder: `JournalDatabase::Options::owned`.
[[nodiscard]] std::filesystem::path file_of_a_job(const std::filesystem::path& jobs_folder);
/// Whether files of jobs are called so.
[[nodiscard]] bool is_of_a_job(const std::string& name);

} // namespace cd
