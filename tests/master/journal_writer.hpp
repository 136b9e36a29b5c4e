// A working journal and entries for it.
#pragma once

#include "master/journal/journal.hpp"
#include "tests/proto/sample_messages.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

namespace cd::tests {

using testing::HasSubstr;

inline JobRecord job_record(JobId job, std::uint64_t scenarios) {
    JobRecord record{job, some_submit()};
    record.submit.scenarios = scenarios;
    return record;
}

/// Makes a failure with a record of `size` bytes or more.
inline ScenarioResult result_of(std::uint64_t scenario, std::size_t size = 40) {
    ScenarioResult result;
    result.index = scenario;
    result.level = Level::Count;
    result.kind = ScenarioClass::Failed;
    result.failure = std::string(size, 'x');
    return result;
}

/// A journal under test, with the events it reported.
class Writer {
  public:
    explicit Writer(std::filesystem::path directory, bool synced = false)
        : directory_(std::move(directory)) {
        auto opened = Journal::open({.directory = directory_, .synced = synced});
        EXPECT_TRUE(opened) << opened.error().detail;
        journal = std::move(opened.value());
        recovered = journal->take_recovered();
        journal->start({[this](std::uint64_t position) {
                            const std::lock_guard lock(mutex_);
                            committed_ = position;
                            changed_.notify_all();
                        },
                        [this](const std::string& why) {
                            const std::lock_guard lock(mutex_);
                            paused_ = why;
                            changed_.notify_all();
                        }});
    }

    void wait_for(std::uint64_t position) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return committed_ >= position; });
    }
    std::string wait_until_paused() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return !paused_.empty(); });
        return paused_;
    }
    /// Adds the entry and returns its position; waits for its commit if asked.
    template <class Entry>
    std::uint64_t add(Entry entry, bool waits) {
        const std::uint64_t at = journal->add(std::move(entry));
        if (waits) {
            wait_for(at);
        }
        return at;
    }
    [[nodiscard]] std::uint64_t committed() {
        const std::lock_guard lock(mutex_);
        return committed_;
    }

    std::shared_ptr<ResultStore> accept(JobId job, std::uint64_t scenarios) {
        std::shared_ptr<ResultStore> store =
            ResultStore::create(journal->results_path(job), job, scenarios);
        journal->add(AcceptJob{job_record(job, scenarios)});
        return store;
    }

  private:
    std::filesystem::path directory_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::uint64_t committed_ = 0;
    std::string paused_;

  public:
    Recovered recovered;
    std::unique_ptr<Journal> journal; ///< Destroyed first: it still calls back.
};

/// Expects that the journal cannot be opened and says so in these words; returns all it says.
inline std::string expect_refused(const std::filesystem::path& directory,
                                  const std::string& words) {
    const auto opened = Journal::open({.directory = directory});
    EXPECT_FALSE(opened) << directory;
    const std::string why = opened ? "" : opened.error().detail;
    EXPECT_THAT(why, HasSubstr(words));
    return why;
}

inline AddResults results_of(JobId job,
                             const std::shared_ptr<ResultStore>& store,
                             std::uint64_t first,
                             std::uint64_t count,
                             std::size_t size = 40) {
    AddResults add{job, store, {}, {}, {}};
    for (std::uint64_t i = first; i < first + count; ++i) {
        add.results.add(result_of(i, size));
    }
    add.progress.answered_by_master = first + count;
    add.progress.traffic = {{1, 2, 3, 4, 5, 6}, 7};
    add.progress.help = {8, 9, 10};
    add.progress.statistics.search.effort = {11, 12, 13, 14};
    add.progress.depths = {7, 8};
    return add;
}

} // namespace cd::tests
