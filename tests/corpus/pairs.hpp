// The hard pairs of triangles, by category (NUMERICS, section 4). The truth about them is the
// oracle's, never taken from how they were made.
#pragma once

#include "tests/support/hard_pairs.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cd::tests {

/// The names of all categories, ascending.
[[nodiscard]] const std::vector<std::string>& pair_categories();

/// The pair number `seed` of a category: the same bits with every compiler and library.
[[nodiscard]] PosedPair corpus_pair(std::string_view category, std::uint64_t seed);

} // namespace cd::tests
