// One cut of a tree as the master serves it: its top in memory, the roots' blocks on disk.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/result.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/obb_tree.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace cd {

/// A tree cut at one depth, with all its blocks encoded and on disk. Immutable, shared freely
/// between threads; holds the file open, and the tree, but none of the blocks.
class CutGeometry {
  public:
    /// Of a file that `write_blocks_file` made. Errors: those of `open_blocks_file`; TooLarge for a
    /// top over `limits::subtree_block_bytes_max`.
    [[nodiscard]] static Result<std::shared_ptr<const CutGeometry>>
    open(const std::filesystem::path& path,
         std::shared_ptr<const ObbTree> tree,
         std::uint32_t depth,
         SubtreeForm form);
    CutGeometry(const CutGeometry&) = delete;
    CutGeometry& operator=(const CutGeometry&) = delete;
    ~CutGeometry();

    [[nodiscard]] std::uint32_t depth() const;
    [[nodiscard]] SubtreeForm form() const; ///< Of the blocks.
    [[nodiscard]] const TreeTop& top() const;
    [[nodiscard]] std::uint32_t root_count() const;
    // Here a root may be `top_root`.
    /// All of these, which ascend, are there.
    [[nodiscard]] bool has_blocks(std::span<const RootIndex> roots) const;
    /// The name of a block's uncompressed bytes.
    [[nodiscard]] const Sha256& hash(RootIndex root) const;
    [[nodiscard]] std::uint64_t compressed_bytes(RootIndex root) const;
    [[nodiscard]] std::uint64_t bytes_total() const; ///< Of all roots, without the top.

    /// One block as it travels. One read of the file: microseconds while the system caches it, so
    /// it may be called from the network thread. A block that is damaged or cannot be read is made
    /// of the tree again, and its file is set aside.
    [[nodiscard]] SubtreeBlock block(RootIndex root) const;

  private:
    struct State;
    explicit CutGeometry(std::unique_ptr<const State> state);
    [[nodiscard]] Bytes compressed_block(RootIndex root) const;
    std::unique_ptr<const State> state_;
};

} // namespace cd
