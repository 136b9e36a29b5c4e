// Orders poses so that neighbours touch nearly equal parts of both bodies.
#pragma once

#include "common/job/scenario.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Returns the scenarios' indices in the order of a space-filling curve (Morton 1966) over B's
/// relative pose: its translation, and the axis of its rotation times the angle's sine. Each
/// coordinate is scaled by its range among the scenarios. The order depends on the poses alone and
/// is equal on every host; equal poses keep their order.
[[nodiscard]] std::vector<std::uint32_t> coherent_order(std::span<const Scenario> scenarios);

} // namespace cd
