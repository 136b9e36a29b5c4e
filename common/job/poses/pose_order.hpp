// Orders poses so that consecutive poses touch nearly equal parts of both bodies, and packs them in
// that order.
#pragma once

#include "common/core/files/bytes.hpp"
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

/// Packs a window of scenarios in coherent order: runs of `limits::pose_run_scenarios`, the last of
/// which may have fewer.
[[nodiscard]] std::vector<Bytes> pack_in_order(std::span<const Scenario> window);

} // namespace cd
