// The hard triangle pairs, by category. Their truth comes from the oracle,
// never from their construction.
#pragma once

#include "tests/support/hard_pairs.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cd::tests {

/// Returns the names of all categories, ascending.
[[nodiscard]] const std::vector<std::string>& pair_categories();

/// Returns pair number `seed` of a category, bit-identical with every compiler and library.
[[nodiscard]] PosedPair corpus_pair(std::string_view category, std::uint64_t seed);

} // namespace cd::tests
