// Proves that the journal survives a power failure at any moment: whatever part of the unsynced
// writes is lost, it opens again, has all it had confirmed, and nothing that was never added.
//
// The test records every operation on the files of a working journal (SQLite's and ours). After
// each operation it builds a disk as a power failure may leave it: all synced data, a random choice
// of sectors of each later write, and a random number of later names, in order; or all of it, as
// after the death of the process alone; or nothing unsynced.
#include "master/journal/journal.hpp"
#include "tests/master/journal_writer.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <cstdarg>
#include <cstring>
#include <map>
#include <mutex>
#include <optional>
#include <random>
#include <set>

namespace cd::tests {
namespace {

struct Operation {
    enum class Kind { Create, Write, Resize, Sync, Rename, Unlink, Confirm };
    Kind kind = Kind::Write;
    std::string name;     ///< Relative to the directory; for a Sync, the directory itself.
    std::uint64_t at = 0; ///< Offset, size, or confirmed position.
    std::string bytes;    ///< Data, or the new name.
};

/// Records file operations below one directory, by any thread or library.
class Recorder {
  public:
    static Recorder& instance() {
        static Recorder recorder;
        return recorder;
    }

    void start(const std::filesystem::path& directory) {
        const std::lock_guard lock(mutex_);
        directory_ = directory.string() + "/";
        operations_.clear();
    }
    std::vector<Operation> stop() {
        const std::lock_guard lock(mutex_);
        directory_.clear();
        return std::move(operations_);
    }

    void add(Operation operation) {
        const std::lock_guard lock(mutex_);
        if (!directory_.empty()) {
            operations_.push_back(std::move(operation));
        }
    }
    void add(const std::string& path, Operation operation) {
        const std::lock_guard lock(mutex_);
        if (!directory_.empty() && (path + "/").starts_with(directory_)) {
            operation.name = name_of(path);
            if (operation.kind == Operation::Kind::Rename) {
                operation.bytes = name_of(operation.bytes);
            }
            operations_.push_back(std::move(operation));
        }
    }
    void add(int descriptor, Operation operation) {
        std::array<char, 4096> path{};
        const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
        const ssize_t size = ::readlink(link.c_str(), path.data(), path.size());
        add(std::string(path.data(), size > 0 ? static_cast<std::size_t>(size) : 0),
            std::move(operation));
    }

    /// Number of coming folder syncs that fail.
    std::atomic<int> failing_folder_syncs = 0;

  private:
    [[nodiscard]] std::string name_of(const std::string& path) const {
        return path.size() < directory_.size() ? "" : path.substr(directory_.size());
    }

    std::mutex mutex_;
    std::string directory_; ///< Empty: nothing is recorded.
    std::vector<Operation> operations_;
};

using Kind = Operation::Kind;

/// Models the files as a disk may hold them.
class Disk {
  public:
    void apply(const Operation& operation) {
        switch (operation.kind) {
        case Kind::Create:
            live_[operation.name] = files_.size();
            names_.push_back({operation.name, files_.size(), {}});
            files_.emplace_back();
            break;
        case Kind::Write:
        case Kind::Resize:
            files_[live_.at(operation.name)].pending.push_back(operation);
            break;
        case Kind::Sync:
            if (const auto file = live_.find(operation.name); file != live_.end()) {
                File& synced = files_[file->second];
                for (const Operation& pending : synced.pending) {
                    change(synced.durable, pending);
                }
                synced.pending.clear();
            } else {
                keep_names(names_.size());
            }
            break;
        case Kind::Rename: {
            const std::size_t file = live_.extract(operation.name).mapped();
            live_[operation.bytes] = file;
            names_.push_back({operation.bytes, file, operation.name});
            break;
        }
        case Kind::Unlink:
            live_.erase(operation.name);
            names_.push_back({operation.name, std::nullopt, {}});
            break;
        case Kind::Confirm:
            break;
        }
    }

    enum class Kept { Some, All, Nothing }; ///< Which unsynced changes survive.
    /// Writes the files that survive a failure now, with `kept` of the unsynced changes.
    void
    write_to(const std::filesystem::path& directory, Kept kept, std::mt19937_64& random) const {
        Disk after = *this;
        const std::size_t some = random() % (names_.size() + 1);
        after.keep_names(kept == Kept::Some ? some : kept == Kept::All ? names_.size() : 0);
        for (const auto& [name, file] : after.durable_names_) {
            std::string content = files_[file].durable;
            std::uint64_t mood = random() % 4; // Keeps nothing, all, or some of it.
            if (kept != Kept::Some) {
                mood = kept == Kept::All ? 1 : 0;
            }
            for (const Operation& pending : files_[file].pending) {
                for (Operation& sector : sectors(pending)) {
                    if (mood == 1 || (mood > 1 && random() % 2 == 0)) {
                        change(content, sector);
                    }
                }
            }
            std::filesystem::create_directories((directory / name).parent_path());
            write_text(directory / name, content);
        }
    }

  private:
    struct File {
        std::string durable;
        std::vector<Operation> pending;
    };
    struct Name {
        std::string name;
        std::optional<std::size_t> file;   ///< Nothing: the name is removed.
        std::optional<std::string> before; ///< Name the file had before the step.
    };

    void keep_names(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            if (names_[i].file) {
                durable_names_[names_[i].name] = *names_[i].file;
                if (names_[i].before) {
                    durable_names_.erase(*names_[i].before);
                }
            } else {
                durable_names_.erase(names_[i].name);
            }
        }
        names_.erase(names_.begin(), names_.begin() + static_cast<std::ptrdiff_t>(count));
    }

    static void change(std::string& content, const Operation& operation) {
        if (operation.kind == Kind::Resize) {
            content.resize(operation.at);
            return;
        }
        content.resize(
            std::max<std::size_t>(content.size(), operation.at + operation.bytes.size()));
        content.replace(operation.at, operation.bytes.size(), operation.bytes);
    }

    /// Splits a write into sectors, which a disk writes atomically.
    [[nodiscard]] static std::vector<Operation> sectors(const Operation& operation) {
        constexpr std::uint64_t sector = 512;
        if (operation.kind != Kind::Write) {
            return {operation};
        }
        std::vector<Operation> parts;
        const std::uint64_t end = operation.at + operation.bytes.size();
        for (std::uint64_t at = operation.at; at < end;) {
            const std::uint64_t next = std::min(end, (at / sector + 1) * sector);
            parts.push_back({Kind::Write,
                             operation.name,
                             at,
                             operation.bytes.substr(at - operation.at, next - at)});
            at = next;
        }
        return parts;
    }

    std::vector<File> files_;
    std::map<std::string, std::size_t> live_;
    std::vector<Name> names_; ///< Changes of names that are not durable, in order.
    std::map<std::string, std::size_t> durable_names_;
};

ScenarioResult sized_result(std::uint64_t scenario) {
    return result_of(scenario, 100 + scenario % 900);
}

/// The journal's operations, and the scenarios of job 1 added by each position.
struct History {
    std::vector<Operation> operations;
    std::vector<std::vector<std::uint64_t>> added{{}}; ///< By position.
    std::uint64_t verdict = 0;                         ///< A scenario added with an alarm.
    std::uint64_t ended_at = 0;
    std::uint64_t dropped_at = 0; ///< Position at which job 3 was dropped.
};

constexpr std::uint64_t verdict_group = 30;
constexpr std::uint64_t dropped_results = 5;

/// `failing_folder_syncs`: counted from the first results on.
History record(const std::filesystem::path& directory, int failing_folder_syncs = 0) {
    History history;
    Recorder::instance().start(directory);
    {
        std::mutex mutex;
        std::condition_variable changed;
        std::uint64_t committed = 0;
        auto journal = std::move(Journal::open({.directory = directory}).value());
        journal->start({[&](std::uint64_t position) {
                            Recorder::instance().add({Kind::Confirm, "", position, ""});
                            const std::lock_guard lock(mutex);
                            committed = position;
                            changed.notify_all();
                        },
                        [=](const std::string& why) {
                            if (failing_folder_syncs == 0) {
                                ADD_FAILURE() << why;
                            }
                        }});
        const auto wait_for = [&](std::uint64_t position) {
            std::unique_lock lock(mutex);
            changed.wait(lock, [&] { return committed >= position; });
        };
        JobRecord job;
        job.id = JobId{1};
        job.submit.scenarios = 10'000;
        const std::shared_ptr<ResultStore> store =
            ResultStore::create(journal->results_path(job.id), job.id, job.submit.scenarios);
        wait_for(journal->add(AcceptJob{job}));
        history.added.emplace_back();
        Recorder::instance().failing_folder_syncs = failing_folder_syncs;
        std::uint64_t next = 0;
        for (std::uint64_t group = 0; group < 60; ++group) {
            AddResults add{job.id, store, {}, {}, {}};
            history.added.emplace_back();
            for (std::uint64_t i = 0; i <= group % 7; ++i, ++next) {
                add.results.add(sized_result(next));
                history.added.back().push_back(next);
            }
            if (group == verdict_group) {
                history.verdict = next - 1;
                add.alarms.emplace().quarantine(7);
            }
            const std::uint64_t position = journal->add(std::move(add));
            if (group % 3 == 0) {
                wait_for(position);
            }
        }
        JobRecord other = job;
        other.id = JobId{2};
        journal->add(AcceptJob{other});
        history.ended_at =
            journal->add(EndJob{other.id, {JobState::Cancelled, "cancelled", {}}, {}});
        JobRecord dropped = job;
        dropped.id = JobId{3};
        journal->add(AcceptJob{dropped});
        AddResults results{
            dropped.id,
            ResultStore::create(journal->results_path(dropped.id), dropped.id, 10'000),
            {},
            {},
            {}};
        for (std::uint64_t i = 0; i < dropped_results; ++i) {
            results.results.add(sized_result(i));
        }
        journal->add(std::move(results));
        journal->add(EndJob{dropped.id, {JobState::Done, "", {}}, {}});
        history.dropped_at = journal->add(DropJob{dropped.id});
        wait_for(history.dropped_at);
        for (const auto& file : journal->files_of(dropped.id)) {
            ::unlink(file.c_str());
        }
    }
    history.operations = Recorder::instance().stop();
    return history;
}

/// Expects that the journal opens with all that was confirmed and nothing that was never added.
void expect_kept(const std::filesystem::path& directory,
                 const History& history,
                 std::uint64_t confirmed) {
    auto journal = Journal::open({.directory = directory, .synced = false});
    ASSERT_TRUE(journal) << journal.error().detail;
    const Recovered recovered = journal.value()->take_recovered();
    const auto find = [&](std::uint64_t id) {
        return std::ranges::find(
            recovered.jobs, JobId{id}, [](auto& job) { return job.record.id; });
    };
    if (confirmed >= 1) {
        ASSERT_GE(recovered.jobs.size(), 1u);
    }
    if (confirmed >= history.ended_at) {
        ASSERT_NE(find(2), recovered.jobs.end());
        ASSERT_TRUE(find(2)->end);
    }
    // Dropping is atomic.
    const auto dropped = find(3);
    if (confirmed >= history.dropped_at) {
        ASSERT_EQ(dropped, recovered.jobs.end());
    }
    if (dropped != recovered.jobs.end() && dropped->end) {
        ASSERT_NE(dropped->results, nullptr);
        ASSERT_TRUE(dropped->results->verify());
        ASSERT_EQ(dropped->results->count(), dropped_results);
    }
    if (recovered.jobs.empty()) {
        return;
    }
    const RecoveredJob& job = recovered.jobs[0];
    ASSERT_TRUE(job.results->verify());
    // The result and its alarm are both there, or neither is.
    ASSERT_EQ(job.merger.has(history.verdict), !recovered.alarms.quarantined.empty());
    // Entries are committed in order, so the journal holds a prefix of them.
    std::set<std::uint64_t> done;
    for (const ResultRow& row : job.done) {
        done.insert(row.scenario);
    }
    ASSERT_EQ(done.size(), job.done.size());
    for (std::uint64_t position = 1; position < history.added.size(); ++position) {
        for (const std::uint64_t scenario : history.added[position]) {
            const bool is_here = done.erase(scenario) == 1;
            ASSERT_TRUE(is_here || position > confirmed) << "lost, and it was confirmed";
            if (is_here) {
                ASSERT_EQ(job.merger.digest_of(scenario), digest_of(sized_result(scenario)));
            }
        }
    }
    ASSERT_TRUE(done.empty()) << "nobody added that";
}

TEST(JournalCrash, ThePowerMayFailBehindEveryOperation) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "live/jobs");
    const History history = record(folder / "live");
    ASSERT_GT(history.operations.size(), 100u);
    std::size_t confirms = 0;
    std::uint64_t confirmed = 0;
    Disk disk;
    for (std::size_t cut = 0; cut < history.operations.size(); ++cut) {
        disk.apply(history.operations[cut]);
        if (history.operations[cut].kind == Kind::Confirm) {
            confirmed = history.operations[cut].at;
            ++confirms;
        }
        for (const Disk::Kept kept : {Disk::Kept::Some, Disk::Kept::All, Disk::Kept::Nothing}) {
            SCOPED_TRACE(testing::Message() << "cut " << cut << ", kept " << int(kept));
            std::mt19937_64 random(cut);
            const std::filesystem::path image = folder / "image";
            disk.write_to(image, kept, random);
            expect_kept(image, history, confirmed);
            if (HasFatalFailure()) {
                return;
            }
            std::filesystem::remove_all(image);
        }
    }
    EXPECT_GT(confirms, 20u);
    EXPECT_EQ(confirmed, history.dropped_at);
}

/// The folder of the segments cannot be synced when a new segment is made.
TEST(JournalCrash, AFailedSyncOfAFileNameIsRepeatedBeforeTheCommit) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "live/jobs");
    const History history = record(folder / "live", 1);
    ASSERT_EQ(Recorder::instance().failing_folder_syncs, 0);
    Disk disk;
    for (const Operation& operation : history.operations) {
        disk.apply(operation);
        if (operation.kind != Kind::Confirm) {
            continue;
        }
        std::mt19937_64 random(1);
        disk.write_to(folder / "image", Disk::Kept::Nothing, random);
        expect_kept(folder / "image", history, operation.at);
        if (HasFatalFailure()) {
            return;
        }
        std::filesystem::remove_all(folder / "image");
    }
}

template <class Where>
void note(const Where& where, Kind kind, std::uint64_t at = 0, std::string bytes = "") {
    Recorder::instance().add(where, {kind, "", at, std::move(bytes)});
}

} // namespace
} // namespace cd::tests

using cd::tests::note;
using Kind = cd::tests::Kind;

// Replaces functions of the C library, for SQLite too.
extern "C" {

ssize_t pwrite64(int descriptor, const void* data, size_t size, off64_t at) {
    const ssize_t written = ::syscall(SYS_pwrite64, descriptor, data, size, at);
    if (written > 0) {
        note(descriptor,
             Kind::Write,
             static_cast<std::uint64_t>(at),
             std::string(static_cast<const char*>(data), static_cast<std::size_t>(written)));
    }
    return written;
}

ssize_t pwrite(int descriptor, const void* data, size_t size, off_t at) {
    return pwrite64(descriptor, data, size, at);
}

int fdatasync(int descriptor) {
    const auto result = static_cast<int>(::syscall(SYS_fdatasync, descriptor));
    note(descriptor, Kind::Sync);
    return result;
}

int fsync(int descriptor) {
    struct stat facts {};
    std::atomic<int>& failing = cd::tests::Recorder::instance().failing_folder_syncs;
    if (failing > 0 && ::fstat(descriptor, &facts) == 0 && S_ISDIR(facts.st_mode)) {
        --failing;
        errno = EIO;
        return -1;
    }
    const auto result = static_cast<int>(::syscall(SYS_fsync, descriptor));
    note(descriptor, Kind::Sync);
    return result;
}

int ftruncate64(int descriptor, off64_t size) noexcept {
    const auto result = static_cast<int>(::syscall(SYS_ftruncate, descriptor, size));
    note(descriptor, Kind::Resize, static_cast<std::uint64_t>(size));
    return result;
}

int ftruncate(int descriptor, off_t size) noexcept {
    return ftruncate64(descriptor, size);
}

int rename(const char* path, const char* to) noexcept {
    const auto result = static_cast<int>(::syscall(SYS_renameat, AT_FDCWD, path, AT_FDCWD, to));
    if (result == 0) {
        note(std::string(path), Kind::Rename, 0, to);
    }
    return result;
}

int open64(const char* path, int flags, ...) {
    std::va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    const bool is_new = (flags & O_CREAT) != 0 && ::access(path, F_OK) != 0;
    const auto descriptor =
        static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags | O_LARGEFILE, mode));
    if (descriptor >= 0 && is_new) {
        note(std::string(path), Kind::Create);
    }
    return descriptor;
}

int open(const char* path, int flags, ...) {
    std::va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return open64(path, flags, mode);
}

int mkostemp(char* name, int flags) {
    // Unique names suffice within one process.
    static std::atomic<unsigned> last = 0;
    const std::string number = std::to_string(1'000'000 + ++last);
    std::copy(number.end() - 6, number.end(), name + std::strlen(name) - 6);
    return open64(name, flags | O_RDWR | O_CREAT | O_EXCL, 0600);
}

int unlink(const char* path) noexcept {
    const auto result = static_cast<int>(::syscall(SYS_unlinkat, AT_FDCWD, path, 0));
    if (result == 0) {
        note(std::string(path), Kind::Unlink);
    }
    return result;
}

} // extern "C"
