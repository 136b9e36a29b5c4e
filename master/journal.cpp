#include "master/journal.hpp"

#include "common/core/check.hpp"
#include "common/core/disk_file.hpp"
#include "common/core/limits.hpp"
#include "common/core/log.hpp"
#include "master/journal_database.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <set>
#include <thread>

namespace cd {

namespace {

using SteadyClock = std::chrono::steady_clock;

std::uint64_t bytes_of(const JournalEntry& entry) {
    std::uint64_t bytes = 0;
    if (const auto* add = std::get_if<AddResults>(&entry)) {
        for (const JournalResult& result : add->results) {
            bytes += result.record.size();
        }
    }
    return bytes;
}

std::size_t rows_of(const JournalEntry& entry) {
    const auto* add = std::get_if<AddResults>(&entry);
    return add == nullptr ? 0 : add->results.size();
}

/// Somebody waits for it, and nothing more of its kind comes soon.
bool is_urgent(const JournalEntry& entry) {
    return !std::holds_alternative<AddResults>(entry);
}

} // namespace

struct Journal::State {
    JournalOptions options;
    std::unique_ptr<JournalDatabase> database;
    Recovered recovered;
    JournalEvents events;

    mutable std::mutex mutex; ///< Guards these five.
    std::condition_variable changed;
    std::deque<JournalEntry> queue;
    std::size_t queued_rows = 0;
    bool urgent = false;
    bool stopping = false;
    std::uint64_t added = 0;
    std::atomic<std::uint64_t> queued_bytes = 0;

    std::uint64_t committed = 0; ///< Of the thread alone, as is all it calls.
    std::thread thread;

    void run();
    [[nodiscard]] std::vector<JournalEntry> next_group(SteadyClock::time_point not_before);
    /// False when it was not written, and the journal ends.
    bool write_until_done(const std::vector<JournalEntry>& group);
    [[nodiscard]] Status write(const std::vector<JournalEntry>& group);
    [[nodiscard]] std::filesystem::path jobs_folder() const { return options.directory / "jobs"; }
};

// ---- Writing ------------------------------------------------------------------------------------

namespace {

/// What a group of entries adds to one job.
struct JobChanges {
    std::shared_ptr<ResultStore> store;
    std::vector<StoredRecord> records;
    ResultGroup rows;
    const JobProgress* progress = nullptr;
};

using ChangesByJob = std::map<JobId, JobChanges>;

ChangesByJob gather(const std::vector<JournalEntry>& group) {
    ChangesByJob by_job;
    for (const JournalEntry& entry : group) {
        if (const auto* add = std::get_if<AddResults>(&entry)) {
            JobChanges& changes = by_job[add->job];
            changes.store = add->store;
            changes.progress = &add->progress;
            for (const JournalResult& result : add->results) {
                changes.records.push_back({result.row.scenario, result.record});
                changes.rows.rows.push_back(result.row);
            }
        } else if (const auto* end = std::get_if<EndJob>(&entry)) {
            by_job[end->job].progress = &end->progress;
        }
    }
    return by_job;
}

std::vector<DatabaseChange> database_changes(const std::vector<JournalEntry>& group,
                                             const ChangesByJob& by_job) {
    using Kind = DatabaseChange::Kind;
    std::vector<DatabaseChange> changes;
    for (const JournalEntry& entry : group) {
        if (const auto* accept = std::get_if<AcceptJob>(&entry)) {
            changes.push_back({Kind::Accept, accept->job.id, encode_job(accept->job)});
        }
    }
    for (const auto& [job, added] : by_job) {
        if (!added.rows.rows.empty()) {
            changes.push_back({Kind::Results, job, encode_group(added.rows)});
        }
        changes.push_back({Kind::Progress, job, encode_progress(*added.progress)});
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

Status Journal::State::write(const std::vector<JournalEntry>& group) {
    ChangesByJob by_job = gather(group);
    bool has_new_segments = false;
    for (auto& [job, changes] : by_job) {
        if (changes.store == nullptr) {
            continue;
        }
        changes.rows.begin = changes.store->end();
        has_new_segments = has_new_segments || !changes.store->has_file();
        if (Status status = changes.store->write(changes.records); !status) {
            return status;
        }
        if (Status status = options.synced ? changes.store->sync() : Status(Done{}); !status) {
            return status;
        }
    }
    const bool has_new_files =
        std::any_of(group.begin(), group.end(), [](const JournalEntry& entry) {
            return std::holds_alternative<AcceptJob>(entry);
        });
    if (options.synced && (has_new_files || has_new_segments)) {
        if (Status status = sync_directory(jobs_folder()); !status) {
            return status;
        }
    }
    if (Status status = database->write(database_changes(group, by_job)); !status) {
        return status;
    }
    for (auto& [job, changes] : by_job) {
        if (changes.store != nullptr) {
            changes.store->commit();
        }
    }
    return Done{};
}

bool Journal::State::write_until_done(const std::vector<JournalEntry>& group) {
    std::string told;
    for (;;) {
        const Status status = write(group);
        if (status) {
            if (!told.empty()) {
                spdlog::info("journal goes on");
                events.paused("");
            }
            return true;
        }
        if (told != status.error().detail) {
            told = status.error().detail;
            spdlog::error("journal cannot write, jobs wait: error=\"{}\"", told);
            events.paused(told);
        }
        std::unique_lock lock(mutex);
        if (changed.wait_for(lock, limits::journal_retry_period, [this] { return stopping; })) {
            return false;
        }
    }
}

std::vector<JournalEntry> Journal::State::next_group(SteadyClock::time_point not_before) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [this] { return stopping || !queue.empty(); });
    changed.wait_until(lock, not_before, [this] {
        return stopping || urgent || queued_rows >= limits::journal_group_rows;
    });
    std::vector<JournalEntry> group;
    std::size_t rows = 0;
    std::uint64_t bytes = 0;
    while (!queue.empty() && rows < limits::journal_commit_rows_max &&
           bytes < limits::journal_commit_bytes_max) {
        rows += rows_of(queue.front());
        bytes += bytes_of(queue.front());
        group.push_back(std::move(queue.front()));
        queue.pop_front();
    }
    queued_rows -= rows;
    urgent = urgent && !queue.empty();
    return group;
}

void Journal::State::run() {
    for (auto not_before = SteadyClock::now();;) {
        const std::vector<JournalEntry> group = next_group(not_before);
        not_before = SteadyClock::now() + limits::journal_group_period;
        if (group.empty() || !write_until_done(group)) {
            return; // Told to stop.
        }
        for (const JournalEntry& entry : group) {
            queued_bytes -= bytes_of(entry);
        }
        committed += group.size();
        events.committed(committed);
    }
}

// ---- Recovering ---------------------------------------------------------------------------------

namespace {

/// A job while its groups of results are read.
struct FoundJob {
    RecoveredJob job;
    std::vector<ResultRow> rows;
    std::vector<RecordPlace> places;
    std::uint64_t end = 0; ///< Of its segment.
};

using FoundJobs = std::map<JobId, FoundJob>;

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
    }
    if (!row.end.empty()) {
        Result<JobEnd> end = decode_end(row.end);
        if (!end) {
            return end.error();
        }
        found.job.end = std::move(end.value());
    }
    found.job.merger = ResultMerger(found.job.record.submit.scenarios);
    return found;
}

Result<FoundJobs> find_jobs(const JournalDatabase& database) {
    const Result<std::vector<DatabaseJob>> rows = database.jobs();
    if (!rows) {
        return rows.error();
    }
    FoundJobs jobs;
    for (const DatabaseJob& row : rows.value()) {
        Result<FoundJob> found = decode_found(row);
        if (!found) {
            return damaged(database.path(), row.id, found.error().detail);
        }
        jobs.emplace(row.id, std::move(found.value()));
    }
    const Status read = database.for_each_results([&](JobId id, std::span<const std::byte> bytes) {
        const auto found = jobs.find(id);
        const Result<ResultGroup> group = decode_group(bytes);
        if (found == jobs.end() || !group) {
            return Status(damaged(database.path(), id, "results of a job that is not there"));
        }
        FoundJob& job = found->second;
        if (job.end != 0 && group.value().begin != job.end) {
            return Status(damaged(database.path(), id, "results are missing"));
        }
        job.end = group.value().begin;
        for (const ResultRow& row : group.value().rows) {
            job.rows.push_back(row);
            job.places.push_back(ResultStore::place_at(job.end, row.length));
            job.end = ResultStore::end_of(job.places.back());
        }
        return Status(Done{});
    });
    return read ? Result<FoundJobs>(std::move(jobs)) : Result<FoundJobs>(read.error());
}

/// Opens the job's segment and fills what is in memory.
Status restore(FoundJob& found, const std::filesystem::path& path, bool check_records) {
    RecoveredJob& job = found.job;
    const std::uint64_t scenarios = job.record.submit.scenarios;
    auto store = ResultStore::open(path, job.record.id, scenarios, found.end);
    if (!store) {
        return store.error();
    }
    job.results = std::move(store.value());
    // The last result of a scenario counts: one before it turned out to be wrong.
    for (std::size_t i = found.rows.size(); i-- > 0;) {
        const ResultRow& row = found.rows[i];
        if (job.merger.has(row.scenario)) {
            continue;
        }
        if (Status status = job.results->restore(row.scenario, found.places[i]); !status) {
            return status;
        }
        (void)job.merger.add(row.scenario, row.facts, row.digest);
        if (!job.end) {
            job.done.push_back(row.scenario);
        }
    }
    if (job.end && job.end->digest && job.merger.digest() != job.end->digest) {
        return damaged(path, job.record.id, "its results do not have its digest");
    }
    return check_records ? job.results->verify() : Status(Done{});
}

/// What a master that was killed has left half-made, and files of jobs that are no more. The
/// journal has been found to be sound.
void remove_leftovers(const std::filesystem::path& folder, const Recovered& recovered) {
    std::set<std::string> known;
    for (const RecoveredJob& job : recovered.jobs) {
        const std::string number = std::to_string(job.record.id.value);
        known.insert(number + ".results");
        if (!job.end) {
            known.insert(number + ".poses");
        }
    }
    std::error_code ignored;
    std::vector<std::filesystem::path> leftovers;
    for (const auto& file : std::filesystem::directory_iterator(folder, ignored)) {
        const std::string name = file.path().filename().string();
        const bool is_ours = name.ends_with(".results") || name.ends_with(".poses") ||
                             name.find(temporary_marker) != std::string::npos;
        if (is_ours && !known.contains(name)) {
            leftovers.push_back(file.path());
        }
    }
    for (const auto& path : leftovers) {
        std::filesystem::remove(path, ignored);
    }
}

/// Results without a journal would be written over.
Status check_none_left(const std::filesystem::path& folder) {
    std::error_code ignored;
    for (const auto& file : std::filesystem::directory_iterator(folder, ignored)) {
        if (file.path().extension() == ".results") {
            return Error{ErrorCode::Io,
                         "journal.db is missing, but there is " + file.path().string() +
                             "; restore the state directory from a copy, or start with an empty "
                             "one"};
        }
    }
    return Done{};
}

} // namespace

Journal::Journal(std::unique_ptr<State> state) : state_(std::move(state)) {}

Result<std::unique_ptr<Journal>> Journal::open(const JournalOptions& options) {
    auto state = std::make_unique<State>();
    state->options = options;
    if (const Status status =
            options.create ? make_directories(state->jobs_folder()) : Status(Done{});
        !status) {
        return status.error();
    }
    if (!std::filesystem::exists(options.directory / "journal.db") &&
        !std::filesystem::exists(options.directory / "journal.mark")) {
        if (const Status status = check_none_left(state->jobs_folder()); !status) {
            return status.error();
        }
    }
    auto database = JournalDatabase::open(options.directory, {options.synced, options.create});
    if (!database) {
        return database.error();
    }
    Result<FoundJobs> jobs = find_jobs(*database.value());
    if (!jobs) {
        return jobs.error();
    }
    state->database = std::move(database.value());
    auto journal = std::unique_ptr<Journal>(new Journal(std::move(state)));
    Recovered& recovered = journal->state_->recovered;
    recovered.cluster = journal->state_->database->cluster();
    recovered.last_job = journal->state_->database->last_job();
    for (auto& [id, found] : jobs.value()) {
        const bool check_records = options.check_records && !found.job.end;
        if (const Status status = restore(found, journal->results_path(id), check_records);
            !status) {
            return status.error();
        }
        recovered.jobs.push_back(std::move(found.job));
    }
    if (options.create) {
        remove_leftovers(journal->state_->jobs_folder(), recovered);
    }
    return journal;
}

// ---- The journal --------------------------------------------------------------------------------

Journal::~Journal() {
    {
        const std::lock_guard lock(state_->mutex);
        state_->stopping = true;
    }
    state_->changed.notify_all();
    if (state_->thread.joinable()) {
        state_->thread.join();
    }
}

Recovered Journal::take_recovered() {
    return std::move(state_->recovered);
}

void Journal::start(JournalEvents events) {
    CD_CHECK(!state_->thread.joinable());
    state_->events = std::move(events);
    state_->thread = std::thread([this] { state_->run(); });
}

std::uint64_t Journal::add(JournalEntry entry) {
    state_->queued_bytes += bytes_of(entry);
    const std::lock_guard lock(state_->mutex);
    state_->queued_rows += rows_of(entry);
    state_->urgent = state_->urgent || is_urgent(entry);
    state_->queue.push_back(std::move(entry));
    state_->changed.notify_all();
    return ++state_->added;
}

std::uint64_t Journal::queued_bytes() const {
    return state_->queued_bytes;
}

std::filesystem::path Journal::results_path(JobId job) const {
    return state_->jobs_folder() / (std::to_string(job.value) + ".results");
}

std::filesystem::path Journal::poses_path(JobId job) const {
    return state_->jobs_folder() / (std::to_string(job.value) + ".poses");
}

} // namespace cd
