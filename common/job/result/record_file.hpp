// Stores a run's results on disk: the canonical records that every export reads.
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

/// A record's bytes in the file, with the decoded result.
struct KeptRecord {
    Bytes bytes;
    ScenarioResult result;
};

/// The same while a file is read; valid until the next record. The result may be moved from.
struct RecordView {
    std::span<const std::byte> bytes;
    ScenarioResult& result;
};

/// Reads a block file (block_file.hpp) of records in ascending order of their scenarios. A block
/// has at most 4,096 records, packed by `pack_records`. Scenarios without a result have no record.
class RecordFile {
  public:
    /// Opens a finished file. Errors: those of `BlockFile::open`.
    [[nodiscard]] static Result<RecordFile> open(const std::filesystem::path& path);
    /// Opens a file that may lack its table. Errors: those of `BlockFile::open_unfinished`.
    [[nodiscard]] static Result<RecordFile> open_unfinished(const std::filesystem::path& path);

    /// From now on leaves out the records for which `is_kept` is false, as if the file lacked them,
    /// though `count` counts them. Any number of threads may call `is_kept` at once.
    void keep_only(std::function<bool(const ScenarioResult&)> is_kept);

    [[nodiscard]] std::uint64_t count() const { return file_.count(); }
    [[nodiscard]] std::size_t blocks() const { return file_.blocks().size(); }
    /// Reads the records of a block, decoded and checked. Errors: Io naming the file.
    [[nodiscard]] Result<std::vector<KeptRecord>> read(std::size_t block) const;
    /// Finds a scenario's record; null if the file has none. The pointer is valid until the next
    /// call. The last block is cached, so that lookups in ascending order read each block once. One
    /// thread at a time may call this. Errors: Io naming the file.
    [[nodiscard]] Result<const KeptRecord*> find(std::uint64_t scenario);
    /// Calls `take` with each record in order, up to a damaged one; an error of `take` ends the
    /// loop. Errors: Io naming the file, those of `take`.
    [[nodiscard]] Status for_each(const std::function<Status(const RecordView&)>& take) const;

  private:
    explicit RecordFile(BlockFile file) : file_(std::move(file)) {}
    [[nodiscard]] Status for_each_of(std::size_t block,
                                     const std::function<Status(const RecordView&)>& take) const;

    BlockFile file_;
    std::function<bool(const ScenarioResult&)> is_kept_; ///< Empty: all are.
    std::optional<std::size_t> kept_block_;
    std::vector<KeptRecord> kept_; ///< Records of block `kept_block_`.
};

/// Writes a record file block by block. Written blocks survive a crash of the process.
class RecordWriter {
  public:
    /// Creates a file. Errors: those of `BlockFileWriter::create`.
    [[nodiscard]] static Result<RecordWriter> create(const std::filesystem::path& path);
    /// Opens a file to append to it. Errors: those of `BlockFileWriter::resume`.
    [[nodiscard]] static Result<RecordWriter> resume(const std::filesystem::path& path);

    /// Buffers the canonical record of a scenario, which comes after all scenarios added before,
    /// until `flush`.
    void add(std::uint64_t scenario, std::span<const std::byte> record);
    /// Buffers the records of `count` scenarios from `first` on, each preceded by its length as
    /// u32. The scenarios come after all added before, and the records fit beside those buffered.
    void add_run(std::uint64_t first, std::uint64_t count, std::span<const std::byte> records);
    /// Returns true if the records of `count` more scenarios do not fit into the block that is
    /// buffered. Then `flush` must precede their `add`.
    [[nodiscard]] bool is_full(std::uint64_t count = 1) const;
    /// Writes the buffered records as one block. Errors: Io.
    [[nodiscard]] Status flush();
    /// Removes the blocks that hold `scenario` or a later one. Requires that the file's scenarios
    /// have no gaps. Errors: Io.
    [[nodiscard]] Status cut_before(std::uint64_t scenario);
    /// Writes the buffered records and the table. Errors: Io.
    [[nodiscard]] Status finish();

    /// Number of records in written blocks.
    [[nodiscard]] std::uint64_t written() const { return file_.written().count(); }

  private:
    explicit RecordWriter(BlockFileWriter file) : file_(std::move(file)) {}

    BlockFileWriter file_;
    ByteWriter waiting_; ///< Buffered records, each preceded by its length.
    std::uint64_t first_ = 0;
    std::uint64_t count_ = 0; ///< Number of buffered records.
};

} // namespace cd
