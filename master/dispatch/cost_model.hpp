// Predicts a scenario's time on one worker thread from its analysis.
#pragma once

#include "common/tree/cut.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// Size of the contact region: over the pairs, the sum of the square roots of the smaller subtree's
/// triangle count.
[[nodiscard]] double
meeting_size(const TreeTop& a, const TreeTop& b, std::span<const RootPair> pairs);

/// Nanoseconds that a scenario of this `meeting_size` takes on one thread; never 0. The ratios
/// between scenarios matter most, because each worker's speed is measured.
[[nodiscard]] std::uint64_t predicted_ns(double meeting_size);

} // namespace cd
