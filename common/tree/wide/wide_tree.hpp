// The wide tree that queries descend: up to sixteen children a node, made from the binary tree.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/tree/obb_tree.hpp"
#include "common/tree/wide/wide_node.hpp"

#include <cstdint>
#include <memory>

namespace cd {

/// Returns false if coordinates are so large or the body so small that floats cannot hold the
/// derived values, or if a binary leaf has too many triangles. Such bodies are searched in the
/// binary tree. If a body suits, so does every part of it.
[[nodiscard]] bool suits_wide_tree(const TreeView& body);

/// An immutable wide tree with its triangles, shared freely between threads.
class WideTree {
  public:
    /// Collapses `binary`. The new tree has no nodes if `suits_wide_tree` refuses the body, and is
    /// equal for any number of threads; without a pool the caller's thread does all the work.
    explicit WideTree(const TreeView& binary, ThreadPool* pool = nullptr);
    /// Collapses a part, or all, of a body that `suits_wide_tree` accepts.
    [[nodiscard]] static WideTree of_part(const TreeView& binary, ThreadPool* pool = nullptr);

    /// Wraps existing arrays, which do not change while `owner` lives.
    WideTree(const WideView& arrays, std::shared_ptr<const void> owner)
        : view_(arrays), owner_(std::move(owner)) {}

    /// Returns a copy with support points that shares the other arrays. The tree has nodes.
    [[nodiscard]] WideTree with_support(ThreadPool* pool = nullptr) const;

    [[nodiscard]] const WideView& view() const { return view_; }
    [[nodiscard]] std::uint64_t memory_bytes() const;

  private:
    WideView view_;
    std::shared_ptr<const void> owner_; ///< Owns the arrays that the view refers to.
};

} // namespace cd
