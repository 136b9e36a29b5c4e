// The dispatcher's view of a job's tree.
#pragma once

#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <vector>

namespace cd {

struct DispatchTree {
    TreeId tree;
    std::vector<std::uint32_t> root_triangles; ///< Per distribution root.
    /// Wire size of each root's block. Empty: unknown, and estimated from the triangles.
    std::vector<std::uint64_t> root_bytes = {};
};

} // namespace cd
