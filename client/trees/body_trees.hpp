// The trees of a job's bodies, in exactly the forms that the job needs.
#pragma once

#include "client/trees/tree_cache.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/tree/obb_tree.hpp"

#include <memory>
#include <vector>

namespace cd {

/// How a job uses trees.
struct TreeUse {
    /// The job detects containment: closed bodies get the binary form if there are two of them.
    bool settles = false;
    /// The job has so many scenarios that making support points pays. Other jobs have them if they
    /// are cached.
    bool makes_points = false;
};

/// Takes the trees of the bodies' meshes from the cache, or builds and caches them. Meshes with
/// equal hashes share one tree, which has the wide form, with support points
/// (`TreeUse::makes_points`). If a wide tree has no nodes, all trees get the binary form too.
[[nodiscard]] std::vector<std::shared_ptr<const ObbTree>>
make_body_trees(const std::vector<std::shared_ptr<const Mesh>>& meshes,
                const TreeUse& use,
                TreeCache& cache,
                ThreadPool& pool);

} // namespace cd
