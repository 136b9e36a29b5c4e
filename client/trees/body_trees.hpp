// The trees of a job's two bodies: in the forms that the job walks, and no others.
#pragma once

#include "client/trees/tree_cache.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/tree/obb_tree.hpp"

#include <array>
#include <memory>

namespace cd {

/// What a job does with trees.
struct TreeUse {
    bool searches_exactly = true; ///< Without a tolerance: in the wide form.
    bool searches_cuts = false;   ///< Under a tolerance: in the binary form.
    bool settles = false; ///< Tells insides, which takes the binary form where both are closed.
};

/// From the cache, or else built and kept there. The second is the first where the meshes are one.
/// The binary form is there in any case where a body has no wide one.
[[nodiscard]] std::array<std::shared_ptr<const ObbTree>, 2>
make_body_trees(const std::array<std::shared_ptr<const Mesh>, 2>& meshes,
                const TreeUse& use,
                TreeCache& cache,
                ThreadPool& pool);

} // namespace cd
