// The tree that queries descend: made from the paper's binary tree, sixteen children to a node.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/tree/obb_tree.hpp"
#include "common/tree/wide/wide_node.hpp"

#include <cstdint>
#include <memory>

namespace cd {

/// Returns false where coordinates are so large or the body so small that floats cannot hold the
/// derived values, and where a binary leaf has too many triangles. Such bodies are searched in the
/// binary tree. Every part of a body that suits suits, too.
[[nodiscard]] bool suits_wide_tree(const TreeView& body);

/// An immutable wide tree with its triangles, shared freely between threads.
class WideTree {
  public:
    /// Collapses `binary`; the result has no nodes where that tree does not suit. It is equal for
    /// any number of threads; without a pool the caller's thread does all the work.
    explicit WideTree(const TreeView& binary, ThreadPool* pool = nullptr);
    /// Collapses a part of a body that suits, or all of it.
    [[nodiscard]] static WideTree of_part(const TreeView& binary, ThreadPool* pool = nullptr);

    /// Wraps existing arrays, which do not change while `owner` lives.
    WideTree(const WideView& arrays, std::shared_ptr<const void> owner)
        : view_(arrays), owner_(std::move(owner)) {}

    [[nodiscard]] const WideView& view() const { return view_; }
    [[nodiscard]] std::uint64_t memory_bytes() const;

  private:
    WideView view_;
    std::shared_ptr<const void> owner_; ///< Owns the arrays that the view refers to.
};

} // namespace cd
