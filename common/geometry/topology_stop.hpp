// An analysis of a mesh's topology that can be stopped.
#pragma once

#include "common/geometry/topology.hpp"

#include <atomic>
#include <optional>

namespace cd {

/// Does the same as `analyse_topology(mesh)`, but returns nothing soon after `stop` becomes true:
/// at the latest after a quarter of the work.
[[nodiscard]] std::optional<Topology> analyse_topology(const Mesh& mesh,
                                                       const std::atomic<bool>& stop);

} // namespace cd
