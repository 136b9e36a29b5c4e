// One cut of a tree as the master serves it: the upper tree in memory, the roots' blocks on disk.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/result.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/obb_tree.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace cd {

/// A tree cut at one depth, with all its blocks encoded and on disk. Immutable and shared between
/// threads. Keeps the file open and the tree in memory, but none of the blocks.
class CutGeometry {
  public:
    /// Opens a file that `write_blocks_file` made. Errors: those of `open_blocks_file`; TooLarge
    /// for an upper tree over `limits::subtree_block_bytes_max`.
    [[nodiscard]] static Result<std::shared_ptr<const CutGeometry>>
    open(const std::filesystem::path& path,
         std::shared_ptr<const ObbTree> tree,
         std::uint32_t depth,
         SubtreeForm form,
         ThreadPool& pool);
    CutGeometry(const CutGeometry&) = delete;
    CutGeometry& operator=(const CutGeometry&) = delete;
    ~CutGeometry();

    [[nodiscard]] std::uint32_t depth() const;
    [[nodiscard]] SubtreeForm form() const; ///< Form of the blocks.
    [[nodiscard]] const TreeTop& top() const;
    [[nodiscard]] std::uint32_t root_count() const;
    // A root below may be `top_root`.
    /// Returns whether all these roots, which ascend, exist.
    [[nodiscard]] bool has_blocks(std::span<const RootIndex> roots) const;
    /// Returns the hash of a block's uncompressed bytes.
    [[nodiscard]] const Sha256& hash(RootIndex root) const;
    [[nodiscard]] std::uint64_t compressed_bytes(RootIndex root) const;
    [[nodiscard]] std::uint64_t
    bytes_total() const; ///< Bytes of all roots' blocks, without the upper tree.

    /// Reads one block in wire form. One file read takes microseconds from the system's cache, so
    /// the network thread may call this. Errors: Io when the file is damaged or unreadable.
    [[nodiscard]] Result<SubtreeBlock> read(RootIndex root) const;
    /// Returns one block in wire form. If it cannot be read, renames the file and writes it anew
    /// from the tree, which may take seconds; encodes only this block if that fails. Any thread;
    /// the network thread calls it on `pool()`.
    [[nodiscard]] SubtreeBlock block(RootIndex root) const;
    [[nodiscard]] ThreadPool& pool() const; ///< For `block`.

  private:
    struct State;
    explicit CutGeometry(std::unique_ptr<const State> state);
    void write_anew(const std::string& why) const;
    std::unique_ptr<const State> state_;
};

} // namespace cd
