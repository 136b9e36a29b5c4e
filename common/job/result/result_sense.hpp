// Checks that the fields of a result are consistent with each other.
#pragma once

#include "common/core/result.hpp"
#include "common/job/result/result.hpp"

#include <cstdint>

namespace cd {

/// Checks that level, class, pairs, counts and distance bound of a result are consistent. Errors:
/// BadFrame.
[[nodiscard]] Status check_sense(const ScenarioResult& result);

/// Returns the number of near pairs in the result's list.
[[nodiscard]] std::uint64_t listed_near_pairs(const ScenarioResult& result);

} // namespace cd
