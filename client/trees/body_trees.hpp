// The trees of a job's two bodies, in exactly the forms that the job needs.
#pragma once

#include "client/trees/tree_cache.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/tree/obb_tree.hpp"

#include <array>
#include <memory>

namespace cd {

/// How a job uses trees.
struct TreeUse {
    bool searches_exactly = true; ///< Searches without a tolerance: wide form.
    bool searches_cuts = false;   ///< Searches under a tolerance: binary form.
    bool settles = false;         ///< Detects containment: binary form if both bodies are closed.
};

/// Takes trees from the cache, or else builds and caches them. Bodies whose meshes have one hash
/// share one tree. If one of the bodies has no wide form, both get the binary form.
[[nodiscard]] std::array<std::shared_ptr<const ObbTree>, 2>
make_body_trees(const std::array<std::shared_ptr<const Mesh>, 2>& meshes,
                const TreeUse& use,
                TreeCache& cache,
                ThreadPool& pool);

} // namespace cd
