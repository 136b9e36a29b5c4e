// Orders poses so that consecutive poses touch nearly equal parts of both bodies.
#pragma once

#include "common/job/scenario.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Returns indices into `scenarios` in the order of a space-filling curve (Morton 1966) over B's
/// pose relative to A: the translation, and the rotation's axis times the sine of its angle. Each
/// coordinate is scaled by its range among the scenarios. The order depends on the poses alone and
/// is equal on every host; equal poses keep their order.
[[nodiscard]] std::vector<std::uint32_t> coherent_order(std::span<const Scenario> scenarios);

} // namespace cd
