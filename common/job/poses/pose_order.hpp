// An order of poses in which neighbours touch the same parts of both bodies.
#pragma once

#include "common/job/scenario.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// The scenarios' places, along a space-filling curve (Morton 1966) over B's relative pose: its
/// translation, and the axis of its rotation times the angle's sine. Each coordinate counts by its
/// range among the scenarios. A function of the poses alone, the same on every host; equal poses
/// keep their order.
[[nodiscard]] std::vector<std::uint32_t> coherent_order(std::span<const Scenario> scenarios);

} // namespace cd
