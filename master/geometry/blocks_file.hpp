// The blocks file of one cut: an index, then the compressed blocks of all distribution roots.
#pragma once

#include "common/core/files/disk_file.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/result.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/obb_tree.hpp"
#include "common/tree/subtree.hpp"

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace cd {

inline constexpr std::string_view blocks_suffix = ".blocks";

/// Index entry of one root's block.
struct BlockPlace {
    std::uint64_t offset = 0;
    std::uint64_t compressed_bytes = 0;
    std::uint64_t bytes = 0;    ///< Uncompressed size.
    Sha256 hash;                ///< SHA-256 of the uncompressed bytes.
    std::uint64_t checksum = 0; ///< Checksum of the compressed bytes.
};

/// An open, checked blocks file.
struct BlocksFile {
    DiskFile file;
    std::vector<BlockPlace> places; ///< Index entries, by root.
};

/// Encodes the blocks of the tree cut at `depth`, on the pool, and writes the file. With a null
/// `pool`, encodes on the caller's thread. Errors: TooLarge for a block over
/// `limits::subtree_block_bytes_max`; Io.
[[nodiscard]] Status write_blocks_file(const std::filesystem::path& path,
                                       const ObbTree& tree,
                                       std::uint32_t depth,
                                       SubtreeForm form,
                                       ThreadPool* pool);

/// Reads the whole file and checks all checksums. Errors: NotFound; Io naming a damaged file.
[[nodiscard]] Status check_blocks_file(const std::filesystem::path& path);

/// Reads the whole file, checks all checksums, and returns the file with its index. Errors:
/// NotFound; Io naming the file if it is damaged or was made from another tree, depth or form.
[[nodiscard]] Result<BlocksFile> open_blocks_file(const std::filesystem::path& path,
                                                  const ObbTree& tree,
                                                  std::uint32_t depth,
                                                  SubtreeForm form);

/// Reads one compressed block and checks its checksum. Errors: Io naming the file.
[[nodiscard]] Result<Bytes> read_block(const BlocksFile& blocks, RootIndex root);

/// Encodes one block from the tree. Returns the bytes that `read_block` returns for an intact file.
[[nodiscard]] Bytes
make_block(const ObbTree& tree, std::uint32_t depth, SubtreeForm form, RootIndex root);

} // namespace cd
