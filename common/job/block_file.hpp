// A file of checksummed blocks that grows at its end; complete blocks survive a crash.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/checked_file.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace cd {

/// The location of a block in its file and the job's scenarios that it holds.
struct BlockEntry {
    std::uint64_t offset = 0; ///< Offset of the block's first byte in the file.
    std::uint64_t first = 0;  ///< Index of the block's first scenario.
    std::uint64_t count = 0;  ///< Number of scenarios, at least 1; their indices may have gaps.
    std::uint64_t bytes = 0;  ///< Size of the content, without the block's header and checksum.
};

/// Reads a block file, which is little-endian:
///
///     u64 magic    u32 version    u32 0
///     blocks, each: u64 first    u64 count    u64 bytes    content    u64 XXH3 of these four
///     the table, one row per block: u64 offset    u64 first    u64 count    u64 bytes
///     u64 blocks    u64 scenarios    u64 XXH3 of the table and these two    u64 magic
///
/// The scenarios of a block come after those of the previous block. A file that is being written
/// has no table yet.
class BlockFile {
  public:
    /// Opens a finished file. Errors: NotFound; Io naming a file that is damaged, unfinished or of
    /// another kind.
    [[nodiscard]] static Result<BlockFile> open(const std::filesystem::path& path, FileKind kind);
    /// Opens a file that may lack its table, and scans its blocks up to the first block that is cut
    /// short or damaged. A file that ends within its header has no blocks. Errors: NotFound; Io,
    /// also if the file is of another kind.
    [[nodiscard]] static Result<BlockFile> open_unfinished(const std::filesystem::path& path,
                                                           FileKind kind);

    [[nodiscard]] const std::vector<BlockEntry>& blocks() const { return blocks_; }
    /// Number of scenarios in all blocks.
    [[nodiscard]] std::uint64_t count() const { return count_; }
    /// File offset, in bytes, at which the last block ends.
    [[nodiscard]] std::uint64_t end() const;
    /// Returns the index in `blocks()` of the block that may hold a scenario, or nothing if all
    /// blocks begin with later scenarios.
    [[nodiscard]] std::optional<std::size_t> block_of(std::uint64_t scenario) const;
    /// Returns the content of the block with this index in `blocks()`. Errors: Io naming the file
    /// if the block is damaged.
    [[nodiscard]] Result<Bytes> read(std::size_t block) const;
    [[nodiscard]] const std::filesystem::path& path() const { return file_.path(); }

  private:
    friend class BlockFileWriter;
    BlockFile(DiskFile file, FileKind kind) : file_(std::move(file)), kind_(kind) {}

    [[nodiscard]] Status read_table();
    [[nodiscard]] Status scan();
    [[nodiscard]] std::optional<BlockEntry> whole_block_at(std::uint64_t offset,
                                                           std::uint64_t size) const;
    void append(const BlockEntry& block);

    DiskFile file_;
    FileKind kind_;
    std::vector<BlockEntry> blocks_;
    std::uint64_t count_ = 0;
};

/// Writes a block file. Each `add` hands its block to the operating system, so that the block
/// survives a crash of the process; `finish` flushes the file to the disk.
class BlockFileWriter {
  public:
    /// Creates a file, or empties an existing one. Errors: Io.
    [[nodiscard]] static Result<BlockFileWriter> create(const std::filesystem::path& path,
                                                        FileKind kind);
    /// Opens a file to append to it, and truncates it after its last whole block. Errors: those of
    /// `BlockFile::open_unfinished`.
    [[nodiscard]] static Result<BlockFileWriter> resume(const std::filesystem::path& path,
                                                        FileKind kind);

    /// Appends a block of `count` scenarios from index `first`, which come after all scenarios in
    /// the file. Errors: Io.
    [[nodiscard]] Status
    add(std::uint64_t first, std::uint64_t count, std::span<const std::byte> content);
    /// Removes the blocks that hold `scenario` or a later one. Requires that the file's scenarios
    /// have no gaps. Errors: Io.
    [[nodiscard]] Status cut_before(std::uint64_t scenario);
    /// Writes the table and flushes the file. No `add` may follow. Errors: Io.
    [[nodiscard]] Status finish();

    [[nodiscard]] const BlockFile& written() const { return file_; }

  private:
    explicit BlockFileWriter(BlockFile file) : file_(std::move(file)) {}

    BlockFile file_;
};

} // namespace cd
