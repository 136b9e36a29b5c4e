// The dispatcher's view of a job's tree: the sizes of its subtrees.
#pragma once

#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <vector>

namespace cd {

struct DispatchTree {
    TreeId tree;
    std::vector<std::uint32_t> root_triangles; ///< Triangles below each distribution root.
    /// Wire size of each root's block, bytes. If empty, `BlockPlan` estimates the sizes.
    std::vector<std::uint64_t> root_bytes = {};
};

} // namespace cd
