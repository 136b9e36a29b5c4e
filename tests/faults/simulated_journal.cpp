// Replaces SQLite by rows in memory, with atomic commits, and the journal's thread by writes of
// groups at simulated times.
#include "common/core/timing/master.hpp"
#include "master/journal/journal.hpp"
#include "master/journal/journal_groups.hpp"
#include "tests/faults/world.hpp"

namespace cd {

using namespace std::chrono_literals;
using tests::DurableJob;
using tests::World;

// ---- The index --------------------------------------------------------------------------------

struct JournalDatabase::State {
    std::filesystem::path path;
    Sha256 cluster = sha256({});
};

JournalDatabase::JournalDatabase(std::unique_ptr<State> state) : state_(std::move(state)) {}
JournalDatabase::~JournalDatabase() = default;

Result<std::unique_ptr<JournalDatabase>>
JournalDatabase::open(const std::filesystem::path& directory, const Options&) {
    auto state = std::make_unique<State>();
    state->path = directory / "journal.db";
    return std::unique_ptr<JournalDatabase>(new JournalDatabase(std::move(state)));
}

const Sha256& JournalDatabase::cluster() const {
    return state_->cluster;
}

JobId JournalDatabase::last_job() const {
    return World::current()->watcher.last_job;
}

Result<std::vector<DatabaseJob>> JournalDatabase::jobs() const {
    std::vector<DatabaseJob> jobs;
    for (const auto& [id, job] : World::current()->watcher.jobs()) {
        jobs.push_back({id, job.record, job.progress, job.end});
    }
    return jobs;
}

Result<Bytes> JournalDatabase::record(JobId job) const {
    return World::current()->watcher.jobs().at(job).record;
}

Result<Bytes> JournalDatabase::alarms() const {
    return World::current()->watcher.alarms;
}

Status JournalDatabase::for_each_results(
    JobId job, const std::function<Status(std::span<const std::byte>)>& take) const {
    for (const Bytes& group : World::current()->watcher.jobs().at(job).groups) {
        if (Status status = take(group); !status) {
            return status;
        }
    }
    return Done{};
}

Status JournalDatabase::check_owners() const {
    return Done{};
}

Status JournalDatabase::write(std::span<const DatabaseChange> changes) {
    World& world = *World::current();
    world.touch_disk();
    if (world.disk_is_full) {
        world.troubles.add(tests::Trouble::DiskFull);
        return Error{ErrorCode::Io, "cannot write journal.db: no space left on device"};
    }
    if (const std::string wrong = world.watcher.committed(changes); !wrong.empty()) {
        world.problem(wrong);
    }
    world.touch_disk(); // The power may also fail after the commit.
    return Done{};
}

const std::filesystem::path& JournalDatabase::path() const {
    return state_->path;
}

// ---- The journal --------------------------------------------------------------------------------

struct Journal::State {
    std::shared_ptr<bool> is_here = std::make_shared<bool>(true);
    JournalOptions options;
    std::unique_ptr<JournalDatabase> database;
    Recovered recovered;
    JournalEvents events;
    std::deque<JournalEntry> queue;
    std::vector<JournalEntry> group; ///< Group being written.
    std::string told;                ///< Reported reason why writing fails.
    std::uint64_t added = 0;
    std::uint64_t committed = 0;
    std::uint64_t queued_bytes = 0;

    [[nodiscard]] std::filesystem::path jobs_folder() const { return options.directory / "jobs"; }
    void later(tests::Duration delay, void (State::*what)());
    void write_next();
    void write_group_now();
    void confirm();
};

void Journal::State::later(tests::Duration delay, void (State::*what)()) {
    World& world = *World::current();
    world.in(delay, [&world, this, weak = std::weak_ptr(is_here), what] {
        if (weak.expired()) {
            return; // The process has ended.
        }
        tests::Host& here = *world.find_host(tests::master_host);
        if (world.is_stopped(here)) {
            return later(here.stopped_until - world.now(), what);
        }
        (this->*what)();
        world.wake(here);
    });
}

void Journal::State::write_next() {
    if (!group.empty() || queue.empty()) {
        return;
    }
    World& world = *World::current();
    const std::size_t count = world.happens(700) ? queue.size() : 1 + world.below(queue.size());
    for (std::size_t i = 0; i < count; ++i) {
        group.push_back(std::move(queue.front()));
        queue.pop_front();
    }
    later(world.between(100us, 30ms), &State::write_group_now);
}

void Journal::State::write_group_now() {
    const Status status = write_group({*database, jobs_folder(), options.synced}, group);
    if (!status) {
        if (told.empty()) {
            told = status.error().detail;
            events.paused(told);
        }
        return later(timing::journal_retry_period, &State::write_group_now);
    }
    if (!told.empty()) {
        told.clear();
        events.paused("");
    }
    later(World::current()->between(50us, 5ms), &State::confirm);
}

void Journal::State::confirm() {
    for (const JournalEntry& entry : group) {
        queued_bytes -= bytes_of(entry);
    }
    committed += group.size();
    group.clear();
    events.committed(committed);
    write_next();
}

Journal::Journal(std::unique_ptr<State> state) : state_(std::move(state)) {}
Journal::~Journal() = default;

Result<std::unique_ptr<Journal>> Journal::open(const JournalOptions& options) {
    auto state = std::make_unique<State>();
    state->options = options;
    state->database = std::move(
        JournalDatabase::open(options.directory, {options.synced, options.create}).value());
    auto jobs = recover_jobs(*state->database, state->jobs_folder(), options.check_records);
    if (!jobs) {
        return jobs.error();
    }
    state->recovered = {state->database->cluster(),
                        state->database->last_job(),
                        std::move(jobs.value()),
                        recover_alarms(*state->database).value()};
    return std::unique_ptr<Journal>(new Journal(std::move(state)));
}

Recovered Journal::take_recovered() {
    return std::move(state_->recovered);
}

void Journal::start(JournalEvents events) {
    state_->events = std::move(events);
}

std::uint64_t Journal::add(JournalEntry entry) {
    if (const auto* end = std::get_if<EndJob>(&entry)) {
        World::current()->watcher.ends(end->job);
    }
    state_->queued_bytes += bytes_of(entry);
    state_->queue.push_back(std::move(entry));
    state_->write_next();
    return ++state_->added;
}

std::uint64_t Journal::queued_bytes() const {
    return state_->queued_bytes;
}

Result<JobRecord> Journal::job(JobId job) const {
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
