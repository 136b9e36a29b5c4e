// The tree that queries walk: made of the paper's binary tree, sixteen children to a node.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/tree/obb_tree.hpp"
#include "common/tree/wide/wide_node.hpp"

#include <cstdint>
#include <memory>

namespace cd {

/// False where coordinates are so large or the body so small that floats cannot hold what is made
/// of them, and where a binary leaf has too many triangles: such bodies are searched in the binary
/// tree. A body that suits has parts that do.
[[nodiscard]] bool suits_wide_tree(const TreeView& body);

/// An immutable wide tree with its triangles, shared freely between threads.
class WideTree {
  public:
    /// Collapses the binary tree at hand; without nodes where it does not suit. The same for any
    /// number of threads; without a pool it is made on the caller's alone.
    explicit WideTree(const TreeView& binary, ThreadPool* pool = nullptr);
    /// Of a part of a body that suits, or all of it.
    [[nodiscard]] static WideTree of_part(const TreeView& binary, ThreadPool* pool = nullptr);

    /// The tree in these arrays, which stay as they are while `owner` lives.
    WideTree(const WideView& arrays, std::shared_ptr<const void> owner)
        : view_(arrays), owner_(std::move(owner)) {}

    [[nodiscard]] const WideView& view() const { return view_; }
    [[nodiscard]] std::uint64_t memory_bytes() const;

  private:
    WideView view_;
    std::shared_ptr<const void> owner_; ///< Of what the view shows.
};

} // namespace cd
