// How long a scenario will take a thread of a worker, guessed from its analysis.
#pragma once

#include "common/tree/cut.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// How much meets: over the pairs, the square roots of the smaller subtree's triangles.
[[nodiscard]] double
meeting_size(const TreeTop& a, const TreeTop& b, std::span<const RootPair> pairs);

/// For matching by time, where mostly how scenarios compare matters: what a worker makes of it is
/// measured. Never 0.
[[nodiscard]] std::uint64_t predicted_ns(double meeting_size);

} // namespace cd
