// Splits a node of few triangles by a sweep. Most nodes of a tree have few.
#pragma once

#include "common/tree/build/build.hpp"
#include "common/tree/build/build_fit.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace cd {

inline constexpr std::size_t few_triangles_max = 32;

struct FewSplit {
    std::uint32_t left = 0;       ///< Bit i is set if triangle i goes to the left child.
    std::uint32_t left_count = 0; ///< Number of set bits.
};

/// Finds the split that `sweep_split` (build_split.hpp) finds, for 2 to `few_triangles_max`
/// triangles, without branches that depend on their positions. Maxima that differ by less than
/// 2^-46 of the whole count as equal, and so do sums of relative segments within 2^-44.
[[nodiscard]] std::optional<FewSplit>
sweep_few(std::span<const Projection> triangles, const Projection& whole, SplitRule rule);

} // namespace cd
