// How long a scenario will take a thread of a worker, guessed from its analysis.
#pragma once

#include "common/tree/cut.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// For matching by time, where only how scenarios compare matters: what a worker makes of it is
/// measured. Never 0.
[[nodiscard]] std::uint64_t predicted_ns(const TreeTop& a,
                                         const TreeTop& b,
                                         std::span<const RootPair> pairs,
                                         std::uint64_t box_tests);

} // namespace cd
