// The forms of one mesh's tree, each made when it is first needed.
#pragma once

#include "client/trees/tree_cache.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/tree/obb_tree.hpp"

#include <memory>

namespace cd {

/// A mesh with the forms of its tree that were needed so far. Forms come from the cache, or are
/// built and cached.
class MeshTrees {
  public:
    explicit MeshTrees(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)) {}

    /// Makes the wide form. Returns soon after `stop` returns true, as for `build_tree_until`; then
    /// the form may be missing.
    void need_wide(TreeCache& cache, ThreadPool& pool, const StopCheck& stop = {});
    /// Adds support points to the wide form, if it has nodes: cached ones, or, if `makes_them`, new
    /// ones. Requires the wide form.
    void need_points(bool makes_them, TreeCache& cache, ThreadPool& pool);
    void need_binary(TreeCache& cache, ThreadPool& pool);

    [[nodiscard]] const std::shared_ptr<const Mesh>& mesh() const { return mesh_; }
    /// Requires a form.
    [[nodiscard]] bool is_closed() const { return any().topology().is_closed(); }
    [[nodiscard]] bool has_wide() const { return wide_ != nullptr; }
    [[nodiscard]] bool has_wide_nodes() const;
    [[nodiscard]] bool has_points() const;

    /// Returns the tree in the forms that were needed, at least one.
    [[nodiscard]] std::shared_ptr<const ObbTree> tree() const;

  private:
    [[nodiscard]] const ObbTree& any() const { return wide_ ? *wide_ : *binary_; }

    std::shared_ptr<const Mesh> mesh_;
    std::shared_ptr<const ObbTree> wide_;   ///< Has the wide form; null until requested.
    std::shared_ptr<const ObbTree> binary_; ///< Has the binary form; may be set without a request.
    bool shows_binary_ = false;
};

} // namespace cd
