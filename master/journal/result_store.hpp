// A job's results on disk: an append-only segment of canonical records, found by scenario.
#pragma once

#include "common/core/id.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace cd {

/// A record on its way into the segment.
struct StoredRecord {
    std::uint64_t scenario = 0;
    std::span<const std::byte> record;
};

/// Where a record stands in the segment; a length of 0 is no record.
struct RecordPlace {
    std::uint64_t offset = 0; ///< Of the record's own bytes.
    std::uint64_t length = 0;

    friend bool operator==(const RecordPlace&, const RecordPlace&) = default;
};

/// The file starts with its kind, its version, its job and their checksum; then, of each record:
///
///     u64 length    u64 scenario    the record    u64 XXH3 of all three
///
/// What stands behind the committed end is of no account, and is written over. Memory: 16 bytes for
/// each scenario answered. Any thread may call `has`, `count` and `read`; one at a time the others.
/// All block for the disk.
class ResultStore {
  public:
    /// For a job that is new: the file is made by the first `write`, and what it may hold before is
    /// of none.
    [[nodiscard]] static std::unique_ptr<ResultStore>
    create(const std::filesystem::path& path, JobId job, std::uint64_t scenarios);
    /// With `end` committed bytes, whose records are told by `restore`; 0: the file need not be
    /// there. Errors: Io, naming the file, when it is of another kind or job, or shorter.
    [[nodiscard]] static Result<std::unique_ptr<ResultStore>>
    open(const std::filesystem::path& path, JobId job, std::uint64_t scenarios, std::uint64_t end);
    /// The store of a job that has ended. It opens the file when results are read, so that a
    /// damaged or missing file makes only these reads fail.
    [[nodiscard]] static std::unique_ptr<ResultStore> open_to_read(
        const std::filesystem::path& path, JobId job, std::uint64_t scenarios, std::uint64_t end);
    ResultStore(const ResultStore&) = delete;
    ResultStore& operator=(const ResultStore&) = delete;
    ~ResultStore();

    /// The name of the file may not survive a loss of power: it is new, and nobody has called
    /// `name_synced` since.
    [[nodiscard]] bool has_new_name() const;
    void name_synced();
    /// Where `write` would put its first record.
    [[nodiscard]] std::uint64_t end() const;
    /// That of one without records.
    [[nodiscard]] static std::uint64_t first_end();
    /// Where a record stands that comes behind `end`, and where the next one would.
    [[nodiscard]] static RecordPlace place_at(std::uint64_t end, std::uint64_t length);
    [[nodiscard]] static std::uint64_t end_of(const RecordPlace& place);

    /// Writes behind the committed end, one after the other; without `commit` the next call writes
    /// there again. A record is at least one byte and at most `limits::result_record_bytes_max`.
    /// Errors: Io.
    [[nodiscard]] Status write(std::span<const StoredRecord> records);
    /// Brings what was written to the disk. Errors: Io.
    [[nodiscard]] Status sync() const;
    /// Closes the file until the next write. Reads open it each time.
    void close();
    /// What was written last can be read from now on. Of several records of a scenario the last one
    /// counts.
    void commit();

    /// A committed record. Errors: Io, when it would not lie within the committed bytes.
    [[nodiscard]] Status restore(std::uint64_t scenario, const RecordPlace& place);
    /// Reads all committed records against their checksums. Errors: Io, naming file and scenario.
    [[nodiscard]] Status verify() const;

    [[nodiscard]] bool has(std::uint64_t scenario) const;
    [[nodiscard]] std::uint64_t count() const; ///< Scenarios whose records can be read.

    /// The records that are here of scenarios [first, first + count), up to the one that would
    /// bring the uncompressed records over `bytes_max`, and at most `limits::results_scan_max`
    /// scenarios further; the first record is given whatever its size. `job` is left for the caller
    /// to set. Errors: Io, when a record is damaged or cannot be read.
    [[nodiscard]] Result<ResultsPart>
    read(std::uint64_t first, std::uint64_t count, std::uint64_t bytes_max) const;

  private:
    struct State;
    explicit ResultStore(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace cd
