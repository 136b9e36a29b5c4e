// A cut whose upper tree is in memory, and the blocks of the distribution roots are on disk.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/result.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/obb_tree.hpp"
#include "master/geometry/cut.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace cd {

/// Keeps the file of the blocks open and the tree in memory, but none of the blocks.
class CutGeometry final : public Cut {
  public:
    /// Opens a file that `write_blocks_file` made. Errors: as `open_blocks_file`; TooLarge for an
    /// upper tree over `limits::subtree_block_bytes_max`.
    [[nodiscard]] static Result<std::shared_ptr<const CutGeometry>>
    open(const std::filesystem::path& path,
         std::shared_ptr<const ObbTree> tree,
         std::uint32_t depth,
         SubtreeForm form);
    ~CutGeometry() override;

    [[nodiscard]] const TreeTop& top() const;
    [[nodiscard]] std::uint64_t
    bytes_total() const; ///< Uncompressed bytes of all distribution roots' blocks.

    [[nodiscard]] std::uint32_t depth() const override;
    [[nodiscard]] SubtreeForm form() const override;
    [[nodiscard]] std::uint32_t triangle_count() const override { return top().triangle_count(); }
    [[nodiscard]] std::uint32_t root_count() const override { return top().root_count(); }
    [[nodiscard]] std::uint32_t triangles_under(RootIndex root) const override {
        return top().triangles_under(root);
    }
    [[nodiscard]] const Sha256& hash(RootIndex root) const override;
    [[nodiscard]] std::uint64_t compressed_bytes(RootIndex root) const override;
    [[nodiscard]] Result<SubtreeBlock> read(RootIndex root) const override;
    /// If the block cannot be read, renames the damaged file and writes a new one from the tree; if
    /// that fails, encodes only this block.
    [[nodiscard]] SubtreeBlock block(RootIndex root) const override;

  private:
    struct State;
    explicit CutGeometry(std::unique_ptr<const State> state);
    void write_anew(const std::string& why) const;
    std::unique_ptr<const State> state_;
};

} // namespace cd
