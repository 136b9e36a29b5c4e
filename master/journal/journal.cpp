#include "master/journal/journal.hpp"

#include "common/core/check.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/host/log.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"
#include "master/base/remedy.hpp"
#include "master/journal/journal_database.hpp"
#include "master/journal/journal_groups.hpp"

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

/// Returns whether the entry must be written at once: a client may wait for it. Results can wait
/// for more results.
bool is_urgent(const JournalEntry& entry) {
    return !std::holds_alternative<AddResults>(entry);
}

} // namespace

struct Journal::State {
    JournalOptions options;
    std::mutex database_use;
    std::unique_ptr<JournalDatabase> database; ///< Guarded by `database_use`.
    Recovered recovered;
    JournalEvents events;

    mutable std::mutex mutex; ///< Guards the members from `queue` to `added`.
    std::condition_variable changed;
    std::deque<JournalEntry> queue;
    std::size_t queued_rows = 0;
    bool urgent = false;
    bool stopping = false;
    std::uint64_t added = 0;
    std::atomic<std::uint64_t> queued_bytes = 0;

    std::uint64_t committed = 0; ///< Only the journal's thread uses it.
    std::thread thread;

    void run();
    [[nodiscard]] std::vector<JournalEntry> next_group(SteadyClock::time_point not_before);
    [[nodiscard]] Status write(const std::vector<JournalEntry>& group);
    /// Retries until the group is written. False if the journal is destroyed before that.
    bool write_until_done(const std::vector<JournalEntry>& group);
    [[nodiscard]] std::filesystem::path jobs_folder() const { return options.directory / "jobs"; }
};

// ---- Writing ------------------------------------------------------------------------------------

Status Journal::State::write(const std::vector<JournalEntry>& group) {
    const std::lock_guard lock(database_use);
    return write_group({*database, jobs_folder(), options.synced}, group);
}

bool Journal::State::write_until_done(const std::vector<JournalEntry>& group) {
    std::string told;
    for (;;) {
        const Status status = write(group);
        if (status) {
            if (!told.empty()) {
                log_info("journal resumed");
                events.paused("");
            }
            return true;
        }
        if (told != status.error().detail) {
            told = status.error().detail;
            log_error("journal cannot write, jobs paused: error=\"{}\"", told);
            events.paused(told);
        }
        std::unique_lock lock(mutex);
        if (changed.wait_for(lock, timing::journal_retry_period, [this] { return stopping; })) {
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
        not_before = SteadyClock::now() + timing::journal_group_period;
        if (group.empty() || !write_until_done(group)) {
            return; // The journal is being destroyed.
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

/// Deletes the temporary files of a killed master, and files of dropped jobs. Call only after the
/// journal was found intact.
void remove_leftovers(const JournalOptions& options,
                      const std::filesystem::path& folder,
                      const Recovered& recovered) {
    std::set<std::string> known;
    for (const RecoveredJob& job : recovered.jobs) {
        const std::string number = std::to_string(job.record.id.value);
        known.insert(number + ".results");
        known.insert(number + ".poses");
        known.insert(number + ".labels");
    }
    std::error_code ignored;
    std::vector<std::filesystem::path> leftovers;
    for (const auto& file : std::filesystem::directory_iterator(folder, ignored)) {
        const std::string name = file.path().filename().string();
        const bool is_ours = is_of_a_job(name) || name.find(temporary_marker) != std::string::npos;
        if (is_ours && !known.contains(name)) {
            leftovers.push_back(file.path());
        }
    }
    for (const auto& file : std::filesystem::directory_iterator(options.directory, ignored)) {
        const std::string unfinished = "journal.mark" + std::string(temporary_marker);
        if (file.path().filename().string().starts_with(unfinished)) {
            leftovers.push_back(file.path());
        }
    }
    for (const auto& path : leftovers) {
        std::filesystem::remove(path, ignored);
    }
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
    auto database = JournalDatabase::open(
        options.directory, {options.synced, options.create, file_of_a_job(state->jobs_folder())});
    if (!database) {
        return database.error();
    }
    auto jobs = recover_jobs(*database.value(), state->jobs_folder(), options.check_records);
    if (!jobs) {
        return with_remedy(jobs.error());
    }
    auto alarms = recover_alarms(*database.value());
    if (!alarms) {
        return with_remedy(alarms.error());
    }
    state->database = std::move(database.value());
    Recovered& recovered = state->recovered;
    recovered.cluster = state->database->cluster();
    recovered.last_job = state->database->last_job();
    recovered.jobs = std::move(jobs.value());
    recovered.alarms = std::move(alarms.value());
    if (options.create) {
        remove_leftovers(options, state->jobs_folder(), recovered);
    }
    return std::unique_ptr<Journal>(new Journal(std::move(state)));
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

Result<JobRecord> Journal::job(JobId job) const {
    const std::lock_guard lock(state_->database_use);
    const Result<Bytes> record = state_->database->record(job);
    return record ? decode_job(record.value()) : Result<JobRecord>(record.error());
}

std::filesystem::path Journal::results_path(JobId job) const {
    return state_->jobs_folder() / (std::to_string(job.value) + ".results");
}

std::filesystem::path Journal::labels_path(JobId job) const {
    return state_->jobs_folder() / (std::to_string(job.value) + ".labels");
}

std::filesystem::path Journal::poses_path(JobId job) const {
    return state_->jobs_folder() / (std::to_string(job.value) + ".poses");
}

} // namespace cd
