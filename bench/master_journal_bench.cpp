// Measures how many results per second the journal commits to disk, and the time of one commit.
//
// journal_results: adds results to `Journal` one by one, as fast as it accepts them, by record
// size, synced and not. journal_commit: adds one result at a time and waits for each. The directory
// is below TMPDIR: its file system and disk are measured.
#include "common/core/files/hash.hpp"
#include "master/journal/journal.hpp"

#include <benchmark/benchmark.h>

#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <mutex>

namespace cd::bench {
namespace {

constexpr JobId job{1};

/// A journal with one job.
class Running {
  public:
    explicit Running(bool synced) {
        std::string name = (std::filesystem::temp_directory_path() / "cd-journal-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
        journal_ = std::move(Journal::open({.directory = folder_, .synced = synced}).value());
        journal_->start(
            {[this](std::uint64_t position) {
                 const std::lock_guard lock(mutex_);
                 committed_ = position;
                 changed_.notify_all();
             },
             [](const std::string& why) { std::fprintf(stderr, "%s\n", why.c_str()); }});
        JobRecord record;
        record.id = job;
        record.submit.scenarios = std::uint64_t{1} << 40;
        store_ = ResultStore::create(journal_->results_path(job), job, record.submit.scenarios);
        wait_for(journal_->add(AcceptJob{record}));
    }
    ~Running() {
        journal_.reset();
        std::filesystem::remove_all(folder_);
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    std::uint64_t add(std::size_t record_bytes) {
        AddResults entry{job, store_, {}, {}, {}};
        entry.results.add(next_++, {}, Bytes(record_bytes));
        return journal_->add(std::move(entry));
    }
    void wait_for(std::uint64_t position) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return committed_ >= position; });
    }
    [[nodiscard]] std::uint64_t count() const { return store_->count(); }

  private:
    std::filesystem::path folder_;
    std::unique_ptr<Journal> journal_;
    std::shared_ptr<ResultStore> store_;
    std::uint64_t next_ = 0;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::uint64_t committed_ = 0;
};

void journal_results(benchmark::State& state) {
    constexpr std::uint64_t together = 20'000;
    Running running(state.range(1) != 0);
    for (auto _ : state) {
        std::uint64_t last = 0;
        for (std::uint64_t i = 0; i < together; ++i) {
            last = running.add(static_cast<std::size_t>(state.range(0)));
        }
        running.wait_for(last);
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(running.count()));
    state.SetBytesProcessed(static_cast<std::int64_t>(running.count()) * state.range(0));
}
BENCHMARK(journal_results)
    ->ArgNames({"bytes", "synced"})
    ->ArgsProduct({{60, 3000}, {1, 0}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void journal_commit(benchmark::State& state) {
    Running running(state.range(0) != 0);
    for (auto _ : state) {
        running.wait_for(running.add(60));
    }
}
BENCHMARK(journal_commit)
    ->ArgName("synced")
    ->Arg(1)
    ->Arg(0)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace cd::bench

BENCHMARK_MAIN();
