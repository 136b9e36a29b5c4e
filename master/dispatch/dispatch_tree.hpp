// What the dispatcher knows of a job's tree.
#pragma once

#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <vector>

namespace cd {

struct DispatchTree {
    TreeId tree;
    std::vector<std::uint32_t> root_triangles; ///< Of each distribution root.
    /// Of each root's block as it travels. Empty: not known, and guessed from the triangles.
    std::vector<std::uint64_t> root_bytes = {};
};

} // namespace cd
