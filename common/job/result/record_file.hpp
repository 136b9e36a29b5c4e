// A run's results on disk: the canonical records, from which every export is made.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/job/block_file.hpp"
#include "common/job/result/result.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace cd {

/// A record's bytes in the file, and the result that they encode.
struct KeptRecord {
    Bytes bytes;
    ScenarioResult result;
};

/// A block file (block_file.hpp) of `pack_records`, at most 4,096 in a block, with ascending
/// scenarios. Scenarios without a result are left out.
class RecordFile {
  public:
    /// Errors: those of `BlockFile::open`.
    [[nodiscard]] static Result<RecordFile> open(const std::filesystem::path& path);
    /// Errors: those of `BlockFile::open_unfinished`.
    [[nodiscard]] static Result<RecordFile> open_unfinished(const std::filesystem::path& path);

    [[nodiscard]] std::uint64_t count() const { return file_.count(); }
    [[nodiscard]] std::size_t blocks() const { return file_.blocks().size(); }
    /// The records of a block, decoded and checked. Errors: Io naming the file.
    [[nodiscard]] Result<std::vector<KeptRecord>> read(std::size_t block) const;
    /// A scenario's record, good until the next call; null where it has none. Keeps its block, so
    /// that scenarios in ascending order are found without reading a block twice. One thread at a
    /// time. Errors: Io naming the file.
    [[nodiscard]] Result<const KeptRecord*> find(std::uint64_t scenario);
    /// Calls `take` with each record in order; an error of `take` ends it. Errors: also Io.
    [[nodiscard]] Status for_each(const std::function<Status(const KeptRecord&)>& take) const;

  private:
    explicit RecordFile(BlockFile file) : file_(std::move(file)) {}

    BlockFile file_;
    std::optional<std::size_t> kept_block_;
    std::vector<KeptRecord> kept_; ///< The records of `kept_block_`.
};

/// Writes a record file in blocks that are whole as soon as they are written.
class RecordWriter {
  public:
    /// Errors: those of `BlockFileWriter`.
    [[nodiscard]] static Result<RecordWriter> create(const std::filesystem::path& path);
    [[nodiscard]] static Result<RecordWriter> resume(const std::filesystem::path& path);

    /// Adds the canonical record of a scenario after all before. It waits until `flush`.
    void add(std::uint64_t scenario, std::span<const std::byte> record);
    /// Whether a block's worth waits; `add` may not be called before `flush` then.
    [[nodiscard]] bool is_full() const;
    /// Writes what has been added, as a block of its own. Errors: Io.
    [[nodiscard]] Status flush();
    /// Cuts off the blocks that reach `scenario`, in a file without gaps. Errors: Io.
    [[nodiscard]] Status cut_before(std::uint64_t scenario);
    /// Writes what has been added and the table. Errors: Io.
    [[nodiscard]] Status finish();

    /// Records in blocks that are written.
    [[nodiscard]] std::uint64_t written() const { return file_.written().count(); }

  private:
    explicit RecordWriter(BlockFileWriter file) : file_(std::move(file)) {}

    BlockFileWriter file_;
    ByteWriter waiting_; ///< Each record behind its length.
    std::uint64_t first_ = 0;
    std::uint64_t count_ = 0; ///< Number of records that wait.
};

} // namespace cd
