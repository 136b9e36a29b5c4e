// What a worker knows of a job: its trees, its query, and its poses where a grid tells them.
#pragma once

#include "common/job/pose_source.hpp"
#include "common/job/query.hpp"
#include "proto/message.hpp"
#include "worker/subtree_cache.hpp"

#include <memory>
#include <optional>

namespace cd {

struct WorkerJob {
    JobId id;
    TreeId tree_a;
    TreeId tree_b;
    Query query;
    std::optional<Grid> grid;

    [[nodiscard]] bool uses(TreeId tree) const { return tree_a == tree || tree_b == tree; }
};

/// Errors: BadFrame when a tree is not here, the trees have unlike forms, wide ones under a
/// tolerance, or the grid is none.
[[nodiscard]] Result<std::shared_ptr<const WorkerJob>> make_worker_job(AddJob add,
                                                                       const SubtreeCache& cache);

} // namespace cd
