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

/// The journal on disk, which writes on its own thread.
class DiskJournal final : public Journal {
  public:
    DiskJournal(const JournalOptions& options,
                std::unique_ptr<JournalDatabase> database,
                Recovered recovered)
        : Journal(options.directory / "jobs"),
          synced_(options.synced),
          database_(std::move(database)),
          recovered_(std::move(recovered)) {}
    ~DiskJournal() override;

    [[nodiscard]] Recovered take_recovered() override { return std::move(recovered_); }
    void start(JournalEvents events) override;
    std::uint64_t add(JournalEntry entry) override;
    [[nodiscard]] std::uint64_t queued_bytes() const override { return queued_bytes_; }
    [[nodiscard]] Result<JobRecord> job(JobId job) const override;
    [[nodiscard]] CommitTimes::Counts commit_times() const override { return times_.counts(); }

  private:
    void run();
    [[nodiscard]] std::vector<JournalEntry> next_group(SteadyClock::time_point not_before);
    [[nodiscard]] Status write(const std::vector<JournalEntry>& group);
    /// Retries until the group is written. False if the journal is destroyed before that.
    bool write_until_done(const std::vector<JournalEntry>& group);

    bool synced_;
    mutable std::mutex database_use_;
    std::unique_ptr<JournalDatabase> database_; ///< Guarded by `database_use_`.
    Recovered recovered_;
    JournalEvents events_;

    /// Entries that wait for a commit; `mutex_` guards them.
    struct Queue {
        std::deque<JournalEntry> entries;
        std::size_t rows = 0;
        bool urgent = false;
        bool stopping = false;
        std::uint64_t added = 0; ///< Number of entries ever added.
    };
    std::mutex mutex_;
    std::condition_variable changed_;
    Queue queue_;
    std::atomic<std::uint64_t> queued_bytes_ = 0;
    CommitTimes times_;

    std::uint64_t committed_ = 0; ///< Only the journal's thread uses it.
    std::thread thread_;
};

} // namespace

// ---- Writing ------------------------------------------------------------------------------------

Status DiskJournal::write(const std::vector<JournalEntry>& group) {
    const std::lock_guard lock(database_use_);
    return write_group({*database_, jobs_folder(), synced_}, group);
}

bool DiskJournal::write_until_done(const std::vector<JournalEntry>& group) {
    std::string told;
    for (;;) {
        const auto begin = SteadyClock::now();
        const Status status = write(group);
        if (status) {
            times_.add(SteadyClock::now() - begin);
            if (!told.empty()) {
                log_info("journal resumed");
                events_.paused("");
            }
            return true;
        }
        if (told != status.error().detail) {
            told = status.error().detail;
            log_error("journal cannot write, jobs paused: error=\"{}\"", told);
            events_.paused(told);
        }
        std::unique_lock lock(mutex_);
        if (changed_.wait_for(
                lock, timing::journal_retry_period, [this] { return queue_.stopping; })) {
            return false;
        }
    }
}

std::vector<JournalEntry> DiskJournal::next_group(SteadyClock::time_point not_before) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return queue_.stopping || !queue_.entries.empty(); });
    changed_.wait_until(lock, not_before, [this] {
        return queue_.stopping || queue_.urgent || queue_.rows >= limits::journal_group_rows;
    });
    std::vector<JournalEntry> group;
    std::size_t rows = 0;
    std::uint64_t bytes = 0;
    while (!queue_.entries.empty() && rows < limits::journal_commit_rows_max &&
           bytes < limits::journal_commit_bytes_max) {
        rows += rows_of(queue_.entries.front());
        bytes += bytes_of(queue_.entries.front());
        group.push_back(std::move(queue_.entries.front()));
        queue_.entries.pop_front();
    }
    queue_.rows -= rows;
    queue_.urgent = queue_.urgent && !queue_.entries.empty();
    return group;
}

void DiskJournal::run() {
    for (auto not_before = SteadyClock::now();;) {
        const std::vector<JournalEntry> group = next_group(not_before);
        not_before = SteadyClock::now() + timing::journal_commit_period;
        if (group.empty() || !write_until_done(group)) {
            return; // The journal is being destroyed.
        }
        for (const JournalEntry& entry : group) {
            queued_bytes_ -= bytes_of(entry);
        }
        committed_ += group.size();
        events_.committed(committed_);
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

Result<std::unique_ptr<Journal>> Journal::open(const JournalOptions& options) {
    const std::filesystem::path folder = options.directory / "jobs";
    if (const Status status = options.create ? make_directories(folder) : Status(Done{}); !status) {
        return status.error();
    }
    auto database = JournalDatabase::open(options.directory,
                                          {options.synced, options.create, file_of_a_job(folder)});
    if (!database) {
        return database.error();
    }
    auto recovered = recover(*database.value(), folder);
    if (!recovered) {
        return with_remedy(recovered.error());
    }
    if (options.create) {
        remove_leftovers(options, folder, recovered.value());
    }
    return std::unique_ptr<Journal>(std::make_unique<DiskJournal>(
        options, std::move(database.value()), std::move(recovered.value())));
}

// ---- The journal --------------------------------------------------------------------------------

DiskJournal::~DiskJournal() {
    {
        const std::lock_guard lock(mutex_);
        queue_.stopping = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) {
        thread_.join();
    }
}

void DiskJournal::start(JournalEvents events) {
    CD_CHECK(!thread_.joinable());
    events_ = std::move(events);
    thread_ = std::thread([this] { run(); });
}

std::uint64_t DiskJournal::add(JournalEntry entry) {
    queued_bytes_ += bytes_of(entry);
    const std::lock_guard lock(mutex_);
    queue_.rows += rows_of(entry);
    queue_.urgent = queue_.urgent || is_urgent(entry);
    queue_.entries.push_back(std::move(entry));
    changed_.notify_all();
    return ++queue_.added;
}

Result<JobRecord> DiskJournal::job(JobId job) const {
    const std::lock_guard lock(database_use_);
    const Result<Bytes> record = database_->record(job);
    return record ? decode_job(record.value()) : Result<JobRecord>(record.error());
}

} // namespace cd
