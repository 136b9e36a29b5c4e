// Adds up weights over rows of bits, for 64 columns at once.
#pragma once

#include "common/tree/root_holders.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace cd {

/// Adds to `sums[c]` the weights of the roots r whose word `words[r * stride]` has bit c.
void add_row_sums(std::span<const WeightedRoot> roots,
                  const std::uint64_t* words,
                  std::size_t stride,
                  std::span<std::uint64_t, 64> sums);

} // namespace cd
