// Orders poses so that consecutive poses touch nearly equal parts of both bodies, and packs them in
// that order.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/job/scenario.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// The trees of the bodies of a job with two bodies.
inline constexpr std::array<std::uint32_t, 2> two_trees{0, 1};

/// Returns indices into `scenarios` in the order of a space-filling curve (Morton 1966) over B's
/// pose relative to A: the translation, and the rotation's axis times the sine of its angle. Each
/// coordinate is scaled by its range among the scenarios. The order depends on the poses alone and
/// is equal on every host; equal poses keep their order.
[[nodiscard]] std::vector<std::uint32_t> coherent_order(std::span<const Scenario> scenarios);

/// Packs a window of scenarios, ordered by the trees of their bodies, and those of the same two
/// trees in coherent order: runs of `limits::pose_run_scenarios`, the last of which may have fewer.
/// `trees` numbers the tree of each body.
[[nodiscard]] std::vector<Bytes> pack_in_order(std::span<const Scenario> window,
                                               std::span<const std::uint32_t> trees = two_trees);

} // namespace cd
