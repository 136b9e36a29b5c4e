// The interface of a cut of a tree: it keeps the sizes and hashes of the blocks at hand, and reads
// a block's bytes on request.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/tree/cut.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// A tree cut at one depth. Immutable and shared between threads.
class Cut {
  public:
    Cut() = default;
    Cut(const Cut&) = delete;
    Cut& operator=(const Cut&) = delete;
    virtual ~Cut() = default;

    [[nodiscard]] virtual std::uint32_t depth() const = 0;
    [[nodiscard]] virtual SubtreeForm form() const = 0; ///< Form of the blocks.
    /// Number of triangles of the whole body.
    [[nodiscard]] virtual std::uint32_t triangle_count() const = 0;
    [[nodiscard]] virtual std::uint32_t root_count() const = 0;
    [[nodiscard]] virtual std::uint32_t triangles_under(RootIndex root) const = 0;
    // The members below accept `top_root` as a root: it means the block of the upper tree.
    /// Returns whether all these roots exist. They must ascend.
    [[nodiscard]] bool has_blocks(std::span<const RootIndex> roots) const {
        roots = without_top(roots);
        return roots.empty() || roots.back() < root_count();
    }
    /// Returns the hash of a block's uncompressed bytes.
    [[nodiscard]] virtual const Sha256& hash(RootIndex root) const = 0;
    [[nodiscard]] virtual std::uint64_t compressed_bytes(RootIndex root) const = 0;

    /// Reads one block in wire form. The operating system mostly has the file cached, so a read
    /// takes microseconds, and the network thread may call this. Errors: Io if the file is damaged
    /// or unreadable.
    [[nodiscard]] virtual Result<SubtreeBlock> read(RootIndex root) const = 0;
    /// Returns one block in wire form. If it cannot be read, encodes it again, which may take
    /// seconds: the network thread must leave this to a pool.
    [[nodiscard]] virtual SubtreeBlock block(RootIndex root) const = 0;
};

} // namespace cd
