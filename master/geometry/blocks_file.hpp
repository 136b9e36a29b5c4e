// All subtree blocks of one cut on disk: an index, then the compressed blocks.
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

/// Where one root's block stands, and what it is.
struct BlockPlace {
    std::uint64_t offset = 0;
    std::uint64_t compressed_bytes = 0;
    std::uint64_t bytes = 0;    ///< Uncompressed.
    Sha256 hash;                ///< Of the uncompressed bytes.
    std::uint64_t checksum = 0; ///< Of the compressed ones.
};

struct BlocksFile {
    DiskFile file;
    std::vector<BlockPlace> places; ///< By root.
};

/// Encodes every subtree of the cut in this form, on the pool, and writes the file. Errors:
/// TooLarge when one is over `limits::subtree_block_bytes_max`; Io.
[[nodiscard]] Status write_blocks_file(const std::filesystem::path& path,
                                       const ObbTree& tree,
                                       std::uint32_t depth,
                                       SubtreeForm form,
                                       ThreadPool& pool);

/// Reads all of it against its checksums. Errors: NotFound; Io naming the file.
[[nodiscard]] Status check_blocks_file(const std::filesystem::path& path);

/// The same, and keeps the index. Errors: NotFound; Io naming the file when it is damaged, or was
/// made of another tree, depth or form.
[[nodiscard]] Result<BlocksFile> open_blocks_file(const std::filesystem::path& path,
                                                  const ObbTree& tree,
                                                  std::uint32_t depth,
                                                  SubtreeForm form);

/// One compressed block. Errors: Io naming the file.
[[nodiscard]] Result<Bytes> read_block(const BlocksFile& blocks, RootIndex root);

/// The same as `read_block` gives of a sound file, made of the tree.
[[nodiscard]] Bytes
make_block(const ObbTree& tree, std::uint32_t depth, SubtreeForm form, RootIndex root);

} // namespace cd
