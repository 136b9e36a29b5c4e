// A job's results on disk: an append-only segment of canonical records, accessed by scenario.
#pragma once

#include "common/core/id.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"
#include "master/base/result_batch.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>

namespace cd {

/// Location of a record in the segment; length 0: no record.
struct RecordPlace {
    std::uint64_t offset = 0;
    std::uint64_t length = 0;

    friend bool operator==(const RecordPlace&, const RecordPlace&) = default;
};

/// The file starts with a header: kind, version, job, and their checksum. The records follow, each
/// with its footer (`record_footer`). The index has their lengths.
///
/// Bytes past the committed end are ignored and overwritten. Takes 16 bytes of memory per answered
/// scenario. Any thread may call `has`, `count` and `read`; one thread at a time may call the other
/// members. All may block for the disk.
class ResultStore {
  public:
    /// Creates the store of a new job. The first `write` makes the file and ignores any earlier
    /// content.
    [[nodiscard]] static std::unique_ptr<ResultStore>
    create(const std::filesystem::path& path, JobId job, std::uint64_t scenarios);
    /// Opens the store of a job that continues. The file has `end` committed bytes; with 0 it need
    /// not exist. The caller adds its records with `restore`. Errors: Io naming a file that is
    /// missing, too short, or of another kind or job.
    [[nodiscard]] static Result<std::unique_ptr<ResultStore>>
    open(const std::filesystem::path& path, JobId job, std::uint64_t scenarios, std::uint64_t end);
    /// Returns the store of an ended job. Opens no file; each read does, so that a damaged or
    /// missing file fails only the reads.
    [[nodiscard]] static std::unique_ptr<ResultStore> open_to_read(
        const std::filesystem::path& path, JobId job, std::uint64_t scenarios, std::uint64_t end);
    ResultStore(const ResultStore&) = delete;
    ResultStore& operator=(const ResultStore&) = delete;
    ~ResultStore();

    /// True if `write` has created the file and `name_synced` has not been called since: until its
    /// folder is synced, a power loss may remove the file's name.
    [[nodiscard]] bool has_new_name() const;
    void name_synced();
    /// Offset at which `write` puts its first record.
    [[nodiscard]] std::uint64_t end() const;
    /// Value of `end` for a store without records.
    [[nodiscard]] static std::uint64_t first_end();
    /// Returns the location that a record gets if it is appended when the store ends at `end`.
    [[nodiscard]] static RecordPlace place_at(std::uint64_t end, std::uint64_t length) {
        return {end, length};
    }
    /// Returns the end of the store after the record at this location.
    [[nodiscard]] static std::uint64_t end_of(const RecordPlace& place) {
        return place.offset + place.length + record_footer_bytes;
    }

    /// Writes the records of the batches, which outlive the `commit`, past the committed end;
    /// without a `commit` the next call overwrites them. A record has at least one byte and at most
    /// `limits::result_record_bytes_max`. Errors: Io.
    [[nodiscard]] Status write(std::span<const ResultBatch* const> batches);
    /// Syncs the written records to disk. Errors: Io.
    [[nodiscard]] Status sync() const;
    /// Closes the file. The next `write` opens it again; each read opens it anyway.
    void close();
    /// Makes the records of the last `write` readable. A new record of a scenario replaces the
    /// earlier one.
    void commit();
    /// Makes a scenario's record unreadable.
    void withdraw(std::uint64_t scenario);

    /// Adds a record that the index names. Errors: Io for a location outside the committed bytes.
    [[nodiscard]] Status restore(std::uint64_t scenario, const RecordPlace& place);
    using Visit = std::function<void(std::uint64_t scenario, std::span<const std::byte> record)>;
    /// Reads all committed records in the order of the file, checks their checksums, and calls
    /// `visit` for each. Errors: Io naming file and scenario.
    [[nodiscard]] Status verify(const Visit& visit = {}) const;

    [[nodiscard]] bool has(std::uint64_t scenario) const;
    [[nodiscard]] std::uint64_t count() const; ///< Number of scenarios with a readable record.

    /// Returns the records, not packed, of scenarios, or of places of a sample (`ResultsQuery`),
    /// [first, first + count). Stops before their size exceeds `bytes_max`, though not before the
    /// first record, and after `limits::results_scan_max` scenarios. The caller sets `job` of the
    /// part. Errors: Io for a record that is damaged or unreadable.
    [[nodiscard]] Result<ResultsPart> read(std::uint64_t first,
                                           std::uint64_t count,
                                           std::uint64_t bytes_max,
                                           std::uint64_t sample = 0) const;

  private:
    struct State;
    explicit ResultStore(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace cd
