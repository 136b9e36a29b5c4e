#include "master/journal/journal_groups.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/limits/engine.hpp"
#include "common/job/result/packed_map.hpp"
#include "master/base/mutation.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <unordered_set>
#include <utility>

namespace cd {

std::uint64_t bytes_of(const JournalEntry& entry) {
    std::uint64_t bytes = 0;
    if (const auto* add = std::get_if<AddResults>(&entry)) {
        bytes += add->results.stored().size() + add->map.size();
    }
    return bytes;
}

std::size_t rows_of(const JournalEntry& entry) {
    const auto* add = std::get_if<AddResults>(&entry);
    return add == nullptr ? 0 : add->results.size() + add->remarks.size() + add->losses.size();
}

// ---- Writing ------------------------------------------------------------------------------------

namespace {

/// Changes of one job in a group of entries.
struct JobChanges {
    std::shared_ptr<ResultStore> store;
    std::vector<const ResultBatch*> batches;
    ResultGroup rows;
    std::set<std::uint64_t> withdrawn; ///< Scenarios that these changes leave without a result.
    const JobProgress* progress = nullptr;
};

using ChangesByJob = std::map<JobId, JobChanges>;

void add_results(JobChanges& changes, const AddResults& add) {
    changes.store = add.store;
    changes.progress = &add.progress;
    changes.withdrawn.insert(add.withdrawn.begin(), add.withdrawn.end());
    const std::span<const ResultRow> rows = add.results.rows();
    if (!changes.withdrawn.empty()) {
        for (const ResultRow& row : rows) {
            changes.withdrawn.erase(row.scenario);
        }
    }
    if (!add.map.empty()) {
        changes.rows.maps.push_back(add.map);
    }
    std::vector<AuthorRun>& runs = changes.rows.authors;
    if (!rows.empty()) {
        changes.batches.push_back(&add.results);
        changes.rows.rows.insert(changes.rows.rows.end(), rows.begin(), rows.end());
        if (runs.empty() || runs.back().author != add.author) {
            runs.push_back({0, add.author});
        }
        runs.back().rows += rows.size();
    }
    std::vector<Remark>& remarks = changes.rows.remarks;
    remarks.insert(remarks.end(), add.remarks.begin(), add.remarks.end());
    std::vector<LostPositions>& losses = changes.rows.losses;
    losses.insert(losses.end(), add.losses.begin(), add.losses.end());
}

ChangesByJob gather(std::span<const JournalEntry> group) {
    ChangesByJob by_job;
    for (const JournalEntry& entry : group) {
        if (const auto* add = std::get_if<AddResults>(&entry)) {
            add_results(by_job[add->job], *add);
        } else if (const auto* end = std::get_if<EndJob>(&entry)) {
            by_job[end->job].progress = &end->progress;
        }
    }
    return by_job;
}

std::vector<DatabaseChange> database_changes(std::span<const JournalEntry> group,
                                             const ChangesByJob& by_job) {
    using Kind = DatabaseChange::Kind;
    std::vector<DatabaseChange> changes;
    for (const JournalEntry& entry : group) {
        if (const auto* accept = std::get_if<AcceptJob>(&entry)) {
            changes.push_back({Kind::Accept, accept->job.id, encode_job(accept->job)});
        } else if (const auto* change = std::get_if<ChangeJob>(&entry)) {
            changes.push_back({Kind::Record, change->job.id, encode_job(change->job)});
        }
    }
    for (const auto& [job, added] : by_job) {
        if (!added.rows.rows.empty() || !added.rows.remarks.empty() || !added.rows.losses.empty()) {
            changes.push_back({Kind::Results, job, encode_group(added.rows)});
        }
        changes.push_back({Kind::Progress, job, encode_progress(*added.progress)});
    }
    // The last alarm record of the group replaces the earlier ones.
    const AlarmRecord* alarms = nullptr;
    for (const JournalEntry& entry : group) {
        if (const auto* add = std::get_if<AddResults>(&entry); add != nullptr && add->alarms) {
            alarms = &*add->alarms;
        }
    }
    if (alarms != nullptr) {
        changes.push_back({Kind::Alarms, JobId{}, encode_alarms(*alarms)});
    }
    for (const JournalEntry& entry : group) {
        if (const auto* end = std::get_if<EndJob>(&entry)) {
            changes.push_back({Kind::End, end->job, encode_end(end->end)});
        } else if (const auto* drop = std::get_if<DropJob>(&entry)) {
            changes.push_back({Kind::Drop, drop->job, {}});
        }
    }
    return changes;
}

} // namespace

Status write_group(const JournalDisk& disk, std::span<const JournalEntry> group) {
    ChangesByJob by_job = gather(group);
    bool has_new_segments = false;
    for (auto& [job, changes] : by_job) {
        if (changes.store == nullptr) {
            continue;
        }
        changes.rows.begin = changes.store->end();
        if (changes.batches.empty()) {
            continue;
        }
        if (Status status = changes.store->write(changes.batches); !status) {
            return status;
        }
        // Also true for a file that an earlier, failed attempt created.
        has_new_segments = has_new_segments || changes.store->has_new_name();
        if (Status status = disk.synced && !mutated(Mutation::SegmentNotSynced)
                                ? changes.store->sync()
                                : Status(Done{});
            !status) {
            return status;
        }
    }
    const bool has_new_files =
        std::any_of(group.begin(), group.end(), [](const JournalEntry& entry) {
            return std::holds_alternative<AcceptJob>(entry);
        });
    if (disk.synced && (has_new_files || has_new_segments)) {
        if (Status status = sync_directory(disk.jobs_folder); !status) {
            return status;
        }
        for (auto& [job, changes] : by_job) {
            if (changes.store != nullptr) {
                changes.store->name_synced();
            }
        }
    }
    if (Status status = disk.database.write(database_changes(group, by_job)); !status) {
        return status;
    }
    for (auto& [job, changes] : by_job) {
        if (!changes.batches.empty()) {
            changes.store->commit();
        }
        for (const std::uint64_t scenario : changes.withdrawn) {
            changes.store->withdraw(scenario);
        }
    }
    return Done{};
}

// ---- Recovering ---------------------------------------------------------------------------------

namespace {

/// A job while its groups of results are read.
struct FoundJob {
    RecoveredJob job;
    std::vector<ResultRow> rows;
    std::vector<RecordPlace> places;
    std::vector<InstanceId> authors;              ///< Author of each row.
    std::vector<bool> withdrawn;                  ///< For each row: true if it was withdrawn.
    std::uint64_t end = ResultStore::first_end(); ///< Committed end of the segment.
};

Error damaged(const std::filesystem::path& path, JobId job, const std::string& why) {
    return {ErrorCode::Io,
            path.string() + " is damaged: job " + std::to_string(job.value) + ": " + why};
}

Result<FoundJob> decode_found(const DatabaseJob& row) {
    FoundJob found;
    Result<JobRecord> record = decode_job(row.record);
    if (!record) {
        return record.error();
    }
    found.job.record = std::move(record.value());
    if (!row.progress.empty()) {
        const Result<JobProgress> progress = decode_progress(row.progress);
        if (!progress) {
            return progress.error();
        }
        found.job.progress = progress.value();
        if (const std::string& why = progress.value().map_withdrawn; !why.empty()) {
            found.job.map.withdraw(why);
        }
    }
    if (!row.end.empty()) {
        Result<JobEnd> end = decode_end(row.end);
        if (!end) {
            return end.error();
        }
        found.job.end = std::move(end.value());
    }
    const Submit& submit = found.job.record.submit;
    found.job.merger = ResultMerger(submit.scenarios, submit.scene_head());
    return found;
}

void take_rows(FoundJob& job, const ResultGroup& group) {
    job.end = group.begin;
    for (const ResultRow& row : group.rows) {
        job.rows.push_back(row);
        job.places.push_back(ResultStore::place_at(job.end, row.length));
        job.end = ResultStore::end_of(job.places.back());
    }
    for (const AuthorRun& run : group.authors) {
        job.authors.insert(job.authors.end(), run.rows, run.author);
        if (run.author != 0) {
            job.job.contributors.insert(run.author);
        }
    }
    job.withdrawn.resize(job.rows.size());
}

/// Marks the author's rows read so far as withdrawn. The author has no rows in later groups.
void withdraw_rows(FoundJob& job, InstanceId author) {
    for (std::size_t i = 0; i < job.rows.size(); ++i) {
        if (job.authors[i] == author && !job.withdrawn[i]) {
            job.withdrawn[i] = true;
            ++job.job.withdrawn;
        }
    }
    job.job.contributors.erase(author);
}

void take_remarks(FoundJob& job, std::span<const Remark> remarks) {
    for (const Remark& remark : remarks) {
        if (remark.kind == Remark::Kind::Disputed) {
            job.job.disputes.push_back(remark);
        } else if (remark.kind == Remark::Kind::Withdrawn) {
            withdraw_rows(job, remark.author);
        } else {
            std::erase_if(job.job.disputes, [&](const Remark& open) {
                return open.scenario == remark.scenario && open.digest == remark.digest &&
                       open.author == remark.author;
            });
        }
    }
}

Result<FoundJob> find_job(const JournalDatabase& database, const DatabaseJob& row) {
    Result<FoundJob> found = decode_found(row);
    if (!found) {
        return damaged(database.path(), row.id, found.error().detail);
    }
    FoundJob& job = found.value();
    const Status read = database.for_each_results(row.id, [&](std::span<const std::byte> bytes) {
        const Result<ResultGroup> group = decode_group(bytes);
        if (!group) {
            return Status(damaged(database.path(), row.id, group.error().detail));
        }
        if (group.value().begin != job.end) {
            return Status(damaged(database.path(), row.id, "results are missing"));
        }
        take_rows(job, group.value());
        take_remarks(job, group.value().remarks);
        const auto& losses = group.value().losses;
        job.job.losses.insert(job.job.losses.end(), losses.begin(), losses.end());
        for (const Bytes& packed : group.value().maps) {
            // The journal does not know the sizes of the job's meshes.
            const Result<ContactMap> map = unpack_map(packed, any_map());
            if (!map) {
                return Status(damaged(database.path(), row.id, "a map that is none"));
            }
            job.job.map.add(map.value());
        }
        return Status(Done{});
    });
    return read ? std::move(found) : Result<FoundJob>(read.error());
}

/// Reads the jobs and passes them to `take` one at a time, because a job's rows take much more
/// memory than the part that is kept. Stops at an error of `take`.
Status for_each_job(const JournalDatabase& database,
                    const std::function<Status(Result<FoundJob>)>& take) {
    const Result<std::vector<DatabaseJob>> rows = database.jobs();
    if (!rows) {
        return rows.error();
    }
    for (const DatabaseJob& row : rows.value()) {
        if (Status taken = take(find_job(database, row)); !taken) {
            return taken;
        }
    }
    return database.check_owners();
}

std::filesystem::path segment_path(const std::filesystem::path& jobs_folder, JobId job) {
    return jobs_folder / (std::to_string(job.value) + ".results");
}

/// Returns the newest valid row of each scenario, in the order of the records in the file.
std::vector<std::size_t> valid_rows(const FoundJob& found) {
    std::vector<std::size_t> valid;
    std::unordered_set<std::uint64_t> seen;
    // Goes from the newest to the oldest row: of several rows of a scenario only the newest counts.
    for (std::size_t i = found.rows.size(); i-- > 0;) {
        const bool is_missed = mutated(Mutation::GroupNotRecovered) && i + 1 == found.rows.size();
        if (!found.withdrawn[i] && !is_missed && seen.insert(found.rows[i].scenario).second) {
            valid.push_back(i);
        }
    }
    // The order of `ResultStore::verify`.
    std::ranges::sort(valid, {}, [&](std::size_t row) {
        return std::pair(found.places[row].offset, found.rows[row].scenario);
    });
    return valid;
}

/// Checks the records of the rows, and merges the rows with the digests of their records.
Status merge_records(FoundJob& found, std::span<const std::size_t> rows) {
    RecoveredJob& job = found.job;
    auto next = rows.begin();
    return job.results->verify([&](std::uint64_t scenario, std::span<const std::byte> record) {
        const std::size_t row = *next++;
        CD_CHECK(found.rows[row].scenario == scenario);
        if (mutated(Mutation::DoneIsDoneAgain) && !job.end) {
            return;
        }
        (void)job.merger.add(scenario, found.rows[row].facts, digest_of_record(record));
        if (!job.end) {
            job.done.push_back(found.rows[row]);
            job.authors.push_back(found.authors[row]);
        }
    });
}

/// Opens the job's segment, and fills the members of `found.job` from the rows. Reads and checks
/// the records of an ended job only with `records`; otherwise its merger has no digests.
Status restore(FoundJob& found, const std::filesystem::path& path, bool records) {
    RecoveredJob& job = found.job;
    const std::uint64_t scenarios = job.record.submit.scenarios;
    if (job.end) {
        job.results = ResultStore::open_to_read(path, job.record.id, scenarios, found.end);
        job.map.finish();
        job.losses = {};
    } else {
        auto store = ResultStore::open(path, job.record.id, scenarios, found.end);
        if (!store) {
            return store.error();
        }
        job.results = std::move(store.value());
    }
    const std::vector<std::size_t> rows = valid_rows(found);
    for (const std::size_t i : rows) {
        CD_TRY(job.results->restore(found.rows[i].scenario, found.places[i]));
    }
    const auto is_scenario = [&](const Remark& open) { return open.scenario < scenarios; };
    if (!std::ranges::all_of(job.disputes, is_scenario)) {
        return damaged(path, job.record.id, "a scenario that it does not have is in dispute");
    }
    const auto is_place = [&](const LostPositions& lost) {
        return lost.positions.end() <= scenarios;
    };
    if (!std::ranges::all_of(job.losses, is_place)) {
        return damaged(path, job.record.id, "scenarios that it does not have were lost");
    }
    if (job.end && !records) {
        for (const std::size_t i : rows) {
            (void)job.merger.add(found.rows[i].scenario, found.rows[i].facts, {});
        }
        return Done{};
    }
    CD_TRY(merge_records(found, rows));
    if (job.end && job.end->digest && job.merger.digest() != job.end->digest) {
        return damaged(path, job.record.id, "its results do not have its digest");
    }
    return Done{};
}

} // namespace

Result<AlarmRecord> recover_alarms(const JournalDatabase& database) {
    const Result<Bytes> row = database.alarms();
    if (!row) {
        return row.error();
    }
    if (row.value().empty()) {
        return AlarmRecord();
    }
    Result<AlarmRecord> alarms = decode_alarms(row.value());
    if (!alarms) {
        return Error{ErrorCode::Io,
                     database.path().string() + " is damaged: " + alarms.error().detail};
    }
    return alarms;
}

Result<Recovered> recover(const JournalDatabase& database,
                          const std::filesystem::path& jobs_folder) {
    Recovered recovered;
    const Status read = for_each_job(database, [&](Result<FoundJob> found) {
        if (!found) {
            return Status(found.error());
        }
        RecoveredJob& job = found.value().job;
        const auto segment = segment_path(jobs_folder, job.record.id);
        if (Status restored = restore(found.value(), segment, false); !restored) {
            return restored;
        }
        if (job.end) {
            job.merger.close();
        }
        recovered.jobs.push_back(std::move(job));
        return Status(Done{});
    });
    if (!read) {
        return read.error();
    }
    Result<AlarmRecord> alarms = recover_alarms(database);
    if (!alarms) {
        return alarms.error();
    }
    recovered.cluster = database.cluster();
    recovered.last_job = database.last_job();
    recovered.alarms = std::move(alarms.value());
    return recovered;
}

ExaminedJobs examine_jobs(const JournalDatabase& database,
                          const std::filesystem::path& jobs_folder) {
    ExaminedJobs examined;
    const Status read = for_each_job(database, [&](Result<FoundJob> found) {
        if (!found) {
            examined.damage.push_back(found.error());
            return Status(Done{});
        }
        RecoveredJob& job = found.value().job;
        const auto segment = segment_path(jobs_folder, job.record.id);
        if (const Status sound = restore(found.value(), segment, true); !sound) {
            examined.damage.push_back(sound.error());
        }
        job.merger.close();
        examined.jobs.push_back(std::move(job));
        return Status(Done{});
    });
    if (!read) {
        examined.damage.push_back(read.error());
    }
    return examined;
}

bool is_of_a_job(const std::string& name) {
    return name.ends_with(".results") || name.ends_with(".poses") || name.ends_with(".labels");
}

std::filesystem::path file_of_a_job(const std::filesystem::path& jobs_folder) {
    std::error_code ignored;
    for (const auto& file : std::filesystem::directory_iterator(jobs_folder, ignored)) {
        if (is_of_a_job(file.path().filename().string())) {
            return file.path();
        }
    }
    return {};
}

} // namespace cd
