// A file of checksummed blocks that grows at its end; complete blocks survive a crash.
#pragma once

#include "common/core/files/bytes.hpp"
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
struct BlockPlace {
    std::uint64_t offset = 0; ///< Offset of its first byte in the file.
    std::uint64_t first = 0;  ///< Index of its first scenario.
    std::uint64_t count = 0;  ///< Scenarios in it, at least 1; there may be gaps between them.
    std::uint64_t bytes = 0;  ///< Size of its content.
};

/// Reads a block file. Little-endian:
///
///     u64 magic    u32 version    u32 0
///     blocks, each: u64 first    u64 count    u64 bytes    content    u64 XXH3 of all that
///     the table, a row a block: u64 offset    u64 first    u64 count    u64 bytes
///     u64 blocks    u64 scenarios    u64 XXH3 of the table and these two    u64 magic
///
/// The scenarios of a block come after those of the block before. A file that is being written has
/// no table yet.
class BlockFile {
  public:
    /// Opens a finished file. Errors: NotFound; Io naming a file that is damaged, unfinished or of
    /// another kind.
    [[nodiscard]] static Result<BlockFile> open(const std::filesystem::path& path, FileKind kind);
    /// Opens a file without relying on its table: the blocks up to the first that is not whole.
    /// A file that ends within its header has none. Errors: NotFound; Io, also for another kind.
    [[nodiscard]] static Result<BlockFile> open_unfinished(const std::filesystem::path& path,
                                                           FileKind kind);

    [[nodiscard]] const std::vector<BlockPlace>& blocks() const { return blocks_; }
    /// Scenarios in all blocks.
    [[nodiscard]] std::uint64_t count() const { return count_; }
    /// Where the last block ends in the file, in bytes.
    [[nodiscard]] std::uint64_t end() const;
    /// The block that may hold a scenario; nothing where none can.
    [[nodiscard]] std::optional<std::size_t> block_of(std::uint64_t scenario) const;
    /// The content of a block. Errors: Io naming the file where it is damaged.
    [[nodiscard]] Result<Bytes> read(std::size_t block) const;
    [[nodiscard]] const std::filesystem::path& path() const { return file_.path(); }

  private:
    friend class BlockFileWriter;
    BlockFile(DiskFile file, FileKind kind) : file_(std::move(file)), kind_(kind) {}

    [[nodiscard]] Status read_table();
    [[nodiscard]] Status scan();
    [[nodiscard]] std::optional<BlockPlace> whole_block_at(std::uint64_t offset,
                                                           std::uint64_t size) const;
    void append(const BlockPlace& block);

    DiskFile file_;
    FileKind kind_;
    std::vector<BlockPlace> blocks_;
    std::uint64_t count_ = 0;
};

/// Writes a block file. Blocks reach the operating system one by one, so that they outlive the
/// process; `finish` brings them to the disk.
class BlockFileWriter {
  public:
    /// Starts a new file, in place of one that is there. Errors: Io.
    [[nodiscard]] static Result<BlockFileWriter> create(const std::filesystem::path& path,
                                                        FileKind kind);
    /// Goes on with a file after its last whole block; what follows it is cut off. Errors: those of
    /// `BlockFile::open_unfinished`.
    [[nodiscard]] static Result<BlockFileWriter> resume(const std::filesystem::path& path,
                                                        FileKind kind);

    /// Writes a block of scenarios that come after all before. Errors: Io.
    [[nodiscard]] Status
    add(std::uint64_t first, std::uint64_t count, std::span<const std::byte> content);
    /// Cuts off the blocks that reach `scenario`, in a file without gaps. Errors: Io.
    [[nodiscard]] Status cut_before(std::uint64_t scenario);
    /// Writes the table. Nothing may be added afterwards. Errors: Io.
    [[nodiscard]] Status finish();

    /// What has been written so far.
    [[nodiscard]] const BlockFile& written() const { return file_; }

  private:
    explicit BlockFileWriter(BlockFile file) : file_(std::move(file)) {}

    BlockFile file_;
};

} // namespace cd
