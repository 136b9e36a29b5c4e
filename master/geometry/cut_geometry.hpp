// A cut of a tree, whose blocks the master sends: the upper tree in memory, the blocks of the
// distribution roots on disk.
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
    // The members below accept `top_root` as a root: it means the block of the upper tree.
    /// Returns whether all these roots exist. They must ascend.
    [[nodiscard]] bool has_blocks(std::span<const RootIndex> roots) const;
    /// Returns the hash of a block's uncompressed bytes.
    [[nodiscard]] const Sha256& hash(RootIndex root) const;
    [[nodiscard]] std::uint64_t compressed_bytes(RootIndex root) const;
    [[nodiscard]] std::uint64_t
    bytes_total() const; ///< Uncompressed bytes of all distribution roots' blocks.

    /// Reads one block in wire form. The system mostly has the file in its cache, so a read takes
    /// microseconds, and the network thread may call this. Errors: Io if the file is damaged or
    /// unreadable.
    [[nodiscard]] Result<SubtreeBlock> read(RootIndex root) const;
    /// Returns one block in wire form. If it cannot be read, renames the damaged file and writes a
    /// new one from the tree, which may take seconds; if that fails, encodes only this block. Any
    /// thread may call this; the network thread does so on `pool()`.
    [[nodiscard]] SubtreeBlock block(RootIndex root) const;
    [[nodiscard]] ThreadPool& pool() const; ///< For `block`.

  private:
    struct State;
    explicit CutGeometry(std::unique_ptr<const State> state);
    void write_anew(const std::string& why) const;
    std::unique_ptr<const State> state_;
};

} // namespace cd
