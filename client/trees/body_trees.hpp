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
    bool settles = false; ///< The job detects containment: binary form if both are closed.
    /// The job has so many scenarios that making support points pays. Other jobs have them if they
    /// are cached.
    bool makes_points = false;
};

/// Takes the trees of two meshes from the cache, or builds and caches them. Meshes with equal
/// hashes share one tree, which has the wide form, with support points (`TreeUse::makes_points`).
/// If a wide tree has no nodes, both trees get the binary form too.
[[nodiscard]] std::array<std::shared_ptr<const ObbTree>, 2>
make_body_trees(const std::array<std::shared_ptr<const Mesh>, 2>& meshes,
                const TreeUse& use,
                TreeCache& cache,
                ThreadPool& pool);

} // namespace cd
