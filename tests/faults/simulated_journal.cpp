#include "tests/faults/simulated_journal.hpp"

#include "common/core/timing/master.hpp"
#include "master/journal/journal_groups.hpp"

#include <utility>

namespace cd::tests {

using namespace std::chrono_literals;

// ---- The index --------------------------------------------------------------------------------

Result<std::vector<DatabaseJob>> SimulatedDatabase::jobs() const {
    std::vector<DatabaseJob> jobs;
    for (const auto& [id, job] : world_.watcher.jobs()) {
        jobs.push_back({id, job.record, job.progress, job.end});
    }
    return jobs;
}

Result<Bytes> SimulatedDatabase::record(JobId job) const {
    return world_.watcher.jobs().at(job).record;
}

Status SimulatedDatabase::for_each_results(
    JobId job, const std::function<Status(std::span<const std::byte>)>& take) const {
    for (const Bytes& group : world_.watcher.jobs().at(job).groups) {
        if (Status status = take(group); !status) {
            return status;
        }
    }
    return Done{};
}

Status SimulatedDatabase::write(std::span<const DatabaseChange> changes) {
    world_.touch_disk();
    if (world_.disk_is_full) {
        world_.troubles.add(Trouble::DiskFull);
        return Error{ErrorCode::Io, "cannot write journal.db: no space left on device"};
    }
    if (const std::string wrong = world_.watcher.committed(changes); !wrong.empty()) {
        world_.problem(wrong);
    }
    world_.touch_disk(); // The power may also fail after the commit.
    return Done{};
}

// ---- The journal --------------------------------------------------------------------------------

Result<std::unique_ptr<Journal>> SimulatedJournal::open(World& world) {
    auto database = std::make_unique<SimulatedDatabase>(world);
    auto recovered = recover(*database, database->path().parent_path() / "jobs");
    if (!recovered) {
        return recovered.error();
    }
    return std::unique_ptr<Journal>(std::make_unique<SimulatedJournal>(
        world, std::move(database), std::move(recovered.value())));
}

SimulatedJournal::SimulatedJournal(World& world,
                                   std::unique_ptr<SimulatedDatabase> database,
                                   Recovered recovered)
    : Journal(database->path().parent_path() / "jobs"),
      world_(world),
      database_(std::move(database)),
      recovered_(std::move(recovered)) {}

void SimulatedJournal::later(Duration delay, void (SimulatedJournal::*what)()) {
    world_.in(delay, [&world = world_, this, weak = std::weak_ptr(is_here_), what] {
        if (weak.expired()) {
            return; // The process has ended.
        }
        Host& here = *world.find_host(master_host);
        if (world.is_stopped(here)) {
            return later(here.stopped_until - world.now(), what);
        }
        (this->*what)();
        world.wake(here);
    });
}

void SimulatedJournal::write_next() {
    if (!group_.empty() || queue_.empty()) {
        return;
    }
    const std::size_t count = world_.happens(700) ? queue_.size() : 1 + world_.below(queue_.size());
    for (std::size_t i = 0; i < count; ++i) {
        group_.push_back(std::move(queue_.front()));
        queue_.pop_front();
    }
    later(world_.between(100us, 30ms), &SimulatedJournal::write_group_now);
}

void SimulatedJournal::write_group_now() {
    const Status status = write_group({*database_, jobs_folder(), true}, group_);
    if (!status) {
        if (told_.empty()) {
            told_ = status.error().detail;
            events_.paused(told_);
        }
        return later(timing::journal_retry_period, &SimulatedJournal::write_group_now);
    }
    if (!told_.empty()) {
        told_.clear();
        events_.paused("");
    }
    later(world_.between(50us, 5ms), &SimulatedJournal::confirm);
}

void SimulatedJournal::confirm() {
    for (const JournalEntry& entry : group_) {
        queued_bytes_ -= bytes_of(entry);
    }
    committed_ += group_.size();
    group_.clear();
    events_.committed(committed_);
    write_next();
}

std::uint64_t SimulatedJournal::add(JournalEntry entry) {
    if (const auto* end = std::get_if<EndJob>(&entry)) {
        world_.watcher.ends(end->job);
    }
    queued_bytes_ += bytes_of(entry);
    queue_.push_back(std::move(entry));
    write_next();
    return ++added_;
}

Result<JobRecord> SimulatedJournal::job(JobId job) const {
    const Result<Bytes> record = database_->record(job);
    return record ? decode_job(record.value()) : Result<JobRecord>(record.error());
}

} // namespace cd::tests
