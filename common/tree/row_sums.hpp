// Adds up weights over the columns of a bit matrix.
#pragma once

#include "common/tree/root_holders.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace cd {

/// Adds to each `sums[c]` the weights of the roots r whose row has bit c set: bit c % 64 of
/// `rows[r * row_words + c / 64]`. `sums` has 64 * `row_words` elements.
void add_row_sums(std::span<const WeightedRoot> roots,
                  const std::uint64_t* rows,
                  std::size_t row_words,
                  std::span<std::uint64_t> sums);

} // namespace cd
