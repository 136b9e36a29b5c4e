// The journal of a simulated master: its rows are in memory, with atomic commits, and it writes
// groups at simulated times.
#pragma once

#include "master/journal/journal.hpp"
#include "master/journal/journal_database.hpp"
#include "tests/faults/world.hpp"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace cd::tests {

/// The rows are those that the world's watcher keeps, which survive the master.
class SimulatedDatabase final : public JournalDatabase {
  public:
    explicit SimulatedDatabase(World& world) : world_(world) {}

    [[nodiscard]] const Sha256& cluster() const override { return cluster_; }
    [[nodiscard]] JobId last_job() const override { return world_.watcher.last_job; }
    [[nodiscard]] Result<std::vector<DatabaseJob>> jobs() const override;
    [[nodiscard]] Result<Bytes> record(JobId job) const override;
    [[nodiscard]] Result<Bytes> alarms() const override { return world_.watcher.alarms; }
    [[nodiscard]] Status
    for_each_results(JobId job,
                     const std::function<Status(std::span<const std::byte>)>& take) const override;
    [[nodiscard]] Status check_owners() const override { return Done{}; }
    [[nodiscard]] Status write(std::span<const DatabaseChange> changes) override;
    [[nodiscard]] const std::filesystem::path& path() const override { return path_; }

  private:
    World& world_;
    std::filesystem::path path_ = "/state/journal.db";
    Sha256 cluster_ = sha256({});
};

class SimulatedJournal final : public Journal {
  public:
    /// Errors: those of `recover`.
    [[nodiscard]] static Result<std::unique_ptr<Journal>> open(World& world);
    SimulatedJournal(World& world,
                     std::unique_ptr<SimulatedDatabase> database,
                     Recovered recovered);

    [[nodiscard]] Recovered take_recovered() override { return std::move(recovered_); }
    void start(JournalEvents events) override { events_ = std::move(events); }
    std::uint64_t add(JournalEntry entry) override;
    [[nodiscard]] std::uint64_t queued_bytes() const override { return queued_bytes_; }
    [[nodiscard]] Result<JobRecord> job(JobId job) const override;

  private:
    /// Calls the member after the delay, unless the process has ended.
    void later(Duration delay, void (SimulatedJournal::*what)());
    void write_next();
    void write_group_now();
    void confirm();

    World& world_;
    std::unique_ptr<SimulatedDatabase> database_;
    Recovered recovered_;
    JournalEvents events_;
    std::shared_ptr<bool> is_here_ = std::make_shared<bool>(true);
    std::deque<JournalEntry> queue_;
    std::vector<JournalEntry> group_; ///< Group being written.
    std::string told_;                ///< Reported reason why writing fails.
    std::uint64_t added_ = 0;
    std::uint64_t committed_ = 0;
    std::uint64_t queued_bytes_ = 0;
};

} // namespace cd::tests
